"""From a priority raster and a budget to the cells that are cut.

`Budget` is the only place that turns amounts into cells and shares. It lives here, below all that cuts, since the
simulation of a curve and the placement of patterns need it as well as plans do.
"""

from __future__ import annotations

import math
import typing
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.kernels.keys import distinct
from firebreak_gis.rasters.units import read_amount
from firebreak_gis.schema import VARIABLES, annotate

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes

#: What a budget counts: a share of the fuel, hectares, or money.
BudgetUnit = Literal["share", "ha", "cost"]
_COUNTED = {"share": "a share of the fuel", "ha": "hectares", "cost": "money"}
#: Sums of costs may pass a budget by this share, for their rounding.
_ROUNDING = 1.0 + 1e-12
#: Shares of a cell that hectares may lack for it, for their rounding.
_SLACK = 1e-9


@dataclass(frozen=True)
class Budget:
    """How much may be cut.

    An impossible amount is refused where it is turned into cells, so that it can be named with all else that is wrong.

    Parameters
    ----------
    amount
        In the given unit.
    unit
        `"share"`: d_f, a share from 0 to 1 of the cells that hold fuel. `"ha"`: hectares. `"cost"`: money.

    Examples
    --------
    >>> Budget(0.14).cells(n_burnable=1000)
    140
    >>> Budget(1.0, "ha").cells(n_burnable=1000, cell_area_ha=0.0625)
    16
    >>> Budget(5.0, "cost").affordable([2.0, 3.0, 1.0])
    2
    >>> Budget.of("14%"), Budget.of("5 ha"), Budget.of("20000eur")
    (Budget(amount=0.14, unit='share'), Budget(amount=5.0, unit='ha'), Budget(amount=20000.0, unit='cost'))
    """

    amount: float
    unit: BudgetUnit = "share"

    @classmethod
    def of(cls, budget: Amount, unit: BudgetUnit | None = None) -> Budget:
        """A budget as it is, as a text says, or that of a number and its unit.

        Parameters
        ----------
        budget
            A number counts in `unit`. A text may tell its own: "10%", "5 ha", "12 acres", "20000 EUR", "$20 000".
        unit
            What a number counts, by default a share; a budget that tells its own unit must agree.

        Raises
        ------
        ParameterError
            If the text is no budget, or its unit is another one.
        """
        if isinstance(budget, str):
            amount = read_amount(budget)
            if amount is None:
                raise ParameterError(
                    f"budget is {budget!r}, expected a share of the fuel such as 10% or 0.1, an area such as 5ha, or "
                    "money such as 20000eur (a point stands before decimals only)"
                )
            number, word = amount
            found = cls(number, typing.cast(BudgetUnit, word or unit or "share"))
        else:
            found = budget if isinstance(budget, Budget) else cls(budget, unit or "share")
        if unit is not None and found.unit != unit:
            raise ParameterError(
                f"budget is {budget!s}, which counts {_COUNTED[found.unit]}, but its unit is given as {unit}; "
                "leave the unit away, or give a plain number"
            )
        return found

    @classmethod
    def of_cost_share(cls, share: float, stakes: Stakes) -> Budget:
        """The money that is a share of the cost of all fuel."""
        return cls(share * float(stakes.cost.sum()), "cost")

    @classmethod
    def made_for(cls, priority: xr.DataArray) -> Budget | None:
        """The budget that a ranking was made for; None for one that serves any, or that does not say.

        `planning.design.design` records it in the attributes, the raster writer in the tags of the file.
        """
        text = priority.attrs.get("made_for") or priority.attrs.get("provenance", {}).get("made_for")
        if not text:
            return None
        try:
            made = cls.of(str(text))
            made.require()
        except ParameterError:
            return None
        return made

    @property
    def record(self) -> dict[str, str]:
        """The attribute that `made_for` reads."""
        return {"made_for": f"{float(self.amount)!r} {self.unit}"}

    def __str__(self) -> str:
        return f"{self.amount:g} ({self.unit})"

    def require(self) -> None:
        """Refuse what no landscape could make possible.

        Raises
        ------
        ParameterError
            If the unit is unknown, or the amount is no share from 0 to 1, or negative or infinite.
        """
        if self.unit not in ("share", "ha", "cost"):
            raise ParameterError(f"the unit of the budget is {self.unit!r}, expected share, ha or cost")
        number = isinstance(self.amount, (int, float, np.number))
        if self.unit == "share":
            if not (number and 0.0 <= self.amount <= 1.0):
                raise ParameterError(
                    f"budget is {self.amount}, expected a share of the cells that hold fuel, from 0 to 1 (14 % is 0.14 "
                    "or 14%; hectares are 5ha)"
                )
        elif not (number and math.isfinite(self.amount) and self.amount >= 0.0):
            told = f"{self.amount} ha" if self.unit == "ha" else f"{self.amount}"
            raise ParameterError(f"budget is {told}, expected a number of at least 0")

    def cells(self, *, n_burnable: int, cell_area_ha: float = 1.0) -> int:
        """Number of cells that a share or hectares buy: round(d_f N_v), halves up; or those that fit in whole.

        Parameters
        ----------
        n_burnable
            N_v, the cells that hold fuel, those included that may not be cut.
        cell_area_ha
            Area of a cell [ha].

        Raises
        ------
        ParameterError
            As `require`; or for money, whose cells depend on which are cut, see `affordable`.
        """
        self.require()
        if self.unit == "cost":
            raise ParameterError("a budget in cost needs the cost of every cell")
        if self.unit == "share":
            return math.floor(float(self.amount) * n_burnable + 0.5)
        # A whole number of cells must not be lost to rounding.
        return math.floor(float(self.amount) / cell_area_ha + _SLACK)

    def share(self, network: SpreadNetwork) -> float:
        """Share of the cells with fuel that is cut.

        Raises
        ------
        ParameterError
            As `require`; or for money, which buys each ranking another share.
        """
        if self.unit == "cost":
            raise ParameterError(
                f"a budget of {self} buys each ranking another area, and these are compared at the same one; give "
                "shares such as 5% or hectares such as 20ha"
            )
        cells = self.cells(n_burnable=network.n_burnable, cell_area_ha=network.grid.cell_area_ha)
        return float(self.amount) if self.unit == "share" else cells / max(network.n_burnable, 1)

    def affordable(self, costs: Sequence[float] | np.ndarray) -> int:
        """Length of the longest beginning of `costs`, one a cell in the order of cutting, that money pays.

        Raises
        ------
        ParameterError
            As `require`.
        """
        self.require()
        prices = np.asarray(costs, dtype=np.float64)
        wrong = int(np.count_nonzero(~(np.isfinite(prices) & (prices >= 0.0))))
        if wrong:
            raise InputError(
                f"cost is missing, negative or infinite on {wrong} cells that can be cut; give a number of at least 0, "
                "or let these cells not be cut (-inf in the priority)"
            )
        spent = np.cumsum(prices)
        return int(np.searchsorted(spent, self.amount * _ROUNDING, side="right"))

    def pays(self, cost: float) -> bool:
        """Whether money suffices for a cost."""
        return bool(cost <= self.amount * _ROUNDING)

    def cost_share(self, network: SpreadNetwork, stakes: Stakes) -> float:
        """Share of the cost of all fuel that this is about; cells and hectares are taken at the mean cost."""
        if self.unit == "share":
            return float(self.amount)
        total = float(stakes.cost.sum()) if self.unit == "cost" else network.n_burnable * network.grid.cell_area_ha
        return min(1.0, float(self.amount) / total) if total > 0 else 1.0

    def cell_share(self, network: SpreadNetwork, stakes: Stakes) -> float:
        """Share of the cells with fuel that this is about; money is taken at the mean cost."""
        return self.cost_share(network, stakes)


