"""Percolation centrality: cells on many fastest routes from where fires start.

Betweenness in which every source counts by how likely it burns: a share of shortest paths, edges being 1 / p long,
in the mean over targets and over sources weighted by where fires start. With ignitions alike everywhere it ranks
nearly as betweenness; with an ignition map it shows the cells that carry fire away from there. No orientation.

Exact up to 20,000 burnable cells. Beyond, sources are drawn in proportion to their ignitions; with probability 0.9
the score of no cell is off by more than sqrt(log(20 n) / (2 pivots)), 0.13 on 10^6 cells by default, and the draws
belong to cells of the grid.

Cost: a search a source, about 35 ns a cell on small grids and 90 ns on 10^6 cells; memory 32 B a cell (64 B if any
p is below 1/256) and about 60 B a cell and thread. Ties fall to the cell first in (row, col).
Source: Piraveenan, Prokopenko, Hossain 2013, doi 10.1371/journal.pone.0053095.
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
MEMORY = (200, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the percolation centrality."""

    pivots: int = parameter(
        0, text="number of sources drawn; 0: all cells up to 20,000 burnable cells, beyond 500", minimum=0
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the percolation centrality, (rows, cols) float64."""
    from firebreak_gis.kernels.centrality import percolation

    scores = percolation(
        network.probability,
        network.burnable,
        stakes.ignition,
        pivots=params.pivots or (0 if network.n_burnable <= EXACT_CELLS else 500),
        seed=seed,
        boundary=network.boundary,
        progress=progress,
    )
    progress(1.0, "percolation done")
    return scores
