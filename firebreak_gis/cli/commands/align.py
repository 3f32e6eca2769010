"""firebreak align: any layers in, one square grid in metres out."""

from __future__ import annotations

import click

from firebreak_gis.cli import options
from firebreak_gis.cli.layers import input_files, read_layers
from firebreak_gis.cli.rehearsal import foresee, rehearse, require_outputs
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.request import LandscapeRequest

#: What the command writes into its folder.
OUTPUTS = {
    "elevation.tif": "Elevation on the common grid",
    "vegetation.tif": "Vegetation classes on the common grid",
    "density.tif": "Density classes on the common grid",
    "vegetation_effect.tif": "Effect of the vegetation, where the legend gives numbers in place of classes",
    "density_effect.tif": "Effect of the density, where the legend gives numbers in place of classes",
    "rate.tif": "Rate of spread on flat calm dry ground, where the legend gives it",
    "dead_load.tif": "Load of dead fuel, where the legend gives it",
    "live_load.tif": "Load of live fuel, where the legend gives it",
    "heat_content.tif": "Heat content of the fuel, where the legend gives it",
    "live_moisture.tif": "Moisture of the live fuel, where the legend gives it",
    "run.json": "Account of the run",
}


@click.command("align")
@options.inputs
@options.output_folder
@options.dry_run
@options.landscape
@options.common
@built(layers=LandscapeRequest, output=OutputRequest)
def command(session: Session, *, dry_run: bool, layers: LandscapeRequest, output: OutputRequest) -> None:
    """Lay DEM, VEGETATION and DENSITY on one square grid in metres.

    Writes elevation.tif, vegetation.tif and density.tif (classes of the paper) and says what was done to each
    layer.
    """
    from firebreak_gis.files import together
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import write_landscape
    from firebreak_gis.manifest import provenance, write_manifest

    inputs = input_files(layers.sources)
    require_outputs(output, tuple(OUTPUTS), inputs)
    foreseen = foresee(layers, output, session, tuple(OUTPUTS))
    if dry_run:
        rehearse(foreseen, session)
        return
    landscape = read_layers(layers, foreseen.survey, session, progress=session.progress)
    parameters = recorded()
    grid = Grid.of(landscape["burnable"])
    account = {
        "grid": grid.describe(),
        "alignment": landscape.attrs["alignment"],
        "warnings": landscape.attrs["warnings"],
    }
    with together(output.output, alone=True) as target:
        files = write_landscape(
            landscape,
            target,
            overwrite=output.overwrite,
            provenance=provenance(parameters),
            forbid=inputs,
            creation_options=output.creation_options,
        )
        files.append(
            write_manifest(
                target / "run.json",
                command="align",
                parameters=parameters,
                inputs=inputs,
                outputs=files,
                account=account,
                overwrite=output.overwrite,
            )
        )
    session.finish({"files": files, **account}, f"{grid.describe()}; {len(files)} files in {output.output}")
