"""Many fires on many machines: the runs of a simulation as tasks of a dask scheduler.

Runs are numbered and their draws are keyed, so a task is a range of runs and nothing else has to be agreed on. dask
decides where tasks run: on threads or processes of this machine, or on a cluster.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import MissingComponentError, ParameterError
from firebreak_gis.simulation.fires import burn_maps, simulate
from firebreak_gis.simulation.ignitions import resolve_ignitions

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Part = tuple[np.ndarray, np.ndarray, np.ndarray | None]


def simulate_distributed(
    network: SpreadNetwork, *, n_runs: int, runs_per_task: int = 256, seed: int = 0, **fires: Any
) -> xr.Dataset:
    """Burn the network `n_runs` times on the dask scheduler in use.

    Parameters
    ----------
    network
        The spread network before cutting.
    n_runs
        Number of runs.
    runs_per_task
        Runs of one task, which takes one thread; changes the speed only. A task sends back 4 B a cell.
    seed
        Seed of the draws.
    **fires
        `breaks`, `residual`, `value`, `ignitions` and `ignition_mode` as in `simulate`.

    Returns
    -------
    xarray.Dataset
        Equal to that of `simulate`, however the runs are split and wherever they are made.

    Raises
    ------
    MissingComponentError
        If dask is not installed.
    ParameterError, InputError, GridError
        As `simulate`.

    Notes
    -----
    Make a `dask.distributed.Client` first to use a cluster; without one dask takes the threads of this machine. The
    network is sent to a worker once.
    """
    try:
        from dask.delayed import delayed
    except ImportError:
        raise MissingComponentError(
            "dask is not installed, which spreads the runs; install firebreak_gis[scale]"
        ) from None

    if runs_per_task < 1:
        raise ParameterError(f"runs_per_task is {runs_per_task}, expected at least 1")
    where = {key: fires[key] for key in ("ignitions", "ignition_mode") if key in fires}
    # What cannot burn is refused here, not on a worker.
    resolve_ignitions(
        network, where.get("ignitions"), mode=where.get("ignition_mode", "each"), n_runs=n_runs, seed=seed
    )
    shared, task, joined = delayed(network), delayed(_part), delayed(_join)
    parts = [
        task(shared, n_runs=min(runs_per_task, n_runs - first), first_run=first, seed=seed, **fires)
        for first in range(0, n_runs, runs_per_task)
    ]
    while len(parts) > 1:  # two and two, so that no machine holds more than a few maps
        parts = [joined(*parts[i : i + 2]) if i + 1 < len(parts) else parts[i] for i in range(0, len(parts), 2)]
    counts, sizes, lost = parts[0].compute()
    return burn_maps(network, counts, sizes, seed=seed, lost=lost)


def _part(network: SpreadNetwork, **fires: Any) -> Part:
    burns = simulate(network, threads=1, **fires)
    lost = burns["value_lost"].to_numpy() if "value_lost" in burns else None
    return burns["burn_count"].to_numpy(), burns["fire_size"].to_numpy(), lost


def _join(one: Part, other: Part) -> Part:
    """The runs of both, `one` before `other`."""
    lost = None if one[2] is None or other[2] is None else np.concatenate([one[2], other[2]])
    return one[0] + other[0], np.concatenate([one[1], other[1]]), lost
