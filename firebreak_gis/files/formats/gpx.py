"""GPX 1.1 (topografix.com/GPX/1/1): a track for each line, and a waypoint with its number in the middle of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

from firebreak_gis.files.formats import Labels, Row, clean

if TYPE_CHECKING:
    import geopandas as gpd

#: Columns that a small screen has room for.
_SHORT = ("year", "length_m", "width_m", "area_ha", "mean_slope_deg", "max_slope_deg", "treatment")
NAMESPACE = "http://www.topografix.com/GPX/1/1"


def encode(gdf: gpd.GeoDataFrame, title: str, labels: Labels) -> bytes:
    """Return a GPX document, without a time.

    Parameters
    ----------
    gdf
        Lines or points in longitude and latitude. Points become waypoints.
    title
        Of the document.
    labels
        How the features are called; devices show names and short comments, some the whole description.
    """
    schema = f"{NAMESPACE} {NAMESPACE}/gpx.xsd"
    instance = "http://www.w3.org/2001/XMLSchema-instance"
    root = ET.Element(
        "gpx",
        {"version": "1.1", "creator": "firebreak_gis", "xmlns": NAMESPACE}
        | {"xmlns:xsi": instance, "xsi:schemaLocation": schema},
    )
    _with(_with(root, "metadata"), "name", title)
    rows = [row for row in labels.rows(gdf) if row.shape is not None and not row.shape.is_empty]
    # The schema wants all waypoints first.
    for row in rows:
        for point in _points(row.shape):
            _texts(_point(root, "wpt", (point.x, point.y)), row, labels, sym="Flag, Blue")
    for row in rows:
        parts = [part for part in _parts(row.shape) if part.geom_type != "Point"]
        if parts:
            track = _with(root, "trk")
            _texts(track, row, labels)
            for part in parts:
                piece = _with(track, "trkseg")
                for place in part.coords:
                    _point(piece, "trkpt", place)
    ET.indent(root, " ")
    return bytes(ET.tostring(root, encoding="UTF-8", xml_declaration=True))


def _with(parent: ET.Element, tag: str, text: object = None) -> ET.Element:
    made = ET.SubElement(parent, tag)
    if text is not None:
        made.text = clean(text)
    return made


def _point(parent: ET.Element, tag: str, place: tuple[float, ...]) -> ET.Element:
    return ET.SubElement(parent, tag, lat=f"{place[1]:.9f}", lon=f"{place[0]:.9f}")


def _texts(element: ET.Element, row: Row, labels: Labels, sym: str = "") -> None:
    """In the order of the schema."""
    _with(element, "name", row.name)
    _with(element, "cmt", row.name if row.group is None else f"{row.name}, {labels.group} {row.group}")
    _with(element, "desc", "; ".join(f"{text} {value}" for text, value in row.told_of(_SHORT)) or row.name)
    if sym:
        _with(element, "sym", sym)
    _with(element, "type", labels.word)


def _parts(shape: Any) -> list[Any]:
    return list(shape.geoms) if shape.geom_type.startswith("Multi") else [shape]


def _points(shape: Any) -> list[Any]:
    """The points themselves, or the middle of the longest part of a line."""
    parts = _parts(shape)
    if parts[0].geom_type == "Point":
        return parts
    return [max(parts, key=lambda part: part.length).interpolate(0.5, normalized=True)]
