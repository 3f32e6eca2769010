"""What parts of breaks are worth in fires with a clock, and plans whose parts are exchanged by it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.landscape.lines import laid_on, links_crossed
from firebreak_gis.placement.exchanging import exchange, exchanged
from firebreak_gis.planning.design import design
from firebreak_gis.progress import silent
from firebreak_gis.simulation.embers import Embers
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import Hold
from firebreak_gis.simulation.weather import Spell, Step, Weather, WeatherNetworks
from firebreak_gis.stakes import Stakes
from tests.placement.test_trial import WINDY, network_of, trial_of

FAILING = Hold(0.5, length=60.0)


def problem(seed, *, boundary="open", **fires):
    """Network, trial, parts of three scattered cells, and which of them are built."""
    network = network_of(seed, boundary=boundary)
    random = np.random.default_rng(seed)
    stakes = Stakes(network, value=random.integers(1, 9, network.shape), ignition=random.random(network.shape))
    fuel = random.permutation(np.flatnonzero(network.burnable.ravel()))[:90]
    parts = [np.sort(each) for each in np.array_split(fuel, 30)]
    return network, trial_of(network, 3, stakes=stakes, **fires), parts, random.random(30) < 0.5


def losses(network, trial, parts, built, **runs):
    """Twin: burn all fires against the parts that are built."""
    cut = np.zeros(network.burnable.size, bool)
    for each in np.flatnonzero(built):
        cut[parts[each]] = True
    return trial.losses(cut.reshape(network.shape), **runs).mean()


@pytest.mark.parametrize(
    ("seed", "fires"),
    [
        (1, {}),
        (2, {"residual": 0.4}),
        (3, {"hold": FAILING}),
        (4, {"hold": FAILING, "residual": 0.3, "boundary": "periodic"}),
    ],
)
def test_the_worth_of_a_part_is_what_burning_all_with_and_without_it_tells(seed, fires):
    network, trial, parts, built = problem(seed, **fires)
    runs = {"n_runs": 40, "first_run": 7}
    worth, lost = trial.worth(parts, built, **runs)
    assert lost == pytest.approx(losses(network, trial, parts, built, **runs), rel=1e-12)
    expected = []
    for k in range(len(parts)):
        other = built.copy()
        other[k] = ~other[k]
        expected.append(abs(losses(network, trial, parts, other, **runs) - lost))
    assert np.ptp(expected) > 0.0
    np.testing.assert_allclose(worth, expected, rtol=1e-9, atol=1e-9)


def exchanged_by_hand(worth, costs, built, money, most, rests, hard):
    """Twin with sets and lists."""
    ratio, after = worth / (costs * hard), {k for k in range(built.size) if built[k]}
    old, kept, freed = set(after), set(), 0.0
    left = money - sum(costs[k] for k in after)
    for each in sorted(set(range(built.size)) - after, key=lambda k: (-ratio[k], k)):
        if not set(rests[each]) <= after:
            continue
        kept |= set(rests[each])
        while left < costs[each] and freed < most:
            bearing = {k for other in after for k in rests[other]}
            free = [k for k in after & old - kept - bearing if ratio[k] < ratio[each]]
            if not free:
                break
            least = min(free, key=lambda k: (ratio[k], k))
            after.remove(least)
            left, freed = left + costs[least], freed + costs[least]
        if ratio[each] > 0 and costs[each] <= left * (1 + 1e-12):
            after.add(each)
            left -= costs[each]
    return [k in after for k in range(built.size)]


@settings(max_examples=300, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_what_rests_on_a_part_is_built_with_it_alone(seed):
    random = np.random.default_rng(seed)
    n = int(random.integers(1, 12))
    rests = [sorted(random.choice(k, min(k, int(random.integers(0, 3))), replace=False).tolist()) for k in range(n)]
    costs, worth = random.integers(1, 6, n).astype(float), random.integers(-1, 9, n).astype(float)
    built = np.arange(n) < random.integers(0, n + 1)
    money, most = float(costs[built].sum() + random.integers(0, 4)), float(random.integers(0, 12))
    hard = random.integers(1, 4, n).astype(float)
    after = exchanged(worth, costs, built, money=money, most=most, rests=rests, hard=hard)
    assert after.tolist() == exchanged_by_hand(worth, costs, built, money, most, rests, hard)
    assert costs[after].sum() <= money * (1 + 1e-9)
    assert all(after[rests[k]].all() for k in np.flatnonzero(after))
    assert costs[built & ~after].sum() < most + costs.max()


def lines_on(network, n, seed):
    """Bent lines over the map, crossing each other and along the middles of cells, laid."""
    import geopandas as gpd
    import shapely

    random = np.random.default_rng(seed)
    (rows, cols), t = network.shape, network.grid.transform
    ends = np.round(2 * random.uniform(-1.0, [cols + 1.0, rows + 1.0], (n, 3, 2))) / 2
    shapes = [shapely.LineString(each * [t.a, t.e] + [t.c, t.f]) for each in ends]
    return laid_on(gpd.GeoDataFrame({"width_m": np.full(n, 9.0)}, geometry=shapes, crs=network.grid.crs), network.grid)


def losses_across(trial, laid, built, **runs):
    """Twin: burn all fires against the links of the lines that are built, each of the first line across it."""
    stands = (laid.owners >= 0) & np.append(built, False)[laid.owners]
    crossed = (stands << np.arange(8)).sum(axis=2).astype(np.uint8)
    return trial.losses(replace(laid.groundless, crossed=crossed), **runs).mean()


def test_the_owner_of_a_link_is_the_first_line_across_it():
    network = network_of(3)
    laid = lines_on(network, 9, 2)
    expected = np.full((*network.shape, 8), -1)
    for k in reversed(range(9)):
        crossed, *_ = links_crossed(laid.lines.iloc[[k]], network.grid)
        for d in range(8):
            expected[..., d][crossed >> d & 1 > 0] = k
    np.testing.assert_array_equal(laid.owners, expected)
    assert (laid.owners >= 0).any(axis=(0, 1)).all()


@pytest.mark.parametrize(
    ("seed", "fires"),
    [
        (1, {}),
        (2, {"residual": 0.4}),
        (3, {"hold": FAILING}),
        (4, {"hold": FAILING, "embers": Embers(rate=20_000.0, wind_speed=5.0, wind_from_direction=10.0)}),
    ],
)
@pytest.mark.parametrize("beside_cells", [False, True])
def test_the_worth_of_a_line_is_what_burning_all_with_and_without_it_tells(seed, fires, beside_cells):
    network, trial, parts, _ = problem(seed, **fires)
    if beside_cells:
        standing = np.zeros(network.shape, bool)
        standing.ravel()[np.concatenate(parts[:8])] = True
        trial = replace(trial, standing=standing)
    laid, built = lines_on(network, 12, seed), np.random.default_rng(seed).random(12) < 0.5
    runs = {"n_runs": 60, "first_run": 7}
    worth, lost = trial.worth_of_lines(laid, built, **runs)
    assert lost == pytest.approx(losses_across(trial, laid, built, **runs), rel=1e-12)
    expected = []
    for k in range(12):
        other = built.copy()
        other[k] = ~other[k]
        expected.append(abs(losses_across(trial, laid, other, **runs) - lost))
    assert np.count_nonzero(expected) > 4
    # Embers from afar that would light anew what was taken back are left out.
    np.testing.assert_allclose(worth, expected, rtol=0.06 if "embers" in fires else 1e-9, atol=1e-9)
    np.testing.assert_array_equal(replace(trial, threads=1).worth_of_lines(laid, built, **runs)[0], worth)


def test_worth_under_changing_weather_and_beside_standing_breaks():
    """Fires of two weathers, one of them turning, and breaks that stand already in some cells of the parts."""
    network, trial, parts, built = problem(5, hold=FAILING)

    def build(step):
        return network_of(5 if step.wind_speed else 7)

    turning = Spell((Step(0.0, 0.0), Step(3.0, 40.0)), starts=(0, 1000))
    weather = WeatherNetworks(Weather((turning, Spell((Step(3.0, 40.0),), weight=2.0))), build)
    standing = np.zeros(network.shape, bool)
    standing.ravel()[np.concatenate(parts)[::5]] = True
    trial = replace(trial, ground=Ground(network, weather), standing=standing)
    worth, lost = trial.worth(parts, built, n_runs=30)
    assert lost == pytest.approx(losses(network, trial, parts, built, n_runs=30), rel=1e-12)
    one = np.arange(30) == np.argmax(worth)
    changed = losses(network, trial, parts, built ^ one, n_runs=30)
    assert worth.max() == pytest.approx(abs(changed - lost), rel=1e-9)
    np.testing.assert_array_equal(worth, replace(trial, threads=1).worth(parts, built, n_runs=30)[0])


def test_worth_where_barriers_hold_more_often_than_breaks():
    network, trial, parts, built = problem(7, hold=FAILING)
    barriers = np.zeros(network.shape, bool)
    barriers.ravel()[np.concatenate(parts)[::4]] = True
    trial = replace(trial, ground=Ground(network, barriers=barriers))
    worth, lost = trial.worth(parts, built, n_runs=30)
    assert lost == pytest.approx(losses(network, trial, parts, built, n_runs=30), rel=1e-12)
    for k in np.argsort(-worth)[:5]:
        changed = losses(network, trial, parts, built ^ (np.arange(30) == k), n_runs=30)
        assert worth[k] == pytest.approx(abs(changed - lost), rel=1e-9)


def test_embers_leave_worth_near_what_it_is():
    network, trial, parts, built = problem(6, hold=FAILING, embers=WINDY)
    worth, lost = trial.worth(parts, built, n_runs=60)
    others = [built ^ (np.arange(30) == k) for k in range(len(parts))]
    true = [abs(losses(network, trial, parts, other, n_runs=60) - lost) for other in others]
    assert np.corrcoef(worth, true)[0, 1] > 0.8


@pytest.mark.parametrize("seed", range(20))
def test_what_is_exchanged_keeps_to_the_money_and_never_gets_poorer(seed):
    random = np.random.default_rng(seed)
    worth, costs = random.random(40), random.integers(1, 6, 40).astype(float)
    built = random.random(40) < 0.4
    money = float(costs[built].sum()) + random.integers(0, 4)
    for most in (0.0, 5.0, 1e9):
        after = exchanged(worth, costs, built, money=money, most=most)
        assert costs[after].sum() <= money
        gone, come = built & ~after, after & ~built
        assert costs[gone].sum() <= most + costs.max()
        if gone.any() and come.any():
            assert (worth / costs)[gone].min() < (worth / costs)[come].max()
    assert (exchanged(worth, costs, built, money=money, most=0.0) >= built).all()
    alike = exchanged(worth, np.ones(40), built, money=float(built.sum()), most=1e9)
    assert set(np.flatnonzero(alike)) == set(np.argsort(-worth)[: int(built.sum())])


def test_a_poor_plan_of_walls_that_fail_gets_better_on_fires_that_it_did_not_know(monkeypatch):
    monkeypatch.setattr("firebreak_gis.placement.exchanging._WORK", 2e5)
    network = network_of(8, (60, 70), low=0.3, high=0.9)
    trial = trial_of(network, hold=Hold(0.6, length=200.0))
    stakes = Stakes(network)
    made = {}
    for refine in (False, True):
        plan = design(network, "random", stakes=stakes, budget=Budget(0.1), trial=trial, refine=refine)
        made[refine] = select_breaks(plan, budget=Budget(0.1), burnable=network.burnable).to_numpy() > 0
        assert np.isneginf(plan.to_numpy()).sum() == np.count_nonzero(~network.burnable)
    assert made[True].sum() <= made[False].sum()
    fresh = replace(trial, seed=99)
    before, after = (fresh.losses(made[refine], n_runs=400).mean() for refine in (False, True))
    assert after < 0.97 * before


def test_a_plan_that_cannot_be_bettered_is_left(monkeypatch):
    network = network_of(9)
    trial = trial_of(network)
    stakes = Stakes(network)
    given = {"stakes": stakes, "budget": Budget(0.1), "trial": trial}
    monkeypatch.setattr(
        "firebreak_gis.placement.exchanging.exchanged", lambda worth, costs, built, **more: built & False
    )
    price = network.burnable.astype(float)
    plain = design(network, "dissection", **given)
    assert exchange(network, stakes, trial, plain.to_numpy(), price=price, money=20.0, progress=silent) is None
    np.testing.assert_array_equal(plain, design(network, "dissection", refine=True, **given))
