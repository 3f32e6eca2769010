"""What is asked of a plan: one typed value, built once, by the command, by `pipeline.plan` or from a `run.json`.

It is made of parts that other commands take as well: the layers and their grid (`align`), the spread model and the
weather (`network`), what a planner adds (`rank`, `segments`, `compare`), the fires (`burn`, `evaluate`, `compare`) and
where the result goes (all). A part lies beside the code that reads it; its docstring says how to add an option. The
command line fills every part by the names of its fields (`cli.options.built`), so that an option is typed in two
places: the field, and its `click.option` with the text that help pages and QGIS show.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from firebreak_gis.breaks import Amount, Budget, BudgetUnit
from firebreak_gis.construction.treatments import Treatments
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.planning.goals import Goal
from firebreak_gis.planning.line_design import Widths
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.planning.years import YearsRequest
from firebreak_gis.simulation.request import FireRequest


@dataclass(frozen=True)
class DesignRequest:
    """How the breaks are chosen, and how much may be cut.

    Parameters
    ----------
    method, method_params
        Ranking and its parameters, see `design.design`.
    budget, budget_unit
        See `breaks.Budget.of`.
    width
        Least width of the breaks [m].
    refine
        Whether they are improved by local search.
    treatments
        Table from which each segment gets its treatment; None: all segments alike, as the residual of the fires says.
    goal
        Whether the mean of all fires or that of their worst tenth is to be small, see `goals.for_worst_tenth`.
    line_width
        Width of breaks that are lines [m], "auto" for that which suits the flames, "cells" for whole cells in their
        place; None: as `designs.lines.usual` says.
    """

    method: str = "dissection"
    method_params: Mapping[str, Any] = field(default_factory=dict)
    budget: Amount = 0.1
    budget_unit: BudgetUnit | None = None
    width: float | None = None
    refine: bool = False
    treatments: Treatments | None = None
    goal: Goal = "mean"
    line_width: Widths | None = None

    def __post_init__(self) -> None:
        """Refuse a budget that cannot be read, or that its unit contradicts."""
        _ = self.amount

    @property
    def amount(self) -> Budget:
        """How much may be cut."""
        return Budget.of(self.budget, self.budget_unit)


@dataclass(frozen=True)
class PlanRequest:
    """A plan.

    Parameters
    ----------
    design, spread, fires, stakes
        Rankings and budget, spread model and wind, fires, and what a planner adds. The leak of the breaks is that
        of the fires, as is the seed of the design.
    weather
        Ensemble of weathers in place of the wind.
    timeless
        Whether the fires have no clock and the breaks hold, as in the paper, unless `fires` says otherwise; else what
        `fires` leaves open is assumed, see `judging`.
    calendar
        Over how many years it is built and kept up.
    siting
        How breaks are laid into the ground.
    layers, output
        What is read and written; None where the landscape is at hand, and the plan stays in memory.
    """

    design: DesignRequest = field(default_factory=DesignRequest)
    spread: SpreadRequest = field(default_factory=SpreadRequest)
    fires: FireRequest = field(default_factory=FireRequest)
    stakes: StakesRequest = field(default_factory=StakesRequest)
    weather: WeatherRequest = field(default_factory=WeatherRequest)
    timeless: bool = False
    calendar: YearsRequest = field(default_factory=YearsRequest)
    siting: SitingRequest = field(default_factory=SitingRequest)
    layers: LandscapeRequest | None = None
    output: OutputRequest | None = None

    def require(self) -> None:
        """Refuse years that cannot be, and what the kind of design cannot be asked for beside, see `designs.require`.

        Raises
        ------
        ParameterError
            Naming what is wrong.
        """
        from firebreak_gis.planning.designs import require

        require(self)
        self.calendar.require()

    @property
    def sources(self) -> tuple[str, ...]:
        """Names that may be those of files that go in."""
        layers = () if self.layers is None else self.layers.sources
        treatments = self.design.treatments
        layers += () if treatments is None or not treatments.source else (treatments.source,)
        return (*layers, *self.fires.sources, *self.spread.sources, *self.weather.sources, *self.stakes.sources)
