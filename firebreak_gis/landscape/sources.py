"""Layers that have been looked through, from which parts of a landscape are read, here or by workers.

A part returns its values with what was found of it; whoever joins the parts in their order knows what is found of the
whole.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import FirebreakError, InputError
from firebreak_gis.files import sha256
from firebreak_gis.files.gate import is_file
from firebreak_gis.landscape.continuity import CONTINUITY, WINDOW
from firebreak_gis.landscape.fuel import Lacks, fuel_of
from firebreak_gis.landscape.grid_part import GridPart
from firebreak_gis.landscape.layers import Seen, part_of_codes, part_of_elevation
from firebreak_gis.landscape.reading import planes_of
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import file_of, files_behind

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.legends import Legend
    from firebreak_gis.progress import Progress
    from firebreak_gis.rasters import Header
    from firebreak_gis.rasters.reading import Window

#: All rows and columns.
WHOLE = (slice(None), slice(None))
#: Among the arrays of a part, what was found of it.
FOUND = "found"


@dataclass
class OfLayer:
    """What is found of a layer on parts of the grid.

    Parameters
    ----------
    known
        Whether any cell has a value.
    seen
        What is asked of its codes.
    alignment, warnings
        Sentences, each once.
    """

    known: bool = False
    seen: Seen = field(default_factory=Seen)
    alignment: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)

    def join(self, other: OfLayer) -> None:
        """Add what was found on other parts."""
        self.known |= other.known
        self.seen.join(other.seen)
        self.alignment += [said for said in other.alignment if said not in self.alignment]
        self.warnings += [said for said in other.warnings if said not in self.warnings]


@dataclass
class Found:
    """What is found of a landscape on parts of the grid, by layer and of all together."""

    layers: dict[str, OfLayer] = field(default_factory=dict)
    lacks: Lacks = field(default_factory=Lacks)

    def join(self, other: Found) -> None:
        """Add what was found on the parts that follow."""
        for name, layer in other.layers.items():
            self.layers.setdefault(name, OfLayer()).join(layer)
        self.lacks.join(other.lacks)

    def packed(self) -> np.ndarray:
        """All of it as an array, (n,) uint8."""
        return np.frombuffer(json.dumps(asdict(self)).encode(), np.uint8)

    @classmethod
    def unpacked(cls, packed: np.ndarray) -> Found:
        """What was packed."""
        told = json.loads(packed.tobytes())
        layers = {name: OfLayer(**{**each, "seen": Seen(**each["seen"])}) for name, each in told["layers"].items()}
        lacks = Lacks(**told["lacks"])
        lacks.unknown = {
            name: {float(code): number for code, number in codes.items()} for name, codes in lacks.unknown.items()
        }
        return cls(layers, lacks)


@dataclass(frozen=True, eq=False)
class Sources:
    """What parts of a landscape are read from.

    Parameters
    ----------
    grid
        Of the whole.
    headers
        Of the layers by name, with all that was found out by looking through them.
    legend, density_legend, density
        As in `surveying.Survey`.
    strict
        Whether to refuse what would be warned of.
    named
        Names of the files in messages, by the names under which they are opened, where these differ.
    """

    grid: Grid
    headers: Mapping[str, Header]
    legend: Legend
    density_legend: Legend
    density: str | None
    strict: bool
    named: Mapping[str, str] = field(default_factory=dict)

    def __reduce__(self) -> Any:
        """With the names of its files as any process of this file system finds them: whoever gets it opens them."""
        headers = {name: replace(header, path=_absolute(header)) for name, header in self.headers.items()}
        named = {headers[name].path: header.path for name, header in self.headers.items()}
        named = {place: self.named.get(name, name) for place, name in named.items()}
        return _again, (self.grid, headers, self.legend, self.density_legend, self.density, self.strict, named)

    def content(self) -> list[Any]:
        """What tells it from others."""
        files = files_behind(header.path for header in self.headers.values() if header.array is None)
        read = [self.grid, dict(self.headers), self.legend, self.density_legend, self.density, self.strict]
        return [*read, [sha256(file) for file in files]]

    def lay(self, window: Window, found: Found) -> dict[str, np.ndarray]:
        """Variables of a part of the grid; what is found of it is added to `found`."""
        elevation = self._on(window, "elevation", found)
        wide, inner = (window, WHOLE) if self.density != CONTINUITY else _wider(window, self.grid.shape)
        codes = self._on(wide, "vegetation", found, inner)
        cover = self._on(window, "density", found) if "density" in self.headers else self.density
        fuel = fuel_of(codes, cover, self.legend, self.density_legend, inner=inner)
        return planes_of(elevation, fuel, found.lacks)

    def told(self, text: str) -> str:
        """A message, in which files have the names that they were given."""
        for place, name in self.named.items():
            text = text.replace(place, name)
        return text

    def _on(self, window: Window, name: str, found: Found, inner: tuple[slice, slice] = WHOLE) -> np.ndarray:
        """Values of a layer on a part of the grid, of which those in `inner` count."""
        part, header, account = GridPart(self.grid, window), self.headers[name], Account(strict=self.strict)
        seen = Seen()
        if name == "elevation":
            values = part_of_elevation(header, part, account)
        else:
            table = self.density_legend if name == "density" else self.legend
            values = part_of_codes(header, part, name, table, account)
            seen.add(values[inner], table)
        said = ([self.told(each) for each in told] for told in (account.alignment, account.warnings))
        one = OfLayer(bool(np.isfinite(values[inner]).any()), seen, *said)
        found.layers.setdefault(name, OfLayer()).join(one)
        return values


def lay_part(window: Window, *, source: Sources, threads: int | None, progress: Progress) -> dict[str, np.ndarray]:  # noqa: ARG001
    """Lay a part of a landscape on the grid.

    Returns
    -------
    dict
        Its variables by name, and under `FOUND` what was found of it.
    """
    progress(0.0, "lay on the grid")
    found = Found()
    try:
        planes = source.lay(window, found)
    except FirebreakError as error:
        raise type(error)(source.told(str(error))) from error
    return planes | {FOUND: found.packed()}


def _wider(window: Window, shape: tuple[int, int]) -> tuple[Window, tuple[slice, slice]]:
    """A window with all that the continuity of its cells depends on, and where it lies in that."""
    row, col, rows, cols = window
    half = WINDOW // 2
    top, left = max(row - half, 0), max(col - half, 0)
    bottom, right = min(row + rows + half, shape[0]), min(col + cols + half, shape[1])
    inner = (slice(row - top, row - top + rows), slice(col - left, col - left + cols))
    return (top, left, bottom - top, right - left), inner


def _absolute(header: Header) -> str:
    """The name of a layer as any process of this file system finds it."""
    file = file_of(header.path)
    if header.array is not None or not is_file(file) or Path(file).is_absolute():
        return header.path
    before, _, after = header.path.rpartition(file)
    return f"{before}{Path(file).absolute()}{after}"


def _again(grid: Grid, headers: Mapping[str, Header], *others: Any) -> Sources:
    """The sources on another machine."""
    for header in headers.values():
        file = file_of(header.path)
        if Path(file).is_absolute() and header.array is None and not is_file(file):
            raise InputError(f"a worker does not find {file}; layers must lie where all workers reach them")
    return Sources(grid, headers, *others)
