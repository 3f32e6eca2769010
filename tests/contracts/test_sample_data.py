"""The sample landscape: what its files promise, and that the script still makes them."""

import subprocess
import sys
from pathlib import Path

import geopandas as gpd
import numpy as np
import pyogrio
import pytest
import rasterio
from rasterio.warp import transform_bounds
from scipy import ndimage
from shapely.geometry import box

FOLDER = Path(__file__).resolve().parents[2] / "sample_data"
RASTERS = ("dem", "vegetation", "density")
LAYERS = ("ignitions", "boundary", "villages", "roads")


def read(name, folder=FOLDER):
    with rasterio.open(folder / f"{name}.tif") as raster:
        return raster.read(1), raster.profile


def layer(name, folder=FOLDER):
    return gpd.read_file(folder / f"{name}.gpkg", layer=name)


def cells_under(points, profile):
    """Rows and columns of the cells that hold the points."""
    points = points.geometry.to_crs(profile["crs"])
    return rasterio.transform.rowcol(profile["transform"], points.x.to_numpy(), points.y.to_numpy())


def study_box():
    with rasterio.open(FOLDER / "vegetation.tif") as raster:
        return box(*raster.bounds)


def test_folder_is_small():
    files = [path for path in FOLDER.iterdir() if path.is_file()]
    assert {f"{name}.tif" for name in RASTERS} | {f"{name}.gpkg" for name in LAYERS} <= {f.name for f in files}
    assert sum(path.stat().st_size for path in files) < 2_000_000


# One test for all files, so that the script runs only once.
def test_script_makes_the_files_again(tmp_path):
    script = FOLDER / "make_sample_data.py"
    subprocess.run(
        [sys.executable, str(script), "--output", str(tmp_path)], check=True, timeout=120, capture_output=True
    )
    for name in RASTERS:
        values, profile = read(name)
        again, profile_again = read(name, tmp_path)
        np.testing.assert_array_equal(again, values, err_msg=name)
        assert profile_again == profile
    for name in LAYERS:
        stored, again = layer(name), layer(name, tmp_path)
        assert again.crs == stored.crs
        assert again.drop(columns="geometry").equals(stored.drop(columns="geometry"))
        assert again.geometry.geom_equals_exact(stored.geometry, tolerance=1e-9).all(), name


def test_grids_differ_so_that_alignment_matters():
    _, dem = read("dem")
    vegetation, profile = read("vegetation")
    _, density = read("density")
    assert dem["crs"] == "EPSG:4326"
    assert profile["crs"] == "EPSG:32635"
    assert density["crs"] == profile["crs"]
    assert density["transform"] == profile["transform"]
    assert (density["height"], density["width"]) == vegetation.shape
    assert vegetation.shape[0] != vegetation.shape[1]
    assert profile["transform"].a == -profile["transform"].e == 25.0
    # In metres on the ground, a DEM cell is neither square nor 25 m high.
    north_south = -dem["transform"].e * 111_000.0
    assert 28.0 < north_south < 33.0


def test_dem_covers_the_vegetation_grid():
    with rasterio.open(FOLDER / "dem.tif") as dem, rasterio.open(FOLDER / "vegetation.tif") as vegetation:
        inner = transform_bounds(vegetation.crs, dem.crs, *vegetation.bounds)
        cell = dem.transform.a
        assert dem.bounds.left < inner[0] - 2 * cell
        assert dem.bounds.bottom < inner[1] - 2 * cell
        assert dem.bounds.right > inner[2] + 2 * cell
        assert dem.bounds.top > inner[3] + 2 * cell
        assert dem.nodata == -9999.0
        assert np.all(dem.read_masks(1) == 255)


def test_relief_is_a_mountainous_coast():
    height, profile = read("dem")
    assert height.dtype == np.float32
    assert height.min() == 0.0
    assert 700.0 < height.max() < 1000.0
    sea = height == 0.0
    assert 0.15 < sea.mean() < 0.27
    latitude = profile["transform"].f + 0.5 * height.shape[0] * profile["transform"].e
    metres = 111_320.0 * profile["transform"].a
    south, east = np.gradient(height, metres, metres * np.cos(np.radians(latitude)))
    slope = np.degrees(np.arctan(np.hypot(south, east)))[~sea]
    assert 12.0 < np.median(slope) < 18.0
    assert np.mean(slope > 40.0) < 0.02


