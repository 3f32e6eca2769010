"""Improve a plan on simulated fires: drop cells that do little, put others in, swap."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.gains import dominated, reopened
from firebreak_gis.placement.dissection import lines_first
from firebreak_gis.placement.fires import Fires, burn_pieces, design_fires, pieces
from firebreak_gis.placement.gains import mean_gain
from firebreak_gis.placement.widening import affordable
from firebreak_gis.progress import part

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.setting import Setting

#: Cut cells that are tried in a swap, those that do least first.
_TRIES = 8
#: Swaps for which a cell that came or went stays as it is.
_TENURE = 7


class _Plan:
    """A set of cut cells on fixed fires; what they lose and what each change does, in units of value."""

    def __init__(
        self, network: SpreadNetwork, setting: Setting, cut: np.ndarray, fires: Fires, limit: float,
        threads: int | None,
    ) -> None:  # fmt: skip
        self.fires, self.threads, self.limit = fires, threads, limit
        self.free = (network.burnable & ~setting.protected).ravel()
        self.cost, self.value = setting.cost.ravel(), setting.value.ravel()
        self.alive = network.burnable.ravel() & ~cut.ravel()
        self.spent = float(self.cost[cut.ravel()].sum())

    def gains(self, progress: Progress) -> tuple[np.ndarray, float]:
        """Gain of cutting each cell that may be cut and paid, -1 for others; and the loss as it is."""
        gain, lost = mean_gain(
            dominated, self.fires, self.alive, self.value, threads=self.threads, progress=progress
        )
        payable = self.free & self.alive & (self.spent + self.cost <= self.limit)
        return np.where(payable, gain, -1.0), lost

    def damage(self, cells: np.ndarray, progress: Progress) -> np.ndarray:
        """Additional loss if each of the cut `cells` alone is left."""
        parts = pieces(self.fires.keys.size)
        sums = np.zeros((len(parts), cells.size))

        def work(i: int) -> None:
            reopened(
                self.fires.limits, self.fires.keys, self.fires.grid_steps, self.fires.cells, self.alive, self.value,
                cells, *parts[i], sums[i],
            )  # fmt: skip

        burn_pieces(work, self.fires.keys.size, self.alive.size, threads=self.threads, progress=progress)
        total: np.ndarray = sums.sum(axis=0) / self.fires.keys.size
        return total

    def cut(self, cell: int) -> None:
        self.alive[cell] = False
        self.spent += float(self.cost[cell])

    def leave(self, cell: int) -> None:
        self.alive[cell] = True
        self.spent -= float(self.cost[cell])

    def cells(self) -> np.ndarray:
        """Cells that are cut."""
        return np.flatnonzero(self.free & ~self.alive)


def refine(
    network: SpreadNetwork,
    setting: Setting,
    priority: np.ndarray,
    *,
    budget: float,
    moves: int = 100,
    n_runs: int = 100,
    seed: int = 0,
    fires: Fires | None = None,
    threads: int | None = None,
    progress: Progress,
) -> np.ndarray:
    """Improve the plan of one budget by tabu search on common fires.

    Money left over buys the cell of the largest gain. Then, again and again, one of the cells that do least is left
    and the cell of the largest exact gain is cut instead, the best such swap even if it is worse; the best plan seen
    counts. Breaks are taken as perfect.

    Parameters
    ----------
    network, setting
        What is planned for.
    priority
        (rows, cols) of any ranking.
    budget
        Share of the cost of all fuel.
    moves
        Largest number of swaps; the search ends after a quarter as many without a better plan.
    n_runs, seed
        Fires of the design; judge the plan on others.
    fires
        Use these fires.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64: first the cells of the improved plan in their old order, then the others. It is nested,
        but improved for this budget only.

    Notes
    -----
    Cost: about ten times 100 ns a burnt cell, fire and swap.
    """
    if not network.burnable.any():
        return priority
    fires = fires or design_fires(network, setting, n_runs=n_runs, seed=seed)
    limit = budget * float(setting.cost.sum()) * (1 + 1e-12)
    priority = np.where(setting.protected | ~network.burnable, -np.inf, priority)
    plan = _Plan(network, setting, affordable(priority, setting, budget), fires, limit, threads)
    best = (_fill(plan, progress), plan.cells())
    barred: dict[int, int] = {}
    last = 0
    for move in range(moves):
        step = part(progress, move / moves, (move + 1) / moves, f"swap {move + 1}: ")
        lost = _swap(plan, barred, move, step)
        if lost < best[0] * (1 - 1e-12):
            best, last = (lost, plan.cells()), move
        if lost == np.inf or best[0] == 0.0 or move - last > max(moves // 4, 1):
            break
    progress(1.0, "plan refined")
    first = best[1][np.argsort(-priority.ravel()[best[1]], kind="stable")]
    return lines_first([first], setting, priority)


def _fill(plan: _Plan, progress: Progress) -> float:
    """Spend what is left where it saves most; the loss then."""
    while True:
        gain, lost = plan.gains(part(progress, 0.0, 0.0))
        cell = int(np.argmax(gain / np.maximum(plan.cost, 1e-300)))
        if gain[cell] <= 0.0:
            return lost
        plan.cut(cell)


def _swap(plan: _Plan, barred: dict[int, int], move: int, progress: Progress) -> float:
    """Make the best swap that is not barred; the loss then, inf if there is none."""
    cells = plan.cells()
    cells = cells[[barred.get(int(cell), -1) < move for cell in cells]]
    damage = plan.damage(cells, part(progress, 0.0, 0.1))
    saving = damage / np.maximum(plan.cost[cells], 1e-300)
    best = (np.inf, -1, -1)
    tried = cells[np.argsort(saving, kind="stable")[:_TRIES]]
    for i, cell in enumerate(tried.tolist()):
        plan.leave(cell)
        gain, lost = plan.gains(part(progress, 0.1 + 0.9 * i / _TRIES, 0.1 + 0.9 * (i + 1) / _TRIES))
        gain[cell] = -1.0
        gain[[other for other, until in barred.items() if until >= move]] = -1.0
        other = int(np.argmax(gain))
        if gain[other] > 0.0 and lost - gain[other] < best[0]:
            best = (lost - float(gain[other]), cell, other)
        plan.cut(cell)
    if best[1] >= 0:
        plan.leave(best[1])
        plan.cut(best[2])
        barred[best[1]] = barred[best[2]] = move + _TENURE
        return min(best[0], _fill(plan, progress))
    return best[0]
