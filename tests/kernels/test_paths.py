"""Betweenness and closeness against igraph, networkx and exact arithmetic."""

from __future__ import annotations

import math
import re
import threading

import igraph
import networkx as nx
import numpy as np
import pytest

from firebreak_gis.errors import Cancelled
from firebreak_gis.kernels import centrality, paths
from firebreak_gis.kernels.centrality import betweenness, closeness, error_bound, sampled_betweenness
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.ranking import rank
from tests.twins import centrality as twin

CASES = [(seed, boundary) for seed in range(5) for boundary in ("open", "periodic")]


def landscape(seed: int, boundary: str = "open", shape: tuple[int, int] | None = None) -> SpreadNetwork:
    """Probabilities over ten decades, holes, zero edges, and a wall that cuts an island off an open map."""
    random = np.random.default_rng(seed)
    rows, cols = shape or (9 + seed, 15)
    probability = random.random((8, rows, cols)).astype(np.float32) ** (1 + 2 * seed)
    probability[random.random(probability.shape) < 0.2] = 0
    burnable = random.random((rows, cols)) > 0.15
    burnable[:, 2 * cols // 3] = False
    return SpreadNetwork(probability, burnable=burnable, boundary=boundary)


def classes(seed: int, boundary: str = "open", shape: tuple[int, int] = (8, 11)) -> SpreadNetwork:
    """Few fuel classes: many routes of equal length."""
    fuel = np.random.default_rng(seed).choice([0.0, 0.406, 0.58, 0.812], shape)
    probability = np.empty((8, *shape), np.float32)
    for d in range(8):
        probability[d] = np.roll(fuel, (-paths.ROW_STEP[d], -paths.COL_STEP[d]), axis=(0, 1))
    return SpreadNetwork(probability, burnable=fuel > 0, boundary=boundary)


def weighted_graph(network: SpreadNetwork) -> nx.DiGraph:
    graph = nx.DiGraph()
    graph.add_nodes_from(np.flatnonzero(network.burnable).tolist())
    graph.add_weighted_edges_from((a, b, float(length)) for a, b, length in twin.edges(network))
    return graph


def on_map(network: SpreadNetwork, values: dict[int, float]) -> np.ndarray:
    result = np.zeros(network.burnable.size)
    result[list(values)] = list(values.values())
    return result.reshape(network.shape)


@pytest.mark.parametrize("make", [landscape, classes])
@pytest.mark.parametrize(("seed", "boundary"), CASES)
def test_betweenness_is_that_of_networkx(make, seed, boundary):
    network = make(seed, boundary)
    got = betweenness(network.probability, network.burnable, boundary=boundary)
    expected = on_map(network, nx.betweenness_centrality(weighted_graph(network), weight="weight", normalized=False))
    assert expected.max() > 10
    np.testing.assert_allclose(got, expected, rtol=3e-15, atol=3e-15 * expected.max())


@pytest.mark.parametrize("seed", range(3))
def test_betweenness_is_that_of_igraph(seed):
    network = landscape(0, "open", (21 + seed, 30))
    edges = twin.edges(network)
    graph = igraph.Graph(n=network.burnable.size, edges=[(a, b) for a, b, _ in edges], directed=True)
    expected = np.array(graph.betweenness(weights=[float(length) for *_, length in edges])).reshape(network.shape)
    got = betweenness(network.probability, network.burnable)
    np.testing.assert_allclose(got, expected, rtol=1e-14, atol=1e-12)


def test_rounded_lengths_do_not_change_the_routes():
    """Against 1/p itself, where no two routes tie."""
    network = landscape(0, "open", (12, 17))
    graph = network.to_networkx()
    between, close = rank(network, "betweenness").values, rank(network, "closeness").values
    for cell, value in nx.betweenness_centrality(graph, weight="length", normalized=False).items():
        assert between[cell] == pytest.approx(value, rel=1e-12)
    for cell, value in nx.closeness_centrality(graph, distance="length").items():
        assert close[cell] == pytest.approx(value, rel=1e-7)


@pytest.mark.parametrize("make", [landscape, classes])
@pytest.mark.parametrize(("seed", "boundary"), CASES)
def test_closeness_is_that_of_networkx(make, seed, boundary):
    network = make(seed, boundary)
    graph = weighted_graph(network)
    for transpose, directed in ((True, graph), (False, graph.reverse())):
        got = closeness(network.probability, network.burnable, boundary=boundary, transpose=transpose)
        expected = on_map(network, nx.closeness_centrality(directed, distance="weight"))
        np.testing.assert_allclose(got, expected, rtol=1e-14)


def test_lengths_are_multiples_of_the_unit():
    p = np.array([1.0, 0.58, 1 / 3, 1e-3, 0.0, 1e-30], np.float32)
    got = paths.edge_lengths(p)
    assert got[:4].tolist() == [float(twin.length(x)) for x in p[:4]]
    assert got[4] == np.inf
    assert got[5] == 2.0**32
    np.testing.assert_allclose(got[:4], 1 / p[:4].astype(float), rtol=3e-8)


def test_more_shortest_paths_than_a_float_can_count():
    """A uniform strip: the number of routes passes 1e308 long before its end."""
    network = SpreadNetwork(np.full((8, 7, 760), 0.5, np.float32))
    lattice = paths.lattice(network.probability, network.burnable)
    space = paths.Workspace(lattice)
    total = np.zeros(lattice.lengths.shape[0])
    source = 3 * 760
    centrality.betweenness_batch(
        lattice.cells[[source]],
        np.ones(1),
        lattice.lengths,
        lattice.absent,
        lattice.offset,
        lattice.home,
        lattice.shift,
        *space.labels,
        *space.counts,
        total,
    )
    exponent = space.counts[1]
    assert exponent.max() > 0
    expected = twin.dependencies(network, source)
    np.testing.assert_allclose(total.reshape(9, 762)[1:-1, 1:-1], expected, rtol=1e-12)


def test_labels_beyond_the_ring_wait_their_turn():
    """One long detour and one long edge, each thousands of buckets away from the rest."""
    probability = np.zeros((8, 1, 5), np.float32)
    probability[2, 0, :4] = [1.0, 1e-6, 1.0, 1e-5]
    probability[6, 0, 1:] = [1.0, 1e-4, 1.0, 1e-7]
    network = SpreadNetwork(probability)
    lattice = paths.lattice(network.probability, network.burnable)
    assert lattice.ring == 4096
    graph = weighted_graph(network)
    expected = on_map(network, nx.closeness_centrality(graph, distance="weight"))
    got = closeness(network.probability, network.burnable, transpose=True)
    np.testing.assert_allclose(got, expected, rtol=1e-14)


@pytest.mark.parametrize("name", twin.SYMMETRIES)
def test_turned_maps_give_turned_results(name):
    symmetry = twin.SYMMETRIES[name]
    for boundary in ("open", "periodic"):
        network = classes(7, boundary)
        turned = twin.turn_network(network, symmetry)
        for function in (betweenness, closeness):
            expected = twin.turn(function(network.probability, network.burnable, boundary=boundary), symmetry)
            got = function(turned.probability, turned.burnable, boundary=boundary)
            np.testing.assert_allclose(got, expected, rtol=1e-13, atol=1e-12)


def test_threads_do_not_change_a_bit():
    network = classes(3, "open", (23, 31))
    for function in (betweenness, closeness):
        results = [function(network.probability, network.burnable, threads=threads) for threads in (1, 2, 5)]
        assert (results[0] == results[1]).all()
        assert (results[0] == results[2]).all()
    samples = [
        sampled_betweenness(network.probability, network.burnable, pivots=200, seed=4, threads=threads)
        for threads in (1, 3)
    ]
    assert (samples[0].values == samples[1].values).all()
    assert samples[0].epsilon == samples[1].epsilon


def test_all_pivots_are_the_exact_result():
    network = classes(1)
    n_cells = network.n_burnable
    sample = sampled_betweenness(network.probability, network.burnable, pivots=n_cells)
    exact = betweenness(network.probability, network.burnable)
    np.testing.assert_allclose(sample.values, exact, rtol=1e-13, atol=1e-12)
    assert sample.epsilon == 0.0
    assert sample.pivots == n_cells


def test_sampling_keeps_its_promise():
    network = SpreadNetwork(np.random.default_rng(5).random((8, 34, 47)).astype(np.float32))
    n_cells = network.n_burnable
    exact = betweenness(network.probability, network.burnable) / (n_cells * (n_cells - 1))
    misses, errors = 0, []
    for seed in range(20):
        sample = sampled_betweenness(network.probability, network.burnable, epsilon=0.06, delta=0.1, seed=seed)
        error = np.abs(sample.values / (n_cells * (n_cells - 1)) - exact).max()
        assert sample.epsilon <= 0.06
        assert sample.pivots < n_cells
        misses += error > sample.epsilon
        errors.append(error)
    assert misses <= 2
    assert len(set(errors)) == 20


def test_sampling_is_unbiased():
    network = classes(2)
    exact = betweenness(network.probability, network.burnable)
    draws = np.array(
        [sampled_betweenness(network.probability, network.burnable, pivots=10, seed=seed).values for seed in range(300)]
    )
    deviation = np.abs(draws.mean(axis=0) - exact)
    spread = draws.std(axis=0) / math.sqrt(len(draws))
    assert (deviation <= 4.5 * spread + 1e-9).all()


def test_error_bound_is_the_binomial_tail():
    """Where no estimate is above 0 the bound is 1 - (delta / 2n)**(1/k); it shrinks with k and is 0 with all."""
    assert error_bound(0.0, 100, 5000, 0.1) == pytest.approx(1 - (0.1 / 10_000) ** 0.01, rel=1e-9)
    assert error_bound(0.01, 400, 5000, 0.1) < error_bound(0.01, 100, 5000, 0.1)
    assert error_bound(0.01, 100, 5000, 0.1) < error_bound(0.05, 100, 5000, 0.1) < error_bound(0.6, 100, 5000, 0.1)
    assert error_bound(0.2, 5000, 5000, 0.1) == 0.0


def test_progress_of_sampling_shows_the_bound_and_rises():
    network = SpreadNetwork(np.random.default_rng(6).random((8, 40, 53)).astype(np.float32))
    calls: list[tuple[float, str]] = []
    sample = sampled_betweenness(
        network.probability, network.burnable, epsilon=0.05, progress=lambda share, text: calls.append((share, text))
    )
    shares = [share for share, _ in calls]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert calls[-1][1] == f"{sample.pivots} pivots, error below {sample.epsilon:.3g}"
    told = [re.fullmatch(r"(\d+) pivots, error below (\S+)", text) for _, text in calls]
    assert all(told)
    pivots, bounds = zip(*((int(match[1]), float(match[2])) for match in told if match), strict=True)
    assert list(pivots) == sorted(pivots)
    assert bounds[0] == 1.0
    assert any(0.05 < bound < 1.0 for bound in bounds)  # it comes down on the way
    assert bounds[-1] <= 0.05


def test_progress_is_called_while_a_batch_runs(monkeypatch):
    monkeypatch.setattr(centrality, "_PATIENCE", 0.001)
    monkeypatch.setattr(centrality, "_BATCH_SOURCES", 10_000)
    monkeypatch.setattr(centrality, "_BATCH_CELLS", 10**9)
    network = SpreadNetwork(np.random.default_rng(6).random((8, 40, 53)).astype(np.float32))
    shares: list[float] = []
    betweenness(network.probability, network.burnable, progress=lambda share, _: shares.append(share))
    assert shares[0] == 0.0  # before the only batch is done
    assert shares[-1] == 1.0


def test_cancelling_stops_early():
    network = SpreadNetwork(np.random.default_rng(6).random((8, 60, 71)).astype(np.float32))
    calls = 0

    def stop(share: float, text: str) -> None:
        nonlocal calls
        calls += 1
        raise Cancelled("stopped")

    for function in (betweenness, closeness, sampled_betweenness):
        calls = 0
        with pytest.raises(Cancelled):
            function(network.probability, network.burnable, progress=stop)
        assert calls == 1


@pytest.mark.parametrize("threads", [1, 2])
def test_a_batch_that_fails_ends_the_work(monkeypatch, threads):
    """Its error comes out, and no other batch waits for the workspace that it held."""

    def fails(*arguments):
        raise MemoryError("no room")

    monkeypatch.setattr(centrality, "betweenness_batch", fails)
    monkeypatch.setattr(centrality, "distance_batch", fails)
    monkeypatch.setattr(centrality, "_BATCH_SOURCES", 10)
    network = SpreadNetwork(np.random.default_rng(6).random((8, 20, 31)).astype(np.float32))
    for function in (betweenness, closeness, sampled_betweenness):
        errors: list[BaseException] = []

        def work(function=function, errors=errors):
            try:
                function(network.probability, network.burnable, threads=threads)
            except MemoryError as caught:
                errors.append(caught)

        worker = threading.Thread(target=work, daemon=True)
        worker.start()
        worker.join(timeout=20)
        assert not worker.is_alive()
        assert [str(error) for error in errors] == ["no room"]


def test_default_is_exact_on_small_maps_and_sampled_on_large_ones(monkeypatch):
    from firebreak_gis.ranking import betweenness as plugin

    network = SpreadNetwork(np.random.default_rng(8).random((8, 30, 41)).astype(np.float32))
    exact = betweenness(network.probability, network.burnable)
    assert (rank(network, "betweenness", seed=1).values == exact).all()
    monkeypatch.setattr(plugin, "EXACT_CELLS", 100)
    sampled = rank(network, "betweenness", epsilon=0.08, seed=1).values
    assert (sampled != exact).any()
    assert (sampled != rank(network, "betweenness", epsilon=0.08, seed=2).values).any()
    assert (rank(network, "betweenness", pivots=50).values != exact).any()
