"""Fires against "draw all edges, then search", and against what percolation theory knows."""

import numpy as np
import pytest
from scipy import ndimage

from firebreak_gis import SpreadNetwork, burn_curve, select_breaks, simulate
from firebreak_gis.kernels import draws
from firebreak_gis.simulation.ignitions import resolve_ignitions
from tests.twins import percolation as twin


def random_network(seed, shape=(9, 13), boundary="open", low=0.0, high=0.7):
    rng = np.random.default_rng(seed)
    probability = rng.uniform(low, high, (8, *shape)).astype(np.float32)
    probability[rng.random(probability.shape) < 0.15] = 0.0
    probability[rng.random(probability.shape) < 0.05] = 1.0
    return SpreadNetwork(probability, burnable=rng.random(shape) > 0.15, boundary=boundary)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("seed", range(3))
def test_runs_are_those_of_the_twin(seed, boundary):
    network = random_network(seed, boundary=boundary)
    cells = np.flatnonzero(network.burnable)
    x, y = network.grid.x, network.grid.y
    picked = [int(c) for c in cells[[0, cells.size // 2, -1]]]
    points = [(x[c % 13], y[c // 13]) for c in picked]
    keys = draws.run_keys(seed, "edges", 70)
    for mode in ("each", "all"):
        burns = simulate(network, ignitions=points, ignition_mode=mode, n_runs=70, seed=seed)
        begun = resolve_ignitions(network, points, mode=mode, n_runs=70, seed=seed)
        count = np.zeros(network.shape, int)
        for run in range(70):
            start = begun.cells[begun.starts[run] : begun.starts[run + 1]].tolist()
            assert start == picked if mode == "all" else start[0] in picked
            burnt = twin.burn(network, int(keys[run]), start)
            assert burns["fire_size"][run] == len(burnt)
            count.ravel()[list(burnt)] += 1
        np.testing.assert_array_equal(burns["burn_count"], count)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_every_budget_of_the_curve_is_a_simulation(boundary):
    network = random_network(5, (11, 8), boundary)
    rng = np.random.default_rng(1)
    priority = np.round(rng.random(network.shape), 1)  # ties
    budgets = np.linspace(0, 1, 24)
    priority[~network.burnable] = -np.inf
    curve = burn_curve(network, priority, budgets=budgets, n_runs=90, seed=3)
    for k, budget in enumerate(budgets):
        burns = simulate(network, breaks=select_breaks(priority, budget=budget), n_runs=90, seed=3)
        np.testing.assert_array_equal(curve[:, k], burns["fire_size"])
    assert (np.diff(curve.to_numpy(), axis=1) <= 0).all()


def test_breaks_of_the_twin():
    network = random_network(8)
    cut = np.random.default_rng(2).random(network.shape) < 0.2
    burns = simulate(network, breaks=cut, n_runs=40, seed=1)
    free = simulate(network, n_runs=40, seed=1)
    keys = draws.run_keys(1, "edges", 40)
    start = resolve_ignitions(network, n_runs=40, seed=1).cells
    for run in range(40):
        assert burns["fire_size"][run] == len(twin.burn(network, int(keys[run]), [int(start[run])], cut))
    assert (burns["fire_size"] <= free["fire_size"]).all()
    assert (burns["burn_count"] <= free["burn_count"]).all()
    assert not burns["burn_count"].to_numpy()[cut].any()


def test_threads_and_number_of_runs_change_nothing():
    network = random_network(4, (30, 41), high=0.5)
    one = simulate(network, n_runs=150, seed=9, threads=1)
    for threads in (2, 3):
        other = simulate(network, n_runs=150, seed=9, threads=threads)
        assert one.identical(other)
    fewer = simulate(network, n_runs=33, seed=9)
    np.testing.assert_array_equal(fewer["fire_size"], one["fire_size"][:33])
    priority = np.random.default_rng(0).random(network.shape)
    curves = [burn_curve(network, priority, budgets=[0, 0.2, 0.4], n_runs=150, seed=9, threads=t) for t in (1, 2)]
    assert curves[0].identical(curves[1])


def chain(p, length):
    probability = np.zeros((8, 1, length), np.float32)
    probability[2, 0, :-1] = p
    return SpreadNetwork(probability)


@pytest.mark.parametrize("p", [0.3, 0.8, 0.95])
def test_chain_is_reached_with_a_power_of_p(p):
    network = chain(p, 12)
    n_runs = 40_000
    burns = simulate(network, ignitions=[(0.5, -0.5)], n_runs=n_runs, seed=2)
    expected = p ** np.arange(12)
    error = np.sqrt(expected * (1 - expected) / n_runs)
    assert (np.abs(burns["burn_count"][0] / n_runs - expected) <= 4.5 * error + 1e-12).all()


def test_certain_and_impossible_edges():
    full = SpreadNetwork(np.ones((8, 7, 9)))
    assert (simulate(full, n_runs=20)["fire_size"] == 63).all()
    none = SpreadNetwork(np.zeros((8, 7, 9)), burnable=np.ones((7, 9), bool))
    assert (simulate(none, n_runs=20)["fire_size"] == 1).all()


def test_ring_of_breaks_never_leaks_and_a_diagonal_does():
    shape = (15, 19)
    network = SpreadNetwork(np.ones((8, *shape)))
    row, col = np.mgrid[:15, :19]
    radius = np.hypot(row - 7, col - 9)
    inside = radius < 5
    ring = ndimage.binary_dilation(inside, np.ones((3, 3))) & ~inside
    burns = simulate(network, breaks=ring, ignitions=[(9.5, -7.5)], n_runs=5)
    assert (burns["fire_size"] == inside.sum()).all()
    thin = ndimage.binary_dilation(inside) & ~inside  # closed over corners only
    burns = simulate(network, breaks=thin, ignitions=[(9.5, -7.5)], n_runs=5)
    assert (burns["fire_size"] == (~thin).sum()).all()
    diagonal = row == col
    burns = simulate(network, breaks=diagonal, ignitions=[(18.5, -0.5)], n_runs=1)
    assert burns["fire_size"][0] == (~diagonal).sum()
    stairs = (row == col) | (row == col + 1)
    burns = simulate(network, breaks=stairs, ignitions=[(18.5, -0.5)], n_runs=1)
    assert burns["fire_size"][0] == (col > row).sum()


def crossing(shape, weights, p, n_runs, seed=0):
    """Share of runs in which a fire along the west side reaches the east side."""
    probability = np.empty((8, *shape), np.float32)
    for d in range(8):
        probability[d] = min(p * weights[d], 1.0)
    network = SpreadNetwork(probability)
    west = [(0.5, -r - 0.5) for r in range(shape[0])]
    hits = 0
    for run in range(n_runs):
        burns = simulate(network, ignitions=west, ignition_mode="all", n_runs=1, seed=seed + run)
        hits += bool(burns["burn_count"][:, -1].to_numpy().any())
    return hits / n_runs


@pytest.mark.parametrize(
    ("weights", "threshold", "size"),
    [
        ([1] * 8, 0.250368, 256),
        ([1, 0] * 4, 0.5, 256),
        ([1.6, 0, 0.4, 0] * 2, 0.5, 256),
    ],
    ids=["Moore", "nearest neighbours", "anisotropic: p_x + p_y = 1"],
)
def test_fires_cross_at_the_threshold_of_bond_percolation(weights, threshold, size):
    """On a square of either lattice half of the runs cross at the threshold, hardly any below, most above."""
    below = crossing((size, size + 1), weights, threshold - 0.01, 60)
    above = crossing((size, size + 1), weights, threshold + 0.01, 60)
    assert below < 0.5 < above
    assert above - below > 0.4


def test_mirrored_landscape_burns_alike():
    network = random_network(3, (12, 17), low=0.1, high=0.5)
    mirrored = SpreadNetwork(network.probability[[0, 7, 6, 5, 4, 3, 2, 1], :, ::-1], burnable=network.burnable[:, ::-1])
    n_runs = 20_000
    weights = network.burnable.astype(float)
    a = simulate(network, ignitions=weights, n_runs=n_runs, seed=1)["burn_count"].to_numpy() / n_runs
    b = simulate(mirrored, ignitions=weights[:, ::-1], n_runs=n_runs, seed=2)["burn_count"].to_numpy()[:, ::-1] / n_runs
    error = np.sqrt((a * (1 - a) + b * (1 - b)) / n_runs)
    assert (np.abs(a - b) <= 5 * error + 1e-12).all()
