"""Walls for breaks that fail: how wide, and where wider, tried out on fires with a clock.

How wide walls should be depends on how long fires burn and on how breaks fail: leaks cell by cell want wide walls, the
more so the longer fires last; failing stretches want many thin ones. So walls of one to several cells are laid for the
same money and burnt. Where breaks leak, thin walls are laid as well, and widened where most is lost by way of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.kernels.keys import distinct
from firebreak_gis.placement.choosing import Choice, all_hold
from firebreak_gis.placement.parts import parts_of
from firebreak_gis.placement.widening import around, wall_costs, walls
from firebreak_gis.progress import part
from firebreak_gis.simulation.holding import stretches

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.holding import Hold
    from firebreak_gis.stakes import Stakes

#: Rounds in which walls are widened, or laid, where most passes.
_ROUNDS = 6
#: Shares of the even width's length of wall that are laid thin, before they are widened.
_LENGTHS = (1.0, 0.8)
#: Times the money that the walls cost of which those are laid first by which most passes.
_MORE = 1.5


class Layout(NamedTuple):
    """Walls in their order of building.

    Parameters
    ----------
    told
        What they are, in words.
    cells
        Row-major cells of each wall or part of one, in turn.
    width
        Cells across the narrowest.
    """

    told: str
    cells: list[np.ndarray]
    width: int = 1

    def cut(self, stakes: Stakes, money: float) -> np.ndarray:
        """Cells that the money buys, (rows, cols) bool."""
        cells = np.concatenate([*self.cells, np.zeros(0, np.int64)]).astype(np.int64)
        paid = np.cumsum(stakes.cost.ravel()[cells]) <= money * (1 + 1e-12)
        bought = np.zeros(stakes.cost.shape, bool)
        bought.ravel()[cells[paid]] = True
        return bought


def best_layout(
    network: SpreadNetwork,
    stakes: Stakes,
    trial: Trial,
    lines: Callable[[int, Callable[[list[np.ndarray]], np.ndarray] | None], list[np.ndarray]],
    *,
    money: float,
    narrowest: int = 1,
    widest: int = 6,
    progress: Progress,
) -> Layout:
    """Find the layout that loses least value in fires with a clock.

    Parameters
    ----------
    network, stakes
        What is planned for.
    trial
        The fires.
    lines
        Told a width, and what tells how often all cells of each wall hold (None: always), returns the walls one cell
        wide in the order of building that suits it.
    money
        What the plan may cost, the unit of `stakes.cost`.
    narrowest, widest
        Widths of even walls that are tried, from the narrowest up until two in a row are worse than the best.
    progress
        Callback (share done, message).
    """

    @lru_cache(maxsize=2)  # one of them is laid before its turn
    def even(width: int) -> Layout:
        told = f"walls of {width} cell{'s' if width > 1 else ''}"
        return Layout(told, walls(lines(width, None), network, stakes, width)[0], width)

    def even_walls() -> Iterator[Layout]:
        for width in range(narrowest, max(widest, narrowest) + 1):
            layout = even(width)
            progress(0.05 * width, f"trying {layout.told}")
            yield layout

    leaks = trial.fires.residual > 0.0
    # Thin walls that leak save little, so what burns beside them would allow few fires.
    like = even(narrowest + 1) if leaks else None
    choice: Choice[Layout] = Choice(trial, network.n_burnable, lambda layout: layout.cut(stakes, money), like)

    best = choice.rising(even_walls()).width
    # Of each round half as many as of a comparison: a part is met by those of all rounds.
    about: dict[str, Any] = {"money": money, "n_runs": max(choice.n_runs // 2, 1)}
    if leaks:
        for k, share in enumerate(_LENGTHS):
            step = part(progress, 0.4 + 0.2 * k, 0.6 + 0.2 * k, "widening: ")
            length = share / best if best > 1 else 0.8 * share
            thin = lines(best, None)
            choice.attempt(
                reinforced(network, stakes, trial, thin, length=length, narrowest=narrowest, **about, progress=step)
            )
    elif not trial.fires.holding.perfect:
        step = part(progress, 0.4, 0.8, "laying: ")
        pool = lines(best, closing(network, trial.fires.holding))
        choice.attempt(most_passed(network, stakes, trial, pool, width=best, **about, progress=step))
    chosen = choice.chosen()
    progress(1.0, f"chosen: {chosen.told}")
    return chosen


def closing(network: SpreadNetwork, hold: Hold) -> Callable[[list[np.ndarray]], np.ndarray]:
    """Tell how often all stretches of each wall hold, from their row-major cells, as a share of what one does."""
    block = stretches(network.shape, network.grid.cell_size, hold.length).ravel()
    fuel = network.burnable.ravel()
    n_blocks = int(block.max(initial=0)) + 1

    def chance(lines: list[np.ndarray]) -> np.ndarray:
        cells = np.concatenate([*lines, np.zeros(0, np.int64)]).astype(np.int64)
        line = np.repeat(np.arange(len(lines)), [each.size for each in lines])
        crossed = distinct((line * n_blocks + block[cells])[fuel[cells]])
        counts = np.bincount(crossed // n_blocks, minlength=len(lines))
        return np.array([all_hold(hold, each) for each in range(int(counts.max(initial=0)) + 1)])[counts]

    return chance


def reinforced(
    network: SpreadNetwork,
    stakes: Stakes,
    trial: Trial,
    lines: Sequence[np.ndarray],
    *,
    length: float,
    narrowest: int = 1,
    widest: int = 6,
    money: float,
    n_runs: int,
    progress: Progress,
) -> Layout:
    """Lay thin walls for a share of the money, and widen them, part by part, where most value is lost by way of them.

    Parameters
    ----------
    network, stakes, trial, money
        As in `best_layout`.
    lines
        Walls one cell wide, those that are built first at first.
    length
        Share of the money that thin walls take.
    narrowest, widest
        Cells across a part at least, and at most.
    n_runs
        Fires of each round; every round has others.
    progress
        Callback (share done, message).
    """
    cost = np.maximum(stakes.cost.ravel(), 1e-300)
    cells, costs = _parts(lines, network, stakes, trial, narrowest, length * money * narrowest)
    free = (network.burnable & ~stakes.protected).ravel().copy()
    numbers = np.full(free.size, len(cells), np.int32)
    for k, each in enumerate(cells):
        free[each], numbers[each] = False, k
    layers = [[each] for each in cells]
    width = np.full(len(cells), narrowest)
    spent = float(costs.sum())
    for k in range(_ROUNDS):
        step = part(progress, k / _ROUNDS, (k + 1) / _ROUNDS)
        passed = trial.passing(
            numbers.reshape(network.shape) < len(cells), n_runs=n_runs, first_run=k * n_runs, progress=step
        )
        leaking = np.bincount(numbers, weights=passed.ravel(), minlength=len(cells) + 1)[:-1]
        following = [
            around(each[0], network.shape, int(w) + 1, network.boundary) for each, w in zip(layers, width, strict=True)
        ]
        following = [each[free[each]] for each in following]
        price = np.array([cost[each].sum() for each in following])
        goal = spent + (money - spent) / (_ROUNDS - k)
        for i in np.argsort(-leaking / np.maximum(price, 1e-300), kind="stable"):
            if spent >= goal:
                break
            if width[i] < widest:
                more = following[i][free[following[i]]]
                free[more], numbers[more] = False, i
                layers[i].append(more)
                width[i] += 1
                spent += float(cost[more].sum())
    told = (
        f"walls of {width.min()} to {width.max()} cells, widened where most fire passes" if len(cells) else "no walls"
    )
    rest = walls(lines, network, stakes, narrowest)[0]
    return Layout(told, _once([np.concatenate(each) for each in layers] + rest))


def most_passed(
    network: SpreadNetwork,
    stakes: Stakes,
    trial: Trial,
    lines: Sequence[np.ndarray],
    *,
    width: int,
    money: float,
    n_runs: int,
    progress: Progress,
) -> Layout:
    """Of more walls than the money pays lay those parts first by way of which most value is lost for their cost.

    Parameters as in `reinforced`.
    """
    cells, costs = _parts(lines, network, stakes, trial, width, _MORE * money)
    numbers = np.full(network.burnable.size, len(cells), np.int32)
    for k, each in enumerate(cells):
        numbers[each] = k
    built: list[int] = []
    cut = np.zeros(network.shape, bool)
    spent = 0.0
    waiting = np.ones(len(cells), bool)
    for k in range(_ROUNDS):
        step = part(progress, k / _ROUNDS, (k + 1) / _ROUNDS)
        passed = trial.passing(cut, n_runs=n_runs, first_run=k * n_runs, progress=step)
        score = np.bincount(numbers, weights=passed.ravel(), minlength=len(cells) + 1)[:-1] / np.maximum(costs, 1e-300)
        for i in np.argsort(-score, kind="stable"):
            if spent >= money * (k + 1) / _ROUNDS:
                break
            if waiting[i]:
                waiting[i] = False
                built.append(int(i))
                spent += float(costs[i])
                cut.ravel()[cells[i]] = True
    rest = walls(lines, network, stakes, width)[0]
    told = f"parts of walls of {width} cell{'s' if width > 1 else ''}, those first by which most fire passes"
    return Layout(told, _once([cells[i] for i in built] + rest))


def _parts(
    lines: Sequence[np.ndarray], network: SpreadNetwork, stakes: Stakes, trial: Trial, width: int, money: float
) -> tuple[list[np.ndarray], np.ndarray]:
    """Parts of the walls that a sum of money pays."""
    costs = wall_costs(lines, network, stakes, width)
    count = int(np.searchsorted(np.cumsum(costs), money, side="right")) + 1
    block = stretches(network.shape, network.grid.cell_size, trial.fires.holding.length)
    return parts_of(lines[:count], network, stakes, width=width, stretch=block)


def _once(groups: Sequence[np.ndarray]) -> list[np.ndarray]:
    """The same groups, each cell where it comes first."""
    if not groups:
        return []
    cells = np.concatenate(groups)
    _, first = np.unique(cells, return_index=True)
    new = np.zeros(cells.size, bool)
    new[first] = True
    return [
        each[kept] for each, kept in zip(groups, np.split(new, np.cumsum([g.size for g in groups])[:-1]), strict=True)
    ]
