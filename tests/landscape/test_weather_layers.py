"""Wind and moisture in any unit, by components, with gaps where nothing burns, with flags that are no weather."""

import json

import numpy as np
import pytest
import rasterio
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis import spread_network
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.landscape.weather_layers import WeatherReader
from firebreak_gis.planning.weather import SpreadRequest
from firebreak_gis.rasters import read_header
from tests.places import UTM, relief, square, write

GRID = Grid((20, 30), square(), parse_crs(UTM))
READER = WeatherReader(GRID)


def raster(folder, values, name="a.tif", **more):
    return str(write(folder / name, np.asarray(values, "float32"), **more))


# --- units


@pytest.mark.parametrize(
    ("unit", "factor"), [("km/h", 1 / 3.6), ("mph", 0.44704), ("knots", 1852 / 3600), ("m s-1", 1.0), ("cm/s", 0.01)]
)
@pytest.mark.parametrize("cell", [20.0, 7.0, 90.0])
def test_rasters_of_wind_are_taken_in_their_unit(tmp_path, unit, factor, cell):
    values = np.random.default_rng(0).uniform(5, 30, (60, 90))
    plain = READER.wind(raster(tmp_path, values * factor, "p.tif", transform=square(cell)), 0)[0]
    account = Account()
    path = raster(tmp_path, values, transform=square(cell), units=unit)
    told = WeatherReader(GRID, account=account).wind(path, 0)[0]
    np.testing.assert_allclose(told, plain, rtol=1e-5)
    assert any(f"turned from {unit}" in line for line in account.alignment) == (factor != 1)


@pytest.mark.parametrize("how", ["unit", "tag", "description"])
def test_a_unit_is_found_where_programs_write_it(tmp_path, how):
    path = raster(tmp_path, np.full((20, 30), 36.0), units="km/h" if how == "unit" else None)
    with rasterio.open(path, "r+") as target:
        if how == "tag":
            target.update_tags(1, units="km h-1")
        if how == "description":
            target.set_band_description(1, "wind speed at 10 m [km/h]")
    np.testing.assert_allclose(READER.wind(path, 0)[0], 10.0, rtol=1e-6)


def test_netcdf_keeps_its_unit(tmp_path):
    data = GRID.dataarray(np.full(GRID.shape, 36.0, np.float32), "wind_speed", units="km h-1")
    data.encoding["grid_mapping"] = "spatial_ref"
    data.to_dataset().to_netcdf(tmp_path / "w.nc", engine="scipy")
    np.testing.assert_allclose(READER.wind(f"{tmp_path}/w.nc:wind_speed", 0)[0], 10.0, rtol=1e-6)


def test_moisture_in_percent(tmp_path):
    path = raster(tmp_path, np.full((20, 30), 8.0), units="%")
    np.testing.assert_allclose(READER.moisture(path), 0.08, rtol=1e-6)
    assert READER.moisture("8%") == READER.moisture("8 %") == pytest.approx(0.08)
    assert READER.moisture(0.08) == 0.08


def test_directions_in_radians(tmp_path):
    path = raster(tmp_path, np.full((20, 30), np.pi / 2), units="radians")
    np.testing.assert_allclose(READER.wind(1, path)[1], 90.0, rtol=1e-6)


@pytest.mark.parametrize(("option", "unit"), [("wind_speed", "hPa"), ("moisture", "m3 m-3"), ("wind_from", "m/s")])
def test_units_of_something_else_are_refused(tmp_path, make_landscape, option, unit):
    landscape = make_landscape((20, 30))
    path = raster(tmp_path, np.full((20, 30), 0.5), units=unit)
    with pytest.raises(InputError, match=rf"is in '{unit}', expected a "):
        SpreadRequest(**{option: path}).params(landscape)


@pytest.mark.parametrize(
    ("text", "expected"), [("20km/h", 20 / 3.6), ("4bf", 0.836 * 8), ("10 kn", 18520 / 3600), ("3", 3.0), (3, 3.0)]
)
def test_numbers_take_units(text, expected):
    assert READER.wind(text, "90 deg") == (pytest.approx(expected), 90.0)


def test_what_is_neither_number_nor_raster_is_refused():
    with pytest.raises(ParameterError, match="neither a number nor a raster"):
        READER.wind("gale", 0)
    with pytest.raises(ParameterError, match="'furlongs' is no unit"):
        READER.wind("3 furlongs", 0)


# --- components


