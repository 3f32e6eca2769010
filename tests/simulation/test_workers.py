"""Fires burnt by parts, in other processes, with workers that come and go, and after a stop: always the same fires."""

import subprocess
import sys
import threading
import time

import dask.array
import geopandas as gpd
import numpy as np
import psutil
import pytest
import xarray as xr
from shapely.geometry import LineString, Point

import firebreak_gis as fb
from firebreak_gis import SpreadNetwork, rank, select_breaks, simulate
from firebreak_gis.errors import Cancelled, InputError, MissingComponentError, ParameterError, ResourceError
from firebreak_gis.files.parts import Parts
from firebreak_gis.placement.trial import Trial
from firebreak_gis.simulation import engine
from firebreak_gis.simulation import workers as clusters
from firebreak_gis.simulation.budgets import burn_curve
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.ground_fires import MapInMemory
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.windows import burn_windows

SHAPE = (40, 51)


def network_of(seed=3, shape=SHAPE):
    from affine import Affine

    random = np.random.default_rng(seed)
    return SpreadNetwork(
        random.uniform(0.1, 0.7, (8, *shape)),
        burnable=random.random(shape) > 0.1,
        crs="EPSG:32635",
        transform=Affine(20.0, 0.0, 500_000.0, 0.0, -20.0, 4_000_000.0),
        travel_time=random.integers(30, 300, (8, *shape)).astype(float),
        heat=random.uniform(5_000, 40_000, shape),
    )


NETWORK = network_of()
CUT = np.random.default_rng(0).random(SHAPE) < 0.15
VALUE = np.random.default_rng(1).random(SHAPE)
LINES = gpd.GeoDataFrame(geometry=[LineString([(500_100, 3_999_900), (500_900, 3_999_300)])], crs="EPSG:32635")


def weather():
    landscape = fb.read_landscape(**fb.sample_layers(), resolution=250.0)
    networks = fb.weather_networks(landscape, "rose:NW=5x0.4,N=36km/hx0.2;duration=2h")
    return {"network": networks[0].network, "weather": networks, "duration": "weather", "hold": 0.5}


#: What is burnt: every way through the simulation, and everything that workers are sent.
FIRES = {
    "timeless": {"breaks": CUT, "residual": 0.1, "value": VALUE, "n_runs": 150},
    "many at once": {"n_runs": 200},
    "range of runs": {"n_runs": 150, "first_run": 70, "duration": "20min"},
    "clock": {"breaks": CUT, "hold": "0.5:100", "duration": "lognormal:20min,0.5", "value": VALUE, "residual": VALUE},
    "embers": {"duration": "30min", "embers": fb.Embers(rate=500, longest=300, wind_speed=8, wind_from_direction=290)},
    "attacked": {"duration": "1h", "containment": "attack:lognormal:10min,0.5;size=1;intensity=20000"},
    "barriers": {
        "duration": "30min",
        "barriers": CUT,
        "barriers_hold": 0.5,
        "hold": "flame",
        "breaks": np.roll(CUT, 7),
    },
    "crews": {
        "duration": "1h",
        "breaks": CUT,
        "stations": gpd.GeoDataFrame(geometry=[Point(500_100, 3_999_900)], crs="EPSG:32635"),
        "crew_travel": "off=1",
    },
    "lines": {"duration": "30min", "breaks": fb.line_breaks(LINES, NETWORK.grid, width=12.0), "hold": 0.7},
    "timeless lines": {"breaks": fb.line_breaks(LINES, NETWORK.grid, width=12.0)},
    "products": {
        "duration": "30min",
        "products": Products((600.0, 900.0), (0.1, 0.5), (1.0, 4.0), (1.2, 2.5), paths=True),
    },
    "arrivals": {"duration": "30min", "n_runs": 12, "products": Products(arrivals=True)},
    "points": {"ignitions": [(500_110.0, 3_999_500.0), (500_700.0, 3_999_700.0)], "duration": "15min"},
}


def burnt(name):
    given = {"n_runs": 60, "seed": 5, "network": NETWORK, **(weather() if name == "weather" else FIRES[name])}
    return simulate(given.pop("network"), **given)


@pytest.fixture(scope="module")
def workers():
    with fb.cluster(2) as made, engine.using(None):
        yield made


