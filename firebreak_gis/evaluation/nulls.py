"""Fires that know nothing: what a simulation must beat before its score means anything.

* `none`: the fire does not grow beyond where it started.
* `distance`: it grows at one speed through the fuel, whatever wind, slope and fuel are.
* `ellipse`: it grows as an ellipse in the wind, ignited at its rear focus, whatever slope and fuel are.

The last two grow until they are as large as the observed fire, so they know its size, which a forecast does not.
A circle or an ellipse of the right size beats careless models on many fires.
"""

from __future__ import annotations

import heapq
import math

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH

#: Names of the null models, in order.
NULLS = ("none", "distance", "ellipse")
#: Length to breadth of a fire by the wind at mid-flame height: sums of a exp(b V), V in m/s, plus a constant.
LENGTH_TO_BREADTH = ((0.936, 0.2566), (0.461, -0.1548))
_ROUND = -0.397
#: Longest ellipse; the formula was fitted to less.
_LONGEST = 8.0


def length_to_breadth(
    wind_speed: float,
    *,
    terms: tuple[tuple[float, float], ...] = LENGTH_TO_BREADTH,
    constant: float = _ROUND,
    longest: float = _LONGEST,
) -> float:
    """Length of a fire over its breadth.

    Anderson 1983 (USDA Forest Service INT-305), in m/s and with the constant that makes calm fires round, as in
    Finney 1998 (doi 10.2737/RMRS-RP-4): 0.936 exp(0.2566 V) + 0.461 exp(-0.1548 V) - 0.397.

    Parameters
    ----------
    wind_speed
        At mid-flame height [m/s].
    terms, constant
        The formula: pairs (a, b) of the sum of a exp(b V), and what is added.
    longest
        Largest value.

    Raises
    ------
    ParameterError
        If the wind is negative or not finite.

    Examples
    --------
    >>> round(length_to_breadth(0.0), 9), round(length_to_breadth(5.0), 2)
    (1.0, 3.19)
    """
    if not 0.0 <= wind_speed < math.inf:
        raise ParameterError(f"wind_speed is {wind_speed}, expected a finite number of at least 0 m/s")
    exponents = [b * min(wind_speed, 100.0) for _, b in terms]
    value = constant + sum(a * math.exp(x) for (a, _), x in zip(terms, exponents, strict=True))
    return min(max(value, 1.0), longest)


def no_growth(start: np.ndarray) -> np.ndarray:
    """Return the fire that stays where it started, (rows, cols) bool."""
    return np.array(start, dtype=bool)


def equal_distance(fuel: np.ndarray, start: np.ndarray, size: int) -> np.ndarray:
    """Grow at one speed through the fuel until so many cells burn.

    Parameters
    ----------
    fuel
        (rows, cols) bool.
    start
        (rows, cols) bool: where the fire is. These cells burn whether they hold fuel or not.
    size
        Cells that burn in the end, those of the start included; fewer if the fuel within reach is less.

    Returns
    -------
    numpy.ndarray
        (rows, cols) bool. Cells are taken by the length of the shortest way to them over the eight neighbours that hold
        fuel (so fronts are octagons); ties break by (row, col).

    Raises
    ------
    InputError
        If the fire starts nowhere.

    Notes
    -----
    Time and memory are in proportion to what burns, not to the map.

    Examples
    --------
    >>> import numpy as np
    >>> fuel, start = np.ones((3, 4), bool), np.zeros((3, 4), bool)
    >>> start[1, 1] = True
    >>> equal_distance(fuel, start, 5).astype(int).tolist()
    [[0, 1, 0, 0], [1, 1, 1, 0], [0, 1, 0, 0]]
    """
    rows, cols = _require_start(start)
    burns = [(0.0, cell) for cell in np.flatnonzero(start).tolist()]
    nearest = dict.fromkeys((cell for _, cell in burns), 0.0)
    taken = np.zeros(rows * cols, bool)
    passable = np.asarray(fuel, dtype=bool).ravel()
    n_taken = 0
    while burns and n_taken < size:
        distance, cell = heapq.heappop(burns)
        if taken[cell]:
            continue
        taken[cell] = True
        n_taken += 1
        row, col = divmod(cell, cols)
        for row_step, col_step, length in zip(ROW_STEP, COL_STEP, STEP_LENGTH, strict=True):
            r, c = row + row_step, col + col_step
            if not (0 <= r < rows and 0 <= c < cols):
                continue
            other = r * cols + c
            further = round(distance + length, 9)  # equal ways are equal whatever their order of steps
            if passable[other] and not taken[other] and further < nearest.get(other, math.inf):
                nearest[other] = further
                heapq.heappush(burns, (further, other))
    return taken.reshape(rows, cols)


