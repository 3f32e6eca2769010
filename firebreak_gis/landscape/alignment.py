"""Laying one layer on the grid: copied where it fits, else resampled, never the wrong way round.

Quantities are interpolated, or averaged when cells get coarser; classes take the nearest cell, or the
commonest. "Coarser" means that a cell of the grid covers at least two of the layer.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Literal

import numpy as np
from affine import Affine

from firebreak_gis.errors import InputError, VerificationError
from firebreak_gis.grid import SAME_GRID_TOLERANCE, Grid, crs_name
from firebreak_gis.landscape.grid_part import GridPart
from firebreak_gis.landscape.resampling import BLOCK, Placed, average, bilinear, mode, nearest, shared_out, touched
from firebreak_gis.landscape.target_grid import Account, cell_in
from firebreak_gis.projections import outline, transform
from firebreak_gis.rasters import Cells, Header, read_cells
from firebreak_gis.rasters.nodata import Extremes, told_of

if TYPE_CHECKING:
    from firebreak_gis.rasters.reading import Window

#: A cell of the grid that covers this many cells of a layer is filled by average or mode.
COARSER = 2.0
#: Class codes may be off whole numbers by so much: programs compute them in floating point.
ROUNDING = 1e-5
#: Stands for "no data" among class codes.
MISSING = -1
#: Which cells of another grid belong to an area.
MaskRule = Literal["touched", "centre", "within"]
MASK_RULES: Mapping[MaskRule, str] = MappingProxyType(
    {"touched": "every cell with a part inside", "centre": "cells whose centre lies inside", "within": "whole cells"}
)


@dataclass(frozen=True)
class Placing:
    """How a layer comes onto the grid.

    Parameters
    ----------
    window
        Part of the layer that is read (first row, first column, rows, columns), counted from the
        north-west of an upright layer; zero rows or columns if nothing lies on the grid.
    copy
        Whether the window is the grid, so that nothing is computed.
    coarser
        Whether average and mode are used.
    cells
        Sides of a cell of the layer, measured on the grid.
    """

    window: Window
    copy: bool
    coarser: bool
    cells: tuple[float, float]


def placing(header: Header, grid: Grid) -> Placing:
    """Decide from the header alone how a layer comes onto the grid; onto a part as onto the whole."""
    if isinstance(grid, GridPart):
        return _narrowed(placing(header, grid.whole), header, grid)
    upright = _upright(header)
    left, bottom, right, top = grid.bounds
    assert grid.crs is not None
    sides = cell_in(header, grid.crs, (left + right) / 2, (bottom + top) / 2)
    fit = _fit(upright, header, grid)
    if fit is not None:
        return Placing((*fit, *grid.shape), copy=True, coarser=False, cells=sides)
    coarser = grid.cell_size**2 >= COARSER * sides[0] * sides[1]
    return Placing(_window(upright, header, grid, sides), copy=False, coarser=coarser, cells=sides)


def _narrowed(how: Placing, header: Header, part: GridPart) -> Placing:
    if how.copy:
        corner = (how.window[0] + part.corner[0], how.window[1] + part.corner[1])
        return replace(how, window=(*corner, *part.shape))
    return replace(how, window=_window(_upright(header), header, part, how.cells))


def strips(header: Header, how: Placing, *, strict: bool = False, sentinels: bool = False) -> Iterator[Cells]:
    """Read what lies on the grid of a layer by strips of rows, from the north, as whole layers are read."""
    row, col, rows, cols = how.window
    step = max(1, BLOCK // max(cols, 1))
    for first in range(row, row + rows, step):
        part = replace(how, window=(first, col, min(step, row + rows - first), cols))
        yield _read(header, part, strict, sentinels)


def with_nodata(header: Header, grid: Grid, name: str, account: Account) -> Header:
    """Look through a layer for undeclared "no data" values; the header with them, so that its parts are read alike.

    Parameters
    ----------
    header, grid, name, account
        As in `align_values`.
    """
    if header.nodata or header.masked or header.declared:
        return header
    found = Extremes()
    for cells in strips(replace(header, scale=1.0, offset=0.0), placing(header, grid)):
        found.add(cells.values, cells.valid)
    nodata = found.undeclared()
    for note in told_of(nodata, header.path, strict=account.strict):
        account.warn(f"{name}: {note}")
    return replace(header, nodata=tuple(nodata), declared=True)


def align_values(
    header: Header, grid: Grid, name: str, account: Account, *, settle: Callable[[np.ndarray], np.ndarray] | None = None
) -> np.ndarray:
    """Return a quantity on the grid as float32 (rows, cols), NaN for no data.

    Parameters
    ----------
    header, grid, name, account
        The layer, where it goes, its name for messages, and where is written what was done.
    settle
        Takes the float32 values as they lie in the layer, NaN for no data, and returns those that count: units, voids
        and flags must be settled before neighbours are mixed. It may raise.

    Raises
    ------
    InputError
        If the values cannot be used (see `rasters.read_cells`).
    """
    how = placing(header, grid)
    values = _values(header, how, name, account)
    if settle is not None and values.size:
        values = settle(values)
    account.alignment.append(_sentence(name, header, how, grid, "average" if how.coarser else "bilinear"))
    return _mixed(values, header, how, grid)


def align_quantity(
    header: Header, grid: Grid, name: str, account: Account, flagged: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Return a quantity among whose values stand flags, such as 255 for "outside"; flags are never mixed with it.

    A cell of the grid takes a flag where the nearest cell (cells coarser than the layer's: the commonest) has it, else
    the quantity of the cells without.

    Parameters
    ----------
    header, grid, name, account
        As in `align_values`.
    flagged
        Takes float32 values, NaN for no data; returns which of them are flags.
    """
    how = placing(header, grid)
    values = _values(header, how, name, account)
    account.alignment.append(_sentence(name, header, how, grid, "average" if how.coarser else "bilinear"))
    flags = flagged(values)
    if how.copy or not flags.any():
        return _mixed(values, header, how, grid)
    quantity = _mixed(np.where(flags, np.float32(np.nan), values), header, how, grid)
    words, codes = np.unique(values[flags], return_inverse=True)
    votes = np.where(np.isnan(values), MISSING, 0).astype(np.int32)
    votes[flags] = codes + 1
    voted = (mode if how.coarser else nearest)(votes, _placed(header, how), grid, MISSING)
    if not isinstance(grid, GridPart):  # a part does not know all
        account.alignment.append(flags_told(name, words))
    return np.where(voted > 0, words[np.maximum(voted - 1, 0)], quantity)


