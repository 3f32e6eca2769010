"""Options of weather that several commands share; `landscape.weather.WeatherRequest` takes them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds

F = TypeVar("F", bound=Callable[..., Any])


def weather(command: F) -> F:
    """--weather, and how its table is to be read."""
    command = table(command)
    return click.option(
        "--weather",
        type=kinds.FILE_OR_TEXT,
        metavar="FILE|ROSE",
        help="Ensemble of weathers, of which each run draws one: a CSV file with wind_speed_kmh, wind_from, "
        "moisture_pct, weight, duration_h, time; or a wind rose such as rose:NW=5x0.4,N=8x0.2 (firebreak weather "
        "shows how it is read).",
    )(command)


def table(command: F) -> F:
    """How a table of weather is to be read."""
    options = [
        click.option(
            "--weather-step",
            metavar="TIME",
            help="The lines of the weather follow each other, and each lasts so long, e.g. 1h.",
        ),
        click.option(
            "--weather-column",
            "weather_columns",
            multiple=True,
            callback=kinds.pairs,
            metavar="WHAT=COLUMN",
            help="Name of a column of the weather, e.g. wind_speed=FF; may be repeated.",
        ),
        click.option(
            "--weather-unit",
            "weather_units",
            multiple=True,
            callback=kinds.pairs,
            metavar="WHAT=UNIT",
            help="Unit of a column of the weather that does not tell it, e.g. wind_speed=kn; may be repeated.",
        ),
        click.option(
            "--weather-ignore", metavar="COLUMNS", help="Columns of the weather to leave out, separated by commas."
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command
