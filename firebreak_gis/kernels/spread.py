"""The Alexandridis spread probability of every edge, in one pass over the grid."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH

_ROW_STEP = np.array(ROW_STEP, dtype=np.int64)
_COL_STEP = np.array(COL_STEP, dtype=np.int64)
_LENGTH = np.array(STEP_LENGTH)


@kernel
def fill_probability(
    flammability: np.ndarray,
    elevation: np.ndarray,
    burnable: np.ndarray,
    cell_size: float,
    slope_factor: float,
    wind: np.ndarray,
    first: int,
    last: int,
    periodic: bool,
    out: np.ndarray,
) -> None:
    """Set `out[:, first:last]`.

    Parameters
    ----------
    flammability
        (rows, cols) float64, p0 (1 + type) (1 + density) of the target cell.
    elevation
        (rows, cols) float64 [m].
    burnable
        (rows, cols) bool.
    cell_size
        [m]
    slope_factor
        a, per degree.
    wind
        (8, rows, cols) or (8, 1, 1) float64 factor of the wind at the burning cell.
    first, last
        Rows to do.
    out
        (8, rows, cols) float32.
    """
    rows, cols = burnable.shape
    uniform_wind = wind.shape[1] == 1
    for d in range(8):
        distance = cell_size * _LENGTH[d]
        for row in range(first, last):
            to_row = row + _ROW_STEP[d]
            if periodic:
                to_row = (to_row + rows) % rows
            inside = 0 <= to_row < rows
            for col in range(cols):
                to_col = col + _COL_STEP[d]
                if periodic:
                    to_col = (to_col + cols) % cols
                p = 0.0
                if inside and 0 <= to_col < cols and burnable[row, col] and burnable[to_row, to_col]:
                    rise = elevation[to_row, to_col] - elevation[row, col]
                    p = flammability[to_row, to_col]
                    p *= wind[d, 0, 0] if uniform_wind else wind[d, row, col]
                    if rise != 0.0 and slope_factor != 0.0:
                        p *= np.exp(slope_factor * np.degrees(np.arctan(rise / distance)))
                out[d, row, col] = min(p, 1.0)
