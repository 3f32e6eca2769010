"""Every kind of output, written by its real writer, small; for the tests that break the writing.

`write(kind, folder, variant, overwrite)` writes into `folder`; the bytes depend on `variant` (0 or 1) alone.
"""

import functools
from pathlib import Path
from unittest import mock

import numpy as np

from tests.faults.state import content, put_back

VECTORS = ("gpkg", "geojson", "fgb", "kml", "gpx", "dxf", "zip", "shp")
SINGLE = ("text", "figure", "svg", "book", "account", "raster", "network", "layers", *VECTORS)
#: Kinds that take long.
LONG = ("landscape", "plan")
KINDS = (*SINGLE, *LONG)


def write(kind, folder, variant, overwrite):
    WRITERS[kind](Path(folder), variant, overwrite)


def prepare(kind, folder):
    """Do all that is done once: imports, compiling, data; leaves `folder` empty."""
    for variant in (0, 1):
        write(kind, folder, variant, overwrite=True)
    for entry in Path(folder).iterdir():
        entry.unlink()


def contents(kind, folder):
    """Bytes of all files of variants 0 and 1."""
    found = []
    for variant in (0, 1):
        put_back(folder, {})
        write(kind, folder, variant, overwrite=False)
        found.append(content(folder))
    return found


@functools.cache
def landscape(variant):
    from tests.conftest import _landscape

    return _landscape((9, 14), seed=variant)


@functools.cache
def polygons(variant):
    import geopandas as gpd
    import shapely

    corners = np.arange(40.0) * (variant + 1)
    shapes = shapely.box(corners, corners, corners + 1, corners + 1.5)
    return gpd.GeoDataFrame({"order": np.arange(40), "name": ["wall"] * 40}, geometry=shapes, crs="EPSG:32635")


@functools.cache
def small_plan(variant):
    from firebreak_gis.planning.pipeline import plan

    return plan(landscape(variant), budget=0.1, method="flammability", n_runs=8, seed=variant, threads=1)


@functools.cache
def drawing(variant):
    from firebreak_gis.report.figures import new_figure

    figure = new_figure(1.0, 1.0)
    figure.text(0.1, 0.5, f"plan {variant}")
    return figure


def _text(folder, variant, overwrite):
    from firebreak_gis.files import write_text

    write_text(folder / "out.csv", "cells,ha\n" + f"{variant},0.04\n" * 3000, overwrite=overwrite)


def _figure(folder, variant, overwrite, name="out.png"):
    from firebreak_gis.report.figures import save

    save(drawing(variant), folder / name, overwrite=overwrite)


def _svg(folder, variant, overwrite):
    _figure(folder, variant, overwrite, "out.svg")


@functools.cache
def pages(variant):
    from firebreak_gis.grid import Grid, parse_crs
    from firebreak_gis.report import mapbook
    from firebreak_gis.report.mapbook.atlas import Atlas

    lines = polygons(variant)[:1].assign(stage=1, length_m=5.0)
    lines = lines.set_geometry(lines.boundary)
    from affine import Affine

    grid = Grid((20, 20), Affine(10, 0, 0, 0, -10, 100), parse_crs("EPSG:32635"))
    return mapbook._drawn(Atlas(f"plan {variant}", lines, grid), mapbook.pages.sheet("a4", portrait=True), [0], None)


def _book(folder, variant, overwrite):
    from firebreak_gis.report import mapbook

    atlas = mock.Mock(lines={"length_m": [5.0]})
    with mock.patch.object(mapbook, "_drawn", return_value=pages(variant)):  # drawing takes a second
        mapbook.write_book(folder / "out.pdf", atlas, overwrite=overwrite)


def _account(folder, variant, overwrite):
    from firebreak_gis.files.outputs import Writing
    from firebreak_gis.manifest import account

    how = Writing(overwrite, parameters={"seed": variant})
    account("rank", lambda result: result).write({}, folder / "run.json", how)


def _raster(folder, variant, overwrite):
    from firebreak_gis.rasters import write_raster

    write_raster(folder / "out.tif", landscape(variant)["elevation"], overwrite=overwrite)


def _network(folder, variant, overwrite):
    from firebreak_gis.rasters import write_blocks

    network = small_plan(variant).network
    data = [(0, network.to_dataset())]
    write_blocks(folder / "out.tif", data, network.grid, overwrite=overwrite, provenance={"seed": variant})


def _vector(folder, variant, overwrite, suffix):
    from firebreak_gis.vectors import write_vector

    frame = polygons(variant)
    if suffix == ".gpx":
        frame = frame.set_geometry(frame.boundary)
    write_vector(folder / f"out{suffix}", frame, overwrite=overwrite)


def _layers(folder, variant, overwrite):
    from firebreak_gis.construction.writing import write_compartments

    table = polygons(variant).assign(expected_loss=np.linspace(0.0, 3.0, 40), compartment=np.arange(40))
    write_compartments(folder / "out.gpkg", table, overwrite=overwrite)


def _landscape_folder(folder, variant, overwrite):
    from firebreak_gis.landscape import write_landscape

    write_landscape(landscape(variant), folder, overwrite=overwrite)


def _plan(folder, variant, overwrite):
    from firebreak_gis.planning import outputs
    from firebreak_gis.report import overview
    from firebreak_gis.vectors import write_vector

    def one_layer(path, *_, **options):
        return write_vector(path, polygons(variant), **options)

    # Drawing the real figure takes a second, and files with several layers are a kind of their own.
    with (
        mock.patch.object(overview, "overview_figure", return_value=drawing(variant)),
        mock.patch.object(outputs, "write_segments", one_layer),
        mock.patch.object(outputs, "write_compartments", one_layer),
    ):
        outputs.write_plan(small_plan(variant), folder, parameters={"seed": variant}, overwrite=overwrite)


WRITERS = {
    "text": _text,
    "figure": _figure,
    "svg": _svg,
    "book": _book,
    "account": _account,
    "raster": _raster,
    "network": _network,
    **{name: functools.partial(_vector, suffix=f".{name}") for name in VECTORS},
    "layers": _layers,
    "landscape": _landscape_folder,
    "plan": _plan,
}
