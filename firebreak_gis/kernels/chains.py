"""The chain of cells that splits a patch best, where fire passes between all neighbours in it.

Fire steps over corners too, so what stops it between two ends of a patch is a chain of cells that share a side, from
one border of the patch to the other; what is no cell of the patch costs nothing. So the minimum cut is a shortest path.
A chain between the shares m and 1 - m of a patch saves about 2 m (1 - m) of its loss. So a cell that lies at m counts
1 / (4 m (1 - m)) of its cost: one search in each direction weighs the cost and what is saved.

Common arguments:

row, col
    (n,) int32: where the cells of the patch lie.
capacity
    (n,) int32 >= 0: cost of cutting the cell; `flow.UNCUTTABLE` or more: never cut.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.flow import UNCUTTABLE
from firebreak_gis.kernels.policy import inlined, kernel
from firebreak_gis.lattice import COL_STEP, ROW_STEP

#: Steps of the cost of a cell in the middle of a patch.
_STEPS = 256
#: Cells are sorted along a direction to such parts of a cell.
_PARTS = 2
#: A chain that counts so many times the least so far is still judged by what it saves.
_SLACK = 1.1
#: Rectangles of more places, or of more for each cell of the patch, are not searched.
_BITS, _THINNEST = 24, 32
_LARGEST = 1 << _BITS
_FAR = np.int64(1) << 62
_ZERO, _ONE = np.uint64(0), np.uint64(1)


@kernel
def can_chain(row: np.ndarray, col: np.ndarray, links: np.ndarray) -> bool:
    """Whether all neighbours in a patch are linked, and it is no thin line across a map.

    `links` is (n,) uint8: bit d set where the cell is linked to its neighbour in direction d.
    """
    top, left = row.min() - 1, col.min() - 1
    high, wide = row.max() - top + 2, col.max() - left + 2
    if high * wide > min(_THINNEST * row.size, _LARGEST):
        return False
    inside = np.zeros((high, wide), np.bool_)
    for v in range(row.size):
        inside[row[v] - top, col[v] - left] = True
    for v in range(row.size):
        r, c = row[v] - top, col[v] - left
        for d in range(8):
            if inside[r + ROW_STEP[d], c + COL_STEP[d]] and (links[v] >> d) & 1 == 0:
                return False
    return True


@kernel
def best_chain(
    row: np.ndarray,
    col: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    toward: np.ndarray,
    share: float,
    cut: np.ndarray,
) -> tuple[float, int]:
    """Find the chain across a patch that saves most for its cost, of one in each direction.

    Parameters
    ----------
    ignition, value
        (n,) float64 >= 0: chance that a fire starts in the cell, value lost when it burns.
    toward
        (n_directions, 2) float64: rows and columns of a step from one end of the patch to the other.
    share
        The ends, which no chain enters, hold this share of the patch (mean of ignition and value).
    cut
        (n,) uint8, set to 1 in the cells of the best chain, to 2 in those on one side of it.

    Returns
    -------
    tuple
        Score (share of ignition mass x value mass that is saved, over capacity) and direction of the best chain; score
        0 if the patch cannot be cut.
    """
    n = row.size
    total_ignition, total_value = ignition.sum(), value.sum()
    loss = total_ignition * total_value
    best, direction = 0.0, -1
    cut[:] = 0
    if loss <= 0.0:
        return best, direction
    top, left = row.min() - 1, col.min() - 1
    high, wide = row.max() - top + 2, col.max() - left + 2
    of = np.full(high * wide, -1, np.int32)
    for v in range(n):
        of[_at(row[v], col[v], top, left, wide)] = v
    margin = _margin(high, wide)
    place = np.empty(of.size, np.int32)
    price, way = np.empty(of.size, np.int64), np.empty(of.size, np.int64)
    came = np.empty(of.size, np.int8)
    side = np.empty(n, np.uint8)
    queue = np.empty(of.size, np.int32)
    least = _FAR
    for k in range(toward.shape[0]):
        _places(toward[k], high, wide, place)
        last = place.max()
        before = np.zeros(last + 2, np.float64)
        first, last = last, 0
        for v in range(n):
            there = place[_at(row[v], col[v], top, left, wide)]
            first, last = min(first, there), max(last, there)
            before[there + 1] += 0.5 * (ignition[v] / total_ignition + value[v] / total_value)
        before = np.cumsum(before)
        while before[first + 2] <= share:
            first += 1
        while before[last - 1] >= 1.0 - share:
            last -= 1
        for b in range(of.size):
            v = of[b]
            if not first < place[b] < last or (v >= 0 and capacity[v] >= UNCUTTABLE):
                price[b] = -1
            elif v < 0:
                price[b] = 0
            else:
                middle = 0.5 * (before[place[b]] + before[place[b] + 1])
                price[b] = np.int64(np.rint(_STEPS * capacity[v] / (4.0 * middle * (1.0 - middle))))
        most = least if least == _FAR else np.int64(least * _SLACK)
        end = _search(price, margin, wide, most, way, came, queue)
        if end < 0:
            continue
        least = min(least, way[end])
        score = _judged(
            end,
            came,
            wide,
            top,
            left,
            row,
            col,
            of,
            place,
            first,
            capacity,
            ignition,
            value,
            total_ignition,
            total_value,
            side,
            queue,
        )
        if score > best:
            best, direction = score, k
            cut[:] = side
    return best, direction


@inlined
def _at(row: int, col: int, top: int, left: int, wide: int) -> int:
    """Place of a cell in the rectangle."""
    return (row - top) * wide + col - left


@inlined
def _margin(high: int, wide: int) -> np.ndarray:
    """Places of the margin of a rectangle, round it."""
    margin = np.empty(2 * (high + wide) - 4, np.int64)
    for c in range(wide):
        margin[c] = c
        margin[high + wide - 2 + c] = high * wide - 1 - c
    for r in range(1, high - 1):
        margin[wide - 1 + r] = r * wide + wide - 1
        margin[high + 2 * wide - 3 + r] = (high - 1 - r) * wide
    return margin


@inlined
def _places(toward: np.ndarray, high: int, wide: int, place: np.ndarray) -> None:
    """How far along a direction each place of a rectangle lies, in parts of a cell from 0."""
    lowest = min(0.0, toward[0] * (high - 1)) + min(0.0, toward[1] * (wide - 1))
    for r in range(high):
        for c in range(wide):
            # Rounded, so that cells in line are so whatever the arithmetic.
            place[r * wide + c] = np.int32(np.floor(_PARTS * (toward[0] * r + toward[1] * c - lowest) + 1e-6))


@inlined
def _rise(heap: np.ndarray, k: np.uint64, entry: int) -> None:
    """Let an entry of a heap, the least of which comes first, rise from place k."""
    while k > _ZERO:
        above = heap[(k - _ONE) >> _ONE]
        if above <= entry:
            break
        heap[k] = above
        k = (k - _ONE) >> _ONE
    heap[k] = entry


@inlined
def _sink(heap: np.ndarray, size: np.uint64, entry: int) -> None:
    """Put an entry in place of the first of a heap that then has `size`: at the bottom, whence it rises."""
    k, below = _ZERO, _ONE
    while below + _ONE < size:
        one, other = heap[below], heap[below + _ONE]
        heap[k] = min(one, other)
        k = below + np.uint64(other < one)
        below = k + k + _ONE
    if below < size:
        heap[k] = heap[below]
        k = below
    _rise(heap, k, entry)


@kernel
def _search(
    price: np.ndarray, margin: np.ndarray, wide: int, most: int, way: np.ndarray, came: np.ndarray, free: np.ndarray
) -> int:
    """Find the cheapest way through a band (`price` >= 0) from its one end on the margin to its other; its last place.

    Sets `way` to what leads to a place costs and `came` to the last step there, -1 at the start; -1 if there is no way
    of at most `most`. By Dijkstra's method, with a heap in an array, as lists of numba count their holders at each
    step; what costs nothing is done at once, without the queue, by way of `free`.
    """
    runs, start = 0, 0
    for i in range(margin.size):
        if price[margin[i]] >= 0 and price[margin[i - 1]] < 0:
            runs += 1
            start = i
    if runs != 2:  # the band is narrower than a cell
        return -1
    way[:] = _FAR
    n_free = 0
    while price[margin[start]] >= 0:
        b = margin[start]
        way[b], came[b] = 0, -1
        free[n_free] = b
        n_free += 1
        start = (start + 1) % margin.size
    goal = np.zeros(price.size, np.bool_)
    for b in margin:
        goal[b] = price[b] >= 0 and way[b] > 0
    heap, waiting = np.empty(16, np.int64), _ZERO
    while n_free > 0 or waiting > _ZERO:
        if n_free > 0:
            n_free -= 1
            b = free[n_free]
        else:
            entry = heap[0]
            waiting -= _ONE
            _sink(heap, waiting, heap[waiting])
            b = entry & (_LARGEST - 1)
            if way[b] < entry >> _BITS:
                continue
        if goal[b]:
            return b
        if waiting + np.uint64(4) > np.uint64(heap.size):
            heap = np.concatenate((heap, np.empty_like(heap)))
        row, col = b // wide, b % wide
        for d in range(4):
            u = -1
            if d == 0 and col < wide - 1:
                u = b + 1
            elif d == 1 and b + wide < price.size:
                u = b + wide
            elif d == 2 and col > 0:
                u = b - 1
            elif d == 3 and row > 0:
                u = b - wide
            if u < 0 or price[u] < 0:
                continue
            there = way[b] + price[u]
            if there < way[u] and there <= most:
                way[u], came[u] = there, d
                if price[u] == 0:
                    free[n_free] = u
                    n_free += 1
                else:
                    _rise(heap, waiting, (there << _BITS) | u)
                    waiting += _ONE
    return -1


@kernel
def _judged(
    end: int,
    came: np.ndarray,
    wide: int,
    top: int,
    left: int,
    row: np.ndarray,
    col: np.ndarray,
    of: np.ndarray,
    place: np.ndarray,
    first: int,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    total_ignition: float,
    total_value: float,
    side: np.ndarray,
    queue: np.ndarray,
) -> float:
    """Score of the chain that ends at a place; `side` is set to 1 in it, to 2 in what is linked to the first end."""
    side[:] = 0
    cost, cut_ignition, cut_value = 0.0, 0.0, 0.0
    b = end
    while True:
        v = of[b]
        if v >= 0:
            side[v] = 1
            cost += capacity[v]
            cut_ignition += ignition[v]
            cut_value += value[v]
        d = came[b]
        if d < 0:
            break
        b -= 1 if d == 0 else wide if d == 1 else -1 if d == 2 else -wide
    head, tail = 0, 0
    for v in range(row.size):
        if place[_at(row[v], col[v], top, left, wide)] <= first:
            side[v] = 2
            queue[tail] = v
            tail += 1
    own_ignition, own_value = 0.0, 0.0
    while head < tail:
        v = queue[head]
        head += 1
        own_ignition += ignition[v]
        own_value += value[v]
        b = _at(row[v], col[v], top, left, wide)
        for i in range(-1, 2):
            for j in range(-1, 2):
                u = of[b + i * wide + j]
                if u >= 0 and side[u] == 0:
                    side[u] = 2
                    queue[tail] = u
                    tail += 1
    loss = total_ignition * total_value
    rest = (total_ignition - own_ignition - cut_ignition) * (total_value - own_value - cut_value)
    return (loss - own_ignition * own_value - rest) / loss / max(cost, 1.0)
