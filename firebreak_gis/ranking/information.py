"""Information centrality: cells that many parallel ways of spread join closely to all others.

Every route counts, not the shortest alone: two cells are as far apart as the effective resistance between them in a
circuit of the cells, and the score is the inverse of the mean resistance to the others (current-flow closeness).
Currents have no direction; the conductance between neighbours is the mean of the two probabilities. In several
islands the score is r / (n - 1) * r / (sum of resistances) over the r of n - 1 other burnable cells that hang
together with the cell, as for `closeness`; a cell alone has 0.

Exact up to 10,000 burnable cells. Beyond, the resistances are estimated from random probes; the standard error of
a cell's own part of the sum is sqrt(2 / probes) of it, 12.5 % by default, and the draws belong to the grid.

Cost: a factorisation, then a solution a cell or a probe: 5 s on 10,000 cells, half a minute on 10^6. Memory about
2.5 kB a cell for the factors. Ties fall to the cell first in (row, col).
Source: Stephenson, Zelen 1989, doi 10.1016/0378-8733(89)90016-6; Brandes, Fleischer 2005,
doi 10.1007/978-3-540-31856-9_44.
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
MEMORY = (2600, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the information centrality."""

    probes: int = parameter(
        0, text="random probes for the resistances; 0: exact up to 10,000 burnable cells, beyond 128", minimum=0
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the information centrality, (rows, cols) float64."""
    from firebreak_gis.placement.currents import Circuit, resistance_sums

    scores = np.zeros(network.shape)
    progress(0.0, "information: circuit")
    circuit = Circuit(network)
    probes = params.probes or (0 if circuit.n_cells <= EXACT_CELLS else 128)
    sums = resistance_sums(circuit, probes=probes, seed=seed, progress=progress)
    others = circuit.size[circuit.part] - 1.0
    values = np.zeros(circuit.n_cells)
    joined = others > 0
    values[joined] = others[joined] ** 2 / (max(circuit.n_cells - 1, 1) * sums[joined])
    scores[network.burnable] = values
    progress(1.0, f"information of {circuit.n_cells} cells done")
    return scores
