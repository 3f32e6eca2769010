"""Breaks that are lines with a width in metres, which may be narrower than a cell.

A line stops fire on the links between neighbouring cells that it crosses. What it takes of the land is its length times
its width: that ground is no fuel where the line holds, and the rest of the cells beside it stays fuel.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.footprints import footprints_in_cells, in_cells
from firebreak_gis.network import neighbour

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.landscape.planes import Source
    from firebreak_gis.network import Residual, SpreadNetwork

#: Between the numbers of stretches that follow each other on a line; half of it is odd, so that all of a line differ.
_STEP = np.uint32(0x9E3779B2)


class Cleared(NamedTuple):
    """Ground that lines clear: one entry for each straight piece of a line and each cell of which it takes some.

    The parts of all pieces add up to length times width: what a bend takes twice inside, it lacks outside.

    Parameters
    ----------
    cell
        (n,) int64, rising, row-major number.
    part
        (n,) uint32, of the cell, of which the whole is `kernels.walls.GROUND`.
    width
        (n,) float32 of the line [m].
    line
        (n,) uint32: mark of the line, as in `LineBreaks`.
    along, whole
        (n,) float32 [m]: how far from its beginning this is, and how long it is, as there.
    """

    cell: np.ndarray
    part: np.ndarray
    width: np.ndarray
    line: np.ndarray
    along: np.ndarray
    whole: np.ndarray

    def window(self, rows: slice, cols: slice, n_cols: int) -> Cleared:
        """The entries in a window of a grid with `n_cols` columns."""
        row, col = np.divmod(self.cell, n_cols)
        inside = (row >= rows.start) & (row < rows.stop) & (col >= cols.start) & (col < cols.stop)
        cell = (row - rows.start) * (cols.stop - cols.start) + col - cols.start
        return Cleared(cell[inside], *(each[inside] for each in self[1:]))

    def stretches(self, length: float) -> np.ndarray:
        """As `LineBreaks.stretches`, of each entry."""
        return _stretches(self.line, self.along, self.whole, length)


@dataclass(frozen=True, eq=False)
class LineBreaks:
    """Breaks drawn as lines, on a grid; made by `line_breaks`.

    Parameters
    ----------
    lines
        In the CRS of the grid, with the column `width_m`.
    crossed
        (rows, cols) uint8: bit d is set where a line crosses the link to the neighbour in direction d
        (`lattice.DIRECTIONS`); links go both ways, so the neighbour has the bit of the opposite direction.
    width
        (rows, cols) float32 [m]: of the widest line across a link of the cell to a later cell, 0 for none.
    line
        (rows, cols) uint32: mark of the first line across such a link, which follows from where it begins and first
        goes to; 0 for none.
    along
        (rows, cols) float32 [m]: how far from the beginning of that line this is. The parts of a multiline are one
        line, the gaps between them count.
    whole
        (rows, cols) float32 [m]: how long that line is.
    cleared
        The ground that the lines take.
    grid
        The grid.
    cells
        (rows, cols) bool: whole cells that are cut beside the lines; None for none.
    """

    lines: gpd.GeoDataFrame
    crossed: np.ndarray
    width: np.ndarray
    line: np.ndarray
    along: np.ndarray
    whole: np.ndarray
    cleared: Cleared
    grid: Grid
    cells: np.ndarray | None = None

    @property
    def area_ha(self) -> float:
        """Length times width of all lines, what lies off the fuel included [ha]."""
        return float((self.lines.length * self.lines["width_m"]).sum()) / 10_000.0

    def part(self, rows: slice, cols: slice, grid: Grid) -> LineBreaks:
        """Return the breaks on a window of the grid."""
        here = rows, cols
        planes = {name: getattr(self, name)[here] for name in ("crossed", "width", "line", "along", "whole")}
        cleared = self.cleared.window(rows, cols, self.crossed.shape[1])
        cells = None if self.cells is None else self.cells[here]
        return replace(self, **planes, cleared=cleared, grid=grid, cells=cells)

    def stretches(self, length: float) -> np.ndarray:
        """Number of the stretch along its line in which each cell lies, (rows, cols) uint32, even.

        A line has as many equal stretches as come nearest to `length` metres, so that all lines together have about one
        for each `length`. Numbers follow from the line alone: lines that come later change none.
        """
        return _stretches(self.line, self.along, self.whole, length)

    def some(self, chosen: np.ndarray) -> LineBreaks:
        """Some of the lines alone, (n_lines,) bool, with all cells."""
        return replace(laid_on(self.lines[chosen], self.grid), cells=self.cells)

    @property
    def groundless(self) -> LineBreaks:
        """The same lines, which take no ground."""
        return replace(self, cleared=Cleared(*(each[:0] for each in self.cleared)))

    @cached_property
    def owners(self) -> np.ndarray:
        """The first line that crosses each link, (rows, cols, 8) int32 by their place in `lines`; -1 for none."""
        owner = np.full((*self.crossed.shape, 8), -1, np.int32)
        traced = _trace(self.lines, self.grid)
        first = np.searchsorted(traced.of, np.arange(len(self.lines) + 1))
        for k in range(len(self.lines)):
            crossed, rows, cols = _crossed_by(traced.ends[first[k] : first[k + 1]], self.grid)
            row, col = np.nonzero(crossed)
            across = (crossed[row, col, np.newaxis] >> np.arange(8, dtype=np.uint8)) & 1 > 0
            cells = row + rows.start, col + cols.start
            before = owner[cells]
            owner[cells] = np.where(across & (before < 0), k, before)
        return owner

    def parted(self, network: SpreadNetwork, *, residual: Residual = 0.0) -> SpreadNetwork:
        """Return a network with the lines in it: an edge across keeps `residual`, the share of the cell it leads to.

        So does an edge into a cell that is cut, see `SpreadNetwork.treated`, but once if it also crosses a line.
        """
        kept = np.broadcast_to(network.kept_share(residual).astype(np.float32), network.shape)
        network.grid.require(self.grid, "the lines")
        cells = np.zeros(network.shape, bool) if self.cells is None else self.cells
        values = network.probability.copy()
        for d in range(8):
            across = ((self.crossed >> d) & 1 > 0) & ~neighbour(cells, d, network.boundary)
            values[d][across] *= neighbour(kept, d, network.boundary)[across]
        lined = network.derived(probability=values)
        return lined if self.cells is None else lined.treated(cells, residual=residual)

    def spared(self, network: SpreadNetwork, *, residual: Residual = 0.0) -> np.ndarray:
        """Ground of each cell that does not burn with it where all lines hold, (n_cells,) int64 of `GROUND`."""
        from firebreak_gis.kernels.walls import GROUND

        total = np.zeros(network.burnable.size, np.int64)
        np.add.at(total, self.cleared.cell, self.cleared.part)
        kept = np.broadcast_to(network.kept_share(residual), network.shape).ravel()
        return np.floor(np.minimum(total, GROUND) * (1.0 - kept)).astype(np.int64)


def _stretches(line: np.ndarray, along: np.ndarray, whole: np.ndarray, length: float) -> np.ndarray:
    count = np.maximum(np.rint(whole / length), 1.0)
    share = along / np.maximum(whole, np.float32(1e-30))
    steps = np.minimum(np.floor(share * count), count - 1).astype(np.uint32)
    return np.asarray((line + steps * _STEP) & ~np.uint32(1), np.uint32)


def on_cells(
    network: SpreadNetwork, breaks: np.ndarray | xr.DataArray | LineBreaks | None, what: str
) -> np.ndarray | LineBreaks | None:
    """Breaks that have been held against the grid of a network, as they are sent: (rows, cols) bool, or lines."""
    return breaks if breaks is None or isinstance(breaks, LineBreaks) else network.mask(breaks, what)


def beside(
    cut: np.ndarray | xr.DataArray | LineBreaks | None, standing: np.ndarray | None
) -> np.ndarray | xr.DataArray | LineBreaks | None:
    """Breaks, and cells of breaks that stand already, (rows, cols) bool; None for none.

    Lines stay lines, with those cells; all else becomes cells.
    """
    if standing is None or not standing.any():
        return cut
    if isinstance(cut, LineBreaks):
        return replace(cut, cells=standing)
    return standing if cut is None else standing | (np.asarray(cut) > 0)


def line_breaks(source: Source, grid: Grid, *, width: float | str, what: str = "breaks") -> LineBreaks:
    """Lay lines with a width on a grid.

    Parameters
    ----------
    source
        Lines: path or GeoDataFrame with CRS.
    grid
        The grid of the network, of square cells in metres.
    width
        In metres, of all lines; or the column that tells it.
    what
        Name for messages.

    Raises
    ------
    InputError
        If the source cannot be read, holds other geometries or lies elsewhere, or has no such column.
    ParameterError
        If a width is not above 0.

    Examples
    --------
    >>> import geopandas as gpd, shapely
    >>> from affine import Affine
    >>> from firebreak_gis.grid import Grid, parse_crs
    >>> grid = Grid((2, 3), Affine(20, 0, 0, 0, -20, 40), parse_crs("EPSG:32635"))
    >>> road = gpd.GeoDataFrame(geometry=[shapely.LineString([(20, 0), (20, 40)])], crs=32635)
    >>> breaks = line_breaks(road, grid, width=6.0)
    >>> breaks.crossed.tolist()
    [[12, 96, 0], [6, 192, 0]]
    >>> breaks.area_ha
    0.024
    """
    from firebreak_gis.vectors import read_lines

    grid.require_metres("the width of lines")
    frame = read_lines(source, grid.crs)
    if isinstance(width, str):
        if width not in frame.columns:
            named = ", ".join(str(name) for name in frame.columns if name != "geometry") or "none"
            raise InputError(f"{what} has no column {width!r} for the width of the lines; its columns: {named}")
        try:
            metres = frame[width].to_numpy(dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(f"{what}: column {width!r} holds no numbers, expected widths in metres") from None
    else:
        metres = np.full(len(frame), float(width))
    wrong = int(np.count_nonzero(~(np.isfinite(metres) & (metres > 0))))
    if wrong:
        raise ParameterError(
            f"{what}: the width of {wrong} of {len(frame)} lines is not above 0, expected metres"
            if isinstance(width, str)
            else f"the width of lines is {width} m, expected a number above 0"
        )
    lines = frame[["geometry"]].assign(width_m=metres)
    breaks = laid_on(lines, grid)
    if not breaks.crossed.any():
        raise InputError(f"{what} crosses no link of the landscape {grid.describe()}; is it the right file?")
    return breaks


def laid_on(lines: gpd.GeoDataFrame, grid: Grid) -> LineBreaks:
    """Lay lines in the CRS of a grid, with the column `width_m`, on it."""
    traced = _trace(lines, grid)
    return LineBreaks(lines, *_links(traced, grid), _cleared(traced, grid), grid)


def links_crossed(
    lines: gpd.GeoDataFrame, grid: Grid
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Find the links between neighbouring cells that lines cross.

    Links run straight from centre to centre, also to the four diagonal neighbours. A line that touches a centre or
    runs along a link is taken to pass just west of it, or else just north; so all links are decided, and alike from
    both ends. Vertices are rounded to 1/4096 of a cell.

    Parameters
    ----------
    lines
        In the CRS of the grid; with the column `width_m`, if widths are wanted.
    grid
        The grid.

    Returns
    -------
    crossed
        (rows, cols) uint8, see `LineBreaks`.
    width
        (rows, cols) float32, see there; 0 without the column.
    line, along, whole
        (rows, cols) uint32, float32 and float32, see there.
    """
    return _links(_trace(lines, grid), grid)


