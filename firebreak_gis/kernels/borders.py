"""Quarters of the cut cells: to which compartment each is nearest through the break, and where compartments meet.

A cut cell is divided into 2 x 2 quarters. Quarter 4 k + 2 i + j is that in half row i and half column j of the k-th cut
cell. So all but the numbers of the cut cells grows with what is cut, not with the map.

Common arguments:

number
    (rows, cols) int32: number of each cut cell in reading order, -1 elsewhere.
labels
    (rows, cols) int32: compartments from 1, 0 for none.
cells
    (n,) int64 row-major numbers of the cut cells, rising.
periodic
    Whether the grid is a torus.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

#: Steps over the sides, then over the corners.
_DOWN = (0, 1, 0, -1, 1, 1, -1, -1)
_ACROSS = (1, 0, -1, 0, 1, -1, -1, 1)
#: No quarter of a cut cell; `OFF` not on the grid either.
OTHER, OFF = -1, -2


@inlined
def _beside(number: np.ndarray, cells: np.ndarray, quarter: int, d: int, periodic: bool) -> tuple[int, int]:
    """The quarter in direction d, `OTHER` or `OFF`; and the cell in which it lies, -1 off the grid."""
    rows, cols = number.shape
    cell = cells[quarter >> 2]
    row = 2 * (cell // cols) + ((quarter >> 1) & 1) + _DOWN[d]
    col = 2 * (cell % cols) + (quarter & 1) + _ACROSS[d]
    if periodic:
        row, col = row % (2 * rows), col % (2 * cols)
    found, there = OFF, np.int64(-1)
    if row >= 0 and row < 2 * rows and col >= 0 and col < 2 * cols:
        there = (row >> 1) * cols + (col >> 1)
        k = np.int64(number[row >> 1, col >> 1])
        found = OTHER if k < 0 else 4 * k + 2 * (row & 1) + (col & 1)
    return found, there


@kernel
def _push(
    number: np.ndarray,
    cells: np.ndarray,
    periodic: bool,
    region: np.ndarray,
    depth: np.ndarray,
    queue: np.ndarray,
    first: int,
    tail: int,
    step: int,
) -> int:
    """Spread from the quarters of the queue on; its new end. Of several compartments the lowest counts."""
    n_directions = 8 if step % 2 == 0 else 4
    stop = tail
    for i in range(first, stop):
        for d in range(n_directions):
            near, _ = _beside(number, cells, queue[i], d, periodic)
            if near >= 0 and depth[near] == 0:
                depth[near] = step
                region[near] = region[queue[i]]
                queue[tail] = near
                tail += 1
            elif near >= 0 and depth[near] == step:
                region[near] = min(region[near], region[queue[i]])
    return tail


@kernel
def grow(number: np.ndarray, labels: np.ndarray, cells: np.ndarray, periodic: bool) -> tuple[np.ndarray, np.ndarray]:
    """Spread the compartments over the quarters, in steps over sides and over all eight neighbours in turn.

    Returns
    -------
    tuple
        (4 n,) int32 compartment of each quarter, of those that are as near the lowest, 0 where none comes; and (4 n,)
        int32 the steps taken to it.
    """
    size = 4 * cells.size
    region, depth = np.zeros(size, np.int32), np.zeros(size, np.int32)
    flat = labels.ravel()
    queue = np.empty(size, np.int64)
    first, tail = 0, 0
    # What the first two steps reach lies beside compartments: it looks for them.
    for step in range(1, 3):
        first = tail
        for quarter in range(size):
            if depth[quarter] > 0:
                continue
            least = np.int32(0)
            for d in range(4 * step):
                near, there = _beside(number, cells, quarter, d, periodic)
                label = np.int32(0)
                if near == OTHER:
                    label = flat[there]
                elif near >= 0 and 0 < depth[near] < step:
                    label = region[near]
                if label > 0 and (least == 0 or label < least):
                    least = label
            if least > 0:
                region[quarter] = least
                depth[quarter] = step
                queue[tail] = quarter
                tail += 1
    step = 3
    while first < tail:
        middle = _push(number, cells, periodic, region, depth, queue, first, tail, step)
        # Over the corners goes what was reached by either of the last two steps.
        tail = _push(number, cells, periodic, region, depth, queue, first, middle, step + 1)
        first, step = middle, step + 2
    return region, depth


@kernel
def _met(
    number: np.ndarray,
    labels: np.ndarray,
    cells: np.ndarray,
    region: np.ndarray,
    quarter: int,
    d: int,
    periodic: bool,
) -> tuple[int, int]:
    """Compartment that meets that of a quarter over a side, 0 for none; and the quarter in which it does."""
    near, there = _beside(number, cells, quarter, d, periodic)
    other = np.int64(0)
    if region[quarter] > 0 and near != OFF:
        # Between two cut quarters a meeting is found from the upper or left one.
        other = np.int64(labels.ravel()[there]) if near == OTHER else np.int64(region[near]) if d < 2 else other
    return (other if other != region[quarter] else np.int64(0)), near


@kernel
def meetings(
    number: np.ndarray, labels: np.ndarray, cells: np.ndarray, region: np.ndarray, periodic: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Sides of quarters over which two compartments meet.

    Parameters
    ----------
    region
        As `grow` returns it.

    Returns
    -------
    tuple
        (2, m) int64 the two quarters, the second `OTHER` where it is not cut; (2, m) int64 their compartments; and
        (m, 2, 2) int64 the ends of each side (x, y), in half cells from the upper left corner of the grid. They come
        side by side of a quarter, and in reading order.
    """
    n, cols = cells.size, number.shape[1]
    count = 0
    for quarter in range(4 * n):
        for d in range(4):
            other, _ = _met(number, labels, cells, region, quarter, d, periodic)
            count += other > 0
    both, regions = np.empty((2, count), np.int64), np.empty((2, count), np.int64)
    ends = np.empty((count, 2, 2), np.int64)
    m = 0
    for d in range(4):
        start = 0
        while start < n:
            row = cells[start] // cols
            stop = start
            while stop < n and cells[stop] // cols == row:
                stop += 1
            for half in range(2):
                for i in range(2 * start, 2 * stop):
                    quarter = 4 * (i >> 1) + 2 * half + (i & 1)
                    other, near = _met(number, labels, cells, region, quarter, d, periodic)
                    if other == 0:
                        continue
                    both[0, m], both[1, m] = quarter, near
                    regions[0, m], regions[1, m] = region[quarter], other
                    x = 2 * (cells[i >> 1] % cols) + (i & 1) + max(_ACROSS[d], 0)
                    y = 2 * row + half + max(_DOWN[d], 0)
                    ends[m, 0, 0], ends[m, 0, 1] = x, y
                    ends[m, 1, 0], ends[m, 1, 1] = x + abs(_DOWN[d]), y + abs(_ACROSS[d])
                    m += 1
            start = stop
    return both, regions, ends


