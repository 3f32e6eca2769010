"""Cells by way of which fires with a clock take most, found anew after every few cuts on the same draws.

In a fire a cell counts its own value and that of all that was lit by way of it, in the time that the fire has; the
score is the mean over fires, for the cost of cutting. Clock, weather, embers and the way that breaks fail are those of
the plan, so that cut cells which leak or fail let fire by in later rounds too. Without a plan that knows them fires
burn until they end by themselves.

Cost: each round burns its fires once, about 200 ns a burnt cell. Memory about 60 B a cell and thread.
Source: downstream protection value, Pais, Carrasco, Elimbi Moudio, Shen 2021, doi 10.1016/j.cor.2021.105252.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (260, 70)


@dataclass(frozen=True)
class Params:
    """Parameters of the influence."""

    cover: float = parameter(
        20.0, text="fires are so many that each cell burns so often where nothing is cut", minimum=0.1, maximum=1e4
    )
    recompute_every: float = parameter(
        0.005, text="share of the cost of all fuel that is cut before scores are found anew", minimum=1e-6, maximum=1.0
    )
    until: float = parameter(
        0.2, text="share of the cost of all fuel up to which scores are found anew", minimum=1e-6, maximum=1.0
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
    trial: Trial | None = None,
) -> np.ndarray:
    """Return the order of cutting, (rows, cols) float64, highest first."""
    from firebreak_gis.placement.orientation import in_standard_orientation
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.request import FireRequest

    if not network.burnable.any():
        return np.zeros(network.shape)
    if trial is not None:  # draws are keyed by the number of the cell, so its map cannot be turned
        return _in_rounds(network, params, stakes, trial, progress)

    def standard(turned: SpreadNetwork, placed: Stakes, turn: object) -> np.ndarray:
        endless = Trial(Ground(turned), FireRequest(), placed, seed)
        return _in_rounds(turned, params, placed, endless, progress)

    return in_standard_orientation(network, stakes, standard)


def _in_rounds(network: SpreadNetwork, params: Params, stakes: Stakes, trial: Trial, progress: Progress) -> np.ndarray:
    from firebreak_gis.placement.rounds import in_rounds

    n_runs = trial.runs(params.cover * network.n_burnable)
    cost = stakes.cost.ravel()
    least = max(1e-12 * float(cost.sum()), 1e-300)

    def scores(alive: np.ndarray, step: Progress) -> np.ndarray | None:
        cut = network.burnable & ~alive.reshape(network.shape)
        passed = trial.passing(cut, n_runs=n_runs, progress=step).ravel()
        return passed / np.maximum(cost, least) if passed.any() else None

    return in_rounds(
        network, stakes, scores, recompute_every=params.recompute_every, until=params.until, progress=progress
    )
