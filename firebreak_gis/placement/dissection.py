"""Cut a landscape into compartments by nested minimum vertex cuts.

A compartment is split where a wall saves most expected loss for its cost; expected loss is the chance that a fire
starts in the compartment times the value in it, as if a fire that starts burnt all of it. The pieces are split in
turn, which gives a tree of walls. Each wall is a minimum cut between two opposite ends, found in several directions
and for ends of several sizes, or weighed by what it saves where it lies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from threading import Lock
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.kernels.keys import distinct
from firebreak_gis.memory import BLOCK_CELLS
from firebreak_gis.placement.patches import COARSE_FROM, Patches, Walls
from firebreak_gis.placement.widening import STANDARD_CORNER
from firebreak_gis.progress import part, silent
from firebreak_gis.threads import run_growing, run_pieces

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.regions import Region
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Maps with more cells of fuel are parted into regions first.
REGIONS_FROM = BLOCK_CELLS
#: Compartments with more cells are a piece of work alone.
_LARGE = 20_000
#: Parts in which large planes are handled, for the memory of what comes and goes.
_PARTS = 16
#: Cells in a piece of work of small compartments.
_BATCH = 20_000


class Cut(NamedTuple):
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
    size
        Number of cells of the compartment that is split, the wall included.
    """

    cells: np.ndarray
    cost: float
    saved: float
    parent: int
    size: int


