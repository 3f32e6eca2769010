"""Walls by nested minimum cuts: they separate, are minimal and cheapest, keep off what is protected, and nest."""

from __future__ import annotations

import itertools
from typing import Any

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.ndimage import gaussian_filter

from firebreak_gis.breaks import removal_order, select_breaks
from firebreak_gis.kernels.bisection import best_cut
from firebreak_gis.kernels.chains import best_chain, can_chain
from firebreak_gis.kernels.coarse import band, blocks
from firebreak_gis.kernels.flow import UNCUTTABLE, cut_between
from firebreak_gis.kernels.patches import patch_links
from firebreak_gis.kernels.squares import UNNUMBERED, number_blocks
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.dissection import Cut, dissect, sequence
from firebreak_gis.placement.edges import links
from firebreak_gis.placement.patches import COARSE_FROM, Patches, capacities
from firebreak_gis.placement.patterns import ExpectedLoss
from firebreak_gis.placement.regions import Regions
from firebreak_gis.placement.widening import offsets, walls
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes
from tests.twins import centrality
from tests.twins import placement as twin

SEEDS = st.integers(0, 10_000)
#: Patches of more cells are searched coarsely first: those of the tests, or none.
COARSE = st.sampled_from([40, 100, 100_000])
LANDSCAPES = settings(max_examples=10, deadline=None, derandomize=True)


def landscape(seed: int, shape: tuple[int, int] = (19, 24)) -> tuple[SpreadNetwork, Stakes]:
    """Random fuel with holes, costs, values and protected cells; open or periodic; some ways shut, or none."""
    random = np.random.default_rng(seed)
    probability = random.random((8, *shape)).astype(np.float32)
    if seed % 4:
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


def compartments_of(network: SpreadNetwork, cuts: list[Cut]) -> list[np.ndarray]:
    """Cells of the compartment that each wall splits: what its parents leave connected around it."""
    found: list[np.ndarray] = []
    for cut in cuts:
        whole = np.flatnonzero(network.burnable.ravel())
        if cut.parent >= 0:
            whole = np.setdiff1d(found[cut.parent], cuts[cut.parent].cells)
        graph = graph_of(network, whole)
        piece = nx.node_connected_component(graph, divmod(int(cut.cells[0]), network.shape[1]))
        found.append(np.sort([row * network.shape[1] + col for row, col in piece]))
        assert found[-1].size == cut.size
    return found


#: A map in one, or parted into regions first.
REGIONS = st.sampled_from([60, 150, 100_000])


def cuts_of(network: SpreadNetwork, stakes: Stakes, **options: Any) -> list[Cut]:
    return dissect(network, stakes, progress=silent, **options)


@LANDSCAPES
@given(seed=SEEDS, coarse=COARSE, regions=REGIONS)
def test_every_wall_separates_and_needs_all_its_cells(seed, coarse, regions):
    network, stakes = landscape(seed)
    cols = network.shape[1]
    cuts = cuts_of(network, stakes, coarse_from=coarse, regions_from=regions)
    for cut, compartment in zip(cuts, compartments_of(network, cuts), strict=True):
        graph = graph_of(network, compartment)
        assert nx.is_connected(graph)
        sides = pieces(graph, cut.cells, cols)
        assert len(sides) > 1
        for cell in cut.cells:
            near = set(graph[divmod(int(cell), cols)])
            assert sum(bool(near & side) for side in sides) > 1


@LANDSCAPES
@given(seed=SEEDS, coarse=COARSE, regions=REGIONS)
def test_walls_nest_and_keep_off_what_is_protected(seed, coarse, regions):
    network, stakes = landscape(seed)
    sizes = np.zeros(network.burnable.size, int)
    cuts = cuts_of(network, stakes, coarse_from=coarse, regions_from=regions, sizes=sizes)
    compartments = compartments_of(network, cuts)
    smallest = np.zeros_like(sizes)
    for cut, compartment in zip(cuts, compartments, strict=True):
        smallest[compartment] = cut.size
        assert network.burnable.ravel()[cut.cells].all()
        assert not stakes.protected.ravel()[cut.cells].any()
        assert cut.cost == pytest.approx(stakes.cost.ravel()[cut.cells].sum())
        assert np.isin(cut.cells, compartment).all()
    assert (smallest == sizes).all()
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
    heads = np.random.default_rng(seed).permutation(8)[None]  # the order in which ways are tried changes nothing
    _, cost = best_cut(near, capacity[cells], one, one, order[None], heads, np.array([share]), mask)
    end = int(np.floor(share * cells.size + 1e-9)) + 1  # the first to hold more than the share
    source, sink = np.zeros(network.burnable.size, bool), np.zeros(network.burnable.size, bool)
    source[cells[order[:end]]], sink[cells[order[cells.size - end :]]] = True, True
    kept = np.where(capacity >= UNCUTTABLE, np.inf, capacity).reshape(network.shape)
    expected = twin.minimum_cut(network, source.reshape(network.shape), sink.reshape(network.shape), kept)
    ends = np.where(source.ravel()[cells], 1, np.where(sink.ravel()[cells], 2, 0)).astype(np.uint8)
    between = np.zeros(cells.size, np.uint8)
    _, same = cut_between(near, capacity[cells], one, one, ends, between)
    for wall, price in ((mask, cost), (between, same)):
        assert (price if wall.any() else np.inf) == expected
        if wall.any():
            assert capacity[cells[wall == 1]].sum() == expected
            sides = pieces(graph_of(network, cells), cells[wall == 1], network.shape[1])
            assert len(sides) > 1
            of = [
                {k for k, side in enumerate(sides) if side & {divmod(int(cell), network.shape[1]) for cell in part}}
                for part in (cells[wall == 0], cells[wall == 2])
            ]
            assert of[0]
            assert of[1]
            assert not of[0] & of[1]


