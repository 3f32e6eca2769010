"""Rankings beyond the paper's five against networkx, dense matrices and paths listed one by one."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest

from firebreak_gis.breaks import removal_order
from firebreak_gis.kernels.centrality import betweenness
from firebreak_gis.kernels.groups import uncovered
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.currents import Circuit, resistance_sums, sampled_throughput, sampling_error, throughput
from firebreak_gis.ranking import domirank, rank
from firebreak_gis.stakes import Stakes
from tests.twins import centrality as twin

SEEDS = range(30)


def landscape(seed: int, shape: tuple[int, int] | None = None) -> SpreadNetwork:
    """Holes, zero edges, edges of one direction only, and a wall that makes islands; every third map is a torus."""
    random = np.random.default_rng(seed)
    rows, cols = shape or (5 + seed % 3, 8 + seed % 4)
    probability = random.random((8, rows, cols)).astype(np.float32)
    probability[random.random(probability.shape) < 0.25] = 0
    burnable = random.random((rows, cols)) > 0.15
    burnable[:, cols // 2] = False
    if seed % 2:
        burnable[:, cols // 2] = True
    return SpreadNetwork(probability, burnable=burnable, boundary="periodic" if seed % 3 == 0 else "open")


def circuit_graph(network: SpreadNetwork) -> nx.Graph:
    graph = nx.Graph()
    graph.add_nodes_from(np.flatnonzero(network.burnable).tolist())
    weights = twin.conductances(network)
    graph.add_weighted_edges_from(
        (int(a), int(b), float(weights[a, b])) for a, b in np.argwhere(np.triu(weights)) if a != b
    )
    return graph


def scores(network: SpreadNetwork, method: str, **params: object) -> np.ndarray:
    return rank(network, method, **params).values[network.burnable]


@pytest.mark.parametrize("seed", SEEDS)
def test_information_is_the_current_flow_closeness_of_networkx(seed):
    network = landscape(seed)
    graph = circuit_graph(network)
    expected = np.zeros(network.burnable.size)
    for part in nx.connected_components(graph):
        if len(part) > 1:
            inner = nx.current_flow_closeness_centrality(graph.subgraph(part), weight="weight")
            for cell, value in inner.items():  # 1 / (sum of resistances)
                expected[cell] = (len(part) - 1) ** 2 / (network.n_burnable - 1) * value
    expected = expected[network.burnable.ravel()]
    np.testing.assert_allclose(scores(network, "information"), expected, rtol=1e-8, atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_current_flow_is_the_current_flow_betweenness_of_networkx(seed):
    network = landscape(seed)
    graph = circuit_graph(network)
    expected = np.zeros(network.burnable.size)
    all_pairs = (network.n_burnable - 1) * (network.n_burnable - 2) / 2
    for part in nx.connected_components(graph):
        if len(part) > 2:
            inner = nx.current_flow_betweenness_centrality(graph.subgraph(part), weight="weight", normalized=True)
            for cell, value in inner.items():
                expected[cell] = value * ((len(part) - 1) * (len(part) - 2) / 2) / all_pairs
    expected = expected[network.burnable.ravel()]
    np.testing.assert_allclose(scores(network, "current_flow"), expected, rtol=1e-8, atol=1e-10)


@pytest.mark.parametrize("seed", SEEDS)
def test_percolation_is_that_of_networkx(seed):
    network = landscape(seed)
    states = np.random.default_rng(seed).random(network.shape) ** 3
    graph = nx.DiGraph()
    cells = np.flatnonzero(network.burnable).tolist()
    graph.add_nodes_from(cells)
    graph.add_weighted_edges_from((a, b, float(length)) for a, b, length in twin.edges(network))
    found = nx.percolation_centrality(
        graph, states={cell: float(states.ravel()[cell]) for cell in cells}, weight="weight"
    )
    got = rank(network, "percolation", stakes=Stakes(network, ignition=states)).values[network.burnable]
    np.testing.assert_allclose(got, [found[cell] for cell in cells], rtol=1e-8, atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("orientation", ["in", "out"])
def test_pagerank_is_that_of_networkx(seed, orientation):
    network = landscape(seed)
    graph = network.to_networkx()
    graph = graph if orientation == "in" else graph.reverse()
    found = nx.pagerank(graph, alpha=0.8, weight="probability", tol=1e-14, max_iter=1000)
    expected = [found[int(r), int(c)] for r, c in np.argwhere(network.burnable)]
    got = scores(network, "pagerank", damping=0.8, orientation=orientation)
    np.testing.assert_allclose(got, expected, rtol=1e-8)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("orientation", ["in", "out"])
def test_domirank_solves_its_equation(seed, orientation, monkeypatch):
    network = landscape(seed)
    for competition in (0.3, 0.95):
        expected = twin.domirank(network, competition, orientation)[network.burnable]
        got = scores(network, "domirank", competition=competition, orientation=orientation)
        np.testing.assert_allclose(got, expected, rtol=1e-8, atol=1e-9)
        # The ways of large maps: Arnoldi for the eigenvalue, BiCGSTAB for the solution.
        with monkeypatch.context() as small:
            small.setattr(domirank, "_DENSE", 0)
            small.setattr(domirank, "_FACTORISED", 0)
            if network.n_burnable > 66:
                again = scores(network, "domirank", competition=competition, orientation=orientation)
                np.testing.assert_allclose(again, expected, rtol=1e-7, atol=1e-8)


def test_domirank_without_competition_is_the_degree():
    network = landscape(1)
    np.testing.assert_array_equal(
        removal_order(rank(network, "domirank", competition=0.0)), removal_order(rank(network, "degree"))
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_gains_of_a_group_are_those_of_paths_listed_one_by_one(seed):
    network = landscape(seed)
    random = np.random.default_rng(seed)
    routes = uncovered(network.probability, network.burnable, boundary=network.boundary)
    for size in (0, 1, 4):
        group = np.zeros(network.shape, bool)
        group.ravel()[random.choice(np.flatnonzero(network.burnable), size, replace=False)] = True
        expected = twin.uncovered(network, set(np.flatnonzero(group).tolist()))
        np.testing.assert_allclose(routes.gains(group), expected, rtol=1e-8, atol=1e-9)


def test_tied_routes_are_shared_out():
    """On even ground there are thousands of equal routes; the exponents of their counts must not get lost."""
    network = SpreadNetwork(np.full((8, 3, 40), 0.5, np.float32))
    routes = uncovered(network.probability, network.burnable)
    none = np.zeros(network.shape, bool)
    np.testing.assert_allclose(routes.gains(none), betweenness(network.probability, network.burnable), rtol=1e-9)


def test_a_group_is_chosen_cell_by_cell():
    network = landscape(4)
    order = rank(network, "group_betweenness", recompute_every=1e-6, until=1.0).values
    group: set[int] = set()
    for _ in range(8):
        gains = np.where(network.burnable, twin.uncovered(network, group), -1.0)
        best = int(np.argmax(np.where(np.isin(np.arange(gains.size), list(group)).reshape(gains.shape), -1, order)))
        assert gains.ravel()[best] == pytest.approx(gains.max(), rel=1e-9)
        group.add(best)


def test_a_group_covers_more_than_the_same_number_of_single_scores():
    network = landscape(7, (14, 19))
    covered = {}
    everything = twin.uncovered(network, set()).sum()
    for method in ("group_betweenness", "betweenness"):
        first = np.argsort(-rank(network, method).values.ravel(), kind="stable")[:12]
        covered[method] = everything - twin.uncovered(network, set(first.tolist())).sum()
    assert covered["group_betweenness"] > covered["betweenness"]


def test_sampled_currents_keep_to_their_errors():
    network = landscape(3, (12, 17))
    circuit = Circuit(network)
    exact = throughput(circuit) / (circuit.n_cells * (circuit.n_cells - 1) / 2)
    for seed in range(5):
        sampled = sampled_throughput(circuit, pairs=300, seed=seed)
        assert np.abs(sampled - exact).max() <= sampling_error(circuit.n_cells, 300)
    sums = resistance_sums(circuit)
    ratios = [resistance_sums(circuit, probes=200, seed=seed) / sums - 1.0 for seed in range(5)]
    joined = circuit.size[circuit.part] > 1
    # A cell's own part of the sum is about half of it, and has a standard error of sqrt(2 / 200) = 10 %.
    assert 0.01 < np.std(np.array(ratios)[:, joined]) < 0.12


def test_sampled_percolation_keeps_to_its_error():
    network = landscape(5, (12, 17))
    states = np.random.default_rng(0).random(network.shape)
    stakes = Stakes(network, ignition=states)
    exact = rank(network, "percolation", stakes=stakes).values[network.burnable]
    bound = np.sqrt(np.log(20 * network.n_burnable) / 800) * (network.n_burnable - 1) / (network.n_burnable - 2)
    for seed in range(5):
        got = rank(network, "percolation", stakes=stakes, pivots=400, seed=seed).values[network.burnable]
        assert 0 < np.abs(got - exact).max() <= 1.01 * bound
