"""Fires with a clock against Dijkstra with a heap, run by run, and against what must hold of any clock."""

from __future__ import annotations

import math

import numpy as np
import pytest

from firebreak_gis import SpreadNetwork, simulate
from firebreak_gis.kernels import draws
from firebreak_gis.lattice import NEVER
from firebreak_gis.simulation.holding import stretches
from firebreak_gis.simulation.ignitions import resolve_ignitions
from firebreak_gis.simulation.products import Products
from tests.twins.arrival import Fire, across
from tests.twins.percolation import word

EACH = Products(arrivals=True)


def random_network(seed, shape=(11, 14), boundary="open", high=0.7, least=7, most=900):
    random = np.random.default_rng(seed)
    probability = random.uniform(0.0, high, (8, *shape)).astype(np.float32)
    probability[random.random(probability.shape) < 0.15] = 0.0
    probability[random.random(probability.shape) < 0.05] = 1.0
    return SpreadNetwork(
        probability,
        burnable=random.random(shape) > 0.15,
        boundary=boundary,
        travel_time=random.integers(least, most, (8, *shape)),
        heat=np.full(shape, 40_000.0),
    )


def point(network, cell):
    row, col = divmod(int(cell), network.shape[1])
    return network.grid.x[col], network.grid.y[row]


def arrivals(burns, run):
    """Arrival of the burnt cells of a run."""
    found = burns["arrival"][run].to_numpy().ravel()
    return {int(c): int(found[c]) for c in np.flatnonzero(found != NEVER)}


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize(("least", "most"), [(7, 900), (1, 3), (1000, 1001), (1, 1 << 24)])
def test_runs_are_those_of_the_twin(boundary, least, most):
    network = random_network(3, boundary=boundary, least=least, most=most)
    fuel = np.flatnonzero(network.burnable)
    picked = [int(c) for c in fuel[[0, fuel.size // 2, -1]]]
    points = [point(network, c) for c in picked]
    keys = draws.run_keys(5, "edges", 40)
    lit = resolve_ignitions(network, points, n_runs=40, seed=5).cells
    assert set(lit.tolist()) == set(picked)
    for limit in (math.inf, 4.0 * (least + most)):
        given = {"ignitions": points, "ignition_mode": "each", "n_runs": 40, "seed": 5, "duration": limit}
        burns = simulate(network, products=EACH, **given)
        for run in range(40):
            fire = Fire(network, int(keys[run]), [network.travel_time], limit=limit)
            expected = fire.burn({int(lit[run]): 0})
            # Files and arrays tell arrivals up to 2^32 - 2 s.
            assert arrivals(burns, run) == {c: min(t, NEVER - 1) for c, t in expected.items()}
            assert burns["fire_size"][run] == len(expected)
        assert burns["burn_count"].sum() == burns["fire_size"].sum()


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_without_an_end_the_fires_are_those_without_a_clock(boundary):
    network = random_network(4, (23, 31), boundary=boundary, high=0.5)
    cut = np.random.default_rng(1).random(network.shape) < 0.2
    value = np.random.default_rng(2).random(network.shape)
    for breaks, residual in ((None, 0.0), (cut, 0.0), (cut, 0.3)):
        given = {"breaks": breaks, "residual": residual, "n_runs": 130, "seed": 2}
        plain = simulate(network, value=value, **given)
        assert simulate(network, value=value, duration=math.inf, **given).drop_vars("duration").identical(plain)
        timed = simulate(network, duration=1e9, **given)
        for name in ("burn_count", "burn_frequency", "fire_size"):
            assert timed[name].identical(plain[name])
        told = simulate(network, value=value, products=EACH, **given)
        assert ((told["arrival"] != NEVER).sum("run").astype(np.uint32) == plain["burn_count"]).all()


@pytest.mark.parametrize("residual", [0.0, 0.4, "plane"])
def test_breaks_and_failing_stretches_are_those_of_the_twin(residual):
    network = random_network(6)
    random = np.random.default_rng(3)
    cut = random.random(network.shape) < 0.35
    residual = np.random.default_rng(4).choice([0.0, 0.4, 1.0], network.shape) if residual == "plane" else residual
    cell = int(np.flatnonzero(network.burnable & ~cut)[20])
    keys, holding = draws.run_keys(1, "edges", 50), draws.run_keys(1, "hold", 50)
    from firebreak_gis.simulation.holding import Hold

    burns = simulate(
        network,
        breaks=cut,
        residual=residual,
        hold=Hold(0.6, length=4.0),
        ignitions=point(network, cell),
        duration=6000,
        n_runs=50,
        seed=1,
        products=EACH,
    )
    block = stretches(network.shape, 1.0, 4.0).ravel()
    failed = 0
    for run in range(50):
        holds = [word(int(holding[run]), 2 * int(b)) >> 32 < round(0.6 * 2**32) for b in block]
        stands = frozenset(int(c) for c in np.flatnonzero(cut) if holds[c])
        failed += cut.sum() - len(stands)
        fire = Fire(network, int(keys[run]), [network.travel_time], limit=6000, stands=stands, residual=residual)
        assert arrivals(burns, run) == fire.burn({cell: 0})
    assert 0.3 < failed / 50 / cut.sum() < 0.5


def test_threads_and_pieces_change_nothing():
    network = random_network(7, (31, 40), high=0.5)
    asked = Products(by=(900.0, 2000.0), quantiles=(0.1, 0.5), size_classes=(0.001, 0.01), paths=True, arrivals=True)
    given = {"n_runs": 100, "seed": 9, "duration": "lognormal:1h,0.7", "products": asked}
    one = simulate(network, threads=1, **given)
    assert one.identical(simulate(network, threads=3, **given))
    late = simulate(network, threads=2, **(given | {"n_runs": 40}), first_run=60)
    for name in ("fire_size", "fire_size_by", "duration", "arrival"):
        np.testing.assert_array_equal(late[name], one[name][60:])


def test_weather_that_changes_is_crossed_share_by_share():
    random = np.random.default_rng(0)
    starts = [0, 100, 250, 1000]
    for _ in range(300):
        seconds = [int(s) for s in random.integers(1, 900, 4)]
        if random.random() < 0.3:
            seconds[random.integers(0, 3)] = NEVER
        times = [across(t, seconds, starts) for t in range(0, 1500, 7)]
        assert times == sorted(times)  # first in, first out
        assert all(across(t, [seconds[0]] * 4, starts) == t + seconds[0] for t in (0, 99, 180) if seconds[0] != NEVER)
