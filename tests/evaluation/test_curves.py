"""R(d_f): statistics against numpy and scipy, pairing, refusals; comparison of plans."""

import itertools
import math

import numpy as np
import pytest
from scipy import stats

from firebreak_gis import SpreadNetwork, evaluate, rank, select_breaks, simulate
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.curves import better_range, runs_table, summarise, table, tell_apart
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.planning.comparison import compare_plans, comparison_table
from firebreak_gis.simulation import budgets, ground_fires
from firebreak_gis.simulation.request import FireRequest


@pytest.fixture(scope="module")
def network():
    rng = np.random.default_rng(3)
    return SpreadNetwork(rng.uniform(0, 0.6, (8, 21, 30)), burnable=rng.random((21, 30)) > 0.1)


@pytest.fixture(scope="module")
def priorities(network):
    return {name: rank(network, name, seed=1) for name in ("bonacich", "flammability", "random")}


def test_figures_are_those_of_numpy_and_scipy():
    rng = np.random.default_rng(0)
    cells = {"a": rng.integers(0, 900, (80, 3)), "random": rng.integers(0, 1000, (80, 3))}
    result = summarise(cells, fuel=1000, budgets=[0, 0.1, 0.2])
    for name, runs in cells.items():
        picked = result.sel(ranking=name)
        np.testing.assert_array_equal(picked["burnt_cells"], runs)
        np.testing.assert_allclose(picked["mean"], [np.mean(runs[:, k]) / 1000 for k in range(3)])
        np.testing.assert_allclose(picked["max"], [max(runs[:, k]) / 1000 for k in range(3)])
        np.testing.assert_allclose(picked["p90"], [np.percentile(runs[:, k], 90) / 1000 for k in range(3)])
    for k in range(3):
        expected = stats.wilcoxon(cells["a"][:, k], cells["random"][:, k], zero_method="pratt", method="approx")
        assert result["p_value"].sel(ranking="a")[k] == pytest.approx(expected.pvalue)
    assert np.isnan(result["p_value"].sel(ranking="random")).all()
    assert (result["significant"].sel(ranking="random") == "no").all()


def signs_by_hand(difference):
    """Exact two-sided p-value of the signed ranks (Pratt), over every choice of signs."""
    ranks = stats.rankdata(np.abs(difference))[difference != 0]
    half = ranks.sum() / 2
    found = abs(ranks[difference[difference != 0] > 0].sum() - half)
    sums = [sum(chosen) for chosen in itertools.product(*((0.0, rank) for rank in ranks))]
    return np.mean([abs(s - half) >= found - 1e-9 for s in sums])


@pytest.mark.parametrize("seed", range(12))
def test_small_samples_are_tested_exactly_with_ties_and_zeros(seed):
    rng = np.random.default_rng(seed)
    a, b = rng.integers(0, 5, (2, 3 + seed % 9))
    p, _ = tell_apart(a, b)
    assert p == pytest.approx(signs_by_hand(a - b) if (a != b).any() else 1.0)


def test_without_ties_the_exact_test_is_that_of_scipy():
    rng = np.random.default_rng(2)
    difference = rng.permutation(np.arange(1, 41)) * rng.choice([-1, 1, 1], 40)
    assert tell_apart(difference, np.zeros(40, int))[0] == pytest.approx(
        stats.wilcoxon(difference, method="exact").pvalue
    )


def test_ties_are_those_of_cells_not_of_rounded_shares():
    """Five cells less are five cells less, whatever the fire; as shares of 1107 they are not all the same number."""
    random = np.array([1000, 907, 813, 611, 102, 50])
    cells = {"a": random - np.array([5, 5, 5, 5, 5, -5]), "random": random}
    shares = {name: runs / 1107 for name, runs in cells.items()}
    assert len(set(np.abs(shares["a"] - shares["random"]))) > 1
    p, effect = tell_apart(cells["a"], cells["random"])
    assert p == signs_by_hand(cells["a"] - cells["random"]) == 14 / 64
    result = summarise({name: runs[:, None] for name, runs in cells.items()}, fuel=1107, budgets=[0.1])
    assert result["p_value"].sel(ranking="a").item() == p
    assert effect == pytest.approx(-4 / 6)


def test_every_p_value_is_found_again_from_the_runs(network, priorities):
    result = evaluate(network, priorities, budgets=[0, 0.1, 0.3], n_runs=30, seed=2)
    runs = runs_table(result)
    assert list(runs.columns) == ["run", "d_f", *priorities]
    assert (runs.dtypes[list(priorities)] == np.dtype(int)).all()
    for row in table(result).itertuples():
        picked = runs[runs["d_f"] == row.d_f]
        assert picked[row.method].mean() / network.n_burnable == pytest.approx(row.mean)
        if row.method != "random":
            p, effect = tell_apart(picked[row.method].to_numpy(), picked["random"].to_numpy())
            assert (p, effect) == (row.p_value, row.effect_size)
            assert row.significant == ("no" if p >= 0.01 else "better" if effect < 0 else "worse")


