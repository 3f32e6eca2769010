"""Defensible fuel profile zones (DFPZ): broad bands along roads and ridges.

Roads come first if given. Ridges are the lines on which the ways straight uphill meet: each cell counts the cells
from which steepest ascent leads through it, on terrain smoothed over two cells, so that main ridges come before
spurs. A band of `width` cells around them is cut in that order (Agee et al. advise about 400 m, with the fuel reduced
rather than removed: judge it with a residual). Ridges in ground that is hard to hold count as so much smaller. Without
`elevation` the terrain is guessed from the network: fire enters high ground more easily than it leaves it. Cost: one
sort and a few passes over the grid.
Source: Agee et al. 2000, doi 10.1016/S0378-1127(99)00116-4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (230, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the zones along ridges and roads."""

    width: int = parameter(5, text="width of the bands", units="cells", minimum=1, maximum=1000, told="least_width")
    elevation: float | None = parameter(
        None,
        text="terrain elevation raster; default: guessed from the network",
        units="m",
        raster=True,
        told="elevation",
    )
    roads: float | None = parameter(None, text="raster of roads, above 0 on a road", raster=True, told="roads")


def rank(network: SpreadNetwork, params: Params, *, stakes: Stakes, seed: int, progress: Progress) -> np.ndarray:
    """Return the size of the slopes that lead up to the ridge next to each cell, (rows, cols) float64."""
    from firebreak_gis.placement.orientation import in_standard_orientation

    progress(0.0, "finding ridges")
    elevation = _plane(network, params.elevation, "elevation")
    roads = _plane(network, params.roads, "roads")

    def standard(network: SpreadNetwork, stakes: Stakes, turn: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        height = climb(network) if elevation is None else turn(elevation)
        return zones(network, height, None if roads is None else turn(roads) > 0, params.width, stakes.difficulty)

    return in_standard_orientation(network, stakes, standard)


def zones(
    network: SpreadNetwork, height: np.ndarray, roads: np.ndarray | None, width: int, difficulty: np.ndarray
) -> np.ndarray:
    """Priority of every cell: roads, then ridges by size, each with the band around it; then by height."""
    from scipy import ndimage

    from firebreak_gis.kernels.terrain import uphill_area
    from firebreak_gis.placement.widening import offsets

    smooth = ndimage.gaussian_filter(np.nan_to_num(height.astype(np.float64)), 2.0, mode="nearest")
    area = uphill_area(smooth) / np.maximum(difficulty, 1.0)
    if roads is not None:
        area = np.where(roads, float(area.size + 1), area)
    shift = offsets(width)[0] + width // 2
    band = ndimage.maximum_filter(area, size=width, mode="nearest", origin=shift)
    _, own = np.unique(smooth, return_inverse=True)  # cells of a band alike: the highest first
    return np.asarray(band + own.reshape(band.shape) / (own.max() + 1.0))


def climb(network: SpreadNetwork) -> np.ndarray:
    """How much more easily fire enters each cell than it leaves it, (rows, cols) float64."""
    from firebreak_gis.lattice import OPPOSITE
    from firebreak_gis.network import neighbour

    total = np.zeros(network.shape)
    for d in range(8):
        total += neighbour(network.probability[OPPOSITE[d]], d, network.boundary) - network.probability[d]
    return total


def _plane(network: SpreadNetwork, data: object, what: str) -> np.ndarray | None:
    """Plane of a raster parameter; None where none is given. A single number is a plane without relief."""
    if data is None:
        return None
    if isinstance(data, (int, float)):
        return np.full(network.shape, float(data))
    return network.plane(data, what).astype(np.float64)  # type: ignore[arg-type]
