"""firebreak segments: a network and a break mask in, segments to build out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from firebreak_gis.cli import filters, kinds, options, outputs, stakes_options
from firebreak_gis.cli.layers import read_breaks, read_priority, read_stakes
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import InputError
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest

if TYPE_CHECKING:
    from firebreak_gis.construction.writing import What

#: Place in the list of commands, which is the order of the work.
STEP = 6


@click.command("segments")
@click.argument("network", type=kinds.RASTER)
@click.argument("mask", metavar="BREAKS", type=kinds.RASTER_OR_VECTOR)
@outputs.output_file(
    "GeoPackage with the layers lines and polygons; or .shp, .zip, .geojson, .kml, .gpx, .dxf, .fgb, .parquet with one "
    "of them",
    kinds.NEW_VECTOR,
)
@outputs.what
@click.option(
    "--compartments",
    type=kinds.NEW_AREAS,
    metavar="FILE",
    help="Also write the compartments between the breaks, in any of these formats but .gpx.",
)
@click.option(
    "--priority",
    type=kinds.RASTER,
    metavar="RASTER",
    help="Ranking; decides between segments that save equally much.",
)
@filters.foreign
@click.option("--dem", type=kinds.RASTER, metavar="RASTER", help="Elevation on any grid, for the slopes [m].")
@options.ignition_map
@stakes_options.stakes
@filters.where
@options.common
@built(output=OutputRequest, at_stake=StakesRequest)
def command(
    session: Session,
    network: str,
    mask: str,
    output: OutputRequest,
    at_stake: StakesRequest,
    priority: str | None,
    dem: str | None,
    ignitions: str | None,
    foreign: bool,
    compartments: str | None,
    what: What | None,
) -> None:
    """Take BREAKS on NETWORK apart into segments to build, best first.

    Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, mean slope
    and cost, and the share of all that the breaks save that it adds.
    """
    from firebreak_gis.construction.compartments import compartments_of
    from firebreak_gis.construction.segments import segments_of
    from firebreak_gis.construction.writing import require_what, write_compartments, write_segments
    from firebreak_gis.files import together
    from firebreak_gis.landscape.planes import elevation_plane
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.spread.raster import read_network
    from firebreak_gis.vectors import require_writable_vector

    require_what(output.output, what)
    inputs = files_behind([network, mask, *filter(None, (priority, dem, ignitions)), *at_stake.sources])
    files = [output.output] + ([compartments] if compartments else [])
    for name in files:
        require_writable_vector(name, overwrite=output.overwrite, forbid=inputs)
    untouched = read_network(network)
    planes, _ = read_stakes(at_stake, session, grid=untouched.grid, fuel=untouched.burnable, ignitions=ignitions)
    barred, placed = planes.on(untouched)
    cut = read_breaks(mask, untouched.grid, session)
    if planes.unpriced is not None and (unknown := int((planes.unpriced & cut).sum())):
        raise InputError(
            f"the cost of {unknown} of the cells cut is not known; say what cutting a hectare costs (--cost-default)"
        )
    session.progress(0.2, "segments")
    lines, polygons = segments_of(
        barred,
        cut,
        priority=read_priority(priority, session, foreign=foreign) if priority else None,
        elevation=elevation_plane(dem, barred.grid) if dem else None,
        cost=placed.cost,
        value=placed.value,
        ignition=placed.ignition,
    )
    session.progress(0.7, "compartments")
    _, table = compartments_of(barred, cut, value=placed.value, ignition=placed.ignition)
    with together(*(Path(name).parent for name in files)):
        write_segments(output.output, lines, polygons, what=what, overwrite=output.overwrite, forbid=inputs)
        if compartments:
            write_compartments(compartments, table, overwrite=output.overwrite, forbid=inputs)
    length = float(lines["length_m"].sum()) / 1000.0
    stages = int(polygons["stage"].max()) if len(polygons) else 0
    session.finish(
        {"files": files, "segments": len(polygons), "stages": stages, "km": length, "compartments": len(table)},
        f"{len(polygons)} segments in {stages} stages, {length:,.1f} km, between {len(table)} compartments; "
        f"written to {', '.join(files)}",
    )
