"""Directed bond percolation on the grid, run by run: one fire, and its whole curve in one pass.

`kernels.lanes` does the same for 64 runs at once. All read the same draws (`kernels.draws`), so they agree to the
bit. Common arguments:

thresholds
    `draws.Thresholds`. Edges that leave an open grid have threshold 0 and never open, which is why no kernel
    tests for the border of an open grid.
keys
    (n_runs,) uint64 from `draws.run_keys`.
steps
    `Steps` of the grid. Cell numbers are unsigned in all loops: numba tests a signed index for negative
    values, which costs more than the rest of the step.
starts, cells
    Ignitions of run i are ``cells[starts[i]:starts[i + 1]]``; -1 burns nothing.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.draws import Thresholds, open_edges
from firebreak_gis.kernels.policy import inlined, kernel
from firebreak_gis.kernels.prefetch import AHEAD, prefetch
from firebreak_gis.lattice import COL_STEP, ROW_STEP

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_AHEAD = np.uint64(AHEAD)
#: `ground` and `spared` where nothing is to be added up.
NOTHING_SPARED = np.zeros(0, np.int64), np.zeros(0, np.int64)


class Steps(NamedTuple):
    """Steps between row-major cell numbers.

    Parameters
    ----------
    offsets
        (9, 8) uint64, two's complement: step in each direction for each position of a cell, 3 * (0 inside, 1
        first row, 2 last row) + (0 inside, 1 first column, 2 last column).
    position
        (n_cells,) uint8 position of each cell of a periodic grid; empty for an open one, where edges across
        the border never open and every cell counts as inside.
    first, shift, skip
        Where the grid is a window of a larger map: `number` of its first cell there, the binary logarithm of its
        columns, and the columns of the map beside it. Draws belong to the cells of the map, so that a window and the
        whole have the same fires.
    """

    offsets: np.ndarray
    position: np.ndarray
    first: np.uint64
    shift: np.uint64
    skip: np.uint64


@inlined
def number(steps: Steps, cell: np.uint64) -> np.uint64:
    """Number of a cell on the whole map, of which the grid may be a window."""
    return steps.first + cell + (cell >> steps.shift) * steps.skip


def steps(shape: tuple[int, int], *, periodic: bool, corner: int = 0, map_cols: int | None = None) -> Steps:
    """Steps of a grid of (rows, cols).

    Parameters
    ----------
    periodic
        Whether the grid is a torus.
    corner, map_cols
        If it is a window of a larger map: number of its first cell there, and the columns of the map. Then it has as
        many columns as the map, or a power of two.
    """
    rows, cols = shape
    dr, dc = np.array(ROW_STEP), np.array(COL_STEP)
    offsets = np.empty((9, 8), np.int64)
    for row_position, row_wrap in enumerate((0, rows, -rows)):
        for col_position, col_wrap in enumerate((0, cols, -cols)):
            crosses_row = (dr == -1) if row_position == 1 else (dr == 1) & (row_position == 2)
            crosses_col = (dc == -1) if col_position == 1 else (dc == 1) & (col_position == 2)
            offsets[3 * row_position + col_position] = (
                (dr + row_wrap * crosses_row) * cols + dc + col_wrap * crosses_col
            )
    position = np.zeros(0, np.uint8)
    if periodic:
        plane = np.zeros(shape, np.uint8)
        plane[0] += 3
        plane[-1] += 6
        plane[:, 0] += 1
        plane[:, -1] += 2
        position = plane.ravel()
    skip = 0 if map_cols is None else map_cols - cols
    if skip and cols & (cols - 1):
        raise ValueError(f"a window has {cols} columns, expected a power of two or all {map_cols} of the map")
    shift = cols.bit_length() - 1 if skip else 63
    return Steps(offsets.astype(np.uint64), position, np.uint64(corner), np.uint64(shift), np.uint64(skip))


@kernel
def burn_runs(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    starts: np.ndarray,
    cells: np.ndarray,
    first: int,
    last: int,
    counts: np.ndarray,
    sizes: np.ndarray,
    value: np.ndarray,
    lost: np.ndarray,
    ground: np.ndarray,
    spared: np.ndarray,
) -> None:
    """Burn runs `first` .. `last - 1` one after another. Memory: 5 bytes a cell.

    Parameters
    ----------
    counts
        (n_cells,) uint32, increased by one for each run in which the cell burns.
    sizes
        (n_runs,) int64, set to the cells burnt.
    value
        (n_cells,) float64 lost when the cell burns; empty if nothing is to be added up.
    lost
        (n_runs,) float64, set to the sum over the burnt cells, added in the order in which they burn.
    ground
        (n_cells,) int64, what of the cell does not burn with it; empty if nothing is to be added up.
    spared
        (n_runs,) int64, set to the sum over the burnt cells.
    """
    # Arrays by plain names: numba counts their holders at each look-up in a tuple.
    top, rest, offsets, positions = thresholds.top, thresholds.rest, steps.offsets, steps.position
    n_cells = top.shape[0]
    stamp = np.zeros(n_cells, np.uint8)
    queue = np.empty(n_cells + 1, np.uint32)
    periodic = positions.size > 0
    below = offsets[0, 4]
    mark = np.uint8(0)
    for run in range(first, last):
        if mark == np.uint8(255):
            stamp[:] = np.uint8(0)
            mark = np.uint8(0)
        mark = np.uint8(mark + np.uint8(1))
        key = keys[run]
        tail = _ZERO
        for i in range(starts[run], starts[run + 1]):
            if cells[i] >= 0 and stamp[cells[i]] != mark:
                stamp[cells[i]] = mark
                queue[tail] = cells[i]
                tail += _ONE
        head = _ZERO
        while head < tail:
            cell = np.uint64(queue[head])
            coming = np.uint64(queue[min(head + _AHEAD, tail)])
            prefetch(top, coming)
            prefetch(counts, coming)
            prefetch(stamp, coming - below)
            prefetch(stamp, coming + below)
            head += _ONE
            counts[cell] += np.uint32(1)
            opened = open_edges(key, cell, top[cell], rest)
            position = np.uint8(0)
            if periodic:
                position = positions[cell]
            # No branch in this loop: a closed edge leads back to the cell itself, which is stamped.
            for d in range(8):
                is_open = (opened >> np.uint64(8 * d + 7)) & _ONE
                target = cell + offsets[position, d] * is_open
                queue[tail] = np.uint32(target)
                tail += np.uint64(stamp[target] != mark)
                stamp[target] = mark
        sizes[run] = tail
        if value.size > 0:
            total = 0.0
            for i in range(tail):
                total += value[queue[i]]
            lost[run] = total
        if ground.size > 0:
            spared[run] = 0
            for i in range(tail):
                spared[run] += ground[queue[i]]


@kernel
def burn_curve(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    starts: np.ndarray,
    cells: np.ndarray,
    first: int,
    last: int,
    levels: np.ndarray,
    burnt_at: np.ndarray,
) -> None:
    """Cells burnt at every cut level, one pass a run (a widest-path problem).

    A cell of level q is still there at cut levels 0 .. q. The largest cut level at which a cell burns is the
    widest path to it over open edges; cells are settled from the highest level down, and each is final when
    first touched. Memory: 12 bytes a cell.

    Parameters
    ----------
    levels
        (n_cells,) int32 in -1 .. n_levels - 1; -1: cut at every level.
    burnt_at
        (n_runs, n_levels) int64; row `run` is set to the cells burnt at each cut level.
    """
    top, rest, offsets, positions = thresholds.top, thresholds.rest, steps.offsets, steps.position
    n_cells = top.shape[0]
    n_levels = burnt_at.shape[1]
    periodic = positions.size > 0
    below = offsets[0, 4]
    nobody = np.uint32(0xFFFFFFFF)
    # Level + 1 while the cell has not caught fire, else 0.
    standing = (levels + 1).astype(np.uint32)
    queue = np.empty(n_cells + 1, np.uint32)
    later = np.empty(n_cells, np.uint32)  # next cell that waits for the same level
    waiting = np.full(n_levels + 1, nobody, np.uint32)
    for run in range(first, last):
        key = keys[run]
        for i in range(starts[run], starts[run + 1]):
            if cells[i] >= 0:
                cell = np.uint64(cells[i])
                level = np.uint64(standing[cell])
                if level > _ZERO:
                    standing[cell] = np.uint32(0)
                    later[cell] = waiting[level]
                    waiting[level] = np.uint32(cell)
        head = _ZERO
        tail = _ZERO
        for step in range(n_levels):
            here = np.uint64(n_levels - step)
            while waiting[here] != nobody:
                cell = np.uint64(waiting[here])
                waiting[here] = later[cell]
                queue[tail] = np.uint32(cell)
                tail += _ONE
            while head < tail:
                cell = np.uint64(queue[head])
                coming = np.uint64(queue[min(head + _AHEAD, tail)])
                prefetch(top, coming)
                prefetch(standing, coming - below)
                prefetch(standing, coming)
                prefetch(standing, coming + below)
                prefetch(later, coming)
                head += _ONE
                opened = open_edges(key, cell, top[cell], rest)
                position = np.uint8(0)
                if periodic:
                    position = positions[cell]
                for d in range(8):
                    is_open = (opened >> np.uint64(8 * d + 7)) & _ONE
                    target = cell + offsets[position, d] * is_open
                    level = np.uint64(standing[target])
                    standing[target] = np.uint32(0)
                    queue[tail] = np.uint32(target)
                    tail += np.uint64(level >= here)
                    if (level < here) & (level > _ZERO):
                        later[target] = waiting[level]
                        waiting[level] = np.uint32(target)
            burnt_at[run, here - _ONE] = tail
        for i in range(tail):
            cell = np.uint64(queue[np.uint64(i)])
            standing[cell] = np.uint32(levels[cell] + 1)