@settings(deadline=None, max_examples=30)
@given(st.floats(0.5, 20), st.floats(0, 359.9))
def test_components_are_the_wind_that_they_make_up(speed, direction):
    towards = np.radians(direction + 180)
    found = READER.components(speed * np.sin(towards), speed * np.cos(towards))
    assert found[0] == pytest.approx(speed, rel=1e-9)
    assert abs((found[1] - direction + 180) % 360 - 180) < 1e-6


def test_a_west_wind_blows_towards_the_east(tmp_path):
    u = raster(tmp_path, np.full((20, 30), 18.0), "u.tif", units="km/h")
    v = raster(tmp_path, np.zeros((20, 30)), "v.tif", units="km/h")
    speed, direction = READER.components(u, v)
    np.testing.assert_allclose(speed, 5.0, rtol=1e-6)
    np.testing.assert_allclose(direction, 270.0)


def test_a_component_given_as_a_speed_is_refused(tmp_path):
    u = raster(tmp_path, np.linspace(-5, 5, 600).reshape(20, 30))
    with pytest.raises(InputError, match=r"expected 0 to 60 m/s.*--wind-uv U V"):
        READER.wind(u, 0)


# --- gaps and flags


def island(make_landscape):
    """Fuel with a sea of 12 columns in the west."""
    fuel = np.zeros((20, 30), np.uint8)
    fuel[:, 12:] = 2
    return make_landscape((20, 30), holes=0.0, vegetation=fuel, density=fuel, burnable=fuel > 0)


@pytest.mark.parametrize("option", ["wind_speed", "wind_from", "moisture", "wind_uv"])
@pytest.mark.parametrize("cell", [20.0, 60.0])
def test_gaps_over_the_sea_change_nothing(tmp_path, make_landscape, option, cell):
    landscape = island(make_landscape)
    values = np.random.default_rng(1).uniform(0.05, 0.2, (20, 30))
    holed = values.copy()
    holed[:, : int(180 / cell)] = -9999
    sources = [
        raster(tmp_path, v, f"{i}.tif", nodata=-9999, transform=square(cell)) for i, v in enumerate((values, holed))
    ]
    networks = []
    for source in sources:
        given_ = {option: (source, source) if option == "wind_uv" else source}
        if option == "wind_from":
            given_["wind_speed"] = 5.0
        networks.append(spread_network(landscape, **SpreadRequest(**given_).params(landscape)).probability)
    assert networks[0].any()
    np.testing.assert_array_equal(networks[0][:, :, 14:], networks[1][:, :, 14:])
    assert not networks[1][:, :, :12].any()


def test_gaps_on_fuel_are_refused(tmp_path, make_landscape):
    landscape = island(make_landscape)
    values = np.full((20, 30), 5.0)
    values[:, :15] = -9999
    path = raster(tmp_path, values, nodata=-9999)
    with pytest.raises(InputError, match="wind speed has no data on 60 cells of the landscape that hold fuel"):
        SpreadRequest(wind_speed=path).params(landscape)
    with pytest.raises(ParameterError, match="with 60 gaps, expected 0 to 60 m s-1 in every cell with fuel"):
        spread_network(landscape, wind_speed=np.where(values < 0, np.nan, values))
    values[:, 12:15] = 5.0
    spread_network(landscape, wind_speed=np.where(values < 0, np.nan, values))


@pytest.mark.parametrize("cell", [20.0, 7.0, 90.0])
@pytest.mark.parametrize(
    ("option", "flag"), [("wind_speed", -1), ("wind_speed", 99), ("wind_from", 999), ("moisture", -1)]
)
def test_flags_are_found_before_they_are_mixed(tmp_path, make_landscape, option, flag, cell):
    values = np.full((90, 90), 0.5)
    values[5, 5] = flag
    path = raster(tmp_path, values, transform=square(cell))
    with pytest.raises(InputError, match=rf"of {flag:g} in 1 cells, expected .*-a_nodata"):
        SpreadRequest(**{option: path}).params(make_landscape((20, 30)))


def test_numpy_arrays_are_taken_on_the_grid(make_landscape):
    landscape = make_landscape((20, 30))
    u, v = np.full((20, 30), 3.0), np.full((20, 30), -4.0)
    found = SpreadRequest(wind_uv=(u, v), moisture=np.full((20, 30), 0.1)).params(landscape)
    np.testing.assert_allclose(found["wind_speed"], 5.0)
    directed = SpreadRequest(wind_speed=5.0, wind_from=np.full((20, 30), 350.0)).params(landscape)
    np.testing.assert_allclose(directed["wind_from_direction"], 350.0)
    with pytest.raises(InputError, match="has shape"):
        SpreadRequest(wind_speed=u[1:]).params(landscape)


