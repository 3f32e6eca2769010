"""The wall that splits a patch best: minimum vertex cuts between opposite ends that grow, in several directions.

For patches in which some neighbours are not linked, or that go round a torus; all others: `chains`. The graph is that
of `flow`. Flow is sent along paths that are found depth first, those neighbours first that lead straight ahead, so that
on a map nearly every path is straight and short; what was searched in vain is not searched again before more could have
become possible. Where costs are large numbers only the shortest paths are sought. The ends grow step by step and keep
the flow, so that one pass yields minimum cuts of rising balance (the idea of FlowCutter: Hamann, Strasser 2018, doi
10.1145/3173045; of the ends: Schild, Sommer 2015, doi 10.1007/978-3-319-20086-6_22).
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.flow import (
    SINK,
    SOURCE,
    UNCUTTABLE,
    judged,
    levels,
    mark_cut,
    opposite,
    reached_from,
    reaching,
)
from firebreak_gis.kernels.policy import inlined, kernel

#: Bit of a node that is on the path or was left in vain; the bits below count the arcs that were tried.
_SEEN = np.uint8(16)
_TRIED = np.uint8(15)
#: Where a cell costs more of the whole numbers, flow is sent along shortest paths, see `_send`.
_ALIKE = 64


@inlined
def _at(place: int) -> int:
    """An index that is not negative, which spares the look whether it counts from the end."""
    return np.uint64(place)


@kernel
def _send(
    near: np.ndarray,
    capacity: np.ndarray,
    through: np.ndarray,
    flow: np.ndarray,
    end: np.ndarray,
    heads: np.ndarray,
    rim: np.ndarray,
    level: np.ndarray,
    most: int,
    state: np.ndarray,
    path: np.ndarray,
) -> int:
    """Send flow along paths found depth first; the amount, `UNCUTTABLE` or more if nothing can stop it.

    Arcs 0 to 7 of an exit lead to the entries of neighbours, the foremost first, arc 8 back to its own entry. Arc 0 of
    an entry leads to its own exit, arcs 1 to 8 send flow back to the exits of neighbours.

    A node that was left in vain is not tried again, so more may be found by another call. If none is found `state` is
    set where the rim can send more flow to, and 0 elsewhere. No more is sought once `most` is sent.

    With `level`, as `flow.levels` sets it, only the shortest paths are sought (Dinic's method): where costs are many
    steps, flow is sent in many parts, and paths longer than need be are in the way of others.
    """
    state[:] = 0
    sent = np.int64(0)
    by_level = level.size > 0
    for s in range(2 * rim.size):
        origin = 2 * np.int64(rim[_at(s >> 1)]) + 1 - (s & 1)
        if state[_at(origin)] >= _SEEN or (s & 1 and through[_at(origin >> 1)] == 0):
            continue
        state[_at(origin)] = _SEEN
        path[0] = origin
        length = 1
        while length > 0:
            node = np.int64(path[_at(length - 1)])
            v = node >> 1
            step = np.int64(state[_at(node)] & _TRIED)
            target = np.int64(-1)
            # The next arc that has room and leads to a node not yet seen; a call would cost more than all of this.
            if node & 1:
                while step < 8:
                    u = np.int64(near[_at(v), _at(heads[_at(step)])])
                    if (
                        u >= 0
                        and state[_at(2 * u)] < _SEEN
                        and end[_at(u)] != SOURCE
                        and (not by_level or level[_at(2 * u)] == level[_at(node)] - 1)
                    ):
                        target = 2 * u
                        break
                    step += 1
                back = step == 8 and end[_at(v)] != SOURCE and through[_at(v)] > 0 and state[_at(node - 1)] < _SEEN
                if back and (not by_level or level[_at(node - 1)] == level[_at(node)] - 1):
                    target = node - 1
            else:
                if step == 0:
                    if (
                        end[_at(v)] != SOURCE
                        and through[_at(v)] < capacity[_at(v)]
                        and state[_at(node + 1)] < _SEEN
                        and (not by_level or level[_at(node + 1)] == level[_at(node)] - 1)
                    ):
                        target = node + 1
                    else:
                        step = 1
                if target < 0 and through[_at(v)] > 0:
                    while step < 9:
                        d = heads[_at(step - 1)]
                        u = np.int64(near[_at(v), _at(d)])
                        if (
                            u >= 0
                            and flow[_at(u), _at(opposite(d))] > 0
                            and state[_at(2 * u + 1)] < _SEEN
                            and end[_at(u)] != SOURCE
                            and (not by_level or level[_at(2 * u + 1)] == level[_at(node)] - 1)
                        ):
                            target = 2 * u + 1
                            break
                        step += 1
            state[_at(node)] = _SEEN | np.uint8(step)
            if target < 0:
                length -= 1
                if length > 0:
                    state[_at(path[_at(length - 1)])] += np.uint8(1)
                continue
            v = target >> 1
            if end[_at(v)] != SINK:
                state[_at(target)] |= _SEEN
                path[_at(length)] = target
                length += 1
                only = node & 1 and not target & 1 and through[_at(v)] == 0 and capacity[_at(v)] > 0
                if (
                    only
                    and state[_at(target + 1)] < _SEEN
                    and (not by_level or level[_at(target + 1)] == level[_at(target)] - 1)
                ):  # no other way on: at once to the exit
                    state[_at(target)] = _SEEN
                    state[_at(target + 1)] |= _SEEN
                    path[_at(length)] = target + 1
                    length += 1
                continue
            amount = np.int64(UNCUTTABLE)
            for i in range(length):
                node = np.int64(path[_at(i)])
                v, step = node >> 1, np.int64(state[_at(node)] & _TRIED)
                if node & 1:
                    if step == 8:
                        amount = min(amount, np.int64(through[_at(v)]))
                elif step == 0:
                    amount = min(amount, np.int64(capacity[_at(v)]) - through[_at(v)])
                else:
                    d = heads[_at(step - 1)]
                    amount = min(amount, np.int64(flow[_at(near[_at(v), _at(d)]), _at(opposite(d))]))
            if amount >= UNCUTTABLE:
                return amount
            keep = length
            for i in range(length):
                node = np.int64(path[_at(i)])
                v, step = node >> 1, np.int64(state[_at(node)] & _TRIED)
                if i >= keep:
                    state[_at(node)] &= _TRIED
                full = False
                if node & 1:
                    if step == 8:
                        through[_at(v)] -= amount
                        full = through[_at(v)] == 0
                    else:
                        flow[_at(v), _at(heads[_at(step)])] += amount
                elif step == 0:
                    through[_at(v)] += amount
                    full = through[_at(v)] == capacity[_at(v)]
                else:
                    d = heads[_at(step - 1)]
                    u = np.int64(near[_at(v), _at(d)])
                    flow[_at(u), _at(opposite(d))] -= amount
                    full = flow[_at(u), _at(opposite(d))] == 0
                if full and keep == length:
                    keep = i + 1
            length = keep
            sent += amount
            if sent >= most:
                return sent
    return sent


@kernel
def _grown_rim(near: np.ndarray, end: np.ndarray, which: int, rim: np.ndarray, n_rim: int, added: np.ndarray) -> int:
    """Bring the rim of an end up to date, its cells that have a neighbour outside it; their number.

    Cells that an end has gained join the rim, and some of the old ones are inside it now.
    """
    kept = 0
    for i in range(n_rim + added.size):
        v = rim[i] if i < n_rim else added[i - n_rim]
        for d in range(8):
            u = near[v, d]
            if u >= 0 and end[u] != which:
                rim[kept] = v
                kept += 1
                break
    return kept


@kernel
def best_cut(
    near: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    orders: np.ndarray,
    heads: np.ndarray,
    shares: np.ndarray,
    cut: np.ndarray,
) -> tuple[float, float]:
    """Find the vertex cut of a patch that saves most for its cost.

    Parameters
    ----------
    near, capacity
        As in `flow`.
    ignition, value
        (n,) float64 >= 0: chance that a fire starts in the cell, value lost when it burns.
    orders
        (n_orders, n) int: the cells from one side of the patch to the other.
    heads
        (n_orders, 8) int: directions, those first that lead straight to the other side; they change the speed only.
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
    mass = 0.5 * (ignition / total_ignition + value / total_value)
    through = np.empty(n, np.int32)
    flow = np.empty((n, 8), np.int32)
    end = np.empty(n, np.uint8)
    rim = np.empty(n, np.int32)
    state, reached = np.empty(2 * n, np.uint8), np.empty(2 * n, np.uint8)
    queue = np.empty(2 * n, np.int32)
    sinks = np.empty(n, np.int32)
    dearest = 0
    for v in range(n):
        if capacity[v] < UNCUTTABLE:
            dearest = max(dearest, capacity[v])
    by_level = dearest > _ALIKE
    level = np.empty(2 * n if by_level else 0, np.int32)
    for k in range(orders.shape[0]):
        order = orders[k]
        through[:] = 0
        flow[:] = 0
        end[:] = 0
        sent = np.int64(0)
        first, last = 0, n - 1
        ahead, behind = 0.0, 0.0
        n_rim, n_sinks = 0, 0
        for s in range(shares.shape[0]):
            from_first, from_last = first, last
            while first < last and (ahead <= shares[s] or first == 0):
                end[order[first]] = SOURCE
                ahead += mass[order[first]]
                first += 1
            while first <= last and (behind <= shares[s] or last == n - 1):
                end[order[last]] = SINK
                behind += mass[order[last]]
                last -= 1
            n_rim = _grown_rim(near, end, SOURCE, rim, n_rim, order[from_first:first])
            n_sinks = _grown_rim(near, end, SINK, sinks, n_sinks, order[last + 1 : from_last + 1])
            more = np.int64(1)
            while more > 0 and sent < UNCUTTABLE and best * sent < 0.5:
                most = np.int64(0.5 / best) - sent if best > 0.0 else np.int64(UNCUTTABLE)
                if by_level and not levels(near, capacity, through, flow, end, sinks, n_sinks, level, queue):
                    reached_from(near, capacity, through, flow, end, rim[:n_rim], state, queue)
                    break
                more = _send(near, capacity, through, flow, end, heads[k], rim[:n_rim], level, most, state, queue)
                sent += more
            if sent >= UNCUTTABLE or best * sent >= 0.5:
                break
            for i in range(first):
                state[2 * order[i]] = state[2 * order[i] + 1] = 1
            reaching(near, capacity, through, flow, end, sinks[:n_sinks], reached, queue)
            for side in range(2):
                if side == 1:
                    reached[:] = state
                score, cost = judged(capacity, ignition, value, reached, side, loss, total_ignition, total_value)
                if score > best:
                    best = score
                    best_cost = cost
                    mark_cut(reached, side, cut)
    return best, best_cost
