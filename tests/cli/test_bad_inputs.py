"""Every bad input as one table: how it is made, what is called, the exit code, and what the message must say.

Codes: 0 mended or gone on with, and said so; 2 usage; 3 input refused; 4 output; 5 resources.
"""

import json
import traceback
import warnings
import zipfile

import numpy as np
import pytest
import rasterio
import rasterio.shutil
from affine import Affine
from click.testing import CliRunner
from rasterio.control import GroundControlPoint
from rasterio.crs import CRS
from rasterio.errors import NotGeoreferencedWarning
from rasterio.rpc import RPC

from firebreak_gis.cli import firebreak
from tests.places import NORTH_WEST, patches, relief, square, three, write

ROWS, COLS = 24, 31
DEGREES = Affine(0.0002, 0, 27.961, 0, -0.0002, 36.1420)
TURNED = Affine.translation(NORTH_WEST[0], NORTH_WEST[1] - 250) @ Affine.rotation(30) @ Affine.scale(20, -20)


def shifted(cols, cell=20.0):
    return square(cell, (NORTH_WEST[0] + 20 * cols, NORTH_WEST[1]))


# Makers: each changes one of the three good layers in a folder; `f` is the folder.


def dem(values=None, **more):
    return lambda f: write(f / "dem.tif", relief(ROWS, COLS) if values is None else values(), **more)


def vegetation(values=None, **more):
    return lambda f: write(
        f / "vegetation.tif", patches(ROWS, COLS, [0, 1, 2, 3]) if values is None else values(), **more
    )


def density(values, **more):
    return lambda f: write(f / "density.tif", values(), **more)


def spoilt(*changes):
    """Hills with single cells changed: (row, column, value)."""

    def values():
        hills = relief(ROWS, COLS).copy()
        for row, col, value in changes:
            hills[row, col] = value
        return hills

    return values


def filled(value, dtype):
    return lambda: np.full((ROWS, COLS), value, dtype)


def located(**how):
    def make(f):
        profile = {"driver": "GTiff", "height": ROWS, "width": COLS, "count": 1, "dtype": "float32"}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", NotGeoreferencedWarning)
            with rasterio.open(f / "dem.tif", "w", **profile) as target:
                target.write(relief(ROWS, COLS), 1)
                if "gcps" in how:
                    target.gcps = (how["gcps"], CRS.from_epsg(32635))
                if "rpcs" in how:
                    target.rpcs = how["rpcs"]

    return make


GCPS = [GroundControlPoint(r, c, NORTH_WEST[0] + 20 * c, NORTH_WEST[1] - 20 * r) for r, c in ((0, 0), (0, 30), (23, 0))]
RPCS = RPC(
    height_off=100,
    height_scale=100,
    lat_off=36,
    lat_scale=1,
    line_off=12,
    line_scale=12,
    long_off=28,
    long_scale=1,
    samp_off=15,
    samp_scale=15,
    line_den_coeff=[1.0] + [0.0] * 19,
    line_num_coeff=[0.0] * 20,
    samp_den_coeff=[1.0] + [0.0] * 19,
    samp_num_coeff=[0.0] * 20,
)


def own(name, content):
    return lambda f: (f / name).write_bytes(content)


def cut_off(f):
    path = write(f / "dem.tif", relief(ROWS, COLS))
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def folder_in_place(f):
    (f / "dem.tif").unlink()
    (f / "dem.tif").mkdir()


def virtual(name):
    def make(f):
        rasterio.shutil.copy(f / "dem.tif", f / "d.vrt", driver="VRT")
        (f / name).write_bytes((f / "d.vrt").read_bytes())

    return make


def archive(f):
    with zipfile.ZipFile(f / "dem.zip", "w") as target:
        target.write(f / "dem.tif", "dem.tif")


