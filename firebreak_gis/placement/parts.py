"""Walls split into parts: where the compartments beside them change, and where breaks fail by stretches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.lattice import ROW_STEP
from firebreak_gis.network import neighbour
from firebreak_gis.placement.widening import walls

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes


def parts_of(
    lines: Sequence[np.ndarray],
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    width: int = 1,
    stretch: np.ndarray | None = None,
) -> tuple[list[np.ndarray], np.ndarray]:
    """Split walls where the compartments beside them change.

    Parameters
    ----------
    lines
        Row-major cells of each wall one cell wide, those that are built first at first.
    width
        Cells across a wall.
    stretch
        (rows, cols) block in which breaks hold or fail together; parts end at its border too. None where all hold.

    Returns
    -------
    cells : list of numpy.ndarray
        Of each part in full width; a cell belongs to the first part that needs it.
    costs : numpy.ndarray
        (n_parts,) float64.
    """
    from scipy import ndimage

    drawn = np.zeros(network.shape, bool)
    drawn.ravel()[np.concatenate([*lines, np.zeros(0, np.int64)]).astype(np.int64)] = True
    label, count = ndimage.label(network.burnable & ~drawn, structure=np.ones((3, 3)))
    low, high = np.full(network.shape, count + 1, label.dtype), np.zeros(network.shape, label.dtype)
    for d in range(len(ROW_STEP)):
        beside = neighbour(label, d, network.boundary)
        np.minimum(low, beside, out=low, where=beside > 0)
        np.maximum(high, beside, out=high)
    lowest, highest = low.ravel(), high.ravel()
    block = np.zeros(lowest.size, np.uint8) if stretch is None else stretch.ravel()
    taken = np.zeros(lowest.size, bool)
    pieces: list[np.ndarray] = []
    for line in lines:
        own = line[~taken[line]]
        taken[own] = True
        if own.size == 0:
            continue
        # A cell where walls meet goes with the one before it.
        met = np.where(lowest[own] < highest[own], np.arange(own.size), -1)
        first = int(np.argmax(met >= 0))
        by = own[np.maximum.accumulate(np.where(met < 0, first if met[first] >= 0 else 0, met))]
        keys = np.stack([lowest[by], highest[by], block[own]])
        _, where, group = np.unique(keys, axis=1, return_index=True, return_inverse=True)
        pieces += [own[group.ravel() == k] for k in np.argsort(where)]
    cells, costs = walls(pieces, network, stakes, width)
    kept = [k for k, each in enumerate(cells) if each.size]
    return [cells[k] for k in kept], np.array(costs)[kept]
