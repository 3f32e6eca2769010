"""firebreak network: an aligned landscape in, the spread network out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import options, parsing
from firebreak_gis.cli.layers import input_files, spread_params
from firebreak_gis.cli.session import Session


@click.command("network")
@click.argument("folder", type=click.Path(file_okay=False))
@options.output_file("Eight-band GeoTIFF")
@options.spread
@options.fitting("network")
@options.common
def command(session: Session, folder: str, output: str, **given: Any) -> None:
    """Build the spread network of the landscape in FOLDER (made by align).

    Band d holds the probability that fire spreads from the cell to its neighbour in direction d, in the order
    N NE E SE S SW W NW.
    """
    from firebreak_gis.files import require_writable
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.spread import spread_network

    inputs = files_behind([*map(str, Path(folder).glob("*.tif")), *input_files(given)])
    require_writable(output, overwrite=given["overwrite"], forbid=inputs)
    landscape = read_landscape_folder(folder)
    grid = Grid.of(landscape["burnable"])
    session.progress(0.2, "spread network")
    network = spread_network(landscape, model=given["model"], **spread_params(given, grid))
    session.progress(0.6, "writing")
    tags = provenance({k: given[k] for k in ("model", "model_params", "wind_speed", "wind_from", "moisture")})
    write_raster(
        output,
        network.to_dataset(),
        overwrite=given["overwrite"],
        provenance=tags,
        forbid=inputs,
        creation_options=parsing.pairs(given["creation_options"], "--co"),
    )
    session.finish(
        {"files": [output], "burnable_cells": network.n_burnable},
        f"{network.n_burnable} cells with fuel, mean edge probability "
        f"{network.probability[:, network.burnable].mean():.3f}; written to {output}",
    )
