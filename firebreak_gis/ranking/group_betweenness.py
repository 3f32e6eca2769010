"""Group betweenness: built cell by cell, each covers fastest routes that the group leaves open.

Single scores choose neighbours of neighbours, since the cells of one route all score high; here the pairs whose
routes a chosen cell covers count no more, so that the next cell is taken elsewhere. Routes are those before any
cut: a pair is covered, not led round. The score of a cell, given the group, is the sum over pairs of other cells
outside it of the share of shortest paths, edges being 1 / p long, that pass through the cell and past the group.

Chosen are the best cells worth `recompute_every` of the cost of all fuel, at least one, then scores are found anew;
with 1e-6 and all sources this is the exact greedy choice. Beyond 20,000 burnable cells 100 sources are sampled, and
the draws belong to cells of the grid. There is no orientation.

Cost: as betweenness, for every round, about 1.5 times as long a search; memory as betweenness and 16 B a cell and
thread. Ties fall to the cell first in (row, col) of the standard orientation.
Source: Everett, Borgatti 1999, doi 10.1080/0022250X.1999.9990219; successive choice, Puzis, Elovici, Dolev 2007,
doi 10.1103/PhysRevE.76.056709.
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

#: Burnable cells up to which the default takes every source.
EXACT_CELLS, _PIVOTS = 20_000, 100

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (260, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the group betweenness."""

    pivots: int = parameter(0, text="number of sources; 0: all up to 20,000 burnable cells, beyond 100", minimum=0)
    recompute_every: float = parameter(
        0.01,
        text="share of the cost of all fuel that joins the group before scores are found anew",
        minimum=1e-6,
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
    """Return the order of joining the group, (rows, cols) float64, highest first."""
    from firebreak_gis.kernels.groups import uncovered
    from firebreak_gis.placement.orientation import in_standard_orientation
    from firebreak_gis.placement.rounds import in_rounds

    pivots = params.pivots or (0 if network.n_burnable <= EXACT_CELLS else _PIVOTS)

    def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
        routes = uncovered(network.probability, network.burnable, boundary=network.boundary, pivots=pivots, seed=seed)

        def scores(alive: np.ndarray, step: Progress) -> np.ndarray | None:
            if not alive.any():
                return None
            group = network.burnable & ~alive.reshape(network.shape)
            return routes.gains(group, progress=step).ravel()

        order = in_rounds(
            network,
            stakes,
            scores,
            recompute_every=params.recompute_every,
            until=params.until,
            progress=progress,
        )
        progress(1.0, "group betweenness done")
        return order

    return in_standard_orientation(network, stakes, standard)
