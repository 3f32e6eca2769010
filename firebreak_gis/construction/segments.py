"""Breaks as segments to build: lines and polygons with an order, sizes, costs and what they separate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from firebreak_gis.construction.centrelines import Borders, draw_lines, find_borders, mean_widths, middle_lines
from firebreak_gis.construction.compartments import Compartments, split, weights
from firebreak_gis.construction.sequence import construction_order, gains
from firebreak_gis.grid import outlines
from firebreak_gis.kernels.keys import distinct, keyed
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.schema import MapLayer, card, one_line

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Plane = np.ndarray | xr.DataArray

#: Rows of the table that a notebook shows.
_SHOWN = 10


class Segments(NamedTuple):
    """What is to be built, in order: one row a segment in both tables, with the same columns.

    Attributes
    ----------
    lines, polygons
        Middle lines and outlines.
    """

    lines: gpd.GeoDataFrame
    polygons: gpd.GeoDataFrame

    def facts(self) -> dict[str, object]:
        """How many, how long and how large, as `repr` and notebooks show them."""
        table = self.polygons
        return {
            "segments": len(table),
            "stages": table["stage"].nunique(),
            "length": f"{table['length_m'].sum() / 1000:,.4g} km",
            "area": f"{table['area_ha'].sum():,.4g} ha",
        }

    def layers(self) -> tuple[MapLayer, ...]:
        """Outlines by stage, middle lines over them."""
        table = self.polygons
        title = f"Segments, {len(table)} in {table['stage'].nunique()} stages"
        return (
            MapLayer(title, table, "stage", "stage of construction"),
            MapLayer("Middle lines of the segments", self.lines),
        )

    def __repr__(self) -> str:
        return one_line("Segments", self.facts())

    def _repr_html_(self) -> str:
        first = self.polygons.drop(columns="geometry").head(_SHOWN)
        return card("Segments", self.facts(), first.to_html(index=False, float_format="{:.4g}".format, border=0))


def segments_of(
    network: SpreadNetwork,
    breaks: Plane,
    *,
    priority: Plane | None = None,
    elevation: Plane | None = None,
    cost: Plane | None = None,
    value: Plane | None = None,
    ignition: Plane | None = None,
) -> Segments:
    """Take breaks apart into segments that each separate two compartments.

    Every cut cell is in exactly one segment. Cells between more than two compartments belong to the segment that is
    built first. Pieces that separate nothing, such as spurs and patches, are segments without compartments.

    Parameters
    ----------
    network
        The spread network before cutting.
    breaks
        (y, x), above 0 where the fuel is cut.
    priority
        (y, x) ranking; decides between segments that save equally much for their cost, higher first.
    elevation
        (y, x) [m], for the slope.
    cost
        (y, x) cost of cutting the cell, any one unit, at least 0. Default: 1 on fuel.
    value, ignition
        As in `compartments`.

    Returns
    -------
    lines : geopandas.GeoDataFrame
        Middle lines of the same segments, inside the polygons, sorted by `order`.
    polygons : geopandas.GeoDataFrame
        Outlines of all segments, sorted by `order`; valid.

    Raises
    ------
    GridError
        If a layer lies on another grid, or cells are not square.
    InputError
        If costs, values or ignitions are negative, infinite or missing on fuel.

    Notes
    -----
    Both have the columns

    * `order`: place in the order of construction, from 1, see `firebreak_gis.construction.sequence.construction_order`;
    * `stage`: segments of one stage lie between the same two compartments of what is built by then, and work only
      once all of them stand;
    * `length_m`: of the line;
    * `width_m`: mean width of the polygon, see `construction.centrelines.mean_widths`; a cell's for a wall
      that is one cell wide;
    * `cells`, `area_ha`;
    * `mean_slope_deg`, `max_slope_deg`: of the terrain at the cells by Horn's weights, NaN without elevation;
    * `cost`;
    * `compartment_a`, `compartment_b`: numbers as in `compartments`, a < b; both 0 for pieces that separate nothing;
    * `gain`: drop of the expected loss when the segment is built at its turn, in the unit of value, by the model of
      `compartments`; all gains and the expected loss with all breaks add up to that without breaks;
    * `gain_share`: of the sum of gains;
    * `stage_gain_share`: that of the whole stage, the same for all its segments. Before its last segment a stage saves
      hardly anything.

    Where the network has times and heat, also

    * `intensity_kw_m`, `flame_length_m`: of the fire that the segment must stop, from the fuel about it, see
      `simulation.holding.fire_before`; means over its cells;
    * `breach`: share of such fires that breach it at its width, by Wilson 1988 (doi 10.1139/x88-104);
    * `width_wilson_m`, `width_flames_m`: width that 5 % of them would breach by Wilson, and 1.5 flame lengths.

    Two pieces of break between the same compartments are two segments. On a torus lines end at the seam. Cost:
    linear in the cells; in the number of segments at most quadratic, with small factors.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> breaks = fb.select_breaks(fb.rank(network, budget=0.2), budget=0.2)
    >>> built = fb.segments_of(network, breaks)
    >>> bool(built.polygons["cells"].sum() == breaks.sum()), len(built.lines) == len(built.polygons)
    (True, True)
    """
    cut = network.mask(breaks, "breaks")
    parts = split(network, cut, value=value, ignition=ignition)
    borders = find_borders(parts.labels, cut, periodic=network.boundary == "periodic")
    price = weights(network, cost, "cost")
    pieces = _find_pieces(network, parts, borders, cut)
    score = _mean_score(network, priority, pieces)
    stages = construction_order(
        pieces.sides,
        cost=pieces.total(price),
        ignition=pieces.total(parts.ignition),
        value=pieces.total(parts.value),
        compartment_ignition=parts.ignition_mass,
        compartment_value=parts.value_mass,
        score=score,
    )
    owner, position, order, stage = _settle(pieces, stages, cut.size)
    saved = gains(position, owner, parts.labels.ravel(), parts.links, parts.ignition.ravel(), parts.value.ravel())[
        order
    ]
    sides = np.where(pieces.sides[order, 1:] > 0, pieces.sides[order], 0)
    share = saved / max(float(saved.sum()), np.finfo(float).tiny)
    columns = {
        "stage": stage,
        "compartment_a": sides[:, 0],
        "compartment_b": sides[:, 1],
        "gain": saved,
        "gain_share": share,
        "stage_gain_share": np.bincount(stage, weights=share)[stage] if stage.size else share,
        **_columns(network, owner, order, price, slope(network, elevation)),
        **_holding(network, owner, order, cut),
    }
    return _frames(network, owner, order, columns, borders)


@dataclass(frozen=True)
class _Pieces:
    """Segments before the cells between several of them are settled; the stretches of border come first.

    `sides` (n, 2) compartments, (a, b), (a, 0) or (0, 0); `cut` (k,) cells that are cut, and `main` (k,) the nearest
    segment of each; `cell`, `piece` (m,) all segments that a cut cell may belong to.
    """

    sides: np.ndarray
    cut: np.ndarray
    main: np.ndarray
    cell: np.ndarray
    piece: np.ndarray

    def total(self, plane: np.ndarray) -> np.ndarray:
        """Sum over the nearest cells of each segment."""
        return np.bincount(self.main, weights=plane.ravel()[self.cut], minlength=len(self.sides))


def _find_pieces(network: SpreadNetwork, parts: Compartments, borders: Borders, cut: np.ndarray) -> _Pieces:
    from scipy import ndimage

    loose, n_loose = ndimage.label(cut & (borders.reached < 0), structure=np.ones((3, 3)))
    main = np.where(loose > 0, len(borders.pair) + loose - 1, borders.reached).astype(np.int32).ravel()
    cell, compartment = _touches(parts, cut)
    sides = np.concatenate([borders.pair, np.zeros((n_loose, 2), np.int64)])
    own = main[cell] >= len(borders.pair)
    for piece, k in np.unique(np.column_stack([main[cell][own], compartment[own]]), axis=0).tolist():
        empty = np.flatnonzero(sides[piece] == 0)
        sides[piece, empty[:1]] = k
    inside = np.flatnonzero(cut)
    near_cell, near_stretch = _between(network, borders, cell * (parts.cells.size + 1) + compartment, parts.cells.size)
    key, sizes = keyed(
        np.concatenate([inside, borders.cell, near_cell]),
        np.concatenate([main[inside], borders.cell_stretch, near_stretch]),
    )
    return _Pieces(sides, inside, main[inside], *np.unravel_index(distinct(key), sizes))


def _touches(parts: Compartments, cut: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Cut cells and the compartments that fire could pass to or from, each pair once, sorted."""
    labels, wall = parts.labels.ravel(), cut.ravel()
    found = []
    for one, other in (parts.links, parts.links[::-1]):
        meets = wall[one] & (labels[other] > 0)
        found.append(one[meets].astype(np.int64) * (parts.cells.size + 1) + labels[other[meets]])
    key = distinct(np.concatenate(found))
    return np.divmod(key, parts.cells.size + 1)


