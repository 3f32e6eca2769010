"""Fires with a clock through the public functions: weather, embers, breaks that fail, and what is kept of the runs."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from affine import Affine

from firebreak_gis import SpreadNetwork, burn_curve, select_breaks, simulate, spread_network
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.kernels import draws
from firebreak_gis.lattice import NEVER, OPPOSITE
from firebreak_gis.network import neighbour
from firebreak_gis.simulation.budgets import burn_budgets
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import Embers, what_flies
from firebreak_gis.simulation.holding import Hold, breach, chances, strongest, widths
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.weather import Spell, Step, Weather, WeatherNetworks
from tests.twins.arrival import Fire

UTM = {"crs": "EPSG:32635", "transform": Affine(20, 0, 586_440, 0, -20, 3_999_900)}
EACH = Products(arrivals=True)
WINDY = Embers(rate=60_000.0, wind_speed=8.0, wind_from_direction=300.0, ignition=0.9, ignition_heavy=0.9)


def network_of(seed, shape=(17, 22), high=0.6, **more):
    random = np.random.default_rng(seed)
    return SpreadNetwork(
        random.uniform(0.0, high, (8, *shape)),
        burnable=random.random(shape) > 0.12,
        travel_time=random.integers(40, 900, (8, *shape)),
        heat=random.uniform(5_000, 50_000, shape),
        **(UTM | more),
    )


def certain(shape, seconds, **more):
    """Every edge open; `seconds` (8, rows, cols) or eight numbers."""
    times = np.broadcast_to(np.asarray(seconds).reshape(8, *([1, 1] if np.ndim(seconds) == 1 else shape)), (8, *shape))
    return SpreadNetwork(np.ones((8, *shape)), travel_time=times, heat=np.full(shape, 40_000.0), **(UTM | more))


def at(network, row, col):
    return network.grid.x[col], network.grid.y[row]


def ensemble(seed, *, changing):
    """Networks of one landscape in five weathers, some of which change."""

    def build(step):
        base = network_of(seed)
        times = np.where(
            base.travel_time == NEVER, NEVER, np.maximum(base.travel_time // (1 + step.wind_speed), 10)
        ).astype(np.uint32)
        return SpreadNetwork(base.probability, burnable=base.burnable, travel_time=times, heat=base.heat, **UTM)

    winds = [Step(0.0, 0.0), Step(3.0, 40.0), Step(9.0, 200.0)]
    spells = [Spell((wind,), weight=1.0 + k) for k, wind in enumerate(winds)]
    if changing:
        spells += [Spell((winds[0], winds[2], winds[1]), starts=(0, 700, 1500)), Spell((winds[2], winds[0]), (0, 400))]
    return WeatherNetworks(Weather(tuple(spells)), build)


def test_embers_are_those_of_the_twin():
    network = network_of(1, boundary="periodic")
    cut = np.random.default_rng(5).random(network.shape) < 0.15
    cell = int(np.flatnonzero(network.burnable & ~cut)[100])
    keys = {purpose: draws.run_keys(3, purpose, 40) for purpose in ("edges", "embers")}
    given = {"ignitions": at(network, *divmod(cell, 22)), "n_runs": 40, "seed": 3, "duration": 3000, "products": EACH}
    plane = np.random.default_rng(6).choice([0.0, 0.3, 0.9], network.shape)
    for residual in (0.0, 0.5, plane):
        burns = simulate(network, breaks=cut, residual=residual, embers=WINDY, **given)
        flying = what_flies(WINDY, network, keys["embers"], times=[network.travel_time], winds=[(8.0, 300.0)])
        spots = 0
        for run in range(40):
            fire = Fire(
                network,
                int(keys["edges"][run]),
                [network.travel_time],
                limit=3000,
                stands=frozenset(np.flatnonzero(cut).tolist()),
                residual=residual,
                embers=flying,
                ember_key=int(keys["embers"][run]),
            )
            expected = fire.burn({cell: 0})
            found = burns["arrival"][run].to_numpy().ravel()
            assert {c: int(found[c]) for c in np.flatnonzero(found != NEVER).tolist()} == expected
            fire.embers = None
            spots += len(expected) - len(fire.burn({cell: 0}))
        assert spots > 100


def test_embers_fly_downwind_as_far_as_the_law_says():
    shape = (201, 201)
    silent = SpreadNetwork(
        np.zeros((8, *shape)),
        burnable=np.ones(shape, bool),
        travel_time=np.full((8, *shape), NEVER, np.uint32),
        heat=np.full(shape, 40_000.0),
        **UTM,
    )
    # Probability 0 but a pace: one burning cell throws, nothing spreads by itself.
    open_edges = np.zeros((8, *shape), np.float32)
    open_edges[2] = 1e-9
    network = SpreadNetwork(open_edges, travel_time=np.full((8, *shape), 80), heat=np.full(shape, 40_000.0), **UTM)
    embers = Embers(
        rate=500.0, spread=10.0, wind_speed=10.0, wind_from_direction=270.0, delay=1000.0, ignition_heavy=1.0
    )
    burns = simulate(
        network, embers=embers, ignitions=at(network, 100, 60), n_runs=3000, duration=1500, products=EACH, seed=2
    )
    first = (burns["arrival"].to_numpy() < 1500) & (burns["arrival"].to_numpy() > 0)
    row, col = np.nonzero(first.any(axis=0))
    counts = first.sum(axis=0)[row, col]
    intensity = 40_000.0 * 20.0 / 80.0
    median = 100.0 * 36.0 / 20.0 * (intensity / 10_000.0) ** (1 / 3)
    distance = np.repeat(np.hypot(row - 100, col - 60) * 20.0, counts)
    bearing = np.repeat(np.degrees(np.arctan2(100 - row, col - 60)), counts)
    assert np.median(distance) == pytest.approx(median * math.exp(5 * (math.cos(math.radians(10)) - 1)), rel=0.1)
    assert abs(np.average(bearing)) < 2.0
    assert np.std(bearing) == pytest.approx(10.0, rel=0.25)
    expected = 500.0 * 0.0004
    assert counts.sum() / 3000 == pytest.approx(
        expected * 0.84, rel=0.15
    )  # ln(1.5) / 0.4 = 1.01 sigma: 16 % come after 1500 s
    with pytest.raises(InputError, match="wind"):
        simulate(silent, embers=True, n_runs=1)


@pytest.mark.parametrize("changing", [False, True])
def test_runs_under_a_weather_are_those_of_the_twin(changing):
    networks = ensemble(2, changing=changing)
    network = networks[0].network
    cell = int(np.flatnonzero(network.burnable)[150])
    where = at(network, *divmod(cell, 22))
    burns = simulate(network, weather=networks, ignitions=where, n_runs=60, seed=4, duration=2500, products=EACH)
    keys = draws.run_keys(4, "edges", 60)
    spells = networks.weather.of_runs(seed=4, n_runs=60)
    np.testing.assert_array_equal(burns["weather"], spells)
    assert len(set(spells.tolist())) == len(networks)
    for run in range(60):
        made = networks[spells[run]]
        fire = Fire(made.network, int(keys[run]), list(made.times), [int(s) for s in made.starts], limit=2500)
        found = burns["arrival"][run].to_numpy().ravel()
        assert {c: int(found[c]) for c in np.flatnonzero(found != NEVER).tolist()} == fire.burn({cell: 0})
    # Grouped by weather or not, early or late: the same runs.
    late = simulate(
        network, weather=networks, ignitions=where, n_runs=20, first_run=40, seed=4, duration=2500, products=EACH
    )
    np.testing.assert_array_equal(late["arrival"], burns["arrival"][40:])


@pytest.mark.parametrize(
    "hold", [Hold(1.0), Hold(0.5, length=60.0), Hold(share=None, length=100.0), Hold(None, 100.0, "flames")]
)
@pytest.mark.parametrize("residual", [0.0, 0.3, np.random.default_rng(1).random((17, 22)).round()])
def test_more_cut_never_burns_any_cell_earlier(hold, residual):
    networks = ensemble(8, changing=False)
    network = networks[0].network
    order = np.random.default_rng(2).permutation(network.burnable.size).reshape(network.shape)
    earlier = None
    slower = 0
    for share in (0.0, 0.08, 0.25, 0.5):
        cut = (order < share * order.size) & network.burnable
        found = simulate(
            network,
            weather=networks,
            breaks=cut,
            residual=residual,
            hold=hold,
            embers=Embers(rate=20_000.0),
            duration="lognormal:40min,0.5",
            n_runs=60,
            seed=6,
            products=EACH,
        )["arrival"].to_numpy()
        if earlier is not None:
            assert (found >= earlier).all()
            slower += int((found > earlier).sum())
        earlier = found
    assert slower > 1000


def test_longer_never_burns_less_and_ends_at_what_burns_for_ever():
    network = network_of(9)
    given = {"n_runs": 80, "seed": 1, "embers": WINDY}
    sizes = [simulate(network, duration=t, **given)["fire_size"].to_numpy() for t in (60, 600, 3600, 36_000, math.inf)]
    assert all((more >= less).all() for less, more in pairwise(sizes))
    assert sizes[0].sum() < sizes[1].sum() < sizes[2].sum() < sizes[-1].sum()
    np.testing.assert_array_equal(sizes[-2], sizes[-1])


def test_holding_always_is_a_perfect_break_and_never_is_none():
    network = network_of(10)
    cut = np.zeros(network.shape, bool)
    cut[:, 10:12] = True
    given = {"n_runs": 90, "seed": 1, "duration": "2h"}
    perfect = simulate(network, breaks=cut, **given)
    assert simulate(network, breaks=cut, hold=1.0, **given).identical(perfect)
    assert simulate(network, breaks=cut, hold=0.0, **given).identical(simulate(network, **given))
    assert simulate(network, breaks=cut, residual=1.0, **given).identical(simulate(network, **given))
    # Without a clock as well.
    assert simulate(network, breaks=cut, hold=0.0, n_runs=90)["burn_count"].identical(
        simulate(network, n_runs=90)["burn_count"]
    )
    halves = simulate(certain((40, 40), [60] * 8), breaks=np.eye(40)[::-1] > -1, hold=0.47, n_runs=1)
    assert halves["fire_size"].shape == (1,)


def test_a_wall_of_one_block_holds_as_often_as_asked():
    network = certain((9, 41), [60, 85] * 4)
    wall = np.zeros(network.shape, bool)
    wall[:, 21] = True
    burns = simulate(
        network, breaks=wall, hold=Hold(0.47, length=20 * 9.0), ignitions=at(network, 4, 2), n_runs=2000, seed=3
    )
    beyond = burns["burn_count"].to_numpy()[:, 30] / 2000
    assert (beyond == beyond[0]).all()
    assert beyond[0] == pytest.approx(0.53, abs=0.04)


def test_barriers_that_may_fail_are_drawn_apart_from_breaks():
    network = certain((9, 61), [60, 85] * 4)
    wall, road = np.zeros(network.shape, bool), np.zeros(network.shape, bool)
    wall[:, 20] = road[:, 22] = True
    burns = simulate(
        network,
        breaks=wall,
        barriers=road,
        barriers_hold=0.6,
        hold=Hold(0.5, length=20 * 9.0),
        ignitions=at(network, 4, 2),
        n_runs=4000,
        seed=3,
    )
    share = burns["burn_count"].to_numpy()[0] / 4000
    assert share[21] == pytest.approx(0.5, abs=0.03)
    assert share[40] == pytest.approx(0.2, abs=0.025)  # both failed


def test_widths_are_sides_of_squares():
    cut = np.zeros((12, 15), bool)
    cut[2:5, :] = True
    cut[:, 7] = True
    width = widths(cut, 20.0)
    assert (width[2:5] == 60.0).all()
    assert (width[6:, 7] == 20.0).all()
    assert (width[~cut] == 0.0).all()


def test_flames_decide_by_width_and_intensity():
    network = certain((30, 30), [40] * 8)
    cut = np.zeros(network.shape, bool)
    cut[:, 10:12] = cut[:, 20] = True
    fierce = strongest(network, "a test")
    assert fierce == pytest.approx(40_000 * 20 * math.sqrt(2) / 40)
    wilson = chances(network, cut, Hold(share=None))
    assert wilson[0, 10] == pytest.approx(1 - float(breach(fierce[0, 0], 40.0, trees=True)))
    assert wilson[0, 20] == pytest.approx(1 - float(breach(fierce[0, 0], 20.0, trees=True)))
    length = 0.0775 * float(fierce[0, 0]) ** 0.46
    rule = chances(network, cut, Hold(share=None, rule="flames", flames=1.5))
    assert (rule[:, 10:12] == (1.5 * length <= 40.0)).all()
    assert (rule[:, 20] == (1.5 * length <= 20.0)).all()


def test_calm_flat_fires_are_octagons_of_the_right_speed():
    rate = 0.05  # m/s
    straight, diagonal = 20 / rate, 20 * math.sqrt(2) / rate
    network = certain((81, 81), [straight, diagonal] * 4)
    burns = simulate(network, ignitions=at(network, 40, 40), n_runs=1, duration="3h", products=EACH)
    row, col = np.mgrid[:81, :81]
    near, far = np.sort([abs(row - 40), abs(col - 40)], axis=0)
    expected = round(straight) * (far - near) + round(diagonal) * near
    arrival = burns["arrival"][0].to_numpy()
    assert (arrival == np.where(expected <= 10_800, expected, NEVER)).all()
    radius = rate * 10_800
    octagon = 8 * math.tan(math.pi / 8) * (radius * math.cos(math.pi / 8)) ** 2 * 1.0
    assert burns["fire_size"][0] * 400.0 == pytest.approx(octagon, rel=0.06)


def test_mirrored_and_turned_landscapes_burn_mirrored_and_turned():
    random = np.random.default_rng(3)
    shape = (14, 19)
    times = random.integers(20, 400, (8, *shape))
    fire = simulate(
        certain(shape, times), ignitions=at(certain(shape, times), 3, 5), products=EACH, duration=900, n_runs=1
    )
    mirrored = certain(shape, times[[0, 7, 6, 5, 4, 3, 2, 1]][:, :, ::-1])
    other = simulate(mirrored, ignitions=at(mirrored, 3, 13), products=EACH, duration=900, n_runs=1)
    np.testing.assert_array_equal(fire["arrival"][0].to_numpy(), other["arrival"][0].to_numpy()[:, ::-1])
    turned = certain(shape[::-1], np.rot90(times[[2, 3, 4, 5, 6, 7, 0, 1]], axes=(1, 2)))
    other = simulate(turned, ignitions=at(turned, 19 - 1 - 5, 3), products=EACH, duration=900, n_runs=1)
    np.testing.assert_array_equal(np.rot90(fire["arrival"][0].to_numpy()), other["arrival"][0].to_numpy())


def test_products_are_sums_of_the_arrivals():
    network = network_of(12, (25, 31), high=0.5)
    asked = Products(
        by=(600.0, 1800.0, 5000.0), quantiles=(0.1, 0.5), size_classes=(0.2, 1.0, 4.0), paths=True, arrivals=True
    )
    burns = simulate(network, n_runs=400, seed=5, duration="lognormal:1h,0.8", products=asked)
    arrival = burns["arrival"].to_numpy()
    burnt = arrival != NEVER
    np.testing.assert_array_equal(burnt.sum(axis=0), burns["burn_count"])
    fuel = network.burnable
    for k, limit in enumerate(asked.by):
        np.testing.assert_allclose(
            burns["burnt_by"][k].to_numpy()[fuel], (arrival <= limit).mean(axis=0)[fuel], rtol=1e-6
        )
        np.testing.assert_array_equal(burns["fire_size_by"][:, k], (arrival <= limit).sum(axis=(1, 2)))
    size = burns["fire_size"].to_numpy() * 0.04
    which = np.searchsorted(asked.size_classes, size - 1e-9)
    for k in range(4):
        share = burnt[which == k].sum(axis=0) / 400
        np.testing.assert_allclose(burns["burnt_in_class"][k].to_numpy()[fuel], share[fuel], atol=1e-6)
    for k, share in enumerate(asked.quantiles):
        told = burns["arrival_time"][k].to_numpy()
        often = burns["burn_count"].to_numpy() >= 8
        exact = np.array([np.quantile(arrival[:, r, c][burnt[:, r, c]], share) for r, c in np.argwhere(often)])
        assert (np.isnan(told) == (burns["burn_count"].to_numpy() == 0)).all()
        assert np.median(np.abs(told[often] - exact) / (exact + 300.0)) < 0.1
    assert (burns["duration"].to_numpy() >= np.where(burnt, arrival, 0).max(axis=(1, 2))).all()


def test_paths_count_the_cells_that_hang_on_each():
    random = np.random.default_rng(8)
    shape = (13, 16)
    network = certain(shape, random.integers(20, 60, (8, *shape)))
    burns = simulate(
        network, ignitions=at(network, 6, 7), n_runs=1, duration="1h", products=Products(paths=True, arrivals=True)
    )
    arrival = burns["arrival"][0].to_numpy().astype(np.int64)
    number = np.arange(arrival.size).reshape(shape)
    parent = np.full(shape, arrival.size)
    for d in range(8):
        seconds = neighbour(network.travel_time[OPPOSITE[d]], d).astype(np.int64)
        came = (neighbour(arrival + 1, d) > 0) & (neighbour(arrival, d) + seconds == arrival)
        parent = np.where(came, np.minimum(parent, neighbour(number, d)), parent)
    hanging = np.zeros(arrival.size)
    for cell in np.argsort(-arrival, axis=None, kind="stable"):
        if arrival.ravel()[cell] > 0:
            hanging[parent.ravel()[cell]] += hanging[cell] + 1
    np.testing.assert_array_equal(burns["fire_paths"].to_numpy().ravel(), hanging)
    assert burns["fire_paths"].max() == arrival.size - 1


def test_flames_are_those_of_the_fire_that_comes():
    """A strip that burns fast eastwards: head fire east of the ignition, back fire west of it."""
    shape = (3, 41)
    network = certain(shape, [400, 400, 40, 400, 400, 400, 400, 400])
    limits = (1.0, 2.0, 4.0, 8.0)
    burns = simulate(
        network, ignitions=at(network, 1, 20), n_runs=2, duration="1d", products=Products(flame_lengths=limits)
    )
    head, back = (0.0775 * (40_000.0 * 20.0 / tau) ** 0.46 for tau in (40, 400))
    for k, limit in enumerate(limits):
        assert (burns["flame_exceedance"][k, 1, 21:] == (head > limit)).all()
        assert (burns["flame_exceedance"][k, 1, :20] == (back > limit)).all()


def test_budgets_under_a_clock_are_simulations_of_each():
    network = network_of(14)
    priority = np.where(network.burnable, np.random.default_rng(0).random(network.shape), -np.inf)
    request = FireRequest(n_runs=40, seed=2, duration=as_duration("1h"), hold=Hold(0.5, 100.0))
    budgets = [0.0, 0.1, 0.3]
    curve = burn_budgets(network, priority, request, budgets=budgets)
    for k, budget in enumerate(budgets):
        burns = simulate(
            network,
            breaks=select_breaks(priority, budget=budget).to_numpy(),
            duration="1h",
            hold=Hold(0.5, 100.0),
            n_runs=40,
            seed=2,
        )
        np.testing.assert_array_equal(curve[:, k], burns["fire_size"])
    plain = burn_budgets(network, priority, FireRequest(n_runs=40, seed=2), budgets=budgets)
    assert plain.identical(burn_curve(network, priority, budgets=budgets, n_runs=40, seed=2))


def test_durations_follow_their_law():
    drawn = as_duration("lognormal:8h,0.7").of_runs(seed=1, n_runs=4000)
    assert np.median(drawn) == pytest.approx(28_800, rel=0.05)
    assert np.std(np.log(drawn)) == pytest.approx(0.7, rel=0.05)
    flat = as_duration("uniform:2h,4h").of_runs(seed=1, n_runs=4000)
    assert 7200 <= flat.min() < 7250
    assert 14_350 < flat.max() <= 14_400
    assert as_duration("4h,8h").of_runs(seed=0, n_runs=3, first_run=1).tolist() == [28_800, 14_400, 28_800]
    np.testing.assert_array_equal(as_duration("lognormal:8h,0.7").of_runs(seed=1, n_runs=7, first_run=9), drawn[9:16])


def test_drawn_durations_end_at_the_longest_one():
    free = as_duration("lognormal:8h,0.7").of_runs(seed=1, n_runs=500)
    capped = as_duration("lognormal:8h,0.7,12h")
    np.testing.assert_array_equal(capped.of_runs(seed=1, n_runs=500), np.minimum(free, 12 * 3600))
    assert capped.told() == "8 h in the median (lognormal, sigma 0.7, at most 12 h)"
    with pytest.raises(ParameterError, match="more than 0"):
        as_duration("lognormal:8h,0.7,0h")


@pytest.mark.parametrize("given", ["8 parsecs", "lognormal:8h", "normal:8h,1", "0h", "-3", "", "uniform:9h,2h", []])
def test_durations_that_are_none_are_refused(given):
    with pytest.raises(ParameterError, match=r"duration"):
        as_duration(given)


def test_what_a_network_lacks_is_said():
    bare = SpreadNetwork(np.full((8, 9, 9), 0.4), **UTM)
    for given in ({"duration": "8h"}, {"embers": True}, {"products": Products(flame_lengths=(1.0,))}):
        with pytest.raises(InputError, match="travel times"):
            simulate(bare, n_runs=3, **given)
    cold = SpreadNetwork(np.full((8, 9, 9), 0.4), travel_time=np.full((8, 9, 9), 60), **UTM)
    for given in ({"embers": WINDY}, {"breaks": np.eye(9), "hold": "flame"}):
        with pytest.raises(InputError, match="heat"):
            simulate(cold, n_runs=3, **given)
    with pytest.raises(ParameterError, match="hold"):
        simulate(cold, hold=1.2, n_runs=3)
    with pytest.raises(ParameterError, match="weather"):
        simulate(cold, duration="weather", n_runs=3)


def test_wind_drives_head_flanks_and_back_as_the_formula_says(make_landscape):
    """Flat, dense pines, where every edge opens: distances after four hours against the rates along the axes."""
    landscape = make_landscape((161, 161), seed=1, relief=0.0)
    landscape["vegetation"][:] = 3
    landscape["density"][:] = 3
    landscape["burnable"][:] = True
    landscape["elevation"][:] = 0.0
    reach = {}
    for speed in (0.0, 2.0, 4.0):
        network = spread_network(landscape, wind_speed=speed, wind_from_direction=270.0, clock=True)
        assert (network.probability[:, 1:-1, 1:-1] == 1.0).all()
        size = network.grid.cell_size
        burns = simulate(network, ignitions=at(network, 80, 40), n_runs=1, duration="4h", products=EACH)
        burnt = burns["arrival"][0].to_numpy() != NEVER
        reach[speed] = [size * (burnt[80, 41:].sum()), size * burnt[80, :40].sum(), size * burnt[:80, 40].sum()]
    head, back, flank = (np.array([reach[v][k] for v in (2.0, 4.0)]) for k in range(3))
    calm = reach[0.0][0]
    assert reach[0.0] == [calm] * 3
    assert calm == pytest.approx(200.0 * 4, abs=size)  # conifers without wind go 200 m/h
    along = np.exp(0.1783 * np.array([2.0, 4.0]))
    np.testing.assert_allclose(head, calm * along, atol=2 * size)
    np.testing.assert_allclose(back, calm / along, atol=2 * size)
    assert (flank >= calm - size).all()  # cos 90 = 0 straight across, and faster obliquely
    assert reach[4.0][0] > reach[2.0][0] > calm
