"""Wind, moisture and ignitions as rasters on their own grids; density from continuity."""

import numpy as np
import pytest
from affine import Affine
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis import spread_network
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape import read_landscape
from firebreak_gis.landscape.continuity import density_by_continuity
from firebreak_gis.landscape.planes import ignition_source
from firebreak_gis.landscape.weather_layers import WeatherReader
from tests.places import NORTH_WEST, UTM, patches, real, relief, shared, square, write

GRID = Grid((20, 30), square(), parse_crs(UTM))


def raster(folder, values, name="a.tif", **more):
    return str(write(folder / name, np.asarray(values, "float32"), **more))


def wind_planes(speed, from_direction, grid):
    return WeatherReader(grid).wind(speed, from_direction)


def moisture_plane(source, grid):
    return WeatherReader(grid).moisture(source)


def apart(one, other):
    return np.abs((one - other + 180) % 360 - 180)


def test_directions_are_averaged_as_vectors(tmp_path):
    """Columns of 350 and 10 degrees on cells half as wide: every cell of the grid gets the wind from 0."""
    angles = np.tile([350.0, 10.0], (40, 30))
    _, direction = wind_planes(5.0, raster(tmp_path, angles, transform=square(10.0)), GRID)
    assert direction.shape == GRID.shape
    assert apart(direction, 0.0).max() < 1e-3
    # Interpolated as well: half way between a column of 350 and one of 10 lies 0, and never 180.
    coarse = raster(tmp_path, [[350.0, 10.0]] * 2, "c.tif", transform=square(300.0))
    _, direction = wind_planes(5.0, coarse, GRID)
    middle = direction[:, 14:16]
    assert apart(middle, 0.0).max() < 1.0
    assert apart(direction, 0.0).max() <= 10.001
    assert (np.diff(direction[0] - 360.0 * (direction[0] > 180)) >= -1e-3).all()


def test_wind_lies_on_any_grid_and_crs(tmp_path):
    degrees = Affine(0.02, 0, 27.9, 0, -0.02, 36.2)
    speed = raster(tmp_path, np.full((6, 6), 7.0), "s.tif", transform=degrees, crs="EPSG:4326")
    strength, direction = wind_planes(speed, "270", GRID)
    np.testing.assert_allclose(strength, 7.0, rtol=1e-6)
    assert direction == 270
    assert wind_planes("3", 10, GRID) == (3.0, 10.0)
    half = raster(tmp_path, np.full((20, 15), 7.0), "h.tif")
    with pytest.raises(InputError, match="wind speed has no data on 300 cells"):
        wind_planes(half, 0, GRID)
    far = raster(tmp_path, np.full((9, 9), 90.0), "f.tif", transform=square(20.0, (NORTH_WEST[0] + 9e4, NORTH_WEST[1])))
    with pytest.raises(InputError, match="wind direction has no data on 600 cells"):
        wind_planes(5, far, GRID)


def test_moisture_is_a_number_or_a_raster_of_shares(tmp_path):
    assert moisture_plane("0.1", GRID) == 0.1
    coarse = raster(tmp_path, np.full((5, 5), 0.08), transform=square(200.0))
    np.testing.assert_allclose(moisture_plane(coarse, GRID), 0.08, rtol=1e-6)
    percent = raster(tmp_path, np.full((20, 30), 8.0), "p.tif")
    with pytest.raises(InputError, match=r"up to 8, expected shares.*-scale 0\.01"):
        moisture_plane(percent, GRID)
    stored = raster(tmp_path, np.full((20, 30), 8.0), "q.tif", scale=(0.01, 0.0))
    np.testing.assert_allclose(moisture_plane(stored, GRID), 0.08, rtol=1e-6)


