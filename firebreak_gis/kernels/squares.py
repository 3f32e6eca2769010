"""Connected pieces of the fuel of a whole map, and of it within squares.

As `coarse.blocks` does for a patch, but in a plane of the map and in place, so that it takes next to nothing beside it.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel

#: Of cells whose block has no number yet.
UNNUMBERED = np.int32(-2)


@kernel
def number_blocks(
    label: np.ndarray,
    links: np.ndarray,
    row_step: np.ndarray,
    col_step: np.ndarray,
    factor: int,
) -> int:
    """Number the blocks of a map, square by square.

    Parameters
    ----------
    label
        (rows, cols) int32: `UNNUMBERED` where there is fuel, -1 elsewhere; set to the number of the block, from 0.
    links
        (rows, cols) uint8: bit d set where the cell is linked to its neighbour in direction d; links go both ways, and
        none leaves the map.
    row_step, col_step
        Steps of the directions.
    factor
        Side of the squares [cells].

    Returns
    -------
    int
        How many blocks there are.
    """
    rows, cols = label.shape
    queue = np.empty((factor * factor, 2), np.int32)
    count = 0
    for top in range(0, rows, factor):
        bottom = min(top + factor, rows)
        for left in range(0, cols, factor):
            right = min(left + factor, cols)
            for row in range(top, bottom):
                for col in range(left, right):
                    if label[row, col] != UNNUMBERED:
                        continue
                    label[row, col] = count
                    queue[0, 0], queue[0, 1] = row, col
                    head, tail = 0, 1
                    while head < tail:
                        r, c = queue[head]
                        head += 1
                        for d in range(8):
                            if (links[r, c] >> d) & 1:
                                down, across = r + row_step[d], c + col_step[d]
                                if (
                                    top <= down < bottom
                                    and left <= across < right
                                    and label[down, across] == UNNUMBERED
                                ):
                                    label[down, across] = count
                                    queue[tail, 0], queue[tail, 1] = down, across
                                    tail += 1
                    count += 1
    return count


@kernel
def number_pieces(label: np.ndarray, links: np.ndarray, row_step: np.ndarray, col_step: np.ndarray) -> int:
    """Number the connected pieces of a map in the order of their first cells; parameters as in `number_blocks`.

    Links may lead over the edge of a torus.
    """
    rows, cols = label.shape
    waiting = 0
    for row in range(rows):
        for col in range(cols):
            waiting += label[row, col] == UNNUMBERED
    stack = np.empty(waiting, np.int64)
    count = 0
    for first in range(rows * cols):
        if label[first // cols, first % cols] != UNNUMBERED:
            continue
        label[first // cols, first % cols] = count
        stack[0] = first
        top = 1
        while top > 0:
            top -= 1
            r, c = stack[top] // cols, stack[top] % cols
            for d in range(8):
                if (links[r, c] >> d) & 1:
                    down, across = (r + row_step[d]) % rows, (c + col_step[d]) % cols
                    if label[down, across] == UNNUMBERED:
                        label[down, across] = count
                        stack[top] = down * cols + across
                        top += 1
        count += 1
    return count
