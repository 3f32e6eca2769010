"""The real landscapes: read, written, opened anew with plain rasterio, compared with what they hold."""

import numpy as np
import pytest
import rasterio
from pyproj import Transformer

from firebreak_gis.errors import CRSError, InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape, read_landscape_folder, write_landscape
from tests.places import real, shared

pytestmark = real


def raw(*parts):
    with rasterio.open(shared(*parts)) as source:
        return source.read(1), source.transform


def rhodes(name):
    return shared("rhodes_20m", f"rhodes_{name}.tif")


def test_rhodes_three_layers_reach_the_disk_unchanged(tmp_path):
    data = read_landscape(rhodes("dem"), rhodes("vegetation"), rhodes("density"))
    write_landscape(data, tmp_path, provenance={"version": "test"})
    assert read_landscape_folder(tmp_path).identical(data)
    vegetation, transform = raw("rhodes_20m", "rhodes_vegetation.tif")
    assert int(data["burnable"].sum()) == int(((vegetation > 0) & (vegetation < 255)).sum()) == 171_896
    for name, units, nodata in (("elevation", "m", -9999), ("vegetation", "1", 255), ("density", "1", 255)):
        with rasterio.open(tmp_path / f"{name}.tif") as source:
            assert source.crs.to_epsg() == 32635
            assert source.transform == transform
            assert source.units == (units,)
            assert source.nodata == nodata
            assert source.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG"
            found = source.read(1)
        original, _ = raw("rhodes_20m", f"rhodes_{'dem' if name == 'elevation' else name}.tif")
        same = found == np.where(original == 255, 0, original) if name != "elevation" else found == original
        assert same[vegetation > 0].all()


def test_rhodes_by_the_codes_of_eu12_without_density(tmp_path):
    data = read_landscape(rhodes("dem"), rhodes("fuel12"), legend="eu12")
    codes, _ = raw("rhodes_20m", "rhodes_fuel12.tif")
    np.testing.assert_array_equal(data["vegetation"], np.array([0, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 3])[codes])
    np.testing.assert_array_equal(data["density"], np.array([0, 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3])[codes])
    by_hand = read_landscape(rhodes("dem"), rhodes("vegetation"), rhodes("density"))
    np.testing.assert_array_equal(data["vegetation"], by_hand["vegetation"])


def test_spotorno_transforms_that_differ_by_a_hair_are_one_grid():
    data = read_landscape(
        shared("spotorno_20m", "src_spotorno_dem.tif"),
        shared("spotorno_20m", "src_spotorno_fuel.tif"),
        legend="eu12",
    )
    assert sum("copied" in text for text in data.attrs["alignment"]) == 2
    assert data.sizes == {"y": 512, "x": 512}


def test_ireland_becomes_square_by_looking_up_every_cell():
    paths = shared("ireland_aniso", "dem_clip.tif"), shared("ireland_aniso", "veg_clip.tif")
    data = read_landscape(*paths, legend="prop6")
    grid = Grid.of(data)
    assert grid.cell_size == 20
    codes, transform = raw("ireland_aniso", "veg_clip.tif")
    heights, _ = raw("ireland_aniso", "dem_clip.tif")
    x, y = np.meshgrid(grid.x, grid.y)
    col = (x - transform.c) / transform.a
    row = (y - transform.f) / transform.e
    near = codes[np.floor(row).astype(int), np.floor(col).astype(int)]
    edge = (np.abs(col - np.round(col)) < 1e-4) | (np.abs(row - np.round(row)) < 1e-4)
    expected = np.array([0, 2, 2, 0, 1, 3, 1, 2])[near]
    np.testing.assert_array_equal(data["vegetation"].to_numpy()[~edge], expected[~edge])
    # Within one cell the interpolated height stays near that of the cell.
    difference = np.abs(data["elevation"].to_numpy() - heights[np.floor(row).astype(int), np.floor(col).astype(int)])
    assert np.nanmedian(difference) < 2
    assert np.nanmax(difference) < 40


def test_vilopriu_float_codes_and_canopy_cover():
    folder = "vilopriu_2013"
    paths = [shared(folder, f"{name}.tif") for name in ("elevation", "fuels", "ccf")]
    with pytest.raises(LegendError, match=r"does not list: 0 \(4\.16 ha\)"):
        read_landscape(*paths[:2], legend="scott_burgan_40")
    plain = read_landscape(*paths[:2], legend="scott_burgan_40", unknown="nonburnable")
    assert plain.sizes == {"y": 610, "x": 508}
    data = read_landscape(*paths, legend="scott_burgan_40", density_legend="canopy_cover", unknown="nonburnable")
    codes, _ = raw(folder, "fuels.tif")
    cover, _ = raw(folder, "ccf.tif")
    timber = (codes >= 161) & (codes <= 189) & data["burnable"].to_numpy()
    assert timber.sum() > 1000
    expected = np.where(cover < 40, 1, np.where(cover < 70, 2, 3))
    np.testing.assert_array_equal(data["density"].to_numpy()[timber], expected[timber])
    np.testing.assert_array_equal(
        data["density"].to_numpy()[~timber & (cover >= 0)],
        plain["density"].to_numpy()[~timber & (cover >= 0)],
    )