def test_tests_on_equal_and_on_different_samples():
    rng = np.random.default_rng(1)
    x = rng.random(50)
    assert tell_apart(x, x) == (1.0, 0.0)
    assert tell_apart(x, x, test="t") == (1.0, 0.0)
    p, effect = tell_apart(x - 0.5, x)
    assert p < 1e-6
    assert effect == -1.0
    assert tell_apart(x + 0.5, x)[1] == 1.0
    y = rng.random(50)
    p, effect = tell_apart(x, y, test="ranksum")
    assert p == pytest.approx(stats.mannwhitneyu(x, y).pvalue)
    assert effect == pytest.approx(np.mean(np.sign(x[:, None] - y[None])))
    assert tell_apart(x, y, test="t")[0] == pytest.approx(stats.ttest_rel(x, y).pvalue)
    with pytest.raises(ParameterError):
        tell_apart(x, y, test="sign")


def test_mostly_equal_runs_give_a_number():
    x = np.zeros(30)
    y = x.copy()
    y[4] = 1.0
    p, effect = tell_apart(x, y)
    assert 0 < p <= 1
    assert -1 <= effect < 0


def test_evaluation_is_a_simulation_at_each_budget(network, priorities):
    budgets = [0.0, 0.07, 0.2]
    result = evaluate(network, priorities, budgets=budgets, n_runs=60, seed=5)
    for name, priority in priorities.items():
        for budget in budgets:
            burns = simulate(network, breaks=select_breaks(priority, budget=budget), n_runs=60, seed=5)
            got = result["burnt_share"].sel(ranking=name, budget=budget) * network.n_burnable
            np.testing.assert_allclose(got, burns["fire_size"])
    start = result.isel(budget=0)["burnt_share"]
    assert (start == start[0]).all()
    rows = table(result)
    assert list(rows.columns) == [
        "method",
        "d_f",
        "cells_cut",
        "mean",
        "p90",
        "max",
        "p_value",
        "effect_size",
        "significant",
    ]
    assert len(rows) == 9
    assert rows.loc[rows["d_f"] == 0.07, "cells_cut"].eq(round(0.07 * network.n_burnable)).all()


def test_missing_baseline_and_falling_budgets_are_refused(network, priorities):
    with pytest.raises(ParameterError, match="baseline"):
        evaluate(network, priorities, budgets=[0.1], baseline="nothing", n_runs=2)
    with pytest.raises(ParameterError, match="rising"):
        evaluate(network, priorities, budgets=[0.2, 0.1], n_runs=2)


def test_comparison_is_made_on_fresh_shared_fires(network, priorities):
    value = np.random.default_rng(2).random(network.shape)
    fires = FireRequest(n_runs=50, seed=4)
    result = compare_plans(network, priorities, fires, budgets=[0.1, 0.3], residuals=[0.0, 0.1], value=value)
    plain = compare_plans(network, priorities, fires, budgets=[0.1, 0.3], residuals=[0.0, 0.1])
    np.testing.assert_array_equal(result["burnt"], plain["burnt"])
    np.testing.assert_array_equal(plain["burnt"], plain["lost"])
    for name, priority in priorities.items():
        mask = select_breaks(priority, budget=0.3, burnable=network.burnable)
        for residual in (0.0, 0.1):
            burns = simulate(
                network, breaks=mask, residual=residual, value=value, n_runs=50, seed=seed_for(4, "comparison")
            )
            picked = result.sel(ranking=name, budget=0.3, residual=residual)
            np.testing.assert_array_equal(picked["burnt"], burns["fire_size"])
            np.testing.assert_allclose(picked["lost"], burns["value_lost"])
    assert (result["burnt"].sel(residual=0.0) <= result["burnt"].sel(residual=0.1)).all()
    rows = comparison_table(result)
    assert len(rows) == 12
    for name in ("burnt_ha", "p90_ha", "cvar_ha", "value_lost", "leverage"):
        assert (rows[f"{name}_low"] <= rows[name] + 1e-12).all()
        assert (rows[name] <= rows[f"{name}_high"] + 1e-12).all()
    row = rows.iloc[0]
    picked = result.sel(ranking=row["method"], budget=row["d_f"], residual=row["residual"])["burnt"].to_numpy()
    area = network.grid.cell_area_ha
    assert row["burnt_ha"] == pytest.approx(picked.mean() * area)
    assert row["cvar_ha"] == pytest.approx(np.sort(picked)[-5:].mean() * area)
    saved = (result["burnt_untreated"].to_numpy() - picked).mean() / row["cells_cut"]
    assert row["leverage"] == pytest.approx(saved)


def test_value_lost_is_summed_over_burnt_cells():
    network = SpreadNetwork(np.ones((8, 4, 6)))
    value = np.arange(24.0).reshape(4, 6)
    burns = simulate(network, value=value, n_runs=5)
    assert (burns["value_lost"] == value.sum()).all()


