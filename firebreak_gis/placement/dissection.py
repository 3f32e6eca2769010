"""Cut a landscape into compartments by nested minimum vertex cuts.

A compartment is split where a wall saves most expected loss for its cost; expected loss is the chance that a fire
starts in the compartment times the value in it, as if a fire that starts burnt all of it. The pieces are split in
turn, which gives a tree of walls. Each wall is a minimum cut between two opposite ends, found in several directions
and for ends of several sizes.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.flow import UNCUTTABLE, best_cut, patch_links, pieces_after, thin
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.edges import links, mean_lit
from firebreak_gis.placement.widening import wall_cost
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Compartments with more cells are searched in one direction a piece of work, so that all threads are busy.
_LARGE = 20_000
#: Cells in a piece of work of small compartments.
_BATCH = 20_000
#: Largest sum of whole-number costs, so that no flow overflows.
_COST_RANGE = 2**29
#: Costs of which the least is so many steps, and the largest at most so many times the least, stay as they are.
_STEPS, _FEW = 2, 256
#: Steps of the median cost of a cell where breaks leak. With 8 in place of 1000 walls are found 2.7 times as fast; on
#: the sample at 60 m plans of three widths then burn 19 % less to 2 % more.
_LEAK_STEPS = 8
#: What a mean cell costs more for its leak; on Rhodes at 40 m this burns 3 to 4 % less, 1 as much, 3 more.
_LEAK_WEIGHT = 0.3


@dataclass(frozen=True)
class Cut:
    """One wall of the tree.

    Parameters
    ----------
    cells
        (n,) int64 row-major numbers of the cells of the wall, along it.
    cost
        Cost of cutting them, in the unit of the stakes.
    saved
        Expected loss that the wall saves once its parents stand, as a share of (ignition mass x value mass) of the
        whole landscape.
    parent
        Position in the list of the wall that must stand before, -1 for none.
    compartment
        (m,) int64 cells of the compartment that is split, the wall included.
    """

    cells: np.ndarray
    cost: float
    saved: float
    parent: int
    compartment: np.ndarray


@dataclass(frozen=True)
class _Patches:
    """What does not change while the landscape is split; planes are flat."""

    shape: tuple[int, int]
    links: np.ndarray
    capacity: np.ndarray
    cost: np.ndarray
    ignition: np.ndarray
    value: np.ndarray
    directions: int
    shares: np.ndarray
    periodic: bool

    def near(self, cells: np.ndarray) -> np.ndarray:
        return patch_links(cells, self.links, *self.shape, np.array(ROW_STEP), np.array(COL_STEP))  # type: ignore[no-any-return]

    def orders(self, cells: np.ndarray, directions: Sequence[int]) -> np.ndarray:
        """Cells sorted along each direction, (n_directions, n)."""
        angles = np.pi * np.asarray(directions)[:, None] / self.directions
        return ordered(cells, self.shape, angles, periodic=self.periodic)

    def cut(self, cells: np.ndarray, directions: Sequence[int]) -> tuple[float, np.ndarray]:
        """Score and mask of the best wall over the directions."""
        mask = np.zeros(cells.size, np.uint8)
        near = self.near(cells)
        score, _ = best_cut(
            near,
            self.capacity[cells],
            self.ignition[cells],
            self.value[cells],
            self.orders(cells, directions),
            self.shares,
            mask,
        )
        thin(near, mask)
        return score, mask

    def loss(self, cells: np.ndarray) -> float:
        return float(self.ignition[cells].sum() * self.value[cells].sum())


def ordered(cells: np.ndarray, shape: tuple[int, int], angles: np.ndarray, *, periodic: bool = False) -> np.ndarray:
    """Positions of cells sorted along each of some directions, (n_directions, n) int64.

    Parameters
    ----------
    cells
        (n,) row-major numbers.
    shape
        (rows, cols).
    angles
        (n_directions, 1), from east to south.
    periodic
        Whether the grid is a torus.
    """
    row, col = np.divmod(cells, shape[1])
    if periodic and (_spans(row, shape[0]) or _spans(col, shape[1])):
        # On a torus a patch has no ends: from one side of the ring to the other.
        row, col = (np.cos(2.0 * np.pi * place / size + angles) for place, size in ((row, shape[0]), (col, shape[1])))
    # Rounded, so that cells in line tie whatever the arithmetic; ties go by number.
    along = np.round(np.sin(angles) * row + np.cos(angles) * col, 6)
    return np.argsort(along, axis=1, kind="stable")


def _spans(places: np.ndarray, size: int) -> bool:
    """Whether places along an axis reach both of its ends."""
    return bool(places.size and places.min() == 0 and places.max() == size - 1)


def capacities(network: SpreadNetwork, stakes: Stakes, width: int = 1, *, leaky: bool = False) -> np.ndarray:
    """Whole-number cutting costs for the flow, (rows, cols) int32; `UNCUTTABLE` where protected.

    A cell counts its cost times its difficulty. With a width a cell also counts its share of the wall around it.
    Where breaks leak, costs grow with the chance that a fire takes `width` steps into cells like this one.

    Equal costs become 1 and small multiples of the least whole numbers, since small capacities are cut fast; so do
    these with the leak on top, in eighths of the median. Others keep the resolution that the sum of all allows, at most
    a thousandth of the median.
    """
    own = np.where(stakes.protected, 0.0, stakes.cost * stakes.difficulty)
    plain = _few_steps(own[own > 0], least=1.0)
    if leaky:
        passed = mean_lit(network) ** width
        own = own * (1.0 + _LEAK_WEIGHT * passed / max(float(passed[network.burnable].mean()), 1e-300))
    cost = np.where(network.burnable & ~stakes.protected, wall_cost(own, width, network.boundary), 0.0)
    positive = cost[cost > 0]
    scale = 1.0
    if positive.size:
        scale = 1.0 / positive[0]
        if leaky and plain:
            scale = _LEAK_STEPS / float(np.median(positive))
        elif _few_steps(positive):
            scale = _STEPS / float(positive.min())
        elif positive.min() < positive.max():
            scale = min(1000.0 / float(np.median(positive)), _COST_RANGE / float(positive.sum()))
    whole = np.where(cost > 0, np.maximum(np.rint(cost * scale), 1.0), 0.0).astype(np.int32)
    whole[stakes.protected] = UNCUTTABLE
    return whole


def _few_steps(costs: np.ndarray, *, least: float = np.nextafter(1.0, 2.0)) -> bool:
    """Whether the largest of the costs is `least` to `_FEW` times the least, and all are multiples of a step of it."""
    if not costs.size:
        return False
    ratio = costs * (_STEPS / costs.min())
    return bool(least <= ratio.max() / _STEPS <= _FEW and np.abs(ratio - np.rint(ratio)).max() < 1e-9)


def dissect(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    width: int = 1,
    leaky: bool = False,
    directions: int = 8,
    shares: Sequence[float] = (0.2, 0.25, 0.3, 0.35, 0.4, 0.45),
    smallest: int = 16,
    threads: int | None = None,
    progress: Progress,
) -> list[Cut]:
    """Split the landscape until compartments hold fewer than `smallest` cells or cannot be split.

    Parameters
    ----------
    network, stakes
        What is planned for. Protected cells are in no wall; cells without fuel cost nothing.
    width
        Cells across a wall, see `widening`; the walls returned are lines one cell wide.
    leaky
        Whether treated cells still burn; walls then keep to fuel that is hard to light.
    directions
        Directions searched for each wall, evenly spaced over half a turn.
    shares
        Shares of the compartment (mean of ignition and value mass) that the opposite ends hold, rising, below .5.
    smallest
        Compartments of fewer cells are left whole.
    threads
        Threads to use; changes the speed only.
    progress
        Callback (share done, message).

    Returns
    -------
    list of Cut
        Parents before children.

    Notes
    -----
    Cost: about n ** 1.35, 8 s for 172,000 cells on two cores; memory about 200 B a cell and thread.
    """
    ignition, value = stakes.ignition.ravel(), stakes.value.ravel()
    patches = _Patches(
        network.shape,
        links(network).ravel(),
        capacities(network, stakes, width, leaky=leaky).ravel(),
        stakes.cost.ravel(),
        ignition / max(ignition.sum(), 1e-300),
        value / max(value.sum(), 1e-300),
        directions,
        np.asarray(shares),
        network.boundary == "periodic",
    )
    fuel = np.flatnonzero(network.burnable.ravel())
    waiting = [(cells, -1) for cells in pieces_of(fuel, patches.near(fuel))]
    cuts: list[Cut] = []
    left = total = work_of(fuel.size, smallest)
    while waiting:
        waiting = [(cells, parent) for cells, parent in waiting if cells.size >= smallest]
        share = 1.0 - left / max(total, 1.0)
        left = sum(work_of(cells.size / 2, smallest) for cells, _ in waiting)
        masks = best_walls(
            [cells for cells, _ in waiting],
            patches.cut,
            directions,
            threads=threads,
            progress=_scaled(progress, share, 1.0 - left / max(total, 1.0), f"{len(cuts)} walls"),
        )
        children = []
        for (cells, parent), mask in zip(waiting, masks, strict=True):
            if mask.any():
                pieces = pieces_of(cells, patches.near(cells), mask)
                wall = along(cells[mask > 0], network.shape)
                saved = patches.loss(cells) - sum(patches.loss(piece) for piece in pieces)
                children += [(piece, len(cuts)) for piece in pieces]
                cuts.append(Cut(wall, float(patches.cost[wall].sum()), saved, parent, cells))
        waiting = children
    progress(1.0, f"{len(cuts)} walls")
    return cuts


def _scaled(progress: Progress, start: float, stop: float, message: str) -> Progress:
    def report(fraction: float, text: str) -> None:  # noqa: ARG001
        progress(start + (stop - start) * fraction, message)

    return report


def work_of(n_cells: float, smallest: int) -> float:
    """Rough work of splitting a compartment all the way down."""
    return n_cells**1.35 if n_cells >= smallest else 0.0


def pieces_of(cells: np.ndarray, near: np.ndarray, cut: np.ndarray | None = None) -> list[np.ndarray]:
    """Cells of the connected pieces of a patch that a wall leaves, in the order of their first cells.

    Parameters
    ----------
    cells, near
        The patch, and its links as `kernels.flow.patch_links` returns them.
    cut
        (n,) uint8, 1 in the cells of the wall; None: none.
    """
    label = pieces_after(near, np.zeros(cells.size, np.uint8) if cut is None else cut)
    order = np.argsort(label, kind="stable")
    order = order[label[order] >= 0]
    if order.size == 0:
        return []
    return np.split(cells[order], np.flatnonzero(np.diff(label[order])) + 1)


def batches(compartments: Sequence[np.ndarray]) -> list[list[int]]:
    """Positions of compartments by pieces of work, the largest first: large ones alone, small ones together."""
    found: list[list[int]] = []
    batch: list[int] = []
    filled = 0
    for i in sorted(range(len(compartments)), key=lambda i: -compartments[i].size):
        if compartments[i].size > _LARGE:
            found.append([i])
            continue
        batch.append(i)
        filled += compartments[i].size
        if filled >= _BATCH:
            found.append(batch)
            batch, filled = [], 0
    return [*found, batch] if batch else found


def best_walls(
    compartments: Sequence[np.ndarray],
    cut: Callable[[np.ndarray, Sequence[int]], tuple[float, np.ndarray]],
    directions: int,
    *,
    threads: int | None,
    progress: Progress,
    message: str = "",
) -> list[np.ndarray]:
    """The best wall of every compartment, as `cut` marks it.

    Parameters
    ----------
    compartments
        Cells of each.
    cut
        Returns the score and the mark of the best wall of some cells over some directions.
    directions
        How many there are; of equal walls that of the first counts.
    """
    every = range(directions)
    tasks: list[list[tuple[int, Sequence[int]]]] = []
    for batch in batches(compartments):
        if compartments[batch[0]].size > _LARGE:
            tasks += [[(batch[0], [k])] for k in every]
        else:
            tasks.append([(i, every) for i in batch])
    found: dict[tuple[int, int], tuple[float, np.ndarray]] = {}

    def work(task: list[tuple[int, Sequence[int]]]) -> None:
        for i, chosen in task:
            found[i, chosen[0]] = cut(compartments[i], chosen)

    run_pieces(work, tasks, threads=threads, progress=progress, message=message)
    best = []
    for i in range(len(compartments)):
        options = [found[i, k] for k in every if (i, k) in found]
        best.append(max(options, key=lambda option: option[0])[1])  # the first of equals
    return best


def along(cells: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """Cells of a line sorted along the axis in which it extends most."""
    row, col = np.divmod(cells, shape[1])
    if cells.size and np.ptp(row) >= np.ptp(col):
        return cells[np.lexsort((col, row))]
    return cells[np.lexsort((row, col))]


def sequence(saved: Sequence[float], cost: Sequence[float], parent: Sequence[int]) -> list[int]:
    """Order of constructing walls, parents first, that saves most at every budget.

    Walls are joined with those that they make possible as long as that raises what the group saves for its cost, and
    groups are built by falling ratio; no order that respects the tree saves more at the end of any group.
    Source: Horn 1972, doi 10.1137/0123021.

    Parameters
    ----------
    saved, cost, parent
        Of every wall; parents come before children, -1 for none.

    Returns
    -------
    list of int
        Positions of the walls.
    """
    n = len(saved)
    children: list[list[int]] = [[] for _ in range(n)]
    groups: list[list[tuple[float, int, float, float, list[int]]]] = [[] for _ in range(n)]
    roots: list[tuple[float, int, float, float, list[int]]] = []
    for i in range(n):
        if parent[i] >= 0:
            children[parent[i]].append(i)
    for i in range(n - 1, -1, -1):
        heap: list[tuple[float, int, float, float, list[int]]] = []
        for child in children[i]:
            if len(groups[child]) > len(heap):
                heap, groups[child] = groups[child], heap
            for group in groups[child]:
                heapq.heappush(heap, group)
            groups[child] = []
        gain, price, members = saved[i], cost[i], [i]
        while heap and heap[0][2] * price > gain * heap[0][3]:
            group = heapq.heappop(heap)
            gain, price, members = gain + group[2], price + group[3], members + group[4]
        heapq.heappush(heap, (-gain / price if price > 0 else -np.inf, i, gain, price, members))
        groups[i] = heap
        if parent[i] < 0:
            roots += heap
    return [i for group in sorted(roots) for i in group[4]]


def lines_first(lines: Sequence[np.ndarray], stakes: Stakes, score: np.ndarray) -> np.ndarray:
    """Priority that cuts the cells of `lines` in their order, then all others by falling `score`.

    Parameters
    ----------
    lines
        Row-major cell numbers; a cell counts where it comes first.
    stakes
        Gives the protected cells, which get -inf.
    score
        (rows, cols) rank of all other cells.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.
    """
    flat = score.ravel().astype(np.float64)
    cells = np.concatenate([*lines, np.zeros(0, np.int64)]).astype(np.int64)
    _, first = np.unique(cells, return_index=True)
    cells = cells[np.sort(first)]
    _, rank = np.unique(flat, return_inverse=True)
    priority = rank.astype(np.float64)
    priority[cells] = rank.max(initial=0) + np.arange(cells.size, 0, -1.0)
    priority[stakes.protected.ravel()] = -np.inf
    return priority.reshape(score.shape)
