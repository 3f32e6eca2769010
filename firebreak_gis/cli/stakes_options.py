"""Options of what a planner adds to the network: costs, areas where (not) to cut, barriers, values at risk.

An option fills the field of its name in `landscape.stake_layers.StakesRequest`, which says how to add one.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds

F = TypeVar("F", bound=Callable[..., Any])


cost_default = click.option(
    "--cost-default",
    type=float,
    metavar="NUMBER",
    help="Cost per hectare where --cost tells none; alone, everywhere [default: nothing is cut there].",
)


def stakes(command: F) -> F:
    """--cost, --protected, --allowed, --barriers, --values and their fields."""
    options = [
        click.option(
            "--cost",
            type=kinds.COST,
            metavar="PATH",
            help="Cost of cutting per hectare: a raster, polygons with --cost-field, or "
            "(firebreak plan only) classes such as agricultural=500,shrubs=900,pines=1500.",
        ),
        click.option("--cost-field", metavar="NAME", help="Column of the cost polygons."),
        cost_default,
        click.option(
            "--protected",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Area (raster or polygons, lines take the cells that they touch) where nothing may be cut.",
        ),
        click.option(
            "--allowed",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Area (raster or polygons, lines take the cells that they touch) outside of which nothing may be cut.",
        ),
        click.option(
            "--protected-rule",
            type=click.Choice(["every-part", "centre"]),
            default="every-part",
            show_default=True,
            help="Cells that --protected and --allowed keep from being cut: all with a part inside the one or outside "
            "the other, or those whose centre is.",
        ),
        click.option(
            "--barriers",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Existing breaks, roads, rivers (raster, lines or polygons): all cells that they cut hold no fuel and "
            "cost nothing.",
        ),
    ]
    return _apply(options, values(command))


def values(command: F) -> F:
    """--values and its columns, and --value for several."""
    options = [
        click.option(
            "--values",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Values at risk: a raster, or polygons or points with --values-field [default: 1 on fuel].",
        ),
        click.option(
            "--values-field", metavar="NAME", help="Column of the value polygons or points [default: 1 for each]."
        ),
        click.option(
            "--values-as",
            type=click.Choice(["amount", "density"]),
            default="amount",
            show_default=True,
            help="What the numbers of --values are: so much in each cell of the raster, polygon or point (people), the "
            "sum of which is kept; or so much a hectare.",
        ),
        click.option(
            "--value",
            "value_layers",
            multiple=True,
            callback=kinds.VALUE_LAYERS,
            metavar="NAME=PATH,...",
            help="One of several values at risk: NAME=PATH, with ,field=COLUMN ,weight=NUMBER (what a unit counts in "
            "the sum that is planned for) and ,as=density after it as needed; may be repeated, each is told by name.",
        ),
    ]
    return _apply(options, command)


def _apply(options: list[Callable[[Any], Any]], command: F) -> F:
    for option in reversed(options):
        command = option(command)
    return command
