"""DXF of release 12, which every drawing program and machine control reads: polylines on a layer for each group.

A drawing holds no columns and no coordinate system: the number of each feature stands beside it as text, the system in
a comment at the top.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from firebreak_gis.files.formats import Labels, clean, groups_of

if TYPE_CHECKING:
    import geopandas as gpd

#: Height of texts [m], 2.5 mm on a map 1 : 10,000.
TEXT_HEIGHT = 25.0
#: Colours of groups, by the index of AutoCAD: red, orange, yellow, cyan, blue.
_COLOURS = (1, 30, 2, 4, 5)
_WHITE = 7

Pair = tuple[int, object]


def encode(gdf: gpd.GeoDataFrame, title: str, labels: Labels) -> bytes:
    """Return a drawing.

    Parameters
    ----------
    gdf
        In metres. Lines become polylines, each ring of an area a closed one, points points.
    title
        Of the drawing, for the comment.
    labels
        How the features are numbered and grouped.
    """
    from firebreak_gis.grid import crs_name

    rows = labels.rows(gdf)
    groups = groups_of(rows)
    texts = layer_name(labels.word, "numbers")
    layers = {layer_name(labels.word, labels.group, group): k for k, group in enumerate(groups)}
    pairs: list[Pair] = [(999, _ascii(title)), (999, _ascii(f"metres in {crs_name(gdf.crs)}"))]
    pairs += [*_section("HEADER"), (9, "$ACADVER"), (1, "AC1009"), (0, "ENDSEC"), *_section("TABLES")]
    pairs += [(0, "TABLE"), (2, "LTYPE"), (70, 1), (0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (3, "Solid line")]
    pairs += [(72, 65), (73, 0), (40, 0.0), (0, "ENDTAB"), (0, "TABLE"), (2, "LAYER"), (70, len(layers) + 2)]
    colours = {name: _COLOURS[k * len(_COLOURS) // max(len(layers), 1)] for name, k in layers.items()}
    for name, colour in {"0": _WHITE, **colours, texts: _WHITE}.items():
        pairs += [(0, "LAYER"), (2, name), (70, 0), (62, colour), (6, "CONTINUOUS")]
    pairs += [(0, "ENDTAB"), (0, "ENDSEC"), *_section("ENTITIES")]
    for row in rows:
        if row.shape is not None and not row.shape.is_empty:
            pairs += _drawn(row.shape, layer_name(labels.word, labels.group, row.group))
            x, y = _middle(row.shape)
            pairs += [(0, "TEXT"), (8, texts), (10, x), (20, y), (30, 0.0), (40, TEXT_HEIGHT), (1, _ascii(row.number))]
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    lines = (f"{code:>3}\n{f'{value:.4f}' if isinstance(value, float) else value}\n" for code, value in pairs)
    return "".join(lines).encode("ascii")


def layer_name(*words: str | None) -> str:
    """Name of a layer: capitals, digits and underscores, at most 31.

    Examples
    --------
    >>> layer_name("Segment", "stage", "3")
    'SEGMENT_STAGE_3'
    """
    return re.sub(r"[^A-Z0-9_]+", "_", "_".join(filter(None, words)).upper())[:31]


def _section(name: str) -> list[Pair]:
    return [(0, "SECTION"), (2, name)]


def _drawn(shape: Any, layer: str) -> Iterator[Pair]:
    if shape.geom_type.startswith("Multi"):
        for part in shape.geoms:
            yield from _drawn(part, layer)
    elif shape.geom_type == "Polygon":
        for ring in (shape.exterior, *shape.interiors):
            yield from _polyline(ring.coords[:-1], layer, closed=True)
    elif shape.geom_type == "Point":
        yield from [(0, "POINT"), (8, layer), (10, shape.x), (20, shape.y), (30, 0.0)]
    else:
        yield from _polyline(shape.coords, layer, closed=False)


def _polyline(points: Iterable[tuple[float, ...]], layer: str, *, closed: bool) -> Iterator[Pair]:
    yield from [(0, "POLYLINE"), (8, layer), (66, 1), (10, 0.0), (20, 0.0), (30, 0.0), (70, int(closed))]
    for x, y, *_ in points:
        yield from [(0, "VERTEX"), (8, layer), (10, float(x)), (20, float(y)), (30, 0.0)]
    yield from [(0, "SEQEND"), (8, layer)]


def _middle(shape: Any) -> tuple[float, float]:
    """Where the number stands: the middle of the longest line, inside the area, at the point."""
    if "Line" in shape.geom_type or shape.geom_type == "LinearRing":
        parts = list(shape.geoms) if shape.geom_type.startswith("Multi") else [shape]
        place = max(parts, key=lambda part: part.length).interpolate(0.5, normalized=True)
    else:
        place = shape.representative_point()
    return float(place.x), float(place.y)


def _ascii(text: str) -> str:
    """Text on one line; other letters as AutoCAD writes them."""
    letters = clean(text).replace("\n", " ").replace("\t", " ")
    return "".join(c if c.isascii() else f"\\U+{ord(c):04X}" for c in letters)
