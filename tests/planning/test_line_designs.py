"""Lines among the methods of a comparison: the plans that `plan` makes, burnt and counted as they are built."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner

from firebreak_gis import plan
from firebreak_gis.breaks import Budget
from firebreak_gis.cli import firebreak, parsing
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.front import front_table
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.landscape import write_landscape
from firebreak_gis.placement import lines as placement
from firebreak_gis.planning.comparison import compare_plans, comparison_table
from firebreak_gis.planning.design import Designs
from firebreak_gis.planning.line_designs import LineDesigns
from firebreak_gis.progress import silent
from firebreak_gis.simulation.ground_fires import burn_on
from firebreak_gis.stakes import Stakes

pytestmark = pytest.mark.usefixtures("no_pictures")

BUDGETS = (0.04, 0.08)


@pytest.fixture(scope="module")
def landscape(make_landscape):
    return make_landscape((50, 61), seed=2, relief=4.0)


@pytest.fixture(scope="module")
def made(landscape):
    """The default plans of both budgets."""
    cost = np.where(
        landscape["burnable"], np.random.default_rng(1).uniform(100.0, 300.0, landscape["burnable"].shape), 0
    )
    value = np.random.default_rng(2).uniform(1.0, 50.0, cost.shape)
    asked = {"model_params": {"wind_speed": 3}, "cost": cost, "value": value, "n_runs": 30, "seed": 6}
    return {budget: plan(landscape, budget=budget, **asked) for budget in BUDGETS}


@pytest.fixture(scope="module")
def setting(made):
    return made[BUDGETS[0]].design.setting


def lines_in(setting, **more):
    return LineDesigns(setting.network, stakes=setting.stakes, trial=setting.trial, **more)


@pytest.fixture(scope="module")
def compared(setting):
    network, stakes = setting.network, setting.stakes
    plans = {"lines": lines_in(setting), "random": Designs(network, "random", stakes=stakes, seed=6)}
    asked = {"residuals": [0.0, 0.1], "value": stakes.value, "cost": stakes.cost, "ground": setting.ground}
    return compare_plans(network, plans, setting.judged.fires, budgets=BUDGETS, **asked)


@pytest.mark.parametrize("order", [1, -1])
def test_lines_are_those_that_plan_makes_and_their_walls_are_sought_once(made, setting, monkeypatch, order):
    sought = []
    seek = placement.dissect_by_lines
    monkeypatch.setattr(placement, "dissect_by_lines", lambda *a, **k: sought.append(k["smallest"]) or seek(*a, **k))
    designs = lines_in(setting)
    for budget in BUDGETS[::order]:
        found = designs(budget, 0.0, silent)
        pd.testing.assert_frame_equal(found.built(Budget(budget)), made[budget].walls)
        assert found.figures(Budget(budget)) == made[budget].design.figures
        assert designs(budget, 0.0, silent) is found
    assert sought == [64]
    assert designs.distinct(BUDGETS, [0.0, 0.1]) == 1


def test_rows_are_what_burns_and_what_is_taken_under_the_lines_of_plan(made, setting, compared):
    fires = setting.judged.fires
    fresh = replace(fires, seed=seed_for(fires.seed, "comparison"))
    for budget, each in made.items():
        told = compared.sel(ranking="lines", budget=budget, residual=0.0)
        value = setting.stakes.value
        burnt = burn_on(setting.ground, fresh, breaks=each.design.laid, value=value)
        np.testing.assert_array_equal(told["burnt"], burnt["fire_size"])
        np.testing.assert_array_equal(told["lost"], burnt["value_lost"])
        assert not np.array_equal(told["burnt"], each.after["fire_size"])  # other fires than those of the plan
        for name in ("cells_cut", "ha_cut", "cost"):
            assert float(told[name]) == each.summary[name]
        length = each.walls.length.sum()
        assert float(told["ha_cut"]) == pytest.approx(length * each.parameters["line_width"] / 10_000, rel=1e-4)
        assert float(told["ha_cut"]) < float(told["cells_cut"]) * setting.network.grid.cell_area_ha


def test_where_cells_keep_something_there_are_no_lines_and_no_empty_rows(compared):
    rows, front = comparison_table(compared), front_table(compared)
    for table in (rows, front):
        assert not table.isna().any().any()
        found = table[["method", "residual", "d_f"]].apply(tuple, axis=1).tolist()
        expected = {("lines", 0.0, b) for b in BUDGETS} | {("random", r, b) for b in BUDGETS for r in (0.0, 0.1)}
        assert set(found) == expected
        assert len(found) == len(expected)
    chosen = compared.sel(ranking="lines", residual=0.0)
    mine = front[front["method"] == "lines"]
    assert mine["paid"].tolist() == chosen["cost"].to_numpy().tolist()
    assert mine["ha_cut"].tolist() == chosen["ha_cut"].to_numpy().tolist()
    unpriced = front_table(compared.assign_attrs(priced=False))
    assert unpriced[unpriced["method"] == "lines"]["paid"].tolist() == mine["ha_cut"].tolist()
    saved = (compared["burnt_untreated"] - chosen["burnt"]).mean("run") * compared.attrs["cell_area_ha"]
    told = rows[rows["method"] == "lines"]["leverage"]
    np.testing.assert_allclose(told, (saved / chosen["ha_cut"]).to_numpy())


def test_lines_of_a_width_that_is_asked_for_may_leak(setting):
    asked = lines_in(setting, width=10.0, params={"smallest": 100})
    one, two = (asked(0.08, residual, silent) for residual in (0.0, 0.2))
    assert set(one.walls["width_m"]) == {10.0}
    assert one.built(Budget(0.08))["area_ha"].sum() > 0
    assert two is not None
    assert two is not one
    assert lines_in(setting)(0.08, 0.2, silent) is None
    assert lines_in(setting).distinct([0.08], [0.2]) == 0


def test_a_budget_that_pays_no_wall_has_no_plan(setting):
    asked = {"residuals": [0.0], "ground": setting.ground}
    with pytest.raises(ParameterError, match="no method has a plan"):
        compare_plans(setting.network, {"lines": lines_in(setting)}, setting.judged.fires, budgets=[0.0005], **asked)
    random = Designs(setting.network, "random", stakes=Stakes(setting.network))
    plans = {"lines": lines_in(setting), "random": random}
    result = compare_plans(setting.network, plans, setting.judged.fires, budgets=[0.0005, 0.08], **asked)
    rows = comparison_table(result)
    assert rows[["method", "d_f"]].apply(tuple, axis=1).tolist() == [
        ("lines", 0.08),
        ("random", 0.0005),
        ("random", 0.08),
    ]


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(word) for word in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


@pytest.fixture(scope="module")
def folder(landscape, tmp_path_factory):
    folder = tmp_path_factory.mktemp("compared")
    write_landscape(landscape, folder / "land")
    run("network", folder / "land", "-o", folder / "still.tif")
    return folder


FEW = ["--runs", 20, "--seed", 3, "--wind-speed", 3, "-q"]


def test_the_commands_agree_and_the_order_of_methods_changes_nothing(folder, tmp_path):
    """What `firebreak plan` builds where nothing is said stands in what `firebreak compare` compares."""
    layers = [folder / "land" / f"{name}.tif" for name in ("elevation", "vegetation", "density")]
    run("plan", *layers, "--budget", "8%", *FEW, "-o", tmp_path / "plan")
    summary = json.loads((tmp_path / "plan/run.json").read_text())["summary"]
    tables = []
    for name, methods in (("a", "lines,random"), ("b", "random,lines")):
        words = ["--dem", layers[0], "--budgets", "8%", "--residuals", "0,0.1", "--methods", methods]
        run("compare", folder / "land", *words, *FEW, "-o", tmp_path / name)
        table = pd.read_csv(tmp_path / name / "comparison.csv")
        tables.append(table.sort_values(["method", "residual"]).reset_index(drop=True))
        assert not table.isna().any().any()
    pd.testing.assert_frame_equal(*tables)
    (lines,) = tables[0][tables[0]["method"] == "lines"].to_dict("records")
    assert lines["ha_cut"] == pytest.approx(summary["ha_cut"], abs=1e-6)
    assert lines["cells_cut"] == summary["cells_cut"]
    account = json.loads((tmp_path / "a/run.json").read_text())
    assert "Lines are 20 m wide, planned only for breaks without a leak." in account["assumptions"]
    page = (tmp_path / "a/report.html").read_text()
    assert "Lines are 20 m wide" in page


def test_lines_fall_away_where_plan_makes_none_and_it_is_said(folder, tmp_path):
    words = ["--budgets", "8%", "--residuals", "0", "--runs", 4]
    told = run("compare", folder / "still.tif", "--methods", "lines,random", *words, "-o", tmp_path / "a")
    assert "no lines are compared, since the fires have no clock" in told.output
    assert set(pd.read_csv(tmp_path / "a/comparison.csv")["method"]) == {"random"}
    told = run(
        "compare", folder / "land", "--methods", "lines,random", *words[:3], "0.1", *words[4:], "-o", tmp_path / "b"
    )
    assert "no lines are compared, since treated cells keep" in told.output
    refused = run("compare", folder / "still.tif", "--methods", "lines", *words, "-o", tmp_path / "c", code=2)
    assert "lines:width=20m" in refused.output
    asked = ["--methods", "lines:width=20m,random", "--residuals", "0,0.1"]
    run("compare", folder / "still.tif", *asked, *words[:2], *words[4:], "-o", tmp_path / "d")
    table = pd.read_csv(tmp_path / "d/comparison.csv")
    assert table[table["method"] == "lines:width=20m"]["residual"].tolist() == [0.0, 0.1]
    assert not (tmp_path / "c").exists()


@pytest.mark.parametrize(
    ("methods", "told"),
    [
        ("lines:width=wide", "12m, auto or cells"),
        ("lines:width=-3", "above 0"),
        ("lines:width=cells", "the method dissection"),
        ("lines:beta=2", "directions and smallest"),
        ("lines:smallest=-1", "smallest"),
        ("lines:width=auto", "--hold flame"),
        ("lines,lines", "different names"),
    ],
)
def test_what_lines_cannot_be_is_refused(folder, tmp_path, methods, told):
    refused = run("compare", folder / "land", "--methods", methods, "-o", tmp_path / "out", code=2)
    assert told in refused.output
    assert not (tmp_path / "out").exists()


def test_lines_are_read_among_methods():
    usual, wide, ranked = parsing.plans_list("lines,lines:width=12m:smallest=16,degree")
    assert (usual.name, usual.params, usual.line_width) == ("dissection", {}, None)
    assert (wide.label, wide.params, wide.line_width) == ("lines:width=12m:smallest=16", {"smallest": "16"}, 12.0)
    assert (ranked.name, ranked.line_width) == ("degree", "cells")
    with pytest.raises(ParameterError, match="lines"):
        parsing.methods_list("lines")  # rankings alone, as `evaluate` takes them
