"""QGIS styles for layers of vectors: colours by classes of one column, and labels; valid for QGIS 3.22 and later.

In a GeoPackage a style lies in the table `layer_styles`, where QGIS finds it for each layer of the file.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Literal
from xml.sax.saxutils import quoteattr

import numpy as np

from firebreak_gis.schema import COLUMNS
from firebreak_gis.styles.rasters import rgba

if TYPE_CHECKING:
    import pandas as pd

Symbol = Literal["line", "fill"]

#: Number of classes of a column.
_CLASSES = 5
#: QGIS knows a table of styles by these columns.
_OWNER = "firebreak_gis"


def class_edges(values: np.ndarray, n: int = _CLASSES) -> list[float]:
    """Edges of classes that hold about equally many of the values; rising, at least two."""
    known = np.asarray(values, dtype=np.float64)
    known = known[np.isfinite(known)]
    if known.size == 0:
        return [0.0, 1.0]
    edges = np.unique(np.quantile(known, np.linspace(0.0, 1.0, n + 1), method="nearest"))
    return [*edges.tolist(), float(edges[0]) + 1.0] if edges.size == 1 else edges.tolist()


def graduated(
    values: np.ndarray,
    *,
    column: str,
    symbol: Symbol,
    colours: Sequence[str],
    label: str | None = None,
    columns: Iterable[str] = (),
) -> str:
    """Return the text of a .qml that colours features by classes of a column.

    Parameters
    ----------
    values
        Of the column, from which the classes are made.
    column
        Name of the column.
    symbol
        Lines, or filled outlines.
    colours
        "#rrggbb" or "#rrggbbaa" from the first class to the last, at least two; interpolated.
    label
        Column to write beside the features.
    columns
        All columns of the layer: those of `schema.COLUMNS` get their texts as aliases, for a QGIS whose GDAL, before
        3.7, does not read those of the GeoPackage.
    """
    edges = class_edges(values)
    shades = _between(colours, len(edges) - 1)
    ranges = "".join(
        f'   <range lower="{low:.9g}" upper="{high:.9g}" symbol="{k}" render="true" label="{low:.4g} to {high:.4g}"/>\n'
        for k, (low, high) in enumerate(pairwise(edges))
    )
    symbols = "".join(_symbol(k, symbol, shade) for k, shade in enumerate(shades))
    return (
        "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        '<qgis version="3.22.0" styleCategories="Symbology|Labeling|Fields" '
        f'labelsEnabled="{int(label is not None)}">\n'
        f' <renderer-v2 type="graduatedSymbol" attr={quoteattr(column)} graduatedMethod="GraduatedColor" '
        'symbollevels="0" enableorderby="0" forceraster="0">\n'
        f"  <ranges>\n{ranges}  </ranges>\n"
        f"  <symbols>\n{symbols}  </symbols>\n"
        " </renderer-v2>\n"
        f"{'' if label is None else _labels(label, symbol)}"
        f"{_aliases(columns)}"
        " <blendMode>0</blendMode>\n"
        " <featureBlendMode>0</featureBlendMode>\n"
        "</qgis>\n"
    )


def style_table(styles: dict[str, str], *, geometry: str, date: str) -> pd.DataFrame:
    """Rows of the table `layer_styles` of a GeoPackage.

    Parameters
    ----------
    styles
        Text of the .qml by layer.
    geometry
        Name of the column with the geometry.
    date
        Time stamp, the same in every run.
    """
    import pandas as pd

    return pd.DataFrame(
        {
            "f_table_catalog": "",
            "f_table_schema": "",
            "f_table_name": list(styles),
            "f_geometry_column": geometry,
            "styleName": list(styles),
            "styleQML": list(styles.values()),
            "styleSLD": "",
            "useAsDefault": True,
            "description": "",
            "owner": _OWNER,
            "ui": "",
            "update_time": pd.Timestamp(date).tz_convert(None),
        }
    )


def _between(colours: Sequence[str], n: int) -> list[tuple[int, ...]]:
    """Colours at n even steps from the first to the last."""
    known = np.array([rgba(colour) for colour in colours], dtype=np.float64)
    places = np.linspace(0.0, len(known) - 1.0, n) if n > 1 else np.zeros(1)
    mixed = [np.interp(places, np.arange(len(known)), known[:, channel]) for channel in range(4)]
    return [tuple(round(part) for part in shade) for shade in zip(*mixed, strict=True)]


def _symbol(number: int, kind: Symbol, shade: tuple[int, ...]) -> str:
    colour = ",".join(map(str, shade))
    if kind == "line":
        name, parts = "SimpleLine", {"line_color": colour, "line_width": "0.8", "line_width_unit": "MM"}
        parts |= {"line_style": "solid", "capstyle": "round", "joinstyle": "round"}
    else:
        name, parts = "SimpleFill", {"color": colour, "style": "solid", "outline_color": "90,90,90,255"}
        parts |= {"outline_style": "solid", "outline_width": "0.1", "outline_width_unit": "MM"}
    lines = "".join(f"     <prop k={quoteattr(key)} v={quoteattr(value)}/>\n" for key, value in parts.items())
    return (
        f'   <symbol name="{number}" type="{kind}" alpha="1" clip_to_extent="1" force_rhr="0">\n'
        f'    <layer class="{name}" enabled="1" locked="0" pass="0">\n{lines}    </layer>\n'
        "   </symbol>\n"
    )


def _aliases(columns: Iterable[str]) -> str:
    known = "".join(
        f'  <alias index="{k}" field={quoteattr(name)} name={quoteattr(COLUMNS[name].alias)}/>\n'
        for k, name in enumerate(columns, 1)  # the first is the number that GDAL gives
        if name in COLUMNS
    )
    return f" <aliases>\n{known} </aliases>\n" if known else ""


def _labels(column: str, symbol: Symbol) -> str:
    # Placement 2 is along a line, 1 over the middle of a polygon.
    place = 2 if symbol == "line" else 1
    return (
        ' <labeling type="simple">\n'
        "  <settings>\n"
        f'   <text-style fieldName={quoteattr(column)} isExpression="0" fontFamily="Sans Serif" fontSize="8" '
        'fontSizeUnit="Point" textColor="30,30,30,255">\n'
        '    <text-buffer bufferDraw="1" bufferSize="0.8" bufferSizeUnits="MM" bufferColor="255,255,255,255"/>\n'
        "   </text-style>\n"
        f'   <placement placement="{place}" placementFlags="10"/>\n'
        '   <rendering obstacle="1" mergeLines="0"/>\n'
        "  </settings>\n"
        " </labeling>\n"
    )
