"""Ridges of a terrain."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH


def uphill_area(height: np.ndarray) -> np.ndarray:
    """Cells from which steepest ascent leads through each cell, itself included.

    Parameters
    ----------
    height
        (rows, cols) float64. Of equally steep ways the first direction is taken; a cell without a higher neighbour
        ends the way.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64, whole numbers.
    """
    order = np.argsort(height, axis=None, kind="stable")
    area = np.ones(height.size)
    _climb(np.ascontiguousarray(height), order, np.array(ROW_STEP), np.array(COL_STEP), np.array(STEP_LENGTH), area)
    return area.reshape(height.shape)


@kernel
def _climb(
    height: np.ndarray,
    order: np.ndarray,
    row_step: np.ndarray,
    col_step: np.ndarray,
    length: np.ndarray,
    area: np.ndarray,
) -> None:
    rows, cols = height.shape
    for cell in order:
        row, col = cell // cols, cell % cols
        steepest, above = 0.0, -1
        for d in range(8):
            r, c = row + row_step[d], col + col_step[d]
            if 0 <= r < rows and 0 <= c < cols:
                slope = (height[r, c] - height[row, col]) / length[d]
                if slope > steepest:
                    steepest, above = slope, r * cols + c
        if above >= 0:
            area[above] += area[cell]
