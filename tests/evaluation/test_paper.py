"""The paper's experiments: grey levels, tables, the order of the methods on artificial forests."""

import json

import numpy as np
import pytest

from firebreak_gis import forest, spread_network
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.paper.artificial_forest import METHODS, NAMED, artificial_forest, curve_table, summary
from firebreak_gis.evaluation.paper.landscape import crop, cut_table, grey_levels, landscape_experiment, middle


@pytest.fixture(scope="module")
def ensemble():
    return artificial_forest(n_forests=6, n_runs=5, seed=3, shape=(40, 47))


def test_forest_is_that_of_the_paper():
    landscape = forest((6, 8), seed=2)
    emptiness = landscape["emptiness"].to_numpy()
    assert 0 < emptiness.min() < emptiness.max() < 1
    network = spread_network(landscape, model="artificial")
    assert network.boundary == "periodic"
    steps = [(-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1)]
    for d, (down, right) in enumerate(steps):
        for row in range(6):
            for col in range(8):
                target = emptiness[(row + down) % 6, (col + right) % 8]
                assert network.probability[d, row, col] == np.float32(1 - target)
    assert (forest((6, 8), seed=3)["emptiness"] != emptiness).any()


def test_centralities_fall_before_random_and_eigenvector(ensemble):
    mean = ensemble["mean"].sel(budget=0.27)
    for label in ("bonacich 0.5", "bonacich 0.2", "betweenness", "degree"):
        assert mean.sel(ranking=label) < 0.6 * mean.sel(ranking="random")
    assert mean.sel(ranking="eigenvector") > mean.sel(ranking="bonacich 0.5")
    fallen = {label: row["d_f_below_0.3"] for label, row in summary(ensemble)["methods"].items()}
    assert 0.18 <= fallen["bonacich 0.5"] <= 0.27
    assert fallen["random"] > fallen["betweenness"] > 0.15


def test_table_and_summary(ensemble):
    rows = curve_table(ensemble)
    assert list(rows.columns) == ["method", "beta", "d_f", "mean", "p90", "max", "p_value"]
    assert len(rows) == 51 * len(METHODS)
    assert set(rows.loc[rows["method"] == "bonacich", "beta"]) == {0.2, 0.5, 0.8}
    assert (rows["mean"] <= rows["max"]).all()
    found = json.loads(json.dumps(summary(ensemble)))
    assert found["settings"] == {"n_forests": 6, "n_runs": 5, "seed": 3, "alpha": 0.01}
    mean = ensemble["mean"].sel(ranking="random").to_numpy()
    first = found["methods"]["random"]["d_f_below_0.3"]
    assert mean[round(100 * first)] < 0.3 <= mean[round(100 * first) - 1]


def test_rankings_that_the_paper_names_burn_the_same_fires(ensemble):
    named = artificial_forest(rankings="named", n_forests=2, n_runs=5, seed=3, shape=(40, 47))
    assert named["ranking"].to_numpy().tolist() == [label for label, _, _ in NAMED]
    for label in ("bonacich 0.5", "betweenness", "random"):
        both = (result["burnt_share"].sel(ranking=label)[:10] for result in (named, ensemble))
        np.testing.assert_array_equal(*both)
    mean = named["mean"]
    assert (mean.sel(budget=0.0) == mean.sel(budget=0.0)[0]).all()
    assert (mean.sel(budget=0.4, ranking=["information", "current flow", "percolation"]) < 0.3).all()
    assert set(curve_table(named)["method"]) == {method for _, method, _ in NAMED}
    with pytest.raises(ParameterError, match="paper, named"):
        artificial_forest(rankings="others")


def test_equal_seeds_give_equal_ensembles(ensemble):
    again = artificial_forest(n_forests=2, n_runs=5, seed=3, shape=(40, 47), threads=1)
    np.testing.assert_array_equal(again["burnt_share"], ensemble["burnt_share"][:, :10])
    with pytest.raises(ParameterError):
        artificial_forest(n_forests=0)


