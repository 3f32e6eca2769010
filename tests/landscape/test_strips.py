"""A landscape laid part by part is that of the whole, values, words and refusals."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import rasterio
from affine import Affine
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.cli.group import firebreak
from firebreak_gis.errors import FirebreakError, InputError, LegendError
from firebreak_gis.files.scratch import let_go, on_disk
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_surveyed, survey, write_landscape
from firebreak_gis.landscape.grid_part import GridPart
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.strips import read_by_parts, windows
from firebreak_gis.rasters.blocks import rows_of
from firebreak_gis.rasters.nodata import Extremes, undeclared_nodata

UTM = "EPSG:32635"


def write(path, values, transform, *, crs=UTM, nodata=None, **tags):
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        height=values.shape[0],
        width=values.shape[1],
        count=1,
        dtype=values.dtype,
        crs=crs,
        transform=transform,
        nodata=nodata,
    ) as target:
        target.write(values, 1)
        if "scales" in tags:
            target.scales = (tags["scales"],)
        if "units" in tags:
            target.units = (tags["units"],)
    return str(path)


def layers(
    folder, *, seed=0, dem_nodata=-9999.0, feet=False, scale=None, finer=1, turned=False, degrees=False, cover=False
):
    random = np.random.default_rng(seed)
    rows, cols = 61, 83
    y, x = np.mgrid[:rows, :cols]
    dem = (500 + 3 * y + 2 * np.sin(x / 5) + random.random((rows, cols))).astype(np.float32)
    dem[5:9, 10:14] = -9999
    dem[40:42, 70:] = -2500 if feet else -700  # below the sea
    place = Affine(25.0, 0, 600_000, 0, -25.0, 4_000_000)
    if turned:
        place = place @ Affine.rotation(17)
    crs = UTM
    if degrees:
        place, crs = Affine(0.0003, 0, 27.9, 0, -0.00025, 36.2), "EPSG:4326"
    more = {"units": "ft"} if feet else {}
    if scale:
        dem, more = (dem / scale).astype(np.float32), {"scales": scale}
        dem[5:9, 10:14] = -9999
    fine = place @ Affine.scale(1 / finer)
    vegetation = random.integers(0, 4, (rows * finer, cols * finer)).astype(np.uint8)
    density = np.where(vegetation > 0, random.integers(1, 4, vegetation.shape), 0).astype(np.uint8)
    if cover:
        density = random.integers(0, 101, vegetation.shape).astype(np.uint8)
        density[random.random(density.shape) < 0.1] = 254
    return [
        write(folder / "dem.tif", dem, place, crs=crs, nodata=dem_nodata, **more),
        write(folder / "vegetation.tif", vegetation, fine, crs=crs),
        write(folder / "density.tif", density, fine, crs=crs),
    ]


CASES = {
    "same grid": ({}, {}),
    "coarser": ({"finer": 4}, {"resolution": 50.0}),
    "finer": ({}, {"resolution": 7.0}),
    "turned": ({"turned": True}, {"resolution": 20.0}),
    "degrees": ({"degrees": True, "finer": 3}, {"resolution": 30.0}),
    "undeclared": ({"dem_nodata": None}, {"resolution": 33.0}),
    "feet": ({"feet": True}, {"resolution": 33.0}),
    "scaled": ({"scale": 0.5, "dem_nodata": None}, {}),
    "cover": ({"cover": True, "finer": 2}, {"resolution": 30.0, "density_legend": "tree_cover_density"}),
    "word": ({}, {"density": "normal"}),
    "continuity": ({}, {"density": "continuity", "resolution": 20.0}),
}


def asked(files, **wishes):
    dem, vegetation, density = files
    return LandscapeRequest(dem, vegetation, **{"density": density, **wishes})


def both(request, folder, cells):
    """The landscape as a whole and by parts; or what each refuses."""
    results = []
    for read in (
        lambda found: read_surveyed(request, found),
        lambda found: read_by_parts(request, found, folder, cells=cells),
    ):
        try:
            results.append(read(survey(request)))
        except FirebreakError as error:
            results.append((type(error), str(error)))
    return results


@pytest.mark.parametrize("cells", [97, 1500])
@pytest.mark.parametrize("case", CASES)
def test_parts_are_those_of_the_whole(case, cells, tmp_path, monkeypatch):
    monkeypatch.setattr("firebreak_gis.landscape.alignment.BLOCK", 700)
    monkeypatch.setattr("firebreak_gis.landscape.strips.SOURCE_CELLS", 900)
    monkeypatch.setattr("firebreak_gis.landscape.strips._LEAST", 50)
    made, wishes = CASES[case]
    request = asked(layers(tmp_path, **made), **wishes)
    whole, parts = both(request, tmp_path, cells)
    assert not isinstance(whole, tuple), whole
    assert sorted(whole.data_vars) == sorted(parts.data_vars)
    for name in whole.data_vars:
        assert whole[name].values.tobytes() == parts[name].values.tobytes(), name
        assert whole[name].attrs.keys() == parts[name].attrs.keys()
    assert whole.attrs == parts.attrs
    assert whole.coords.equals(parts.coords)


def spoiled(case, folder):
    files = layers(folder, dem_nodata=None if case == "strict" else -9999.0)
    if case == "codes":
        with rasterio.open(files[1], "r+") as target:
            values = target.read(1)
            values[3, 4], values[50, 60], values[51, 60] = 77, 77, 99
            target.write(values, 1)
    if case == "void":
        with rasterio.open(files[0], "r+") as target:
            values = np.where(target.read(1) < -600, 600, target.read(1))
            values[:, :9] = 1
            target.write(values, 1)
    if case == "high":
        with rasterio.open(files[0], "r+") as target:
            values = target.read(1)
            values[60, 82] = 9500
            target.write(values, 1)
    if case == "empty":
        with rasterio.open(files[1], "r+") as target:
            target.write(np.zeros((1, *target.shape), np.uint8))
    return files


@pytest.mark.parametrize("case", ["codes", "void", "high", "empty", "strict"])
def test_what_the_whole_refuses_parts_refuse_alike(case, tmp_path, monkeypatch):
    monkeypatch.setattr("firebreak_gis.landscape.alignment.BLOCK", 700)
    request = asked(spoiled(case, tmp_path), strict=case == "strict", resolution=30.0)
    whole, parts = both(request, tmp_path, 400)
    assert whole == parts
    assert whole[0] is (LegendError if case == "codes" else InputError)


def test_unknown_codes_taken_as_no_fuel_are_counted_over_all_parts(tmp_path):
    request = asked(spoiled("codes", tmp_path), unknown="nonburnable")
    whole, parts = both(request, tmp_path, 400)
    assert whole.attrs == parts.attrs
    assert "77 (0.125 ha), 99 (0.0625 ha)" in " ".join(whole.attrs["warnings"])


def test_parts_cover_the_grid_once_and_are_small(tmp_path):
    found = survey(asked(layers(tmp_path, finer=4), resolution=50.0))
    counted = np.zeros(found.grid.shape, int)
    for row, col, rows, cols in windows(found, 300):
        assert rows * cols <= 300
        counted[row : row + rows, col : col + cols] += 1
    assert (counted == 1).all()


@settings(max_examples=60, deadline=None, derandomize=True)
@given(
    values=st.lists(st.sampled_from([-9999.0, -32768.0, 1e20, -3.4e38, 0.0, 1.0, 2.5, 300.0, 65535.0]), max_size=12),
    cut=st.integers(0, 12),
)
def test_extremes_tell_what_is_undeclared_as_all_values_do(values, cut):
    array = np.array(values, np.float32)
    found = Extremes()
    for part in (array[:cut], array[cut:]):
        found.add(part, np.ones(part.size, bool))
    assert found.undeclared() == undeclared_nodata(array, np.ones(array.size, bool))


def test_a_part_of_a_grid_lies_as_the_whole_does():
    grid = Grid((50, 60), Affine(0.1 + 1e-9, 0, 1 / 3, 0, -0.1 - 1e-9, 7 / 9))
    part = GridPart(grid, (13, 17, 20, 30))
    assert (part.x == grid.x[17:47]).all()
    assert (part.y == grid.y[13:33]).all()
    col, row = grid.position(grid.x[17:47], grid.y[13:43])
    assert (part.position(grid.x[17:47], grid.y[13:43])[0] == col - 17).all()
    assert (part.position(grid.x[17:47], grid.y[13:43])[1] == row - 13).all()
    assert part.transform.almost_equals(grid.transform @ Affine.translation(17, 13))


def test_arrays_on_the_disk_leave_nothing_behind(tmp_path):
    array = on_disk(tmp_path, (30, 40), np.float32)
    assert not array.any()
    array[:] = 3
    assert array.sum() == 3600
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(sys.platform != "linux", reason="only there /proc tells what is resident")
def test_what_is_let_go_keeps_its_values_and_no_memory(tmp_path):
    def files():
        return int(re.search(r"RssFile:\s+(\d+) kB", Path("/proc/self/status").read_text())[1])

    array = on_disk(tmp_path, (2000, 4000), np.float32)
    array[:] = np.arange(4000, dtype=np.float32)
    held = files()
    let_go(array)
    assert files() < held - 25_000
    assert array[1234, 4:7].tolist() == [4.0, 5.0, 6.0]
    let_go(np.zeros(3))  # in memory there is nothing to let go


def test_align_by_parts_writes_what_align_writes(tmp_path, monkeypatch):
    files = layers(tmp_path)
    run = CliRunner()
    assert run.invoke(firebreak, ["align", *files, "-o", str(tmp_path / "whole"), "--quiet"]).exit_code == 0
    monkeypatch.setattr("firebreak_gis.landscape.surveying.BLOCK_CELLS", 900)
    monkeypatch.setitem(rows_of.__kwdefaults__, "cells", 900)
    monkeypatch.setitem(read_by_parts.__kwdefaults__, "cells", 900)
    done = run.invoke(firebreak, ["align", *files, "-o", str(tmp_path / "parts"), "--quiet"])
    assert done.exit_code == 0, done.output
    for name in ("elevation", "vegetation", "density"):
        with (
            rasterio.open(tmp_path / f"whole/{name}.tif") as one,
            rasterio.open(tmp_path / f"parts/{name}.tif") as other,
        ):
            assert (one.read() == other.read()).all()
            assert one.tags() == other.tags()
            assert one.profile == other.profile


def test_a_landscape_is_written_by_rows_as_in_one(tmp_path, monkeypatch):
    request = asked(layers(tmp_path))
    landscape = read_surveyed(request, survey(request))
    write_landscape(landscape, tmp_path / "whole")
    monkeypatch.setitem(rows_of.__kwdefaults__, "cells", 900)
    monkeypatch.setattr("firebreak_gis.rasters.blocks.ROWS", 16)
    write_landscape(landscape, tmp_path / "rows")
    for name in ("elevation", "vegetation", "density"):
        with (
            rasterio.open(tmp_path / f"whole/{name}.tif") as one,
            rasterio.open(tmp_path / f"rows/{name}.tif") as other,
        ):
            assert (one.read() == other.read()).all()
            assert one.tags() == other.tags()


def test_fewer_bytes_are_asked_for_a_landscape_laid_by_parts(tmp_path):
    found = survey(asked(layers(tmp_path)))
    assert found.memory_by_parts == found.memory
    large = replace(found, grid=Grid((40_000, 40_000), found.grid.transform, found.grid.crs))
    assert large.memory_by_parts < 1e9 < large.memory
