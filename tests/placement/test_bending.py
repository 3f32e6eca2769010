"""Lines of patterns on better ground: the cheapest way in the corridor, closed and as wide as before."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest
from scipy import ndimage

from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.bending import bent, is_even, prices, pushed
from firebreak_gis.placement.patterns import stripes
from firebreak_gis.stakes import Stakes

SHAPE = (41, 53)


def setting(seed: int = 1, **planes):
    random = np.random.default_rng(seed)
    network = SpreadNetwork(np.full((8, *SHAPE), 0.5, np.float32), burnable=np.ones(SHAPE, bool))
    planes = {"difficulty": random.integers(2, 9, SHAPE) / 2.0} | planes
    return network, Stakes(network, **planes)


def band(azimuth: float, width: int = 1) -> np.ndarray:
    lines = stripes(SHAPE, azimuth, width=width, spacing=26.0, shift=0.5)
    return max(lines, key=len)


def slow(line, price, reach):
    """Least price of a way over sides from border to border near the ends, by networkx."""
    off = np.ones(SHAPE, bool)
    off.ravel()[line] = False
    away = ndimage.distance_transform_edt(off)
    inside = {(int(r), int(c)) for r, c in zip(*np.nonzero(away <= reach), strict=True)}
    weight = price * (1.0 + 1e-4 * away)
    graph = nx.Graph()
    for r, c in inside:
        for other in ((r + 1, c), (r, c + 1)):
            if other in inside:
                graph.add_edge((r, c), other, weight=0.5 * (weight[r, c] + weight[other]))
    for r, c in inside:  # an upright line goes from the first row to the last
        if r == 0:
            graph.add_edge("top", (r, c), weight=0.0)
        if r == SHAPE[0] - 1:
            graph.add_edge((r, c), "bottom", weight=0.0)
    return nx.shortest_path_length(graph, "top", "bottom", weight="weight"), weight


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_way_is_the_cheapest(seed):
    network, stakes = setting(seed)
    line, price = band(90.0), prices(network, stakes, 1)
    best, weight = slow(line, price, 5.0)
    way = bent(line, network, price, width=1, reach=5.0)
    own = weight.ravel()[way]
    assert float((0.5 * (own[1:] + own[:-1])).sum()) == pytest.approx(best)
    assert price.ravel()[way].sum() < price.ravel()[line].sum()


@pytest.mark.parametrize("azimuth", [0.0, 90.0, 45.0, 22.5])
@pytest.mark.parametrize("width", [1, 2, 3])
def test_bent_bands_stop_spread_over_corners_and_stay_in_the_corridor(azimuth, width):
    network, stakes = setting(4)
    line = band(azimuth, width)
    way = bent(line, network, prices(network, stakes, width), width=width, reach=6.0)
    assert set(way.tolist()) != set(line.tolist())
    wall = np.zeros(SHAPE, bool)
    wall.ravel()[way] = True
    straight = np.ones(SHAPE, bool)
    straight.ravel()[line] = False
    assert ndimage.distance_transform_edt(straight)[wall].max() <= 6.0 + width
    pieces, _ = ndimage.label(~wall, structure=np.ones((3, 3)))
    sizes = np.sort(np.bincount(pieces.ravel())[1:])
    assert sizes[-2:].min() > 0.05 * wall.size  # the map falls into two


def test_even_ground_leaves_the_line_straight():
    network, stakes = setting(difficulty=None)
    assert is_even(stakes)
    line = band(90.0)
    way = bent(line, network, prices(network, stakes, 1), width=1, reach=6.0)
    assert sorted(way.tolist()) == sorted(line.tolist())
    assert not is_even(setting()[1])


def test_ways_go_round_protected_ground():
    protected = np.zeros(SHAPE, bool)
    line = band(90.0)
    col = int(line[0] % SHAPE[1])
    protected[15:25, col - 2 : col + 3] = True
    network, stakes = setting(difficulty=None, protected=protected)
    way = bent(line, network, prices(network, stakes, 1), width=1, reach=6.0)
    assert protected.ravel()[line].sum() == 10
    assert not protected.ravel()[way].any()


def test_a_line_without_room_stays():
    network, stakes = setting()
    price = prices(network, stakes, 1)
    line = band(90.0)
    np.testing.assert_array_equal(bent(line, network, price, width=1, reach=0.5), line)
    np.testing.assert_array_equal(bent(line[:1], network, price, width=1, reach=5.0), line[:1])


def test_patches_move_as_they_are_to_the_best_ground():
    hard = np.full(SHAPE, 4.0)
    hard[18:21] = 1.0
    network, stakes = setting(difficulty=hard)
    patch = (np.arange(14, 17)[:, None] * SHAPE[1] + np.arange(10, 16)).ravel()
    (moved,) = pushed([patch], network, stakes, 0.0, 6)
    np.testing.assert_array_equal(moved, patch + 4 * SHAPE[1])
    (moved,) = pushed([patch], network, stakes, 90.0, 6)
    np.testing.assert_array_equal(moved, patch)  # nothing is better to the east or west
    (moved,) = pushed([patch], network, stakes, 0.0, 1)
    np.testing.assert_array_equal(moved, patch)
    kept = np.zeros(SHAPE, bool)
    kept[18:21, 12] = True
    network, stakes = setting(difficulty=hard, protected=kept)
    (moved,) = pushed([patch], network, stakes, 0.0, 6)
    assert not kept.ravel()[moved].any()
