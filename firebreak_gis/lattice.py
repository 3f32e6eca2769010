"""The eight directions of the square grid, defined once.

Rows grow to the south and columns to the east (north-up rasters). Every array with a direction axis
is ordered N, NE, E, SE, S, SW, W, NW.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import numpy as np

#: Names in order; the index into this tuple is "the direction" everywhere.
DIRECTIONS: Final = ("N", "NE", "E", "SE", "S", "SW", "W", "NW")
#: Row step to the neighbour in each direction.
ROW_STEP: Final = (-1, -1, 0, 1, 1, 1, 0, -1)
#: Column step to the neighbour in each direction.
COL_STEP: Final = (0, 1, 1, 1, 0, -1, -1, -1)
#: Distance to the neighbour, in cells.
STEP_LENGTH: Final = tuple(math.hypot(r, c) for r, c in zip(ROW_STEP, COL_STEP, strict=True))
#: Azimuth of each direction, degrees clockwise from north.
AZIMUTH: Final = tuple(45.0 * d for d in range(8))
#: Index of the direction that leads back.
OPPOSITE: Final = tuple((d + 4) % 8 for d in range(8))

#: Travel time of an edge that does not exist, as uint32.
NEVER: Final = 0xFFFFFFFF
#: The longest travel time of an edge [s], 194 days: whole seconds up to here are exact in float32, as files hold them.
LONGEST: Final = 1 << 24


def close_boundary(values: np.ndarray, closed: float = 0) -> None:
    """Set the edges of (8, rows, cols) that leave an open grid to 0, or what tells that they are closed, in place."""
    for d in range(8):
        if ROW_STEP[d]:
            values[d, -1 if ROW_STEP[d] > 0 else 0, :] = closed
        if COL_STEP[d]:
            values[d, :, -1 if COL_STEP[d] > 0 else 0] = closed
