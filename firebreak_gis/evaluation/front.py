"""The front of a comparison: what is saved against what is paid, and where the next hectare stops paying.

Breaks pay while what they save, in all fires that meet them, is worth more than they cost. Fires here are those of the
simulation, so a front holds for as many of them as is said. A wall is worth little before it is closed, so that what
single steps save goes up and down; the budget of the largest net saving is therefore the one beyond which no further
step pays for what it adds.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.measures import BOUNDS, resamples

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

#: Words of the column `pays`: the whole interval is above the price, or below it, or neither.
PAYS, STOPPED, UNSURE = "yes", "no", "unsure"


def front_table(result: xr.Dataset, *, n_fires: float = 1.0) -> pd.DataFrame:
    """Saved against paid, step by step.

    Parameters
    ----------
    result
        As `comparison.compare_plans` returns it: where its attribute `priced` is true, costs and values count, else
        hectares.
    n_fires
        Fires that meet the breaks before they have grown back.

    Returns
    -------
    pandas.DataFrame
        One row a method, residual and budget for which there is a plan, rising: `method`, `residual`, `d_f`, `ha_cut`,
        `paid` (hectares, or money), `saved` (in all fires: hectares, or value), `step_saved` (per unit paid since the
        budget before, or since none), each of the two with `_low` and `_high`, the ends of its 95 % interval (bootstrap
        over fires, the same for all plans); `pays` (`yes`, `no`, `unsure`: whether that step saves more than it costs),
        `front` (whether no other plan of the residual saves as much for less), and `stop`, `stop_low`, `stop_high`, the
        same for all budgets of a method and residual: what is paid where the net saving is largest.

    Raises
    ------
    ParameterError
        If `n_fires` is not above 0.
    """
    import pandas as pd

    require_fires(n_fires)
    picks = resamples(result.sizes["run"], int(result.attrs["fire_seed"]))
    saved, paid = _saved_and_paid(result, n_fires)
    cut, budgets = result["ha_cut"].to_numpy(), result["budget"].to_numpy()
    rows: list[dict[str, Any]] = []
    for i, method in enumerate(result["ranking"].to_numpy().tolist()):
        for j, residual in enumerate(result["residual"].to_numpy().tolist()):
            there = np.flatnonzero(~np.isnan(cut[i, :, j]))
            if not there.size:
                continue
            steps = _steps(saved[i, there, j], paid[i, there, j], picks)
            for k, at in enumerate(there):
                known = {"method": method, "residual": residual, "d_f": float(budgets[at]), "ha_cut": cut[i, at, j]}
                rows.append(known | {name: each[k] if np.ndim(each) else each for name, each in steps.items()})
    table = pd.DataFrame(rows)
    table.insert(list(table).index("pays") + 1, "front", _undominated(table))
    return table


def require_fires(n_fires: float) -> None:
    """Refuse a number of expected fires that cannot be."""
    if not (np.isfinite(n_fires) and n_fires > 0):
        raise ParameterError(f"the number of fires is {n_fires}, expected a number above 0")


def _saved_and_paid(result: xr.Dataset, n_fires: float) -> tuple[np.ndarray, np.ndarray]:
    """What each fire saves, (ranking, budget, residual, run), and what is paid, (ranking, budget, residual)."""
    if result.attrs.get("priced"):
        saved = result["lost_untreated"].to_numpy() - result["lost"].to_numpy()
        return saved * n_fires, result["cost"].to_numpy()
    area = float(result.attrs["cell_area_ha"])
    saved = (result["burnt_untreated"].to_numpy() - result["burnt"].to_numpy()) * area
    return saved * n_fires, result["ha_cut"].to_numpy()


def _steps(saved: np.ndarray, paid: np.ndarray, picks: np.ndarray) -> dict[str, Any]:
    """Columns of one method and residual from what each fire saves, (n_budgets, n_runs), and what is paid."""
    drawn = saved[:, picks].mean(axis=2)  # (n_budgets, n_samples)
    mean = saved.mean(axis=1)
    more = np.diff(paid, prepend=0.0)
    spent = np.where(more > 0, more, np.nan)
    step, step_drawn = np.diff(mean, prepend=0.0) / spent, np.diff(drawn, axis=0, prepend=0.0) / spent[:, None]
    low, high = np.percentile(drawn, BOUNDS, axis=1)
    step_low, step_high = np.percentile(step_drawn, BOUNDS, axis=1)
    stops = _stop(drawn, paid)
    return {
        "paid": paid,
        "saved": mean,
        "saved_low": low,
        "saved_high": high,
        "step_saved": step,
        "step_saved_low": step_low,
        "step_saved_high": step_high,
        "pays": np.select([step_low >= 1.0, step_high < 1.0], [PAYS, STOPPED], UNSURE),
        "stop": float(_stop(mean[:, None], paid)[0]),
        "stop_low": float(np.percentile(stops, BOUNDS[0])),
        "stop_high": float(np.percentile(stops, BOUNDS[1])),
    }


def _stop(saved: np.ndarray, paid: np.ndarray) -> np.ndarray:
    """What is paid where the net saving is largest, the least of equals; `saved` is (n_budgets, n_samples)."""
    net = np.concatenate([np.zeros((1, saved.shape[1])), saved - paid[:, None]])
    return np.asarray(np.append(0.0, paid)[net.argmax(axis=0)])


def _undominated(table: pd.DataFrame) -> np.ndarray:
    """Whether no other plan of the same residual saves as much for less, or more for as much."""
    paid, saved = table["paid"].to_numpy(), table["saved"].to_numpy()
    same = table["residual"].to_numpy()[:, None] == table["residual"].to_numpy()
    no_worse = (paid[None] <= paid[:, None]) & (saved[None] >= saved[:, None])
    better = (paid[None] < paid[:, None]) | (saved[None] > saved[:, None])
    return np.asarray(~(same & no_worse & better).any(axis=1) & (saved > 0))


def stops_told(table: pd.DataFrame, *, priced: bool, n_fires: float = 1.0) -> list[str]:
    """Say, for the best method of each residual, where the next hectare stops paying.

    The best is that of the largest net saving. `table` is of `front_table`.
    """
    told = []
    unit = "" if priced else " ha"
    fires = "one fire" if n_fires == 1.0 else f"{n_fires:g} fires"
    for residual, rows in table.groupby("residual"):
        best = rows.loc[(rows["saved"] - rows["paid"]).idxmax()]
        leak = f"a residual of {float(residual):g}"
        step = "money" if priced else "hectare"
        own = rows[rows["method"] == best["method"]]
        if best["stop"] <= 0.0:
            paying = rows[rows["saved"] > 0.0]
            needed = n_fires * float((paying["paid"] / paying["saved"]).min()) if len(paying) else float("inf")
            told.append(
                f"With {leak} no budget looked at pays in {fires}: each saves less than it costs"
                + (f"; the best pays from {needed:.2g} fires on." if np.isfinite(needed) else ".")
            )
        elif best["stop"] >= own["paid"].max():
            told.append(
                f"With {leak} {best['method']} saves most for what it costs ({fires}), and the next {step} still pays "
                f"at the largest budget looked at, {best['stop']:,.0f}{unit}."
            )
        else:
            told.append(
                f"With {leak} {best['method']} saves most for what it costs ({fires}): the next {step} stops paying "
                f"beyond {best['stop']:,.0f}{unit} (95 % interval {best['stop_low']:,.0f} to {best['stop_high']:,.0f}, "
                "among the budgets looked at)."
            )
    return told
