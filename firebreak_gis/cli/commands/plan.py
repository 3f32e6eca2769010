"""firebreak plan: the whole job."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import (
    filters,
    fire_options,
    kinds,
    options,
    outputs,
    stakes_options,
    weather_options,
    years_options,
)
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import input_files, read_layers, read_stakes
from firebreak_gis.cli.rehearsal import foresee, rehearse, require_outputs, require_possible
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.planning.outputs import OUTPUTS, write_plan
from firebreak_gis.planning.request import DesignRequest, PlanRequest
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.planning.years import YearsRequest
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from firebreak_gis.planning.feasibility import Feasibility

#: Place in the list of commands, which is the order of the work.
STEP = 1


@click.command("plan")
@options.inputs
@outputs.output_folder(OUTPUTS)
@options.dry_run
@options.budget
@options.ranking
@options.leaks
@click.option("--refine", is_flag=True, help="Improve the breaks by local search on simulated fires; takes longer.")
@click.option(
    "--goal",
    type=click.Choice(["mean", "worst-tenth"]),
    default="mean",
    show_default=True,
    help="What is to be small: the loss of the mean fire, or that of the worst tenth of the fires (CVaR).",
)
@click.option(
    "--line-width",
    type=kinds.PLANNED_WIDTH,
    metavar="METRES|auto|cells",
    help="Width of the lines that breaks are, such as 12m, narrower than a cell too; the budget counts their length "
    "times their width. With --hold flame, auto is the width with which fires take least. cells cuts whole cells, as "
    "in the paper. Default: lines as wide as a cell, at most 30 m, where fires have a clock and breaks do not leak.",
)
@click.option(
    "--treatments",
    type=kinds.TREATMENTS,
    metavar="FILE|default",
    help="Table of treatments (CSV: name, vegetation, residual, cost_ha, cost_per_degree, years, max_slope_deg), or "
    "default: each segment gets the one that saves most for its cost, a budget in cost is what they cost, and fires "
    "burn with what they leave [default: all segments alike, by --residual].",
)
@years_options.calendar
@stakes_options.stakes
@stakes_options.siting
@filters.where
@options.fires
@fire_options.judging
@options.seed
@weather_options.weather
@weather_options.spread
@options.landscape
@options.common
@engine
@built(
    layers=LandscapeRequest,
    output=OutputRequest,
    design=DesignRequest,
    spread=SpreadRequest,
    fires=FireRequest,
    weather=WeatherRequest,
    at_stake=StakesRequest,
    calendar=YearsRequest,
    siting=SitingRequest,
)
def command(
    session: Session,
    *,
    dry_run: bool,
    layers: LandscapeRequest,
    output: OutputRequest,
    design: DesignRequest,
    spread: SpreadRequest,
    fires: FireRequest,
    weather: WeatherRequest,
    at_stake: StakesRequest,
    calendar: YearsRequest,
    siting: SitingRequest,
    timeless: bool,
) -> None:
    """Plan fire breaks: DEM, VEGETATION and DENSITY rasters in, breaks and burn maps out.

    The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. DENSITY may
    be a raster, one of the words sparse, normal, dense, continuity (how closed the fuel is), or left out if the
    legend gives the density. DEM alone may be a FlamMap landscape (.lcp).
    """
    from firebreak_gis.grid import Grid
    from firebreak_gis.planning.goals import goals_told
    from firebreak_gis.planning.pipeline import make_plan
    from firebreak_gis.planning.setting import away
    from firebreak_gis.progress import part

    request = PlanRequest(design, spread, fires, at_stake, weather, timeless, calendar, siting, layers, output)
    require_possible(request)
    inputs = input_files(request.sources)
    how = require_outputs(output, OUTPUTS, inputs)
    foreseen = foresee(layers, output, session, OUTPUTS, method=design.method, clock=not timeless, away=away(request))
    if dry_run:
        rehearse(foreseen, session)
        return
    landscape = read_layers(layers, foreseen.survey, session, progress=part(session.progress, 0.0, 0.05, "align: "))
    planes, account = read_stakes(
        at_stake,
        session,
        grid=Grid.of(landscape["burnable"]),
        fuel=landscape["burnable"].to_numpy() > 0,
        ignitions=fires.ignitions,
        landscape=landscape,
        strict=layers.strict,
    )
    for name, sentences in (("alignment", account.alignment), ("warnings", account.warnings)):
        landscape.attrs[name] = [*landscape.attrs.get(name, []), *sentences]
    if planes.ignition is not None:  # a raster: it shapes the plan, and the fires start by it
        request = replace(request, fires=replace(fires, ignitions=None))
    reached: list[str] = []

    def tell(found: Feasibility) -> None:
        reached.extend(found.warnings)
        _tell(session, found.account, found.warnings, strict=layers.strict)

    result = make_plan(
        landscape,
        request,
        planes,
        checked=tell,
        foreseen=session.foresee if session.heard else None,
        progress=part(session.progress, 0.05, 0.95),
    )
    for key, say in (("alignment", session.say), ("warnings", session.warn)):  # what was done to the weather
        for sentence in result.landscape.attrs[key][len(landscape.attrs[key]) :]:
            say(sentence)
    _tell(session, (), result.feasibility.warnings[len(reached) :], strict=layers.strict)
    if result.years is not None and result.years.unbuilt:
        session.say(
            "for breaks that are not built within the years: give more --budget-per-year, or a smaller --budget"
        )
    files = write_plan(
        result,
        output.output,
        parameters=how.parameters,
        inputs=inputs,
        creation_options=output.creation_options,
        overwrite=output.overwrite,
        progress=part(session.progress, 0.95, 1.0),
    )
    summary = result.summary
    judged = summary["judged"]
    told = {"headline": result.headline, "assumptions": result.judged.assumptions}
    first = 1 if result.years is None else 2
    saved = goals_told(result.goals)
    if saved and result.whole:
        saved = f"{result.whole}{saved[0].lower()}{saved[1:]}"
    session.finish(
        {"files": files, **told, **summary},
        f"{result.built}.\n"
        f"{chr(10).join(result.headline[:first])}\n"
        f"{' '.join(result.judged.assumptions)}\n"
        f"{judged['leverage']:.3g} ha saved per ha treated "
        f"({judged['leverage_low']:.3g} to {judged['leverage_high']:.3g}), "
        f"{judged['cvar_ha']:,.0f} ha burnt in the worst tenth of the fires.\n"
        f"{''.join(f'{sentence}{chr(10)}' for sentence in result.headline[first:])}"
        f"{saved}\n"
        f"{len(files)} files in {output.output}; look at overview.png first.",
    )


def _tell(session: Session, account: Sequence[str], warnings: Sequence[str], *, strict: bool) -> None:
    """Say what the plan can reach."""
    for sentence in account:
        session.say(sentence)
    for sentence in warnings:
        session.warn(sentence)
    if strict and warnings:
        raise ParameterError("refused, as --strict asks: " + "; ".join(warnings))
