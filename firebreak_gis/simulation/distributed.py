"""Many fires on many machines: the runs of a simulation as tasks of a dask scheduler.

Runs are numbered and their draws are keyed, so a task is a range of runs and nothing else has to be agreed on. dask
decides where tasks run: on threads or processes of this machine, or on a cluster.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import MissingComponentError, ParameterError
from firebreak_gis.simulation.fires import burn_maps, of_runs, simulate
from firebreak_gis.simulation.ignitions import resolve_ignitions

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Part = tuple[np.ndarray, dict[str, np.ndarray]]

#: Numbers of a run that some simulations have, in the order of `simulate`.
_LATER = ("duration", "containment", "weather")


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
        All else as in `simulate`, but no `products`.

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

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> spread_out = fb.simulate_distributed(network, n_runs=40, runs_per_task=10, seed=3)
    >>> bool((spread_out["fire_size"] == fb.simulate(network, n_runs=40, seed=3)["fire_size"]).all())
    True
    """
    try:
        from dask.delayed import delayed
    except ImportError:
        raise MissingComponentError(
            "dask is not installed, which spreads the runs; install firebreak_gis[scale]"
        ) from None

    if fires.get("products") is not None:
        raise ParameterError("products are kept by simulate alone, not by tasks of dask")
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
    counts, told = parts[0].compute()
    burns = burn_maps(network, counts, told["fire_size"], seed=seed, lost=told.get("value_lost"))
    return burns.assign({name: of_runs(name, told[name]) for name in _LATER if name in told})


def _part(network: SpreadNetwork, **fires: Any) -> Part:
    burns = simulate(network, threads=1, **fires)
    return burns["burn_count"].to_numpy(), {
        name: burns[name].to_numpy() for name in ("fire_size", "value_lost", *_LATER) if name in burns
    }


def _join(one: Part, other: Part) -> Part:
    """The runs of both, `one` before `other`."""
    return one[0] + other[0], {name: np.concatenate([told, other[1][name]]) for name, told in one[1].items()}