def twin_effect(moisture):
    """The published factor, term by term."""
    x = moisture / 0.3
    if x >= 1:
        return 0.0
    e = -11.507 * x**5 + 22.963 * x**4 - 17.331 * x**3 + 6.598 * x**2 - 1.7211 * x + 1.0003
    return min(max(e, 0.0), 1.0)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_moisture_of_the_cell_that_is_lit_lowers_the_probability(make_landscape, boundary):
    landscape = make_landscape((7, 9), seed=2, boundary=boundary)
    moisture = np.random.default_rng(5).uniform(0, 0.4, (7, 9))
    dry = spread_network(landscape, wind_speed=4, wind_from_direction=200).probability
    damp = spread_network(landscape, wind_speed=4, wind_from_direction=200, moisture=moisture).probability
    steps = [(-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1)]
    for d, (dr, dc) in enumerate(steps):
        for r in range(7):
            for c in range(9):
                expected = dry[d, r, c] * twin_effect(moisture[(r + dr) % 7, (c + dc) % 9])
                assert damp[d, r, c] == pytest.approx(expected, abs=1e-6)
    assert (damp < dry).any()


@settings(deadline=None)
@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_the_damper_the_less_it_burns(make_landscape, one, other):
    landscape = make_landscape((3, 4), seed=1, holes=0.0)
    low, high = sorted((one, other))
    p = [spread_network(landscape, moisture=m).probability for m in (0.0, low, high, 0.3)]
    np.testing.assert_array_equal(p[0], spread_network(landscape).probability)
    assert (p[1] >= p[2]).all()
    assert not p[3].any()


def test_impossible_moisture_is_refused(make_landscape):
    landscape = make_landscape((3, 4))
    for wrong in (-0.1, 8, np.full((3, 4), 1.5), np.full((3, 4), np.nan)):
        with pytest.raises(ParameterError, match="moisture"):
            spread_network(landscape, moisture=wrong)


def test_ignition_rasters_are_laid_on_the_grid(tmp_path):
    weights = np.zeros((8, 8))
    weights[2, 3] = 0.5
    path = raster(tmp_path, weights, transform=square(100.0))
    plane = ignition_source(path, GRID)
    assert plane.shape == GRID.shape
    assert 10 <= plane.argmax() // 30 < 15
    assert 15 <= plane.argmax() % 30 < 20
    assert ignition_source(None, GRID) is None
    assert ignition_source("points.gpkg", GRID) == "points.gpkg"


# Density from continuity


def continuity_twin(fuel):
    rows, cols = fuel.shape
    out = np.zeros(fuel.shape, int)
    for r in range(rows):
        for c in range(cols):
            share = fuel[max(r - 3, 0) : r + 4, max(c - 3, 0) : c + 4].mean()
            out[r, c] = 1 if share < 0.5 else 2 if share < 0.9 else 3
    return out


@given(st.integers(1, 20), st.integers(1, 20), st.integers(0, 99), st.floats(0.2, 1.0))
def test_continuity_is_the_share_of_fuel_around(rows, cols, seed, share):
    fuel = np.random.default_rng(seed).random((rows, cols)) < share
    np.testing.assert_array_equal(density_by_continuity(fuel), continuity_twin(fuel))


def test_density_from_continuity_in_a_landscape(tmp_path):
    dem = write(tmp_path / "d.tif", relief(30, 40))
    codes = patches(30, 40, [0, 1, 2, 3], size=4)
    data = read_landscape(dem, write(tmp_path / "v.tif", codes), "continuity")
    np.testing.assert_array_equal(data["density"], np.where(codes > 0, continuity_twin(codes > 0), 0))
    # Of a legend with densities only those that a raster would replace.
    table = tmp_path / "own.csv"
    table.write_text(
        "code,vegetation,density,label,density_from_raster\n0,none,,a,\n1,shrubs,dense,b,no\n2,pines,sparse,c,yes\n"
        "3,pines,sparse,d,yes\n"
    )
    mixed = read_landscape(dem, tmp_path / "v.tif", "continuity", legend=table)
    np.testing.assert_array_equal(mixed["density"].to_numpy()[codes == 1], 3)
    np.testing.assert_array_equal(mixed["density"].to_numpy()[codes > 1], data["density"].to_numpy()[codes > 1])


@real
def test_continuity_is_how_the_density_of_rhodes_was_made():
    import rasterio

    def read(name):
        with rasterio.open(shared("rhodes_20m", name)) as source:
            return source.read(1)

    fuel = read("rhodes_vegetation.tif") > 0
    found = np.where(fuel, density_by_continuity(fuel), 0)
    # There the land ends at the edge of the map; here what lies beyond is not counted.
    np.testing.assert_array_equal(found[3:-3, 3:-3], read("rhodes_density.tif")[3:-3, 3:-3])
