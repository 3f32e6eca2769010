"""How good a plan is: R(d_f) of rankings on the same fires, and whether they differ from a baseline."""

from __future__ import annotations

import typing
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.breaks import Amount, require_priority, shares_of
from firebreak_gis.errors import ParameterError
from firebreak_gis.progress import Progress, part
from firebreak_gis.simulation.budgets import Sizes, burn_budgets, burn_each
from firebreak_gis.simulation.containment import as_containment
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.fires import resolved
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import as_hold
from firebreak_gis.simulation.request import FireRequest, IgnitionMode

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.weather import WeatherNetworks

#: Ranks the cells for a budget (a share) and a residual, reporting its progress; the same object for the same plan.
Ranker = Callable[[float, float, Progress], "np.ndarray | xr.DataArray"]


@dataclass(frozen=True)
class ByBudget:
    """Breaks that do not follow from a priority.

    Parameters
    ----------
    breaks
        Returns them for a budget, a share of the fuel; None for none.
    """

    breaks: Callable[[float], LineBreaks | np.ndarray | xr.DataArray | None]


Test = Literal["wilcoxon", "ranksum", "t"]

#: Words of `significant`.
BETTER, WORSE = "better", "worse"
#: Up to so many runs that differ, the signed-rank test is exact; beyond, its normal approximation is.
_EXACT_UP_TO = 50


