"""The time that fire takes along every edge, from a rate of spread, in one pass over the grid."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, LONGEST, NEVER, ROW_STEP, STEP_LENGTH

_ROW_STEP = np.array(ROW_STEP, dtype=np.int64)
_COL_STEP = np.array(COL_STEP, dtype=np.int64)
_LENGTH = np.array(STEP_LENGTH)
_NEVER = np.uint32(NEVER)
_LONGEST = float(LONGEST)


class Limits(NamedTuple):
    """Constants of the formula.

    Parameters
    ----------
    slope, slope_power
        Effect of slope: exp(+-slope |tan|^slope_power).
    factor_least, factor_greatest
        Between which the factor of slope stays.
    rate_least, rate_greatest
        Between which the rate of spread stays [m/s].
    """

    slope: float
    slope_power: float
    factor_least: float
    factor_greatest: float
    rate_least: float
    rate_greatest: float


@kernel
def fill_travel_time(
    probability: np.ndarray,
    base: np.ndarray,
    wind: np.ndarray,
    elevation: np.ndarray,
    cell_size: float,
    limits: Limits,
    first: int,
    last: int,
    out: np.ndarray,
) -> None:
    """Set `out[:, first:last]`.

    Parameters
    ----------
    probability
        (8, rows, cols) float32; edges with p > 0 get a time. Those that leave the grid lead to its other side.
    base
        (rows, cols) float64, rate of spread of the burning cell on flat calm ground [m/s].
    wind
        (8, rows, cols) or (8, 1, 1) float64 factor of the wind at the burning cell.
    elevation
        (rows, cols) float64 [m].
    cell_size
        [m]
    limits
        The constants.
    first, last
        Rows to do.
    out
        (8, rows, cols) uint32 [s], `lattice.NEVER` where there is no edge.
    """
    rows, cols = base.shape
    uniform_wind = wind.shape[1] == 1
    for d in range(8):
        distance = cell_size * _LENGTH[d]
        for row in range(first, last):
            to_row = (row + _ROW_STEP[d] + rows) % rows
            for col in range(cols):
                out[d, row, col] = _NEVER
                if probability[d, row, col] > 0.0:
                    to_col = (col + _COL_STEP[d] + cols) % cols
                    rate = base[row, col]
                    rate *= wind[d, 0, 0] if uniform_wind else wind[d, row, col]
                    length = distance
                    rise = elevation[to_row, to_col] - elevation[row, col]
                    if rise != 0.0:
                        length = np.sqrt(distance * distance + rise * rise)
                        effect = limits.slope * (abs(rise) / distance) ** limits.slope_power
                        factor = np.exp(effect if rise > 0.0 else -effect)
                        rate *= min(max(factor, limits.factor_least), limits.factor_greatest)
                    seconds = np.rint(length / min(max(rate, limits.rate_least), limits.rate_greatest))
                    out[d, row, col] = np.uint32(min(max(seconds, 1.0), _LONGEST))


def rates(travel_time: np.ndarray, cell_size: float) -> np.ndarray:
    """Rates of spread along the map [m/h], (8, rows, cols) float32, from travel times; 0 where there is no edge."""
    out = np.zeros(travel_time.shape, np.float32)
    for d in range(8):
        length = np.float32(3600.0 * cell_size * STEP_LENGTH[d])
        np.divide(length, travel_time[d], out=out[d], where=travel_time[d] != NEVER, casting="same_kind")
    return out
