"""What each part of a set of breaks is worth in fires with a clock: what it saves, or would save, by itself.

A run is burnt once; then one part after another is left out or put in, and only what that changes is burnt anew. Where
a part is left out, fire goes on from the burnt cells beside it, and what it reaches before was reached later or not at
all. Where one is put in, the cells that were lit by way of it are taken back, and fire comes to them from the burnt
cells beside. All other cells keep their times, since the way by which fire came to them is still there.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.arrival import UNSEEN, Clock, Starts, Workspace, burn_run
from firebreak_gis.kernels.buckets import DONE
from firebreak_gis.kernels.draws import Thresholds
from firebreak_gis.kernels.embers import Embers
from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.kernels.walls import Cleared, Walls, holding

_ONE = np.uint64(1)
_EIGHT = np.uint64(8)
_LOST, _BESIDE = np.uint8(1), np.uint8(2)


class Parts(NamedTuple):
    """Parts of breaks that are built or may be: cells, or links that lines cross; none is in two of them.

    Parameters
    ----------
    first, cells
        Row-major cells of part p are ``cells[first[p]:first[p + 1]]``, int64; of lines, the cells from which its links
        go, both of each link.
    towards
        (n,) uint8, of lines the directions of those links; empty where parts are cells.
    of
        (n_cells,) int32 part of each cell, -1 for none; of lines (8 * n_cells,), direction by direction, cell by cell.
    built
        (n_parts,) bool.
    cut, uncut
        (n_cells,) uint32 as `Walls.holds`: where the cell is cut, and where it is not; empty where parts are lines.
    """

    first: np.ndarray
    cells: np.ndarray
    towards: np.ndarray
    of: np.ndarray
    built: np.ndarray
    cut: np.ndarray
    uncut: np.ndarray


class Kept(NamedTuple):
    """The run as it is, and seeds of what is burnt anew; memory of one thread, 34 bytes a cell.

    Parameters
    ----------
    arrival
        (n_cells,) uint64, `UNSEEN` between runs.
    parent, order
        (n_cells,) uint32.
    mark
        (n_cells,) uint8, 0 between parts.
    first
        (n_runs + 1,) int64 for `Starts`.
    seeds, at
        (n_cells,) int64 cells from which fire goes on, uint64 when they burn.
    touched
        (n_parts,) int64 parts that a run meets.
    seen
        (n_parts,) bool, False between runs.
    """

    arrival: np.ndarray
    parent: np.ndarray
    order: np.ndarray
    mark: np.ndarray
    first: np.ndarray
    seeds: np.ndarray
    at: np.ndarray
    touched: np.ndarray
    seen: np.ndarray


def kept(n_cells: int, n_runs: int, n_parts: int) -> Kept:
    """Memory for a thread."""
    return Kept(
        np.full(n_cells, UNSEEN),
        np.empty(n_cells, np.uint32),
        np.empty(n_cells, np.uint32),
        np.zeros(n_cells, np.uint8),
        np.zeros(n_runs + 1, np.int64),
        np.empty(n_cells, np.int64),
        np.empty(n_cells, np.uint64),
        np.empty(n_parts, np.int64),
        np.zeros(n_parts, bool),
    )


@kernel
def worth(
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
    value: np.ndarray,
    parts: Parts,
    memory: Kept,
    saved: np.ndarray,
) -> float:
    """Add up what each built part saves, and each other would save if it were built beside them.

    Parameters
    ----------
    thresholds, keys, steps, clock, starts, cleared, embers, space, runs
        As in `arrival.burn_timed`.
    walls
        Breaks with the built parts; `holds` and `crossed` belong to the thread, `near` is set beside all parts.
    value
        (n_cells,) float64 lost when the cell burns.
    parts, memory
        See there.
    saved
        (n_parts,) float64, added to. Embers that a change of far cells lets land beside a part are left out.

    Returns
    -------
    float
        Value lost as it is, summed over the runs.
    """
    # Arrays by plain names: each look-up in a tuple costs more than the rest of a step.
    order, arrival, parent, links = space.order, space.arrival, space.parent, space.queue.links
    kept_order, kept_arrival, kept_parent, mark = memory.order, memory.arrival, memory.parent, memory.mark
    lost = 0.0
    again = Starts(memory.first, memory.seeds, memory.at, starts.limit)
    for k in range(runs.size):
        run = runs[k]
        key = keys[run]
        size = np.int64(burn_run(thresholds, key, steps, clock, starts, walls, cleared, embers, space, run))
        for i in range(size):
            cell = order[i]
            kept_order[i] = cell
            kept_arrival[cell] = arrival[cell]
            kept_parent[cell] = parent[cell]
            links[cell, 0] = DONE
            lost += value[cell]
        for t in range(_touched(steps, starts, parts, memory, run, size)):
            part = memory.touched[t]
            memory.seen[part] = False
            built = parts.built[part]
            if not built:
                _set(walls, parts, part, True)
            if _holds(walls, steps, parts, part, run):
                removed = 0.0
                count = 0
                if built:
                    _set(walls, parts, part, False)
                    count = _beside_part(steps, starts, parts, part, memory, space, run)
                else:
                    removed, count = _taken_back(steps, starts, parts, part, memory, space, size, run, value)
                memory.first[run] = 0
                memory.first[run + 1] = count
                burnt = np.int64(burn_run(thresholds, key, steps, clock, again, walls, cleared, embers, space, run))
                for i in range(burnt):
                    cell = order[i]
                    if kept_arrival[cell] == UNSEEN or mark[cell] == _LOST:
                        removed -= value[cell]
                    arrival[cell] = kept_arrival[cell]
                    parent[cell] = kept_parent[cell]
                    links[cell, 0] = DONE
                    mark[cell] = 0
                saved[part] += abs(removed)
                if built:
                    _set(walls, parts, part, True)
                else:
                    _restored(memory, space, size)
            if not built:
                _set(walls, parts, part, False)
        for i in range(size):
            cell = kept_order[i]
            arrival[cell] = UNSEEN
            kept_arrival[cell] = UNSEEN
    return lost


@kernel
def _set(walls: Walls, parts: Parts, part: int, cut: bool) -> None:
    cells, towards, crossed, holds = parts.cells, parts.towards, walls.crossed, walls.holds
    becomes = parts.cut if cut else parts.uncut
    lines = towards.size > 0
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = cells[i]
        if lines:
            bit = np.uint8(1) << towards[i]
            crossed[cell] = crossed[cell] | bit if cut else crossed[cell] & ~bit
        else:
            holds[cell] = becomes[cell]


@kernel
def _holds(walls: Walls, steps: Steps, parts: Parts, part: int, run: int) -> bool:
    """Whether any cell or link of a part that is set holds in the run."""
    cells, towards, offsets, key = parts.cells, parts.towards, steps.offsets, walls.keys[run]
    holds, stretch, line_holds, line_stretch = walls.holds, walls.stretch, walls.line_holds, walls.line_stretch
    lines = towards.size > 0
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = np.uint64(cells[i])
        if lines:
            first = min(cell, cell + offsets[0, towards[i]])
            if holding(key, line_stretch[first], line_holds[first]):
                return True
        elif holding(key, stretch[cell], holds[cell]):
            return True
    return False


@kernel
def _touched(steps: Steps, starts: Starts, parts: Parts, memory: Kept, run: int, size: int) -> int:
    """List the built parts that are lit or lie beside burnt cells, and the others in or across which fire goes."""
    of, built, seen, touched = parts.of, parts.built, memory.seen, memory.touched
    order, parent, offsets, positions = memory.order, memory.parent, steps.offsets, steps.position
    n_cells = np.uint64(memory.arrival.size)
    count = 0
    if parts.towards.size > 0:
        for i in range(size):
            cell = np.uint64(order[i])
            for d in range(8):
                own = of[_EIGHT * cell + np.uint64(d)]
                if own < 0 or seen[own]:
                    continue
                if built[own] or parent[cell] == np.uint32(cell + offsets[0, d]):
                    seen[own] = True
                    touched[count] = own
                    count += 1
        return count
    for i in range(starts.first[run], starts.first[run + 1]):
        if starts.cells[i] >= 0:
            own = of[starts.cells[i]]
            if own >= 0 and not seen[own]:
                seen[own] = True
                touched[count] = own
                count += 1
    for i in range(size):
        cell = np.uint64(order[i])
        own = of[cell]
        if own >= 0 and not built[own] and not seen[own]:
            seen[own] = True
            touched[count] = own
            count += 1
        position = positions[cell] if positions.size > 0 else np.uint8(0)
        for d in range(8):
            beside = cell + offsets[position, d]
            if beside < n_cells:
                other = of[beside]
                if other >= 0 and built[other] and not seen[other]:
                    seen[other] = True
                    touched[count] = other
                    count += 1
    return count


@kernel
def _lit_in(starts: Starts, parts: Parts, part: int, memory: Kept, run: int) -> int:
    """Seeds are the ignitions in what is burnt anew or was not burnt; return their number."""
    count = 0
    for i in range(starts.first[run], starts.first[run + 1]):
        cell = starts.cells[i]
        if cell >= 0:
            unburnt = parts.towards.size == 0 and memory.arrival[cell] == UNSEEN and parts.of[cell] == part
            if memory.mark[cell] == _LOST or unburnt:
                memory.seeds[count] = cell
                memory.at[count] = starts.at[i]
                count += 1
    return count


@kernel
def _go_on(memory: Kept, space: Workspace, first: int, count: int) -> None:
    """Let fire go on from seeds that burn already."""
    seeds, at, arrival, again = memory.seeds, memory.at, memory.arrival, space.arrival
    for i in range(first, count):
        cell = seeds[i]
        at[i] = arrival[cell]
        again[cell] = UNSEEN


@kernel
def _beside_part(
    steps: Steps, starts: Starts, parts: Parts, part: int, memory: Kept, space: Workspace, run: int
) -> int:
    """Seeds are what is lit in a part, and the burnt cells beside it; return their number.

    A seed is noted in place: numba would count the holders of the arrays at each call of a function that does it.
    """
    mark, arrival, seeds = memory.mark, memory.arrival, memory.seeds
    cells, offsets, positions = parts.cells, steps.offsets, steps.position
    lines = parts.towards.size > 0
    lit = _lit_in(starts, parts, part, memory, run)
    count = lit
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = np.uint64(cells[i])
        if lines:
            if arrival[cell] != UNSEEN and mark[cell] == 0:
                mark[cell] = _BESIDE
                seeds[count] = np.int64(cell)
                count += 1
            continue
        position = positions[cell] if positions.size > 0 else np.uint8(0)
        for d in range(8):  # one beyond the border may be any cell, from which fire goes nowhere new
            beside = cell + offsets[position, d]
            if beside < np.uint64(arrival.size) and arrival[beside] != UNSEEN and mark[beside] == 0:
                mark[beside] = _BESIDE
                seeds[count] = np.int64(beside)
                count += 1
    _go_on(memory, space, lit, count)
    return count


@kernel
def _taken_back(
    steps: Steps,
    starts: Starts,
    parts: Parts,
    part: int,
    memory: Kept,
    space: Workspace,
    size: int,
    run: int,
    value: np.ndarray,
) -> tuple[float, int]:
    """Take back all that burnt by way of a part; return its value, and the number of seeds beside it."""
    mark, arrival, seeds, again = memory.mark, memory.arrival, memory.seeds, space.arrival
    order, parents, offsets, positions = memory.order, memory.parent, steps.offsets, steps.position
    cells, towards = parts.cells, parts.towards
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = np.uint64(cells[i])
        if arrival[cell] != UNSEEN and (towards.size == 0 or parents[cell] == np.uint32(cell + offsets[0, towards[i]])):
            mark[cell] = _LOST
    back = 0.0
    for i in range(size):  # who lights comes before who is lit
        cell = order[i]
        if mark[cell] == _LOST or mark[parents[cell]] == _LOST:
            mark[cell] = _LOST
            back += value[cell]
            again[cell] = UNSEEN
    lit = _lit_in(starts, parts, part, memory, run)
    count = lit
    for i in range(size):
        cell = np.uint64(order[i])
        if mark[cell] == _LOST:
            position = positions[cell] if positions.size > 0 else np.uint8(0)
            for d in range(8):
                beside = cell + offsets[position, d]
                if beside < np.uint64(arrival.size) and arrival[beside] != UNSEEN and mark[beside] == 0:
                    mark[beside] = _BESIDE
                    seeds[count] = np.int64(beside)
                    count += 1
    _go_on(memory, space, lit, count)
    return back, count


@kernel
def _restored(memory: Kept, space: Workspace, size: int) -> None:
    """Put the run back as it was."""
    mark, order, arrival, parent = memory.mark, memory.order, space.arrival, space.parent
    kept_arrival, kept_parent = memory.arrival, memory.parent
    for i in range(size):
        cell = order[i]
        if mark[cell] != 0:
            mark[cell] = 0
            arrival[cell] = kept_arrival[cell]
            parent[cell] = kept_parent[cell]
