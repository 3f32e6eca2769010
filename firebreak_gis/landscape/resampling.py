"""Values of one raster on the cells of another grid, by exact transformation of every cell centre.

Each result depends on its own cell alone: not on tiles, threads or releases. Cost: one coordinate
transformation a cell where the reference systems differ (about 1 microsecond), little otherwise.

Why not GDAL's warper (measured with GDAL 3.10 and 3.12, rasterio 1.4.4 and 1.5.2, random classes):

* by default it interpolates coordinates: 121,004 of 1.8 million nearest cells were not the nearest, and
  69,991 changed with the tiles. `reproject(tolerance=0)` is exact in rasterio 1.5 and ignored in 1.4;
  `WarpedVRT(tolerance=0)` does not open in either.
* `WarpedVRT(tolerance=1e-12, XSCALE="1", YSCALE="1")` is exact for nearest and bilinear in both; the tests
  hold `nearest` and `bilinear` against it.
* mode counts cells in GDAL 3.10 and weighs them by area in 3.12, so the same input gives other classes.
* average and mode take the box between two opposite corners of a cell, which is wrong for rotated layers
  and a line at 45 degrees.

All four stay here, so that the layers of one landscape are laid by one and the same transformation.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from affine import Affine

from firebreak_gis.grid import Grid
from firebreak_gis.kernels.keys import distinct
from firebreak_gis.projections import transform

if TYPE_CHECKING:
    from pyproj import CRS

#: Cells handled at once; bounds the memory for coordinates.
BLOCK = 1 << 20
#: A point nearer than this to the edge of two cells is on it, and belongs to the east or south one.
ON_EDGE = 1e-6
#: A cell that overlaps another by less than this part of its side only touches it, since grids are equal within it.
WITHIN = 1e-3
#: Points across a fine cell, and across a cell of the grid under coarse ones, by which amounts are shared out.
FINE_POINTS, POINTS = 4, 2
#: Cells that amounts of coarse cells are followed beyond the grid.
FARTHEST = 200


@dataclass(frozen=True)
class Placed:
    """Where an array of cells lies.

    Parameters
    ----------
    transform, crs
        Of the whole raster from which the array was read.
    row, col
        First cell of the array in it.
    shape
        (rows, cols) of the array.
    """

    transform: Affine
    crs: CRS
    row: int
    col: int
    shape: tuple[int, int]


def nearest(values: np.ndarray, placed: Placed, grid: Grid, missing: float) -> np.ndarray:
    """Return the value of the cell in which each cell centre of `grid` lies, `missing` outside.

    Parameters
    ----------
    values
        (rows, cols), any dtype; the result has the same.
    placed
        Where they lie.
    grid
        Of the result.
    missing
        A value of the dtype.
    """
    result = np.full(grid.shape, missing, dtype=values.dtype)
    for rows, col, row in _source_cells(placed, grid):
        inside, r, c = _inside(row, col, values.shape)
        result[rows][inside] = values[r, c]
    return result


def bilinear(values: np.ndarray, placed: Placed, grid: Grid) -> np.ndarray:
    """Interpolate between the four cell centres around each cell centre of `grid`.

    NaN cells are left out and the weights of the others scaled up; NaN where the cell centre lies in
    a NaN cell or outside the raster.

    Parameters
    ----------
    values
        (rows, cols) float32; as the result.
    placed, grid
        As in `nearest`.
    """
    result = np.full(grid.shape, np.nan, dtype=np.float32)
    last_row, last_col = values.shape[0] - 1, values.shape[1] - 1
    for rows, col, row in _source_cells(placed, grid):
        inside, r, c = _inside(row, col, values.shape)
        x, y = col[inside] - 0.5, row[inside] - 0.5
        x0, y0 = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
        dx, dy = x - x0, y - y0
        total, weights = np.zeros(x.shape), np.zeros(x.shape)
        for step_row, part_y in ((0, 1.0 - dy), (1, dy)):
            for step_col, part_x in ((0, 1.0 - dx), (1, dx)):
                near = values[(y0 + step_row).clip(0, last_row), (x0 + step_col).clip(0, last_col)]
                weight = np.where(np.isnan(near), 0.0, part_x * part_y)
                total += weight * np.nan_to_num(near)
                weights += weight
        known = ~np.isnan(values[r, c])
        filled = np.full(x.shape, np.nan)
        filled[known] = total[known] / weights[known]
        result[rows][inside] = filled
    return result


def average(values: np.ndarray, placed: Placed, grid: Grid) -> np.ndarray:
    """Return the mean of the cells whose centres lie in each cell of `grid`; NaN cells do not count.

    Cells of `grid` without any centre are interpolated.

    Parameters
    ----------
    values
        (rows, cols) float32; as the result.
    placed, grid
        As in `nearest`.
    """
    size = grid.shape[0] * grid.shape[1]
    total, counts = np.zeros(size), np.zeros(size, dtype=np.int64)
    touched = np.zeros(size, dtype=bool)
    for rows, index in _target_cells(placed, grid):
        part = values[rows].ravel()
        touched[index[index >= 0]] = True
        used = (index >= 0) & ~np.isnan(part)
        total += np.bincount(index[used], weights=part[used].astype(np.float64), minlength=size)
        counts += np.bincount(index[used], minlength=size)
    result = np.full(size, np.nan)
    np.divide(total, counts, out=result, where=counts > 0)
    means = result.reshape(grid.shape).astype(np.float32)
    empty = ~touched.reshape(grid.shape)
    if empty.any():
        means[empty] = bilinear(values, placed, grid)[empty]
    return means


def mode(codes: np.ndarray, placed: Placed, grid: Grid, missing: int) -> np.ndarray:
    """Return the commonest code among the cells whose centres lie in each cell of `grid`.

    Missing cells vote as a class of their own, so bare land does not vanish. Among equally many the
    lowest code wins, missing last. Cells of `grid` without any centre take the nearest cell.

    Parameters
    ----------
    codes
        (rows, cols) integers; the result has their dtype.
    placed, grid, missing
        As in `nearest`.
    """
    size = grid.shape[0] * grid.shape[1]
    index = np.concatenate([part for _, part in _target_cells(placed, grid)] or [np.empty(0, dtype=np.int64)])
    flat = codes.ravel()[index >= 0]
    index = index[index >= 0]
    best, votes = np.full(size, missing, dtype=codes.dtype), np.zeros(size, dtype=np.int64)
    present = distinct(flat)
    for code in [*present[present != missing], missing]:
        counted = np.bincount(index[flat == code], minlength=size)
        better = counted > votes
        best[better] = code
        votes[better] = counted[better]
    result = best.reshape(grid.shape)
    empty = votes.reshape(grid.shape) == 0
    if empty.any():
        result[empty] = nearest(codes, placed, grid, missing)[empty]
    return result


def touched(mask: np.ndarray, placed: Placed, grid: Grid, sides: tuple[float, float]) -> np.ndarray:
    """Return which cells of `grid` any true cell overlaps, however little.

    Parameters
    ----------
    mask
        (rows, cols) bool.
    placed, grid
        As in `nearest`.
    sides
        Width and height of a cell of the mask on the grid.

    Notes
    -----
    Exact for upright grids in one CRS: points on each true cell, from edge to edge and no further apart than a cell of
    the grid, fall into each cell that it overlaps.
    """
    assert grid.crs is not None
    found = np.zeros(grid.shape, dtype=bool)
    row, col = np.nonzero(mask)
    across, down = (
        np.clip(np.linspace(0.0, 1.0, math.ceil(side / grid.cell_size) + 1), WITHIN, 1.0 - WITHIN) for side in sides
    )
    step = max(1, BLOCK // (across.size * down.size))
    for first in range(0, row.size, step):
        part = slice(first, first + step)
        y, x = np.broadcast_arrays(
            placed.row + row[part, None, None] + down[:, None], placed.col + col[part, None, None] + across
        )
        x, y = _apply(placed.transform, x.ravel(), y.ravel())
        x, y = transform(placed.crs, grid.crs, x, y)
        target_col, target_row = grid.position(x, y)
        _, r, c = _inside(target_row, target_col, grid.shape)
        found[r, c] = True
    return found


def shared_out(amounts: np.ndarray, placed: Placed, grid: Grid, sides: tuple[float, float]) -> np.ndarray:
    """Share the amount in each cell out among the cells of `grid` that it overlaps; the sum stays the same.

    Parameters
    ----------
    amounts
        (rows, cols) float64 without NaN: so much in each cell, such as people.
    placed, grid
        As in `nearest`.
    sides
        Width and height of a cell on the grid.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64. What lies outside the grid is left out.

    Notes
    -----
    By points: of a fine cell `FINE_POINTS` across, each with its part; of a coarse cell all points (`POINTS` across a
    cell of the grid) that fall into it, in equal parts. The sum is exact; so are the shares where edges of cells meet.
    """
    if sides[0] * sides[1] <= grid.cell_size**2:
        return _fine_shared_out(amounts, placed, grid)
    reach = math.ceil(max(sides) / grid.cell_size) + 1  # so that a cell at the edge has all its points
    counted = reach <= FARTHEST
    pad = reach if counted else 0
    t, (rows, cols) = grid.transform, grid.shape
    points = Grid(
        ((rows + 2 * pad) * POINTS, (cols + 2 * pad) * POINTS),
        t @ Affine.translation(-pad, -pad) @ Affine.scale(1.0 / POINTS),
        grid.crs,
    )
    flat = np.append(amounts.ravel(), 0.0)
    cells = np.full(points.shape, amounts.size, dtype=np.int32)  # the last stands for outside
    for part, col, row in _source_cells(placed, points):
        inside, r, c = _inside(row, col, amounts.shape)
        cells[part][inside] = r * amounts.shape[1] + c
    n_points = np.bincount(cells.ravel(), minlength=flat.size).astype(np.float64)
    if not counted:  # cells far larger than the landscape: their area tells how many points they would have
        n_points[:] = sides[0] * sides[1] / (grid.cell_size / POINTS) ** 2
    shares = (flat / np.maximum(n_points, 1.0))[cells]
    summed = shares.reshape(rows + 2 * pad, POINTS, cols + 2 * pad, POINTS).sum(axis=(1, 3))
    return np.asarray(summed[pad : pad + rows, pad : pad + cols])


def _fine_shared_out(amounts: np.ndarray, placed: Placed, grid: Grid) -> np.ndarray:
    size = grid.shape[0] * grid.shape[1]
    total = np.zeros(size)
    offsets = (np.arange(FINE_POINTS) + 0.5) / FINE_POINTS - 0.5
    for down in offsets:
        for across in offsets:
            moved = replace(placed, transform=placed.transform @ Affine.translation(across, down))
            for rows, index in _target_cells(moved, grid):
                used = index >= 0
                total += np.bincount(index[used], weights=amounts[rows].ravel()[used], minlength=size)
    return (total / FINE_POINTS**2).reshape(grid.shape)


def _source_cells(placed: Placed, grid: Grid) -> Iterator[tuple[slice, np.ndarray, np.ndarray]]:
    """Yield rows of the grid with the position of their cell centres in the array, in cells.

    Positions are (rows, cols) floats, counted from the corner of the array.
    """
    assert grid.crs is not None
    step = max(1, BLOCK // grid.shape[1])
    for first in range(0, grid.shape[0], step):
        rows = slice(first, min(first + step, grid.shape[0]))
        x, y = np.broadcast_arrays(grid.x[np.newaxis, :], grid.y[rows, np.newaxis])
        x, y = transform(grid.crs, placed.crs, x, y)
        col, row = _apply(~placed.transform, _same_turn(x, placed), y)
        yield rows, col - placed.col, row - placed.row


def _target_cells(placed: Placed, grid: Grid) -> Iterator[tuple[slice, np.ndarray]]:
    """Yield rows of the array with the row-major cell of the grid in which each centre lies, or -1."""
    rows_, cols_ = placed.shape
    if rows_ == 0 or cols_ == 0:
        return
    step = max(1, BLOCK // cols_)
    col = placed.col + np.arange(cols_)[np.newaxis, :] + 0.5
    for first in range(0, rows_, step):
        rows = slice(first, min(first + step, rows_))
        row = placed.row + np.arange(rows.start, rows.stop)[:, np.newaxis] + 0.5
        x, y = _apply(placed.transform, *np.broadcast_arrays(col, row))
        x, y = transform(placed.crs, grid.crs, x, y)
        target_col, target_row = grid.position(x, y)
        inside, r, c = _inside(target_row, target_col, grid.shape)
        index = np.full(inside.shape, -1, dtype=np.int64)
        index[inside] = r * grid.shape[1] + c
        yield rows, index.ravel()


def _same_turn(x: np.ndarray, placed: Placed) -> np.ndarray:
    """Bring longitudes to the turn of the globe on which the raster is described."""
    if not placed.crs.is_geographic:
        return x
    middle = placed.transform.c + placed.transform.a * (placed.col + placed.shape[1] / 2)
    with np.errstate(invalid="ignore"):
        return x - 360.0 * np.round((x - middle) / 360.0)


def _apply(t: Affine, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return t.a * x + t.b * y + t.c, t.d * x + t.e * y + t.f


def _inside(row: np.ndarray, col: np.ndarray, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Which positions fall in the array, and the row and column of those."""
    r, c = np.floor(row + ON_EDGE), np.floor(col + ON_EDGE)
    # Positions that the transformation cannot reach are infinite and fail these comparisons.
    inside = (r >= 0) & (r < shape[0]) & (c >= 0) & (c < shape[1])
    return inside, r[inside].astype(np.int64), c[inside].astype(np.int64)
