"""What options given as text mean: pairs, lists, sizes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from firebreak_gis import plugins
from firebreak_gis.breaks import Budget
from firebreak_gis.errors import OutputError, ParameterError
from firebreak_gis.files.formats import hint
from firebreak_gis.rasters.units import SPEED, Quantity

if TYPE_CHECKING:
    from firebreak_gis.landscape.stake_layers import ValueLayer
    from firebreak_gis.planning.line_design import Widths

#: The layers of a landscape, as the command line names them.
LAYERS = ("dem", "vegetation", "density")
#: Among methods that are compared, `dissection` whose breaks are lines.
LINES = "lines"


class Method(NamedTuple):
    """One of several rankings: what it is called, its plug-in, its parameters; of lines their width, None if usual."""

    label: str
    name: str
    params: dict[str, Any]
    line_width: Widths | None = "cells"


def pairs(words: Iterable[str], option: str) -> dict[str, str]:
    """Split NAME=VALUE words.

    Raises
    ------
    ParameterError
        If a word has no "=".
    """
    result = {}
    for word in words:
        name, equals, value = word.partition("=")
        if not equals or not name:
            raise ParameterError(f"{option} got {word!r}, expected NAME=VALUE")
        result[name.strip()] = value.strip()
    return result


def methods_list(text: str, option: str = "--methods", *, lines: bool = False) -> list[Method]:
    """Split "bonacich:beta=0.2,random" into methods; where asked, "lines:width=20" is one as well."""
    result = []
    for word in filter(None, (w.strip() for w in text.split(","))):
        name, *rest = word.split(":")
        params = pairs(rest, option)
        if lines and name == LINES:
            result.append(_of_lines(word, params, option))
            continue
        plugins.load("ranking", name)
        result.append(Method(word, name, params))
    labels = [method.label for method in result]
    if not result or len(set(labels)) != len(labels):
        raise ParameterError(f"{option} got {text!r}, expected different names such as bonacich:beta=0.5,random")
    return result


def plans_list(text: str, option: str = "--methods") -> list[Method]:
    """Split "lines,bonacich:beta=0.2" into methods, lines among them."""
    return methods_list(text, option, lines=True)


def _of_lines(label: str, params: dict[str, Any], option: str) -> Method:
    text = params.pop("width", None)
    width = None if text is None else planned_width(text, f"{option} {LINES}:width")
    if width == "cells":
        raise ParameterError(f"{option} got {label!r}; breaks of cells are the method dissection")
    return Method(label, "dissection", params, width)


def budget(text: Any, _option: str = "") -> float | Budget:
    """Read how much may be cut; a plain number is left to the unit that another option gives."""
    try:
        return float(text)
    except ValueError:
        return Budget.of(str(text))


def budget_per_year(text: Any, _option: str = "") -> Budget:
    """Read how much a year affords; a plain number is a share."""
    return Budget.of(str(text))


def intervals(text: Any, _option: str = "") -> dict[str, float]:
    """Read years until fuel has grown back."""
    from firebreak_gis.construction.years import return_intervals

    return return_intervals(str(text))


def rate(text: Any, option: str) -> float:
    """Read a rate: "3%" or 0.03."""
    word = str(text).strip()
    try:
        return float(word[:-1]) / 100.0 if word.endswith("%") else float(word)
    except ValueError:
        raise ParameterError(f"{option} is {text!r}, expected a rate such as 3% or 0.03") from None


def budget_list(text: Any, option: str) -> list[Budget]:
    """Split "5%,10%" or "5ha,10ha" into different budgets; plain numbers are shares.

    Raises
    ------
    ParameterError
        If a word is no budget, or there is none.
    """
    found = [Budget.of(word.strip()) for word in str(text).split(",") if word.strip()]
    if not found:
        raise ParameterError(f"{option} got {text!r}, expected budgets such as 5%,10% or 5ha,10ha")
    return list(dict.fromkeys(found))


def number_list(text: Any, option: str) -> list[float]:
    """Split "0,0.05,0.1" into rising numbers.

    Raises
    ------
    ParameterError
        If a word is no number or there is none.
    """
    try:
        numbers = sorted({float(word) for word in str(text).split(",") if word.strip()})
    except ValueError:
        numbers = []
    if not numbers:
        raise ParameterError(f"{option} got {text!r}, expected numbers such as 0,0.05,0.1")
    return numbers


def word_list(text: Any, option: str) -> list[str]:
    """Split "rate,duration" into different words.

    Raises
    ------
    ParameterError
        If there is none.
    """
    words = list(dict.fromkeys(word.strip() for word in str(text).split(",") if word.strip()))
    if not words:
        raise ParameterError(f"{option} got {text!r}, expected words separated by commas")
    return words


def require_least(number: int, least: int, name: str) -> None:
    """Refuse a whole number that is too small."""
    if number < least:
        raise ParameterError(f"{name} is {number}, expected a whole number of at least {least}")


def require_extension(path: str, extensions: Sequence[str], option: str) -> None:
    """Refuse the name of a file that cannot be written.

    Raises
    ------
    OutputError
        If its extension is none of those.
    """
    if Path(path).suffix.lower() not in extensions:
        raise OutputError(
            f"{option} got {path!r}, expected the extension {' or '.join(extensions)}"
            f"{hint(Path(path).suffix, extensions)}"
        )


def byte_size(text: str | None, option: str = "--max-memory") -> int | None:
    """Read "4GB", "800 MiB" or a number of bytes.

    Raises
    ------
    ParameterError
        If the text is no size.
    """
    if text is None:
        return None
    words = str(text).strip().upper().replace("IB", "B").rstrip("B")
    factor = {"K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}.get(words[-1:], 1)
    try:
        size = int(float(words.rstrip("KMGT")) * factor)
    except (ValueError, OverflowError):
        size = 0
    if size <= 0:
        raise ParameterError(f"{option} got {text!r}, expected a size such as 4GB")
    return size


def line_width(text: Any, option: str) -> float | str:
    """Read the width of lines: "12" or "12m", in metres; anything else names a column."""
    word = str(text).strip()
    try:
        metres = float(word.removesuffix("m"))
    except ValueError:
        return word
    if not 0 < metres < float("inf"):
        raise ParameterError(f"{option} is {text!r}, expected metres above 0, or the name of a column")
    return metres


def planned_width(text: Any, option: str) -> Widths:
    """Read "12" or "12m", in metres, "auto" or "cells"."""
    found = line_width(text, option)
    if not isinstance(found, str):
        return found
    words: dict[str, Widths] = {"auto": "auto", "cells": "cells"}
    if found.lower() not in words:
        raise ParameterError(f"{option} is {text!r}, expected metres, such as 12m, auto or cells")
    return words[found.lower()]


def measured(quantity: Quantity) -> Callable[[Any, str], float | str]:
    """Make a reader of numbers, with or without a unit; anything else must name a raster that exists."""

    def read(value: Any, option: str) -> float | str:
        from firebreak_gis.landscape.weather_layers import measured

        try:
            number = measured(value, quantity)
        except ParameterError as error:
            raise ParameterError(f"{option}: {error}") from None
        return str(value) if number is None else number

    return read


def components(words: Sequence[str] | None, option: str) -> tuple[float | str, ...] | None:
    """Read the two components of a wind, each as `measured` does."""
    return None if words is None else tuple(measured(SPEED)(word, option) for word in words)


def cost(text: str, _: str = "") -> str | dict[str, float]:
    """Read costs: a name, or rates by class such as "agricultural=500,shrubs=900,pines=1500"."""
    from firebreak_gis.landscape.stake_layers import rates_by_class

    return rates_by_class(text) if "=" in text else text


def layer_crs(words: Iterable[str], _: str = "") -> dict[str, str]:
    """Read LAYER=CRS words; a word without a layer (its CRS may hold "=" itself, as +proj=utm) is for all."""
    result: dict[str, str] = {}
    for word in words:
        layer, _, crs = str(word).partition("=")
        result.update({layer: crs} if layer in LAYERS else dict.fromkeys(LAYERS, str(word)))
    return result


def layer_numbers(words: Iterable[str], option: str) -> dict[str, list[float]]:
    """Read LAYER=VALUE,VALUE words; what is given twice for a layer is added up. "none" is NaN: no value at all."""
    return _layer_values(words, option, lambda word: float("nan") if word.strip().lower() == "none" else float(word))


def layer_band(words: Iterable[str], option: str) -> dict[str, int]:
    """Read LAYER=BAND words; of those given twice for a layer the last one counts."""
    return {layer: numbers[-1] for layer, numbers in _layer_values(words, option, int).items()}


def _layer_values(words: Iterable[str], option: str, kind: Callable[[str], Any]) -> dict[str, list[Any]]:
    result: dict[str, list[Any]] = {}
    for word in words:
        ((layer, text),) = pairs((word,), option).items()
        if layer not in LAYERS:
            raise ParameterError(f"{option} names {layer!r}, expected dem, vegetation or density")
        try:
            result.setdefault(layer, []).extend(kind(value) for value in str(text).split(","))
        except ValueError:
            raise ParameterError(f"{option} {layer} is {text!r}, expected a number") from None
    return result


def value_layers(words: Iterable[str], option: str) -> tuple[ValueLayer, ...]:
    """Read NAME=PATH[,field=...][,weight=...][,as=...] words, each name once."""
    from firebreak_gis.landscape.stake_layers import value_layer

    made: list[ValueLayer] = []
    for word in words:
        ((name, text),) = pairs((word,), option).items()
        if name in {"hectares", "value", "values", *(layer.name for layer in made)}:
            raise ParameterError(f"{option} names {name!r}, which is taken; give each value a name of its own")
        made.append(value_layer(name, str(text)))
    return tuple(made)


def hectares(text: Any, option: str) -> float:
    """Read an area: "500ha", "5km2", or a number of hectares."""
    word = str(text).strip().lower()
    factor = 100.0 if word.endswith("km2") else 1.0
    try:
        number = factor * float(word.removesuffix("km2").removesuffix("ha"))
    except ValueError:
        number = 0.0
    if not (number > 0 and number < float("inf")):
        raise ParameterError(f"{option} is {text!r}, expected an area above 0, such as 500ha or 5km2")
    return number


def length(text: Any, option: str) -> float:
    """Read a distance in metres: "50", "50m" or "0.2km".

    Raises
    ------
    ParameterError
        If the text is no distance of at least 0.
    """
    word = str(text).strip().lower()
    factor = 1000.0 if word.endswith("km") else 1.0
    try:
        metres = float(word.removesuffix("km").removesuffix("m")) * factor
    except ValueError:
        metres = -1.0
    if not 0.0 <= metres < float("inf"):
        raise ParameterError(f"{option} got {text!r}, expected a distance of at least 0 such as 50m")
    return metres


def times(text: Any, option: str) -> list[float]:
    """Split "2h,4h" into rising seconds."""
    from firebreak_gis.simulation.durations import as_seconds

    found = sorted({as_seconds(word, option) for word in str(text).split(",") if word.strip()})
    if not found or found[0] <= 0:
        raise ParameterError(f"{option} is {text!r}, expected times such as 2h,4h,8h")
    return found


def seconds(text: Any, option: str) -> float:
    """Read a time such as "8h", see `simulation.durations`."""
    from firebreak_gis.simulation.durations import as_seconds

    return as_seconds(text, option)


def duration(text: Any, option: str) -> Any:
    """Read how long fires burn, see `simulation.durations`."""
    from firebreak_gis.simulation.durations import as_duration

    return as_duration(text, option)


def hold(text: Any, option: str) -> Any:
    """Read how breaks hold, see `simulation.holding`."""
    from firebreak_gis.simulation.holding import as_hold

    return as_hold(text, option)


def treatments(text: Any, _option: str) -> Any:
    """Read a table of treatments, see `construction.treatments`; `default` is the built-in one."""
    from firebreak_gis.construction.treatments import as_treatments

    return as_treatments(str(text))


def containment(text: Any, option: str) -> Any:
    """Read when fires are contained, see `simulation.containment`; None if never, as if it had not been given."""
    from firebreak_gis.simulation.containment import as_containment

    crews = as_containment(text, option)
    return None if crews is None or crews.endless else crews


def embers(text: Any, option: str) -> Any:
    """Read embers, see `simulation.embers`."""
    from firebreak_gis.simulation.embers import as_embers

    return as_embers(text, option)


def travel(text: Any, option: str) -> Any:
    """Read how crews travel, see `simulation.stations`."""
    from firebreak_gis.simulation.stations import as_travel

    return as_travel(text, option)


def share(text: Any, option: str) -> float:
    """Read a share from 0 to 1."""
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not 0.0 <= number <= 1.0:
        raise ParameterError(f"{option} is {text!r}, expected a share from 0 to 1")
    return number