# --- bands by number, and the command line


def test_a_band_is_named_by_its_number(tmp_path):
    path = str(write(tmp_path / "w.tif", np.stack([np.full((20, 30), v, np.float32) for v in (3, 7)])))
    with pytest.raises(InputError, match=r"2 bands; choose one .*by its number: .*w\.tif:1"):
        READER.wind(path, 0)
    np.testing.assert_array_equal(READER.wind(f"{path}:2", 0)[0], 7.0)
    assert read_header(f"{path}:1").band == 1
    with pytest.raises(InputError, match="has no band 3"):
        read_header(f"{path}:3")
    with pytest.raises(InputError, match="does not exist"):
        read_header(f"{tmp_path}/none.tif:2")


def run(*args):
    return CliRunner().invoke(firebreak, [str(arg) for arg in args])


def test_units_and_components_on_the_command_line(tmp_path):
    dem, vegetation = (
        write(tmp_path / "d.tif", relief(20, 30)),
        write(tmp_path / "v.tif", np.full((20, 30), 2, np.uint8)),
    )
    assert run("align", dem, vegetation, "normal", "-o", tmp_path / "land").exit_code == 0
    u = raster(tmp_path, np.full((20, 30), 18.0), "u.tif", units="km/h")
    v = raster(tmp_path, np.zeros((20, 30)), "z.tif", units="km/h")
    probabilities = []
    for wind in (
        ("--wind-speed", "5", "--wind-from", "270"),
        ("--wind-speed", "18km/h", "--wind-from", "270"),
        ("--wind-speed", u, "--wind-from", "270"),
        ("--wind-uv", u, v),
    ):
        done = run("network", tmp_path / "land", "-o", tmp_path / "n.tif", "--overwrite", *wind)
        assert done.exit_code == 0, done.stderr
        with rasterio.open(tmp_path / "n.tif") as source:
            probabilities.append(source.read())
    for other in probabilities[1:]:
        np.testing.assert_allclose(other, probabilities[0], atol=1e-6)
    network = ["network", tmp_path / "land", "-o", tmp_path / "n.tif", "--overwrite"]
    both = run(*network, "--wind-uv", u, v, "--wind-speed", 3)
    assert both.exit_code == 2
    assert "--wind-uv is the whole wind" in both.stderr
    wrong = run(*network, "--wind-speed", "5hPa")
    assert wrong.exit_code == 2
    assert "--wind-speed: '5hPa' is no wind speed" in wrong.stderr


def test_a_plan_keeps_what_was_done_to_the_weather_and_can_be_repeated(tmp_path):
    dem, vegetation = (
        write(tmp_path / "d.tif", relief(20, 30)),
        write(tmp_path / "v.tif", np.full((20, 30), 2, np.uint8)),
    )
    u = raster(tmp_path, np.full((20, 30), 18.0), "u.tif", units="km/h")
    plan = ["plan", dem, vegetation, "normal", "-o", tmp_path / "out", "--method", "random", "--runs", 5]
    plan += ["--moisture", "8%"]
    done = run(*plan, "--wind-uv", u, u)
    assert done.exit_code == 0, done.stderr
    assert "wind towards east: turned from km/h into m/s" in done.stderr
    kept = json.loads((tmp_path / "out/run.json").read_text())
    assert any("turned from km/h" in line for line in kept["alignment"])
    assert (kept["parameters"]["wind_uv"], kept["parameters"]["moisture"]) == ([u, u], 0.08)
    again = run("plan", "--config", tmp_path / "out/run.json", dem, vegetation, "normal", "-o", tmp_path / "again")
    assert again.exit_code == 0, again.stderr
    assert (tmp_path / "again/priority.tif").read_bytes() == (tmp_path / "out/priority.tif").read_bytes()


def test_a_dem_in_feet_gives_the_slopes_of_the_segments_in_metres(tmp_path):
    from firebreak_gis.landscape.planes import elevation_plane

    heights = relief(20, 30)
    metres = elevation_plane(write(tmp_path / "m.tif", heights), GRID)
    feet = elevation_plane(write(tmp_path / "f.tif", heights / np.float32(0.3048), units="ft"), GRID)
    np.testing.assert_allclose(feet, metres, rtol=1e-5)
