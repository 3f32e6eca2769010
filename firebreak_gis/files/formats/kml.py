"""KML 2.2 (OGC 07-147r2): a folder for each group, a style for each colour, names and texts that viewers show."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

from firebreak_gis.files.formats import Labels, Row, clean, groups_of
from firebreak_gis.schema import COLUMNS

if TYPE_CHECKING:
    import geopandas as gpd

NAMESPACE = "http://www.opengis.net/kml/2.2"
_LINE_WIDTH = "4"
#: Opacity of areas, the first two digits of a colour of KML.
_FILL = "66"


def encode(gdf: gpd.GeoDataFrame, title: str, labels: Labels) -> bytes:
    """Return a KML document.

    Parameters
    ----------
    gdf
        In longitude and latitude.
    title
        Of the document.
    labels
        How the features are called and coloured.
    """
    root = ET.Element("kml", xmlns=NAMESPACE)
    document = _with(root, "Document")
    _with(document, "name", title)
    rows = labels.rows(gdf)
    groups = groups_of(rows)
    colours = [labels.colour(group, groups) for group in groups]
    styles = {colour: f"colour{k}" for k, colour in enumerate(dict.fromkeys(colours))}
    for colour, name in styles.items():
        _style(document, name, colour)
    for group, colour in zip(groups, colours, strict=True):
        folder = document
        if group is not None:
            folder = _with(document, "Folder")
            _with(folder, "name", f"{labels.group.capitalize()} {group}")
        for row in rows:
            if row.group == group:
                _placemark(folder, row, f"#{styles[colour]}")
    ET.indent(root, " ")
    return bytes(ET.tostring(root, encoding="UTF-8", xml_declaration=True))


def _with(parent: ET.Element, tag: str, text: object = None, **attributes: str) -> ET.Element:
    made = ET.SubElement(parent, tag, attributes)
    if text is not None:
        made.text = clean(text)
    return made


def _style(document: ET.Element, name: str, colour: str) -> None:
    red, green, blue = (colour[k : k + 2] for k in (1, 3, 5))
    style = _with(document, "Style", id=name)
    line = _with(style, "LineStyle")
    _with(line, "color", f"ff{blue}{green}{red}")
    _with(line, "width", _LINE_WIDTH)
    _with(_with(style, "PolyStyle"), "color", f"{_FILL}{blue}{green}{red}")


def _placemark(folder: ET.Element, row: Row, style: str) -> None:
    mark = _with(folder, "Placemark")
    _with(mark, "name", row.name)
    _with(mark, "description", "<br/>".join(f"{escape(text)}: {escape(value)}" for text, value in row.told_of()))
    _with(mark, "styleUrl", style)
    extended = _with(mark, "ExtendedData")
    for name, value in row.values.items():
        if value is not None:
            data = _with(extended, "Data", name=clean(name))
            _with(data, "displayName", COLUMNS[name].alias if name in COLUMNS else name)
            _with(data, "value", value)
    if row.shape is not None and not row.shape.is_empty:
        _shape(mark, row.shape)


def _shape(parent: ET.Element, shape: Any) -> None:
    kind = shape.geom_type
    if kind.startswith("Multi"):
        several = _with(parent, "MultiGeometry")
        for part in shape.geoms:
            _shape(several, part)
    elif kind == "Polygon":
        import shapely

        area = shapely.geometry.polygon.orient(shape)
        polygon = _with(parent, "Polygon")
        _with(polygon, "tessellate", 1)
        for tag, ring in (
            ("outerBoundaryIs", area.exterior),
            *(("innerBoundaryIs", hole) for hole in area.interiors),
        ):
            _with(_with(_with(polygon, tag), "LinearRing"), "coordinates", _coordinates(ring.coords))
    elif kind == "Point":
        _with(_with(parent, "Point"), "coordinates", _coordinates(shape.coords))
    else:
        line = _with(parent, "LineString")
        _with(line, "tessellate", 1)
        _with(line, "coordinates", _coordinates(shape.coords))


def _coordinates(points: Iterable[tuple[float, ...]]) -> str:
    """Longitude and latitude to a hundredth of a millimetre or so."""
    return " ".join(f"{x:.9f},{y:.9f}" for x, y, *_ in points)
