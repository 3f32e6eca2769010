"""Where a line can be held: landforms, slopes, distances, and what they make of walls."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage

from firebreak_gis import rank, select_breaks, simulate, spread_network
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.landscape import siting
from firebreak_gis.landscape.siting import (
    Siting,
    beside,
    crests,
    difficulty,
    distance,
    features,
    fuel_edges,
    site,
    siting_of,
    suitability,
)
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
    crest, bottom = crests(height, CELL, (100.0,), 4.5)
    assert away[crest].max() <= CELL
    inner = np.s_[8:-8, 8:-8]
    assert crest[inner][away[inner] < 0.4 * CELL].all()
    assert not bottom.any()


def test_a_crest_counts_by_its_flanks():
    """A dome of radius r: smoothed or not it bends by 1 / r, so one scale from its line the slope is scale / r."""
    x = (np.arange(81) - 40.0) * CELL
    for flank in (2.0, 4.0, 8.0):
        bend = np.tan(np.radians(flank)) / 200.0
        height = np.zeros((60, 1)) - 0.5 * bend * x**2
        assert crests(height, CELL, (200.0,), flank * 0.98)[0][30].tolist() == [i == 40 for i in range(81)]
        assert not crests(height, CELL, (200.0,), flank * 1.02)[0].any()


@pytest.mark.parametrize("shape", [(70, 40), (3, 9), (1, 30), (30, 1)])
@pytest.mark.parametrize("sigma", [1.0, 3.0])
def test_crests_by_bands_are_those_of_the_whole(shape, sigma, monkeypatch):
    height = ndimage.gaussian_filter(np.random.default_rng(3).standard_normal(shape), 2.0) * 200
    margin = int(np.ceil(4.0 * sigma))
    whole = np.pad(height, margin, mode="reflect", reflect_type="odd") if min(shape) > 1 else height
    inner = np.s_[margin:-margin, margin:-margin] if min(shape) > 1 else np.s_[:, :]
    down, right, rows, cols, both = (
        ndimage.gaussian_filter(whole, sigma, order=order, mode="nearest")[inner]
        for order in ((1, 0), (0, 1), (2, 0), (0, 2), (1, 1))
    )
    bends, ways = np.linalg.eigh(np.stack([rows, both, both, cols], axis=-1).reshape(*shape, 2, 2))
    bend, across = bends[..., 0], ways[..., :, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        away = -(down * across[..., 0] + right * across[..., 1]) / bend
        step = np.abs(away) * np.abs(across).max(axis=-1)
    clear = (np.abs(step - 0.5) > 1e-6) & (np.abs(bend) > 1e-9)
    monkeypatch.setattr(siting, "_TOGETHER", 1)
    found, bottom = crests(height, 1.0, (sigma,), 0.0)
    np.testing.assert_array_equal(crests(-height, 1.0, (sigma,), 0.0), [bottom, found])
    assert (found == ((step <= 0.5) & (bend < 0.0)))[clear].all()
    assert clear.mean() > 0.5


def test_crests_go_on_over_saddles_and_not_along_the_border():
    row, col = np.indices((81, 91))
    x, y = (col - 45) * CELL, (row - 40) * CELL
    height = 50.0 * np.cos(x / 300.0) - 0.001 * y**2
    assert crests(height, CELL, (100.0,), 4.5)[0][40, 10:-10].all()
    plane = 0.4 * x + 0.2 * y
    assert not np.any(crests(plane, CELL, (100.0, 200.0), 0.5))


def test_scales_below_a_cell_find_nothing():
    height, _ = roof(0.0)
    assert crests(height, 100.0, (300.0,), 1.0)[0].any()
    assert not crests(height, 100.0, (60.0,), 1.0)[0].any()


def test_a_cell_is_worth_its_best_line():
    fuel = np.ones((30, 41), bool)
    roads, rivers = np.zeros(fuel.shape, bool), np.zeros(fuel.shape, bool)
    roads[:, 10] = rivers[:, 11] = rivers[:, 30] = True
    weights = Siting(road=0.9, river=0.4, access=0.0, reach=45.0)
    found, factors = suitability(None, CELL, burnable=fuel, roads=roads, rivers=rivers, siting=weights)
    assert set(factors) == {"road", "river"}
    by_hand = np.zeros(41)
    by_hand[28:33] = by_hand[9:14] = 0.4  # 45 m reach two cells of 20 m
    by_hand[8:13] = 0.9
    np.testing.assert_allclose(found, np.broadcast_to(by_hand, fuel.shape))


def test_a_valley_is_worth_its_share_of_a_ridge():
    height, away = roof(0.0)
    fuel = np.ones(height.shape, bool)
    for valley in (0.25, 0.5, 1.0):
        siting = Siting(valley=valley, slope=0.0)
        ridge, _ = suitability(height, CELL, burnable=fuel, siting=siting)
        bottom, _ = suitability(-height, CELL, burnable=fuel, siting=siting)
        np.testing.assert_allclose(bottom, valley * ridge)
        assert ridge[away == 0].max() == 1.0
    assert "valley" not in features(-height, CELL, burnable=fuel, siting=Siting(valley=0.0))


def test_slope_is_that_of_an_even_plane():
    row, col = np.indices((20, 31))
    for degrees, expected in ((10, 1.0), (25, 0.5), (40, 0.0)):
        for turn in (0.0, 0.6, 2.0):
            height = np.tan(np.radians(degrees)) * CELL * (np.cos(turn) * col + np.sin(turn) * row)
            found, factors = suitability(height, CELL, burnable=np.ones(height.shape, bool))
            np.testing.assert_allclose(factors["slope"][2:-2, 2:-2], expected, atol=1e-9)
            np.testing.assert_allclose(found, factors["slope"])


def test_access_falls_off_by_its_reach():
    fuel = np.ones((30, 41), bool)
    roads = np.zeros(fuel.shape, bool)
    roads[:, 20] = True
    siting = Siting(access=3.0, access_reach=60.0)
    found, factors = suitability(None, CELL, burnable=fuel, roads=roads, siting=siting)
    access = np.exp(-np.abs(np.arange(41) - 20) * CELL / 60.0)
    np.testing.assert_allclose(factors["access"][3], access)
    np.testing.assert_allclose(found[3], (factors["road"][3] + 3.0 * access) / 4.0)


def test_edges_lie_on_fuel_beside_large_ground_without_fuel():
    fuel = np.ones((9, 12), bool)
    fuel[:, :2] = False
    fuel[4, 7] = False
    edges = fuel_edges(fuel)
    assert np.flatnonzero(edges.all(axis=0)).tolist() == [2]
    single = {(3, 7), (5, 7), (4, 6), (4, 8)}
    assert {(int(r), int(c)) for r, c in zip(*np.nonzero(edges), strict=True)} == {(r, 2) for r in range(9)} | single
    large = fuel_edges(fuel, patch=2)
    assert large.sum() == 9
    assert not fuel_edges(fuel, patch=19).any()


@pytest.mark.parametrize("symmetry", list(turning.SYMMETRIES.values()))
def test_turned_maps_give_turned_suitabilities(make_landscape, symmetry):
    landscape = make_landscape((44, 53), relief=60.0)
    roads = np.random.default_rng(1).random((44, 53)) < 0.03
    height, fuel = landscape["elevation"].to_numpy().astype(float), landscape["burnable"].to_numpy()
    siting = Siting(scales=(40.0,), patch=0.1)
    expected, _ = suitability(height, CELL, burnable=fuel, roads=roads, siting=siting)
    turned = [turning.turn(plane, symmetry) for plane in (height, fuel, roads)]
    got, factors = suitability(turned[0], CELL, burnable=turned[1], roads=turned[2], siting=siting)
    assert {"ridge", "valley", "edge", "road", "slope", "access"} == set(factors)
    np.testing.assert_allclose(got, turning.turn(expected, symmetry), atol=1e-9)


def test_gaps_in_the_terrain_are_bad_ground_not_holes():
    height, away = roof(0.0)
    height[:8, :] = np.nan
    found, factors = suitability(height, CELL, burnable=np.ones(height.shape, bool))
    assert np.isfinite(found).all()
    assert ((found >= 0) & (found <= 1)).all()
    assert not factors["slope"][:8].any()
    crest, _ = crests(height, CELL, (100.0,), 4.5)
    assert not crest[:13].any()  # within 100 m of unknown ground
    assert crest[13:-8][away[13:-8] == 0].all()
    assert not np.any(crests(np.full((20, 20), np.nan), CELL, (100.0,), 4.5))


def test_difficulty_grows_as_suitability_falls():
    suitable = np.linspace(0, 1, 201)
    for strength in (0.0, 0.5, 1.0, 3.0):
        factor = difficulty(suitable, strength=strength)
        assert (np.diff(factor) <= 0).all()
        assert (factor[-1], factor[0]) == (1.0, 1.0 + strength)
        np.testing.assert_allclose(factor, 1.0 + strength * (1.0 - suitable), atol=0.25 + 1e-12)
        np.testing.assert_array_equal(2 * factor, np.rint(2 * factor))
    for strength in (-1, 11, np.nan):
        with pytest.raises(ParameterError, match="strength"):
            difficulty(suitable, strength=strength)


def test_what_cannot_be_is_refused(make_landscape):
    landscape = make_landscape()
    with pytest.raises(ParameterError, match="no_such"):
        site(landscape, roads=np.ones((9, 14)), no_such=1)
    with pytest.raises(ParameterError, match="expected numbers"):
        site(landscape, ridge="much")
    with pytest.raises(ParameterError, match="from 0 to 1"):
        site(landscape, ridge=2)
    with pytest.raises(ParameterError, match="steep"):
        Siting(gentle=40)
    with pytest.raises(ParameterError, match="scales"):
        siting_of({"scales": "0"})
    assert siting_of({"scales": "100+300"}).scales == (100.0, 300.0)
    with pytest.raises(ParameterError, match="nothing to go by"):
        site(landscape, ridge=0, valley=0, slope=0, edge=0)
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


@pytest.mark.parametrize("reach", [0.0, 25.0, 39.0, 40.0, 70.0])
def test_what_lies_beside_is_what_lies_within_reach(reach):
    mask = np.random.default_rng(4).random((23, 17)) < 0.03
    near = distance(mask, 20.0) <= max(reach, 1.5 * 20.0)
    np.testing.assert_array_equal(beside(mask, 20.0, reach), near)
    assert mask.sum() < near.sum() < near.size
