"""A plan: what was made on the way from a landscape to breaks, and what follows from it, made when asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import break_polygons
from firebreak_gis.construction.compartments import compartments_of
from firebreak_gis.construction.lines import line_polygons, line_segments
from firebreak_gis.construction.segments import Segments, segments_of
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.classes import class_shares
from firebreak_gis.evaluation.measures import judge, resamples
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.landscape.sited import Sited
from firebreak_gis.planning.feasibility import Feasibility
from firebreak_gis.planning.goals import goals_table
from firebreak_gis.planning.judging import Judging, headline
from firebreak_gis.planning.request import PlanRequest
from firebreak_gis.planning.years import Losses, Years, over_years
from firebreak_gis.schema import Shown, card
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from firebreak_gis.construction.treating import Treated
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.line_design import LineDesign


@dataclass(frozen=True, repr=False)
class Plan(Shown):
    """A plan of fire breaks and what it saves.

    Parameters
    ----------
    landscape
        `elevation`, `vegetation`, `density`, `burnable` (y, x).
    network
        The spread network before cutting, existing barriers in it.
    stakes
        Costs, protected cells, values at risk and ignitions.
    priority, breaks
        (y, x): the ranking, and 1 where cut.
    before, after
        Burns of the same fires without and with the breaks, as `simulate` returns them.
    evaluation
        R(d_f) of the ranking and the baselines under these fires, as `evaluate` returns it; with a clock at a few
        budgets.
    paper
        The same for fires that end by themselves and perfect breaks.
    judged
        What the fires and the breaks were taken for, and what is assumed.
    request
        What was asked for.
    share
        Share of the cells with fuel that is cut.
    feasibility
        What could be reached.
    sited
        Lines of the ground that the breaks could follow.
    treated
        The segments, where each has a treatment, and what they leave; None where all cells are treated alike.
    lines
        The walls, where breaks are lines; `breaks` are then the cells that they pass.
    objectives
        By name, what each fire loses of single values at risk, without and with the breaks, (n_runs,) each.
    years
        What is built when, and what burns then; None where all is built at once.
    """

    landscape: xr.Dataset
    network: SpreadNetwork
    stakes: Stakes
    priority: xr.DataArray
    breaks: xr.DataArray
    before: xr.Dataset
    after: xr.Dataset
    evaluation: xr.Dataset
    paper: xr.Dataset
    judged: Judging
    request: PlanRequest
    share: float
    feasibility: Feasibility
    sited: Sited
    treated: Treated | None = None
    objectives: Mapping[str, tuple[np.ndarray, np.ndarray]] = field(default_factory=dict)
    lines: LineDesign | None = None
    years: Years | None = None

    def facts(self) -> dict[str, object]:
        """Ranking, cut, saving and grid, as `repr` shows them."""
        area = self.network.grid.cell_area_ha
        cut = self._lines_built.get("ha_cut", int(np.count_nonzero(self.breaks.to_numpy() > 0)) * area)
        before, after = (float(burns["fire_size"].mean()) * area for burns in (self.before, self.after))
        return {
            "ranking": self.request.design.method,
            "cut": f"{cut:,.4g} ha ({100 * cut / max(self.network.n_burnable * area, 1e-9):.3g} % of the fuel)",
            "mean fire": f"{before:,.4g} ha without, {after:,.4g} ha with the breaks",
            "fires": self.before.sizes["run"],
            "grid": self.network.grid.describe(),
        }

    def _repr_html_(self) -> str:
        told = "".join(f"<p>{escape(text)}</p>" for text in (*self.headline, *self.judged.assumptions))
        return card("Plan", self.facts(), told)

    def plot(self) -> Figure:
        """Six panels: the landscape, the burns without and with the breaks, and the curve."""
        from firebreak_gis.report.overview import overview_figure

        return overview_figure(
            self.landscape,
            self.breaks,
            self.before,
            self.after,
            self.evaluation,
            title=self.title,
            budget=float(self.share),
            caption=" ".join(self.judged.assumptions),
            lines=None if self.lines is None else self.walls,
        )

    def explore(self, **options: Any) -> Any:
        """A map to pan and zoom, with layers to switch; needs folium, see `firebreak_gis.explore`."""
        from firebreak_gis.report.exploring import explore_plan

        return explore_plan(self, **options)

    @property
    def title(self) -> str:
        """One line over a picture: ranking, cut, mean fires."""
        summary = self.summary
        return (
            f"Fire breaks by {self.request.design.method}: "
            f"{100 * self.share:.3g} % of the fuel cut ({summary['ha_cut']:,.0f} ha), "
            f"mean fire {summary['fire_ha_without_breaks']:,.4g} "
            f"\N{RIGHTWARDS ARROW} {summary['fire_ha_with_breaks']:,.4g} ha, "
            f"{100 * summary['saved_share']:.3g} % saved"
        )

    @property
    def parameters(self) -> dict[str, Any]:
        """What was asked for, as plain data for an account of the plan."""
        design, spread, fires = self.request.design, self.request.spread, self.judged.fires
        return {
            "budget": design.amount.amount,
            "budget_unit": design.amount.unit,
            "d_f": self.share,
            "method": design.method,
            "method_params": dict(design.method_params),
            "model": spread.model,
            "model_params": dict(spread.model_params),
            "width": design.width,
            **({} if design.line_width is None else {"line_width": design.line_width}),
            "siting": self.sited.strength,
            "residual": fires.residual,
            "timeless": self.request.timeless,
            "duration": None if fires.duration is None else fires.duration.told(),
            "hold": fires.holding.told(),
            "embers": None if fires.embers is None else fires.embers.told(),
            "containment": None if fires.crews is None else fires.crews.told(),
            "refine": design.refine,
            "goal": design.goal,
            "n_runs": fires.n_runs,
            "seed": fires.seed,
        }

    @cached_property
    def laid(self) -> xr.DataArray | LineBreaks | None:
        """The breaks as fires meet them: cells, or lines, or None if lines were asked and none is paid."""
        return self.breaks if self.lines is None else self.lines.breaks(self.request.design.amount)

    @property
    def walls(self) -> gpd.GeoDataFrame:
        """Lines that are built, one row a wall in order; only where breaks are lines."""
        if self.lines is None:
            raise ParameterError("the breaks are cells, not lines; give line_width")
        return self.lines.walls.iloc[: self.lines.bought(self.request.design.amount)]

    def over_years(self, losses: Losses) -> Plan:
        """The same plan with its years, see `years.over_years`; itself where all is built at once."""
        asked = self.request.calendar
        if asked.years == 1:
            return self
        years = over_years(
            asked,
            self._segments.polygons,
            self.landscape["vegetation"],
            self.network,
            losses,
            budget=self.request.design.amount,
            priced=self.stakes.priced or self.treated is not None,
        )
        return replace(self, years=years)

    @property
    def polygons(self) -> gpd.GeoDataFrame:
        """Connected pieces of the breaks, see `break_polygons` and `lines.line_polygons`."""
        if self.lines is not None:
            return line_polygons(self.walls)
        return break_polygons(self.breaks, self.priority)

    @cached_property
    def segments(self) -> Segments:
        """Middle lines and outlines of what is to be built, in order, see `segments.segments`."""
        made = self._segments
        return made if self.years is None else Segments(*(frame.assign(**self.years.columns) for frame in made))

    @cached_property
    def _segments(self) -> Segments:
        if self.treated is not None:
            return self.treated.segments
        if self.lines is not None:
            return line_segments(
                self.network,
                self.walls,
                self.laid if isinstance(self.laid, LineBreaks) else None,
                elevation=self.landscape["elevation"],
                value=self.stakes.value,
                ignition=self.stakes.ignition,
            )
        return segments_of(
            self.network,
            self.breaks,
            priority=self.priority,
            elevation=self.landscape["elevation"],
            cost=self.stakes.cost,
            value=self.stakes.value,
            ignition=self.stakes.ignition,
        )

    @cached_property
    def compartments(self) -> gpd.GeoDataFrame:
        """The fuel between the breaks and what it has to lose, see `compartments.compartments`."""
        laid = np.zeros(self.network.shape, bool) if self.laid is None else self.laid
        return compartments_of(
            self.network, laid, value=self.stakes.value, ignition=self.stakes.ignition, burns=self.after
        )[1]

    @property
    def headline(self) -> list[str]:
        """What the plan saves, as sentences: first under the fires that were asked or assumed, then in the paper's."""
        told = headline(self.summary, self.judged)
        return told if self.years is None else [*told, self.years.told, *self.request.calendar.assumptions]

    @cached_property
    def goals(self) -> pd.DataFrame:
        """What the plan does for its goal and for all others, see `goals.goals_table`."""
        area = self.network.grid.cell_area_ha
        runs = (self.before, self.after)
        losses = {"hectares": tuple(run["fire_size"].to_numpy() * area for run in runs)}
        if "value_lost" in self.before:
            losses["value"] = tuple(run["value_lost"].to_numpy() for run in runs)
        planned = list(losses)[-1]
        every: dict[str, Any] = {**losses, **self.objectives}
        return goals_table(every, planned=planned, goal=self.request.design.goal, seed=self.request.fires.seed)

    @property
    def built(self) -> str:
        """What is built, in words."""
        summary = self.summary
        if self.lines is None:
            return (
                f"{summary['cells_cut']} of {summary['burnable_cells']} cells with fuel cut "
                f"({summary['ha_cut']:,.1f} ha)"
            )
        return (
            f"{summary['line_km']:,.1f} km of lines {self.request.design.line_width:g} m wide "
            f"({summary['ha_cut']:,.1f} ha) in {summary['walls']} walls"
        )

    @property
    def _lines_built(self) -> dict[str, Any]:
        """What lines take, in place of what their cells would."""
        if self.lines is None:
            return {}
        walls = self.walls
        return {
            "ha_cut": round(float(walls["area_ha"].sum()), 4),
            "cost": float(walls["cost"].sum()),
            "line_km": round(float(walls["length_m"].sum()) / 1000.0, 4),
            "walls": len(walls),
        }

    @property
    def fire_sizes(self) -> pd.DataFrame:
        """One row a run: cells and hectares burnt without and with the breaks."""
        import pandas as pd

        area = self.network.grid.cell_area_ha
        sizes = {
            "without_breaks": self.before["fire_size"].to_numpy(),
            "with_breaks": self.after["fire_size"].to_numpy(),
        }
        columns: dict[str, np.ndarray] = {"run": np.arange(self.before.sizes["run"])}
        for name, cells in sizes.items():
            columns[f"cells_{name}"] = cells
            columns[f"ha_{name}"] = np.round(cells * area, 6)
        return pd.DataFrame(columns)

    @property
    def _cost(self) -> float:
        """What the plan costs at once: the treatments chosen, or what cutting its cells does."""
        if self.treated is not None:
            return float(self.treated.segments.polygons["treatment_cost"].sum())
        return float(self.stakes.cost[self.breaks.to_numpy() > 0].sum())

    @property
    def cut_classes(self) -> dict[str, dict[str, dict[str, float]]]:
        """By layer and class: its share of the cut cells, and of all fuel, which is what random cutting takes.

        For `vegetation` and `density`, the classes that hold fuel; fuel that a legend gives effects counts under the
        class nearest to them.
        """
        return class_shares(self.landscape, self.breaks.to_numpy() > 0, self.network.burnable)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Key figures as plain numbers."""
        n_burnable = self.network.n_burnable
        before, after = self.before["fire_size"].to_numpy(), self.after["fire_size"].to_numpy()
        area = self.network.grid.cell_area_ha
        chosen = self.evaluation.sel(ranking=self.request.design.method, budget=self.share)
        cut = self.breaks.to_numpy() > 0
        figures: dict[str, Any] = {
            "burnable_cells": n_burnable,
            "burnable_ha": round(n_burnable * area, 4),
            "cells_cut": int(np.count_nonzero(cut)),
            "ha_cut": round(int(np.count_nonzero(cut)) * area, 4),
            "cost": self._cost,
            **self._lines_built,
            "burnt_share_without_breaks": float(before.mean() / n_burnable),
            "burnt_share_with_breaks": float(after.mean() / n_burnable),
            "burnt_share_with_breaks_p90": float(np.percentile(after, 90) / n_burnable),
            "burnt_share_with_breaks_max": float(after.max() / n_burnable),
            "saved_share": float(1.0 - after.mean() / before.mean()) if before.any() else 0.0,
            "fire_ha_without_breaks": float(before.mean() * area),
            "fire_ha_with_breaks": float(after.mean() * area),
        }
        endless = self.paper["mean"].sel(ranking=self.request.design.method)
        figures["timeless"] = {
            "burnt_share_without_breaks": float(endless.sel(budget=0.0)),
            "burnt_share_with_breaks": float(endless.sel(budget=self.share)),
        }
        if "design" in self.priority.attrs:
            figures["design"] = self.priority.attrs["design"]
        figures["cut_classes"] = self.cut_classes
        figures["beside_lines"] = {
            "strength": self.sited.strength,
            "breaks": self.sited.shares(cut),
            "fuel": self.sited.shares(self.network.burnable),
        }
        lost = self.after["value_lost"] if "value_lost" in self.after else self.after["fire_size"]
        figures["judged"] = judge(
            after,
            lost.to_numpy(),
            before,
            treated_ha=figures["ha_cut"],
            cell_area_ha=area,
            picks=resamples(after.size, self.request.fires.seed),
        )
        if self.years is not None:
            figures["years"] = self.years.table.replace({np.nan: None}).to_dict("records")
        figures["goals"] = self.goals.replace({np.nan: None}).to_dict("records")
        if self.request.design.method != "random":
            figures["p_value_against_random"] = float(chosen["p_value"])
        if "value_lost" in self.before:
            figures["value_lost_without_breaks"] = float(self.before["value_lost"].mean())
            figures["value_lost_with_breaks"] = float(self.after["value_lost"].mean())
        return figures
