"""How fire passes between neighbours: either way at all, and on average into a cell."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.lattice import OPPOSITE
from firebreak_gis.network import neighbour

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork


def passable(network: SpreadNetwork, direction: int) -> np.ndarray:
    """Where fire can pass between a cell and its neighbour in a direction, either way; (rows, cols) bool."""
    back = neighbour(network.probability[OPPOSITE[direction]], direction, network.boundary)
    return np.asarray((network.probability[direction] > 0) | (back > 0))


def mean_lit(network: SpreadNetwork) -> np.ndarray:
    """Mean probability with which a cell is lit by its neighbours that hold fuel, (rows, cols) float64; 0 without."""
    total, count = np.zeros(network.shape), np.zeros(network.shape)
    for d in range(8):
        total += neighbour(network.probability[OPPOSITE[d]], d, network.boundary)
        count += neighbour(network.burnable, d, network.boundary)
    return np.asarray(total / np.maximum(count, 1.0))


def links(network: SpreadNetwork) -> np.ndarray:
    """Bits of the directions in which fire can pass either way, (rows, cols) uint8."""
    out = np.zeros(network.shape, np.uint8)
    for d in range(8):
        out |= passable(network, d).astype(np.uint8) << np.uint8(d)
    return out
