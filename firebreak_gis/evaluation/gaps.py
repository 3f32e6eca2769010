"""Gaps between breaks: from each loose end straight to what lies near, another break or ground without fuel.

An end is loose if nothing that stops fire lies beside it. From it the nearest cells of other breaks, of the break's own
other end, and of ground without fuel are looked at; a gap is the straight line to one of them, over the fuel between.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.landscape.footprints import close_corners, footprints

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.existing import Existing

#: What a gap leads to where it is no break.
NO_FUEL = -1
#: Cells within so many of an end stand beside it.
_BESIDE = 1.5
#: Breaks that are looked at from an end, the nearest.
_NEAREST = 3


@dataclass(frozen=True, eq=False)
class Gaps:
    """Gaps that could be closed.

    Parameters
    ----------
    frame
        One straight line a gap, with `from_break` and `to_break`, positions of the breaks (`NO_FUEL` for ground without
        fuel), and `length_m`; shortest first.
    cells
        Of each gap, row-major numbers of the cells with fuel, not cut so far, that closing it cuts.
    """

    frame: gpd.GeoDataFrame
    cells: list[np.ndarray]


def find_gaps(existing: Existing, burnable: np.ndarray, grid: Grid, *, longest: float, most: int) -> tuple[Gaps, int]:
    """Find gaps at the ends of breaks.

    Parameters
    ----------
    existing
        The breaks.
    burnable
        (rows, cols) bool, cells that hold fuel.
    grid
        Of the network.
    longest
        Length of the longest gap [m].
    most
        Gaps that are kept, the shortest.

    Returns
    -------
    gaps : Gaps
        The gaps.
    left_out : int
        Longer ones, beyond `most`.
    """
    import geopandas as gpd
    import shapely

    cut = np.zeros(grid.shape, bool)
    for cells in existing.cells:
        cut.ravel()[cells] = True
    found: dict[tuple[int, ...], tuple[float, int, int, np.ndarray]] = {}
    for i in range(len(existing)):
        for end in range(2):
            for to, target in _targets(existing, i, end, burnable & ~cut, grid, longest):
                start = existing.ends[i][end]
                length = float(np.hypot(*(target - start)))
                pair = (i, end, to) if to == NO_FUEL else (min(i, to), max(i, to))
                if pair not in found or length < found[pair][0]:
                    found[pair] = (length, i, to, np.array([start, target]))
    chosen = sorted(found.values(), key=lambda gap: (gap[0], gap[1], gap[2]))
    frame = gpd.GeoDataFrame(
        {
            "from_break": [i for _, i, _, _ in chosen],
            "to_break": [to for _, _, to, _ in chosen],
            "length_m": np.array([length for length, *_ in chosen], float),
        },
        geometry=[shapely.LineString(points) for *_, points in chosen],
        crs=grid.crs,
    )
    across = [_across(frame.iloc[[k]], burnable & ~cut, grid) for k in range(len(frame))]
    open_ = [k for k, cells in enumerate(across) if cells.size]
    kept = open_[:most]
    return Gaps(frame.iloc[kept].reset_index(drop=True), [across[k] for k in kept]), len(open_) - len(kept)


def _targets(
    existing: Existing, i: int, end: int, open_fuel: np.ndarray, grid: Grid, longest: float
) -> list[tuple[int, np.ndarray]]:
    """Break and place (x, y) of what lies near a loose end; nothing for an end that is not loose."""
    x, y = grid.x, grid.y
    start = existing.ends[i][end]
    reach, cols = _BESIDE * grid.cell_size, grid.shape[1]
    own = np.zeros(open_fuel.size, bool)
    own[existing.cells[i]] = True
    near = []

    def nearest(cells: np.ndarray) -> tuple[float, np.ndarray]:
        places = np.column_stack([x[cells % cols], y[cells // cols]])
        away = np.hypot(*(places - start).T)
        k = int(np.argmin(away))
        return float(away[k]), places[k]

    for j, cells in enumerate(existing.cells):
        others = cells[~own[cells]]
        if j == i or not others.size:
            continue
        away, place = nearest(others)
        if away <= reach:
            return []
        if away <= longest:
            near.append((away, j, place))
    bare = np.flatnonzero(~open_fuel.ravel() & ~own)
    taken = np.zeros(open_fuel.size, bool)
    for cells in existing.cells:
        taken[cells] = True
    bare = bare[~taken[bare]]
    if bare.size:
        away, place = nearest(bare)
        if away <= reach:
            return []
        if away <= longest:
            near.append((away, NO_FUEL, place))
    other = existing.ends[i][1 - end]
    if (away := float(np.hypot(*(other - start)))) <= min(longest, 0.5 * existing.lengths[i]):
        near.append((away, i, other))
    near.sort(key=lambda each: (each[0], each[1]))
    breaks = [each for each in near if each[1] != NO_FUEL][:_NEAREST]
    return [(j, place) for _, j, place in breaks + [each for each in near if each[1] == NO_FUEL]]


def _across(line: gpd.GeoDataFrame, open_fuel: np.ndarray, grid: Grid) -> np.ndarray:
    """Cells that closing a gap cuts."""
    mask = np.zeros(grid.shape, bool)
    mask.ravel()[footprints(line, grid).cell] = True
    return np.flatnonzero((close_corners(mask, line, grid) & open_fuel).ravel())
