"""Existing breaks, drawn or as a raster, one by one: the cells of each, how long it is and where it ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.kernels.keys import distinct
from firebreak_gis.landscape.footprints import close_corners, footprints
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.schema import MapLayer, Shown
from firebreak_gis.vectors import is_vector, read_features

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.planes import Source


@dataclass(frozen=True, repr=False, eq=False)
class Existing(Shown):
    """Breaks that stand.

    Parameters
    ----------
    frame
        One line or polygon a break, in the CRS of the grid.
    cells
        Of each break, sorted row-major numbers of the cells that it takes, int64; a cell may be in several.
    ends
        Of each break, (2, 2) float64, x and y of its two ends.
    """

    frame: gpd.GeoDataFrame
    cells: list[np.ndarray]
    ends: list[np.ndarray]

    def __len__(self) -> int:
        return len(self.cells)

    def mask(self, shape: tuple[int, int]) -> np.ndarray:
        """(rows, cols) bool: the cells of all."""
        plane = np.zeros(shape, bool)
        for own in self.cells:
            plane.ravel()[own] = True
        return plane

    def facts(self) -> dict[str, object]:
        """How many and how long, as `repr` and notebooks show them."""
        taken = distinct(np.concatenate(self.cells)).size if self.cells else 0
        return {"breaks": len(self), "length": f"{self.lengths.sum() / 1000:,.4g} km", "cells": f"{taken:,}"}

    def layers(self) -> tuple[MapLayer, ...]:
        """The breaks as they are drawn."""
        return (MapLayer(f"{len(self)} existing breaks", self.frame),)

    @property
    def lengths(self) -> np.ndarray:
        """Length of each [m]: of a line its own, of an area the long side of the smallest rectangle about it."""
        found = [
            shape.length if "Line" in shape.geom_type else float(np.hypot(*np.subtract(*ends)))
            for shape, ends in zip(self.frame.geometry, self.ends, strict=True)
        ]
        return np.array(found)


def existing_breaks(source: Source, grid: Grid, *, what: str = "breaks", account: Account | None = None) -> Existing:
    """Read breaks one by one: each line or polygon, or each connected piece of a raster.

    Parameters
    ----------
    source
        As in `masks.mask_plane`. All cells that a line or polygon touches count, as there.
    grid
        The grid of the network.
    what
        Name for messages.
    account
        Gets sentences on what was done.

    Raises
    ------
    InputError
        If the source cannot be read, or lies elsewhere.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> landscape = fb.read_landscape(**fb.sample_layers(), resolution=200.0)
    >>> len(fb.existing_breaks("sample_data/roads.gpkg", fb.spread_network(landscape).grid).cells)
    4
    """
    account = account or Account()
    mask = mask_plane(source, grid, what=what, rule="touched", solid=True, account=account)
    if not is_vector(source):
        return _pieces(mask, grid)
    frame = read_features(source, grid.crs)
    prints = footprints(frame, grid)
    cells, kept = [], []
    for k in np.unique(prints.feature).tolist():
        own = np.zeros(grid.shape, bool)
        own.ravel()[prints.cell[prints.feature == k]] = True
        cells.append(np.flatnonzero(close_corners(own, frame.iloc[[k]], grid)))
        kept.append(k)
    drawn = frame.iloc[kept].reset_index(drop=True)
    if len(kept) < len(frame):
        account.warn(f"{what}: {len(frame) - len(kept)} of {len(frame)} lie off the landscape and are left out")
    return Existing(drawn, cells, [_ends(shape) for shape in drawn.geometry])


def _pieces(mask: np.ndarray, grid: Grid) -> Existing:
    import geopandas as gpd
    from scipy import ndimage

    from firebreak_gis.grid import outlines

    labels, n = ndimage.label(mask, structure=np.ones((3, 3)))
    frame = gpd.GeoDataFrame(geometry=outlines(labels, n, grid), crs=grid.crs)
    cells = [np.flatnonzero(labels.ravel() == k + 1) for k in range(n)]
    return Existing(frame, cells, [_ends(shape) for shape in frame.geometry])


def _ends(shape: Any) -> np.ndarray:
    """The two ends of a line, or the middles of the short sides of the smallest rectangle about an area."""
    import shapely

    if "Line" in shape.geom_type:
        points = shapely.get_coordinates(shape)
        return np.asarray(points[[0, -1]])
    box = shapely.get_coordinates(shapely.oriented_envelope(shape))[:4]
    if len(box) < 4:  # no width
        return np.asarray(box[[0, -1]])
    middles = (box + np.roll(box, -1, axis=0)) / 2
    pairs = (middles[[0, 2]], middles[[1, 3]])
    return max(pairs, key=lambda pair: float(np.hypot(*np.subtract(*pair))))
