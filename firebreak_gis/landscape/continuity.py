"""Density from the continuity of the fuel, where no map of density exists."""

from __future__ import annotations

import numpy as np

#: In place of a density raster or class.
CONTINUITY = "continuity"
#: Side of the square about each cell, in cells.
WINDOW = 7
#: Shares of cells with fuel from which vegetation counts as normal and as dense.
NORMAL_FROM, DENSE_FROM = 0.5, 0.9


def density_by_continuity(fuel: np.ndarray) -> np.ndarray:
    """Return density classes by the share of cells with fuel in the square of 7 x 7 cells about each cell.

    Below a half sparse, below nine tenths normal, else dense. Beyond the edge of the map nothing is counted. Cost:
    one pass.

    Parameters
    ----------
    fuel
        (rows, cols) bool, where something grows that burns.

    Returns
    -------
    numpy.ndarray
        (rows, cols) uint8: 1 sparse, 2 normal, 3 dense, also where there is no fuel.
    """
    share = _window_sum(fuel.astype(np.int32)) / _window_sum(np.ones(fuel.shape, np.int32))
    return np.where(share < NORMAL_FROM, 1, np.where(share < DENSE_FROM, 2, 3)).astype(np.uint8)


def _window_sum(values: np.ndarray) -> np.ndarray:
    """Sum over the square about each cell, by differences of running sums."""
    half = WINDOW // 2
    for axis in (0, 1):
        before = [(0, 0), (0, 0)]
        before[axis] = (half + 1, half)
        padded = np.cumsum(np.pad(values, before), axis=axis, dtype=np.int32)
        size = values.shape[axis]
        values = padded.take(range(WINDOW, WINDOW + size), axis) - padded.take(range(size), axis)
    return values
