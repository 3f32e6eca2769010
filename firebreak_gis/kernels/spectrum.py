"""The largest eigenvalue of a spread network between two bounds that hold.

For a matrix without negative entries and any x > 0, the smallest and the largest (A x)_i / x_i enclose the
spectral radius if the matrix is irreducible, and the largest bounds it from above in any case (Collatz,
Wielandt). A diagonal block never has a larger radius than the whole. A reducible network (islands, one-way
edges) has the largest radius of its strongly connected parts; one without cycles has radius 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.sparse.linalg import splu

from firebreak_gis.kernels.linear import Operator
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.progress import Progress, silent

#: Largest grid, in cells, that is treated as one block.
DIRECT_CELLS = 40_000
#: Rounding allowance of a ratio (A x)_i / x_i: nine roundings and some room.
_ROUNDING = 1e-14


@dataclass(frozen=True)
class Bounds:
    """Enclosure of the spectral radius.

    Parameters
    ----------
    lower, upper
        The radius lies between them.
    """

    lower: float
    upper: float

    @property
    def width(self) -> float:
        """Relative distance of the bounds; 0 for radius 0."""
        return self.upper / self.lower - 1.0 if self.lower > 0.0 else (0.0 if self.upper == 0.0 else np.inf)


def spectral_radius(
    probability: np.ndarray,
    *,
    boundary: str = "open",
    tolerance: float = 1e-9,
    threads: int | None = None,
    progress: Progress = silent,
) -> Bounds:
    """Enclose the largest eigenvalue of A.

    Parameters
    ----------
    probability
        (8, rows, cols) float32.
    boundary, threads
        As for `Operator`.
    tolerance
        Relative distance of the bounds to aim at. They hold even where it is not met.
    progress
        Callback.
    """
    planes = np.asarray(probability)
    if planes[0].size <= DIRECT_CELLS:
        return block_bounds(grid_matrix(planes, boundary), 1e-3 * tolerance)[0]
    return _power_bounds(planes, boundary, tolerance, threads, progress)


def grid_matrix(planes: np.ndarray, boundary: str) -> sp.csr_array:
    """Matrix of a small grid, or of a window cut out of a large one (with open edges), float64."""
    _, rows, cols = planes.shape
    d, row, col = np.nonzero(planes)
    to_row, to_col = row + np.array(ROW_STEP)[d], col + np.array(COL_STEP)[d]
    if boundary == "periodic":
        to_row, to_col = to_row % rows, to_col % cols
    inside = (to_row >= 0) & (to_row < rows) & (to_col >= 0) & (to_col < cols)
    weights = planes[d, row, col].astype(np.float64)[inside]
    source, target = (row * cols + col)[inside], (to_row * cols + to_col)[inside]
    return sp.csr_array((weights, (source, target)), shape=(rows * cols, rows * cols))


def block_bounds(matrix: sp.csr_array, tolerance: float) -> tuple[Bounds, np.ndarray]:
    """Enclose the radius of a small matrix.

    Returns
    -------
    tuple
        The bounds, and the cells of the strongly connected part that has the largest radius (empty at radius 0).
    """
    n_parts, part = connected_components(matrix, directed=True, connection="strong")
    sizes = np.bincount(part, minlength=n_parts)
    lower = upper = 0.0
    dominant = np.empty(0, dtype=np.int64)
    row_part = np.repeat(part, np.diff(matrix.indptr))
    inner = row_part == part[matrix.indices]
    row_sum = np.zeros(matrix.shape[0])
    np.add.at(row_sum, np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr))[inner], matrix.data[inner])
    ceiling = np.zeros(n_parts)
    np.maximum.at(ceiling, part, row_sum)
    for k in np.argsort(-ceiling, kind="stable"):
        if sizes[k] < 2 or ceiling[k] * (1.0 + _ROUNDING) <= lower:
            continue
        cells = np.flatnonzero(part == k)
        low, high, _ = irreducible_bounds(matrix[cells][:, cells], tolerance)
        if low > lower:
            lower, dominant = low, cells
        upper = max(upper, high)
    return Bounds(lower, max(lower, upper)), dominant


def irreducible_bounds(matrix: sp.csr_array, tolerance: float) -> tuple[float, float, np.ndarray]:
    """Bounds and Perron vector of an irreducible matrix by Noda's iteration (1971, doi 10.1007/BF01436384).

    Each step solves (mu I - A) y = x with mu the present upper bound; the bounds close quadratically.
    """
    x = np.ones(matrix.shape[0])
    for _ in range(50):
        x = matrix @ x + x
        x /= x.max()
    identity = sp.eye_array(matrix.shape[0], format="csc")
    lower, upper, best = 0.0, np.inf, x
    for _ in range(40):
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = matrix @ x / x
        if not (x > 0.0).all() or not np.isfinite(ratio).all():
            break
        before = upper / lower if lower > 0.0 else np.inf
        lower, upper = max(lower, float(ratio.min())), min(upper, float(ratio.max()))
        best = x
        if upper <= lower * (1.0 + tolerance) or upper / max(lower, 1e-300) >= before * (1.0 - 1e-12):
            break
        try:
            y = splu(identity * (upper * (1.0 + 1e-15)) - matrix.tocsc(), diag_pivot_thresh=0.0).solve(x)
        except RuntimeError:  # the bound is the radius to the last digit
            break
        x = np.abs(y) / np.abs(y).max()
    return lower * (1.0 - _ROUNDING), upper * (1.0 + _ROUNDING), best


def _power_bounds(
    planes: np.ndarray, boundary: str, tolerance: float, threads: int | None, progress: Progress
) -> Bounds:
    """Bounds of a large network from power steps alone."""
    with Operator(planes, boundary=boundary, threads=threads) as operator:
        x, y = np.ones(operator.shape), np.empty(operator.shape)
        lower, upper = 0.0, np.inf
        for step in range(200):
            operator.apply(x, y)
            ratio = y / x
            upper = min(upper, float(ratio.max()))
            y += 0.5 * x
            y /= y.max()
            x, y = y, x
            progress(step / 200, "largest eigenvalue")
    return Bounds(lower, upper * (1.0 + _ROUNDING))


def perron_vector(planes: np.ndarray, boundary: str) -> np.ndarray:
    """Eigenvector of the largest eigenvalue of a small grid, (rows, cols), largest entry 1, 0 where it vanishes."""
    matrix = grid_matrix(planes, boundary)
    bounds, dominant = block_bounds(matrix, 1e-12)
    if dominant.size == 0:
        return np.zeros(planes.shape[1:])
    identity = sp.eye_array(matrix.shape[0], format="csc")
    solver = splu((identity * (bounds.upper * (1.0 + 1e-11)) - matrix).tocsc(), diag_pivot_thresh=0.0)
    x = np.ones(matrix.shape[0])
    for _ in range(5):
        x = np.abs(solver.solve(x))
        x /= x.max()
    # Exactly the cells from which the dominant part can be reached have a positive entry.
    reached = dijkstra(matrix.T.tocsr(), indices=dominant, min_only=True, unweighted=True)
    x[~np.isfinite(reached)] = 0.0
    return (x / x.max()).reshape(planes.shape[1:])
