"""firebreak siting: an aligned landscape in, where a line can be held out."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, outputs, stakes_options
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest


@click.command("siting")
@click.argument("folder", type=kinds.LANDSCAPE_FOLDER)
@outputs.output_file("Suitability GeoTIFF")
@stakes_options.roads
@stakes_options.rivers
@stakes_options.siting_params
@options.common
@built(output=OutputRequest)
def command(
    session: Session,
    folder: str,
    output: OutputRequest,
    roads: str | None,
    rivers: str | None,
    siting_params: Mapping[str, Any],
) -> None:
    """Find where a line can be held in the landscape in FOLDER (made by align).

    The suitability, from 0 to 1, is what the best line is worth within reach (ridges, valley bottoms, roads, rivers,
    edges of the fuel), with the slope for machines and the way for crews from the next road. The weights have no source
    for your region: they are parameters. firebreak plan goes by it, see --siting there.
    """
    from firebreak_gis.files import require_writable
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.landscape.masks import mask_plane
    from firebreak_gis.landscape.siting import site
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, write_raster

    inputs = files_behind([*map(str, Path(folder).glob("*.tif")), *filter(None, (roads, rivers))])
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    landscape = read_landscape_folder(folder)
    grid = Grid.of(landscape["burnable"])
    session.progress(0.2, "factors")
    found = site(
        landscape,
        roads=mask_plane(roads, grid, what="roads", rule="touched") if roads else None,
        rivers=mask_plane(rivers, grid, what="rivers", rule="touched") if rivers else None,
        **siting_params,
    )
    factors = [name.removeprefix("suitability_") for name in map(str, found) if name != "suitability"]
    session.progress(0.7, "writing")
    write_raster(
        output.output,
        found["suitability"],
        overwrite=output.overwrite,
        forbid=inputs,
        provenance=provenance({"factors": factors, "siting_params": dict(siting_params)}),
        creation_options=output.creation_options,
    )
    mean = float(found["suitability"].where(landscape["burnable"]).mean())
    session.finish(
        {"files": [output.output], "factors": factors, "mean_suitability": round(mean, 4)},
        f"suitability from {', '.join(factors)}, mean {mean:.2f} where there is fuel; written to {output.output}",
    )
