"""Where a line can be held: landforms, slopes, distances, and what they make of walls."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis import rank, select_breaks, simulate, spread_network
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.landscape.siting import Siting, difficulty, fuel_edges, site, suitability
from firebreak_gis.stakes import Stakes
from tests.twins import centrality as turning

CELL = 20.0


def roof(angle: float, shape=(61, 73)) -> tuple[np.ndarray, np.ndarray]:
    """A ridge through the middle at an angle, falling 0.3 m a metre on both sides; and the distance from it [m]."""
    row, col = np.indices(shape)
    x, y = (col - shape[1] // 2) * CELL, (row - shape[0] // 2) * CELL
    away = np.abs(x * np.cos(angle) + y * np.sin(angle))
    return 500.0 - 0.3 * away, away


@pytest.mark.parametrize("degrees", [0, 30, 45, 75])
def test_ridges_are_found_whatever_their_direction(degrees):
    height, away = roof(np.radians(degrees))
    found, factors = suitability(height, CELL, burnable=np.ones(height.shape, bool))
    assert set(factors) == {"landform", "slope"}
    inner = np.s_[10:-10, 10:-10]
    on, off = away[inner] < CELL / 2, (away[inner] > 150) & (away[inner] < 250)
    assert found[inner][on].min() > found[inner][off].max()


def test_a_valley_is_worth_its_share_of_a_ridge():
    height, _ = roof(0.0)
    fuel = np.ones(height.shape, bool)
    for valley in (0.0, 0.5, 1.0):
        _, ridge = suitability(height, CELL, burnable=fuel, siting=Siting(valley=valley))
        _, bottom = suitability(-height, CELL, burnable=fuel, siting=Siting(valley=valley))
        middle = ridge["landform"].shape[0] // 2, ridge["landform"].shape[1] // 2
        assert bottom["landform"][middle] == pytest.approx(valley * ridge["landform"][middle])


def test_slope_is_that_of_an_even_plane():
    row, col = np.indices((20, 31))
    for degrees, expected in ((10, 1.0), (25, 0.5), (40, 0.0)):
        for turn in (0.0, 0.6, 2.0):
            height = np.tan(np.radians(degrees)) * CELL * (np.cos(turn) * col + np.sin(turn) * row)
            _, factors = suitability(height, CELL, burnable=np.ones(height.shape, bool))
            np.testing.assert_allclose(factors["slope"][2:-2, 2:-2], expected, atol=1e-9)


def test_distances_fall_off_by_their_reach():
    fuel = np.ones((30, 41), bool)
    roads = np.zeros(fuel.shape, bool)
    roads[:, 20] = True
    found, factors = suitability(
        None, CELL, burnable=fuel, roads=roads, siting=Siting(road=1.0, road_reach=60.0, access=0.0)
    )
    assert set(factors) == {"road"}
    np.testing.assert_allclose(found[3], np.exp(-np.abs(np.arange(41) - 20) * CELL / 60.0))


def test_edges_lie_on_both_sides_of_a_change_and_only_on_fuel():
    fuel = np.ones((6, 9), bool)
    fuel[:, :2] = False
    flammability = np.ones((6, 9))
    flammability[:, 6:] = 0.7
    edges = fuel_edges(fuel, flammability)
    assert np.flatnonzero(edges.all(axis=0)).tolist() == [2, 5, 6]
    assert edges.sum() == 18
    assert np.flatnonzero(fuel_edges(fuel).all(axis=0)).tolist() == [2]
    flammability[:, 6:] = 0.8
    assert np.flatnonzero(fuel_edges(fuel, flammability).all(axis=0)).tolist() == [2]


@pytest.mark.parametrize("symmetry", list(turning.SYMMETRIES.values()))
def test_turned_maps_give_turned_suitabilities(make_landscape, symmetry):
    landscape = make_landscape((24, 33), relief=60.0)
    roads = np.random.default_rng(1).random((24, 33)) < 0.03
    height, fuel = landscape["elevation"].to_numpy().astype(float), landscape["burnable"].to_numpy()
    expected, _ = suitability(height, CELL, burnable=fuel, roads=roads)
    turned = [turning.turn(plane, symmetry) for plane in (height, fuel, roads)]
    got, _ = suitability(turned[0], CELL, burnable=turned[1], roads=turned[2])
    np.testing.assert_allclose(got, turning.turn(expected, symmetry), atol=1e-9)


def test_gaps_in_the_terrain_are_bad_ground_not_holes():
    height, _ = roof(0.3)
    height[:8, :8] = np.nan
    found, _ = suitability(height, CELL, burnable=np.ones(height.shape, bool))
    assert np.isfinite(found).all()
    assert ((found >= 0) & (found <= 1)).all()


def test_difficulty_grows_as_suitability_falls():
    suitable = np.linspace(0, 1, 200).reshape(10, 20)
    for strength in (0.0, 0.5, 1.0):
        factor = difficulty(suitable, strength=strength)
        assert (np.diff(factor.ravel()) <= 0).all()
        assert factor.min() == 1.0
        assert factor.max() == pytest.approx(np.exp(2 * strength), abs=0.25)
    with pytest.raises(ParameterError, match="strength"):
        difficulty(suitable, strength=-1)


def test_what_cannot_be_is_refused(make_landscape):
    landscape = make_landscape()
    with pytest.raises(ParameterError, match="road_reach"):
        site(landscape, roads=np.ones((9, 14)), no_such=1)
    with pytest.raises(ParameterError, match="expected numbers"):
        site(landscape, ridge="much")
    with pytest.raises(ParameterError, match="steep"):
        Siting(gentle=40)
    with pytest.raises(ParameterError, match="nothing to go by"):
        site(landscape, ridge=0, slope=0, edge=0)
    network = spread_network(landscape)
    with pytest.raises(InputError, match="difficulty is 0"):
        Stakes(network, difficulty=np.zeros(network.shape))


def test_walls_keep_to_good_ground_and_still_hold(make_landscape):
    """On an even map with a cheap grid of lines, walls are drawn to them; the budget counts cells alone."""
    landscape = make_landscape((60, 73), holes=0.0, relief=0.0, vegetation=3, density=2)
    network = spread_network(landscape)
    good = np.zeros(network.shape, bool)
    good[7::15] = good[:, 7::15] = True
    stakes = Stakes(network, difficulty=np.where(good, 1.0, 3.0))
    on, burnt = {}, {}
    for name, given in (("plain", None), ("sited", stakes)):
        breaks = select_breaks(rank(network, "dissection", stakes=given), budget=0.1).to_numpy() > 0
        on[name] = good[breaks].mean()
        burnt[name] = float(simulate(network, breaks=breaks, n_runs=200, seed=4)["fire_size"].mean())
        assert breaks.sum() == round(0.1 * network.n_burnable)
    assert on["sited"] > 0.9 > 2.5 * on["plain"]
    assert burnt["sited"] < 0.5 * float(simulate(network, n_runs=200, seed=4)["fire_size"].mean())
