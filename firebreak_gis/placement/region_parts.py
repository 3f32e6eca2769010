"""Regions of a large map as parts of the work, for workers that have no map.

A part is given what its region needs, cell by cell. It puts that where it lies on the map, so that all is as there, to
the last bit: memory for the rest of the map is asked for, and as long as nobody touches it, not taken.
"""

from __future__ import annotations

import mmap
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping

    from firebreak_gis.placement.patches import Patches

#: What is known of every cell, see `Patches`.
_PLANES = ("links", "capacity", "cost", "ignition", "value")


class Pieces(Sequence[Any]):
    """What regions need of the map, made when it is asked for: 37 B a cell.

    Parameters
    ----------
    patches
        The map.
    cells
        Gives the row-major numbers of the cells of a region by its number, rising.
    order
        Numbers of the regions in the order in which they are begun.
    """

    def __init__(self, patches: Patches, cells: Callable[[int], np.ndarray], order: Sequence[int]) -> None:
        self._patches, self._cells, self._order = patches, cells, order

    def __len__(self) -> int:
        return len(self._order)

    def __getitem__(self, i: Any) -> Any:
        cells = self._cells(self._order[i])
        return {"cells": cells} | {name: getattr(self._patches, name)[cells] for name in _PLANES}


def bare(patches: Patches) -> Patches:
    """Patches without what is known of every cell, as all parts need them."""
    return _with(patches, {name: getattr(patches, name)[:0] for name in _PLANES})


def placed(patches: Patches, piece: Mapping[str, np.ndarray]) -> tuple[Patches, np.ndarray]:
    """Patches that are those of the map in the cells of a piece, and an array for `sizes` of `dissection.dissect`."""
    n_cells = patches.shape[0] * patches.shape[1]
    planes = {name: _untouched(n_cells, piece[name].dtype) for name in _PLANES}
    for name, plane in planes.items():
        plane[piece["cells"]] = piece[name]
    return _with(patches, planes), _untouched(n_cells, np.dtype(np.int32))


def packed(walls: Iterable[tuple[np.ndarray, float, float, int, int]], sizes: np.ndarray) -> dict[str, np.ndarray]:
    """Walls, as `dissection.Cut` tells them, and the sizes of a region's cells as arrays by name."""
    lines, cost, saved, parent, size = [list(each) for each in zip(*walls, strict=True)] or [[], [], [], [], []]
    return {
        "walls": np.concatenate([np.zeros(0, np.int64), *lines]),
        "ends": np.cumsum([line.size for line in lines], dtype=np.int64),
        "cost": np.array(cost, np.float64),
        "saved": np.array(saved, np.float64),
        "parent": np.array(parent, np.int64),
        "size": np.array(size, np.int64),
        "sizes": sizes,
    }


def unpacked(made: Mapping[str, np.ndarray]) -> Iterator[tuple[Any, ...]]:
    """The walls that were packed."""
    lines = (made["walls"][start:stop] for start, stop in pairwise([0, *made["ends"].tolist()]))
    return zip(lines, *(made[name].tolist() for name in ("cost", "saved", "parent", "size")), strict=True)


def _with(patches: Patches, planes: dict[str, Any]) -> Patches:
    return replace(patches, **planes)


def _untouched(size: int, dtype: np.dtype[Any]) -> np.ndarray:
    """Zeros that take memory page by page where they are written; `np.zeros` takes all between, in huge pages."""
    return np.frombuffer(mmap.mmap(-1, size * dtype.itemsize), dtype)
