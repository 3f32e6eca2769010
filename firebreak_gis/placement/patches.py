"""Patches of fuel, and the wall that splits one best: the minimum cut between two of its ends.

Where fire passes between all neighbours, which is usual, the wall is a shortest path (`kernels.chains`). A large patch
is searched coarsely first, by squares, of which a wall crosses one for about their cost over their side; the direction
that is best for them is then searched cell by cell.

Elsewhere, and on a torus, it is found by flow (`kernels.bisection`), and a large patch is joined to blocks; their best
cut is made exact in a band around it, whose rims are its ends. So a wall costs little more than one look at the patch,
and is the cheapest in the band; what is lost is a cheaper one elsewhere, such as along a narrow strip of cheap cells,
which blocks average out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from firebreak_gis.kernels.bisection import best_cut
from firebreak_gis.kernels.chains import best_chain, can_chain
from firebreak_gis.kernels.coarse import band, blocks
from firebreak_gis.kernels.flow import UNCUTTABLE, cut_between
from firebreak_gis.kernels.patches import patch_links, pieces_after, thin
from firebreak_gis.kernels.splitting import split_down
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.coarsening import factor_for, joined_costs
from firebreak_gis.placement.edges import links, mean_lit
from firebreak_gis.placement.widening import STANDARD_CORNER, wall_cost

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import Stakes

#: Patches of more cells are searched coarsely first, in about half as many blocks or fewer.
COARSE_FROM = 4096
#: Patches of so many times more, where walls are chains: these are found faster than flows, and the direction that is
#: best by blocks need not be the best.
_CHAINS = 16
#: Steps from the coarse wall to which the band reaches, in sides of a block; tried in turn until both ends lie outside.
_REACH = (1.0, 0.5, 0.0)
#: Largest sum of whole-number costs, so that no flow overflows.
_COST_RANGE = 2**29
#: Costs of which the least is so many steps, and the largest at most so many times the least, stay as they are.
_STEPS, _FEW = 2, 256
#: Steps of the median cost of a cell where breaks leak. With 8 in place of 1000 walls are found 2.7 times as fast; on
#: the sample at 60 m plans of three widths then burn 19 % less to 2 % more.
_LEAK_STEPS = 8
#: What a mean cell costs more for its leak; on Rhodes at 40 m this burns 3 to 4 % less, 1 as much, 3 more.
_LEAK_WEIGHT = 0.3

#: Side of what `bisection.best_cut` marks 0, 1 and 2, as `Patches.exact_wall` takes it: its wall is on none.
SIDES = np.array([2, 0, 1], np.uint8)

_ROW_STEP, _COL_STEP = np.array(ROW_STEP), np.array(COL_STEP)


@dataclass(frozen=True)
class Split:
    """A patch that is split.

    Parameters
    ----------
    wall
        (n,) int64 row-major numbers of the cells of the wall.
    pieces
        Cells of each connected piece that is left, in the order of their first cells.
    """

    wall: np.ndarray
    pieces: list[np.ndarray]


class Walls(NamedTuple):
    """Walls of a patch that is split all the way down, as `kernels.splitting.split_down` returns them."""

    cells: np.ndarray
    ends: np.ndarray
    parent: np.ndarray
    sibling: np.ndarray
    size: np.ndarray
    saved: np.ndarray


@dataclass(frozen=True)
class Patches:
    """What does not change while a landscape is split; planes are flat.

    Parameters
    ----------
    shape
        (rows, cols).
    links, capacity, cost, ignition, value
        As of `edges.links` and `capacities`; cost, ignition and value of the cells.
    ignitions, values
        Sums of ignition and value over the landscape.
    angles, shares
        (n, 1) directions in which walls are sought, from east to south; shares that the ends hold.
    periodic
        Whether the grid is a torus.
    coarse_from
        Patches of more cells are searched coarsely first; for chains, of 16 times as many.
    """

    shape: tuple[int, int]
    links: np.ndarray
    capacity: np.ndarray
    cost: np.ndarray
    ignition: np.ndarray
    value: np.ndarray
    ignitions: float
    values: float
    angles: np.ndarray
    shares: np.ndarray
    periodic: bool
    coarse_from: int = COARSE_FROM

    @classmethod
    def of(
        cls,
        network: SpreadNetwork,
        stakes: Stakes,
        *,
        width: int,
        leaky: bool,
        directions: int,
        shares: Sequence[float],
        coarse_from: int,
        corner: tuple[int, int] = STANDARD_CORNER,
    ) -> Patches:
        """Of a network; parameters as in `dissection.dissect`."""
        return cls(
            network.shape,
            links(network).ravel(),
            capacities(network, stakes, width, leaky=leaky, corner=corner).ravel(),
            stakes.cost.ravel(),
            stakes.ignition.ravel(),
            stakes.value.ravel(),
            max(float(stakes.ignition.sum()), 1e-300),
            max(float(stakes.value.sum()), 1e-300),
            np.pi * np.arange(directions)[:, None] / directions,
            np.asarray(shares),
            network.boundary == "periodic",
            coarse_from,
        )

    def loss(self, cells: np.ndarray) -> float:
        """Expected loss of a patch, a share of that of the whole."""
        return float(self.ignition[cells].sum() / self.ignitions * (self.value[cells].sum() / self.values))

    def connected(self, cells: np.ndarray) -> list[np.ndarray]:
        """Cells of each connected piece."""
        return pieces_of(cells, self.near(cells))

    def split(self, cells: np.ndarray) -> Split | None:
        """Split a connected patch where a wall saves most for its cost; None if none saves anything."""
        mask = None if self.periodic else self._chain(cells)
        if mask is None:
            mask = self._cheapest_cut(cells)
        wall = (mask == 1).astype(np.uint8)
        near = self.near(cells)  # made here, not before: of a large map much memory
        thin(near, wall)
        return Split(cells[wall > 0], pieces_of(cells, near, wall)) if wall.any() else None

    def split_down(self, cells: np.ndarray, smallest: int, sizes: np.ndarray) -> Walls:
        """Split a connected patch as `split` does, and its pieces in turn until they are smaller than `smallest`.

        Parameters
        ----------
        cells
            (n,) int64, rising.
        smallest
            Pieces of fewer cells are left whole.
        sizes
            (rows * cols,) int32, set in the cells of each piece that is split to its number of cells.
        """
        return Walls(
            *split_down(
                cells,
                self.links,
                *self.shape,
                _ROW_STEP,
                _COL_STEP,
                self.capacity,
                self.ignition,
                self.value,
                self.ignitions,
                self.values,
                *self._places,
                self.heads,
                self.toward,
                self.shares,
                self.periodic,
                smallest,
                sizes,
            )
        )

    @cached_property
    def toward(self) -> np.ndarray:
        """Rows and columns of a step along each direction of `angles`, (n, 2)."""
        return np.concatenate([np.sin(self.angles), np.cos(self.angles)], axis=1)

    @cached_property
    def heads(self) -> np.ndarray:
        """Directions of the grid, those first that lead straight along each direction of `angles`."""
        along = np.round(np.sin(self.angles) * _ROW_STEP + np.cos(self.angles) * _COL_STEP, 6)
        return np.argsort(-along, axis=1, kind="stable")

    @cached_property
    def _places(self) -> list[np.ndarray]:
        """What rows, and what columns, add to the places of cells along each direction: in the plane, round a torus."""
        factors, out = (np.sin(self.angles), np.cos(self.angles)), []
        for size, factor in zip(self.shape, factors, strict=True):
            steps = np.arange(size)
            out.append(
                factor * np.stack([np.broadcast_to(steps, (factor.size, size)), _round(steps, size, self.angles)])
            )
        return out

    def near(self, cells: np.ndarray) -> np.ndarray:
        """Links within some cells, as `kernels.flow` takes them."""
        return patch_links(cells, self.links, *self.shape, _ROW_STEP, _COL_STEP)  # type: ignore[no-any-return]

    def masses(self, cells: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Ignition and value of some cells, shares of those of the whole."""
        return self.ignition[cells] / self.ignitions, self.value[cells] / self.values

    def _chain(self, cells: np.ndarray) -> np.ndarray | None:
        """Mark of the best chain, as `chains.best_chain` sets it; None where a wall need not be one.

        In a large patch in the direction that is best by squares.
        """
        row, col = (cells // self.shape[1]).astype(np.int32), (cells % self.shape[1]).astype(np.int32)
        if not can_chain(row, col, self.links[cells]):
            return None
        toward, share = self.toward, float(self.shares[0])
        if cells.size > _CHAINS * self.coarse_from:
            squares = self._squares(cells, row, col)
            _, found = best_chain(*squares, toward, share, np.empty(squares[0].size, np.uint8))
            toward = toward[found : found + 1] if found >= 0 else toward
        mask = np.empty(cells.size, np.uint8)
        best_chain(row, col, self.capacity[cells], *self.masses(cells), toward, share, mask)
        return mask

    def _squares(self, cells: np.ndarray, row: np.ndarray, col: np.ndarray) -> tuple[np.ndarray, ...]:
        """Squares of a large patch, as `chains.best_chain` takes cells."""
        factor = factor_for(cells.size, _CHAINS * self.coarse_from)
        wide = int(col.max()) // factor + 1
        key = row // factor * wide + col // factor
        there = np.zeros(int(key.max()) + 1, bool)
        there[key] = True
        square, label = np.flatnonzero(there), (np.cumsum(there, dtype=np.int32) - 1)[key]
        cost = joined_costs(self.capacity[cells], label, factor)
        masses = (np.bincount(label, weights=mass) for mass in self.masses(cells))
        return (*(each.astype(np.int32) for each in np.divmod(square, wide)), cost, *masses)

    def _cheapest_cut(self, cells: np.ndarray) -> np.ndarray:
        """Mark of the best minimum cut, as `bisection.best_cut` sets it."""
        mask = self._coarse_wall(cells) if cells.size > self.coarse_from else None
        if mask is None:
            mask = np.zeros(cells.size, np.uint8)
            order = ordered(cells, self.shape, self.angles, periodic=self.periodic)
            near = self.near(cells)
            best_cut(near, self.capacity[cells], *self.masses(cells), order, self.heads, self.shares, mask)
        return mask

    def _coarse_wall(self, cells: np.ndarray) -> np.ndarray | None:
        """Mark of the wall, as `bisection.best_cut` sets it, found coarsely and made exact; None if that finds none."""
        factor = factor_for(cells.size, self.coarse_from)
        place = (self.links, *self.shape, _ROW_STEP, _COL_STEP)
        label, near = blocks(cells, *place, factor)
        ignition, value = self.masses(cells)
        cost = joined_costs(self.capacity[cells], label, factor)
        masses = (np.bincount(label, weights=ignition), np.bincount(label, weights=value))
        row, col = np.divmod(cells, self.shape[1])
        ring = self.periodic and _ring(row, col, self.shape)
        row, col = (np.bincount(label, weights=line) / np.bincount(label) for line in (row, col))
        order = sorted_along(row, col, self.shape, self.angles, ring=ring)
        mark = np.zeros(near.shape[0], np.uint8)
        best_cut(near, cost, *masses, order, self.heads, self.shares, mark)
        if not (mark == 1).any():
            return None
        return self.exact_wall(cells, SIDES[mark][label], factor)

    def exact_wall(
        self, cells: np.ndarray, side: np.ndarray, factor: int, beyond: np.ndarray | None = None
    ) -> np.ndarray | None:
        """Make a coarse wall exact in a band around it.

        Parameters
        ----------
        cells
            (n,) of the patch, or those of it that lie near the wall.
        side
            (n,) uint8: 0 in the coarse wall, 1 and 2 on its sides.
        factor
            Side of its blocks [cells].
        beyond
            (2, 2) ignition and value on side 1, and on side 2, that lie in no cell of these; None: nothing.

        Returns
        -------
        numpy.ndarray or None
            (n,) uint8, 1 in the wall; None if there is none that saves anything.
        """
        place = (self.links, *self.shape, _ROW_STEP, _COL_STEP)
        for reach in _REACH:
            found = band(cells, side, *place, int(np.ceil(reach * factor)))
            ends = [np.flatnonzero((found == 2) & (side == each)) for each in (1, 2)]
            if all(end.size for end in ends):
                return self._exact_in(cells, found, side, np.zeros((2, 2)) if beyond is None else beyond)
        return None

    def _exact_in(self, cells: np.ndarray, found: np.ndarray, side: np.ndarray, far: np.ndarray) -> np.ndarray | None:
        """The cheapest wall in a band between its rims, which hold all that lies beyond them."""
        inner = np.flatnonzero(found)
        end = np.where(found[inner] == 2, side[inner], 0).astype(np.uint8)
        ignition, value = self.masses(cells)
        within = [ignition[inner], value[inner]]
        for each in (1, 2):
            beyond = (found == 0) & (side == each)
            rim = int(np.flatnonzero(end == each)[0])
            for own, mass, more in zip(within, (ignition, value), far[each - 1], strict=True):
                own[rim] += mass[beyond].sum() + more
        mark = np.zeros(inner.size, np.uint8)
        score, _ = cut_between(self.near(cells[inner]), self.capacity[cells[inner]], *within, end, mark)
        if score <= 0.0:
            return None
        wall = np.zeros(cells.size, np.uint8)
        wall[inner] = mark == 1
        return wall


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
    return sorted_along(row, col, shape, angles, ring=periodic and _ring(row, col, shape))


def sorted_along(
    row: np.ndarray, col: np.ndarray, shape: tuple[int, int], angles: np.ndarray, *, ring: bool
) -> np.ndarray:
    """Positions of places sorted along each of some directions, as `ordered`; round a ring if they form one."""
    if ring:  # it has no ends: from one side of it to the other
        row, col = _round(row, shape[0], angles), _round(col, shape[1], angles)
    # Rounded, so that cells in line tie whatever the arithmetic; ties go by number.
    along = np.round(np.sin(angles) * row + np.cos(angles) * col, 6)
    return np.argsort(along, axis=1, kind="stable")


def _round(places: np.ndarray, size: int, angles: np.ndarray) -> np.ndarray:
    """How far along a direction places round an axis are."""
    return np.asarray(np.cos(2.0 * np.pi * places / size + angles))


def _ring(row: np.ndarray, col: np.ndarray, shape: tuple[int, int]) -> bool:
    """Whether cells of a torus reach both ends of an axis."""
    return _spans(row, shape[0]) or _spans(col, shape[1])


def _spans(places: np.ndarray, size: int) -> bool:
    """Whether places along an axis reach both of its ends."""
    return bool(places.size and places.min() == 0 and places.max() == size - 1)


def capacities(
    network: SpreadNetwork,
    stakes: Stakes,
    width: int = 1,
    *,
    leaky: bool = False,
    corner: tuple[int, int] = STANDARD_CORNER,
) -> np.ndarray:
    """Whole-number cutting costs for the flow, (rows, cols) int32; `UNCUTTABLE` where protected.

    A cell counts its cost times its difficulty. With a width a cell also counts its share of the wall around it
    (`corner` as in `widening.wall_cost`).
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
    cost = np.where(network.burnable & ~stakes.protected, wall_cost(own, width, network.boundary, corner), 0.0)
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
