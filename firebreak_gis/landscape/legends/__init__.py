"""Legends: tables that map the codes of a raster to the classes of the spread model.

A legend is a CSV file with the columns `code`, `vegetation`, `density`, `label`; lines that begin
with `#` say where it comes from. Classes are written by name; a number with a decimal point in place
of a name is the continuous effect itself (0.4 is what "pines" stands for in the paper). A code may be
a range `low..high`, low included, high not (the highest end of all is): then the raster is a
quantity, such as canopy cover in percent. The optional column `density_from_raster` (yes or no, yes
if absent) says whether a density raster, where one is given, replaces the density of the legend.

Further optional columns say how the fuel burns, see `legends.burning`.

In place of a class, `nodata` says that the code is none: what stands for "no data", or for "outside". Among ranges
such codes are flags, which are never mixed with the quantity. A line `extends,NAME` takes the entries of another
legend, built-in or in the same folder, except those for codes that the file lists itself. Columns may be separated by
commas, semicolons (then numbers may have decimal commas) or tabs; the text is UTF-8 or UTF-16.
"""

from __future__ import annotations

import csv
import functools
import importlib.resources
import itertools
import math
import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from firebreak_gis.errors import LegendError
from firebreak_gis.files.gate import is_file
from firebreak_gis.landscape.legends.burning import BURNING, burning_of
from firebreak_gis.schema import DENSITY, VEGETATION

#: In place of a class: the code stands for no data.
NO_DATA = "nodata"
#: First word of a line that names another legend.
EXTENDS = "extends"
COLUMNS = ("code", "vegetation", "density", "label", "density_from_raster", *BURNING)
#: Effect of each class in the paper; only used to name the class nearest to a continuous effect.
_NEAREST = {"vegetation": {1: -0.3, 2: 0.0, 3: 0.4}, "density": {1: -0.4, 2: 0.0, 3: 0.3}}
_CLASSES = {"vegetation": VEGETATION, "density": DENSITY}
_RANGE = re.compile(r"^\s*(-?[\d.]+?)\s*\.\.\s*(-?[\d.]+)\s*$")
#: Values from which `Legend.find` looks codes up in a table, and the size of it.
_TABLE = 1 << 16


@dataclass(frozen=True)
class Entry:
    """One line of a legend.

    Parameters
    ----------
    low, high
        The code twice, or the ends of the range.
    vegetation, density
        Class codes of the schema; None where the legend says nothing.
    vegetation_effect, density_effect
        Continuous effects given in place of class names, else None.
    density_from_raster
        Whether a density raster replaces `density`.
    label
        Text for people.
    missing
        Whether the code stands for no data.
    rate, dead_load, live_load, heat_content, live_moisture
        How the fuel burns, in the units of the schema; None where the class counts.
    """

    low: float
    high: float
    vegetation: int | None = None
    density: int | None = None
    vegetation_effect: float | None = None
    density_effect: float | None = None
    density_from_raster: bool = True
    label: str = ""
    missing: bool = False
    rate: float | None = None
    dead_load: float | None = None
    live_load: float | None = None
    heat_content: float | None = None
    live_moisture: float | None = None


