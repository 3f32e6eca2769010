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
from firebreak_gis.kernels.policy import inlined, kernel
from firebreak_gis.kernels.walls import Cleared, Walls, parted, stands

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
    lost = 0.0
    again = Starts(memory.first, memory.seeds, memory.at, starts.limit)
    for k in range(runs.size):
        run = runs[k]
        key = keys[run]
        size = np.int64(burn_run(thresholds, key, steps, clock, starts, walls, cleared, embers, space, run))
        for i in range(size):
            cell = space.order[i]
            memory.order[i] = cell
            memory.arrival[cell] = space.arrival[cell]
            memory.parent[cell] = space.parent[cell]
            space.queue.links[cell, 0] = DONE
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
                    cell = space.order[i]
                    if memory.arrival[cell] == UNSEEN or memory.mark[cell] == _LOST:
                        removed -= value[cell]
                    space.arrival[cell] = memory.arrival[cell]
                    space.parent[cell] = memory.parent[cell]
                    space.queue.links[cell, 0] = DONE
                    memory.mark[cell] = 0
                saved[part] += abs(removed)
                if built:
                    _set(walls, parts, part, True)
                else:
                    _restored(memory, space, size)
            if not built:
                _set(walls, parts, part, False)
        for i in range(size):
            cell = memory.order[i]
            space.arrival[cell] = UNSEEN
            memory.arrival[cell] = UNSEEN
    return lost


@kernel
def _set(walls: Walls, parts: Parts, part: int, cut: bool) -> None:
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = parts.cells[i]
        if parts.towards.size > 0:
            bit = np.uint8(1) << parts.towards[i]
            walls.crossed[cell] = walls.crossed[cell] | bit if cut else walls.crossed[cell] & ~bit
        else:
            walls.holds[cell] = parts.cut[cell] if cut else parts.uncut[cell]


@kernel
def _holds(walls: Walls, steps: Steps, parts: Parts, part: int, run: int) -> bool:
    """Whether any cell or link of a part holds in the run."""
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = np.uint64(parts.cells[i])
        if parts.towards.size > 0:
            d = parts.towards[i]
            if parted(walls, run, cell, cell + steps.offsets[0, d], d):
                return True
        elif stands(walls, run, cell):
            return True
    return False


@kernel
def _touched(steps: Steps, starts: Starts, parts: Parts, memory: Kept, run: int, size: int) -> int:
    """List the built parts that are lit or lie beside burnt cells, and the others in or across which fire goes."""
    # Arrays by plain names in the loops over what burns: each look-up in a tuple costs more than the rest of a step.
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


@inlined
def _seed(
    cell: np.uint64,
    count: int,
    mark: np.ndarray,
    arrival: np.ndarray,
    seeds: np.ndarray,
    at: np.ndarray,
    again: np.ndarray,
) -> int:
    """Let fire go on from a burnt cell, once."""
    if arrival[cell] != UNSEEN and mark[cell] == 0:
        mark[cell] = _BESIDE
        seeds[count] = np.int64(cell)
        at[count] = arrival[cell]
        again[cell] = UNSEEN
        count += 1
    return count


@kernel
def _beside_part(
    steps: Steps, starts: Starts, parts: Parts, part: int, memory: Kept, space: Workspace, run: int
) -> int:
    """Seeds are what is lit in a part, and the burnt cells beside it; return their number."""
    mark, arrival, seeds, at, again = memory.mark, memory.arrival, memory.seeds, memory.at, space.arrival
    cells, offsets, positions = parts.cells, steps.offsets, steps.position
    lines = parts.towards.size > 0
    count = _lit_in(starts, parts, part, memory, run)
    for i in range(parts.first[part], parts.first[part + 1]):
        cell = np.uint64(cells[i])
        if lines:
            count = _seed(cell, count, mark, arrival, seeds, at, again)
            continue
        position = positions[cell] if positions.size > 0 else np.uint8(0)
        for d in range(8):  # one beyond the border may be any cell, from which fire goes nowhere new
            beside = cell + offsets[position, d]
            if beside < np.uint64(arrival.size):
                count = _seed(beside, count, mark, arrival, seeds, at, again)
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
    mark, arrival, seeds, at, again = memory.mark, memory.arrival, memory.seeds, memory.at, space.arrival
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
    count = _lit_in(starts, parts, part, memory, run)
    for i in range(size):
        cell = np.uint64(order[i])
        if mark[cell] == _LOST:
            position = positions[cell] if positions.size > 0 else np.uint8(0)
            for d in range(8):
                beside = cell + offsets[position, d]
                if beside < np.uint64(arrival.size):
                    count = _seed(beside, count, mark, arrival, seeds, at, again)
    return back, count


@kernel
def _restored(memory: Kept, space: Workspace, size: int) -> None:
    """Put the run back as it was."""
    for i in range(size):
        cell = memory.order[i]
        if memory.mark[cell] != 0:
            memory.mark[cell] = 0
            space.arrival[cell] = memory.arrival[cell]
            space.parent[cell] = memory.parent[cell]
