"""Walls by nested minimum cuts: they separate, are minimal and cheapest, keep off what is protected, and nest."""

from __future__ import annotations

import itertools

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.breaks import removal_order, select_breaks
from firebreak_gis.kernels.flow import UNCUTTABLE, best_cut, patch_links
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.dissection import Cut, capacities, dissect, sequence
from firebreak_gis.placement.edges import links
from firebreak_gis.placement.patterns import ExpectedLoss
from firebreak_gis.placement.widening import walls
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes
from tests.twins import centrality
from tests.twins import placement as twin

SEEDS = st.integers(0, 10_000)
LANDSCAPES = settings(max_examples=15, deadline=None, derandomize=True)


def landscape(seed: int, shape: tuple[int, int] = (19, 24)) -> tuple[SpreadNetwork, Stakes]:
    """Random fuel with holes, one-way edges, costs, values and protected cells; open or periodic."""
    random = np.random.default_rng(seed)
    probability = random.random((8, *shape)).astype(np.float32)
    probability[random.random(probability.shape) < 0.1] = 0
    network = SpreadNetwork(probability, burnable=random.random(shape) > 0.15, boundary=("open", "periodic")[seed % 2])
    coarse = random.random((shape[0] // 4 + 1, shape[1] // 4 + 1)) < 0.1
    protected = np.kron(coarse, np.ones((4, 4), bool))[: shape[0], : shape[1]]
    stakes = Stakes(
        network,
        cost=random.integers(0 if seed % 3 == 0 else 1, 10, shape),
        value=random.random(shape),
        ignition=random.random(shape),
        protected=protected,
    )
    return network, stakes


def graph_of(network: SpreadNetwork, cells: np.ndarray) -> nx.Graph:
    """Ways of fire in either direction among cells given by number."""
    places = [divmod(int(cell), network.shape[1]) for cell in cells]
    return network.to_networkx().to_undirected().subgraph(places)


def pieces(graph: nx.Graph, without: np.ndarray, cols: int) -> list[set[tuple[int, int]]]:
    left = graph.subgraph(set(graph) - {divmod(int(cell), cols) for cell in without})
    return list(nx.connected_components(left))


def cuts_of(network: SpreadNetwork, stakes: Stakes, **options: int) -> list[Cut]:
    return dissect(network, stakes, progress=silent, **options)


@LANDSCAPES
@given(seed=SEEDS)
def test_every_wall_separates_and_needs_all_its_cells(seed):
    network, stakes = landscape(seed)
    cols = network.shape[1]
    for cut in cuts_of(network, stakes):
        graph = graph_of(network, cut.compartment)
        assert nx.is_connected(graph)
        sides = pieces(graph, cut.cells, cols)
        assert len(sides) > 1
        for cell in cut.cells:
            near = set(graph[divmod(int(cell), cols)])
            assert sum(bool(near & side) for side in sides) > 1


@LANDSCAPES
@given(seed=SEEDS)
def test_walls_nest_and_keep_off_what_is_protected(seed):
    network, stakes = landscape(seed)
    cuts = cuts_of(network, stakes)
    for cut in cuts:
        assert network.burnable.ravel()[cut.cells].all()
        assert not stakes.protected.ravel()[cut.cells].any()
        assert cut.cost == pytest.approx(stakes.cost.ravel()[cut.cells].sum())
        assert np.isin(cut.cells, cut.compartment).all()
        if cut.parent >= 0:
            parent = cuts[cut.parent]
            assert np.isin(cut.compartment, parent.compartment).all()
            assert not np.isin(cut.compartment, parent.cells).any()
    assert sum(cut.cells.size for cut in cuts) == np.unique(np.concatenate([cut.cells for cut in cuts])).size


@LANDSCAPES
@given(seed=SEEDS)
def test_what_a_wall_saves_is_the_fall_of_the_expected_loss(seed):
    network, stakes = landscape(seed)
    expected = ExpectedLoss(network, stakes)
    cut = np.zeros(network.shape, bool)
    for wall in cuts_of(network, stakes):
        before = expected(cut)
        cut.ravel()[wall.cells] = True
        # Masses are shares of the whole landscape, of which fire may not reach all from one place.
        assert before - expected(cut) == pytest.approx(wall.saved, rel=1e-9, abs=1e-15)


@LANDSCAPES
@given(seed=SEEDS, share=st.sampled_from([0.02, 0.07, 0.2]))
def test_a_budget_in_money_is_kept_to_the_last_cell(seed, share):
    network, stakes = landscape(seed)
    priority = rank(network, "dissection", stakes=stakes)
    budget = share * float(stakes.cost.sum())
    cut = select_breaks(priority, budget=budget, unit="cost", cost=stakes.cost).values > 0
    spent = stakes.cost[cut].sum()
    assert spent <= budget
    assert not (cut & (stakes.protected | ~network.burnable)).any()
    order = removal_order(priority)
    following = (order >= 0) & (order == order[cut].max(initial=-1) + 1)
    assert spent + stakes.cost[following].sum() > budget
    smaller = select_breaks(priority, budget=budget / 2, unit="cost", cost=stakes.cost).values > 0
    assert (cut | ~smaller).all()


@LANDSCAPES
@given(seed=SEEDS, share=st.sampled_from([0.1, 0.25, 0.4]))
def test_a_cut_is_the_cheapest_between_its_ends(seed, share):
    network, stakes = landscape(seed, (7, 9))
    capacity = capacities(network, stakes).ravel()
    fuel = np.flatnonzero(network.burnable.ravel())
    component = max(nx.connected_components(graph_of(network, fuel)), key=len)
    cells = np.sort([row * network.shape[1] + col for row, col in component])
    near = patch_links(cells, links(network).ravel(), *network.shape, np.array(ROW_STEP), np.array(COL_STEP))
    order = np.argsort(cells % network.shape[1], kind="stable")
    mask = np.zeros(cells.size, np.uint8)
    one = np.ones(cells.size)
    _, cost = best_cut(near, capacity[cells], one, one, order[None], np.array([share]), mask)
    end = int(np.floor(share * cells.size + 1e-9)) + 1  # the first to hold more than the share
    source, sink = np.zeros(network.burnable.size, bool), np.zeros(network.burnable.size, bool)
    source[cells[order[:end]]], sink[cells[order[cells.size - end :]]] = True, True
    kept = np.where(capacity >= UNCUTTABLE, np.inf, capacity).reshape(network.shape)
    expected = twin.minimum_cut(network, source.reshape(network.shape), sink.reshape(network.shape), kept)
    assert (cost if mask.any() else np.inf) == expected
    if mask.any():
        assert capacity[cells[mask > 0]].sum() == expected
        assert len(pieces(graph_of(network, cells), cells[mask > 0], network.shape[1])) > 1


def test_dear_land_is_left_alone():
    inside = {1.0: 0, 2.0: 0}
    for seed in range(8):
        random = np.random.default_rng(seed)
        network = SpreadNetwork(random.random((8, 30, 41)).astype(np.float32), burnable=random.random((30, 41)) > 0.1)
        region = np.zeros(network.shape, bool)
        region[8:22, 14:27] = True
        for factor in inside:
            stakes = Stakes(network, cost=np.where(region, factor, 1.0))
            priority = rank(network, "dissection", stakes=stakes)
            cut = select_breaks(priority, budget=0.08, burnable=network.burnable).values > 0
            inside[factor] += int(cut[region].sum())
    assert inside[2.0] < 0.7 * inside[1.0]


@pytest.mark.parametrize("symmetry", [(True, 0), (False, 1), (True, 3)])
def test_a_turned_map_gives_an_equally_good_plan(symmetry):
    for seed in range(4):
        network, _ = landscape(2 * seed, (31, 40))
        losses = []
        for turned in (network, centrality.turn_network(network, symmetry)):
            priority = rank(turned, "dissection")
            expected = ExpectedLoss(turned, Stakes(turned))
            cuts = [select_breaks(priority, budget=b, burnable=turned.burnable).values > 0 for b in (0.05, 0.1, 0.2)]
            losses.append([expected(cut) for cut in cuts])
        np.testing.assert_allclose(losses[0], losses[1], rtol=0.05)


@pytest.mark.parametrize("width", [2, 3, 4])
def test_every_way_across_a_wide_wall_meets_its_width(width):
    network = SpreadNetwork(np.full((8, 40, 52), 0.5, np.float32))
    stakes = Stakes(network)
    cut = cuts_of(network, stakes, width=width, smallest=500)[0]
    wall = set(walls([cut.cells], network, stakes, width)[0][0].tolist())
    sides = pieces(graph_of(network, cut.compartment), cut.cells, network.shape[1])
    graph = nx.DiGraph()
    for a, b in network.to_networkx().edges:
        graph.add_edge(a, b, met=int(b[0] * network.shape[1] + b[1] in wall))
    free = [[cell for cell in side if cell[0] * network.shape[1] + cell[1] not in wall] for side in sides]
    assert all(free)
    met = nx.multi_source_dijkstra_path_length(graph, free[0], weight="met")
    assert min(met[cell] for cell in free[1]) == width


@LANDSCAPES
@given(seed=SEEDS, n=st.integers(1, 6))
def test_no_order_of_building_that_respects_parents_saves_more(seed, n):
    random = np.random.default_rng(seed)
    saved, cost = random.integers(0, 9, n).astype(float), random.integers(1, 9, n).astype(float)
    parent = [int(random.integers(-1, i)) if i else -1 for i in range(n)]

    def waited(order: list[int]) -> float:
        return float(np.cumsum(cost[list(order)]) @ saved[list(order)])

    order = sequence(saved.tolist(), cost.tolist(), parent)
    allowed = [
        p for p in itertools.permutations(range(n)) if all(parent[i] < 0 or parent[i] in p[: p.index(i)] for i in p)
    ]
    assert tuple(order) in allowed
    assert waited(order) == pytest.approx(min(map(waited, allowed)))


def test_threads_do_not_change_the_walls():
    network, stakes = landscape(4, (120, 200))
    one, two = (cuts_of(network, stakes, threads=threads, smallest=2000) for threads in (1, 3))
    assert len(one) == len(two)
    assert all((a.cells == b.cells).all() and a.parent == b.parent for a, b in zip(one, two, strict=True))
