"""Crews that come from stations: their way, what holds before and after them, and what must never change."""

from __future__ import annotations

import heapq
import math
from itertools import pairwise

import geopandas as gpd
import numpy as np
import pytest
import xarray as xr
from click.testing import CliRunner
from shapely.geometry import LineString, Point

import firebreak_gis as fb
from firebreak_gis import SpreadNetwork, simulate
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import FirebreakError, InputError, ParameterError
from firebreak_gis.kernels import draws
from firebreak_gis.lattice import NEVER
from firebreak_gis.rasters import write_raster
from firebreak_gis.simulation.embers import what_flies
from firebreak_gis.simulation.ground_fires import MapInMemory
from firebreak_gis.simulation.holding import Hold, stretches
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.stations import Stations, Travel, as_travel, travel_hours
from firebreak_gis.simulation.windows import burn_windows
from tests.simulation.test_timed import EACH, WINDY, at, ensemble, network_of
from tests.twins.arrival import Fire
from tests.twins.percolation import word

SLOW = Travel(road=2.0, off=0.6, delay=5.0)


def way(start, roads, travel, size):
    """Dijkstra with a heap, cell by cell."""
    rows, cols = start.shape
    speed = np.where(roads, travel.road, travel.off)
    best = {(int(r), int(c)): 0.0 for r, c in np.argwhere(start)}
    heap = [(0.0, cell) for cell in best]
    while heap:
        hours, (r, c) = heapq.heappop(heap)
        if hours > best[r, c]:
            continue
        for down in (-1, 0, 1):
            for right in (-1, 0, 1):
                to = (r + down, c + right)
                if to == (r, c) or not (0 <= to[0] < rows and 0 <= to[1] < cols):
                    continue
                there = hours + size / 1000 * math.hypot(down, right) * (1 / speed[r, c] + 1 / speed[to]) / 2
                if there < best.get(to, math.inf):
                    best[to] = there
                    heapq.heappush(heap, (there, to))
    return np.array([[best[r, c] for c in range(cols)] for r in range(rows)])


@pytest.mark.parametrize("seed", range(6))
def test_the_way_is_that_of_the_twin(seed):
    random = np.random.default_rng(seed)
    shape = (int(random.integers(1, 14)), int(random.integers(1, 17)))
    start = random.random(shape) < 0.03
    start.flat[int(random.integers(start.size))] = True
    roads = random.random(shape) < 0.3
    travel = Travel(*random.uniform(0.5, 50, 2), 0.0)
    np.testing.assert_allclose(travel_hours(start, roads, travel, 30.0), way(start, roads, travel, 30.0), rtol=1e-12)


def points(network, *cells):
    x, y = network.grid.x, network.grid.y
    at = [Point(x[0] + 20.0 * col, y[0] - 20.0 * row) for row, col in cells]
    return gpd.GeoDataFrame(geometry=at, crs=network.grid.crs)


def test_delay_roads_and_blocks_make_the_arrival():
    network = network_of(1, shape=(20, 30))
    road = gpd.GeoDataFrame(geometry=[LineString([at(network, 3, 2), at(network, 3, 29)])], crs=network.grid.crs)
    found = Stations(points(network, (3, 2), (999, 999)), road, Travel(40.0, 2.0, 15.0)).arrival(network.grid, 20.0)
    assert found.dtype == np.uint64
    assert found[3, 2] == 900
    assert found[3, 22] == 900 + math.ceil(3600 * 0.4 / 40 - 1e-6)
    assert found[13, 2] == 900 + math.ceil(3600 * 0.02 * (0.5 / 40 + 9.5 / 2))
    blocks = Stations(points(network, (3, 2)), road, Travel(40.0, 2.0, 15.0)).arrival(network.grid, 100.0)
    side = stretches(network.shape, 20.0, 100.0)
    for block in np.unique(side):
        assert (blocks[side == block] == found[side == block].min()).all()


def held(network, cut, residual, crews, runs, **more):
    """Arrival of each run by the twin."""
    keys = {purpose: draws.run_keys(3, purpose, runs) for purpose in ("edges", "hold", "embers")}
    block = stretches(network.shape, 20.0, 60.0).ravel()
    for run in range(runs):
        holds = [word(int(keys["hold"][run]), 2 * int(b)) >> 32 < round(0.8 * 2**32) for b in block]
        yield Fire(
            network,
            int(keys["edges"][run]),
            [network.travel_time],
            limit=4000,
            stands=frozenset(int(c) for c in np.flatnonzero(cut) if holds[c]),
            residual=residual,
            crews=crews,
            ember_key=int(keys["embers"][run]),
            **more,
        )


