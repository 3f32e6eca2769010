"""A landscape laid on its grid part by part, so that it need not fit into memory.

Layers are looked through first, for what only the whole tells: values that stand for "no data", voids, units. Then
parts of the grid are read and looked up, in turn or by workers, as the whole would be: all values are the same.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.files.scratch import let_go, on_disk
from firebreak_gis.landscape.alignment import flags_told, placing, strips, with_nodata
from firebreak_gis.landscape.grid_part import GridPart
from firebreak_gis.landscape.layers import look_at_elevations, require_some
from firebreak_gis.landscape.reading import assembled
from firebreak_gis.landscape.sources import FOUND, Found, OfLayer, Sources, lay_part
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.memory import BLOCK_CELLS, SOURCE_CELLS
from firebreak_gis.progress import part, silent

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


@dataclass
class _Layer:
    """A layer that has been looked through."""

    name: str
    header: Header
    table: Legend | None
    account: Account
    flags: np.ndarray = field(default_factory=lambda: np.zeros(0, np.float32))

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
            for strip in values():
                layer.flags = np.union1d(layer.flags, strip[table.flagged(strip)])
        return layer

    def require(self, found: OfLayer, account: Account) -> None:
        """Refuse what cannot be used, as far as only the whole tells, and say what was done."""
        alignment = [*self.account.alignment, *(said for said in found.alignment if said not in self.account.alignment)]
        if self.flags.size:
            alignment.append(flags_told(self.name, self.flags))
        account.alignment += alignment
        account.warnings += self.account.warnings
        account.warnings += [said for said in found.warnings if said not in self.account.warnings]
        if self.table is None:
            require_some(found.known, self.header, self.name)
        else:
            found.seen.require(self.header, self.name, self.table)


def _in_turn(
    work: Callable[..., Mapping[str, np.ndarray]],
    pieces: Sequence[Any],
    shared: Mapping[str, Any],
    *,
    take: Callable[[int, Mapping[str, np.ndarray]], None],
    threads: int | None,
    progress: Progress,
    message: str,  # noqa: ARG001
) -> None:
    """Make pieces of work one after another, as `simulation.engine.spread` does where no engine is in use."""
    for i, piece in enumerate(pieces):
        step = part(progress, i / len(pieces), (i + 1) / len(pieces))
        take(i, work(piece, threads=threads, progress=step, **shared))


def read_by_parts(
    request: LandscapeRequest,
    found: Survey,
    folder: str | os.PathLike[str],
    *,
    cells: int = BLOCK_CELLS,
    spread: Callable[..., None] = _in_turn,
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
    spread
        Makes the parts, as `simulation.engine.spread` does; by default one after another.
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
    planes: dict[str, np.ndarray] = {}
    parts = list(windows(found, cells))
    told: dict[int, Found] = {}

    def take(i: int, made: Mapping[str, np.ndarray]) -> None:
        row, col, rows, cols = parts[i]
        for name, values in made.items():
            if name == FOUND:
                told[i] = Found.unpacked(values)
                continue
            if name not in planes:
                planes[name] = on_disk(folder, grid.shape, values.dtype)
            planes[name][row : row + rows, col : col + cols] = values
            let_go(planes[name])

    headers = {name: layer.header for name, layer in layers.items()}
    source = Sources(grid, headers, found.legend, found.density_legend, found.density, request.strict)
    step = part(report, 0.3, 1.0)
    spread(lay_part, parts, {"source": source}, take=take, threads=None, progress=step, message="lay on the grid")
    of_all = Found()
    for i in range(len(parts)):
        of_all.join(told[i])
    for name, layer in layers.items():
        layer.require(of_all.layers[name], found.account)
    of_all.lacks.require(found.legends, grid, found.account, request.unknown)
    report(1.0, "landscape read")
    return assembled(found, grid, planes)


def windows(found: Survey, cells: int) -> Iterator[Window]:
    """Parts of the grid of about so many cells, from the north-west, each with a bounded part of every layer."""
    rows, cols = found.grid.shape
    step = max(cells // cols, 1)
    waiting = [(row, 0, min(step, rows - row), cols) for row in reversed(range(0, rows, step))]
    while waiting:
        row, col, height, width = waiting.pop()
        place = GridPart(found.grid, (row, col, height, width))
        most = max(how.window[2] * how.window[3] for how in (placing(each, place) for each in found.layers.values()))
        if most <= SOURCE_CELLS or height * width <= _LEAST:
            yield row, col, height, width
        elif height >= width:
            half = height // 2
            waiting += [(row + half, col, height - half, width), (row, col, half, width)]
        else:
            half = width // 2
            waiting += [(row, col + half, height, width - half), (row, col, height, half)]
