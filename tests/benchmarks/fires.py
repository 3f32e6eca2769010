"""Rows about fires: 64 at once, against numpy and scipy, and whole curves."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from firebreak_gis import SpreadNetwork, burn_curve, simulate
from firebreak_gis.kernels import draws, lanes, percolation
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import Comparison

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
        percolation.burn_runs(*self.given, 0, n_runs, counts, sizes, np.zeros(0), np.zeros(n_runs))
        return counts, sizes

    def at_once(self) -> peers.Burns:
        """Burn 64 runs at once."""
        counts, sizes = np.zeros(self.n_cells, np.uint32), np.zeros(RUNS, np.int64)
        lanes.burn_block(*self.given, 0, RUNS, self.state, counts, sizes)
        return counts, sizes

    def curve(self, levels: np.ndarray, n_runs: int = RUNS) -> np.ndarray:
        """Cells burnt at every cut level, run by run."""
        burnt = np.zeros((n_runs, LEVELS.size), np.int64)
        percolation.burn_curve(*self.given, 0, n_runs, levels, burnt)
        return burnt


def rows(side: int) -> Iterator[Comparison]:
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
    from firebreak_gis.simulation.fires import cut_levels

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
