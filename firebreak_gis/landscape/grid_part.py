"""A window of a grid."""

from __future__ import annotations

from typing import TYPE_CHECKING

from affine import Affine

from firebreak_gis.grid import Grid

if TYPE_CHECKING:
    import numpy as np


class GridPart(Grid):
    """A window of a grid, whose cells lie where those of the whole do, to the last bit.

    Parameters
    ----------
    whole
        The grid.
    window
        First row and column, rows and columns.
    """

    def __init__(self, whole: Grid, window: tuple[int, int, int, int]) -> None:
        row, col, rows, cols = window
        super().__init__((rows, cols), whole.transform * Affine.translation(col, row), whole.crs)
        object.__setattr__(self, "whole", whole)
        object.__setattr__(self, "corner", (row, col))

    whole: Grid
    corner: tuple[int, int]

    @property
    def x(self) -> np.ndarray:
        """As of the whole."""
        return self.whole.x[self.corner[1] : self.corner[1] + self.shape[1]]

    @property
    def y(self) -> np.ndarray:
        """As of the whole."""
        return self.whole.y[self.corner[0] : self.corner[0] + self.shape[0]]

    def position(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """As in the whole."""
        col, row = self.whole.position(x, y)
        return col - self.corner[1], row - self.corner[0]
