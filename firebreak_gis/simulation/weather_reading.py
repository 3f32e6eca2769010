"""Weather from tables and wind roses.

A table (CSV, with commas, semicolons or tabs) has one line a weather, or one line a step of a weather that changes:

* `wind_speed` (or `WS`) and `wind_from` (or `wind_from_direction`, `wind_direction`, `WD`): where the wind comes from;
* optional `moisture` of the fine dead fuel, `weight`, and `duration` of the fires;
* optional `scenario` (or `Instance`): lines of one name are steps of one weather, in their order;
* optional `time` (or `datetime`): when a step begins, as ISO dates or as a number since the fire starts.

A column tells its unit in its name: `wind_speed_kmh`, `wind_speed [km/h]`, `duration_h`, `moisture (%)`. Without one
wind is in m/s, directions in degrees and moisture a share; `WS` is in km/h, as in the tables of Cell2Fire, and a
duration or a time must tell its unit. With a time, or a step told by the caller, all lines that share a scenario (or
all, if there is none) are one weather that changes; else each line is a weather of the ensemble.

A wind rose is a text: `rose:NW=5x0.4,N=8x0.2,225=20km/hx0.1;moisture=6%;duration=8h`. Each word is a direction that the
wind comes from (16 points of the compass, or degrees), the speed, and after an `x` the weight, 1 if not told.
"""

from __future__ import annotations

import csv
import datetime as dt
import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.rasters.units import ANGLE, SHARE, SPEED, TIME, Quantity, read_number, unit_in
from firebreak_gis.simulation.weather import Spell, Step, Weather

ROSE = "rose:"
_POINTS = ("N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW")
#: What a column may hold, and what it may be called, in lower case without units.
_NAMES: Mapping[str, tuple[str, ...]] = {
    "wind_speed": ("wind_speed", "windspeed", "ws"),
    "wind_from": ("wind_from", "wind_from_direction", "wind_direction", "winddirection", "wd"),
    "moisture": ("moisture",),
    "weight": ("weight",),
    "duration": ("duration",),
    "time": ("time", "datetime", "date_time"),
    "scenario": ("scenario", "instance"),
}
_QUANTITIES: Mapping[str, Quantity] = {
    "wind_speed": SPEED,
    "wind_from": ANGLE,
    "moisture": SHARE,
    "duration": TIME,
    "time": TIME,
}
#: Ways to write a date and time other than ISO 8601; they must agree on how far the lines are apart.
_DATES = tuple(
    f"{day} {hour}"
    for day in ("%d/%m/%y", "%d/%m/%Y", "%m/%d/%y", "%m/%d/%Y", "%y/%m/%d", "%Y/%m/%d", "%d.%m.%Y", "%d-%m-%Y")
    for hour in ("%H:%M", "%H:%M:%S")
)


def read_weather(
    source: Any,
    *,
    step: float | str | None = None,
    columns: Mapping[str, str] | None = None,
    units: Mapping[str, str] | None = None,
    ignore: Iterable[str] = (),
) -> Weather:
    """Read an ensemble of weathers from a table or a wind rose.

    Parameters
    ----------
    source
        CSV file, pandas DataFrame, wind rose as text ("rose:NW=5x0.4,N=8x0.2"), or a `Weather`, which comes back.
    step
        How long each line of a table lasts, in seconds or as text ("1h"): its lines follow each other.
    columns
        Names of columns that are called otherwise, by what they hold: {"wind_speed": "FF"}. They hold `wind_speed`,
        `wind_from`, `moisture`, `weight`, `duration`, `time` or `scenario`.
    units
        Units of columns that do not tell them, likewise: {"wind_speed": "kn"}.
    ignore
        Names of columns to leave out.

    Raises
    ------
    InputError
        If the table cannot be read, has a column that is not known, a unit that is not of its quantity, or a cell that
        is no number; or if the lines follow each other and nothing tells when.
    ParameterError
        If a wind rose cannot be read, or an option names no column.

    Examples
    --------
    >>> weather = read_weather("rose:NW=5x0.4,N=36km/hx0.2;duration=8h")
    >>> [(s.steps[0].wind_speed, s.steps[0].wind_from_direction, s.weight, s.duration) for s in weather.spells]
    [(5.0, 315.0, 0.4, 28800.0), (10.0, 0.0, 0.2, 28800.0)]
    """
    if isinstance(source, Weather):
        return source
    if isinstance(source, str) and source.strip().lower().startswith(ROSE):
        if step is not None or columns or units or list(ignore):
            raise ParameterError("a wind rose has no columns and no steps; leave the options of tables out")
        return _rose(source.strip()[len(ROSE) :])
    table = _Table(*_rows(source), columns or {}, units or {}, list(ignore))
    return table.weather(None if step is None else _seconds(step, "step"))


