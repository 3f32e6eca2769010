"""Bounds of the largest eigenvalue of a network too large to be one block.

On a heterogeneous landscape the eigenvector is localised: it lives on one spot and falls off exponentially. So a
window around the spot gives the eigenvalue from below to many digits. From above it takes a vector x > 0 with
A x <= mu x in every cell of the map. Power steps from x = 1 give one that fails only on a few dense spots. There x
is raised: on the strongest spot to the window's eigenvector, elsewhere cell by cell, and where that is slow by
solving a window with its surroundings fixed. One last product with A proves the result.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from firebreak_gis.kernels.blocks import ROUNDING, Block, block_bounds, factorise, grid_matrix
from firebreak_gis.kernels.linear import Operator
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.progress import Progress

_ROW_STEP = ROW_STEP
_COL_STEP = COL_STEP

#: Power steps on the whole map before windows are cut.
_POWER_STEPS = 40
#: Half sizes of windows, in cells; a window grows until its eigenvalue no longer does.
_HALF_SIZES = (24, 36, 54, 80, 120)
#: Spots that are tried as the strongest one.
_SPOTS = 8
#: Rounds of raising x, and visits to cells in each besides half the number of cells.
_ROUNDS, _VISITS = 30, 2_000_000


@dataclass
class _Window:
    """A window of the map and what is known of it.

    Parameters
    ----------
    cells
        Index arrays of its rows and columns, as from `numpy.ix_`.
    block
        Its eigenvalue and eigenvector.
    """

    cells: tuple[np.ndarray, np.ndarray]
    block: Block

    @property
    def vector(self) -> np.ndarray:
        """Eigenvector, (window rows, window cols)."""
        return self.block.vector.reshape(self.cells[0].size, self.cells[1].size)

    @property
    def peak(self) -> tuple[int, int]:
        """Cell of the map where the eigenvector is largest."""
        row, col = divmod(int(np.argmax(self.block.vector)), self.cells[1].size)
        return int(self.cells[0][row, 0]), int(self.cells[1][0, col])


def localised_bounds(operator: Operator, tolerance: float, progress: Progress) -> tuple[float, float, np.ndarray]:
    """Enclose the largest eigenvalue of A.

    Parameters
    ----------
    operator
        A itself, not transposed.
    tolerance
        Relative distance of the bounds to aim at.
    progress
        Callback.

    Returns
    -------
    tuple
        Lower bound, upper bound, and the positive vector that proves the upper one. Memory: 3 vectors.
    """
    x, spare, upper = _power_steps(operator, progress)
    lower = 0.0
    tried: list[_Window] = []
    for start in _spots(x):
        window = _window(operator, start, _HALF_SIZES[0], 1e-6)
        tried.append(window)
        lower = max(lower, window.block.lower)
        progress(0.3 + 0.2 * len(tried) / _SPOTS, f"largest eigenvalue at least {lower:.9g}")
    if lower == 0.0:
        return 0.0, upper, x
    strongest, settled = _grow(operator, max(tried, key=lambda w: w.block.lower), tolerance, progress)
    lower = max(lower, strongest.block.lower)
    if not settled:
        return lower, upper, x
    best_x = x.copy()
    for _ in range(_ROUNDS):
        goal = lower * (1.0 + 0.9 * tolerance)
        _lift(operator, x, strongest)
        stronger = _raise(operator, x, spare, strongest, goal, progress)
        ratio = _largest_ratio(operator, x, spare)
        if ratio < upper:
            upper = ratio
            best_x[:] = x
        if stronger is None:
            break
        strongest, settled = _grow(operator, stronger, tolerance, progress)
        lower = max(lower, strongest.block.lower)
        if not settled:
            break
    return lower, upper, best_x


def tilt(probability: np.ndarray) -> np.ndarray:
    """Factors of the planes, (8,), under which wind does not push the power steps off an open map.

    Scaling x by exp(a * row + b * col) multiplies plane d by exp(a * row step + b * col step) and keeps the
    eigenvalues. a and b minimise the mean row sum, a convex function, by Newton's method.
    """
    mean = probability.mean(axis=(1, 2), dtype=np.float64)
    steps = np.array([ROW_STEP, COL_STEP], dtype=np.float64)
    slope = np.zeros(2)
    for _ in range(50):
        terms = mean * np.exp(slope @ steps)
        curvature = (steps * terms) @ steps.T + 1e-9 * np.eye(2)
        move = np.linalg.solve(curvature, steps @ terms)
        slope = np.clip(slope - move / max(1.0, float(np.abs(move).max())), -5.0, 5.0)
    return np.exp(slope @ steps)


def _power_steps(operator: Operator, progress: Progress) -> tuple[np.ndarray, np.ndarray, float]:
    """Vector after some steps of A + s I from 1, a spare vector, and the upper bound that it gives."""
    x, y = np.ones(operator.shape), np.empty(operator.shape)
    upper = np.inf
    for step in range(_POWER_STEPS):
        operator.apply(x, y)
        top = float(y.max())
        if top == 0.0:
            return np.ones(operator.shape), y, 0.0
        # The shift keeps every entry positive and stops oscillation.
        operator.combine(1.0 / top, y, 0.1, x, y)
        x, y = y, x
        progress(0.3 * step / _POWER_STEPS, "largest eigenvalue: power steps")
    return x, y, min(upper, _largest_ratio(operator, x, y))


def _largest_ratio(operator: Operator, x: np.ndarray, spare: np.ndarray) -> float:
    operator.apply(x, spare)
    np.divide(spare, x, out=spare)
    return float(spare.max()) * (1.0 + ROUNDING)


def _spots(x: np.ndarray) -> list[tuple[int, int]]:
    """Cells where x is largest, at most one a tile of 32 x 32 cells, largest first."""
    tile = 32
    rows, cols = x.shape
    peaks = []
    for r in range(0, rows, tile):
        best = x[r : r + tile].max(axis=0)
        peaks += [(-float(best[c : c + tile].max()), r, c) for c in range(0, cols, tile)]
    spots = []
    for _, r, c in sorted(peaks)[:_SPOTS]:
        patch = x[r : r + tile, c : c + tile]
        at = np.unravel_index(int(patch.argmax()), patch.shape)
        spots.append((r + int(at[0]), c + int(at[1])))
    return spots


def _cut(operator: Operator, centre: tuple[int, int], half: int) -> tuple[tuple[np.ndarray, np.ndarray], sp.csr_array]:
    """Cells and matrix of the window of up to 2 * half + 1 cells a side; it wraps on a periodic map."""
    axes = []
    for at, size in zip(centre, operator.shape, strict=True):
        if operator.periodic:
            axes.append(np.arange(at - half, min(at + half + 1, at - half + size)) % size)
        else:
            axes.append(np.arange(max(0, at - half), min(at + half + 1, size)))
    rows, cols = np.ix_(*axes)
    whole = operator.periodic and (rows.size, cols.size) == operator.shape
    planes = operator.probability[:, rows, cols]
    return (rows, cols), grid_matrix(planes, "periodic" if whole else "open", operator.weights)


def _window(operator: Operator, centre: tuple[int, int], half: int, tolerance: float, guess: float = 0.0) -> _Window:
    cells, matrix = _cut(operator, centre, half)
    return _Window(cells, block_bounds(matrix, tolerance, guess=guess))


def _grow(operator: Operator, window: _Window, tolerance: float, progress: Progress) -> tuple[_Window, bool]:
    """Enlarge a window until its eigenvalue stays twice; whether it did, or the window is the map."""
    before, stayed = window.block.lower, 0
    sizes = [half for half in _HALF_SIZES if 2 * half + 1 > max(window.vector.shape)]
    for half in sizes or _HALF_SIZES[-1:]:
        window = _window(operator, window.peak, half, 1e-2 * tolerance, before)
        progress(0.6, f"largest eigenvalue at least {window.block.lower:.12g}")
        stayed = stayed + 1 if window.block.lower <= before * (1.0 + 0.1 * tolerance) else 0
        if stayed == 2:
            break
        before = max(before, window.block.lower)
    full = [size == of for size, of in zip(window.vector.shape, operator.shape, strict=True)]
    # A window round a torus in one direction only is cut where the torus is not.
    return window, all(full) or (stayed > 0 and not (operator.periodic and any(full)))


def _lift(operator: Operator, x: np.ndarray, window: _Window) -> None:
    """Raise x to a multiple of the window's eigenvector that does not show at the window's rim."""
    patch, vector = x[window.cells], window.vector
    rim = np.zeros(vector.shape, dtype=bool)
    for axis, index in enumerate(window.cells):
        line = index.ravel()
        edges = rim if axis == 0 else rim.T
        # The edge of an open map is no rim: nothing lies beyond.
        edges[0] |= operator.periodic or line[0] > 0
        edges[-1] |= operator.periodic or line[-1] < operator.shape[axis] - 1
    shown = rim & (vector > 0.0)
    factor = float((patch[shown] / vector[shown]).min()) if shown.any() else np.inf
    x[window.cells] = np.maximum(patch, min(factor, 1e30 * float(patch.max())) * vector)


def _raise(
    operator: Operator, x: np.ndarray, spare: np.ndarray, strongest: _Window, goal: float, progress: Progress
) -> _Window | None:
    """Raise x until A x <= goal * x, as far as it goes; a window with a larger eigenvalue if one is met."""
    queue = np.empty(x.size, dtype=np.uint32)
    waiting = np.zeros(x.size, dtype=np.uint8)
    visits: dict[tuple[int, int], int] = {}
    aim = goal * (1.0 - 4.0 * ROUNDING)
    weights = np.ones(8) if operator.weights is None else operator.weights
    for step in range(_ROUNDS):
        operator.apply(x, spare)
        open_cells = np.flatnonzero(spare > aim * x)
        progress(0.6 + 0.4 * step / _ROUNDS, f"largest eigenvalue: {open_cells.size} cells to prove")
        if open_cells.size == 0:
            return None
        queue[: open_cells.size] = open_cells
        waiting[open_cells] = 1
        # Raised a little further than needed, so that the last digits come to rest.
        left = _relax(
            operator.probability,
            weights,
            x,
            queue,
            waiting,
            open_cells.size,
            aim * (1.0 - 1e-12),
            aim * (1.0 - ROUNDING),
            operator.periodic,
            _VISITS + x.size // 2,
        )
        if left == 0:
            continue
        waiting[:] = 0
        operator.apply(x, spare)
        np.divide(spare, x, out=spare)
        row, col = divmod(int(np.argmax(spare)), x.shape[1])
        centre, size = (row, col), 1
        if row in strongest.cells[0] and col in strongest.cells[1]:
            centre, size = strongest.peak, 3
        # A place that comes up again gets a larger window.
        place = (centre[0] // 64, centre[1] // 64)
        size = min(size + visits.get(place, 0), len(_HALF_SIZES) - 1)
        visits[place] = visits.get(place, 0) + 1
        # Solved for less than the goal, so that the seam and rounding do not spoil the goal inside.
        target = 0.5 * (strongest.block.lower + goal)
        stronger = _solve_window(operator, x, centre, _HALF_SIZES[size], target)
        if stronger is not None:
            return stronger
    return None


def _solve_window(operator: Operator, x: np.ndarray, centre: tuple[int, int], half: int, goal: float) -> _Window | None:
    """Set x to the solution of goal * x = A x in a window whose surroundings are fixed.

    Returns
    -------
    _Window or None
        The window, if its eigenvalue exceeds `goal`: then there is no such solution.
    """
    cells, matrix = _cut(operator, centre, half)
    patch = x[cells]
    whole = operator.apply(x, np.empty(operator.shape))[cells]
    # The small addition keeps cells positive that reach no cell outside.
    outside = np.maximum(whole.ravel() - matrix @ patch.ravel(), 0.0) + np.maximum(1e-12 * patch.ravel(), 1e-200)
    z = factorise(matrix, goal).solve(outside)
    if z.min() < -1e-9 * np.abs(z).max():
        block = block_bounds(matrix, 1e-12)
        if block.lower > goal:
            return _Window(cells, block)
    x[cells] = z.reshape(patch.shape)
    return None


@kernel
def _relax(
    probability: np.ndarray,
    weights: np.ndarray,
    x: np.ndarray,
    queue: np.ndarray,
    waiting: np.ndarray,
    n_open: int,
    to: float,
    above: float,
    periodic: bool,
    limit: int,
) -> int:
    """Raise x cell by cell, first come first served, where A x > `above` * x; returns the cells left open."""
    rows, cols = x.shape
    size = queue.size
    head, n = 0, n_open
    for _ in range(limit):
        if n == 0:
            break
        cell = np.int64(queue[head])
        head += 1
        if head == size:
            head = 0
        n -= 1
        waiting[cell] = 0
        row, col = cell // cols, cell % cols
        total = 0.0
        for d in range(8):
            r, c = row + _ROW_STEP[d], col + _COL_STEP[d]
            if periodic:
                r, c = r % rows, c % cols
            if 0 <= r < rows and 0 <= c < cols:
                total += weights[d] * probability[d, row, col] * x[r, c]
        if total <= above * x[row, col]:
            continue
        x[row, col] = total / to
        for d in range(8):  # the cells that can light this one
            r, c = row - _ROW_STEP[d], col - _COL_STEP[d]
            if periodic:
                r, c = r % rows, c % cols
            if 0 <= r < rows and 0 <= c < cols and probability[d, r, c] > 0:
                other = r * cols + c
                if waiting[other] == 0:
                    waiting[other] = 1
                    tail = head + n
                    if tail >= size:
                        tail -= size
                    queue[tail] = other
                    n += 1
    return n
