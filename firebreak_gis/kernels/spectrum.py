"""The largest eigenvalue of a spread network, between two bounds that hold, and its eigenvector."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse.csgraph import dijkstra

from firebreak_gis.kernels.blocks import block_bounds, factorise, grid_matrix
from firebreak_gis.kernels.certificate import localised_bounds, tilt
from firebreak_gis.kernels.linear import Operator
from firebreak_gis.lattice import COL_STEP, OPPOSITE, ROW_STEP
from firebreak_gis.progress import Progress, part, silent

#: Largest grid, in cells, that is treated as one block.
DIRECT_CELLS = 40_000
#: Most power steps towards the eigenvector of a larger grid, and the change, relative to the largest
#: entry, that ends them.
_EIGENVECTOR_STEPS, _EIGENVECTOR_CHANGE = 2_000, 1e-10


@dataclass(frozen=True)
class Bounds:
    """Enclosure of the largest eigenvalue.

    Parameters
    ----------
    lower, upper
        The eigenvalue lies between them. Both 0 for a network without cycles.
    """

    lower: float
    upper: float

    @property
    def width(self) -> float:
        """Relative distance of the bounds."""
        if self.upper == 0.0:
            return 0.0
        return self.upper / self.lower - 1.0 if self.lower > 0.0 else float("inf")


def spectral_radius(
    probability: np.ndarray,
    *,
    boundary: str = "open",
    tolerance: float = 1e-9,
    direct_cells: int = DIRECT_CELLS,
    threads: int | None = None,
    progress: Progress = silent,
) -> Bounds:
    """Enclose the largest eigenvalue of A.

    Cost: a few sparse factorisations up to `direct_cells`, to 1e-12; beyond, about 60 products with A and windows of
    up to 240 x 240 cells. The bounds always hold. They miss the tolerance on landscapes whose dense part is larger
    than that and uniform, where the eigenvector is not localised: 240 uniform cells a side leave about 1e-4.

    Parameters
    ----------
    probability
        (8, rows, cols) float32.
    boundary, threads
        As for `Operator`.
    tolerance
        Relative distance of the bounds to aim at.
    direct_cells
        Largest grid that is treated as one block.
    progress
        Callback.
    """
    planes = np.asarray(probability)
    if planes[0].size <= direct_cells:
        block = block_bounds(grid_matrix(planes, boundary), min(1e-12, tolerance))
        return Bounds(block.lower, block.upper)
    weights = tilt(planes) if boundary == "open" else None
    with Operator(planes, boundary=boundary, weights=weights, threads=threads) as operator:
        lower, upper, _ = localised_bounds(operator, tolerance, progress)
    return Bounds(lower, upper)


def perron_vector(
    probability: np.ndarray,
    *,
    boundary: str = "open",
    transpose: bool = False,
    direct_cells: int = DIRECT_CELLS,
    threads: int | None = None,
    progress: Progress = silent,
) -> np.ndarray:
    """Eigenvector of the largest eigenvalue of A (or A^T), what power steps from 1 tend to.

    Parameters
    ----------
    probability
        (8, rows, cols) float32.
    boundary, transpose, threads
        As for `Operator`.
    direct_cells
        Largest grid that is factorised.
    progress
        Callback.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64, largest entry 1; 0 in cells that cannot light (transposed: be lit by) the dominant part.
    """
    planes = np.asarray(probability)
    if planes[0].size > direct_cells:
        return _power_vector(planes, boundary, transpose, threads, progress)
    matrix = grid_matrix(planes, boundary)
    matrix = matrix.T.tocsr() if transpose else matrix
    block = block_bounds(matrix, 1e-12)
    dominant = np.flatnonzero(block.vector)
    if dominant.size == 0:
        return np.zeros(planes.shape[1:])
    solver = factorise(matrix, block.upper * (1.0 + 1e-11))
    x = np.ones(matrix.shape[0])
    for _ in range(5):
        x = np.abs(solver.solve(x))
        x /= x.max()
    # Exactly the cells from which the dominant part can be reached have a positive entry.
    steps = dijkstra(matrix.T.tocsr(), indices=dominant, min_only=True, unweighted=True)
    x[~np.isfinite(steps)] = 0.0
    return np.asarray(x / x.max()).reshape(planes.shape[1:])


def _power_vector(
    planes: np.ndarray, boundary: str, transpose: bool, threads: int | None, progress: Progress
) -> np.ndarray:
    """Power steps on a large grid, from the vector that encloses the eigenvalue."""
    if transpose:
        # Edges that would wrap on an open map are 0.
        planes = np.stack([np.roll(planes[OPPOSITE[d]], (-ROW_STEP[d], -COL_STEP[d]), axis=(0, 1)) for d in range(8)])
    with Operator(planes, boundary=boundary, threads=threads) as operator:
        lower, upper, x = localised_bounds(operator, 1e-9, part(progress, 0.0, 0.3))
        if lower == 0.0:
            return np.zeros(operator.shape)
        x /= x.max()
        y = np.empty(operator.shape)
        for step in range(_EIGENVECTOR_STEPS):
            # Not the whole step: A / lambda could oscillate.
            operator.apply(x, y, scale=1.0 / upper)
            operator.combine(0.75, y, 0.25, x, y)
            x, y = y, x
            if step % 16 == 15:
                change = operator.change(x, y) / float(x.max())
                progress(0.3 + 0.7 * step / _EIGENVECTOR_STEPS, f"eigenvector: change {change:.1e}")
                if change < _EIGENVECTOR_CHANGE + (upper / lower - 1.0):
                    break
        return x / x.max()
