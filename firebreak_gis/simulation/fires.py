"""Monte-Carlo fires on a spread network, with and without breaks.

Every edge is tried once a run with a draw keyed by (seed, run, edge). The same run therefore meets the same
open edges with and without breaks, and neither the number of threads nor the order of runs changes a result.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Budget, removal_order
from firebreak_gis.errors import ParameterError
from firebreak_gis.progress import Progress, part
from firebreak_gis.schema import annotate
from firebreak_gis.simulation.ignitions import IgnitionMode, Ignitions, resolve_ignitions
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.threads import run_pieces, thread_count

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.lanes import Lanes
    from firebreak_gis.network import SpreadNetwork

#: Runs made one by one before it is decided whether blocks of 64 pay.
_PILOT = 4
#: Runs that a thread makes one by one before it looks for the next piece.
_PIECE = 8


def simulate(
    network: SpreadNetwork,
    *,
    breaks: np.ndarray | xr.DataArray | None = None,
    residual: float = 0.0,
    value: np.ndarray | xr.DataArray | None = None,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 100,
    first_run: int = 0,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the network `n_runs` times.

    Parameters
    ----------
    network
        The spread network before cutting.
    breaks
        (y, x), above 0 where the fuel is cut. Ignitions are drawn before cutting; one that falls on a cut
        cell burns nothing.
    residual
        Share of its spread probability that a treated cell keeps; 0 is a perfect break.
    value
        (y, x) value lost when the cell burns; then the result holds `value_lost`.
    ignitions, ignition_mode
        See `firebreak_gis.simulation.ignitions.resolve_ignitions`; default: one random cell with fuel a run.
    n_runs
        Number of runs. Run i is the same for any number of runs.
    first_run
        Number of the first run: runs 0 to 99 and runs 100 to 199 are together the first 200.
    seed
        Seed of the draws; the same seed gives the same fires with and without breaks.
    threads
        Threads to use; changes the speed only.
    progress
        Callback (share done, message); raise `Cancelled` in it to stop.

    Returns
    -------
    xarray.Dataset
        `burn_count` (y, x) uint32, `burn_frequency` (y, x) float32 (NaN where there is no fuel) and
        `fire_size` (run) int64 [cells].

    Raises
    ------
    ParameterError, InputError, GridError
        If a parameter is out of range, an ignition cannot burn, or `breaks` lies on another grid.

    Notes
    -----
    Memory: 32 B a cell for the draw thresholds and up to 100 B a cell and thread, whatever the number of
    runs.
    """
    request = FireRequest(ignitions, ignition_mode, n_runs, seed, residual)
    return burn(network, request, breaks=breaks, value=value, first_run=first_run, threads=threads, progress=progress)


