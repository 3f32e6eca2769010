"""Minimum vertex cuts of a patch of the grid between two ends, by maximum flow with warm starts.

A cell is split into an entry and an exit joined by an arc of its cutting cost; arcs between linked cells are
unlimited. The flow is found by Dinic's method (levels by breadth-first search, then a blocking flow by depth-first
search). The ends grow step by step and keep the flow, so that one pass yields minimum cuts of rising balance
(the idea of FlowCutter: Hamann, Strasser 2018, doi 10.1145/3173045; of the ends: Schild, Sommer 2015,
doi 10.1007/978-3-319-20086-6_22).

Common arguments:

near
    (n, 8) int32: number of the linked cell in each direction within the patch, -1 for none. Links go both ways.
capacity
    (n,) int32 >= 0: cost of cutting the cell; `UNCUTTABLE` or more: never cut.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

#: Capacity of a cell that may not be cut.
UNCUTTABLE = 1 << 30

_SOURCE = np.uint8(1)
_SINK = np.uint8(2)


@inlined
def _opposite(d: int) -> int:
    return (d + 4) & 7


@kernel
def _levels(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    rim: np.ndarray,
    n_rim: int,
    level: np.ndarray,
    queue: np.ndarray,
) -> bool:
    """Steps from every node of the residual graph to the sink, by breadth-first search; whether the source has a way.

    Node 2 v is the entry of cell v, 2 v + 1 its exit. `level` of an unreached node is -1. `rim` holds the sink cells
    that have a neighbour outside the sink. Only nodes no farther than the source are reached, if it has a way.
    """
    level[:] = -1
    for i in range(n_rim):
        level[2 * rim[i]] = 0
        level[2 * rim[i] + 1] = 0
        queue[2 * i] = 2 * rim[i]
        queue[2 * i + 1] = 2 * rim[i] + 1
    tail = 2 * n_rim
    head = 0
    found = -1
    while head < tail:
        node = queue[head]
        head += 1
        here = level[node] + 1
        if found >= 0 and here > found:
            break
        v = node >> 1
        if end[v] == _SOURCE:
            continue
        if node & 1:  # an exit is fed by its entry if there is room, and by entries that can send flow back
            if level[node - 1] < 0 and through[v] < capacity[v]:
                level[node - 1] = here
                queue[tail] = node - 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and flow[v, d] > 0 and level[2 * u] < 0 and end[u] != _SINK:
                    level[2 * u] = here
                    queue[tail] = 2 * u
                    tail += 1
                    if end[u] == _SOURCE:
                        found = here
        else:  # an entry is fed by its exit if flow can go back, and by the exits of all neighbours
            if level[node + 1] < 0 and through[v] > 0:
                level[node + 1] = here
                queue[tail] = node + 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and level[2 * u + 1] < 0 and end[u] != _SINK:
                    level[2 * u + 1] = here
                    queue[tail] = 2 * u + 1
                    tail += 1
                    if end[u] == _SOURCE:
                        found = here
    return found >= 0


@kernel
def _blocking(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    level: np.ndarray,
    pointer: np.ndarray,
    path: np.ndarray,
) -> int:
    """Send a blocking flow along the levels; the amount sent, `UNCUTTABLE` or more if nothing can stop it."""
    pointer[:] = 0
    sent = np.int64(0)
    for origin in range(2 * near.shape[0]):
        if end[origin >> 1] != _SOURCE or level[origin] < 0:
            continue
        path[0] = origin
        length = 1
        while length > 0:
            node = path[length - 1]
            v = node >> 1
            if end[v] == _SINK:
                amount = np.int64(UNCUTTABLE)
                for i in range(length - 1):
                    amount = min(amount, _room(near, capacity, through, flow, path[i], pointer[path[i]]))
                if amount >= UNCUTTABLE:
                    return UNCUTTABLE
                keep = length
                for i in range(length - 1):
                    _push(near, through, flow, path[i], pointer[path[i]], amount)
                    if keep == length and _room(near, capacity, through, flow, path[i], pointer[path[i]]) == 0:
                        keep = i + 1
                sent += amount
                length = keep
                continue
            advanced = False
            while pointer[node] < 9:
                step = pointer[node]
                target = _target(near, node, step)
                if (
                    target >= 0
                    and level[target] == level[node] - 1
                    and _room(near, capacity, through, flow, node, step) > 0
                ):
                    path[length] = target
                    length += 1
                    advanced = True
                    break
                pointer[node] += 1
            if not advanced:
                length -= 1
                if length > 0:
                    pointer[path[length - 1]] += 1
    return sent


@inlined
def _target(near: np.ndarray, node: int, step: int) -> int:
    """Node at the end of arc `step` (0 within the cell, 1 .. 8 to the neighbours) of `node`; -1 for none."""
    if step == 0:
        return node ^ 1
    u = near[node >> 1, step - 1]
    return -1 if u < 0 else 2 * u + 1 - (node & 1)


@inlined
def _room(near: np.ndarray, capacity: np.ndarray, through: np.ndarray, flow: np.ndarray, node: int, step: int) -> int:
    """Flow that the arc can still take."""
    v = node >> 1
    room = np.int64(UNCUTTABLE)
    if step == 0:
        room = through[v] if node & 1 else min(capacity[v] - through[v], np.int64(UNCUTTABLE))
    elif not node & 1:
        room = flow[near[v, step - 1], _opposite(step - 1)]
    return room


@inlined
def _push(near: np.ndarray, through: np.ndarray, flow: np.ndarray, node: int, step: int, amount: int) -> None:
    v = node >> 1
    if step == 0:
        through[v] += -amount if node & 1 else amount
    elif node & 1:
        flow[v, step - 1] += amount
    else:
        flow[near[v, step - 1], _opposite(step - 1)] -= amount


@kernel
def _reached(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    reached: np.ndarray,
    queue: np.ndarray,
) -> None:
    """Set `reached[node]` to 0 where the source can send more flow to, to -1 elsewhere."""
    reached[:] = -1
    tail = 0
    for v in range(near.shape[0]):
        if end[v] == _SOURCE:
            reached[2 * v] = 0
            reached[2 * v + 1] = 0
            queue[tail] = 2 * v
            queue[tail + 1] = 2 * v + 1
            tail += 2
    head = 0
    while head < tail:
        node = queue[head]
        head += 1
        v = node >> 1
        if node & 1:
            if reached[node - 1] < 0 and through[v] > 0:
                reached[node - 1] = 0
                queue[tail] = node - 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and reached[2 * u] < 0:
                    reached[2 * u] = 0
                    queue[tail] = 2 * u
                    tail += 1
        else:
            if reached[node + 1] < 0 and through[v] < capacity[v]:
                reached[node + 1] = 0
                queue[tail] = node + 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and reached[2 * u + 1] < 0 and flow[u, _opposite(d)] > 0:
                    reached[2 * u + 1] = 0
                    queue[tail] = 2 * u + 1
                    tail += 1


@inlined
def _rim(near: np.ndarray, end: np.ndarray, rim: np.ndarray) -> int:
    """List the sink cells with a neighbour outside the sink; their number."""
    n_rim = 0
    for v in range(near.shape[0]):
        if end[v] == _SINK:
            for d in range(8):
                if near[v, d] >= 0 and end[near[v, d]] != _SINK:
                    rim[n_rim] = v
                    n_rim += 1
                    break
    return n_rim


@inlined
def _judge(
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    end: np.ndarray,
    level: np.ndarray,
    side: int,
    loss: float,
    total_ignition: float,
    total_value: float,
) -> tuple[float, float]:
    """Score and cost of the cut next to the sink (side 0) or to the source (1), whose nodes have a level."""
    own_ignition, own_value, cut_ignition, cut_value, cost = 0.0, 0.0, 0.0, 0.0, 0.0
    for v in range(capacity.size):
        if side == 0:  # the sink has reached some exits
            inside, outside = level[2 * v] >= 0 or end[v] == _SINK, level[2 * v + 1] < 0
        else:  # the source has reached some entries
            inside, outside = level[2 * v + 1] >= 0, level[2 * v] < 0
        if inside:
            own_ignition += ignition[v]
            own_value += value[v]
        elif not outside:
            cut_ignition += ignition[v]
            cut_value += value[v]
            cost += capacity[v]
    rest = (total_ignition - own_ignition - cut_ignition) * (total_value - own_value - cut_value)
    return (loss - own_ignition * own_value - rest) / loss / max(cost, 1.0), cost


@inlined
def _mark(end: np.ndarray, level: np.ndarray, side: int, cut: np.ndarray) -> None:
    """Set `cut` to 1 in the cells of the cut, and to 2 on its side."""
    for v in range(cut.size):
        if side == 0:
            inside, outside = level[2 * v] >= 0 or end[v] == _SINK, level[2 * v + 1] < 0
        else:
            inside, outside = level[2 * v + 1] >= 0, level[2 * v] < 0
        cut[v] = 2 if inside else 0 if outside else 1


@kernel
def best_cut(
    near: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    orders: np.ndarray,
    shares: np.ndarray,
    cut: np.ndarray,
) -> tuple[float, float]:
    """Find the vertex cut of a patch that saves most for its cost.

    Parameters
    ----------
    ignition, value
        (n,) float64 >= 0: chance that a fire starts in the cell, value lost when it burns.
    orders
        (n_orders, n) int64: the cells from one side of the patch to the other.
    shares
        (n_shares,) float64, rising, below .5: the ends hold this share of the patch.
    cut
        (n,) uint8, set to 1 in the cells of the best cut, to 2 in those on one side of it.

    Returns
    -------
    tuple
        Score (share of ignition mass x value mass that is saved, over capacity) and capacity of the best cut; score
        0 if the patch cannot be cut.
    """
    n = near.shape[0]
    total_ignition, total_value = ignition.sum(), value.sum()
    loss = total_ignition * total_value
    best = 0.0
    best_cost = 0.0
    cut[:] = 0
    if loss <= 0.0:
        return best, best_cost
    through = np.empty(n, np.int32)
    flow = np.empty((n, 8), np.int32)
    end = np.empty(n, np.uint8)
    rim = np.empty(n, np.int32)
    level = np.empty(2 * n, np.int32)
    queue = np.empty(2 * n, np.int32)
    pointer = np.empty(2 * n, np.uint8)
    for k in range(orders.shape[0]):
        order = orders[k]
        through[:] = 0
        flow[:] = 0
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
            n_rim = _rim(near, end, rim)
            while _levels(near, capacity, through, flow, end, rim, n_rim, level, queue):
                sent += _blocking(near, capacity, through, flow, end, level, pointer, queue)
                if sent >= UNCUTTABLE or (best > 0.0 and best * sent >= 0.5):
                    break
            if sent >= UNCUTTABLE or (best > 0.0 and best * sent >= 0.5):
                break
            for side in range(2):
                if side == 1:
                    _reached(near, capacity, through, flow, end, level, queue)
                score, cost = _judge(capacity, ignition, value, end, level, side, loss, total_ignition, total_value)
                if score > best:
                    best = score
                    best_cost = cost
                    _mark(end, level, side, cut)
    return best, best_cost


@kernel
def cut_between(
    near: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    end: np.ndarray,
    cut: np.ndarray,
) -> tuple[float, float]:
    """Find the cheapest vertex cut between ends that are given; of those next to either end that which saves more.

    Parameters
    ----------
    end
        (n,) uint8: 1 and 2 in the cells of the ends, which are not adjacent.
    ignition, value, cut
        As in `best_cut`, as is what is returned.
    """
    n = near.shape[0]
    total_ignition, total_value = ignition.sum(), value.sum()
    loss = total_ignition * total_value
    best = 0.0
    best_cost = 0.0
    cut[:] = 0
    if loss <= 0.0:
        return best, best_cost
    through = np.zeros(n, np.int32)
    flow = np.zeros((n, 8), np.int32)
    rim = np.empty(n, np.int32)
    level = np.empty(2 * n, np.int32)
    queue = np.empty(2 * n, np.int32)
    pointer = np.empty(2 * n, np.uint8)
    sent = np.int64(0)
    n_rim = _rim(near, end, rim)
    while _levels(near, capacity, through, flow, end, rim, n_rim, level, queue):
        sent += _blocking(near, capacity, through, flow, end, level, pointer, queue)
        if sent >= UNCUTTABLE:
            return best, best_cost
    for side in range(2):
        if side == 1:
            _reached(near, capacity, through, flow, end, level, queue)
        score, cost = _judge(capacity, ignition, value, end, level, side, loss, total_ignition, total_value)
        if score > best:
            best = score
            best_cost = cost
            _mark(end, level, side, cut)
    return best, best_cost