class _Traced(NamedTuple):
    """Straight pieces of lines on a grid.

    Parameters
    ----------
    ends
        (n, 4) int64, x and y of both ends in 1/`PARTS` of a cell.
    width
        (n,) float32 [m].
    line
        (n,) uint32, the mark of its line.
    begin, whole
        (n,) float64 [cells]: how far it begins from where its line does, and how long that is.
    of
        (n,) int64, rising: the place of its line among all.
    """

    ends: np.ndarray
    width: np.ndarray
    line: np.ndarray
    begin: np.ndarray
    whole: np.ndarray
    of: np.ndarray

    def along(self, of: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """How far along its line the place on piece `of` is that is nearest to (x, y), each (n,) [cells]."""
        from firebreak_gis.kernels.crossings import PARTS

        start, end = (self.ends[of, i : i + 2] / PARTS for i in (0, 2))
        step = np.hypot(*(end - start).T)
        share = np.clip(((np.column_stack([x, y]) - start) * (end - start)).sum(axis=1) / step**2, 0.0, 1.0)
        return np.asarray(self.begin[of] + share * step)


def _trace(lines: gpd.GeoDataFrame, grid: Grid) -> _Traced:
    """Take lines apart into straight pieces; far off the grid they are cut."""
    import shapely

    from firebreak_gis.kernels.crossings import PARTS

    rows, cols = grid.shape
    shapes = shapely.clip_by_rect(in_cells(lines, grid), -2.0, -2.0, cols + 2.0, rows + 2.0)
    parts, owner = shapely.get_parts(shapes, return_index=True)
    places, part = shapely.get_coordinates(parts, return_index=True)
    if not len(places):
        none = np.zeros(0)
        ends, of = np.zeros((0, 4), np.int64), none.astype(np.int64)
        return _Traced(ends, none.astype(np.float32), none.astype(np.uint32), none, none, of)
    at = np.rint(places * PARTS).astype(np.int64)
    joined = np.flatnonzero(part[1:] == part[:-1])
    ends = np.ascontiguousarray(np.concatenate([at[joined], at[joined + 1]], axis=1))
    feature = owner[part]
    metres = lines["width_m"].to_numpy(np.float32) if "width_m" in lines.columns else np.zeros(len(lines), np.float32)
    own, run = feature[joined], _run(places, feature)
    whole = run[np.searchsorted(feature, own, "right") - 1]
    return _Traced(ends, metres[own], _marks(at, feature)[own], run[joined], whole, own)


def _crossed_by(ends: np.ndarray, grid: Grid) -> tuple[np.ndarray, slice, slice]:
    """Bits of the links that straight pieces cross in the window about them, and its rows and columns."""
    from firebreak_gis.kernels.crossings import PARTS, cross_links

    if not len(ends):
        return np.zeros((0, 0), np.uint8), slice(0, 0), slice(0, 0)
    x, y = ends[:, ::2] // PARTS, ends[:, 1::2] // PARTS
    rows, cols = (
        slice(max(int(at.min()) - 2, 0), max(min(int(at.max()) + 3, n), 0))
        for at, n in zip((y, x), grid.shape, strict=True)
    )
    shape = (max(rows.stop - rows.start, 0), max(cols.stop - cols.start, 0))
    crossed, none = np.zeros(shape, np.uint8), np.zeros(len(ends), np.float32)
    corner = np.array([cols.start, rows.start] * 2, np.int64) * PARTS
    cross_links(ends - corner, none, crossed, np.zeros(shape, np.float32), np.zeros(shape, np.int64))
    return crossed, rows, cols


def _links(traced: _Traced, grid: Grid) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """See `links_crossed`."""
    from firebreak_gis.kernels.crossings import cross_links

    crossed, width = np.zeros(grid.shape, np.uint8), np.zeros(grid.shape, np.float32)
    piece = np.full(grid.shape, -1, np.int64)
    cross_links(traced.ends, traced.width, crossed, width, piece)
    line = np.zeros(grid.shape, np.uint32)
    along, length = np.zeros(grid.shape, np.float32), np.zeros(grid.shape, np.float32)
    at = np.nonzero(piece >= 0)
    of = piece[at]
    line[at] = traced.line[of]
    along[at] = traced.along(of, at[1] + 0.5, at[0] + 0.5) * grid.cell_size
    length[at] = traced.whole[of] * grid.cell_size
    return crossed, width, line, along, length


def _cleared(traced: _Traced, grid: Grid) -> Cleared:
    """What the pieces take of the cells, each as a rectangle of its length and width."""
    import shapely

    from firebreak_gis.kernels.crossings import PARTS
    from firebreak_gis.kernels.walls import GROUND

    start, end = traced.ends[:, :2] / PARTS, traced.ends[:, 2:] / PARTS
    length = np.hypot(*(end - start).T)
    own = np.flatnonzero(length > 0)
    start, end = start[own], end[own]
    ahead = (end - start) / length[own, np.newaxis]
    aside = np.column_stack([-ahead[:, 1], ahead[:, 0]]) * (traced.width[own, np.newaxis] / grid.cell_size / 2.0)
    corners = np.stack([start + aside, end + aside, end - aside, start - aside], axis=1)
    prints = footprints_in_cells(shapely.polygons(corners), grid.shape)
    of = own[prints.feature]
    order = np.argsort(prints.cell, kind="stable")
    cell, of = prints.cell[order], of[order]
    row, col = np.divmod(cell, grid.shape[1])
    part = np.rint(np.minimum(prints.part[order], 1.0) * GROUND).astype(np.uint32)
    metres = (traced.along(of, col + 0.5, row + 0.5), traced.whole[of])
    in_metres = ((each * grid.cell_size).astype(np.float32) for each in metres)
    return Cleared(cell, part, traced.width[of], traced.line[of], *in_metres)


def _marks(whole: np.ndarray, feature: np.ndarray) -> np.ndarray:
    """A mark for each feature from its first two places, (features,) uint32."""
    count = int(feature.max()) + 1
    first = np.minimum(np.searchsorted(feature, np.arange(count)), feature.size - 2)
    told = np.concatenate([whole[first], whole[first + 1]], axis=1).astype(np.uint64)
    mark = np.zeros(count, np.uint64)
    for column in told.T:
        mark = (mark ^ column) * np.uint64(0x9E3779B97F4A7C15)
        mark ^= mark >> np.uint64(29)
    return np.asarray(mark >> np.uint64(32), np.uint32)


def _run(places: np.ndarray, feature: np.ndarray) -> np.ndarray:
    """How far each place is from the first of its feature, the gaps between parts counted [cells]."""
    steps = np.hypot(*np.diff(places, axis=0).T)
    run = np.concatenate([[0.0], np.cumsum(np.where(np.diff(feature) == 0, steps, 0.0))])
    return np.asarray(run - run[np.searchsorted(feature, feature)])
