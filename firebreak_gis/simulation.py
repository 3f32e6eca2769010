"""Monte-Carlo fires on a spread network, with and without breaks.

Every edge is tried once a run with a draw keyed by (seed, run, edge). The same run therefore meets the same
open edges with and without breaks, and neither the number of threads nor the order of runs changes a result.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import cells_to_cut, removal_order
from firebreak_gis.errors import ParameterError
from firebreak_gis.ignitions import IgnitionMode, resolve_ignitions
from firebreak_gis.progress import Progress, silent
from firebreak_gis.schema import annotate
from firebreak_gis.workers import run_pieces, thread_count

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

#: Runs a thread does before it looks for the next piece; never more than one block of 64 lanes.
_PIECE = 64


def simulate(
    network: SpreadNetwork,
    *,
    breaks: np.ndarray | xr.DataArray | None = None,
    residual: float = 0.0,
    value: np.ndarray | xr.DataArray | None = None,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 100,
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
        See `firebreak_gis.ignitions.resolve_ignitions`; default: one random cell with fuel a run.
    n_runs
        Number of runs. Run i is the same for any number of runs.
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
    from firebreak_gis.kernels.draws import run_keys, thresholds
    from firebreak_gis.kernels.percolation import burn_runs, steps

    start = resolve_ignitions(network, ignitions, mode=ignition_mode, n_runs=n_runs, seed=seed)
    cells = start.cells
    burnt_network = network
    if breaks is not None:
        burnt_network = network.treated(breaks, residual=residual)
        if residual == 0.0:
            cells = np.where(network.mask(breaks, "breaks").ravel()[cells], -1, cells)
    limits = thresholds(burnt_network.probability)
    keys = run_keys(seed, "edges", n_runs)
    grid_steps = steps(network.shape, periodic=network.boundary == "periodic")
    counts = np.zeros(network.burnable.size, np.uint32)
    sizes = np.zeros(n_runs, np.int64)
    worth = np.zeros(0) if value is None else network.plane(value, "value").astype(np.float64).ravel()
    lost = np.zeros(n_runs)
    adding = threading.Lock()

    def burn(piece: tuple[int, int]) -> None:
        own = np.zeros_like(counts)
        burn_runs(limits, keys, grid_steps, start.starts, cells, piece[0], piece[1], own, sizes, worth, lost)
        with adding:
            np.add(counts, own, out=counts)

    run_pieces(burn, _pieces(n_runs, threads), threads=threads, progress=progress or silent, message="burning")
    burns = _burns(network, counts.reshape(network.shape), sizes, seed)
    return burns if value is None else burns.assign(value_lost=annotate(_by_run(lost, "value_lost")))


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
    import xarray as xr

    from firebreak_gis.kernels.draws import run_keys, thresholds
    from firebreak_gis.kernels.percolation import burn_curve as burn_levels
    from firebreak_gis.kernels.percolation import steps

    start = resolve_ignitions(network, ignitions, mode=ignition_mode, n_runs=n_runs, seed=seed)
    levels = cut_levels(network, priority, budgets).ravel()
    limits = thresholds(network.probability)
    keys = run_keys(seed, "edges", n_runs)
    grid_steps = steps(network.shape, periodic=network.boundary == "periodic")
    burnt = np.zeros((n_runs, len(budgets)), np.int64)

    def burn(piece: tuple[int, int]) -> None:
        burn_levels(limits, keys, grid_steps, start.starts, start.cells, piece[0], piece[1], levels, burnt)

    run_pieces(burn, _pieces(n_runs, threads), threads=threads, progress=progress or silent, message="burning")
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
    cut = np.array([cells_to_cut(budget, network.n_burnable) for budget in budgets])
    position = removal_order(network.plane(priority, "priority"))
    levels = np.searchsorted(cut, position, side="right") - 1
    levels[position < 0] = len(cut) - 1
    return levels.astype(np.int32)


def _pieces(n_runs: int, threads: int | None) -> list[tuple[int, int]]:
    """Runs in pieces of at most 64 that keep all threads busy."""
    size = min(_PIECE, -(-n_runs // thread_count(threads)))
    return [(first, min(first + size, n_runs)) for first in range(0, n_runs, size)]


def _burns(network: SpreadNetwork, counts: np.ndarray, sizes: np.ndarray, seed: int) -> xr.Dataset:
    import xarray as xr

    n_runs = sizes.size
    frequency = np.where(network.burnable, counts / n_runs, np.nan).astype(np.float32)
    return xr.Dataset(
        {
            "burn_count": annotate(network.grid.dataarray(counts, "burn_count")),
            "burn_frequency": annotate(network.grid.dataarray(frequency, "burn_frequency")),
            "fire_size": annotate(_by_run(sizes, "fire_size")),
        },
        attrs={"n_runs": n_runs, "seed": seed, "n_burnable": network.n_burnable},
    )


def _by_run(values: np.ndarray, name: str) -> xr.DataArray:
    import xarray as xr

    return xr.DataArray(values, dims="run", name=name)