def dissect(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    width: int = 1,
    leaky: bool = False,
    directions: int = 8,
    shares: Sequence[float] = (0.2, 0.25, 0.3, 0.35, 0.4, 0.45),
    smallest: int = 16,
    coarse_from: int = COARSE_FROM,
    regions_from: int = REGIONS_FROM,
    sizes: np.ndarray | None = None,
    corner: tuple[int, int] = STANDARD_CORNER,
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
        Shares of the compartment (mean of ignition and value mass) that the opposite ends hold, rising, below .5; where
        walls are chains (see `patches`) the first alone counts.
    smallest
        Compartments of fewer cells are left whole.
    coarse_from
        Compartments of more cells are searched coarsely first, see `patches`.
    regions_from
        A map with more cells of fuel is parted into regions of at most so many first, see `regions`; one that is a
        torus is not.
    sizes
        (rows * cols,) set, in the cells of a compartment that is split, to its size; that of the smallest remains.
    corner
        As in `widening.wall_cost`, on a turned map.
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
    Cost: about n log n, 7 s of processor time for 935,000 cells; memory about 125 B a cell beside the network.
    """
    patches = Patches.of(
        network,
        stakes,
        width=width,
        leaky=leaky,
        directions=directions,
        shares=shares,
        coarse_from=coarse_from,
        corner=corner,
    )
    grown = _Tree(patches, network.shape, smallest, sizes)
    if by_regions(network, regions_from):
        return grown.by_regions(network.burnable, regions_from, threads, progress)
    grown.down(patches.connected(np.flatnonzero(network.burnable.ravel())), -1, threads, progress)
    progress(1.0, f"{len(grown.cuts)} walls")
    return grown.cuts


def by_regions(network: SpreadNetwork, regions_from: int = REGIONS_FROM) -> bool:
    """Whether a map is parted into regions first."""
    return network.boundary == "open" and network.n_burnable > regions_from


class _Tree:
    """The walls so far."""

    def __init__(self, patches: Patches, shape: tuple[int, int], smallest: int, sizes: np.ndarray | None) -> None:
        self.cuts: list[Cut] = []
        self._patches, self._shape, self._smallest = patches, shape, smallest
        self._sizes = np.zeros(patches.cost.size, np.int32) if sizes is None else sizes

    def down(self, compartments: Sequence[np.ndarray], parent: int, threads: int | None, progress: Progress) -> None:
        """Split connected compartments, which stand once a wall does, all the way down."""
        growth = _Growth(self._patches, self._smallest, self._sizes)
        run_growing(
            growth.split,
            growth.left_of(compartments, -1),
            size=_Left.work,
            threads=threads,
            progress=progress,
            message=lambda: f"{len(self.cuts) + growth.n_walls} walls",
        )
        first = len(self.cuts)
        self.cuts += [cut._replace(parent=parent if cut.parent < 0 else first + cut.parent) for cut in growth.cuts()]

    def by_regions(self, burnable: np.ndarray, largest: int, threads: int | None, progress: Progress) -> list[Cut]:
        """Part the map into regions, and split each all the way down by itself."""
        from firebreak_gis.placement.region_parts import Pieces, bare, unpacked
        from firebreak_gis.placement.regions import Regions
        from firebreak_gis.simulation.engine import in_use, spread

        progress(0.0, "regions")
        regions = Regions(self._patches, burnable, largest)
        waiting = [(region, -1) for region in regions]
        leaves: list[tuple[Region, int]] = []
        while waiting:
            region, parent = waiting.pop()
            split = regions.split(region) if region.size > largest else None
            if split is None:
                leaves.append((region, parent))
                continue
            wall, pieces = split
            waiting += [(piece, len(self.cuts)) for piece in pieces]
            saved = region.loss - sum(piece.loss for piece in pieces)
            self._add(wall, wall, saved, parent, region.size)
            progress(0.02, f"{len(self.cuts)} walls between regions")
        walled: list[list[Cut]] = [[] for _ in leaves]

        def begun(k: int) -> np.ndarray:
            region, parent = leaves[k]
            cells = regions.cells(region)
            if parent >= 0:
                self._sizes[cells] = self.cuts[parent].size
            return cells

        def work(k: int) -> None:
            walled[k] = walls_within(self._patches, begun(k), self._smallest, self._sizes, 1, silent)

        def take(i: int, made: Mapping[str, np.ndarray]) -> None:
            cells, split = begun(largest_first[i]), made["sizes"]
            self._sizes[cells] = np.where(split > 0, split, self._sizes[cells])
            walled[largest_first[i]] = [Cut(*each) for each in unpacked(made)]

        largest_first = sorted(range(len(leaves)), key=lambda k: -leaves[k][0].size)
        how: dict[str, Any] = {"threads": threads, "progress": part(progress, 0.05, 1.0), "message": "walls in regions"}
        if in_use() is None:
            run_pieces(work, largest_first, **how)
        else:
            shared = {"patches": bare(self._patches), "smallest": self._smallest}
            spread(split_region, Pieces(self._patches, begun, largest_first), shared, take=take, **how)
        for (_, parent), cuts in zip(leaves, walled, strict=True):
            above = len(self.cuts)
            self.cuts += [cut._replace(parent=parent if cut.parent < 0 else above + cut.parent) for cut in cuts]
        return self.cuts

    def _add(self, wall: np.ndarray, cells: np.ndarray, saved: float, parent: int, size: int) -> None:
        line = along(wall, self._shape)
        self._sizes[cells] = size
        self.cuts.append(Cut(line, float(self._patches.cost[line].sum()), saved, parent, size))


def walls_within(
    patches: Patches, cells: np.ndarray, smallest: int, sizes: np.ndarray, threads: int | None, progress: Progress
) -> list[Cut]:
    """Walls of a connected patch that is split all the way down; parameters as in `dissect`."""
    own = _Tree(patches, patches.shape, smallest, sizes)
    own.down([cells], -1, threads, progress)
    return own.cuts


def split_region(
    piece: Mapping[str, np.ndarray], *, patches: Patches, smallest: int, threads: int | None, progress: Progress
) -> dict[str, np.ndarray]:
    """Split a region, as `region_parts.Pieces` gives it, all the way down; returns what `region_parts.packed` does."""
    from firebreak_gis.placement.region_parts import packed, placed

    whole, sizes = placed(patches, piece)
    cuts = walls_within(whole, piece["cells"], smallest, sizes, threads, progress)
    return packed(((cut.cells, cut.cost, cut.saved, cut.parent, cut.size) for cut in cuts), sizes[piece["cells"]])


@dataclass(frozen=True, eq=False)
class _Left:
    """Compartments that are left to split: a large one once, small ones all the way down.

    Parameters
    ----------
    pieces
        Each with its place among those that the wall above leaves.
    above
        Number of that wall, -1 for none.
    """

    pieces: list[tuple[int, np.ndarray]]
    above: int

    def work(self) -> float:
        """Rough work that they are."""
        return float(sum(cells.size * np.log2(cells.size) for _, cells in self.pieces))


class _Growth:
    """The walls so far; threads add to them in any order.

    Parameters
    ----------
    patches, smallest, sizes
        As in `dissect`.
    """

    def __init__(self, patches: Patches, smallest: int, sizes: np.ndarray) -> None:
        self._patches, self._smallest, self._sizes = patches, smallest, sizes
        self._alone = min(patches.coarse_from, COARSE_FROM)
        self._lock = Lock()
        self._found: list[Walls] = []
        self.n_walls = 0

    def left_of(self, pieces: Sequence[np.ndarray], above: int) -> list[_Left]:
        """What is to be split of the pieces that a wall leaves."""
        found: list[_Left] = []
        batch: list[tuple[int, np.ndarray]] = []
        for k, cells in enumerate(pieces):
            if cells.size > self._alone:
                found.append(_Left([(k, cells)], above))
            elif cells.size >= self._smallest:
                batch.append((k, cells))
                if sum(each.size for _, each in batch) >= _BATCH:
                    found.append(_Left(batch, above))
                    batch = []
        return [*found, _Left(batch, above)] if batch else found

    def split(self, left: _Left) -> list[_Left]:
        """Split compartments; what is left to split of their pieces."""
        if left.pieces[0][1].size <= self._alone:
            for k, cells in left.pieces:
                self._add(self._patches.split_down(cells, self._smallest, self._sizes), left.above, k)
            return []
        ((k, cells),) = left.pieces
        split = self._patches.split(cells)
        if split is None:
            return []
        self._sizes[cells] = cells.size
        saved = self._patches.loss(cells) - sum(self._patches.loss(piece) for piece in split.pieces)
        wall = along(split.wall, self._patches.shape)
        one = Walls(wall, *(np.array([each]) for each in (wall.size, -1, 0, cells.size, saved)))
        return self.left_of(split.pieces, self._add(one, left.above, k))

    def _add(self, walls: Walls, above: int, place: int) -> int:
        """Keep walls of the `place`-th piece that wall `above` leaves; the number of the first."""
        with self._lock:
            start = self.n_walls
            self.n_walls += walls.size.size
            first = walls.parent < 0
            parent = np.where(first, above, walls.parent + start)
            self._found.append(walls._replace(parent=parent, sibling=np.where(first, place, walls.sibling)))
        return start

    def cuts(self) -> list[Cut]:
        """All walls, level by level: the first of all, those of their pieces, and so on."""
        if self.n_walls == 0:
            return []
        parent, sibling, size, saved = (np.concatenate(each) for each in list(zip(*self._found, strict=True))[2:])
        lines = [each.cells[start:stop] for each in self._found for start, stop in pairwise([0, *each.ends.tolist()])]
        order = _by_level(parent, sibling)
        position = np.empty(order.size, np.int64)
        position[order] = np.arange(order.size)
        above = np.where(parent < 0, -1, position[parent])
        return [
            Cut(lines[k], float(self._patches.cost[lines[k]].sum()), gain, up, cells)
            for k, gain, up, cells in zip(
                order.tolist(), saved[order].tolist(), above[order].tolist(), size[order].tolist(), strict=True
            )
        ]


def _by_level(parent: np.ndarray, sibling: np.ndarray) -> np.ndarray:
    """Numbers of walls level by level, within a level as their parents are ordered, then by their own place.

    Parameters
    ----------
    parent, sibling
        (n,) number of the parent, -1 for none, and place among its children.
    """
    children = np.argsort(parent, kind="stable")
    starts = np.searchsorted(parent[children], np.arange(-1, parent.size + 1))
    order = []
    level = np.array([-1])
    while level.size:
        first, last = starts[level + 1], starts[level + 2]
        rank = np.repeat(np.arange(level.size), last - first)
        level = children[np.arange(rank.size) + np.repeat(first - np.cumsum([0, *(last - first)[:-1]]), last - first)]
        level = level[np.lexsort((sibling[level], rank))]
        order.append(level)
    return np.concatenate(order)


def work_of(n_cells: float, smallest: int) -> float:
    """Rough work of splitting a compartment all the way down."""
    return n_cells**1.35 if n_cells >= smallest else 0.0


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
    from firebreak_gis.kernels.precedence import grouped

    given = (np.asarray(each, kind) for each, kind in ((saved, float), (cost, float), (parent, np.int64)))
    ratio, first, following = grouped(*given)
    starts = np.flatnonzero(first)
    following = following.tolist()
    order = []
    for wall in starts[np.argsort(ratio[starts], kind="stable")].tolist():
        while wall >= 0:
            order.append(wall)
            wall = following[wall]
    return order


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
    flat = score.ravel()
    cells = np.concatenate([*lines, np.zeros(0, np.int64)]).astype(np.int64, copy=False)
    _, first = np.unique(cells, return_index=True)
    cells = cells[np.sort(first)]
    values = distinct(flat)
    priority = np.empty(flat.size)
    for some, place in zip(*(np.array_split(plane, _PARTS) for plane in (flat, priority)), strict=True):
        place[:] = np.searchsorted(values, some)
    priority[cells] = max(values.size - 1, 0) + np.arange(cells.size, 0, -1.0)
    priority[stakes.protected.ravel()] = -np.inf
    return priority.reshape(score.shape)
