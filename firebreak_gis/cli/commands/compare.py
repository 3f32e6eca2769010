"""firebreak compare: methods x budgets x leaks on fresh fires."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import kinds, options, parsing, stakes
from firebreak_gis.cli.layers import checked_fires, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import FirebreakError, ParameterError
from firebreak_gis.plugins import build_params, load

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
    default="0.01,0.025,0.05,0.1,0.14",
    show_default=True,
    metavar="LIST",
    help="Shares to cut, separated by commas.",
)
@click.option(
    "--residuals",
    default="0,0.05,0.1",
    show_default=True,
    metavar="LIST",
    help="Shares of its spread probability that a treated cell keeps, separated by commas; 0 is perfect.",
)
@click.option("--dem", type=kinds.RASTER, metavar="RASTER", help="Elevation, for methods that follow ridges [m].")
@stakes.stakes
@options.fires
@options.seed
@options.fitting("compare")
@options.common
def command(session: Session, network: str, output: str, method_list: str, **given: Any) -> None:
    """Compare rankings on NETWORK: expected burnt area, value lost, worst fires and leverage, with intervals.

    Each plan is made for its budget and leak, as firebreak plan makes it. The fires are fresh: no plan was designed
    with them, and all burn in the same ones. Writes comparison.csv, comparison.png, comparison.svg and run.json.
    """
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.landscape.planes import value_plane
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.planning.comparison import compare_plans, comparison_table
    from firebreak_gis.planning.design import Designs
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.report.comparison import comparison_figure
    from firebreak_gis.report.figures import save
    from firebreak_gis.spread.raster import read_network

    seed = parsing.checked_seed(given["seed"])
    methods = parsing.methods_list(method_list)
    budgets = parsing.number_list(given["budgets"], "--budgets")
    residuals = parsing.number_list(given["residuals"], "--residuals")
    named = [given[key] for key in ("ignitions", "dem") if given[key]]
    inputs = [network, *named, *stakes.stake_files(given)]
    target = make_folder(output)
    files = [target / name for name in ("comparison.csv", "comparison.png", "comparison.svg")]
    for name in (*files, target / "run.json"):
        require_writable(name, overwrite=given["overwrite"], forbid=files_behind(inputs))
    untouched = read_network(network)
    spread, at_stake = stakes.network_and_stakes(untouched, given)
    fires = checked_fires(given, spread)
    _require_possible(spread, at_stake, methods, budgets, residuals)
    ridges = value_plane(given["dem"], spread.grid, what="elevation", fill=float("nan")) if given["dem"] else None
    roads = (untouched.burnable & ~spread.burnable).astype(float) if given["barriers"] else None
    plans = {
        label: Designs(spread, method, stakes=at_stake, params=params, elevation=ridges, roads=roads, seed=seed)
        for label, method, params in methods
    }
    result = compare_plans(
        spread,
        plans,
        budgets=budgets,
        residuals=residuals,
        value=at_stake.value if given["values"] else None,
        **fires,
        progress=part(session.progress, 0.02, 0.97),
    )
    rows = comparison_table(result)
    with together(target):
        write_text(
            files[0], rows.to_csv(index=False, lineterminator="\n", float_format="%.8g"), overwrite=given["overwrite"]
        )
        figure = comparison_figure(rows, n_burnable=spread.n_burnable, cell_area_ha=spread.grid.cell_area_ha)
        for name in files[1:]:
            save(figure, name, overwrite=given["overwrite"])
        files.append(
            write_manifest(
                target / "run.json",
                command="compare",
                parameters=recorded({"network": network, "method_list": method_list, **given}),
                inputs=_existing(inputs),
                outputs=files,
                account={"n_burnable": spread.n_burnable},
                overwrite=given["overwrite"],
            )
        )
    shown = rows.pivot_table(index="method", columns=["residual", "d_f"], values="R", sort=False)
    session.finish(
        {"files": files},
        f"mean burnt share R by residual and d_f\n{shown.to_string(float_format='%.4f')}\nwritten to {output}",
    )


def _existing(paths: list[str]) -> list[str]:
    return [p for p in paths if Path(p).is_file()]


def _require_possible(
    network: SpreadNetwork, at_stake: Stakes, methods: list[Any], budgets: list[float], residuals: list[float]
) -> None:
    """Refuse before the first ranking what a later one would be refused for."""
    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import checked_residual
    from firebreak_gis.planning.feasibility import feasibility, raise_together

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
        problems += [p for p in feasibility(network, at_stake, budget=Budget(budget)).problems if str(p) not in told]
    raise_together(problems)
