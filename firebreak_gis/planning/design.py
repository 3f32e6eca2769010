"""A ranking for one plan: the method is told the budget, the leak, the width and the terrain of the plan.

Plans, comparisons, evaluations and the command `rank` all come through here, so that they agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins, ranking
from firebreak_gis.breaks import Amount, Budget, removal_order, select_breaks
from firebreak_gis.placement.dissection import lines_first
from firebreak_gis.placement.exchanging import exchange
from firebreak_gis.planning.refinement import refine as improve
from firebreak_gis.planning.thickening import thickened
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.trial import Trial

    Plane = np.ndarray | xr.DataArray


def rank(
    network: SpreadNetwork,
    method: str = "dissection",
    *,
    budget: Amount = 0.1,
    residual: float = 0.0,
    stakes: Stakes | None = None,
    elevation: Plane | None = None,
    roads: Plane | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    **params: Any,
) -> xr.DataArray:
    """Rank the cells of a network by the order in which they should be cut, as `plan` does.

    Parameters
    ----------
    network
        The spread network.
    method
        Name of a ranking (`firebreak methods` lists them).
    budget
        What the ranking is for: a share of the cells that hold fuel, a text such as "5ha", or a `breaks.Budget`.
        Patterns are laid for it; most methods give one ranking for all budgets.
    residual
        Share of its spread probability that a treated cell keeps; 0 is a perfect break.
    stakes
        Costs, protected cells, values at risk and ignitions; default: every cell alike, nothing protected.
    elevation, roads
        (y, x) terrain in metres and above 0 on roads, for methods that follow ridges and roads.
    seed
        Seed of methods that draw.
    progress
        Callback (share done, message); raise `Cancelled` in it to stop.
    **params
        Parameters of the method, for example ``beta=0.5``; they win over what the plan would tell it.

    Returns
    -------
    xarray.DataArray
        `priority` (y, x) float64, higher is cut earlier, -inf where there is no fuel or nothing may be cut. Where
        another budget would have given another ranking, the attribute `made_for` tells the budget.

    Raises
    ------
    ParameterError
        If the method or a parameter is unknown or out of range, or the budget is impossible.
    GridError
        If the stakes were made for a network of another shape.

    Notes
    -----
    Memory at the peak, beside the network: `plugins.memory_of("ranking", method)`; the text of each method says more.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> fb.rank(network, "bonacich", beta=0.2).attrs["method"]
    'bonacich'
    >>> fb.rank(network, "stripes", budget=0.2).attrs["made_for"]
    '0.2 share'
    """
    amount = Budget.of(budget)
    amount.require()
    return design(
        network,
        method,
        stakes=stakes or Stakes(network),
        budget=amount,
        residual=residual,
        params=params,
        elevation=elevation,
        roads=roads,
        seed=seed,
        progress=progress,
    )


def design(
    network: SpreadNetwork,
    method: str,
    *,
    stakes: Stakes,
    budget: Budget,
    residual: float = 0.0,
    width: int = 1,
    params: Mapping[str, Any] | None = None,
    elevation: Plane | None = None,
    roads: Plane | None = None,
    trial: Trial | None = None,
    refine: bool = False,
    seed: int = 0,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Rank the cells for a plan of one budget, leak and width.

    Parameters
    ----------
    network, method, stakes, budget, residual, elevation, roads, seed, progress
        As in `rank`.
    width
        Least width of the breaks, cells. A method that makes walls or bands is asked for it; under any other each
        cell brings the square around it along, see `planning.thickening`.
    params
        Parameters of the method; they win over what the plan tells.
    trial
        Fires with a clock, of the kind that will judge the plan, on which methods may try designs; None: no clock.
    refine
        Whether the plan is improved by local search; then the ranking is good for this budget only. Without a clock
        cells are moved (`planning.refinement.refine`), and a width is not kept; with one parts of walls are
        (`placement.exchanging.exchange`).

    Returns
    -------
    xarray.DataArray
        `priority`, as `rank` returns it.

    Raises
    ------
    ParameterError
        As `rank`, or if the parameters ask for less than `width`.
    """
    designs = Designs(
        network,
        method,
        stakes=stakes,
        width=width,
        params=params,
        elevation=elevation,
        roads=roads,
        trial=trial,
        seed=seed,
    )
    if not refine:
        return designs(budget, residual, progress or silent)
    priority = designs(budget, residual, part(progress, 0.0, 0.5))
    step = part(progress, 0.5, 1.0, "local search: ")
    if trial is None:
        better = improve(network, stakes, priority, budget=budget, residual=residual, seed=seed, progress=step)
    else:
        better = _exchanged(network, stakes, priority, budget, trial.under(residual), step)
    return priority.copy(data=np.where(np.isneginf(priority), -np.inf, better)).assign_attrs(budget.record)


