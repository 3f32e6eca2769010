"""What fires leave under a plan: expected and worst areas, value lost and leverage, each with its interval."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

#: Share of the worst runs that CVaR averages.
WORST = 0.1
#: Bootstrap samples, and the percentiles that bound an interval.
_RESAMPLES = 500
BOUNDS = (2.5, 97.5)


def resamples(n_runs: int, seed: int) -> np.ndarray:
    """Runs of the bootstrap samples, (n_samples, n_runs) int64."""
    return np.random.default_rng(seed).integers(0, n_runs, (_RESAMPLES, n_runs))


def judge(
    burnt: np.ndarray,
    lost: np.ndarray,
    untreated: np.ndarray,
    *,
    treated_ha: float,
    cell_area_ha: float,
    picks: np.ndarray,
) -> dict[str, float]:
    """Measure a plan on the runs of a simulation.

    Parameters
    ----------
    burnt, untreated
        (n_runs,) cells burnt in the same fires with and without the plan.
    lost
        (n_runs,) value lost with the plan.
    treated_ha
        Area of the breaks [ha].
    cell_area_ha
        Area of a cell [ha].
    picks
        As `resamples` returns them; the same for plans that are compared.

    Returns
    -------
    dict
        `burnt_ha` (expected), `p90_ha` (90 % percentile), `cvar_ha` (mean of the worst tenth of the runs),
        `value_lost` (expected), `leverage` (hectares saved per hectare treated; 0 without breaks); each also with
        `_low` and `_high`, the ends of its 95 % interval: bootstrap percentiles over runs, of leverage over pairs
        of runs.
    """
    area = burnt * cell_area_ha
    saved = (untreated * cell_area_ha - area) / treated_ha if treated_ha > 0 else np.zeros(area.size)
    measures: Mapping[str, tuple[np.ndarray, Callable[[np.ndarray], np.ndarray]]] = {
        "burnt_ha": (area, _mean),
        "p90_ha": (area, _p90),
        "cvar_ha": (area, worst_mean),
        "value_lost": (lost, _mean),
        "leverage": (saved, _mean),
    }
    row: dict[str, float] = {}
    for name, (runs, measure) in measures.items():
        low, high = np.percentile(measure(runs[picks]), BOUNDS)
        row |= {name: float(measure(runs[None])[0]), f"{name}_low": float(low), f"{name}_high": float(high)}
    return row


def _mean(runs: np.ndarray) -> np.ndarray:
    return np.asarray(runs.mean(axis=1))


def _p90(runs: np.ndarray) -> np.ndarray:
    return np.asarray(np.percentile(runs, 90, axis=1))


def worst_mean(runs: np.ndarray) -> np.ndarray:
    """Mean of the worst tenth of the runs, at least of one, along the last axis (CVaR)."""
    count = max(1, round(WORST * runs.shape[-1]))
    return np.asarray(np.sort(runs, axis=-1)[..., -count:].mean(axis=-1))