@settings(max_examples=60, deadline=None, derandomize=True)
@given(seed=SEEDS)
def test_a_chain_is_the_cheapest_across_its_band(seed):
    random = np.random.default_rng(seed)
    most = 40 if seed % 8 == 0 else 9  # in large ones more places wait than there is room for at first
    shape = (int(random.integers(3, most)), int(random.integers(3, most)))
    fuel = random.random(shape) < 0.8
    row, col = (each.astype(np.int32) for each in np.nonzero(fuel))
    if row.size < 3:
        return
    capacity = random.integers(0, 50, row.size).astype(np.int32)
    capacity[random.random(row.size) < 0.1] = UNCUTTABLE
    ignition, value = random.random((2, row.size))
    angle, share = np.pi * random.random(), float(random.choice([0.2, 0.3]))
    toward = np.array([[np.sin(angle), np.cos(angle)]])
    mark = np.zeros(row.size, np.uint8)
    score, _ = best_chain(row, col, capacity, ignition, value, toward, share, mark)
    expected = twin.cheapest_chain(row, col, capacity, ignition, value, toward[0], share)
    assert (score > 0) <= (expected is not None)
    if expected is None:
        assert not mark.any()
    elif mark.any():
        price, worth = expected
        assert worth[mark == 1].sum() == price
        one, other = (set(np.flatnonzero(mark == side).tolist()) for side in (0, 2))
        assert not any(max(abs(row[a] - row[b]), abs(col[a] - col[b])) == 1 for a in one for b in other)
        saved = 1.0 - sum(ignition[list(part)].sum() * value[list(part)].sum() for part in (one, other)) / (
            ignition.sum() * value.sum()
        )
        assert score == pytest.approx(saved / max(capacity[mark == 1].sum(), 1))


