"""The order of work in which some must stand before other does, so that each step saves most for its cost.

Work is joined to groups, and the groups that wait below a wall are a heap that is melded with those of its siblings
(skew heaps: Sleator, Tarjan 1986, doi 10.1137/0215004), so that n walls take about n log n.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel


@inlined
def _before(ratio: np.ndarray, a: int, b: int) -> bool:
    """Whether group a is built before b: it saves more for its cost, or its first wall comes first."""
    return ratio[a] < ratio[b] or (ratio[a] == ratio[b] and a < b)


@kernel
def _meld(ratio: np.ndarray, left: np.ndarray, right: np.ndarray, a: int, b: int) -> int:
    """Join two heaps, -1 for empty ones; the first group of both."""
    if a < 0 or b < 0:
        return max(a, b)
    if _before(ratio, b, a):
        a, b = b, a
    root = a
    while True:
        rest = right[a]
        right[a] = left[a]
        if rest < 0:
            left[a] = b
            return root
        if _before(ratio, b, rest):
            rest, b = b, rest
        left[a] = rest
        a = rest


@kernel
def grouped(saved: np.ndarray, cost: np.ndarray, parent: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Join walls to groups that are built without a break; see `placement.dissection.sequence`.

    Parameters
    ----------
    saved, cost
        (n,) float64 of each wall.
    parent
        (n,) int64 wall that must stand before, with a lower number; -1 for none.

    Returns
    -------
    tuple
        (n,) float64 each group's cost of a unit saved, negative, by the number of its first wall; (n,) bool whether a
        wall is the first of a group; (n,) int64 the next wall of the same group, -1 for none.
    """
    n = saved.size
    ratio, gain, price = np.empty(n), saved.copy(), cost.copy()
    first = np.ones(n, np.bool_)
    following, last = np.full(n, -1), np.arange(n)
    left, right, below = np.full(n, -1), np.full(n, -1), np.full(n, -1)
    for i in range(n - 1, -1, -1):
        heap = below[i]
        while heap >= 0 and gain[heap] * price[i] > gain[i] * price[heap]:
            first[heap] = False
            following[last[i]] = heap
            gain[i] += gain[heap]
            price[i] += price[heap]
            last[i] = last[heap]
            heap = _meld(ratio, left, right, left[heap], right[heap])
        ratio[i] = -gain[i] / price[i] if price[i] > 0.0 else -np.inf
        heap = _meld(ratio, left, right, heap, i)
        if parent[i] >= 0:
            below[parent[i]] = _meld(ratio, left, right, below[parent[i]], heap)
    return ratio, first, following
