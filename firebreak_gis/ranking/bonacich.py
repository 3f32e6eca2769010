"""Bonacich power centrality: cells through which fire reaches cells that are easily reached themselves.

x = (I - beta / lambda_max A)^-1 A 1, where a_lk is the probability that l lights k and lambda_max is the largest
eigenvalue of A. beta sets how far a cell looks: 0 is the degree; towards 1 x grows without bound in the direction of
the eigenvector, which is what beta = 1 returns (largest entry 1). `in` uses A transposed (how fire arrives; the
orientation of the paper), `out` uses A (how fire leaves).

lambda_max is enclosed between two bounds, of which the upper one is taken, and the solution for it is accurate to 1e-10
in every cell. The bounds are 1e-9 apart, but 1e-4 to 1e-3 where the densest fuel is the same over more than 240 x 240
cells; there cells look as much less far than `beta` says. A network of several
islands has one lambda_max, that of the strongest. A network without cycles has lambda_max = 0: the formula has no
value there and the degree is returned. With `recompute_every` the centrality is found anew on the network
that is left after every few cuts, and the order of removal is returned.

Cost: a few products with A for lambda_max, then about 23 / -ln(beta) products of 1-2 ns a cell each, for every round;
memory about 45 B a cell. Ties fall to the cell first in (row, col).
Source: Bonacich 1987, doi 10.1086/228631; Russo, Russo, Siettos 2016, doi 10.1371/journal.pone.0163226.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from firebreak_gis.plugins import parameter
from firebreak_gis.progress import part

if TYPE_CHECKING:
    import numpy as np

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (80, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the Bonacich centrality."""

    beta: float = parameter(
        0.5,
        text="how far a cell looks: 0 is the degree, 1 the eigenvector",
        minimum=0.0,
        maximum=1.0,
    )
    orientation: str = parameter(
        "in", text="whether fire arriving at the cell (in) or leaving it (out) counts", choices=("in", "out")
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
    """Return the Bonacich centrality, or the order of removal, (rows, cols) float64."""
    from firebreak_gis.placement.rounds import centrality_in_rounds

    return centrality_in_rounds(
        network,
        stakes,
        lambda left, step: _scores(left, params, step),
        recompute_every=params.recompute_every,
        until=params.until,
        progress=progress,
    )


def _scores(network: SpreadNetwork, params: Params, progress: Progress) -> np.ndarray:
    from firebreak_gis.kernels.linear import katz
    from firebreak_gis.kernels.spectrum import perron_vector, spectral_radius

    attenuation = 0.0
    if params.beta > 0.0:
        radius = spectral_radius(
            network.probability, boundary=network.boundary, progress=part(progress, 0.0, 0.5)
        ).upper
        if params.beta == 1.0 and radius > 0.0:
            return perron_vector(
                network.probability,
                boundary=network.boundary,
                transpose=params.orientation == "in",
                progress=part(progress, 0.5, 1.0),
            )
        attenuation = params.beta / radius if radius > 0.0 else 0.0
    solution = katz(
        network.probability,
        attenuation,
        params.beta,
        boundary=network.boundary,
        transpose=params.orientation == "in",
        progress=part(progress, 0.5, 1.0),
    )
    progress(1.0, f"Bonacich done, relative error below {solution.error:.1e}")
    return solution.values
