"""Embers of a burning cell: how many, and where and when each lands, by draws keyed by run and cell."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.draws import normal, uniform
from firebreak_gis.kernels.policy import inlined, kernel

#: Most embers of a cell.
MOST = 15
#: No ember lights a fire sooner than this after its cell burns [s].
SOONEST = 60
#: Words of the stream of a run that belong to a cell: one for the number, four for each ember.
_WORDS = np.uint64(64)
#: Landing off the grid.
NOWHERE = np.uint64(0xFFFFFFFFFFFFFFFF)
_ONE = np.uint64(1)


class Embers(NamedTuple):
    """What flies. Without embers, the arrays of cells are empty.

    Parameters
    ----------
    keys
        (n_runs,) uint64 from `draws.run_keys`.
    mean
        (n_steps, n_cells) float32: embers expected from a cell that burns, under the weather of each step.
    median
        (n_steps, n_cells) float32: median distance downwind [cells].
    sigma
        (n_steps, n_cells) float32 of the lognormal distance; (n_steps, 1) if all cells are alike.
    downwind
        (n_steps, n_cells) float32 azimuth [radians]; (n_steps, 1) if all cells are alike.
    spread
        Standard deviation of the direction about it [radians].
    focus
        The distance off the wind is that downwind times exp(focus (cos(angle) - 1)).
    longest
        No ember flies further [cells].
    catches
        (n_cells,) float32 probability that an ember lights the cell; 0 where there is no fuel.
    delay, delay_sigma
        Median [s] and sigma of the lognormal time from the burning of the cell to the new fire.
    """

    keys: np.ndarray
    mean: np.ndarray
    median: np.ndarray
    sigma: np.ndarray
    downwind: np.ndarray
    spread: float
    focus: float
    longest: float
    catches: np.ndarray
    delay: float
    delay_sigma: float


@inlined
def may_throw(mean: np.ndarray, key: np.uint64, step: int, cell: np.uint64, here: np.uint64) -> bool:
    """Whether `number` may be above 0, from `Embers.mean` and the key of the run; mostly not, so it spares the call."""
    expected = np.float64(mean[step, cell])
    return expected > 0.0 and uniform(key, here * _WORDS) >= 1.0 - expected  # exp(-mean) is larger


@inlined
def number(embers: Embers, run: int, step: int, cell: np.uint64, here: np.uint64) -> int:
    """Embers that a cell, number `here` on the whole map, throws in the run: a Poisson number of at most `MOST`."""
    mean = np.float64(embers.mean[step, cell])
    count = 0
    if mean > 0.0:
        u = uniform(embers.keys[run], here * _WORDS)
        share = np.exp(-mean)
        total = share
        while u >= total and count < MOST:
            count += 1
            share *= mean / count
            total += share
    return count


@kernel
def landing(
    embers: Embers, run: int, step: int, cell: np.uint64, here: np.uint64, k: int, rows: int, cols: int, periodic: bool
) -> np.uint64:
    """Cell in which ember `k` of `cell` comes down; `NOWHERE` off the grid."""
    key = embers.keys[run]
    place = here * _WORDS + _ONE + np.uint64(4 * k)
    angle = embers.spread * normal(key, place)
    sigma = np.float64(embers.sigma[step, cell if embers.sigma.shape[1] > 1 else np.uint64(0)])
    heading = np.float64(embers.downwind[step, cell if embers.downwind.shape[1] > 1 else np.uint64(0)])
    distance = np.float64(embers.median[step, cell]) * np.exp(
        sigma * normal(key, place + _ONE) + embers.focus * (np.cos(angle) - 1.0)
    )
    distance = min(distance, embers.longest)
    row = int(cell // np.uint64(cols)) - int(np.rint(distance * np.cos(heading + angle)))
    col = int(cell % np.uint64(cols)) + int(np.rint(distance * np.sin(heading + angle)))
    if periodic:
        row, col = row % rows, col % cols
    if row < 0 or row >= rows or col < 0 or col >= cols:
        return NOWHERE
    return np.uint64(row * cols + col)


@kernel
def lights(embers: Embers, run: int, here: np.uint64, k: int, target: np.uint64, kept: float) -> bool:
    """Whether ember `k` of cell `here` of the whole map lights `target`, which keeps a share of its chance to burn."""
    place = here * _WORDS + np.uint64(3 + 4 * k)
    return uniform(embers.keys[run], place) < np.float64(embers.catches[target]) * kept


@kernel
def smoulders(embers: Embers, run: int, here: np.uint64, k: int) -> np.uint64:
    """Seconds from the burning of a cell to the fire that its ember `k` lights."""
    place = here * _WORDS + np.uint64(4 + 4 * k)
    seconds = embers.delay * np.exp(embers.delay_sigma * normal(embers.keys[run], place))
    return np.uint64(min(max(np.rint(seconds), SOONEST), 1e9))