def _between(
    network: SpreadNetwork, borders: Borders, touches: np.ndarray, n_parts: int
) -> tuple[np.ndarray, np.ndarray]:
    """Cells beside a border that touch both of its compartments, with its stretch: a gap there would open it too.

    `touches` holds cell x (`n_parts` + 1) + compartment, rising.
    """
    rows, cols = network.shape
    row, col = np.divmod(borders.cell, cols)
    found = [np.zeros((2, 0), np.int64)]
    for dr, dc in zip(ROW_STEP, COL_STEP, strict=True):
        r, c = row + dr, col + dc
        inside = (r >= 0) & (r < rows) & (c >= 0) & (c < cols) | (network.boundary == "periodic")
        near = (r % rows * cols + c % cols)[inside]
        stretch = borders.cell_stretch[inside]
        keys = near[:, np.newaxis] * (n_parts + 1) + borders.pair[stretch]
        at = np.searchsorted(touches, keys)
        both = (np.append(touches, -1)[at] == keys).all(axis=1)
        found.append(np.array([near[both], stretch[both]]))
    near, stretch = np.concatenate(found, axis=1)
    return near, stretch


def _mean_score(network: SpreadNetwork, priority: Plane | None, pieces: _Pieces) -> np.ndarray:
    """Mean finite priority of each segment; -inf for those without."""
    if priority is None:
        return np.zeros(len(pieces.sides))
    values = network.plane(priority, "priority").ravel()[pieces.cut].astype(np.float64)
    finite = np.isfinite(values)
    n = np.bincount(pieces.main[finite], minlength=len(pieces.sides))
    total = np.bincount(pieces.main[finite], weights=values[finite], minlength=len(pieces.sides))
    return np.where(n > 0, total / np.maximum(n, 1), -np.inf)


