"""A plan over years: the schedule of its segments, and what each year's fires take with what stands then."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Budget
from firebreak_gis.construction.years import RETURN, mean_rates, schedule, visits
from firebreak_gis.errors import ParameterError

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.standing import Kept, Standing

#: Hectares and value that the mean fire takes where some of the segments stand, (n,) bool, beside cells of breaks that
#: were there before, (rows, cols) bool, or None.
Losses = Callable[["np.ndarray", "np.ndarray | None"], "tuple[float, float]"]


@dataclass(frozen=True)
class YearsRequest:
    """A plan over years.

    Parameters
    ----------
    years
        Number of years; 1: all is built at once.
    budget_per_year
        For building and upkeep in each year; None: what the whole plan costs, over the years.
    fires_per_year
        Fires that start in the landscape in a year, of those that are simulated; an assumption.
    discount
        Rate a year at which later losses and costs count less.
    return_interval
        Years until treated fuel has grown back, by type of vegetation; None: assumed, or those of the treatments.
    upkeep_cost
        What treating anew costs, as a share of treating first.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = fb.sample_layers()
    >>> asked = YearsRequest(years=3, budget_per_year=fb.Budget.of("100ha"))
    >>> made = fb.plan(fb.read_landscape(**layers, resolution=200.0), budget="6%", n_runs=10, years=asked)
    >>> made.years.table["spent"].round(6).tolist()
    [100.0, 100.0, 100.0]
    """

    years: int = 1
    budget_per_year: Budget | None = None
    fires_per_year: float = 1.0
    discount: float = 0.0
    return_interval: Mapping[str, float] | None = None
    upkeep_cost: float = 1.0

    def require(self) -> None:
        """Refuse what cannot be.

        Raises
        ------
        ParameterError
            Naming the number.
        """
        if self.years == 1 and self.budget_per_year is not None:
            raise ParameterError("a budget a year needs the number of years (--years)")
        for name, value, most in (
            ("fires a year", self.fires_per_year, np.inf),
            ("discount", self.discount, 1.0),
            ("cost of upkeep", self.upkeep_cost, 1.0),
        ):
            if not (np.isfinite(value) and 0.0 <= value <= most):
                raise ParameterError(f"the {name} is {value:g}, expected a number of at least 0, at most {most:g}")
        if self.budget_per_year is not None:
            self.budget_per_year.require()

    @property
    def assumptions(self) -> list[str]:
        """What the numbers of the years rest on, sentences."""
        some = "fire starts" if self.fires_per_year == 1.0 else "fires start"
        told = [
            f"{self.fires_per_year:g} simulated {some} in a year, every year alike, as if nothing had burnt before."
        ]
        if self.return_interval is None:
            each = ", ".join(f"{name} in {years:g}" for name, years in RETURN.items())
            told.append(f"Treated fuel grows back ({each} years, if no treatment tells it), which is assumed.")
        as_much = "as much as" if self.upkeep_cost == 1.0 else f"{100 * self.upkeep_cost:.3g} % of"
        told.append(f"Treating anew costs {as_much} treating first.")
        return told


@dataclass(frozen=True, eq=False)
class Years:
    """A plan over years.

    Parameters
    ----------
    table
        One row a year: `year`, `built_ha` (segments that stand from then on), `standing_ha`, `existing_ha` (of breaks
        that were there before, if there are any), `spent_building`, `spent_upkeep`, `spent`, `budget` (in money, or
        hectares where the budget counts these), `burnt_ha` and `value_lost` (expected, with what stands), `saved_ha`,
        and the last of each of `spent`, `burnt_ha` and `value_lost` discounted to the first year, `_now`.
    columns
        Of each segment: `year`, `year_begun`, `return_years`, `upkeep_year` (cost a year) and `upkeep_years`.
    unit
        Of what is spent.
    kept
        Existing breaks, and which of them are kept up; None where there are none.
    """

    table: pd.DataFrame
    columns: Mapping[str, Any]
    unit: str
    kept: Kept | None = None

    @property
    def unbuilt(self) -> int:
        """Number of segments that are not built within the years."""
        return int((np.asarray(self.columns["year"]) == 0).sum())

    @property
    def told(self) -> str:
        """What is spent, stands and burns, a sentence without its end."""
        last, n = self.table.iloc[-1], len(self.table)
        left = f", {self.unbuilt} {'segment is' if self.unbuilt == 1 else 'segments are'} not built"
        return (
            f"Over {n} years {self.table['spent'].sum():,.4g} {self.unit} are spent, "
            f"{self.table['spent_upkeep'].sum():,.4g} of it on upkeep; {last['standing_ha']:,.4g} ha stand at the end"
            + ("" if self.kept is None else self.kept.told)
            + (left if self.unbuilt else "")
            + f", and {self.table['saved_ha'].sum():,.4g} ha less burn in all "
            + f"({self.table['burnt_ha'].sum():,.4g} burn)"
        )


def over_years(
    request: YearsRequest,
    polygons: gpd.GeoDataFrame,
    vegetation: xr.DataArray,
    network: SpreadNetwork,
    losses: Losses,
    *,
    budget: Budget,
    priced: bool,
    standing: Standing | None = None,
) -> Years:
    """Schedule the segments of a plan, and burn each year's fires with what stands.

    Parameters
    ----------
    request
        The years.
    polygons
        Segments in the order of construction, as `segments_of` returns them, perhaps with treatments.
    vegetation
        (y, x) codes.
    network
        Before cutting.
    losses
        What the mean fire takes with some of the segments.
    budget
        Of the whole plan, whose unit counts where no budget of a year is given.
    priced
        Whether cells or treatments have costs.
    standing
        Breaks that stand already; None for none.
    """
    import pandas as pd

    request.require()
    asked = request.budget_per_year or budget
    money = asked.unit == "cost"
    if money and not priced:
        raise ParameterError(
            "a budget a year in money needs what cutting costs: --cost, --cost-default or --treatments"
        )
    cost, yearly = _costs(request, polygons, vegetation, money=money)
    interval = np.divide(cost * request.upkeep_cost, yearly, out=np.full(cost.size, np.inf), where=yearly > 0)
    per_year = np.inf
    if request.budget_per_year is not None:
        area = network.n_burnable * network.grid.cell_area_ha
        per_year = asked.amount * (area if asked.unit == "share" else 1.0)
    kept = None
    if standing is not None:
        kept = standing.kept_up(
            money=money,
            years=request.years,
            budget=per_year,
            fires=request.fires_per_year,
            intervals=request.return_interval or RETURN,
            upkeep=request.upkeep_cost,
        )
    upkeep = 0.0 if kept is None else kept.upkeep
    if np.isinf(per_year):
        per_year = float(cost.sum()) / request.years + upkeep
    made = schedule(cost, yearly, budget=max(per_year - upkeep, 0.0), years=request.years)
    bare = losses(np.zeros(cost.size, bool), None)
    known: dict[tuple[int, int], tuple[float, float]] = {}
    rows: list[dict[str, float]] = []
    area_of = polygons["area_ha"].to_numpy(float)
    for y in range(1, request.years + 1):
        stands = (made.year > 0) & (made.year <= y)
        state = (int(stands.sum()), 0 if kept is None else int((kept.until >= y).sum()))
        if state not in known:
            known[state] = losses(stands, None if kept is None else kept.mask(y)) if any(state) else bare
        hectares, value = (request.fires_per_year * each for each in known[state])
        rows.append(
            {
                "year": y,
                "built_ha": float(area_of[made.year == y].sum()),
                "standing_ha": float(area_of[stands].sum()),
                **({} if kept is None else {"existing_ha": kept.area_ha(y)}),
                "spent_building": float(made.built[y - 1]),
                "spent_upkeep": float(made.kept[y - 1]) + upkeep,
                "spent": float(made.built[y - 1] + made.kept[y - 1]) + upkeep,
                "budget": per_year,
                "burnt_ha": hectares,
                "value_lost": value,
                "saved_ha": request.fires_per_year * bare[0] - hectares,
            }
        )
    table = pd.DataFrame(rows)
    factor = (1.0 + request.discount) ** -(table["year"].to_numpy() - 1.0)
    for name in ("spent", "burnt_ha", "value_lost"):
        table[f"{name}_now"] = table[name] * factor
    columns = {
        "year": made.year,
        "year_begun": made.begun,
        "return_years": np.where(np.isfinite(interval), interval, np.nan),
        "upkeep_year": yearly,
        "upkeep_years": visits(made.year, interval, request.years),
    }
    return Years(table, columns, "" if money else "ha", kept)


def _costs(
    request: YearsRequest, polygons: gpd.GeoDataFrame, vegetation: xr.DataArray, *, money: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Cost of each segment, and of keeping it up for a year, in money or hectares."""
    rates = mean_rates(polygons, vegetation, request.return_interval or RETURN)
    treated = "treatment_cost" in polygons
    if treated and request.return_interval is None:
        first, again = (polygons[f"treatment_{name}"].to_numpy(float) for name in ("cost", "yearly"))
        rates = np.divide(again, first, out=rates.copy(), where=first > 0)
    name = ("treatment_cost" if treated else "cost") if money else "area_ha"
    cost = polygons[name].to_numpy(float)
    return cost, cost * np.minimum(rates, 1.0) * request.upkeep_cost
