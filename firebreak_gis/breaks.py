"""From a priority raster and a budget to the cells that are cut."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import GridError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.schema import annotate

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

#: What a budget counts: a share of the fuel, hectares, or money.
BudgetUnit = Literal["share", "ha", "cost"]


def removal_order(priority: np.ndarray | xr.DataArray) -> np.ndarray:
    """Position of every cell in the order of cutting.

    Parameters
    ----------
    priority
        (rows, cols); higher is cut earlier, -inf or NaN is never cut. Ties are cut by row, then column.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int64: 0 for the cell cut first; -1 for cells that are never cut.
    """
    values = np.asarray(priority, dtype=np.float64)
    if values.ndim != 2:
        raise GridError(f"priority has shape {values.shape}, expected (rows, cols)")
    flat = values.ravel()
    candidates = np.flatnonzero(~np.isnan(flat) & (flat > -np.inf))
    order = candidates[np.argsort(-flat[candidates], kind="stable")]
    position = np.full(flat.size, -1, dtype=np.int64)
    position[order] = np.arange(order.size)
    return position.reshape(values.shape)


def cells_to_cut(budget: float, n_burnable: int) -> int:
    """Number of cells that a budget buys: round(d_f N_v), halves up.

    Parameters
    ----------
    budget
        d_f, share of the cells that hold fuel, from 0 to 1.
    n_burnable
        N_v.

    Raises
    ------
    ParameterError
        If `budget` is not a share from 0 to 1.
    """
    if not (isinstance(budget, (int, float, np.number)) and 0.0 <= budget <= 1.0):
        raise ParameterError(
            f"budget is {budget}, expected a share of the cells that hold fuel, from 0 to 1 (14 % is 0.14)"
        )
    return math.floor(float(budget) * n_burnable + 0.5)


def select_breaks(
    priority: xr.DataArray | np.ndarray,
    *,
    budget: float,
    unit: BudgetUnit = "share",
    burnable: np.ndarray | xr.DataArray | None = None,
    cost: np.ndarray | xr.DataArray | None = None,
) -> xr.DataArray:
    """Cut the first cells of a ranking, as many as a budget buys.

    Parameters
    ----------
    priority
        (y, x), higher is cut earlier, -inf or NaN is never cut. Ties are cut by row, then column.
    budget
        In the given unit.
    unit
        `"share"`: d_f, a share from 0 to 1 of the cells that hold fuel; exactly round(d_f N_v) cells are cut.
        `"ha"`: hectares; the cells that fit into them. `"cost"`: in the unit of `cost`; the longest beginning of
        the ranking that costs no more.
    burnable
        (y, x) cells that hold fuel, which make N_v. Default: the cells that can be cut.
    cost
        (y, x) cost of cutting each cell, for the unit `"cost"`.

    Returns
    -------
    xarray.DataArray
        `breaks` (y, x) uint8: 1 where cut; attributes `budget`, `unit` and `cells_cut`.

    Raises
    ------
    ParameterError
        If the budget is impossible, or is more than can be cut.
    GridError
        If `priority`, `burnable` or `cost` have other dimensions or shapes.

    Notes
    -----
    Memory at the peak: at most 90 B a cell, a network and the priority included.
    """
    position = removal_order(priority)
    grid = Grid.of(priority) if hasattr(priority, "dims") else Grid((position.shape[0], position.shape[1]))
    n_candidates = int(np.count_nonzero(position >= 0))
    for name, plane in (("burnable", burnable), ("cost", cost)):
        if plane is not None and np.shape(plane) != position.shape:
            raise GridError(f"{name} has shape {np.shape(plane)}, expected {position.shape}")
    if unit == "cost":
        count = _affordable(position, cost, budget)
    else:
        n_burnable = n_candidates if burnable is None else int(np.count_nonzero(np.asarray(burnable)))
        count = cells_to_cut(budget, n_burnable) if unit == "share" else _fitting(grid, budget, unit)
        if count > n_candidates:
            most = n_candidates / max(n_burnable, 1) if unit == "share" else n_candidates * grid.cell_area_ha
            raise ParameterError(
                f"a budget of {budget:g} ({unit}) is {count} cells, but only {n_candidates} cells can be cut; "
                f"lower the budget to {most:.4g} or protect less"
            )
    mask = ((position >= 0) & (position < count)).astype(np.uint8)
    return annotate(grid.dataarray(mask, "breaks")).assign_attrs(budget=float(budget), unit=unit, cells_cut=count)


def _fitting(grid: Grid, hectares: float, unit: str) -> int:
    """Cells that fit into so many hectares."""
    if unit != "ha":
        raise ParameterError(f"the unit of the budget is {unit!r}, expected share, ha or cost")
    if not (math.isfinite(hectares) and hectares >= 0.0):
        raise ParameterError(f"budget is {hectares} ha, expected a number of at least 0")
    # A whole number of cells must not be lost to rounding.
    return math.floor(hectares / grid.cell_area_ha + 1e-9)


def _affordable(position: np.ndarray, cost: np.ndarray | xr.DataArray | None, budget: float) -> int:
    """Length of the longest beginning of the ranking that costs no more than the budget."""
    if cost is None:
        raise ParameterError("a budget in cost needs the cost of every cell")
    if not (math.isfinite(budget) and budget >= 0.0):
        raise ParameterError(f"budget is {budget}, expected a number of at least 0")
    candidates = np.flatnonzero(position.ravel() >= 0)
    order = np.empty(candidates.size, dtype=np.int64)
    order[position.ravel()[candidates]] = candidates
    spent = np.cumsum(np.asarray(cost, dtype=np.float64).ravel()[order])
    return int(np.searchsorted(spent, budget * (1.0 + 1e-12), side="right"))


def break_polygons(breaks: xr.DataArray, priority: xr.DataArray | None = None) -> gpd.GeoDataFrame:
    """Outline the connected pieces of a break mask.

    Pieces are connected over sides and corners; each row is one piece.

    Parameters
    ----------
    breaks
        (y, x), above 0 where cut, with a CRS in metres.
    priority
        The ranking, which gives the construction order and the mean score.

    Returns
    -------
    geopandas.GeoDataFrame
        Columns `order` (1 = highest mean priority), `cells`, `area_ha`, `mean_priority`, `geometry` (valid
        polygons or multipolygons), sorted by `order`.
    """
    import geopandas as gpd
    from rasterio.features import shapes
    from scipy import ndimage
    from shapely.geometry import shape
    from shapely.ops import unary_union

    grid = Grid.of(breaks)
    cut = np.asarray(breaks) > 0
    # Traced over sides only, since a polygon that touches itself at a corner is invalid; then joined.
    labels, n_pieces = ndimage.label(cut, structure=np.ones((3, 3)))
    parts: dict[int, list[Any]] = {i: [] for i in range(1, n_pieces + 1)}
    for geometry, label in shapes(labels.astype(np.int32), mask=cut, connectivity=4, transform=grid.transform):
        parts[int(label)].append(shape(geometry))
    cells = np.bincount(labels.ravel(), minlength=n_pieces + 1)[1:]
    scores = np.zeros(n_pieces)
    if priority is not None:
        grid.require(Grid.of(priority), "priority")
        total = np.bincount(labels[cut], weights=np.asarray(priority, dtype=np.float64)[cut], minlength=n_pieces + 1)[
            1:
        ]
        scores = total / np.maximum(cells, 1)
    sequence = np.argsort(-scores, kind="stable")
    return gpd.GeoDataFrame(
        {
            "order": np.arange(1, n_pieces + 1),
            "cells": cells[sequence],
            "area_ha": cells[sequence] * grid.cell_area_ha,
            "mean_priority": scores[sequence],
        },
        geometry=[unary_union(parts[int(i) + 1]) for i in sequence],
        crs=grid.crs,
    )
