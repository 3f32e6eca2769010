"""How close a simulated fire comes to an observed scar.

Sets of cells are compared by Sorensen's and Jaccard's indices and by size; probabilities by the Brier score and a
reliability curve. No score means anything alone: `evaluation.nulls` gives the models that know nothing, to stand
beside it.

Sources: Filippi, Mallet, Nader 2014 (doi 10.1071/WF12202) and Duff, Chong, Tolhurst 2016 (doi
10.1016/j.envsoft.2016.05.005) for sets of cells; Brier 1950 (doi 10.1175/1520-0493(1950)078<0001:VOFEIT>2.0.CO;2)
for probabilities; Murphy 1973 (doi 10.1175/1520-0450(1973)012<0595:ANVPOT>2.0.CO;2) for the reliability.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.errors import GridError, InputError, ParameterError

#: Bins of a reliability curve, of equal width.
BINS = 10


class Reliability(NamedTuple):
    """A reliability curve, one element a bin of forecast probability.

    Parameters
    ----------
    low, high
        Ends of the bin; the high end belongs to the next bin, but for the last.
    cells
        Cells whose forecast lies in the bin, int64.
    forecast
        Their mean forecast; nan without cells.
    observed
        Share of them that burnt; nan without cells.
    """

    low: np.ndarray
    high: np.ndarray
    cells: np.ndarray
    forecast: np.ndarray
    observed: np.ndarray

    def largest_gap(self, least_cells: int = 100) -> float:
        """Largest distance of forecast and observed among the bins of at least so many cells; nan without any."""
        gaps = np.abs(self.forecast - self.observed)[self.cells >= max(least_cells, 1)]
        return float(gaps.max()) if gaps.size else float("nan")


def overlap(burnt: np.ndarray, observed: np.ndarray, *, start: np.ndarray | None = None) -> dict[str, float]:
    """Compare two sets of cells.

    Parameters
    ----------
    burnt, observed
        (rows, cols) bool: simulated and observed.
    start
        (rows, cols) bool: where the fire was when the simulation began, left out of `growth_iou`.

    Returns
    -------
    dict
        `sorensen` 2 |A and B| / (|A| + |B|), `iou` |A and B| / |A or B| (Jaccard), `growth_iou` the same without the
        cells of `start`, `size_ratio` |A| / |B| (1 is unbiased; inf or nan if nothing was observed). Two empty sets
        are equal: 1.

    Raises
    ------
    GridError
        If the shapes differ.

    Examples
    --------
    >>> import numpy as np
    >>> observed = np.array([[1, 1, 1, 0]], bool)
    >>> overlap(np.array([[1, 1, 0, 1]], bool), observed, start=np.array([[1, 0, 0, 0]], bool))
    {'sorensen': 0.6666666666666666, 'iou': 0.5, 'growth_iou': 0.3333333333333333, 'size_ratio': 1.0}
    """
    one, other = _same_shape(burnt=burnt, observed=observed)
    outside = np.ones(one.shape, bool) if start is None else ~_same_shape(observed=observed, start=start)[1]
    hits = int(np.count_nonzero(one & other))
    sizes = int(np.count_nonzero(one)), int(np.count_nonzero(other))
    ratio = sizes[0] / sizes[1] if sizes[1] else (float("inf") if sizes[0] else float("nan"))
    return {
        "sorensen": 2.0 * hits / sum(sizes) if sum(sizes) else 1.0,
        "iou": _jaccard(one, other),
        "growth_iou": _jaccard(one & outside, other & outside),
        "size_ratio": ratio,
    }


def brier(probability: np.ndarray, observed: np.ndarray, *, within: np.ndarray | None = None) -> float:
    """Mean squared error of a burn probability.

    Parameters
    ----------
    probability
        (rows, cols), 0 to 1.
    observed
        (rows, cols) bool.
    within
        (rows, cols) bool: cells that count; all if not given. Cells that nobody expects to burn, and that do not,
        make the score small; a skill against a null model is the same however many of them there are.

    Raises
    ------
    InputError
        If a probability is not from 0 to 1, or no cell counts.

    Examples
    --------
    >>> import numpy as np
    >>> brier(np.array([[1.0, 0.5, 0.0]]), np.array([[1, 1, 0]], bool))
    0.08333333333333333
    """
    forecast, truth = _forecasts(probability, observed, within)
    return float(np.mean((forecast - truth) ** 2))


def brier_skill(score: float, reference: float) -> float:
    """Share of the Brier score of a null model that is saved: 1 is perfect, 0 no better, below 0 worse.

    Where the null model is perfect there is nothing to save: 0 if the score is perfect too, else -inf.

    Examples
    --------
    >>> brier_skill(0.05, 0.2)
    0.75
    """
    if reference == 0.0:
        return 0.0 if score == 0.0 else float("-inf")
    return 1.0 - score / reference


def reliability(
    probability: np.ndarray, observed: np.ndarray, *, within: np.ndarray | None = None, bins: int = BINS
) -> Reliability:
    """How often cells burnt, by the probability that was forecast for them.

    Parameters
    ----------
    probability, observed, within
        As in `brier`.
    bins
        Number of bins of equal width from 0 to 1.

    Raises
    ------
    ParameterError
        If `bins` is less than 1; `InputError` as `brier`.

    Examples
    --------
    >>> import numpy as np
    >>> curve = reliability(np.array([[0.1, 0.2, 0.9, 1.0]]), np.array([[0, 1, 1, 1]], bool), bins=2)
    >>> curve.cells.tolist(), curve.observed.tolist()
    ([2, 2], [0.5, 1.0])
    """
    if bins < 1:
        raise ParameterError(f"bins is {bins}, expected at least 1")
    forecast, truth = _forecasts(probability, observed, within)
    edges = np.arange(bins + 1) / bins  # so that 30 of 100 runs lie on the edge 3 / 10
    place = np.minimum(np.searchsorted(edges, forecast, side="right") - 1, bins - 1)
    cells = np.bincount(place, minlength=bins)
    with np.errstate(invalid="ignore"):
        means = [np.bincount(place, weights=values, minlength=bins) / cells for values in (forecast, truth)]
    return Reliability(edges[:-1], edges[1:], cells.astype(np.int64), *means)


def area_matched(probability: np.ndarray, size: int) -> np.ndarray:
    """Cells most likely to burn, as many as were observed to burn: the shape of a forecast apart from its size.

    Parameters
    ----------
    probability
        (rows, cols), 0 to 1, or any score that is higher where fire is more likely.
    size
        Number of cells; cells with 0 are never taken, so that there may be fewer. Ties break by (row, col).

    Returns
    -------
    numpy.ndarray
        (rows, cols) bool.

    Examples
    --------
    >>> import numpy as np
    >>> area_matched(np.array([[0.2, 0.0], [0.9, 0.2]]), 2).astype(int).tolist()
    [[1, 0], [1, 0]]
    """
    flat = np.nan_to_num(np.asarray(probability, dtype=np.float64).ravel())
    order = np.argsort(-flat, kind="stable")[: max(size, 0)]
    taken = np.zeros(flat.size, bool)
    taken[order[flat[order] > 0.0]] = True
    return taken.reshape(np.shape(probability))


def time_of_size(times: np.ndarray, sizes: np.ndarray, target: float) -> float:
    """Time at which a growing fire reaches a size; straight lines between the times.

    Parameters
    ----------
    times
        (n,) rising, any unit.
    sizes
        (n,) not falling, such as the mean burnt cells by each time.
    target
        Size in the same unit.

    Returns
    -------
    float
        nan if it is never reached.

    Raises
    ------
    ParameterError
        If the times do not rise, or the sizes fall.

    Examples
    --------
    >>> import numpy as np
    >>> time_of_size(np.array([0.0, 1.0, 3.0]), np.array([1.0, 10.0, 30.0]), 20.0)
    2.0
    """
    clock, grown = np.asarray(times, dtype=np.float64), np.asarray(sizes, dtype=np.float64)
    if clock.size == 0 or clock.shape != grown.shape or (np.diff(clock) <= 0).any() or (np.diff(grown) < 0).any():
        raise ParameterError("times must rise and sizes must not fall, one size a time")
    place = int(np.searchsorted(grown, target, side="left"))
    if place == grown.size:
        return float("nan")
    if place == 0:
        return float(clock[0])
    share = (target - grown[place - 1]) / (grown[place] - grown[place - 1])
    return float(clock[place - 1] + share * (clock[place] - clock[place - 1]))


def _jaccard(one: np.ndarray, other: np.ndarray) -> float:
    union = int(np.count_nonzero(one | other))
    return int(np.count_nonzero(one & other)) / union if union else 1.0


def _same_shape(**planes: np.ndarray) -> list[np.ndarray]:
    arrays = [np.asarray(plane).astype(bool) for plane in planes.values()]
    if len({array.shape for array in arrays}) > 1:
        told = ", ".join(f"{name} {array.shape}" for name, array in zip(planes, arrays, strict=True))
        raise GridError(f"the sets of cells have different shapes: {told}; lay them on one grid")
    return arrays


def _forecasts(
    probability: np.ndarray, observed: np.ndarray, within: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray]:
    """Forecast and truth of the cells that count, float64."""
    given = np.asarray(probability, dtype=np.float64)
    truth = np.asarray(observed).astype(bool)
    counted = np.ones(given.shape, bool) if within is None else np.asarray(within).astype(bool)
    _same_shape(probability=given, observed=truth, within=counted)
    forecast = given[counted]
    if forecast.size == 0:
        raise InputError("no cell counts for the score; expected at least one cell with fuel or in the scar")
    if not ((forecast >= 0.0) & (forecast <= 1.0)).all():  # also catches NaN
        raise InputError("burn probabilities must lie from 0 to 1 without NaN in the cells that count")
    return forecast, truth[counted].astype(np.float64)
