"""How commands talk: configurations, JSON, progress, stops, exit codes, plug-ins of rio, the paper's commands."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import rasterio
from click.testing import CliRunner

from firebreak_gis import spread_network
from firebreak_gis.cli import firebreak
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape_folder, write_landscape
from firebreak_gis.rasters import write_raster
from firebreak_gis.spread.raster import read_network
from firebreak_gis.vectors import write_vector

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data"
LAYERS = [str(SAMPLE / f"{name}.tif") for name in ("dem", "vegetation", "density")]


def run(*words, code=0):
    """Run a command in this process and check its exit code."""
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


def start(*words, **options):
    return subprocess.Popen(
        [sys.executable, "-u", "-m", "firebreak_gis", *map(str, words)],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        **{"env": {**os.environ, "PYTHONPATH": str(ROOT)}, **options},
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory, make_landscape):
    """A small landscape as files, its network and what a user may bring along."""
    place = tmp_path_factory.mktemp("small")
    landscape = make_landscape((24, 33), seed=3, relief=4.0)
    write_landscape(landscape, place / "land")
    network = spread_network(landscape)
    write_raster(place / "network.tif", network.to_raster())
    grid = Grid.of(landscape["burnable"])
    likely = np.where(network.burnable, 0.0, np.nan).astype(np.float32)
    fuel = np.argwhere(network.burnable)
    likely[tuple(fuel[:20].T)] = 0.5
    write_raster(place / "likely.tif", grid.dataarray(likely, "burn_frequency"))
    points = gpd.points_from_xy(grid.x[fuel[[5, 90], 1]], grid.y[fuel[[5, 90], 0]])
    write_vector(place / "points.gpkg", gpd.GeoDataFrame(geometry=points, crs="EPSG:32635").to_crs("EPSG:4326"))
    hole = np.argwhere(~network.burnable)[0]
    bare = gpd.points_from_xy(grid.x[hole[[1]]], grid.y[hole[[0]]])
    write_vector(place / "bare.gpkg", gpd.GeoDataFrame(geometry=bare, crs="EPSG:32635"))
    with rasterio.open(
        place / "wind.tif",
        "w",
        driver="GTiff",
        count=1,
        height=24,
        width=33,
        dtype="float32",
        crs="EPSG:32635",
        transform=grid.transform,
    ) as target:
        target.write(np.full((1, 24, 33), 6.0, np.float32))
    return place


def layers(folder):
    return [folder / f"land/{name}.tif" for name in ("elevation", "vegetation", "density")]


def read(path):
    with rasterio.open(path) as source:
        return source.read(masked=True)


def json_lines(text):
    return [json.loads(line) for line in text.splitlines() if line.startswith("{")]


def test_configuration_by_the_names_of_the_options(folder, tmp_path):
    config = tmp_path / "my.toml"
    config.write_text(
        'runs = 7\nbudget = 0.2\nmethod = "flammability"\nwind-speed = 3.5\nwind_from = 45\nseed = 5\n'
        "[model-param]\np0 = 0.4\n"
    )
    run("plan", *layers(folder), "-o", tmp_path / "out", "--config", config, "--seed", "8")
    told = json.loads((tmp_path / "out/run.json").read_text())["parameters"]
    assert told["n_runs"] == 7
    assert told["seed"] == 8
    assert told["model_params"] == {"p0": "0.4"}
    assert len(pd.read_csv(tmp_path / "out/fire_sizes.csv")) == 7
    run("plan", "--config", tmp_path / "out/run.json", "-o", tmp_path / "again", "--budget", "0.1")
    assert read(tmp_path / "again/breaks.tif").sum() < read(tmp_path / "out/breaks.tif").sum()
    np.testing.assert_array_equal(read(tmp_path / "again/priority.tif"), read(tmp_path / "out/priority.tif"))


def test_options_of_layers_survive_the_configuration(tmp_path):
    bounds = ("587000", "4005000", "589400", "4006800")
    words = ["--bounds", *bounds, "--res", "100", "--src-nodata", "dem=-9999", "--bidx", "density=1"]
    run("plan", *LAYERS, "-o", tmp_path / "one", *words, "--runs", 3, "--method", "random", "-q")
    run("plan", "--config", tmp_path / "one/run.json", "-o", tmp_path / "two", "-q")
    assert read(tmp_path / "one/elevation.tif").shape == (1, 18, 24)
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "two" / path.name).read_bytes(), path.name


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("colour = 3", "colour"),
        ("runs = 'many'", "many"),
        ("output = 3\nbudget = 2.0", "from 0 to 1"),
        ("= 3", "cannot read"),
    ],
)
def test_wrong_configurations(folder, tmp_path, text, word):
    config = tmp_path / "my.toml"
    config.write_text(text)
    outcome = run("plan", *layers(folder), "-o", tmp_path / "out", "--config", config, code=2)
    assert word in outcome.output


def test_usage_errors_are_json_too(folder):
    for words in (["plan", "--nonsense"], ["nothing"], ["rank", "--method"], ["burn", "x.tif"]):
        outcome = run(*words, "--json", code=2)
        (line,) = json_lines(outcome.stdout)
        assert line["error"]["kind"] == "usage"
        assert line["error"]["exit_code"] == 2
        assert not json_lines(run(*words, code=2).stdout)


def test_bugs_say_so(folder, tmp_path, monkeypatch):
    monkeypatch.setattr("firebreak_gis.ranking.rankings", lambda *_, **__: 1 / 0)
    outcome = run("rank", folder / "network.tif", "-o", tmp_path / "p.tif", "--json", code=1)
    (line,) = json_lines(outcome.stdout)
    assert line["error"]["kind"] == "bug"
    assert "ZeroDivisionError" in line["error"]["message"]
    assert "please report" in outcome.stderr
    monkeypatch.setattr("firebreak_gis.ranking.rankings", lambda *_, **__: (_ for _ in ()).throw(MemoryError()))
    assert "out of memory" in run("rank", folder / "network.tif", "-o", tmp_path / "p.tif", code=5).stderr


def test_results_as_json_and_quiet(folder, tmp_path):
    outcome = run("rank", folder / "network.tif", "-o", tmp_path / "p.tif", "--method", "degree", "--json")
    (line,) = json_lines(outcome.stdout)
    assert line["result"]["files"] == [str(tmp_path / "p.tif")]
    assert outcome.stdout.count("\n") == 1
    quiet = run("breaks", tmp_path / "p.tif", "-o", tmp_path / "b.tif", "-q")
    assert quiet.output == ""
    assert "cells cut" in run("breaks", tmp_path / "p.tif", "-o", tmp_path / "b.tif", "--overwrite").stdout


def test_ignitions_of_every_kind(folder, tmp_path):
    burns = {}
    for name in ("points.gpkg", "likely.tif"):
        run(
            "burn", folder / "network.tif", "-o", tmp_path / f"{name}.f.tif", "--ignitions", folder / name, "--runs", 40
        )
        burns[name] = read(tmp_path / f"{name}.f.tif")[0]
    assert (burns["points.gpkg"] >= 0.499).sum() >= 2
    all_at_once = ["--ignition-mode", "all", "--ignitions", folder / "points.gpkg"]
    run("burn", folder / "network.tif", "-o", tmp_path / "all.tif", *all_at_once, "--runs", 40)
    assert (read(tmp_path / "all.tif")[0] == 1).sum() >= 2
    outcome = run(
        "burn", folder / "network.tif", "-o", tmp_path / "no.tif", "--ignitions", folder / "bare.gpkg", code=3
    )
    assert "point 1" in outcome.output
    assert "without fuel" in outcome.output
    run("burn", folder / "network.tif", "-o", tmp_path / "no.tif", "--ignitions", folder / "none.gpkg", code=3)
    assert not (tmp_path / "no.tif").exists()


def test_wind_as_a_number_and_as_a_raster(folder, tmp_path):
    run("network", folder / "land", "-o", tmp_path / "a.tif", "--wind-speed", "6", "--wind-from", "90")
    run("network", folder / "land", "-o", tmp_path / "b.tif", "--wind-speed", folder / "wind.tif", "--wind-from", "90")
    one, two = read(tmp_path / "a.tif"), read(tmp_path / "b.tif")
    np.testing.assert_array_equal(one, two)
    assert one[6].mean() > one[2].mean()  # from the east: to the west more than to the east
    wrong = ["--wind-speed", tmp_path / "none.tif"]
    assert "neither a number" in run("network", folder / "land", "-o", tmp_path / "c.tif", *wrong, code=2).output
    outcome = run("network", folder / "land", "-o", tmp_path / "c.tif", "--model-param", "p0", code=2)
    assert "NAME=VALUE" in outcome.output


def test_outputs_never_replace_inputs(folder, tmp_path):
    elevation = folder / "land/elevation.tif"
    before = elevation.read_bytes()
    run("network", folder / "land", "-o", elevation, "--overwrite", code=4)
    run("plan", *layers(folder), "-o", folder / "land", "--overwrite", "--runs", 2, code=4)
    assert elevation.read_bytes() == before
    link = tmp_path / "link.tif"
    link.symlink_to(folder / "likely.tif")
    before = (folder / "likely.tif").read_bytes()
    run("burn", folder / "network.tif", "--ignitions", folder / "likely.tif", "-o", link, "--overwrite", code=4)
    assert (folder / "likely.tif").read_bytes() == before


def test_wrong_number_of_threads_is_a_usage_error(folder, tmp_path, monkeypatch):
    monkeypatch.setenv("FIREBREAK_THREADS", "many")
    assert "FIREBREAK_THREADS" in run("burn", folder / "network.tif", "-o", tmp_path / "f.tif", code=2).output


def test_progress_lines_and_a_listener_that_says_nothing(folder, tmp_path):
    """Whoever drives the program keeps its input open; it must end well all the same."""
    words = ["burn", folder / "network.tif", "-o", tmp_path / "f.tif", "--runs", "300", "--progress", "json"]
    with start(*words, stdin=subprocess.PIPE) as process:
        out = process.stdout.read()
        assert process.wait(timeout=60) == 0, process.stderr.read()
        assert process.stderr.read() == ""
    lines = json_lines(out)
    assert len(lines) == len(out.splitlines())
    shares = [line["progress"] for line in lines if "progress" in line]
    assert shares == sorted(shares)
    assert shares
    assert lines[-1]["result"]["files"] == [str(tmp_path / "f.tif")]


@pytest.mark.parametrize("method", ["dissection", "betweenness"])
def test_ctrl_c_while_ranking_leaves_nothing(tmp_path, method):
    """Interrupted in the middle of the longest step, for a person who waits at a terminal."""
    target = tmp_path / "out"
    words = ["plan", *LAYERS, "-o", target, "--method", method, "--runs", "100", "--progress", "json"]
    process = start(*words, stdin=subprocess.PIPE)
    for line in process.stdout:
        if "rank by" in json.loads(line).get("message", ""):
            break
    time.sleep(0.5)
    asked = time.perf_counter()
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=60)
    assert process.returncode == 130
    assert time.perf_counter() - asked < 8
    assert json_lines(out)[-1]["error"]["kind"] == "cancelled"
    assert not target.exists() or not list(target.iterdir())


def test_ctrl_c_without_json_is_said_in_words(folder, tmp_path):
    process = start(
        "burn", folder / "network.tif", "-o", tmp_path / "f.tif", "--runs", "20000000", stdin=subprocess.DEVNULL
    )
    time.sleep(4)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130, err
    assert "stopped" in err
    assert "Traceback" not in err
    assert out == ""
    assert not list(tmp_path.iterdir())


def test_rio_finds_the_commands(tmp_path):
    """The entry points of pyproject.toml, as an installer would write them."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    info = tmp_path / "firebreak_gis-0.0.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: firebreak_gis\nVersion: 0.0.0\n")
    groups = {"console_scripts": project["scripts"], **project["entry-points"]}
    lines = [f"[{name}]\n" + "".join(f"{k} = {v}\n" for k, v in entries.items()) for name, entries in groups.items()]
    (info / "entry_points.txt").write_text("\n".join(lines))
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(tmp_path), str(ROOT)])}

    def rio(*words):
        command = [sys.executable, "-c", "from rasterio.rio.main import main_group; main_group()"]
        return subprocess.run([*command, *words], env=environment, capture_output=True, text=True)

    shown = rio("firebreak", "--help")
    assert shown.returncode == 0, shown.stderr
    assert "Plan wildfire fire breaks" in shown.stdout
    found = json_lines(rio("firebreak", "describe", "--json").stdout)[0]["result"]
    assert "plan" in found["commands"]
    failed = rio("firebreak", "rank", str(tmp_path / "none.tif"), "-o", str(tmp_path / "p.tif"), "--json")
    assert failed.returncode == 3
    assert json_lines(failed.stdout)[0]["error"]["kind"] == "input"


