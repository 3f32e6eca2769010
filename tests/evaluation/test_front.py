"""The front: what is saved against what is paid, and where the next hectare stops paying."""

from __future__ import annotations

import itertools

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.front import PAYS, STOPPED, front_table, stops_told
from firebreak_gis.evaluation.measures import BOUNDS, resamples
from firebreak_gis.planning.comparison import compare_plans
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.request import FireRequest
from tests.planning.test_design import random_network


def result(saved, cut, *, priced=False, cost=None, noise=0.0, runs=40, seed=1):
    """A comparison in which `saved` (ranking, budget) cells are saved in the mean of the runs."""
    saved = np.asarray(saved, float)
    rng = np.random.default_rng(seed)
    untreated = np.full(runs, 1000.0)
    wobble = noise * rng.standard_normal((*saved.shape, 1, runs))
    burnt = untreated - saved[:, :, None, None] - (wobble - wobble.mean(axis=-1, keepdims=True))
    dims = ("ranking", "budget", "residual", "run")
    paid = np.broadcast_to(np.asarray(cut, float)[None, :, None] if cost is None else cost, burnt.shape[:3])
    return xr.Dataset(
        {
            "burnt": (dims, burnt),
            "lost": (dims, 10.0 * burnt),
            "burnt_untreated": ("run", untreated),
            "lost_untreated": ("run", 10.0 * untreated),
            "ha_cut": (dims[:3], np.broadcast_to(0.5 * np.asarray(cut, float)[None, :, None], burnt.shape[:3]).copy()),
            "cost": (dims[:3], paid),
        },
        coords={
            "ranking": [f"r{i}" for i in range(len(saved))],
            "budget": np.asarray(cut) / 1000.0,
            "residual": [0.0],
        },
        attrs={"cell_area_ha": 0.5, "fire_seed": 3, "priced": priced},
    )


def test_the_next_hectare_stops_paying_where_it_saves_less_than_one():
    table = front_table(result([[100, 150, 155]], [10, 50, 60]))
    assert table["step_saved"].tolist() == [10.0, 1.25, 0.5]
    assert table["pays"].tolist() == [PAYS, PAYS, STOPPED]
    assert table["stop"].unique().tolist() == [25.0]  # 50 cells of half a hectare
    assert "beyond 25 ha" in stops_told(table, priced=False)[0]


def test_a_step_that_saves_nothing_before_the_next_closes_the_wall_is_gone_over():
    table = front_table(result([[0, 300]], [10, 20]))
    assert table["pays"].tolist() == [STOPPED, PAYS]
    assert table["stop"].unique().tolist() == [10.0]
    assert "still pays" in stops_told(table, priced=False)[0]


def test_money_counts_where_costs_and_values_are_given():
    cost = np.array([[[900.0], [3000.0]]])
    made = result([[100, 150]], [10, 50], priced=True, cost=cost)
    table = front_table(made)
    assert table["paid"].tolist() == [900.0, 3000.0]
    assert table["saved"].tolist() == [1000.0, 1500.0]
    assert table["stop"].unique().tolist() == [900.0]
    assert front_table(made, n_fires=10)["stop"].unique().tolist() == [3000.0]


def test_what_never_pays_says_how_many_fires_it_takes():
    table = front_table(result([[5, 8]], [10, 50]))
    assert table["stop"].unique().tolist() == [0.0]
    assert "from 2 fires on" in stops_told(table, priced=False)[0]
    with pytest.raises(ParameterError, match="above 0"):
        front_table(result([[5]], [10]), n_fires=0.0)


def test_plans_on_the_front_are_those_that_none_beats():
    table = front_table(result([[100, 150], [100, 120], [-5, 160]], [10, 50]))
    assert table["front"].tolist() == [True, False, True, False, False, True]


@settings(max_examples=40, deadline=None)
@given(saved=st.lists(st.integers(-50, 300), min_size=2, max_size=4), noise=st.floats(0, 50), seed=st.integers(0, 1000))
def test_intervals_are_those_of_a_plain_bootstrap_over_pairs(saved, noise, seed):
    cut = [10 * (k + 1) for k in range(len(saved))]
    made = result([saved], cut, noise=noise, seed=seed)
    table = front_table(made)
    picks = resamples(40, 3)
    each = (made["burnt_untreated"].to_numpy() - made["burnt"].to_numpy()[0, :, 0]) * 0.5
    draws, stops = [], []
    for pick in picks:
        means = [0.0, *(run[pick].mean() for run in each)]
        draws.append([(b - a) / 5.0 for a, b in itertools.pairwise(means)])
        net = [m - 5.0 * k for k, m in enumerate(means)]
        stops.append(5.0 * net.index(max(net)))
    low, high = np.percentile(draws, BOUNDS, axis=0)
    assert np.allclose(table["step_saved_low"], low)
    assert np.allclose(table["step_saved_high"], high)
    assert np.allclose([table["stop_low"][0], table["stop_high"][0]], np.percentile(stops, BOUNDS))
    assert ((table["pays"] == PAYS) == (low >= 1.0)).all()
    assert ((table["pays"] == STOPPED) == (high < 1.0)).all()


@settings(max_examples=40, deadline=None)
@given(data=st.data())
def test_plans_that_are_not_there_change_nothing_for_those_that_are(data):
    """Against the comparison of each method alone, of the budgets for which it has a plan."""
    saved, cut = [[100, 150, 170], [80, 140, 200]], [10, 30, 60]
    made = result(saved, cut, noise=5.0)
    gone = np.array(data.draw(st.lists(st.booleans(), min_size=6, max_size=6))).reshape(2, 3)
    gone[0, 1] = False
    holes = made.copy(deep=True)
    for name in ("burnt", "lost", "ha_cut", "cost"):
        holes[name].to_numpy()[gone] = np.nan
    table = front_table(holes)
    assert not table.drop(columns="front").isna().any().any()
    assert len(table) == np.count_nonzero(~gone)
    for i, name in enumerate(("r0", "r1")):
        alone = made.isel(ranking=[i], budget=np.flatnonzero(~gone[i]))
        mine = table[table["method"] == name].reset_index(drop=True)
        if len(mine):
            pd.testing.assert_frame_equal(mine.drop(columns="front"), front_table(alone).drop(columns="front"))
    assert stops_told(table, priced=False)


def test_a_comparison_tells_what_its_plans_cost():
    network = random_network(4, shape=(12, 15))
    cost = np.where(network.burnable, np.arange(180.0).reshape(12, 15), 0.0)
    priority = rank(network, "random", seed=1)
    fires = FireRequest(n_runs=8, seed=2)
    made = compare_plans(network, {"r": priority}, fires, budgets=[0.1, 0.3], residuals=[0.0], cost=cost)
    order = np.argsort(-priority.to_numpy().ravel(), kind="stable")
    cells = made["cells_cut"].to_numpy()[0, :, 0].astype(int)
    assert cells.tolist() == [round(share * network.n_burnable) for share in (0.1, 0.3)]
    np.testing.assert_allclose(made["ha_cut"].to_numpy()[0, :, 0], cells * network.grid.cell_area_ha)
    expected = [cost.ravel()[order[:k]].sum() for k in cells]
    assert made["cost"].to_numpy()[0, :, 0].tolist() == expected
    assert not made.attrs["priced"]