def test_grey_levels_are_sixteen_from_256_to_16():
    counts = np.arange(161).reshape(7, 23)  # every tenth lies on the edge of two bins
    frequency = (counts / 200).astype(np.float32)
    levels = grey_levels(frequency, 200)
    assert set(levels.ravel()) == set(range(16, 257, 16))
    assert levels[0, 0] == 256
    assert levels[-1, -1] == 16
    assert (np.diff(levels.ravel()) <= 0).all()
    assert all(256 - 16 * min(c // 10, 15) == v for c, v in zip(counts.flat, levels.flat, strict=True))
    frequency[2, 3] = np.nan
    assert grey_levels(frequency, 200)[2, 3] == 0
    assert (grey_levels(np.zeros((2, 3)), 200) == 256).all()


@pytest.mark.parametrize("n_runs", [7, 30, 48, 99, 1000])
def test_frequencies_on_the_edge_of_two_bins_go_to_the_upper_one(n_runs):
    for most in range(1, n_runs + 1):
        counts = np.arange(most + 1)
        levels = grey_levels((counts / n_runs).astype(np.float32)[None], n_runs)[0]
        assert levels.tolist() == [256 - 16 * min(16 * count // most, 15) for count in counts.tolist()]


def test_experiment_on_a_landscape(sample):
    left, right = float(sample["x"][20]), float(sample["x"][90])
    bottom, top = float(sample["y"][80]), float(sample["y"][10])
    result = landscape_experiment(sample, rectangle=(left, bottom, right, top), n_runs=20)
    assert result.window.sizes["x"] == 71
    assert result.window.sizes["y"] == 71
    x, y = middle(sample)
    assert bool(sample["burnable"].sel(x=x, y=y))
    assert result.fire["burn_frequency"].sel(x=x, y=y) == 1
    rows = cut_table(result)
    np.testing.assert_allclose(rows[["sparse", "normal", "dense"]].sum(axis=1), 1)
    assert rows["d_f"].tolist() == [0.14, 0.19]
    n_burnable = int(result.window["burnable"].sum())
    assert rows["cells_cut"].tolist() == [int(b * n_burnable + 0.5) for b in (0.14, 0.19)]
    assert result.evaluation["mean"].sel(ranking="random", budget=0.4) < 0.5
    with pytest.raises(ParameterError, match="at least 3 x 3"):
        crop(sample, (0.0, 0.0, 1.0, 1.0))


def test_windy_curves_are_fires_of_figure_4(sample):
    """Burnt from the one ignition with its wind, as `evaluate` burns them; the calm ones are others."""
    from firebreak_gis import evaluate, rank
    from firebreak_gis.errors import InputError

    window = (float(sample["x"][20]), float(sample["y"][80]), float(sample["x"][90]), float(sample["y"][10]))
    given = {"rectangle": window, "n_runs": 10, "wind_speed": 6.0, "wind_from_direction": 270.0}
    windy = landscape_experiment(sample, curves="windy", **given)
    network = spread_network(windy.window, wind_speed=6.0, wind_from_direction=270.0)
    again = evaluate(
        network,
        {"bonacich 0.5": rank(network, "bonacich"), "random": rank(network, "random")},
        budgets=[0.0, 0.14],
        ignitions=[middle(windy.window)],
        n_runs=10,
    )
    for name in ("bonacich 0.5", "random"):
        np.testing.assert_array_equal(
            windy.evaluation["burnt_cells"].sel(ranking=name, budget=[0.0, 0.14]),
            again["burnt_cells"].sel(ranking=name),
        )
    calm = landscape_experiment(sample, **given)
    assert (calm.evaluation["burnt_cells"] != windy.evaluation["burnt_cells"]).any()
    outside = (float(sample["x"][2]), float(sample["y"][2]))
    with pytest.raises(InputError):  # outside of the rectangle
        landscape_experiment(sample, curves="windy", ignition=outside, **given)


def test_class_table_counts_what_is_cut(sample):
    """Counted cell by cell; random cuts spread about the share of the fuel as they should."""
    from firebreak_gis import rank, select_breaks
    from firebreak_gis.evaluation.classes import class_table

    network = spread_network(sample)
    plans = {
        (f"random {seed}", 0.14): select_breaks(
            rank(network, "random", seed=seed), budget=0.14, burnable=network.burnable
        )
        for seed in range(40)
    }
    rows = class_table(sample, plans)
    density, fuel = sample["density"].to_numpy(), network.burnable
    first = rows[(rows["method"] == "random 3") & (rows["layer"] == "density")].set_index("class")
    codes = density[plans["random 3", 0.14].to_numpy() > 0].tolist()
    assert first["share"].to_dict() == {
        name: codes.count(code) / len(codes) for code, name in ((1, "sparse"), (2, "normal"), (3, "dense"))
    }
    assert first["random"]["dense"] == (density[fuel] == 3).sum() / fuel.sum()
    assert set(first["cells_cut"]) == {len(codes)}
    z = (rows["share"] - rows["random"]) / rows["random_sd"]
    assert abs(z.mean()) < 0.3
    assert 0.8 < z.std() < 1.2
    np.testing.assert_allclose(rows.groupby(["method", "layer"])[["share", "random"]].sum(), 1)
