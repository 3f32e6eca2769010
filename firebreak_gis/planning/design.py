"""A ranking for one plan: the method is told the budget, the leak, the width and the terrain of the plan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.breaks import Budget, removal_order
from firebreak_gis.planning.refinement import refine as improve
from firebreak_gis.planning.thickening import thickened
from firebreak_gis.progress import part
from firebreak_gis.ranking import rank

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes


def design(
    network: SpreadNetwork,
    method: str,
    *,
    stakes: Stakes,
    budget: Budget,
    residual: float = 0.0,
    width: int = 1,
    params: Mapping[str, Any] | None = None,
    elevation: np.ndarray | None = None,
    roads: np.ndarray | None = None,
    refine: bool = False,
    seed: int = 0,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Rank the cells for a plan of one budget, leak and width.

    Parameters
    ----------
    network, method, stakes, seed, progress
        As in `ranking.rank`.
    budget
        Of the plan.
    residual
        Share of its spread probability that a treated cell keeps.
    width
        Least width of the breaks, cells. A method that makes walls or bands is asked for it; under any other each
        cell brings the square around it along, see `placement.thickening`.
    params
        Parameters of the method; they win over what the plan tells.
    elevation, roads
        (rows, cols), for methods that follow ridges and roads.
    refine
        Whether the plan is improved by local search, see `placement.refinement.refine`; then the ranking is good for
        this budget only, and a width is not kept.

    Returns
    -------
    xarray.DataArray
        `priority` (y, x) float64, as `ranking.rank` returns it.

    Raises
    ------
    ParameterError
        As `ranking.rank`, or if the parameters ask for less than `width`.
    """
    known = facts(network, stakes, budget, residual=residual, width=width, elevation=elevation, roads=roads)
    every = {**plugins.told(plugins.load("ranking", method), known, params or {}), **(params or {})}
    share = 0.5 if refine else 1.0
    priority = _ranked(network, method, stakes, every, width, seed, part(progress, 0.0, share))
    if refine:
        better = improve(
            network,
            stakes,
            priority,
            budget=budget,
            residual=residual,
            seed=seed,
            progress=part(progress, share, 1.0, "local search: "),
        )
        return priority.copy(data=np.where(np.isneginf(priority), -np.inf, better))
    return priority


class Designs:
    """The plans of one method for any budget (a share) and residual; equal ones are made once.

    Parameters
    ----------
    network, method, stakes, width, params, elevation, roads, seed
        As in `design`.
    """

    def __init__(
        self,
        network: SpreadNetwork,
        method: str,
        *,
        stakes: Stakes,
        width: int = 1,
        params: Mapping[str, Any] | None = None,
        elevation: np.ndarray | None = None,
        roads: np.ndarray | None = None,
        seed: int = 0,
    ) -> None:
        self._network, self._method, self._stakes, self._seed = network, method, stakes, seed
        self._params, self._width = dict(params or {}), width
        self._planes = {"elevation": elevation, "roads": roads}
        self._made: dict[tuple[Any, ...], xr.DataArray] = {}

    def __call__(self, budget: float, residual: float, progress: Progress) -> xr.DataArray:
        """Return the priority of the plan; the same object for equal plans."""
        module = plugins.load("ranking", self._method)
        known = facts(self._network, self._stakes, Budget(budget), residual=residual, width=self._width, **self._planes)
        every = {**plugins.told(module, known, self._params), **self._params}
        counting = plugins.effective(module, plugins.build_params(module, every))
        # Planes are the same for all plans.
        key = tuple(getattr(counting, f.name) for f in fields(counting) if not f.metadata["raster"])
        if key not in self._made:
            self._made[key] = _ranked(
                self._network, self._method, self._stakes, every, self._width, self._seed, progress
            )
        return self._made[key]


def facts(
    network: SpreadNetwork,
    stakes: Stakes,
    budget: Budget,
    *,
    residual: float = 0.0,
    width: int = 1,
    elevation: np.ndarray | None = None,
    roads: np.ndarray | None = None,
) -> dict[str, Any]:
    """What a plan tells its method, by the names of `plugins.FACTS`."""
    return {
        "cost_share": budget.cost_share(network, stakes),
        "cell_share": budget.cell_share(network, stakes),
        "residual": residual,
        "least_width": width,
        "elevation": elevation,
        "roads": roads,
    }


def _ranked(
    network: SpreadNetwork,
    method: str,
    stakes: Stakes,
    params: Mapping[str, Any],
    width: int,
    seed: int,
    progress: Progress | None,
) -> xr.DataArray:
    priority = rank(network, method, stakes=stakes, seed=seed, progress=progress, **params)
    if width > 1 and not plugins.asks_for(plugins.load("ranking", method), "least_width"):
        return priority.copy(data=thickened(removal_order(priority), network, stakes, width))
    return priority
