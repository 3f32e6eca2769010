"""firebreak breaks: a priority raster and a budget in, a break mask out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import filters, kinds, options, outputs, stakes_options
from firebreak_gis.cli.layers import read_priority, tell
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.breaks import Budget, BudgetUnit

#: Place in the list of commands, which is the order of the work.
STEP = 5


@click.command("breaks")
@click.argument("priority", type=kinds.RASTER)
@outputs.output_file("Mask GeoTIFF")
@options.budget
@click.option(
    "--cost",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    help="Cost per hectare, for budgets of money: a raster, or polygons with --cost-field.",
)
@click.option("--cost-field", metavar="NAME", help="Column of the cost polygons.")
@stakes_options.cost_default
@filters.where
@filters.foreign
@click.option(
    "--polygons",
    type=kinds.NEW_AREAS,
    metavar="FILE",
    help="Also write the outlines: .gpkg, .shp, .zip (a zipped Shapefile), .geojson, .kml, .dxf, .fgb or .parquet.",
)
@options.common
@built(output=OutputRequest)
def command(
    session: Session,
    priority: str,
    output: OutputRequest,
    polygons: str | None,
    budget: float | Budget,
    budget_unit: BudgetUnit | None,
    cost: str | None,
    cost_field: str | None,
    cost_default: float | None,
    foreign: bool,
) -> None:
    """Cut the first cells of PRIORITY.

    A share cuts exactly round(budget x cells that can be cut); ties are cut by row, then column. A ranking that was
    made for another budget is warned of.
    """
    from firebreak_gis.breaks import Budget, select_breaks
    from firebreak_gis.construction.pieces import break_polygons
    from firebreak_gis.construction.writing import write_breaks
    from firebreak_gis.files import require_writable, together
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.vectors import require_writable_vector

    amount = Budget.of(budget, budget_unit)
    files = [output.output] + ([polygons] if polygons else [])
    inputs = files_behind([priority] + ([cost] if cost else []))
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    if polygons:
        require_writable_vector(polygons, overwrite=output.overwrite, forbid=inputs)
    ranking = read_priority(priority, session, foreign=foreign)
    prices = None
    if cost or cost_default is not None:
        ranking, prices = _priced(ranking, session, StakesRequest(cost, cost_field, cost_default))
    made = Budget.made_for(ranking)
    breaks = select_breaks(ranking, budget=amount, cost=prices)
    if made is not None and made != amount:
        session.warn(
            f"{priority} was ranked for a budget of {made}, and its method lays another pattern for {amount}; rank "
            f"with --budget {amount.amount:g} --budget-unit {amount.unit} for the breaks that firebreak plan makes"
        )
    with together(*(Path(name).parent for name in files)):
        write_raster(
            output.output,
            breaks,
            overwrite=output.overwrite,
            provenance=provenance({"budget": float(amount.amount), "unit": amount.unit}),
            creation_options=output.creation_options,
        )
        if polygons:
            write_breaks(polygons, break_polygons(breaks, ranking), overwrite=output.overwrite)
    count = breaks.attrs["cells_cut"]
    session.finish({"files": files, "cells_cut": count}, f"{count} cells cut; written to {', '.join(files)}")


def _priced(ranking: xr.DataArray, session: Session, request: StakesRequest) -> tuple[xr.DataArray, np.ndarray]:
    """Take cells whose cost nobody knows out of the ranking; the ranking and the cost of each cell."""
    import numpy as np

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.target_grid import Account

    account = Account()
    planes = request.read(Grid.of(ranking), fuel=ranking.to_numpy() > -np.inf, account=account)
    tell(account, session)
    if planes.unpriced is not None:
        ranking = ranking.where(~planes.unpriced, -np.inf)
    return ranking, np.asarray(planes.cost)