def flags_told(name: str, flags: np.ndarray) -> str:
    """Say which values of a quantity were taken as flags."""
    return f"{name}: its flags {', '.join(f'{word:g}' for word in flags[:8])} were not mixed with it"


def _values(header: Header, how: Placing, name: str, account: Account) -> np.ndarray:
    """Values of the part of a layer that is read, float32, NaN for no data."""
    cells = _read(header, how, account.strict, sentinels=True)
    _tell(cells, name, account)
    return np.where(cells.valid, cells.values, np.nan).astype(np.float32)


def _mixed(values: np.ndarray, header: Header, how: Placing, grid: Grid) -> np.ndarray:
    if how.copy:
        return values
    if not values.size:
        return np.full(grid.shape, np.nan, dtype=np.float32)
    return (average if how.coarser else bilinear)(values, _placed(header, how), grid)


def align_classes(header: Header, grid: Grid, name: str, account: Account) -> np.ndarray:
    """Return class codes on the grid as int32 (rows, cols), MISSING (-1) for no data.

    Raises
    ------
    InputError
        If the codes are not whole numbers, or negative.
    VerificationError
        If a code came out that did not go in.
    """
    how = placing(header, grid)
    cells = _read(header, how, strict=False, sentinels=False)
    _tell(cells, name, account)
    codes = _as_codes(cells, header, name)
    account.alignment.append(_sentence(name, header, how, grid, "mode" if how.coarser else "nearest"))
    if how.copy:
        return codes
    if not codes.size:
        return np.full(grid.shape, MISSING, dtype=np.int32)
    result = (mode if how.coarser else nearest)(codes, _placed(header, how), grid, MISSING)
    new = np.setdiff1d(result, codes)
    if np.any(new != MISSING):
        raise VerificationError(
            f"{name}: aligning made the codes {new[new != MISSING][:5]}, which were not in the raster"
        )
    return result


