"""Borders inside the breaks: which compartments each stretch of a break separates, and along which line.

Every cut cell is divided into 2 x 2 quarters, and each quarter goes to the compartment that is nearest through the
break. Where two compartments meet is the border; in a break of even width it runs down its middle, also if the break
is one cell wide. The part of a break that no border can be reached from separates nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.kernels.keys import distinct, keyed

if TYPE_CHECKING:
    import shapely
    from affine import Affine


#: Units of border that are joined at once: each is an object of its own, of some 200 B.
_TOGETHER = 500_000


@dataclass(frozen=True)
class Borders:
    """Stretches of border, each between one pair of compartments.

    Parameters
    ----------
    pair
        (n, 2) int64 compartments, the lower number first.
    edge
        (e,) int64 stretch of each unit of border, from 0.
    ends
        (e, 2, 2) int64 its two ends (x, y), in half cells from the upper left corner of the grid.
    cell, cell_stretch
        (m,) int64: row-major cut cells and the stretches whose border lies in them or on their rim, each pair once.
    reached
        (rows, cols) int32: stretch that the cut cell belongs to because it lies between the border and a compartment;
        -1 for cells that separate nothing.
    """

    pair: np.ndarray
    edge: np.ndarray
    ends: np.ndarray
    cell: np.ndarray
    cell_stretch: np.ndarray
    reached: np.ndarray


def find_borders(labels: np.ndarray, cut: np.ndarray, *, periodic: bool = False) -> Borders:
    """Find the borders between compartments inside the breaks.

    Parameters
    ----------
    labels
        (rows, cols) int32 compartments from 1, 0 for none.
    cut
        (rows, cols) bool.
    periodic
        Whether the grid is a torus. Lines end at its seam.

    Returns
    -------
    Borders
        Stretches sorted by compartments, then by place.

    Notes
    -----
    Distance grows in octagons (steps over sides and over all eight neighbours in turn). A quarter equally near to two
    compartments goes to the lower number. Cost: linear in the cells, n log n in the cut cells.
    """
    from firebreak_gis.kernels.borders import descend, grow, meetings

    cells = np.flatnonzero(cut)
    number = np.full(cut.shape, -1, np.int32)
    number[cut] = np.arange(cells.size)
    region, depth = grow(number, labels, cells, periodic)
    quarters, regions, ends = meetings(number, labels, cells, region, periodic)
    pair, edge = _stretches(regions[0], regions[1], ends)
    sides, owners = quarters.ravel(), np.concatenate([edge, edge])
    owners, sides = owners[sides >= 0], sides[sides >= 0]
    key, sizes = keyed(cells[sides // 4], owners)
    cell, stretch = np.unravel_index(distinct(key), sizes)
    reached = descend(number, cells, depth, sides, owners, periodic).reshape(-1, 4)
    nearest = np.where(reached < 0, len(pair), reached).min(axis=1, initial=len(pair))
    of_cells = np.full(cut.shape, -1, np.int32)
    of_cells[cut] = np.where(nearest == len(pair), -1, nearest)
    return Borders(pair, edge, ends, cell, stretch, of_cells)


def draw_lines(borders: Borders, transform: Affine) -> list[shapely.Geometry]:
    """Draw each stretch as a line or, where it branches, lines.

    Units of border are joined at their middles, so that a staircase becomes a diagonal; ends stay.

    Parameters
    ----------
    borders
        As `find_borders` returns them.
    transform
        Of the grid.
    """
    order = np.argsort(borders.edge, kind="stable")
    starts = np.searchsorted(borders.edge[order], np.arange(len(borders.pair) + 1))
    lines: list[shapely.Geometry] = []
    while len(lines) < len(borders.pair):
        first = len(lines)
        last = max(int(np.searchsorted(starts, starts[first] + _TOGETHER, side="right")) - 1, first + 1)
        units = order[starts[first] : starts[last]]
        lines += _drawn(borders.ends[units].astype(np.float64), borders.edge[units] - first, transform)
    return lines


def _drawn(ends: np.ndarray, stretch: np.ndarray, transform: Affine) -> list[shapely.Geometry]:
    """Draw stretches whose units are given, those of one after those of another; see `draw_lines`."""
    import shapely

    merged = shapely.line_merge(shapely.multilinestrings(shapely.linestrings(ends), indices=stretch))
    parts, of = shapely.get_parts(merged, return_index=True)
    plain = shapely.simplify(_smooth(parts), 1e-6)
    scale, shift = np.array([transform.a, transform.e]) / 2, np.array([transform.c, transform.f])
    placed = shapely.transform(plain, lambda points: shift + scale * points)
    single = np.bincount(of, minlength=merged.size)[of] == 1
    lines = np.empty(merged.size, object)
    lines[of[single]] = placed[single]
    shapely.multilinestrings(placed[~single], indices=of[~single], out=lines)
    return list(lines)


def middle_lines(outlines: Sequence[shapely.Geometry], borders: Sequence[shapely.Geometry | None]) -> list[Any]:
    """Return the line of each segment, inside its polygon.

    Parameters
    ----------
    outlines
        Polygon of the cells of each segment.
    borders
        Line along which each separates two compartments. The cells about its ends may belong to other segments. None
        for a segment that separates nothing: its line is the long axis of its largest part.
    """
    import shapely

    polygons, lines = np.array(outlines, object), np.array(borders, object)
    inside = lines.copy()
    partly = np.flatnonzero(shapely.is_geometry(lines) & ~shapely.covers(polygons, lines))
    inside[partly] = _lines_of(shapely.intersection(lines[partly], polygons[partly]))
    for k in np.flatnonzero(~(shapely.length(inside) > 0)):
        inside[k] = _axis(polygons[k])
    return list(inside)


def _axis(outline: shapely.Geometry) -> shapely.Geometry:
    """Return the long axis of the largest part of a polygon, or a line inside it."""
    import shapely

    part = max(shapely.get_parts(outline), key=lambda polygon: polygon.area)
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(part))[:4]
    if np.hypot(*(corners[1] - corners[0])) < np.hypot(*(corners[2] - corners[1])):
        corners = np.roll(corners, -1, axis=0)
    ends = (corners[[1, 0]] + corners[[2, 3]]) / 2
    axis = shapely.LineString(ends[np.lexsort((ends[:, 1], ends[:, 0]))])
    inside = _lines_of(shapely.intersection([axis], [part]))[0]
    if inside.length > 0:
        return inside
    y = part.representative_point().y
    left, _, right, _ = part.bounds
    return _lines_of(shapely.intersection([shapely.LineString([(left, y), (right, y)])], [part]))[0]


def mean_widths(outlines: Sequence[shapely.Geometry]) -> np.ndarray:
    """Return the width of the rectangle with the area and the perimeter of each polygon; of parts, their mean by area.

    For a band of even width, straight or with corners, it is what can be measured across it; for cells that meet at
    corners only, a cell's.
    """
    import shapely

    parts, of = shapely.get_parts(np.array(outlines, object), return_index=True)
    area, round_ = shapely.area(parts), shapely.length(parts)
    width = (round_ - np.sqrt(np.maximum(round_**2 - 16.0 * area, 0.0))) / 4.0
    whole = [np.bincount(of, weights=each, minlength=len(outlines)) for each in (width * area, area)]
    return np.asarray(whole[0] / whole[1])


def _lines_of(geometries: np.ndarray) -> np.ndarray:
    """The lines among what intersections left, those of each joined."""
    import shapely

    parts, of = shapely.get_parts(geometries, return_index=True)
    kept = (shapely.get_type_id(parts) == shapely.GeometryType.LINESTRING) & ~shapely.is_empty(parts)
    lines = np.full(len(geometries), shapely.MultiLineString())
    shapely.multilinestrings(parts[kept], indices=of[kept], out=lines)
    return np.asarray(shapely.line_merge(lines))


def _smooth(lines: np.ndarray) -> np.ndarray:
    """Lines through the middles of the pieces of lines, and through their ends where they are not closed."""
    import shapely

    points, line = shapely.get_coordinates(lines, return_index=True)
    n_points = np.bincount(line, minlength=lines.size)
    first = np.cumsum(n_points) - n_points
    last = first + n_points - 1
    closed = (points[first] == points[last]).all(axis=1)
    # In the place of each point the middle before it; of the first its own place, or nothing where the line closes.
    before = points.copy()
    before[1:] = (points[1:] + points[:-1]) / 2
    kept = np.ones(line.size, bool)
    before[first], kept[first] = points[first], ~closed
    ends = np.where(closed[:, np.newaxis], before[first + 1], points[last])
    of = np.append(line[kept], np.arange(lines.size))
    by_line = np.argsort(of, kind="stable")
    return np.asarray(shapely.linestrings(np.append(before[kept], ends, axis=0)[by_line], indices=of[by_line]))


def _stretches(one: np.ndarray, other: np.ndarray, ends: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pair of compartments of each stretch, and stretch of each unit: connected units of the same pair."""
    import scipy.sparse as sp
    from scipy.sparse.csgraph import connected_components

    if one.size == 0:
        return np.zeros((0, 2), np.int64), np.zeros(0, np.int64)
    pairs = np.column_stack([np.minimum(one, other), np.maximum(one, other)]).astype(np.int64)
    _, pair = np.unique(keyed(*pairs.T)[0], return_inverse=True)
    _, node = np.unique(keyed(np.repeat(pair, 2), *ends.reshape(-1, 2).T)[0], return_inverse=True)
    node = node.reshape(-1, 2).astype(np.int32)  # scipy's graphs know no longer numbers
    n = int(node.max()) + 1
    _, part = connected_components(sp.coo_array((np.ones(len(node)), (node[:, 0], node[:, 1])), (n, n)), directed=False)
    # Nodes are sorted by pair and place, so parts numbered by their first node are too.
    _, first, stretch = np.unique(part[node[:, 0]], return_index=True, return_inverse=True)
    lowest = np.full(first.size, n)
    np.minimum.at(lowest, stretch.ravel(), node.min(axis=1))
    rank = np.argsort(np.argsort(lowest, kind="stable"), kind="stable")
    edge = rank[stretch.ravel()]
    pair_of = np.zeros((first.size, 2), np.int64)
    pair_of[edge] = pairs
    return pair_of, edge
