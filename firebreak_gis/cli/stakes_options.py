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
roads = click.option(
    "--roads",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    help="Roads and tracks (lines or a raster), beside which breaks are easier to build and to hold, and on which "
    "crews drive; those that stop fire are barriers too.",
)
rivers = click.option(
    "--rivers",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    help="Rivers and lakes (lines, areas, a raster), beside which breaks are easier to hold; those that stop fire are "
    "barriers too.",
)
siting_params = click.option(
    "--siting-param",
    "siting_params",
    callback=kinds.pairs,
    multiple=True,
    metavar="NAME=VALUE",
    help="What a line is worth, or a reach, such as ridge=0.8, valley=0 or reach=60; may be repeated.",
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


def siting(command: F) -> F:
    """--rivers, --aoi, --siting, --siting-param, --max-slope, --near-roads and --beyond-roads.

    What they go by beside the terrain, `roads`, comes with the options of fires where there are fires.
    """
    options = [
        rivers,
        click.option(
            "--aoi",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Area of interest (raster or polygons) that is planned for: nothing is cut outside, but fires start "
            "and burn there too.",
        ),
        click.option(
            "--siting",
            type=float,
            metavar="STRENGTH",
            help="How much more a break counts in the worst ground than on a ridge, a road, a river or the edge of the "
            "fuel; 0: all ground alike, as in the paper [default: 1.5 where the terrain is known and has relief].",
        ),
        siting_params,
        click.option("--max-slope", type=float, metavar="DEGREES", help="Ground that is steeper is not cut."),
        click.option(
            "--near-roads", type=kinds.LENGTH, metavar="METRES", help="Only ground within this of a road is cut: 200m."
        ),
        click.option(
            "--beyond-roads", type=kinds.LENGTH, metavar="METRES", help="Ground within this of a road is not cut: 50m."
        ),
    ]
    for option in reversed(options):
        command = option(command)
    return command
