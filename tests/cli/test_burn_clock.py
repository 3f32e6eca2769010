"""firebreak burn with a clock, a weather, embers and breaks that fail: files, accounts, refusals."""

from __future__ import annotations

import json

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import rasterio
from click.testing import CliRunner
from shapely.geometry import LineString, Point

from firebreak_gis import (
    line_breaks,
    read_weather,
    simulate,
    spread_network,
    weather_networks,
    write_raster,
    write_vector,
)
from firebreak_gis.cli import firebreak
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape_folder, write_landscape
from firebreak_gis.schema import VARIABLES
from firebreak_gis.spread.raster import read_network

ROSE = "rose:NW=5x0.4,N=8x0.2"


def run(*words, code=0):
    """Run a command in this process and check its exit code."""
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


@pytest.fixture(scope="module")
def folder(tmp_path_factory, make_landscape):
    place = tmp_path_factory.mktemp("clock")
    landscape = make_landscape((30, 41), seed=3, relief=4.0)
    write_landscape(landscape, place / "land")
    run("network", place / "land", "-o", place / "net.tif", "--clock", "--wind-speed", 6, "--wind-from", 270)
    network = read_network(place / "net.tif")
    cut = np.zeros(network.shape, np.uint8)
    cut[:, 20] = 1
    write_raster(place / "cut.tif", network.grid.dataarray(cut, "breaks"))
    cell = np.argwhere(network.burnable)[300]
    start = gpd.GeoDataFrame(geometry=[Point(network.grid.x[cell[1]], network.grid.y[cell[0]])], crs=network.grid.crs)
    write_vector(place / "start.gpkg", start)
    return place


def test_products_are_those_of_simulate(folder):
    told = json.loads(
        run(
            "burn",
            folder / "net.tif",
            "-o",
            folder / "often.tif",
            "--breaks",
            folder / "cut.tif",
            "--duration",
            "2h",
            "--embers",
            "rate=500",
            "--hold",
            "0.47:200",
            "--ignitions",
            folder / "start.gpkg",
            "--runs",
            60,
            "--products",
            folder / "products",
            "--by",
            "30min,2h",
            "--size-classes",
            "1,5",
            "--flame-lengths",
            "1,3",
            "--sizes",
            folder / "sizes.csv",
            "--seed",
            4,
            "--json",
        ).stdout
    )["result"]
    names = {
        "burnt_by_30min.tif",
        "burnt_by_2h.tif",
        "arrival_time_10.tif",
        "arrival_time_50.tif",
        "burnt_from_0_ha.tif",
        "burnt_from_1_ha.tif",
        "burnt_from_5_ha.tif",
        "flames_above_1_m.tif",
        "flames_above_3_m.tif",
        "fire_paths.tif",
        "isochrones.gpkg",
        "fire_sizes.csv",
    }
    found = {path.name for path in (folder / "products").iterdir()}
    assert {name for name in found if not name.endswith(".qml")} == names
    assert {f"{name[:-4]}.qml" for name in names if name.endswith(".tif")} <= found
    assert {path.split("/")[-1] for path in told["files"]} == names | {"often.tif", "sizes.csv"}
    from firebreak_gis.simulation.embers import Embers
    from firebreak_gis.simulation.holding import Hold
    from firebreak_gis.simulation.products import Products

    network = read_network(folder / "net.tif")
    burns = simulate(
        network,
        breaks=np.arange(41) == 20 * np.ones((30, 1)),
        duration=7200,
        embers=Embers(rate=500.0),
        hold=Hold(0.47, 200.0),
        ignitions=folder / "start.gpkg",
        n_runs=60,
        seed=4,
        products=Products((1800.0, 7200.0), (0.1, 0.5), (1.0, 5.0), (1.0, 3.0), paths=True),
    )
    for name, data in (
        ("burnt_by_30min", burns["burnt_by"][0]),
        ("arrival_time_50", burns["arrival_time"][1]),
        ("burnt_from_5_ha", burns["burnt_in_class"][2]),
        ("flames_above_3_m", burns["flame_exceedance"][1]),
        ("fire_paths", burns["fire_paths"]),
    ):
        with rasterio.open(folder / "products" / f"{name}.tif") as source:
            values = source.read(1, masked=True).filled(np.nan)
            np.testing.assert_array_equal(values, data.to_numpy())
            assert source.descriptions[0].startswith(VARIABLES[data.name].text)
            assert source.units[0] == VARIABLES[data.name].units
            assert "0.47 of fires" in source.tags()["FIREBREAK_ASSUMPTIONS"]
    table = pd.read_csv(folder / "products" / "fire_sizes.csv")
    assert list(table.columns) == ["run", "cells", "ha", "duration_h", "ha_by_30min", "ha_by_2h"]
    np.testing.assert_array_equal(table["cells"], burns["fire_size"])
    assert (table["ha_by_2h"] == table["ha"]).all()
    assert pd.read_csv(folder / "sizes.csv").equals(table)
    fronts = gpd.read_file(folder / "products" / "isochrones.gpkg", layer="isochrones")
    median = burns["arrival_time"][1].to_numpy()
    assert fronts["hours"].tolist() == [0.5, 2.0]
    np.testing.assert_allclose(
        fronts["area_ha"], [(median <= t).sum() * network.grid.cell_area_ha for t in (1800, 7200)]
    )
    said = " ".join(told["assumptions"])
    assert all(
        word in said for word in ("burn 2 h", "each 200 m of break holds in 0.47", "assumed", "500 a burning km2")
    )


