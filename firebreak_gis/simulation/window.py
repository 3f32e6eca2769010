"""A rectangle of a map that stands for the whole while a fire stays inside it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.grid import Grid

if TYPE_CHECKING:
    from collections.abc import Iterator


@dataclass(frozen=True)
class Window:
    """Rows and columns of a map.

    Parameters
    ----------
    top, left
        First row and column.
    shape
        (rows, cols) of the window; as many columns as the map, or a power of two (`kernels.percolation.steps`).
    map_shape
        (rows, cols) of the map.
    """

    top: int
    left: int
    shape: tuple[int, int]
    map_shape: tuple[int, int]

    @classmethod
    def around(cls, top: int, left: int, bottom: int, right: int, map_shape: tuple[int, int], side: int) -> Window:
        """Return the square of `side` cells about the middle of a rectangle, moved to lie on the map.

        It is as long as the map where the map is shorter; `side` grows by powers of two until the rectangle fits.

        Parameters
        ----------
        top, left, bottom, right
            First and last row and column of the rectangle.
        side
            A power of two.

        Examples
        --------
        >>> Window.around(3, 90, 3, 90, (100, 100), 32)
        Window(top=0, left=68, shape=(32, 32), map_shape=(100, 100))
        >>> Window.around(3, 90, 3, 90, (100, 100), 128).shape
        (100, 100)
        """
        while side <= max(bottom - top, right - left):
            side *= 2
        rows, cols = (min(side, n) for n in map_shape)
        first = [
            min(max((low + high + 1) // 2 - n // 2, 0), whole - n)
            for low, high, n, whole in ((top, bottom, rows, map_shape[0]), (left, right, cols, map_shape[1]))
        ]
        return cls(first[0], first[1], (rows, cols), map_shape)

    @property
    def slices(self) -> tuple[slice, slice]:
        """Rows and columns of the map."""
        rows, cols = self.shape
        return slice(self.top, self.top + rows), slice(self.left, self.left + cols)

    @property
    def corner(self) -> int:
        """Number of the first cell on the map."""
        return self.top * self.map_shape[1] + self.left

    @property
    def whole(self) -> bool:
        """Whether it is the map."""
        return self.shape == self.map_shape

    def grid(self, grid: Grid) -> Grid:
        """Return the grid of the window on that of the map."""
        from affine import Affine

        return Grid(self.shape, grid.transform * Affine.translation(self.left, self.top), grid.crs)

    def local(self, cells: np.ndarray) -> np.ndarray:
        """Numbers in the window of cells of the map that lie in it; -1 stays -1."""
        row, col = np.divmod(cells, self.map_shape[1])
        return np.where(cells < 0, -1, (row - self.top) * self.shape[1] + col - self.left)

    def on_map(self, cells: np.ndarray) -> np.ndarray:
        """Numbers on the map of cells of the window."""
        row, col = np.divmod(cells, self.shape[1])
        return np.asarray((row + self.top) * self.map_shape[1] + col + self.left)

    def rim(self, reach: int) -> np.ndarray:
        """(rows, cols) bool: cells within `reach` cells of a side beyond which the map goes on."""
        rows, cols = self.shape
        out = np.zeros(self.shape, bool)
        out[: reach * (self.top > 0)] = True
        out[rows - reach * (self.top + rows < self.map_shape[0]) :] = True
        out[:, : reach * (self.left > 0)] = True
        out[:, cols - reach * (self.left + cols < self.map_shape[1]) :] = True
        return out


def tiles(cells: np.ndarray, starts: np.ndarray, map_shape: tuple[int, int], side: int) -> Iterator[np.ndarray]:
    """Runs that start near each other, those of one tile of the map after those of another.

    Parameters
    ----------
    cells, starts
        Ignition cells of run i are ``cells[starts[i]:starts[i + 1]]``; -1 burns nothing.
    side
        Of a tile [cells].

    Yields
    ------
    numpy.ndarray
        Run numbers. A run with ignitions in several tiles is alone.
    """
    tile = np.where(
        cells < 0, -1, cells // map_shape[1] // side * (map_shape[1] // side + 1) + cells % map_shape[1] // side
    )
    first = np.full(starts.size - 1, -1)
    alone = np.zeros(starts.size - 1, bool)
    for run in range(starts.size - 1):
        own = tile[starts[run] : starts[run + 1]]
        if (own >= 0).any():
            own = own[own >= 0]
            first[run], alone[run] = own[0], (own != own[0]).any()
    for run in np.flatnonzero(alone).tolist():
        yield np.array([run])
    rest = np.flatnonzero((first >= 0) & ~alone)
    order = rest[np.argsort(first[rest], kind="stable")]
    yield from (each for each in np.split(order, np.flatnonzero(np.diff(first[order])) + 1) if each.size)
