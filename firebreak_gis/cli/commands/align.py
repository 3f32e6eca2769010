"""firebreak align: any layers in, one square grid in metres out."""

from __future__ import annotations

from typing import Any

import click

from firebreak_gis.cli import options, parsing
from firebreak_gis.cli.layers import input_files, read_layers, recorded
from firebreak_gis.cli.rehearsal import foresee, rehearse, require_outputs
from firebreak_gis.cli.session import Session

#: What the command writes into its folder.
OUTPUTS = {
    "elevation.tif": "Elevation on the common grid",
    "vegetation.tif": "Vegetation classes on the common grid",
    "density.tif": "Density classes on the common grid",
    "vegetation_effect.tif": "Effect of the vegetation, where the legend gives numbers in place of classes",
    "density_effect.tif": "Effect of the density, where the legend gives numbers in place of classes",
    "run.json": "Account of the run",
}


@click.command("align")
@options.inputs
@options.output_folder
@options.dry_run
@options.landscape
@options.common
def command(session: Session, **given: Any) -> None:
    """Lay DEM, VEGETATION and DENSITY on one square grid in metres.

    Writes elevation.tif, vegetation.tif and density.tif (classes of the paper) and says what was done to each
    layer.
    """
    from firebreak_gis.files import together
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import write_landscape
    from firebreak_gis.manifest import provenance, write_manifest

    inputs = input_files(given)
    require_outputs(given, tuple(OUTPUTS), inputs)
    foreseen = foresee(given, session, tuple(OUTPUTS))
    if given["dry_run"]:
        rehearse(foreseen, session)
        return
    landscape = read_layers(given, session, progress=session.progress)
    parameters = recorded(given)
    grid = Grid.of(landscape["burnable"])
    account = {
        "grid": grid.describe(),
        "alignment": landscape.attrs["alignment"],
        "warnings": landscape.attrs["warnings"],
    }
    with together(given["output"], alone=True) as target:
        files = write_landscape(
            landscape,
            target,
            overwrite=given["overwrite"],
            provenance=provenance(parameters),
            forbid=inputs,
            creation_options=parsing.pairs(given["creation_options"], "--co"),
        )
        files.append(
            write_manifest(
                target / "run.json",
                command="align",
                parameters=parameters,
                inputs=inputs,
                outputs=files,
                account=account,
                overwrite=given["overwrite"],
            )
        )
    session.finish({"files": files, **account}, f"{grid.describe()}; {len(files)} files in {given['output']}")
