"""State of 64 fires at once, one bit a run, and how they spread.

The first time a cell burns in any run, its eight edges are drawn for all 64 runs, into one mask a direction. The
draws are those of `kernels.percolation`, so the results agree with it to the bit.

What costs afterwards is not the runs but how often a cell is visited, so fires are kept waiting until many can
go on together. The grid is swept down and up by tiles small enough for the second-level cache; a tile is swept
down and up by rows until nothing in it waits; a row is swept eastwards and westwards.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.bits import (
    highest,
    lowest,
    not_zero,
    swap_bytes,
    swap_halves,
    swap_pairs,
)
from firebreak_gis.kernels.draws import Thresholds, bytes_below, bytes_equal, word
from firebreak_gis.kernels.policy import kernel

#: At most 64: a bit a row.
TILE_ROWS = 64
#: At most 62: a bit a column and one for the neighbour on either side.
TILE_COLS = 62

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_ALL = ~_ZERO
_TILE_ROWS = np.uint64(TILE_ROWS)
_TILE_COLS = np.uint64(TILE_COLS)
_INSIDE = ((_ONE << _TILE_COLS) - _ONE) << _ONE
_ALL_BUT_TOP = _ALL >> _ONE


class Lanes(NamedTuple):
    """State of a block of runs: 81 bytes a cell, 93 with a curve. Made once, used for any number of blocks.

    Cells stand in a frame: one more row and column on each side, and padded to whole tiles. Outside the grid
    `done` is all ones, so that nothing there ever counts as newly burnt.

    Parameters
    ----------
    masks
        (8 * n_cells,) uint64: runs in which the edge of a cell in a direction is open; valid where `done`.
    lit
        (frame,) uint64: runs in which the cell has caught fire.
    done
        (frame,) uint64: runs in which it has passed the fire on. All ones while a cell is cut.
    columns
        (framed rows * framed tile columns,) uint64: columns of a row of a tile with `lit` but not `done` runs;
        bit 0 is the column west of the tile.
    rows
        (framed tiles,) uint64: rows of a tile with a column set; bit 0 is the first.
    buffer
        (320,) uint64: keys and draws of one cell.
    touched, counted, order
        For a curve, otherwise empty: as `rows` for rows visited since they were last counted; (frame,) uint64
        `done` as last counted; (n_cells,) uint32 cells from the highest level down.
    """

    masks: np.ndarray
    lit: np.ndarray
    done: np.ndarray
    columns: np.ndarray
    rows: np.ndarray
    buffer: np.ndarray
    touched: np.ndarray
    counted: np.ndarray
    order: np.ndarray


def lanes(shape: tuple[int, int], *, curve: bool = False) -> Lanes:
    """State for blocks of runs on a grid of (rows, cols).

    Parameters
    ----------
    shape
        (rows, cols).
    curve
        Whether it shall serve `curve_block` too.
    """
    rows, cols = shape
    tile_rows, tile_cols = -(-rows // TILE_ROWS), -(-cols // TILE_COLS)
    frame = (tile_rows * TILE_ROWS + 2, tile_cols * TILE_COLS + 2)
    tiles = (tile_rows + 2) * (tile_cols + 2)
    done = np.full(frame, _ALL)
    done[1 : rows + 1, 1 : cols + 1] = _ZERO
    return Lanes(
        masks=np.empty(8 * rows * cols, np.uint64),
        lit=np.zeros(frame[0] * frame[1], np.uint64),
        done=done.ravel(),
        columns=np.zeros(frame[0] * (tile_cols + 2), np.uint64),
        rows=np.zeros(tiles, np.uint64),
        buffer=np.empty(320, np.uint64),
        touched=np.zeros(tiles, np.uint64),
        counted=done.ravel().copy() if curve else np.empty(0, np.uint64),
        order=np.empty(rows * cols if curve else 0, np.uint32),
    )


# One long function: numba counts references in every call or inlined function that takes arrays and branches,
# which costs more than a cell does.
@kernel
def spread(thresholds: Thresholds, n_rows: np.uint64, n_cols: np.uint64, periodic: bool, state: Lanes) -> None:
    """Burn on until nothing waits: what is lit and not yet done, and marked in `state.columns` and `.rows`."""
    top, rest = thresholds.top, thresholds.rest
    masks, lit, done, buffer = state.masks, state.lit, state.done, state.buffer
    columns, rows, touched = state.columns, state.rows, state.touched
    tile_stride = (n_cols + _TILE_COLS - _ONE) // _TILE_COLS + np.uint64(2)
    stride = (tile_stride - np.uint64(2)) * _TILE_COLS + np.uint64(2)
    n_tiles = np.uint64(rows.shape[0])
    turn = _ZERO
    idle = _ZERO
    while idle < n_tiles * np.uint64(2):
        # All tiles forwards, then backwards, until nothing waited in any for a whole sweep.
        tile = turn if turn < n_tiles else n_tiles * np.uint64(2) - _ONE - turn
        turn = turn + _ONE if turn + _ONE < n_tiles * np.uint64(2) else _ZERO
        idle += _ONE
        if rows[tile] == _ZERO:
            continue
        idle = _ZERO
        tile_row = tile // tile_stride - _ONE
        tile_col = tile % tile_stride - _ONE
        first_col = tile_col * _TILE_COLS
        waiting = rows[tile]
        rows[tile] = _ZERO
        visited = _ZERO
        # Rows to set in the eight tiles around, by direction.
        north = _ZERO
        north_east = _ZERO
        east = _ZERO
        south_east = _ZERO
        south = _ZERO
        south_west = _ZERO
        west = _ZERO
        north_west = _ZERO
        local = _ZERO
        down = True
        while waiting != _ZERO:
            ahead = waiting & (_ALL << local) if down else waiting & (_ALL >> (np.uint64(63) - local))
            if ahead == _ZERO:
                down = not down
                continue
            local = lowest(ahead) if down else highest(ahead)
            waiting &= ~(_ONE << local)
            visited |= _ONE << local
            row = tile_row * _TILE_ROWS + local
            strip = (row + _ONE) * tile_stride + tile_col + _ONE
            # Bit k is column k - 1 of the tile, so that both neighbours have one.
            bits = columns[strip]
            columns[strip] = _ZERO
            base = (row + _ONE) * stride + first_col
            above = _ZERO
            below = _ZERO
            beyond_east = _ZERO
            beyond_west = _ZERO
            for side in range(2):
                # Eastwards, then westwards with bits in the opposite order.
                behind = _ZERO
                while bits != _ZERO:
                    j = lowest(bits)
                    bits &= bits - _ONE
                    k = j if side == 0 else np.uint64(63) - j
                    forward = _ONE if side == 0 else _ALL
                    onward = np.uint64(2) if side == 0 else np.uint64(6)
                    at = base + k
                    before = done[at]
                    fresh = lit[at] & ~before
                    cell = row * n_cols + first_col + k - _ONE
                    mask = cell * np.uint64(8)
                    if before == _ZERO:
                        # First fire here: draw all runs. Bit i of byte d of word g: run 8 g + i, direction d.
                        limit = top[cell]
                        for lane in range(64):
                            i = np.uint64(lane)
                            x = word(buffer[i], cell * np.uint64(4))
                            equal = bytes_equal(x, limit)
                            buffer[i + np.uint64(64)] = bytes_below(x, limit) >> (np.uint64(7) - (i >> np.uint64(3)))
                            buffer[i + np.uint64(128)] = np.uint64(equal != _ZERO) << (i >> np.uint64(3))
                            buffer[i + np.uint64(192)] = equal
                        for lane in range(8):
                            i = np.uint64(lane + 64)
                            buffer[i + np.uint64(192)] = (
                                buffer[i]
                                | buffer[i + np.uint64(8)]
                                | buffer[i + np.uint64(16)]
                                | buffer[i + np.uint64(24)]
                                | buffer[i + np.uint64(32)]
                                | buffer[i + np.uint64(40)]
                                | buffer[i + np.uint64(48)]
                                | buffer[i + np.uint64(56)]
                            )
                        for lane in range(8):
                            i = np.uint64(lane + 128)
                            buffer[i + np.uint64(136)] = (
                                buffer[i]
                                | buffer[i + np.uint64(8)]
                                | buffer[i + np.uint64(16)]
                                | buffer[i + np.uint64(24)]
                                | buffer[i + np.uint64(32)]
                                | buffer[i + np.uint64(40)]
                                | buffer[i + np.uint64(48)]
                                | buffer[i + np.uint64(56)]
                            )
                        # Transpose the 8 x 8 bytes: word d, byte g.
                        a0, a1, a2, a3 = buffer[256], buffer[257], buffer[258], buffer[259]
                        a4, a5, a6, a7 = buffer[260], buffer[261], buffer[262], buffer[263]
                        a0, a4 = swap_halves(a0, a4)
                        a1, a5 = swap_halves(a1, a5)
                        a2, a6 = swap_halves(a2, a6)
                        a3, a7 = swap_halves(a3, a7)
                        a0, a2 = swap_pairs(a0, a2)
                        a1, a3 = swap_pairs(a1, a3)
                        a4, a6 = swap_pairs(a4, a6)
                        a5, a7 = swap_pairs(a5, a7)
                        masks[mask], masks[mask + np.uint64(1)] = swap_bytes(a0, a1)
                        masks[mask + np.uint64(2)], masks[mask + np.uint64(3)] = swap_bytes(a2, a3)
                        masks[mask + np.uint64(4)], masks[mask + np.uint64(5)] = swap_bytes(a4, a5)
                        masks[mask + np.uint64(6)], masks[mask + np.uint64(7)] = swap_bytes(a6, a7)
                        undecided = _ZERO
                        for group in range(8):
                            undecided |= buffer[np.uint64(264 + group)] << np.uint64(8 * group)
                        # About two runs a cell need more digits; see draws.open_edges.
                        while undecided != _ZERO:
                            lane_bit = lowest(undecided)
                            undecided &= undecided - _ONE
                            i = ((lane_bit & np.uint64(7)) << np.uint64(3)) + (lane_bit >> np.uint64(3))
                            edges = buffer[i + np.uint64(192)]
                            opened = _ZERO
                            left = edges
                            certain = left & bytes_equal(limit, _ALL)
                            for digit in range(3):
                                x = word(buffer[i], cell * np.uint64(4) + np.uint64(digit + 1))
                                finer = rest[cell, np.uint64(digit)]
                                opened |= left & bytes_below(x, finer)
                                left &= bytes_equal(x, finer)
                                certain &= bytes_equal(finer, _ALL)
                            opened |= certain
                            while edges != _ZERO:
                                position = lowest(edges)
                                edges &= edges - _ONE
                                masks[mask + (position >> np.uint64(3))] |= ((opened >> position) & _ONE) << lane_bit
                    done[at] = before | fresh
                    # A cell is lit whether or not it is cut; it wakes only if it is there.
                    to = at + forward
                    v = fresh & masks[mask + onward]
                    lit[to] |= v
                    bits |= np.uint64((v & ~done[to]) != _ZERO) << (j + _ONE)
                    if side == 0:
                        beyond_east |= bits & ~_INSIDE
                        bits &= _INSIDE
                    else:
                        beyond_west |= bits & ~_ALL_BUT_TOP
                        bits &= _ALL_BUT_TOP
                    to = at - forward
                    v = fresh & masks[mask + (onward ^ np.uint64(4))]
                    lit[to] |= v
                    behind |= np.uint64((v & ~done[to]) != _ZERO) << ((np.uint64(64) - j) & np.uint64(63))
                    to = at - stride
                    v0 = fresh & masks[mask + np.uint64(7)]
                    v1 = fresh & masks[mask]
                    v2 = fresh & masks[mask + np.uint64(1)]
                    lit[to - _ONE] |= v0
                    lit[to] |= v1
                    lit[to + _ONE] |= v2
                    above |= not_zero(v0 & ~done[to - _ONE], v1 & ~done[to], v2 & ~done[to + _ONE]) << (k - _ONE)
                    to = at + stride
                    v0 = fresh & masks[mask + np.uint64(5)]
                    v1 = fresh & masks[mask + np.uint64(4)]
                    v2 = fresh & masks[mask + np.uint64(3)]
                    lit[to - _ONE] |= v0
                    lit[to] |= v1
                    lit[to + _ONE] |= v2
                    below |= not_zero(v0 & ~done[to - _ONE], v1 & ~done[to], v2 & ~done[to + _ONE]) << (k - _ONE)
                if side == 0:
                    beyond_west = behind & ~_ALL_BUT_TOP
                    bits = behind & _ALL_BUT_TOP
            # Hand on what has caught fire in the strips around.
            sets_east = (beyond_east >> (_TILE_COLS + _ONE)) & _ONE
            sets_west = beyond_west >> np.uint64(63)
            columns[strip + _ONE] |= sets_east << _ONE
            columns[strip - _ONE] |= sets_west << _TILE_COLS
            east |= sets_east << local
            west |= sets_west << local
            for side in range(2):
                bits = above if side == 0 else below
                to = strip - tile_stride if side == 0 else strip + tile_stride
                inside = np.uint64((bits & _INSIDE) != _ZERO)
                sets_west = bits & _ONE
                sets_east = (bits >> (_TILE_COLS + _ONE)) & _ONE
                columns[to] |= bits & _INSIDE
                columns[to - _ONE] |= sets_west << _TILE_COLS
                columns[to + _ONE] |= sets_east << _ONE
                if side == 0 and local == _ZERO:
                    north |= inside << (_TILE_ROWS - _ONE)
                    north_west |= sets_west << (_TILE_ROWS - _ONE)
                    north_east |= sets_east << (_TILE_ROWS - _ONE)
                elif side == 1 and local == _TILE_ROWS - _ONE:
                    south |= inside
                    south_west |= sets_west
                    south_east |= sets_east
                else:
                    neighbour = local - _ONE if side == 0 else local + _ONE
                    waiting |= inside << neighbour
                    west |= sets_west << neighbour
                    east |= sets_east << neighbour
        touched[tile] |= visited
        for d in range(8):
            if d == 0:
                bits, to = north, tile - tile_stride
            elif d == 1:
                bits, to = north_east, tile - tile_stride + _ONE
            elif d == 2:
                bits, to = east, tile + _ONE
            elif d == 3:
                bits, to = south_east, tile + tile_stride + _ONE
            elif d == 4:
                bits, to = south, tile + tile_stride
            elif d == 5:
                bits, to = south_west, tile + tile_stride - _ONE
            elif d == 6:
                bits, to = west, tile - _ONE
            else:
                bits, to = north_west, tile - tile_stride - _ONE
            rows[to] |= bits
        if periodic:
            # What left the grid stands in the frame; four sides, corners with the rows.
            end_row = min((tile_row + _ONE) * _TILE_ROWS, n_rows)
            end_col = min(first_col + _TILE_COLS, n_cols)
            for side in range(4):
                if side < 2:
                    beside = tile_row == _ZERO if side == 0 else end_row == n_rows
                    at = first_col if side == 0 else (n_rows + _ONE) * stride + first_col
                    step = _ONE
                    length = end_col - first_col + np.uint64(2)
                else:
                    beside = tile_col == _ZERO if side == 2 else end_col == n_cols
                    at = tile_row * _TILE_ROWS * stride + (_ZERO if side == 2 else n_cols + _ONE)
                    step = stride
                    length = end_row - tile_row * _TILE_ROWS + np.uint64(2)
                if not beside:
                    continue
                for _ in range(length):
                    arrived = lit[at]
                    if arrived != _ZERO:
                        lit[at] = _ZERO
                        row = (at // stride + n_rows - _ONE) % n_rows
                        col = (at % stride + n_cols - _ONE) % n_cols
                        home = (row + _ONE) * stride + col + _ONE
                        lit[home] |= arrived
                        if arrived & ~done[home] != _ZERO:
                            to_col = col // _TILE_COLS + _ONE
                            to = (row // _TILE_ROWS + _ONE) * tile_stride + to_col
                            columns[(row + _ONE) * tile_stride + to_col] |= _ONE << (col % _TILE_COLS + _ONE)
                            rows[to] |= _ONE << (row % _TILE_ROWS)
                    at += step
