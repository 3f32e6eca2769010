"""Minimum cuts of the links of a patch of the grid between two ends, by maximum flow with warm starts.

Cells are nodes, and a link between neighbours is an arc either way with the cost of a line across it. As in
`kernels.flow`, the flow is found by Dinic's method, and the ends grow step by step and keep the flow.

A straight line crosses the links to the eight neighbours in numbers that depend on its direction. If a link along an
axis costs sqrt 2 times as much as a diagonal one, the sum is the length of the line within 4 %, and the same along axes
and diagonals (Boykov, Kolmogorov 2003, doi 10.1109/ICCV.2003.1238310).

Common arguments:

near
    (n, 8) int32: number of the linked cell in each direction within the patch, -1 for none. Links go both ways.
room
    (n, 8) int32: flow that a link can still take from the cell in each direction.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel

#: Cost of a link that may not be cut.
UNCUTTABLE = 1 << 29
#: Largest sum of the costs of all other links, so that no flow overflows.
MOST = 1 << 28

_SOURCE = np.uint8(1)
_SINK = np.uint8(2)


@kernel
def link_costs(near: np.ndarray, price: np.ndarray, axis: float, diagonal: float) -> np.ndarray:
    """Cost of a line across each link: the mean price of both cells times `axis` or `diagonal`.

    Parameters
    ----------
    price
        (n,) float64 of each cell; below 0 where no line may be.

    Returns
    -------
    numpy.ndarray
        (n, 8) int32; 0 where there is no link.
    """
    n = near.shape[0]
    cost = np.zeros((n, 8), np.int32)
    for v in range(n):
        for d in range(8):
            u = near[v, d]
            if u >= 0:
                if price[v] < 0 or price[u] < 0:
                    cost[v, d] = UNCUTTABLE
                else:
                    each = axis if d % 2 == 0 else diagonal
                    cost[v, d] = np.int32(np.rint(0.5 * (price[v] + price[u]) * each))
    return cost


@kernel
def _levels(
    near: np.ndarray, room: np.ndarray, end: np.ndarray, level: np.ndarray, queue: np.ndarray, whole: bool
) -> bool:
    """Steps from every cell of the residual graph to the sink; whether the source has a way.

    Only cells no farther than the source are reached, if it has a way, unless `whole`.
    """
    level[:] = -1
    tail = 0
    for v in range(near.shape[0]):
        if end[v] == _SINK:
            level[v] = 0
            queue[tail] = v
            tail += 1
    head = 0
    found = -1
    while head < tail:
        v = queue[head]
        head += 1
        here = level[v] + 1
        if found >= 0 and here > found and not whole:
            break
        if end[v] == _SOURCE:
            continue
        for d in range(8):
            u = near[v, d]
            if u >= 0 and level[u] < 0 and room[u, (d + 4) & 7] > 0:
                level[u] = here
                queue[tail] = u
                tail += 1
                if end[u] == _SOURCE:
                    found = here
    return found >= 0


@kernel
def _blocking(
    near: np.ndarray, room: np.ndarray, end: np.ndarray, level: np.ndarray, pointer: np.ndarray, path: np.ndarray
) -> int:
    """Send a blocking flow along the levels; the amount sent, `UNCUTTABLE` or more if nothing can stop it."""
    pointer[:] = 0
    sent = np.int64(0)
    for origin in range(near.shape[0]):
        if end[origin] != _SOURCE or level[origin] < 0:
            continue
        path[0] = origin
        length = 1
        while length > 0:
            v = path[length - 1]
            if end[v] == _SINK:
                amount = np.int64(UNCUTTABLE)
                for i in range(length - 1):
                    amount = min(amount, np.int64(room[path[i], pointer[path[i]]]))
                if amount >= MOST:
                    return UNCUTTABLE
                keep = length
                for i in range(length - 1):
                    u, d = path[i], pointer[path[i]]
                    room[u, d] -= amount
                    room[near[u, d], (d + 4) & 7] += amount
                    if keep == length and room[u, d] == 0:
                        keep = i + 1
                sent += amount
                length = keep
                continue
            advanced = False
            while pointer[v] < 8:
                u = near[v, pointer[v]]
                if u >= 0 and level[u] == level[v] - 1 and room[v, pointer[v]] > 0:
                    path[length] = u
                    length += 1
                    advanced = True
                    break
                pointer[v] += 1
            if not advanced:
                length -= 1
                if length > 0:
                    pointer[path[length - 1]] += 1
    return sent


@kernel
def _reached(near: np.ndarray, room: np.ndarray, end: np.ndarray, level: np.ndarray, queue: np.ndarray) -> None:
    """Set `level[v]` to 0 where the source can send more flow to, to -1 elsewhere."""
    level[:] = -1
    tail = 0
    for v in range(near.shape[0]):
        if end[v] == _SOURCE:
            level[v] = 0
            queue[tail] = v
            tail += 1
    head = 0
    while head < tail:
        v = queue[head]
        head += 1
        for d in range(8):
            u = near[v, d]
            if u >= 0 and level[u] < 0 and room[v, d] > 0:
                level[u] = 0
                queue[tail] = u
                tail += 1


@kernel
def best_link_cut(
    near: np.ndarray,
    cost: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    orders: np.ndarray,
    shares: np.ndarray,
    side: np.ndarray,
) -> tuple[float, float]:
    """Find the cut of links that saves most for its cost.

    Parameters
    ----------
    cost
        (n, 8) int32 of each link, the same both ways; `UNCUTTABLE`: never cut.
    ignition, value
        (n,) float64 >= 0: chance that a fire starts in the cell, value lost when it burns.
    orders
        (n_orders, n) int64: the cells from one side of the patch to the other.
    shares
        (n_shares,) float64, rising, below .5: the ends hold this share of the patch.
    side
        (n,) uint8, set to 1 on one side of the best cut and to 2 on the other, all 1 if there is none.

    Returns
    -------
    tuple
        Score (share of ignition mass x value mass that is saved, over cost) and cost of the best cut; score 0 if the
        patch cannot be cut.
    """
    n = near.shape[0]
    total_ignition, total_value = ignition.sum(), value.sum()
    loss = total_ignition * total_value
    best = 0.0
    best_cost = 0.0
    side[:] = 1
    if loss <= 0.0:
        return best, best_cost
    room = np.empty((n, 8), np.int32)
    end = np.empty(n, np.uint8)
    level = np.empty(n, np.int32)
    queue = np.empty(n, np.int32)
    pointer = np.empty(n, np.uint8)
    for k in range(orders.shape[0]):
        order = orders[k]
        room[:] = cost
        end[:] = 0
        sent = np.int64(0)
        first, last = 0, n - 1
        ahead, behind = 0.0, 0.0
        for s in range(shares.shape[0]):
            while first < last and (ahead <= shares[s] or first == 0):
                end[order[first]] = _SOURCE
                ahead += 0.5 * (ignition[order[first]] / total_ignition + value[order[first]] / total_value)
                first += 1
            while first <= last and (behind <= shares[s] or last == n - 1):
                end[order[last]] = _SINK
                behind += 0.5 * (ignition[order[last]] / total_ignition + value[order[last]] / total_value)
                last -= 1
            while _levels(near, room, end, level, queue, False):
                sent += _blocking(near, room, end, level, pointer, queue)
                if sent >= MOST or (best > 0.0 and best * sent >= 0.5):
                    break
            if sent >= MOST or (best > 0.0 and best * sent >= 0.5):
                break
            for way in range(2):
                # The cut nearest to the sink, then that nearest to the source.
                if way == 1:
                    _reached(near, room, end, level, queue)
                own_ignition, own_value = 0.0, 0.0
                for v in range(n):
                    if level[v] >= 0:
                        own_ignition += ignition[v]
                        own_value += value[v]
                rest = (total_ignition - own_ignition) * (total_value - own_value)
                saved = (loss - own_ignition * own_value - rest) / loss
                score = saved / max(np.float64(sent), 1.0)
                if score > best:
                    best = score
                    best_cost = np.float64(sent)
                    for v in range(n):
                        side[v] = 1 + (level[v] >= 0)
    return best, best_cost
