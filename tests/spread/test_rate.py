"""Travel times and heat of the spread model: against a plain loop, by hand, turned round, and the timeless network."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import AZIMUTH, DIRECTIONS, LONGEST, NEVER, OPPOSITE, STEP_LENGTH
from firebreak_gis.network import neighbour
from firebreak_gis.spread import alexandridis, spread_network
from tests.twins import centrality as turning
from tests.twins import spread as twin

FLAT = {"holes": 0.0, "elevation": 0.0}


def assert_times(network, expected):
    got = twin.times_as_dict(network)
    assert got.keys() == {key for key in expected if key in got}
    assert got
    for key, seconds in got.items():
        assert seconds == pytest.approx(max(expected[key], 1.0), abs=0.5 + 1e-6), key
    assert {type(v) for v in got.values()} == {int}


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize(
    ("speed", "wind_from", "percent"), [(0, 0, 0), (8, 315, 0), (3.5, 17.0, 12.0), (30, 360, 4), (0, 123, 29)]
)
def test_times_are_the_loop(make_landscape, boundary, speed, wind_from, percent):
    landscape = make_landscape((8, 13), seed=5, boundary=boundary)
    network = spread_network(
        landscape, clock=True, wind_speed=speed, wind_from_direction=wind_from, moisture=percent / 100
    )
    assert_times(network, twin.seconds(landscape, speed, wind_from, percent))


def test_times_of_rasters_are_the_loop(make_landscape):
    random = np.random.default_rng(3)
    shape = (8, 13)
    rate = np.where(random.random(shape) < 0.5, np.nan, random.uniform(1, 900, shape)).astype(np.float32)
    landscape = make_landscape(shape, seed=6, rate=rate)
    speed, wind_from = random.uniform(0, 15, shape), random.uniform(0, 360, shape)
    percent = random.uniform(0, 25, shape)
    network = spread_network(
        landscape, clock=True, wind_speed=speed, wind_from_direction=wind_from, moisture=percent / 100
    )
    assert_times(network, twin.seconds(landscape, speed, wind_from, percent))


def test_changed_constants_are_the_loop(make_landscape):
    landscape = make_landscape(seed=7)
    network = spread_network(
        landscape,
        clock=True,
        wind_speed=6,
        wind_from_direction=200,
        moisture=0.1,
        rate_agricultural=50,
        rate_shrubs=300,
        rate_pines=90,
        rate_wind=0.3,
        rate_slope=1.5,
        rate_slope_power=0.8,
        rate_moisture=0.03,
        factor_least=0.5,
        factor_greatest=3,
        rate_least=70,
        rate_greatest=400,
        rate_scale=1.7,
    )
    changed = {"rate": (50, 300, 90), "wind": 0.3, "slope": 1.5, "power": 0.8, "moisture": 0.03, "scale": 1.7}
    changed |= {"factors": (0.5, 3.0), "rates": (70 / 60, 400 / 60)}
    assert_times(network, twin.seconds(landscape, 6, 200, 10.0, **changed))


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("rate_scale", 2.0),
        ("rate_agricultural", 60.0),
        ("rate_shrubs", 60.0),
        ("rate_pines", 60.0),
        ("rate_wind", 0.1),
        ("rate_slope", 2.0),
        ("rate_slope_power", 1.0),
        ("rate_moisture", 0.03),
        ("factor_least", 0.6),
        ("factor_greatest", 1.2),
        ("rate_least", 130.0),
        ("rate_greatest", 90.0),
    ],
)
def test_every_constant_of_the_rate_counts(make_landscape, name, value):
    landscape = make_landscape(seed=2)
    given = {"clock": True, "wind_speed": 4, "wind_from_direction": 30, "moisture": 0.1}
    one, other = spread_network(landscape, **given), spread_network(landscape, **given, **{name: value})
    assert (one.travel_time != other.travel_time).any()
    np.testing.assert_array_equal(one.probability, other.probability)
    np.testing.assert_array_equal(one.heat, other.heat)


@pytest.mark.parametrize(("vegetation", "rate"), [(1, 120), (2, 140), (3, 200)])
def test_flat_calm_ground_takes_distance_over_rate(make_landscape, vegetation, rate):
    landscape = make_landscape((4, 5), **FLAT, vegetation=vegetation, density=2, cell=20.0)
    times = spread_network(landscape, clock=True).travel_time[:, 1, 2]
    for d in range(8):
        assert times[d] == round(20.0 * STEP_LENGTH[d] / rate * 3600), DIRECTIONS[d]


def test_head_flank_and_back_of_the_wind(make_landscape):
    """Conifers at 8 m/s: exp(+-1.4264) ahead and behind, 1 across."""
    landscape = make_landscape((3, 5), **FLAT, vegetation=3, density=2, cell=100.0)
    times = spread_network(landscape, clock=True, wind_speed=8, wind_from_direction=270).travel_time[:, 1, 2]
    ahead = math.exp(0.1783 * 8)
    for name, factor in (("E", ahead), ("N", 1.0), ("S", 1.0), ("W", 1 / ahead)):
        assert times[DIRECTIONS.index(name)] == pytest.approx(100 / 200 * 3600 / factor, abs=0.5), name
    assert ahead == pytest.approx(4.163, abs=1e-3)


def test_twenty_degrees_uphill_and_down(make_landscape):
    rise = 100.0 * math.tan(math.radians(20.0))
    landscape = make_landscape(
        (3, 5), holes=0, cell=100.0, elevation=np.broadcast_to(rise * np.arange(5), (3, 5)), vegetation=2, density=2
    )
    times = spread_network(landscape, clock=True).travel_time[:, 1, 2]
    way = 100.0 / math.cos(math.radians(20.0))
    steep = math.exp(3.533 * math.tan(math.radians(20.0)) ** 1.2)
    assert times[DIRECTIONS.index("E")] == pytest.approx(way / 140 * 3600 / steep, abs=0.51)
    assert times[DIRECTIONS.index("W")] == pytest.approx(way / 140 * 3600 * steep, abs=0.51)
    assert times[DIRECTIONS.index("N")] == round(100 / 140 * 3600)


def test_uphill_is_faster_than_downhill_everywhere(make_landscape):
    landscape = make_landscape(seed=3, vegetation=2, density=2, holes=0.0, relief=3.0)
    network = spread_network(landscape, clock=True)
    z = landscape["elevation"].to_numpy()
    seen = 0
    for d in range(8):
        edge = network.travel_time[d] != NEVER
        back = neighbour(network.travel_time[OPPOSITE[d]], d)
        rise = neighbour(z, d) - z
        uphill = edge & (rise > 0.1)
        assert (network.travel_time[d][uphill] < back[uphill]).all()
        seen += uphill.sum()
    assert seen > 100


@pytest.mark.parametrize("name", turning.SYMMETRIES)
def test_turned_landscape_and_wind_turn_the_times(make_landscape, name):
    symmetry = turning.SYMMETRIES[name]
    landscape = make_landscape((6, 11), seed=8)
    layers = {key: turning.turn(landscape[key].to_numpy(), symmetry) for key in landscape.data_vars}
    turned = make_landscape(layers["burnable"].shape, **layers)
    for d in (0, 3):
        given = {"clock": True, "wind_speed": 6, "moisture": 0.07}
        got = spread_network(turned, wind_from_direction=AZIMUTH[turning.turn_direction(d, symmetry)], **given)
        as_it_lies = spread_network(landscape, wind_from_direction=AZIMUTH[d], **given)
        expected = turning.turn_network(as_it_lies, symmetry)
        assert np.abs(got.travel_time.astype(np.int64) - expected.travel_time).max() <= 1  # cos is not exact
        np.testing.assert_allclose(got.heat, expected.heat, rtol=1e-6)


@pytest.mark.parametrize("percent", [0.0, 8.0])
def test_heat_is_that_of_loads_and_moisture(make_landscape, percent):
    landscape = make_landscape(seed=4)
    network = spread_network(landscape, clock=True, moisture=percent / 100)
    vegetation = landscape["vegetation"].to_numpy()
    for code in (1, 2, 3):
        assert network.heat[vegetation == code] == pytest.approx(twin.heat(code, percent), rel=1e-6)
    assert not network.heat[vegetation == 0].any()


def test_loads_of_the_landscape_take_the_place_of_those_of_the_class(make_landscape):
    """Broadleaves: 1.5 and 3 kg/m2 of 20,000 kJ/kg, 60 % live moisture, in half of the cells."""
    half = np.where(np.arange(90).reshape(9, 10) % 2 == 0, 1.0, np.nan)
    broadleaves = {"dead_load": 1.5, "live_load": 3, "heat_content": 20_000, "live_moisture": 0.6}
    landscape = make_landscape(
        (9, 10), vegetation=2, density=2, holes=0, **{name: half * value for name, value in broadleaves.items()}
    )
    heat = spread_network(landscape, clock=True).heat
    expected = 1.5 * 20_000 + 3 * (20_000 * 0.4 - 2442 * 0.6)
    assert heat[np.isfinite(half)] == pytest.approx(expected, rel=1e-6)
    assert heat[np.isnan(half)] == pytest.approx(twin.heat(2, 0.0), rel=1e-6)


@pytest.mark.parametrize(
    "name",
    [f"{stem}_{kind}" for stem in ("dead", "live", "heat", "moisture") for kind in ("agricultural", "shrubs", "pines")],
)
def test_every_constant_of_the_heat_counts(make_landscape, name):
    live = {"live_agricultural": 1.0}
    landscape = make_landscape(seed=2)
    value = {"dead": 2.0, "live": 2.0, "heat": 18_000.0, "moisture": 0.3}[name.split("_")[0]]
    one = spread_network(landscape, clock=True, **live)
    other = spread_network(landscape, clock=True, **(live | {name: value}))
    code = 1 + ("agricultural", "shrubs", "pines").index(name.split("_")[1])
    changed = one.heat != other.heat
    np.testing.assert_array_equal(changed, landscape["vegetation"].to_numpy() == code)
    np.testing.assert_array_equal(one.travel_time, other.travel_time)


def test_under_a_clock_wind_and_slope_leave_the_probability(make_landscape):
    landscape = make_landscape(seed=9)
    weather = {"wind_speed": 7, "wind_from_direction": 40, "moisture": 0.06}
    kept = {
        "none": {"c1": 0, "c2": 0, "a": 0},
        "slope": {"c1": 0, "c2": 0},
        "wind": {"a": 0},
        "both": {},
    }
    seen = []
    for word, gone in kept.items():
        clocked = spread_network(landscape, clock=True, probability_keeps=word, **weather)
        timeless = spread_network(landscape, **weather, **gone)
        np.testing.assert_array_equal(clocked.probability, timeless.probability)
        seen.append((word, clocked.provenance.get("left_out", ""), clocked.probability.tobytes()))
    assert [left for _, left, _ in seen] == ["wind and slope", "wind", "slope", ""]
    assert len({p for *_, p in seen}) == 4
    assert spread_network(landscape, clock=True, **weather).probability.tobytes() == seen[0][2]
    ahead_only = spread_network(landscape, clock=True, probability_keeps="both", c2=0, **weather)
    np.testing.assert_array_equal(ahead_only.probability, spread_network(landscape, c2=0, **weather).probability)
    calm = spread_network(landscape, clock=True)
    assert calm.provenance["left_out"] == "slope"


def test_without_a_clock_there_is_no_time(make_landscape):
    landscape = make_landscape()
    network = spread_network(landscape, wind_speed=5)
    assert not network.timed
    assert network.heat is None
    assert network.provenance == {}
    names = [f.name for f in dataclasses.fields(alexandridis.Params) if f.name.startswith(("rate", "factor", "dead"))]
    for name in names:  # and what only a clock needs changes nothing
        other = spread_network(landscape, wind_speed=5, **{name: 1.0})
        np.testing.assert_array_equal(other.probability, network.probability)
    with pytest.raises(ParameterError, match="probability_keeps"):
        spread_network(landscape, clock=True, probability_keeps="c1")


def test_threads_change_no_time(make_landscape, monkeypatch):
    landscape = make_landscape((23, 17), seed=1)
    given = {"clock": True, "wind_speed": 5, "wind_from_direction": 20, "moisture": 0.05}
    networks = []
    for threads in ("1", "3"):
        monkeypatch.setenv("FIREBREAK_THREADS", threads)
        networks.append(spread_network(landscape, **given))
    np.testing.assert_array_equal(networks[0].travel_time, networks[1].travel_time)


def test_the_wind_of_a_raster_is_that_of_a_number(make_landscape):
    landscape = make_landscape(seed=1)
    grid = Grid.of(landscape["burnable"])
    plane = np.full(grid.shape, 6.0)
    one = spread_network(landscape, clock=True, wind_speed=6, wind_from_direction=75)
    other = spread_network(landscape, clock=True, wind_speed=plane, wind_from_direction=plane * 0 + 75)
    np.testing.assert_array_equal(one.travel_time, other.travel_time)


@pytest.mark.parametrize(("cell", "rate", "expected"), [(0.5, 6000.0, 1), (5_000.0, 0.0, LONGEST)])
def test_the_shortest_and_the_longest_time(make_landscape, cell, rate, expected):
    landscape = make_landscape((3, 5), **FLAT, vegetation=2, density=2, cell=cell)
    params = alexandridis.Params(clock=True, rate_shrubs=rate, rate_least=1e-3)
    _, times, _, _ = alexandridis.probability(landscape, params)
    assert (times[:, 1, 2] == expected).all()


def test_fuel_too_wet_to_burn_releases_nothing(make_landscape):
    landscape = make_landscape((3, 5), **FLAT, vegetation=2, density=2)
    heat = spread_network(landscape, clock=True, heat_shrubs=1000.0, moisture_shrubs=0.9).heat
    assert heat == pytest.approx(1000.0)  # of the dead fuel alone
