"""Options of a plan over years; `planning.years.YearsRequest` has their fields."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds

F = TypeVar("F", bound=Callable[..., Any])


fires_per_year = click.option(
    "--fires-per-year",
    type=float,
    default=1.0,
    show_default=True,
    help="Number of fires that start in a year.",
)
return_interval = click.option(
    "--return-interval",
    type=kinds.INTERVALS,
    metavar="YEARS",
    help="Years until treated fuel has grown back: 4, or agricultural=3,shrubs=4,pines=8 [default: those of "
    "--treatments, or agricultural=3,shrubs=4,pines=4, an assumption].",
)


existing = click.option(
    "--existing",
    type=kinds.RASTER_OR_VECTOR,
    metavar="BREAKS",
    help="Breaks that stand already (lines, polygons, or a raster of which each connected piece is one): fires meet "
    "them with and without the plan, they fail as new ones do, and their fuel grows back unless they are kept up.",
)


def calendar(command: F) -> F:
    """--existing, --years, --budget-per-year, --fires-per-year, --discount, --return-interval, --upkeep-cost."""
    options = [
        existing,
        click.option(
            "--years",
            type=kinds.COUNT,
            default=1,
            show_default=True,
            help="Number of years over which the breaks are built and kept up; 1: all is built at once.",
        ),
        click.option(
            "--budget-per-year",
            type=kinds.BUDGET_PER_YEAR,
            metavar="AMOUNT",
            help="What each year affords for upkeep, which is paid first, and building: 500ha, 20000eur or a share "
            "[default: what all breaks cost, over the years].",
        ),
        fires_per_year,
        click.option(
            "--discount",
            type=kinds.RATE,
            default="0%",
            show_default=True,
            metavar="RATE",
            help="Rate a year, such as 3%, at which later costs and losses count less.",
        ),
        return_interval,
        click.option(
            "--upkeep-cost",
            type=kinds.SHARE_OF_RUNS,
            default=1.0,
            show_default=True,
            help="What treating anew costs, as a share of treating first.",
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command
