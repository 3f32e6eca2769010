"""How long work will take: exact on work whose time is a power of the cells, told before it, without effect on it."""

from __future__ import annotations

import json

import numpy as np
import pytest
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis.breaks import Budget
from firebreak_gis.cli import firebreak
from firebreak_gis.planning import burning, pipeline, timing
from firebreak_gis.planning.pipeline import make_plan
from firebreak_gis.planning.request import DesignRequest, PlanRequest
from firebreak_gis.planning.setting import settle
from firebreak_gis.planning.timing import (
    Estimate,
    by_pieces,
    delineation_seconds,
    fire_seconds,
    ranking_seconds,
    runs_seconds,
    window_seconds,
)
from firebreak_gis.progress import COMPILING
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import StakePlanes


class Clock:
    """Goes on only when told."""

    def __init__(self):
        self.time = 100.0

    def __call__(self):
        return self.time


@pytest.mark.parametrize("power", [1.0, 1.35, 2.0, 2.5])
@pytest.mark.parametrize("shape", [(320, 640), (1600, 800), (30_000, 30_000)])
def test_the_time_of_the_whole_is_that_of_the_pieces_at_their_power(power, shape):
    clock, seen = Clock(), []

    def work(rows, cols):
        cells = (rows.stop - rows.start) * (cols.stop - cols.start)
        seen.append(cells)
        clock.time += 1e-3 * cells**power

    cells = shape[0] * shape[1]
    assert by_pieces(work, shape, clock) == pytest.approx(1e-3 * cells**power, rel=1e-6)
    assert max(seen) <= min(cells / 16, 150_000) * 1.02
    assert sum(seen) <= 0.12 * cells


def test_powers_beyond_any_method_are_noise():
    """A piece that took long by chance does not make a century of it."""
    clock = Clock()
    took = iter([5.0, 5.0, 500.0])
    found = by_pieces(lambda rows, cols: setattr(clock, "time", clock.time + next(took)), (1000, 1000), clock)
    assert found == pytest.approx(500.0 * 16**2.5, rel=0.02)


def test_short_work_is_looked_at_once_and_small_maps_not_at_all():
    clock, calls = Clock(), []

    def work(rows, cols):
        calls.append(rows)
        clock.time += 1e-6

    assert by_pieces(work, (1000, 1000), clock) == pytest.approx(64e-6, rel=0.05)
    assert len(calls) == 2  # the first call loads
    calls.clear()
    assert by_pieces(work, (100, 100), clock) == 0.0
    assert not calls


def test_the_first_call_and_compiling_do_not_count(monkeypatch):
    clock = Clock()
    compiled = Clock()
    monkeypatch.setattr(COMPILING, "_now", compiled)
    calls = []

    def work(rows, cols):
        calls.append(rows)
        if len(calls) == 1:
            clock.time += 50.0  # loading
        if len(calls) == 2:  # compiling something else
            COMPILING.start()
            clock.time += 7.0
            compiled.time += 7.0
            COMPILING.stop()
        clock.time += 1e-3 * (rows.stop - rows.start) ** 2

    assert by_pieces(work, (800, 800), clock) == pytest.approx(1e-3 * 800**2)


