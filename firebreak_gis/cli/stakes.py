"""Options of what a planner adds to the network: costs, areas where (not) to cut, barriers, values at risk."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click
import numpy as np

from firebreak_gis.cli import kinds
from firebreak_gis.errors import FirebreakError, InputError, ParameterError
from firebreak_gis.rasters import file_of

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes

F = TypeVar("F", bound=Callable[..., Any])

_SOURCES = ("cost", "protected", "allowed", "barriers", "values")


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


def stake_files(given: Mapping[str, Any]) -> list[str]:
    """Files that these options name."""
    named = [file_of(str(given[key])) for key in _SOURCES if given.get(key)]
    return [name for name in named if Path(name).is_file()]


def read_stakes(grid: Grid, given: Mapping[str, Any], *, landscape: xr.Dataset | None = None) -> dict[str, Any]:
    """Read what the options name onto a grid: `barriers`, `protected`, `cost` (per cell), `value`, `ignition`.

    Parameters
    ----------
    grid
        The grid of the network.
    given
        Options of the command.
    landscape
        Needed for costs by vegetation class.

    Raises
    ------
    ParameterError, InputError
        Naming everything that cannot be read.
    """
    from firebreak_gis.landscape.planes import ignition_source, mask_plane, value_plane
    from firebreak_gis.planning.feasibility import raise_together

    readers: dict[str, Callable[[str], Any]] = {
        "barriers": lambda source: mask_plane(source, grid, what="barriers"),
        "protected": lambda source: mask_plane(source, grid, what="protected"),
        "allowed": lambda source: mask_plane(source, grid, what="allowed"),
        "cost": lambda source: _cost(source, given["cost_field"], grid, landscape),
        "values": lambda source: value_plane(source, grid, what="values", field=given["values_field"]),
        "ignitions": lambda source: ignition_source(source, grid),
    }
    planes: dict[str, np.ndarray] = {}
    problems: list[FirebreakError] = []
    for name, read in readers.items():
        source = given.get(name)
        if source:
            try:
                planes[name] = read(str(source))
            except (ParameterError, InputError) as error:
                problems.append(error)
    raise_together(problems)
    if not isinstance(planes.get("ignitions"), np.ndarray):  # points only say where the simulated fires start
        planes.pop("ignitions", None)
    if "allowed" in planes:
        planes["protected"] = planes.get("protected", np.False_) | ~planes.pop("allowed")
    return {{"values": "value", "ignitions": "ignition"}.get(name, name): plane for name, plane in planes.items()}


def network_and_stakes(network: SpreadNetwork, given: Mapping[str, Any]) -> tuple[SpreadNetwork, Stakes]:
    """Put the barriers into the network and the rest into a `Stakes`."""
    from firebreak_gis.stakes import Stakes, with_barriers

    planes = read_stakes(network.grid, given)
    barriers = planes.pop("barriers", None)
    if barriers is not None:
        network = with_barriers(network, barriers)
    return network, Stakes(network, **planes)


def _cost(source: str, field: str | None, grid: Grid, landscape: xr.Dataset | None) -> np.ndarray:
    """Cost of cutting each cell, from costs per hectare."""
    from firebreak_gis.landscape.planes import value_plane
    from firebreak_gis.schema import VEGETATION

    if "=" not in source:
        return value_plane(source, grid, what="cost", field=field) * grid.cell_area_ha
    if landscape is None:
        raise ParameterError("costs by class need the vegetation; use firebreak plan, or give a raster")
    rates = np.zeros(256)
    codes = {name: code for code, name in VEGETATION.items() if code}
    for word in source.split(","):
        name, _, number = word.partition("=")
        try:
            rates[codes[name.strip()]] = float(number)
        except (KeyError, ValueError):
            raise ParameterError(
                f"--cost got {word!r}, expected CLASS=NUMBER with a class of {', '.join(codes)}"
            ) from None
    missing = [name for name, code in codes.items() if f"{name}=" not in source.replace(" ", "")]
    if missing:
        raise ParameterError(f"--cost names no rate for {', '.join(missing)}")
    return np.asarray(rates[landscape["vegetation"].to_numpy()] * grid.cell_area_ha)
