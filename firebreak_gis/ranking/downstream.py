"""Downstream protection value: cells from which most value was lit, found anew after every few cuts.

In one simulated fire a cell counts its own value and that of all that it lit, directly or not, in the tree of who
lit whom; the score is the mean over fires, for the cost of cutting. The tree overstates the gain, since fire has
other ways; `dominator` gives the exact gain of one cell. After `recompute_every` of the fuel is cut the scores are
found anew on the same fires.

Cost: two passes over the burnt cells for every fire and round, about 30 ns a cell. Ties fall to the cell first in
(row, col) of the standard orientation. Memory about 150 B a cell and thread.
Source: Pais, Carrasco, Elimbi Moudio, Shen 2021, doi 10.1016/j.cor.2021.105252.
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
MEMORY = (220, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the downstream protection value."""

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
    from firebreak_gis.kernels.gains import downstream
    from firebreak_gis.placement.gains import by_gain
    from firebreak_gis.placement.orientation import in_standard_orientation

    def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
        return by_gain(
            network,
            stakes,
            downstream,
            n_runs=params.fires,
            recompute_every=params.recompute_every,
            until=params.until,
            seed=seed,
            progress=progress,
        )

    return in_standard_orientation(network, stakes, standard)