@pytest.mark.parametrize("name", [*FIRES, "weather"])
def test_parts_change_nothing(name, tmp_path):
    whole = burnt(name)
    with fb.cluster(keep=tmp_path / "parts") as made:
        assert whole.identical(burnt(name))
    assert made.kept.made == {"arrivals": 0, "range of runs": 19}.get(name, made.kept.made)
    assert made.kept.made > 1 or name == "arrivals" or "timeless" in name
    assert not (tmp_path / "parts").exists()


@pytest.mark.parametrize("name", [*FIRES, "weather"])
def test_workers_change_nothing(name, workers):
    with engine.using(workers):
        found = burnt(name)
    assert found.identical(burnt(name))


def test_curves_windows_and_trials_are_spread_as_well(workers, monkeypatch):
    priority = rank(NETWORK, "degree")
    request = FireRequest(n_runs=50, seed=2, duration=as_duration("20min"))
    stakes = fb.Stakes(NETWORK)
    calls = {
        "curve": lambda: burn_curve(NETWORK, priority, budgets=[0.0, 0.1, 0.2], n_runs=150),
        "windows": lambda: burn_windows(MapInMemory(NETWORK, CUT), request, side=16),
        "trial": lambda: xr.DataArray(Trial(Ground(NETWORK), request, stakes, 1).losses(CUT, n_runs=40)),
    }
    seen = []
    run = clusters.Cluster.run
    monkeypatch.setattr(clusters.Cluster, "run", lambda *given: seen.append(len(given[2])) or run(*given))
    for name, call in calls.items():
        seen.clear()
        with engine.using(workers):
            found = call()
        assert found.identical(call()), name
        assert seen
        assert seen[0] > 1, name


def test_a_lost_worker_and_a_new_one_change_nothing(workers):
    """One of two is killed in the run, and a third comes."""
    whole = simulate(NETWORK, n_runs=400, duration="30min", breaks=CUT)
    dask_cluster = workers.cluster._client.cluster
    events = []

    def disturb(share, message):
        if not events and share > 0.1:
            events.append("killed")
            next(iter(dask_cluster.workers.values())).process.process._process.kill()
        if len(events) == 1 and share > 0.3:
            events.append("added")
            dask_cluster.scale(3)

    with engine.using(workers):
        found = simulate(NETWORK, n_runs=400, duration="30min", breaks=CUT, progress=disturb)
    assert events == ["killed", "added"]
    assert found.identical(whole)


def test_data_that_all_lost_workers_held_are_sent_again():
    whole = simulate(NETWORK, n_runs=400, duration="30min")
    killed = []

    def disturb(share, message):
        if not killed and share > 0.1:
            killed.append(next(iter(made.cluster._client.cluster.workers.values())))
            killed[0].process.process._process.kill()

    with fb.cluster(1) as made:
        found = simulate(NETWORK, n_runs=400, duration="30min", progress=disturb)
    assert killed
    assert found.identical(whole)


def test_a_stop_comes_through_at_once():
    """Workers are at parts that take minutes. A machine that is busy with something else has a second try."""
    large = network_of(shape=(700, 700))

    def stopped_after(begun, processes):
        def stop(share, message):
            begun.append(time.monotonic())
            if begun[-1] - begun[0] > 2.0:
                raise Cancelled("enough")

        with fb.cluster(2) as made:
            processes.extend(nanny.pid for nanny in made.cluster._client.cluster.workers.values())
            simulate(large, n_runs=2000, duration="24h", progress=stop)

    took = []
    for _ in range(3):
        begun, processes = [], []
        with pytest.raises(Cancelled):
            stopped_after(begun, processes)
        took.append(time.monotonic() - begun[-1])
        assert not [pid for pid in processes if psutil.pid_exists(pid) and psutil.Process(pid).status() != "zombie"]
        if took[-1] < 2.0:
            break
    assert min(took) < 2.0