def several(f):
    """A file of two pages is a file of two rasters."""
    write(f / "dem.tif", relief(ROWS, COLS))
    with rasterio.open(f / "dem.tif", "r+", APPEND_SUBDATASET="YES"):
        pass
    rasterio.shutil.copy(write(f / "x.tif", relief(ROWS, COLS)), f / "dem.tif", driver="GTiff", APPEND_SUBDATASET="YES")


def bomb(f):
    """Two files of a few hundred kB that say they hold 810,000 million cells."""
    for name in ("dem.tif", "vegetation.tif"):
        with rasterio.open(
            f / name,
            "w",
            driver="GTiff",
            height=900_000,
            width=900_000,
            count=1,
            dtype="float32",
            crs="EPSG:32635",
            transform=square(0.5),
            tiled=True,
            blockxsize=4096,
            blockysize=4096,
            compress="deflate",
            sparse_ok=True,
        ):
            pass


LONG_NAME = "a b " + "\N{GREEK SMALL LETTER ALPHA}" * 90 + ".tif"
PICTURE = {"photometric": "RGB"}
FUEL = patches(ROWS, COLS, [0, 1, 2, 3])
LAYERS = ["dem.tif", "vegetation.tif", "density.tif"]
PLAIN = ["dem.tif", "vegetation.tif", "normal"]

