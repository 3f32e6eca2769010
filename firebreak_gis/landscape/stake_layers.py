"""What a planner adds, as layers: named by the user, laid on the grid of a network.

To add a layer: add a field to `StakesRequest`, how it is read to `StakesRequest.read`, an option of that name to
`cli.stakes_options`, and, if the plan needs the plane as it is, a field to `StakePlanes`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, cast, get_args

import numpy as np

from firebreak_gis.errors import FirebreakError, InputError, ParameterError, raise_together
from firebreak_gis.landscape.alignment import MaskRule
from firebreak_gis.landscape.amounts import ValuesAs, cost_per_hectare, value_at_risk
from firebreak_gis.landscape.existing import existing_breaks
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.planes import ignition_source
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.schema import VEGETATION
from firebreak_gis.stakes import StakePlanes
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid

#: Which cells are kept: all with any part protected or not allowed, or those whose centre is.
ProtectedRule = Literal["every-part", "centre"]
#: How areas are laid on the grid, so that none is cut into and nothing passes a barrier.
MASKS: Mapping[str, MaskRule] = MappingProxyType(
    {
        "barriers": "touched",
        "roads": "touched",
        "rivers": "touched",
        "protected": "touched",
        "allowed": "within",
        "aoi": "within",
    }
)
CENTRES: Mapping[str, MaskRule] = MappingProxyType({"protected": "centre", "allowed": "centre", "aoi": "centre"})


@dataclass(frozen=True)
class ValueLayer:
    """One of several values at risk.

    Parameters
    ----------
    name
        For people: people, houses, timber.
    source
        A raster, polygons or points.
    field
        Column of polygons or points; without it each counts 1.
    weight
        What one unit counts in the sum that is planned for, such as the money that it is worth.
    taken_as
        As `StakesRequest.values_as`.
    """

    name: str
    source: str
    field: str | None = None
    weight: float = 1.0
    taken_as: ValuesAs = "amount"


def value_layer(name: str, text: str) -> ValueLayer:
    """Read "PATH[,field=NAME][,weight=NUMBER][,as=amount|density]".

    Raises
    ------
    ParameterError
        If a word is none of these.

    Examples
    --------
    >>> value_layer("people", "villages.gpkg,field=people,weight=2")
    ValueLayer(name='people', source='villages.gpkg', field='people', weight=2.0, taken_as='amount')
    """
    source, *words = re.split(r",(?=(?:field|weight|as)=)", text)
    given = dict(word.split("=", 1) for word in words)
    try:
        weight = float(given.get("weight", 1.0))
    except ValueError:
        weight = math.nan
    kind = given.get("as", "amount")
    if not source or kind not in get_args(ValuesAs) or not (math.isfinite(weight) and weight >= 0.0):
        raise ParameterError(
            f"--value {name} is {text!r}, expected PATH, perhaps with ,field=NAME ,weight=NUMBER of at least 0 and "
            ",as=amount or ,as=density"
        )
    return ValueLayer(name, source, given.get("field"), weight, cast(ValuesAs, kind))


@dataclass(frozen=True)
class StakesRequest:
    """Rasters on any grid, or vector files in any CRS; None where nothing is given.

    Parameters
    ----------
    cost, cost_field
        Cost of cutting per hectare: a raster, polygons with their column, or a rate by vegetation class.
    cost_default
        Cost per hectare where `cost` tells none; without it nothing is cut there. Alone it is the cost everywhere.
    protected, allowed
        Where nothing may be cut, and outside of which nothing may be cut.
    aoi
        The area that is planned for: nothing is cut outside, but fires burn there too.
    protected_rule
        Whether a cell is kept if any part of it is protected or not allowed, or only if its centre is.
    barriers
        Existing breaks, roads, rivers that stop fire.
    existing
        Breaks that stand already, one by one; they fail as new ones do, and their fuel grows back.
    roads, rivers
        Roads and tracks, and water, beside which breaks are easier to build and to hold, see `landscape.siting`.
    values, values_field
        Values at risk: a raster, or polygons or points with their column.
    values_as
        Whether they are amounts (in each cell of the raster, polygon or point) or so much a hectare.
    value_layers
        More values at risk; the sum of all, by their weights, is what plans are made for.
    """

    cost: str | Mapping[str, float] | None = None
    cost_field: str | None = None
    cost_default: float | None = None
    protected: str | None = None
    allowed: str | None = None
    aoi: str | None = None
    protected_rule: ProtectedRule = "every-part"
    barriers: str | None = None
    existing: str | None = None
    roads: str | None = None
    rivers: str | None = None
    values: str | None = None
    values_field: str | None = None
    values_as: ValuesAs = "amount"
    value_layers: tuple[ValueLayer, ...] = ()

    @property
    def valued(self) -> bool:
        """Whether any values are given."""
        return bool(self.values or self.value_layers)

    @property
    def layers(self) -> dict[str, str]:
        """Names of files, by field."""
        named = {name: getattr(self, name) for name in ("cost", *MASKS, "existing", "values")}
        known = {name: source for name, source in named.items() if isinstance(source, str) and source}
        return known | {f"value {layer.name}": layer.source for layer in self.value_layers}

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of files."""
        return tuple(self.layers.values())

    def read(
        self,
        grid: Grid,
        *,
        fuel: np.ndarray,
        ignitions: Any = None,
        landscape: xr.Dataset | None = None,
        account: Account | None = None,
    ) -> StakePlanes:
        """Lay everything on a grid.

        Parameters
        ----------
        grid
            The grid of the network.
        fuel
            (rows, cols) bool: which cells hold fuel.
        ignitions
            Where fires start; a raster of weights shapes the plan too, points do not.
        landscape
            Needed for costs by vegetation class.
        account
            Gets sentences on what was done.

        Raises
        ------
        ParameterError, InputError
            Naming everything that cannot be read.
        """
        account = Account() if account is None else account
        rules = {**MASKS, **(CENTRES if self.protected_rule == "centre" else {})}
        readers: dict[str, Callable[[], Any]] = {}
        for name, rule in rules.items():
            if source := getattr(self, name):
                readers[name] = partial(
                    mask_plane, source, grid, what=name, rule=rule, solid=name == "barriers", account=account
                )
        if self.existing:
            readers["existing"] = partial(existing_breaks, self.existing, grid, what="existing", account=account)
        if self.cost or self.cost_default is not None:
            readers["cost"] = lambda: self._cost(grid, landscape, account)
        if self.values:
            readers["value"] = lambda: value_at_risk(
                self.values, grid, field=self.values_field, values_as=self.values_as, account=account
            )
        for layer in self.value_layers:
            readers[f"value {layer.name}"] = partial(
                value_at_risk,
                layer.source,
                grid,
                field=layer.field,
                values_as=layer.taken_as,
                account=account,
            )
        if ignitions is not None and not is_vector(ignitions):
            readers["ignition"] = lambda: ignition_source(ignitions, grid, account)
        planes: dict[str, Any] = {}
        problems: list[FirebreakError] = []
        for name, read in readers.items():
            try:
                planes[name] = read()
            except (ParameterError, InputError) as error:
                problems.append(error)
        raise_together(problems)
        if "allowed" in planes:
            planes["protected"] = planes.get("protected", np.False_) | ~planes.pop("allowed")
        if "cost" in planes:
            planes |= _priced(planes["cost"], fuel & ~planes.get("barriers", np.False_), grid, account)
        total, objectives = self._summed(planes)
        if total is not None:
            planes["value"] = total
            _tell_out_of_reach(total, fuel, account)
        known: dict[str, Any] = planes
        return StakePlanes(objectives=objectives, **known)

    def _summed(self, planes: dict[str, np.ndarray]) -> tuple[np.ndarray | None, dict[str, np.ndarray]]:
        """The weighted sum of all values, and each of several by its name; takes the single ones out of `planes`."""
        named = {layer.name: planes.pop(f"value {layer.name}") for layer in self.value_layers}
        total = planes.pop("value", None)
        if total is not None and named:
            named = {"values": total, **named}
        for layer in self.value_layers:
            part = layer.weight * named[layer.name]
            total = part if total is None else total + part
        return total, named

    def _cost(self, grid: Grid, landscape: xr.Dataset | None, account: Account) -> np.ndarray:
        """Cost of cutting each cell, from costs per hectare."""
        if not isinstance(self.cost, Mapping):
            return (
                cost_per_hectare(self.cost, grid, field=self.cost_field, default=self.cost_default, account=account)
                * grid.cell_area_ha
            )
        if landscape is None:
            raise ParameterError("costs by class need the vegetation; use firebreak plan, or give a raster")
        rates = np.zeros(256)
        for code, name in VEGETATION.items():
            rates[code] = self.cost[name] if code else 0.0
        return np.asarray(rates[landscape["vegetation"].to_numpy()] * grid.cell_area_ha)


