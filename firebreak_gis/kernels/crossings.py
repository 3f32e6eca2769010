"""Links between neighbouring cells that straight pieces of lines cross, in whole numbers, so exactly.

Where a piece passes exactly through a centre or along a link, the centres count as moved to the east by next to
nothing, and to the south by next to nothing of that: every case is decided, the same way from both ends of a link, and
a line that closes a way on the map closes it on the lattice.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

#: Parts of a cell in which coordinates are told: 5 mm in cells of 20 m.
PARTS = 4096

_HALF = PARTS // 2


@inlined
def _beside(px: int, py: int, qx: int, qy: int, x: int, y: int) -> bool:
    """Whether a centre lies to the one side of the way from p to q, and not to the other."""
    turn = (qx - px) * (y - py) - (qy - py) * (x - px)
    if turn == 0:
        turn = py - qy
    if turn == 0:
        turn = qx - px
    return turn > 0


@inlined
def _ahead(ax: int, ay: int, bx: int, by: int, x: int, y: int) -> bool:
    """The same of a point and the link from centre a to centre b, both of which are moved."""
    turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    if turn == 0:
        turn = by - ay
    if turn == 0:
        turn = ax - bx
    return turn > 0


@kernel
def cross_links(
    pieces: np.ndarray, widths: np.ndarray, bits: np.ndarray, width: np.ndarray, first_piece: np.ndarray
) -> None:
    """Mark the links that pieces of lines cross.

    Parameters
    ----------
    pieces
        (n, 4) int64, x and y of both ends, from the north-western corner of the grid to the east and to the south, in
        parts of a cell (`PARTS`); within 2^30 of the corner.
    widths
        (n,) float32 of each piece.
    bits
        (rows, cols) uint8; bit d is set where the link to the neighbour in direction d is crossed, at both cells.
    width
        (rows, cols) float32; raised to the width of the widest piece across any link of the cell to a cell with a
        higher row-major number.
    first_piece
        (rows, cols) int64; where below 0, set to the number of the first piece across any of those links.
    """
    rows, cols = bits.shape
    steps = ((2, 0, 1), (3, 1, 1), (4, 1, 0), (5, 1, -1))
    for i in range(pieces.shape[0]):
        px, py, qx, qy = pieces[i, 0], pieces[i, 1], pieces[i, 2], pieces[i, 3]
        if px == qx and py == qy:
            continue
        top, bottom = min(py, qy), max(py, qy)
        first = max((top - _HALF) // PARTS - 1, 0)
        last = min((bottom - _HALF) // PARTS + 1, rows - 1)
        for row in range(first, last + 1):
            # Where the piece runs beside the links of this row, and a row more.
            west, east = min(px, qx), max(px, qx)
            if py != qy:
                slope = (qx - px) / (qy - py)
                one = px + slope * (min(max((row - 0.5) * PARTS, top), bottom) - py)
                other = px + slope * (min(max((row + 2.5) * PARTS, top), bottom) - py)
                west, east = max(west, int(min(one, other)) - PARTS), min(east, int(max(one, other)) + PARTS)
            for col in range(max((west - _HALF) // PARTS - 1, 0), min((east - _HALF) // PARTS + 2, cols - 1) + 1):
                ax, ay = col * PARTS + _HALF, row * PARTS + _HALF
                side = _beside(px, py, qx, qy, ax, ay)
                for d, down, right in steps:
                    to_row, to_col = row + down, col + right
                    if to_row >= rows or to_col >= cols or to_col < 0:
                        continue
                    bx, by = to_col * PARTS + _HALF, to_row * PARTS + _HALF
                    if side == _beside(px, py, qx, qy, bx, by):
                        continue
                    if _ahead(ax, ay, bx, by, px, py) != _ahead(ax, ay, bx, by, qx, qy):
                        bits[row, col] |= np.uint8(1 << d)
                        bits[to_row, to_col] |= np.uint8(1 << ((d + 4) & 7))
                        width[row, col] = max(width[row, col], widths[i])
                        if first_piece[row, col] < 0:
                            first_piece[row, col] = i
