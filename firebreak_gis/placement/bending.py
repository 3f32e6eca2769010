"""Lines of a pattern moved to better ground: cheapest ways within a corridor, and patches pushed along the heading."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.placement.dissection import along
from firebreak_gis.placement.widening import around, wall_cost

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes

#: What a protected cell counts beside the dearest other: a way passes it only where there is no other.
_AROUND = 10.0
#: What a cell without fuel counts beside the mean one; not 0, so that ways stay short.
_FREE = 1e-3
#: What a step away from the straight line adds, so that of equal ways the straightest is taken.
_STRAIGHT = 1e-4


def is_even(stakes: Stakes) -> bool:
    """Whether all ground is alike, so that nothing is gained by moving a line."""
    return bool(np.ptp(stakes.difficulty[stakes.difficulty > 0.0]) == 0.0) if stakes.difficulty.any() else True


def prices(network: SpreadNetwork, stakes: Stakes, width: int) -> np.ndarray:
    """What a cell of a line counts, with its share of the wall of `width` cells around it, (rows, cols) above 0."""
    free = network.burnable & ~stakes.protected
    price = wall_cost(np.where(free, stakes.cost * stakes.difficulty, 0.0), width, network.boundary)
    mean = float(price[free].mean()) if free.any() else 1.0
    price = np.maximum(price, _FREE * max(mean, 1e-300))
    price[stakes.protected & network.burnable] = _AROUND * price.max()
    return np.asarray(price)


def bent(line: np.ndarray, network: SpreadNetwork, price: np.ndarray, *, width: int, reach: float) -> np.ndarray:
    """The cheapest line in the corridor around a straight one, from end to end.

    Parameters
    ----------
    line
        (n,) row-major cell numbers of a band.
    price
        (rows, cols) from `prices`.
    width
        Cells across the band.
    reach
        How far from the straight line the other may lie, cells.

    Returns
    -------
    numpy.ndarray
        (m,) row-major cell numbers along the new band; it stops spread over corners, as the old one did. The old one
        where it is too short to be moved.
    """
    from scipy import ndimage
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    if line.size < 2 * width or reach < 1.0:
        return line
    row, col = np.divmod(line, network.shape[1])
    margin = int(np.ceil(reach)) + 1
    top, left = max(row.min() - margin, 0), max(col.min() - margin, 0)
    bottom, right = min(row.max() + margin + 1, network.shape[0]), min(col.max() + margin + 1, network.shape[1])
    straight = np.ones((bottom - top, right - left), bool)
    straight[row - top, col - left] = False
    away = ndimage.distance_transform_edt(straight)
    corridor = away <= reach
    number = np.full(corridor.shape, -1, np.int32)  # scipy 1.12 takes no longer numbers
    number[corridor] = np.arange(np.count_nonzero(corridor), dtype=np.int32)
    weight = price[top:bottom, left:right] * (1.0 + _STRAIGHT * away)
    beside = [
        (number[:-1][both], number[1:][both])
        for number, both in ((n, (n[:-1] >= 0) & (n[1:] >= 0)) for n in (number, number.T))
    ]
    tail, head = (np.concatenate(ends) for ends in zip(*beside, strict=True))
    own = weight[corridor]
    cells = own.size
    graph = csr_array((0.5 * (own[tail] + own[head]), (tail, head)), shape=(cells, cells))
    rows, cols = np.nonzero(corridor)
    rows, cols = rows + top, cols + left
    ends = _ends(rows, cols, row, col, network.shape, reach)
    if not all(end.size for end in ends):
        return line
    cost, before, _ = dijkstra(graph, directed=False, indices=ends[0], min_only=True, return_predecessors=True)
    last = int(ends[1][np.argmin(cost[ends[1]])])
    if not np.isfinite(cost[last]):
        return line
    way = [last]
    while before[way[-1]] >= 0:
        way.append(int(before[way[-1]]))
    path = rows[way] * network.shape[1] + cols[way]
    return along(around(path, network.shape, width, network.boundary), network.shape) if width > 1 else path


def _ends(
    rows: np.ndarray, cols: np.ndarray, row: np.ndarray, col: np.ndarray, shape: tuple[int, int], reach: float
) -> tuple[np.ndarray, np.ndarray]:
    """Cells of the corridor in which the line may start and end: on the border of the map, near the ends of the old."""
    spread = np.cov(np.stack([row, col])) + 1e-9 * np.eye(2)
    direction = np.linalg.eigh(spread)[1][:, 1]
    place, old = direction[0] * rows + direction[1] * cols, direction[0] * row + direction[1] * col
    border = (rows == 0) | (cols == 0) | (rows == shape[0] - 1) | (cols == shape[1] - 1)
    first = np.flatnonzero(border & (place <= old.min() + reach))
    last = np.flatnonzero(border & (place >= old.max() - reach))
    return first, last


def pushed(
    patches: Sequence[np.ndarray], network: SpreadNetwork, stakes: Stakes, azimuth: float, reach: int
) -> list[np.ndarray]:
    """Patches moved as they are along a heading, at most `reach` cells, to where the ground is best in the mean.

    A patch is not moved onto ground that cannot be cut or off the map; of equal places the nearest is taken.
    """
    free = network.burnable & ~stakes.protected
    hard = np.where(free, stakes.difficulty, np.inf)
    east, north = np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth))
    steps = sorted(range(-reach, reach + 1), key=lambda step: (abs(step), step))
    moved = []
    for cells in patches:
        row, col = np.divmod(cells, network.shape[1])
        best, chosen = np.inf, cells
        for step in steps:
            r, c = row - round(step * north), col + round(step * east)
            if r.min() < 0 or c.min() < 0 or r.max() >= network.shape[0] or c.max() >= network.shape[1]:
                continue
            mean = float(hard[r, c].mean())
            if mean < best:
                best, chosen = mean, r * network.shape[1] + c
        moved.append(chosen)
    return moved
