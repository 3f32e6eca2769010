"""Spectral radius and eigenvector of a block of cells small enough to be factorised.

For a matrix without negative entries that is irreducible and any x > 0, the smallest and the largest
(A x)_i / x_i enclose the spectral radius (Collatz, Wielandt). A reducible matrix (islands, one-way edges) has
the largest radius of its strongly connected parts, and radius 0 if it has no cycle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import SuperLU, splu

from firebreak_gis.lattice import COL_STEP, ROW_STEP

#: Rounding allowance of a ratio (A x)_i / x_i: nine roundings and some room.
ROUNDING = 1e-14


@dataclass(frozen=True)
class Block:
    """Enclosure of the spectral radius of a block.

    Parameters
    ----------
    lower, upper
        Bounds.
    vector
        (cells,) eigenvector on the strongly connected part with the largest radius, largest entry 1; 0 elsewhere.
    """

    lower: float
    upper: float
    vector: np.ndarray


def grid_matrix(planes: np.ndarray, boundary: str, weights: Sequence[float] | None = None) -> sp.csr_array:
    """Matrix of a small grid, or of a window cut out of a large one (boundary "open"), float64.

    `weights` (8,) are factors of the planes.
    """
    _, rows, cols = planes.shape
    d, row, col = np.nonzero(planes)
    to_row, to_col = row + np.array(ROW_STEP)[d], col + np.array(COL_STEP)[d]
    if boundary == "periodic":
        to_row, to_col = to_row % rows, to_col % cols
    inside = (to_row >= 0) & (to_row < rows) & (to_col >= 0) & (to_col < cols)
    values = planes[d, row, col].astype(np.float64)
    values = (values if weights is None else values * np.asarray(weights)[d])[inside]
    source, target = (row * cols + col)[inside], (to_row * cols + to_col)[inside]
    return sp.csr_array((values, (source, target)), shape=(rows * cols, rows * cols))


def factorise(matrix: sp.csr_array, shift: float) -> SuperLU:
    """Factors of shift * I - A. For a shift above the radius pivots on the diagonal are safe."""
    identity = sp.eye_array(matrix.shape[0], format="csc")
    return splu(
        (shift * identity - matrix).tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )  # fmt: skip


def block_bounds(matrix: sp.csr_array, tolerance: float, *, guess: float = 0.0) -> Block:
    """Enclose the radius of a small matrix, part by part.

    Parameters
    ----------
    matrix
        Square, without negative entries.
    tolerance
        Relative distance of the bounds to aim at.
    guess
        A number near the radius, if one is known; saves factorisations.
    """
    n_parts, part = connected_components(matrix, directed=True, connection="strong")
    source = np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr))
    inner = part[source] == part[matrix.indices]
    row_sum = np.bincount(source[inner], weights=matrix.data[inner], minlength=matrix.shape[0])
    ceiling = np.zeros(n_parts)
    np.maximum.at(ceiling, part, row_sum)
    vector = np.zeros(matrix.shape[0])
    lower = upper = 0.0
    for k in np.argsort(-ceiling, kind="stable"):
        if ceiling[k] * (1.0 + ROUNDING) <= lower or ceiling[k] == 0.0:
            break
        cells = np.flatnonzero(part == k)
        low, high, x = _irreducible(matrix[cells][:, cells], tolerance, guess)
        if low > lower:
            lower = low
            vector[:] = 0.0
            vector[cells] = x
        upper = max(upper, high)
    return Block(lower, max(lower, upper), vector)


def _irreducible(matrix: sp.csr_array, tolerance: float, guess: float) -> tuple[float, float, np.ndarray]:
    """Bounds and eigenvector of an irreducible matrix by Noda's iteration (1971, doi 10.1007/BF01436384).

    Each step solves (mu I - A) y = x with mu the present upper bound; the bounds close quadratically.
    """
    x = _near(matrix, guess) if guess > 0.0 else None
    smoothing = 2 if x is not None else 60
    x = np.ones(matrix.shape[0]) if x is None else x
    lower, upper, best = 0.0, np.inf, x
    for step in range(40):
        for _ in range(smoothing):  # later, a few steps smooth the rounding of the solve
            x = matrix @ x + 0.3 * x
            x /= x.max()
        smoothing = 2
        if not x.min() > 1e-290:  # so small that ratios lose their digits: the bounds stay where they are
            break
        ratio = matrix @ x / x
        low, high = float(ratio.min()), float(ratio.max())
        if step > 2 and low <= lower and high >= upper:
            break
        lower, upper, best = max(lower, low), min(upper, high), x
        if upper <= lower * (1.0 + tolerance):
            break
        try:
            y = np.abs(factorise(matrix, upper * (1.0 + ROUNDING)).solve(x))
        except RuntimeError:  # the bound is the radius to the last digit
            break
        x = y / y.max()
    return lower * (1.0 - ROUNDING), upper * (1.0 + ROUNDING), best


def _near(matrix: sp.csr_array, guess: float) -> np.ndarray | None:
    """Inverse iteration just above a guess; None if the guess is below the radius."""
    solver = factorise(matrix, guess * (1.0 + 1e-6))
    x = np.ones(matrix.shape[0])
    for _ in range(4):
        x = solver.solve(x)
        if not x.min() > 0.0:
            return None
        x /= x.max()
    return x
