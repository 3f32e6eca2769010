"""`rank`, `rank | breaks` and `evaluate` make the plans that `plan` makes; a ranking tells what it was made for."""

from __future__ import annotations

import json

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import rasterio
from click.testing import CliRunner
from shapely.geometry import LineString

import firebreak_gis as fb
from firebreak_gis import plugins
from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.cli import firebreak
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import write_landscape
from firebreak_gis.rasters import read_variable
from firebreak_gis.vectors import write_vector

pytestmark = pytest.mark.usefixtures("no_pictures")

#: Methods of which another budget gives another ranking, on the landscape below.
LAID_FOR_A_BUDGET = {"compartments", "splat", "stripes"}


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


@pytest.fixture(scope="module")
def files(make_landscape, tmp_path_factory):
    folder = tmp_path_factory.mktemp("agree")
    landscape = make_landscape((26, 37), seed=3, relief=4.0, holes=0.05)
    write_landscape(landscape, folder / "land")
    grid = Grid.of(landscape["burnable"])
    road = LineString([(grid.x[0], grid.y[7]), (grid.x[20], grid.y[8]), (grid.x[36], grid.y[20])])
    write_vector(folder / "road.gpkg", gpd.GeoDataFrame(geometry=[road], crs=grid.crs))
    run("network", folder / "land", "-o", folder / "network.tif")
    return folder


def layers(files):
    return [files / "land" / f"{name}.tif" for name in ("elevation", "vegetation", "density")]


@pytest.mark.parametrize(
    "asked",
    [
        ["--budget", "0.14"],
        ["--budget", "8", "--budget-unit", "ha", "--residual", "0.2", "--width", "40", "--barriers", "road.gpkg"],
    ],
    ids=["share", "hectares, leaks, width, barriers"],
)
@pytest.mark.parametrize("method", plugins.names("ranking"))
def test_every_method_ranks_as_it_plans(files, tmp_path, method, asked):
    """Where no fire has a clock; `rank` knows of none."""
    words = [str(files / w) if w.endswith(".gpkg") else w for w in asked]
    known = {p["name"] for p in plugins.describe("ranking", method)["parameters"]}
    words += ["--method", method, "--seed", "4", *(["-p", "fires=10"] if "fires" in known else [])]
    run("plan", *layers(files), "-o", tmp_path / "plan", "--runs", 2, "--timeless", *words)
    run("rank", files / "network.tif", "-o", tmp_path / "p.tif", "--dem", layers(files)[0], *words)
    paths = (tmp_path / "plan/priority.tif", tmp_path / "p.tif")
    planned, ranked = (read_variable(path, "priority") for path in paths)
    np.testing.assert_array_equal(planned, ranked)
    assert Budget.made_for(planned) == Budget.made_for(ranked)
    budget = words[:4] if "ha" in words else words[:2]
    told = run("breaks", tmp_path / "p.tif", "-o", tmp_path / "b.tif", *budget)
    assert "was ranked for" not in told.output
    masks = []
    for path in (tmp_path / "plan/breaks.tif", tmp_path / "b.tif"):
        with rasterio.open(path) as source:
            masks.append(source.read(1))
    np.testing.assert_array_equal(*masks)


SITED = "--siting 2 --siting-param scales=60 --siting-param patch=1 --max-slope 25 --roads ROAD --near-roads 0.2km"


@pytest.mark.parametrize("method", ["dissection", "stripes", "compartments", "splat", "dfpz", "random"])
def test_every_method_ranks_as_it_plans_on_the_same_ground(files, tmp_path, method):
    words = [str(files / "road.gpkg") if word == "ROAD" else word for word in SITED.split()]
    words += ["--method", method, "--budget", "0.1"]
    run("plan", *layers(files), "-o", tmp_path / "plan", "--runs", 2, "--line-width", "cells", *words)
    told = run("rank", files / "network.tif", "-o", tmp_path / "p.tif", "--dem", layers(files)[0], *words).output
    assert "farther than 200 m from roads, where nothing is cut" in told
    run("rank", files / "network.tif", "-o", tmp_path / "off.tif", "--siting", 0, "--method", method)
    planned, ranked, plain = (
        read_variable(tmp_path / path, "priority") for path in ("plan/priority.tif", "p.tif", "off.tif")
    )
    np.testing.assert_array_equal(planned, ranked)
    assert (np.isneginf(ranked) & ~np.isneginf(plain)).any()
    # The account is a configuration that makes the same plan again.
    run("plan", "--config", tmp_path / "plan/run.json", "-o", tmp_path / "again")
    np.testing.assert_array_equal(read_variable(tmp_path / "again/priority.tif", "priority"), planned)


