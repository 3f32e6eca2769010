"""Regions of a large map as parts of the work, for workers that have no map.

A part is given what its region needs, cell by cell. It puts that where it lies on the map, so that all is as there, to
the last bit: memory for the rest of the map is asked for, and as long as nobody touches it, not taken.
"""

from __future__ import annotations

import mmap
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.simulation.engine import spread

if TYPE_CHECKING:
    from collections.abc import Mapping

    from firebreak_gis.placement.dissection import Cut
    from firebreak_gis.placement.patches import Patches
    from firebreak_gis.progress import Progress

#: What is known of every cell, see `Patches`.
_PLANES = ("links", "capacity", "cost", "ignition", "value")
#: What is told of every wall, see `Cut`.
_OF_WALL = ("cells", "cost", "saved", "parent", "size")


class _Pieces(Sequence[Any]):
    """What regions need of the map, made when it is asked for: 37 B a cell."""

    def __init__(self, patches: Patches, cells: Callable[[int], np.ndarray], order: Sequence[int]) -> None:
        self._patches, self._cells, self._order = patches, cells, order

    def __len__(self) -> int:
        return len(self._order)

    def __getitem__(self, i: Any) -> Any:
        cells = self._cells(self._order[i])
        return {"cells": cells} | {name: getattr(self._patches, name)[cells] for name in _PLANES}


def walled_apart(
    patches: Patches,
    cells: Callable[[int], np.ndarray],
    order: Sequence[int],
    smallest: int,
    sizes: np.ndarray,
    *,
    threads: int | None,
    progress: Progress,
) -> list[list[Cut]]:
    """Split regions all the way down on the engine in use.

    Parameters
    ----------
    patches
        The map.
    cells
        Gives the row-major numbers of the cells of a region by its number, rising.
    order
        Numbers of the regions in the order in which they are begun.
    smallest, sizes
        As in `dissection.dissect`.
    threads, progress
        As in `engine.spread`.

    Returns
    -------
    list of list of Cut
        Walls of each region, by its number; parents as in its list.
    """
    from firebreak_gis.placement.dissection import Cut

    found: list[list[Cut]] = [[] for _ in order]

    def take(i: int, made: Mapping[str, np.ndarray]) -> None:
        own, split = cells(order[i]), made["sizes"]
        sizes[own] = np.where(split > 0, split, sizes[own])
        lines = [made["walls"][start:stop] for start, stop in pairwise([0, *made["ends"].tolist()])]
        told = (made[name].tolist() for name in ("cost", "saved", "parent", "size"))
        found[order[i]] = [Cut(*each) for each in zip(lines, *told, strict=True)]

    bare = replace(patches, **{name: getattr(patches, name)[:0] for name in _PLANES})
    spread(
        split_region,
        _Pieces(patches, cells, order),
        {"patches": bare, "smallest": smallest},
        take=take,
        threads=threads,
        progress=progress,
        message="walls in regions",
    )
    return found


def split_region(
    piece: Mapping[str, np.ndarray], *, patches: Patches, smallest: int, threads: int | None, progress: Progress
) -> dict[str, np.ndarray]:
    """Split a region all the way down.

    Parameters
    ----------
    piece
        Its cells, and of each of them what `patches` lacks.

    Returns
    -------
    dict
        `walls`, the cells of all walls, one after another, and of each wall the place in them where it `ends`, `cost`,
        `saved`, `parent` and `size`; and of each cell of the region the size of the smallest compartment around it
        that is split, `sizes`, or 0.
    """
    from firebreak_gis.placement.dissection import walls_within

    cells, n_cells = piece["cells"], patches.shape[0] * patches.shape[1]
    planes: dict[str, Any] = {}
    for name in _PLANES:
        planes[name] = _untouched(n_cells, piece[name].dtype)
        planes[name][cells] = piece[name]
    sizes = _untouched(n_cells, np.dtype(np.int32))
    cuts = walls_within(replace(patches, **planes), cells, smallest, sizes, threads, progress)
    lines, cost, saved, parent, size = [[getattr(cut, name) for cut in cuts] for name in _OF_WALL]
    return {
        "walls": np.concatenate([np.zeros(0, np.int64), *lines]),
        "ends": np.cumsum([line.size for line in lines], dtype=np.int64),
        "cost": np.array(cost, np.float64),
        "saved": np.array(saved, np.float64),
        "parent": np.array(parent, np.int64),
        "size": np.array(size, np.int64),
        "sizes": sizes[cells],
    }


def _untouched(size: int, dtype: np.dtype[Any]) -> np.ndarray:
    """Zeros that take memory page by page where they are written; `np.zeros` takes all between, in huge pages."""
    return np.frombuffer(mmap.mmap(-1, size * dtype.itemsize), dtype)
