"""Spectral radius and eigenvector of a block of cells small enough to be factorised.

For a matrix without negative entries that is irreducible and any x > 0, the smallest and the largest
(A x)_i / x_i enclose the spectral radius (Collatz, Wielandt). A reducible matrix (islands, one-way edges) has
the largest radius of its strongly connected parts, and radius 0 if it has no cycle.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from scipy.linalg.blas import dtrsv
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import SuperLU, splu

from firebreak_gis.lattice import COL_STEP, ROW_STEP

#: Most solutions with one set of factors.
_SOLUTIONS = 12
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


def grid_matrix(planes: np.ndarray, boundary: str, weights: np.ndarray | None = None) -> sp.csr_array:
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
    values = (values if weights is None else values * weights[d])[inside]
    # scipy's graphs know no longer numbers.
    source, target = ((r * cols + c)[inside].astype(np.int32) for r, c in ((row, col), (to_row, to_col)))
    return sp.csr_array((values, (source, target)), shape=(rows * cols, rows * cols))


def factorise(matrix: sp.csr_array, shift: float) -> SuperLU:
    """Factors of shift * I - A. For a shift above the radius pivots on the diagonal are safe.

    Raises
    ------
    numpy.linalg.LinAlgError
        If the shift is the radius to the last digit.
    MemoryError
        If the factors do not fit.
    """
    identity = sp.eye_array(matrix.shape[0], format="csc")
    # BLAS takes its 32 MB at the first call, and where SuperLU has reserved all that there is it tries to for ever.
    dtrsv(np.eye(1), np.ones(1))
    try:
        return splu(
            (shift * identity - matrix).tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            panel_size=1,  # what wider panels would gain goes into their working space: columns share few rows
            options={"SymmetricMode": True},
        )
    except RuntimeError as error:
        # SuperLU has one class for both. Taken for the other, want of memory would give bounds that are no good.
        if "singular" in str(error):
            raise np.linalg.LinAlgError(str(error)) from error
        raise MemoryError(str(error)) from error


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

    Each step solves (mu I - A) y = x with mu the present upper bound; the bounds close quadratically. Factors cost
    as much as twenty solutions, so each are used for as long as the bounds move.
    """
    found = _Enclosure(matrix)
    shift = guess * (1.0 + 1e-6)  # a guess below the radius is no harm: solutions change their sign, no more
    if guess == 0.0:
        found.improve(found.x, 60)
        shift = found.upper
    for _ in range(40):
        if found.near(tolerance):
            break
        try:
            solver = factorise(matrix, shift * (1.0 + ROUNDING))
        except np.linalg.LinAlgError:  # the shift is the radius to the last digit
            break
        before = found.lower, found.upper
        for _ in range(_SOLUTIONS):
            last = found.lower, found.upper
            found.improve(np.abs(solver.solve(found.x)), 2)  # two steps smooth the rounding of the solution
            if found.near(tolerance) or last == (found.lower, found.upper):
                break
        del solver  # before the next factors are made: they are the most memory that there is here
        if before == (found.lower, found.upper):
            break
        shift = found.upper
    return found.lower * (1.0 - ROUNDING), found.upper * (1.0 + ROUNDING), found.best


class _Enclosure:
    """A positive vector and the bounds of the radius that it and the ones before it prove."""

    def __init__(self, matrix: sp.csr_array) -> None:
        self._matrix = matrix
        self.x = self.best = np.ones(matrix.shape[0])
        self.lower, self.upper = 0.0, np.inf

    def near(self, tolerance: float) -> bool:
        """Whether the bounds are as near to each other as asked."""
        return self.upper <= self.lower * (1.0 + tolerance)

    def improve(self, x: np.ndarray, steps: int) -> None:
        """Go on from x: make power steps, then look at the ratios."""
        x = x / x.max()
        for _ in range(steps):
            x = self._matrix @ x + 0.3 * x
            x /= x.max()
        self.x = x
        if not x.min() > 1e-290:  # so small that ratios lose their digits: the bounds stay where they are
            return
        ratio = self._matrix @ x / x
        self.lower, self.upper = max(self.lower, float(ratio.min())), min(self.upper, float(ratio.max()))
        self.best = x
