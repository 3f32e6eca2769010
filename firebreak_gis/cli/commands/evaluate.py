"""firebreak evaluate: a spread network and rankings in, R(d_f) with significance out."""

from __future__ import annotations

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
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.manifest import account
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.plugins import build_params, load
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from firebreak_gis.breaks import Budget
    from firebreak_gis.evaluation.curves import Test


@dataclass(frozen=True)
class _Judged:
    """What is written: the result, and the labels of all rankings but the baseline."""

    result: xr.Dataset
    n_burnable: int
    labels: tuple[str, ...]
    alignment: list[str]
    assumptions: tuple[str, ...]

    @cached_property
    def figure(self) -> Figure:
        from firebreak_gis.report.curve import curve_figure

        return curve_figure(self.result, caption=" ".join(self.assumptions))

    @cached_property
    def better(self) -> dict[str, list[float] | None]:
        """Budgets from and to which each ranking burns less than the baseline."""
        from firebreak_gis.evaluation.curves import better_range

        return {label: better_range(self.result, label) for label in self.labels}


def _csv(judged: _Judged, path: Path, how: Writing) -> None:
    from firebreak_gis.evaluation.curves import table

    _write(table(judged.result), path, how)


def _runs(judged: _Judged, path: Path, how: Writing) -> None:
    from firebreak_gis.evaluation.curves import runs_table

    _write(runs_table(judged.result), path, how)


def _write(frame: pd.DataFrame, path: Path, how: Writing) -> None:
    from firebreak_gis.files import write_text

    write_text(path, frame.to_csv(index=False, lineterminator="\n"), overwrite=how.overwrite)


def _picture(judged: _Judged, path: Path, how: Writing) -> None:
    from firebreak_gis.report.figures import save

    save(judged.figure, path, overwrite=how.overwrite)


#: What the command writes into its folder.
OUTPUTS: tuple[Output[_Judged], ...] = (
    Output("evaluation.csv", "Burnt share and significance of every ranking at every budget", _csv),
    Output("runs.csv", "Cells burnt in every run, from which each p-value can be found again", _runs),
    Output("evaluation.png", "Curves of the burnt share", _picture),
    Output("evaluation.svg", "Curves of the burnt share, to scale", _picture),
    account(
        "evaluate",
        lambda judged: {
            "n_burnable": judged.n_burnable,
            "significant_d_f": judged.better,
            "alignment": judged.alignment,
            "assumptions": judged.assumptions,
        },
    ),
)

#: Place in the list of commands, which is the order of the work.
STEP = 8


