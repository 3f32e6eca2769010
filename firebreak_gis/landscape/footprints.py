"""Which cells points, lines and polygons cut, and how much of each: exact areas, never cell centres alone.

Outlines are taken apart where they cross the edges of cells. The area of a polygon in a cell is then a sum over the
pieces of its outline: each covers what lies to the east of it, counted down or up as it runs. The cost is linear in
the cells on outlines, under a microsecond each.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.grid import Grid

if TYPE_CHECKING:
    import geopandas as gpd

#: Parts of a cell (area, or length in cells) below this come from rounding coordinates.
LEAST_PART = 1e-7
#: A geometry nearer than this to a corner of cells passes through the corner (in cells).
THROUGH_CORNER = 1e-3


@dataclass(frozen=True)
class Footprints:
    """Pairs of a feature and a cell that it cuts, sorted by feature, then cell.

    Parameters
    ----------
    feature
        (n,) int64, position of the feature.
    cell
        (n,) int64, row-major number of the cell.
    part
        (n,) float64: share of the cell's area for polygons, length in cells for lines, number of points for points.
    whole
        (features,) float64: the same measure of each feature, what lies outside the grid included.
    """

    feature: np.ndarray
    cell: np.ndarray
    part: np.ndarray
    whole: np.ndarray


def footprints(frame: gpd.GeoDataFrame, grid: Grid) -> Footprints:
    """Find every cell that points, lines and polygons cut.

    A cell is cut if a polygon covers some of its area, or a line some length in it; one that is only touched from
    outside is not.

    Parameters
    ----------
    frame
        In the CRS of the grid, each geometry of one kind.
    grid
        The grid.
    """
    return footprints_in_cells(in_cells(frame, grid), grid.shape)


def footprints_in_cells(shapes: np.ndarray, shape: tuple[int, int]) -> Footprints:
    """As `footprints`, of geometries in (column, row) coordinates, on a grid of (rows, cols)."""
    import shapely

    if not len(shapes):
        nothing = np.zeros(0, np.int64)
        return Footprints(nothing, nothing, np.zeros(0), np.zeros(0))
    dimension = shapely.get_dimensions(shapes)
    whole = np.where(dimension == 2, shapely.area(shapes), shapely.length(shapes))
    whole = np.where(dimension == 0, shapely.get_num_geometries(shapes), whole)
    kinds = ((_points, 0), (_lines, 1), (_polygons, 2))
    found = [cut(shapes, np.flatnonzero(dimension == kind), shape) for cut, kind in kinds]
    feature, cell, part = (np.concatenate([piece[i] for piece in found]) for i in range(3))
    order = np.lexsort((cell, feature))
    order = order[part[order] > LEAST_PART]
    return Footprints(feature[order], cell[order], part[order], whole)


def close_corners(mask: np.ndarray, frame: gpd.GeoDataFrame, grid: Grid) -> np.ndarray:
    """Return the mask with the cells beside each corner of cells through which a geometry passes.

    Fire passes between two cells that only meet at a corner; a line exactly through that corner must stop it.

    Parameters
    ----------
    mask
        (rows, cols) bool, cells that the geometries cut.
    frame
        The geometries.
    grid
        The grid.
    """
    import shapely

    falling, rising = corner_contacts(mask)
    at = np.argwhere(falling | rising)
    if not at.size:
        return mask
    tree = shapely.STRtree(in_cells(frame, grid))
    corners = shapely.points(at[:, 1] + 1.0, at[:, 0] + 1.0)
    passed = np.unique(tree.query(corners, predicate="dwithin", distance=THROUGH_CORNER)[0])
    closed = mask.copy()
    for row, col in at[passed]:
        closed[row : row + 2, col : col + 2] = True
    return closed


def corner_contacts(mask: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Inner corners of cells at which two cells of the mask meet and the two others are not in it.

    Returns
    -------
    tuple of numpy.ndarray
        (rows - 1, cols - 1) bool: the north-western and the south-eastern cell meet; the other two do.
    """
    nw, ne, sw, se = mask[:-1, :-1], mask[:-1, 1:], mask[1:, :-1], mask[1:, 1:]
    return nw & se & ~ne & ~sw, ne & sw & ~nw & ~se


def in_cells(frame: gpd.GeoDataFrame, grid: Grid) -> np.ndarray:
    """Return the geometries in (column, row) coordinates of the grid, counted from its north-western corner."""
    import shapely

    t = ~grid.transform
    # Centred first: differences of map coordinates are exact, products with their inverse are not.
    x0, y0 = grid.transform.c, grid.transform.f

    def placed(points: np.ndarray) -> np.ndarray:
        dx, dy = points[:, 0] - x0, points[:, 1] - y0
        return np.column_stack((t.a * dx + t.b * dy, t.d * dx + t.e * dy))

    return np.asarray(shapely.transform(np.asarray(frame.geometry.array), placed))


Pieces = tuple[np.ndarray, np.ndarray, np.ndarray]


def _points(shapes: np.ndarray, chosen: np.ndarray, shape: tuple[int, int]) -> Pieces:
    import shapely

    coordinates, owner = shapely.get_coordinates(shapes[chosen], return_index=True)
    col, row = np.floor(coordinates[:, 0]), np.floor(coordinates[:, 1])
    # The southern and eastern edge belong to the grid.
    col -= coordinates[:, 0] == shape[1]
    row -= coordinates[:, 1] == shape[0]
    inside = (row >= 0) & (row < shape[0]) & (col >= 0) & (col < shape[1])
    cells = (row * shape[1] + col)[inside].astype(np.int64)
    pairs, count = np.unique(np.stack((chosen[owner[inside]], cells)), axis=1, return_counts=True)
    return pairs[0], pairs[1], count.astype(np.float64)