#: What a budget is given as: a number, a text such as "10%", or a budget.
Amount = float | str | Budget


def shares_of(budgets: Iterable[Amount], network: SpreadNetwork) -> list[float]:
    """Shares of the cells with fuel that budgets cut, in their order, see `Budget.of` and `Budget.share`."""
    return [Budget.of(budget).share(network) for budget in budgets]


def require_priority(priority: Any) -> None:
    """Refuse a variable that this package made as something else: any numbers rank cells, and look plausible.

    Raises
    ------
    InputError
        Saying what it is.

    Examples
    --------
    >>> import xarray as xr
    >>> require_priority(  # doctest: +ELLIPSIS
    ...     xr.DataArray([[3.0, 1.0]], dims=("y", "x"), name="elevation")
    ... )
    Traceback (most recent call last):
    firebreak_gis.errors.InputError: the ranking is elevation (terrain elevation), expected priority; if its ...
    """
    name = str(priority.name) if hasattr(priority, "dims") else ""
    if name in VARIABLES and name != "priority":
        raise InputError(
            f"the ranking is {name} ({VARIABLES[name].text}), expected priority; if its numbers are meant, say so: "
            'data.rename("priority")'
        )


def removal_order(priority: np.ndarray | xr.DataArray) -> np.ndarray:
    """Position of every cell in the order of cutting.

    Parameters
    ----------
    priority
        (rows, cols); higher is cut earlier, -inf or NaN is never cut. Ties are cut by row, then column.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int64: 0 for the cell cut first; -1 for cells that are never cut.

    Examples
    --------
    >>> import numpy as np
    >>> removal_order(np.array([[3.0, 7.0], [-np.inf, 3.0]]))
    array([[ 1,  0],
           [-1,  2]])
    """
    values = _values(priority)
    order = _in_order(values)
    position = np.full(values.size, -1, dtype=np.int64)
    position[order] = np.arange(order.size)
    return position.reshape(values.shape)


