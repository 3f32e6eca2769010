"""Breaks of a least width under any ranking: each cell brings the square around it along."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes


def thickened(position: np.ndarray, network: SpreadNetwork, stakes: Stakes, width: int) -> np.ndarray:
    """Priority in which every cell is followed by what its square lacks.

    The first cells of it, at any budget, are whole squares of `width` cells (without protected cells and those that
    hold no fuel), but for the last one. The square lies around its cell as in `widening.offsets`.

    Parameters
    ----------
    position
        (rows, cols) int64 place in the order of cutting, -1 for cells that are never cut.
    network, stakes
        What is planned for.
    width
        Cells across a break.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64, higher is cut earlier; -inf for cells that are never cut.
    """
    from scipy import ndimage

    never = position.size
    first = np.where(position < 0, never, position)
    # A cell belongs to the earliest of the squares that hold it.
    mode = "wrap" if network.boundary == "periodic" else "constant"
    first = ndimage.minimum_filter(first, size=width, mode=mode, cval=never)
    cells = np.flatnonzero((network.burnable & ~stakes.protected & (first < never)).ravel())
    own = np.where(position.ravel()[cells] < 0, never, position.ravel()[cells])
    order = cells[np.lexsort((cells, own, first.ravel()[cells]))]
    priority = np.full(position.size, -np.inf)
    priority[order] = np.arange(order.size, 0, -1.0)
    return priority.reshape(position.shape)
