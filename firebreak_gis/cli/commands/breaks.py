"""firebreak breaks: a priority raster and a budget in, a break mask out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import kinds, options
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest

if TYPE_CHECKING:
    from firebreak_gis.breaks import BudgetUnit


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
@built(output=OutputRequest)
def command(
    session: Session,
    priority: str,
    output: OutputRequest,
    polygons: str | None,
    budget: float,
    budget_unit: BudgetUnit,
    cost: str | None,
) -> None:
    """Cut the first cells of PRIORITY.

    A share cuts exactly round(budget x cells that can be cut); ties are cut by row, then column. A ranking that was
    made for another budget is warned of.
    """
    from firebreak_gis.breaks import Budget, break_polygons, select_breaks
    from firebreak_gis.files import require_writable, together
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.planes import value_plane
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, read_variable, write_raster
    from firebreak_gis.vectors import write_vector

    files = [output.output] + ([polygons] if polygons else [])
    inputs = files_behind([priority] + ([cost] if cost else []))
    for name in files:
        require_writable(name, overwrite=output.overwrite, forbid=inputs)
    ranking = read_variable(priority, "priority")
    prices = None
    if cost:
        grid = Grid.of(ranking)
        prices = value_plane(cost, grid, what="cost") * grid.cell_area_ha
    amount, made = Budget(budget, budget_unit), Budget.made_for(ranking)
    breaks = select_breaks(ranking, budget=amount, cost=prices)
    if made is not None and made != amount:
        session.warn(
            f"{priority} was ranked for a budget of {made}, and its method lays another pattern for {amount}; rank "
            f"with --budget {amount.amount:g} --budget-unit {amount.unit} for the breaks that firebreak plan makes"
        )
    with together(Path(output.output).parent):
        write_raster(
            output.output,
            breaks,
            overwrite=output.overwrite,
            provenance=provenance({"budget": budget, "unit": budget_unit}),
            creation_options=output.creation_options,
        )
        if polygons:
            write_vector(polygons, break_polygons(breaks, ranking), layer="breaks", overwrite=output.overwrite)
    count = breaks.attrs["cells_cut"]
    session.finish({"files": files, "cells_cut": count}, f"{count} cells cut; written to {', '.join(files)}")
