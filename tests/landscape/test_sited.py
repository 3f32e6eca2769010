"""What is asked of the ground: strength, slopes, distances from roads, the area of interest."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis import plan, select_breaks, spread_network
from firebreak_gis.breaks import Budget
from firebreak_gis.errors import FirebreakError, ParameterError
from firebreak_gis.landscape.sited import STRENGTH, SitingRequest
from firebreak_gis.landscape.siting import Siting, crests, difficulty, suitability
from firebreak_gis.planning.design import design
from firebreak_gis.stakes import StakePlanes

SHAPE = (60, 71)
CELL = 20.0


def ridge() -> np.ndarray:
    """A ridge that runs aslant over the map, 0.3 m a metre on both sides."""
    row, col = np.indices(SHAPE)
    return 400.0 - 0.3 * CELL * np.abs((col - 35) * 0.8 + (row - 30) * 0.6)


@pytest.fixture(scope="module")
def land(make_landscape):
    return make_landscape(SHAPE, holes=0.0, elevation=ridge(), vegetation=3, density=2)


@pytest.fixture(scope="module")
def network(land):
    return spread_network(land)


@pytest.fixture(scope="module")
def roads():
    found = np.zeros(SHAPE, bool)
    found[:, 12] = True
    return found


def test_difficulty_is_that_of_the_suitability(network, roads):
    request = SitingRequest(2.0, {"road": "0.8", "access": 0.0})
    sited = request.on(StakePlanes(roads=roads), network, ridge())
    weights = Siting(road=0.8, access=0.0)
    found, _ = suitability(ridge(), CELL, burnable=network.burnable, roads=roads, siting=weights)
    np.testing.assert_array_equal(sited.planes.difficulty, difficulty(found, strength=2.0))
    assert sited.strength == 2.0
    assert sited.told == ("breaks keep to ridges, roads and gentle slopes (siting 2; what each is worth is assumed)",)


def test_default_is_on_where_the_terrain_has_relief(network):
    for height, expected in ((ridge(), STRENGTH), (ridge() * 0.01, 0.0), (None, 0.0)):
        sited = SitingRequest().on(StakePlanes(), network, height)
        assert sited.strength == expected
        assert (sited.planes.difficulty is not None) == bool(sited.told) == (expected > 0)
    off = SitingRequest(0.0).on(StakePlanes(), network, ridge())
    assert off.planes.difficulty is None
    assert off.told == ()
    assert set(off.lines) == {"ridge"}  # what is followed is counted all the same


def test_a_difficulty_that_is_given_stays(network):
    own = np.full(SHAPE, 3.0)
    sited = SitingRequest(1.0).on(StakePlanes(difficulty=own), network, ridge())
    assert sited.planes.difficulty is own


def test_shares_count_cells_within_one_of_a_line(network):
    sited = SitingRequest(0.0).on(StakePlanes(), network, ridge())
    cells = np.zeros(SHAPE, bool)
    cells[30, 30:41] = True
    crest = np.flatnonzero(crests(ridge(), CELL, (200.0,), 4.5)[0][30])
    beside = sited.lines["ridge"][30]
    assert beside[crest.min() - 1]
    assert beside[crest.max() + 1]
    assert sited.shares(cells) == {"ridge": beside[30:41].mean(), "any": beside[30:41].mean()}
    assert sited.shares(np.zeros(SHAPE, bool)) == {"ridge": 0.0, "any": 0.0}


def test_ground_is_excluded_cell_by_cell(network, roads, make_landscape):
    row, col = np.indices(SHAPE)
    steep = np.where(row < 30, np.tan(np.radians(40)) * CELL * row, 1000.0)
    away = np.abs(col - 12) * CELL
    aoi = row > 10
    protected = (row + col) % 7 == 0
    request = SitingRequest(0.0, {}, max_slope=30.0, near_roads=400.0, beyond_roads=60.0)
    sited = request.on(StakePlanes(roads=roads, aoi=aoi, protected=protected), network, steep)
    kept = np.asarray(sited.planes.protected)
    inner = (row < 28) | (row > 32)  # where the slope is even
    expected = protected | ~aoi | (row < 28) | (away > 400) | (away <= 60)
    np.testing.assert_array_equal(kept[inner], expected[inner])
    assert len(sited.told) == len(sited.account) == 4
    outside = np.count_nonzero(away > 400) * CELL**2 / 1e4
    assert f"{outside:,.6g} ha of fuel lie farther than 400 m from roads, where nothing is cut" in sited.account
    assert "nothing is cut on slopes above 30 degrees" in sited.told


def test_unknown_ground_is_not_known_to_be_gentle(network):
    height = ridge()
    height[:5] = np.nan
    kept = np.asarray(SitingRequest(0.0, max_slope=80.0).on(StakePlanes(), network, height).planes.protected)
    assert kept[:5].all()
    assert not kept[6:].any()


@pytest.mark.parametrize(
    ("request_", "words"),
    [
        (SitingRequest(-1.0), "strength"),
        (SitingRequest(siting_params={"hill": 1}), "hill"),
        (SitingRequest(max_slope=95.0), "max-slope"),
        (SitingRequest(near_roads=-1.0), "near-roads"),
        (SitingRequest(beyond_roads=float("inf")), "beyond-roads"),
        (SitingRequest(near_roads=50.0, beyond_roads=50.0), "larger"),
        (SitingRequest(near_roads=50.0), "--roads"),
        (SitingRequest(max_slope=30.0), "--dem"),
    ],
)
def test_what_cannot_be_is_refused(network, request_, words):
    with pytest.raises(ParameterError, match=words):
        request_.on(StakePlanes(), network, None)


def test_a_plan_keeps_to_the_ridge_and_says_so(land):
    made = {strength: plan(land, budget=0.06, siting=strength, n_runs=20) for strength in (0.0, None, 3.0)}
    beside = {strength: made[strength].summary["beside_lines"]["breaks"]["any"] for strength in made}
    assert beside[3.0] > 0.3 > 2 * beside[0.0]
    assert beside[0.0] < beside[None]
    assert made[None].summary["beside_lines"]["strength"] == STRENGTH
    assert any(sentence.startswith("Breaks keep to ridges") for sentence in made[None].judged.assumptions)
    assert not any("Breaks keep to" in sentence for sentence in made[0.0].judged.assumptions)
    for plan_ in made.values():  # the budget knows the area alone
        fuel_ha = plan_.network.n_burnable * plan_.network.grid.cell_area_ha
        assert 0.055 * fuel_ha < plan_.summary["ha_cut"] <= 0.06 * fuel_ha


def test_nothing_is_cut_where_a_plan_excludes_the_ground(land, roads):
    aoi = np.zeros(SHAPE)
    aoi[:, :40] = 1
    made = plan(land, budget=0.03, roads=roads, near_roads=300.0, beyond_roads=40.0, aoi=aoi, n_runs=20)
    cut = made.breaks.to_numpy() > 0
    away = np.abs(np.indices(SHAPE)[1] - 12) * CELL
    assert cut.any()
    assert (away[cut] <= 300).all()
    assert (away[cut] > 40).all()
    assert made.before["burn_frequency"].to_numpy()[:, 45:].any()  # fires know no area of interest
    assert any("outside the area of interest" in sentence for sentence in made.feasibility.account)
    with pytest.raises(FirebreakError, match="no cell with fuel may be cut"):
        plan(land, budget=0.03, aoi=np.zeros(SHAPE), n_runs=2)
    with pytest.raises(FirebreakError, match="lower the budget"):
        plan(land, budget=0.5, roads=roads, near_roads=60.0, n_runs=2)


@pytest.mark.parametrize("method", ["dissection", "stripes", "compartments", "splat", "dfpz"])
def test_every_pattern_goes_by_the_ground(network, method):
    """On a map with a grid of good ground, all patterns cut more of it than where ground is alike."""
    good = np.zeros(SHAPE, bool)
    good[6::12] = good[:, 5::13] = True
    on = {}
    for sited in (False, True):
        planes = StakePlanes(difficulty=np.where(good, 1.0, 4.0)) if sited else StakePlanes()
        _, stakes = planes.on(network)
        priority = design(network, method, stakes=stakes, budget=Budget(0.12), elevation=ridge())
        breaks = select_breaks(priority, budget=0.12, burnable=network.burnable).to_numpy() > 0
        on[sited] = good[breaks].mean()
    assert on[True] > 1.1 * on[False]