@dataclass(frozen=True)
class Legend:
    """A table of codes.

    Parameters
    ----------
    name
        Built-in name, or the stem of the file.
    entries
        In the order of the codes.
    about
        The comment lines: source, version.
    """

    name: str
    entries: tuple[Entry, ...]
    about: tuple[str, ...] = ()

    @property
    def version(self) -> str:
        """What the comment `Version:` says, else ""."""
        return next((line.partition(":")[2].strip() for line in self.about if line.startswith("Version:")), "")

    @property
    def continuous(self) -> bool:
        """Whether codes are ranges of a quantity."""
        return any(entry.low != entry.high for entry in self.entries)

    def flagged(self, values: np.ndarray) -> np.ndarray:
        """Return which values are no amount of the quantity: they stand for themselves and must not be mixed.

        Parameters
        ----------
        values
            Any shape, NaN for no data.

        Returns
        -------
        numpy.ndarray
            bool: listed by a code of its own, such as 255 for "outside", or not listed.
        """
        ranged = np.array([*(entry.low != entry.high for entry in self.entries), False])
        return np.asarray(~ranged[self.find(values)] & ~np.isnan(values))

    @property
    def has_vegetation(self) -> bool:
        """Whether every entry gives a vegetation class or effect."""
        return all(entry.vegetation is not None for entry in self.entries if not entry.missing)

    @property
    def has_density(self) -> bool:
        """Whether every entry that can burn gives a density class or effect."""
        return all(entry.density is not None for entry in self.entries if entry.vegetation != 0 and not entry.missing)

    @property
    def codes(self) -> tuple[float, ...]:
        """All codes, for a legend that is not continuous."""
        return tuple(entry.low for entry in self.entries)

    def find(self, values: np.ndarray) -> np.ndarray:
        """Return the index into `entries` for each value, -1 where the legend does not list it."""
        numbers = np.asarray(values, dtype=np.float64)
        if numbers.size < _TABLE:
            return self._search(numbers)
        # Codes are small whole numbers: one table serves all cells.
        with np.errstate(invalid="ignore"):
            code = numbers.astype(np.uint16)
        found = self._search(np.arange(_TABLE, dtype=np.float64))[code]
        other = code != numbers
        if other.any():
            found[other] = self._search(numbers[other])
        return found

    def _search(self, numbers: np.ndarray) -> np.ndarray:
        lows = np.array([entry.low for entry in self.entries])
        highs = np.array([entry.high for entry in self.entries])
        index = np.searchsorted(lows, numbers, side="right") - 1
        found = index.clip(0)
        top = max((entry.high for entry in self.entries if entry.low != entry.high), default=np.inf)
        inside = (index >= 0) & (numbers < highs[found])
        inside |= (index >= 0) & (numbers == highs[found]) & ((lows[found] == highs[found]) | (highs[found] == top))
        return np.where(inside, found, -1)

    def column(self, name: str, missing: float) -> np.ndarray:
        """Return one field of all entries as floats, `missing` where it is not given.

        One more element stands at the end, also `missing`, so that index -1 of `find` falls on it.
        """
        values = [getattr(entry, name) for entry in self.entries]
        return np.array([missing if value is None else float(value) for value in values] + [missing])


def names() -> list[str]:
    """Return the names of the built-in legends, sorted."""
    return list(_built_in())


@functools.cache
def _built_in() -> tuple[str, ...]:
    folder = importlib.resources.files(__package__)
    return tuple(sorted(entry.name.removesuffix(".csv") for entry in folder.iterdir() if entry.name.endswith(".csv")))


def read_legend(name_or_path: str | os.PathLike[str] | Legend) -> Legend:
    """Read a built-in legend by name, or a CSV file by path.

    Raises
    ------
    LegendError
        If there is no such legend, or naming all problems of the file with their line numbers.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> fb.read_legend("paper").entries[1].label
    'agricultural'
    """
    if isinstance(name_or_path, Legend):
        return name_or_path
    name = os.fspath(name_or_path)
    if name in names():
        text = (importlib.resources.files(__package__) / f"{name}.csv").read_text(encoding="utf-8")
        return parse(text, name, f"the legend {name}")
    path = Path(name)
    if not is_file(path):
        raise LegendError(f"no legend {name!r}: neither a built-in one ({', '.join(names())}) nor a CSV file")
    try:
        content = path.read_bytes()
    except OSError as error:
        raise LegendError(f"cannot read the legend {name}: {error.strerror}") from error
    return parse(_decoded(content, name), path.stem, name, folder=path.parent)


def _decoded(content: bytes, name: str) -> str:
    """Text of a file: UTF-16 if it begins with the mark of it, or with a letter beside a zero, else UTF-8."""
    wide = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}.get(content[:2])
    wide = wide or {(True, False): "utf-16-le", (False, True): "utf-16-be"}.get(
        (content[1:2] == b"\0", content[:1] == b"\0")
    )
    try:
        return content.decode(wide or "utf-8-sig")
    except UnicodeDecodeError as error:
        raise LegendError(f"the legend {name} is not UTF-8 text; save it as CSV UTF-8") from error


