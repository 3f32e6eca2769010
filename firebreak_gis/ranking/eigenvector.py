"""Eigenvector centrality: cells next to the cells that matter most, all in one place of the map.

The eigenvector of the largest eigenvalue of A (a_lk = probability that l lights k), largest entry 1. `in` uses A
transposed (how fire arrives), `out` uses A (how fire leaves). On a heterogeneous landscape it is localised: almost
all weight lies around the densest spot and it falls off exponentially from there, which makes it a poor plan
(the paper shows it as such).

Cells that cannot light the dominant part of the network (`in`: be lit from it), other islands among them, have 0;
so has every cell of a network without cycles, whose largest eigenvalue is 0. Cost: up to 40,000 cells a sparse
factorisation, accurate to 1e-9 in every cell; beyond, up to 2,000 products with A of 1-2 ns a cell, until no entry
changes by more than 1e-9 of the largest in a step; memory about 70 B a cell.
Source: Bonacich 1972, doi 10.1080/0022250X.1972.9989806; Russo, Russo, Siettos 2016,
doi 10.1371/journal.pone.0163226.
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
MEMORY = (100, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the eigenvector centrality."""

    orientation: str = parameter(
        "in", text="whether fire arriving at the cell (in) or leaving it (out) counts", choices=("in", "out")
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the eigenvector of the largest eigenvalue, (rows, cols) float64, largest entry 1."""
    from firebreak_gis.kernels.spectrum import perron_vector

    scores = perron_vector(
        network.probability, boundary=network.boundary, transpose=params.orientation == "in", progress=progress
    )
    progress(1.0, "eigenvector done")
    return scores
