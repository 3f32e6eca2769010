"""A patch seen coarsely, and the part of it in which a coarse cut is made exact.

The patch is a set of cells given by their row-major numbers, linked as `flow.patch_links` links them. Its blocks are
the connected pieces of it within squares of `factor` x `factor` cells of the grid, so that a river that parts a square
parts it coarsely, too.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.patches import placed
from firebreak_gis.kernels.policy import kernel


@kernel
def blocks(
    cells: np.ndarray,
    links: np.ndarray,
    rows: int,
    cols: int,
    row_step: np.ndarray,
    col_step: np.ndarray,
    factor: int,
) -> tuple[np.ndarray, np.ndarray]:
    """Part a patch into blocks, and link them.

    Parameters
    ----------
    cells, links, rows, cols, row_step, col_step
        As in `flow.patch_links`.
    factor
        Side of the squares [cells].

    Returns
    -------
    tuple
        Number of the block of each cell, (n,) int32, and their links, (n_blocks, 8) int32 as `near` of `flow`. Of
        several blocks in one direction one is linked, about that to which most links lead; links go both ways.
    """
    local, at, steps = placed(cells, rows, cols, row_step, col_step)
    n = cells.size
    square = np.empty(n, np.int32)
    for v in range(n):
        square[v] = cells[v] // cols // factor * (cols // factor + 1) + cells[v] % cols // factor
    label = np.full(n, -1, np.int32)
    queue = np.empty(n, np.int32)
    count = 0
    for start in range(n):
        if label[start] >= 0:
            continue
        label[start] = count
        queue[0] = start
        head, tail = 0, 1
        while head < tail:
            v = queue[head]
            head += 1
            for d in range(8):
                u = local[at[v] + steps[d]] if (links[cells[v]] >> d) & 1 else -1
                if u >= 0 and label[u] < 0 and square[u] == square[start]:
                    label[u] = count
                    queue[tail] = u
                    tail += 1
        count += 1
    found = np.full((count, 8), -1, np.int32)
    votes = np.zeros((count, 8), np.int32)
    for v in range(n):
        for d in range(8):
            u = local[at[v] + steps[d]] if (links[cells[v]] >> d) & 1 else -1
            if u < 0 or label[u] == label[v]:
                continue
            row, col = cells[v] // cols, cells[v] % cols
            down = (cells[u] // cols // factor - row // factor) * (1 if abs(cells[u] // cols - row) <= 1 else -1)
            across = (cells[u] % cols // factor - col // factor) * (1 if abs(cells[u] % cols - col) <= 1 else -1)
            for k in range(8):
                if row_step[k] == np.sign(down) and col_step[k] == np.sign(across):
                    # A vote in which each link cancels one for another block.
                    if found[label[v], k] == label[u]:
                        votes[label[v], k] += 1
                    elif votes[label[v], k] == 0:
                        found[label[v], k] = label[u]
                        votes[label[v], k] = 1
                    else:
                        votes[label[v], k] -= 1
    near = np.full((count, 8), -1, np.int32)
    for v in range(count):
        for k in range(8):
            u = found[v, k]
            if u >= 0 and found[u, (k + 4) & 7] == v:
                near[v, k] = u
    return label, near


@kernel
def band(
    cells: np.ndarray,
    side: np.ndarray,
    links: np.ndarray,
    rows: int,
    cols: int,
    row_step: np.ndarray,
    col_step: np.ndarray,
    width: int,
) -> np.ndarray:
    """Cells near the seam of two sides.

    Parameters
    ----------
    cells, links, rows, cols, row_step, col_step
        As in `flow.patch_links`.
    side
        (n,) uint8: 0 in the seam, else the number of the side; sides may touch.
    width
        Steps from the seam, or from where sides touch, to which the band reaches.

    Returns
    -------
    numpy.ndarray
        (n,) uint8: 1 in the band, 2 in the cells around it.
    """
    local, at, steps = placed(cells, rows, cols, row_step, col_step)
    n = cells.size
    found = np.zeros(n, np.uint8)
    queue = np.empty(n, np.int32)
    tail = 0
    for v in range(n):
        seam = side[v] == 0
        if not seam:
            for d in range(8):
                u = local[at[v] + steps[d]] if (links[cells[v]] >> d) & 1 else -1
                if u >= 0 and side[u] != 0 and side[u] != side[v]:
                    seam = True
                    break
        if seam:
            found[v] = 1
            queue[tail] = v
            tail += 1
    head = 0
    for step in range(width + 1):
        mark = np.uint8(1 if step < width else 2)
        stop = tail
        while head < stop:
            v = queue[head]
            head += 1
            for d in range(8):
                u = local[at[v] + steps[d]] if (links[cells[v]] >> d) & 1 else -1
                if u >= 0 and found[u] == 0:
                    found[u] = mark
                    queue[tail] = u
                    tail += 1
    return found
