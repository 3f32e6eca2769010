"""Linear algebra on the probability planes: y = A x and what follows from it, without a matrix.

A is the adjacency matrix a_lk = p(l -> k). Row l of A x gathers x over the cells that l can light; row l of
A^T x gathers over the cells that can light l. Both read the planes in place: 32 B of probability, 8 B of x
and 8 B of y a cell, which is what limits them.

The eight products of a cell are summed as ((N + S) + (E + W)) + ((NE + SW) + (SE + NW)). This grouping is
its own image under every mirror and quarter turn, so the products of a mirrored network are the mirrored
products to the last bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.bands import Bands
from firebreak_gis.kernels.policy import inlined, kernel
from firebreak_gis.progress import Progress, silent

if TYPE_CHECKING:
    from types import TracebackType

#: Above this beta the Neumann series is left for BiCGSTAB.
KRYLOV_ABOVE = 0.95
#: Products between two looks at the residual.
_CHECK_EVERY = 8
#: From this contraction on the Neumann series is preceded by Chebyshev steps.
_ACCELERATE_FROM = 0.3


class Operator:
    """A or its transpose on the planes of one network.

    Parameters
    ----------
    probability
        (8, rows, cols) float32, `probability[d, row, col]` from the cell to its neighbour in direction d;
        0 on edges that leave an open grid.
    boundary
        `"open"` or `"periodic"` (then at least 3 rows and columns).
    transpose
        Whether to multiply by A^T.
    weights
        (8,) factors of the planes; none is faster than all 1.
    threads
        Number of threads; the result does not depend on it.
    """

    def __init__(
        self,
        probability: np.ndarray,
        *,
        boundary: str = "open",
        transpose: bool = False,
        weights: np.ndarray | None = None,
        threads: int | None = None,
    ) -> None:
        planes = np.ascontiguousarray(probability, dtype=np.float32).view()
        planes.flags.writeable = False  # one compiled version for frozen and other arrays
        self.probability = planes
        self.periodic = boundary == "periodic"
        self.transpose = transpose
        self.weights = None if weights is None else np.asarray(weights, dtype=np.float64)
        self.shape: tuple[int, int] = (planes.shape[1], planes.shape[2])
        self._bands = Bands(self.shape, threads)
        self._by_row = np.empty(self.shape[0])

    def __enter__(self) -> Operator:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._bands.__exit__(kind, error, trace)

    def apply(self, x: np.ndarray, out: np.ndarray, *, shift: float = 0.0, scale: float = 1.0) -> np.ndarray:
        """Write shift + scale * (A x) to `out`, both (rows, cols) float64 and not the same array."""
        rows = _rows_in if self.transpose else _rows_out
        self._bands.run(lambda a, b: rows(self.probability, x, out, shift, scale, self.weights, a, b))
        return out

    def change(self, x: np.ndarray, y: np.ndarray) -> float:
        """Largest |x - y|."""
        self._bands.run(lambda a, b: _rows_change(x, y, self._by_row, a, b))
        return float(self._by_row.max())

    def dot(self, x: np.ndarray, y: np.ndarray) -> float:
        """Sum of x * y, row by row in fixed order."""
        self._bands.run(lambda a, b: _rows_dot(x, y, self._by_row, a, b))
        return float(self._by_row.sum())

    def combine(self, a: float, x: np.ndarray, b: float, y: np.ndarray, out: np.ndarray) -> np.ndarray:
        """Write a * x + b * y to `out`, which may be x or y."""
        self._bands.run(lambda first, stop: _rows_combine(a, x, b, y, out, first, stop))
        return out


@dataclass(frozen=True)
class Solution:
    """Solution of a linear system and how good it is.

    Parameters
    ----------
    values
        (rows, cols) float64.
    error
        Largest relative error of any cell that the residual leaves possible.
    products
        Matrix-vector products used.
    """

    values: np.ndarray
    error: float
    products: int


def degree(
    probability: np.ndarray, *, boundary: str = "open", transpose: bool = False, threads: int | None = None
) -> np.ndarray:
    """Return A 1: the sum of probabilities out of (transposed: into) each cell, (rows, cols) float64."""
    with Operator(probability, boundary=boundary, transpose=transpose, threads=threads) as operator:
        return operator.apply(np.ones(operator.shape), np.empty(operator.shape))


def katz(
    probability: np.ndarray,
    attenuation: float,
    contraction: float,
    *,
    boundary: str = "open",
    transpose: bool = False,
    tolerance: float = 1e-10,
    threads: int | None = None,
    progress: Progress = silent,
) -> Solution:
    """Solve x = (I - c A)^-1 A 1 for an attenuation c below 1 / lambda_max.

    With z = 1 + c x the system is z = 1 + c A z, whose right side is 1. The inverse has no negative entry, so
    a residual of at most t in every cell bounds the error of every z, and of x = A z, by t relative to its
    true value; this is how the work knows when to stop. Chebyshev steps come first: where fire passes about as
    easily either way they need a quarter of the products at a contraction of 0.9. Above `KRYLOV_ABOVE` BiCGSTAB does.
    The Neumann series ends the work, and does all of it where the first steps do not converge: log(tolerance) /
    log(contraction) products at most. Memory: 3 (7 with BiCGSTAB) vectors of 8 B a cell.

    Parameters
    ----------
    probability
        (8, rows, cols) float32.
    attenuation
        c; 0 gives the degree.
    contraction
        c * lambda_max, in [0, 1): chooses the solver and paces the progress.
    boundary, transpose, threads
        As for `Operator`.
    tolerance
        Relative error allowed in any cell.
    progress
        Callback.
    """
    with Operator(probability, boundary=boundary, transpose=transpose, threads=threads) as operator:
        if attenuation == 0.0:
            return Solution(operator.apply(np.ones(operator.shape), np.empty(operator.shape)), 0.0, 1)
        z = np.ones(operator.shape)
        spare = np.empty(operator.shape)
        products = 0
        if contraction > KRYLOV_ABOVE:
            products = _bicgstab(operator, attenuation, z, spare, tolerance, progress)
        elif contraction > _ACCELERATE_FROM:
            z, products = _chebyshev(operator, attenuation, contraction, z, spare, tolerance, progress)
        z, spare, error, more = _neumann(operator, attenuation, contraction, z, spare, tolerance, progress)
        return Solution(operator.apply(z, spare), error, products + more + 1)


def _chebyshev(
    operator: Operator,
    attenuation: float,
    contraction: float,
    z: np.ndarray,
    spare: np.ndarray,
    tolerance: float,
    progress: Progress,
) -> tuple[np.ndarray, int]:
    """Iterate z = 1 + c A z, each step extrapolated from the last two, as long as the residual falls fast.

    Best if the eigenvalues of c A are real, which they nearly are unless wind or slope drive fire one way. Sums
    are made cell by cell, so mirrored networks still have mirrored results. Source: Golub, Varga 1961,
    doi 10.1007/BF01386013. Returns z and the products used.
    """
    before = z.copy()
    weight, products, residual, first = 1.0, 0, math.inf, math.nan
    while True:
        for _ in range(_CHECK_EVERY):
            operator.apply(z, spare, shift=1.0, scale=attenuation)
            operator.combine(weight, spare, 1.0 - weight, before, before)
            z, before = before, z
            products += 1
            weight = 1.0 / (1.0 - weight * (contraction / 2.0) ** 2 * (2.0 if products == 1 else 1.0))
        # `spare` is what a plain step makes of the one before.
        last, residual = residual, operator.change(spare, before)
        first = residual if math.isnan(first) else first
        if residual <= tolerance or not residual < 0.5 * last:
            return z, products
        done = math.log(first / residual) / math.log(max(first / tolerance, 2.0))
        progress(min(done, 0.95), f"residual {residual:.1e}")


def _neumann(
    operator: Operator,
    attenuation: float,
    contraction: float,
    z: np.ndarray,
    spare: np.ndarray,
    tolerance: float,
    progress: Progress,
) -> tuple[np.ndarray, np.ndarray, float, int]:
    """Iterate z = 1 + c A z until the residual is below the tolerance or no longer falls."""
    products, first, best, error = 0, math.nan, math.inf, math.inf
    stalled = 0
    while True:
        for _ in range(_CHECK_EVERY):
            operator.apply(z, spare, shift=1.0, scale=attenuation)
            z, spare = spare, z
        products += _CHECK_EVERY
        # The step just made is the residual of `spare`; one more product contracts it.
        error = operator.change(z, spare)
        first = error if math.isnan(first) else first
        if error <= tolerance or not math.isfinite(error):
            return z, spare, error, products
        # Rounding stops the fall near the unit roundoff times the largest z.
        stalled = stalled + 1 if error > 0.999 * best and error < 1e-6 else 0
        best = min(best, error)
        if stalled > 4 * max(1.0, 1.0 / -math.log(min(max(contraction, 1e-3), 0.9999))):
            return z, spare, error, products
        done = math.log(max(first / error, 1.0)) / math.log(max(first / tolerance, 2.0))
        progress(min(done, 0.99), f"relative error below {error:.1e}")


def _bicgstab(
    operator: Operator,
    attenuation: float,
    z: np.ndarray,
    spare: np.ndarray,
    tolerance: float,
    progress: Progress,
) -> int:
    """Improve z in place by BiCGSTAB (van der Vorst 1992, doi 10.1137/0913035); returns the products used."""

    def system(x: np.ndarray, out: np.ndarray) -> np.ndarray:
        operator.apply(x, out, scale=-attenuation)
        return operator.combine(1.0, x, 1.0, out, out)

    zero = np.zeros(operator.shape)
    operator.apply(z, spare, shift=1.0, scale=attenuation)
    residual = operator.combine(1.0, spare, -1.0, z, np.empty_like(z))
    shadow = residual.copy()
    direction, image, second = residual.copy(), np.empty_like(z), np.empty_like(z)
    rho = operator.dot(shadow, residual)
    start = best = operator.change(residual, zero)
    products = 1
    for step in range(2000):
        if best <= 0.5 * tolerance or rho == 0.0:
            break
        along = operator.dot(shadow, system(direction, image))
        if along == 0.0 or not math.isfinite(along):
            break
        alpha = rho / along
        operator.combine(1.0, residual, -alpha, image, residual)
        square = operator.dot(system(residual, second), second)
        omega = operator.dot(second, residual) / square if square > 0.0 else 0.0
        operator.combine(alpha, direction, omega, residual, spare)
        size = operator.change(spare, zero)
        if not math.isfinite(size):
            break
        operator.combine(1.0, z, 1.0, spare, z)
        operator.combine(1.0, residual, -omega, second, residual)
        products += 2
        best = operator.change(residual, zero)
        new_rho = operator.dot(shadow, residual)
        if omega == 0.0 or not math.isfinite(best):
            break
        weight = new_rho / rho * (alpha / omega)
        rho = new_rho
        operator.combine(1.0, direction, -omega, image, direction)
        operator.combine(1.0, residual, weight, direction, direction)
        done = math.log(max(start / best, 1.0)) / math.log(max(start / tolerance, 2.0)) if best > 0.0 else 1.0
        progress(min(done, 0.95), f"step {step + 1}, residual {best:.1e}")
    return products


@inlined
def _factors(weights: np.ndarray | None) -> tuple[float, ...]:
    """Factors of the planes as a tuple, which stays in registers."""
    if weights is None:
        return (1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0)
    return (weights[0], weights[1], weights[2], weights[3], weights[4], weights[5], weights[6], weights[7])


@inlined
def _times(weights: np.ndarray | None, factor: float, p: np.float32) -> float:
    """Product with a factor; without weights nothing is left of it in the compiled loop."""
    return np.float64(p) if weights is None else factor * p


@inlined
def _sum_out(
    weights: np.ndarray | None,
    f: tuple[float, ...],
    n: np.ndarray,
    ne: np.ndarray,
    e: np.ndarray,
    se: np.ndarray,
    s: np.ndarray,
    sw: np.ndarray,
    w: np.ndarray,
    nw: np.ndarray,
    up: np.ndarray,
    at: np.ndarray,
    down: np.ndarray,
    left: int,
    c: int,
    right: int,
) -> float:
    """One cell of A x."""
    upright = _times(weights, f[0], n[c]) * up[c] + _times(weights, f[4], s[c]) * down[c]
    level = _times(weights, f[2], e[c]) * at[right] + _times(weights, f[6], w[c]) * at[left]
    rising = _times(weights, f[1], ne[c]) * up[right] + _times(weights, f[5], sw[c]) * down[left]
    falling = _times(weights, f[3], se[c]) * down[right] + _times(weights, f[7], nw[c]) * up[left]
    return (upright + level) + (rising + falling)


@inlined
def _sum_in(
    weights: np.ndarray | None,
    f: tuple[float, ...],
    n: np.ndarray,
    ne: np.ndarray,
    e: np.ndarray,
    se: np.ndarray,
    s: np.ndarray,
    sw: np.ndarray,
    w: np.ndarray,
    nw: np.ndarray,
    up: np.ndarray,
    at: np.ndarray,
    down: np.ndarray,
    left: int,
    c: int,
    right: int,
) -> float:
    """One cell of A^T x; every plane at the row that it comes from."""
    upright = _times(weights, f[0], n[c]) * down[c] + _times(weights, f[4], s[c]) * up[c]
    level = _times(weights, f[2], e[left]) * at[left] + _times(weights, f[6], w[right]) * at[right]
    rising = _times(weights, f[1], ne[left]) * down[left] + _times(weights, f[5], sw[right]) * up[right]
    falling = _times(weights, f[3], se[left]) * up[left] + _times(weights, f[7], nw[right]) * down[right]
    return (upright + level) + (rising + falling)


@kernel
def _rows_out(
    probability: np.ndarray,
    x: np.ndarray,
    y: np.ndarray,
    shift: float,
    scale: float,
    weights: np.ndarray | None,
    first: int,
    stop: int,
) -> None:
    rows, cols = x.shape
    end = cols - 1
    f = _factors(weights)
    for row in range(first, stop):
        # Rows as separate arrays: only so are the loops over columns vectorised. On an open grid what lies
        # beyond the rim is met with probability 0.
        n, ne, e, se = probability[0, row], probability[1, row], probability[2, row], probability[3, row]
        s, sw, w, nw = probability[4, row], probability[5, row], probability[6, row], probability[7, row]
        up, at, down, out = x[row - 1 if row > 0 else rows - 1], x[row], x[row + 1 if row < rows - 1 else 0], y[row]
        for c in range(1, end):
            out[c] = shift + scale * _sum_out(weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, c - 1, c, c + 1)
        out[0] = shift + scale * _sum_out(weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, end, 0, min(1, end))
        out[end] = shift + scale * _sum_out(
            weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, max(end - 1, 0), end, 0
        )


@kernel
def _rows_in(
    probability: np.ndarray,
    x: np.ndarray,
    y: np.ndarray,
    shift: float,
    scale: float,
    weights: np.ndarray | None,
    first: int,
    stop: int,
) -> None:
    rows, cols = x.shape
    end = cols - 1
    f = _factors(weights)
    for row in range(first, stop):
        above, below = row - 1 if row > 0 else rows - 1, row + 1 if row < rows - 1 else 0
        n, ne, nw = probability[0, below], probability[1, below], probability[7, below]
        s, se, sw = probability[4, above], probability[3, above], probability[5, above]
        e, w = probability[2, row], probability[6, row]
        up, at, down, out = x[above], x[row], x[below], y[row]
        for c in range(1, end):
            out[c] = shift + scale * _sum_in(weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, c - 1, c, c + 1)
        out[0] = shift + scale * _sum_in(weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, end, 0, min(1, end))
        out[end] = shift + scale * _sum_in(
            weights, f, n, ne, e, se, s, sw, w, nw, up, at, down, max(end - 1, 0), end, 0
        )


@kernel
def _rows_change(x: np.ndarray, y: np.ndarray, by_row: np.ndarray, first: int, stop: int) -> None:
    for row in range(first, stop):
        a, b = x[row], y[row]
        largest = 0.0
        for c in range(a.size):
            step = abs(a[c] - b[c])
            if not step <= largest:
                largest = step if step == step else np.inf
        by_row[row] = largest


@kernel
def _rows_dot(x: np.ndarray, y: np.ndarray, by_row: np.ndarray, first: int, stop: int) -> None:
    for row in range(first, stop):
        a, b = x[row], y[row]
        total = 0.0
        for c in range(a.size):
            total += a[c] * b[c]
        by_row[row] = total


@kernel
def _rows_combine(a: float, x: np.ndarray, b: float, y: np.ndarray, out: np.ndarray, first: int, stop: int) -> None:
    for row in range(first, stop):
        u, v, o = x[row], y[row], out[row]
        for c in range(u.size):
            o[c] = a * u[c] + b * v[c]
