"""Walls that are lines: cuts of links against a solver, drawings against slow twins, lengths in every direction."""

from __future__ import annotations

from itertools import pairwise

import geopandas as gpd
import numpy as np
import pytest
import scipy.sparse as sp
import shapely
from affine import Affine
from scipy import ndimage
from scipy.sparse.csgraph import connected_components, maximum_flow

from firebreak_gis import SpreadNetwork
from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import parse_crs
from firebreak_gis.kernels.crossings import PARTS, cross_links
from firebreak_gis.kernels.drawing import channels, landings, lines_in, price_along, shortest
from firebreak_gis.kernels.linkflow import MOST, UNCUTTABLE, best_link_cut, link_costs
from firebreak_gis.kernels.patches import patch_links, pieces_after
from firebreak_gis.landscape.lines import links_crossed
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.dissection import sequence
from firebreak_gis.placement.edges import links
from firebreak_gis.placement.lines import dissect_by_lines
from firebreak_gis.progress import silent
from firebreak_gis.stakes import Stakes

CRS = parse_crs("EPSG:32635")
PLACE = Affine(20, 0, 586_440, 0, -20, 3_999_900)


def forest_of(fuel):
    return SpreadNetwork(np.ones((8, *fuel.shape)), burnable=fuel, crs=CRS, transform=PLACE)


def patchy(seed, shape=(14, 18), share=0.15):
    return np.random.default_rng(seed).random(shape) > share


def patch_of(fuel):
    """Cells of the largest piece of fuel, and their neighbours."""
    bits = links(forest_of(fuel)).ravel()
    cells = np.flatnonzero(fuel.ravel())
    near = patch_links(cells, bits, *fuel.shape, np.array(ROW_STEP), np.array(COL_STEP))
    piece = pieces_after(near, np.zeros(cells.size, np.uint8))
    cells = cells[piece == np.bincount(piece).argmax()]
    return cells, patch_links(cells, bits, *fuel.shape, np.array(ROW_STEP), np.array(COL_STEP))


