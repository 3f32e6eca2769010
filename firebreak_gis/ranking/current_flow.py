"""Current-flow betweenness: cells through which spread passes by any route, not by the fastest alone.

Between every pair of cells one unit of current flows through a circuit of the cells; the score of a cell is the
mean over pairs of other cells of the current that passes through it. It is also how often a random walk from one
to the other passes the cell, walks back and forth not counted. Currents have no direction; the conductance between
neighbours is the mean of the two probabilities. Pairs on different islands count nothing.

Exact up to 10,000 burnable cells. Beyond, random pairs are taken; with probability 0.9 no cell is off by more than
sqrt(log(20 n) / (2 pairs)), 0.13 on 10^6 cells by default, and the draws belong to cells of the grid.

Cost: a factorisation, then a solution a cell and a sort of n numbers a resistor (exact: a minute on 10,000 cells), or
a solution a pair (2 minutes on 10^6). Memory about 2.5 kB a cell for the factors. Ties fall to the cell first in
(row, col).
Source: Newman 2005, doi 10.1016/j.socnet.2004.11.009; Brandes, Fleischer 2005, doi 10.1007/978-3-540-31856-9_44.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Burnable cells up to which the default is exact.
EXACT_CELLS = 10_000

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (2700, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the current-flow betweenness."""

    pairs: int = parameter(0, text="random pairs of cells; 0: all up to 10,000 burnable cells, beyond 500", minimum=0)


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the current-flow betweenness, a share of all pairs, (rows, cols) float64."""
    from firebreak_gis.placement.currents import Circuit, sampled_throughput, throughput

    scores = np.zeros(network.shape)
    progress(0.0, "current flow: circuit")
    circuit = Circuit(network)
    n_cells = circuit.n_cells
    pairs = params.pairs or (0 if n_cells <= EXACT_CELLS else 500)
    if pairs:
        scores[network.burnable] = sampled_throughput(circuit, pairs=pairs, seed=seed, progress=progress)
    else:
        n_pairs = max((n_cells - 1) * (n_cells - 2) / 2.0, 1.0)
        scores[network.burnable] = throughput(circuit, progress=progress) / n_pairs
    progress(1.0, f"current flow of {n_cells} cells done")
    return scores
