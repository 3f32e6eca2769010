"""What cutting one cell would save in simulated fires: by the tree of who lit whom, and exactly.

Common arguments:

thresholds, keys, steps
    As in `kernels.percolation`; the thresholds are those before cutting.
leaks
    `draws.Thresholds` of edges into cut cells; empty if breaks are perfect.
cells
    (n_runs,) int64 ignition cell of each run.
alive
    (n_cells,) bool: not cut yet. A fire that starts on a cut cell burns nothing if breaks are perfect, and goes on if
    they leak.
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
    thresholds: Thresholds,
    leaks: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    cells: np.ndarray,
    alive: np.ndarray,
    value: np.ndarray,
    first: int,
    last: int,
    gain: np.ndarray,
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
        if not alive[cells[run]] and leaks.top.size == 0:
            continue
        queue[0] = cells[run]
        lit_by[cells[run]] = cells[run]
        head, tail = 0, 1
        while head < tail:
            cell = np.int64(queue[head])
            head += 1
            worth[cell] = value[cell]
            opened, _ = _open_bits(thresholds, leaks, keys[run], cell, steps, alive)
            for d in range(8):
                if (opened >> np.uint8(d)) & np.uint8(1):
                    target = _neighbour(cell, d, steps)
                    if lit_by[target] < 0:
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
    thresholds: Thresholds,
    leaks: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    cells: np.ndarray,
    alive: np.ndarray,
    value: np.ndarray,
    first: int,
    last: int,
    gain: np.ndarray,
) -> float:
    """Value that would not burn without the cell in runs `first` .. `last - 1`: exactly what cutting it saves.

    A cell burns only by way of its dominators in the graph of open edges, rooted at the ignition; the gain of a
    cell is the value of its subtree in the dominator tree (semi-NCA: Georgiadis, Tarjan, Werneck 2006,
    doi 10.7155/jgaa.00119). Where breaks leak, cutting saves nothing in runs in which fire still enters the cell.
    Cost: a few passes over the open edges of a run.

    Returns
    -------
    float
        Value lost, summed over the runs.
    """
    n_cells = alive.shape[0]
    number = np.full(n_cells, -1, np.int32)  # position in depth-first order
    opened = np.zeros(n_cells, np.uint8)
    leaking = np.zeros(n_cells, np.uint8)
    vertex = np.empty(n_cells, np.int32)
    ancestor = np.empty(n_cells, np.int32)
    dominator = np.empty(n_cells, np.int32)
    semi = np.empty(n_cells, np.int32)
    label = np.empty(n_cells, np.int32)
    stack = np.empty(n_cells, np.int32)
    worth = np.empty(n_cells, np.float64)
    leaky = leaks.top.size > 0
    lost = 0.0
    for run in range(first, last):
        if not alive[cells[run]] and not leaky:
            continue
        n = _depth_first(
            thresholds, leaks, keys[run], steps, cells[run], alive, number, opened, leaking, vertex, ancestor, stack
        )
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
            if not leaky or (i > 0 and not _enters(np.int64(vertex[i]), i, steps, number, leaking, dominator)):
                gain[vertex[i]] += worth[i]
        for i in range(n):
            number[vertex[i]] = -1
    return lost


@kernel
def _enters(cell: int, i: int, steps: Steps, number: np.ndarray, leaking: np.ndarray, dominator: np.ndarray) -> bool:
    """Whether fire enters the cell, the i-th of its run, though it is cut, from one that burns without it."""
    for d in range(8):
        other = _neighbour(cell, d, steps)
        if 0 <= other < number.shape[0] and number[other] >= 0 and (leaking[other] >> ((d + 4) & 7)) & 1:
            above = number[other]
            while above > i:
                above = dominator[above]
            if above != i:
                return True
    return False


@kernel
def _depth_first(
    thresholds: Thresholds,
    leaks: Thresholds,
    key: np.uint64,
    steps: Steps,
    start: int,
    alive: np.ndarray,
    number: np.ndarray,
    opened: np.ndarray,
    leaking: np.ndarray,
    vertex: np.ndarray,
    parent: np.ndarray,
    stack: np.ndarray,
) -> int:
    """Number the cells that burn in depth-first order; how many burn. `parent` holds numbers, 0 for the first."""
    depth = 0
    stack[0] = start
    number[start] = 0
    parent[0] = 0
    vertex[0] = start
    opened[start], leaking[start] = _open_bits(thresholds, leaks, key, start, steps, alive)
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
            opened[target], leaking[target] = _open_bits(thresholds, leaks, key, target, steps, alive)
            left[target] = opened[target]
            n += 1
            depth += 1
            stack[depth] = target
    return n


@inlined
def _open_bits(
    thresholds: Thresholds, leaks: Thresholds, key: np.uint64, cell: int, steps: Steps, alive: np.ndarray
) -> tuple[np.uint8, np.uint8]:
    """Bit d set where fire passes in direction d; and where it would pass even if the cell there were cut."""
    edges = open_edges(key, np.uint64(cell), thresholds.top[cell], thresholds.rest)
    strong = np.uint64(0)
    if leaks.top.size > 0:
        strong = open_edges(key, np.uint64(cell), leaks.top[cell], leaks.rest)
    bits, leaking = np.uint8(0), np.uint8(0)
    for d in range(8):
        if (edges >> np.uint64(8 * d + 7)) & np.uint64(1):
            through = (strong >> np.uint64(8 * d + 7)) & np.uint64(1)
            leaking |= np.uint8(through) << np.uint8(d)
            if through or alive[_neighbour(cell, d, steps)]:
                bits |= np.uint8(1) << np.uint8(d)
    return bits, leaking


@kernel
def _lowest(v: int, linked: int, ancestor: np.ndarray, semi: np.ndarray, label: np.ndarray, stack: np.ndarray) -> int:
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
    thresholds: Thresholds,
    leaks: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    cells: np.ndarray,
    alive: np.ndarray,
    value: np.ndarray,
    first: int,
    last: int,
    enough: float,
    loss: np.ndarray,
) -> None:
    """Value that burns in addition if one cut cell is left uncut, in runs `first` .. `last - 1`.

    Parameters
    ----------
    enough
        A cell whose loss here is as much is not followed any more.
    loss
        (n_cells,) float64; the additional loss of each cut cell is added, summed over the runs.
    """
    n_cells = alive.shape[0]
    stamp = np.zeros(n_cells, np.int32)  # the mark of the last search that reached the cell
    listed = np.full(n_cells, -1, np.int32)
    queue = np.empty(n_cells, np.int32)
    near = np.empty(n_cells, np.int32)
    mark = np.int32(0)
    for run in range(first, last):
        if mark > np.int32(2**31 - 2) - np.int32(n_cells):
            stamp[:] = 0
            mark = np.int32(0)
        start = cells[run]
        mark += np.int32(1)
        burning = mark
        n_near = 0
        if not alive[start] and leaks.top.size == 0:
            near[0] = start
            n_near = 1
        else:
            queue[0] = start
            stamp[start] = burning
            head, tail = 0, 1
            while head < tail:
                cell = np.int64(queue[head])
                head += 1
                edges = open_edges(keys[run], np.uint64(cell), thresholds.top[cell], thresholds.rest)
                bits, _ = _open_bits(thresholds, leaks, keys[run], cell, steps, alive)
                for d in range(8):
                    if (edges >> np.uint64(8 * d + 7)) & np.uint64(1):
                        target = _neighbour(cell, d, steps)
                        if (bits >> np.uint8(d)) & np.uint8(1):
                            if stamp[target] != burning:
                                stamp[target] = burning
                                queue[tail] = target
                                tail += 1
                        elif listed[target] != run:
                            listed[target] = run
                            near[n_near] = target
                            n_near += 1
        for k in range(n_near):
            cell = np.int64(near[k])
            if stamp[cell] != burning and loss[cell] < enough:
                mark += np.int32(1)
                loss[cell] += _added(
                    thresholds, leaks, keys[run], steps, cell, alive, stamp, burning, mark, queue, value
                )


@kernel
def _added(
    thresholds: Thresholds,
    leaks: Thresholds,
    key: np.uint64,
    steps: Steps,
    start: int,
    alive: np.ndarray,
    stamp: np.ndarray,
    burning: np.int32,
    mark: np.int32,
    queue: np.ndarray,
    value: np.ndarray,
) -> float:
    """Value of what burns from `start` and does not burn yet."""
    queue[0] = start
    stamp[start] = mark
    head, tail = 0, 1
    total = 0.0
    while head < tail:
        cell = np.int64(queue[head])
        head += 1
        total += value[cell]
        bits, _ = _open_bits(thresholds, leaks, key, cell, steps, alive)
        for d in range(8):
            if (bits >> np.uint8(d)) & np.uint8(1):
                target = _neighbour(cell, d, steps)
                if stamp[target] != burning and stamp[target] != mark:
                    stamp[target] = mark
                    queue[tail] = target
                    tail += 1
    return total
