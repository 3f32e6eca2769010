"""Improve a plan on simulated fires: drop cells that do little, put others in, swap, widen."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.breaks import select_breaks
from firebreak_gis.kernels.gains import dominated, downstream, reopened
from firebreak_gis.placement.dissection import lines_first
from firebreak_gis.placement.fires import Fires, burn_pieces, design_fires, losses, pieces
from firebreak_gis.placement.gains import mean_gain
from firebreak_gis.progress import part

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.gains import Kernel
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Share of the cut cells that the first moves exchange at once.
_FIRST = 1 / 8
#: Steps in which a batch is put in again; gains are found anew before each.
_STEPS = 4
#: Cells of a batch lie farther apart than this, so that what one does hardly depends on the others.
_APART = 2
#: A cell that does more than this many times an even share of all value is not followed further.
_FOLLOWED = 8.0
#: Cut cells that are tried in a swap, those that do least first.
_TRIES = 8
#: Swaps for which a cell that came or went stays as it is.
_TENURE = 7
#: Swaps without a better plan after which the best plan is disturbed.
_PATIENCE = 10
#: Cells that are left at most when the plan is disturbed.
_MOST = 16
#: How often a few fires alone decide at first what is cut then.
_FEW_FIRES = 2 / 3


class _CutSet:
    """A set of cut cells on fixed fires; what each change does, in units of value."""

    def __init__(
        self,
        network: SpreadNetwork,
        stakes: Stakes,
        free: np.ndarray,
        cut: np.ndarray,
        fires: Fires,
        price: np.ndarray,
        limit: float,
        threads: int | None,
    ) -> None:
        self.shape, self.fires, self.threads = network.shape, fires, threads
        self.free = free.ravel()
        self.price, self.limit = np.maximum(price.ravel(), 1e-12 * max(limit, 1e-288)), limit * (1 + 1e-12)
        self.value = stakes.value.ravel()
        self.alive = network.burnable.ravel() & ~cut.ravel()

    @property
    def cells(self) -> np.ndarray:
        """Cells that are cut."""
        return np.flatnonzero(self.free & ~self.alive)

    @property
    def left(self) -> float:
        """Money left."""
        return self.limit - float(self.price[self.cells].sum())

    def gains(self, progress: Progress, kernel: Kernel = dominated) -> tuple[np.ndarray, float]:
        """Gain of cutting each cell that may be cut and paid, -1 for others; and the loss as it is."""
        gain, lost = mean_gain(kernel, self.fires, self.alive, self.value, threads=self.threads, progress=progress)
        return np.where(self.free & self.alive & (self.price <= self.left), gain, -1.0), lost

    def least(self, progress: Progress) -> np.ndarray:
        """Cells that are cut, those first whose leaving costs least for the money that it gives back."""
        n_runs = self.fires.keys.size
        parts = pieces(n_runs)
        sums = np.zeros((len(parts), self.alive.size))
        cells = self.cells
        # Of many cells only the least count, so what does much need not be followed to its end.
        enough = float(self.value.sum()) * n_runs / len(parts) * min(_FOLLOWED / max(cells.size, 1), 1.0)

        def work(i: int) -> None:
            reopened(
                self.fires.limits,
                self.fires.leaks,
                self.fires.keys,
                self.fires.grid_steps,
                self.fires.cells,
                self.alive,
                self.value,
                *parts[i],
                enough,
                sums[i],
            )

        burn_pieces(work, n_runs, self.alive.size, threads=self.threads, progress=progress)
        return cells[np.argsort(sums.sum(axis=0)[cells] / self.price[cells], kind="stable")]

    def spend(self, count: int, progress: Progress, kernel: Kernel = dominated) -> float:
        """Spend money left where it saves most, up to `count` cells before gains are found anew; the loss then."""
        while True:
            gain, lost = self.gains(progress, kernel)
            gaining = np.flatnonzero(gain > 0.0)
            ranked = gaining[np.argsort(-gain[gaining] / self.price[gaining], kind="stable")]
            chosen = self.apart(ranked, count)
            chosen = chosen[np.cumsum(self.price[chosen]) <= self.left]
            if chosen.size == 0:
                return lost
            self.alive[chosen] = False

    def apart(self, ranked: np.ndarray, count: int) -> np.ndarray:
        """The first `count` cells of a ranking of which no two are close together."""
        if count == 1:
            return ranked[:1]
        near = np.zeros(self.shape, bool)
        chosen: list[int] = []
        for cell in ranked.tolist():
            row, col = divmod(cell, self.shape[1])
            if not near[row, col]:
                near[max(row - _APART, 0) : row + _APART + 1, max(col - _APART, 0) : col + _APART + 1] = True
                chosen.append(cell)
                if len(chosen) == count:
                    break
        return np.array(chosen, np.int64)


def refine(
    network: SpreadNetwork,
    stakes: Stakes,
    priority: np.ndarray | xr.DataArray,
    *,
    budget: Budget,
    residual: float = 0.0,
    moves: int = 200,
    n_runs: int = 200,
    seed: int = 0,
    fires: Fires | None = None,
    threads: int | None = None,
    progress: Progress,
) -> np.ndarray:
    """Improve the plan of one budget by local search on common fires.

    Money left over buys the cells of the largest gain. Then many cells at once that do least are left, and the cells
    of the largest exact gain are cut instead, next to a wall (which widens it) or anywhere; the move stands if less is
    lost, else fewer cells are tried. Last, single cells are swapped, the best such swap even if it is worse (tabu
    search); where that finds nothing better, some cells are left and others cut anew. The best plan seen counts. It
    is returned only if it loses less on other fires as well.

    Parameters
    ----------
    network, stakes
        What is planned for.
    priority
        (rows, cols) of any ranking; cells at -inf are not cut.
    budget
        Of the plan.
    residual
        Share of its spread probability that an edge into a treated cell keeps.
    moves
        Number of moves; small plans gain from more.
    n_runs, seed
        Fires of the design, which take `seed` as does the search; judge the plan on others.
    fires
        Improve on these fires, drawn for the same residual, without a check on others.
    threads
        Threads to use; changes the speed only.
    progress
        Callback (share done, message).

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64: first the cells of the improved plan in their old order, then the others. It is nested,
        but improved for this budget only.

    Raises
    ------
    ParameterError
        If the budget is impossible.

    Notes
    -----
    Walls of minimum cuts are already best cell by cell: on large landscapes with perfect breaks their plan comes
    back unchanged. Cost: about ten times 100 ns a burnt cell, fire and move, and what leaving a cell burns.
    """
    plane = np.where(stakes.protected | ~network.burnable, -np.inf, np.asarray(priority, dtype=np.float64))
    before = np.asarray(
        select_breaks(
            network.grid.dataarray(plane, "priority"),
            budget=budget,
            burnable=network.burnable,
            cost=stakes.cost,
        )
    )
    if not before.any():
        return plane
    price = stakes.cost if budget.unit == "cost" else network.burnable.astype(np.float64)
    limit = budget.amount if budget.unit == "cost" else float(np.count_nonzero(before))
    design = fires or design_fires(network, stakes, n_runs=n_runs, seed=seed, residual=residual)
    plan = _CutSet(network, stakes, plane > -np.inf, before, design, price, limit, threads)
    cells = _search(plan, moves, seed, part(progress, 0.0, 0.9))
    after = np.zeros(network.shape, bool)
    after.ravel()[cells] = True
    if fires is None:
        check = design_fires(network, stakes, n_runs=n_runs, seed=seed, residual=residual, purpose="check")
        old, new = (
            losses(network, stakes, cut, check, residual=residual, threads=threads, progress=part(progress, 0.9, 1.0))
            for cut in (before > 0, after)
        )
        if new.sum() >= old.sum():
            progress(1.0, "plan left as it is")
            return plane
    progress(1.0, "plan refined")
    refined = lines_first([cells[np.argsort(-plane.ravel()[cells], kind="stable")]], stakes, plane)
    return np.where(plane > -np.inf, refined, -np.inf)


def _search(plan: _CutSet, moves: int, seed: int, progress: Progress) -> np.ndarray:
    """Cells of the best plan found."""
    size = max(int(_FIRST * plan.cells.size), 1)
    lost = plan.spend(-(-size // _STEPS), part(progress, 0.0, 0.0))
    best = (lost, plan.alive.copy())
    barred: dict[int, int] = {}
    random = np.random.default_rng(seed)
    last = 0
    for move in range(moves):
        step = part(progress, move / moves, (move + 1) / moves, f"move {move + 1}: ")
        if size > 1:
            lost = _exchange(plan, size, step)
        elif move - last <= _PATIENCE:
            lost = _swap(plan, barred, move, step)
        else:
            plan.alive[:] = best[1]
            lost, last, barred = _disturb(plan, random, step), move, {}
        if lost < best[0] * (1 - 1e-12):
            best, last = (lost, plan.alive.copy()), move
        elif size > 1:
            plan.alive[:] = best[1]
            size, last = size // 2, move
        if best[0] == 0.0:
            break
    plan.alive[:] = best[1]
    return plan.cells


def _exchange(plan: _CutSet, size: int, progress: Progress) -> float:
    """Leave the cells that do least and spend the money anew; the loss then."""
    plan.alive[plan.apart(plan.least(part(progress, 0.0, 0.5)), size)] = True
    return plan.spend(-(-size // _STEPS), part(progress, 0.5, 0.5))


def _disturb(plan: _CutSet, random: np.random.Generator, progress: Progress) -> float:
    """Leave cells near each other, anywhere, or most of them, and spend the money by one of two scores; the loss then.

    Mostly a few of the fires alone decide at first: a plan that holds these in full is not found from one that holds
    each of all a little.
    """
    cells = plan.cells
    count = int(random.integers(2, min(max(cells.size // 2, 2), _MOST) + 1))
    order = random.permutation(cells)
    if random.random() < 0.5:
        row, col = np.divmod(cells, plan.shape[1])
        at = random.integers(cells.size)
        order = cells[np.argsort(np.hypot(row - row[at], col - col[at]), kind="stable")]
    if random.random() < 0.5:
        count = min(cells.size, _MOST) if random.random() < 0.5 else max(min(cells.size * 3 // 4, _MOST), 1)
    plan.alive[order[:count]] = True
    kernel = dominated if random.random() < 0.5 else downstream
    every = plan.fires
    if every.keys.size > 1 and random.random() < _FEW_FIRES:
        some = np.sort(random.permutation(every.keys.size)[: int(random.integers(1, every.keys.size))])
        plan.fires = replace(every, keys=every.keys[some], cells=every.cells[some])
        plan.spend(1, part(progress, 0.0, 0.0), kernel)
        plan.fires = every
    plan.spend(1, part(progress, 0.0, 0.0), kernel)
    return plan.spend(1, part(progress, 0.5, 0.5))


def _swap(plan: _CutSet, barred: dict[int, int], move: int, progress: Progress) -> float:
    """Make the best swap that is not barred; the loss then, inf if there is none."""
    ranked = plan.least(part(progress, 0.0, 0.1)).tolist()
    tried = [cell for cell in ranked if barred.get(cell, -1) < move][:_TRIES]
    best = (np.inf, -1, -1)
    for i, cell in enumerate(tried):
        plan.alive[cell] = True
        gain, lost = plan.gains(part(progress, 0.1 + 0.9 * i / _TRIES, 0.1 + 0.9 * (i + 1) / _TRIES))
        gain[cell] = -1.0
        gain[[other for other, until in barred.items() if until >= move]] = -1.0
        other = int(np.argmax(gain))
        if gain[other] > 0.0 and lost - gain[other] < best[0]:
            best = (lost - float(gain[other]), cell, other)
        plan.alive[cell] = False
    if best[1] < 0:
        return np.inf
    plan.alive[best[1]], plan.alive[best[2]] = True, False
    barred[best[1]] = barred[best[2]] = move + _TENURE
    return min(best[0], plan.spend(1, part(progress, 1.0, 1.0)))