@pytest.mark.parametrize("embers", [None, WINDY])
@pytest.mark.parametrize("residual", [0.0, 0.4])
def test_fires_are_those_of_the_twin(embers, residual):
    network = network_of(1, boundary="open")
    cut = np.random.default_rng(5).random(network.shape) < 0.3
    cell = int(np.flatnonzero(network.burnable & ~cut)[100])
    stations = points(network, (2, 3))
    crews = Stations(stations, None, SLOW).arrival(network.grid, 60.0)
    assert crews.min() < 1000 < crews.max()
    given = {"ignitions": at(network, *divmod(cell, 22)), "n_runs": 40, "seed": 3, "duration": 4000, "products": EACH}
    given |= {"breaks": cut, "residual": residual, "hold": Hold(0.8, length=60.0), "embers": embers}
    burns = simulate(network, stations=stations, crew_travel=SLOW, **given)
    flying = None
    if embers:
        keys = draws.run_keys(3, "embers", 40)
        flying = what_flies(WINDY, network, keys, times=[network.travel_time], winds=[(8.0, 300.0)])
    others = 0
    for run, fire in enumerate(held(network, cut, residual, crews, 40, embers=flying)):
        expected = fire.burn({cell: 0})
        found = burns["arrival"][run].to_numpy().ravel()
        assert {c: int(found[c]) for c in np.flatnonzero(found != NEVER).tolist()} == expected
        fire.crews = None
        others += expected != fire.burn({cell: 0})
    assert others > 20


def test_a_cut_cell_that_is_lit_before_crews_come_burns():
    network = network_of(4)
    cut = np.ones(network.shape, bool)
    far = points(network, (0, 0))
    given = {"breaks": cut, "n_runs": 30, "duration": "1h"}
    assert (simulate(network, **given)["fire_size"] == 0).all()
    late = simulate(network, stations=far, crew_travel="delay=100000", **given)
    xr.testing.assert_identical(late, simulate(network, n_runs=30, duration="1h"))


@pytest.mark.parametrize("more", [{}, {"embers": WINDY}, {"residual": 0.3}, {"barriers": True, "barriers_hold": 0.6}])
def test_crews_that_are_there_at_once_change_nothing(more):
    network = network_of(7)
    random = np.random.default_rng(1)
    if "barriers" in more:
        more = more | {"barriers": random.random(network.shape) < 0.1}
    given = {"breaks": random.random(network.shape) < 0.2, "hold": "0.5:60", "duration": "1h", "n_runs": 50, **more}
    everywhere = network.grid.dataarray(np.ones(network.shape, np.uint8), "breaks")
    there = simulate(network, stations=everywhere, crew_travel="delay=0", **given)
    xr.testing.assert_identical(there, simulate(network, **given))


def test_barriers_hold_without_crews():
    network = network_of(7)
    wall = np.random.default_rng(1).random(network.shape) < 0.3
    given = {"barriers": wall, "barriers_hold": 0.7, "duration": "1h", "n_runs": 40}
    never = simulate(network, stations=points(network, (0, 0)), crew_travel="delay=100000", **given)
    xr.testing.assert_identical(never, simulate(network, **given))


@pytest.mark.parametrize("hold", [Hold(1.0), Hold(0.5, length=60.0)])
def test_more_cut_never_burns_earlier_and_more_stations_never_burn_more(hold):
    networks = ensemble(8, changing=False)
    network = networks[0].network
    random = np.random.default_rng(2)
    order = random.permutation(network.burnable.size).reshape(network.shape)
    places = [tuple(map(int, np.unravel_index(i, network.shape))) for i in random.permutation(order.size)[:9]]
    found = {}
    for share in (0.08, 0.25, 0.5):
        for n in (1, 3, 9):
            found[share, n] = simulate(
                network,
                weather=networks,
                breaks=(order < share * order.size) & network.burnable,
                residual=0.1,
                hold=hold,
                embers=fb.Embers(rate=20_000.0),
                duration="lognormal:40min,0.5",
                stations=points(network, *places[:n]),
                crew_travel=SLOW,
                n_runs=60,
                seed=6,
                products=EACH,
            )["arrival"].to_numpy()
    slower = 0
    for n in (1, 3, 9):
        for fewer, more in pairwise((0.08, 0.25, 0.5)):
            assert (found[more, n] >= found[fewer, n]).all()
    for share in (0.08, 0.25, 0.5):
        for fewer, more in pairwise((1, 3, 9)):
            assert (found[share, more] >= found[share, fewer]).all()
            slower += int((found[share, more] > found[share, fewer]).sum())
    assert slower > 200