def _priced(cost: np.ndarray, fuel: np.ndarray, grid: Grid, account: Account) -> dict[str, np.ndarray]:
    """Cost without gaps, and where it is not known: nothing is cut there, since missing is not free."""
    unknown = fuel & np.isnan(cost)
    if not unknown.any():
        return {"cost": np.nan_to_num(cost, nan=0.0)}
    count = int(np.count_nonzero(unknown))
    if count == np.count_nonzero(fuel):
        raise InputError("cost is known on no cell that holds fuel; say what cutting a hectare costs (--cost-default)")
    account.warn(
        f"cost is not known on {count} cells with fuel ({count * grid.cell_area_ha:,.6g} ha), where nothing is cut; "
        "say what cutting a hectare costs there (--cost-default)"
    )
    return {"cost": np.nan_to_num(cost, nan=0.0), "unpriced": unknown}


def _tell_out_of_reach(value: np.ndarray, fuel: np.ndarray, account: Account) -> None:
    """Say how much of the value lies where nothing burns."""
    total, lost = float(value.sum()), float(value[~fuel].sum())
    if total > 0 and lost > 1e-9 * total:
        account.alignment.append(
            f"values: {lost:,.10g} of it ({100 * lost / total:.3g} %) lie on cells without fuel, which do not burn"
        )


def rates_by_class(text: str) -> dict[str, float]:
    """Read costs per hectare by vegetation class, "agricultural=500,shrubs=900,pines=1500".

    Raises
    ------
    ParameterError
        If a word is no rate, or a class has none.
    """
    names = [name for code, name in VEGETATION.items() if code]
    rates: dict[str, float] = {}
    for word in text.split(","):
        name, _, number = word.partition("=")
        try:
            rates[names[names.index(name.strip())]] = float(number)
        except ValueError:
            raise ParameterError(
                f"--cost got {word!r}, expected CLASS=NUMBER with a class of {', '.join(names)}"
            ) from None
    if missing := [name for name in names if name not in rates]:
        raise ParameterError(f"--cost names no rate for {', '.join(missing)}")
    return rates
