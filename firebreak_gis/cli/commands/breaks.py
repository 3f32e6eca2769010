"""firebreak breaks: a priority raster and a budget in, a break mask out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, parsing
from firebreak_gis.cli.session import Session


@click.command("breaks")
@click.argument("priority", type=kinds.RASTER)
@options.output_file("Mask GeoTIFF")
@options.budget
@click.option("--cost", type=kinds.RASTER, metavar="RASTER", help="Cost per hectare, for --budget-unit cost.")
@click.option(
    "--polygons",
    type=kinds.NEW_VECTOR,
    metavar="FILE",
    help="Also write the outlines (.gpkg, .geojson, .fgb, .parquet).",
)
@options.common
def command(session: Session, priority: str, output: str, polygons: str | None, **given: Any) -> None:
    """Cut the first cells of PRIORITY.

    A share cuts exactly round(budget x cells that can be cut); ties are cut by row, then column.
    """
    from firebreak_gis.breaks import break_polygons, select_breaks
    from firebreak_gis.files import require_writable, together
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.planes import value_plane
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, read_variable, write_raster
    from firebreak_gis.vectors import write_vector

    files = [output] + ([polygons] if polygons else [])
    inputs = files_behind([priority] + ([given["cost"]] if given["cost"] else []))
    for name in files:
        require_writable(name, overwrite=given["overwrite"], forbid=inputs)
    ranking = read_variable(priority, "priority")
    cost = None
    if given["cost"]:
        grid = Grid.of(ranking)
        cost = value_plane(given["cost"], grid, what="cost") * grid.cell_area_ha
    breaks = select_breaks(ranking, budget=given["budget"], unit=given["budget_unit"], cost=cost)
    with together(Path(output).parent):
        write_raster(
            output,
            breaks,
            overwrite=given["overwrite"],
            provenance=provenance({"budget": given["budget"], "unit": given["budget_unit"]}),
            creation_options=parsing.pairs(given["creation_options"], "--co"),
        )
        if polygons:
            write_vector(polygons, break_polygons(breaks, ranking), layer="breaks", overwrite=given["overwrite"])
    count = breaks.attrs["cells_cut"]
    session.finish({"files": files, "cells_cut": count}, f"{count} cells cut; written to {', '.join(files)}")
