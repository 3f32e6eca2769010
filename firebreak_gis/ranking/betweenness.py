"""Betweenness centrality: cells that lie on many fastest routes of fire.

The score of a cell is the sum over ordered pairs of other cells of the share of shortest paths between them that
pass through it. An edge l -> k is 1 / p(l -> k) long. Turning all edges round changes nothing, so there is no
orientation.

Lengths are rounded to multiples of 2**-24, so that their sums are exact and routes over the same lengths in any order
tie; tied routes share the pair equally, however many there are. Routes that would be equally long before the rounding,
over other lengths, need not tie after it. Pairs without a route count nothing; cells on no route have 0.

Exact up to 20,000 burnable cells. Beyond, sources are sampled until, with probability 1 - delta, the error of every
cell is at most epsilon of the n (n - 1) ordered pairs; the draws belong to cells of the grid, so the estimate of a
mirrored network is not the mirrored estimate. With `recompute_every` the score is found anew on the network that is
left after every few cuts, and the order of removal is returned.

Cost: a search a source, about 35 ns a cell on small grids and 90 ns on 10^6 cells, for every round; memory 32 B a
cell (64 B if any p is below 1/256) and about 60 B a cell and thread.
Source: Freeman 1977, doi 10.2307/3033543; Brandes 2001, doi 10.1080/0022250X.2001.9990249; Russo, Russo, Siettos
2016, doi 10.1371/journal.pone.0163226.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    import numpy as np

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Burnable cells up to which the default is exact.
EXACT_CELLS = 20_000

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (180, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the betweenness."""

    pivots: int = parameter(
        0, text="number of sources; 0: all up to 20,000 burnable cells, beyond as many as epsilon needs", minimum=0
    )
    epsilon: float = parameter(
        0.05,
        text="error of any cell allowed when sources are sampled, as a share of ordered pairs",
        minimum=1e-4,
        maximum=1.0,
        open_maximum=True,
    )
    delta: float = parameter(
        0.1, text="chance that the sampling error exceeds epsilon", minimum=1e-12, maximum=1.0, open_maximum=True
    )
    recompute_every: float = parameter(
        0.0,
        text="share of the cost of all fuel that is cut before scores are found anew on what is left; 0: never",
        minimum=0.0,
        maximum=1.0,
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
) -> np.ndarray:
    """Return the betweenness, a number of ordered pairs, or the order of removal, (rows, cols) float64."""
    from firebreak_gis.placement.rounds import centrality_in_rounds

    return centrality_in_rounds(
        network,
        stakes,
        lambda left, step: _scores(left, params, seed, step),
        recompute_every=params.recompute_every,
        until=params.until,
        progress=progress,
    )


def _scores(network: SpreadNetwork, params: Params, seed: int, progress: Progress) -> np.ndarray:
    from firebreak_gis.kernels.centrality import betweenness, sampled_betweenness

    n_cells = network.n_burnable
    if params.pivots >= n_cells or (params.pivots == 0 and n_cells <= EXACT_CELLS):
        scores = betweenness(network.probability, network.burnable, boundary=network.boundary, progress=progress)
        progress(1.0, f"betweenness of {n_cells} cells done")
        return scores
    return sampled_betweenness(
        network.probability,
        network.burnable,
        boundary=network.boundary,
        pivots=params.pivots,
        epsilon=params.epsilon,
        delta=params.delta,
        seed=seed,
        progress=progress,
    ).values