def align_mask(header: Header, grid: Grid, name: str, account: Account, rule: MaskRule) -> np.ndarray:
    """Return an area given as a raster, above 0 inside, as bool (rows, cols); no data lies outside.

    Parameters
    ----------
    header, grid, name, account
        As in `align_classes`.
    rule
        Cells of another grid: `"touched"` takes those that any part of the area overlaps, `"centre"` those whose centre
        lies in it, `"within"` those of which no part lies outside.

    Raises
    ------
    InputError
        If the raster lies elsewhere, or holds fractions.
    """
    how = placing(header, grid)
    cells = _read(header, how, strict=False, sentinels=False)
    _tell(cells, name, account)
    inside = cells.values[cells.valid]
    if inside.dtype.kind == "f" and (broken := inside[inside != np.round(inside)]).size:
        raise InputError(
            f"{header.path} holds fractions such as {broken[0]:g}, expected a mask of whole numbers for {name}, above "
            "0 inside; if it was resampled make it again with nearest, if it is a quantity make a mask of it first"
        )
    mask = cells.valid & (cells.values > 0)
    placed = _placed(header, how)
    covered = cells.valid if how.copy else nearest(cells.valid, placed, grid, missing=False)
    if not covered.any():
        raise InputError(f"{name} does not touch the landscape {grid.describe()}; is {header.path} the right file?")
    account.alignment.append(_sentence(name, header, how, grid, f"classes, {MASK_RULES[rule]}"))
    others = np.setdiff1d(np.unique(inside[inside > 0]), [1])
    if others.size:
        account.alignment.append(
            f"{name}: all values above 0 count as inside, here also {', '.join(f'{v:g}' for v in others[:5])}"
        )
    if not covered.all():
        account.alignment.append(
            f"{name}: the raster tells nothing about {1 - covered.mean():.3g} of the landscape, which counts as outside"
        )
    if how.copy:
        return np.asarray(mask)
    centre = nearest(mask, placed, grid, missing=False)
    if rule == "centre":
        return centre
    if rule == "within":
        centre &= ~touched(~mask, placed, grid, how.cells)
        return centre
    return touched(mask, placed, grid, how.cells)