def _lines(shapes: np.ndarray, chosen: np.ndarray, shape: tuple[int, int]) -> Pieces:
    import shapely

    parts, owner = shapely.get_parts(shapes[chosen], return_index=True)
    rings, ring = shapely.get_coordinates(parts, return_index=True)
    start = np.flatnonzero(ring[1:] == ring[:-1])
    from_, to, line = _pieces(rings[start], rings[start + 1])
    col, row = np.floor((from_ + to) / 2).astype(np.int64).T
    inside = (row >= 0) & (row < shape[0]) & (col >= 0) & (col < shape[1])
    feature = chosen[owner[ring[start]]][line][inside]
    return _summed(feature, (row * shape[1] + col)[inside], np.hypot(*(to - from_).T)[inside])


def _polygons(shapes: np.ndarray, chosen: np.ndarray, shape: tuple[int, int]) -> Pieces:
    import shapely

    parts, owner = shapely.get_parts(shapes[chosen], return_index=True)
    rings, polygon = shapely.get_rings(parts, return_index=True)
    if not len(rings):
        return _summed(*(np.zeros(0, np.int64),) * 2, np.zeros(0))
    outer = np.concatenate(([True], polygon[1:] != polygon[:-1]))
    # Rows count southwards, so that a ring that is clockwise on the map covers what lies east of what runs down.
    sign = np.where(shapely.is_ccw(rings) == outer, -1.0, 1.0)
    points, ring = shapely.get_coordinates(rings, return_index=True)
    start = np.flatnonzero(ring[1:] == ring[:-1])
    from_, to, line = _pieces(points[start], points[start + 1])
    col, row = np.floor((from_ + to) / 2).astype(np.int64).T
    middle = (from_[:, 0] + to[:, 0]) / 2
    drop = (to[:, 1] - from_[:, 1]) * sign[ring[start]][line]
    feature = chosen[owner[polygon[ring[start]]]][line]
    used = (row >= 0) & (row < shape[0]) & (col < shape[1]) & (drop != 0)
    west = col < 0  # all cells of the row lie to the east
    col = np.where(west, -1, col)
    own = np.where(west, 0.0, drop * (col + 1 - middle))
    key = (feature * shape[0] + row)[used], col[used]
    order = np.lexsort((key[1], key[0]))
    line_key, col = key[0][order], key[1][order]
    new = np.concatenate(([True], (line_key[1:] != line_key[:-1]) | (col[1:] != col[:-1])))[: len(col)]
    first = np.flatnonzero(new)
    if not first.size:
        return _summed(*(np.zeros(0, np.int64),) * 2, np.zeros(0))
    line_key, col = line_key[first], col[first]
    drop, own = (np.add.reduceat(values[used][order], first) for values in (drop, own))
    # Along each row: the height that all pieces to the west cover together.
    total = np.cumsum(drop)
    row_start = np.concatenate(([True], line_key[1:] != line_key[:-1]))
    before = np.concatenate(([0.0], total[:-1]))
    base = before[np.flatnonzero(row_start)][np.cumsum(row_start) - 1]
    after, before = total - base, before - base
    last = np.concatenate((line_key[1:] != line_key[:-1], [True]))
    stop = np.where(last, shape[1], np.concatenate((col[1:], [0])))
    gap = np.where(after > LEAST_PART, np.maximum(stop - col - 1, 0), 0)
    of = np.repeat(np.arange(gap.size), gap)
    inner = col[of] + 1 + np.arange(of.size) - np.repeat(np.cumsum(gap) - gap, gap)
    real = col >= 0
    lines = np.concatenate((line_key[real], line_key[of]))
    cells = lines % shape[0] * shape[1] + np.concatenate((col[real], inner))
    return lines // shape[0], cells, np.concatenate((before[real] + own[real], after[of]))


def _pieces(from_: np.ndarray, to: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Split straight lines where they cross edges of cells; (n, 2) beginnings and ends, and the line of each."""
    n = len(from_)
    places, owners = [np.zeros(n), np.ones(n)], [np.arange(n), np.arange(n)]
    for axis in (0, 1):
        low, high = np.minimum(from_[:, axis], to[:, axis]), np.maximum(from_[:, axis], to[:, axis])
        first = np.floor(low) + 1
        count = np.maximum(np.ceil(high) - first, 0).astype(np.int64)
        of = np.repeat(np.arange(n), count)
        edge = first[of] + np.arange(of.size) - np.repeat(np.cumsum(count) - count, count)
        places.append((edge - from_[of, axis]) / (to[of, axis] - from_[of, axis]))
        owners.append(of)
    place, owner = np.concatenate(places), np.concatenate(owners)
    order = np.lexsort((place, owner))
    place, owner = place[order], owner[order]
    start = np.flatnonzero((owner[1:] == owner[:-1]) & (place[1:] > place[:-1]))
    line = owner[start]
    step = to[line] - from_[line]
    ends = [from_[line] + place[at][:, None] * step for at in (start, start + 1)]
    ends[1] = np.where((place[start + 1] == 1.0)[:, None], to[line], ends[1])
    return ends[0], ends[1], line


def _summed(feature: np.ndarray, cell: np.ndarray, part: np.ndarray) -> Pieces:
    """Add up what a feature has in a cell."""
    if not feature.size:
        return feature.astype(np.int64), cell.astype(np.int64), part
    order = np.lexsort((cell, feature))
    feature, cell, part = feature[order], cell[order], part[order]
    first = np.flatnonzero(np.concatenate(([True], (feature[1:] != feature[:-1]) | (cell[1:] != cell[:-1]))))
    return feature[first], cell[first], np.add.reduceat(part, first)