def labelled(shape, cells, side):
    label = np.zeros((shape[0] + 2, shape[1] + 2), np.uint8)
    label[cells // shape[1] + 1, cells % shape[1] + 1] = side
    return label


def crossed_by(points, first, shape):
    whole = np.rint(points * PARTS).astype(np.int64)
    pieces = [np.hstack([whole[a : b - 1], whole[a + 1 : b]]) for a, b in pairwise(first)]
    bits = np.zeros(shape, np.uint8)
    pieces = np.concatenate(pieces) if pieces else np.zeros((0, 4), np.int64)
    none = np.zeros(shape, np.float32), np.zeros(shape, np.int64)
    cross_links(pieces, np.zeros(len(pieces), np.float32), bits, *none)
    return bits


@pytest.mark.parametrize("seed", range(12))
def test_cuts_of_links_cost_what_a_solver_finds(seed):
    random = np.random.default_rng(seed)
    cells, near = patch_of(patchy(seed))
    n = cells.size
    price = random.uniform(0.3, 3.0, n)
    price[random.random(n) < 0.05] = -1.0
    cost = link_costs(near, price, 17.0, 12.0)
    order = np.argsort(random.random(n) + cells % 18)
    side = np.zeros(n, np.uint8)
    mass = np.full(n, 1.0 / n)
    _, found = best_link_cut(near, cost, mass, mass, order[np.newaxis], np.array([0.2]), side)
    end = int(np.floor(0.2 * n)) + 1
    one, other = np.nonzero(near >= 0)
    graph = sp.coo_array((cost[one, other], (one, near[one, other])), (n + 2, n + 2)).tolil()
    graph[n, order[:end]] = MOST
    graph[order[n - end :], n + 1] = MOST
    expected = maximum_flow(sp.csr_array(graph, dtype=np.int32), n, n + 1).flow_value
    if expected >= UNCUTTABLE:
        assert found == 0
    else:
        assert found == expected
        apart = side[one] != side[near[one, other]]
        assert cost[one[apart], other[apart]].sum() == 2 * expected
        assert (side[order[:end]] != side[order[-1]]).all()


def test_costs_of_links_are_the_mean_price_and_uncuttable_where_protected():
    cells, near = patch_of(np.ones((3, 3), bool))
    price = np.array([1.0, 3.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0])
    cost = link_costs(near, price, 17.0, 12.0)
    assert cost[0].tolist() == [0, 0, 34, 12, 17, 0, 0, 0]
    assert cost[4].tolist() == [34, 12, 17, UNCUTTABLE, 17, 12, 17, 12]
    np.testing.assert_array_equal(cells, np.arange(9))


def saddles(label):
    """Links that a line may cross although they join cells of one side: two sides meet across a corner."""
    a, b, c, d = label[:-1, :-1], label[:-1, 1:], label[1:, :-1], label[1:, 1:]
    return (a == d) & (b == c) & (a * b == 2)


@pytest.mark.parametrize("seed", range(40))
def test_lines_in_their_channels_cross_just_the_links_between_the_sides(seed):
    random = np.random.default_rng(seed)
    shape = (12, 15)
    fuel = patchy(seed, shape, share=0.2 if seed % 2 else 0.0)
    cells = np.flatnonzero(fuel.ravel())
    noise = np.convolve(random.random(cells.size), np.ones(1 + seed % 6), "same")
    side = (1 + (noise > np.median(noise))).astype(np.uint8)
    label = labelled(shape, cells, side)
    gates, starts, ends = channels(label)
    price = np.where(label > 0, 1.0, -1.0)
    points, first = lines_in(gates, starts, ends, price, np.zeros((0, 2)), np.zeros(len(ends), np.uint8))
    bits = crossed_by(points, first, label.shape)
    free = saddles(label)
    for row in range(1, shape[0] + 1):
        for col in range(1, shape[1] + 1):
            for d in range(8):
                r, c = row + ROW_STEP[d], col + COL_STEP[d]
                if label[row, col] * label[r, c] == 2:
                    assert bits[row, col] >> d & 1, (row, col, d)
                elif label[row, col] * label[r, c] > 0 and bits[row, col] >> d & 1:
                    assert free[min(row, r), min(col, c)], (row, col, d)
    assert len(ends) > 0


@pytest.mark.parametrize("seed", range(8))
def test_lines_in_their_channels_are_the_shortest(seed):
    """Dynamic programming over many places in every gate, which is a little longer."""
    label = np.zeros((14, 16), np.uint8)
    random = np.random.default_rng(seed)
    border = np.clip(7 + np.cumsum(random.integers(-2, 3, 16)), 2, 11)
    label[1:-1, 1:-1] = 1 + (np.arange(1, 13)[:, np.newaxis] > border[1:-1])
    gates, _, ends = channels(label)
    assert len(ends) == 1
    line = shortest(gates, ends[0])
    share = np.linspace(1 / 16, 15 / 16, 113)[:, np.newaxis]
    at, best = ends[0][np.newaxis, :2], np.zeros(1)
    for gate in gates:
        places = gate[:2] + share * (gate[2:] - gate[:2])
        best = (best + np.hypot(*(places[:, np.newaxis] - at).transpose(2, 0, 1))).min(axis=1)
        at = places
    slow = float((best + np.hypot(*(ends[0][2:] - at).T)).min())
    fast = float(np.hypot(*np.diff(line, axis=0).T).sum())
    assert fast <= slow + 1e-9
    assert fast >= slow - 0.02 * len(line)


@pytest.mark.parametrize("seed", range(10))
def test_lines_that_leave_their_channels_cost_no_more_and_stay_near(seed):
    random = np.random.default_rng(seed)
    shape = (30, 40)
    fuel = patchy(seed, shape, share=0.04)
    cells = np.flatnonzero(fuel.ravel())
    border = 15 + np.cumsum(random.integers(-1, 2, 40))
    side = (1 + (cells // 40 > border[cells % 40])).astype(np.uint8)
    label = labelled(shape, cells, side)
    gates, starts, ends = channels(label)
    price = np.where(label > 0, random.uniform(0.5, 2.0, label.shape), -1.0)
    places = landings(label)
    lines = []
    for freedom in (0, 1, 2):
        points, first = lines_in(gates, starts, ends, price, places, np.full(len(ends), freedom, np.uint8))
        lines.append([points[a:b] for a, b in pairwise(first)])
    shorter = 0
    for raw, pulled, slid in zip(*lines, strict=True):
        costs = [sum(price_along(price, *a, *b) for a, b in pairwise(line)) for line in (raw, pulled, slid)]
        assert costs[2] <= costs[1] <= costs[0] + 1e-9
        shorter += costs[2] < costs[0] - 1e-9
        np.testing.assert_array_equal(pulled[[0, -1]], raw[[0, -1]])
        if costs[1] == np.inf:  # what runs along a shore stays there
            np.testing.assert_array_equal(slid, raw)
        for end in (0, -1):
            assert np.hypot(*(slid[end] - pulled[end])) <= 4 * np.hypot(*np.diff(pulled, axis=0).T).sum()
    assert shorter > 0


def test_prices_add_up_along_a_piece_in_any_direction():
    random = np.random.default_rng(1)
    price = random.uniform(0.5, 2.0, (8, 9))
    for _ in range(50):
        (ax, ay), (bx, by) = random.uniform(0, [9, 8], (2, 2))
        t = (np.arange(200_000) + 0.5) / 200_000
        mean = price[(ay + t * (by - ay)).astype(int), (ax + t * (bx - ax)).astype(int)].mean()
        assert price_along(price, ax, ay, bx, by) == pytest.approx(mean * np.hypot(bx - ax, by - ay), rel=1e-4)
    price[4, 4] = -1.0
    assert price_along(price, 3.5, 4.5, 6.5, 4.5) == np.inf
    assert price_along(price, 3.5, 4.5, 4.2, 4.5) < np.inf  # a quarter of a cell at most


def neck(angle, width=41.0, size=170):
    """Two woods joined by a straight neck, turned by an angle [degrees]; the grid is the same."""
    y, x = np.mgrid[:size, :size] + 0.5 - size / 2
    turn = np.radians(angle)
    along, across = x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)
    woods = (np.abs(np.abs(along) - 50) < 20) & (np.abs(across) < 45)
    return (np.abs(across) < width / 2) & (np.abs(along) < 60) | woods


@pytest.mark.parametrize("angle", [0.0, 10.0, 22.5, 30.0, 45.0, 60.0, 80.0])
def test_a_wall_costs_its_length_whatever_the_direction_of_the_lattice(angle):
    network = forest_of(neck(angle))
    cuts = dissect_by_lines(network, Stakes(network), smallest=6000, progress=silent)
    assert cuts[0].length == pytest.approx(41.0, rel=0.05)
    assert cuts[0].cost == pytest.approx(41.0, rel=0.05)


@pytest.mark.parametrize("angle", [0.0, 15.0, 22.5, 30.0, 45.0])
def test_what_the_search_counts_is_the_length_within_four_percent(angle):
    """Links cut by a half plane, a row of which costs 17 along an axis and 12 along a diagonal."""
    size = 120
    y, x = np.mgrid[:size, :size] + 0.3 - size / 2
    turn = np.radians(angle)
    one = x * np.cos(turn) + y * np.sin(turn) > 0
    inside = np.hypot(x, y) < 50
    total = 0
    for d in range(8):
        r, c = ROW_STEP[d], COL_STEP[d]
        both = inside & (one != np.roll(one, (-r, -c), (0, 1)))
        total += int(both.sum()) * (17 if d % 2 == 0 else 12)
    assert total / 2 / 100 / 42.7 == pytest.approx(1.0, abs=0.05)


def walls_on(cuts, grid):
    t = grid.transform
    shapes = [
        shapely.LineString(np.column_stack([t.c + t.a * line[:, 0] / PARTS, t.f + t.e * line[:, 1] / PARTS]))
        for cut in cuts
        for line in cut.lines
    ]
    return gpd.GeoDataFrame(geometry=shapes, crs=grid.crs)


def masses(network, bits):
    """Shares of the fuel in the pieces that some links join."""
    cols = network.shape[1]
    row, col, d = np.nonzero((bits[..., np.newaxis] >> np.arange(8)) & 1)
    to = (row + np.array(ROW_STEP)[d]) * cols + col + np.array(COL_STEP)[d]
    n = network.burnable.size
    _, part = connected_components(sp.coo_array((np.ones(row.size), (row * cols + col, to)), (n, n)), directed=False)
    return np.bincount(part[network.burnable.ravel()]) / network.n_burnable


@pytest.mark.parametrize("seed", range(3))
def test_lines_leave_the_compartments_that_the_tree_tells(seed):
    fuel = patchy(seed, (50, 60), share=0.05)
    random = np.random.default_rng(seed)
    network = forest_of(fuel)
    protected = np.zeros(fuel.shape, bool)
    protected[20:28, 25:40] = True
    stakes = Stakes(network, cost=np.where(fuel, random.uniform(0.5, 2.0, fuel.shape), 0.0), protected=protected)
    cuts = dissect_by_lines(network, stakes, smallest=100, progress=silent)
    assert len(cuts) > 10
    drawn = walls_on(cuts, network.grid)
    crossed, *_ = links_crossed(drawn, network.grid)
    before, after = (masses(network, bits) for bits in (links(network), links(network) & ~crossed))
    assert (before**2).sum() - (after**2).sum() == pytest.approx(sum(cut.saved for cut in cuts), abs=1e-9)
    assert all(cut.parent < place for place, cut in enumerate(cuts))
    # No line goes through protected ground, but for its very ends.
    x, y = 586_440 + 20 * np.array([25, 40]), 3_999_900 - 20 * np.array([28, 20])
    inside = shapely.box(x[0], y[0], x[1], y[1])
    assert shapely.length(shapely.intersection(drawn.geometry.array, inside)).max() <= 0.25 * 20 * 2
    length = np.array([sum(np.hypot(*np.diff(line, axis=0).T).sum() for line in cut.lines) / PARTS for cut in cuts])
    np.testing.assert_allclose(length, [cut.length for cut in cuts])
    assert length.sum() * 20 == pytest.approx(drawn.length.sum())


@pytest.mark.parametrize("angle", [0.0, 30.0, 45.0, 80.0])
def test_the_wall_of_a_large_compartment_is_found_by_its_blocks(angle):
    """As good as the best of all directions, sought in few."""
    network = forest_of(neck(angle))
    about = {"smallest": 6000, "progress": silent}
    every, few = (dissect_by_lines(network, Stakes(network), coarse_from=n, **about) for n in (10**9, 500))
    assert few[0].saved / few[0].price > 0.98 * every[0].saved / every[0].price


@pytest.mark.parametrize("seed", range(4))
def test_walls_found_by_blocks_save_about_as_much(seed):
    random = np.random.default_rng(seed)
    fuel = patchy(seed, (90, 110), share=0.1)
    rough = ndimage.gaussian_filter(random.standard_normal(fuel.shape), 5)
    cost = np.where(fuel, np.exp(rough / rough.std()), 0.0)
    stakes = Stakes(forest_of(fuel), cost=cost)
    saved = []
    for coarse_from in (10**9, 300):
        cuts = dissect_by_lines(
            forest_of(fuel), stakes, smallest=200, coarse_from=coarse_from, threads=1, progress=silent
        )
        order = sequence([cut.saved for cut in cuts], [cut.price for cut in cuts], [cut.parent for cut in cuts])
        paid = np.cumsum([cuts[k].price for k in order])
        total = np.cumsum([cuts[k].saved for k in order])
        saved.append(np.mean([total[paid <= money].max(initial=0.0) for money in np.linspace(0.1, 0.6, 6) * paid[-1]]))
    assert saved[1] > 0.97 * saved[0] > 0.5


def test_walls_do_not_depend_on_threads_and_torus_is_refused():
    fuel = patchy(3, (70, 80), share=0.03)
    network = forest_of(fuel)
    one, two = (dissect_by_lines(network, Stakes(network), smallest=200, threads=n, progress=silent) for n in (1, 2))
    assert [cut.saved for cut in one] == [cut.saved for cut in two]
    assert all(
        np.array_equal(a, b) for x, y in zip(one, two, strict=True) for a, b in zip(x.lines, y.lines, strict=True)
    )
    torus = SpreadNetwork(np.ones((8, 9, 9)), boundary="periodic", crs=CRS, transform=PLACE)
    with pytest.raises(ParameterError, match="periodic"):
        dissect_by_lines(torus, Stakes(torus), progress=silent)


def test_walls_keep_to_cheap_ground():
    fuel = np.ones((40, 60), bool)
    network = forest_of(fuel)
    cost = np.full(fuel.shape, 5.0)
    cost[:, 33:36] = 1.0
    cut = dissect_by_lines(network, Stakes(network, cost=cost), smallest=2000, progress=silent)[0]
    assert cut.cost == pytest.approx(40.0, rel=0.05)
    easy = cut.price / cut.cost
    assert all(line[:, 0].min() >= 33 * PARTS and line[:, 0].max() <= 36 * PARTS for line in cut.lines)
    difficult = np.ones(fuel.shape)
    difficult[:, 33:36] = 9.0
    cut = dissect_by_lines(network, Stakes(network, cost=cost, difficulty=difficult), smallest=2000, progress=silent)[0]
    assert cut.cost > 100.0
    assert cut.price / cut.cost == pytest.approx(easy, rel=0.02)  # all of it on ground that is not difficult


def test_landings_lie_off_the_patch_beside_its_corners():
    label = np.zeros((4, 5), np.uint8)
    label[1:3, 1:4] = 1
    found = landings(label)
    assert len(found) == 4 * 3 + 2 * 6
    assert all(label[int(y), int(x)] == 0 for x, y in found)
