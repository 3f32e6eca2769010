"""firebreak compare: methods x budgets x leaks on fresh fires."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import filters, fire_options, kinds, options, outputs, parsing, stakes_options, weather_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import checked_fires, input_files, read_stakes, ridges, tell
from firebreak_gis.cli.rehearsal import require_outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import FirebreakError, ParameterError, raise_together
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.manifest import account, told
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.plugins import build_params, load
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from collections.abc import Callable

    import pandas as pd
    from matplotlib.figure import Figure

    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.stakes import Stakes


@dataclass(frozen=True)
class _Compared:
    """What is written."""

    rows: pd.DataFrame
    front: pd.DataFrame
    priced: bool
    n_burnable: int
    cell_area_ha: float
    told: dict[str, list[str]]

    @cached_property
    def figure(self) -> Figure:
        from firebreak_gis.report.comparison import comparison_figure

        return comparison_figure(
            self.rows,
            n_burnable=self.n_burnable,
            cell_area_ha=self.cell_area_ha,
            caption=" ".join(self.told["assumptions"]),
        )

    @cached_property
    def front_figure(self) -> Figure:
        from firebreak_gis.report.comparison import front_figure

        return front_figure(self.front, priced=self.priced, caption=" ".join(self.told["assumptions"]))


def _table(get: Callable[[_Compared], pd.DataFrame]) -> Callable[[_Compared, Path, Writing], object]:
    def write(compared: _Compared, path: Path, how: Writing) -> None:
        from firebreak_gis.files import write_text

        text = get(compared).to_csv(index=False, lineterminator="\n", float_format="%.8g")
        write_text(path, text, overwrite=how.overwrite)

    return write


def _picture(compared: _Compared, path: Path, how: Writing) -> None:
    from firebreak_gis.report.figures import save

    save(compared.figure, path, overwrite=how.overwrite)


def _front_picture(compared: _Compared, path: Path, how: Writing) -> None:
    from firebreak_gis.report.figures import save

    save(compared.front_figure, path, overwrite=how.overwrite)


def _page(compared: _Compared, path: Path, how: Writing) -> None:
    from firebreak_gis.files import write_text
    from firebreak_gis.files.outputs import labels
    from firebreak_gis.report.page import render
    from firebreak_gis.report.page.comparison import comparison_page

    known = told("compare", how, _told(compared)) | {"files": list(labels(OUTPUTS).items())}
    write_text(path, render(comparison_page(compared.rows, known)), overwrite=how.overwrite)


def _told(compared: _Compared) -> dict[str, object]:
    return {"n_burnable": compared.n_burnable, **compared.told}


#: What the command writes into its folder.
OUTPUTS: tuple[Output[_Compared], ...] = (
    Output("comparison.csv", "Every plan at every budget and leak, with intervals", _table(lambda made: made.rows)),
    Output("comparison.png", "Curves of the plans", _picture),
    Output("comparison.svg", "Curves of the plans, to scale", _picture),
    Output("front.csv", "What each step of each plan costs and saves", _table(lambda made: made.front)),
    Output("front.png", "Saved against paid, and where the next hectare stops paying", _front_picture),
    Output("report.html", "The comparison on one page; opens in any browser", _page, main=True),
    account("compare", _told),
)


@click.command("compare")
@click.argument("network", type=kinds.RASTER)
@outputs.output_folder(OUTPUTS)
@click.option(
    "--methods",
    "method_list",
    type=kinds.PLANS,
    default="lines,dissection,compartments,stripes,bonacich,flammability,random",
    show_default=True,
    metavar="LIST",
    help="Methods, separated by commas, parameters by colons: dissection:width=2,random. What is not set, a method "
    "that asks for the budget or the leak is told for each plan. lines are the breaks that firebreak plan makes where "
    "nothing is said, and left out where it makes none; lines:width=20m have that width in metres.",
)
@click.option(
    "--budgets",
    type=kinds.BUDGETS,
    default="1%,2.5%,5%,10%,14%",
    show_default=True,
    metavar="LIST",
    help="How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha.",
)
@click.option(
    "--residuals",
    type=kinds.NUMBERS,
    default="0,0.05,0.1",
    show_default=True,
    metavar="LIST",
    help="Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.",
)
@click.option(
    "--expected-fires",
    type=float,
    default=1.0,
    show_default=True,
    help="Number of fires that meet the breaks before they have grown back; what breaks save in one fire counts so "
    "often when it is held against what they cost.",
)
@options.dem
@stakes_options.stakes
@stakes_options.siting
@filters.where
@options.fires
@fire_options.judging
@weather_options.weather
@weather_options.spread
@options.seed
@options.fitting("compare")
@options.common
@engine
@built(
    output=OutputRequest,
    fires=FireRequest,
    spread=SpreadRequest,
    weather=WeatherRequest,
    at_stake=StakesRequest,
    siting=SitingRequest,
)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    fires: FireRequest,
    spread: SpreadRequest,
    weather: WeatherRequest,
    at_stake: StakesRequest,
    siting: SitingRequest,
    timeless: bool,
    method_list: list[parsing.Method],
    budgets: list[Budget],
    residuals: list[float],
    expected_fires: float,
    dem: str | None,
) -> None:
    """Compare plans on NETWORK: expected burnt area, value lost, worst fires and leverage, with intervals.

    Also the front, what is saved against what is paid, and where the next hectare stops paying: where it saves less
    than a hectare; with --cost and --values, less than its price.

    NETWORK is a file made by network, or the folder of a landscape made by align, with --wind-speed or --weather. Fires
    on a folder, or on a network with times, have a clock.

    Each plan is made for its budget and leak, as firebreak plan makes it. The fires are fresh: no plan was designed
    with them, and all burn in the same ones.
    """
    from firebreak_gis.breaks import Budget
    from firebreak_gis.evaluation.front import front_table, require_fires, stops_told
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.planning.comparison import compare_plans, comparison_table
    from firebreak_gis.planning.design import Designs
    from firebreak_gis.planning.line_design import Walls
    from firebreak_gis.planning.line_designs import LineDesigns
    from firebreak_gis.planning.scene import files_of, open_scene
    from firebreak_gis.planning.timing import Estimate, fire_seconds, ranking_seconds
    from firebreak_gis.progress import part

    require_fires(expected_fires)
    named = (*fires.sources, *spread.sources, *weather.sources, *at_stake.sources)
    inputs = input_files([*files_of(network), dem, *named])
    how = require_outputs(output, OUTPUTS, inputs)
    laid = Account()
    scene = open_scene(network, spread, weather, account=laid)
    tell(laid, session)
    untouched = scene.network
    planes, read = read_stakes(
        at_stake, session, grid=untouched.grid, fuel=untouched.burnable, ignitions=fires.ignitions
    )
    elevation = ridges(dem, untouched.grid)
    sited = siting.on(planes, untouched, elevation)
    planes = sited.planes
    barred, placed = planes.on(untouched)
    if planes.ignition is not None:
        fires = replace(fires, ignitions=planes.ignition)
    judged = replace(scene.judging(fires, timeless=timeless), sited=sited.told)
    fires = checked_fires(judged.fires, barred, session)
    _require_possible(barred, placed, method_list, budgets, residuals, replace(judged, fires=fires))
    methods, lines_told, left_out = _settled(method_list, judged, barred, residuals)
    notes = [*judged.notes, *left_out]
    for sentence in notes:
        session.warn(sentence)
    roads = planes.followed(untouched)
    ground = scene.ground(judged, barred, planes.barriers)
    trial = Trial(ground, fires, placed, fires.seed) if judged.clock else None
    known: dict[str, Any] = {"elevation": elevation, "roads": roads, "trial": trial, "seed": fires.seed}
    walls = Walls(barred, placed)
    plans: dict[str, Designs | LineDesigns] = {
        label: Designs(barred, method, stakes=placed, params=params, **known)
        if width == "cells"
        else LineDesigns(barred, stakes=placed, width=width, params=params, trial=trial, walls=walls)
        for label, method, params, width in methods
    }
    shares = sorted({budget.share(barred) for budget in budgets})
    value = placed.value if at_stake.valued else None
    ranking = sum(
        plans[label].distinct(shares, residuals)
        * ranking_seconds(
            barred,
            method,
            stakes=placed,
            budget=Budget(max(shares)),
            params=params,
            elevation=elevation,
            roads=roads,
            lines=width != "cells",
        )
        for label, method, params, width in methods
    )
    passes = len(methods) * len(shares) * len(residuals)
    burning = passes * fires.n_runs * fire_seconds(ground, fires, passes=passes, value=value)
    searches = any(isinstance(each, LineDesigns) and each.searches for each in plans.values())
    session.foresee(Estimate({"rankings": ranking, "fires": burning}, without="local search" if searches else ""))
    result = compare_plans(
        barred,
        plans,
        fires,
        budgets=shares,
        residuals=residuals,
        value=value,
        cost=placed.cost if placed.priced else None,
        ground=ground,
        progress=part(session.progress, 0.02, 0.97),
    )
    rows = comparison_table(result)
    assumptions = [*judged.assumptions, *lines_told]
    priced = bool(result.attrs["priced"])
    front = front_table(result, n_fires=expected_fires)
    headline = stops_told(front, priced=priced, n_fires=expected_fires)
    compared = _Compared(
        rows,
        front,
        priced,
        barred.n_burnable,
        barred.grid.cell_area_ha,
        {
            "headline": headline,
            "alignment": [*laid.alignment, *read.alignment],
            "warnings": [*laid.warnings, *read.warnings, *notes],
            "assumptions": assumptions,
        },
    )
    files = write_all(OUTPUTS, compared, output.output, how, progress=part(session.progress, 0.97, 1.0))
    shown = rows.pivot_table(index="method", columns=["residual", "d_f"], values="R", sort=False).sort_index(axis=1)
    session.finish(
        {"files": files, "headline": headline, "assumptions": assumptions},
        f"{' '.join(assumptions)}\n{chr(10).join(headline)}\nmean burnt share R by residual and d_f\n"
        f"{shown.to_string(float_format='%.4f', na_rep='-')}\nwritten to {output.output}",
    )


def _settled(
    methods: list[parsing.Method], judged: Judging, network: SpreadNetwork, residuals: list[float]
) -> tuple[list[parsing.Method], list[str], list[str]]:
    """The methods, without lines of no width where `plan` makes none; what lines are, or why there are none.

    Raises
    ------
    ParameterError
        If no method is left.
    """
    from firebreak_gis.planning.designs import lines

    least = replace(judged, fires=replace(judged.fires, residual=min(residuals)))
    why = lines.hindered(least, network)
    usual = [method for method in methods if method.line_width is None]
    if not usual:
        return methods, [], []
    if not why:
        only = ", planned only for breaks without a leak" if max(residuals) > 0 else ""
        return methods, [f"Lines are {lines.width_of(network):.3g} m wide{only}."], []
    note = f"no lines are compared, since {why}"
    left = [method for method in methods if method.line_width is not None]
    if not left:
        raise ParameterError(f"{note}; give other methods, or lines of a width such as lines:width=20m")
    return left, [], [note]


def _require_possible(
    network: SpreadNetwork,
    placed: Stakes,
    methods: list[parsing.Method],
    budgets: list[Budget],
    residuals: list[float],
    judged: Judging,
) -> None:
    """Refuse before the first ranking what a later one would be refused for."""
    from firebreak_gis.network import checked_residual
    from firebreak_gis.planning.designs import lines
    from firebreak_gis.planning.feasibility import feasibility
    from firebreak_gis.planning.request import DesignRequest, PlanRequest

    problems: list[FirebreakError] = []
    for label, method, params, width in methods:
        try:
            if width == "cells":
                build_params(load("ranking", method), params)
            else:
                asked = DesignRequest(method, params, line_width=width)
                lines.require(PlanRequest(asked, fires=judged.fires, timeless=not judged.clock))
        except ParameterError as error:
            problems.append(ParameterError(f"{label}: {error}"))
    for residual in residuals:
        try:
            checked_residual(residual)
        except ParameterError as error:
            problems.append(error)
    widths = dict.fromkeys(method.line_width for method in methods)
    for budget, each in itertools.product(budgets, widths):
        told = {str(problem) for problem in problems}
        found = feasibility(network, placed, budget=budget, line_width=each).problems
        problems += [problem for problem in found if str(problem) not in told]
    raise_together(problems)