def evaluate(
    network: SpreadNetwork,
    priorities: Mapping[str, np.ndarray | xr.DataArray | Ranker],
    *,
    budgets: Sequence[Amount] | np.ndarray,
    baseline: str = "random",
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 100,
    seed: int = 0,
    residual: float = 0.0,
    duration: Any = None,
    weather: WeatherNetworks | None = None,
    embers: Any = None,
    hold: Any = None,
    containment: Any = None,
    test: Test = "wilcoxon",
    alpha: float = 0.01,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the same fires under several rankings at every budget.

    Parameters
    ----------
    network
        The spread network before cutting.
    priorities
        By method name, `baseline` among them: a priority raster, or a function ``(budget, residual, progress)`` that
        returns the one of the plan for them, such as `planning.design.Designs`.
    budgets
        Shares d_f of the cells that hold fuel such as 0.05 or "5%", or areas such as "20ha"; rising.
    baseline
        Method that the others are tested against.
    ignitions, ignition_mode, n_runs, seed, threads, progress
        As in `simulate`.
    residual, duration, weather, embers, hold, containment
        As in `simulate`; with any of the last five the fires of every budget are burnt again, so give few budgets.
        Without them breaks are perfect, and all budgets take one pass a run.
    test, alpha
        See `tell_apart`; significance threshold.

    Returns
    -------
    xarray.Dataset
        As `summarise` returns it.

    Raises
    ------
    ParameterError, InputError, GridError
        As `summarise` and `simulate`; the baseline is looked for before the first fire.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> rankings = {name: fb.rank(network, name) for name in ("bonacich", "random")}
    >>> result = fb.evaluate(network, rankings, budgets=[0.0, 0.2], n_runs=50)
    >>> result["mean"].sizes["ranking"], result["mean"].sizes["budget"]
    (2, 2)
    >>> float(result["p_value"].sel(ranking="bonacich", budget=0.0))  # the same fires, and nothing cut
    1.0
    """
    request = FireRequest(
        ignitions,
        ignition_mode,
        n_runs,
        seed,
        residual,
        duration=None if duration is None else as_duration(duration),
        hold=as_hold(hold),
        embers=as_embers(embers),
        containment=as_containment(containment),
    )
    if residual and request.timeless and weather is None:
        raise ParameterError(
            "residual counts with a duration, embers, hold or weather; without them breaks are perfect"
        )
    return evaluate_fires(
        network,
        priorities,
        request,
        budgets=shares_of(budgets, network),
        baseline=baseline,
        test=test,
        alpha=alpha,
        ground=Ground(network, weather),
        threads=threads,
        progress=progress,
    )


def evaluate_fires(
    network: SpreadNetwork,
    priorities: Mapping[str, np.ndarray | xr.DataArray | Ranker | ByBudget],
    request: FireRequest,
    *,
    budgets: Sequence[float] | np.ndarray,
    baseline: str = "random",
    test: Test = "wilcoxon",
    alpha: float = 0.01,
    ground: Ground | None = None,
    known: Sizes | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Judge rankings on the fires of a request.

    Parameters
    ----------
    network
        What the rankings were made on, and of whose fuel the budgets and burnt areas are shares.
    request
        The fires. With a clock, embers or breaks that fail, each budget is burnt by itself; see `burn_budgets`.
    ground
        Where the fires burn, if that is not `network`.
    priorities
        As in `evaluate`, or `ByBudget`, whose budgets are burnt one by one.
    known
        As in `burn_each`.
    budgets, baseline, test, alpha, threads, progress
        As in `evaluate`.
    """
    _require_choice(priorities, baseline, test)
    for priority in priorities.values():
        if not isinstance(priority, ByBudget):
            require_priority(priority)
    known = Sizes() if known is None else known
    cells = {}
    for i, (name, priority) in enumerate(priorities.items()):
        step = part(progress, i / len(priorities), (i + 1) / len(priorities), f"{name}: ")
        if isinstance(priority, ByBudget):
            same = replace(request, ignitions=resolved(network, request))
            laid = [priority.breaks(float(budget)) for budget in budgets]
            burnt = burn_each(ground or Ground(network), same, laid, known=known, threads=threads, progress=step)
        elif callable(priority):
            plans = _plans(priority, budgets, part(step, 0.0, 0.5))
            later = part(step, 0.5, 1.0)
            burnt = burnt_under(
                network, plans, request, budgets=budgets, ground=ground, known=known, threads=threads, progress=later
            )
        else:
            burnt = burn_budgets(
                network, priority, request, budgets=budgets, ground=ground, known=known, threads=threads, progress=step
            ).to_numpy()
        cells[name] = burnt
    fuel = max(network.n_burnable, 1)
    result = summarise(cells, fuel=fuel, budgets=budgets, baseline=baseline, test=test, alpha=alpha)
    return result.assign_attrs(n_burnable=network.n_burnable, n_runs=request.n_runs, seed=request.seed)


def _plans(ranker: Ranker, budgets: Sequence[float] | np.ndarray, progress: Progress) -> Iterator[Any]:
    for k, budget in enumerate(budgets):
        yield ranker(float(budget), 0.0, part(progress, k / len(budgets), (k + 1) / len(budgets)))


def burnt_under(
    network: SpreadNetwork,
    plans: Iterable[Any],
    request: FireRequest,
    *,
    budgets: Sequence[float] | np.ndarray,
    ground: Ground | None = None,
    known: Sizes | None = None,
    threads: int | None = None,
    progress: Progress,
) -> np.ndarray:
    """Cells burnt where each budget has its own plan.

    Parameters
    ----------
    plans
        The priority for each of the budgets; those in a row that are one object are burnt in one pass.
    request, budgets, ground, known, threads
        As in `burn_budgets`.

    Returns
    -------
    numpy.ndarray
        (n_runs, n_budgets) int64.
    """
    parts: list[np.ndarray] = []
    plan: Any = None
    first, count = 0, len(budgets)

    def burn(until: int) -> None:
        step, some = part(progress, first / count, until / count), budgets[first:until]
        more: dict[str, Any] = {"ground": ground, "known": known, "threads": threads, "progress": step}
        parts.append(burn_budgets(network, plan, request, budgets=some, **more).to_numpy())

    for k, made in enumerate(plans):
        if k and made is not plan:
            burn(k)
            first = k
        plan = made
    burn(count)
    return np.concatenate(parts, axis=1)


def summarise(
    cells: Mapping[str, np.ndarray],
    *,
    fuel: int,
    budgets: Sequence[float] | np.ndarray,
    baseline: str = "random",
    test: Test = "wilcoxon",
    alpha: float = 0.01,
) -> xr.Dataset:
    """Turn the sizes of single fires into R(d_f) and its significance.

    The tests look at the sizes themselves: shares of equal differences differ by rounding, which breaks their ties.

    Parameters
    ----------
    cells
        (n_runs, n_budgets) whole number of cells burnt, by method; row i is the same fire in all.
    fuel
        Cells with fuel before cutting, of which R is a share.
    budgets
        d_f of the columns.
    baseline
        Method that the others are tested against.
    test, alpha
        See `tell_apart`; significance threshold.

    Returns
    -------
    xarray.Dataset
        `burnt_cells` and `burnt_share` (ranking, run, budget); `mean`, `p90` (90 % percentile), `max`, `p_value`,
        `effect_size` and `significant` (ranking, budget): `better` where the ranking burns less than the baseline,
        `worse` where it burns more, `no` where they do not differ. The p-value of the baseline itself is nan.

    Raises
    ------
    ParameterError
        If the baseline is not among the methods, or there is no such test.
    """
    import xarray as xr

    _require_choice(cells, baseline, test)
    names = list(cells)
    burnt = np.stack([cells[name] for name in names])
    shares = burnt / fuel
    p_value = np.full((len(names), burnt.shape[2]), np.nan)
    effect = np.full_like(p_value, np.nan)
    for i, name in enumerate(names):
        if name != baseline:
            for k in range(burnt.shape[2]):
                p_value[i, k], effect[i, k] = tell_apart(cells[name][:, k], cells[baseline][:, k], test=test)
    by_budget = ("ranking", "budget")
    return xr.Dataset(
        {
            "burnt_cells": (("ranking", "run", "budget"), burnt),
            "burnt_share": (("ranking", "run", "budget"), shares),
            "mean": (by_budget, shares.mean(axis=1)),
            "p90": (by_budget, np.percentile(shares, 90, axis=1)),
            "max": (by_budget, shares.max(axis=1)),
            "p_value": (by_budget, p_value),
            "effect_size": (by_budget, effect),
            "significant": (by_budget, _direction(p_value < alpha, effect)),
        },
        coords={"ranking": names, "budget": np.asarray(budgets, dtype=np.float64)},
        attrs={"baseline": baseline, "test": test, "alpha": alpha},
    )


def _direction(differs: np.ndarray, effect: np.ndarray) -> np.ndarray:
    return np.select([differs & (effect < 0), differs & (effect > 0)], [BETTER, WORSE], "no")


def _require_choice(methods: Mapping[str, Any], baseline: str, test: str) -> None:
    if baseline not in methods:
        raise ParameterError(f"the baseline {baseline!r} is not among the methods {', '.join(methods)}")
    _require_test(test)


def _require_test(test: str) -> None:
    if test not in typing.get_args(Test):
        raise ParameterError(f"test is {test!r}, expected one of {', '.join(typing.get_args(Test))}")


def tell_apart(burnt: np.ndarray, baseline: np.ndarray, *, test: Test = "wilcoxon") -> tuple[float, float]:
    """Test whether two samples of fires differ.

    Parameters
    ----------
    burnt, baseline
        (n_runs,) sizes of fires: cells, whose ties are exact.
    test
        `"wilcoxon"`: signed-rank on runs that share their draws, zeros by Pratt's method, exact (over all signs of the
        ranks) for up to 50 runs that differ; equal samples are no difference (p = 1). `"ranksum"`: for independent
        runs. `"t"`: paired t-test.

    Returns
    -------
    tuple of float
        Two-sided p-value, and the effect size from -1 to 1, negative where `burnt` is smaller: matched-pairs
        rank-biserial correlation (`wilcoxon`, `t`) or Cliff's delta (`ranksum`).
    """
    from scipy import stats

    _require_test(test)
    difference = burnt - baseline
    if test == "ranksum":
        outcome = stats.mannwhitneyu(burnt, baseline, alternative="two-sided")
        return float(outcome.pvalue), float(2.0 * outcome.statistic / (burnt.size * baseline.size) - 1.0)
    if not difference.any():
        return 1.0, 0.0
    ranks = stats.rankdata(np.abs(difference))
    effect = float((ranks * np.sign(difference)).sum() / ranks.sum())
    if test == "t":
        if difference.size == 1:
            return 1.0, effect  # one run proves nothing
        constant = np.ptp(difference) == 0.0
        return (0.0 if constant else float(stats.ttest_rel(burnt, baseline).pvalue)), effect
    if np.count_nonzero(difference) <= _EXACT_UP_TO:
        return _signed_rank(ranks[difference != 0], difference[difference != 0] > 0), effect
    return float(stats.wilcoxon(burnt, baseline, zero_method="pratt", method="approx").pvalue), effect


def _signed_rank(ranks: np.ndarray, positive: np.ndarray) -> float:
    """Exact two-sided p-value: the share of all signs of the ranks whose sum lies as far from its mean."""
    doubled = np.round(2 * ranks).astype(np.int64)  # ranks of ties are halves
    total = int(doubled.sum())
    ways = np.zeros(total + 1)
    ways[0] = 1.0
    for rank in doubled.tolist():
        ways[rank:] += ways[: total + 1 - rank].copy()
    found = abs(2 * int(doubled[positive].sum()) - total)
    far = np.abs(2 * np.arange(total + 1) - total) >= found
    return float(ways[far].sum() / ways.sum())


def better_range(result: xr.Dataset, ranking: str) -> list[float] | None:
    """First and last budget at which a ranking burns significantly less than the baseline; None if never."""
    picked = result.sel(ranking=ranking)
    better = np.flatnonzero(picked["significant"].to_numpy() == BETTER)
    budgets = result["budget"].to_numpy()
    return [float(budgets[better[0]]), float(budgets[better[-1]])] if better.size else None


def table(result: xr.Dataset) -> pd.DataFrame:
    """One row a method and budget: method, d_f, cells_cut, mean, p90, max, p_value, effect_size, ..."""
    import pandas as pd

    from firebreak_gis.breaks import Budget

    n_burnable = int(result.attrs["n_burnable"])
    rows = [
        {
            "method": name,
            "d_f": float(budget),
            "cells_cut": Budget(float(budget)).cells(n_burnable=n_burnable),
            **{
                key: result[key].to_numpy()[i, k]
                for key in ("mean", "p90", "max", "p_value", "effect_size", "significant")
            },
        }
        for i, name in enumerate(result["ranking"].to_numpy().tolist())
        for k, budget in enumerate(result["budget"].to_numpy())
    ]
    return pd.DataFrame(rows)


def runs_table(result: xr.Dataset) -> pd.DataFrame:
    """Cells burnt in every run: run, d_f and a column for each method; every p-value can be found from it again."""
    import pandas as pd

    cells = result["burnt_cells"].to_numpy()
    _, n_runs, n_budgets = cells.shape
    columns = {
        "run": np.tile(np.arange(1, n_runs + 1), n_budgets),
        "d_f": np.repeat(result["budget"].to_numpy(), n_runs),
    }
    names = result["ranking"].to_numpy().tolist()
    return pd.DataFrame(columns | {name: cells[i].T.ravel() for i, name in enumerate(names)})