def align_amounts(
    header: Header, grid: Grid, name: str, account: Account, *, settle: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Return amounts (so much in each cell, such as people) on the grid as float64 (rows, cols), their sum kept.

    Cells without data hold nothing, which is said. `settle` is as in `align_values`.

    Raises
    ------
    InputError
        If the values cannot be used, or lie elsewhere.
    """
    how = placing(header, grid)
    cells = _read(header, how, account.strict, sentinels=True)
    _tell(cells, name, account)
    placed = _placed(header, how)
    known = cells.valid if how.copy else nearest(cells.valid, placed, grid, missing=False)
    if not known.any():
        raise InputError(f"{name} holds no data on the landscape {grid.describe()}; is {header.path} the right file?")
    if not known.all():
        missing = int(np.count_nonzero(~known))
        account.alignment.append(
            f"{name}: no data on {missing} cells ({missing * grid.cell_area_ha:,.6g} ha), counted as 0"
        )
    amounts = np.nan_to_num(settle(np.where(cells.valid, cells.values, np.nan).astype(np.float64)), nan=0.0)
    account.alignment.append(_sentence(name, header, how, grid, "shares that keep the sum"))
    return amounts if how.copy else shared_out(amounts, placed, grid, how.cells)


def _tell(cells: Cells, name: str, account: Account) -> None:
    account.alignment.extend(f"{name}: {said}" for said in cells.said)
    for note in cells.notes:
        account.warn(f"{name}: {note}")


def _upright(header: Header) -> Affine:
    """Transform of the layer once it is turned north-up; unchanged if it is rotated."""
    t = header.transform
    if t.b != 0 or t.d != 0:
        return t
    left, _, _, top = header.bounds
    return Affine(abs(t.a), 0.0, left, 0.0, -abs(t.e), top)


def _fit(upright: Affine, header: Header, grid: Grid) -> tuple[int, int] | None:
    """Row and column of the layer at which the grid begins, if its cells are cells of the layer."""
    if header.crs != grid.crs or upright.b != 0 or upright.d != 0:
        return None
    rows, cols = grid.shape
    corners = [~upright @ (grid.transform @ corner) for corner in ((0, 0), (cols, rows))]
    if any(abs(v - round(v)) > SAME_GRID_TOLERANCE for corner in corners for v in corner):
        return None
    (col, row), (last_col, last_row) = [(round(c), round(r)) for c, r in corners]
    if (last_col - col, last_row - row) != (cols, rows) or col < 0 or row < 0:
        return None
    return (row, col) if last_row <= header.shape[0] and last_col <= header.shape[1] else None


def _window(upright: Affine, header: Header, grid: Grid, sides: tuple[float, float]) -> Window:
    """Part of the layer that touches the grid, with a margin for interpolation and curved edges."""
    x, y = outline(grid.transform, grid.shape, points=41)
    assert grid.crs is not None
    x, y = transform(grid.crs, header.crs, x, y)
    if header.crs is not None and header.crs.is_geographic:
        # The same turn of the globe as the layer.
        x = np.unwrap(x, period=360.0)
        x = x - 360.0 * round((float(x.mean()) - (header.bounds[0] + header.bounds[2]) / 2) / 360.0)
    x, y = (np.asarray(part) for part in (x, y))
    inverse = ~upright
    col, row = inverse.a * x + inverse.b * y + inverse.c, inverse.d * x + inverse.e * y + inverse.f
    margin = 3 + math.ceil(2 * grid.cell_size / min(sides))
    rows, cols = header.shape
    first_row, last_row = max(math.floor(row.min()) - margin, 0), min(math.ceil(row.max()) + margin, rows)
    first_col, last_col = max(math.floor(col.min()) - margin, 0), min(math.ceil(col.max()) + margin, cols)
    return first_row, first_col, max(last_row - first_row, 0), max(last_col - first_col, 0)


def _read(header: Header, how: Placing, strict: bool, sentinels: bool) -> Cells:
    """Read the window of a layer, turned north-up."""
    row, col, rows, cols = how.window
    if rows == 0 or cols == 0:
        empty = np.zeros((0, 0))
        return Cells(empty, empty.astype(bool))
    t = header.transform
    straight = t.b == 0 and t.d == 0
    down = straight and t.e > 0
    back = straight and t.a < 0
    first_row = header.shape[0] - row - rows if down else row
    first_col = header.shape[1] - col - cols if back else col
    cells = read_cells(header, (first_row, first_col, rows, cols), strict=strict, sentinels=sentinels)
    turn = (slice(None, None, -1 if down else 1), slice(None, None, -1 if back else 1))
    return Cells(cells.values[turn], cells.valid[turn], cells.notes, cells.said)


def _as_codes(cells: Cells, header: Header, name: str) -> np.ndarray:
    inside = cells.values[cells.valid]
    if inside.dtype.kind == "f":
        whole = np.round(inside)
        broken = inside[np.abs(inside - whole) > ROUNDING]
        if broken.size:
            raise InputError(
                f"{header.path} holds fractions such as {broken[0]:.10g} where class codes are expected; it "
                f"looks resampled: make it "
                "again with nearest, or, if it is a quantity such as cover in percent, give a legend with "
                "ranges"
            )
        inside = whole
    if inside.size and (inside.min() < -(2**31) or inside.max() >= 2**31):
        raise InputError(f"{header.path} holds codes up to {inside.max():g}, too great for class codes")
    if inside.size and (inside < 0).any():
        wrong = np.unique(inside[inside < 0])[:5]
        raise InputError(
            f"{header.path} holds the negative codes {', '.join(f'{v:g}' for v in wrong)}, expected class "
            f"codes from 0; "
            f"if they mean no data, say so (--src-nodata {name}={wrong[0]:g})"
        )
    # np.where(valid, values, -1) would keep the type of the raster and turn -1 into class 255.
    codes = np.full(cells.values.shape, MISSING, dtype=np.int32)
    codes[cells.valid] = inside
    return codes


def _placed(header: Header, how: Placing) -> Placed:
    assert header.crs is not None
    return Placed(_upright(header), header.crs, how.window[0], how.window[1], how.window[2:])


def _sentence(name: str, header: Header, how: Placing, grid: Grid, method: str) -> str:
    assert header.crs is not None
    if how.copy:
        return f"{name}: copied cell by cell, its cells are those of the grid"
    t = header.transform
    turned = ", rotated" if t.b != 0 or t.d != 0 else ", south-up" if t.e > 0 else ""
    what = f"cells of {math.hypot(t.a, t.d):.6g} x {math.hypot(t.b, t.e):.6g} in {crs_name(header.crs)}{turned}"
    width, height = how.cells
    size = f"about {width:.4g} x {height:.4g} m"
    return f"{name}: resampled by {method} from {what} ({size}) to {grid.cell_size:g} m"
