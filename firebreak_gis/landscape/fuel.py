"""From codes on the grid to vegetation and density classes, by the legends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from firebreak_gis.errors import LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.continuity import CONTINUITY, density_by_continuity
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.legends.burning import BURNING
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.schema import DENSITY

#: What every landscape holds.
LAYERS = ("elevation", "vegetation", "density")
#: What a landscape holds only where a legend gives numbers in place of classes.
INSTEAD = ("vegetation_effect", "density_effect", *BURNING.values())
#: So many unknown codes are listed in a message.
LISTED = 8


@dataclass(frozen=True)
class Fuel:
    """Fuel on the grid, all arrays (rows, cols).

    Parameters
    ----------
    vegetation, density
        uint8 class codes of the schema; density is 0 where vegetation is.
    instead
        float32 numbers in place of what the class has, NaN where the class counts, by variable; those of `INSTEAD`
        that a legend gives.
    """

    vegetation: np.ndarray
    density: np.ndarray
    instead: Mapping[str, np.ndarray] = field(default_factory=dict)


def fuel_of(
    codes: np.ndarray,
    cover: np.ndarray | str | None,
    legend: Legend,
    density_legend: Legend,
    grid: Grid,
    account: Account,
    unknown: str = "refuse",
) -> Fuel:
    """Look the codes up.

    Parameters
    ----------
    codes
        Vegetation codes as floats, NaN for no data.
    cover
        Density codes (or a quantity) likewise; the name of one class; "continuity"; or None.
    legend, density_legend
        For `codes` and `cover`.
    grid
        For the areas in messages.
    account
        Warnings are added to it.
    unknown
        "refuse" or "nonburnable".

    Raises
    ------
    LegendError
        For codes that the legend does not list, with their areas.
    """
    index = _look_up(codes, legend, "vegetation", grid, account, unknown)
    vegetation = legend.column("vegetation", 0)[index].astype(np.uint8)
    density = legend.column("density", np.nan)[index]
    density_effect = _effect(legend, "density_effect", index)
    if cover is not None:
        replaced = (legend.column("density_from_raster", 1)[index] == 1) | np.isnan(density)
        if isinstance(cover, str) and cover == CONTINUITY:
            given, given_effect = density_by_continuity(vegetation > 0).astype(np.float64), None
        elif isinstance(cover, str):
            given, given_effect = np.full(grid.shape, float(_density_code(cover))), None
        else:
            where = _look_up(np.where(vegetation > 0, cover, np.nan), density_legend, "density", grid, account, unknown)
            given = density_legend.column("density", np.nan)[where]
            given_effect = _effect(density_legend, "density_effect", where)
        density = np.where(replaced, given, density)
        density_effect = _merge(density_effect, given_effect, replaced)
    lacking = np.isnan(density) & (vegetation > 0)
    if lacking.any():
        account.warn(
            f"{int(lacking.sum())} cells with vegetation have no density and are taken as not burnable "
            f"({lacking.mean():.2%} of the grid)"
        )
    classes = np.where(np.isnan(density) | (vegetation == 0), 0, density).astype(np.uint8)
    numbers = {name: _effect(legend, name, index) for name in INSTEAD} | {"density_effect": density_effect}
    burns = classes > 0
    instead = {name: np.where(burns, plane, np.float32(np.nan)) for name, plane in numbers.items() if plane is not None}
    return Fuel(vegetation, classes, instead)


def given_instead(legend: Legend, density_legend: Legend | None) -> set[str]:
    """Variables that `fuel_of` makes where legends give numbers; `density_legend` is None without a raster for it."""
    found = {name for name in INSTEAD if not np.isnan(legend.column(name, np.nan)).all()}
    if density_legend is not None and not np.isnan(density_legend.column("density_effect", np.nan)).all():
        found.add("density_effect")
    return found


def burnable_cells(layers: Mapping[Any, Any]) -> np.ndarray:
    """Return where vegetation, density and elevation meet, (rows, cols) bool."""
    elevation, vegetation, density = (np.asarray(layers[name]) for name in LAYERS)
    return np.asarray((vegetation > 0) & (density > 0) & np.isfinite(elevation))


def _density_code(name: str) -> int:
    return next(code for code, label in DENSITY.items() if label == name)


def _effect(legend: Legend, name: str, index: np.ndarray) -> np.ndarray | None:
    column = legend.column(name, np.nan)
    return None if np.isnan(column).all() else np.asarray(column.astype(np.float32)[index])


def _merge(own: np.ndarray | None, given: np.ndarray | None, replaced: np.ndarray) -> np.ndarray | None:
    if own is None and given is None:
        return None
    blank = np.full(replaced.shape, np.nan, dtype=np.float32)
    return np.where(replaced, blank if given is None else given, blank if own is None else own)


def _look_up(values: np.ndarray, legend: Legend, name: str, grid: Grid, account: Account, unknown: str) -> np.ndarray:
    """Index of the legend's entry for each cell, -1 where there is no data."""
    index = legend.find(values)
    strange = (index < 0) & np.isfinite(values)
    missing = legend.column("missing", 0)
    if missing.any():
        index = np.where(missing[index] == 1, -1, index)
    if not strange.any():
        return index
    told = _areas(values[strange], legend, grid)
    if unknown == "refuse":
        raise LegendError(
            f"the {name} raster holds codes that the legend {legend.name} does not list: {told}. Give the "
            f"right legend "
            f"(--legend, --density-legend), add the codes to an own one, declare no data (--src-nodata "
            f"{name}=...), or take them "
            "as land without fuel (--unknown nonburnable)" + _hint(values[strange], legend, name)
        )
    account.warn(f"{name}: codes not in the legend {legend.name} were taken as land without fuel: {told}")
    return index


def _areas(values: np.ndarray, legend: Legend, grid: Grid) -> str:
    if legend.continuous:
        return f"{values.min():g} to {values.max():g} ({values.size * grid.cell_area_ha:.6g} ha)"
    codes, counts = np.unique(values, return_counts=True)
    order = np.argsort(-counts, kind="stable")[:LISTED]
    told = ", ".join(f"{codes[i]:g} ({counts[i] * grid.cell_area_ha:.6g} ha)" for i in sorted(order))
    return told + (f" and {codes.size - LISTED} more" if codes.size > LISTED else "")


def _hint(values: np.ndarray, legend: Legend, name: str) -> str:
    if name == "density" and not legend.continuous and values.max() <= 100 and np.unique(values).size > LISTED:
        return "; if it is a cover in percent, take the density legend canopy_cover or tree_cover_density"
    return ""
