"""firebreak export: segments, breaks or compartments of a plan in, the same in the format of a crew out."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import kinds, options, outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest

if TYPE_CHECKING:
    from firebreak_gis.construction.writing import What


@click.command("export")
@click.argument("made", metavar="SEGMENTS", type=kinds.GEOPACKAGE)
@outputs.output_file("File", kinds.NEW_VECTOR)
@outputs.what
@options.common
@built(output=OutputRequest)
def command(session: Session, made: str, output: OutputRequest, what: What | None) -> None:
    """Write SEGMENTS, the segments.gpkg of a plan, in the format of a crew; or its breaks.gpkg or compartments.gpkg.

    The extension chooses the format: .shp or .zip (Shapefile), .geojson, .kml (Google Earth, phones), .gpx (GPS
    devices, lines only), .dxf (drawings), .fgb, .parquet or .gpkg.
    """
    from firebreak_gis.construction.writing import KINDS, read_written, require_what, write_layers_of
    from firebreak_gis.vectors import require_writable_vector

    require_writable_vector(output.output, overwrite=output.overwrite, forbid=[made])
    if what is not None:
        require_what(output.output, what)
    frames = read_written(made)
    session.progress(0.3, "writing")
    write_layers_of(output.output, frames, what=what, overwrite=output.overwrite, forbid=[made])
    name: str = what or next(iter(frames))
    session.finish(
        {"files": [output.output], "layer": name, "features": len(frames[name]), "kind": KINDS[name]},
        f"{len(frames[name])} features written to {output.output}",
    )
