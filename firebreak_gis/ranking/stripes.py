"""Stripes: parallel bands across a direction, the plainest pattern of practice.

Bands lie evenly spaced across `direction`, the heading of the fires expected; by default the one of eight headings,
and the shift of the pattern, that leave the least expected loss (ignitions times values, by compartment). Bands stop
spread over corners; where ground is better to hold beside them they bend to it, by up to a quarter of the spacing. The
middle band comes first, then those that halve what is left, then the cells nearest to the bands, which widens them.
Cost: about 30 passes over the grid.
Source: linear fuel breaks and their spacing, Finney 2001, doi 10.1093/forestscience/47.2.219.
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
MEMORY = (180, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the stripes."""

    direction: float | None = parameter(
        None,
        text="heading that the bands lie across, clockwise from north; default: the best of eight",
        units="degree",
        minimum=0.0,
        maximum=360.0,
    )
    width: int = parameter(1, text="width of the bands", units="cells", minimum=1, maximum=1000, told="least_width")
    spacing: float | None = parameter(
        None, text="from band to the next; default: the densest that the budget affords", units="cells", minimum=1.0
    )
    cost_share: float = parameter(
        0.05,
        text="share of the cost of all fuel that the pattern may take",
        minimum=1e-6,
        maximum=1.0,
        told="cost_share",
    )


def rank(network: SpreadNetwork, params: Params, *, stakes: Stakes, seed: int, progress: Progress) -> np.ndarray:
    """Return the order of cutting, (rows, cols) float64, highest first."""
    from firebreak_gis.placement.orientation import in_standard_orientation
    from firebreak_gis.placement.patterns import best_pattern, stripes

    def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
        headings = (0.0, 45.0, 90.0, 135.0, 22.5, 67.5, 112.5, 157.5)
        return best_pattern(
            network,
            stakes,
            stripes,
            azimuths=headings if params.direction is None else (params.direction,),
            width=params.width,
            spacing=params.spacing,
            families=1,
            cost_share=params.cost_share,
            progress=progress,
        )

    if params.direction is None:
        return in_standard_orientation(network, stakes, standard)
    return standard(network, stakes, None)