@kernel
def descend(
    number: np.ndarray, cells: np.ndarray, depth: np.ndarray, seeds: np.ndarray, owners: np.ndarray, periodic: bool
) -> np.ndarray:
    """Stretch of each quarter that can be reached from a border by steps towards a compartment; -1 for others.

    Parameters
    ----------
    depth
        As `grow` returns it.
    seeds, owners
        (m,) int64 quarters at borders and the stretches of these; of several the lowest counts.
    """
    found = np.full(depth.size, -1, np.int64)
    level = np.zeros(depth.size, np.int32)
    queue = np.empty(depth.size, np.int64)
    tail = 0
    for i in range(seeds.size):
        if found[seeds[i]] < 0:
            queue[tail] = seeds[i]
            tail += 1
            found[seeds[i]] = owners[i]
        found[seeds[i]] = min(found[seeds[i]], owners[i])
    head = 0
    while head < tail:
        quarter = queue[head]
        head += 1
        for d in range(8):
            near, _ = _beside(number, cells, quarter, d, periodic)
            if near < 0 or depth[near] == 0 or depth[near] >= depth[quarter]:
                continue
            if found[near] < 0:
                found[near] = found[quarter]
                level[near] = level[quarter] + 1
                queue[tail] = near
                tail += 1
            elif level[near] == level[quarter] + 1:
                found[near] = min(found[near], found[quarter])
    return found