def test_workers_leave_parts_that_nobody_waits_for(workers):
    """Those of a scheduler that stays are not killed: they find out by themselves."""
    begun = []

    def stop(share, message):
        begun.append(time.monotonic())
        if begun[-1] - begun[0] > 3.0:
            raise Cancelled("enough")

    def at_work(dask_worker):
        return [task.key for task in dask_worker.state.tasks.values() if task.state in ("executing", "cancelled")]

    client = workers.cluster._client
    with engine.using(workers), pytest.raises(Cancelled):
        simulate(network_of(shape=(1000, 1000)), n_runs=8000, duration="240h", progress=stop)
    until = time.monotonic() + 10.0
    while any(client.run(at_work).values()) and time.monotonic() < until:
        time.sleep(0.1)
    assert not any(client.run(at_work).values())


def test_an_error_of_a_part_is_told(workers):
    with engine.using(workers), pytest.raises(InputError, match="outside the grid"):
        simulate(NETWORK, n_runs=10, ignitions=[(-50.0, 50.0)])
    with engine.using(workers), pytest.raises(ParameterError, match="is no part"):
        engine.spread(refusing, [1, 2], {}, take=lambda *_: None, threads=None, progress=None)


def refusing(piece, *, threads, progress):
    raise ParameterError(f"{piece} is no part")


def test_refused_with_what_to_do(monkeypatch, workers):
    monkeypatch.setattr(clusters, "_PATIENCE", 0.5)
    nobody = fb.cluster(scheduler="tcp://127.0.0.1:9")
    with pytest.raises(ResourceError, match=r"no dask scheduler answers at tcp://127.0.0.1:9"), nobody:
        pass
    with pytest.raises(ParameterError, match="one of"), fb.cluster(2, scheduler="tcp://127.0.0.1:9"):
        pass
    with pytest.raises(ParameterError, match="at least 1"), fb.cluster(0):
        pass
    with monkeypatch.context() as patch:
        patch.setattr(clusters, "_versions", lambda: {"firebreak_gis": "99.9"})
        with pytest.raises(
            MissingComponentError, match=r"the worker at tcp://.* has firebreak_gis .*, this machine 99.9"
        ):
            clusters.Cluster(workers.cluster._client)
    # A worker that comes later with another version is found out by its first part.
    monkeypatch.setattr(workers.cluster, "_versions", {"numpy": "1.0"})
    with engine.using(workers), pytest.raises(MissingComponentError, match="numpy"):
        simulate(NETWORK, n_runs=100, duration="5min")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(MissingComponentError, match=r"firebreak_gis\[scale\]"), fb.cluster(2):
        pass


class _StopError(Exception):
    pass


def stopping(at):
    def progress(share, message):
        if share > at:
            raise _StopError

    return progress


def fires(progress=None, **other):
    return simulate(
        NETWORK, **{"n_runs": 80, "duration": "30min", "breaks": CUT, **other}, threads=1, progress=progress
    )


@pytest.mark.parametrize("count", [None, 2])
def test_a_run_that_was_stopped_goes_on(tmp_path, count, monkeypatch, workers):
    keep = tmp_path / "parts"
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        fires(stopping(0.5))
    kept = len(list(keep.iterdir()))
    assert 2 < kept < 10
    told = []
    with fb.cluster(keep=keep, say=told.append) as made:
        made.cluster = workers.cluster if count else None  # who makes the rest does not matter
        found = fires()
    assert found.identical(fires())
    assert (made.kept.found, made.kept.made, told) == (kept, 10 - kept, [])
    assert not keep.exists()


@pytest.mark.parametrize(
    "other", [{"seed": 1}, {"breaks": ~CUT}, {"duration": "31min"}, {"n_runs": 90}, {"hold": 0.5}, {"value": VALUE}]
)
def test_parts_of_other_fires_are_made_anew(tmp_path, other):
    """And each kind of difference is noticed by itself."""
    keep = tmp_path / "parts"
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        fires(stopping(0.5))
    told = []
    with fb.cluster(keep=keep, say=told.append) as made:
        found = fires(**other)
    assert found.identical(fires(**other))
    assert made.kept.found == 0
    assert any("other inputs or parameters" in each for each in told)


