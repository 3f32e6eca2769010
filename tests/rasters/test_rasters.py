"""Rasters: read with every "no data" settled, written so that plain rasterio finds all of it."""

import os
import signal
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
import rasterio
from affine import Affine

from firebreak_gis import rasters, schema
from firebreak_gis.errors import (
    CRSError,
    GridError,
    InputError,
    OutputError,
    VerificationError,
)
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.lattice import DIRECTIONS
from firebreak_gis.rasters import writing
from firebreak_gis.rasters.nodata import undeclared_nodata
from firebreak_gis.styles import rasters as styles
from tests.places import ROOT, patches, real, relief, shared, square, write

ROWS, COLS = 300, 530
GRID = Grid((ROWS, COLS), square(), parse_crs(32635))


def values_of(name, rows=ROWS, cols=COLS, seed=0):
    """Values of a variable that use its whole range, with missing cells where it may have them."""
    variable = schema.VARIABLES[name]
    rng = np.random.default_rng(seed)
    shape = (8, rows, cols) if variable.dims[0] == "direction" else (rows, cols)
    if variable.classes:
        return rng.integers(0, max(variable.classes) + 1, shape).astype(variable.dtype)
    if variable.dtype == "bool":
        return rng.random(shape) < 0.5
    if np.dtype(variable.dtype).kind in "iu":
        most = 999 if variable.maximum is None else min(int(variable.maximum), 999)
        return rng.integers(0, most + 1, shape).astype(variable.dtype)
    values = rng.random(shape).astype(variable.dtype)
    values[..., :5, :7] = -np.inf if name == "priority" else np.nan
    return values


RASTERS = [v.name for v in schema.VARIABLES.values() if v.dims[-2:] == ("y", "x")]


@pytest.mark.parametrize("name", RASTERS)
def test_every_variable_reads_back_equal(tmp_path, name):
    values = values_of(name, 21, 34)
    grid = Grid((21, 34), square(), parse_crs(32635))
    path = rasters.write_raster(tmp_path / f"{name}.tif", grid.dataarray(values, name))
    back = rasters.read_variable(path, name)
    assert back.dims == schema.VARIABLES[name].dims
    assert back.dtype == np.dtype(schema.VARIABLES[name].dtype)
    np.testing.assert_array_equal(back.to_numpy(), values)
    assert Grid.of(back).matches(grid)


@pytest.mark.parametrize("name", ["breaks", "elevation", "priority", "spread_probability", "burn_count"])
def test_the_file_holds_what_others_need(tmp_path, name):
    variable = schema.VARIABLES[name]
    values = values_of(name)
    provenance = {"software": "firebreak_gis", "version": "0.1.0", "seed": 7, "parameters": {"b": 1, "a": 2}}
    path = rasters.write_raster(tmp_path / f"{name}.tif", GRID.dataarray(values, name), provenance=provenance)
    with rasterio.open(path) as source:
        assert source.driver == "GTiff"
        assert source.crs.to_epsg() == 32635
        assert source.transform == square()
        assert (source.height, source.width) == (ROWS, COLS)
        assert source.nodata == variable.nodata
        assert set(source.units) == {variable.units}
        assert source.descriptions == (DIRECTIONS if name == "spread_probability" else (variable.text,))
        assert source.tags()["AREA_OR_POINT"] == "Area"
        assert source.tags()["FIREBREAK_SEED"] == "7"
        assert source.tags()["FIREBREAK_PARAMETERS"] == '{"a": 2, "b": 1}'
        assert source.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG"
        assert source.compression.name == "deflate"
        assert source.profile["tiled"]
        assert source.block_shapes[0] == (256, 256)
        assert len(source.overviews(1)) >= 1
        if variable.classes:
            found = source.colormap(1)
            for code, colour in variable.colours.items():
                assert found[code][:3] == styles.rgba(colour)[:3]
    assert not list(tmp_path.glob("*.aux.xml"))
    back = rasters.read_variable(path, name)
    assert back.attrs["provenance"]["software"] == "firebreak_gis"


def test_overviews_invent_no_class(tmp_path):
    path = rasters.write_raster(tmp_path / "breaks.tif", GRID.dataarray(values_of("breaks"), "breaks"))
    with rasterio.open(path, overview_level=0) as source:
        assert set(np.unique(source.read(1))) <= {0, 1}


