"""Compartments that become one: as borders are taken away, the cheapest first, and as cells of breaks come back."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel


@inlined
def _found(root: np.ndarray, a: int) -> int:
    while root[a] != a:
        root[a] = root[root[a]]
        a = root[a]
    return a


@inlined
def _lost(
    one: int, other: int, own_ignition: float, own_value: float, ignition: np.ndarray, value: np.ndarray
) -> float:
    """Expected loss when two compartments and the fuel between them become one."""
    both = (ignition[one] + ignition[other] + own_ignition) * (value[one] + value[other] + own_value)
    return max(both - ignition[one] * value[one] - ignition[other] * value[other], 0.0)


@inlined
def _settle(tree: np.ndarray, ratio: np.ndarray, leaves: int, k: int) -> None:
    """Let the tree know a new ratio: each node holds the lowest of what is below it, of equal ones the first."""
    node = (leaves + k) >> 1
    while node > 0:
        a, b = tree[2 * node], tree[2 * node + 1]
        tree[node] = a if ratio[a] <= ratio[b] else b
        node >>= 1


@kernel
def taken_away(
    one: np.ndarray,
    other: np.ndarray,
    cost: np.ndarray,
    own_ignition: np.ndarray,
    own_value: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    least: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Take borders away until none is left.

    Parameters
    ----------
    one, other
        (n,) int64 compartments on both sides; no two borders have the same.
    cost, own_ignition, own_value
        (n,) of each border; changed.
    ignition, value
        (n_compartments,) masses; changed.
    least
        Costs below it count as that, above 0.

    Returns
    -------
    tuple
        Borders in the order in which they go, and the border that each became part of, (n,) int64: itself where it
        goes by itself. Those that a union leaves between the same two compartments become one, that of the first side.

    Notes
    -----
    Cost: n log n, and a look at all borders of two compartments when they become one.
    """
    n, n_sides = one.size, ignition.size
    leaves = 1
    while leaves < n:
        leaves *= 2
    ratio = np.full(leaves + 1, np.inf)
    tree = np.full(2 * leaves, leaves, np.int64)
    root = np.arange(n_sides)
    head = np.full(n_sides, -1, np.int64)
    following = np.full(2 * n, -1, np.int64)  # entry 2 k is border k at its side one, 2 k + 1 at its side other
    into = np.arange(n)
    place = np.full(n_sides, -1, np.int64)
    for k in range(n):
        for entry, side in ((2 * k, one[k]), (2 * k + 1, other[k])):
            following[entry] = head[side]
            head[side] = entry
        ratio[k] = _lost(one[k], other[k], own_ignition[k], own_value[k], ignition, value) / max(cost[k], least)
        tree[leaves + k] = k
    for node in range(leaves - 1, 0, -1):
        a, b = tree[2 * node], tree[2 * node + 1]
        tree[node] = a if ratio[a] <= ratio[b] else b
    gone_first = np.empty(n, np.int64)
    count = 0
    standing = np.ones(n, np.bool_)
    left = n
    while left > 0:
        k = tree[1]
        gone_first[count] = k
        count += 1
        left -= 1
        standing[k] = False
        ratio[k] = np.inf
        _settle(tree, ratio, leaves, k)
        keep, gone = _found(root, one[k]), _found(root, other[k])
        ignition[keep] += ignition[gone] + own_ignition[k]
        value[keep] += value[gone] + own_value[k]
        # What still stands at the side that stays, by what lies beyond.
        entry = head[keep]
        head[keep] = -1
        while entry >= 0:
            after = following[entry]
            border = entry >> 1
            if standing[border]:
                beyond = _found(root, one[border] if entry & 1 else other[border])
                place[beyond] = border
                following[entry] = head[keep]
                head[keep] = entry
            entry = after
        # The first list ends where it began: what is added now comes before it.
        last = head[keep]
        entry = head[gone]
        head[gone] = -1
        while entry >= 0:
            after = following[entry]
            border = entry >> 1
            if standing[border]:
                beyond = _found(root, one[border] if entry & 1 else other[border])
                same = place[beyond]
                if same >= 0:
                    cost[same] += cost[border]
                    own_ignition[same] += own_ignition[border]
                    own_value[same] += own_value[border]
                    into[border] = same
                    standing[border] = False
                    left -= 1
                    ratio[border] = np.inf
                    _settle(tree, ratio, leaves, border)
                else:
                    following[entry] = head[keep]
                    head[keep] = entry
            entry = after
        root[gone] = keep
        entry = last
        while entry >= 0:
            border = entry >> 1
            place[_found(root, one[border] if entry & 1 else other[border])] = -1
            entry = following[entry]
        entry = head[keep]
        while entry >= 0:
            border = entry >> 1
            a, b = _found(root, one[border]), _found(root, other[border])
            ratio[border] = _lost(a, b, own_ignition[border], own_value[border], ignition, value) / max(
                cost[border], least
            )
            _settle(tree, ratio, leaves, border)
            entry = following[entry]
    return gone_first[:count], into


@kernel
def come_back(
    one: np.ndarray, other: np.ndarray, turn: np.ndarray, ignition: np.ndarray, value: np.ndarray, lost: np.ndarray
) -> None:
    """Join nodes pair by pair, and add up what each turn loses.

    Parameters
    ----------
    one, other, turn
        (m,) nodes of each pair, and the turn at which it is joined, rising.
    ignition, value
        (n_nodes,) masses; changed.
    lost
        (n_turns,) added to.
    """
    root = np.arange(ignition.size)
    for k in range(one.size):
        a, b = _found(root, one[k]), _found(root, other[k])
        if a != b:
            a, b = min(a, b), max(a, b)
            lost[turn[k]] += ignition[a] * value[b] + ignition[b] * value[a]
            root[b] = a
            ignition[a] += ignition[b]
            value[a] += value[b]