def test_rankings_are_made_on_pieces_with_their_stakes(make_landscape, monkeypatch):
    """Costs, protected cells and terrain are those of the piece, and the budget the same share."""
    network = fb.spread_network(make_landscape((240, 250), seed=3))
    rng = np.random.default_rng(1)
    cost = np.where(network.burnable, rng.uniform(1, 2, network.shape), 0.0)
    stakes = fb.Stakes(network, cost=cost, protected=rng.random(network.shape) < 0.2)
    elevation = rng.random(network.shape)
    clock, seen = Clock(), []

    def design(piece, method, **given):
        seen.append((piece, given))
        clock.time += piece.burnable.size

    monkeypatch.setattr(timing, "design", design)
    half = Budget(float(stakes.cost.sum()) / 2, "cost")
    seconds = ranking_seconds(network, "degree", stakes=stakes, budget=half, elevation=elevation, seed=3, now=clock)
    assert seconds == pytest.approx(network.burnable.size, rel=0.05)
    piece, given = seen[-1]
    top, left = ((n - m) // 2 for n, m in zip(network.shape, piece.shape, strict=True))
    place = (slice(top, top + piece.shape[0]), slice(left, left + piece.shape[1]))
    np.testing.assert_array_equal(piece.burnable, network.burnable[place])
    np.testing.assert_array_equal(given["elevation"], elevation[place])
    np.testing.assert_array_equal(given["stakes"].cost, stakes.cost[place])
    np.testing.assert_array_equal(given["stakes"].protected, stakes.protected[place])
    assert given["budget"] == Budget(half.cell_share(network, stakes))
    assert (given["seed"], given["roads"]) == (3, None)


def test_a_piece_that_cannot_be_ranked_tells_nothing(monkeypatch):
    network = fb.SpreadNetwork(np.full((8, 240, 240), 0.5))

    def design(*_, **__):
        raise fb.FirebreakError("no fuel here")

    monkeypatch.setattr(timing, "design", design)
    assert ranking_seconds(network, "degree", stakes=fb.Stakes(network), budget=Budget(0.1)) == 0.0


@pytest.mark.parametrize(("n_runs", "passes", "burnt"), [(1000, 1, 20), (100, 20, 40), (7, 1, 1), (10_000, 9, 64)])
def test_a_few_fires_tell_of_all(monkeypatch, n_runs, passes, burnt):
    network = fb.SpreadNetwork(np.full((8, 9, 11), 0.5))
    clock, seen = Clock(), []

    def burn(_, fires, **how):
        seen.append(fires.n_runs)
        assert how["value"] is None
        clock.time += 0.25 * fires.n_runs

    monkeypatch.setattr(timing, "burn", burn)
    starts = fb.ignition_places(network)
    found = fire_seconds(Ground(network), FireRequest(starts, n_runs=n_runs), passes=passes, value=None, now=clock)
    assert found == pytest.approx(0.25)
    assert seen == [1, burnt]


def test_simulations_are_told_by_one_run_and_a_few():
    """So much before the first run, so much a run; what comes before the fires counts for all but the first."""
    clock, seen = Clock(), []

    def work(count):
        seen.append(count)
        clock.time += 3.0 + 0.5 * count

    assert runs_seconds(work, 1000, 7.0, now=clock) == pytest.approx(3.0 + 500.0)
    assert seen == [1, 1, 1, 20]
    assert runs_seconds(work, 1000, 7.0, times=4.0, now=clock) == pytest.approx(4 * 503.0 + 3 * 7.0)
    assert seen[-1] == 64


@pytest.mark.parametrize("held_up", [{2}, {3}, {2, 3}])
def test_a_run_that_was_held_up_makes_simulations_no_shorter(held_up):
    """As on a machine with other work: by a run that took longer than the few, all others would take no time."""
    clock, calls = Clock(), []

    def work(count):
        calls.append(count)
        clock.time += 3.0 + 0.5 * count + 60.0 * (len(calls) in held_up)

    found = runs_seconds(work, 1000, 7.0, now=clock)
    assert found >= 503.0
    assert found == pytest.approx(503.0) if len(held_up) == 1 else found < 1000.0


def test_windows_are_told_by_two_of_them(monkeypatch):
    """Each is read once, and then burnt in; threads share them."""
    clock, seen = Clock(), []
    counts = [3, 140, 90, 25, 70, 30]

    def burn(k, count):
        assert count <= counts[k]
        seen.append((k, count))
        clock.time += 2.0 + 0.25 * (count - 1)

    monkeypatch.setattr(timing, "window_work", lambda *_, **__: (counts, burn))
    whole = 2.0 * len(counts) + 0.25 * (sum(counts) - len(counts))
    for threads in (1, 2, 50):
        found = window_seconds(None, None, side=16, threads=threads, now=clock)
        assert found == pytest.approx(whole / min(threads, len(counts)))
    assert set(seen) == {(k, count) for k in (2, 4) for count in (1, 8, 64)}

    def held_up(k, count):
        burn(k, count)
        clock.time += 60.0 * (count == 8)  # the few take longer than the many

    monkeypatch.setattr(timing, "window_work", lambda *_, **__: (counts, held_up))
    assert window_seconds(None, None, side=16, threads=1, now=clock) > whole
    monkeypatch.setattr(timing, "window_work", lambda *_, **__: (counts, burn))
    counts[:] = [5, 3]  # too few to tell what one more costs
    assert window_seconds(None, None, side=16, threads=1, now=clock) > 0.0


def test_compartments_are_told_by_a_piece_with_several(monkeypatch):
    """The work is that of all cells on every level."""
    clock, seen = Clock(), []

    def delineate(piece, good, *, size_ha, strength):
        assert piece.shape == good.shape
        seen.append((piece.burnable.size, strength))
        clock.time += 1e-3 * piece.burnable.size * np.log2(piece.burnable.size / 2_000 + 1)

    monkeypatch.setattr(timing, "delineate", delineate)
    network = fb.SpreadNetwork(np.full((8, 400, 500), 0.5))  # cells of a square metre
    good = np.ones(network.shape)
    found = delineation_seconds(network, good, size_ha=0.2, strength=3.0, now=clock)
    assert found == pytest.approx(1e-3 * 200_000 * np.log2(101), rel=0.03)
    assert [size for size, _ in seen] == [pytest.approx(16_000, rel=0.02)] * 2
    small = fb.SpreadNetwork(np.full((8, 100, 100), 0.5))
    assert delineation_seconds(small, np.ones((100, 100)), size_ha=0.2, now=clock) == 0.0


def test_a_little_of_the_windows_is_what_windows_do():
    """The means to burn a little burns the same fires, and leaves the real burns as they are."""
    from firebreak_gis.simulation.durations import Duration
    from firebreak_gis.simulation.ground_fires import MapInMemory
    from firebreak_gis.simulation.windows import burn_windows, window_work

    network = fb.SpreadNetwork(np.full((8, 90, 80), 0.6), travel_time=np.full((8, 90, 80), 600.0))
    source = MapInMemory(network)
    request = FireRequest(n_runs=40, seed=2, duration=Duration("fixed", (7200.0,)))
    whole = burn_windows(source, request, side=16)
    counts, burn = window_work(source, request, side=16)
    assert sum(counts) == 40
    for k, count in enumerate(counts):
        burn(k, count)
    assert window_seconds(source, request, side=16) >= 0.0
    again = burn_windows(source, request, side=16)
    assert again.equals(whole)


def test_ignitions_that_are_decided_serve_the_few():
    from firebreak_gis.simulation.ignitions import resolve_ignitions

    network = fb.SpreadNetwork(np.full((8, 9, 11), 0.5))
    starts = resolve_ignitions(network, n_runs=30, seed=4)
    few = starts.first(7)
    np.testing.assert_array_equal(few.cells, resolve_ignitions(network, n_runs=7, seed=4).cells)
    assert fire_seconds(Ground(network), FireRequest(starts, n_runs=30, seed=4), passes=50) >= 0.0


def test_words():
    assert (
        Estimate({"ranking": 3600.0, "fires": 3600.0 * 1.5}).told().startswith("This takes about 2.5 h (ranking 60 min")
    )
    assert ", local search not counted, as far" in Estimate({"ranking": 20.0}, without="local search").told()
    assert "fires" not in Estimate({"ranking": 20.0, "fires": 0.2}).told()
    assert "nan" not in Estimate({"ranking": 0.0}).told()


def test_plans_do_not_depend_on_being_foreseen(make_landscape):
    from firebreak_gis.planning.pipeline import make_plan
    from firebreak_gis.stakes import StakePlanes

    landscape = make_landscape((210, 200), seed=3)
    asked = PlanRequest(design=DesignRequest("dissection"), fires=FireRequest(n_runs=12, seed=5))
    told, shares = [], []
    one = make_plan(landscape, asked, StakePlanes())
    two = make_plan(
        landscape, asked, StakePlanes(), foreseen=told.append, progress=lambda share, _: shares.append(share)
    )
    assert one.breaks.equals(two.breaks)
    assert one.after.equals(two.after)
    (estimate,) = told
    assert list(estimate.steps) == ["ranking", "fires", "curve without a clock", "curve"]
    assert all(seconds >= 0.0 for seconds in estimate.steps.values())
    assert estimate.steps["ranking"] > 0.0
    assert shares == sorted(shares)
    assert shares[-1] == pytest.approx(1.0)


def test_commands_tell_what_takes_long(make_landscape, tmp_path, monkeypatch):
    """With a second that counts as a minute; short work is not announced."""
    from firebreak_gis.landscape import write_landscape

    write_landscape(make_landscape((40, 50), seed=3), tmp_path / "land")

    def run(*words):
        outcome = CliRunner().invoke(firebreak, [str(word) for word in words])
        assert outcome.exit_code == 0, outcome.output
        return outcome.output

    net = tmp_path / "net.tif"
    run("network", tmp_path / "land", "-o", net)
    commands = {
        "rank": ["rank", net, "--method", "degree", "-o", tmp_path / "p.tif"],
        "burn": ["burn", net, "--runs", 20, "-o", tmp_path / "f.tif"],
        "evaluate": [
            "evaluate",
            net,
            "--methods",
            "degree,random",
            "--budgets",
            "0.1",
            "--runs",
            5,
            "-o",
            tmp_path / "e",
        ],
        "compare": ["compare", net, "--methods", "degree", "--budgets", "0.1", "--runs", 5, "-o", tmp_path / "c"],
    }
    timed, roads, scar = tmp_path / "timed.tif", tmp_path / "roads.tif", tmp_path / "scar.tif"
    run("network", tmp_path / "land", "-o", timed, "--clock")
    mask, begun = np.zeros((40, 50), np.uint8), np.zeros((40, 50), np.uint8)
    mask[20:, 24] = begun[12, 14] = 1
    burnt = np.zeros_like(mask)
    burnt[9:16, 11:18] = 1
    grid = fb.read_network(net).grid
    for path, plane in ((roads, mask), (scar, burnt), (tmp_path / "start.tif", begun)):
        fb.write_raster(path, grid.dataarray(plane, "breaks"))
    (tmp_path / "fires.csv").write_text("ha,days\n0.5,1\n1,1\n2,1\n3,2\n4,2\n")
    table = f"landscape,scar,start,duration,weather\nland,{scar.name},start.tif,1h,rose:NW=4\n"
    (tmp_path / "scars.csv").write_text(table)
    few = ["--runs", 3, "-o"]
    commands |= {
        "burn --window": ["burn", timed, "--duration", "1h", "--window", 16, *few, tmp_path / "w.tif"],
        "assess": ["assess", timed, roads, "--placements", 1, *few, tmp_path / "a"],
        "delineate": ["delineate", tmp_path / "land", "--size", "30", *few, tmp_path / "d"],
        "validate": [
            "validate",
            timed,
            scar,
            "--start",
            tmp_path / "start.tif",
            "--duration",
            "1h",
            *few,
            tmp_path / "v",
        ],
        "calibrate": [
            *("calibrate", tmp_path / "land", tmp_path / "fires.csv", "--weather", "rose:NW=4", "--least", "0.1"),
            *("--fit", "duration", "--runs", 9, "-o", tmp_path / "fit.toml"),
        ],
        "calibrate on scars": ["calibrate", tmp_path / "scars.csv", *few, tmp_path / "rate.toml"],
    }
    for words in commands.values():
        assert "This takes" not in run(*words)
    monkeypatch.setattr(timing, "by_pieces", lambda *_: 60.0)
    monkeypatch.setattr(timing, "worked", lambda work, now: (work(), 60.0)[1])
    for name, words in commands.items():
        assert "This takes about" in run(*words, "--overwrite"), name
        told = run(*words, "--overwrite", "--json")
        assert json.loads(told.splitlines()[-1])["result"]


def test_a_plan_that_nobody_hears_does_not_look(make_landscape, tmp_path, monkeypatch):
    from firebreak_gis.landscape import write_landscape

    write_landscape(make_landscape((12, 15), seed=3), tmp_path / "land")
    looked = []
    monkeypatch.setattr(pipeline, "seconds_of", lambda *_: (looked.append(1), burning.USUAL)[1])
    layers = [str(tmp_path / "land" / f"{name}.tif") for name in ("elevation", "vegetation", "density")]
    words = ["plan", *layers, "--method", "degree", "--runs", "3", "-o", str(tmp_path / "plan"), "--overwrite"]
    for more, times in ((["--quiet"], 0), ([], 1)):
        outcome = CliRunner().invoke(firebreak, [*words, *more])
        assert outcome.exit_code == 0, outcome.output
        assert len(looked) == times, more


def test_plans_of_lines_are_foreseen_by_lines(sample, monkeypatch):
    """Not by walls of cells, which take a tenth of the time, and whose kernels such a plan need not compile."""
    from firebreak_gis.planning import timing

    asked = []
    monkeypatch.setattr(timing, "dissect_by_lines", lambda piece, *_, **__: asked.append(piece.shape))
    monkeypatch.setattr(timing, "design", None)
    monkeypatch.setattr(timing, "_SMALL", 0)
    fb.plan(sample, n_runs=2)
    assert not asked  # nobody looks
    make_plan(sample, PlanRequest(fires=FireRequest(n_runs=2)), StakePlanes(), foreseen=lambda estimate: None)
    assert asked
    for more, left_out in (
        ({}, "trying designs out, local search and writing"),
        ({"method": "degree"}, "writing"),
        ({"line_width": "cells"}, "trying designs out and writing"),
    ):
        request = PlanRequest(design=DesignRequest(**more), fires=FireRequest(n_runs=2))
        told = settle(sample, request, StakePlanes(), threads=None).uncounted
        assert told == left_out
    asked.clear()
    network = fb.spread_network(sample)
    ranking_seconds(network, "dissection", stakes=fb.Stakes(network), budget=Budget(0.1), lines=True)
    assert asked
