"""Patches of cells: their links, and the pieces that a wall leaves of them.

A patch is given by `near`, (n, 8) int32: number of the linked cell in each direction within the patch, -1 for none.
Links go both ways.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel


@kernel
def placed(
    cells: np.ndarray, rows: int, cols: int, row_step: np.ndarray, col_step: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Positions of the cells of a patch in the smallest rectangle around it, for steps without a look at its border.

    Returns
    -------
    tuple
        The rectangle with a margin of one cell, flat, int32: number of the cell in the patch, -1 for none; where each
        cell of the patch lies in it, (n,) int32; and the steps to the eight neighbours. Where the rectangle is as high
        or as wide as the grid the margin holds the cells of the other border, for grids that are a torus.
    """
    n = cells.size
    top, bottom, left, right = rows, -1, cols, -1
    for i in range(n):
        row, col = cells[i] // cols, cells[i] % cols
        top, bottom = min(top, row), max(bottom, row)
        left, right = min(left, col), max(right, col)
    high, wide = max(bottom - top + 1, 0), max(right - left + 1, 0)
    local = np.full((high + 2, wide + 2), -1, np.int32)
    at = np.empty(n, np.int32)
    for i in range(n):
        row, col = cells[i] // cols - top + 1, cells[i] % cols - left + 1
        local[row, col] = i
        at[i] = row * (wide + 2) + col
    if high == rows:
        local[0], local[high + 1] = local[high], local[1]
    if wide == cols:
        local[:, 0], local[:, wide + 1] = local[:, wide], local[:, 1]
    return local.ravel(), at, row_step * (wide + 2) + col_step


@kernel
def patch_links(
    cells: np.ndarray, links: np.ndarray, rows: int, cols: int, row_step: np.ndarray, col_step: np.ndarray
) -> np.ndarray:
    """Neighbours within a patch.

    Parameters
    ----------
    cells
        (n,) int64 row-major cell numbers.
    links
        (rows * cols,) uint8: bit d set where the cell is linked to its neighbour in direction d.

    Returns
    -------
    numpy.ndarray
        `near`.
    """
    local, at, steps = placed(cells, rows, cols, row_step, col_step)
    near = np.full((cells.size, 8), -1, np.int32)
    for i in range(cells.size):
        for d in range(8):
            if (links[cells[i]] >> d) & 1:
                near[i, d] = local[at[i] + steps[d]]
    return near


@kernel
def pieces_after(near: np.ndarray, cut: np.ndarray) -> np.ndarray:
    """Number of the connected piece of every cell once `cut` is removed, (n,) int32; -1 in the cut."""
    n = near.shape[0]
    label = np.full(n, -1, np.int32)
    queue = np.empty(n, np.int32)
    count = 0
    for start in range(n):
        if label[start] >= 0 or cut[start] != 0:
            continue
        label[start] = count
        queue[0] = start
        head, tail = 0, 1
        while head < tail:
            v = queue[head]
            head += 1
            for d in range(8):
                u = near[v, d]
                if u >= 0 and label[u] < 0 and cut[u] == 0:
                    label[u] = count
                    queue[tail] = u
                    tail += 1
        count += 1
    return label


@kernel
def thin(near: np.ndarray, cut: np.ndarray) -> None:
    """Clear `cut` in the cells that join no two pieces; minimum cuts hold such cells only where cutting is free."""
    label = pieces_after(near, cut)
    fresh = near.shape[0]
    again = True
    while again:
        again = False
        for least in (1, 0):  # a cell inside the wall is left last, as a piece of its own
            for v in range(near.shape[0]):
                if cut[v] == 0 or (again and least == 0):
                    continue
                own, several = -1, False
                for d in range(8):
                    u = near[v, d]
                    if u >= 0 and cut[u] == 0:
                        several |= own >= 0 and label[u] != own
                        own = label[u]
                if not several and (own >= 0 or least == 0):
                    cut[v] = 0
                    label[v] = own if own >= 0 else fresh
                    fresh += 1
                    again = True
