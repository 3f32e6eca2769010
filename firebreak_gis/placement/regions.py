"""Regions of a map that is too large to be looked at cell by cell at once, parted by walls over all of it.

The map is parted into blocks: the connected pieces of its fuel within squares. The best cut of the blocks is sought
first, and made exact among the cells near it, so that a wall costs a look at the blocks and at the cells near the wall.
Then what the wall has left of the blocks there is parted into blocks anew. So each block lies in one region, regions
are connected, and what parts them is exact; they are split until each is small enough to be dissected by itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.bisection import best_cut
from firebreak_gis.kernels.coarse import blocks
from firebreak_gis.kernels.flow import UNCUTTABLE
from firebreak_gis.kernels.keys import distinct
from firebreak_gis.kernels.patches import thin
from firebreak_gis.kernels.squares import UNNUMBERED, number_blocks
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.placement.coarsening import coarse_costs, coarse_price, factor_for
from firebreak_gis.placement.patches import SIDES, sorted_along

if TYPE_CHECKING:
    from firebreak_gis.placement.patches import Patches

#: Cells that are looked at together.
_TOGETHER = 1_000_000
#: Squares around those of a coarse wall among whose cells it is made exact: a step more than the band reaches.
_RINGS = 2

_ROW_STEP, _COL_STEP = np.array(ROW_STEP), np.array(COL_STEP)


@dataclass(frozen=True)
class Region:
    """Connected fuel.

    Parameters
    ----------
    blocks
        (n,) numbers of its blocks, rising.
    pairs
        (2, m) numbers of blocks that are linked, each pair once, the smaller first.
    links
        (m,) links of cells between them.
    size
        Cells.
    loss
        Expected loss, a share of that of the whole.
    """

    blocks: np.ndarray
    pairs: np.ndarray
    links: np.ndarray
    size: int
    loss: float


class Regions:
    """The map in blocks.

    Parameters
    ----------
    patches
        The map.
    burnable
        (rows, cols) bool.
    largest
        Regions of more cells are split.
    """

    def __init__(self, patches: Patches, burnable: np.ndarray, largest: int) -> None:
        self._patches, self._shape = patches, burnable.shape
        self._factor = factor_for(largest, patches.coarse_from)
        # With room beside the map, so that the squares around one are never those of another row.
        self._across = -(-burnable.shape[1] // self._factor) + _RINGS
        reach = np.arange(-_RINGS, _RINGS + 1)
        self._around = (reach[:, None] * self._across + reach).ravel()
        label = np.where(burnable, UNNUMBERED, np.int32(-1))
        count = number_blocks(label, patches.links.reshape(burnable.shape), _ROW_STEP, _COL_STEP, self._factor)
        self._label = label.ravel()
        firm = patches.capacity >= UNCUTTABLE
        self._dearest = int(patches.capacity[~firm].max(initial=1))
        self._sums = np.zeros((_SUMS, count))
        found = []
        for first in range(0, self._label.size, _TOGETHER):
            cells = first + np.flatnonzero(self._label[first : first + _TOGETHER] >= 0)
            self._sums += self._summed(cells, count)
            found.append(_pairs(self._links_from(cells, self._label.size)))
        pairs, links = zip(*found, strict=True)
        self._whole = _pairs(np.concatenate(pairs, axis=1), np.concatenate(links))

    def __iter__(self) -> Iterator[Region]:
        """Give the connected pieces of the map."""
        return iter(self._connected(np.arange(self._sums.shape[1]), *self._whole))

    def cells(self, region: Region) -> np.ndarray:
        """Row-major numbers of the cells of a region, rising, (n,) int64."""
        return self._cells(region.blocks)

    def split(self, region: Region) -> tuple[np.ndarray, list[Region]] | None:
        """Split a region where a wall saves most for its cost.

        Returns
        -------
        tuple or None
            Row-major numbers of the cells of the wall, and the regions that are left; None if no wall is found.
        """
        ids, patches = region.blocks, self._patches
        one, other = np.searchsorted(ids, region.pairs)
        sums = self._sums[:, ids]
        count, _, _, ignition, value, row, col = sums
        cost = coarse_costs(sums[1], sums[2] == count, self._factor)
        near = self._near(ids, one, other, region.links)
        order = sorted_along(row / count, col / count, self._shape, patches.angles, ring=False)
        mark = np.zeros(ids.size, np.uint8)
        best_cut(near, cost, ignition, value, order, patches.heads, patches.shares, mark)
        if not (mark == 1).any():
            return None
        side = SIDES[mark]
        # What is linked past the eight neighbours of a block may still join the sides.
        across = (side[one] != side[other]) & (side[one] > 0) & (side[other] > 0)
        gathered = side == 0
        gathered[one[across]] = gathered[other[across]] = True
        squares = self._squares(ids)
        gathered = np.isin(squares, squares[gathered][:, None] + self._around)
        beyond = np.array([[mass[~gathered & (side == s)].sum() for mass in (ignition, value)] for s in (1, 2)])
        cells = self._cells(ids[gathered])
        near_side = side[np.searchsorted(ids, self._label[cells])]
        wall = patches.exact_wall(cells, near_side, self._factor, beyond)
        if wall is None:
            return None
        thin(patches.near(cells), wall)
        if not wall.any():
            return None
        new, *pairs = self._again(cells, wall)
        kept = ~(gathered[one] | gathered[other])
        whole = np.concatenate([region.pairs[:, kept], pairs[0]], axis=1), np.append(region.links[kept], pairs[1])
        return cells[wall > 0], self._connected(np.append(ids[~gathered], new), *whole)

    def _again(self, cells: np.ndarray, wall: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Part what a wall has left of some blocks into new ones; return those, and what they are linked to."""
        rest, known = cells[wall == 0], self._sums.shape[1]
        self._label[cells[wall > 0]] = -1
        if rest.size == 0:
            return np.zeros(0, np.int64), np.zeros((2, 0), np.int64), np.zeros(0, np.int64)
        number, _ = blocks(rest, self._patches.links, *self._shape, _ROW_STEP, _COL_STEP, self._factor)
        self._label[rest] = known + number
        count = int(number.max()) + 1
        self._sums = np.concatenate([self._sums, self._summed(rest, known + count)[:, known:]], axis=1)
        pairs, links = _pairs(self._links_from(rest, known))
        return known + np.arange(count), pairs, links

    def _connected(self, ids: np.ndarray, pairs: np.ndarray, links: np.ndarray) -> list[Region]:
        """The connected pieces of some blocks, in the order of their first blocks."""
        from scipy.sparse import coo_array
        from scipy.sparse.csgraph import connected_components

        local = np.searchsorted(ids, pairs)
        graph = coo_array((np.ones(links.size, np.int8), (local[0], local[1])), (ids.size, ids.size))
        count, part = connected_components(graph.tocsr(), directed=False)
        order = np.argsort(part, kind="stable")
        by_part = np.split(order, np.flatnonzero(np.diff(part[order])) + 1) if ids.size else []
        part_of_pair = part[local[0]]
        pair_order = np.argsort(part_of_pair, kind="stable")
        pair_ends = np.searchsorted(part_of_pair[pair_order], np.arange(count + 1))
        found = []
        for k, members in enumerate(by_part):
            own = pair_order[pair_ends[k] : pair_ends[k + 1]]
            sums = self._sums[:, ids[members]].sum(axis=1)
            found.append(Region(ids[members], pairs[:, own], links[own], int(sums[0]), float(sums[3] * sums[4])))
        return found

    def _near(self, ids: np.ndarray, one: np.ndarray, other: np.ndarray, links: np.ndarray) -> np.ndarray:
        """Blocks as `kernels.flow` takes them: of several in one direction that with most links; links go both ways."""
        row, col = np.divmod(self._squares(ids), self._across)
        down, right = np.sign(row[other] - row[one]), np.sign(col[other] - col[one])
        near = np.full((ids.size, 8), -1, np.int32)
        order = np.lexsort((other, one, links))  # of what is written twice the last stays
        for d in range(8):
            for start, stop, sign in ((one, other, 1), (other, one, -1)):
                there = order[(sign * down[order] == ROW_STEP[d]) & (sign * right[order] == COL_STEP[d])]
                near[start[there], d] = stop[there]
        for d in range(8):
            to = near[:, d]
            near[(to >= 0) & (near[to, (d + 4) & 7] != np.arange(ids.size)), d] = -1
        return near

    def _cells(self, ids: np.ndarray) -> np.ndarray:
        """Cells of blocks."""
        rows, cols = self._shape
        squares = distinct(self._squares(ids))
        inside = np.arange(self._factor)
        found = [np.zeros(0, np.int64)]
        step = max(_TOGETHER // self._factor**2, 1)
        wanted = np.zeros(self._sums.shape[1] + 1, bool)
        wanted[ids] = True
        for first in range(0, squares.size, step):
            top, left = np.divmod(squares[first : first + step, None, None], self._across)
            row, col = np.broadcast_arrays(top * self._factor + inside[:, None], left * self._factor + inside)
            within = (row < rows) & (col < cols)
            cells = row[within] * cols + col[within]
            found.append(cells[wanted[self._label[cells]]])
        return np.sort(np.concatenate(found))

    def _squares(self, ids: np.ndarray) -> np.ndarray:
        """Numbers of the squares in which blocks lie: the middle of a block lies where all of it does."""
        row, col = (self._sums[5:7, ids] / self._sums[0, ids]).round().astype(np.int64) // self._factor
        return np.asarray(row * self._across + col)

    def _summed(self, cells: np.ndarray, count: int) -> np.ndarray:
        """By block: cells, what a wall pays for them, those that may not be cut, ignition, value, rows and columns."""
        label, capacity = self._label[cells], self._patches.capacity[cells]
        firm = capacity >= UNCUTTABLE
        ignition, value = self._patches.masses(cells)
        price = coarse_price(capacity, firm, self._dearest)
        each = (np.ones(cells.size), price, firm, ignition, value, *np.divmod(cells, self._shape[1]))
        return np.array([np.bincount(label, weights=plane, minlength=count) for plane in each])

    def _links_from(self, cells: np.ndarray, known: int) -> np.ndarray:
        """Links from cells to those of other blocks, (2, n) int64; of links between blocks from `known` on one way."""
        label, links = self._label, self._patches.links
        found = [np.zeros((2, 0), np.int64)]
        for d in range(8):
            linked = cells[(links[cells] >> d) & 1 > 0]
            own, other = label[linked], label[linked + ROW_STEP[d] * self._shape[1] + COL_STEP[d]]
            kept = (other >= 0) & ((own < other) | (other < known) & (own >= known))
            found.append(np.array([np.minimum(own, other)[kept], np.maximum(own, other)[kept]], np.int64))
        return np.concatenate(found, axis=1)


#: What is known of a block, see `Regions._summed`.
_SUMS = 7


def _pairs(links: np.ndarray, weights: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Links as pairs that are there once, and how often each was, or what it weighed in all."""
    size = int(links.max(initial=0)) + 1
    key, place = np.unique(links[0] * size + links[1], return_inverse=True)
    return np.array(np.divmod(key, size)), np.bincount(place, weights=weights, minlength=key.size).astype(np.int64)
