"""The whole way from a landscape to a plan; the only module that knows the order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from firebreak_gis.breaks import Amount, BudgetUnit
from firebreak_gis.construction.treatments import as_treatments
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.existing import Existing, existing_breaks
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.planning.burning import USUAL, burnt_with, seconds_of
from firebreak_gis.planning.designs import designed, rankings
from firebreak_gis.planning.feasibility import Feasibility
from firebreak_gis.planning.goals import Goal
from firebreak_gis.planning.line_design import Widths
from firebreak_gis.planning.made import Plan
from firebreak_gis.planning.request import DesignRequest, PlanRequest
from firebreak_gis.planning.setting import settle
from firebreak_gis.planning.timing import Estimate
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.planning.years import YearsRequest
from firebreak_gis.progress import Progress, in_proportion, part, silent
from firebreak_gis.simulation.containment import as_containment
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.holding import as_hold
from firebreak_gis.simulation.request import FireRequest, IgnitionMode, Outside
from firebreak_gis.simulation.stations import as_travel
from firebreak_gis.stakes import StakePlanes

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    Plane = np.ndarray | xr.DataArray


def plan(
    landscape: xr.Dataset,
    *,
    budget: Amount = 0.1,
    budget_unit: BudgetUnit | None = None,
    method: str = "dissection",
    method_params: Mapping[str, Any] | None = None,
    model: str = "alexandridis",
    model_params: Mapping[str, Any] | None = None,
    barriers: Plane | None = None,
    existing: Any = None,
    roads: Any = None,
    rivers: Plane | None = None,
    cost: Plane | None = None,
    protected: Plane | None = None,
    aoi: Plane | None = None,
    value: Plane | None = None,
    ignition: Plane | None = None,
    siting: float | None = None,
    siting_params: Mapping[str, Any] | None = None,
    max_slope: float | None = None,
    near_roads: float | None = None,
    beyond_roads: float | None = None,
    width: float | None = None,
    residual: float = 0.0,
    treatments: Any = None,
    hold: Any = None,
    barriers_hold: float = 1.0,
    duration: Any = None,
    weather: Any = None,
    embers: Any = None,
    containment: Any = None,
    stations: Any = None,
    crew_travel: Any = None,
    timeless: bool = False,
    refine: bool = False,
    goal: Goal = "mean",
    line_width: Widths | None = None,
    years: YearsRequest | None = None,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    ignitions_outside: Outside = "refuse",
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    checked: Callable[[Feasibility], None] | None = None,
    progress: Progress | None = None,
) -> Plan:
    """Plan fire breaks on a landscape and burn it with and without them.

    Parameters
    ----------
    landscape
        As `read_landscape` returns it.
    budget, budget_unit
        How much to cut, see `select_breaks`: a share d_f of the cells that hold fuel such as 0.1 or "10%", hectares
        such as "5ha", or money such as "20000eur" (with `cost`); or a number and its unit.
    method, method_params
        Ranking and its parameters, see `rank`. What the plan knows and the method asks for, such as the budget, it is
        told, see `design.design`; what is given here wins.
    model, model_params
        Spread model and its parameters (wind), see `spread_network`.
    barriers
        (y, x), above 0 on existing breaks, roads and rivers that stop fire, see `stakes.with_barriers`.
    existing
        Breaks that stand already: a file, a GeoDataFrame, or what `existing_breaks` returns. Fires meet them before and
        after, they fail as new ones do, and their fuel grows back, see `years`.
    roads
        Roads and tracks: a file, lines, or (y, x) above 0. Beside them breaks are easier to build and to hold, and
        crews from `stations` drive on them.
    rivers
        (y, x), above 0 on water, beside which breaks are easier to hold.
    cost, protected, value, ignition
        (y, x) cost of cutting each cell, where nothing may be cut, value at risk and where fires start, see
        `stakes.Stakes`.
    aoi
        (y, x), above 0 in the area that is planned for: nothing is cut outside, but fires burn there too.
    siting, siting_params, max_slope, near_roads, beyond_roads
        How much more a wall counts in bad ground than on a ridge, a road or the edge of the fuel (None: 1.5 on terrain
        with relief; 0: all ground is alike, as in the paper), what that is made of, and where the ground rules out
        cutting, see `landscape.sited.SitingRequest`.
    width
        Least width of the breaks [m]; rounded up to whole cells.
    residual
        Share of its spread probability that a treated cell keeps; 0 is a perfect break. Methods that know it choose
        the width of their walls for it.
    treatments
        Table from which each segment gets a treatment in place of one residual: the name of a file, "default", or what
        `construction.treatments.read_treatments` returns. Nothing is cut where no treatment is allowed, a budget in
        money is what the treatments cost, and the fires burn with what they leave.
    hold, duration, embers, containment
        How often a stretch of break holds, how long fires burn, whether embers fly, and when crews contain fires, as in
        `simulate`. Where nothing is said fires burn 8 h in the median and breaks hold in 0.47 of fires
        (`judging.ASSUMED_DURATION`, `ASSUMED_HOLD`), which `Plan.judged` names.
    stations, crew_travel
        Crews whom breaks wait for, as in `simulate`. No design knows them.
    barriers_hold
        How often a stretch of the barriers holds.
    weather
        Ensemble of which each run draws one: what `read_weather` reads, in place of a wind among `model_params`.
    timeless
        Fires end by themselves and breaks hold unless `hold` says otherwise, as in the paper. So it is, and
        `Plan.judged` says it, where the spread model tells no times.
    refine
        Whether the breaks are improved by local search on simulated fires, see `placement.refinement.refine`.
    goal
        `"mean"`, or `"worst-tenth"`: what is to be small, the loss of the mean fire or that of the worst tenth, see
        `planning.goals`. `Plan.goals` tells what the plan does for both, in hectares and values.
    line_width
        Width of breaks that are lines [m], which the method `dissection` plans; the budget counts length times width.
        `"auto"`: with `hold` by flames, the width with which fires take least. `"cells"`: breaks are whole cells, as in
        the paper. None: lines as wide as a cell, at most 30 m, where they can be planned and judged; cells elsewhere
        (another method, no clock, breaks that leak, what lines cannot have, large maps), see `designs.lines.usual`.
    years
        Over how many years the plan is built and kept up, see `years.YearsRequest`; default: all at once.
    ignitions, ignition_mode, n_runs, seed, threads, progress
        As in `simulate`; without `ignitions` fires start by `ignition`. No method designs its plan with these fires.
    ignitions_outside
        Whether points and polygons off the landscape or without fuel are refused, or left out and counted.
    checked
        Told, before the ranking, what can be reached.

    Returns
    -------
    Plan
        Everything, from the network to the evaluation. Methods that take `trial` try designs on fires of the kind
        that judges the plan, with other draws.

    Raises
    ------
    ParameterError, InputError
        Before the ranking, naming everything that stands in the way, see `feasibility.feasibility`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> made = fb.plan(fb.read_landscape(*layers, resolution=200.0), budget="10%", n_runs=20)
    >>> 0 < made.summary["ha_cut"] <= 0.1 * made.network.n_burnable * made.network.grid.cell_area_ha
    True
    >>> made.summary["burnt_share_with_breaks"] < made.summary["burnt_share_without_breaks"]
    True
    >>> len(made.headline), made.judged.clock
    (2, True)
    """
    request = PlanRequest(
        design=DesignRequest(
            method, method_params or {}, budget, budget_unit, width, refine, as_treatments(treatments), goal, line_width
        ),
        spread=SpreadRequest(model, model_params or {}),
        fires=FireRequest(
            ignitions,
            ignition_mode,
            n_runs,
            seed,
            residual,
            duration=None if duration is None else as_duration(duration),
            hold=None if hold is None else as_hold(hold),
            barriers_hold=barriers_hold,
            embers=as_embers(embers),
            containment=as_containment(containment),
            ignitions_outside=ignitions_outside,
            stations=stations,
            roads=roads,
            crew_travel=None if crew_travel is None else as_travel(crew_travel),
        ),
        weather=WeatherRequest(weather),
        timeless=timeless,
        calendar=years or YearsRequest(),
        siting=SitingRequest(siting, siting_params or {}, max_slope, near_roads, beyond_roads),
    )
    if roads is not None:
        roads = mask_plane(roads, Grid.of(landscape["burnable"]), what="roads", rule="touched")
    if existing is not None and not isinstance(existing, Existing):
        existing = existing_breaks(existing, Grid.of(landscape["burnable"]), what="existing")
    planes = StakePlanes(barriers, roads, rivers, aoi, cost, protected, value, ignition, existing=existing)
    return make_plan(landscape, request, planes, threads=threads, checked=checked, progress=progress)


def make_plan(
    landscape: xr.Dataset,
    request: PlanRequest,
    planes: StakePlanes,
    *,
    threads: int | None = None,
    checked: Callable[[Feasibility], None] | None = None,
    foreseen: Callable[[Estimate], None] | None = None,
    progress: Progress | None = None,
) -> Plan:
    """Make the plan of a request: settled, designed, burnt, judged.

    Parameters
    ----------
    landscape
        As `read_landscape` returns it.
    request
        What is asked; its layers and stakes have been read.
    planes
        What a planner adds, on the grid of the landscape.
    threads, checked, progress
        As in `plan`.
    foreseen
        Told, before the ranking, how long all will take; without it nobody looks.
    """
    request.require()
    report = progress or silent
    setting = settle(landscape, request, planes, threads=threads)
    if checked is not None:
        checked(setting.found)
    seconds = USUAL
    if foreseen is not None:
        seconds = seconds_of(setting, rankings(request.design))
        foreseen(Estimate(seconds, without=setting.uncounted))
    spans = dict(zip(seconds, in_proportion(list(seconds.values()), 0.02, 1.0), strict=True))
    design = designed(setting, part(report, *spans["ranking"], f"rank by {request.design.method}: "))
    judged = design.under(setting.judged)
    burnt = burnt_with(design, judged, spans, report)
    return Plan.of(design, judged, burnt).over_years(progress=part(report, 1.0, 1.0, "years: "))
