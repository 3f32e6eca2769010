"""What a plan can reach before anything is computed: every conflict in words, and an account of what is possible."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import FirebreakError, ParameterError, raise_together
from firebreak_gis.network import checked_residual

if TYPE_CHECKING:
    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.line_design import Widths
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.stakes import Stakes


@dataclass(frozen=True)
class Feasibility:
    """What was found.

    Parameters
    ----------
    account
        Sentences that say what can be reached, and what the plan will mean.
    warnings
        Sentences on what is possible but hardly meant.
    problems
        What cannot be.
    """

    account: tuple[str, ...]
    warnings: tuple[str, ...]
    problems: tuple[FirebreakError, ...]

    def require(self) -> None:
        """Raise all problems as one error, if there are any."""
        raise_together(self.problems)


def width_in_cells(width: float | None, cell_size: float) -> int:
    """Least number of cells across a break of a width in metres; 1 for None."""
    if width is None or not math.isfinite(width):
        return 1
    # A whole number of cells must not grow by rounding.
    return max(1, math.ceil(width / cell_size - 1e-9))


def feasibility(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    budget: Budget,
    width: float | None = None,
    residual: float = 0.0,
    refine: bool = False,
    line_width: Widths | None = None,
    ignitions: Callable[[], Ignitions] | None = None,
) -> Feasibility:
    """Check what is asked of a plan against the landscape.

    Parameters
    ----------
    network
        The spread network before cutting, existing barriers in it.
    stakes
        Costs, protected cells, values at risk and ignitions.
    budget
        How much may be cut.
    width
        Least width of the breaks [m].
    residual
        Share of its spread probability that a treated cell keeps.
    refine
        Whether the breaks are improved by local search.
    line_width
        Width of breaks that are lines [m]; "cells" or None: they are whole cells.
    ignitions
        Returns where the simulated fires start, or raises what is wrong with that.
    """
    check = _Check(network, stakes)
    check.reach()
    check.afford(budget, lines=line_width not in (None, "cells"))
    check.width(width, residual)
    check.lines(line_width, budget)
    if refine and width_in_cells(width, network.grid.cell_size) > 1:
        check.problems.append(
            ParameterError(
                f"local search (--refine) moves single cells and would not keep a width of {width:g} m; leave one out"
            )
        )
    if ignitions is not None:
        check.ignitions(ignitions)
    return Feasibility(tuple(check.account), tuple(check.warnings), tuple(check.problems))


class _Check:
    """Collects what is found."""

    def __init__(self, network: SpreadNetwork, stakes: Stakes) -> None:
        self.grid, self.stakes = network.grid, stakes
        self.fuel = network.burnable
        self.free = network.burnable & ~stakes.protected
        self.n_fuel, self.n_free = int(self.fuel.sum()), int(self.free.sum())
        self.account: list[str] = []
        self.warnings: list[str] = []
        self.problems: list[FirebreakError] = []

    def reach(self) -> None:
        """What may be cut at all."""
        sentence = f"{self._area(self.n_fuel)} hold fuel"
        if self.n_free < self.n_fuel:
            share = 100.0 * self.n_free / self.n_fuel
            sentence += (
                f"; {self._area(self.n_fuel - self.n_free)} of them may not be cut, so that at most "
                f"{self._area(self.n_free)}, {share:.4g} % of the fuel, can be reached"
            )
        if self.stakes.priced and self.n_free:
            prices = self.stakes.cost[self.free] / self.grid.cell_area_ha
            sentence += (
                f"; cutting all that may be cut costs {self.stakes.cost[self.free].sum():,.6g} "
                f"({prices.min():,.4g} to {prices.max():,.4g} a hectare)"
            )
        self.account.append(sentence)
        if self.n_fuel and not self.n_free:
            self.problems.append(
                ParameterError(
                    "no cell with fuel may be cut: the protected and the allowed area exclude everything; "
                    "protect less or allow more"
                )
            )

    def afford(self, budget: Budget, *, lines: bool = False) -> None:
        """How far the budget goes."""
        try:
            cells = self._bought(budget)
        except ParameterError as error:
            self.problems.append(error)
            return
        if cells == 0 < budget.amount and self.n_free and not lines:
            self.warnings.append(f"a budget of {budget} does not buy a single cell, so nothing is cut")

    def _bought(self, budget: Budget) -> int:
        """Cells that the budget can buy at most."""
        if budget.unit == "cost":
            return self._money(budget)
        cells = budget.cells(n_burnable=self.n_fuel, cell_area_ha=self.grid.cell_area_ha)
        if cells > self.n_free and self.n_free:
            most = f"{self.n_free / self.n_fuel:.4g}" if budget.unit == "share" else f"{self._ha(self.n_free):,.6g} ha"
            raise ParameterError(
                f"a budget of {budget} is {self._area(cells)}, but only {self._area(self.n_free)} can be "
                f"cut; lower the budget to {most} or protect less"
            )
        share = 100.0 * cells / max(self.n_fuel, 1)
        self.account.append(f"the budget is {self._area(cells)}, {share:.4g} % of the fuel")
        return cells

    def _money(self, budget: Budget) -> int:
        if not self.stakes.priced:
            raise ParameterError("a budget in cost needs to know what cutting costs; give the cost (--cost)")
        budget.require()
        prices = np.sort(self.stakes.cost[self.free])
        total, money = float(prices.sum()), budget.amount
        if self.n_free and money > total * (1 + 1e-12):
            raise ParameterError(
                f"a budget of {money:,.6g} (cost) is more than cutting everything that may be cut costs; "
                f"lower it to {total:,.6g} at most"
            )
        most, least = budget.affordable(prices), budget.affordable(prices[::-1])
        mean = money / float(prices.mean()) if total > 0 else self.n_free
        self.account.append(
            f"the budget of {money:,.6g} buys {self._ha(least):,.4g} to {self._ha(most):,.4g} ha, "
            f"about {self._ha(mean):,.4g} ha at the mean cost"
        )
        return most

    def width(self, width: float | None, residual: float) -> None:
        """Whether breaks of that width fit in."""
        try:
            checked_residual(residual)
        except ParameterError as error:
            self.problems.append(error)
            return
        if residual > 0.0:
            self.account.append(
                f"a treated cell keeps {100.0 * residual:.3g} % of its spread probability; "
                "methods that know it choose the width for that"
            )
        if width is None:
            return
        size = self.grid.cell_size
        if not (math.isfinite(width) and width > 0.0):
            self.problems.append(ParameterError(f"width is {width} m, expected a number above 0"))
            return
        cells = width_in_cells(width, size)
        short = min(self.grid.shape) * size
        if cells > min(self.grid.shape):
            self.problems.append(
                ParameterError(f"width is {width:g} m, but the landscape is only {short:g} m across; give less")
            )
            return
        across = "1 cell" if cells == 1 else f"{cells} cells"
        self.account.append(f"breaks are at least {across} ({cells * size:g} m) wide")
        if cells > 1 and residual == 0.0:
            self.warnings.append(
                f"breaks {cells} cells wide are taken as perfect (residual 0), which one cell would be too; the same "
                "budget then encloses less. If width is there because breaks leak, give --residual"
            )

    def lines(self, width: Widths | None, budget: Budget) -> None:
        """Whether breaks can be lines of that width, and how long they get."""
        if width is None or width == "cells":
            return
        try:
            self.grid.require_metres("lines with a width")
        except FirebreakError as error:
            self.problems.append(error)
        if isinstance(width, str):
            self.account.append("breaks are lines of the width that suits the flames; they count by length times width")
            return
        if not (math.isfinite(width) and width > 0.0):
            self.problems.append(ParameterError(f"the width of lines is {width} m, expected a number above 0"))
            return
        hectares = {"share": budget.amount * self._ha(self.n_fuel), "ha": budget.amount}.get(budget.unit)
        told = f"; the budget is {hectares * 10.0 / width:,.4g} km of them" if hectares else ""
        self.account.append(f"breaks are lines {width:g} m wide, which count by length times width{told}")

    def ignitions(self, draw: Callable[[], Ignitions]) -> None:
        """Whether fires can start."""
        try:
            start = draw()
        except FirebreakError as error:
            self.problems.append(error)
            return
        self.account.extend(start.notes)
        cells = start.cells
        inside = int(np.count_nonzero(self.stakes.protected.ravel()[cells]))
        if inside and self.n_free:
            self.account.append(
                f"{100.0 * inside / cells.size:.3g} % of the simulated fires start where nothing may be cut"
            )

    def _ha(self, cells: float) -> float:
        return cells * self.grid.cell_area_ha

    def _area(self, cells: int) -> str:
        return f"{cells} {'cell' if cells == 1 else 'cells'} ({self._ha(cells):,.6g} ha)"
