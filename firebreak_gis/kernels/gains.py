"""What cutting one cell would save in simulated fires: by the tree of who lit whom, and exactly.

Common arguments:

thresholds, keys, steps
    As in `kernels.percolation`.
cells
    (n_runs,) int64 ignition cell of each run.
alive
    (n_cells,) bool: not cut yet. A fire that starts on a cut cell burns nothing.
value
    (n_cells,) float64 lost when the cell burns.
gain
    (n_cells,) float64; the value saved by cutting the cell is added, summed over the runs.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.draws import Thresholds, open_edges
from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import inlined, kernel


@inlined
def _neighbour(cell: int, d: int, steps: Steps) -> int:
    position = np.uint8(0)
    if steps.position.size > 0:
        position = steps.position[cell]
    return np.int64(np.uint64(cell) + steps.offsets[position, d])


@kernel
def downstream(
    thresholds: Thresholds, keys: np.ndarray, steps: Steps, cells: np.ndarray, alive: np.ndarray, value: np.ndarray,
    first: int, last: int, gain: np.ndarray,
) -> float:
    """Value of each cell and of all that it lit, directly or not, in runs `first` .. `last - 1`.

    Fires grow in steps of equal time; a cell is lit by the first neighbour to reach it. Cost: two passes over the
    burnt cells of a run.

    Returns
    -------
    float
        Value lost, summed over the runs.
    """
    n_cells = alive.shape[0]
    lit_by = np.full(n_cells, -1, np.int32)
    queue = np.empty(n_cells, np.int32)
    worth = np.empty(n_cells, np.float64)
    lost = 0.0
    for run in range(first, last):
        if not alive[cells[run]]:
            continue
        queue[0] = cells[run]
        lit_by[cells[run]] = cells[run]
        head, tail = 0, 1
        while head < tail:
            cell = np.int64(queue[head])
            head += 1
            worth[cell] = value[cell]
            opened = open_edges(keys[run], np.uint64(cell), thresholds.top[cell], thresholds.rest)
            for d in range(8):
                if (opened >> np.uint64(8 * d + 7)) & np.uint64(1):
                    target = _neighbour(cell, d, steps)
                    if alive[target] and lit_by[target] < 0:
                        lit_by[target] = cell
                        queue[tail] = target
                        tail += 1
        for i in range(tail - 1, 0, -1):
            cell = np.int64(queue[i])
            worth[lit_by[cell]] += worth[cell]
        lost += worth[queue[0]]
        for i in range(tail):
            cell = np.int64(queue[i])
            gain[cell] += worth[cell]
            lit_by[cell] = -1
    return lost


@kernel
def dominated(
    thresholds: Thresholds, keys: np.ndarray, steps: Steps, cells: np.ndarray, alive: np.ndarray, value: np.ndarray,
    first: int, last: int, gain: np.ndarray,
) -> float:
    """Value that would not burn without the cell in runs `first` .. `last - 1`: exactly what cutting it saves.

    A cell burns only by way of its dominators in the graph of open edges, rooted at the ignition; the gain of a
    cell is the value of its subtree in the dominator tree (semi-NCA: Georgiadis, Tarjan, Werneck 2006,
    doi 10.7155/jgaa.00119). Cost: a few passes over the open edges of a run.

    Returns
    -------
    float
        Value lost, summed over the runs.
    """
    n_cells = alive.shape[0]
    number = np.full(n_cells, -1, np.int32)  # position in depth-first order
    opened = np.zeros(n_cells, np.uint8)
    vertex = np.empty(n_cells, np.int32)
    ancestor = np.empty(n_cells, np.int32)
    dominator = np.empty(n_cells, np.int32)
    semi = np.empty(n_cells, np.int32)
    label = np.empty(n_cells, np.int32)
    stack = np.empty(n_cells, np.int32)
    worth = np.empty(n_cells, np.float64)
    lost = 0.0
    for run in range(first, last):
        if not alive[cells[run]]:
            continue
        n = _depth_first(thresholds, keys[run], steps, cells[run], alive, number, opened, vertex, ancestor, stack)
        for i in range(n):
            dominator[i] = ancestor[i]
            semi[i] = i
            label[i] = i
        for i in range(n - 1, 0, -1):
            least = dominator[i]
            cell = np.int64(vertex[i])
            for d in range(8):
                other = _neighbour(cell, d, steps)
                if 0 <= other < n_cells and number[other] >= 0 and (opened[other] >> ((d + 4) & 7)) & 1:
                    least = min(least, semi[_lowest(number[other], i + 1, ancestor, semi, label, stack)])
            semi[i] = least
        for i in range(1, n):
            above = dominator[i]
            while above > semi[i]:
                above = dominator[above]
            dominator[i] = above
        for i in range(n):
            worth[i] = value[vertex[i]]
        for i in range(n - 1, 0, -1):
            worth[dominator[i]] += worth[i]
        lost += worth[0]
        for i in range(n):
            gain[vertex[i]] += worth[i]
            number[vertex[i]] = -1
    return lost


@kernel
def _depth_first(
    thresholds: Thresholds, key: np.uint64, steps: Steps, start: int, alive: np.ndarray, number: np.ndarray,
    opened: np.ndarray, vertex: np.ndarray, parent: np.ndarray, stack: np.ndarray,
) -> int:
    """Number the cells that burn in depth-first order; how many burn. `parent` holds numbers, 0 for the first."""
    n = 0
    depth = 0
    stack[0] = start
    number[start] = 0
    parent[0] = 0
    vertex[0] = start
    opened[start] = _open_bits(thresholds, key, start, steps, alive)
    left = np.zeros(alive.shape[0], np.uint8)  # open edges of a cell on the stack that are still to be tried
    left[start] = opened[start]
    n = 1
    while depth >= 0:
        cell = np.int64(stack[depth])
        if left[cell] == 0:
            depth -= 1
            continue
        d = 0
        while not (left[cell] >> d) & 1:
            d += 1
        left[cell] &= left[cell] - np.uint8(1)
        target = _neighbour(cell, d, steps)
        if number[target] < 0:
            number[target] = n
            parent[n] = number[cell]
            vertex[n] = target
            opened[target] = _open_bits(thresholds, key, target, steps, alive)
            left[target] = opened[target]
            n += 1
            depth += 1
            stack[depth] = target
    return n


@inlined
def _open_bits(thresholds: Thresholds, key: np.uint64, cell: int, steps: Steps, alive: np.ndarray) -> np.uint8:
    """Bit d set where the edge in direction d is open and leads to a cell that is alive."""
    edges = open_edges(key, np.uint64(cell), thresholds.top[cell], thresholds.rest)
    bits = np.uint8(0)
    for d in range(8):
        if (edges >> np.uint64(8 * d + 7)) & np.uint64(1) and alive[_neighbour(cell, d, steps)]:
            bits |= np.uint8(1) << np.uint8(d)
    return bits


@kernel
def _lowest(
    v: int, linked: int, ancestor: np.ndarray, semi: np.ndarray, label: np.ndarray, stack: np.ndarray
) -> int:
    """Cell of the smallest semidominator between `v` and the root of its tree of cells numbered `linked` or more."""
    if ancestor[v] < linked:
        return label[v]
    depth = 0
    while ancestor[v] >= linked:
        stack[depth] = v
        depth += 1
        v = ancestor[v]
    above = v
    best = label[above]
    while depth > 0:
        depth -= 1
        v = stack[depth]
        ancestor[v] = ancestor[above]
        if semi[best] < semi[label[v]]:
            label[v] = best
        else:
            best = label[v]
        above = v
    return best


@kernel
def reopened(
    thresholds: Thresholds, keys: np.ndarray, steps: Steps, cells: np.ndarray, alive: np.ndarray, value: np.ndarray,
    cut: np.ndarray, first: int, last: int, loss: np.ndarray,
) -> None:
    """Value that burns in addition if one cut cell is left uncut, in runs `first` .. `last - 1`.

    Parameters
    ----------
    cut
        (n_cut,) int64 cells that are not alive.
    loss
        (n_cut,) float64; the additional loss is added, summed over the runs.
    """
    n_cells = alive.shape[0]
    stamp = np.zeros(n_cells, np.int32)  # 1: burns; 2, 3, ...: burns if the cell of that search is left
    queue = np.empty(n_cells, np.int32)
    for run in range(first, last):
        stamp[:] = 0
        start = cells[run]
        if alive[start]:
            _spread(thresholds, keys[run], steps, start, alive, stamp, np.int32(1), queue, value)
        mark = np.int32(1)
        for k in range(cut.shape[0]):
            cell = cut[k]
            lit = cell == start
            for d in range(8):
                other = _neighbour(cell, d, steps)
                if not lit and 0 <= other < n_cells and stamp[other] == 1:
                    edges = open_edges(keys[run], np.uint64(other), thresholds.top[other], thresholds.rest)
                    lit = (edges >> np.uint64(8 * ((d + 4) & 7) + 7)) & np.uint64(1) != 0
            if lit:
                mark += np.int32(1)
                loss[k] += _spread(thresholds, keys[run], steps, cell, alive, stamp, mark, queue, value)
                stamp[cell] = 0


@kernel
def _spread(
    thresholds: Thresholds, key: np.uint64, steps: Steps, start: int, alive: np.ndarray, stamp: np.ndarray,
    mark: np.int32, queue: np.ndarray, value: np.ndarray,
) -> float:
    """Mark what burns from `start` and bears neither 1 nor `mark`; its value."""
    queue[0] = start
    stamp[start] = mark
    head, tail = 0, 1
    total = 0.0
    while head < tail:
        cell = np.int64(queue[head])
        head += 1
        total += value[cell]
        edges = open_edges(key, np.uint64(cell), thresholds.top[cell], thresholds.rest)
        for d in range(8):
            if (edges >> np.uint64(8 * d + 7)) & np.uint64(1):
                target = _neighbour(cell, d, steps)
                if alive[target] and stamp[target] != 1 and stamp[target] != mark:
                    stamp[target] = mark
                    queue[tail] = target
                    tail += 1
    return total
