"""Lines widened to walls, cell by cell."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel


@kernel
def widened(
    lines: np.ndarray,
    ends: np.ndarray,
    down: np.ndarray,
    across: np.ndarray,
    rows: int,
    cols: int,
    periodic: bool,
    free: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Give each line the cells around it that no line before has.

    Parameters
    ----------
    lines
        (n,) int64 row-major cells of all lines, one after another.
    ends
        (n_lines,) int64, end of each line among them.
    down, across
        (k,) int64 steps from a cell of a line to the cells of its wall.
    rows, cols, periodic
        Of the grid, and whether it is a torus.
    free
        (rows * cols,) bool: cells that walls may have; those that they get are cleared.

    Returns
    -------
    tuple
        Cells of the walls, int64, a cell of a line before those that it brings along; and (n_lines,) int64, the end of
        each wall among them.
    """
    wall = np.empty(min(lines.size * down.size, int(free.sum())), np.int64)
    until = np.empty(ends.size, np.int64)
    filled, i = 0, 0
    for k in range(ends.size):
        while i < ends[k]:
            row, col = lines[i] // cols, lines[i] % cols
            for j in range(down.size):
                r, c = row + down[j], col + across[j]
                if periodic:
                    r, c = r % rows, c % cols
                elif r < 0 or r >= rows or c < 0 or c >= cols:
                    continue
                cell = r * cols + c
                if free[cell]:
                    free[cell] = False
                    wall[filled] = cell
                    filled += 1
            i += 1
        until[k] = filled
    return wall[:filled].copy(), until