def _seconds(value: float | str, what: str) -> float:
    number = read_number(value, TIME)
    if number is None or not (0 < number < math.inf):
        raise ParameterError(f"{what} is {value!r}, expected a time such as 1h or 30min")
    return number


def _rose(text: str) -> Weather:
    winds, *others = [part.strip() for part in text.split(";")]
    more: dict[str, float] = {}
    for other in others:
        name, _, value = other.partition("=")
        quantity = {"moisture": SHARE, "duration": TIME}.get(name.strip().lower())
        number = None if quantity is None else read_number(value.strip(), quantity)
        if number is None:
            raise ParameterError(f"the wind rose has {other!r}, expected moisture=6% or duration=8h")
        more[name.strip().lower()] = number
    spells = [_petal(word.strip(), more) for word in winds.split(",") if word.strip()]
    if not spells:
        raise ParameterError("the wind rose is empty, expected one such as rose:NW=5x0.4,N=8x0.2")
    return Weather(tuple(spells), ("a wind rose: a weather for each wind, steady",))


def _petal(word: str, more: Mapping[str, float]) -> Spell:
    found = re.match(
        r"^(?P<where>[^=]+)=(?P<speed>.+?)(?:\s*[x*]\s*(?P<weight>[\d.]+(?:e-?\d+)?)\s*(?P<share>%?))?$", word
    )
    speed = None if found is None else read_number(found["speed"].strip(), SPEED)
    where = "" if found is None else found["where"].strip()
    angle = 360.0 / len(_POINTS) * _POINTS.index(where.upper()) if where.upper() in _POINTS else None
    if angle is None and found is not None:
        angle = read_number(where, ANGLE)
    try:
        weight = float((found and found["weight"]) or 1.0)
    except ValueError:
        weight = math.nan
    if found is None or speed is None or angle is None or math.isnan(weight):
        raise ParameterError(
            f"the wind rose has {word!r}, expected where the wind comes from, its speed and its weight, such as "
            "NW=5x0.4 or 225=20km/hx0.1"
        )
    step = Step(speed, angle, more.get("moisture"))
    return Spell((step,), weight=weight * (0.01 if found["share"] else 1.0), duration=more.get("duration"), name=word)


def _rows(source: Any) -> tuple[str, list[str], list[tuple[int, list[str]]]]:
    """Name of a table for messages, its header, and its lines with their numbers."""
    if hasattr(source, "columns") and hasattr(source, "itertuples"):
        values = [[_cell(value) for value in line] for line in source.itertuples(index=False)]
        if not values:
            raise InputError("the table of weather is empty, expected a line a weather")
        return "the table of weather", [str(name) for name in source.columns], list(enumerate(values, start=1))
    path = Path(source)
    try:
        text = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise InputError(
            f"{path} does not exist; the weather is a CSV file, or a wind rose such as rose:NW=5x0.4"
        ) from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"the weather {path} cannot be read as a CSV file in UTF-8: {error}") from error
    numbered = [
        (n, line) for n, line in enumerate(text.splitlines(), start=1) if line.strip() and line.strip()[0] != "#"
    ]
    if len(numbered) < 2:
        raise InputError(f"the weather {path} is empty, expected a line of names and a line a weather")
    delimiter = max(",;\t", key=numbered[0][1].count)
    cells = [(n, [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter))]) for n, line in numbered]
    lines = [(n, [c.replace(",", ".") for c in row] if delimiter != "," else row) for n, row in cells[1:]]
    return str(path), cells[0][1], lines