def test_overviews_of_quantities_leave_missing_cells_out(tmp_path):
    values = np.full((ROWS, COLS), 100, dtype=np.float32)
    values[::2] = np.nan
    path = rasters.write_raster(tmp_path / "elevation.tif", GRID.dataarray(values, "elevation"))
    with rasterio.open(path, overview_level=0) as source:
        assert set(np.unique(source.read(1))) == {100}


def test_equal_data_give_equal_bytes(tmp_path):
    data = GRID.dataarray(values_of("burn_frequency"), "burn_frequency")
    one = rasters.write_raster(tmp_path / "one.tif", data, provenance={"seed": 1, "version": "1"})
    other = rasters.write_raster(tmp_path / "other.tif", data, provenance={"version": "1", "seed": 1})
    assert one.read_bytes() == other.read_bytes()


def test_creation_options_reach_the_driver(tmp_path):
    data = GRID.dataarray(values_of("breaks"), "breaks")
    path = rasters.write_raster(tmp_path / "a.tif", data, creation_options={"COMPRESS": "LZW", "BLOCKSIZE": 128})
    with rasterio.open(path) as source:
        assert source.compression.name == "lzw"
        assert source.block_shapes[0] == (128, 128)


@pytest.mark.parametrize(
    ("name", "change", "match"),
    [
        ("spread_probability", lambda v: v + 1, "at most 1"),
        ("elevation", lambda v: np.where(np.isnan(v), v, -9999.0), "at least|no data"),
        ("elevation", lambda v: np.where(v > 0.5, np.inf, v), "infinite"),
        ("priority", lambda v: np.where(v > 0.5, np.nan, v), "NaN"),
        ("priority", lambda v: np.where(v > 0.5, -9999.0, v), "stands for no data"),
        ("vegetation", lambda v: v + 1, "at most 3"),
        ("vegetation", lambda v: v * 0.3, "fractions"),
        ("burn_count", lambda v: v.astype(float) - 5, "at least 0"),
    ],
)
def test_data_that_do_not_fit_the_schema_are_refused(tmp_path, name, change, match):
    with pytest.raises(InputError, match=match):
        rasters.write_raster(tmp_path / "a.tif", GRID.dataarray(change(values_of(name)), name))
    assert list(tmp_path.iterdir()) == []


def test_unknown_names_and_dims_are_refused(tmp_path):
    with pytest.raises(InputError, match="not a variable"):
        rasters.write_raster(tmp_path / "a.tif", GRID.dataarray(relief(ROWS, COLS), "height"))
    with pytest.raises(InputError, match="dims"):
        rasters.write_raster(tmp_path / "a.tif", GRID.dataarray(relief(ROWS, COLS), "elevation").transpose("x", "y"))


def test_overwriting_is_asked_for_and_removes_stale_companions(tmp_path):
    path = tmp_path / "breaks.tif"
    data = GRID.dataarray(values_of("breaks"), "breaks")
    rasters.write_raster(path, data)
    before = path.read_bytes()
    with pytest.raises(OutputError):
        rasters.write_raster(path, data)
    assert path.read_bytes() == before
    for suffix in (".aux.xml", ".ovr", ".msk"):
        (tmp_path / f"breaks.tif{suffix}").write_text("of the old raster")
    rasters.write_raster(path, data, overwrite=True)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["breaks.qml", "breaks.tif"]


def test_a_users_style_is_kept(tmp_path):
    (tmp_path / "breaks.qml").write_text("mine")
    rasters.write_raster(tmp_path / "breaks.tif", GRID.dataarray(values_of("breaks"), "breaks"))
    assert (tmp_path / "breaks.qml").read_text() == "mine"


def test_a_file_that_reads_back_differently_never_takes_its_place(tmp_path, monkeypatch):
    genuine = writing._encoded

    def broken(planes, *rest):
        return genuine(np.where(planes == 1, 0, planes), *rest)

    monkeypatch.setattr(writing, "_encoded", broken)
    with pytest.raises(VerificationError, match="does not read back"):
        rasters.write_raster(tmp_path / "breaks.tif", GRID.dataarray(values_of("breaks"), "breaks"))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="no limits on the size of files there")
