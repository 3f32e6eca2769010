"""Rows about fires: 64 at once, against numpy and scipy, and whole curves."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from firebreak_gis import SpreadNetwork, burn_curve, read_network, simulate, write_raster
from firebreak_gis.kernels import arrival as arrival_kernel
from firebreak_gis.kernels import draws, lanes, percolation
from firebreak_gis.kernels.percolation import NOTHING_SPARED
from firebreak_gis.planning.maps import MapInFiles
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation import timed as timed_runs
from firebreak_gis.simulation.durations import Duration
from firebreak_gis.simulation.embers import nothing_flies
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.ground_fires import MapInMemory
from firebreak_gis.simulation.holding import build_walls, cleared_ground
from firebreak_gis.simulation.products import Products, new_tally
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.windows import burn_windows
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal, paced
from tests.benchmarks.measuring import Comparison, Figure, seconds, threads

#: Runs of a block.
RUNS = 64
#: The demands are for landscapes of at least so many cells.
ASKED = 90_000
#: Cut levels of a curve.
LEVELS = np.linspace(0.0, 0.5, 51)


class Kernels:
    """The fire kernels on one network, with the ignitions in its middle or anywhere."""

    def __init__(self, network: SpreadNetwork, *, middle: bool = False) -> None:
        rows, cols = network.shape
        self.n_cells = rows * cols
        self.starts = np.full(RUNS, rows // 2 * cols + cols // 2)
        if not middle:
            self.starts = np.random.default_rng(0).integers(0, self.n_cells, RUNS)
        grid_steps = percolation.steps(network.shape, periodic=False)
        keys = draws.run_keys(0, "edges", RUNS)
        self.given = (draws.thresholds(network.probability), keys, grid_steps, np.arange(RUNS + 1), self.starts)
        self.state = lanes.lanes(network.shape)

    def one_by_one(self, n_runs: int = RUNS) -> peers.Burns:
        """Burn run by run."""
        counts, sizes = np.zeros(self.n_cells, np.uint32), np.zeros(n_runs, np.int64)
        percolation.burn_runs(*self.given, 0, n_runs, counts, sizes, np.zeros(0), np.zeros(n_runs), *NOTHING_SPARED)
        return counts, sizes

    def at_once(self) -> peers.Burns:
        """Burn 64 runs at once."""
        counts, sizes = np.zeros(self.n_cells, np.uint32), np.zeros(RUNS, np.int64)
        lanes.burn_block(*self.given, 0, RUNS, self.state, counts, sizes, *NOTHING_SPARED)
        return counts, sizes

    def curve(self, levels: np.ndarray, n_runs: int = RUNS) -> np.ndarray:
        """Cells burnt at every cut level, run by run."""
        burnt = np.zeros((n_runs, LEVELS.size), np.int64)
        percolation.burn_curve(*self.given, 0, n_runs, levels, burnt)
        return burnt


def rows(side: int) -> Iterator[Comparison | Figure]:
    """All rows about fires on one landscape."""
    network = fractal(side)
    for middle in (True, False):
        name = "one ignition" if middle else "random ignitions"
        kernels = Kernels(network, middle=middle)
        floor = {300: 3.0, 1000: 2.0}.get(side) if middle else None
        yield Comparison(
            f"64 fires at once, {name}",
            kernels.n_cells,
            "one by one",
            kernels.at_once,
            kernels.one_by_one,
            _equal,
            _burnt,
            "ns/burnt cell",
            1e9,
            at_least=floor,
        )
        yield from _against_peers(network, kernels.starts, name)
    yield from _curves(network)
    network = paced(side)
    yield from _timed(network)
    yield from _by_windows(network)


def _timed(network: SpreadNetwork) -> Iterator[Comparison | Figure]:
    """Fires with a clock, lit in the middle, against scipy and against those without one."""
    n_cells, (rows, cols) = network.burnable.size, network.shape
    middle = rows // 2 * cols + cols // 2
    asked = n_cells >= ASKED
    eight = 8 * 3600
    peer = peers.MaskAndDijkstra(network, eight)
    starts = np.full(8, middle)
    graphs = [peer.open_edges(run) for run in range(8)]
    timed = Timed(network, middle)

    def alike(a: np.ndarray, b: np.ndarray) -> bool:
        return _alike(a, b, n_cells)

    for name, theirs, floor in (
        ("csgraph.dijkstra(limit=) on edges drawn before", lambda: _searched(peer, graphs, middle), None),
        ("numpy mask + csgraph.dijkstra(limit=)", lambda: peer(starts), 10.0),
    ):
        yield Comparison(
            "fires of 8 h, one ignition",
            n_cells,
            name,
            lambda: timed.burn(eight),
            theirs,
            alike,
            lambda sizes: float(sizes.size),
            "ms/run",
            1e3,
            at_least=floor if asked else None,
        )
    plain = Kernels(network, middle=True)
    yield Comparison(
        "fires with a clock and no end, one ignition",
        n_cells,
        "one by one, no clock",
        lambda: timed.burn(arrival_kernel.ENDLESS),
        lambda: plain.one_by_one()[1],
        lambda a, b: bool((a == b).all()),
        lambda sizes: float(sizes.sum()),
        "ns/burnt cell",
        1e9,
        at_most=4.0 if asked else None,
    )
    if n_cells >= 1_000_000:
        with threads(2):
            taken = seconds(lambda: simulate(network, duration="8h", n_runs=1000), clock=time.perf_counter)
        yield Figure("1,000 fires of 8 h (`simulate`), random ignitions", n_cells, taken, "s", at_most=5.0, threads=2)


def _by_windows(network: SpreadNetwork) -> Iterator[Comparison]:
    """Fires with a clock that read the map by windows, against the same fires on the whole of it; equal run by run."""
    n_cells = network.burnable.size
    request = FireRequest(n_runs=1000, duration=Duration("fixed", (8 * 3600.0,)))
    path = str(write_raster(Path(tempfile.mkdtemp()) / "net.tif", network.to_dataset()))

    def of_file() -> MapInFiles:
        return MapInFiles(path, SpreadRequest(), WeatherRequest(), clock=True)

    for name, source, whole in (
        ("map in memory", lambda: MapInMemory(network), lambda: network),
        ("map in a file", of_file, lambda: read_network(path)),
    ):
        yield Comparison(
            f"1,000 fires of 8 h by windows, {name}",
            n_cells,
            "the whole map",
            lambda source=source: burn_windows(source(), request, threads=1)["fire_size"].to_numpy(),
            lambda whole=whole: burn(whole(), request, threads=1)["fire_size"].to_numpy(),
            lambda a, b: bool((a == b).all()),
            lambda sizes: float(sizes.size),
            "ms/fire",
            1e3,
        )
    Path(path).unlink()


def _searched(peer: peers.MaskAndDijkstra, graphs: list[Any], start: int) -> np.ndarray:
    return np.array([peer.search(graph, start) for graph in graphs])


class Timed:
    """The kernel of fires with a clock on one network, lit in one cell."""

    def __init__(self, network: SpreadNetwork, cell: int) -> None:
        self.network = network
        self.n_cells = network.burnable.size
        request = FireRequest(n_runs=RUNS)
        group = next(timed_runs.groups_of(network, None, n_runs=RUNS, first_run=0, seed=0))
        self.clock, self.span = timed_runs.clock_of(group.times, group.starts, 1 << 40, embers=False)
        keys = {purpose: draws.run_keys(0, purpose, RUNS) for purpose in ("edges", "hold", "embers")}
        walls = build_walls(network, keys["hold"], breaks=None, residual=0.0, hold=request.holding)
        self.cells = np.full(RUNS, cell)
        self.before = (
            draws.thresholds(network.probability),
            keys["edges"],
            percolation.steps(network.shape, periodic=False),
            self.clock,
        )
        cleared = cleared_ground(network, keys["hold"], None, request.holding)
        space = arrival_kernel.workspace(self.n_cells, self.span)
        self.after = (walls, cleared, nothing_flies(keys["embers"]), space)

    def burn(self, limit: int) -> np.ndarray:
        """Size of every fire."""
        tally = new_tally(self.network, Products(), RUNS, longest=limit, value=None)
        at, limits = np.zeros(RUNS, np.uint64), np.full(RUNS, limit, np.uint64)
        starts = arrival_kernel.Starts(np.arange(RUNS + 1), self.cells, at, limits)
        arrival_kernel.burn_timed(*self.before, starts, *self.after, np.arange(RUNS), tally, np.zeros(0, np.float32))
        return tally.sizes


def _against_peers(network: SpreadNetwork, starts: np.ndarray, name: str) -> Iterator[Comparison]:
    """What a user calls, on one thread, against what a user could write."""
    n_cells = network.burnable.size
    rows_cols = np.divmod(starts, network.shape[1])
    points = [(network.grid.x[col], network.grid.y[row]) for row, col in zip(*rows_cols, strict=True)]

    def ours() -> peers.Burns:
        burns = simulate(network, ignitions=points, n_runs=2 * RUNS, threads=1)
        return burns["burn_count"].to_numpy().ravel(), burns["fire_size"].to_numpy()

    few = starts if n_cells < 500_000 else starts[: RUNS // 2]
    for peer, make, floor in (
        ("numpy frontier", peers.NumpyFrontier, 15.0),
        ("numpy mask + csgraph", peers.MaskAndCsgraph, 8.0),
    ):
        burn = make(network)
        yield Comparison(
            f"fires (`simulate`), {name}",
            n_cells,
            peer,
            ours,
            lambda burn=burn: burn(few),
            lambda a, b: _alike(a[1][: few.size], b[1], n_cells),
            _burnt,
            "ns/burnt cell",
            1e9,
            at_least=floor if n_cells >= ASKED else None,
        )


def _curves(network: SpreadNetwork) -> Iterator[Comparison]:
    from firebreak_gis.simulation.budgets import cut_levels

    kernels = Kernels(network)
    asked = kernels.n_cells >= ASKED
    priority = np.random.default_rng(3).random(network.shape)
    levels = cut_levels(network, priority, LEVELS).ravel()
    order = np.argsort(np.argsort(-priority.ravel(), kind="stable"), kind="stable").reshape(network.shape)

    def every_level() -> np.ndarray:
        burnt = np.zeros((RUNS, LEVELS.size), np.int64)
        for k, budget in enumerate(LEVELS):
            cut = order < round(float(budget) * network.n_burnable)
            burnt[:, k] = simulate(network, breaks=cut, n_runs=RUNS, threads=1)["fire_size"]
        return burnt

    def curve() -> np.ndarray:
        return burn_curve(network, priority, budgets=LEVELS, n_runs=RUNS, threads=1).to_numpy()

    yield Comparison(
        "curve of 51 levels, run by run",
        kernels.n_cells,
        "one plain run",
        lambda: kernels.curve(levels),
        kernels.one_by_one,
        lambda a, b: bool((a[:, 0] == b[1]).all()),
        lambda _: RUNS,
        "ms/run",
        1e3,
        at_most=2.0 if asked else None,
    )
    yield Comparison(
        "curve of 51 levels (`burn_curve`)",
        kernels.n_cells,
        "`simulate`, no cut",
        curve,
        lambda: simulate(network, n_runs=RUNS, threads=1)["fire_size"].to_numpy(),
        lambda a, b: bool((a[:, 0] == b).all()),
        lambda _: RUNS,
        "ms/run",
        1e3,
    )
    yield Comparison(
        "curve of 51 levels (`burn_curve`)",
        kernels.n_cells,
        "`simulate` at every level",
        curve,
        every_level,
        lambda a, b: bool((a == b).all()),
        lambda _: RUNS,
        "ms/run",
        1e3,
        rounds=3 if kernels.n_cells < 500_000 else 1,
        at_least=5.0 if asked else None,
    )


def _equal(a: peers.Burns, b: peers.Burns) -> bool:
    return all(bool((x == y).all()) for x, y in zip(a, b, strict=True))


def _alike(ours: np.ndarray, theirs: np.ndarray, n_cells: int) -> bool:
    """Whether fires of other draws are as large, within four standard errors."""
    error = np.sqrt(ours.var() / ours.size + theirs.var() / theirs.size)
    return bool(abs(ours.mean() - theirs.mean()) <= 4 * error + 1e-3 * n_cells)


def _burnt(burns: peers.Burns) -> float:
    return float(burns[1].sum())
