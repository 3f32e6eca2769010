"""Legends: tables that map the codes of a raster to the classes of the spread model.

A legend is a CSV file with the columns `code`, `vegetation`, `density`, `label`; lines that begin
with `#` say where it comes from. Classes are written by name; a number with a decimal point in place
of a name is the continuous effect itself (0.4 is what "pines" stands for in the paper). A code may be
a range `low..high`, low included, high not (the highest end of all is): then the raster is a
quantity, such as canopy cover in percent. The optional column `density_from_raster` (yes or no, yes
if absent) says whether a density raster, where one is given, replaces the density of the legend.
"""

from __future__ import annotations

import csv
import importlib.resources
import itertools
import math
import os
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from firebreak_gis.errors import LegendError
from firebreak_gis.schema import DENSITY, VEGETATION

COLUMNS = ("code", "vegetation", "density", "label", "density_from_raster")
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
    """

    low: float
    high: float
    vegetation: int | None = None
    density: int | None = None
    vegetation_effect: float | None = None
    density_effect: float | None = None
    density_from_raster: bool = True
    label: str = ""


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

    @property
    def has_vegetation(self) -> bool:
        """Whether every entry gives a vegetation class or effect."""
        return all(entry.vegetation is not None for entry in self.entries)

    @property
    def has_density(self) -> bool:
        """Whether every entry that can burn gives a density class or effect."""
        return all(entry.density is not None for entry in self.entries if entry.vegetation != 0)

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
        inside = (index >= 0) & (numbers < highs[found])
        inside |= (
            (index >= 0) & (numbers == highs[found]) & ((lows[found] == highs[found]) | (highs[found] == highs.max()))
        )
        return np.where(inside, found, -1)

    def column(self, name: str, missing: float) -> np.ndarray:
        """Return one field of all entries as floats, `missing` where it is not given.

        One more element stands at the end, also `missing`, so that index -1 of `find` falls on it.
        """
        values = [getattr(entry, name) for entry in self.entries]
        return np.array([missing if value is None else float(value) for value in values] + [missing])


def names() -> list[str]:
    """Return the names of the built-in legends, sorted."""
    folder = importlib.resources.files(__package__)
    return sorted(entry.name.removesuffix(".csv") for entry in folder.iterdir() if entry.name.endswith(".csv"))


def read_legend(name_or_path: str | os.PathLike[str] | Legend) -> Legend:
    """Read a built-in legend by name, or a CSV file by path.

    Raises
    ------
    LegendError
        If there is no such legend, or naming all problems of the file with their line numbers.
    """
    if isinstance(name_or_path, Legend):
        return name_or_path
    name = os.fspath(name_or_path)
    if name in names():
        text = (importlib.resources.files(__package__) / f"{name}.csv").read_text(encoding="utf-8")
        return parse(text, name, f"the legend {name}")
    path = Path(name)
    if not path.is_file():
        raise LegendError(f"no legend {name!r}: neither a built-in one ({', '.join(names())}) nor a CSV file")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise LegendError(f"cannot read the legend {name}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise LegendError(f"the legend {name} is not UTF-8 text; save it as CSV UTF-8") from error
    return parse(text, path.stem, name)


def parse(text: str, name: str, where: str) -> Legend:
    """Parse the text of a legend; `where` names it in messages.

    Raises
    ------
    LegendError
        Naming all problems with their line numbers.
    """
    lines = [(number, line) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    about = tuple(line.strip().lstrip("# ") for _, line in lines if line.lstrip().startswith("#"))
    rows = [(number, line) for number, line in lines if not line.lstrip().startswith("#")]
    if not rows:
        raise LegendError(f"{where} is empty; expected a line {','.join(COLUMNS[:4])} and one line a code")
    header = [cell.strip().lower() for cell in next(csv.reader([rows[0][1]]))]
    unknown = [cell for cell in header if cell not in COLUMNS]
    if "code" not in header or unknown or not {"vegetation", "density"} & set(header) or len(set(header)) < len(header):
        raise LegendError(
            f"{where}, line {rows[0][0]}: got the columns {', '.join(header)}, expected "
            f"{', '.join(COLUMNS[:4])} "
            "separated by commas (density_from_raster is optional)"
        )
    problems: list[str] = []
    entries = []
    for number, line in rows[1:]:
        cells = [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True))]
        if len(cells) > len(header):
            problems.append(
                f"line {number}: {len(cells)} cells, expected at most {len(header)}; quote texts that hold commas"
            )
            continue
        record = dict(zip(header, cells + [""] * (len(header) - len(cells)), strict=True))
        entry = _entry(record, number, problems)
        if entry is not None:
            entries.append((number, entry))
    _find_overlaps(entries, problems)
    if not entries and not problems:
        problems.append("no codes")
    if problems:
        raise LegendError(f"{where} cannot be used: " + "; ".join(problems))
    ordered = sorted((entry for _, entry in entries), key=lambda entry: entry.low)
    return Legend(name, tuple(ordered), about)


def _entry(record: dict[str, str], number: int, problems: list[str]) -> Entry | None:
    before = len(problems)
    low, high = _code(record["code"], number, problems)
    vegetation, vegetation_effect = _class("vegetation", record.get("vegetation", ""), number, problems)
    density, density_effect = _class("density", record.get("density", ""), number, problems)
    replaced = record.get("density_from_raster", "").lower() or "yes"
    if replaced not in ("yes", "no"):
        problems.append(f"line {number}: density_from_raster is {replaced!r}, expected yes or no")
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
    )


def _code(text: str, number: int, problems: list[str]) -> tuple[float, float]:
    match = _RANGE.match(text)
    try:
        low, high = (float(match[1]), float(match[2])) if match else (float(int(text)),) * 2
    except ValueError:
        problems.append(f"line {number}: the code is {text!r}, expected a whole number or a range like 0..40")
        return math.nan, math.nan
    if match and high <= low:
        problems.append(f"line {number}: the range {text} is empty")
    return low, high


def _class(kind: str, text: str, number: int, problems: list[str]) -> tuple[int | None, float | None]:
    """Return class code and effect of a cell; both None if it is blank."""
    classes = {label: code for code, label in _CLASSES[kind].items()}
    word = text.lower()
    if not word:
        return None, None
    if word in classes:
        return classes[word], None
    expected = f"expected one of {', '.join(classes)}, or an effect as a number with a decimal point"
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