def _cell(value: Any) -> str:
    text = str(value)
    return "" if text in ("nan", "NaT", "None", "<NA>") else text


class _Table:
    """The lines of a table by what its columns hold."""

    def __init__(
        self,
        name: str,
        header: list[str],
        lines: list[tuple[int, list[str]]],
        columns: Mapping[str, str],
        units: Mapping[str, str],
        ignore: Sequence[str],
    ) -> None:
        self.name = name
        self.said: list[str] = []
        self.where: dict[str, int] = {}
        self.unit: dict[str, str] = {}
        for option, given in (("columns", columns), ("units", units)):
            if strange := set(given) - set(_NAMES):
                raise ParameterError(
                    f"{option} names {', '.join(sorted(strange))}; a table of weather has {', '.join(_NAMES)}"
                )
        lacking = (set(columns.values()) | set(ignore)) - set(header)
        if lacking:
            raise ParameterError(f"{name} has no column {', '.join(sorted(lacking))}; it has {', '.join(header)}")
        problems = self._find(header, columns, units, ignore)
        problems += [f"there is no column for {need}" for need in ("wind_speed", "wind_from") if need not in self.where]
        if problems:
            raise InputError(f"{name} cannot be used as weather: " + "; ".join(problems))
        self.lines = lines
        for number, cells in lines:
            if len(cells) != len(header):
                raise InputError(f"{name}, line {number}: {len(cells)} cells, expected {len(header)}")

    def _find(
        self, header: list[str], columns: Mapping[str, str], units: Mapping[str, str], ignore: Sequence[str]
    ) -> list[str]:
        problems = []
        named = {column: what for what, column in columns.items()}
        for position, column in enumerate(header):
            if column in ignore:
                continue
            what, unit = (named[column], unit_in(column)) if column in named else _meaning(column)
            if not what:
                problems.append(
                    f"the column {column!r} is not known (known are {', '.join(_NAMES)}, with units such as "
                    "wind_speed_kmh or duration_h); name it, or say that it is to be left out"
                )
                continue
            if what in self.where:
                problems.append(f"the columns {header[self.where[what]]!r} and {column!r} both hold {what}")
                continue
            self.where[what] = position
            self.unit[what] = units.get(what, unit)
            quantity = _QUANTITIES.get(what)
            if quantity is None and self.unit[what]:
                problems.append(f"the column {column!r} has a unit, and {what} has none")
            elif quantity is not None and not quantity.knows(self.unit[what]):
                problems.append(f"the column {column!r} is in {self.unit[what]!r}, which is no unit of {quantity.name}")
            elif what == "duration" and not self.unit[what]:
                problems.append(f"the column {column!r} does not tell its unit; call it duration_h or duration_min")
            elif quantity is not None and what not in ("time", "scenario"):
                self.said.append(f"{column}: {what} in {self.unit[what] or quantity.unit}")
        return problems

    def weather(self, step: float | None) -> Weather:
        """Make the ensemble; `step` is in seconds."""
        groups: dict[str, list[tuple[int, list[str]]]] = {}
        follow = "scenario" in self.where or "time" in self.where or step is not None
        for order, (number, cells) in enumerate(self.lines):
            name = cells[self.where["scenario"]] if "scenario" in self.where else "" if follow else str(order)
            groups.setdefault(name, []).append((number, cells))
        spells = [self._spell(name if follow else "", lines, step) for name, lines in groups.items()]
        changing = sum(not spell.steady for spell in spells)
        self.said.append(
            f"{len(spells)} weathers, {changing} of them changing with time"
            if len(spells) > 1 or not changing
            else f"one weather that changes with time, {len(spells[0].steps)} steps"
        )
        return Weather(tuple(spells), tuple(self.said))

    def _spell(self, name: str, lines: list[tuple[int, list[str]]], step: float | None) -> Spell:
        steps = [
            Step(
                self._number("wind_speed", number, cells),
                self._number("wind_from", number, cells),
                self._number("moisture", number, cells) if "moisture" in self.where else None,
            )
            for number, cells in lines
        ]
        starts, span = self._starts(name, lines, step)
        return Spell(
            tuple(steps),
            starts,
            self._same("weight", name, lines, 1.0),
            self._same("duration", name, lines, None),
            span,
            name,
        )

    def _starts(
        self, name: str, lines: list[tuple[int, list[str]]], step: float | None
    ) -> tuple[tuple[int, ...], float | None]:
        """When each step begins, and for how long they are told."""
        if len(lines) == 1:
            return (0,), None
        where = f"{self.name}{f', scenario {name}' if name else ''}"
        if step is not None:
            return tuple(round(step * i) for i in range(len(lines))), step * len(lines)
        texts = [cells[self.where["time"]] for _, cells in lines] if "time" in self.where else []
        if len(set(texts)) < 2:
            told = f"all lines carry one time, {texts[0]!r}" if texts else "there is no column for the time"
            raise InputError(
                f"{where}: its {len(lines)} lines follow each other, but {told}; say how long each lasts "
                "(--weather-step 1h)"
            )
        times = (
            [float(self._number("time", n, cells)) for n, cells in lines]
            if self.unit["time"]
            else _moments(texts, where)
        )
        starts = [round(moment - times[0]) for moment in times]
        if any(b <= a for a, b in pairwise(starts)):
            raise InputError(f"{where}: its times do not rise from line to line; sort them, or leave doubles out")
        return tuple(starts), starts[-1] + (starts[-1] - starts[-2])

    def _same(self, what: str, name: str, lines: list[tuple[int, list[str]]], default: Any) -> Any:
        """The number that all lines of a weather have in common."""
        if what not in self.where:
            return default
        numbers = {self._number(what, number, cells) for number, cells in lines}
        if len(numbers) > 1:
            raise InputError(
                f"{self.name}: the lines of scenario {name!r} have different numbers for {what}, expected one"
            )
        return numbers.pop()

    def _number(self, what: str, line: int, cells: list[str]) -> float:
        text = cells[self.where[what]]
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise InputError(f"{self.name}, line {line}: {what} is {text!r}, expected a number")
        quantity = _QUANTITIES.get(what)
        converted = number if quantity is None else float(quantity.convert(number, self.unit[what]))
        if what == "moisture" and converted > 1:
            raise InputError(
                f"{self.name}, line {line}: moisture is {text}, expected a share of the dry weight; if it is in "
                "percent, call the column moisture_pct"
            )
        return converted