def test_faster_crews_and_roads_never_burn_more():
    network = network_of(3)
    cut = np.random.default_rng(3).random(network.shape) < 0.3
    road = gpd.GeoDataFrame(geometry=[LineString([at(network, 2, 3), at(network, 14, 19)])], crs=network.grid.crs)
    given = {"breaks": cut, "duration": "1h", "n_runs": 80, "stations": points(network, (2, 3))}
    sizes = [
        simulate(network, crew_travel=travel, roads=roads, **given)["fire_size"].to_numpy()
        for travel, roads in (
            ("off=0.3", None),
            ("off=0.3,road=3", road),
            ("off=2,road=3", road),
            ("off=2,delay=0", road),
        )
    ]
    assert all((more <= less).all() for less, more in pairwise(sizes))
    assert sizes[-1].sum() < sizes[0].sum()


def test_parts_and_threads_give_the_same(tmp_path):
    network = network_of(2)
    given = {"breaks": np.random.default_rng(3).random(network.shape) < 0.3, "duration": "1h", "n_runs": 40}
    given |= {"stations": points(network, (2, 3)), "crew_travel": SLOW}
    whole = simulate(network, **given)
    xr.testing.assert_identical(whole, simulate(network, threads=1, **given))
    with fb.cluster(keep=tmp_path / "parts"):
        xr.testing.assert_identical(whole, simulate(network, **given))


@pytest.mark.parametrize("given", ["soon", "off=-1", "road=0", "delay=-3", "off=2;road=3", "speed=3", "off"])
def test_what_is_no_way_to_travel_is_refused(given):
    with pytest.raises(ParameterError, match=r"crew"):
        as_travel(given)


def test_what_it_needs():
    base = network_of(1)
    timeless = SpreadNetwork(base.probability, burnable=base.burnable, crs=base.grid.crs, transform=base.grid.transform)
    stations = points(base, (1, 1))
    with pytest.raises(InputError, match="the way of crews"):
        simulate(timeless, stations=stations, n_runs=3)
    with pytest.raises(ParameterError, match="--stations"):
        simulate(base, roads=stations, n_runs=3)
    with pytest.raises(FirebreakError, match="station"):
        simulate(base, breaks=base.burnable, stations=points(base, (500, 900)), n_runs=3)
    request = FireRequest(stations=stations, n_runs=3, duration=None)
    with pytest.raises(ParameterError, match="crews needs the map as a whole"):
        burn_windows(MapInMemory(base, base.burnable), request, side=16)


def test_the_command_says_it_and_without_it_writes_the_same_bytes(tmp_path):
    network = network_of(5)
    write_raster(tmp_path / "network.tif", network.to_dataset())
    cut = np.zeros(network.shape, np.uint8)
    cut[:, 11] = 1
    write_raster(tmp_path / "cut.tif", network.grid.dataarray(cut, "breaks"))
    points(network, (2, 3)).to_file(tmp_path / "stations.gpkg")
    for name, more in (
        ("without", []),
        ("with", ["--stations", str(tmp_path / "stations.gpkg"), "--crew-travel", "off=0.5"]),
    ):
        words = ["burn", str(tmp_path / "network.tif"), "--breaks", str(tmp_path / "cut.tif"), "--duration", "3h"]
        words += ["--runs", "40", *more, "-o", str(tmp_path / f"{name}.tif"), "--sizes", str(tmp_path / f"{name}.csv")]
        outcome = CliRunner().invoke(firebreak, words)
        assert outcome.exit_code == 0, outcome.output
        assert ("crews leave after 10 min at 0.5 km/h off roads (assumed)" in outcome.output) == (name == "with")
    plain = simulate(network, breaks=cut, duration="3h", n_runs=40)
    lines = (tmp_path / "without.csv").read_text().splitlines()[1:]
    assert [int(line.split(",")[1]) for line in lines] == plain["fire_size"].to_numpy().tolist()
    assert (tmp_path / "with.csv").read_bytes() != (tmp_path / "without.csv").read_bytes()
    refused = CliRunner().invoke(
        firebreak, ["burn", str(tmp_path / "network.tif"), "--roads", "x.gpkg", "-o", str(tmp_path / "no.tif")]
    )
    assert refused.exit_code != 0
    assert "--stations" in refused.output