def test_a_folder_is_burnt_under_its_weather(folder):
    run(
        "burn",
        folder / "land",
        "-o",
        folder / "weather.tif",
        "--weather",
        ROSE,
        "--duration",
        "uniform:1h,3h",
        "--runs",
        50,
        "--sizes",
        folder / "weather.csv",
    )
    landscape = read_landscape_folder(folder / "land")
    networks = weather_networks(landscape, read_weather(ROSE))
    burns = simulate(networks[0].network, weather=networks, duration="uniform:1h,3h", n_runs=50)
    with rasterio.open(folder / "weather.tif") as source:
        np.testing.assert_array_equal(source.read(1, masked=True).filled(np.nan), burns["burn_frequency"])
        assert "weather of rose:NW" in source.tags()["FIREBREAK_ASSUMPTIONS"]
    table = pd.read_csv(folder / "weather.csv")
    assert set(table["weather"]) == {1, 2}
    assert table["duration_h"].between(1, 3).all()
    # One wind, no clock: the network of the folder.
    run("burn", folder / "land", "-o", folder / "plain.tif", "--wind-speed", 3, "--wind-from", 90, "--runs", 20)
    plain = simulate(spread_network(landscape, wind_speed=3.0, wind_from_direction=90.0), n_runs=20)
    with rasterio.open(folder / "plain.tif") as source:
        np.testing.assert_array_equal(source.read(1, masked=True).filled(np.nan), plain["burn_frequency"])


def test_barriers_that_may_fail(folder):
    network = read_network(folder / "net.tif")
    given = ["--duration", "3h", "--runs", 80, "--ignitions", folder / "start.gpkg", "--barriers", folder / "cut.tif"]
    shares = []
    for hold in (1.0, 0.5, 0.0):
        run("burn", folder / "net.tif", "-o", folder / "b.tif", *given, "--barriers-hold", hold, "--overwrite")
        with rasterio.open(folder / "b.tif") as source:
            shares.append(np.nansum(source.read(1, masked=True).filled(np.nan)))
    assert shares[0] < shares[1] < shares[2]
    free = simulate(network, duration="3h", n_runs=80, ignitions=folder / "start.gpkg")
    assert shares[2] == pytest.approx(float(free["burn_frequency"].sum()), rel=1e-6)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--duration", "8 parsecs"], "--duration is '8 parsecs'"),
        (["--duration", "weather"], "no weather is given"),
        (["--hold", "1.5"], "hold is 1.5"),
        (["--hold", "often"], "--hold is 'often'"),
        (["--embers", "speed=3"], "--embers has 'speed=3'"),
        (["--barriers-hold", "2"], "--barriers-hold"),
        (["--by", "-1h", "--products", "x"], "--by"),
        (["--weather", ROSE], "firebreak align"),
        (["--wind-speed", "5"], "firebreak align"),
        (["--ignition-times", "hour"], "times of ignitions"),
    ],
)
def test_what_cannot_be_is_said_in_the_words_of_the_command(folder, words, said):
    outcome = run("burn", folder / "net.tif", "-o", folder / "never.tif", *words, code=2)
    assert said in outcome.output + str(outcome.exception)
    assert not (folder / "never.tif").exists()


def test_a_network_without_times_refuses_a_clock(folder):
    landscape = read_landscape_folder(folder / "land")
    network = spread_network(landscape)
    write_raster(folder / "still.tif", network.to_raster())
    assert Grid.of(landscape["burnable"]).matches(network.grid)
    for words in (["--duration", "8h"], ["--products", folder / "none"], ["--embers", "on"]):
        outcome = run("burn", folder / "still.tif", "-o", folder / "never.tif", *words, code=3)
        assert "travel times" in outcome.output


def test_lines_with_a_width_stop_fires_and_keep_their_fuel(folder):
    network = read_network(folder / "net.tif")
    x = float(network.grid.x[20]) + network.grid.cell_size / 3
    wall = LineString([(x, network.grid.y[0] + 100), (x, network.grid.y[-1] - 100)])
    write_vector(folder / "wall.gpkg", gpd.GeoDataFrame({"wide": [9.0]}, geometry=[wall], crs=network.grid.crs))
    words = ("burn", folder / "net.tif", "--breaks", folder / "wall.gpkg", "--duration", "6h", "--runs", 60, "--json")
    found = {}
    for name, more in {"cells": (), "lines": ("--line-width", "9m"), "column": ("--line-width", "wide")}.items():
        found[name] = json.loads(run(*words, "-o", folder / f"{name}.tif", *more).stdout)
        with rasterio.open(folder / f"{name}.tif") as file:
            found[name]["burnt"] = file.read(1, masked=True).filled(np.nan)
    np.testing.assert_array_equal(found["lines"]["burnt"], found["column"]["burnt"])
    assert np.nanmax(found["cells"]["burnt"][:, 20]) == 0.0 < np.nanmax(found["lines"]["burnt"][:, 20])
    expected = simulate(
        network,
        breaks=line_breaks(folder / "wall.gpkg", network.grid, width=9.0),
        duration="6h",
        n_runs=60,
        seed=0,
    )["burn_frequency"]
    np.testing.assert_array_equal(found["lines"]["burnt"], expected)
    flames = json.loads(run(*words, "-o", folder / "wilson.tif", "--line-width", "wide", "--hold", "flame").stdout)
    assert flames["result"]["mean_ha"] > found["lines"]["result"]["mean_ha"]
    for code, more, told in (
        (2, ("--line-width", "-3"), "above 0"),
        (3, ("--line-width", "depth"), "no column 'depth'"),
        (2, ("--line-width", "3", "--breaks", folder / "cut.tif"), "raster"),
    ):
        assert told in run(*words, "-o", folder / "no.tif", *more, code=code).output
    assert "--breaks" in run("burn", folder / "net.tif", "-o", folder / "no.tif", "--line-width", 3, code=2).output
