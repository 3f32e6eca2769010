"""A landscape laid on its grid part by part, so that it need not fit into memory.

Layers are looked through first, for what only the whole tells: values that stand for "no data", voids, units. Then
parts of the grid are read and looked up one after another, as the whole would be: all values are the same.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.files.scratch import on_disk
from firebreak_gis.landscape.alignment import flags_told, placing, strips, with_nodata
from firebreak_gis.landscape.continuity import CONTINUITY, WINDOW
from firebreak_gis.landscape.fuel import Lacks, fuel_of
from firebreak_gis.landscape.grid_part import GridPart
from firebreak_gis.landscape.layers import (
    Seen,
    look_at_elevations,
    part_of_codes,
    part_of_elevation,
    require_some,
)
from firebreak_gis.landscape.reading import assembled, planes_of
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.memory import BLOCK_CELLS, SOURCE_CELLS
from firebreak_gis.progress import silent

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.legends import Legend
    from firebreak_gis.landscape.request import LandscapeRequest
    from firebreak_gis.landscape.surveying import Survey
    from firebreak_gis.progress import Progress
    from firebreak_gis.rasters import Header
    from firebreak_gis.rasters.reading import Window

#: Parts of fewer cells are not made smaller, however fine a layer is.
_LEAST = 4096
#: All rows and columns.
WHOLE = (slice(None), slice(None))


@dataclass
class _Layer:
    """A layer that has been looked through, and what was found so far of its parts on the grid."""

    name: str
    header: Header
    table: Legend | None
    account: Account
    flags: np.ndarray = field(default_factory=lambda: np.zeros(0, np.float32))
    known: bool = False
    seen: Seen = field(default_factory=Seen)

    @classmethod
    def of(cls, name: str, found: Survey, strict: bool) -> _Layer:
        """Look a layer through."""
        header, account, table = found.layers[name], Account(strict=strict), found.legends.get(name)
        for note in header.notes:
            account.warn(f"{name}: {note}")
        if table is not None and not table.continuous:
            return cls(name, header, table, account)
        header = with_nodata(header, found.grid, name, account)
        how = placing(header, found.grid)
        for cells in strips(header, how):
            account.alignment.extend(f"{name}: {said}" for said in cells.said)
            break

        def values() -> Iterator[np.ndarray]:
            for cells in strips(header, how):
                yield np.where(cells.valid, cells.values, np.nan).astype(np.float32)

        layer = cls(name, header, table, account)
        if table is None:
            look_at_elevations(values, replace(header, declared=found.layers[name].declared), account)
        elif not how.copy:
            for part in values():
                layer.flags = np.union1d(layer.flags, part[table.flagged(part)])
        return layer

    def on(self, part: GridPart, inner: tuple[slice, slice] = WHOLE) -> np.ndarray:
        """Values on a part of the grid, of which those in `inner` count."""
        account = Account(strict=self.account.strict)
        if self.table is None:
            values = part_of_elevation(self.header, part, account)
        else:
            values = part_of_codes(self.header, part, self.name, self.table, account)
            self.seen.add(values[inner], self.table)
        self.known = self.known or bool(np.isfinite(values[inner]).any())
        self.account.alignment += [said for said in account.alignment if said not in self.account.alignment]
        self.account.warnings += [said for said in account.warnings if said not in self.account.warnings]
        return values

    def require(self, account: Account) -> None:
        """Refuse what cannot be used, as far as only the whole tells, and say what was done."""
        if self.flags.size:
            self.account.alignment.append(flags_told(self.name, self.flags))
        account.alignment += self.account.alignment
        account.warnings += self.account.warnings
        if self.table is None:
            require_some(self.known, self.header, self.name)
        else:
            self.seen.require(self.header, self.name, self.table)


def read_by_parts(
    request: LandscapeRequest,
    found: Survey,
    folder: str | os.PathLike[str],
    *,
    cells: int = BLOCK_CELLS,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Read the layers of a survey into arrays on the disk; equal to `reading.read_surveyed`.

    Parameters
    ----------
    request, found
        As in `reading.read_surveyed`.
    folder
        On whose disk the arrays lie, 7 B a cell, and 4 more for each variable that a legend gives.
    cells
        Cells of the grid in a part, about; fewer where a layer has finer ones.
    progress
        Callback (share done, message).

    Returns
    -------
    xarray.Dataset
        Its values lie on the disk, in files that go with it.
    """
    report, grid = progress or silent, found.grid
    layers = {}
    for i, name in enumerate(found.layers):
        report(0.1 * i, f"look at {name}")
        layers[name] = _Layer.of(name, found, request.strict)
    lacks = Lacks()
    planes: dict[str, np.ndarray] = {}
    for row, col, rows, cols in windows(found, cells):
        report(0.3 + 0.7 * row / grid.shape[0], "lay on the grid")
        for name, values in _part(found, layers, (row, col, rows, cols), lacks).items():
            if name not in planes:
                planes[name] = on_disk(folder, grid.shape, values.dtype)
            planes[name][row : row + rows, col : col + cols] = values
    for layer in layers.values():
        layer.require(found.account)
    lacks.require(found.legends, grid, found.account, request.unknown)
    report(1.0, "landscape read")
    return assembled(found, grid, planes)


def windows(found: Survey, cells: int) -> Iterator[Window]:
    """Parts of the grid of about so many cells, from the north-west, each with a bounded part of every layer."""
    rows, cols = found.grid.shape
    step = max(cells // cols, 1)
    waiting = [(row, 0, min(step, rows - row), cols) for row in reversed(range(0, rows, step))]
    while waiting:
        row, col, height, width = waiting.pop()
        part = GridPart(found.grid, (row, col, height, width))
        most = max(how.window[2] * how.window[3] for how in (placing(each, part) for each in found.layers.values()))
        if most <= SOURCE_CELLS or height * width <= _LEAST:
            yield row, col, height, width
        elif height >= width:
            half = height // 2
            waiting += [(row + half, col, height - half, width), (row, col, half, width)]
        else:
            half = width // 2
            waiting += [(row, col + half, height, width - half), (row, col, height, half)]


def _part(found: Survey, layers: Mapping[str, _Layer], window: Window, lacks: Lacks) -> dict[str, np.ndarray]:
    """Variables of one part of the grid."""
    part = GridPart(found.grid, window)
    elevation = layers["elevation"].on(part)
    wide, inner = (window, WHOLE) if found.density != CONTINUITY else _wider(window, found.grid.shape)
    codes = layers["vegetation"].on(GridPart(found.grid, wide), inner)
    cover = layers["density"].on(part) if "density" in layers else found.density
    return planes_of(elevation, fuel_of(codes, cover, found.legend, found.density_legend, inner=inner), lacks)


def _wider(window: Window, shape: tuple[int, int]) -> tuple[Window, tuple[slice, slice]]:
    """A window with all that the continuity of its cells depends on, and where it lies in that."""
    row, col, rows, cols = window
    half = WINDOW // 2
    top, left = max(row - half, 0), max(col - half, 0)
    bottom, right = min(row + rows + half, shape[0]), min(col + cols + half, shape[1])
    inner = (slice(row - top, row - top + rows), slice(col - left, col - left + cols))
    return (top, left, bottom - top, right - left), inner