def _meaning(column: str) -> tuple[str, str]:
    """What a column holds by its name, and its unit: wind_speed and kmh for "Wind speed [kmh]" or "wind_speed_kmh"."""
    unit = unit_in(column)
    bare = re.sub(r"\s*[\[(][^\[\]()]*[\])]\s*$", "", column.strip())
    word = re.sub(r"[\s.-]+", "_", bare.lower())
    for what, names in _NAMES.items():
        for name in names:
            if word == name:
                return what, unit or ("km/h" if name == "ws" else "")
            if not unit and word.startswith(f"{name}_") and what in _QUANTITIES:
                rest = _in_names(word[len(name) + 1 :])
                if _QUANTITIES[what].knows(rest):
                    return what, rest
    return "", unit


def _in_names(word: str) -> str:
    """A unit as names of columns write it: "m_s" is m/s."""
    return word.replace("_per_", "/").replace("_", "/")


def _moments(texts: Sequence[str], where: str) -> list[float]:
    """Seconds of dates and times, from any moment on."""
    found: set[tuple[float, ...]] = set()
    for read in (dt.datetime.fromisoformat, *(_reader(way) for way in _DATES)):
        try:
            moments = [read(text) for text in texts]
            found.add(tuple((moment - moments[0]).total_seconds() for moment in moments))
        except (ValueError, TypeError):  # another way, or some with a zone and some without
            continue
    if len(found) != 1:
        why = "can be read in more than one way" if found else "cannot be read"
        raise InputError(
            f"{where}: the times, such as {texts[0]!r}, {why}; write them as 2025-03-23 14:00, or as "
            "numbers with a unit in the name of the column, such as time_h"
        )
    return list(found.pop())


def _reader(way: str) -> Callable[[str], dt.datetime]:
    return lambda text: dt.datetime.strptime(text, way)