@LANDSCAPES
@given(seed=SEEDS)
def test_chains_are_sought_where_all_neighbours_are_linked(seed):
    random = np.random.default_rng(seed)
    fuel = np.pad(random.random((7, 9)) < 0.8, 1)
    cells = np.flatnonzero(fuel)
    shut = np.full(fuel.size, 255, np.uint8)
    place = (*fuel.shape, np.array(ROW_STEP), np.array(COL_STEP))
    near = patch_links(cells, shut, *place)
    row, col = (each.astype(np.int32) for each in np.divmod(cells, fuel.shape[1]))
    assert can_chain(row, col, shut[cells])
    shut[cells[seed % cells.size]] = 255 - (1 << seed // cells.size % 8)
    fewer = patch_links(cells, shut, *place)
    assert can_chain(row, col, shut[cells]) == bool((fewer == near).all())


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
    sides = pieces(graph_of(network, compartments_of(network, [cut])[0]), cut.cells, network.shape[1])
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
    one, two = (cuts_of(network, stakes, threads=threads, smallest=200, coarse_from=1000) for threads in (1, 3))
    assert len(one) == len(two)
    assert len({cut.parent for cut in one}) > 20
    assert all((a.cells == b.cells).all() and a.parent == b.parent for a, b in zip(one, two, strict=True))


@LANDSCAPES
@given(seed=SEEDS, coarse=COARSE, smallest=st.sampled_from([2, 5, 16]), leaky=st.booleans())
def test_walls_are_those_found_piece_by_piece(seed, coarse, smallest, leaky):
    network, stakes = landscape(seed, (25, 31))
    sizes = [np.zeros(network.burnable.size, np.int32) for _ in range(2)]
    about = {"coarse_from": coarse, "smallest": smallest, "leaky": leaky}
    found = cuts_of(network, stakes, sizes=sizes[0], threads=2, **about)
    expected = twin.dissected(network, stakes, sizes=sizes[1], **about)
    assert len(found) == len(expected)
    for cut, other in zip(found, expected, strict=True):
        assert cut.cells.tolist() == other.cells.tolist()
        assert (cut.parent, cut.size) == (other.parent, other.size)
        assert (cut.cost, cut.saved) == pytest.approx((other.cost, other.saved), rel=1e-9, abs=1e-15)
    assert (sizes[0] == sizes[1]).all()


def test_a_torus_is_split_where_it_is_one_and_where_it_no_longer_is():
    network = SpreadNetwork(np.full((8, 24, 40), 0.5, np.float32), boundary="periodic")
    found, expected = (way(network, Stakes(network)) for way in (cuts_of, twin.dissected))
    assert [cut.cells.tolist() for cut in found] == [cut.cells.tolist() for cut in expected]
    rings = [np.ptp(cells // 40) == 23 or np.ptp(cells % 40) == 39 for cells in compartments_of(network, found)]
    assert 5 < sum(rings) < len(rings) - 5


@LANDSCAPES
@given(seed=SEEDS, factor=st.sampled_from([2, 3, 5]))
def test_blocks_are_the_connected_pieces_of_squares_and_linked_both_ways(seed, factor):
    network, _ = landscape(seed)
    rows, cols = network.shape
    cells = np.flatnonzero(network.burnable.ravel())
    graph = graph_of(network, cells)
    label, near = blocks(cells, links(network).ravel(), rows, cols, np.array(ROW_STEP), np.array(COL_STEP), factor)
    places = [divmod(int(cell), cols) for cell in cells]
    expected = nx.Graph(
        (a, b) for a, b in graph.edges if (a[0] // factor, a[1] // factor) == (b[0] // factor, b[1] // factor)
    )
    expected.add_nodes_from(places)
    of = dict(zip(places, label.tolist(), strict=True))
    assert {frozenset(group) for group in nx.connected_components(expected)} == {
        frozenset(place for place in places if of[place] == number) for number in range(near.shape[0])
    }
    linked = {frozenset((of[a], of[b])) for a, b in graph.edges if of[a] != of[b]}
    for v, row in enumerate(near):
        for d, u in enumerate(row.tolist()):
            if u >= 0:
                assert near[u, (d + 4) % 8] == v
                assert frozenset((v, u)) in linked
    alone = [v for v in range(near.shape[0]) if (near[v] < 0).all()]
    assert len(alone) <= 0.3 * near.shape[0]  # a block is left alone only where others crowd it out


@LANDSCAPES
@given(seed=SEEDS, width=st.integers(0, 3))
def test_a_band_is_what_lies_within_steps_of_the_seam(seed, width):
    network, _ = landscape(seed)
    rows, cols = network.shape
    cells = np.flatnonzero(network.burnable.ravel())
    graph = graph_of(network, cells)
    side = np.random.default_rng(seed).choice([1, 2], cells.size).astype(np.uint8)
    side[cells % cols < 8], side[cells % cols > 14] = 1, 2
    side[cells % cols == 11] = 0
    of = {divmod(int(cell), cols): int(mark) for cell, mark in zip(cells, side, strict=True)}
    seam = [a for a in graph if of[a] == 0 or any(0 < of[b] != of[a] for b in graph[a])]
    away = nx.multi_source_dijkstra_path_length(graph, seam)
    expected = [1 if away.get(place, 99) <= width else 2 if away.get(place, 99) == width + 1 else 0 for place in of]
    found = band(cells, side, links(network).ravel(), rows, cols, np.array(ROW_STEP), np.array(COL_STEP), width)
    assert found.tolist() == expected


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_walls_found_coarsely_save_as_much_as_those_of_the_whole(seed):
    network, stakes = noise(seed)
    left = []
    for coarse in (400, 10**9):
        cuts = cuts_of(network, stakes, coarse_from=coarse)
        order = sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])
        spent = np.cumsum([cuts[i].cost for i in order]) / stakes.cost.sum()
        left.append(1.0 - np.interp([0.02, 0.05, 0.1], spent, np.cumsum([cuts[i].saved for i in order])))
    assert (left[0] <= 1.05 * left[1]).all()


@settings(deadline=None, max_examples=40)
@given(
    st.integers(3, 20), st.integers(3, 20), st.integers(1, 5), st.sampled_from(["open", "periodic"]), st.integers(0, 9)
)
def test_walls_are_lines_widened_one_after_another(rows, cols, width, boundary, seed):
    """Cell by cell: the squares around the cells of a line in turn, and what is taken is taken."""
    random = np.random.default_rng(seed)
    fuel, kept = random.random((rows, cols)) < 0.8, random.random((rows, cols)) < 0.1
    network = SpreadNetwork(np.full((8, rows, cols), 0.5, np.float32), burnable=fuel, boundary=boundary)
    stakes = Stakes(network, cost=random.integers(1, 9, (rows, cols)).astype(float), protected=kept)
    lines = [random.permutation(rows * cols)[: random.integers(0, 9)] for _ in range(8)]
    taken = set(np.flatnonzero(~fuel | kept).tolist())
    found, costs = walls(lines, network, stakes, width)
    assert len(found) == len(costs) == len(lines)
    for line, cells, cost in zip(lines, found, costs, strict=True):
        expected = []
        for cell in line.tolist():
            steps = sorted((abs(r) + abs(c), r, c) for r in offsets(width) for c in offsets(width))
            for _, r, c in steps:
                row, col = cell // cols + r, cell % cols + c
                if boundary == "periodic":
                    row, col = row % rows, col % cols
                if 0 <= row < rows and 0 <= col < cols and row * cols + col not in taken:
                    taken.add(row * cols + col)
                    expected.append(row * cols + col)
        assert cells.tolist() == expected
        assert cost == stakes.cost.ravel()[expected].sum()


@LANDSCAPES
@given(seed=SEEDS, factor=st.sampled_from([2, 3, 5]))
def test_blocks_of_a_map_are_those_of_a_patch(seed, factor):
    network, _ = landscape(2 * seed)
    steps = np.array(ROW_STEP), np.array(COL_STEP)
    label = np.where(network.burnable, UNNUMBERED, np.int32(-1))
    count = number_blocks(label, links(network), *steps, factor)
    cells = np.flatnonzero(network.burnable.ravel())
    expected, near = blocks(cells, links(network).ravel(), *network.shape, *steps, factor)
    assert count == near.shape[0]
    assert (label[~network.burnable] == -1).all()
    pairs = np.unique(np.array([label.ravel()[cells], expected]), axis=1)
    assert pairs.shape[1] == np.unique(pairs[0]).size == np.unique(pairs[1]).size == count


def noise(seed: int) -> tuple[SpreadNetwork, Stakes]:
    random = np.random.default_rng(seed)
    rough = sum(width * gaussian_filter(random.standard_normal((150, 150)), width, mode="wrap") for width in (1, 4, 16))
    network = SpreadNetwork(np.full((8, 150, 150), 0.5), burnable=rough < np.quantile(rough, 0.8))
    return network, Stakes(network, cost=1 + random.integers(0, 3, network.shape), value=random.random(network.shape))


def test_chains_across_all_but_huge_patches_are_the_best_of_all_directions():
    """What is best by squares was often not: walls that leak saved up to seven points less of the mean fire."""
    network, stakes = noise(1)
    found, exact = (cuts_of(network, stakes, coarse_from=coarse) for coarse in (COARSE_FROM, 10**9))
    assert max(cut.size for cut in exact) > 2 * COARSE_FROM
    assert [cut.cells.tolist() for cut in found] == [cut.cells.tolist() for cut in exact]


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_walls_by_regions_save_as_much_as_those_of_the_whole(seed):
    network, stakes = noise(seed)
    left = []
    for regions in (2500, 10**9):
        cuts = cuts_of(network, stakes, coarse_from=400, regions_from=regions)
        order = sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])
        spent = np.cumsum([cuts[i].cost for i in order]) / stakes.cost.sum()
        left.append(1.0 - np.interp([0.02, 0.05, 0.1], spent, np.cumsum([cuts[i].saved for i in order])))
    assert (left[0] <= 1.1 * left[1]).all()