@click.command("evaluate")
@click.argument("network", type=kinds.RASTER)
@outputs.output_folder(OUTPUTS)
@click.option(
    "--methods",
    "method_list",
    type=kinds.RANKINGS,
    default="bonacich,random",
    show_default=True,
    metavar="LIST",
    help="Rankings, separated by commas, parameters by colons: bonacich:beta=0.2,betweenness,random.",
)
@click.option(
    "--baseline",
    type=kinds.RANKING,
    metavar="NAME",
    default="random",
    show_default=True,
    help="Ranking that the others are tested against.",
)
@click.option(
    "--budgets",
    type=kinds.BUDGETS,
    metavar="LIST",
    help="How much to cut, separated by commas: shares of the fuel such as 5% or 0.05, or areas such as 20ha [default: "
    "0 to 0.4 in steps of 0.01; where each budget is burnt anew, with a clock or breaks that fail, 0, 0.025, 0.05, "
    "0.075, 0.1, 0.15, 0.2].",
)
@click.option(
    "--test",
    type=click.Choice(["wilcoxon", "ranksum", "t"]),
    default="wilcoxon",
    show_default=True,
    help="Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.",
)
@click.option("--alpha", type=float, default=0.01, show_default=True, help="Significance threshold.")
@options.dem
@stakes_options.siting
@options.fires
@fire_options.judging
@weather_options.weather
@weather_options.spread
@filters.where
@options.seed
@options.fitting("evaluate")
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
    baseline: str,
    budgets: list[Budget] | None,
    test: Test,
    alpha: float,
    dem: str | None,
) -> None:
    """Judge rankings on NETWORK: mean, 90 % percentile and maximum of the burnt share at every budget.

    NETWORK is a file made by network, or the folder of a landscape made by align, with --wind-speed or --weather. Fires
    on a folder, or on a network with times, have a clock.

    All rankings meet the same fires, and each plan is made for its budget, as firebreak plan makes it. Writes
    evaluation.csv, runs.csv, evaluation.png, evaluation.svg and run.json.
    """
    from firebreak_gis.breaks import Budget
    from firebreak_gis.evaluation.curves import evaluate_fires
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.planning.budgets import default_budgets, few_budgets
    from firebreak_gis.planning.design import Designs
    from firebreak_gis.planning.scene import files_of, open_scene
    from firebreak_gis.planning.timing import Estimate, fire_seconds, ranking_seconds
    from firebreak_gis.progress import part

    methods = list(method_list)
    if baseline not in {method.label for method in methods}:
        methods.append(parsing.Method(baseline, baseline, {}))
    for _, method, params, *_ in methods:
        build_params(load("ranking", method), params)
    inputs = input_files(
        [*files_of(network), dem, *fires.sources, *spread.sources, *weather.sources, *at_stake.sources]
    )
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
    placed = sited.planes.on(untouched)[1]
    if planes.ignition is not None:
        fires = replace(fires, ignitions=planes.ignition)
    judged = replace(scene.judging(fires, timeless=timeless), sited=sited.told)
    fires = checked_fires(judged.fires, untouched, session)
    for sentence in judged.notes:
        session.warn(sentence)
    usual = few_budgets(0.05, 0.1) if judged.reburnt else default_budgets()
    shares = sorted({budget.share(untouched) for budget in budgets}) if budgets else usual
    ground = scene.ground(judged, untouched, None)
    trial = Trial(ground, fires, placed, fires.seed) if judged.clock else None
    known: dict[str, Any] = {"elevation": elevation, "trial": trial, "seed": fires.seed}
    # A curve needs each plan once, so only the last is kept.
    priorities = {
        label: Designs(untouched, method, stakes=placed, params=params, keep=1, **known)
        for label, method, params, *_ in methods
    }
    passes = len(priorities) * (len(shares) if judged.reburnt else 1)
    ranking = sum(
        priorities[label].distinct(shares)
        * ranking_seconds(
            untouched, method, stakes=placed, budget=Budget(max(shares)), params=params, elevation=elevation
        )
        for label, method, params, *_ in methods
    )
    burning = passes * fires.n_runs * fire_seconds(ground, fires, passes=passes)
    session.foresee(Estimate({"rankings": ranking, "fires": burning}))
    result = evaluate_fires(
        untouched,
        priorities,
        fires,
        budgets=shares,
        baseline=baseline,
        test=test,
        alpha=alpha,
        ground=ground,
        progress=part(session.progress, 0.02, 0.95),
    )
    evaluated = _Judged(
        result,
        untouched.n_burnable,
        tuple(label for label in priorities if label != baseline),
        [*laid.alignment, *read.alignment],
        judged.assumptions,
    )
    files = write_all(OUTPUTS, evaluated, output.output, how, progress=part(session.progress, 0.95, 1.0))
    told = [
        f"{label} burns less than {baseline} (alpha {alpha:g}) "
        + ("nowhere" if span is None else f"at d_f from {span[0]:g} to {span[1]:g}")
        for label, span in evaluated.better.items()
    ]
    told.append(f"{len(priorities)} rankings at {len(shares)} budgets; written to {output.output}")
    told.append(" ".join(judged.assumptions))
    session.finish(
        {"files": files, "significant_d_f": evaluated.better, "assumptions": judged.assumptions}, "\n".join(told)
    )
