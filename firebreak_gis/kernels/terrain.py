"""Ridges and slopes of a terrain."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH
from firebreak_gis.progress import silent
from firebreak_gis.threads import run_pieces

#: Cells whose slopes are found together.
_TOGETHER = 250_000


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


def horn_slope(height: np.ndarray, cell_size: float) -> np.ndarray:
    """Slope by Horn's weights of the eight neighbours, as GIS programs compute it.

    Parameters
    ----------
    height
        (rows, cols) float64 [m], NaN where unknown.
    cell_size
        Side of a cell [m].

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64 [degrees]. Beside an unknown neighbour, and at the edge, the step to the other side counts
        twice; of the three rows (columns) of neighbours those count in which a step is known. NaN where the height is
        unknown, or no step in one of the two directions is known; a single row or column has no slope across.

    Notes
    -----
    Horn 1981, doi 10.1109/PROC.1981.11918. Cost: one pass.
    """
    rows, cols = height.shape
    out = np.empty(height.shape)
    step = max(_TOGETHER // cols, 1)

    def work(first: int) -> None:
        stop, top = min(first + step, rows), max(first - 1, 0)
        part = height[top : stop + 1]
        slope = np.degrees(np.arctan(np.hypot(_rise(part, 1), _rise(part, 0)) / (2.0 * cell_size)))
        out[first:stop] = np.where(np.isnan(part), np.nan, slope)[first - top : stop - top]

    run_pieces(work, range(0, rows, step), threads=None, progress=silent, message="slopes")
    return out


def _rise(height: np.ndarray, axis: int) -> np.ndarray:
    """Rise over two cells along an axis, averaged over three rows (columns) with the weights 1, 2, 1."""
    if height.shape[axis] == 1:
        return np.zeros(height.shape)
    lines = np.moveaxis(height, axis, 1)
    beyond = np.pad(lines, ((0, 0), (1, 1)), constant_values=np.nan)
    ahead, behind = beyond[:, 2:] - lines, lines - beyond[:, :-2]
    two = np.where(np.isnan(behind), 2.0 * ahead, np.where(np.isnan(ahead), 2.0 * behind, ahead + behind))
    # Where the line itself is not known both ends still may be.
    two = np.where(np.isnan(two), beyond[:, 2:] - beyond[:, :-2], two)
    padded = np.pad(two, ((1, 1), (0, 0)), constant_values=np.nan)
    total, weights = np.zeros(lines.shape), np.zeros(lines.shape)
    for first, weight in ((0, 1.0), (1, 2.0), (2, 1.0)):
        part = padded[first : first + lines.shape[0]]
        known = ~np.isnan(part)
        total += np.where(known, weight * part, 0.0)
        weights += weight * known
    rise = np.divide(total, weights, out=np.full(lines.shape, np.nan), where=weights > 0)
    return np.moveaxis(rise, 1, axis)


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