def test_range_and_direction_of_significance():
    rng = np.random.default_rng(0)
    base = rng.integers(0, 1000, (60, 5))
    shift = np.array([0, 0, -600, -600, 600])
    result = summarise({"a": base + shift, "random": base}, fuel=1000, budgets=[0, 0.1, 0.2, 0.3, 0.4])
    assert better_range(result, "a") == [0.2, 0.3]
    assert result["significant"].sel(ranking="a").to_numpy().tolist() == ["no", "no", "better", "better", "worse"]
    same = summarise({"a": base, "random": base}, fuel=1000, budgets=[0, 0.1, 0.2, 0.3, 0.4])
    assert better_range(same, "a") is None


def signed_rank_by_pratt(difference):
    """Two-sided p of Wilcoxon's test as Pratt (1959) does it: zeros are ranked with the others, then left out."""
    size = [abs(d) for d in difference]
    ranks = [sum(s < own for s in size) + (sum(s == own for s in size) + 1) / 2 for own in size]
    kept = [(rank, d) for rank, d in zip(ranks, difference, strict=True) if d != 0]
    positive = sum(rank for rank, d in kept if d > 0)
    mean, variance = sum(rank for rank, _ in kept) / 2, sum(rank**2 for rank, _ in kept) / 4
    return math.erfc(abs(positive - mean) / math.sqrt(2 * variance))


@pytest.mark.parametrize("seed", range(4))
def test_fires_that_do_not_differ_are_ranked_by_pratts_method(seed):
    """Breaks that a fire never meets change nothing: such runs count, and dropping them would tell too much."""
    rng = np.random.default_rng(seed)
    burnt = rng.integers(0, 30, 160) / 30.0
    other = burnt + np.where(rng.random(160) < 0.5, 0.0, rng.integers(-6, 9, 160) / 30.0)
    difference = np.round(burnt - other, 9)
    assert 20 < np.count_nonzero(difference == 0) < 105
    p, _ = tell_apart(difference, np.zeros(160))
    assert p == pytest.approx(signed_rank_by_pratt(difference.tolist()), rel=1e-9)
    for method in ("wilcox", "zsplit"):
        assert p != pytest.approx(stats.wilcoxon(difference, zero_method=method, method="approx").pvalue, rel=1e-3)


@pytest.mark.parametrize("orientation", ["in", "out"])
def test_bonacich_with_beta_1_is_the_eigenvector(network, orientation):
    """And the scores with beta just below it lie in that direction."""
    one = rank(network, "bonacich", beta=1.0, orientation=orientation).to_numpy()
    np.testing.assert_array_equal(one, rank(network, "eigenvector", orientation=orientation).to_numpy())
    near = rank(network, "bonacich", beta=1 - 1e-9, orientation=orientation).to_numpy()
    fuel = network.burnable
    np.testing.assert_allclose(near[fuel] / near[fuel].max(), one[fuel], atol=1e-6)


def test_what_burns_under_the_same_cells_burns_once(network, priorities, monkeypatch):
    """At no cut, which each ranking begins with, and where two agree; the numbers are those of fires of their own."""
    burnt = []

    def burn_on(*args, **how):
        burnt.append(how["breaks"])
        return ground_fires.burn_on(*args, **how)

    monkeypatch.setattr(budgets, "burn_on", burn_on)
    asked = [0.0, 0.1, 0.3]
    more = {"duration": "4h", "hold": 0.5, "n_runs": 20, "seed": 7}
    timed = SpreadNetwork(
        network.probability, burnable=network.burnable, travel_time=np.full(network.probability.shape, 20.0)
    )
    same = priorities["random"].copy()
    result = evaluate(timed, {**priorities, "again": same}, budgets=asked, **more)
    assert len(burnt) == 1 + 3 * 2
    for name, priority in priorities.items():
        for budget in asked:
            burns = simulate(timed, breaks=select_breaks(priority, budget=budget), **more)
            got = result["burnt_cells"].sel(ranking=name, budget=budget)
            np.testing.assert_array_equal(got, burns["fire_size"])
    assert (result["burnt_cells"].sel(ranking="again") == result["burnt_cells"].sel(ranking="random")).all()


def test_sizes_are_told_apart_by_every_cell(network):
    sizes, one, other = budgets.Sizes(), np.zeros(network.shape), np.zeros(network.shape)
    one[3, 4] = other[3, 5] = 1
    for k, breaks in enumerate((None, one, other)):
        assert sizes.of(breaks) is None
        sizes.keep(breaks, np.array([k]))
    assert [sizes.of(breaks).item() for breaks in (np.zeros(network.shape), one > 0, 2 * other)] == [0, 1, 2]
    line = LineBreaks.__new__(LineBreaks)  # of cells that pass, lines do not tell how much stays open
    sizes.keep(line, np.array([9]))
    assert sizes.of(line) is None
