"""What a planner adds to a spread network: costs, protected cells, values at risk and where fires start."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import FirebreakError, InputError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.schema import Shown

if TYPE_CHECKING:
    from typing import Protocol

    import xarray as xr

    class Existing(Protocol):
        """Breaks that stand, see `landscape.existing`."""

        def mask(self, shape: tuple[int, int]) -> np.ndarray:
            """(rows, cols) bool: the cells of all."""

    Plane = np.ndarray | xr.DataArray


@dataclass(frozen=True, eq=False)
class StakePlanes:
    """What a planner adds, as planes on the grid of one network; None where nothing is given.

    Parameters
    ----------
    barriers
        (rows, cols), above 0 on existing breaks, roads and rivers, see `with_barriers`.
    roads, rivers
        (rows, cols), above 0 on roads and tracks, and on water: where breaks are easier to build and to hold, see
        `landscape.siting`. They hold fuel unless they are barriers too.
    aoi
        (rows, cols), above 0 in the area that is planned for, see `landscape.sited`.
    cost, protected, value, ignition, difficulty
        As in `Stakes`.
    unpriced
        (rows, cols), true where cutting has no known cost, so that nothing is cut.
    existing
        Breaks that stand already, which hold fuel that grows back; designs take them for barriers.
    objectives
        By name, (rows, cols) each: what is at risk, unweighted, of which `value` is the weighted sum.
    """

    barriers: Plane | None = None
    roads: Plane | None = None
    rivers: Plane | None = None
    aoi: Plane | None = None
    cost: Plane | None = None
    protected: Plane | None = None
    value: Plane | None = None
    ignition: Plane | None = None
    difficulty: Plane | None = None
    unpriced: np.ndarray | None = None
    existing: Existing | None = None
    objectives: Mapping[str, Plane] = field(default_factory=dict)

    def followed(self, network: SpreadNetwork) -> np.ndarray | None:
        """(rows, cols) float64, 1 on a road or a barrier, for methods that follow roads; None where none are given."""
        given = [("roads", self.roads), ("barriers", self.barriers)]
        masks = [network.mask(plane, name) for name, plane in given if plane is not None]
        return np.logical_or.reduce(masks).astype(np.float64) if masks else None

    def barred(self, network: SpreadNetwork) -> SpreadNetwork:
        """Put the barriers into a network."""
        return network if self.barriers is None else with_barriers(network, self.barriers)

    def standing(self, network: SpreadNetwork) -> np.ndarray | None:
        """(rows, cols) bool: cells of the existing breaks; None where none are given."""
        return None if self.existing is None else self.existing.mask(network.shape)

    def on(self, network: SpreadNetwork) -> tuple[SpreadNetwork, Stakes]:
        """Put the barriers and the existing breaks into a network, and the rest into its `Stakes`."""
        network = self.barred(network)
        standing = self.standing(network)
        if standing is not None:
            network = with_barriers(network, standing)
        protected = self.protected
        if self.unpriced is not None:
            protected = self.unpriced | (False if protected is None else network.mask(protected, "protected"))
        stakes = Stakes(
            network,
            cost=self.cost,
            protected=protected,
            value=self.value,
            ignition=self.ignition,
            difficulty=self.difficulty,
        )
        return network, stakes


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Stakes(Shown):
    """Costs, protected cells, values at risk and ignitions on the grid of one network.

    Parameters
    ----------
    network
        The network that is planned for; existing barriers are made fuel-free in it first (`with_barriers`).
    cost
        (rows, cols) cost of cutting the cell, any one unit, >= 0. Default: 1 a cell.
    protected
        (rows, cols), above 0 where nothing may be cut. Default: nowhere.
    value
        (rows, cols) value lost when the cell burns, any one unit, >= 0. Default: 1 on fuel.
    ignition
        (rows, cols) how likely a fire starts in the cell, relative to the others, >= 0. Default: 1 on fuel.
    difficulty
        (rows, cols) times that a wall in the cell counts as beside its cost, where it is hard to hold or to build,
        > 0 on fuel, see `landscape.siting`. It shapes walls and is not paid: budgets know the cost alone. Default: 1.

    Attributes
    ----------
    cost, value, ignition, difficulty : numpy.ndarray
        (rows, cols) float64, read-only; 0 where there is no fuel.
    protected : numpy.ndarray
        (rows, cols) bool, read-only.
    priced : bool
        Whether costs were given.

    Raises
    ------
    InputError
        Naming every problem: another grid, negative or infinite numbers, NaN on fuel, nothing of value, nowhere
        to ignite.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> stakes = fb.Stakes(network, cost=np.where(network.burnable, 350.0, 0.0))
    >>> ranked = fb.rank(network, "degree", stakes=stakes)
    >>> fb.select_breaks(ranked, budget="1000 EUR", cost=stakes.cost).attrs["cells_cut"]
    2
    """

    cost: np.ndarray
    protected: np.ndarray
    value: np.ndarray
    ignition: np.ndarray
    difficulty: np.ndarray
    priced: bool

    def facts(self) -> dict[str, object]:
        """What was given, as `repr` and notebooks show it."""
        return {
            "cost": f"{self.cost.sum():,.6g} in all" if self.priced else "not given",
            "protected": f"{np.count_nonzero(self.protected):,} cells",
            "value": f"{self.value.sum():,.6g} in all",
            "ignition": f"{np.count_nonzero(self.ignition):,} cells",
        }

    def __init__(
        self,
        network: SpreadNetwork,
        *,
        cost: Plane | None = None,
        protected: Plane | None = None,
        value: Plane | None = None,
        ignition: Plane | None = None,
        difficulty: Plane | None = None,
    ) -> None:
        problems: list[str] = []
        fuel = network.burnable
        alike = fuel.astype(np.float64)  # one plane for all that is not given
        planes = {
            name: _weights(network, data, name, alike, problems)
            for name, data in (("cost", cost), ("value", value), ("ignition", ignition), ("difficulty", difficulty))
        }
        if not (planes["difficulty"][fuel] > 0.0).all():
            problems.append("difficulty is 0 on cells that hold fuel, expected numbers above 0")
        for name, what in (("value", "nothing can be lost"), ("ignition", "no fire can start")):
            if fuel.any() and not planes[name].any():
                problems.append(f"{name} is zero on every cell that holds fuel, so {what}")
        try:
            kept = np.zeros(network.shape, bool) if protected is None else network.mask(protected, "protected")
        except FirebreakError as error:
            problems.append(str(error))
            kept = np.zeros(network.shape, bool)
        if problems:
            raise InputError("the plan cannot be set up: " + "; ".join(problems))
        object.__setattr__(self, "priced", cost is not None)
        for name, plane in (*planes.items(), ("protected", kept.copy())):
            plane.flags.writeable = False
            object.__setattr__(self, name, plane)

    def with_ignition(self, network: SpreadNetwork, ignition: Plane) -> Stakes:
        """The same stakes on the same network with fires that start elsewhere; priced costs stay so."""
        made = Stakes(
            network,
            cost=self.cost,
            protected=self.protected,
            value=self.value,
            ignition=ignition,
            difficulty=self.difficulty,
        )
        object.__setattr__(made, "priced", self.priced)
        return made


def _weights(
    network: SpreadNetwork, data: Plane | None, name: str, default: np.ndarray, problems: list[str]
) -> np.ndarray:
    """Plane of numbers >= 0, zero off fuel; `default` if none are given. Adds to `problems` what is wrong."""
    if data is None:
        return default
    try:
        return checked_amounts(network, data, name)
    except FirebreakError as error:
        problems.append(str(error))
        return default


def checked_amounts(network: SpreadNetwork, data: Plane, what: str) -> np.ndarray:
    """Return amounts of the cells, such as costs, as (rows, cols) float64 of at least 0; 0 where there is no fuel.

    Raises
    ------
    InputError
        If a number on fuel is missing, negative or infinite, or `data` holds no numbers.
    GridError
        If `data` lies on another grid.
    """
    plane = network.plane(data, what)
    try:
        values = np.where(network.burnable, plane.astype(np.float64), 0.0)
    except (TypeError, ValueError):
        raise InputError(f"{what} holds {plane.dtype} values, expected numbers") from None
    missing = int(np.count_nonzero(np.isnan(values)))
    if missing:
        raise InputError(f"{what} has no data on {missing} cells that hold fuel; give a number there, for example 0")
    if not np.isfinite(values).all() or (values < 0).any():
        raise InputError(f"{what} lies in [{values.min():g}, {values.max():g}], expected finite numbers of at least 0")
    with np.errstate(over="ignore"):
        if not np.isfinite(values.sum()):
            raise InputError(f"{what} goes up to {values.max():g}, its sum is infinite; take a greater unit")
    return values


def with_barriers(network: SpreadNetwork, barriers: Plane) -> SpreadNetwork:
    """Return the network with existing barriers, such as roads and old breaks, as cells without fuel.

    Parameters
    ----------
    network
        The spread network.
    barriers
        (rows, cols), above 0 on a barrier. Moore spread passes a line one cell wide that turns at corners, so
        lines must be rasterised with all the cells that they touch.

    Returns
    -------
    SpreadNetwork
        Its `burnable`, and so N_v, lacks the barriers.
    """
    return network.derived(burnable=network.burnable & ~network.mask(barriers, "barriers"))
