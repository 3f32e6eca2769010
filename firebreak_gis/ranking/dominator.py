"""Dominator: exact gain of cutting one cell, found anew after every few cuts.

In one simulated fire the cells that burn only by way of a cell are its subtree in the dominator tree of the open
edges; their value, in the mean over fires and for the cost of cutting, is exactly what cutting that cell alone
saves. After `recompute_every` of the fuel is cut the gains are found anew on the same fires. Where fire has many
ways round, single cells save little and the gains say nothing of walls: use `dissection` there.

Cost: a few passes over the open edges for every fire and round, about 100 ns a cell. Ties fall to the cell first in
(row, col) of the standard orientation. Memory about 150 B a cell and thread.
Source: Georgiadis, Tarjan, Werneck 2006, doi 10.7155/jgaa.00119; the problem, Pais et al. 2021,
doi 10.1016/j.cor.2021.105252.
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

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (330, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the exact gain of single cells."""

    fires: int = parameter(100, text="simulated fires that the plan is designed with", minimum=1)
    recompute_every: float = parameter(
        0.005,
        text="share of the cost of all fuel that is cut before scores are found anew",
        minimum=1e-6,
        maximum=1.0,
    )
    until: float = parameter(
        0.2, text="share of the cost of all fuel up to which scores are found anew", minimum=1e-6, maximum=1.0
    )


def rank(network: SpreadNetwork, params: Params, *, stakes: Stakes, seed: int, progress: Progress) -> np.ndarray:
    """Return the order of cutting, (rows, cols) float64, highest first."""
    from firebreak_gis.kernels.gains import dominated
    from firebreak_gis.placement.gains import by_gain
    from firebreak_gis.placement.orientation import in_standard_orientation

    def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
        return by_gain(
            network,
            stakes,
            dominated,
            n_runs=params.fires,
            recompute_every=params.recompute_every,
            until=params.until,
            seed=seed,
            progress=progress,
        )

    return in_standard_orientation(network, stakes, standard)
