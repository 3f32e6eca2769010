"""What a command-line value is, beyond its being text: help pages and forms ask for the name, commands get the value.

Every text is converted here, once, before the command starts. To add a kind: a function in `parsing` that reads the
text, and a `Kind` (or, for options that may be repeated, a callback) here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem

from firebreak_gis import plugins
from firebreak_gis.cli import parsing
from firebreak_gis.cli.requests import note
from firebreak_gis.files.formats import FORMATS
from firebreak_gis.landscape import legends
from firebreak_gis.landscape.continuity import CONTINUITY
from firebreak_gis.rasters.units import ANGLE, SHARE, SPEED
from firebreak_gis.schema import DENSITY


class Kind(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in newer releases
    """A value, read from text.

    Parameters
    ----------
    name
        `raster`, `vector`, `file`, `number`, `choice`, `choices` (several, by commas) or `crs`; alternatives
        are joined by "|", the usual one first.
    choices
        Returns the words of `choice` and `choices`; asked only for descriptions, commands check by
        themselves.
    read
        Reads the text, given it and the flag for messages; without it the text is the value.
    """

    def __init__(
        self,
        name: str,
        choices: Callable[[], Sequence[str]] | None = None,
        read: Callable[[Any, str], Any] | None = None,
    ) -> None:
        self.name = name
        self.choices = choices
        self._read = read

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the value that the text stands for."""
        if self._read is None:
            return value
        found = self._read(value, _flag(param))
        if not isinstance(found, float):  # a number stands for itself
            note(ctx, param, value)
        return found

    def shell_complete(self, _ctx: click.Context, _param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """Words that the value may be, for the shell; the last of several, or the name of a file."""
        if self.choices is None:
            plain = self.name in ("number", "text", "crs")
            return [] if plain else [CompletionItem(incomplete, type="file")]
        before, comma, word = incomplete.rpartition(",") if self.name == "choices" else ("", "", incomplete)
        found = [CompletionItem(f"{before}{comma}{one}") for one in self.choices() if one.startswith(word)]
        return found or [CompletionItem(incomplete, type="file")] if "|" in self.name else found


class Whole(click.types.IntParamType):
    """A whole number with a least value."""

    def __init__(self, least: int) -> None:
        self._least = least

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """Return the number."""
        number = int(super().convert(value, param, ctx))
        parsing.require_least(number, self._least, "number" if param is None else str(param.name))
        return number


class NewFile(click.Path):
    """A file that the command writes.

    Parameters
    ----------
    name
        `new-raster`, `new-vector`, `new-table` or `new-config`.
    extensions
        Those that it may have.
    """

    def __init__(self, name: str, extensions: Sequence[str]) -> None:
        super().__init__(dir_okay=False)
        self.name = name
        self.extensions = tuple(extensions)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path, whose extension is one of those."""
        path = super().convert(value, param, ctx)
        parsing.require_extension(str(path), self.extensions, _flag(param))
        return path


class _LandscapeFolder(click.Path):
    """The folder of a landscape; a layer in its place is what someone gives who skips `align`."""

    def __init__(self) -> None:
        super().__init__(file_okay=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path, which is no file."""
        if Path(value).is_file():
            self.fail(
                f"{value} is a file; give the folder that firebreak align makes of the layers: "
                "firebreak align DEM VEGETATION DENSITY -o FOLDER",
                param,
                ctx,
            )
        return super().convert(value, param, ctx)


def pairs(_: click.Context, param: click.Parameter, words: Any) -> dict[str, str]:
    """Callback of options NAME=VALUE that may be repeated."""
    return parsing.pairs(words, _flag(param))


def _from_words(read: Callable[[Any, str], Any]) -> Callable[[click.Context, click.Parameter, Any], Any]:
    """Make the callback of options of several words, or that may be repeated."""

    def callback(ctx: click.Context, param: click.Parameter, words: Any) -> Any:
        note(ctx, param, words)
        return read(words, _flag(param))

    return callback


def _flag(param: click.Parameter | None) -> str:
    return "" if param is None else max(param.opts, key=len)


CRS = Kind("crs")
RASTER = Kind("raster")
RASTER_OR_NUMBER = Kind("number|raster")
WIND_SPEED = Kind("number|raster", read=parsing.measured(SPEED))
WIND_DIRECTION = Kind("number|raster", read=parsing.measured(ANGLE))
MOISTURE = Kind("number|raster", read=parsing.measured(SHARE))
VECTOR = Kind("vector")
VECTOR_OR_RASTER = Kind("vector|raster")
RASTER_OR_VECTOR = Kind("raster|vector")
COST = Kind("vector|raster|text", read=parsing.cost)
RASTER_OR_DENSITY = Kind("raster|choice", lambda: [*(word for code, word in DENSITY.items() if code), CONTINUITY])
FILE_OR_TEXT = Kind("file|text")
LEGEND = Kind("choice|file", legends.names)
RANKING = Kind("choice", lambda: plugins.names("ranking"))
RANKINGS = Kind("choices", lambda: plugins.names("ranking"), parsing.methods_list)
PLANS = Kind("choices", lambda: [parsing.LINES, *plugins.names("ranking")], parsing.plans_list)
SPREAD = Kind("choice", lambda: plugins.names("spread"))
BUDGET = Kind("text", read=parsing.budget)
BUDGET_PER_YEAR = Kind("text", read=parsing.budget_per_year)
INTERVALS = Kind("text", read=parsing.intervals)
RATE = Kind("text", read=parsing.rate)
BUDGETS = Kind("text", read=parsing.budget_list)
NUMBERS = Kind("text", read=parsing.number_list)
WORDS = Kind("text", read=parsing.word_list)
VECTOR_OR_TABLE = Kind("vector|file")
FOLDER_OR_FILE = Kind("directory|file")
GEOPACKAGE = Kind("file")
SIZE = Kind("text", read=parsing.byte_size)
LENGTH = Kind("text", read=parsing.length)
LINE_WIDTH = Kind("text", read=parsing.line_width)
HECTARES = Kind("text", read=parsing.hectares)
PLANNED_WIDTH = Kind("text", read=parsing.planned_width)
TIMES = Kind("text", read=parsing.times)
DURATION = Kind("text", read=parsing.duration)
TIME = Kind("text", read=parsing.seconds)
HOLD = Kind("text", read=parsing.hold)
EMBERS = Kind("text", read=parsing.embers)
TREATMENTS = Kind("file|text", read=parsing.treatments)
TRAVEL = Kind("text", read=parsing.travel)
CONTAINMENT = Kind("text", read=parsing.containment)
SHARE_OF_RUNS = Kind("number", read=parsing.share)
LANDSCAPE_FOLDER = _LandscapeFolder()
SEED = Whole(0)
COUNT = Whole(1)
WIND_COMPONENTS = _from_words(parsing.components)
LAYER_CRS = _from_words(parsing.layer_crs)
LAYER_NODATA = _from_words(parsing.layer_numbers)
LAYER_BAND = _from_words(parsing.layer_band)
VALUE_LAYERS = _from_words(parsing.value_layers)
NEW_RASTER = NewFile("new-raster", (".tif", ".tiff"))
NEW_PAGE = NewFile("new-file", (".html",))
NEW_TABLE = NewFile("new-table", (".csv",))
NEW_VECTOR = NewFile("new-vector", tuple(FORMATS))
NEW_AREAS = NewFile("new-vector", tuple(end for end, kind in FORMATS.items() if "Polygon" in kind.holds))
NEW_BOOK = NewFile("new-file", (".pdf",))
NEW_CONFIG = NewFile("new-config", (".toml",))
