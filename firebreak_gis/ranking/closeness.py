"""Closeness centrality: cells that fire reaches soon from anywhere, or from which it soon reaches anywhere.

The score is r / (n - 1) * r / (sum of distances) over the r of n - 1 other burnable cells that have a route; where
every cell has one this ranks as 1 / (sum of distances). The first factor keeps small islands, whose distances are
short, from coming first (Wasserman, Faust 1994, p. 200). A cell with no route has 0. An edge l -> k is
1 / p(l -> k) long. `in` takes routes to the cell (how soon fire arrives), `out` routes from it. The default `in` is a
choice, as for the other centralities: the words of the paper, the distance from a node to all others, say `out`.

Cost: a search a burnable cell, about 35 ns a cell each, so it grows with the square of the cells; memory 32 B a cell
and about 60 B a cell and thread.
Source: Freeman 1978, doi 10.1016/0378-8733(78)90021-7; Russo, Russo, Siettos 2016,
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
MEMORY = (170, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the closeness."""

    orientation: str = parameter("in", text="routes counted: to the cell (in) or from it (out)", choices=("in", "out"))


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the closeness, (rows, cols) float64."""
    from firebreak_gis.kernels.centrality import closeness

    scores = closeness(
        network.probability,
        network.burnable,
        boundary=network.boundary,
        transpose=params.orientation == "in",
        progress=progress,
    )
    progress(1.0, f"closeness of {network.n_burnable} cells done")
    return scores
