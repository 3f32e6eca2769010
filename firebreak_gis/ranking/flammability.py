"""Flammability: most flammable cells first, the conventional policy, which looks at each cell alone.

The score is the mean probability with which the cell is lit by its burnable neighbours. Cost: one pass.
Source: the "conventional" baseline of Russo, Russo, Siettos 2016, doi 10.1371/journal.pone.0163226.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from firebreak_gis.placement.edges import mean_lit

if TYPE_CHECKING:
    import numpy as np

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (30, 0)


@dataclass(frozen=True)
class Params:
    """Flammability has no parameters."""


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return the mean probability of being lit, (rows, cols) float64; 0 without burnable neighbours."""
    return mean_lit(network)