def parse(text: str, name: str, where: str, *, folder: Path | None = None, within: tuple[str, ...] = ()) -> Legend:
    """Parse the text of a legend.

    Parameters
    ----------
    text
        Of the file.
    name
        Of the legend.
    where
        Names it in messages.
    folder
        Where a legend that it extends is looked for by its file name.
    within
        Legends that extend one another down to this one.

    Raises
    ------
    LegendError
        Naming all problems with their line numbers.
    """
    lines = [(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip(" \t,;")]
    if lines and re.fullmatch(r"sep=.", lines[0][1].strip(), re.IGNORECASE):  # as spreadsheets begin
        del lines[0]
    about = tuple(line.strip().lstrip("# ") for _, line in lines if line.lstrip().startswith("#"))
    rows = [(number, line) for number, line in lines if not line.lstrip().startswith("#")]
    delimiter = _delimiter([line for _, line in rows])
    table = [(number, _cells(line, delimiter)) for number, line in rows]
    base = [(number, cells) for number, cells in table if cells[0].lower() == EXTENDS]
    table = [(number, cells) for number, cells in table if cells[0].lower() != EXTENDS]
    inherited = _inherited(base, where, folder, within)
    if not table and inherited is None:
        raise LegendError(f"{where} is empty; expected a line {','.join(COLUMNS[:4])} and one line a code")
    problems: list[str] = []
    entries = _entries(table, where, delimiter, problems)
    _find_overlaps(entries, problems)
    if not entries and not problems and inherited is None:
        problems.append("no codes")
    if inherited is not None:
        own = [entry for _, entry in entries]
        entries += [(base[0][0], entry) for entry in inherited.entries if not _covered(entry, own)]
        if not problems:
            _find_overlaps(entries, problems)
    if problems:
        raise LegendError(f"{where} cannot be used: " + "; ".join(problems))
    ordered = sorted((entry for _, entry in entries), key=lambda entry: entry.low)
    return Legend(name, tuple(ordered), about + (() if inherited is None else inherited.about))


def _delimiter(lines: list[str]) -> str:
    """What separates the columns: that which the line of their names holds."""
    for line in lines:
        for delimiter in (",", ";", "\t"):
            if "code" in [cell.lower() for cell in _cells(line, delimiter)]:
                return delimiter
    return next((found for found in ";\t" if lines and found in lines[0]), ",")


def _cells(line: str, delimiter: str) -> list[str]:
    csv.field_size_limit(max(csv.field_size_limit(), len(line)))  # a cell may be of any length
    return [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True, delimiter=delimiter))] or [""]


def _inherited(
    base: list[tuple[int, list[str]]], where: str, folder: Path | None, within: tuple[str, ...]
) -> Legend | None:
    """The legend that this one extends; None if there is none."""
    if not base:
        return None
    number, cells = base[0]
    names = [cell for cell in cells[1:] if cell]
    if len(base) > 1 or len(names) != 1:
        raise LegendError(f"{where}, line {number}: expected one line {EXTENDS},NAME with the name of one legend")
    other = names[0]
    beside = (folder or Path()) / other
    if other not in _built_in() and is_file(beside):
        other = str(beside)
    if where in within or other in within:
        raise LegendError(f"{where}, line {number}: the legends extend each other in a circle")
    if other in _built_in():
        return read_legend(other)
    path = Path(other)
    if not is_file(path):
        raise LegendError(
            f"{where}, line {number}: no legend {names[0]!r} to extend: neither a built-in one "
            f"({', '.join(_built_in())}) nor a file in the same folder"
        )
    text = _decoded(path.read_bytes(), other)
    return parse(text, path.stem, other, folder=path.parent, within=(*within, where))


def _covered(entry: Entry, own: list[Entry]) -> bool:
    """Whether own entries replace one of the legend that is extended."""
    return any(mine.low <= entry.low and entry.high <= mine.high for mine in own)


