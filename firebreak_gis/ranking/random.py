"""Random: cells in random order, the baseline that every plan must beat.

The order is a uniform random permutation keyed by the seed. Cost: one draw a cell.
Source: Russo, Russo, Siettos 2016, doi 10.1371/journal.pone.0163226.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.draws import stream_key, uniforms

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (80, 0)


@dataclass(frozen=True)
class Params:
    """A random order has no parameters; the seed alone decides."""


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return a uniform number a cell, (rows, cols) float64."""
    return uniforms(stream_key(seed, "ranking"), network.burnable.size).reshape(network.shape)
