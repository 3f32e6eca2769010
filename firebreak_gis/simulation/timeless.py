"""Fires that end by themselves: run by run, 64 at once, or whole curves, whichever is fastest.

All give the same numbers.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.landscape.lines import LineBreaks, on_cells
from firebreak_gis.progress import Progress, part
from firebreak_gis.simulation.engine import in_use, ranges, spread
from firebreak_gis.threads import run_pieces, thread_count

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.lanes import Lanes
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest

#: Runs made one by one before it is decided whether blocks of 64 pay.
_PILOT = 4
#: Runs that a thread makes one by one before it looks for the next piece.
_PIECE = 8
#: Runs of a part that another process makes, at least: as many as are made at once.
_PART = 64


def burn_all(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    value: np.ndarray | None,
    threads: int | None,
    progress: Progress | None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Burn runs that end by themselves: many at once where that pays.

    Parameters
    ----------
    network, request, breaks, threads, progress
        As in `fires.burn`.
    start
        Ignitions of the runs.
    value
        (n_cells,) float64 lost where a cell burns, or None.

    Returns
    -------
    counts
        (rows, cols) uint32 runs in which each cell burns.
    sizes
        (n_runs,) int64 burnt cells; float64 where lines clear parts of them.
    lost
        (n_runs,) float64.
    """
    if in_use() is None:
        return _burn_here(network, request, start, breaks, value, threads, progress)
    counts, lost = np.zeros(network.burnable.size, np.uint32), np.zeros(request.n_runs)
    sizes = np.zeros(request.n_runs, float if isinstance(breaks, LineBreaks) else np.int64)
    pieces = ranges(request.n_runs, _PART)

    def take(i: int, part: Mapping[str, np.ndarray]) -> None:
        runs = slice(*pieces[i])
        counts[part["cells"]] += part["counts"]
        sizes[runs], lost[runs] = part["sizes"], part["lost"]

    shared = {
        "network": network,
        "request": request.settled(network.grid),
        "start": start,
        "breaks": on_cells(network, breaks, "breaks"),
        "value": value,
    }
    spread(timeless_part, pieces, shared, take=take, threads=threads, progress=progress)
    return counts.reshape(network.shape), sizes, lost


def timeless_part(
    piece: tuple[int, int],
    *,
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    breaks: np.ndarray | LineBreaks | None,
    value: np.ndarray | None,
    threads: int | None,
    progress: Progress,
) -> dict[str, np.ndarray]:
    """Burn some of the runs of `burn_all`: the cells that burn and how often, sizes and losses of the runs."""
    some = replace(request, n_runs=piece[1] - piece[0])
    counts, sizes, lost = _burn_here(network, some, start.of_runs(*piece), breaks, value, threads, progress)
    cells = np.flatnonzero(counts)
    return {"cells": cells, "counts": counts.ravel()[cells], "sizes": sizes, "lost": lost}


