"""The compartments that a plan leaves: connected fuel between the breaks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.grid import outlines
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.edges import passable
from firebreak_gis.stakes import checked_amounts

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Plane = np.ndarray | xr.DataArray


def compartments_of(
    network: SpreadNetwork,
    breaks: Plane | LineBreaks,
    *,
    value: Plane | None = None,
    ignition: Plane | None = None,
    burns: xr.Dataset | None = None,
) -> tuple[xr.DataArray, gpd.GeoDataFrame]:
    """Outline the connected fuel that is left between the breaks.

    Two cells are connected if fire can pass between them in at least one of the two directions.

    Parameters
    ----------
    network
        The spread network before cutting.
    breaks
        (y, x), above 0 where the fuel is cut; or lines, from `line_breaks`.
    value
        (y, x) value lost when the cell burns, any one unit, at least 0. Default: 1 on fuel.
    ignition
        (y, x) how likely a fire starts in the cell, relative to the others, at least 0. Default: 1 on fuel.
    burns
        Fires on the treated network, as `simulate` returns them.

    Returns
    -------
    labels : xarray.DataArray
        `compartment` (y, x) int32: 1 for the compartment with the largest expected loss; 0 where there is no fuel
        or it is cut. Ties go by cells, then by the first cell in reading order.
    table : geopandas.GeoDataFrame
        One row a compartment, by rising number: `compartment`, `cells`, `area_ha`, `ignition_share` (of all fires,
        those that start in breaks included), `value`, `expected_loss` (ignition share x value: the value lost per fire
        if a fire burnt the whole compartment), with `burns` also `burnt_value` (sum of burn frequency x value), and
        `geometry`, valid polygons or multipolygons.

    Raises
    ------
    GridError
        If a layer lies on another grid.
    InputError
        If values or ignitions are negative, infinite or missing on fuel, or `burns` has no burn frequency.

    Notes
    -----
    Cost: linear in the cells. Lengths assume a CRS in metres.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> breaks = fb.select_breaks(fb.rank(network, budget=0.2), budget=0.2)
    >>> labels, table = fb.compartments_of(network, breaks)
    >>> int(table["cells"].sum() + breaks.sum()) == network.n_burnable
    True
    """
    import geopandas as gpd

    if isinstance(breaks, LineBreaks):
        network.grid.require(breaks.grid, "the lines")
        cut, crossed = np.zeros(network.shape, bool), breaks.crossed
    else:
        cut, crossed = network.mask(breaks, "breaks"), None
    parts = split(network, cut, crossed=crossed, value=value, ignition=ignition)
    columns: dict[str, np.ndarray] = {
        "compartment": np.arange(1, parts.cells.size + 1),
        "cells": parts.cells,
        "area_ha": parts.cells * network.grid.cell_area_ha,
        "ignition_share": parts.ignition_mass,
        "value": parts.value_mass,
        "expected_loss": parts.ignition_mass * parts.value_mass,
    }
    if burns is not None:
        burnt = _burn_frequency(network, burns) * parts.value
        columns["burnt_value"] = np.bincount(
            parts.labels.ravel(), weights=burnt.ravel(), minlength=parts.cells.size + 1
        )[1:]
    labels = network.grid.dataarray(parts.labels, "compartment").assign_attrs(
        long_name="compartment, 1 has the largest expected loss", units="1"
    )
    return labels, gpd.GeoDataFrame(
        columns, geometry=outlines(parts.labels, parts.cells.size, network.grid), crs=network.grid.crs
    )


@dataclass(frozen=True)
class Compartments:
    """Compartments as arrays.

    Parameters
    ----------
    labels
        (rows, cols) int32, from 1; 0 where there is no fuel or it is cut.
    cells, ignition_mass, value_mass
        (n,) of each compartment; the ignition is a share of that of all fuel.
    ignition, value
        (rows, cols) float64 of each cell, 0 off fuel; the ignition adds up to 1.
    links
        (2, m) cells between which fire can pass, row-major numbers, before cutting.
    """

    labels: np.ndarray
    cells: np.ndarray
    ignition_mass: np.ndarray
    value_mass: np.ndarray
    ignition: np.ndarray
    value: np.ndarray
    links: np.ndarray


def split(
    network: SpreadNetwork,
    cut: np.ndarray,
    *,
    crossed: np.ndarray | None = None,
    value: Plane | None = None,
    ignition: Plane | None = None,
) -> Compartments:
    """Find the compartments, see `compartments`; `cut` is (rows, cols) bool, `crossed` that of `LineBreaks`."""
    import scipy.sparse as sp
    from scipy.sparse.csgraph import connected_components

    worth = weights(network, value, "value")
    starts = weights(network, ignition, "ignition")
    starts = starts / max(starts.sum(), np.finfo(float).tiny)
    links = _links(network)
    kept = (network.burnable & ~cut).ravel()
    inner = links[:, kept[links[0]] & kept[links[1]]]
    if crossed is not None:
        inner = inner[:, ~_parted(inner, crossed)]
    number = np.cumsum(kept, dtype=np.int32) - 1
    n_kept = int(np.count_nonzero(kept))
    graph = sp.coo_array((np.ones(inner.shape[1], np.int8), (number[inner[0]], number[inner[1]])), (n_kept, n_kept))
    n_parts, part = connected_components(graph.tocsr(), directed=False)
    cells = np.bincount(part, minlength=n_parts)
    masses = [np.bincount(part, weights=plane.ravel()[kept], minlength=n_parts) for plane in (starts, worth)]
    _, first = np.unique(part, return_index=True)
    order = np.lexsort((first, -cells, -masses[0] * masses[1]))
    rank = np.empty(n_parts, np.int32)
    rank[order] = np.arange(1, n_parts + 1)
    labels = np.zeros(kept.size, np.int32)
    labels[kept] = rank[part]
    return Compartments(
        labels.reshape(network.shape), cells[order], masses[0][order], masses[1][order], starts, worth, links
    )


def _parted(links: np.ndarray, crossed: np.ndarray) -> np.ndarray:
    """Which links, from a cell to one of the first four directions, a line crosses; (m,) bool."""
    cols = crossed.shape[1]
    row, col = np.divmod(links, cols)
    steps = list(zip(ROW_STEP[:4], COL_STEP[:4], strict=True))
    down, right = row[1] - row[0], col[1] - col[0]
    out = np.zeros(links.shape[1], bool)
    for d, step in enumerate(steps):
        out |= (down == step[0]) & (right == step[1]) & ((crossed.ravel()[links[0]] >> d) & 1 > 0)
    return out


def weights(network: SpreadNetwork, data: Plane | None, name: str) -> np.ndarray:
    """Plane of finite numbers of at least 0 on fuel and 0 elsewhere, float64; 1 on fuel by default."""
    if data is None:
        return network.burnable.astype(np.float64)
    return checked_amounts(network, data, name)


def _links(network: SpreadNetwork) -> np.ndarray:
    """Pairs of cells between which fire can pass, each pair once, (2, m) int32."""
    rows, cols = network.shape
    found = []
    for d in range(4):
        row, col = np.nonzero(passable(network, d))
        target = (row + ROW_STEP[d]) % rows * cols + (col + COL_STEP[d]) % cols
        found.append(np.array([row * cols + col, target], dtype=np.int32))
    return np.concatenate(found, axis=1)


def _burn_frequency(network: SpreadNetwork, burns: xr.Dataset) -> np.ndarray:
    """Burn frequency, 0 off fuel."""
    if "burn_frequency" not in burns:
        raise InputError(f"burns holds {list(burns)}, expected burn_frequency; give the result of simulate")
    frequency = network.plane(burns["burn_frequency"], "burn_frequency").astype(np.float64)
    return np.nan_to_num(frequency, nan=0.0)