def burn(
    network: SpreadNetwork,
    request: FireRequest,
    *,
    breaks: np.ndarray | xr.DataArray | None = None,
    value: np.ndarray | xr.DataArray | None = None,
    first_run: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the network as a request says; all else as in `simulate`."""
    from firebreak_gis.kernels.lanes import burn_block
    from firebreak_gis.kernels.percolation import burn_runs

    n_runs, seed, residual = request.n_runs, request.seed, request.residual
    start = resolved(network, request, first_run=first_run)
    cells = start.cells
    burnt_network = network
    if breaks is not None:
        burnt_network = network.treated(breaks, residual=residual)
        if residual == 0.0:
            cells = np.where(network.mask(breaks, "breaks").ravel()[cells], -1, cells)
    fires = _Fires(burnt_network, start.starts, cells, n_runs=n_runs, first_run=first_run, seed=seed)
    counts = np.zeros(network.burnable.size, np.uint32)
    sizes = np.zeros(n_runs, np.int64)
    worth = np.zeros(0) if value is None else network.plane(value, "value").astype(np.float64).ravel()
    lost = np.zeros(n_runs)
    adding = threading.Lock()

    def one_by_one(first: int, last: int) -> None:
        own = np.zeros_like(counts)
        burn_runs(*fires.given, first, last, own, sizes, worth, lost)
        with adding:
            np.add(counts, own, out=counts)

    def together(first: int, last: int) -> None:
        own = np.zeros_like(counts)
        burn_block(*fires.given, first, last, fires.lanes(), own, sizes)
        with adding:
            np.add(counts, own, out=counts)

    # Values are added up run by run, so that their sum has one order.
    block = together if value is None else None
    fires.run(one_by_one, block, lambda: (counts, sizes[:_PILOT]), threads=threads, progress=progress)
    return burn_maps(network, counts.reshape(network.shape), sizes, seed=seed, lost=None if value is None else lost)


def resolved(network: SpreadNetwork, request: FireRequest, *, first_run: int = 0) -> Ignitions:
    """Where the fires of a request start, see `ignitions.resolve_ignitions`."""
    return resolve_ignitions(
        network,
        request.ignitions,
        mode=request.ignition_mode,
        n_runs=request.n_runs,
        first_run=first_run,
        seed=request.seed,
    )


def burn_curve(
    network: SpreadNetwork,
    priority: np.ndarray | xr.DataArray,
    *,
    budgets: Sequence[float] | np.ndarray,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Cells burnt at every budget of a ranking, all budgets in one pass a run.

    Equal, run by run, to `simulate` with the breaks of each budget and the same seed.

    Parameters
    ----------
    network
        The spread network before cutting.
    priority
        (y, x), higher is cut earlier, -inf is never cut.
    budgets
        Shares d_f of the cells that hold fuel, rising, each from 0 to 1.
    ignitions, ignition_mode, n_runs, seed, threads, progress
        As in `simulate`.

    Returns
    -------
    xarray.DataArray
        `cells_burnt` (run, budget) int64 with the coordinate `budget`.
    """
    request = FireRequest(ignitions, ignition_mode, n_runs, seed)
    return burn_budgets(network, priority, request, budgets=budgets, threads=threads, progress=progress)


def burn_budgets(
    network: SpreadNetwork,
    priority: np.ndarray | xr.DataArray,
    request: FireRequest,
    *,
    budgets: Sequence[float] | np.ndarray,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Burn the network at every budget as a request says, its breaks perfect; all else as in `burn_curve`."""
    import xarray as xr

    from firebreak_gis.kernels.lanes import curve_block
    from firebreak_gis.kernels.percolation import burn_curve as curve_runs

    start, n_runs, seed = resolved(network, request), request.n_runs, request.seed
    levels = cut_levels(network, priority, budgets).ravel()
    fires = _Fires(network, start.starts, start.cells, n_runs=n_runs, seed=seed)
    burnt = np.zeros((n_runs, len(budgets)), np.int64)

    def one_by_one(first: int, last: int) -> None:
        curve_runs(*fires.given, first, last, levels, burnt)

    def together(first: int, last: int) -> None:
        curve_block(*fires.given, first, last, levels, fires.lanes(curve=True), burnt)

    fuel = network.burnable.ravel()
    fires.run(one_by_one, together, lambda: (fuel, burnt[:_PILOT, 0]), threads=threads, progress=progress, curve=True)
    return xr.DataArray(
        burnt,
        dims=("run", "budget"),
        coords={"budget": ("budget", np.asarray(budgets, dtype=np.float64), {"units": "1", "long_name": "d_f"})},
        name="cells_burnt",
        attrs={"n_burnable": network.n_burnable, "seed": seed},
    )


def cut_levels(
    network: SpreadNetwork, priority: np.ndarray | xr.DataArray, budgets: Sequence[float] | np.ndarray
) -> np.ndarray:
    """Last budget at which each cell is still there.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int32: index into `budgets`; -1 if the cell is cut at all of them.

    Raises
    ------
    ParameterError
        If the budgets do not rise or are not shares.
    """
    if len(budgets) == 0 or np.any(np.diff(budgets) < 0):
        raise ParameterError("budgets must be a rising list of shares, for example 0.0, 0.05, 0.1")
    cut = np.array([Budget(budget).cells(n_burnable=network.n_burnable) for budget in budgets])
    position = removal_order(network.plane(priority, "priority"))
    levels = np.searchsorted(cut, position, side="right") - 1
    levels[position < 0] = len(cut) - 1
    return levels.astype(np.int32)


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


def burn_maps(
    network: SpreadNetwork, counts: np.ndarray, sizes: np.ndarray, *, seed: int, lost: np.ndarray | None = None
) -> xr.Dataset:
    """Dataset of `simulate` from burnt runs a cell, burnt cells a run and value lost a run."""
    import xarray as xr

    n_runs = sizes.size
    frequency = np.where(network.burnable, counts / n_runs, np.nan).astype(np.float32)
    planes = {"burn_count": counts, "burn_frequency": frequency}
    runs = {"fire_size": sizes} if lost is None else {"fire_size": sizes, "value_lost": lost}
    return xr.Dataset(
        {
            **{name: annotate(network.grid.dataarray(plane, name)) for name, plane in planes.items()},
            **{name: annotate(xr.DataArray(each, dims="run", name=name)) for name, each in runs.items()},
        },
        attrs={"n_runs": n_runs, "seed": seed, "n_burnable": network.n_burnable},
    )
