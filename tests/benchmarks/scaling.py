"""Cost of each kernel against the number of cells: what the picture shows."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from firebreak_gis import SpreadNetwork, rank, select_breaks
from firebreak_gis.kernels.centrality import betweenness, sampled_betweenness
from firebreak_gis.kernels.linear import Operator
from firebreak_gis.simulation import cut_levels
from tests.benchmarks.fires import LEVELS, RUNS, Kernels
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import seconds, threads


@dataclass
class Cost:
    """Seconds that a kernel takes on so many cells."""

    kernel: str
    cells: int
    seconds: float


#: Sides of the landscapes: 10^4, 10^5, 10^6 and 9 * 10^6 cells; for exact betweenness smaller ones.
SIDES, SMALL_SIDES = (100, 316, 1000, 3000), (32, 56, 100, 178)


def costs(sides: tuple[int, ...] = SIDES, small: tuple[int, ...] = SMALL_SIDES) -> Iterator[Cost]:
    """Every kernel at every size, on one thread, in processor time."""
    with threads(1):
        for side in small:
            network = fractal(side, scale=1.0)
            given = (network.probability, network.burnable)
            rounds = 3 if side <= 56 else 1
            yield Cost("betweenness, exact", side * side, seconds(lambda: betweenness(*given), rounds=rounds))
        for side in sides:
            for kernel, work, amount in _kernels(fractal(side)):
                started = time.process_time()
                work()
                once = time.process_time() - started
                # Short work is repeated until the clock sees it.
                times = max(1, min(200, round(0.05 / max(once, 1e-6))))
                took = seconds(lambda: [work() for _ in range(times)], rounds=3 if once < 5.0 else 1)  # noqa: B023
                yield Cost(kernel, side * side, took / times / amount)


def _kernels(network: SpreadNetwork) -> Iterator[tuple[str, Callable[[], object], float]]:
    few = 8 if network.burnable.size > 5_000_000 else RUNS
    kernels = Kernels(network)
    yield "a fire, one by one", lambda: kernels.one_by_one(few), few
    yield "a fire, 64 at once", kernels.at_once, RUNS
    levels = cut_levels(network, np.random.default_rng(3).random(network.shape), LEVELS).ravel()
    yield "a curve of 51 levels", lambda: kernels.curve(levels, few), few
    del kernels
    pivots = 2 if network.burnable.size > 500_000 else 8
    given = (network.probability, network.burnable)
    yield "betweenness, a pivot", lambda: sampled_betweenness(*given, pivots=pivots), pivots
    x, out = np.ones(network.shape), np.empty(network.shape)
    with Operator(network.probability) as operator:
        yield "product A x", lambda: operator.apply(x, out), 1
    yield "Bonacich, beta 0.9", lambda: rank(network, "bonacich", beta=0.9), 1
    priority = rank(network, "degree")
    yield "breaks", lambda: select_breaks(priority, budget=0.1, burnable=network.burnable), 1


def slope(costs: list[Cost]) -> float:
    """Exponent of the cells to which the cost grows, by least squares on logarithms."""
    return float(np.polyfit(np.log([c.cells for c in costs]), np.log([c.seconds for c in costs]), 1)[0])