def test_a_full_disk_is_exit_4_and_leaves_nothing(tmp_path):
    # A limit on the size of files makes the operating system fail the write, as a full disk does.
    code = (
        "import resource, signal, sys, numpy as np\n"
        "from firebreak_gis import rasters\nfrom firebreak_gis.grid import Grid, parse_crs\n"
        "from affine import Affine\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "grid = Grid((300, 530), Affine(20, 0, 5e5, 0, -20, 4e6), parse_crs(32635))\n"
        "data = grid.dataarray(np.random.default_rng(0).random((300, 530), dtype=np.float32), "
        "'burn_frequency')\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))\n"
        "try:\n    rasters.write_raster(sys.argv[1], data)\n"
        "except Exception as error:\n    print(type(error).__name__)\n"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "a.tif")],
        capture_output=True,
        text=True,
        check=True,
        cwd=ROOT,
    )
    assert ran.stdout.strip() in ("OutputError", "VerificationError")
    assert list(tmp_path.iterdir()) == []


# Styles


@pytest.mark.parametrize("name", [v.name for v in schema.VARIABLES.values() if v.colours])
def test_styles_are_xml_with_every_colour(name):
    variable = schema.VARIABLES[name]
    root = ET.fromstring(styles.qml(variable, minimum=-3, maximum=12).split("\n", 1)[1])
    renderer = root.find("pipe/rasterrenderer")
    entries = renderer.findall(".//paletteEntry") or renderer.findall(".//item")
    assert [e.get("color") for e in entries] == [c[:7] for c in variable.colours.values()]
    if variable.classes:
        assert renderer.get("type") == "paletted"
        assert [e.get("label") for e in entries] == list(variable.classes.values())
    else:
        assert (float(entries[0].get("value")), float(entries[-1].get("value"))) == (-3, 12)


def test_untouched_cells_are_transparent():
    root = ET.fromstring(styles.qml(schema.VARIABLES["breaks"]).split("\n", 1)[1])
    assert [e.get("alpha") for e in root.iter("paletteEntry")] == ["0", "255"]


@pytest.mark.parametrize(
    ("name", "share", "low", "high"), [("priority", 1000.0, 0.0, 1.0), ("burn_frequency", 1.0, 0.0, 1.0)]
)
def test_a_few_great_values_do_not_take_all_the_colours(tmp_path, name, share, low, high):
    values = np.linspace(0, 1, ROWS * COLS, dtype="float32").reshape(ROWS, COLS)
    values[0, :20] = share
    rasters.write_raster(tmp_path / "a.tif", GRID.dataarray(values, name))
    renderer = ET.fromstring((tmp_path / "a.qml").read_text().split("\n", 1)[1]).find("pipe/rasterrenderer")
    assert float(renderer.get("classificationMin")) == pytest.approx(low, abs=0.03)
    assert float(renderer.get("classificationMax")) == pytest.approx(high, abs=0.03)


# Reading


def read(tmp_path, values, **more):
    options = {key: more.pop(key) for key in ("src_nodata", "strict", "band") if key in more}
    return rasters.read_raster(write(tmp_path / "a.tif", values, **more), **options)


def test_integers_without_holes_keep_their_type(tmp_path):
    data = read(tmp_path, patches(9, 7, [1, 2, 9]))
    assert data.dtype == np.uint8
    np.testing.assert_array_equal(data, patches(9, 7, [1, 2, 9]))


@pytest.mark.parametrize("dtype", ["int16", "int32", "float32", "float64"])
def test_declared_nodata_becomes_nan(tmp_path, dtype):
    values = (relief(9, 7) + 10).astype(dtype)
    values[2, 3] = -9999
    data = read(tmp_path, values, nodata=-9999)
    assert np.isnan(data[2, 3])
    assert int(np.isnan(data).sum()) == 1
    assert data.attrs["notes"] == []


@pytest.mark.parametrize("sentinel", [-9999.0, -32768.0, 32767.0, -3.4028234663852886e38])
def test_undeclared_nodata_is_masked_and_told_or_refused(tmp_path, sentinel):
    values = relief(9, 7).copy()
    values[:2, :2] = sentinel
    data = read(tmp_path, values)
    assert int(np.isnan(data).sum()) == 4
    assert "taken as no data" in data.attrs["notes"][0]
    with pytest.raises(InputError, match="without declaring"):
        read(tmp_path, values, strict=True)


