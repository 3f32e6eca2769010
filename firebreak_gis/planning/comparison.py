"""Plans against each other: methods x budgets x leaks, on fires that no plan was designed with."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Amount, Budget, select_breaks, shares_of
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.curves import burnt_under
from firebreak_gis.evaluation.measures import judge, resamples
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.planning.design import Designs
from firebreak_gis.planning.line_design import LineDesign
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.simulation.fires import burn, resolved
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.network import SpreadNetwork


#: Makes the plan for a budget (a share) and a residual, reporting its progress; the same object for the same plan.
Planner = Callable[[float, float, Progress], Any]


def compare(
    network: SpreadNetwork,
    methods: Sequence[str],
    *,
    budgets: Sequence[Amount],
    residuals: Sequence[float] = (0.0,),
    ignitions: Any = None,
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> pd.DataFrame:
    """Set rankings against each other on the same fresh fires, which end by themselves.

    Parameters
    ----------
    network
        The spread network before cutting.
    methods
        Names of rankings; each makes its plan for the budget and the residual. Lines are none of them: `plan` makes
        those for fires with a clock, in which the command compares them.
    budgets
        Shares of the cells that hold fuel such as 0.05 or "5%", or areas such as "20ha".
    residuals
        Shares of its spread probability that a treated cell keeps; 0 is a perfect break.
    ignitions, n_runs, seed, threads, progress
        As in `simulate`; the seed is that of the designs, the fires have draws of their own.

    Returns
    -------
    pandas.DataFrame
        One row a method, budget and residual, see `comparison_table`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((20, 20), seed=1), model="artificial")
    >>> table = fb.compare(network, ["dissection", "random"], budgets=["20%"], n_runs=50)
    >>> burnt = table.set_index("method")["R"]
    >>> bool(burnt["dissection"] < burnt["random"])
    True
    """
    plans = {name: Designs(network, name, stakes=Stakes(network), seed=seed) for name in methods}
    fires = FireRequest(ignitions=ignitions, n_runs=n_runs, seed=seed)
    result = compare_plans(
        network,
        plans,
        fires,
        budgets=shares_of(budgets, network),
        residuals=residuals,
        threads=threads,
        progress=progress,
    )
    return comparison_table(result)


def compare_plans(
    network: SpreadNetwork,
    plans: Mapping[str, np.ndarray | xr.DataArray | Planner],
    fires: FireRequest,
    *,
    budgets: Sequence[float],
    residuals: Sequence[float] = (0.0, 0.05, 0.1),
    value: np.ndarray | None = None,
    cost: np.ndarray | None = None,
    ground: Ground | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the same fresh fires under every plan.

    Parameters
    ----------
    network
        The spread network before cutting.
    plans
        By label: a priority raster; or a function ``(budget, residual, progress)`` that returns the priority of the
        plan for them, or its `LineDesign`, or None where it has no plan. The same object is the same plan.
    fires
        What is burnt. Its seed is that of the designs, the fires are drawn with another one; its leak gives way to
        `residuals`.
    budgets
        Shares d_f of the cells that hold fuel.
    residuals
        Shares of its spread probability that a treated cell keeps; 0 is a perfect break.
    value
        (rows, cols) value lost when the cell burns; without it every cell counts 1.
    cost
        (rows, cols) cost of cutting the cell, in the unit of the value; without it every cell costs 1.
    ground
        Where the fires burn, if that is not `network`.
    threads, progress
        As in `simulate`.

    Returns
    -------
    xarray.Dataset
        `burnt` (ranking, budget, residual, run) cells burnt, `lost` likewise value lost, `burnt_untreated`,
        `lost_untreated` (run); `cells_cut`, `ha_cut` and `cost` (ranking, budget, residual), of lines the cells that
        they pass, and what their length times width is and costs. All NaN where there is no plan. The attribute
        `priced` tells whether costs and values were given.

    Raises
    ------
    ParameterError
        If there is no plan at all.

    Notes
    -----
    Perfect breaks of cells and fires without a clock need one pass a run for all budgets (`burn_curve`) unless values
    are given; all else is simulated for each budget, with the same draws.
    """
    import xarray as xr

    budgets = sorted(budgets)
    residuals = sorted(residuals)
    if not budgets or not residuals:
        raise ParameterError("give at least one budget and one residual")
    report = progress or silent
    fresh = replace(fires, seed=seed_for(fires.seed, "comparison"))
    fresh = replace(fresh, ignitions=resolved(network, fresh))
    worth = network.burnable.astype(np.float64) if value is None else value
    ground = ground or Ground(network)
    untreated = _fires(ground, fresh, None, worth, threads, part(report, 0.0, 0.02, "untreated: "))
    shape = (len(plans), len(budgets), len(residuals), fires.n_runs)
    burnt, lost, taken = np.zeros(shape), np.zeros(shape), np.zeros((3, *shape[:3]))
    price = network.burnable.astype(np.float64) if cost is None else cost
    steps = [(i, j) for i in range(len(plans)) for j in range(len(residuals))]
    for n, (i, j) in enumerate(steps):
        (label, plan), residual = list(plans.items())[i], residuals[j]
        span = (0.02 + 0.98 * n / len(steps), 0.02 + 0.98 * (n + 1) / len(steps))
        step = part(report, *span, f"{label}, residual {residual:g}: ")
        made: list[Any] = [
            plan(b, residual, part(step, 0.6 * k / len(budgets), 0.6 * (k + 1) / len(budgets)))
            if callable(plan)
            else plan
            for k, b in enumerate(budgets)
        ]
        cuts = [_cut(each, b, network, price) for each, b in zip(made, budgets, strict=True)]
        taken[:, i, :, j] = np.transpose([(cut.cells, cut.ha, cut.cost) for cut in cuts])
        burnt[i, :, j], lost[i, :, j] = _burn(
            network,
            ground,
            made,
            cuts,
            budgets,
            replace(fresh, residual=residual),
            None if value is None else worth,
            threads,
            part(step, 0.6, 1.0),
        )
    if np.isnan(taken).all():
        raise ParameterError(
            "no method has a plan: no budget pays the first wall of lines, or treated cells keep something; give "
            "larger budgets, or methods that rank cells"
        )
    dims = ("ranking", "budget", "residual", "run")
    return xr.Dataset(
        {
            "burnt": (dims, burnt),
            "lost": (dims, lost),
            "burnt_untreated": ("run", untreated["fire_size"].to_numpy()),
            "lost_untreated": ("run", untreated["value_lost"].to_numpy()),
            **{name: (dims[:3], each) for name, each in zip(("cells_cut", "ha_cut", "cost"), taken, strict=True)},
        },
        coords={"ranking": list(plans), "budget": budgets, "residual": residuals},
        attrs={
            "n_burnable": network.n_burnable,
            "cell_area_ha": network.grid.cell_area_ha,
            "n_runs": fires.n_runs,
            "fire_seed": fresh.seed,
            "priced": value is not None and cost is not None,
        },
    )


