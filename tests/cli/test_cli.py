"""The command line end to end on the sample landscape; every output is opened anew by other means."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import rasterio
from click.testing import CliRunner

from firebreak_gis import plugins
from firebreak_gis.cli import firebreak
from firebreak_gis.files.outputs import names
from firebreak_gis.planning.outputs import OUTPUTS

ROOT = Path(__file__).parents[2]
SAMPLE = ROOT / "sample_data"
LAYERS = [str(SAMPLE / f"{name}.tif") for name in ("dem", "vegetation", "density")]
COARSE = ["--res", "60"]


def run(*words, code=0):
    """Run a command in this process; returns the outcome after checking the exit code."""
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


def hashes(folder, leave=()):
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(folder.iterdir()) if p.name not in leave}


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    folder = tmp_path_factory.mktemp("plan") / "out"
    run(
        "plan",
        *LAYERS,
        "-o",
        folder,
        "--budget",
        "0.14",
        "--method",
        "bonacich",
        "-p",
        "beta=0.5",
        "--runs",
        "60",
        "--seed",
        "3",
        "--timeless",
        *COARSE,
    )
    return folder


@pytest.fixture(scope="module")
def network(tmp_path_factory):
    folder = tmp_path_factory.mktemp("steps")
    run("align", *LAYERS, "-o", folder / "land", *COARSE)
    run("network", folder / "land", "-o", folder / "network.tif")
    return folder / "network.tif"


def test_plan_writes_every_file_and_styles(plan):
    found = {p.name for p in plan.iterdir()}
    assert set(names(OUTPUTS, ())) <= found
    assert {p.stem for p in plan.glob("*.tif")} == {p.stem for p in plan.glob("*.qml")}
    assert not [name for name in found if name.startswith(".")]


def test_rasters_lie_on_one_grid_and_say_what_they_are(plan):
    grids = set()
    for path in plan.glob("*.tif"):
        with rasterio.open(path) as file:
            grids.add((file.crs.to_epsg(), tuple(file.transform), file.shape))
            assert file.nodata is not None
            assert file.descriptions[0]
            assert file.tags()["AREA_OR_POINT"] == "Area"
            assert file.tags(ns="IMAGE_STRUCTURE")["LAYOUT"] == "COG"
            assert file.tags()["FIREBREAK_SOFTWARE"] == "firebreak_gis"
            assert file.tags()["FIREBREAK_SEED"] == "3"
            assert "date" not in json.dumps(file.tags()).lower()
    assert len(grids) == 1
    epsg, transform, shape = grids.pop()
    assert epsg == 32635
    assert transform[0] == -transform[4] == 60
    assert shape[0] != shape[1]


def read(path):
    with rasterio.open(path) as file:
        return file.read(1, masked=True)


def test_counts_fit_together(plan):
    breaks, priority = read(plan / "breaks.tif"), read(plan / "priority.tif")
    before, after = read(plan / "burn_frequency.tif"), read(plan / "burn_frequency_with_breaks.tif")
    fuel = ~priority.mask
    n_burnable = int(fuel.sum())
    cut = breaks.filled(0) == 1
    assert cut.sum() == round(0.14 * n_burnable)
    assert priority.data[cut].min() >= priority.data[fuel & ~cut].max()
    assert (before.mask == ~fuel).all()
    runs = before.compressed() * 60
    np.testing.assert_allclose(runs, np.round(runs), atol=1e-4)
    assert (after <= before).all()
    assert after.data[cut].max() == 0
    vegetation, density = read(plan / "vegetation.tif"), read(plan / "density.tif")
    assert ((vegetation.filled(0) > 0) & (density.filled(0) > 0) == fuel).all()
    assert set(density.data[fuel]) == {1, 2, 3}
    sizes = pd.read_csv(plan / "fire_sizes.csv")
    assert len(sizes) == 60
    assert sizes["cells_without_breaks"].sum() == pytest.approx(runs.sum())
    assert sizes["cells_with_breaks"].sum() == pytest.approx(after.compressed().astype(float).sum() * 60, rel=1e-5)
    np.testing.assert_allclose(sizes["ha_with_breaks"], sizes["cells_with_breaks"] * 0.36)


def test_polygons_and_evaluation(plan):
    frame = gpd.read_file(plan / "breaks.gpkg")
    assert frame.crs.to_epsg() == 32635
    assert {"order", "cells", "area_ha", "mean_priority"} <= set(frame.columns)
    breaks = read(plan / "breaks.tif").filled(0)
    assert frame["cells"].sum() == breaks.sum()
    assert frame.area.sum() == pytest.approx(breaks.sum() * 3600)
    rows = pd.read_csv(plan / "evaluation.csv")
    assert set(rows["method"]) == {"bonacich", "random", "flammability"}
    chosen = rows[(rows["method"] == "bonacich") & (rows["d_f"] == 0.14)].iloc[0]
    sizes = pd.read_csv(plan / "fire_sizes.csv")
    n_burnable = (~read(plan / "priority.tif").mask).sum()
    assert chosen["mean"] == pytest.approx(sizes["cells_with_breaks"].mean() / n_burnable)
    assert chosen["max"] == pytest.approx(sizes["cells_with_breaks"].max() / n_burnable)
    assert chosen["cells_cut"] == breaks.sum()


def test_manifest_is_the_account_and_a_configuration(plan, tmp_path):
    manifest = json.loads((plan / "run.json").read_text(encoding="utf-8"))
    assert manifest["command"] == "plan"
    assert manifest["parameters"]["budget"] == 0.14
    assert [Path(i["path"]).name for i in manifest["inputs"]] == ["dem.tif", "vegetation.tif", "density.tif"]
    assert [i["crs"] for i in manifest["inputs"]] == ["EPSG:4326", "EPSG:32635", "EPSG:32635"]
    assert manifest["inputs"][1]["shape"] == [300, 380]
    for entry in manifest["outputs"]:
        assert hashlib.sha256((plan / entry["path"]).read_bytes()).hexdigest() == entry["sha256"]
    assert any("bilinear" in line or "average" in line for line in manifest["alignment"])
    run("plan", "--config", plan / "run.json", "-o", tmp_path / "again", "-q")
    assert hashes(plan) == hashes(tmp_path / "again")


def test_threads_do_not_change_a_byte(plan, tmp_path, monkeypatch):
    monkeypatch.setenv("FIREBREAK_THREADS", "1")
    run("plan", "--config", plan / "run.json", "-o", tmp_path / "one")
    assert hashes(plan) == hashes(tmp_path / "one")


def test_toml_configuration_and_options_that_win(tmp_path):
    config = tmp_path / "plan.toml"
    config.write_text('method = "flammability"\nbudget = 0.3\nn_runs = 4\nresolution = 120\n', encoding="utf-8")
    run("plan", *LAYERS, "-o", tmp_path / "out", "--config", config, "--budget", "0.2")
    parameters = json.loads((tmp_path / "out/run.json").read_text())["parameters"]
    assert parameters["method"] == "flammability"
    assert parameters["budget"] == 0.2
    config.write_text("colour = 3\n", encoding="utf-8")
    assert "colour" in run("plan", *LAYERS, "-o", tmp_path / "o", "--config", config, code=2).output
    config.write_text("colour 3\n", encoding="utf-8")
    run("plan", *LAYERS, "-o", tmp_path / "o", "--config", config, code=2)


def test_steps_give_what_plan_gives(plan, network, tmp_path):
    folder = network.parent
    run("rank", network, "--method", "bonacich", "-p", "beta=0.5", "-o", tmp_path / "priority.tif", "--seed", 3)
    run(
        "breaks",
        tmp_path / "priority.tif",
        "--budget",
        0.14,
        "-o",
        tmp_path / "breaks.tif",
        "--polygons",
        tmp_path / "b.geojson",
    )
    run(
        "burn",
        network,
        "--breaks",
        tmp_path / "breaks.tif",
        "-o",
        tmp_path / "f.tif",
        "--runs",
        60,
        "--seed",
        3,
        "--sizes",
        tmp_path / "s.csv",
    )
    pairs = {"priority.tif": "priority.tif", "breaks.tif": "breaks.tif", "f.tif": "burn_frequency_with_breaks.tif"}
    for mine, theirs in pairs.items():
        one, other = read(tmp_path / mine), read(plan / theirs)
        np.testing.assert_array_equal(one.mask, other.mask)
        np.testing.assert_array_equal(one.data, other.data)
    for name in ("elevation", "vegetation", "density"):
        np.testing.assert_array_equal(read(folder / f"land/{name}.tif").data, read(plan / f"{name}.tif").data)
    cells = pd.read_csv(tmp_path / "s.csv")["cells"]
    assert cells.tolist() == pd.read_csv(plan / "fire_sizes.csv")["cells_with_breaks"].tolist()
    assert len(gpd.read_file(tmp_path / "b.geojson")) == len(gpd.read_file(plan / "breaks.gpkg"))


def test_network_raster_has_eight_named_bands(network):
    with rasterio.open(network) as file:
        assert file.count == 8
        assert file.dtypes == ("float32",) * 8
        named = [text.split()[-1] for text in file.descriptions]
        assert named == ["N", "NE", "E", "SE", "S", "SW", "W", "NW"] or all(
            d in text for d, text in zip(("N", "NE", "E", "SE", "S", "SW", "W", "NW"), file.descriptions, strict=True)
        )
        values = file.read(masked=True)
    assert 0 <= values.min() <= values.max() <= 1


def test_evaluate_and_compare(network, tmp_path):
    run(
        "evaluate",
        network,
        "--methods",
        "bonacich:beta=0.2,random",
        "--budgets",
        "0,0.1,0.3",
        "--runs",
        20,
        "-o",
        tmp_path / "e",
    )
    rows = pd.read_csv(tmp_path / "e/evaluation.csv")
    assert rows["method"].tolist() == ["bonacich:beta=0.2"] * 3 + ["random"] * 3
    assert (tmp_path / "e/evaluation.png").stat().st_size > 5000
    run(
        "compare",
        network,
        "--methods",
        "flammability,random",
        "--budgets",
        "0.1,0.2",
        "--residuals",
        "0,0.1",
        "--runs",
        20,
        "--values",
        SAMPLE / "villages.gpkg",
        "--values-field",
        "people",
        "-o",
        tmp_path / "c",
    )
    rows = pd.read_csv(tmp_path / "c/comparison.csv")
    assert len(rows) == 8
    assert {"R", "burnt_ha", "cvar_ha", "value_lost", "leverage"} <= set(rows.columns)


def test_plan_with_stakes(tmp_path):
    run(
        "plan",
        *LAYERS,
        "-o",
        tmp_path / "p",
        *COARSE,
        "--runs",
        20,
        "--method",
        "flammability",
        "--budget",
        60_000,
        "--budget-unit",
        "cost",
        "--barriers",
        SAMPLE / "roads.gpkg",
        "--allowed",
        SAMPLE / "boundary.gpkg",
        "--cost",
        "agricultural=500,shrubs=900,pines=1500",
        "--residual",
        0.1,
    )
    summary = json.loads((tmp_path / "p/run.json").read_text())["summary"]
    assert 60_000 - 0.36 * 1500 <= summary["cost"] <= 60_000
    cut = read(tmp_path / "p/breaks.tif").filled(0) == 1
    vegetation = read(tmp_path / "p/vegetation.tif").filled(0)
    rates = np.array([0, 500, 900, 1500])
    assert rates[vegetation[cut]].sum() * 0.36 == pytest.approx(summary["cost"])
    from rasterio.features import geometry_mask

    boundary, roads = gpd.read_file(SAMPLE / "boundary.gpkg"), gpd.read_file(SAMPLE / "roads.gpkg")
    with rasterio.open(tmp_path / "p/breaks.tif") as file:
        outside = geometry_mask(boundary.geometry, file.shape, file.transform)
        on_road = geometry_mask(roads.geometry, file.shape, file.transform, all_touched=True, invert=True)
    assert not cut[outside].any()
    assert not cut[on_road].any()
    assert read(tmp_path / "p/burn_frequency.tif").mask[on_road].all()


def test_lists_and_descriptions():
    assert "bonacich" in run("methods").output
    assert "beta = 0.5" in run("methods", "bonacich").output
    run("methods", "nothing", code=2)
    assert "paper" in run("legends").output
    assert "pines" in run("legends", "paper").output
    found = json.loads(run("describe", "--json").output)["result"]
    assert {m["name"] for m in found["methods"]["ranking"]} == set(plugins.names("ranking"))
    assert {"plan", "align", "network", "rank", "breaks", "burn", "evaluate", "methods"} <= set(found["commands"])
    version = json.loads(
        subprocess.run(
            [sys.executable, "-m", "firebreak_gis", "--version", "--json"], capture_output=True, text=True, check=True
        ).stdout
    )
    assert version["software"] == "firebreak_gis"


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["plan", "missing.tif", *LAYERS[1:]], 3, "missing.tif"),
        (["plan", *LAYERS, "--budget", "1.5"], 2, "from 0 to 1"),
        (["plan", *LAYERS, "--budget", "nan"], 2, "from 0 to 1"),
        (["plan", *LAYERS, "--method", "nothing"], 2, "there are: "),
        (["plan", *LAYERS, "-p", "beta"], 2, "NAME=VALUE"),
        (["plan", *LAYERS, "--method", "bonacich", "-p", "beta=1.01"], 2, "at most 1"),
        (["plan", *LAYERS, "-p", "gamma=1"], 2, "gamma"),
        (["plan", *LAYERS, "--runs", "0"], 2, "at least 1"),
        (["plan", *LAYERS, "--seed", "-1"], 2, "at least 0"),
        (["plan", *LAYERS, "--wind-speed", "-3"], 2, "at least 0"),
        (["plan", *LAYERS, "--wind-from", "400"], 2, "at most 360"),
        (["plan", *LAYERS, "--wind-speed", "fast"], 2, "neither a number"),
        (["plan", *LAYERS, "--residual", "2"], 2, "from 0 to 1"),
        (["plan", *LAYERS[:2]], 3, "normal"),
    ],
    ids=lambda value: " ".join(w for w in value if "/" not in w) if isinstance(value, list) else None,
)
def test_refusals_have_their_code_and_one_json_object(words, code, text, tmp_path):
    outcome = run(*words, "-o", tmp_path / "out", "--res", "120", "--json", "--progress", "none", code=code)
    lines = [line for line in outcome.stdout.splitlines() if line.startswith("{")]
    assert len(lines) == 1
    error = json.loads(lines[0])["error"]
    assert error["exit_code"] == code
    assert text in error["message"]
    assert not list((tmp_path / "out").glob("*.tif")) if (tmp_path / "out").exists() else True


def test_outputs_are_not_overwritten_unless_asked(network, tmp_path):
    target = tmp_path / "p.tif"
    run("rank", network, "--method", "random", "-o", target)
    old = target.read_bytes()
    assert "--overwrite" in run("rank", network, "--method", "degree", "-o", target, code=4).output
    assert target.read_bytes() == old
    run("rank", network, "--method", "degree", "-o", target, "--overwrite")
    assert target.read_bytes() != old
    before = network.read_bytes()
    run("rank", network, "-o", network, "--overwrite", code=4)
    assert network.read_bytes() == before
    run("rank", network, "-o", tmp_path / "no/such/folder/p.tif", code=4)


def start(*words, **options):
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen(
        [sys.executable, "-u", "-m", "firebreak_gis", *map(str, words)],
        text=True,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        **options,
    )


def slow_burn(network, target):
    return ["burn", network, "-o", target, "--runs", 2_000_000, "--progress", "json", "--json"]


@pytest.mark.parametrize("how", ["SIGINT", "cancel", "end of stdin"])
def test_a_stop_is_quick_and_leaves_nothing(network, tmp_path, how):
    target = tmp_path / "f.tif"
    process = start(*slow_burn(network, target), stdin=subprocess.PIPE)
    for line in process.stdout:
        if json.loads(line).get("progress", 0) > 0.005:
            break
    asked = time.perf_counter()
    if how == "SIGINT":
        process.send_signal(signal.SIGINT)
    elif how == "cancel":
        process.stdin.write("cancel\n")
        process.stdin.flush()
    else:
        process.stdin.close()
        process.stdin = None
    out, _ = process.communicate(timeout=30)
    assert time.perf_counter() - asked < 5
    assert process.returncode == 130
    assert json.loads(out.splitlines()[-1])["error"]["kind"] == "cancelled"
    assert not list(tmp_path.iterdir())


def test_found_under_rio():
    from importlib.metadata import entry_points

    found = [e for e in entry_points(group="rasterio.rio_plugins") if e.name == "firebreak"]
    if not found:
        pytest.skip("the package is not installed as a distribution")
    assert found[0].load() is firebreak
    rio = Path(sys.executable).with_name("rio")
    done = subprocess.run([str(rio), "firebreak", "--help"], capture_output=True, text=True, check=True)
    assert "Plan wildfire fire breaks" in done.stdout
