"""The minimum vertex cut of a patch of the grid between two ends, by maximum flow.

A cell is split into an entry and an exit joined by an arc of its cutting cost; arcs between linked cells are
unlimited. Node 2 v is the entry of cell v, 2 v + 1 its exit. The flow is found by Dinic's method (levels by
breadth-first search, then a blocking flow by depth-first search), which takes ends of any shape.

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

#: Marks of the cells of the two ends.
SOURCE, SINK = np.uint8(1), np.uint8(2)


@inlined
def opposite(d: int) -> int:
    """The direction back."""
    return (d + 4) & 7


@kernel
def levels(
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

    `level` of an unreached node is -1. `rim` holds the sink cells
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
        if end[v] == SOURCE:
            continue
        if node & 1:  # an exit is fed by its entry if there is room, and by entries that can send flow back
            if level[node - 1] < 0 and through[v] < capacity[v]:
                level[node - 1] = here
                queue[tail] = node - 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and flow[v, d] > 0 and level[2 * u] < 0 and end[u] != SINK:
                    level[2 * u] = here
                    queue[tail] = 2 * u
                    tail += 1
                    if end[u] == SOURCE:
                        found = here
        else:  # an entry is fed by its exit if flow can go back, and by the exits of all neighbours
            if level[node + 1] < 0 and through[v] > 0:
                level[node + 1] = here
                queue[tail] = node + 1
                tail += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and level[2 * u + 1] < 0 and end[u] != SINK:
                    level[2 * u + 1] = here
                    queue[tail] = 2 * u + 1
                    tail += 1
                    if end[u] == SOURCE:
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
        if end[origin >> 1] != SOURCE or level[origin] < 0:
            continue
        path[0] = origin
        length = 1
        while length > 0:
            node = path[length - 1]
            v = node >> 1
            if end[v] == SINK:
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
        room = flow[near[v, step - 1], opposite(step - 1)]
    return room


@inlined
def _push(near: np.ndarray, through: np.ndarray, flow: np.ndarray, node: int, step: int, amount: int) -> None:
    v = node >> 1
    if step == 0:
        through[v] += -amount if node & 1 else amount
    elif node & 1:
        flow[v, step - 1] += amount
    else:
        flow[near[v, step - 1], opposite(step - 1)] -= amount


@kernel
def reached_from(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    rim: np.ndarray,
    reached: np.ndarray,
    queue: np.ndarray,
) -> None:
    """Set `reached[node]` to 1 where the source, whose rim is given, can send more flow to, to 0 elsewhere."""
    tail = _begun(end, SOURCE, rim, reached, queue)
    head = 0
    while head < tail:
        node = queue[head]
        head += 1
        v = node >> 1
        own = through[v] > 0 if node & 1 else through[v] < capacity[v]
        if own and reached[node ^ 1] == 0:
            reached[node ^ 1] = 1
            queue[tail] = node ^ 1
            tail += 1
        if not node & 1 and through[v] == 0:  # nothing that could be sent back
            continue
        for d in range(8):
            u = near[v, d]
            if u < 0:
                continue
            other = 2 * u + 1 - (node & 1)
            if reached[other] == 0 and (node & 1 or flow[u, opposite(d)] > 0):
                reached[other] = 1
                queue[tail] = other
                tail += 1


@kernel
def reaching(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    rim: np.ndarray,
    reached: np.ndarray,
    queue: np.ndarray,
) -> None:
    """Set `reached[node]` to 1 where more flow can be sent on to the sink, whose rim is given, to 0 elsewhere."""
    tail = _begun(end, SINK, rim, reached, queue)
    head = 0
    while head < tail:
        node = queue[head]
        head += 1
        v = node >> 1
        own = through[v] < capacity[v] if node & 1 else through[v] > 0
        if own and reached[node ^ 1] == 0:
            reached[node ^ 1] = 1
            queue[tail] = node ^ 1
            tail += 1
        if node & 1 and through[v] == 0:
            continue
        for d in range(8):
            u = near[v, d]
            if u < 0:
                continue
            other = 2 * u + 1 - (node & 1)
            if reached[other] == 0 and (not node & 1 or flow[v, d] > 0):
                reached[other] = 1
                queue[tail] = other
                tail += 1


@inlined
def _begun(end: np.ndarray, which: int, rim: np.ndarray, reached: np.ndarray, queue: np.ndarray) -> int:
    """Mark the nodes of an end, and put those of its rim into the queue; their number."""
    for v in range(end.size):
        reached[2 * v] = reached[2 * v + 1] = end[v] == which
    for i in range(rim.size):
        queue[2 * i], queue[2 * i + 1] = 2 * rim[i], 2 * rim[i] + 1
    return 2 * rim.size


@inlined
def rim_of(near: np.ndarray, end: np.ndarray, which: int, rim: np.ndarray) -> int:
    """List the cells of an end that have a neighbour outside it; their number."""
    n_rim = 0
    for v in range(near.shape[0]):
        if end[v] == which:
            for d in range(8):
                if near[v, d] >= 0 and end[near[v, d]] != which:
                    rim[n_rim] = v
                    n_rim += 1
                    break
    return n_rim


@inlined
def judged(
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    reached: np.ndarray,
    side: int,
    loss: float,
    total_ignition: float,
    total_value: float,
) -> tuple[float, float]:
    """Score and cost of the cut next to the sink (side 0, from `reaching`) or to the source (1, `reached_from`)."""
    own_ignition, own_value, cut_ignition, cut_value, cost = 0.0, 0.0, 0.0, 0.0, 0.0
    for v in range(capacity.size):
        if reached[2 * v + side]:
            own_ignition += ignition[v]
            own_value += value[v]
        elif reached[2 * v + 1 - side]:
            cut_ignition += ignition[v]
            cut_value += value[v]
            cost += capacity[v]
    rest = (total_ignition - own_ignition - cut_ignition) * (total_value - own_value - cut_value)
    return (loss - own_ignition * own_value - rest) / loss / max(cost, 1.0), cost


@inlined
def mark_cut(reached: np.ndarray, side: int, cut: np.ndarray) -> None:
    """Set `cut` to 1 in the cells of the cut, and to 2 on its side."""
    for v in range(cut.size):
        cut[v] = 2 if reached[2 * v + side] else 1 if reached[2 * v + 1 - side] else 0


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
    ignition, value
        (n,) float64 >= 0: chance that a fire starts in the cell, value lost when it burns.
    end
        (n,) uint8: 1 and 2 in the cells of the ends, which are not adjacent.
    cut
        (n,) uint8, set to 1 in the cells of the cut, to 2 in those on one side of it.

    Returns
    -------
    tuple
        Score (share of ignition mass x value mass that is saved, over capacity) and capacity of the cut; score 0 if
        there is none.
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
    n_rim = rim_of(near, end, SINK, rim)
    while levels(near, capacity, through, flow, end, rim, n_rim, level, queue):
        sent += _blocking(near, capacity, through, flow, end, level, pointer, queue)
        if sent >= UNCUTTABLE:
            return best, best_cost
    reached = pointer
    for side in range(2):
        if side == 0:
            reaching(near, capacity, through, flow, end, rim[:n_rim], reached, queue)
        else:
            n_rim = rim_of(near, end, SOURCE, rim)
            reached_from(near, capacity, through, flow, end, rim[:n_rim], reached, queue)
        score, cost = judged(capacity, ignition, value, reached, side, loss, total_ignition, total_value)
        if score > best:
            best = score
            best_cost = cost
            mark_cut(reached, side, cut)
    return best, best_cost
