"""Nested minimum cuts: walls between compartments, those that save most for their cost first.

Each compartment is split by the exact minimum vertex cut between opposite ends, in several directions, that saves
the largest expected loss for its cost; the pieces are split in turn. Costs are the capacities, protected cells are
never in a wall, cells without fuel are free, and ignitions and values at risk set what a wall saves. Walls stop
spread over corners too. A wall is worth little before it is closed, so budgets between two walls gain little.

Breaks that leak need width: with `width` above 1 each wall is widened before the next is built, see also
`firebreak_gis.placement.widening`. Cells in no wall come last, those of the costliest compartments first.

Cost: about n ** 1.35; on two cores 2 s for 43,000 and 12 s for 172,000 cells. Memory about 200 B a cell and thread.
Source: vertex cuts by flow between the ends of the map, Schild, Sommer 2015, doi 10.1007/978-3-319-20086-6_22;
warm starts, Hamann, Strasser 2018, doi 10.1145/3173045; order of building, Horn 1972, doi 10.1137/0123021.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.methods import parameter

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.setting import Setting

#: Walls of equal cost are many, and the order of the cells decides between them: turned maps give plans that are
#: equally good, not the same cell by cell.
UNIQUE = False


@dataclass(frozen=True)
class Params:
    """Parameters of the dissection."""

    directions: int = parameter(8, text="directions in which walls are sought", minimum=1, maximum=64)
    smallest: int = parameter(16, text="compartments of fewer cells are not split", units="cells", minimum=2)
    width: int = parameter(1, text="width of the walls", units="cells", minimum=1, maximum=100)


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    setting: Setting,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the order of cutting, (rows, cols) float64, highest first."""
    from firebreak_gis.kernels.linear import degree
    from firebreak_gis.placement.dissection import dissect, lines_first, sequence

    cuts = dissect(network, setting, directions=params.directions, smallest=params.smallest, progress=progress)
    order = sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])
    # The most flammable first where no compartment tells cells apart; below 1, since compartments count whole cells.
    score = np.asarray(degree(network.probability, boundary=network.boundary, transpose=True)) / 9.0
    for cut in cuts:  # parents come first, so the smallest compartment of a cell counts
        score.ravel()[cut.compartment] = cut.compartment.size + score.ravel()[cut.compartment] % 1.0
    return lines_first([cuts[i].cells for i in order], setting, score)
