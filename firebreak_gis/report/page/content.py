"""What a report page shows, as plain values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

#: A line chart's lines: name, values across, values up (shares).
Line = tuple[str, Sequence[float], Sequence[float]]


@dataclass(frozen=True)
class Picture:
    """A raster as the map shows it.

    Parameters
    ----------
    key
        Unique short name. `before` and `after` are the two sides of the slider.
    label
        What it is, with the unit.
    image
        A PNG as a data address.
    legend
        Colour and text of each class, or of steps of a ramp.
    shown
        Whether it is shown at first.
    base
        Whether it is a ground, of which one is shown at a time.
    """

    key: str
    label: str
    image: str
    legend: tuple[tuple[str, str], ...] = ()
    shown: bool = False
    base: bool = False


@dataclass(frozen=True)
class Outlines:
    """Lines or areas on the map.

    Parameters
    ----------
    key, label
        As of a picture.
    features
        GeoJSON features in the map's coordinates, metres from its lower left corner; the properties of each are what
        its card shows, text by text.
    colour
        Of lines and outlines.
    shown
        Whether they are shown at first.
    legend
        Colours and their texts, if there are several.
    """

    key: str
    label: str
    features: Sequence[Mapping[str, Any]]
    colour: str = "#1f4fd8"
    shown: bool = False
    legend: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Curve:
    """A line chart of shares."""

    title: str
    note: str
    across: str
    lines: Sequence[Line]
    marked: float | None = None


@dataclass(frozen=True)
class Row:
    """A row of a table.

    Parameters
    ----------
    cells
        Value of each column: numbers sort as numbers.
    decimals
        Digits behind the point, by column; others are shown as they are.
    summed
        Columns that a total makes sense for.
    feature
        Number of the feature on the map that the row stands for.
    group
        Rows in a row with the same words here stand under a line with these words and their sums.
    """

    cells: Mapping[str, Any]
    decimals: Mapping[str, int] = field(default_factory=dict)
    summed: frozenset[str] = frozenset()
    feature: int | None = None
    group: str = ""

    def shown(self, name: str) -> str:
        """Text of a cell; a dash for nothing."""
        return self.as_text(name, self.cells[name])

    def as_text(self, name: str, value: Any) -> str:
        """Text of a value of a column."""
        if value is None:
            return "\N{EN DASH}"
        return f"{value:,.{self.decimals[name]}f}" if name in self.decimals else str(value)


@dataclass(frozen=True)
class Page:
    """A report page.

    Parameters
    ----------
    title
        Of the page.
    headline
        Sentences said first.
    assumptions
        What the headline rests on, beside it.
    warnings
        What may be wrong.
    figures
        Name, value and note of key figures.
    size
        Width and height of the map [m].
    origin
        Easting and northing of its lower left corner, and the name of the CRS.
    pictures, outlines
        Layers of the map, lowest first.
    curve
        Burnt share against share cut.
    segments, comparison, goals, years
        Rows of tables.
    files
        Name and label of the files beside the page.
    provenance
        Name and value: program, parameters, inputs with their hashes.
    """

    title: str
    headline: Sequence[str] = ()
    assumptions: Sequence[str] = ()
    warnings: Sequence[str] = ()
    figures: Sequence[tuple[str, str, str]] = ()
    size: tuple[float, float] = (1.0, 1.0)
    origin: tuple[float, float, str] = (0.0, 0.0, "")
    pictures: Sequence[Picture] = ()
    outlines: Sequence[Outlines] = ()
    curve: Curve | None = None
    segments: Sequence[Row] = ()
    comparison: Sequence[Row] = ()
    goals: Sequence[Row] = ()
    years: Sequence[Row] = ()
    files: Sequence[tuple[str, str]] = ()
    provenance: Sequence[tuple[str, str]] = ()

    def for_map(self) -> dict[str, Any]:
        """What the page's script needs, as JSON types."""
        return {
            "size": list(self.size),
            "origin": list(self.origin),
            "pictures": [
                {
                    "key": p.key,
                    "label": p.label,
                    "image": p.image,
                    "legend": [list(entry) for entry in p.legend],
                    "shown": p.shown,
                    "base": p.base,
                }
                for p in self.pictures
            ],
            "outlines": [
                {
                    "key": o.key,
                    "label": o.label,
                    "features": list(o.features),
                    "colour": o.colour,
                    "shown": o.shown,
                    "legend": [list(entry) for entry in o.legend],
                }
                for o in self.outlines
            ],
        }