def _entries(
    table: list[tuple[int, list[str]]], where: str, delimiter: str, problems: list[str]
) -> list[tuple[int, Entry]]:
    """Entries with the numbers of their lines; problems are added."""
    if not table:
        return []
    header = [cell.lower() for cell in table[0][1]]
    while header and not header[-1]:
        header.pop()
    unknown = [cell for cell in header if cell not in COLUMNS]
    if "code" not in header or unknown or not {"vegetation", "density"} & set(header) or len(set(header)) < len(header):
        raise LegendError(
            f"{where}, line {table[0][0]}: got the columns {', '.join(header)}, expected "
            f"{', '.join(COLUMNS[:4])} "
            f"separated by commas, semicolons or tabs (optional: {', '.join(COLUMNS[4:])})"
        )
    entries = []
    for number, cells in table[1:]:
        while len(cells) > len(header) and not cells[-1]:  # spreadsheets fill lines up
            cells.pop()
        if len(cells) > len(header):
            problems.append(
                f"line {number}: {len(cells)} cells, expected at most {len(header)}; quote texts that hold commas"
            )
            continue
        if delimiter != ",":
            cells = [
                cell if name == "label" else re.sub(r"(?<=\d),(?=\d)", ".", cell)
                for name, cell in zip(header, cells, strict=False)
            ]
        record = dict(zip(header, cells + [""] * (len(header) - len(cells)), strict=True))
        entry = _entry(record, number, problems)
        if entry is not None:
            entries.append((number, entry))
    return entries


def _entry(record: dict[str, str], number: int, problems: list[str]) -> Entry | None:
    before = len(problems)
    low, high = _code(record["code"], number, problems)
    vegetation, vegetation_effect = _class("vegetation", record.get("vegetation", ""), number, problems)
    density, density_effect = _class("density", record.get("density", ""), number, problems)
    replaced = record.get("density_from_raster", "").lower() or "yes"
    if replaced not in ("yes", "no"):
        problems.append(f"line {number}: density_from_raster is {replaced!r}, expected yes or no")
    burning = burning_of(record, number, problems)
    missing = NO_DATA in (record.get("vegetation", "").lower(), record.get("density", "").lower())
    if len(problems) > before:
        return None
    return Entry(
        low,
        high,
        vegetation,
        density,
        vegetation_effect,
        density_effect,
        replaced == "yes",
        record.get("label", ""),
        missing,
        **burning,
    )


def _code(text: str, number: int, problems: list[str]) -> tuple[float, float]:
    match = _RANGE.match(text)
    try:
        low, high = (float(match[1]), float(match[2])) if match else (float(text),) * 2
        if not match and low != int(low):
            raise ValueError
    except (ValueError, OverflowError):
        problems.append(f"line {number}: the code is {text!r}, expected a whole number or a range like 0..40")
        return math.nan, math.nan
    if match and high <= low:
        problems.append(f"line {number}: the range {text} is empty")
    return low, high


def _class(kind: str, text: str, number: int, problems: list[str]) -> tuple[int | None, float | None]:
    """Return class code and effect of a cell; both None if it is blank."""
    classes = {label: code for code, label in _CLASSES[kind].items()}
    word = text.lower()
    if word in ("", NO_DATA):
        return None, None
    if word in classes:
        return classes[word], None
    expected = f"expected one of {', '.join(classes)}, {NO_DATA}, or an effect as a number with a decimal point"
    try:
        effect = float(word)
    except ValueError:
        problems.append(f"line {number}: the {kind} is {text!r}, {expected}")
        return None, None
    if "." not in word:
        # Class numbers would else be taken for effects of 1, 2 and 3.
        problems.append(f"line {number}: the {kind} is {text!r}, {expected} (class numbers are not)")
        return None, None
    if not (math.isfinite(effect) and effect > -1):
        problems.append(
            f"line {number}: the {kind} effect is {text}, expected more than -1.0; write none for what cannot burn"
        )
        return None, None
    nearest = _NEAREST[kind]
    return min(nearest, key=lambda code: abs(nearest[code] - effect)), effect


def _find_overlaps(entries: list[tuple[int, Entry]], problems: list[str]) -> None:
    ordered = sorted(entries, key=lambda item: (item[1].low, item[1].high))
    for (first, one), (second, other) in itertools.pairwise(ordered):
        if other.low < one.high or other.low == one.low:
            problems.append(f"line {max(first, second)}: the code overlaps that of line {min(first, second)}")
