"""The compartments that a plan leaves: connected fuel between the breaks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.grid import outlines
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.lattice import COL_STEP, OPPOSITE, ROW_STEP
from firebreak_gis.network import neighbour
from firebreak_gis.placement.edges import links
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
        (2, m) cells between which fire can pass before cutting, row-major numbers, where one of the two is cut.
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
    from firebreak_gis.kernels.squares import UNNUMBERED, number_pieces

    worth = weights(network, value, "value")
    starts = weights(network, ignition, "ignition")
    starts = starts / max(starts.sum(), np.finfo(float).tiny)
    ways = links(network)
    beside_cut = _links_of(network, ways, cut)
    if crossed is not None:
        _part(ways, crossed)
    labels = np.where(network.burnable & ~cut, UNNUMBERED, np.int32(-1))
    n_parts = number_pieces(labels, ways, np.array(ROW_STEP), np.array(COL_STEP))
    kept = labels.ravel() >= 0
    part = labels.ravel()[kept]
    cells = np.bincount(part, minlength=n_parts)
    masses = [np.bincount(part, weights=plane.ravel()[kept], minlength=n_parts) for plane in (starts, worth)]
    order = np.lexsort((-cells, -masses[0] * masses[1]))  # equal ones by their first cells, as they are numbered
    rank = np.zeros(n_parts + 1, np.int32)
    rank[order] = np.arange(1, n_parts + 1)
    return Compartments(rank[labels], cells[order], masses[0][order], masses[1][order], starts, worth, beside_cut)


def _part(ways: np.ndarray, crossed: np.ndarray) -> None:
    """Clear the links that a line crosses, from a cell to one of the first four directions, both ways."""
    for d in range(4):
        parted = (crossed >> d) & 1
        ways &= ~(parted << d).astype(np.uint8)
        ways &= ~(neighbour(parted, OPPOSITE[d]) << OPPOSITE[d]).astype(np.uint8)


def weights(network: SpreadNetwork, data: Plane | None, name: str) -> np.ndarray:
    """Plane of finite numbers of at least 0 on fuel and 0 elsewhere, float64; 1 on fuel by default."""
    if data is None:
        return network.burnable.astype(np.float64)
    return checked_amounts(network, data, name)


def _links_of(network: SpreadNetwork, ways: np.ndarray, cut: np.ndarray) -> np.ndarray:
    """Pairs of cells between which fire can pass and of which one is cut, each pair once, (2, m) int32."""
    rows, cols = network.shape
    found = []
    for d in range(4):
        row, col = np.nonzero(((ways >> d) & 1 > 0) & (cut | neighbour(cut, d, network.boundary)))
        target = (row + ROW_STEP[d]) % rows * cols + (col + COL_STEP[d]) % cols
        found.append(np.array([row * cols + col, target], dtype=np.int32))
    return np.concatenate(found, axis=1)


def _burn_frequency(network: SpreadNetwork, burns: xr.Dataset) -> np.ndarray:
    """Burn frequency, 0 off fuel."""
    if "burn_frequency" not in burns:
        raise InputError(f"burns holds {list(burns)}, expected burn_frequency; give the result of simulate")
    frequency = network.plane(burns["burn_frequency"], "burn_frequency").astype(np.float64)
    return np.nan_to_num(frequency, nan=0.0)
