"""Fires with a clock: when fire reaches each cell, run by run, by first passage over the edges that are open.

The edges of a run are those of the fires without a clock (`kernels.percolation`): same draws, same thresholds. Arrival
times are whole seconds, so no two roundings can differ. Cells wait in buckets of 2^shift seconds, no wider than the
least time of any step. Whatever leaves a bucket therefore comes into a later one, and every cell of a bucket is final
when the bucket is opened, in any order (Dial 1969, doi 10.1145/363269.363610). Work and memory grow with what burns.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels import embers as flying
from firebreak_gis.kernels.bits import lowest
from firebreak_gis.kernels.buckets import AFAR, DONE, NOBODY, Buckets, buckets, refill
from firebreak_gis.kernels.draws import Thresholds, bytes_below, bytes_equal, later_digits, word
from firebreak_gis.kernels.embers import Embers
from firebreak_gis.kernels.percolation import Steps, number
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.kernels.prefetch import prefetch
from firebreak_gis.kernels.tally import Tally, add_run
from firebreak_gis.kernels.walls import GROUND, Cleared, Walls, falls_on, held_back, kept, manned, spared, stands

#: Arrival at a cell that the fire has not reached.
UNSEEN = np.uint64(0xFFFFFFFFFFFFFFFF)
#: Duration of a run that ends by itself [s].
ENDLESS = 1 << 62

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_SEVEN = np.uint64(7)
_EIGHT = np.uint64(8)
#: Above the error of the sums of shares, far below a second.
_ROUNDING = 1e-6
_NEVER = np.uint32(0xFFFFFFFF)


class Clock(NamedTuple):
    """How long fire takes, and how the weather changes.

    Parameters
    ----------
    seconds
        (n_steps * n_cells * 8,) uint32 time along each edge, direction by direction, cell by cell, under the weather
        of each step; (n_steps * 8,) if all cells are alike. `lattice.NEVER` where fire does not move.
    ends
        (n_steps - 1,) uint64, rising: end of each step [s after the start of the run]; the last step lasts for ever.
    shift
        Width of a bucket: 2^shift seconds, at most the least of `seconds`, and of the delays of embers.
    """

    seconds: np.ndarray
    ends: np.ndarray
    shift: np.uint64


class Starts(NamedTuple):
    """Ignitions of the runs, and how long they last.

    Parameters
    ----------
    first
        (n_runs + 1,) int64. Run i is lit at ``cells[first[i]:first[i + 1]]``.
    cells
        int64, row-major; -1 burns nothing.
    at
        uint64, when each of them is lit [s after the start of the run].
    limit
        (n_runs,) uint64: cells reached later than this do not burn [s]; `ENDLESS`.
    """

    first: np.ndarray
    cells: np.ndarray
    at: np.ndarray
    limit: np.ndarray


class Workspace(NamedTuple):
    """Memory of one thread, used from run to run: 24 bytes a cell.

    Parameters
    ----------
    arrival
        (n_cells,) uint64 [s], `UNSEEN` between runs.
    parent
        (n_cells,) uint32 cell that lit each burnt cell.
    order
        (n_cells,) uint32 burnt cells of the run.
    queue
        Cells that fire is on its way to.
    """

    arrival: np.ndarray
    parent: np.ndarray
    order: np.ndarray
    queue: Buckets


def workspace(n_cells: int, span: int) -> Workspace:
    """Workspace for steps of up to `span` buckets."""
    return Workspace(
        np.full(n_cells, UNSEEN), np.empty(n_cells, np.uint32), np.empty(n_cells, np.uint32), buckets(n_cells, span)
    )


@kernel
def lay_out(times: np.ndarray, out: np.ndarray) -> tuple[int, int]:
    """Lay times by direction, (8, n_cells) uint32, out by cell, (n_cells, 8); the least and the most of any step.

    Where no fire moves they are `lattice.NEVER` and 1.
    """
    # Planes by name, and no branch: so the compiler does several cells at once.
    n, ne, e, se, s, sw, w, nw = times[0], times[1], times[2], times[3], times[4], times[5], times[6], times[7]
    laid = out.reshape(-1)
    least, most = _NEVER, np.uint32(1)
    for cell in range(times.shape[1]):
        at = 8 * cell
        for time in (n[cell], ne[cell], e[cell], se[cell], s[cell], sw[cell], w[cell], nw[cell]):
            laid[at] = time
            at += 1
            least = min(least, time)
            most = max(most, time if time != _NEVER else np.uint32(1))
    return least, most


@kernel
def _across(
    seconds: np.ndarray, ends: np.ndarray, step: int, edge: np.uint64, stride: np.uint64, t: np.uint64
) -> np.uint64:
    """When fire that sets out at t, in the weather of `step`, is across; `UNSEEN` if never.

    The share of the way that is left falls at the rate of each step in turn. Every rounding keeps order, so who leaves
    later never arrives earlier; steps of equal weather are as one.
    """
    result = UNSEEN
    left = 1.0
    for s in range(step, ends.size + 1):
        whole = seconds[np.uint64(s) * stride + edge]
        if whole != _NEVER:
            need = np.ceil(left * np.float64(whole) - _ROUNDING)
            if s == ends.size or need <= np.float64(ends[s] - t):
                result = t + np.uint64(need)
                break
            left = max(left - np.float64(ends[s] - t) / np.float64(whole), 0.0)
        if s < ends.size:
            t = ends[s]
    return result


@kernel
def burn_timed(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    clock: Clock,
    starts: Starts,
    walls: Walls,
    cleared: Cleared,
    embers: Embers,
    space: Workspace,
    runs: np.ndarray,
    tally: Tally,
    strongest: np.ndarray,
) -> None:
    """Burn runs one after another.

    Parameters
    ----------
    thresholds, keys, steps
        As in `kernels.percolation`, of the network without breaks.
    clock, starts
        See there.
    walls, cleared
        Breaks, and how they hold, and ground that lines clear; without any, empty arrays.
    embers
        What flies ahead of the fire; without any, empty arrays.
    space
        As it comes from `workspace`, and again so on return.
    runs
        int64 numbers of the runs to make.
    tally
        What is asked is added to it.
    strongest
        (n_cells,) float32 intensity of a fire that starts in a cell [kW/m]; empty if flame lengths are not asked.
    """
    for k in range(runs.size):
        run = runs[k]
        size = burn_run(thresholds, keys[run], steps, clock, starts, walls, cleared, embers, space, run)
        add_run(tally, run, space.order, size, space.arrival, space.parent, steps, strongest, walls, cleared)
        for i in range(size):
            space.arrival[space.order[i]] = UNSEEN


@kernel
def burn_run(
    thresholds: Thresholds,
    key: np.uint64,
    steps: Steps,
    clock: Clock,
    starts: Starts,
    walls: Walls,
    cleared: Cleared,
    embers: Embers,
    space: Workspace,
    run: int,
) -> np.uint64:
    """Burn one run; return the number of burnt cells, which stand in `space.order`.

    All is in one function and by plain names: numba counts the holders of an array at each call and each look-up in a
    tuple, which costs more than the rest of the step.
    """
    top, offsets, positions = thresholds.top, steps.offsets, steps.position
    arrival, parent, order = space.arrival, space.parent, space.order
    heads, links = space.queue.heads, space.queue.links
    seconds, ends, shift, near = clock.seconds, clock.ends, clock.shift, walls.near
    ignitions, lit_at = starts.cells, starts.at
    size_of_ring = np.uint64(heads.size - 1)
    ring = size_of_ring - _ONE
    limit = starts.limit[run]
    awaited = walls.crews.size > 0
    clears = cleared.ground.shape[0] > 0
    hold_key, holds, stretch = walls.keys[run], walls.holds, walls.stretch
    residual, probability = walls.residual, walls.probability
    crossed, line_holds, line_stretch = walls.crossed, walls.line_holds, walls.line_stretch
    expected, ember_key = embers.mean, embers.keys[run]
    walled, throws, periodic = near.size > 0, expected.size > 0, positions.size > 0
    stride = np.uint64(seconds.size // (ends.size + 1))
    a_cell = _EIGHT if stride > _EIGHT else _ZERO  # times of an edge from one cell to the next
    below = offsets[0, 4]
    last, steady = np.uint64(arrival.size - 1), ends.size == 0
    # What the cell at hand may light, and when.
    targets = np.empty(8 + flying.MOST, np.uint64)
    times = np.empty(8 + flying.MOST, np.uint64)
    lit = starts.first[run]
    last_lit = starts.first[run + 1]
    waiting = _ZERO
    now = _ZERO
    far_first = UNSEEN
    size = _ZERO
    step = 0
    coming = NOBODY
    cell = _ZERO
    while True:
        found = 0
        if lit < last_lit:
            if ignitions[lit] >= 0:
                cell = np.uint64(ignitions[lit])
                targets[0] = cell
                times[0] = lit_at[lit]
                found = 1
                if walled and kept(walls, cell) == 0.0 and stands(walls, run, cell) and manned(walls, cell, times[0]):
                    found = 0
                if clears and kept(walls, cell) == 0.0:
                    ground = spared(walls, cleared, run, cell, times[0])
                    if falls_on(cleared.keys[run], number(steps, cell), ground):
                        found = 0
            lit += 1
        else:
            if coming == NOBODY:
                if waiting == _ZERO:
                    break
                empty = _ZERO
                while True:
                    if now == far_first:
                        far_first = refill(space.queue, arrival, shift, now)
                        empty = _ZERO
                    coming = heads[now & ring]
                    if coming != NOBODY:
                        heads[now & ring] = NOBODY
                        break
                    now += _ONE
                    empty += _ONE
                    if empty == size_of_ring:
                        now = far_first
            cell = np.uint64(coming)
            coming = links[cell, 1]
            prefetch(top, np.uint64(coming))
            prefetch(seconds, a_cell * np.uint64(coming))
            prefetch(arrival, np.uint64(coming) - below)
            prefetch(arrival, np.uint64(coming) + below)
            waiting -= _ONE
            t = arrival[cell]
            order[size] = np.uint32(cell)
            size += _ONE
            position = np.uint8(0)
            if periodic:
                position = positions[cell]
            # Edges by which fire could come sooner than it does; all at once, as most lead to what has burnt.
            sooner = _ZERO
            for k in range(8):
                beside = min(cell + offsets[position, k], last)
                comes = t + (np.uint64(seconds[a_cell * cell + np.uint64(k)]) if steady else _ONE)
                sooner |= np.uint64(comes <= min(arrival[beside], limit)) << np.uint64(8 * k + 7)
            here = number(steps, cell)
            limits = top[cell]
            digits = word(key, here * np.uint64(4))  # as in `draws.open_edges`
            opened = bytes_below(digits, limits) & sooner
            undecided = bytes_equal(digits, limits) & sooner
            if undecided != _ZERO:
                opened |= later_digits(key, here, cell, limits, thresholds.rest, undecided)
            passing = opened
            if walled and near[cell] and opened != _ZERO:
                passing = held_back(
                    hold_key,
                    holds,
                    stretch,
                    residual,
                    probability,
                    crossed,
                    line_holds,
                    line_stretch,
                    key,
                    here,
                    digits,
                    offsets,
                    position,
                    cell,
                    opened,
                )
                if not awaited:
                    opened = passing
            while step < ends.size and t >= ends[step]:
                step += 1
            while step > 0 and t < ends[step - 1]:
                step -= 1
            while opened != _ZERO:
                d = lowest(opened) >> np.uint64(3)
                opened &= opened - _ONE
                targets[found] = cell + offsets[position, d]
                edge = a_cell * cell + d
                times[found] = t + np.uint64(seconds[edge])
                if ends.size > 0:
                    times[found] = _across(seconds, ends, step, edge, stride, t)
                shut = (passing >> (_EIGHT * d + _SEVEN)) & _ONE == _ZERO
                if awaited and shut and manned(walls, targets[found], times[found]):
                    continue
                found += 1
            if throws and flying.may_throw(expected, ember_key, step, cell, here):
                found = _throw(embers, walls, cleared, run, step, cell, t, steps, targets, times, found)
        for k in range(found):
            target = targets[k]
            t = times[k]
            before = arrival[target]
            if t < before and t <= limit:
                bucket = t >> shift
                if before != UNSEEN and links[target, 0] != DONE:  # out of the list where it waits
                    left, right = links[target, 0], links[target, 1]
                    if left < DONE:
                        links[left, 1] = right
                    elif left == AFAR:
                        heads[size_of_ring] = right
                    else:
                        heads[(before >> shift) & ring] = right
                    if right != NOBODY:
                        links[right, 0] = left
                    waiting -= _ONE
                arrival[target] = t
                parent[target] = np.uint32(cell)
                slot = bucket & ring
                left = NOBODY
                if bucket - now >= size_of_ring:
                    slot = size_of_ring
                    left = AFAR
                    far_first = min(far_first, bucket)
                right = heads[slot]
                heads[slot] = np.uint32(target)
                links[target, 0] = left
                links[target, 1] = right
                if right != NOBODY:
                    links[right, 0] = np.uint32(target)
                waiting += _ONE
            elif t == before and np.uint32(cell) < parent[target]:
                parent[target] = np.uint32(cell)  # of those that light it at once, the lowest
    return size


@kernel
def _throw(
    embers: Embers,
    walls: Walls,
    cleared: Cleared,
    run: int,
    step: int,
    cell: np.uint64,
    t: np.uint64,
    steps: Steps,
    targets: np.ndarray,
    times: np.ndarray,
    found: int,
) -> int:
    """Add what the embers of a cell light; return how many things the cell lights in all."""
    walled = walls.near.size > 0
    if not (walled and stands(walls, run, cell) and manned(walls, cell, t)):
        cols = int(steps.offsets[0, 4])
        rows = embers.catches.size // cols
        here = number(steps, cell)
        for k in range(flying.number(embers, run, step, cell, here)):
            target = flying.landing(embers, run, step, cell, here, k, rows, cols, steps.position.size > 0)
            if target != flying.NOWHERE:
                share = 1.0
                when = _ZERO
                if walled and stands(walls, run, target):
                    when = t + flying.smoulders(embers, run, here, k)
                    if manned(walls, target, when):
                        share = kept(walls, target)
                if cleared.ground.shape[0] > 0:
                    when = t + flying.smoulders(embers, run, here, k)
                    share *= 1.0 - spared(walls, cleared, run, target, when) / GROUND
                if flying.lights(embers, run, here, k, target, share):
                    targets[found] = target
                    times[found] = when if when > _ZERO else t + flying.smoulders(embers, run, here, k)
                    found += 1
    return found
