"""Walls of more than one cell, for breaks that leak, and the width that serves best."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.placement.fires import design_fires, losses
from firebreak_gis.progress import part

if TYPE_CHECKING:
    from firebreak_gis.network import Boundary, SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes


#: Lower right: towards it a wall of an even width reaches one cell further from its line.
STANDARD_CORNER = (1, 1)


def offsets(width: int) -> range:
    """Steps from a cell of a line to the cells of the wall, along rows and along columns.

    A line that stops spread over corners, widened by this square, is met at least `width` times by every way
    across, and no smaller set of cells along the line is.
    """
    return range(-((width - 1) // 2), width // 2 + 1)


def around(cells: np.ndarray, shape: tuple[int, int], width: int, boundary: Boundary) -> np.ndarray:
    """Cells of the wall of a line, in the order of the line, each once.

    Parameters
    ----------
    cells
        Row-major cell numbers of the line.
    shape
        (rows, cols) of the grid.
    width
        Cells across the wall.
    boundary
        Whether the wall goes on at the other border (`"periodic"`).

    Returns
    -------
    numpy.ndarray
        int64; a cell of the line stands before those that it brings along.
    """
    if width == 1:
        return cells
    return _widened(cells, np.array([cells.size]), shape, width, boundary, np.ones(shape[0] * shape[1], bool))[0]


def _widened(
    cells: np.ndarray, ends: np.ndarray, shape: tuple[int, int], width: int, boundary: Boundary, free: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """As `kernels.widening.widened`: of the square around each cell of a line the nearest cells first."""
    from firebreak_gis.kernels.widening import widened

    steps = sorted((abs(r) + abs(c), r, c) for r in offsets(width) for c in offsets(width))
    _, down, across = np.array(steps, np.int64).T.copy()
    return widened(  # type: ignore[no-any-return]
        cells.astype(np.int64), ends, down, across, *shape, boundary == "periodic", free
    )


def wall_cost(
    cost: np.ndarray, width: int, boundary: Boundary, corner: tuple[int, int] = STANDARD_CORNER
) -> np.ndarray:
    """Cost of a cell of a line with its share of the wall around it, (rows, cols).

    Along a straight line these add up to the cost of the wall.

    Parameters
    ----------
    cost
        (rows, cols) of the cells.
    width, boundary
        As in `around`.
    corner
        Towards which rows and columns walls of an even width reach one cell further, each 1 (rising) or -1: on a map
        that was turned before walls are sought, where they lie as `around` widens them on the other.
    """
    if width == 1:
        return cost
    before, after = -offsets(width)[0], offsets(width)[-1]
    pad = [(before, after) if step > 0 else (after, before) for step in corner]
    padded = np.pad(cost, pad, mode="wrap" if boundary == "periodic" else "constant")
    total = np.zeros(cost.shape)
    for r in range(width):
        for c in range(width):
            total += padded[r : r + cost.shape[0], c : c + cost.shape[1]]
    return total / width


def walls(
    lines: Sequence[np.ndarray], network: SpreadNetwork, stakes: Stakes, width: int
) -> tuple[list[np.ndarray], list[float]]:
    """Widen lines one after another; a cell belongs to the first wall that needs it.

    Returns
    -------
    tuple
        The new cells of each wall (fuel that may be cut), and their cost.
    """
    wall, until = _laid(lines, network, stakes, width)
    return [wall[start:stop] for start, stop in pairwise([0, *until.tolist()])], _costs(wall, until, stakes)


def wall_costs(lines: Sequence[np.ndarray], network: SpreadNetwork, stakes: Stakes, width: int) -> list[float]:
    """Costs of the walls that `walls` returns."""
    return _costs(*_laid(lines, network, stakes, width), stakes)


def _laid(
    lines: Sequence[np.ndarray], network: SpreadNetwork, stakes: Stakes, width: int
) -> tuple[np.ndarray, np.ndarray]:
    """New cells of all walls, and where those of each end."""
    free = (network.burnable & ~stakes.protected).ravel()
    cells = np.concatenate([*lines, np.zeros(0, np.int64)])
    ends = np.cumsum(np.array([line.size for line in lines], np.int64))
    return _widened(cells, ends, network.shape, width, network.boundary, free)


def _costs(wall: np.ndarray, until: np.ndarray, stakes: Stakes) -> list[float]:
    owner = np.repeat(np.arange(until.size), np.diff(until, prepend=0))
    return np.bincount(owner, stakes.cost.ravel()[wall], minlength=until.size).tolist()  # type: ignore[no-any-return]


def best_width(
    network: SpreadNetwork,
    stakes: Stakes,
    planner: Callable[[int, Progress], np.ndarray],
    *,
    cost_share: float,
    residual: float,
    narrowest: int = 1,
    widest: int = 6,
    n_runs: int = 300,
    seed: int,
    threads: int | None = None,
    progress: Progress,
) -> tuple[int, np.ndarray]:
    """Find the width that loses least value in simulated fires.

    Widths are tried from the narrowest up until two in a row are worse than the best.

    Parameters
    ----------
    planner
        Called as ``planner(width, progress)``; returns the priority for walls of that width.
    cost_share
        Share of the cost of all fuel for which the width is chosen.
    residual
        Share of its spread probability that an edge into a treated cell keeps.
    narrowest, widest
        Smallest and largest width tried; the largest is at least the smallest.
    n_runs, seed
        Fires of the design.

    Returns
    -------
    tuple
        The width and its priority.
    """
    fires = design_fires(network, stakes, n_runs=n_runs, seed=seed)
    best = (np.inf, narrowest, np.zeros(network.shape))
    worse = 0
    widths = range(narrowest, max(widest, narrowest) + 1)
    for i, width in enumerate(widths):
        step = part(progress, i / len(widths), (i + 1) / len(widths), f"walls of {width} cells: ")
        priority = planner(width, part(step, 0.0, 0.7))
        cut = select_breaks(priority, budget=Budget.of_cost_share(cost_share, stakes), cost=stakes.cost).to_numpy() > 0
        lost = float(
            losses(
                network, stakes, cut, fires, residual=residual, threads=threads, progress=part(step, 0.7, 1.0)
            ).mean()
        )
        worse = 0 if lost < best[0] else worse + 1
        if lost < best[0]:
            best = (lost, width, priority)
        if worse == 2:
            break
    return best[1], best[2]