@pytest.mark.parametrize(
    ("name", "codes", "shares"),
    [
        ("vegetation", {0, 1, 2, 3}, {1: 0.20, 2: 0.35, 3: 0.45}),
        ("density", {1, 2, 3, 255}, {1: 0.25, 2: 0.45, 3: 0.30}),
    ],
)
def test_codes_and_shares(name, codes, shares):
    values, profile = read(name)
    assert values.dtype == np.uint8
    assert profile["nodata"] == 255
    assert set(np.unique(values).tolist()) == codes
    burnable = read("vegetation")[0] > 0
    for code, share in shares.items():
        assert np.mean(values[burnable] == code) == pytest.approx(share, abs=0.01)


def test_density_is_known_exactly_where_plants_grow():
    np.testing.assert_array_equal(read("density")[0] != 255, read("vegetation")[0] > 0)


@pytest.mark.parametrize("name", RASTERS)
def test_rasters_are_tiled_deflate_and_described(name):
    with rasterio.open(FOLDER / f"{name}.tif") as raster:
        assert raster.profile["tiled"] is True
        assert raster.profile["compress"] == "deflate"
        assert raster.descriptions == ("elevation" if name == "dem" else name,)
        if name != "dem":
            palette = raster.colormap(1)
            codes = [code for code in np.unique(raster.read(1)).tolist() if code != 255]
            assert len({palette[code] for code in codes}) == len(codes)


def test_most_of_the_land_that_burns_hangs_together():
    burnable = read("vegetation")[0] > 0
    parts, _ = ndimage.label(burnable, np.ones((3, 3)))
    assert np.bincount(parts.ravel())[1:].max() > 0.9 * burnable.sum()


def test_ignitions_are_on_burnable_cells_in_the_study_area():
    points = layer("ignitions")
    assert points.crs == "EPSG:4326"
    assert len(points) == points["name"].nunique() == 5
    vegetation, profile = read("vegetation")
    rows, cols = cells_under(points, profile)
    assert np.all(np.isin(vegetation[rows, cols], (1, 2, 3)))
    boundary = layer("boundary").geometry.iloc[0]
    assert points.to_crs(profile["crs"]).within(boundary).all()


def test_boundary_is_one_polygon_inside_the_rasters():
    boundary = layer("boundary")
    assert boundary.crs == "EPSG:32635"
    assert boundary.geom_type.tolist() == ["Polygon"]
    assert boundary.is_valid.all()
    assert study_box().contains(boundary.geometry.iloc[0])
    assert boundary.area.iloc[0] > 0.7 * study_box().area


def test_villages_do_not_burn_and_roads_reach_them():
    villages, roads = layer("villages"), layer("roads")
    assert villages.crs == roads.crs == "EPSG:32635"
    assert len(villages) == villages["name"].nunique() == 4
    assert (villages["people"] > 0).all()
    assert villages.is_valid.all()
    vegetation, profile = read("vegetation")
    rows, cols = cells_under(villages.set_geometry(villages.representative_point()), profile)
    assert np.all(vegetation[rows, cols] == 0)
    assert set(roads.geom_type) == {"LineString"}
    assert all(roads.intersects(village).any() for village in villages.geometry)
    assert roads.within(study_box()).all()


def test_roads_keep_off_the_sea():
    height, profile = read("dem")
    for road in layer("roads").geometry:
        metres = np.arange(0.0, road.length, 25.0)
        points = gpd.GeoSeries(road.interpolate(metres), crs="EPSG:32635")
        assert np.all(height[cells_under(points, profile)] > 0.0)


@pytest.mark.parametrize("name", LAYERS)
def test_each_geopackage_holds_the_layer_of_its_name(name):
    assert pyogrio.list_layers(FOLDER / f"{name}.gpkg")[:, 0].tolist() == [name]