def test_california_with_a_third_missing():
    names = ("Elevation", "FBFM", "CC")
    paths = [shared("us_ca_30m", f"{name}_UTM_resampled30m.tif") for name in names]
    data = read_landscape(*paths, legend="scott_burgan_40", density_legend="canopy_cover")
    codes, _ = raw("us_ca_30m", "FBFM_UTM_resampled30m.tif")
    np.testing.assert_array_equal(data["vegetation"] > 0, codes > 99)
    assert 0.6 < float(data["burnable"].mean()) < 0.65


def test_portezuelo_is_refused_naming_the_code_and_goes_on_when_told():
    paths = shared("portezuelo_100m", "elevation.tif"), shared("portezuelo_100m", "fuels.tif")
    with pytest.raises(LegendError, match=r"34 \(11\.0\d* ha\)"):
        read_landscape(*paths, legend="kitral")
    data = read_landscape(*paths, legend="kitral", unknown="nonburnable")
    codes, _ = raw("portezuelo_100m", "fuels.tif")
    assert int(data["burnable"].sum()) == int((codes != 0).sum() - (codes == 34).sum())


def test_sub20_metres_in_degrees_are_refused_and_the_grids_read():
    lying = shared("sub20", "Input_Geotiff.tif")
    with pytest.raises(CRSError, match="claims degrees"):
        read_landscape(lying, lying, "normal", band={"dem": 1, "vegetation": 1})
    data = read_landscape(
        shared("sub20", "elevation.asc"),
        shared("sub20", "fuels.asc"),
        "normal",
        legend="kitral",
        unknown="nonburnable",
    )
    assert data.sizes == {"y": 20, "x": 20}
    assert Grid.of(data).crs.is_projected


def test_a_dem_in_degrees_is_interpolated_at_the_true_places(tmp_path):
    dem = shared("geographic_dem", "dem.tif")
    heights, transform = raw("geographic_dem", "dem.tif")
    legend = tmp_path / "all.csv"
    legend.write_text("code,vegetation,density\n-40000..40000,shrubs,normal\n")
    data = read_landscape(dem, dem, legend=legend)
    grid = Grid.of(data)
    assert grid.crs.to_epsg() == 32614
    assert grid.cell_size == 85
    rng = np.random.default_rng(1)
    rows, cols = rng.integers(20, grid.shape[0] - 20, 50), rng.integers(20, grid.shape[1] - 20, 50)
    lon, lat = Transformer.from_crs(32614, 4326, always_xy=True).transform(grid.x[cols], grid.y[rows])
    for row, col, x, y in zip(rows, cols, lon, lat, strict=True):
        i, j = (y - transform.f) / transform.e - 0.5, (x - transform.c) / transform.a - 0.5
        around = heights[int(i) : int(i) + 2, int(j) : int(j) + 2].astype(float)
        if (around == -32768).any():
            continue
        u, v = i % 1, j % 1
        expected = np.array([1 - u, u]) @ around @ np.array([1 - v, v])
        assert float(data["elevation"][row, col]) == pytest.approx(expected, abs=0.01)


@pytest.mark.parametrize("role", ["dem", "vegetation", "density"])
def test_every_odd_file_in_every_role_gets_an_answer_or_a_sentence(role):
    """Never a traceback of another class, never a warning, in any role beside layers that are right."""
    layers = {"dem": rhodes("dem"), "vegetation": rhodes("vegetation"), "density": rhodes("density")}
    files = sorted(shared("odd_tiffs").iterdir())
    assert len(files) > 40
    for path in files:
        # All lie elsewhere, if anywhere: an answer would be wrong.
        with pytest.raises(InputError, match=r".{40}"):
            read_landscape(**{**layers, role: path})


@pytest.mark.parametrize(
    ("name", "epsg", "cell"),
    [
        ("odcgeo__au-3577.tif", 3577, 30_000),
        ("odcgeo__au-3577-rotated.tif", 3577, 30_000),
        ("riotiler__clp.tif", 32653, 67),
        ("riotiler__cog_gradient.tif", None, None),
    ],
)
def test_odd_but_right_files_as_whole_landscapes(tmp_path, name, epsg, cell):
    path = shared("odd_tiffs", name)
    with rasterio.open(path) as source:
        codes = np.unique(source.read(1))
    lines = ["-1000000..1000000"] if codes.dtype.kind == "f" else codes
    legend = tmp_path / "all.csv"
    legend.write_text("code,vegetation,density\n" + "".join(f"{code},pines,dense\n" for code in lines))
    if epsg is None:
        with pytest.raises(CRSError, match="350 degrees of longitude"):
            read_landscape(path, path, legend=legend)
        return
    # The 0 beside cliffs is asked about; here it is said to be ground.
    data = read_landscape(path, path, legend=legend, src_nodata={"dem": ()})
    assert Grid.of(data).crs.to_epsg() == epsg
    assert Grid.of(data).cell_size == cell
    assert 0.3 < float(data["burnable"].mean()) < 0.7
