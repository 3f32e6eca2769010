"""Cut the cells that save most, look again at what burns, cut more: rankings by simulated gains."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.placement.fires import Fires, burn_pieces, design_fires, pieces
from firebreak_gis.placement.rounds import in_rounds

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

    Kernel = Callable[..., Any]


def mean_gain(
    kernel: Kernel,
    fires: Fires,
    alive: np.ndarray,
    value: np.ndarray,
    *,
    threads: int | None = None,
    progress: Progress,
) -> tuple[np.ndarray, float]:
    """Gain of cutting each cell, and the loss, in the mean over the fires.

    Parameters
    ----------
    kernel
        `kernels.gains.downstream` or `kernels.gains.dominated`.
    alive
        (n_cells,) bool.
    value
        (n_cells,) float64.

    Returns
    -------
    tuple
        (n_cells,) float64 and a number, in the unit of `value`.
    """
    parts = pieces(fires.keys.size)
    sums = np.zeros((len(parts), alive.size))
    lost = np.zeros(len(parts))

    def work(i: int) -> None:
        lost[i] = kernel(
            fires.limits, fires.leaks, fires.keys, fires.grid_steps, fires.cells, alive, value, *parts[i], sums[i]
        )

    burn_pieces(work, fires.keys.size, alive.size, threads=threads, progress=progress)
    return sums.sum(axis=0) / fires.keys.size, float(lost.sum()) / fires.keys.size


def by_gain(
    network: SpreadNetwork,
    stakes: Stakes,
    kernel: Kernel,
    *,
    n_runs: int,
    recompute_every: float,
    until: float,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Priority by gain for the cost, found anew after every few cuts on the same fires.

    Parameters
    ----------
    kernel
        See `mean_gain`.
    n_runs, seed
        Fires of the design.
    recompute_every
        Share of the cost of all fuel that is cut before the gains are found anew.
    until
        Share of the cost after which the remaining cells keep their last gain.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.
    """
    cost, value = stakes.cost.ravel(), stakes.value.ravel()
    if not network.burnable.any():
        return np.zeros(network.shape)
    fires = design_fires(network, stakes, n_runs=n_runs, seed=seed)
    least = 1e-12 * float(cost.sum())

    def scores(alive: np.ndarray, step: Progress) -> np.ndarray | None:
        gain, lost = mean_gain(kernel, fires, alive, value, progress=step)
        # Only what can burn is ranked by what it saves; free cells come first.
        return gain / np.maximum(cost, max(least, 1e-300)) if lost > 0.0 else None

    return in_rounds(network, stakes, scores, recompute_every=recompute_every, until=until, progress=progress)
