"""Breaks that stand already: what each is worth beside a plan, and over years, which are kept up and which are dropped.

A break is worth what more burns in the mean fire if it alone is given up, all others and the new ones standing. It is
kept up if that saves more hectares a year than must be treated anew, and dropped else, or if a year does not afford
its upkeep; those that save most for it are kept first. What is dropped has grown back after its return interval.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.construction.years import upkeep_rates, visits

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.existing import Existing


@dataclass(frozen=True, eq=False)
class Standing:
    """Existing breaks in a plan.

    Parameters
    ----------
    breaks
        What stands.
    grid
        The grid of the plan.
    worth_ha
        (n,) hectares that more burn in the mean fire without each.
    codes
        (rows, cols) vegetation.
    price
        (rows, cols) cost of treating a cell; None where it is not known.
    """

    breaks: Existing
    grid: Grid
    worth_ha: np.ndarray
    codes: np.ndarray
    price: np.ndarray | None

    def kept_up(
        self, *, years: int, budget: float, money: bool, fires: float, intervals: Mapping[str, float], upkeep: float
    ) -> Kept:
        """Decide which are kept up.

        Parameters
        ----------
        years
            Number of years.
        budget
            What a year affords; infinite if it is what the work costs.
        money
            Whether it counts money, or hectares.
        fires
            Fires that start in a year.
        intervals
            Years until treated fuel has grown back, by type.
        upkeep
            What treating anew costs, as a share of treating first.
        """
        rates = upkeep_rates(self.codes, intervals).ravel()
        area = self.grid.cell_area_ha
        price = self.price.ravel() if money and self.price is not None else np.full(rates.size, area)
        cells = self.breaks.cells
        again = np.array([float(rates[own].sum()) * area for own in cells])
        yearly = np.array([float((rates[own] * price[own]).sum()) * upkeep for own in cells])
        fuel = np.array([int(np.count_nonzero(rates[own])) for own in cells])
        interval = np.divide(fuel * area, again, out=np.full(len(cells), np.inf), where=again > 0)
        saved = fires * self.worth_ha
        kept, spent = np.zeros(len(cells), bool), 0.0
        for k in np.argsort(-saved / np.maximum(yearly, 1e-300), kind="stable"):
            if saved[k] >= again[k] and spent + yearly[k] <= budget * (1 + 1e-12):
                kept[k] = True
                spent += float(yearly[k])
        last = np.where(kept, years, np.minimum(np.floor(interval), years)).astype(np.int64)
        comes = visits(np.where(kept, 1, 0), interval, years)
        frame = self.table.assign(
            upkeep_ha=again,
            upkeep_year=yearly,
            return_years=np.where(np.isfinite(interval), interval, np.nan),
            keep=np.where(kept, "yes", "no"),
            stands_until=last,
            upkeep_years=comes,
        )
        return Kept(frame, cells, self.grid, last, spent)

    @property
    def table(self) -> gpd.GeoDataFrame:
        """`number`, `length_m`, `cells`, `area_ha`, `worth_ha` of each break, and its geometry."""
        count = np.array([own.size for own in self.breaks.cells], np.int64)
        return self.breaks.frame[["geometry"]].assign(
            number=np.arange(1, count.size + 1),
            length_m=self.breaks.lengths,
            cells=count,
            area_ha=count * self.grid.cell_area_ha,
            worth_ha=self.worth_ha,
        )


@dataclass(frozen=True, eq=False)
class Kept:
    """Existing breaks over years.

    Parameters
    ----------
    table
        As `Standing.table`, and `upkeep_ha`, `upkeep_year` (cost a year), `return_years`, `keep` (yes, no),
        `stands_until` (the last year) and `upkeep_years`.
    cells
        Of each.
    grid
        Of the plan.
    until
        (n,) last year in which each stands.
    upkeep
        Cost a year of those that are kept.
    """

    table: gpd.GeoDataFrame
    cells: list[np.ndarray]
    grid: Grid
    until: np.ndarray
    upkeep: float

    @property
    def told(self) -> str:
        """How many are kept up, and how many dropped, to go on a sentence."""
        n = int((self.table["keep"] == "yes").sum())
        kept = f"{n} {'is' if n == 1 else 'are'} kept up"
        return f"; of {len(self.cells)} existing breaks {kept}, which takes {self.upkeep:,.4g} a year"

    def area_ha(self, year: int) -> float:
        """Area of those that stand in a year."""
        return float(np.count_nonzero(self.mask(year))) * self.grid.cell_area_ha

    def mask(self, year: int) -> np.ndarray:
        """(rows, cols) bool: what stands in a year."""
        plane = np.zeros(self.grid.shape, bool)
        for own, last in zip(self.cells, self.until.tolist(), strict=True):
            if year <= last:
                plane.ravel()[own] = True
        return plane
