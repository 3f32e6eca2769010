"""Cost of each kernel against the number of cells: what the picture shows."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from firebreak_gis import SpreadNetwork, rank, select_breaks
from firebreak_gis.kernels.centrality import betweenness, sampled_betweenness
from firebreak_gis.kernels.linear import Operator
from firebreak_gis.simulation.budgets import cut_levels
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
            work = partial(betweenness, network.probability, network.burnable)
            yield Cost("betweenness, exact", side * side, seconds(work, rounds=3 if side <= 56 else 1))
        for side in sides:
            network = fractal(side)
            for kernel, work, amount in (*_fires(network), *_centralities(network)):
                yield Cost(kernel, side * side, _time(work) / amount)


def _time(work: Callable[[], object]) -> float:
    started = time.process_time()
    work()
    once = time.process_time() - started
    # Short work is repeated until the clock sees it.
    times = max(1, min(200, round(0.05 / max(once, 1e-6))))
    return seconds(lambda: [work() for _ in range(times)], rounds=3 if once < 5.0 else 1) / times


Timed = tuple[str, Callable[[], object], float]


def _fires(network: SpreadNetwork) -> list[Timed]:
    few = 8 if network.burnable.size > 5_000_000 else RUNS
    kernels = Kernels(network)
    levels = cut_levels(network, np.random.default_rng(3).random(network.shape), LEVELS).ravel()
    return [
        ("a fire, one by one", lambda: kernels.one_by_one(few), few),
        ("a fire, 64 at once", kernels.at_once, RUNS),
        ("a curve of 51 levels", lambda: kernels.curve(levels, few), few),
    ]


def _centralities(network: SpreadNetwork) -> list[Timed]:
    pivots = 4 if network.burnable.size > 5_000_000 else 16
    x, out = np.ones(network.shape), np.empty(network.shape)
    operator = Operator(network.probability)
    priority = rank(network, "degree")
    return [
        (
            "betweenness, a pivot",
            lambda: sampled_betweenness(network.probability, network.burnable, pivots=pivots),
            pivots,
        ),
        ("product A x", lambda: operator.apply(x, out), 1),
        ("Bonacich, beta 0.9", lambda: rank(network, "bonacich", beta=0.9), 1),
        ("breaks", lambda: select_breaks(priority, budget=0.1, burnable=network.burnable), 1),
    ]


def slope(costs: list[Cost]) -> float:
    """Exponent of the cells to which the cost grows, by least squares on logarithms."""
    return float(np.polyfit(np.log([c.cells for c in costs]), np.log([c.seconds for c in costs]), 1)[0])
