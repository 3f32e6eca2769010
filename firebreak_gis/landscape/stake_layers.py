"""What a planner adds, as layers: named by the user, laid on the grid of a network.

To add a layer: add a field to `StakesRequest`, how it is read to `StakesRequest.read`, an option of that name to
`cli.stakes`, and, if the plan needs the plane as it is, a field to `StakePlanes`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import FirebreakError, InputError, ParameterError, raise_together
from firebreak_gis.landscape.planes import mask_plane, value_plane
from firebreak_gis.schema import VEGETATION
from firebreak_gis.stakes import StakePlanes
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid


@dataclass(frozen=True)
class StakesRequest:
    """Rasters on any grid, or vector files in any CRS; None where nothing is given.

    Parameters
    ----------
    cost, cost_field
        Cost of cutting per hectare: a raster, polygons with their column, or a rate by vegetation class.
    protected, allowed
        Where nothing may be cut, and outside of which nothing may be cut.
    barriers
        Existing breaks, roads, rivers.
    values, values_field
        Value at risk per cell: a raster, or polygons with their column.
    """

    cost: str | Mapping[str, float] | None = None
    cost_field: str | None = None
    protected: str | None = None
    allowed: str | None = None
    barriers: str | None = None
    values: str | None = None
    values_field: str | None = None

    @property
    def layers(self) -> dict[str, str]:
        """Names of files, by field."""
        named = {name: getattr(self, name) for name in ("cost", "protected", "allowed", "barriers", "values")}
        return {name: source for name, source in named.items() if isinstance(source, str) and source}

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of files."""
        return tuple(self.layers.values())

    def read(self, grid: Grid, *, ignitions: Any = None, landscape: xr.Dataset | None = None) -> StakePlanes:
        """Lay everything on a grid.

        Parameters
        ----------
        grid
            The grid of the network.
        ignitions
            Where fires start; a raster of weights shapes the plan too, points do not.
        landscape
            Needed for costs by vegetation class.

        Raises
        ------
        ParameterError, InputError
            Naming everything that cannot be read.
        """
        readers: dict[str, Callable[[], np.ndarray]] = {}
        for name in ("barriers", "protected", "allowed"):
            if source := getattr(self, name):
                readers[name] = partial(mask_plane, source, grid, what=name)
        if self.cost:
            readers["cost"] = lambda: self._cost(grid, landscape)
        if self.values:
            readers["value"] = lambda: value_plane(self.values, grid, what="values", field=self.values_field)
        if ignitions is not None and not is_vector(ignitions):
            readers["ignition"] = lambda: value_plane(ignitions, grid, what="ignitions")
        planes: dict[str, np.ndarray] = {}
        problems: list[FirebreakError] = []
        for name, read in readers.items():
            try:
                planes[name] = read()
            except (ParameterError, InputError) as error:
                problems.append(error)
        raise_together(problems)
        if "allowed" in planes:
            planes["protected"] = planes.get("protected", np.False_) | ~planes.pop("allowed")
        return replace(StakePlanes(), **planes)

    def _cost(self, grid: Grid, landscape: xr.Dataset | None) -> np.ndarray:
        """Cost of cutting each cell, from costs per hectare."""
        if not isinstance(self.cost, Mapping):
            return value_plane(self.cost, grid, what="cost", field=self.cost_field) * grid.cell_area_ha
        if landscape is None:
            raise ParameterError("costs by class need the vegetation; use firebreak plan, or give a raster")
        rates = np.zeros(256)
        for code, name in VEGETATION.items():
            rates[code] = self.cost[name] if code else 0.0
        return np.asarray(rates[landscape["vegetation"].to_numpy()] * grid.cell_area_ha)


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
