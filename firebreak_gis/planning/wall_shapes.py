"""Walls as multilines of the map: line after line, led on to the walls before them, and which rest on which."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid
    from firebreak_gis.placement.lines import LineCut

#: Cells from the end of a line within which it is led on to a line that stands before it.
_JOINED = 1.5
#: Cells from a line within which others end on it.
_TOUCHES = 0.3


def on_map(cut: LineCut, grid: Grid) -> list[np.ndarray]:
    """Its lines in the coordinates of the map, one after the other from an end of the wall."""
    from firebreak_gis.kernels.crossings import PARTS

    t = grid.transform
    lines = [np.column_stack([t.c + t.a * line[:, 0] / PARTS, t.f + t.e * line[:, 1] / PARTS]) for line in cut.lines]
    return chained(lines)


def chained(lines: list[np.ndarray]) -> list[np.ndarray]:
    """The lines in turn, each from the end that is nearest to where the one before ends.

    The first begins at the end that is farthest from the middle of all ends.
    """
    ends = np.array([[line[0], line[-1]] for line in lines])
    away = np.hypot(*(ends - ends.mean(axis=(0, 1))).T).T
    waiting = np.ones(len(lines), bool)
    out: list[np.ndarray] = []
    while waiting.any():
        k, side = divmod(int(np.argmax(np.where(waiting[:, np.newaxis], away, -np.inf))), 2)
        out.append(lines[k][:: -1 if side else 1])
        waiting[k] = False
        away = -np.hypot(*(ends - out[-1][-1]).T).T
    return out


def joined(walls: list[list[np.ndarray]], cell_size: float) -> list[Any]:
    """The walls as multilines, each end near a line of a wall before led to it, or cut where it crosses that."""
    import shapely

    every = [shapely.LineString(line) for wall in walls for line in wall]
    owner = np.repeat(np.arange(len(walls)), [len(wall) for wall in walls])
    tree = shapely.STRtree(every)
    reach = _JOINED * cell_size
    out = []
    for k, wall in enumerate(walls):
        lines = []
        for line in wall:
            if np.hypot(*np.diff(line, axis=0).T).sum() > cell_size:  # not the stubs across corners
                for _ in range(2):
                    line = line[::-1]
                    near = tree.query(shapely.Point(line[0]), predicate="dwithin", distance=reach)
                    before = [every[i] for i in near[owner[near] < k]]
                    if before:
                        line = _led(line, shapely.MultiLineString(before), reach)
            lines.append(line)
        out.append(shapely.MultiLineString(lines))
    return out


def resting(walls: Sequence[Any], cell_size: float) -> list[list[int]]:
    """Of each wall, a multiline, those before it on which an end of its lines lies.

    Examples
    --------
    >>> import shapely
    >>> resting([shapely.MultiLineString([each]) for each in ([(0, 0), (9, 0)], [(4, 0.1), (4, 9)])], 1.0)
    [[], [0]]
    """
    import shapely

    lines, owner = shapely.get_parts(np.asarray(walls, object), return_index=True)
    ends = np.concatenate([shapely.get_point(lines, 0), shapely.get_point(lines, -1)])
    end, line = shapely.STRtree(lines).query(ends, predicate="dwithin", distance=_TOUCHES * cell_size)
    own, other = np.tile(owner, 2)[end], owner[line]
    pairs = np.unique(np.column_stack([own, other])[other < own], axis=0)
    return [pairs[pairs[:, 0] == k, 1].tolist() for k in range(len(walls))]


def _led(line: np.ndarray, target: Any, reach: float) -> np.ndarray:
    """A line whose beginning is led to the nearest place of a target, or cut where it crosses it, within reach."""
    import shapely

    half = np.vstack([line[0], line[:2].mean(axis=0)])  # what is beyond belongs to the other end
    met = shapely.intersection(shapely.LineString(half), target)
    crosses = not met.is_empty
    place = shapely.get_coordinates(shapely.shortest_line(met if crosses else target, shapely.Point(line[0])))[0]
    if np.hypot(*(place - line[0])) > reach:
        return line
    return np.vstack([place, line[1:] if crosses else line])
