"""firebreak evaluate: a spread network and rankings in, R(d_f) with significance out."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import filters, kinds, options, parsing
from firebreak_gis.cli.layers import checked_fires, input_files, read_stakes, ridges
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.plugins import build_params, load
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from firebreak_gis.evaluation.curves import Test

#: What the command writes into its folder.
OUTPUTS = {
    "evaluation.csv": "Burnt share and significance of every ranking at every budget",
    "evaluation.png": "Curves of the burnt share",
    "evaluation.svg": "Curves of the burnt share, to scale",
    "run.json": "Account of the run",
}


@click.command("evaluate")
@click.argument("network", type=kinds.RASTER)
@options.output_folder
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
    type=kinds.NUMBERS,
    metavar="LIST",
    help="Shares to cut, separated by commas [default: 0 to 0.4 in steps of 0.01].",
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
@options.fires
@filters.where
@options.seed
@options.fitting("evaluate")
@options.common
@built(output=OutputRequest, fires=FireRequest)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    fires: FireRequest,
    method_list: list[parsing.Method],
    baseline: str,
    budgets: list[float] | None,
    test: Test,
    alpha: float,
    dem: str | None,
) -> None:
    """Judge rankings on NETWORK: mean, 90 % percentile and maximum of the burnt share at every budget.

    All rankings meet the same fires, and each plan is made for its budget, as firebreak plan makes it. Writes
    evaluation.csv, evaluation.png, evaluation.svg and run.json.
    """
    from firebreak_gis.evaluation.curves import better_range, evaluate_fires, table
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.planning.design import Designs
    from firebreak_gis.planning.pipeline import default_budgets
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.report.curve import curve_figure
    from firebreak_gis.report.figures import save
    from firebreak_gis.spread.raster import read_network

    methods = list(method_list)
    if baseline not in {method.label for method in methods}:
        methods.append(parsing.Method(baseline, baseline, {}))
    for _, method, params in methods:
        build_params(load("ranking", method), params)
    inputs = input_files([network, dem, *fires.sources])
    target = make_folder(output.output)
    files = [target / name for name in ("evaluation.csv", "evaluation.png", "evaluation.svg")]
    for name in (*files, target / "run.json"):
        require_writable(name, overwrite=output.overwrite, forbid=files_behind(inputs))
    shares = budgets or default_budgets()
    untouched = read_network(network)
    planes, account = read_stakes(
        StakesRequest(), session, grid=untouched.grid, fuel=untouched.burnable, ignitions=fires.ignitions
    )
    placed = planes.on(untouched)[1]
    if planes.ignition is not None:
        fires = replace(fires, ignitions=planes.ignition)
    fires = checked_fires(fires, untouched, session)
    elevation = ridges(dem, untouched.grid)
    # A curve needs each plan once, so only the last is kept.
    priorities = {
        label: Designs(untouched, method, stakes=placed, params=params, elevation=elevation, seed=fires.seed, keep=1)
        for label, method, params in methods
    }
    result = evaluate_fires(
        untouched,
        priorities,
        fires,
        budgets=shares,
        baseline=baseline,
        test=test,
        alpha=alpha,
        progress=part(session.progress, 0.0, 0.95),
    )
    with together(target):
        write_text(files[0], table(result).to_csv(index=False, lineterminator="\n"), overwrite=output.overwrite)
        figure = curve_figure(result)
        for name in files[1:]:
            save(figure, name, overwrite=output.overwrite)
        better = {label: better_range(result, label) for label in priorities if label != baseline}
        files.append(
            write_manifest(
                target / "run.json",
                command="evaluate",
                inputs=inputs,
                outputs=files,
                parameters=recorded(),
                account={
                    "n_burnable": untouched.n_burnable,
                    "significant_d_f": better,
                    "alignment": account.alignment,
                },
                overwrite=output.overwrite,
            )
        )
    told = [
        f"{label} burns less than {baseline} (alpha {alpha:g}) "
        + ("nowhere" if span is None else f"at d_f from {span[0]:g} to {span[1]:g}")
        for label, span in better.items()
    ]
    told.append(f"{len(priorities)} rankings at {len(shares)} budgets; written to {output.output}")
    session.finish({"files": files, "significant_d_f": better}, "\n".join(told))
