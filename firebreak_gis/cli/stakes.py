"""Options of what a planner adds to the network: costs, areas where (not) to cut, barriers, values at risk.

An option fills the field of its name in `landscape.stake_layers.StakesRequest`, which says how to add one.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds

F = TypeVar("F", bound=Callable[..., Any])


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
        click.option(
            "--protected",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Area (raster or polygons) where nothing may be cut.",
        ),
        click.option(
            "--allowed",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Area (raster or polygons) outside of which nothing may be cut.",
        ),
        click.option(
            "--barriers",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Existing breaks, roads, rivers (raster, lines or polygons): they hold no fuel and cost nothing.",
        ),
        click.option(
            "--values",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Values at risk per cell (raster), or polygons with --values-field, "
            "whose number counts for each cell inside [default: 1 on fuel].",
        ),
        click.option("--values-field", metavar="NAME", help="Column of the value polygons."),
    ]
    for option in reversed(options):
        command = option(command)
    return command
