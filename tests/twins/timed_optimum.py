"""The best cells to cut for fixed fires with a clock, by integer programming over time; and a bound."""

from __future__ import annotations

import heapq
from typing import NamedTuple

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import csr_array

from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.stakes import Stakes


class TimedFire(NamedTuple):
    """Where a fire starts, which edges it finds open (8, rows, cols), and for how many minutes it burns."""

    start: int
    opened: np.ndarray
    minutes: int


class Optimum(NamedTuple):
    """Plan and mean cells burnt a fire; no plan loses less than `bound`."""

    cut: np.ndarray
    lost: float
    bound: float
    proven: bool


def drawn(network: SpreadNetwork, *, n: int, minutes: int, seed: int) -> list[TimedFire]:
    """Draw fires: starts evenly on the fuel, each edge open by its probability."""
    random = np.random.default_rng(seed)
    starts = random.choice(np.flatnonzero(network.burnable), n)
    return [
        TimedFire(int(start), random.random(network.probability.shape) < network.probability, minutes)
        for start in starts
    ]


def edges(network: SpreadNetwork, fire: TimedFire, cell: int) -> list[tuple[int, int]]:
    """Neighbours that fire comes to from a cell, and after how many minutes."""
    assert network.travel_time is not None
    rows, cols = network.shape
    row, col = divmod(cell, cols)
    found = []
    for d in range(8):
        r, c = row + ROW_STEP[d], col + COL_STEP[d]
        if 0 <= r < rows and 0 <= c < cols and fire.opened[d, row, col] and network.burnable[r, c]:
            found.append((r * cols + c, round(int(network.travel_time[d, row, col]) / 60)))
    return found


def arrival(network: SpreadNetwork, fire: TimedFire, cut: np.ndarray) -> dict[int, int]:
    """Minute in which each cell burns, by Dijkstra; cells that are cut do not."""
    there: dict[int, int] = {}
    queue = [] if cut.ravel()[fire.start] else [(0, fire.start)]
    while queue:
        minute, cell = heapq.heappop(queue)
        if cell in there:
            continue
        there[cell] = minute
        for other, step in edges(network, fire, cell):
            if minute + step <= fire.minutes and other not in there and not cut.ravel()[other]:
                heapq.heappush(queue, (minute + step, other))
    return there


def lost_cells(network: SpreadNetwork, fire: TimedFire, cut: np.ndarray) -> int:
    """Cells that a fire burns."""
    return len(arrival(network, fire, cut))


def timed_optimum(
    network: SpreadNetwork, stakes: Stakes, fires: list[TimedFire], *, budget: float, seconds: float = 60.0
) -> Optimum:
    """Minimise the mean cells burnt over the fires; the cells cut cost no more than `budget`.

    y_n = 1: cell n is cut. x_n,t,s: cell n burns by minute t in fire s, at least 1 - y_n where and when the fire
    starts, at least x_n,t-1,s, and at least x_m,t-step,s - y_n for every open edge m -> n. A cell is lost if it burns
    by the end. Minutes before the first in which a cell can burn are left out.
    """
    free = np.flatnonzero((network.burnable & ~stakes.protected).ravel())
    slot = np.full(network.burnable.size, -1)
    slot[free] = np.arange(free.size)
    n = free.size
    worth: dict[int, float] = {}
    entries: list[tuple[int, int, float]] = []
    least: list[float] = []

    def demand(one: int, other: int | None, cell: int, low: float) -> None:
        """x_one >= low + x_other - y_cell."""
        row = len(least)
        entries.append((row, one, 1.0))
        if other is not None:
            entries.append((row, other, -1.0))
        if cell >= 0 and slot[cell] >= 0:
            entries.append((row, int(slot[cell]), 1.0))
        least.append(low)

    for fire in fires:
        first = arrival(network, fire, np.zeros(network.shape, bool))
        place = {}
        for cell, minute in first.items():
            for t in range(minute, fire.minutes + 1):
                place[cell, t] = n
                n += 1
            worth[place[cell, fire.minutes]] = 1.0 / len(fires)
        for (cell, t), number in place.items():
            if (cell, t - 1) in place:
                demand(number, place[cell, t - 1], -1, 0.0)
        demand(place[fire.start, 0], None, fire.start, 1.0)
        for cell in first:
            for other, step in edges(network, fire, cell):
                for t in range(first[cell], fire.minutes + 1 - step):
                    demand(place[other, t + step], place[cell, t], other, 0.0)
    row, col, entry = (np.array(part) for part in zip(*entries, strict=True))
    goal, price, whole = np.zeros(n), np.zeros(n), np.zeros(n)
    goal[list(worth)] = list(worth.values())
    price[: free.size] = stakes.cost.ravel()[free]
    whole[: free.size] = 1
    answer = milp(
        goal,
        integrality=whole,
        bounds=Bounds(0, 1),
        constraints=[
            LinearConstraint(csr_array((entry, (row, col)), shape=(len(least), n)), np.array(least), np.inf),
            LinearConstraint(price[None], -np.inf, budget),
        ],
        options={"time_limit": seconds},
    )
    cut = np.zeros(network.shape, bool)
    if answer.x is not None:
        cut.ravel()[free[answer.x[: free.size] > 0.5]] = True
    lost = float(np.mean([lost_cells(network, fire, cut) for fire in fires]))
    return Optimum(cut, lost, max(float(answer.mip_dual_bound or 0.0), 0.0), answer.status == 0)
