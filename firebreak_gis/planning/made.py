"""A plan: what was made on the way from a landscape to breaks, and what follows from it, made when asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.compartments import compartments_of
from firebreak_gis.construction.segments import Segments
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.classes import class_shares
from firebreak_gis.evaluation.measures import judge, resamples
from firebreak_gis.landscape.existing import Existing
from firebreak_gis.landscape.sited import Sited
from firebreak_gis.planning.burning import Burnt, fires_of
from firebreak_gis.planning.designs import Design
from firebreak_gis.planning.feasibility import Feasibility
from firebreak_gis.planning.goals import goals_table
from firebreak_gis.planning.judging import Judging, headline
from firebreak_gis.planning.request import PlanRequest
from firebreak_gis.planning.standing import Standing
from firebreak_gis.planning.years import Years, over_years
from firebreak_gis.progress import Progress, silent
from firebreak_gis.schema import Shown, card
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from firebreak_gis.network import SpreadNetwork


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
    design
        The breaks, see `designs.Design`.
    before, after, objectives, paper, evaluation
        What the fires take, see `burning.Burnt`.
    judged
        What the fires and the breaks were taken for, and what is assumed.
    request
        What was asked for.
    feasibility
        What could be reached.
    sited
        Lines of the ground that the breaks could follow.
    years
        What is built when, and what burns then; None where all is built at once.
    """

    landscape: xr.Dataset
    network: SpreadNetwork
    stakes: Stakes
    design: Design
    before: xr.Dataset
    after: xr.Dataset
    objectives: Mapping[str, tuple[np.ndarray, np.ndarray]]
    paper: xr.Dataset
    evaluation: xr.Dataset
    judged: Judging
    request: PlanRequest
    feasibility: Feasibility
    sited: Sited
    years: Years | None = None

    @classmethod
    def of(cls, design: Design, judged: Judging, burnt: Burnt) -> Plan:
        """The plan of a design, judged by what its fires took."""
        setting = design.setting
        return cls(
            setting.landscape,
            setting.network,
            setting.stakes,
            design,
            burnt.before,
            burnt.after,
            burnt.objectives,
            burnt.paper,
            burnt.evaluation,
            judged,
            setting.request,
            setting.found,
            setting.sited,
        )

    @property
    def priority(self) -> xr.DataArray:
        """(y, x): the ranking."""
        return self.design.priority

    @property
    def breaks(self) -> xr.DataArray:
        """(y, x) uint8: 1 where cut, or passed by a line."""
        return self.design.breaks

    @property
    def share(self) -> float:
        """Share of the fuel that is cut."""
        return self.design.share

    def facts(self) -> dict[str, object]:
        """Ranking, cut, saving and grid, as `repr` shows them."""
        area, cut = self.network.grid.cell_area_ha, self._figures["ha_cut"]
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

        existing = self.design.setting.planes.existing  # not with their worth, which takes fires
        return overview_figure(
            self.landscape,
            self.breaks,
            self.before,
            self.after,
            self.evaluation,
            title=self.title,
            budget=float(self.share),
            caption=" ".join(self.judged.assumptions),
            lines=self.design.walls,
            existing=existing.frame if isinstance(existing, Existing) else None,
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
            + (" if all is built" if self.years is not None and self.years.unbuilt else "")
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
            **self.design.parameters,
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

    @property
    def walls(self) -> gpd.GeoDataFrame:
        """Lines that are built, one row a wall in order; only where breaks are lines."""
        walls = self.design.walls
        if walls is None:
            raise ParameterError("the breaks are cells, not lines; give line_width")
        return walls

    def over_years(self, *, progress: Progress = silent) -> Plan:
        """The same plan with its years, see `years.over_years`; itself where all is built at once."""
        asked = self.request.calendar
        if asked.years == 1:
            return self
        setting = self.design.setting

        def taken(stands: np.ndarray, standing: np.ndarray | None) -> tuple[float, float]:
            run = fires_of(replace(setting, standing=standing), self.judged)(
                self.design.part(stands), setting.value, progress
            )
            lost = np.nan if setting.value is None else float(run["value_lost"].mean())
            return float(run["fire_size"].mean()) * self.network.grid.cell_area_ha, lost

        years = over_years(
            asked,
            self._segments.polygons,
            self.landscape["vegetation"],
            self.network,
            taken,
            budget=self.request.design.amount,
            priced=self.design.priced,
            standing=self.standing,
        )
        return replace(self, years=years)

    @cached_property
    def standing(self) -> Standing | None:
        """The existing breaks, and what each is worth beside the plan; None where there are none."""
        setting = self.design.setting
        existing = setting.planes.existing
        if not isinstance(existing, Existing):
            return None
        area = self.network.grid.cell_area_ha

        def burnt(cells: list[np.ndarray]) -> float:
            mask = replace(existing, cells=cells).mask(self.network.shape)
            run = fires_of(replace(setting, standing=mask), self.judged)(self.design.laid, None, silent)
            return float(run["fire_size"].mean()) * area

        every = existing.cells
        whole = float(self.after["fire_size"].mean()) * area
        worth = np.array([burnt(every[:k] + every[k + 1 :]) - whole for k in range(len(every))])
        return Standing(existing, self.network.grid, worth, self.landscape["vegetation"].to_numpy(), setting.price)

    @property
    def existing(self) -> gpd.GeoDataFrame:
        """The existing breaks, see `standing.Standing.table`; over years, which are kept up, see `standing.Kept.table`.

        Raises
        ------
        ParameterError
            If there are none.
        """
        if self.standing is None:
            raise ParameterError("there are no existing breaks; give existing")
        return self.standing.table if self.years is None or self.years.kept is None else self.years.kept.table

    @property
    def polygons(self) -> gpd.GeoDataFrame:
        """Connected pieces of the breaks, see `break_polygons` and `lines.line_polygons`."""
        return self.design.polygons

    @cached_property
    def segments(self) -> Segments:
        """Middle lines and outlines of what is to be built, in order, see `segments.segments`."""
        made = self._segments
        return made if self.years is None else Segments(*(frame.assign(**self.years.columns) for frame in made))

    @cached_property
    def _segments(self) -> Segments:
        return self.design.segments

    @cached_property
    def compartments(self) -> gpd.GeoDataFrame:
        """The fuel between the breaks and what it has to lose, see `compartments.compartments`."""
        laid = np.zeros(self.network.shape, bool) if self.design.laid is None else self.design.laid
        return compartments_of(
            self.network, laid, value=self.stakes.value, ignition=self.stakes.ignition, burns=self.after
        )[1]

    @property
    def headline(self) -> list[str]:
        """What the plan saves, as sentences: first under the fires that were asked or assumed, then in the paper's.

        Over years that comes first which they bring, since before they are over less stands than is judged.
        """
        told = headline(self.summary, self.judged)
        if self.years is None:
            return told
        first, *others = told
        bring = f"{self.years.told} ({self.judged.short})."
        return [bring, f"{self.whole}{first[0].lower()}{first[1:]}", *others, *self.request.calendar.assumptions]

    @property
    def whole(self) -> str:
        """What is to be said before numbers of the whole plan, where it is built over years."""
        if self.years is None:
            return ""
        return "If all of it were built: " if self.years.unbuilt else "Once all of it stands: "

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
        return self.design.told

    @cached_property
    def _figures(self) -> dict[str, Any]:
        return self.design.figures

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
            **self._figures,
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
            figures["unbuilt_segments"] = self.years.unbuilt
        figures["goals"] = self.goals.replace({np.nan: None}).to_dict("records")
        if self.request.design.method != "random":
            figures["p_value_against_random"] = float(chosen["p_value"])
        if "value_lost" in self.before:
            figures["value_lost_without_breaks"] = float(self.before["value_lost"].mean())
            figures["value_lost_with_breaks"] = float(self.after["value_lost"].mean())
        return figures