@dataclass(frozen=True, eq=False)
class _Cut:
    """What a plan cuts: the breaks as fires meet them, cells, hectares and cost; None and NaN without a plan."""

    breaks: xr.DataArray | LineBreaks | None = None
    cells: float = np.nan
    ha: float = np.nan
    cost: float = np.nan


def _cut(plan: Any, budget: float, network: SpreadNetwork, price: np.ndarray) -> _Cut:
    """What is cut for a budget, of cells by their price."""
    if plan is None:
        return _Cut()
    if isinstance(plan, LineDesign):
        amount = Budget(budget)
        figures = plan.figures(amount)
        return _Cut(plan.breaks(amount), figures["cells_cut"], figures["ha_cut"], figures["cost"])
    breaks = select_breaks(plan, budget=budget, burnable=network.burnable)
    cells = int(breaks.attrs["cells_cut"])
    return _Cut(breaks, cells, cells * network.grid.cell_area_ha, float(price[breaks.to_numpy() > 0].sum()))


def _fires(
    ground: Ground,
    fires: FireRequest,
    breaks: xr.DataArray | LineBreaks | None,
    value: np.ndarray | None,
    threads: int | None,
    progress: Progress,
) -> xr.Dataset:
    return burn(
        ground.network,
        fires,
        breaks=breaks,
        value=value,
        weather=ground.weather,
        barriers=ground.barriers,
        threads=threads,
        progress=progress,
    )


def _burn(
    network: SpreadNetwork,
    ground: Ground,
    made: list[Any],
    cuts: list[_Cut],
    budgets: Sequence[float],
    fires: FireRequest,
    value: np.ndarray | None,
    threads: int | None,
    progress: Progress,
) -> tuple[np.ndarray, np.ndarray]:
    """Cells burnt and value lost, (n_budgets, n_runs) each, under the plan of every budget; NaN where there is none."""
    shape = (len(budgets), fires.n_runs)
    burnt, lost = np.full(shape, np.nan), np.full(shape, np.nan)
    ranked = not any(plan is None or isinstance(plan, LineDesign) for plan in made)
    if ranked and fires.residual == 0.0 and value is None:
        burnt[:] = burnt_under(
            network, made, fires, budgets=budgets, ground=ground, threads=threads, progress=progress
        ).T
        return burnt, burnt
    for k, cut in enumerate(cuts):
        if cut.breaks is None:
            continue
        step = part(progress, k / len(budgets), (k + 1) / len(budgets))
        run = _fires(ground, fires, cut.breaks, value, threads, step)
        burnt[k] = run["fire_size"]
        lost[k] = run["fire_size"] if value is None else run["value_lost"]
    return burnt, lost


def comparison_table(result: xr.Dataset) -> pd.DataFrame:
    """One row a method, budget and residual for which it has a plan, each measure with its 95 % interval.

    Columns: method, d_f, residual, cells_cut, ha_cut, R (mean burnt share), and those of `measures.judge`.
    """
    import pandas as pd

    area, n_burnable = float(result.attrs["cell_area_ha"]), int(result.attrs["n_burnable"])
    picks = resamples(result.sizes["run"], int(result.attrs["fire_seed"]))
    untreated = result["burnt_untreated"].to_numpy()
    rows = []
    for label in result["ranking"].to_numpy().tolist():
        for budget in result["budget"].to_numpy():
            for residual in result["residual"].to_numpy():
                chosen = result.sel(ranking=label, budget=budget, residual=residual)
                cut_ha = float(chosen["ha_cut"])
                if np.isnan(cut_ha):
                    continue
                burnt, lost = chosen["burnt"].to_numpy(), chosen["lost"].to_numpy()
                row: dict[str, Any] = {
                    "method": label,
                    "d_f": float(budget),
                    "residual": float(residual),
                    "cells_cut": int(chosen["cells_cut"]),
                    "ha_cut": cut_ha,
                    "R": burnt.mean() / n_burnable,
                }
                rows.append(row | judge(burnt, lost, untreated, treated_ha=cut_ha, cell_area_ha=area, picks=picks))
    table = pd.DataFrame(rows)
    table.attrs.update(n_burnable=n_burnable, cell_area_ha=area)  # for `plot`
    return table
