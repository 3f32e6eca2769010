"""Compartments: a square grid of bands that encloses equal ones.

Bands of `width` cells lie `spacing` cells apart along `direction` and across it; enclosing squares of s cells takes
2 / s of the land. By default the turn (0 or 45 degrees) and the shift with the least expected loss are taken, and the
densest grid that the budget affords. Bands stop spread over corners; where ground is better to hold beside them they
bend to it, by up to a quarter of the spacing. Middle bands come first, those of the two directions in turn, then the
cells nearest to the bands. Cost: about 20 passes over the grid.
Source: compartments of a primary network, Oliveira, Barros, Ager, Fernandes 2016, doi 10.1071/WF15146.
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
    """Parameters of the square compartments."""

    direction: float | None = parameter(
        None,
        text="direction of one set of bands, clockwise from north; default: the better of 0 and 45",
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
    from firebreak_gis.placement.patterns import best_pattern, square_grid

    def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
        return best_pattern(
            network,
            stakes,
            square_grid,
            azimuths=(0.0, 45.0) if params.direction is None else (params.direction,),
            width=params.width,
            spacing=params.spacing,
            families=2,
            cost_share=params.cost_share,
            progress=progress,
        )

    if params.direction is None:
        return in_standard_orientation(network, stakes, standard)
    return standard(network, stakes, None)
