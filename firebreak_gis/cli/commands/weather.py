"""firebreak weather: how a table of weather or a wind rose is read."""

from __future__ import annotations

import click

from firebreak_gis.cli import kinds, options, weather_options
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.planning.weather import WeatherRequest


@click.command("weather")
@click.argument("weather", type=kinds.FILE_OR_TEXT)
@weather_options.table
@options.common
@built(request=WeatherRequest)
def command(session: Session, request: WeatherRequest) -> None:
    """Show how WEATHER is read: a CSV file, or a wind rose such as rose:NW=5x0.4,N=8x0.2.

    A table has a line a weather, or a line a step of weather that changes. Columns: wind_speed (or WS, in km/h),
    wind_from (or WD), and if you like moisture, weight, duration, time (or datetime) and scenario (or Instance). Units
    stand in the name, as in wind_speed_kmh, "wind_speed [km/h]", duration_h or moisture_pct; without one wind is in
    m/s and moisture a share. Lines of one scenario follow each other, as do all lines where there is a time or
    --weather-step; else each line is a weather by itself.
    """
    weather = request.read()
    assert weather is not None
    found = weather.describe()
    lines = [*weather.said, f"{'share':>7}  {'from':>8}  {'m/s':>6}  {'degrees':>7}  {'moisture':>8}  {'burns':>8}"]
    for spell in found["spells"]:
        for i, (start, (speed, wind_from, moisture)) in enumerate(zip(spell["starts"], spell["steps"], strict=True)):
            share = f"{spell['share']:.1%}" if i == 0 else ""
            burns = _hours(spell["duration"]) if i == 0 else ""
            wet = "" if moisture is None else f"{moisture:.1%}"
            begins = "" if len(spell["steps"]) == 1 else _hours(start)
            lines.append(f"{share:>7}  {begins:>8}  {speed:6.2f}  {wind_from:7.1f}  {wet:>8}  {burns:>8}")
    lines.append(f"mean wind speed {found['mean_wind_speed']:g} m/s")
    session.finish(found, "\n".join(lines))


def _hours(seconds: float | None) -> str:
    return "" if seconds is None else f"{seconds / 3600:g} h"
