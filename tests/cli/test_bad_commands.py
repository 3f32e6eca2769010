"""Every bad option and output as one table, and what --dry-run tells; bad inputs have a table of their own."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import geopandas as gpd
import numpy as np
import pytest
from click.testing import CliRunner
from shapely.geometry import Point

from firebreak_gis import memory
from firebreak_gis.cli import firebreak
from tests.places import NORTH_WEST, patches, relief, three, write

ROWS, COLS = 24, 31
LAYERS = ["dem.tif", "vegetation.tif", "density.tif"]
PLAN = ["plan", *LAYERS, "--method", "random", "--runs", "5"]
FUEL = patches(ROWS, COLS, [0, 1, 2, 3]) > 0


def point(name, row, col):
    place = Point(NORTH_WEST[0] + 20 * (col + 0.5), NORTH_WEST[1] - 20 * (row + 0.5))
    return lambda f: gpd.GeoDataFrame(geometry=[place], crs="EPSG:32635").to_file(f / name)


def bare(f):
    row, col = np.argwhere(~FUEL)[0]
    point("bare.gpkg", row, col)(f)


def link(name, target):
    return lambda f: (f / name).symlink_to(f / target)


def hard_link(f):
    (f / "out").mkdir()
    os.link(f / "dem.tif", f / "out/elevation.tif")


def text(name, content="mine"):
    def make(f):
        (f / name).parent.mkdir(exist_ok=True)
        (f / name).write_text(content)

    return make


def ignitions_of_zero(f):
    write(f / "likely.tif", np.zeros((ROWS, COLS), "float32"))


#: Row: maker, words, exit code, parts of the message.
COMMANDS = {
    "budget NaN": (None, [*PLAN, "-o", "out", "--budget", "nan"], 2, ["budget is nan", "from 0 to 1"]),
    "budget negative": (None, [*PLAN, "-o", "out", "--budget", "-0.1"], 2, ["budget is -0.1"]),
    "budget above 1": (None, [*PLAN, "-o", "out", "--budget", "1.5"], 2, ["14 % is 0.14"]),
    "budget of apples": (None, [*PLAN, "-o", "out", "--budget", "5 apples"], 2, ["5 apples", "10%", "5ha", "20000eur"]),
    "budget with a comma": (None, [*PLAN, "-o", "out", "--budget", "20,000eur"], 2, ["a point stands before decimals"]),
    "budget of two units": (
        None,
        [*PLAN, "-o", "out", "--budget", "5ha", "--budget-unit", "cost"],
        2,
        ["counts hectares", "given as cost", "leave the unit away"],
    ),
    "budget of too many percent": (None, [*PLAN, "-o", "out", "--budget", "140%"], 2, ["budget is 1.4"]),
    "money without costs": (None, [*PLAN, "-o", "out", "--budget", "20000eur"], 2, ["--cost"]),
    "hectares NaN": (None, [*PLAN, "-o", "out", "--budget", "nan", "--budget-unit", "ha"], 2, ["budget is nan"]),
    "hectares negative": (None, [*PLAN, "-o", "out", "--budget", "-5", "--budget-unit", "ha"], 2, ["budget is -5"]),
    "no runs": (None, [*PLAN[:-2], "--runs", "0", "-o", "out"], 2, ["n_runs is 0"]),
    "wind negative": (None, [*PLAN, "-o", "out", "--wind-speed", "-1"], 2, ["wind_speed", "at least 0"]),
    "wind from 400": (None, [*PLAN, "-o", "out", "--wind-from", "400"], 2, ["wind_from_direction", "at most 360"]),
    "wind a word": (None, [*PLAN, "-o", "out", "--wind-speed", "fast"], 2, ["neither a number nor a raster"]),
    "moisture in percent": (None, [*PLAN, "-o", "out", "--moisture", "8"], 2, ["moisture", "at most 1"]),
    "seed negative": (None, [*PLAN, "-o", "out", "--seed", "-1"], 2, ["seed is -1"]),
    "residual above 1": (None, [*PLAN, "-o", "out", "--residual", "1.2"], 2, ["residual is 1.2"]),
    "no such method": (None, [*PLAN, "-o", "out", "--method", "magic"], 2, ["'magic'", "dissection"]),
    "no such parameter": (None, [*PLAN, "-o", "out", "-p", "gamma=1"], 2, ["gamma"]),
    "no-data a word": (None, [*PLAN, "-o", "out", "--src-nodata", "dem=low"], 2, ["--src-nodata dem is 'low'"]),
    "no-data of what": (None, [*PLAN, "-o", "out", "--src-nodata", "wind=0"], 2, ["'wind'", "vegetation"]),
    "resolution zero": (None, [*PLAN, "-o", "out", "--res", "0"], 2, ["resolution is 0", "positive"]),
    "memory a word": (None, [*PLAN, "-o", "out", "--max-memory", "much"], 2, ["such as 4GB"]),
    "ignition outside": (
        point("far.gpkg", 999, 0),
        [*PLAN, "-o", "out", "--ignitions", "far.gpkg"],
        3,
        ["point 1", "outside the grid"],
    ),
    "ignition without fuel": (bare, [*PLAN, "-o", "out", "--ignitions", "bare.gpkg"], 3, ["point 1", "without fuel"]),
    "ignitions missing": (None, [*PLAN, "-o", "out", "--ignitions", "none.gpkg"], 3, ["none.gpkg does not exist"]),
    "ignitions of zero": (
        ignitions_of_zero,
        [*PLAN, "-o", "out", "--ignitions", "likely.tif"],
        3,
        ["ignition is zero on every cell"],
    ),
    "barriers missing": (None, [*PLAN, "-o", "out", "--barriers", "none.gpkg"], 3, ["--barriers none.gpkg"]),
    "output exists": (text("out/breaks.tif"), [*PLAN, "-o", "out"], 4, ["breaks.tif exists", "--overwrite"]),
    "output is an input": (
        lambda f: (f / "dem.tif").rename(f / "elevation.tif"),
        ["align", "elevation.tif", *LAYERS[1:], "-o", ".", "--overwrite"],
        4,
        ["is the input", "never changed"],
    ),
    "output is an input by link": (
        lambda f: [(f / "out").mkdir(), (f / "out/elevation.tif").symlink_to(f / "dem.tif")],
        ["align", *LAYERS, "-o", "out", "--overwrite"],
        4,
        ["is the input", "dem.tif"],
    ),
    "output is an input by hard link": (
        hard_link,
        ["align", *LAYERS, "-o", "out", "--overwrite"],
        4,
        ["is the input", "dem.tif"],
    ),
    "folder is a file": (text("file"), [*PLAN, "-o", "file"], 2, ["is a file"]),
    "folder under a file": (text("file"), [*PLAN, "-o", "file/out"], 4, ["file"]),
    "network too large": (None, ["rank", "net.tif", "-o", "p.tif", "--max-memory", "200MB"], 5, ["rank on 24 x 31"]),
    "landscape too large": (
        lambda f: call("align", *LAYERS, "-o", "land"),
        ["network", "land", "-o", "n.tif", "--max-memory", "200MB"],
        5,
        ["network on 24 x 31"],
    ),
    "layer for a landscape": (
        None,
        ["network", "dem.tif", "-o", "n.tif"],
        2,
        ["dem.tif is a file", "firebreak align DEM"],
    ),
    "layer for a network": (
        None,
        ["rank", "dem.tif", "-o", "p.tif"],
        3,
        ["dem.tif has 1 bands", "firebreak network makes"],
    ),
    "landscape for a layer": (
        lambda f: call("align", *LAYERS, "-o", "land"),
        ["plan", "land", "-o", "out"],
        3,
        ["land is a folder", *(str(Path("land", f"{name}.tif")) for name in ("density", "elevation", "vegetation"))],
    ),
    "plan for its segments": (
        lambda f: [(f / "some").mkdir(), point("some/segments.gpkg", 3, 3)(f)],
        ["export", "some", "-o", "s.kml"],
        3,
        ["some is a folder, expected a vector file", str(Path("some", "segments.gpkg"))],
    ),
    "folder of no features": (text("some/file"), [*PLAN, "-o", "out", "--barriers", "some"], 3, ["some is a folder"]),
    "folder for a layer": (
        text("some/file"),
        ["plan", "some", "-o", "out"],
        3,
        ["some is a folder, expected a raster"],
    ),
    "folder missing": (None, ["rank", "net.tif", "-o", "no/p.tif"], 4, ["no", "does not exist"]),
    "dry run, output exists": (text("out/run.json"), [*PLAN, "-o", "out", "--dry-run"], 4, ["run.json exists"]),
    "dry run, budget above 1": (None, [*PLAN, "-o", "out", "--budget", "2", "--dry-run"], 2, ["budget is 2"]),
    "dry run, layer missing": (None, ["align", "no.tif", *LAYERS[1:], "-o", "out", "--dry-run"], 3, ["does not exist"]),
    "dry run, too large": (None, [*PLAN, "-o", "out", "--max-memory", "300MB", "--dry-run"], 5, ["a plan of 24 x 31"]),
    "dry run, layer narrower, strict": (
        lambda f: write(f / "density.tif", patches(ROWS, 10, [1, 2, 3])),
        ["align", *LAYERS, "-o", "out", "--dry-run", "--strict"],
        0,
        ["24 x 10 cells"],
    ),
}


def listing(folder):
    return {
        str(p.relative_to(folder)): p.read_bytes() if p.is_file() else None
        for p in sorted(folder.rglob("*"))
        if p.name != "net.tif"
    }


@pytest.fixture
def place(tmp_path, monkeypatch):
    three(tmp_path, ROWS, COLS)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def call(*words):
    return CliRunner().invoke(firebreak, [str(w) for w in words])


@pytest.mark.parametrize("row", COMMANDS)
def test_commands(row, place):
    make, words, code, parts = COMMANDS[row]
    if make is not None:
        make(place)
    if "net.tif" in words:
        write(place / "net.tif", np.full((8, ROWS, COLS), 0.5, "float32"))
    before = listing(place)
    outcome = call(*words)
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    for part in parts:
        assert part in outcome.output, (part, outcome.output)
    assert "Traceback" not in outcome.output
    # Inputs and old outputs are as they were, and nothing was begun.
    assert listing(place) == before
    if code:
        outcome = call(*words, "--json", "-q")
        (line,) = [json.loads(text) for text in outcome.stdout.splitlines()]
        assert line["error"]["exit_code"] == code == outcome.exit_code
        assert listing(place) == before


def test_a_full_disk_is_seen_before_the_start(place, monkeypatch):
    usage = shutil.disk_usage(place)
    monkeypatch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=500_000))
    for words in (["align", *LAYERS], PLAN, [*PLAN, "--dry-run"]):
        outcome = call(*words, "-o", "out")
        assert outcome.exit_code == 4
        assert "0.5 MB free" in outcome.output
        assert "free some space" in outcome.output
    assert not (place / "out").exists()
    monkeypatch.setattr(shutil, "disk_usage", lambda _: usage._replace(free=2_000_000))
    assert "has 2 MB free, the work takes up to" in call("align", *LAYERS, "-o", "out").output


def test_a_dry_run_tells_what_the_run_will_do(place):
    before = listing(place)
    words = [*PLAN, "--res", "30", "--wind-speed", "4", "-o", "deep/out"]
    outcome = call(*words, "--dry-run", "--json", "-q")
    told = json.loads(outcome.stdout)["result"]
    assert listing(place) == before
    assert told["cells"] == 16 * 20
    assert told["memory_bytes"] == memory.bytes_for("plan", 320, method="random", clock=True)
    assert told["memory_limit_bytes"] == memory.allowed()
    shared = json.loads(call(*words, "--workers", "3", "--dry-run", "--json", "-q").stdout)["result"]
    assert shared["memory_bytes"] == memory.bytes_for("plan", 320, method="random", clock=True, workers=3)
    assert shared["memory_bytes"] > 2 * told["memory_bytes"]
    shown = call(*words, "--dry-run").output
    assert "nothing was written" in shown
    assert all(path in shown for path in told["files"])
    assert call(*words, "-q").exit_code == 0
    done = json.loads((place / "deep/out/run.json").read_text())
    assert done["grid"] == told["grid"]
    assert done["alignment"][: len(told["alignment"])] == told["alignment"]
    written = {str(p) for p in (place / "deep/out").iterdir() if p.suffix != ".qml"}
    assert written == {str(place / path) for path in told["files"]}
    size = sum(p.stat().st_size for p in (place / "deep/out").iterdir())
    assert size < told["disk_bytes"]


def test_a_dry_run_reads_no_values(place, monkeypatch):
    """Headers only: values that cannot be read do not matter yet."""
    values = relief(ROWS, COLS).copy()
    values[3, 3] = np.inf
    write(place / "dem.tif", values)
    assert call("align", *LAYERS, "-o", "out", "--dry-run").exit_code == 0
    assert call("align", *LAYERS, "-o", "out").exit_code == 3
