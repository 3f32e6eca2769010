"""Measures of a plan and their intervals: a slow twin, known distributions, and plans made for their budget."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis import plan, simulate, spread_network
from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.measures import judge, resamples
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.placement.fires import design_fires
from firebreak_gis.planning.comparison import compare_plans, comparison_table
from firebreak_gis.planning.design import Designs, design
from firebreak_gis.ranking import rankings
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes


def twin(burnt, lost, untreated, treated_ha, area, picks):
    """Measures and intervals by plain lists."""

    def percentile(values, share):
        values = sorted(values)
        place = share * (len(values) - 1)
        low = math.floor(place)
        high = min(low + 1, len(values) - 1)
        return values[low] + (place - low) * (values[high] - values[low])

    def mean(values):
        return math.fsum(values) / len(values)

    def worst(values):
        return mean(sorted(values)[-max(1, round(len(values) / 10)) :])

    cells, free = burnt.tolist(), untreated.tolist()
    runs = {
        "burnt_ha": ([c * area for c in cells], mean),
        "p90_ha": ([c * area for c in cells], lambda v: percentile(v, 0.9)),
        "cvar_ha": ([c * area for c in cells], worst),
        "value_lost": (lost.tolist(), mean),
        "leverage": ([(f - c) * area / treated_ha for c, f in zip(cells, free, strict=True)], mean),
    }
    row = {}
    for name, (values, measure) in runs.items():
        again = [measure([values[i] for i in pick]) for pick in picks.tolist()]
        row |= {
            name: measure(values),
            f"{name}_low": percentile(again, 0.025),
            f"{name}_high": percentile(again, 0.975),
        }
    return row


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000), n=st.integers(1, 60))
def test_measures_are_those_of_the_twin(seed, n):
    rng = np.random.default_rng(seed)
    untreated = rng.integers(0, 1000, n)
    burnt = (untreated * rng.random(n)).astype(int)
    lost = rng.random(n)
    picks = resamples(n, seed)[:60]
    found = judge(burnt, lost, untreated, treated_ha=7.5, cell_area_ha=0.04, picks=picks)
    expected = twin(burnt, lost, untreated, 7.5, 0.04, picks)
    assert set(found) == set(expected)
    for name, value in expected.items():
        assert found[name] == pytest.approx(value, abs=1e-9), name


def test_intervals_hold_the_truth_about_as_often_as_they_say():
    """400 samples of 150 fires from an exponential distribution, of which mean, percentile and CVaR are known."""
    rng = np.random.default_rng(11)
    picks = resamples(150, 3)
    truth = {"burnt_ha": 1.0, "p90_ha": math.log(10.0), "cvar_ha": 1.0 + math.log(10.0), "leverage": 0.5}
    inside = dict.fromkeys(truth, 0)
    for _ in range(400):
        burnt = rng.exponential(1.0, 150)
        row = judge(burnt, burnt, burnt + 1.0, treated_ha=2.0, cell_area_ha=1.0, picks=picks)
        for name, value in truth.items():
            inside[name] += row[f"{name}_low"] - 1e-9 <= value <= row[f"{name}_high"] + 1e-9
    assert 0.90 * 400 <= inside["burnt_ha"] <= 0.98 * 400
    assert 0.88 * 400 <= inside["p90_ha"] <= 0.99 * 400
    assert 0.82 * 400 <= inside["cvar_ha"] <= 0.98 * 400  # the mean of 15 fires: somewhat too sure
    assert inside["leverage"] == 400  # every fire saves the same: paired, no doubt is left


def test_no_breaks_save_nothing():
    row = judge(np.ones(4), np.ones(4), np.ones(4), treated_ha=0.0, cell_area_ha=1.0, picks=resamples(4, 0))
    assert row["leverage"] == row["leverage_low"] == row["leverage_high"] == 0.0


@pytest.fixture(scope="module")
def network(make_landscape):
    return spread_network(make_landscape((30, 38), seed=5, relief=3.0, holes=0.04))


def test_plans_are_made_for_their_budget_and_leak(network):
    stakes = Stakes(network)
    methods = ("dissection", "compartments", "random")
    makers = {name: Designs(network, name, stakes=stakes, seed=2) for name in methods}
    budgets, residuals = [0.1, 0.3], [0.0, 0.3]
    result = compare_plans(network, makers, FireRequest(n_runs=30, seed=2), budgets=budgets, residuals=residuals)
    for name in methods:
        for budget in budgets:
            for residual in residuals:
                priority = design(network, name, stakes=stakes, budget=Budget(budget), residual=residual, seed=2)
                mask = select_breaks(priority, budget=budget, burnable=network.burnable)
                burns = simulate(network, breaks=mask, residual=residual, n_runs=30, seed=seed_for(2, "comparison"))
                chosen = result.sel(ranking=name, budget=budget, residual=residual)
                np.testing.assert_array_equal(chosen["burnt"], burns["fire_size"])
    rows = comparison_table(result)
    assert len(rows) == 12
    np.testing.assert_allclose(rows["R"] * network.n_burnable * network.grid.cell_area_ha, rows["burnt_ha"])


def test_equal_plans_are_made_once(network, monkeypatch):
    made = []

    def noted(*given, **more):
        one = rankings(*given, **more)

        def each(params, *rest):
            made.append(params)
            return one(params, *rest)

        return each

    monkeypatch.setattr("firebreak_gis.ranking.rankings", noted)
    stakes = Stakes(network)
    for method, params, count in (
        ("dissection", {}, 1 + 2),
        ("dissection", {"width": 2}, 2),
        ("dissection", {"residual": 0.1, "cost_share": 0.2}, 1),
        ("compartments", {}, 2),
        ("random", {}, 1),
    ):
        made.clear()
        maker = Designs(network, method, stakes=stakes, params=params)
        for budget in (0.1, 0.3):
            for residual in (0.0, 0.2):
                maker(budget, residual, lambda *_: None)
        assert len(made) == count, (method, params)


def test_no_plan_is_judged_on_the_fires_of_its_design(network):
    """The draws of designs, of plans and of comparisons are other ones, for the same seed."""
    from firebreak_gis.kernels.draws import run_keys
    from firebreak_gis.simulation.ignitions import resolve_ignitions

    for seed in (0, 1, seed_for(0, "comparison")):
        designed = set(design_fires(network, Stakes(network), n_runs=300, seed=seed).keys.tolist())
        for judged in (seed, seed_for(seed, "comparison"), seed_for(seed, "check")):
            assert not designed & set(run_keys(judged, "edges", 300).tolist())
    starts = [
        resolve_ignitions(network, n_runs=50, seed=seed).cells.tolist() for seed in (0, seed_for(0, "comparison"))
    ]
    assert starts[0] != starts[1]


def test_a_plan_carries_its_judgement(make_landscape):
    landscape = make_landscape((16, 21), relief=3.0)
    value = np.random.default_rng(0).random((16, 21))
    made = plan(landscape, budget=0.2, residual=0.1, value=value, n_runs=25, seed=3)
    found = made.summary["judged"]
    cells = made.after["fire_size"].to_numpy()
    assert found["burnt_ha"] == pytest.approx(cells.mean() * 0.04)
    assert found["value_lost"] == pytest.approx(float(made.after["value_lost"].mean()))
    saved = made.before["fire_size"].to_numpy().mean() - cells.mean()
    assert found["leverage"] == pytest.approx(saved / made.summary["cells_cut"])
    for name in ("burnt_ha", "p90_ha", "cvar_ha", "value_lost", "leverage"):
        assert found[f"{name}_low"] <= found[name] <= found[f"{name}_high"]


@pytest.mark.parametrize("unit", ["share", "cost"])
@pytest.mark.parametrize("timeless", [True, False])
def test_local_search_keeps_the_budget_and_what_may_not_be_cut(make_landscape, unit, timeless):
    landscape = make_landscape((11, 14), seed=8, relief=3.0, holes=0.05)
    fuel = landscape["burnable"].to_numpy()
    rng = np.random.default_rng(1)
    cost, protected = 1.0 + rng.random(fuel.shape), rng.random(fuel.shape) < 0.1
    asked = {
        "budget": 0.12 if unit == "share" else 0.12 * cost[fuel].sum(),
        "budget_unit": unit,
        "cost": cost,
        "protected": protected,
        "method": "flammability",
        "n_runs": 200,
        "seed": 2,
        "timeless": timeless,
    }
    plain, better = plan(landscape, **asked), plan(landscape, refine=True, **asked)
    cut = better.breaks.to_numpy() > 0
    assert not cut[protected | ~fuel].any()
    assert np.isneginf(better.priority.to_numpy()[protected | ~fuel]).all()
    assert cost[cut].sum() <= asked["budget"] or unit == "share"
    assert unit == "cost" or cut.sum() <= plain.breaks.to_numpy().sum()
    # The fires are those of no design.
    burnt, before = better.after["fire_size"].mean(), plain.after["fire_size"].mean()
    assert burnt < before if timeless else burnt <= before  # with a clock parts are moved, of which here are few


def test_local_search_would_not_keep_a_width(make_landscape):
    with pytest.raises(ParameterError, match="would not keep a width of 40 m"):
        plan(make_landscape(), refine=True, width=40.0, residual=0.1)
