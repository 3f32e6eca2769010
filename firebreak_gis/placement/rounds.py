"""Cut the first cells of a ranking, rank what is left anew, cut more: one removal order."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.placement.orientation import in_standard_orientation
from firebreak_gis.progress import part
from firebreak_gis.stakes import with_barriers

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

    Scores = Callable[[np.ndarray, Progress], np.ndarray | None]


def in_rounds(
    network: SpreadNetwork,
    stakes: Stakes,
    scores: Scores,
    *,
    recompute_every: float,
    until: float,
    progress: Progress,
) -> np.ndarray:
    """Priority by scores that are found anew after every few cuts.

    Parameters
    ----------
    scores
        Called as ``scores(alive, progress)`` with (n_cells,) bool, true where fuel is left; returns (n_cells,)
        scores, or None if more cuts are of no use.
    recompute_every
        Share of the cost of all fuel that is cut before scores are found anew, at least one cell.
    until
        Share of the cost after which the remaining cells keep their last scores.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64: the order of removal, highest first. Ties fall to the cell first in (row, col).
    """
    free = (network.burnable & ~stakes.protected).ravel()
    alive = network.burnable.ravel().copy()
    cost = stakes.cost.ravel()
    budget = max(float(cost.sum()), 1e-300)
    last = np.zeros(alive.size)
    order: list[np.ndarray] = []
    spent, reached = 0.0, 0.0
    while True:
        started, reached = reached, min(max(reached, (spent / budget + recompute_every) / until), 1.0)
        found = scores(alive, part(progress, started, reached))
        last = last if found is None else found
        candidates = np.flatnonzero(free & alive)
        ranked = candidates[np.argsort(-last[candidates], kind="stable")]
        if found is None or ranked.size == 0 or spent >= until * budget:
            order.append(ranked)
            break
        count = max(int(np.searchsorted(np.cumsum(cost[ranked]), recompute_every * budget, side="right")), 1)
        order.append(ranked[:count])
        alive[ranked[:count]] = False
        spent += float(cost[ranked[:count]].sum())
    cells = np.concatenate(order)
    priority = np.zeros(alive.size)
    priority[cells] = np.arange(cells.size, 0, -1.0)
    return priority.reshape(network.shape)


def centrality_in_rounds(
    network: SpreadNetwork,
    stakes: Stakes,
    centrality: Callable[[SpreadNetwork, Progress], np.ndarray],
    *,
    recompute_every: float,
    until: float,
    progress: Progress,
) -> np.ndarray:
    """Priority by a centrality of the network that is left; the centrality itself if `recompute_every` is 0.

    Parameters
    ----------
    centrality
        Called as ``centrality(network, progress)``; returns (rows, cols) scores.
    recompute_every, until
        As in `in_rounds`.
    """
    if recompute_every == 0.0 or not network.burnable.any():
        return centrality(network, progress)

    def standard(network: SpreadNetwork, stakes: Stakes, _: object) -> np.ndarray:
        def scores(alive: np.ndarray, step: Progress) -> np.ndarray | None:
            if not alive.any():
                return None
            cut = network.burnable & ~alive.reshape(network.shape)
            return centrality(with_barriers(network, cut), step).ravel()

        return in_rounds(network, stakes, scores, recompute_every=recompute_every, until=until, progress=progress)

    return in_standard_orientation(network, stakes, standard)
