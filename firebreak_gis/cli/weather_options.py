"""Options of the spread model and of weather that several commands share; `planning.weather` has their requests."""

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


def spread(command: F) -> F:
    """The spread model and the wind."""
    options = [
        click.option(
            "--model",
            type=kinds.SPREAD,
            metavar="NAME",
            default="alexandridis",
            show_default=True,
            help="Spread model (firebreak methods).",
        ),
        click.option(
            "--wind-speed",
            type=kinds.WIND_SPEED,
            metavar="M/S",
            default="0",
            show_default=True,
            help="Wind speed: a number, in m/s or with its unit (20km/h, 10kn, 4bf), or a raster on any grid.",
        ),
        click.option(
            "--wind-from",
            type=kinds.WIND_DIRECTION,
            metavar="DEGREES",
            default="0",
            show_default=True,
            help="Direction the wind comes from, clockwise from north: 270 is a west wind; a number or a raster.",
        ),
        click.option(
            "--wind-uv",
            type=kinds.RASTER_OR_NUMBER,
            nargs=2,
            callback=kinds.WIND_COMPONENTS,
            metavar="U V",
            help="Components of the wind towards east and north, in place of the two above: rasters on any grid.",
        ),
        click.option(
            "--moisture",
            type=kinds.MOISTURE,
            metavar="SHARE",
            default="0",
            show_default=True,
            help="Moisture of the fine dead fuel as a share of its dry weight (8 % is 0.08 or 8%), or a raster of it.",
        ),
        click.option(
            "--neighbourhood",
            type=click.Choice(["moore", "von_neumann"]),
            default="moore",
            show_default=True,
            help="Neighbours that a cell can light: all eight (moore), or the four that share a side (von_neumann).",
        ),
        click.option(
            "--model-param",
            "model_params",
            multiple=True,
            callback=kinds.pairs,
            metavar="NAME=VALUE",
            help="Parameter of the spread model, e.g. p0=0.5; may be repeated.",
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command


def clock(command: F) -> F:
    """--clock."""
    return click.option(
        "--clock",
        is_flag=True,
        help="Also tell how long fire takes from cell to cell (bands 9 to 16, seconds) and the heat of each cell.",
    )(command)