def test_description_holds_every_command_and_option():
    found = json_lines(run("describe", "--json").stdout)[0]["result"]
    help_page = run("--help").output
    for name, entry in found["commands"].items():
        assert name in help_page
        assert entry["summary"]
        inner = entry.get("commands", {"": entry})
        for word, command in inner.items():
            page = run(*[w for w in (name, word) if w], "--help").output
            for p in command.get("parameters", []):
                for flag in p.get("flags", []):
                    assert flag in page, (name, flag)
                assert not p.get("flags") or p["help"]
    assert set(found["commands"]["reproduce"]["commands"]) == {"artificial-forest", "landscape"}


def test_reproduce_the_artificial_forest(tmp_path):
    words = ["reproduce", "artificial-forest", "--forests", 2, "--runs", 2, "--seed", 4]
    run(*words, "-o", tmp_path / "one")
    run(*words, "-o", tmp_path / "two", "-q")
    names = {"curve.csv", "summary.json", "figure_1.png", "figure_1.svg", "run.json"}
    assert {p.name for p in (tmp_path / "one").iterdir()} == names
    for name in names:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes(), name
    rows = pd.read_csv(tmp_path / "one/curve.csv")
    assert list(rows.columns) == ["method", "beta", "d_f", "mean", "p90", "max", "p_value"]
    assert {"bonacich", "betweenness", "closeness", "degree", "eigenvector", "random"} <= set(rows["method"])
    assert rows.groupby(["method", "beta"], dropna=False).size().nunique() == 1
    assert (rows.loc[rows["d_f"] == 0, "mean"].nunique()) == 1
    found = json.loads((tmp_path / "one/summary.json").read_text())
    for label, row in found["methods"].items():
        method, _, beta = label.partition(" ")
        curve = rows[(rows["method"] == method) & (rows["beta"].isna() if not beta else rows["beta"] == float(beta))]
        fallen = curve.loc[curve["mean"] < 0.3, "d_f"]
        assert row["d_f_below_0.3"] == (fallen.min() if len(fallen) else None)
    run(*words, "-o", tmp_path / "one", code=4)
    run("reproduce", "artificial-forest", "--forests", 0, "-o", tmp_path / "three", code=2)


