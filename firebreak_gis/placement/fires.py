"""The fires that plans are designed with; plans are judged on others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.draws import Thresholds, run_keys, seed_for, stream_key, thresholds, uniforms
from firebreak_gis.kernels.percolation import NOTHING_SPARED, Steps, burn_runs, steps
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Pieces into which runs are split; fixed, so that sums have one order for any number of threads.
PIECES = 8
#: Cells times runs that are burnt without threads.
_SMALL = 200_000


@dataclass(frozen=True)
class Fires:
    """Draws and ignition cells of the fires of a design.

    Parameters
    ----------
    limits
        Draw thresholds of the edges before cutting.
    leaks
        Draw thresholds of edges into cut cells; empty if breaks are perfect.
    keys
        (n_runs,) uint64.
    cells
        (n_runs,) int64 row-major ignition cell of each run.
    grid_steps
        Steps between cell numbers.
    """

    limits: Thresholds
    leaks: Thresholds
    keys: np.ndarray
    cells: np.ndarray
    grid_steps: Steps


def design_fires(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    n_runs: int,
    seed: int,
    residual: float = 0.0,
    purpose: str = "design",
) -> Fires:
    """Draw the fires that a plan is designed with, or checked on, ignitions by their weights in `stakes`.

    The n-th fire starts in the n-th of `n_runs` equal shares of the ignition weights (systematic sampling), which
    takes much of the noise out of means. The draws are other ones than those of a simulation with the same seed, and
    than those for another purpose, see `draws.seed_for`. `residual` is the share of its spread probability that an
    edge into a cut cell keeps.
    """
    cumulative = np.cumsum(stakes.ignition.ravel())
    own = seed_for(seed, purpose)
    start = uniforms(stream_key(own, "ignitions"), 1)
    cells = np.searchsorted(cumulative, (np.arange(n_runs) + start) / n_runs * cumulative[-1], side="right")
    last = int(np.flatnonzero(stakes.ignition.ravel())[-1])
    leaks = Thresholds(np.zeros(0, np.uint64), np.zeros((0, 3), np.uint64))
    if residual > 0.0:
        leaks = thresholds(network.probability * np.float32(residual))
    return Fires(
        thresholds(network.probability),
        leaks,
        run_keys(own, "edges", n_runs),
        np.minimum(cells, last),
        steps(network.shape, periodic=network.boundary == "periodic"),
    )


def pieces(n_runs: int) -> list[tuple[int, int]]:
    """First run and end of each piece."""
    edges = np.linspace(0, n_runs, min(PIECES, n_runs) + 1).astype(int)
    return list(zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True))


def burn_pieces(
    work: Callable[[int], None], n_runs: int, n_cells: int, *, threads: int | None, progress: Progress
) -> None:
    """Call ``work(i)`` for every piece of the runs; small work is not worth threads."""
    count = len(pieces(n_runs))
    if n_runs * n_cells > _SMALL:
        run_pieces(work, range(count), threads=threads, progress=progress, message="burning")
        return
    for i in range(count):
        work(i)
    progress(1.0, "burning")


def losses(
    network: SpreadNetwork,
    stakes: Stakes,
    cut: np.ndarray,
    fires: Fires,
    *,
    residual: float = 0.0,
    threads: int | None = None,
    progress: Progress,
) -> np.ndarray:
    """Share of all value that is lost in each fire, with breaks.

    Parameters
    ----------
    cut
        (rows, cols) bool.
    residual
        Share of its spread probability that an edge into a treated cell keeps.

    Returns
    -------
    numpy.ndarray
        (n_runs,) float64.
    """
    n_runs = fires.keys.size
    cells = fires.cells if residual > 0.0 else np.where(cut.ravel()[fires.cells], -1, fires.cells)
    limits = thresholds(network.treated(cut, residual=residual).probability)
    lost = np.zeros(n_runs)
    sizes = np.zeros(n_runs, np.int64)
    value = stakes.value.ravel()

    def burn(piece: tuple[int, int]) -> None:
        counts = np.zeros(value.size, np.uint32)
        burn_runs(
            limits,
            fires.keys,
            fires.grid_steps,
            np.arange(n_runs + 1),
            cells,
            piece[0],
            piece[1],
            counts,
            sizes,
            value,
            lost,
            *NOTHING_SPARED,
        )

    run_pieces(burn, pieces(n_runs), threads=threads, progress=progress, message="burning")
    share: np.ndarray = lost / value.sum()
    return share
