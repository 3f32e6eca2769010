"""Degree: cells that are lit by, or light, their neighbours most.

`in` sums the probabilities of the edges into a cell (how easily fire arrives), `out` those of the edges out
of it (how readily fire leaves). Cells without edges have 0. Cost: one pass over the probabilities.
Source: Russo, Russo, Siettos 2016, doi 10.1371/journal.pone.0163226; Freeman 1978,
doi 10.1016/0378-8733(78)90021-7.
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
MEMORY = (80, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the degree."""

    orientation: str = parameter(
        "in", text="edges counted: into the cell (in) or out of it (out)", choices=("in", "out")
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the sum of probabilities into or out of each cell, (rows, cols) float64."""
    from firebreak_gis.kernels.linear import degree

    scores = degree(network.probability, boundary=network.boundary, transpose=params.orientation == "in")
    progress(1.0, "degree done")
    return scores