def test_compare_and_evaluate_go_by_the_ground(files, tmp_path):
    for command, extra in (("compare", ["--residuals", "0"]), ("evaluate", ["--baseline", "random"])):
        words = ["--methods", "dissection,random", "--budgets", "0.1", "--runs", 8, "--dem", layers(files)[0], *extra]
        for name, strength in (("off", 0), ("on", 3)):
            siting = ["--siting", strength, "--siting-param", "patch=1"]
            run(command, files / "network.tif", "-o", tmp_path / command / name, *words, *siting)
        told = [json.loads((tmp_path / command / name / "run.json").read_text()) for name in ("off", "on")]
        assert not any("Breaks keep to" in sentence for sentence in told[0]["assumptions"])
        assert any("Breaks keep to" in sentence for sentence in told[1]["assumptions"])
        table = {"compare": "comparison.csv", "evaluate": "evaluation.csv"}[command]
        off, on = (pd.read_csv(tmp_path / command / name / table) for name in ("off", "on"))
        rows = [frame[frame["method"] == "dissection"].drop(columns="method") for frame in (off, on)]
        assert not rows[0].equals(rows[1])
        same = [frame[frame["method"] == "random"]["R" if command == "compare" else "mean"] for frame in (off, on)]
        np.testing.assert_array_equal(*same)


@pytest.mark.parametrize("method", plugins.names("ranking"))
def test_only_a_ranking_that_a_budget_changes_says_so(files, method):
    network = fb.read_network(files / "network.tif")
    known = {p["name"] for p in plugins.describe("ranking", method)["parameters"]}
    params = {"fires": 10} if "fires" in known else {}
    one, other = (fb.rank(network, method, budget=budget, **params) for budget in (0.05, 0.2))
    assert ("made_for" in one.attrs) == (method in LAID_FOR_A_BUDGET)
    if method in LAID_FOR_A_BUDGET:
        assert (one.values != other.values).any()
        assert Budget.made_for(other) == Budget(0.2)
    else:
        np.testing.assert_array_equal(one, other)


def test_a_leak_makes_dissection_depend_on_the_budget(files):
    network = fb.read_network(files / "network.tif")
    assert Budget.made_for(fb.rank(network, "dissection", budget=0.3)) is None
    assert Budget.made_for(fb.rank(network, "dissection", budget=0.3, residual=0.2)) == Budget(0.3)
    assert Budget.made_for(fb.rank(network, "dissection", budget=0.3, residual=0.2, width=2)) is None
    given = fb.rank(network, "stripes", budget=0.3, cost_share=0.1)
    assert Budget.made_for(given) is None  # asked for by hand


def test_breaks_warn_of_a_ranking_for_another_budget(files, tmp_path):
    run("rank", files / "network.tif", "-o", tmp_path / "p.tif", "--method", "stripes", "--budget", 0.05)
    told = run("breaks", tmp_path / "p.tif", "-o", tmp_path / "b.tif", "--budget", 0.14)
    assert "was ranked for a budget of 0.05 (share)" in told.output
    assert "--budget 0.14" in told.output
    assert "ranked for" not in run("breaks", tmp_path / "p.tif", "-o", tmp_path / "c.tif", "--budget", 0.05).output
    with rasterio.open(tmp_path / "p.tif") as source:
        assert source.tags()["FIREBREAK_MADE_FOR"] == "0.05 share"


def test_tags_that_are_no_budget_are_no_budget():
    plane = Grid((2, 3)).dataarray(np.ones((2, 3)), "priority")
    for text in ("", "much", "0.1 apples", "2.0 share", "nan ha"):
        assert Budget.made_for(plane.assign_attrs(made_for=text)) is None
    assert Budget.made_for(plane.assign_attrs(made_for="2.5 ha")) == Budget(2.5, "ha")


def test_rank_refuses_what_plan_refuses(files, tmp_path):
    out = ["-o", tmp_path / "p.tif"]
    assert "share" in run("rank", files / "network.tif", *out, "--budget", 1.2, code=2).output
    assert "cost" in run("rank", files / "network.tif", *out, "--budget", 5, "--budget-unit", "cost", code=2).output
    assert "residual" in run("rank", files / "network.tif", *out, "--residual", 2, code=2).output
    assert not (tmp_path / "p.tif").exists()


def test_evaluate_judges_the_plan_of_each_budget(files, tmp_path):
    """R at a budget is that of the breaks that plan makes for it, on the same fires."""
    words = ["--runs", 12, "--seed", 5]
    methods = "stripes,splat,dissection,random"
    run("evaluate", files / "network.tif", "-o", tmp_path, "--methods", methods, "--budgets", "0.06,0.1,0.2", *words)
    rows = pd.read_csv(tmp_path / "evaluation.csv").set_index(["method", "d_f"])["mean"]
    network = fb.read_network(files / "network.tif")
    for method in methods.split(","):
        for budget in (0.06, 0.1, 0.2):
            priority = fb.rank(network, method, budget=budget, seed=5)
            breaks = select_breaks(priority, budget=budget, burnable=network.burnable)
            burns = fb.simulate(network, breaks=breaks, n_runs=12, seed=5)["fire_size"]
            assert rows[method, budget] == pytest.approx(float(burns.mean()) / network.n_burnable)
    assert json.loads((tmp_path / "run.json").read_text())["parameters"]["seed"] == 5