def _settle(
    pieces: _Pieces, stages: list[list[int]], n_cells: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Give each cut cell to the segment that is built first of those that it may belong to.

    Segments that are left without a cell are not built.

    Returns
    -------
    owner
        (n_cells,) int32 segment of each cell, -1 for cells that are not cut.
    position
        (n,) place of each segment in the order of construction, also of those that are not built.
    order
        Segments that are built, in that order.
    stage
        Stage of each of them, from 1.
    """
    n = len(pieces.sides)
    every = np.array([i for members in stages for i in members], dtype=np.int64)
    number = np.array([k for k, members in enumerate(stages) for _ in members], dtype=np.int64)
    position = np.empty(n, np.int64)
    position[every] = np.arange(n)
    best = np.full(n_cells, n, np.int32)
    np.minimum.at(best, pieces.cell, position[pieces.piece].astype(np.int32))
    built = distinct(best[best < n])
    stage = np.unique(number[built], return_inverse=True)[1].ravel() + 1
    return np.append(every, -1).astype(np.int32)[best], position, every[built], stage


def slope(network: SpreadNetwork, elevation: Plane | None) -> np.ndarray:
    """Slope of the terrain by Horn [degrees], (rows, cols); NaN where unknown."""
    if elevation is None:
        return np.full(network.shape, np.nan)
    from firebreak_gis.kernels.terrain import horn_slope

    return horn_slope(network.plane(elevation, "elevation").astype(np.float64), network.grid.cell_size)


def _columns(
    network: SpreadNetwork, owner: np.ndarray, order: np.ndarray, price: np.ndarray, slope: np.ndarray
) -> dict[str, np.ndarray]:
    """Sizes, costs and slopes of the segments in `order`."""
    inside = np.flatnonzero(owner >= 0)
    own, steepness = owner[inside], slope.ravel()[inside]
    n = int(own.max(initial=-1)) + 1
    cells = np.bincount(own, minlength=n)[order]
    known = np.isfinite(steepness)
    n_known = np.bincount(own[known], minlength=n)[order]
    mean = np.bincount(own[known], weights=steepness[known], minlength=n)[order] / np.maximum(n_known, 1)
    steepest = np.zeros(n)
    np.maximum.at(steepest, own[known], steepness[known])
    return {
        "cells": cells,
        "area_ha": cells * network.grid.cell_area_ha,
        "mean_slope_deg": np.where(n_known > 0, mean, np.nan),
        "max_slope_deg": np.where(n_known > 0, steepest[order], np.nan),
        "cost": np.bincount(own, weights=price.ravel()[inside], minlength=n)[order],
    }


def _holding(network: SpreadNetwork, owner: np.ndarray, order: np.ndarray, cut: np.ndarray) -> dict[str, np.ndarray]:
    """What segments must stop, and how wide they would have to be; nothing for a network that does not tell."""
    from firebreak_gis.simulation import holding

    if network.heat is None or network.travel_time is None:
        return {}
    hold = holding.Hold(share=None)
    inside = np.flatnonzero(owner >= 0)
    intensity, trees = (plane.ravel()[inside] for plane in holding.fire_before(network, hold))
    width = holding.widths(cut, network.grid.cell_size).ravel()[inside]
    found = {
        "intensity_kw_m": intensity,
        "flame_length_m": holding.flame_length(intensity),
        "breach": holding.breach(intensity, width, trees=trees),
        "width_wilson_m": holding.width_needed(intensity, trees=trees),
        "width_flames_m": hold.flames * holding.flame_length(intensity),
    }
    own = owner[inside]
    cells = np.maximum(np.bincount(own), 1)
    return {name: (np.bincount(own, weights=values) / cells)[order] for name, values in found.items()}


def _frames(
    network: SpreadNetwork, owner: np.ndarray, order: np.ndarray, columns: dict[str, np.ndarray], borders: Borders
) -> Segments:
    """Lines and polygons of the segments in `order`, which `columns` follow."""
    import geopandas as gpd
    import shapely

    grid = network.grid
    number = np.zeros(int(owner.max(initial=-1)) + 2, np.int32)  # the last entry is for cells in no segment
    number[order] = np.arange(1, order.size + 1)
    outlined = outlines(number[owner].reshape(network.shape), order.size, grid)
    drawn = draw_lines(borders, grid.transform)
    lines = middle_lines(outlined, [drawn[i] if i < len(drawn) else None for i in order])
    sizes = {
        "length_m": shapely.length(lines),
        "width_m": mean_widths(outlined),
    }
    names: tuple[str, ...] = (
        "order",
        "stage",
        "length_m",
        "width_m",
        "cells",
        "area_ha",
        "mean_slope_deg",
        "max_slope_deg",
        "cost",
        "compartment_a",
        "compartment_b",
        "gain",
        "gain_share",
        "stage_gain_share",
    )
    names += tuple(name for name in columns if name not in names)
    table = {"order": np.arange(1, order.size + 1), **columns, **sizes}
    table = {name: table[name] for name in names}
    return Segments(
        gpd.GeoDataFrame(table, geometry=lines, crs=grid.crs),
        gpd.GeoDataFrame(table, geometry=outlined, crs=grid.crs),
    )
