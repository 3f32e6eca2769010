"""A ranking for one plan: the method is told the budget, the leak, the width and the terrain of the plan."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.breaks import removal_order
from firebreak_gis.errors import ParameterError
from firebreak_gis.planning.refinement import refine as improve
from firebreak_gis.planning.thickening import thickened
from firebreak_gis.progress import part
from firebreak_gis.ranking import rank

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.breaks import Budget
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
    told = plan_params(
        method,
        params or {},
        share=budget.cost_share(network, stakes),
        residual=residual,
        width=width,
        elevation=elevation,
        roads=roads,
    )
    share = 0.5 if refine else 1.0
    priority = _ranked(network, method, stakes, {**told, **(params or {})}, width, seed, part(progress, 0.0, share))
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
        self._network, self._method, self._setting, self._seed = network, method, stakes, seed
        self._params, self._width = dict(params or {}), width
        self._planes = {"elevation": elevation, "roads": roads}
        self._made: dict[tuple[Any, ...], xr.DataArray] = {}

    def __call__(self, budget: float, residual: float, progress: Progress) -> xr.DataArray:
        """Return the priority of the plan; the same object for equal plans."""
        told = plan_params(
            self._method, self._params, share=budget, residual=residual, width=self._width, **self._planes
        )
        key = tuple(sorted((k, v) for k, v in told.items() if k not in self._planes))
        if key not in self._made:
            every = {**told, **self._params}
            self._made[key] = _ranked(
                self._network, self._method, self._setting, every, self._width, self._seed, progress
            )
        return self._made[key]


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
    if width > 1 and not _wide_by_itself(method):
        return priority.copy(data=thickened(removal_order(priority), network, stakes, width))
    return priority


def plan_params(
    method: str,
    given: Mapping[str, Any],
    *,
    share: float,
    residual: float,
    width: int,
    elevation: np.ndarray | None = None,
    roads: np.ndarray | None = None,
) -> dict[str, Any]:
    """Parameters that a plan tells a method which has them; those that are given are left out.

    Raises
    ------
    ParameterError
        If a given width is less than `width`.
    """
    known = {p["name"]: p for p in plugins.describe("ranking", method)["parameters"]}
    told: dict[str, Any] = {"residual": residual, "elevation": elevation, "roads": roads}
    # A method that knows the leak needs the budget only to choose the width for it.
    leak = float(given.get("residual", residual))
    chooses = "residual" not in known or (leak > 0.0 and float(given.get("width", 0)) == 0.0)
    if "budget" in known and chooses:
        told["budget"] = max(share, known["budget"].get("minimum", 0.0))
    if "least_width" in known:
        told["least_width"] = width
    elif _wide_by_itself(method):
        told["width"] = max(width, known["width"]["default"])
    asked = given.get("width")
    if "width" in known and asked is not None and 0 < float(asked) < width:
        raise ParameterError(
            f"{method} is asked for a width of {asked} cells, but the breaks must be at least {width} cells wide; "
            "leave one of the two out"
        )
    return {k: v for k, v in told.items() if k in known and k not in given and v is not None}


def _wide_by_itself(method: str) -> bool:
    """Whether the method makes walls or bands of a width in cells."""
    return any(
        p["name"] in ("width", "least_width") and p.get("units") == "cells"
        for p in plugins.describe("ranking", method)["parameters"]
    )