def can_be_cut(priority: np.ndarray | xr.DataArray) -> np.ndarray:
    """Cells that a ranking may cut, bool: -inf and NaN never are."""
    values = np.asarray(priority, dtype=np.float64)
    return np.asarray(values > -np.inf)


def first_cut(priority: np.ndarray | xr.DataArray, counts: Sequence[int] | np.ndarray) -> np.ndarray:
    """Of rising numbers of cells that are cut the first at which each cell is, without the order of all cells.

    Parameters
    ----------
    priority
        As in `removal_order`, by which the cells are cut.
    counts
        (n,) whole numbers.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int32: index into `counts`, n for cells that are cut at none.

    Examples
    --------
    >>> import numpy as np
    >>> first_cut(np.array([[3.0, 7.0], [-np.inf, 3.0]]), [0, 1, 2])
    array([[2, 1],
           [3, 3]], dtype=int32)
    """
    values = _values(priority)
    free = can_be_cut(values)
    keys = np.where(free, -values, np.inf).ravel()
    numbers = np.asarray(counts, np.int64)
    n = int(np.count_nonzero(free))
    if n == 0 or numbers.size == 0:
        return np.full(values.shape, numbers.size, np.int32)
    last = np.clip(numbers, 1, n) - 1  # place of the last cell that each number cuts
    marks = np.partition(keys, distinct(last))[last]
    marks[numbers < 1] = -np.inf
    out = np.searchsorted(marks, keys, side="left").astype(np.int32)
    least = int(np.count_nonzero(numbers < 1))
    np.maximum(out, least, out=out)
    # Of the cells that are equal to a mark only some may be cut: by row, then column.
    until = np.cumsum(np.bincount(out, minlength=numbers.size + 1))
    equal = np.flatnonzero((keys == np.append(marks, np.nan)[out]) & free.ravel())
    of = out[equal]
    for k in distinct(of):
        own = equal[of == k]
        out[own] = np.searchsorted(numbers, until[k] - own.size + np.arange(own.size), side="right")
    out[~free.ravel()] = numbers.size
    return out.reshape(values.shape)


def _values(priority: np.ndarray | xr.DataArray) -> np.ndarray:
    values = np.asarray(priority, dtype=np.float64)
    if values.ndim != 2:
        raise GridError(f"priority has shape {values.shape}, expected (rows, cols)")
    return values