def test_reproduce_on_the_sample_landscape(tmp_path):
    run("reproduce", "landscape", "-o", tmp_path / "out", "--res", "120", "--runs", "10", "-q")
    names = {f"figure_{k}.png" for k in (3, 4, 5, 6)} | {"evaluation.csv", "cut_cells.csv", "run.json"}
    names |= {"figure_4a.tif", "figure_4a.qml", "class_shares.csv", "class_shares.png"}
    assert {p.name for p in (tmp_path / "out").iterdir()} == names
    cut = pd.read_csv(tmp_path / "out/cut_cells.csv")
    np.testing.assert_allclose(cut[["sparse", "normal", "dense"]].sum(axis=1), 1)
    assert "without VEGETATION" in run("reproduce", "landscape", LAYERS[0], "-o", tmp_path / "no", code=2).output
    outside = ["--ignition", "0", "0", "--res", "120", "-o", tmp_path / "no"]
    assert "outside the grid" in run("reproduce", "landscape", *outside, code=3).output


def test_evaluation_can_be_run_again_from_its_account(folder, tmp_path):
    words = ["--methods", "degree,random", "--budgets", "0,0.1", "--runs", 15, "--test", "ranksum", "--seed", 2]
    run("evaluate", folder / "network.tif", *words, "-o", tmp_path / "one")
    run("evaluate", "--config", tmp_path / "one/run.json", "-o", tmp_path / "two")
    for path in (tmp_path / "one").iterdir():
        assert path.read_bytes() == (tmp_path / "two" / path.name).read_bytes(), path.name
    for wrong in (["--budgets", "0,x"], ["--budgets", "2"], ["--baseline", "nobody"], ["--methods", "degree,degree"]):
        run("evaluate", folder / "network.tif", *wrong, "--runs", 3, "-o", tmp_path / "three", code=2)