def test_a_number_within_the_data_is_no_sentinel():
    values = np.linspace(-12_000, 500, 100)
    values[40] = -9999
    assert undeclared_nodata(values, np.ones(100, dtype=bool)) == []
    assert undeclared_nodata(np.array([-9999.0, 3, 4]), np.array([False, True, True])) == []


def test_src_nodata_takes_the_place_of_the_declared_one(tmp_path):
    values = np.array([[0, 1, 2], [3, 4, 5], [6, 7, 99]], dtype=np.int16)
    np.testing.assert_array_equal(
        read(tmp_path, values, nodata=0, src_nodata=[99, 7]), [[0, 1, 2], [3, 4, 5], [6, np.nan, np.nan]]
    )


def test_a_nodata_that_does_not_fit_is_ignored_and_told(tmp_path):
    data = read(tmp_path, patches(4, 5, [1, 2]), src_nodata=-9999)
    assert data.dtype == np.uint8
    assert "does not fit" in data.attrs["notes"][0]


def test_nan_is_no_data_and_infinity_refused(tmp_path):
    values = relief(5, 4).copy()
    values[1, 1] = np.nan
    assert int(np.isnan(read(tmp_path, values)).sum()) == 1
    values[2, 2] = np.inf
    with pytest.raises(InputError, match="infinite"):
        read(tmp_path, values)


def test_scale_and_offset_are_applied_and_told(tmp_path):
    data = read(tmp_path, np.array([[10, 20], [30, -1]], dtype=np.int16), scale=(0.5, 100.0), nodata=-1)
    np.testing.assert_array_equal(data, [[105, 110], [115, np.nan]])
    assert "multiplied by 0.5" in data.attrs["notes"][0]


def test_a_south_up_raster_is_turned(tmp_path):
    values = relief(6, 5)
    upright = read(tmp_path, values)
    turned = read(tmp_path, values[::-1], transform=Affine(20, 0, 586_440, 0, 20, 3_999_900 - 6 * 20))
    np.testing.assert_array_equal(turned, upright)
    assert Grid.of(turned).matches(Grid.of(upright))


def test_alpha_and_mask_bands_tell_where_data_is(tmp_path):
    path = tmp_path / "a.tif"
    values = patches(8, 6, [1, 2, 3])
    alpha = np.full((8, 6), 255, dtype=np.uint8)
    alpha[0] = 0
    write(path, np.stack([values, alpha]), photometric="MINISBLACK", alpha="YES")
    data = rasters.read_raster(path)
    assert np.isnan(data[0]).all()
    np.testing.assert_array_equal(data[1:], values[1:])