def select_breaks(
    priority: xr.DataArray | np.ndarray,
    *,
    budget: Amount,
    unit: BudgetUnit | None = None,
    burnable: np.ndarray | xr.DataArray | None = None,
    cost: np.ndarray | xr.DataArray | None = None,
) -> xr.DataArray:
    """Cut the first cells of a ranking, as many as a budget buys.

    Parameters
    ----------
    priority
        (y, x), higher is cut earlier, -inf or NaN is never cut. Ties are cut by row, then column.
    budget
        A number in the given unit, a `Budget`, or a text that tells its unit such as "10%", "5ha" or "20000eur".
    unit
        What a number counts, a share by default. `"share"`: d_f, a share from 0 to 1 of the cells that hold fuel;
        exactly round(d_f N_v) cells are cut.
        `"ha"`: hectares; the cells that fit into them. `"cost"`: in the unit of `cost`; the longest beginning of
        the ranking that costs no more.
    burnable
        (y, x) cells that hold fuel, which make N_v. Default: the cells that can be cut.
    cost
        (y, x) cost of cutting each cell, finite and >= 0 where it can be cut, for the unit `"cost"`.

    Returns
    -------
    xarray.DataArray
        `breaks` (y, x) uint8: 1 where cut; attributes `budget`, `unit` and `cells_cut`.

    Raises
    ------
    ParameterError
        If the budget is impossible, or is more than can be cut.
    GridError
        If `priority`, `burnable` or `cost` have other dimensions or shapes.
    InputError
        If `priority` is another variable of this package, or `cost` is missing, negative or infinite where it counts.

    Notes
    -----
    Memory at the peak: at most 90 B a cell, a network and the priority included.

    Examples
    --------
    >>> import numpy as np
    >>> priority = np.array([[3.0, 7.0], [1.0, 3.0]])
    >>> select_breaks(priority, budget=0.5).to_numpy()
    array([[1, 1],
           [0, 0]], dtype=uint8)
    >>> select_breaks(priority, budget=4.0, unit="cost", cost=np.full((2, 2), 1.3)).attrs["cells_cut"]
    3
    """
    amount = Budget.of(budget, unit)
    require_priority(priority)
    values = _values(priority)
    free = can_be_cut(values)
    grid = Grid.of(priority) if hasattr(priority, "dims") else Grid((free.shape[0], free.shape[1]))
    n_candidates = int(np.count_nonzero(free))
    for name, plane in (("burnable", burnable), ("cost", cost)):
        if plane is not None and np.shape(plane) != free.shape:
            raise GridError(f"{name} has shape {np.shape(plane)}, expected {free.shape}")
    if amount.unit == "cost" and cost is not None:
        count = amount.affordable(np.asarray(cost, dtype=np.float64).ravel()[_in_order(values)])
    else:
        n_burnable = n_candidates if burnable is None else int(np.count_nonzero(np.asarray(burnable)))
        count = amount.cells(n_burnable=n_burnable, cell_area_ha=grid.cell_area_ha)
        if count > n_candidates:
            most = n_candidates / max(n_burnable, 1) if amount.unit == "share" else n_candidates * grid.cell_area_ha
            raise ParameterError(
                f"a budget of {amount} is {count} cells, but only {n_candidates} cells can be cut; "
                f"lower the budget to {most:.4g} or protect less"
            )
    mask = (first_cut(values, [count]) == 0).astype(np.uint8)
    told = {"budget": float(amount.amount), "unit": amount.unit, "cells_cut": count}
    return annotate(grid.dataarray(mask, "breaks")).assign_attrs(told)


def _in_order(values: np.ndarray) -> np.ndarray:
    """Row-major numbers of the cells that can be cut, the first to be cut first."""
    flat = values.ravel()
    candidates = np.flatnonzero(can_be_cut(flat))
    return np.asarray(candidates[np.argsort(-flat[candidates], kind="stable")])