def test_network_with_a_clock(folder, tmp_path):
    weather = ["--wind-speed", "6", "--wind-from", "90"]
    outcome = run("network", folder / "land", "-o", tmp_path / "timed.tif", "--clock", *weather)
    assert "in the times alone: wind and slope" in outcome.output
    network = read_network(tmp_path / "timed.tif")
    expected = spread_network(read_landscape_folder(folder / "land"), clock=True, wind_speed=6, wind_from_direction=90)
    np.testing.assert_array_equal(network.travel_time, expected.travel_time)
    np.testing.assert_array_equal(network.heat, expected.heat)
    assert network.provenance == expected.provenance
    assert network.provenance == {"left_out": "wind and slope", "wind_speed": 6.0, "wind_from_direction": 90.0}
    given = ["--clock", "--model", "raster", "--model-param"]
    run("network", folder / "land", "-o", tmp_path / "again.tif", *given, f"path={tmp_path / 'timed.tif'}")
    again = read_network(tmp_path / "again.tif")
    np.testing.assert_array_equal(again.travel_time, expected.travel_time)
    assert again.provenance == network.provenance
    outcome = run(
        "network", folder / "land", "-o", tmp_path / "no.tif", *given, f"path={folder / 'network.tif'}", code=3
    )
    assert "--clock needs travel times" in outcome.output
    outcome = run("network", folder / "land", "-o", tmp_path / "no.tif", "--clock", "--model", "artificial", code=2)
    assert "tells no times" in outcome.output
    run("rank", tmp_path / "timed.tif", "--method", "degree", "-o", tmp_path / "rank.tif")
    outcome = run("burn", tmp_path / "timed.tif", "-o", tmp_path / "burn.tif")
    assert "wind and slope act on its travel times alone" in outcome.output
    assert "Warning" not in run("burn", folder / "network.tif", "-o", tmp_path / "plain.tif").output


def test_weather_is_shown_as_it_is_read(tmp_path):
    table = tmp_path / "weather.csv"
    table.write_text("FF,DD,TMP\n36,270,31\n18,90,30\n")
    assert "'FF' is not known" in run("weather", table, code=3).output
    words = [
        "--weather-column",
        "wind_speed=FF",
        "--weather-column",
        "wind_from=DD",
        "--weather-unit",
        "wind_speed=km/h",
    ]
    told = json.loads(run("weather", table, *words, "--weather-ignore", "TMP", "--json").output)["result"]
    assert [spell["steps"] for spell in told["spells"]] == [[[10.0, 270.0, None]], [[5.0, 90.0, None]]]
    assert told["mean_wind_speed"] == 7.5
    outcome = run("weather", table, *words, "--weather-ignore", "TMP", "--weather-step", "2h")
    assert "one weather that changes with time, 2 steps" in outcome.output
    assert "2 h" in outcome.output
    assert "66.7%" in run("weather", "rose:NW=5x2,N=8").output
    assert "expected where the wind comes from" in run("weather", "rose:NW5", code=2).output