def _exchanged(
    network: SpreadNetwork, stakes: Stakes, priority: xr.DataArray, budget: Budget, trial: Trial, progress: Progress
) -> np.ndarray:
    """The ranking that cuts first what `placement.exchanging` finds, and else as it was."""
    plane = priority.to_numpy()
    before = select_breaks(priority, budget=budget, burnable=network.burnable, cost=stakes.cost).to_numpy() > 0
    price = stakes.cost if budget.unit == "cost" else network.burnable.astype(np.float64)
    money = budget.amount if budget.unit == "cost" else float(np.count_nonzero(before))
    cut = exchange(network, stakes, trial, plane, price=price, money=money, progress=progress)
    if cut is None:
        return plane
    cells = np.flatnonzero(cut)
    return lines_first([cells[np.argsort(-plane.ravel()[cells], kind="stable")]], stakes, plane)


class Designs:
    """The plans of one method for any budget and residual; equal ones are made once.

    Parameters
    ----------
    network, method, stakes, width, params, elevation, roads, trial, seed
        As in `design`.
    keep
        How many different plans are remembered, the last ones; None: all.
    """

    def __init__(
        self,
        network: SpreadNetwork,
        method: str,
        *,
        stakes: Stakes,
        width: int = 1,
        params: Mapping[str, Any] | None = None,
        elevation: Plane | None = None,
        roads: Plane | None = None,
        trial: Trial | None = None,
        seed: int = 0,
        keep: int | None = None,
    ) -> None:
        self._network, self._stakes = network, stakes
        self._module = plugins.load("ranking", method)
        self._rank = ranking.rankings(network, method, stakes=stakes, seed=seed)
        self._params, self._width, self._keep = dict(params or {}), width, keep
        self._planes = {"elevation": elevation, "roads": roads}
        self._trial = trial
        self._made: dict[tuple[Any, ...], xr.DataArray] = {}

    def __call__(self, budget: float | Budget, residual: float, progress: Progress) -> xr.DataArray:
        """Return the priority of the plan; the same object for equal plans."""
        amount = Budget.of(budget)
        key = self._settled(amount, residual)
        if key not in self._made:
            self._made[key] = self._make(amount, residual, progress)
            for old in list(self._made)[: -self._keep] if self._keep else ():
                del self._made[old]
        return self._made[key]

    def distinct(self, budgets: Iterable[float], residuals: Iterable[float] = (0.0,)) -> int:
        """How many different plans there are for these budgets and residuals."""
        leaks = list(residuals)
        return len({self._settled(Budget(budget), leak) for budget in budgets for leak in leaks})

    def facts(self, budget: Budget, residual: float) -> dict[str, Any]:
        """What the plan knows, by the names of `plugins.FACTS`."""
        return {
            "cost_share": budget.cost_share(self._network, self._stakes),
            "cell_share": budget.cell_share(self._network, self._stakes),
            "residual": residual,
            "least_width": self._width,
            **self._planes,
        }

    def _every(self, budget: Budget, residual: float) -> dict[str, Any]:
        """All parameters of the method, those told and those given."""
        return {**plugins.told(self._module, self.facts(budget, residual), self._params), **self._params}

    def _settled(self, budget: Budget, residual: float) -> tuple[Any, ...]:
        """Equal for plans that are equal; planes are the same for all."""
        params = plugins.build_params(self._module, self._every(budget, residual))
        if self._trial is not None and plugins.uses_trial(self._module, params):
            return (residual, *self._plain(params))
        return self._plain(plugins.effective(self._module, params))

    def _plain(self, params: Any) -> tuple[Any, ...]:
        return tuple(getattr(params, f.name) for f in fields(params) if not f.metadata["raster"])

    def _make(self, budget: Budget, residual: float, progress: Progress) -> xr.DataArray:
        trial = None if self._trial is None else self._trial.under(residual)
        priority = self._rank(self._every(budget, residual), progress, trial)
        if self._width > 1 and not plugins.asks_for(self._module, "least_width"):
            wide = thickened(removal_order(priority), self._network, self._stakes, self._width)
            priority = priority.copy(data=wide)
        other = Budget(0.0 if budget.cost_share(self._network, self._stakes) > 0.5 else 1.0)
        if self._settled(other, residual) != self._settled(budget, residual):
            priority = priority.assign_attrs(budget.record)
        return priority
