"""firebreak align: any layers in, one square grid in metres out."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import options, outputs
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import input_files, read_layers
from firebreak_gis.cli.rehearsal import foresee, rehearse, require_outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.outputs import Output
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.folder import OUTPUTS as LAYERS
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.manifest import account
from firebreak_gis.progress import part

if TYPE_CHECKING:
    import xarray as xr


def _account(landscape: xr.Dataset) -> dict[str, Any]:
    from firebreak_gis.grid import Grid

    return {
        "grid": Grid.of(landscape["burnable"]).describe(),
        "alignment": landscape.attrs["alignment"],
        "warnings": landscape.attrs["warnings"],
    }


#: What the command writes into its folder.
OUTPUTS: tuple[Output[xr.Dataset], ...] = (*LAYERS, account("align", _account))

#: Place in the list of commands, which is the order of the work.
STEP = 2


@click.command("align")
@options.inputs
@outputs.output_folder(OUTPUTS)
@options.dry_run
@options.landscape
@options.common
@engine
@built(layers=LandscapeRequest, output=OutputRequest)
def command(session: Session, *, dry_run: bool, layers: LandscapeRequest, output: OutputRequest) -> None:
    """Lay DEM, VEGETATION and DENSITY on one square grid in metres.

    Writes elevation.tif, vegetation.tif and density.tif (classes of the paper) and says what was done to each
    layer. Landscapes of more than 4 million cells are laid part by part and need not fit into memory.
    """
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.manifest import provenance

    inputs = input_files(layers.sources)
    how = require_outputs(output, OUTPUTS, inputs)
    foreseen = foresee(layers, output, session, OUTPUTS)
    if dry_run:
        rehearse(foreseen, session)
        return
    step = part(session.progress, 0.0, 0.8)
    landscape = read_layers(layers, foreseen.survey, session, folder=output.output, progress=step)
    how = replace(how, tags=provenance(how.parameters))
    progress = part(session.progress, 0.8, 1.0)
    files = write_all(OUTPUTS, landscape, output.output, how, variables=landscape, progress=progress)
    told = _account(landscape)
    session.finish({"files": files, **told}, f"{told['grid']}; {len(files)} files in {output.output}")