def refuse_cases(folder):
    """Files that cannot be used, with a word of the sentence that each must get."""
    flat = patches(6, 5, [1, 2])
    text = folder / "text.tif"
    text.write_text("hello")
    (folder / "empty.tif").touch()
    (folder / "html.tif").write_text("<html>please log in</html>")
    lfs = folder / "lfs.tif"
    lfs.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n")
    whole = write(folder / "whole.tif", relief(200, 300), compress="deflate")
    cut = folder / "cut.tif"
    cut.write_bytes(whole.read_bytes()[: whole.stat().st_size * 2 // 3])
    vrt = folder / "really_vrt.tif"
    vrt.write_text("\ufeff" + '<VRTDataset rasterXSize="2" rasterYSize="2"/>')
    rotated = Affine.translation(5e5, 4e6) @ Affine.rotation(30) @ Affine.scale(20, -20)
    return [
        (folder / "missing.tif", "does not exist"),
        (folder, "is a folder"),
        (folder / "empty.tif", "empty"),
        (text, "cannot be read as a raster"),
        (folder / "html.tif", "XML or HTML"),
        (lfs, "Git LFS"),
        (cut, "damaged or cut off|cannot be read"),
        (vrt, "virtual raster"),
        (write(folder / "rgb.tif", np.stack([flat] * 3), photometric="RGB"), "picture"),
        (write(folder / "many.tif", np.stack([flat] * 5)), "5 bands"),
        (write(folder / "complex.tif", flat.astype("complex64")), "complex64"),
        (write(folder / "nocrs.tif", flat, crs=None), "no coordinate reference system"),
        (write(folder / "all_missing.tif", np.zeros((4, 4), "uint8"), nodata=0), "no data in any cell"),
        (write(folder / "rotated.tif", flat, transform=rotated), "rotated"),
        (write(folder / "degrees.tif", flat, crs="EPSG:4326"), "claims degrees"),
        (write(folder / "mars.tif", flat, crs="IAU_2015:49910"), "not of the Earth"),
        (
            write(folder / "local.tif", flat, crs='LOCAL_CS["site grid",UNIT["metre",1]]'),
            "not tied to the Earth",
        ),
        (
            write(folder / "metres.tif", flat, transform=Affine(1e-4, 0, 27.5, 0, -1e-4, 36.2)),
            "look like degrees",
        ),
        ("https://example.org/a.tif", "network"),
        ("/vsizip/a.zip/a.tif", "archive"),
    ]


def test_each_unusable_file_gets_its_own_sentence(tmp_path):
    for path, match in refuse_cases(tmp_path):
        with pytest.raises(InputError, match=match):
            rasters.read_raster(path)


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_control_points_alone_are_refused_with_the_command(tmp_path):
    from rasterio.control import GroundControlPoint as Point

    path = tmp_path / "gcp.tif"
    points = [Point(0, 0, 5e5, 4e6), Point(0, 5, 5e5 + 100, 4e6), Point(6, 0, 5e5, 4e6 - 120)]
    write(path, patches(6, 5, [1]), gcps=points, transform=Affine.identity())
    with pytest.raises(GridError, match="gdalwarp"):
        rasters.read_raster(path)


def test_a_vrt_is_read_under_its_own_name_only(tmp_path):
    path = write(tmp_path / "a.tif", patches(4, 5, [1, 2]))
    vrt = tmp_path / "a.vrt"
    vrt.write_text(
        '<VRTDataset rasterXSize="5" rasterYSize="4"><SRS>EPSG:32635</SRS>'
        "<GeoTransform>5e5,20,0,4e6,0,-20</GeoTransform>"
        '<VRTRasterBand dataType="Byte" band="1"><SimpleSource>'
        '<SourceFilename relativeToVRT="1">a.tif</SourceFilename><SourceBand>1</SourceBand>'
        "</SimpleSource></VRTRasterBand></VRTDataset>"
    )
    np.testing.assert_array_equal(rasters.read_raster(vrt), rasters.read_raster(path))
    disguised = tmp_path / "b.tif"
    disguised.write_text(vrt.read_text())
    with pytest.raises(InputError):
        rasters.read_raster(disguised)


def test_names_with_spaces_and_unicode_work(tmp_path):
    folder = tmp_path / "Λάρδος – été 100%"
    folder.mkdir()
    data = GRID.dataarray(values_of("breaks"), "breaks")
    path = rasters.write_raster(folder / "ζώνες & breaks.tif", data)
    np.testing.assert_array_equal(rasters.read_variable(path, "breaks"), data)


# Variables brought along


def network(folder, descriptions=DIRECTIONS, bands=8, values=None):
    path = folder / "network.tif"
    planes = np.full((bands, 5, 6), 0.5, dtype=np.float32) if values is None else values
    planes = planes + np.arange(bands, dtype=np.float32)[:, None, None] / 100
    write(path, planes.astype(np.float32))
    with rasterio.open(path, "r+") as target:
        for band, text in enumerate(descriptions[:bands] if descriptions else (), start=1):
            target.set_band_description(band, text)
    return path


@pytest.mark.parametrize("descriptions", [DIRECTIONS, None, tuple(f"{d.lower()}: towards it" for d in DIRECTIONS)])
def test_a_network_of_another_model_is_read_in_order(tmp_path, descriptions):
    data = rasters.read_variable(network(tmp_path, descriptions), "spread_probability")
    assert data.dims == ("direction", "y", "x")
    assert list(data["direction"].to_numpy()) == list(DIRECTIONS)
    np.testing.assert_allclose(data[:, 0, 0], 0.5 + np.arange(8) / 100, rtol=1e-6)


def test_networks_that_do_not_fit_are_refused(tmp_path):
    with pytest.raises(InputError, match="order N NW W"):
        rasters.read_variable(network(tmp_path, ("N", "NW", "W", "SW", "S", "SE", "E", "NE")), "spread_probability")
    with pytest.raises(InputError, match="7 bands, expected 8"):
        rasters.read_variable(network(tmp_path, bands=7), "spread_probability")
    with pytest.raises(InputError, match="up to 50, expected"):
        rasters.read_variable(network(tmp_path, values=np.full((8, 5, 6), 50.0)), "spread_probability")
    with pytest.raises(InputError, match="8 bands, expected 1"):
        rasters.read_variable(network(tmp_path), "priority")
    with pytest.raises(CRSError):
        rasters.read_variable(write(tmp_path / "b.tif", np.zeros((4, 4), "float32"), crs=None), "priority")


def test_a_priority_of_any_type_is_taken_and_its_holes_rank_last(tmp_path):
    path = write(tmp_path / "p.tif", np.array([[5, 1], [0, 7]], dtype=np.int16), nodata=0)
    data = rasters.read_variable(path, "priority")
    np.testing.assert_array_equal(data, [[5, 1], [-np.inf, 7]])
    assert data.dtype == np.dtype(schema.VARIABLES["priority"].dtype)


def test_breaks_as_fractions_are_refused(tmp_path):
    with pytest.raises(InputError, match="whole numbers"):
        rasters.read_variable(write(tmp_path / "b.tif", np.full((4, 4), 0.5, "float32")), "breaks")
    whole = write(tmp_path / "c.tif", np.eye(4, dtype="float32"))
    np.testing.assert_array_equal(rasters.read_variable(whole, "breaks"), np.eye(4))


@real
def test_every_odd_file_gets_an_answer_or_a_sentence():
    folder = shared("odd_tiffs")
    answers = 0
    for path in sorted(folder.iterdir()):
        try:
            data = rasters.read_raster(path)
        except InputError:  # any other class fails the test
            continue
        answers += 1
        assert Grid.of(data).crs is not None
        assert np.isfinite(data).any()
    assert answers >= 4


def test_an_artificial_forest_has_no_crs_and_is_read_when_asked(tmp_path):
    grid = Grid((5, 6))
    values = values_of("spread_probability", 5, 6)
    path = rasters.write_raster(tmp_path / "network.tif", grid.dataarray(values, "spread_probability"))
    with pytest.raises(CRSError):
        rasters.read_variable(path, "spread_probability")
    back = rasters.read_variable(path, "spread_probability", unreferenced=True)
    np.testing.assert_array_equal(back, values)
    assert Grid.of(back).matches(grid)


def test_importing_costs_little():
    code = (
        "import sys, firebreak_gis.rasters, firebreak_gis.landscape, firebreak_gis.vectors\n"
        "heavy = {'rasterio', 'geopandas', 'xarray', 'rioxarray', 'pyproj', 'pandas', 'numba'} & "
        "set(sys.modules)\n"
        "print(sorted(heavy))"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True)
    assert ran.stdout.strip() == "[]"


def test_threads_do_not_change_a_byte(tmp_path, monkeypatch):
    data = GRID.dataarray(values_of("burn_frequency"), "burn_frequency")
    written = []
    for threads in ("1", "2", "5"):
        monkeypatch.setenv("FIREBREAK_THREADS", threads)
        written.append(rasters.write_raster(tmp_path / f"{threads}.tif", data).read_bytes())
    assert written[0] == written[1] == written[2]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot be forked here")
def test_a_fork_of_a_process_that_wrote_can_write(tmp_path, monkeypatch):
    monkeypatch.setenv("FIREBREAK_THREADS", "2")
    data = GRID.dataarray(values_of("burn_frequency"), "burn_frequency")
    before = rasters.write_raster(tmp_path / "before.tif", data).read_bytes()
    child = os.fork()
    if child == 0:
        signal.alarm(60)  # ends a child that waits for ever
        try:
            rasters.write_raster(tmp_path / "after.tif", data)
        except BaseException:
            os._exit(1)
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0
    assert (tmp_path / "after.tif").read_bytes() == before
