"""The best cells to cut for a fixed set of fires, by integer programming; and a bound where that is not proven."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import csr_array

from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.fires import Fires
from firebreak_gis.stakes import Stakes
from tests.twins.placement import burnt, loss, open_graph


class Optimum(NamedTuple):
    """Plan and mean loss as a share of all value; no plan loses less than `bound`."""

    cut: np.ndarray
    lost: float
    bound: float
    proven: bool


def optimum(
    network: SpreadNetwork, stakes: Stakes, fires: Fires, *, budget: float, seconds: float = 60.0, gap: float = 1e-6
) -> Optimum:
    """Minimise the mean loss over the fires; the cells cut cost no more than `budget`, in the unit of the cost.

    y_n = 1: cell n is cut. x_n,s: cell n burns in fire s, at least 1 - y_n where the fire starts and at least
    x_m,s - y_n for every open edge m -> n. With y whole the least x is whole.
    """
    n_cells = network.burnable.size
    alive = network.burnable.ravel()
    free = np.flatnonzero(alive & ~stakes.protected.ravel())
    value, cost = stakes.value.ravel(), stakes.cost.ravel()
    slot = np.full(n_cells, -1)
    slot[free] = np.arange(free.size)
    worth = [np.zeros(free.size)]
    graphs = []
    rows: list[tuple[int, int, float]] = []
    least: list[float] = []
    n = free.size
    for run, start in enumerate(fires.cells.tolist()):
        graph = open_graph(network, fires, run)
        graphs.append(graph)
        reached = burnt(graph, start, alive)
        place = {cell: n + i for i, cell in enumerate(reached)}
        n += len(reached)
        worth.append(value[reached] / fires.cells.size)
        for cell in reached:
            for other in ([None] if cell == start else []) + [m for m in graph.predecessors(cell) if m in place]:
                row = len(least)
                rows.append((row, place[cell], 1.0))
                if slot[cell] >= 0:
                    rows.append((row, int(slot[cell]), 1.0))
                if other is not None:
                    rows.append((row, place[other], -1.0))
                least.append(1.0 if other is None else 0.0)
    row, col, entry = (np.array(part) for part in zip(*rows, strict=True))
    spread = LinearConstraint(csr_array((entry, (row, col)), shape=(len(least), n)), np.array(least), np.inf)
    price = np.zeros(n)
    price[: free.size] = cost[free]
    whole = np.zeros(n)
    whole[: free.size] = 1
    answer = milp(
        np.concatenate(worth),
        integrality=whole,
        bounds=Bounds(0, 1),
        constraints=[spread, LinearConstraint(price[None], -np.inf, budget)],
        options={"time_limit": seconds, "mip_rel_gap": gap},
    )
    cut = np.zeros(n_cells, bool)
    if answer.x is not None:
        cut[free[answer.x[: free.size] > 0.5]] = True
    # Burnt again, since x need not be least where the time was out.
    starts = fires.cells.tolist()
    lost = sum(loss(graph, start, alive & ~cut, value) for graph, start in zip(graphs, starts, strict=True))
    total = float(value.sum())
    bound = max(answer.mip_dual_bound or 0.0, 0.0) / total
    return Optimum(cut.reshape(network.shape), lost / len(starts) / total, bound, answer.status == 0)
