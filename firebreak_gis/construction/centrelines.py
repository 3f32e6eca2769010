"""Borders inside the breaks: which compartments each stretch of a break separates, and along which line.

Every cut cell is divided into 2 x 2 quarters, and each quarter goes to the compartment that is nearest through the
break. Where two compartments meet is the border; in a break of even width it runs down its middle, also if the break
is one cell wide. The part of a break that no border can be reached from separates nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.construction.keys import keyed

if TYPE_CHECKING:
    import shapely
    from affine import Affine

_SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))
_CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))


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
        (rows, cols) int64: stretch that the cut cell belongs to because it lies between the border and a compartment;
        -1 for cells that separate nothing.
    """

    pair: np.ndarray
    edge: np.ndarray
    ends: np.ndarray
    cell: np.ndarray
    cell_stretch: np.ndarray
    reached: np.ndarray


@dataclass(frozen=True)
class _Quarters:
    """The grid at half the cell size, flat. An open grid has a margin of one empty cell, so that no step leaves it."""

    rows: int
    cols: int
    margin: int

    def step(self, at: np.ndarray, row: int, col: int) -> np.ndarray:
        """Neighbours; a torus closes on itself."""
        r, c = np.divmod(at, self.cols)
        return np.asarray((r + row) % self.rows * self.cols + (c + col) % self.cols)

    def place(self, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Row and column of quarters, from the upper left corner of the grid."""
        r, c = np.divmod(at, self.cols)
        return r - 2 * self.margin, c - 2 * self.margin

    def cell(self, at: np.ndarray) -> np.ndarray:
        """Row-major number of the cell that the quarter lies in."""
        r, c = self.place(at)
        return np.asarray(r // 2 * (self.cols // 2 - 2 * self.margin) + c // 2)


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
    margin = 0 if periodic else 1
    grid = _Quarters(2 * (cut.shape[0] + 2 * margin), 2 * (cut.shape[1] + 2 * margin), margin)
    wall = _quarter(np.pad(cut, margin))
    region = _quarter(np.pad(labels, margin))
    quarters = np.flatnonzero(wall)
    depth = _grow(grid, wall, region, quarters)
    here, there, ends = _edges(grid, wall, region, quarters)
    pair, edge = _stretches(region[here], region[there], ends)
    sides = np.concatenate([here, there])
    owners = np.concatenate([edge, edge])
    owners, sides = owners[wall[sides]], sides[wall[sides]]
    key, sizes = keyed(grid.cell(sides), owners)
    cell, stretch = np.unravel_index(np.unique(key), sizes)
    reached = _descend(grid, depth, sides, owners)
    nearest = np.full(cut.size, len(pair), np.int64)
    np.minimum.at(nearest, grid.cell(quarters), np.where(reached[quarters] < 0, len(pair), reached[quarters]))
    nearest[nearest == len(pair)] = -1
    return Borders(pair, edge, ends, cell, stretch, nearest.reshape(cut.shape))


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
    import shapely

    order = np.argsort(borders.edge, kind="stable")
    units = shapely.linestrings(borders.ends[order].astype(np.float64))
    merged = shapely.line_merge(shapely.multilinestrings(units, indices=borders.edge[order]))

    def to_map(points: np.ndarray) -> np.ndarray:
        return np.column_stack(
            [transform.c + transform.a * points[:, 0] / 2, transform.f + transform.e * points[:, 1] / 2]
        )

    lines = []
    for geometry in merged:
        parts = [_smooth(shapely.get_coordinates(part)) for part in shapely.get_parts(geometry)]
        plain = shapely.simplify(parts, 1e-6)
        lines.append(shapely.transform(plain[0] if len(plain) == 1 else shapely.MultiLineString(list(plain)), to_map))
    return lines


def middle_line(outline: shapely.Geometry, border: shapely.Geometry | None) -> shapely.Geometry:
    """Return the line of a segment, inside its polygon.

    Parameters
    ----------
    outline
        Polygon of the cells of the segment.
    border
        Line along which it separates two compartments. The cells about its ends may belong to other segments. None for
        a segment that separates nothing: its line is the long axis of its largest part.
    """
    import shapely

    if border is not None:
        inside = border if outline.covers(border) else _lines_of(shapely.intersection(border, outline))
        if inside.length > 0:
            return inside
    part = max(shapely.get_parts(outline), key=lambda polygon: polygon.area)
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(part))[:4]
    if np.hypot(*(corners[1] - corners[0])) < np.hypot(*(corners[2] - corners[1])):
        corners = np.roll(corners, -1, axis=0)
    ends = (corners[[1, 0]] + corners[[2, 3]]) / 2
    axis = shapely.LineString(ends[np.lexsort((ends[:, 1], ends[:, 0]))])
    inside = _lines_of(shapely.intersection(axis, part))
    if inside.length > 0:
        return inside
    y = part.representative_point().y
    left, _, right, _ = part.bounds
    return _lines_of(shapely.intersection(shapely.LineString([(left, y), (right, y)]), part))


def mean_width(outline: shapely.Geometry) -> float:
    """Return the width of the rectangle with the area and the perimeter of a polygon; of several, their mean by area.

    For a band of even width, straight or with corners, it is what can be measured across it; for cells that meet at
    corners only, a cell's.
    """
    import shapely

    parts = shapely.get_parts(outline)
    area, round_ = shapely.area(parts), shapely.length(parts)
    width = (round_ - np.sqrt(np.maximum(round_**2 - 16.0 * area, 0.0))) / 4.0
    return float((width * area).sum() / area.sum())


def _lines_of(geometry: shapely.Geometry) -> shapely.Geometry:
    """The lines among what an intersection left, joined."""
    import shapely

    parts = [part for part in shapely.get_parts(geometry) if part.geom_type == "LineString" and not part.is_empty]
    return shapely.line_merge(shapely.MultiLineString(parts))


def _smooth(points: np.ndarray) -> shapely.LineString:
    import shapely

    middles = (points[1:] + points[:-1]) / 2
    if (points[0] == points[-1]).all():
        return shapely.LineString(np.concatenate([middles, middles[:1]]))
    return shapely.LineString(np.concatenate([points[:1], middles, points[-1:]]))


def _quarter(plane: np.ndarray) -> np.ndarray:
    return np.repeat(np.repeat(plane, 2, axis=0), 2, axis=1).ravel()


def _grow(grid: _Quarters, wall: np.ndarray, region: np.ndarray, quarters: np.ndarray) -> np.ndarray:
    """Spread the compartments over the quarters of the wall, in place; return the steps taken to each quarter."""
    depth = np.zeros(wall.size, np.int32)
    around = (
        np.unique(np.concatenate([grid.step(quarters, r, c) for r, c in _SIDES + _CORNERS]))
        if quarters.size
        else quarters
    )
    last, older = around[region[around] > 0], quarters[:0]
    step = 0
    while last.size or older.size:
        step += 1
        over_corners = step % 2 == 0
        front = np.concatenate([last, older]) if over_corners else last
        targets, sources = _push(grid, front, _SIDES + _CORNERS if over_corners else _SIDES)
        free = wall[targets] & (region[targets] == 0)
        new, label = _lowest(targets[free], region[sources[free]])
        region[new] = label
        depth[new] = step
        older = quarters[:0] if over_corners else last
        last = new
    return depth


def _descend(grid: _Quarters, depth: np.ndarray, seeds: np.ndarray, owners: np.ndarray) -> np.ndarray:
    """Stretch of each quarter that can be reached from a border by steps towards a compartment; -1 for others."""
    found = np.full(depth.size, -1, np.int64)
    front, label = _lowest(seeds, owners)
    while front.size:
        found[front] = label
        targets, sources = _push(grid, front, _SIDES + _CORNERS)
        lower = (found[targets] < 0) & (depth[targets] > 0) & (depth[targets] < depth[sources])
        front, label = _lowest(targets[lower], found[sources[lower]])
    return found


def _push(grid: _Quarters, front: np.ndarray, steps: tuple[tuple[int, int], ...]) -> tuple[np.ndarray, np.ndarray]:
    """All neighbours of a front, and which of it each comes from."""
    return np.concatenate([grid.step(front, r, c) for r, c in steps]), np.tile(front, len(steps))


def _lowest(targets: np.ndarray, labels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Each target once, with its lowest label."""
    order = np.lexsort((labels, targets))
    unique, first = np.unique(targets[order], return_index=True)
    return unique, labels[order][first]


def _edges(
    grid: _Quarters, wall: np.ndarray, region: np.ndarray, quarters: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Units of border: the quarters on both sides, at least one of them cut, and the two ends."""
    found: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    for row, col in _SIDES:
        there = grid.step(quarters, row, col)
        meets = (region[quarters] > 0) & (region[there] > 0) & (region[quarters] != region[there])
        if row + col < 0:  # between two cut quarters it is found from the other one
            meets &= ~wall[there]
        y, x = grid.place(quarters[meets])
        start = np.column_stack([x + (col > 0), y + (row > 0)])
        ends = np.stack([start, start + np.array([abs(row), abs(col)])], axis=1)
        found.append((quarters[meets], there[meets], ends))
    here, there, ends = (np.concatenate(part) for part in zip(*found, strict=True))
    return here, there, ends.astype(np.int64)


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
