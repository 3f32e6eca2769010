"""firebreak compare: methods x budgets x leaks on fresh fires."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import filters, kinds, options, parsing, stakes
from firebreak_gis.cli.layers import checked_fires, input_files, read_stakes, ridges
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import FirebreakError, ParameterError, raise_together
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.plugins import build_params, load
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes

#: What the command writes into its folder.
OUTPUTS = {
    "comparison.csv": "Every ranking at every budget and leak, with intervals",
    "comparison.png": "Curves of the rankings",
    "comparison.svg": "Curves of the rankings, to scale",
    "run.json": "Account of the run",
}


@click.command("compare")
@click.argument("network", type=kinds.RASTER)
@options.output_folder
@click.option(
    "--methods",
    "method_list",
    type=kinds.RANKINGS,
    default="dissection,compartments,stripes,bonacich,flammability,random",
    show_default=True,
    metavar="LIST",
    help="Rankings, separated by commas, parameters by colons: dissection:width=2,random. What is not set, a method "
    "that asks for the budget or the leak is told for each plan.",
)
@click.option(
    "--budgets",
    type=kinds.NUMBERS,
    default="0.01,0.025,0.05,0.1,0.14",
    show_default=True,
    metavar="LIST",
    help="Shares to cut, separated by commas.",
)
@click.option(
    "--residuals",
    type=kinds.NUMBERS,
    default="0,0.05,0.1",
    show_default=True,
    metavar="LIST",
    help="Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.",
)
@options.dem
@stakes.stakes
@filters.where
@options.fires
@options.seed
@options.fitting("compare")
@options.common
@built(output=OutputRequest, fires=FireRequest, at_stake=StakesRequest)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    fires: FireRequest,
    at_stake: StakesRequest,
    method_list: list[parsing.Method],
    budgets: list[float],
    residuals: list[float],
    dem: str | None,
) -> None:
    """Compare rankings on NETWORK: expected burnt area, value lost, worst fires and leverage, with intervals.

    Each plan is made for its budget and leak, as firebreak plan makes it. The fires are fresh: no plan was designed
    with them, and all burn in the same ones. Writes comparison.csv, comparison.png, comparison.svg and run.json.
    """
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.planning.comparison import compare_plans, comparison_table
    from firebreak_gis.planning.design import Designs
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.report.comparison import comparison_figure
    from firebreak_gis.report.figures import save
    from firebreak_gis.spread.raster import read_network

    inputs = input_files([network, *fires.sources, dem, *at_stake.sources])
    target = make_folder(output.output)
    files = [target / name for name in ("comparison.csv", "comparison.png", "comparison.svg")]
    for name in (*files, target / "run.json"):
        require_writable(name, overwrite=output.overwrite, forbid=files_behind(inputs))
    untouched = read_network(network)
    planes, account = read_stakes(
        at_stake, session, grid=untouched.grid, fuel=untouched.burnable, ignitions=fires.ignitions
    )
    barred, placed = planes.on(untouched)
    fires = checked_fires(
        fires if planes.ignition is None else replace(fires, ignitions=planes.ignition), barred, session
    )
    _require_possible(barred, placed, method_list, budgets, residuals)
    elevation, roads = ridges(dem, barred.grid), planes.roads(untouched)
    plans = {
        label: Designs(barred, method, stakes=placed, params=params, elevation=elevation, roads=roads, seed=fires.seed)
        for label, method, params in method_list
    }
    result = compare_plans(
        barred,
        plans,
        fires,
        budgets=budgets,
        residuals=residuals,
        value=placed.value if at_stake.values else None,
        progress=part(session.progress, 0.02, 0.97),
    )
    rows = comparison_table(result)
    with together(target):
        write_text(
            files[0], rows.to_csv(index=False, lineterminator="\n", float_format="%.8g"), overwrite=output.overwrite
        )
        figure = comparison_figure(rows, n_burnable=barred.n_burnable, cell_area_ha=barred.grid.cell_area_ha)
        for name in files[1:]:
            save(figure, name, overwrite=output.overwrite)
        files.append(
            write_manifest(
                target / "run.json",
                command="compare",
                parameters=recorded(),
                inputs=inputs,
                outputs=files,
                account={
                    "n_burnable": barred.n_burnable,
                    "alignment": account.alignment,
                    "warnings": account.warnings,
                },
                overwrite=output.overwrite,
            )
        )
    shown = rows.pivot_table(index="method", columns=["residual", "d_f"], values="R", sort=False)
    session.finish(
        {"files": files},
        f"mean burnt share R by residual and d_f\n{shown.to_string(float_format='%.4f')}\nwritten to {output.output}",
    )


def _require_possible(
    network: SpreadNetwork, placed: Stakes, methods: list[parsing.Method], budgets: list[float], residuals: list[float]
) -> None:
    """Refuse before the first ranking what a later one would be refused for."""
    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import checked_residual
    from firebreak_gis.planning.feasibility import feasibility

    problems: list[FirebreakError] = []
    for label, method, params in methods:
        try:
            build_params(load("ranking", method), params)
        except ParameterError as error:
            problems.append(ParameterError(f"{label}: {error}"))
    for residual in residuals:
        try:
            checked_residual(residual)
        except ParameterError as error:
            problems.append(error)
    for budget in budgets:
        told = {str(problem) for problem in problems}
        problems += [p for p in feasibility(network, placed, budget=Budget(budget)).problems if str(p) not in told]
    raise_together(problems)
