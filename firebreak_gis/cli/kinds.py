"""What a command-line value is, beyond its being text: help pages and forms ask for the name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import click

from firebreak_gis import plugins
from firebreak_gis.landscape import legends
from firebreak_gis.landscape.continuity import CONTINUITY
from firebreak_gis.schema import DENSITY


class Kind(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in newer releases
    """A value passed on as text.

    Parameters
    ----------
    name
        `raster`, `vector`, `file`, `number`, `choice`, `choices` (several, by commas) or `crs`; alternatives
        are joined by "|", the usual one first.
    choices
        Returns the words of `choice` and `choices`; asked only for descriptions, commands check by
        themselves.
    """

    def __init__(self, name: str, choices: Callable[[], Sequence[str]] | None = None) -> None:
        self.name = name
        self.choices = choices

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:  # noqa: ARG002
        """Return the value as it is."""
        return value


class NewFile(click.Path):
    """A file that the command writes; `name` is `new-raster`, `new-vector` or `new-table`."""

    def __init__(self, name: str) -> None:
        super().__init__(dir_okay=False)
        self.name = name


CRS = Kind("crs")
RASTER = Kind("raster")
RASTER_OR_NUMBER = Kind("number|raster")
VECTOR_OR_RASTER = Kind("vector|raster")
COST = Kind("vector|raster|text")
RASTER_OR_DENSITY = Kind("raster|choice", lambda: [*(word for code, word in DENSITY.items() if code), CONTINUITY])
LEGEND = Kind("choice|file", legends.names)
RANKING = Kind("choice", lambda: plugins.names("ranking"))
RANKINGS = Kind("choices", lambda: plugins.names("ranking"))
SPREAD = Kind("choice", lambda: plugins.names("spread"))
NEW_RASTER = NewFile("new-raster")
NEW_TABLE = NewFile("new-table")
NEW_VECTOR = NewFile("new-vector")
