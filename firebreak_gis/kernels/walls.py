"""Breaks that may fail, run by run: which treated cells hold, and what passes them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.draws import below, digits_of, edge_draw, word
from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import inlined, kernel

_ONE = np.uint64(1)


class Walls(NamedTuple):
    """Treated cells. Without any, the arrays of cells are empty.

    Parameters
    ----------
    near
        (n_cells,) bool: whether a neighbour of the cell is treated.
    holds
        (n_cells,) uint32, `draws.digits_of` the probability that the cell holds in a run; 0 for untreated ones.
    stretch
        (n_cells,) uint32: cells of one stretch hold or fail by one draw a run.
    keys
        (n_runs,) uint64 from `draws.run_keys`.
    residual
        Share of its spread probability that a cell keeps where it holds.
    probability
        (8, n_cells) float32 of the network without breaks.
    """

    near: np.ndarray
    holds: np.ndarray
    stretch: np.ndarray
    keys: np.ndarray
    residual: np.float32
    probability: np.ndarray


@inlined
def stands(walls: Walls, run: int, cell: np.uint64) -> bool:
    """Whether a cell is treated and holds in the run."""
    threshold = np.uint64(walls.holds[cell])
    result = False
    if threshold != np.uint64(0):
        draw = word(walls.keys[run], np.uint64(walls.stretch[cell])) >> np.uint64(32)
        result = below(draw, threshold)
    return result


@kernel
def held_back(
    walls: Walls, run: int, key: np.uint64, steps: Steps, position: np.uint8, cell: np.uint64, opened: np.uint64
) -> np.uint64:
    """What is left of the open edges of a cell once the breaks beside it have done their work.

    The probability of an edge into a cell that holds is multiplied by `residual`; the draw stays the same.
    """
    for d in range(8):
        bit = np.uint64(8 * d + 7)
        if (opened >> bit) & _ONE and stands(walls, run, cell + steps.offsets[position, d]):
            passes = False
            if walls.residual > np.float32(0):
                left = np.float32(walls.probability[d, cell] * walls.residual)
                passes = below(edge_draw(key, cell, np.uint64(d)), digits_of(np.float64(left)))
            if not passes:
                opened &= ~(_ONE << bit)
    return opened
