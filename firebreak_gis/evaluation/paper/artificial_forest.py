"""Figure 1: R(d_f) of every centrality on an ensemble of artificial forests."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.curves import better_range, summarise
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.budgets import burn_curve
from firebreak_gis.spread import spread_network
from firebreak_gis.spread.artificial import forest

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

Method = tuple[str, str, dict[str, Any]]
#: Rankings of the figure: label, method, parameters.
METHODS: tuple[Method, ...] = (
    ("bonacich 0.5", "bonacich", {"beta": 0.5}),
    ("bonacich 0.2", "bonacich", {"beta": 0.2}),
    ("bonacich 0.8", "bonacich", {"beta": 0.8}),
    ("betweenness", "betweenness", {}),
    ("closeness", "closeness", {}),
    ("degree", "degree", {}),
    ("eigenvector", "eigenvector", {}),
    ("flammability", "flammability", {}),
    ("random", "random", {}),
)
#: Those that the paper names or that were found since, beside three of its own; slow ones are sampled.
NAMED: tuple[Method, ...] = (
    ("bonacich 0.5", "bonacich", {"beta": 0.5}),
    ("betweenness", "betweenness", {}),
    ("information", "information", {}),
    ("current flow", "current_flow", {"pairs": 500}),
    ("percolation", "percolation", {}),
    ("pagerank", "pagerank", {}),
    ("domirank", "domirank", {}),
    ("group betweenness", "group_betweenness", {"pivots": 200}),
    ("random", "random", {}),
)
#: By name, for the command.
SETS: dict[str, tuple[Method, ...]] = {"paper": METHODS, "named": NAMED}
SHAPE = (50, 50)
BUDGETS = tuple(round(0.01 * k, 2) for k in range(51))
#: The fall of R is dated at the first budget whose mean lies below this.
FALLEN = 0.3


def artificial_forest(
    *,
    rankings: str = "paper",
    n_forests: int = 100,
    n_runs: int = 10,
    seed: int = 0,
    shape: tuple[int, int] = SHAPE,
    budgets: Sequence[float] = BUDGETS,
    alpha: float = 0.01,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn an ensemble of artificial forests under every ranking.

    Each forest is drawn anew, ranked by every method and set on fire at its centre `n_runs` times; the fires
    of a forest are the same for all methods.

    Parameters
    ----------
    rankings
        A name in `SETS`: `"paper"`, those of its figure, or `"named"`.
    n_forests
        Number of forests.
    n_runs
        Fires a forest.
    seed
        Seed of forests, fires and random orders.
    shape
        (rows, cols).
    budgets
        Shares d_f to cut, rising.
    alpha
        Significance threshold.
    threads
        Threads to use; changes the speed only.
    progress
        Callback (share done, message).

    Returns
    -------
    xarray.Dataset
        As `evaluation.summarise`, rankings labelled as in `SETS`. Mean, percentile and maximum are over
        all fires; the paired Wilcoxon test compares the sums of the forests, since fires of one forest are
        not independent.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> result = fb.artificial_forest(n_forests=2, n_runs=3, shape=(10, 12), budgets=[0.0, 0.3])
    >>> result["mean"].sizes["budget"], bool((result["mean"].sel(budget=0.3) < 1.0).all())
    (2, True)
    """
    from firebreak_gis.kernels.draws import run_keys

    if n_forests < 1:
        raise ParameterError(f"the number of forests is {n_forests}, expected at least 1")
    report = progress or silent
    if rankings not in SETS:
        raise ParameterError(f"the rankings are {rankings!r}, expected one of {', '.join(SETS)}")
    methods = SETS[rankings]
    fires: dict[str, list[np.ndarray]] = {label: [] for label, _, _ in methods}
    centre = np.zeros(shape)
    centre[shape[0] // 2, shape[1] // 2] = 1.0
    for i, key in enumerate(run_keys(seed, "forest", n_forests)):
        step = part(report, i / n_forests, (i + 1) / n_forests, f"forest {i + 1} of {n_forests}: ")
        network = spread_network(forest(shape, seed=int(key)), model="artificial")
        for k, (label, method, params) in enumerate(methods):
            step(k / len(methods), label)
            priority = rank(network, method, seed=int(key), **params)
            burnt = burn_curve(
                network,
                priority,
                budgets=budgets,
                ignitions=centre,
                n_runs=n_runs,
                seed=int(key),
                threads=threads,
            )
            fires[label].append(burnt.to_numpy())
    fuel = shape[0] * shape[1]
    all_fires = {label: np.concatenate(cells) for label, cells in fires.items()}
    by_forest = {label: np.stack([c.sum(axis=0) for c in cells]) for label, cells in fires.items()}
    result = summarise(all_fires, fuel=fuel, budgets=budgets, baseline="random", alpha=alpha)
    tested = summarise(by_forest, fuel=fuel * n_runs, budgets=budgets, baseline="random", alpha=alpha)
    for key in ("p_value", "effect_size", "significant"):
        result[key] = tested[key]
    return result.assign_attrs(rankings=rankings, n_forests=n_forests, n_runs=n_runs, seed=seed, n_burnable=fuel)


def curve_table(result: xr.Dataset) -> pd.DataFrame:
    """One row a method and budget: method, beta, d_f, mean, p90, max, p_value."""
    import pandas as pd

    rows = []
    for label, method, params in SETS[result.attrs["rankings"]]:
        picked = result.sel(ranking=label)
        for k, d_f in enumerate(result["budget"].to_numpy()):
            row: dict[str, Any] = {"method": method, "beta": params.get("beta"), "d_f": float(d_f)}
            row |= {key: float(picked[key].to_numpy()[k]) for key in ("mean", "p90", "max", "p_value")}
            rows.append(row)
    return pd.DataFrame(rows)


def summary(result: xr.Dataset) -> dict[str, Any]:
    """Where each ranking falls, and where it differs from random.

    Returns
    -------
    dict
        By label: `d_f_below_0.3`, the smallest d_f at which mean R < 0.3 (None if never), and
        `significant_d_f`, first and last budget at which the ranking burns significantly less than random
        (None if never).
    """
    d_f = result["budget"].to_numpy()
    found: dict[str, Any] = {}
    for label in result["ranking"].to_numpy().tolist():
        picked = result.sel(ranking=label)
        fallen = np.flatnonzero(picked["mean"].to_numpy() < FALLEN)
        found[label] = {
            "d_f_below_0.3": float(d_f[fallen[0]]) if fallen.size else None,
            "significant_d_f": better_range(result, label),
        }
    settings = {key: int(result.attrs[key]) for key in ("n_forests", "n_runs", "seed")}
    return {"settings": {**settings, "alpha": float(result.attrs["alpha"])}, "methods": found}
