"""firebreak plan: the whole job."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import options, parsing, stakes
from firebreak_gis.cli.layers import input_files, read_layers, recorded, spread_params
from firebreak_gis.cli.rehearsal import foresee, rehearse, require_outputs, require_possible
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError

if TYPE_CHECKING:
    from firebreak_gis.planning.feasibility import Feasibility

#: What the command writes into its folder.
OUTPUTS = {
    "breaks.tif": "Fire breaks",
    "breaks.gpkg": "Fire breaks as polygons",
    "segments.gpkg": "Segments to build, in order",
    "compartments.gpkg": "Compartments between the breaks",
    "priority.tif": "Cutting priority",
    "burn_frequency.tif": "Burn frequency without breaks",
    "burn_frequency_with_breaks.tif": "Burn frequency with the breaks",
    "elevation.tif": "Elevation on the common grid",
    "vegetation.tif": "Vegetation classes on the common grid",
    "density.tif": "Density classes on the common grid",
    "fire_sizes.csv": "Size of every fire without and with the breaks",
    "evaluation.csv": "Burnt share at every budget",
    "overview.png": "Picture of the plan",
    "run.json": "Account of the run",
}


@click.command("plan")
@options.inputs
@options.output_folder
@options.dry_run
@options.budget
@options.ranking
@options.leaks
@click.option("--refine", is_flag=True, help="Improve the breaks by local search on simulated fires; takes longer.")
@stakes.stakes
@options.fires
@options.seed
@options.spread
@options.landscape
@options.common
def command(session: Session, **given: Any) -> None:
    """Plan fire breaks: DEM, VEGETATION and DENSITY rasters in, breaks and burn maps out.

    The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. DENSITY may
    be a raster, one of the words sparse, normal, dense, continuity (how closed the fuel is), or left out if the
    legend gives the density. DEM alone may be a FlamMap landscape (.lcp).
    """
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.planes import ignition_source
    from firebreak_gis.planning.outputs import PLAN_FILES, write_plan
    from firebreak_gis.planning.pipeline import plan
    from firebreak_gis.progress import part

    parameters = {
        **given,
        "method_params": parsing.pairs(given["method_params"], "--param"),
        "model_params": parsing.pairs(given["model_params"], "--model-param"),
    }
    require_possible(parameters)
    inputs = [*input_files(given), *stakes.stake_files(given)]
    require_outputs(given, PLAN_FILES, inputs)
    foreseen = foresee(given, session, PLAN_FILES, method=given["method"])
    if given["dry_run"]:
        rehearse(foreseen, session)
        return
    landscape = read_layers(given, session, progress=part(session.progress, 0.0, 0.1, "align: "))
    grid = Grid.of(landscape["burnable"])
    result = plan(
        landscape,
        budget=given["budget"],
        budget_unit=given["budget_unit"],
        width=given["width"],
        residual=given["residual"],
        refine=given["refine"],
        **stakes.read_stakes(grid, given, landscape=landscape),
        method=given["method"],
        method_params=parameters["method_params"],
        model=given["model"],
        model_params=spread_params(given, grid),
        ignitions=ignition_source(given["ignitions"], grid),
        ignition_mode=given["ignition_mode"],
        n_runs=given["n_runs"],
        seed=given["seed"],
        checked=lambda found: _tell(session, found, strict=given["strict"]),
        progress=part(session.progress, 0.1, 0.8),
    )
    files = write_plan(
        result,
        given["output"],
        parameters=recorded(parameters),
        inputs=inputs,
        creation_options=parsing.pairs(given["creation_options"], "--co"),
        overwrite=given["overwrite"],
        progress=part(session.progress, 0.8, 1.0),
    )
    summary = result.summary
    judged = summary["judged"]
    session.finish(
        {"files": files, **summary},
        f"{summary['cells_cut']} of {summary['burnable_cells']} cells with fuel cut "
        f"({summary['ha_cut']:,.1f} ha). "
        f"Mean burnt share {100 * summary['burnt_share_without_breaks']:.1f} % without, "
        f"{100 * summary['burnt_share_with_breaks']:.1f} % with the breaks: "
        f"{judged['leverage']:.1f} ha saved per ha treated "
        f"({judged['leverage_low']:.1f} to {judged['leverage_high']:.1f}), "
        f"{judged['cvar_ha']:,.0f} ha burnt in the worst tenth of the fires.\n"
        f"{len(files)} files in {given['output']}; look at overview.png first.",
    )


def _tell(session: Session, found: Feasibility, *, strict: bool) -> None:
    """Say what the plan can reach."""
    for sentence in found.account:
        session.say(sentence)
    for sentence in found.warnings:
        session.warn(sentence)
    if strict and found.warnings:
        raise ParameterError("refused, as --strict asks: " + "; ".join(found.warnings))