def _burn_here(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    value: np.ndarray | None,
    threads: int | None,
    progress: Progress | None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Burn runs on the threads of this process."""
    from firebreak_gis.kernels.draws import run_keys
    from firebreak_gis.kernels.lanes import burn_block
    from firebreak_gis.kernels.percolation import NOTHING_SPARED, burn_runs
    from firebreak_gis.kernels.walls import GROUND, off_ground

    n_runs, seed = request.n_runs, request.seed
    cells = start.cells
    burnt_network, cut = network, None
    ground, spared = NOTHING_SPARED
    if isinstance(breaks, LineBreaks):
        burnt_network = breaks.parted(network, residual=request.residual)
        ground, spared = breaks.spared(network, residual=request.residual), np.zeros(n_runs, np.int64)
        value = None if value is None else value * (1.0 - ground / GROUND)
        closed = np.where(network.kept_share(request.residual).ravel() == 0.0, ground, 0)
        cells = off_ground(run_keys(seed, "ground", n_runs, start.first_run), start.starts, cells, closed)
        cut = breaks.cells
    elif breaks is not None:
        cut = network.mask(breaks, "breaks")
        burnt_network = network.treated(cut, residual=request.residual)
    if cut is not None:
        perfect = cut & (network.kept_share(request.residual) == 0.0)
        cells = np.where(perfect.ravel()[cells], -1, cells)
    fires = _Fires(burnt_network, start.starts, cells, n_runs=n_runs, first_run=start.first_run, seed=seed)
    counts = np.zeros(network.burnable.size, np.uint32)
    sizes = np.zeros(n_runs, np.int64)
    worth = np.zeros(0) if value is None else value
    lost = np.zeros(n_runs)
    adding = threading.Lock()

    def one_by_one(first: int, last: int) -> None:
        own = np.zeros_like(counts)
        burn_runs(*fires.given, first, last, own, sizes, worth, lost, ground, spared)
        with adding:
            np.add(counts, own, out=counts)

    def together(first: int, last: int) -> None:
        own = np.zeros_like(counts)
        burn_block(*fires.given, first, last, fires.lanes(), own, sizes, ground, spared)
        with adding:
            np.add(counts, own, out=counts)

    # Values are added up run by run, so that their sum has one order.
    block = together if value is None else None
    fires.run(one_by_one, block, lambda: (counts, sizes[:_PILOT]), threads=threads, progress=progress)
    fuel = sizes - spared / GROUND if spared.size else sizes
    return counts.reshape(network.shape), fuel, lost


def burn_levels(
    network: SpreadNetwork,
    start: Ignitions,
    levels: np.ndarray,
    burnt: np.ndarray,
    request: FireRequest,
    threads: int | None,
    progress: Progress | None,
) -> None:
    """Set `burnt`, (run, budget) int64, to the cells burnt at each cut level, by one pass a run.

    `levels` (n_cells,) int32 are those of `budgets.cut_levels`; all else as in `burn_all`.
    """
    if in_use() is None:
        _burn_levels_here(network, start, levels, burnt, request, threads, progress)
        return
    pieces = ranges(request.n_runs, _PART)

    def take(i: int, part: Mapping[str, np.ndarray]) -> None:
        burnt[slice(*pieces[i])] = part["burnt"]

    shared = {
        "network": network,
        "request": request.settled(network.grid),
        "start": start,
        "levels": levels,
        "n_levels": burnt.shape[1],
    }
    spread(levels_part, pieces, shared, take=take, threads=threads, progress=progress)


def levels_part(
    piece: tuple[int, int],
    *,
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    levels: np.ndarray,
    n_levels: int,
    threads: int | None,
    progress: Progress,
) -> dict[str, np.ndarray]:
    """Burn some of the runs of `burn_levels`."""
    n_runs = piece[1] - piece[0]
    burnt = np.zeros((n_runs, n_levels), np.int64)
    some = replace(request, n_runs=n_runs)
    _burn_levels_here(network, start.of_runs(*piece), levels, burnt, some, threads, progress)
    return {"burnt": burnt}


def _burn_levels_here(
    network: SpreadNetwork,
    start: Ignitions,
    levels: np.ndarray,
    burnt: np.ndarray,
    request: FireRequest,
    threads: int | None,
    progress: Progress | None,
) -> None:
    """Burn runs on the threads of this process."""
    from firebreak_gis.kernels.lanes import curve_block
    from firebreak_gis.kernels.percolation import burn_curve as curve_runs

    n_runs, seed = request.n_runs, request.seed
    fires = _Fires(network, start.starts, start.cells, n_runs=n_runs, first_run=start.first_run, seed=seed)

    def one_by_one(first: int, last: int) -> None:
        curve_runs(*fires.given, first, last, levels, burnt)

    def together(first: int, last: int) -> None:
        curve_block(*fires.given, first, last, levels, fires.lanes(curve=True), burnt)

    fuel = network.burnable.ravel()
    fires.run(one_by_one, together, lambda: (fuel, burnt[:_PILOT, 0]), threads=threads, progress=progress, curve=True)


class _Fires:
    """What all kernels are given, and how runs are shared out among threads.

    Whether runs are made one by one or 64 at once changes the speed only: both read the same draws.
    """

    def __init__(
        self,
        network: SpreadNetwork,
        starts: np.ndarray,
        cells: np.ndarray,
        *,
        n_runs: int,
        seed: int,
        first_run: int = 0,
    ) -> None:
        from firebreak_gis.kernels.draws import run_keys, thresholds
        from firebreak_gis.kernels.percolation import steps

        self.shape = network.shape
        self.n_runs = n_runs
        grid_steps = steps(network.shape, periodic=network.boundary == "periodic")
        keys = run_keys(seed, "edges", n_runs, first_run)
        self.given = (thresholds(network.probability), keys, grid_steps, starts, cells)
        self._own = threading.local()

    def lanes(self, *, curve: bool = False) -> Lanes:
        """Return the calling thread's state of a block, made once."""
        from firebreak_gis.kernels.lanes import lanes

        if not hasattr(self._own, "state"):
            self._own.state = lanes(self.shape, curve=curve)
        state: Lanes = self._own.state
        return state

    def run(
        self,
        one_by_one: Callable[[int, int], None],
        together: Callable[[int, int], None] | None,
        pilot: Callable[[], tuple[np.ndarray, np.ndarray]],
        *,
        threads: int | None,
        progress: Progress | None,
        curve: bool = False,
    ) -> None:
        """Make all runs; `pilot` tells, after the first ones, in which cells and how much has burnt."""
        from firebreak_gis.kernels.lanes import LANES, block_pays

        n_threads = thread_count(threads)
        done = min(_PILOT, self.n_runs)
        report = part(progress, 0.0, done / self.n_runs)
        _share_out(one_by_one, 0, done, -(-done // n_threads), threads, report)
        share = -(-(self.n_runs - done) // n_threads)
        work, size = one_by_one, min(_PIECE, share)
        if together is not None and share > _PILOT and block_pays(*pilot(), min(LANES, share), curve=curve):
            work, size = together, min(LANES, share)
        report = part(progress, done / self.n_runs, 1.0)
        _share_out(work, done, self.n_runs, size, threads, report)


def _share_out(
    work: Callable[[int, int], None], first: int, last: int, size: int, threads: int | None, progress: Progress
) -> None:
    """Make the runs from `first` to before `last`, `size` a piece."""
    pieces = [(run, min(run + size, last)) for run in range(first, last, max(size, 1))]
    run_pieces(lambda piece: work(*piece), pieces, threads=threads, progress=progress, message="burning")
