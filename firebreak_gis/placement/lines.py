"""Cut a landscape into compartments by nested minimum cuts of links: walls that are lines.

As in `placement.dissection`, but what is cut are the links between neighbouring cells, so a wall is a line that may be
narrower than a cell, and what it costs hardly depends on the direction of the lattice (`kernels.linkflow`). Each wall
is drawn (`kernels.drawing`) as the shortest line between the cells of its two sides, and then pulled straight where
that costs less. What counts is the drawn line: its length, its cost, and the links that it crosses. The wall of a large
compartment is sought in the directions alone that are best when its cells are joined to blocks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.kernels.coarse import blocks
from firebreak_gis.kernels.crossings import PARTS, cross_links
from firebreak_gis.kernels.drawing import channels, landings, lines_in, prices_of
from firebreak_gis.kernels.linkflow import MOST, best_link_cut, link_costs
from firebreak_gis.kernels.patches import patch_links
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.coarsening import coarse_price, factor_for
from firebreak_gis.placement.dissection import batches, work_of
from firebreak_gis.placement.edges import links
from firebreak_gis.placement.patches import ordered, pieces_of, sorted_along
from firebreak_gis.progress import part
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Costs of a link along an axis and across; where prices differ, of one of the median price.
_EQUAL, _DIFFERENT = (17.0, 12.0), (170.0, 120.0)
#: The walls of compartments of more cells are sought in so many directions alone, those that are best for the blocks:
#: on the sample and on Rhodes at 40 m in half the time, with 0.1 % more and 0.8 % more left of the expected loss.
_COARSE_FROM, _TRIED = 1024, 2
#: Gates of a channel from which on its line may leave it.
_SHORT = 4
#: Share of what a cut saves that its line must save after it was pulled straight.
_KEPT = 0.95
#: Of what is at stake, and of where fires start, where much of the fuel has none: so walls go on beyond those that part
#: all that has some, and hold fire off where these fail. An assumption.
_GROUND = 0.001


@dataclass(frozen=True)
class LineCut:
    """One wall of the tree.

    Parameters
    ----------
    lines
        Its lines, each (k, 2) int64: x and y of the vertices from the north-western corner of the grid to the east and
        to the south, in `kernels.crossings.PARTS` of a cell.
    length
        Of all of them, in cells.
    cost
        Cost of cutting cells along them, cells of length one: times width / cell size this is the cost of the wall.
    price
        The same with the difficulty of the ground, in a unit of its own.
    saved
        Expected loss that the wall saves once its parents stand, as a share of (ignition mass x value mass) of the
        whole landscape.
    parent
        Position in the list of the wall that must stand before, -1 for none.
    """

    lines: tuple[np.ndarray, ...]
    length: float
    cost: float
    price: float
    saved: float
    parent: int


@dataclass(frozen=True)
class _Field:
    """What does not change while the landscape is split; planes are flat."""

    shape: tuple[int, int]
    links: np.ndarray
    price: np.ndarray
    cost: np.ndarray
    ignition: np.ndarray
    value: np.ndarray
    scale: tuple[float, float]
    angles: np.ndarray
    shares: np.ndarray
    coarse_from: int

    def near(self, cells: np.ndarray) -> np.ndarray:
        return patch_links(cells, self.links, *self.shape, np.array(ROW_STEP), np.array(COL_STEP))  # type: ignore[no-any-return]

    def loss(self, cells: np.ndarray) -> float:
        return float(self.ignition[cells].sum() * self.value[cells].sum())

    def sides(self, cells: np.ndarray) -> np.ndarray:
        """Sides of the best wall of a compartment."""
        near = self.near(cells)
        side = np.ones(cells.size, np.uint8)
        best_link_cut(
            near,
            link_costs(near, self.price[cells], *self.scale),
            self.ignition[cells],
            self.value[cells],
            ordered(cells, self.shape, self.angles[self._directions(cells)]),
            self.shares,
            side,
        )
        return side

    def _directions(self, cells: np.ndarray) -> Sequence[int]:
        """Directions in which the wall of a compartment is sought; of a large one the best ones for its blocks."""
        every = range(len(self.angles))
        if cells.size <= self.coarse_from:
            return every
        factor = factor_for(cells.size, self.coarse_from)
        label, near = blocks(cells, self.links, *self.shape, np.array(ROW_STEP), np.array(COL_STEP), factor)

        def joined(values: np.ndarray) -> np.ndarray:
            return np.bincount(label, weights=values)

        count, price = joined(np.ones(cells.size)), self.price[cells]
        barred = price < 0
        told = coarse_price(price, barred, float(price.max(initial=0.0)))
        mean = np.where(joined(barred) == count, -1.0, joined(told) / count)
        row, col = (joined(line) / count for line in np.divmod(cells, self.shape[1]))
        order = sorted_along(row, col, self.shape, self.angles, ring=False)
        masses, side = (joined(self.ignition[cells]), joined(self.value[cells])), np.ones(count.size, np.uint8)
        cost = link_costs(near, mean, *self.scale)
        scores = [best_link_cut(near, cost, *masses, order[k : k + 1], self.shares, side)[0] for k in every]
        return np.argsort(-np.array(scores), kind="stable")[:_TRIED].tolist() if max(scores) > 0.0 else every

    def drawn(self, cells: np.ndarray, side: np.ndarray) -> _Drawn | None:
        """The wall between two sides of a compartment as lines; None if there is none."""
        if side.min() == side.max():
            return None
        box = _Box.around(cells, self.shape)
        label = box.filled(np.uint8(0), side)
        price = box.filled(-1.0, self.price[cells])
        gates, starts, ends = channels(label)
        near = self.near(cells)
        places = landings(label)
        own = [cells[side == k] for k in (1, 2)]
        expected = self.loss(cells) - sum(self.loss(one) for one in own)

        def made(freedom: np.ndarray) -> tuple[_Drawn, float]:
            points, first = lines_in(gates, starts, ends, price, places, freedom)
            lines, crossed = box.crossed(points, first)
            parted = (crossed[:, np.newaxis] >> np.arange(8, dtype=np.uint8)) & 1 > 0
            split = pieces_of(cells, np.where(parted, np.int32(-1), near))
            saved = self.loss(cells) - sum(self.loss(one) for one in split)
            length = sum(float(np.hypot(*np.diff(line, axis=0).T).sum()) for line in lines) / PARTS
            cost = prices_of(points, first, box.filled(-1.0, self.cost[cells]))
            return _Drawn(lines, split, length, cost, prices_of(points, first, price)), saved

        long = np.diff(starts) > _SHORT
        for most in (2, 1):
            freedom = np.where(long, most, 0).astype(np.uint8)
            found, saved = made(freedom)
            if saved >= _KEPT * expected:
                return found
            if np.count_nonzero(long) > 1:  # one line alone may spoil it
                freedom[:] = 0
                for k in np.flatnonzero(long):
                    freedom[k] = most
                    found, saved = made(freedom)
                    if saved < _KEPT * expected:
                        freedom[k] = 0
                if freedom.any():
                    return made(freedom)[0]
        return made(np.zeros(len(ends), np.uint8))[0]


@dataclass(frozen=True)
class _Drawn:
    lines: tuple[np.ndarray, ...]
    pieces: list[np.ndarray]
    length: float
    cost: float
    price: float


@dataclass(frozen=True)
class _Box:
    """The cells of a compartment in their bounding box, with one cell more on each side."""

    top: int
    left: int
    shape: tuple[int, int]
    row: np.ndarray
    col: np.ndarray

    @classmethod
    def around(cls, cells: np.ndarray, shape: tuple[int, int]) -> _Box:
        row, col = np.divmod(cells, shape[1])
        top, left = int(row.min()) - 1, int(col.min()) - 1
        return cls(top, left, (int(row.max()) - top + 2, int(col.max()) - left + 2), row - top, col - left)

    def filled(self, rest: np.generic | float, values: np.ndarray) -> np.ndarray:
        plane = np.full(self.shape, rest)
        plane[self.row, self.col] = values
        return plane

    def crossed(self, points: np.ndarray, first: np.ndarray) -> tuple[tuple[np.ndarray, ...], np.ndarray]:
        """Lines as `LineCut` has them, and the bits of the links of the cells that they cross."""
        whole = np.rint(points * PARTS).astype(np.int64)
        lines = tuple(whole[first[i] : first[i + 1]] for i in range(first.size - 1))
        pieces = np.concatenate([np.hstack([line[:-1], line[1:]]) for line in lines])
        bits = np.zeros(self.shape, np.uint8)
        none = np.zeros(self.shape, np.float32), np.zeros(self.shape, np.int64)
        cross_links(pieces, np.zeros(len(pieces), np.float32), bits, *none)
        corner = np.array([self.left, self.top], np.int64) * PARTS
        return tuple(line + corner for line in lines), bits[self.row, self.col]


def dissect_by_lines(
    network: SpreadNetwork,
    stakes: Stakes,
    *,
    directions: int = 8,
    shares: Sequence[float] = (0.2, 0.25, 0.3, 0.35, 0.4, 0.45),
    smallest: int = 64,
    coarse_from: int = _COARSE_FROM,
    threads: int | None = None,
    progress: Progress,
) -> list[LineCut]:
    """Split the landscape by lines until compartments hold fewer than `smallest` cells or cannot be split.

    Parameters
    ----------
    network, stakes
        What is planned for. A line costs by the cost and difficulty of the cells that it passes; none goes through
        protected cells, and cells without fuel need none.
    directions, shares, smallest, threads, progress
        As in `dissection.dissect`.
    coarse_from
        The wall of a compartment with more cells is sought in the directions that are best for its blocks alone.

    Returns
    -------
    list of LineCut
        Parents before children.

    Raises
    ------
    ParameterError
        If the grid is a torus, on which lines would have to cross the seam.
    """
    if network.boundary == "periodic":
        raise ParameterError("lines are planned on open maps alone; this one is periodic")
    ignition, value = (_shared_out(plane, network.burnable) for plane in (stakes.ignition, stakes.value))
    price, scale = _prices(network, stakes)
    field = _Field(
        network.shape,
        links(network).ravel(),
        price,
        stakes.cost.ravel(),
        ignition,
        value,
        scale,
        np.pi * np.arange(directions)[:, np.newaxis] / directions,
        np.asarray(shares),
        coarse_from,
    )
    fuel = np.flatnonzero(network.burnable.ravel())
    waiting = [(cells, -1) for cells in pieces_of(fuel, field.near(fuel))]
    cuts: list[LineCut] = []
    left = total = work_of(fuel.size, smallest)
    while waiting:
        waiting = [(cells, parent) for cells, parent in waiting if cells.size >= smallest]
        done = 1.0 - left / max(total, 1.0)
        left = sum(work_of(cells.size / 2, smallest) for cells, _ in waiting)
        step = part(progress, done, 1.0 - left / max(total, 1.0))
        walls = _walls(field, [cells for cells, _ in waiting], threads, step, f"{len(cuts)} walls")
        children = []
        for (cells, parent), wall in zip(waiting, walls, strict=True):
            if wall is None or len(wall.pieces) < 2:
                continue
            saved = field.loss(cells) - sum(field.loss(piece) for piece in wall.pieces)
            children += [(piece, len(cuts)) for piece in wall.pieces]
            cuts.append(LineCut(wall.lines, wall.length, wall.cost, wall.price, saved, parent))
        waiting = children
    progress(1.0, f"{len(cuts)} walls")
    return cuts


def _shared_out(plane: np.ndarray, burnable: np.ndarray) -> np.ndarray:
    """Share of all that each cell has, (n_cells,); where fuel has none, `_GROUND` of all is spread over the fuel."""
    share = plane.ravel() / max(float(plane.sum()), 1e-300)
    if (plane[burnable] > 0).all():
        return share
    ground = burnable.ravel() / max(int(np.count_nonzero(burnable)), 1)
    return np.asarray((1.0 - _GROUND) * share + _GROUND * ground)


def _prices(network: SpreadNetwork, stakes: Stakes) -> tuple[np.ndarray, tuple[float, float]]:
    """Price of a line in each cell, (n_cells,) with a median of 1, below 0 where none may be; costs of links of it."""
    price = np.where(network.burnable, stakes.cost * stakes.difficulty, 0.0).ravel()
    allowed = network.burnable & ~stakes.protected
    told = price[allowed.ravel()]
    positive = told[told > 0]
    if positive.size:
        price = price / float(np.median(positive))
    price[stakes.protected.ravel()] = -1.0
    if not positive.size or positive.min() == positive.max() == told.min():
        return price, _EQUAL
    most = MOST / (8.0 * _DIFFERENT[0] * float(price[allowed.ravel()].sum()))
    return price, (min(1.0, most) * _DIFFERENT[0], min(1.0, most) * _DIFFERENT[1])


def _walls(
    field: _Field,
    compartments: list[np.ndarray],
    threads: int | None,
    progress: Progress,
    message: str,
) -> list[_Drawn | None]:
    """The best wall of every compartment."""
    sides: list[np.ndarray] = [np.zeros(0, np.uint8)] * len(compartments)

    def seek(batch: list[int]) -> None:
        for i in batch:
            sides[i] = field.sides(compartments[i])

    pieces = batches(compartments)
    run_pieces(seek, pieces, threads=threads, progress=part(progress, 0.0, 0.8), message=message)
    walls: list[_Drawn | None] = [None] * len(compartments)

    def draw(batch: list[int]) -> None:
        for i in batch:
            walls[i] = field.drawn(compartments[i], sides[i])

    run_pieces(draw, pieces, threads=threads, progress=part(progress, 0.8, 1.0), message=message)
    return walls
