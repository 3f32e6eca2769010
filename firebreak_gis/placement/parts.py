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
    cells = np.concatenate([*lines, np.zeros(0, np.int64)]).astype(np.int64)
    line = np.repeat(np.arange(len(lines)), np.array([each.size for each in lines], np.int64))
    first = np.sort(np.unique(cells, return_index=True)[1])  # a cell belongs to the first wall that has it
    cells, line = cells[first], line[first]
    by = cells[_deciding(lowest[cells] < highest[cells], line)]
    keys = [each.astype(np.int64) for each in (block[cells], highest[by], lowest[by], line)]
    order = np.lexsort(keys)
    begins = np.flatnonzero(np.any([np.diff(key[order], prepend=-1) != 0 for key in keys], axis=0))
    pieces = [cells[each] for each in np.split(order, begins[1:])] if order.size else []
    pieces = [pieces[k] for k in np.argsort(order[begins])]  # as they come along the walls
    wide, costs = walls(pieces, network, stakes, width)
    kept = [k for k, each in enumerate(wide) if each.size]
    return [wide[k] for k in kept], np.array(costs)[kept]


def _deciding(between: np.ndarray, line: np.ndarray) -> np.ndarray:
    """Positions of the cells by which each cell of some walls goes: a cell where walls meet by the one before it.

    Parameters
    ----------
    between
        (n,) bool, whether a cell lies between two compartments alone.
    line
        (n,) number of the wall of each cell, rising.

    Returns
    -------
    numpy.ndarray
        (n,) int64. Cells before the first between two go by that one, those of a wall that has none by its first.
    """
    start = np.searchsorted(line, line)
    known = np.where(between, np.arange(line.size), -1)
    before = np.maximum.accumulate(known)
    following = np.minimum.accumulate(np.where(between, known, line.size)[::-1])[::-1]
    within = following < np.searchsorted(line, line, side="right")
    return np.where(before >= start, before, np.where(within, following, start))
