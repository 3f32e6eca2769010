"""Rankings and the local search against the best plan for the same fires, by integer programming."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from firebreak_gis import simulate
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.fires import design_fires
from firebreak_gis.stakes import Stakes
from tests.benchmarks.yardstick import SEARCHED, artificial_windows, best, plans
from tests.twins import placement as twin
from tests.twins.optimum import optimum
from tests.twins.timed_optimum import drawn, lost_cells, timed_optimum


@pytest.mark.parametrize("seed", range(3))
def test_the_optimum_is_that_of_trying_all_plans(seed):
    random = np.random.default_rng(seed)
    network = SpreadNetwork(0.5 * random.random((8, 4, 5)).astype(np.float32), burnable=random.random((4, 5)) > 0.1)
    stakes = Stakes(network, value=random.integers(0, 9, (4, 5)), cost=random.integers(1, 4, (4, 5)))
    fires = design_fires(network, stakes, n_runs=6, seed=seed)
    graphs = [twin.open_graph(network, fires, run) for run in range(6)]
    fuel, cost, value = np.flatnonzero(network.burnable), stakes.cost.ravel(), stakes.value.ravel()
    lost = []
    for chosen in itertools.chain.from_iterable(itertools.combinations(fuel, k) for k in range(6)):
        if cost[list(chosen)].sum() <= 5:
            alive = network.burnable.ravel().copy()
            alive[list(chosen)] = False
            starts = zip(graphs, fires.cells.tolist(), strict=True)
            lost.append(sum(twin.loss(graph, start, alive, value) for graph, start in starts) / 6 / value.sum())
    found = optimum(network, stakes, fires, budget=5.0)
    assert found.proven
    assert found.lost == pytest.approx(min(lost), abs=1e-9)
    assert found.bound == pytest.approx(min(lost), rel=1e-5, abs=1e-9)
    assert cost[found.cut.ravel()].sum() <= 5


def test_the_local_search_comes_close_to_the_optimum_and_nothing_passes_it():
    ratios = []
    for problem in artificial_windows(4):
        answer = best(problem, seconds=30.0)
        for name, cut in plans(problem, moves=400).items():
            assert cut.sum() <= problem.count, name
            assert not (cut & problem.stakes.protected).any(), name
            assert problem.lost(cut) >= answer.bound * (1 - 1e-6), name
            if name == SEARCHED:
                ratios.append(problem.lost(cut) / answer.lost)
    assert np.mean(ratios) <= 1.1


@pytest.mark.parametrize("seed", range(3))
def test_the_optimum_of_fires_with_a_clock_is_that_of_trying_all_plans(seed):
    random = np.random.default_rng(seed)
    shape = (4, 5)
    network = SpreadNetwork(
        0.7 * random.random((8, *shape)).astype(np.float32),
        travel_time=60.0 * random.integers(1, 4, (8, *shape)),
        burnable=random.random(shape) > 0.1,
    )
    stakes = Stakes(network, cost=random.integers(1, 4, shape))
    fires = drawn(network, n=6, minutes=4, seed=seed)
    fuel, cost = np.flatnonzero(network.burnable), stakes.cost.ravel()
    lost = []
    for chosen in itertools.chain.from_iterable(itertools.combinations(fuel, k) for k in range(6)):
        if cost[list(chosen)].sum() <= 5:
            cut = np.zeros(network.shape, bool)
            cut.ravel()[list(chosen)] = True
            lost.append(np.mean([lost_cells(network, fire, cut) for fire in fires]))
    found = timed_optimum(network, stakes, fires, budget=5.0)
    assert found.proven
    assert found.lost == pytest.approx(min(lost), abs=1e-9)
    assert found.bound == pytest.approx(min(lost), rel=1e-3, abs=1e-6)
    # Fires that burn for less time lose less, whatever is cut.
    short = [fire._replace(minutes=2) for fire in fires]
    assert timed_optimum(network, stakes, short, budget=5.0).lost <= found.lost


def test_the_fires_of_the_timed_yardstick_burn_as_those_of_the_program():
    """Where every edge is open, fire is where the program says that it is, at any minute."""
    random = np.random.default_rng(5)
    times = 60.0 * random.integers(1, 4, (8, 9, 11))
    network = SpreadNetwork(np.ones((8, 9, 11), np.float32), travel_time=times, burnable=random.random((9, 11)) > 0.2)
    cut = network.burnable & (random.random((9, 11)) < 0.1)
    (fire,) = drawn(network, n=1, minutes=5, seed=1)
    cut.ravel()[fire.start] = False
    start = np.zeros((9, 11))
    start.ravel()[fire.start] = 1.0
    burnt = simulate(network, breaks=cut, ignitions=start, duration="5min", n_runs=1)["fire_size"]
    assert lost_cells(network, fire, cut) == int(burnt[0])