@LANDSCAPES
@given(seed=SEEDS)
def test_regions_are_the_connected_pieces_that_the_walls_leave(seed):
    network, stakes = landscape(2 * seed, (30, 35))
    patches = Patches.of(network, stakes, width=1, leaky=False, directions=8, shares=(0.25, 0.4), coarse_from=40)
    regions = Regions(patches, network.burnable, 100)
    waiting = list(regions)
    graph = nx.Graph(graph_of(network, np.flatnonzero(network.burnable.ravel())))
    while waiting:
        region = waiting.pop(0)
        cells = regions.cells(region)
        assert region.size == cells.size
        assert region.loss == pytest.approx(patches.loss(cells))
        found = nx.node_connected_component(graph, divmod(int(cells[0]), network.shape[1]))
        assert sorted(row * network.shape[1] + col for row, col in found) == cells.tolist()
        split = regions.split(region)
        if split is not None:
            wall, pieces_left = split
            graph.remove_nodes_from(divmod(int(cell), network.shape[1]) for cell in wall)
            assert len(pieces_left) > 1
            waiting += pieces_left


def test_threads_do_not_change_the_walls_of_regions():
    network, stakes = landscape(4, (120, 200))
    one, two = (cuts_of(network, stakes, threads=t, smallest=500, coarse_from=400, regions_from=4000) for t in (1, 3))
    assert len(one) == len(two) > 5
    assert all((a.cells == b.cells).all() and a.parent == b.parent for a, b in zip(one, two, strict=True))