def wind_ellipse(
    fuel: np.ndarray,
    start: np.ndarray,
    size: int,
    *,
    wind_speed: float,
    wind_from_direction: float,
    ratio: float | None = None,
) -> np.ndarray:
    """Grow as an ellipse in the wind until so many cells with fuel burn.

    Parameters
    ----------
    fuel, start, size
        As in `equal_distance`; but the ellipse jumps over land without fuel.
    wind_speed
        At mid-flame height [m/s].
    wind_from_direction
        Where the wind comes from [degrees clockwise from north].
    ratio
        Length over breadth, at least 1; by `length_to_breadth` if not given.

    Returns
    -------
    numpy.ndarray
        (rows, cols) bool. Each cell on the rim of the start is the rear focus of an ellipse, and all grow alike; a cell
        is reached at distance r and angle theta from the wind's course at the time r (1 - e cos theta) / (1 - e), with
        the eccentricity e. Ties break by (row, col).

    Raises
    ------
    InputError
        If the fire starts nowhere.
    ParameterError
        If the ratio is below 1.

    Notes
    -----
    Time: cells of the map times cells on the rim of the start.

    Examples
    --------
    >>> import numpy as np
    >>> fuel, start = np.ones((3, 5), bool), np.zeros((3, 5), bool)
    >>> start[1, 1] = True
    >>> wind_ellipse(fuel, start, 4, wind_speed=8, wind_from_direction=270).astype(int).tolist()
    [[0, 0, 0, 0, 0], [0, 1, 1, 1, 1], [0, 0, 0, 0, 0]]
    """
    rows, cols = _require_start(start)
    ratio = length_to_breadth(wind_speed) if ratio is None else ratio
    if not 1.0 <= ratio < math.inf:
        raise ParameterError(f"ratio is {ratio}, expected a length over breadth of at least 1")
    eccentricity = math.sqrt(1.0 - 1.0 / ratio**2)
    course = math.radians(wind_from_direction + 180.0)
    east, north = math.sin(course), math.cos(course)
    begun = np.asarray(start, dtype=bool)
    row, col = np.mgrid[0:rows, 0:cols].astype(np.float64)
    time = np.full((rows, cols), np.inf)
    for r, c in np.argwhere(_rim(begun)).tolist():
        along = east * (col - c) - north * (row - r)
        np.minimum(time, np.hypot(row - r, col - c) - eccentricity * along, out=time)
    reached = np.where(begun, -1.0, np.where(fuel, np.round(time, 9), np.inf)).ravel()
    order = np.argsort(reached, kind="stable")[: max(size, 0)]
    taken = np.zeros(reached.size, bool)
    taken[order[np.isfinite(reached[order])]] = True
    return taken.reshape(rows, cols)


def mean_wind(
    speeds: np.ndarray, from_directions: np.ndarray, *, weights: np.ndarray | None = None
) -> tuple[float, float]:
    """Mean speed, and the direction of the mean wind vector.

    Parameters
    ----------
    speeds, from_directions
        (n,) wind [m/s; degrees clockwise from north, where it comes from].
    weights
        (n,) how long each blows; alike if not given.

    Returns
    -------
    tuple of float
        Mean speed [m/s] and direction it comes from [degrees, 0 to 360].

    Examples
    --------
    >>> import numpy as np
    >>> mean_wind(np.array([4.0, 4.0]), np.array([350.0, 10.0]))
    (4.0, 0.0)
    """
    speed = np.asarray(speeds, dtype=np.float64)
    angle = np.radians(np.asarray(from_directions, dtype=np.float64))
    east, north = (float(np.average(speed * of(angle), weights=weights)) for of in (np.sin, np.cos))
    direction = round(math.degrees(math.atan2(east, north)) % 360.0, 9) % 360.0
    return float(np.average(speed, weights=weights)), direction


def _require_start(start: np.ndarray) -> tuple[int, int]:
    begun = np.asarray(start, dtype=bool)
    if not begun.any():
        raise InputError("the fire starts nowhere: no cell of the start lies on the landscape")
    rows, cols = begun.shape
    return rows, cols


def _rim(area: np.ndarray) -> np.ndarray:
    """Cells of an area that have a neighbour outside it."""
    padded = np.pad(area, 1)
    inner = area.copy()
    rows, cols = area.shape
    for row_step, col_step in zip(ROW_STEP, COL_STEP, strict=True):
        inner &= padded[1 + row_step : 1 + row_step + rows, 1 + col_step : 1 + col_step + cols]
    return np.asarray(area & ~inner)