@pytest.mark.parametrize("damage", [lambda b: b[:-3], lambda b: b[:60] + b"x" + b[61:], lambda b: b"", lambda b: b[9:]])
def test_damaged_parts_are_made_anew(tmp_path, damage):
    keep = tmp_path / "parts"
    with pytest.raises(_StopError), fb.cluster(keep=keep):
        fires(stopping(0.5))
    first = min(keep.iterdir())
    first.write_bytes(damage(first.read_bytes()))
    told = []
    with fb.cluster(keep=keep, say=told.append) as made:
        found = fires()
    assert found.identical(fires())
    assert len(told) == 1
    assert "damaged" in told[0]
    assert made.kept.found > 0


def test_parts_hold_what_they_were_given(tmp_path):
    parts = Parts(tmp_path / "parts")
    parts.put("one", "ab" * 32, {"cells": np.arange(5, dtype=np.uint32), "none": np.zeros(0)})
    found = parts.get("one", "ab" * 32)
    assert found["cells"].dtype == np.uint32
    assert found["cells"].tolist() == [0, 1, 2, 3, 4]
    assert parts.get("two", "ab" * 32) is None
    (tmp_path / "parts" / "mine.txt").write_text("not a part")
    parts.remove()
    assert [path.name for path in (tmp_path / "parts").iterdir()] == ["mine.txt"]


def test_fingerprints_tell_values_apart():
    values = [None, 0, 0.0, False, "0", [], [0], (0,), {"a": 0}, {"b": 0}, np.zeros(2), np.zeros(3), np.zeros(2, int)]
    values += [FireRequest(), FireRequest(seed=1), NETWORK, network_of(4), with_edge(0.0), with_edge(0.1)]
    prints = [engine.fingerprint(value) for value in values]
    assert len(set(prints)) == len(prints)
    assert engine.fingerprint(network_of()) == engine.fingerprint(NETWORK)
    code = (
        "from tests.simulation.test_workers import *; made = [weather()['weather'], FIRES['lines']['breaks'], NETWORK];"
        "print(engine.fingerprint([*made, FIRES['clock']['residual']]))"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    made = [weather()["weather"], FIRES["lines"]["breaks"], NETWORK]
    assert told.strip() == engine.fingerprint([*made, FIRES["clock"]["residual"]])


def with_edge(value):
    probability = NETWORK.probability.copy()
    probability[2, 20, 20] = value
    return SpreadNetwork(probability, travel_time=NETWORK.travel_time.astype(float), heat=NETWORK.heat)


def test_threads_of_one_worker_share_the_networks_of_a_weather():
    """Many parts ask for many weathers at once, of which few are kept."""
    networks = weather()["weather"]
    networks._keep = 1
    failed = []

    def ask(i):
        try:
            for k in range(40):
                assert networks[(i + k) % len(networks)].network.timed
        except Exception as error:
            failed.append(error)

    threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failed


def test_layers_of_dask_are_computed():
    """Chunked arrays go in wherever arrays do."""
    lazy = xr.DataArray(NETWORK.probability, dims=("direction", "y", "x")).chunk({"y": 5, "x": 8})
    other = SpreadNetwork(lazy, burnable=dask.array.from_array(NETWORK.burnable, chunks=4))
    assert (other.probability == NETWORK.probability).all()
    priority = rank(other, "degree")
    breaks = select_breaks(priority.chunk({"y": 6}), budget=0.1)
    assert breaks.equals(select_breaks(rank(other, "degree"), budget=0.1))
    found = simulate(other, breaks=breaks.chunk({"x": 4}), n_runs=20)
    assert isinstance(found, xr.Dataset)
    assert found.equals(simulate(other, breaks=breaks, n_runs=20))


@pytest.mark.parametrize("source", ["anywhere", "points", "weights"])
def test_a_range_of_runs_is_that_part_of_all_runs(source):
    points = [(500_110.0, 3_999_500.0), (500_700.0, 3_999_700.0)]
    ignitions = {"anywhere": None, "points": points, "weights": VALUE}[source]
    whole = simulate(NETWORK, n_runs=150, seed=2, ignitions=ignitions)
    first = simulate(NETWORK, n_runs=70, seed=2, ignitions=ignitions)
    rest = simulate(NETWORK, n_runs=80, first_run=70, seed=2, ignitions=ignitions)
    assert (first["burn_count"] + rest["burn_count"]).equals(whole["burn_count"])
    assert (np.concatenate([first["fire_size"], rest["fire_size"]]) == whole["fire_size"].to_numpy()).all()
