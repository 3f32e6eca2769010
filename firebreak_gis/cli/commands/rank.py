"""firebreak rank: a spread network in, a priority raster out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import filters, kinds, options, outputs, stakes_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import input_files, read_stakes, ridges
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.sited import SitingRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.memory import BLOCK_CELLS
from firebreak_gis.planning.request import DesignRequest
from firebreak_gis.simulation.request import FireRequest

#: Place in the list of commands, which is the order of the work.
STEP = 4


@click.command("rank")
@click.argument("network", type=kinds.RASTER)
@outputs.output_file("Priority GeoTIFF")
@options.budget
@options.ranking
@options.leaks
@options.dem
@options.ignition_map
@stakes_options.stakes
@stakes_options.roads
@stakes_options.siting
@filters.where
@options.seed
@options.fitting("rank")
@options.common
@engine
@built(output=OutputRequest, asked=DesignRequest, fires=FireRequest, at_stake=StakesRequest, siting=SitingRequest)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    asked: DesignRequest,
    fires: FireRequest,
    at_stake: StakesRequest,
    siting: SitingRequest,
    dem: str | None,
) -> None:
    """Rank the cells of NETWORK by the order in which they should be cut: higher is earlier.

    The ranking is the one that firebreak plan makes for the same budget, leak, width, terrain and barriers. Methods
    that lay a pattern for the budget give another ranking for another one; the file tells firebreak breaks. Of networks
    of more than 4 million cells the probabilities stay on the disk, beside the output.
    """
    from firebreak_gis.files import require_writable
    from firebreak_gis.manifest import provenance
    from firebreak_gis.planning.design import design
    from firebreak_gis.planning.feasibility import feasibility, width_in_cells
    from firebreak_gis.planning.timing import Estimate, ranking_seconds
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, write_blocks
    from firebreak_gis.rasters.blocks import rows_of
    from firebreak_gis.spread.raster import NetworkFile

    inputs = files_behind(input_files([network, dem, *fires.sources, *at_stake.sources]))
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    file = NetworkFile(network)
    large = file.grid.shape[0] * file.grid.shape[1] > BLOCK_CELLS
    untouched = file.on_disk(Path(output.output).parent) if large else file.read()
    planes, _ = read_stakes(at_stake, session, grid=untouched.grid, fuel=untouched.burnable, ignitions=fires.ignitions)
    elevation = ridges(dem, untouched.grid)
    sited = siting.on(planes, untouched, elevation)
    barred, placed = sited.planes.on(untouched)
    found = feasibility(barred, placed, budget=asked.amount, width=asked.width, residual=fires.leak)
    found.require()
    for sentence in (*sited.told, *sited.account):
        session.say(sentence)
    for sentence in found.warnings:
        session.warn(sentence)
    asked_for: dict[str, Any] = {
        "stakes": placed,
        "budget": asked.amount,
        "residual": fires.leak,
        "width": width_in_cells(asked.width, barred.grid.cell_size),
        "params": asked.method_params,
        "elevation": elevation,
        "roads": planes.followed(barred),
        "seed": fires.seed,
    }
    session.foresee(Estimate({"ranking": ranking_seconds(barred, asked.method, **asked_for)}))
    priority = design(barred, asked.method, **asked_for, progress=part(session.progress, 0.02, 0.98))
    # What makes no difference is not told, so that equal rankings have equal files.
    shaped = {
        "residual": fires.residual,
        "width": asked.width,
        "siting": sited.strength,
        "made_for": priority.attrs.get("made_for"),
    }
    parameters = {"method": asked.method, "method_params": asked.method_params}
    write_blocks(
        output.output,
        rows_of(priority.to_dataset().assign_attrs(priority.attrs)),
        barred.grid,
        overwrite=output.overwrite,
        forbid=inputs,
        provenance=provenance(parameters | {k: v for k, v in shaped.items() if v}, seed=fires.seed),
        creation_options=output.creation_options,
    )
    session.finish({"files": [output.output]}, f"ranked by {asked.method}; written to {output.output}")
