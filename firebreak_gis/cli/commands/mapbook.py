"""firebreak mapbook: a plan in, a PDF for the crews out."""

from __future__ import annotations

from pathlib import Path

import click

from firebreak_gis.cli import filters, kinds, options, outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest


@click.command("mapbook")
@click.argument("run", metavar="DIR|SEGMENTS", type=kinds.FOLDER_OR_FILE)
@outputs.output_file("Map book", kinds.NEW_BOOK)
@click.option("--title", default="", metavar="TEXT", help="Title of the book [default: what the plan says of itself].")
@click.option("--date", default="", metavar="TEXT", help="Date of the data or the print, shown as it is given.")
@click.option("--roads", type=kinds.VECTOR, metavar="PATH", help="Roads to draw: lines or areas of any vector file.")
@click.option("--water", type=kinds.VECTOR, metavar="PATH", help="Rivers and lakes to draw: lines or areas.")
@click.option(
    "--dem",
    type=kinds.RASTER,
    metavar="RASTER",
    help="Elevation on any grid, beside segments alone; the folder of a plan has its own.",
)
@filters.where
@click.option(
    "--pages",
    type=kinds.COUNT,
    default=100,
    show_default=True,
    help="Segments that get a page, the first in order of construction; the list names all.",
)
@click.option(
    "--shortest",
    type=click.FloatRange(min=0.0),
    default=0.0,
    show_default=True,
    help="Segments shorter than this have no page of their own [m].",
)
@click.option(
    "--paper", type=click.Choice(["a4", "a3", "letter"]), default="a4", show_default=True, help="Size of the paper."
)
@click.option("--portrait", is_flag=True, help="Upright pages, the texts under the map.")
@options.common
@built(output=OutputRequest)
def command(
    session: Session,
    run: str,
    output: OutputRequest,
    title: str,
    date: str,
    roads: str | None,
    water: str | None,
    dem: str | None,
    pages: int,
    shortest: float,
    paper: str,
    portrait: bool,
) -> None:
    """Print a map book of DIR, which plan wrote, or of SEGMENTS, a GeoPackage of segments.

    An overview, a list of the segments, and a page for each: a map at a round scale with coordinates and north, its
    sizes, slope, cost and treatment, and what it is for.
    """
    from firebreak_gis.errors import ParameterError
    from firebreak_gis.files import require_writable
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.report.mapbook import write_book
    from firebreak_gis.report.mapbook.atlas import read_atlas

    place = Path(run)
    if dem is not None and place.is_dir():
        raise ParameterError(f"{run} holds the elevation of its plan; leave --dem out")
    inputs = [*(place.glob("*") if place.is_dir() else [run]), *files_behind(filter(None, (roads, water, dem)))]
    require_writable(output.output, overwrite=output.overwrite, forbid=[i for i in inputs if Path(i).suffix != ".pdf"])
    session.progress(0.0, "reading")
    atlas = read_atlas(run, title=title, date=date, dem=dem, roads=roads, water=water)
    own = write_book(
        output.output,
        atlas,
        paper=paper,
        portrait=portrait,
        most=pages,
        shortest=shortest,
        overwrite=output.overwrite,
        progress=part(session.progress, 0.05, 1.0),
    )
    count = len(atlas.lines)
    left = "" if own == count else f"; {count - own} others are in the list only (--pages, --shortest)"
    session.finish(
        {"files": [output.output], "segments": count, "segments_with_page": own},
        f"overview, list, and pages of {own} of {count} segments{left}; written to {output.output}",
    )