#: Row: maker, words after `firebreak align`, exit code, parts of what is said.
INPUTS = {
    "no CRS": (dem(crs=None), LAYERS, 3, ["no coordinate reference system", "gdal_translate -a_srs"]),
    "no transform": (located(), LAYERS, 3, ["does not say where its cells lie", "-a_ullr"]),
    "no CRS, told": (dem(crs=None), [*LAYERS, "--src-crs", "dem=EPSG:32635"], 0, ["elevation: copied"]),
    "a wrong CRS, told": (dem(crs="EPSG:4326"), [*LAYERS, "--src-crs", "EPSG:32635"], 0, ["elevation: copied"]),
    "control points only": (located(gcps=GCPS), LAYERS, 3, ["ground control points", "gdalwarp -t_srs"]),
    "camera model only": (located(rpcs=RPCS), LAYERS, 3, ["camera model", "gdalwarp -rpc"]),
    "degrees": (dem(transform=DEGREES, crs="EPSG:4326"), LAYERS, 0, ["EPSG:32635", "is in degrees", "bilinear"]),
    "Web Mercator": (
        dem(transform=Affine(25, 0, 3_112_600, 0, -25, 4_320_000), crs="EPSG:3857"),
        LAYERS,
        0,
        ["EPSG:32635", "Mercator, whose metres are not true"],
    ),
    "Web Mercator wished for": (None, [*LAYERS, "--dst-crs", "EPSG:3857"], 3, ["Mercator", "EPSG:32635"]),
    "degrees wished for": (None, [*LAYERS, "--dst-crs", "EPSG:4326"], 3, ["in degrees", "EPSG:32635"]),
    "metres called degrees": (dem(crs="EPSG:4326"), LAYERS, 3, ["claims degrees", "coordinates are x 586440"]),
    "degrees called metres": (dem(transform=DEGREES), LAYERS, 3, ["look like degrees", "-a_srs"]),
    "other CRS": (
        vegetation(transform=DEGREES, crs="EPSG:4326", nodata=255),
        LAYERS,
        0,
        ["vegetation: resampled by nearest"],
    ),
    "other resolution": (vegetation(transform=square(33.0)), LAYERS, 0, ["vegetation: resampled by nearest"]),
    "much finer": (
        vegetation(lambda: patches(240, 310, [0, 1, 2, 3], size=30), transform=square(2.0)),
        LAYERS,
        0,
        ["vegetation: resampled by mode"],
    ),
    "rotated": (dem(transform=TURNED), LAYERS, 0, ["elevation: resampled", "rotated"]),
    "south-up": (dem(transform=Affine(20, 0, NORTH_WEST[0], 0, 20, NORTH_WEST[1] - 480)), LAYERS, 0, ["copied"]),
    "not square": (dem(transform=Affine(19.7, 0, NORTH_WEST[0], 0, -20.3, NORTH_WEST[1])), LAYERS, 0, ["cell: 20 m"]),
    "feet across": (
        lambda f: [
            write(f / name, values, crs="EPSG:2227", transform=Affine(60, 0, 6_000_000, 0, -60, 2_100_000))
            for name, values in (("dem.tif", relief(ROWS, COLS)), ("vegetation.tif", FUEL))
        ],
        PLAIN,
        0,
        ["US survey foot", "EPSG:32610"],
    ),
    "feet up": (dem(units="ft"), LAYERS, 0, ["multiplied by 0.3048"]),
    "scale and offset": (
        lambda f: write(f / "dem.tif", (relief(ROWS, COLS) * 10).astype("int16"), scale=(0.1, 5.0)),
        LAYERS,
        0,
        ["multiplied by 0.1 and 5 was added"],
    ),
    "off by less than a thousandth": (
        vegetation(transform=shifted(0.0005), nodata=255),
        LAYERS,
        0,
        ["vegetation: copied"],
    ),
    "elsewhere": (vegetation(transform=shifted(9_000)), LAYERS, 3, ["do not overlap", "longitude", "elevation:"]),
    "hardly overlapping": (vegetation(transform=shifted(30)), LAYERS, 3, ["overlap on 3.2%", "elevation: x 586440"]),
    "partly overlapping": (vegetation(transform=shifted(10)), LAYERS, 0, ["overlap only in part", "68%"]),
    "partly overlapping, strict": (
        vegetation(transform=shifted(10)),
        [*LAYERS, "--strict"],
        3,
        ["overlap only in part", "--strict"],
    ),
    "all no data": (dem(filled(-9999, "float32"), nodata=-9999), LAYERS, 3, ["(elevation) holds no data"]),
    "no fuel anywhere": (vegetation(filled(0, "uint8")), LAYERS, 3, ["no cell can burn"]),
    "two rows": (
        lambda f: [write(f / n, v[:2]) for n, v in (("dem.tif", relief(ROWS, COLS)), ("vegetation.tif", FUEL))],
        PLAIN,
        3,
        ["2 x 31 cells", "at least 3 x 3"],
    ),
    "undeclared -9999": (dem(spoilt((1, 1, -9999))), LAYERS, 0, ["-9999 is not declared", "taken as no data"]),
    "undeclared -3.4e38": (dem(spoilt((1, 1, -3.4028235e38))), LAYERS, 0, ["is not declared", "taken as no data"]),
    "undeclared 32767": (dem(spoilt((1, 1, 32767))), LAYERS, 0, ["32767 is not declared"]),
    "undeclared, strict": (
        dem(spoilt((1, 1, -9999))),
        [*LAYERS, "--strict"],
        3,
        ["-9999", "gdal_edit.py -a_nodata", "--src-nodata"],
    ),
    "undeclared, told": (
        dem(spoilt((1, 1, -9999))),
        [*LAYERS, "--strict", "--src-nodata", "dem=-9999"],
        3,
        ["1 cells with fuel have no elevation"],
    ),
    "no data beyond the type": (
        None,
        [*LAYERS, "--src-nodata", "vegetation=-9999"],
        0,
        ["-9999 does not fit the data type uint8", "ignored"],
    ),
    "NaN": (dem(spoilt((5, 3, np.nan))), LAYERS, 0, ["1 cells with fuel have no elevation"]),
    "infinite": (dem(spoilt((5, 5, np.inf))), LAYERS, 3, ["infinite values in 1 cells"]),
    "unknown codes": (
        vegetation(lambda: np.where(FUEL == 2, 34, FUEL).astype("uint8")),
        LAYERS,
        3,
        ["34 (", "ha)", "--unknown"],
    ),
    "unknown codes allowed": (
        vegetation(lambda: np.where(FUEL == 2, 34, FUEL).astype("uint8")),
        [*LAYERS, "--unknown", "nonburnable"],
        0,
        ["34 (", "taken as land without fuel"],
    ),
    "fractional classes": (vegetation(lambda: FUEL * np.float32(0.75)), LAYERS, 3, ["fractions", "looks resampled"]),
    "whole floats": (vegetation(lambda: FUEL.astype("float64")), LAYERS, 0, ["copied"]),
    "negative classes": (
        vegetation(lambda: np.where(FUEL == 0, np.int16(-9999), FUEL.astype("int16"))),
        LAYERS,
        3,
        ["negative codes -9999", "--src-nodata vegetation=-9999"],
    ),
    "cover in percent as classes": (
        density(lambda: np.linspace(0, 100, ROWS * COLS).reshape(ROWS, COLS).astype("uint8")),
        LAYERS,
        3,
        ["does not list", "canopy_cover"],
    ),
    "cover as a fraction": (
        density(lambda: np.linspace(0, 1, ROWS * COLS).reshape(ROWS, COLS).astype("float32")),
        [*LAYERS, "--density-legend", "canopy_cover"],
        3,
        ["looks like a fraction"],
    ),
    "cover in percent by its legend": (
        density(lambda: np.linspace(0, 100, ROWS * COLS).reshape(ROWS, COLS).astype("float32")),
        [*LAYERS, "--density-legend", "canopy_cover"],
        0,
        ["density: copied"],
    ),
    "no density": (None, LAYERS[:2], 3, ["no density", "continuity"]),
    "picture of a map": (
        lambda f: write(f / "vegetation.tif", np.stack([FUEL] * 3), **PICTURE),
        LAYERS,
        3,
        ["colour picture of a map"],
    ),
    "several bands": (
        lambda f: write(f / "vegetation.tif", np.stack([FUEL] * 2)),
        LAYERS,
        3,
        ["has 2 bands", "--bidx"],
    ),
    "several bands, one chosen": (
        lambda f: write(f / "vegetation.tif", np.stack([FUEL] * 2)),
        [*LAYERS, "--bidx", "vegetation=2"],
        0,
        ["copied"],
    ),
    "colour table as a DEM": (
        lambda f: colour_table(write(f / "dem.tif", FUEL)),
        LAYERS,
        3,
        ["colour table", "not elevations"],
    ),
    "complex": (dem(lambda: relief(ROWS, COLS).astype("complex64")), LAYERS, 3, ["complex64", "real numbers"]),
    "several rasters in a file": (several, LAYERS, 3, ["holds several rasters", "GTIFF_DIR:1:"]),
    "cut off": (cut_off, LAYERS, 3, ["damaged or cut off"]),
    "zero bytes": (own("dem.tif", b""), LAYERS, 3, ["empty (0 bytes)"]),
    "a text": (own("dem.tif", b"hello\n"), LAYERS, 3, ["cannot be read as a raster"]),
    "a page of the net": (own("dem.tif", b"<!DOCTYPE html><html>log in"), LAYERS, 3, ["XML or HTML text", "log in"]),
    "a pointer of Git LFS": (
        own("dem.tif", b"version https://git-lfs.github.com/spec/v1\n"),
        LAYERS,
        3,
        ["git lfs pull"],
    ),
    "a folder": (folder_in_place, LAYERS, 3, ["is a folder"]),
    "missing": (None, ["nowhere.tif", *LAYERS[1:]], 3, ["nowhere.tif does not exist"]),
    "a bomb": (bomb, PLAIN, 4, ["the work takes", "or more; free some space"]),
    "larger than allowed": (None, [*LAYERS, "--max-memory", "50MB"], 5, ["--max-memory"]),
    "VRT under another name": (virtual("dem.tif"), LAYERS, 3, ["name it .vrt"]),
    "VRT": (virtual("e.vrt"), ["e.vrt", *LAYERS[1:]], 0, ["elevation: copied"]),
    "address": (None, ["https://example.org/dem.tif", *LAYERS[1:]], 3, ["network or archive", "--remote"]),
    "archive": (archive, ["/vsizip/dem.zip/dem.tif", *LAYERS[1:]], 3, ["network or archive", "--remote"]),
    "archive allowed": (archive, ["/vsizip/dem.zip/dem.tif", *LAYERS[1:], "--remote"], 0, ["elevation: copied"]),
    "legend missing": (None, [*LAYERS, "--legend", "korine"], 3, ["no legend 'korine'", "corine"]),
    "legend faulty": (
        own("own.csv", b"code,vegetation,density\n1,pine,dense\n"),
        [*LAYERS, "--legend", "own.csv"],
        3,
        ["line 2", "'pine'"],
    ),
    "spaces, unicode, long names": (
        lambda f: (f / LONG_NAME).write_bytes((f / "dem.tif").read_bytes()),
        [LONG_NAME, *LAYERS[1:]],
        0,
        ["elevation: copied"],
    ),
}


