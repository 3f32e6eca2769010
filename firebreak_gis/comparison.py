"""Rankings against each other: methods x budgets x leaks, on fires that no plan was designed with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import select_breaks
from firebreak_gis.errors import ParameterError
from firebreak_gis.ignitions import IgnitionMode
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.simulation import burn_curve, simulate

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

#: Added to the seed of the design, so that no plan is judged on fires that it has seen.
FRESH = 7919
#: Share of the worst runs that CVaR averages.
WORST = 0.1
_RESAMPLES = 500


def compare_plans(
    network: SpreadNetwork,
    priorities: Mapping[str, np.ndarray | xr.DataArray],
    *,
    budgets: Sequence[float],
    residuals: Sequence[float] = (0.0, 0.05, 0.1),
    value: np.ndarray | None = None,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 200,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the same fresh fires under every ranking, budget and residual.

    Parameters
    ----------
    network
        The spread network before cutting.
    priorities
        Priority raster by label.
    budgets
        Shares d_f of the cells that hold fuel.
    residuals
        Shares of its spread probability that a treated cell keeps; 0 is a perfect break.
    value
        (rows, cols) value lost when the cell burns; without it every cell counts 1.
    ignitions, ignition_mode, n_runs, threads, progress
        As in `simulate`.
    seed
        Seed of the design; the fires are drawn with another one.

    Returns
    -------
    xarray.Dataset
        `burnt` (ranking, budget, residual, run) cells burnt, `lost` likewise value lost, `burnt_untreated`,
        `lost_untreated` (run), `cells_cut` (budget).

    Notes
    -----
    Perfect breaks need one pass a run for all budgets (`burn_curve`) unless values are given; leaking ones are
    simulated for each budget, with the same draws.
    """
    import xarray as xr

    budgets = sorted(budgets)
    residuals = sorted(residuals)
    if not budgets or not residuals:
        raise ParameterError("give at least one budget and one residual")
    report = progress or silent
    fires: dict[str, Any] = {
        "ignitions": ignitions,
        "ignition_mode": ignition_mode,
        "n_runs": n_runs,
        "seed": seed + FRESH,
        "threads": threads,
    }
    worth = network.burnable.astype(np.float64) if value is None else value
    untreated = simulate(network, value=worth, progress=part(report, 0.0, 0.05, "untreated: "), **fires)
    shape = (len(priorities), len(budgets), len(residuals), n_runs)
    burnt, lost = np.zeros(shape), np.zeros(shape)
    cut = np.zeros(len(budgets), dtype=np.int64)
    n_steps = len(priorities) * len(residuals)
    for i, (label, priority) in enumerate(priorities.items()):
        masks = [select_breaks(priority, budget=b, burnable=network.burnable) for b in budgets]
        cut[:] = [m.attrs["cells_cut"] for m in masks]
        for j, residual in enumerate(residuals):
            done = (i * len(residuals) + j) / n_steps
            step = part(
                report, 0.05 + 0.95 * done, 0.05 + 0.95 * (done + 1 / n_steps), f"{label}, residual {residual:g}: "
            )
            if residual == 0.0 and value is None:
                cells = burn_curve(network, priority, budgets=budgets, progress=step, **fires).to_numpy().T
                burnt[i, :, j] = lost[i, :, j] = cells
                continue
            for k, mask in enumerate(masks):
                run = simulate(
                    network,
                    breaks=mask,
                    residual=residual,
                    value=worth,
                    progress=part(step, k / len(masks), (k + 1) / len(masks)),
                    **fires,
                )
                burnt[i, k, j] = run["fire_size"]
                lost[i, k, j] = run["value_lost"]
    dims = ("ranking", "budget", "residual", "run")
    return xr.Dataset(
        {
            "burnt": (dims, burnt),
            "lost": (dims, lost),
            "burnt_untreated": ("run", untreated["fire_size"].to_numpy()),
            "lost_untreated": ("run", untreated["value_lost"].to_numpy()),
            "cells_cut": ("budget", cut),
        },
        coords={"ranking": list(priorities), "budget": budgets, "residual": residuals},
        attrs={
            "n_burnable": network.n_burnable,
            "cell_area_ha": network.grid.cell_area_ha,
            "n_runs": n_runs,
            "fire_seed": seed + FRESH,
        },
    )


def comparison_table(result: xr.Dataset) -> pd.DataFrame:
    """One row a ranking, budget and residual, each measure with its 95 % interval.

    Columns: method, d_f, residual, cells_cut, ha_cut, R (mean burnt share), burnt_ha (expected), p90_ha (90 %
    percentile), cvar_ha (mean of the worst 10 % of runs), value_lost, leverage (ha saved per ha treated, paired);
    `_low` and `_high` are bootstrap percentiles over runs.
    """
    import pandas as pd

    area, n_burnable = float(result.attrs["cell_area_ha"]), int(result.attrs["n_burnable"])
    rng = np.random.default_rng(int(result.attrs["fire_seed"]))
    picks = rng.integers(0, result.sizes["run"], (_RESAMPLES, result.sizes["run"]))
    untreated = result["burnt_untreated"].to_numpy() * area
    rows = []
    for label in result["ranking"].to_numpy().tolist():
        for budget, cells in zip(result["budget"].to_numpy(), result["cells_cut"].to_numpy(), strict=True):
            for residual in result["residual"].to_numpy():
                chosen = result.sel(ranking=label, budget=budget, residual=residual)
                burnt = chosen["burnt"].to_numpy() * area
                saved = (untreated - burnt) / max(cells * area, area)
                row: dict[str, Any] = {
                    "method": label,
                    "d_f": float(budget),
                    "residual": float(residual),
                    "cells_cut": int(cells),
                    "ha_cut": cells * area,
                    "R": burnt.mean() / (n_burnable * area),
                }
                for name, runs, measure in (
                    ("burnt_ha", burnt, _mean),
                    ("p90_ha", burnt, _p90),
                    ("cvar_ha", burnt, _cvar),
                    ("value_lost", chosen["lost"].to_numpy(), _mean),
                    ("leverage", saved, _mean),
                ):
                    low, high = np.percentile(measure(runs[picks]), [2.5, 97.5])
                    row |= {name: float(measure(runs[None])[0]), f"{name}_low": float(low), f"{name}_high": float(high)}
                rows.append(row)
    return pd.DataFrame(rows)


def _mean(runs: np.ndarray) -> np.ndarray:
    return np.asarray(runs.mean(axis=1))


def _p90(runs: np.ndarray) -> np.ndarray:
    return np.asarray(np.percentile(runs, 90, axis=1))


def _cvar(runs: np.ndarray) -> np.ndarray:
    count = max(1, round(WORST * runs.shape[1]))
    return np.asarray(np.sort(runs, axis=1)[:, -count:].mean(axis=1))
