"""Fires that designs are tried out on, and the layouts of walls that are chosen by them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from affine import Affine

from firebreak_gis.breaks import select_breaks
from firebreak_gis.kernels import draws
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.choosing import Choice
from firebreak_gis.placement.dissection import dissect
from firebreak_gis.placement.parts import parts_of
from firebreak_gis.placement.reinforcing import Layout, best_layout, closing, most_passed, reinforced
from firebreak_gis.placement.trial import Trial
from firebreak_gis.placement.widening import walls
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation import ground_fires, windows
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import Embers, what_flies
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import Hold, stretches
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.weather import Spell, Step, Weather, WeatherNetworks
from firebreak_gis.stakes import Stakes
from tests.twins import centrality
from tests.twins import placement as twins
from tests.twins.arrival import Fire

UTM = {"crs": "EPSG:32635", "transform": Affine(20, 0, 586_440, 0, -20, 3_999_900)}
WINDY = Embers(rate=60_000.0, wind_speed=8.0, wind_from_direction=300.0, ignition=0.9, ignition_heavy=0.9)


def network_of(seed, shape=(14, 19), low=0.1, high=0.7, **more):
    random = np.random.default_rng(seed)
    return SpreadNetwork(
        random.uniform(low, high, (8, *shape)),
        burnable=random.random(shape) > 0.08,
        travel_time=random.integers(60, 300, (8, *shape)),
        heat=random.uniform(5_000, 50_000, shape),
        **(UTM | more),
    )


def trial_of(network, seed=0, *, stakes=None, **fires):
    given = {"duration": as_duration("1h"), **fires}
    return Trial(Ground(network), FireRequest(**given), stakes or Stakes(network), seed)


@pytest.mark.parametrize("residual", [0.0, 0.4])
def test_a_large_map_is_tried_by_windows(residual, monkeypatch):
    network = network_of(1, (90, 110))
    random = np.random.default_rng(2)
    stakes = Stakes(network, value=random.random(network.shape), ignition=random.random(network.shape))
    trial = trial_of(network, 3, stakes=stakes, residual=residual, hold=Hold(0.5))
    cut = random.random(network.shape) < 0.1
    about = {"n_runs": 30, "first_run": 60}

    def tried():
        return trial.runs(1e5), trial.losses(cut, **about), trial.passing(cut, **about)

    whole = tried()
    monkeypatch.setattr(windows, "SIDE", 16)
    monkeypatch.setattr(ground_fires, "WINDOWS_FROM", 100)
    parts = tried()
    assert parts[0] == whole[0]
    np.testing.assert_array_equal(parts[1], whole[1])
    np.testing.assert_allclose(parts[2], whole[2], rtol=1e-12)
    assert parts[2].sum() > parts[1].mean() > 0


@pytest.mark.parametrize("residual", [0.0, 0.4])
@pytest.mark.parametrize("embers", [None, WINDY])
def test_what_passes_a_cell_is_what_was_lit_by_way_of_it(residual, embers):
    """Twin: arrivals by a plain heap, parents found anew from them, values handed up the tree."""
    network = network_of(1, boundary="periodic")
    random = np.random.default_rng(2)
    stakes = Stakes(network, value=random.integers(0, 9, network.shape), ignition=random.random(network.shape))
    trial = trial_of(network, 3, stakes=stakes, residual=residual, embers=embers)
    cut = network.burnable & (random.random(network.shape) < 0.15)
    n_runs = 20
    passed = trial.passing(cut, n_runs=n_runs, first_run=5)
    given = trial._given(cut, n_runs, 5)
    seed, start = given["request"].seed, given["start"]
    keys = {purpose: draws.run_keys(seed, purpose, n_runs, 5) for purpose in ("edges", "embers")}
    flying = embers and what_flies(embers, network, keys["embers"], times=[network.travel_time], winds=[(8.0, 300.0)])
    value, expected = stakes.value.ravel(), np.zeros(network.burnable.size)
    for run in range(n_runs):
        fire = Fire(
            network,
            int(keys["edges"][run]),
            [network.travel_time],
            limit=3600,
            stands=frozenset(np.flatnonzero(cut).tolist()),
            residual=residual,
            embers=flying,
            ember_key=int(keys["embers"][run]),
        )
        arrival = fire.burn({int(start.cells[run]): 0})
        parent: dict[int, int] = {}
        for cell in sorted(arrival, reverse=True):  # of those that light it at once, the lowest
            for when, target in [*fire._edges(cell, arrival[cell]), *fire._embers(cell, arrival[cell])]:
                if target in arrival and when == arrival[target] and arrival[target] > 0:
                    parent[target] = cell
        worth = {cell: float(value[cell]) for cell in arrival}
        for cell in sorted(arrival, key=lambda c: -arrival[c]):
            if cell in parent:
                worth[parent[cell]] += worth[cell]
        for cell, each in worth.items():
            expected[cell] += each
    assert expected.max() > 50
    np.testing.assert_allclose(passed.ravel(), expected / n_runs, rtol=1e-12)


def test_losses_are_those_of_the_fires_with_other_draws():
    network = network_of(4)
    random = np.random.default_rng(1)
    stakes = Stakes(network, value=random.random(network.shape))
    trial = trial_of(network, 7, stakes=stakes, hold=Hold(0.5, 60.0), residual=0.2)
    cut = network.burnable & (random.random(network.shape) < 0.2)
    lost = trial.losses(cut, n_runs=30, first_run=4)
    start = trial._given(cut, 30, 4)["start"]
    own = replace(trial.fires, n_runs=30, seed=draws.seed_for(7, "design"), ignitions=start)
    burns = burn(network, own, breaks=cut, value=stakes.value, first_run=4)
    np.testing.assert_array_equal(lost, burns["value_lost"])
    other = burn(network, replace(own, seed=7), breaks=cut, value=stakes.value, first_run=4)
    assert (burns["value_lost"] != other["value_lost"]).mean() > 0.5
    assert trial.under(0.0).losses(cut, n_runs=30, first_run=4).sum() < lost.sum()


def test_fires_start_by_the_weights_and_each_round_has_others():
    network = network_of(5)
    ignition = np.zeros(network.shape)
    ignition[:, :6] = network.burnable[:, :6]
    trial = trial_of(network, stakes=Stakes(network, ignition=ignition))
    first, second = (trial._start(40, k).cells for k in (0, 40))
    for cells in (first, second):
        assert ignition.ravel()[cells].all()
        counts = np.bincount(cells // network.shape[1], minlength=network.shape[0])
        assert np.abs(counts - 40 * ignition.sum(axis=1) / ignition.sum()).max() < 2
    assert (first != second).any()


@pytest.mark.parametrize("threads", [1, 3])
def test_threads_and_weathers_change_nothing_but_the_order_of_work(threads):
    def build(step):
        return network_of(6 if step.wind_speed else 7)

    weather = WeatherNetworks(Weather((Spell((Step(0.0, 0.0),)), Spell((Step(3.0, 40.0),), weight=2.0))), build)
    base = network_of(6)
    base = base.derived(burnable=base.burnable & network_of(7).burnable)
    trial = Trial(
        Ground(network_of(6), weather), FireRequest(duration=as_duration("1h")), Stakes(base), 0, threads=threads
    )
    passed = trial.passing(None, n_runs=50)
    np.testing.assert_array_equal(passed, replace(trial, threads=2).passing(None, n_runs=50))
    assert passed.sum() > 0


def walls_of(network, width=1):
    cuts = dissect(network, Stakes(network), width=width, progress=silent)
    return [cut.cells for cut in cuts]


@pytest.mark.parametrize("width", [1, 2])
def test_parts_are_the_walls_cut_where_others_meet_them(width):
    from scipy import ndimage

    network = network_of(8, (40, 50))
    stakes = Stakes(network)
    lines = walls_of(network)[:12]
    block = stretches(network.shape, 20.0, 200.0)
    cells, costs = parts_of(lines, network, stakes, width=width, stretch=block)
    every = np.concatenate(cells)
    assert np.unique(every).size == every.size
    assert set(every.tolist()) == set(np.concatenate(walls(lines, network, stakes, width)[0]).tolist())
    np.testing.assert_allclose(costs, [each.size for each in cells])
    if width == 1:
        drawn = np.zeros(network.shape, bool)
        drawn.ravel()[np.concatenate(lines)] = True
        label = np.pad(ndimage.label(network.burnable & ~drawn, np.ones((3, 3)))[0], 1)

        def sides(cell):
            row, col = divmod(int(cell), network.shape[1])
            beside = set(label[row : row + 3, col : col + 3].ravel().tolist()) - {0}
            return (min(beside), max(beside)) if len(beside) > 1 else None

        for part in cells:
            assert np.unique(block.ravel()[part]).size == 1
            assert len({sides(cell) for cell in part} - {None}) <= 1
    whole, _ = parts_of(lines, network, stakes, width=width)
    assert len(lines) <= len(whole) < len(cells)


def test_a_layout_buys_what_the_money_pays():
    network = network_of(9)
    cost = np.random.default_rng(0).integers(1, 5, network.shape).astype(float)
    layout = Layout("", walls(walls_of(network)[:5], network, Stakes(network), 1)[0])
    stakes = Stakes(network, cost=cost)
    before = np.zeros(network.shape, bool)
    for money in (0.0, 10.0, 30.0, 1e9):
        cut = layout.cut(stakes, money)
        assert cost[cut].sum() <= money
        assert (cut >= before).all()
        before = cut
    assert before.sum() == sum(each.size for each in layout.cells)


def test_walls_are_widened_where_fire_passes():
    """All fires start in the west and last too short for the east, so that no wall there is widened."""
    network = network_of(10, (60, 120), low=0.5, high=0.9)
    ignition = np.zeros(network.shape)
    ignition[:, :20] = network.burnable[:, :20]
    stakes = Stakes(network, ignition=ignition)
    trial = trial_of(network, stakes=stakes, residual=0.2)
    lines = walls_of(network)
    made = reinforced(network, stakes, trial, lines, length=0.4, money=700.0, n_runs=40, progress=silent)
    cut = made.cut(stakes, 700.0)
    assert 690 <= cut.sum() <= 700
    thin = Layout("", parts_of(lines, network, stakes)[0]).cut(stakes, 0.4 * 700.0)
    more = cut & ~thin
    burnt = trial.passing(None, n_runs=40) > 0
    assert more[:, :60].sum() > 5 * more[:, 60:].sum()
    assert burnt[:, 100:].sum() == 0
    assert trial.losses(cut, n_runs=100, first_run=500).sum() < trial.losses(thin, n_runs=100, first_run=500).sum()
    assert all(np.unique(each).size == each.size for each in [np.concatenate(made.cells)])


def test_parts_by_which_most_passes_come_first():
    network = network_of(11, (60, 90), low=0.5, high=0.9)
    ignition = np.zeros(network.shape)
    ignition[:, :15] = network.burnable[:, :15]
    stakes = Stakes(network, ignition=ignition)
    trial = trial_of(network, stakes=stakes, hold=Hold(0.5, 200.0))
    lines = walls_of(network)
    made = most_passed(network, stakes, trial, lines, width=1, money=300.0, n_runs=60, progress=silent)
    even = Layout("", walls(lines, network, stakes, 1)[0])
    lost = [trial.losses(each.cut(stakes, 300.0), n_runs=200, first_run=900).sum() for each in (made, even)]
    assert lost[0] < 0.97 * lost[1]
    assert set(np.concatenate(made.cells).tolist()) == set(np.concatenate(even.cells).tolist())


def test_long_walls_are_held_less_often():
    network = SpreadNetwork(np.full((8, 40, 40), 0.5), **UTM)
    chance = closing(network, Hold(0.5, 200.0))
    row = np.arange(40)
    assert chance([row[:10], row[:11], row[:0], row]).tolist() == [1.0, 0.5, 1.0, 0.125]
    assert chance([]).size == 0
    bare = SpreadNetwork(np.full((8, 40, 40), 0.5), burnable=np.arange(1600).reshape(40, 40) % 40 < 10, **UTM)
    assert closing(bare, Hold(0.5, 200.0))([row]).tolist() == [1.0]


@pytest.mark.parametrize("seed", range(4))
def test_parts_are_those_found_wall_by_wall(seed):
    network = network_of(20 + seed, (45, 60), low=0.3, high=0.9)
    lines = walls_of(network)
    lines += [lines[0], np.zeros(0, np.int64), np.random.default_rng(seed).permutation(2000)[:200]]
    stakes, block = Stakes(network), stretches(network.shape, 20.0, 150.0)
    for width in (1, 3):
        cells, costs = parts_of(lines, network, stakes, width=width, stretch=block)
        expected = twins.parts_of(lines, network, stakes, width=width, stretch=block)
        assert [each.tolist() for each in cells] == [each.tolist() for each in expected]
        assert costs.tolist() == [each.size for each in cells]
    assert parts_of([], network, stakes)[0] == []


def chosen(network, money, seed=0, **fires):
    stakes = Stakes(network)
    trial = trial_of(network, seed, **fires)
    lines = walls_of(network)
    even = {width: Layout("", walls(lines, network, stakes, width)[0]).cut(stakes, money) for width in (1, 2, 3)}
    made = best_layout(network, stakes, trial, lambda width, chance: lines, money=money, progress=silent)
    fresh = {"n_runs": 400, "first_run": 100_000}
    best = trial.losses(made.cut(stakes, money), **fresh).mean()
    return made, best, {width: trial.losses(cut, **fresh).mean() for width, cut in even.items()}


@pytest.mark.parametrize(
    ("fires", "budget"),
    [({}, 0.1), ({"residual": 0.1}, 0.2), ({"hold": Hold(0.47, 100.0)}, 0.1), ({"residual": 0.3}, 0.3)],
)
def test_what_is_chosen_is_as_good_as_any_even_width(fires, budget):
    network = network_of(12, (50, 60), low=0.5, high=0.9)
    made, best, even = chosen(network, budget * network.n_burnable, **fires)
    assert best <= 1.03 * min(even.values())
    if not fires:
        assert made.told == "walls of 1 cell"
    elif "residual" in fires:
        assert best < even[1]


def test_perfect_breaks_get_the_walls_that_are_laid_without_a_clock():
    network = network_of(13, (50, 60), low=0.5, high=0.9)
    priority = rank(network, "dissection", trial=trial_of(network), cost_share=0.1)
    timeless = rank(network, "dissection")
    assert priority.attrs["design"] == timeless.attrs["design"] == "walls of 1 cell"
    cuts = [select_breaks(each, budget=0.1, burnable=network.burnable).to_numpy() for each in (priority, timeless)]
    np.testing.assert_array_equal(*cuts)


@pytest.mark.parametrize("symmetry", [(True, 0), (False, 1)])
def test_turned_maps_get_plans_that_are_as_good(symmetry):
    lost = []
    for seed in range(3):
        network = network_of(20 + seed, (40, 50), low=0.5, high=0.9)
        each = []
        for turned in (network, turned_of(network, symmetry)):
            priority = rank(turned, "dissection", trial=trial_of(turned, residual=0.2), residual=0.2, cost_share=0.2)
            cut = select_breaks(priority, budget=0.2, burnable=turned.burnable).to_numpy() > 0
            each.append(trial_of(turned, residual=0.2).losses(cut, n_runs=400, first_run=5000).mean())
        lost.append(each)
    first, second = np.mean(lost, axis=0)
    assert first == pytest.approx(second, rel=0.08)


@pytest.mark.parametrize("mirror", [False, True])
@pytest.mark.parametrize("quarters", range(4))
def test_walls_of_two_cells_take_a_cheap_strip_however_the_map_lies(mirror, quarters):
    """Walls are sought on the map in its standard orientation, and must not be widened to the other side."""
    cost = np.ones((26, 40))
    cost[:, 18:20] = 0.01
    cost = np.rot90(cost[:, ::-1] if mirror else cost, quarters)
    network = SpreadNetwork(np.full((8, *cost.shape), 0.6), travel_time=np.full((8, *cost.shape), 100), **UTM)
    stakes = Stakes(network, cost=cost)
    share = float(cost[cost < 1].sum() / cost.sum())
    trial = trial_of(network, stakes=stakes)
    priority = rank(network, "dissection", stakes=stakes, trial=trial, least_width=2, cost_share=share)
    assert priority.attrs["design"] == "walls of 2 cells"
    np.testing.assert_array_equal(priority.to_numpy() > np.sort(priority, axis=None)[-53], cost < 1)


def turned_of(network, symmetry):
    """The map turned, with its times."""
    turned = centrality.turn_network(network, symmetry)
    times = np.where(network.probability > 0, network.travel_time, 0) / 1024  # exact in float32
    times = centrality.turn_network(SpreadNetwork(times), symmetry).probability * 1024
    return SpreadNetwork(
        turned.probability, burnable=turned.burnable, travel_time=np.maximum(times, 1).astype(np.uint32), **UTM
    )


def test_influence_cuts_first_what_most_passes_and_looks_again():
    network = network_of(14, (20, 26), low=0.3, high=0.7)
    cost = np.random.default_rng(1).integers(1, 4, network.shape).astype(float)
    stakes = Stakes(network, cost=cost)
    trial = trial_of(network, stakes=stakes, residual=0.1)
    share = 0.05
    found = rank(network, "influence", stakes=stakes, trial=trial, cover=10.0, recompute_every=share, until=0.1)
    n_runs = trial.runs(10.0 * network.n_burnable)
    cut = np.zeros(network.shape, bool)
    order = np.argsort(-found.to_numpy().ravel(), kind="stable")
    spent = 0
    for _ in range(2):
        score = np.where(network.burnable & ~cut, trial.passing(cut, n_runs=n_runs) / np.maximum(stakes.cost, 1), -1.0)
        ranked = np.argsort(-score.ravel(), kind="stable")
        count = int(np.searchsorted(np.cumsum(stakes.cost.ravel()[ranked]), share * stakes.cost.sum(), side="right"))
        np.testing.assert_array_equal(order[spent : spent + count], ranked[:count])
        cut.ravel()[ranked[:count]] = True
        spent += count
    fresh = {"n_runs": 400, "first_run": 9000}
    at_random = select_breaks(rank(network, "random", stakes=stakes), budget=float(cut.sum() / network.n_burnable))
    assert trial.losses(cut, **fresh).mean() < trial.losses(at_random.to_numpy() > 0, **fresh).mean()


class _Told:
    """Fires whose losses are told: by design and first run."""

    def __init__(self, losses):
        self.losses_of, self.asked = losses, []

    def runs(self, work, *, cut=None):
        return {None: 10, "b": 30}[cut] if work >= 2e6 else 0

    def losses(self, cut, *, n_runs, first_run=0):
        self.asked.append((cut, n_runs, first_run))
        return np.array([self.losses_of[cut][first_run > 0]])


@pytest.mark.all_fires
def test_designs_are_tried_in_turn_and_the_best_two_meet_other_fires():
    trial = _Told({"a": (9.0, 0), "b": (5.0, 7.0), "c": (6.0, 1.0), "d": (8.0, 0), "e": (1.0, 0)})
    choice = Choice(trial, 100, lambda design: design)
    assert choice.rising("abcde") == "b"  # c and d are worse in a row
    assert [cut for cut, _, _ in trial.asked] == list("abcd")
    assert choice.chosen() == "c"  # looked worse than b on the first fires, loses less on all
    assert trial.asked[4:] == [("b", 10, 10), ("c", 10, 10)]
    assert Choice(trial, 100, lambda design: design, "b").n_runs == 30


def test_as_many_fires_as_burn_so_much_beside_breaks():
    network = network_of(15, (50, 60), low=0.6, high=0.9)
    trial = trial_of(network, residual=0.1)
    cut = np.zeros(network.shape, bool)
    cut[::8] = cut[1::8] = True
    runs = {}
    for name, some in (("none", None), ("bands", cut)):
        runs[name] = trial.runs(2e5, cut=some)
        # With a value of 1 everywhere what is lost are the cells that burn.
        assert trial.losses(some, n_runs=runs[name]).sum() == pytest.approx(2e5, rel=0.3)
    assert runs["bands"] > 1.5 * runs["none"]
    assert trial.runs(1e9, cut=cut, most=700) == 700


def test_where_breaks_leak_designs_meet_the_fires_that_walls_of_two_cells_allow(monkeypatch):
    network = network_of(12, (50, 60), low=0.5, high=0.9)
    asked = []

    def runs(self, work, *, cut=None, **limits):
        asked.append(None if cut is None else int(np.count_nonzero(cut)))
        return 50

    monkeypatch.setattr(Trial, "runs", runs)
    for fires, money in (({"residual": 0.1}, 300.0), ({"hold": Hold(0.47, 100.0)}, 300.0)):
        chosen(network, money, **fires)
    assert 280 <= asked[0] <= 300
    assert asked[1:] == [None]
