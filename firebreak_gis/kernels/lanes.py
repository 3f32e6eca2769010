"""Sixty-four runs at once, one bit a run: burnt areas and whole curves. How they spread: `kernels.sweep`."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.bits import lowest, popcount
from firebreak_gis.kernels.draws import Thresholds
from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.kernels.sweep import TILE_COLS, TILE_ROWS, Lanes, lanes, spread

__all__ = ["LANES", "Lanes", "block_pays", "burn_block", "curve_block", "lanes"]

#: Runs in a block.
LANES = 64

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_ALL = ~_ZERO
_TILE_ROWS = np.uint64(TILE_ROWS)
_TILE_COLS = np.uint64(TILE_COLS)


def block_pays(counts: np.ndarray, sizes: np.ndarray, n_lanes: int, *, curve: bool = False) -> bool:
    """Whether the next `n_lanes` runs are faster in a block than one by one, judged by runs made before.

    A block costs about 12 ns a cell and 80 ns a cell that burns in any run, one by one costs about 12 ns more
    for each run in which a cell burns. In a curve, where fires grow level by level and fewer go on together, a
    block pays only if most cells burn in most runs. Both give the same numbers: a wrong guess costs time only.

    Parameters
    ----------
    counts
        (n_cells,) runs in which each cell burnt.
    sizes
        (n_runs,) cells burnt in each of those runs, at least one run.
    n_lanes
        1 .. 64.
    curve
        Whether curves are to be made; `sizes` are then those without any cut.
    """
    expected = float(sizes.mean()) * n_lanes
    return expected > counts.size + (30 if curve else 7) * int(np.count_nonzero(counts))


@kernel
def burn_block(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    starts: np.ndarray,
    cells: np.ndarray,
    first: int,
    last: int,
    state: Lanes,
    counts: np.ndarray,
    sizes: np.ndarray,
    ground: np.ndarray,
    spared: np.ndarray,
) -> None:
    """Burn runs `first` .. `last - 1`, at most 64, at once.

    Parameters
    ----------
    thresholds, keys, steps, starts, cells
        As in `kernels.percolation`.
    state
        From `lanes`; ready for the next block on return.
    counts, sizes, ground, spared
        As in `percolation.burn_runs`.
    """
    cols = steps.offsets[0, 4]
    rows = np.uint64(thresholds.top.shape[0]) // cols
    stride = (cols + _TILE_COLS - _ONE) // _TILE_COLS * _TILE_COLS + np.uint64(2)
    _light(keys, starts, cells, first, last, cols, state)
    spread(thresholds, rows, cols, steps.position.size > 0, state)
    spared[first:last] = 0
    # Sixty-four counters side by side: digit k of the counter of run i is bit i of digits[k].
    digits = np.zeros(48, np.uint64)
    lit, done = state.lit, state.done
    for row in range(rows):
        frame = (np.uint64(row) + _ONE) * stride + _ONE
        cell = np.uint64(row) * cols
        for col in range(cols):
            at = frame + np.uint64(col)
            carry = done[at]
            lit[at] = _ZERO
            done[at] = _ZERO
            counts[cell + np.uint64(col)] += np.uint32(popcount(carry))
            if ground.size > 0 and ground[cell + np.uint64(col)] > 0:
                burning = carry
                while burning != _ZERO:
                    spared[first + np.int64(lowest(burning))] += ground[cell + np.uint64(col)]
                    burning &= burning - _ONE
            for k in range(4):
                overflow = digits[k] & carry
                digits[k] ^= carry
                carry = overflow
            k = np.uint64(4)  # once in sixteen cells
            while carry != _ZERO:
                overflow = digits[k] & carry
                digits[k] ^= carry
                carry = overflow
                k += _ONE
    for run in range(first, last):
        sizes[run] = _total(digits, np.uint64(run - first))


@kernel
def curve_block(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    starts: np.ndarray,
    cells: np.ndarray,
    first: int,
    last: int,
    levels: np.ndarray,
    state: Lanes,
    burnt_at: np.ndarray,
) -> None:
    """Cells burnt at every cut level in runs `first` .. `last - 1`, at most 64, at once.

    All cells are cut at first. From the highest level down, the cells of a level are put back and the fires
    that stood before them go on: what burns at a level burns at all lower ones.

    Parameters
    ----------
    thresholds, keys, steps, starts, cells
        As in `kernels.percolation`.
    levels, burnt_at
        As in `percolation.burn_curve`.
    state
        From `lanes` with `curve`; ready for the next block on return.
    """
    cols = steps.offsets[0, 4]
    n_cells = np.uint64(thresholds.top.shape[0])
    rows = n_cells // cols
    tile_cols = (cols + _TILE_COLS - _ONE) // _TILE_COLS
    stride = tile_cols * _TILE_COLS + np.uint64(2)
    tile_stride = tile_cols + np.uint64(2)
    n_levels = np.uint64(burnt_at.shape[1])
    lit, done, counted, order = state.lit, state.done, state.counted, state.order
    ends = np.zeros(n_levels + _ONE, np.uint64)
    for cell in range(n_cells):
        if levels[np.uint64(cell)] >= 0:
            ends[n_levels - _ONE - np.uint64(levels[np.uint64(cell)])] += _ONE
    total = _ZERO
    for k in range(n_levels):
        here = ends[np.uint64(k)]
        ends[np.uint64(k)] = total
        total += here
    for cell in range(n_cells):
        at = (np.uint64(cell) // cols + _ONE) * stride + np.uint64(cell) % cols + _ONE
        done[at] = _ALL
        counted[at] = _ALL
        if levels[np.uint64(cell)] >= 0:
            k = n_levels - _ONE - np.uint64(levels[np.uint64(cell)])
            order[ends[k]] = np.uint32(cell)
            ends[k] += _ONE
    _light(keys, starts, cells, first, last, cols, state)
    # Nothing can burn yet: what was lit wakes when its level is put back.
    state.rows[:] = _ZERO
    state.columns[:] = _ZERO
    digits = np.zeros(48, np.uint64)
    begin = _ZERO
    for k in range(n_levels):
        for i in range(begin, ends[np.uint64(k)]):
            row = np.uint64(order[np.uint64(i)]) // cols
            col = np.uint64(order[np.uint64(i)]) % cols
            at = (row + _ONE) * stride + col + _ONE
            done[at] = _ZERO
            counted[at] = _ZERO
            if lit[at] != _ZERO:
                tile = col // _TILE_COLS + _ONE
                state.columns[(row + _ONE) * tile_stride + tile] |= _ONE << (col % _TILE_COLS + _ONE)
                state.rows[(row // _TILE_ROWS + _ONE) * tile_stride + tile] |= _ONE << (row % _TILE_ROWS)
        begin = ends[np.uint64(k)]
        spread(thresholds, rows, cols, steps.position.size > 0, state)
        _count(cols, state, digits)
        for run in range(first, last):
            burnt_at[run, n_levels - _ONE - np.uint64(k)] = _total(digits, np.uint64(run - first))
    for row in range(rows):
        at = (np.uint64(row) + _ONE) * stride + _ONE
        lit[at : at + cols] = _ZERO
        done[at : at + cols] = _ZERO


@kernel
def _total(digits: np.ndarray, lane: np.uint64) -> int:
    """Counter of `lane` in 48 bit-sliced `digits`."""
    total = np.int64(0)
    for k in range(48):
        total |= np.int64((digits[k] >> lane) & _ONE) << np.int64(k)
    return total


@kernel
def _light(
    keys: np.ndarray, starts: np.ndarray, cells: np.ndarray, first: int, last: int, cols: np.uint64, state: Lanes
) -> None:
    """Light the ignitions and store the keys of a block."""
    tile_stride = (cols + _TILE_COLS - _ONE) // _TILE_COLS + np.uint64(2)
    stride = (tile_stride - np.uint64(2)) * _TILE_COLS + np.uint64(2)
    for lane in range(64):
        # In the order in which eight draws at a time give the bytes of a mask; spare lanes repeat the last run.
        state.buffer[8 * (lane % 8) + lane // 8] = keys[min(first + lane, last - 1)]
    for run in range(first, last):
        for i in range(starts[run], starts[run + 1]):
            if cells[i] >= 0:
                row = np.uint64(cells[i]) // cols
                col = np.uint64(cells[i]) % cols
                tile = col // _TILE_COLS + _ONE
                state.lit[(row + _ONE) * stride + col + _ONE] |= _ONE << np.uint64(run - first)
                state.columns[(row + _ONE) * tile_stride + tile] |= _ONE << (col % _TILE_COLS + _ONE)
                state.rows[(row // _TILE_ROWS + _ONE) * tile_stride + tile] |= _ONE << (row % _TILE_ROWS)


@kernel
def _count(cols: np.uint64, state: Lanes, digits: np.ndarray) -> None:
    """Add what burnt since the last count to 64 bit-sliced counters."""
    tile_stride = (cols + _TILE_COLS - _ONE) // _TILE_COLS + np.uint64(2)
    stride = (tile_stride - np.uint64(2)) * _TILE_COLS + np.uint64(2)
    done, counted, touched = state.done, state.counted, state.touched
    for t in range(touched.shape[0]):
        tile = np.uint64(t)
        waiting = touched[tile]
        touched[tile] = _ZERO
        while waiting != _ZERO:
            row = (tile // tile_stride - _ONE) * _TILE_ROWS + lowest(waiting)
            waiting &= waiting - _ONE
            begin = (row + _ONE) * stride + (tile % tile_stride - _ONE) * _TILE_COLS + _ONE
            for i in range(TILE_COLS):
                at = begin + np.uint64(i)
                carry = done[at] & ~counted[at]
                if carry != _ZERO:
                    counted[at] = done[at]
                    k = _ZERO
                    while carry != _ZERO:
                        overflow = digits[k] & carry
                        digits[k] ^= carry
                        carry = overflow
                        k += _ONE