def colour_table(path):
    with rasterio.open(path, "r+") as target:
        target.write_colormap(1, {0: (255, 0, 0), 1: (0, 255, 0)})


def call(folder, words, monkeypatch, name="align"):
    monkeypatch.chdir(folder)
    return CliRunner().invoke(firebreak, [name, *map(str, words)])


def said(outcome, code, parts):
    """The exit code, all parts in the text, and never a traceback."""
    told = outcome.output + (
        "" if outcome.exc_info is None else "".join(traceback.format_exception(*outcome.exc_info)[-1:])
    )
    assert outcome.exit_code == code, told
    for part in parts:
        assert part in outcome.output, (part, outcome.output)
    assert "Traceback" not in outcome.output
    assert "bug" not in outcome.output


@pytest.mark.parametrize("row", INPUTS)
def test_inputs(row, tmp_path, monkeypatch):
    make, words, code, parts = INPUTS[row]
    three(tmp_path, ROWS, COLS)
    if make is not None:
        make(tmp_path)
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir() if p.is_file()}
    said(call(tmp_path, [*words, "-o", "out"], monkeypatch), code, parts)
    # Inputs are as they were; there is an output exactly if all went well.
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir() if p.is_file()} == before
    assert (tmp_path / "out").exists() == (code == 0)
    if code == 0:
        with rasterio.open(tmp_path / "out/elevation.tif") as source:
            assert source.crs.is_projected
            assert source.crs.linear_units_factor[1] == 1
            assert source.transform.a == -source.transform.e
        return
    outcome = call(tmp_path, [*words, "-o", "out", "--json", "-q"], monkeypatch)
    (line,) = outcome.stdout.splitlines()
    error = json.loads(line)["error"]
    assert error["exit_code"] == code == outcome.exit_code
    assert error["kind"] in {"input", "crs", "grid", "legend", "resource", "parameter", "output"}
    assert parts[0] in error["message"]


def test_a_lowest_value_that_is_asked_about_can_be_settled_on_the_command_line(tmp_path):
    heights = relief(40, 50) + 300
    heights[10:20, 10:20] = 0
    dem = write(tmp_path / "d.tif", heights)
    vegetation = write(tmp_path / "v.tif", np.full(heights.shape, 2, np.uint8))
    common = ["align", str(dem), str(vegetation), "normal", "--overwrite", "-o", str(tmp_path / "out")]
    asked = CliRunner().invoke(firebreak, common)
    assert asked.exit_code == 3
    assert "--src-nodata dem=0 if it means no data, --src-nodata dem=none if it is ground" in asked.stderr
    for word, lowest in (("0", 300), ("none", 0)):
        done = CliRunner().invoke(firebreak, [*common, "--src-nodata", f"dem={word}"])
        assert done.exit_code == 0, done.stderr
        with rasterio.open(tmp_path / "out/elevation.tif") as source:
            assert source.read(1, masked=True).min() >= lowest
            assert (source.read(1) == 0).any() == (word == "none")
