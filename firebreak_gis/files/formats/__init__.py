"""Formats of vector files: what each can hold, and how features are called where it shows them to people.

GDAL writes GeoPackage, GeoJSON, FlatGeobuf and Shapefile. KML, GPX and DXF are written here: through pyogrio GDAL takes
neither styles nor labels, and a GPX of GDAL holds either tracks or waypoints.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import OutputError
from firebreak_gis.schema import COLUMNS

if TYPE_CHECKING:
    import geopandas as gpd

_LINES = frozenset({"LineString", "MultiLineString", "LinearRing"})
_AREAS = frozenset({"Polygon", "MultiPolygon"})
_POINTS = frozenset({"Point", "MultiPoint"})
_ALL = _LINES | _AREAS | _POINTS


@dataclass(frozen=True)
class Format:
    """What a format can hold.

    Parameters
    ----------
    name
        For people.
    driver
        Of GDAL; "" for those that are written without it.
    parts
        Endings of the files that it is made of, the one by which readers open it last; none for a single file.
    several
        Whether one file holds several layers.
    degrees
        Whether coordinates are longitude and latitude (WGS 84).
    holds
        Kinds of geometry.
    """

    name: str
    driver: str = ""
    parts: tuple[str, ...] = ()
    several: bool = False
    degrees: bool = False
    holds: frozenset[str] = _ALL


#: Pieces of a Shapefile; without the .shp nothing opens the others.
SHAPEFILE_PARTS = (".dbf", ".shx", ".prj", ".cpg", ".shp")
#: By extension.
FORMATS: Mapping[str, Format] = MappingProxyType(
    {
        ".gpkg": Format("GeoPackage", "GPKG", several=True),
        ".geojson": Format("GeoJSON", "GeoJSON", degrees=True),
        ".json": Format("GeoJSON", "GeoJSON", degrees=True),
        ".shp": Format("Shapefile", "ESRI Shapefile", SHAPEFILE_PARTS),
        ".zip": Format("zipped Shapefile", "ESRI Shapefile"),
        ".kml": Format("KML", degrees=True),
        ".gpx": Format("GPX", degrees=True, holds=_LINES | _POINTS),
        ".dxf": Format("DXF"),
        ".fgb": Format("FlatGeobuf", "FlatGeobuf"),
        ".parquet": Format("GeoParquet"),
    }
)
#: Other names that people know a format by.
_MEANT = {".kmz": ".kml", ".dwg": ".dxf", ".dbf": ".shp", ".shx": ".shp", ".shz": ".zip", ".geopackage": ".gpkg"}


def hint(suffix: str, known: Iterable[str]) -> str:
    """A question for who mistyped an extension, or one that means the same as a known one; "" if there is none.

    Examples
    --------
    >>> hint(".gpgk", FORMATS), hint(".dwg", FORMATS), hint(".txt", FORMATS)
    ('; did you mean .gpkg?', '; did you mean .dxf?', '')
    """
    known = tuple(known)
    meant = _MEANT.get(suffix.lower())
    near = [meant] if meant in known else difflib.get_close_matches(suffix.lower(), known, 1, 0.7)
    return f"; did you mean {near[0]}?" if near else ""


def format_of(place: Path) -> Format:
    """Return the format that the extension of a file says.

    Raises
    ------
    OutputError
        If it is unknown.
    """
    suffix = place.suffix.lower()
    if suffix not in FORMATS:
        raise OutputError(
            f"{place.name} has no known vector extension; expected one of {', '.join(FORMATS)}{hint(suffix, FORMATS)}"
        )
    return FORMATS[suffix]


def parts_of(path: str | Path) -> tuple[Path, ...]:
    """Files that writing a vector file makes: itself, or all pieces of a Shapefile, itself last.

    Examples
    --------
    >>> [part.name for part in parts_of("crew.shp")]
    ['crew.dbf', 'crew.shx', 'crew.prj', 'crew.cpg', 'crew.shp']
    """
    place = Path(path)
    ends = FORMATS.get(place.suffix.lower(), Format("")).parts
    return tuple(place if end == place.suffix.lower() else place.with_suffix(end) for end in ends) or (place,)


def require_kinds(place: Path, kinds: Iterable[str]) -> None:
    """Refuse kinds of geometry that a format cannot hold.

    Raises
    ------
    OutputError
        Naming a format that can.
    """
    found = format_of(place)
    kinds = set(kinds)
    if other := sorted(kinds - found.holds):
        more = "lines can (--what lines); areas go into .kml or .gpkg" if found.name == "GPX" else "choose .gpkg"
        raise OutputError(f"{place.name} cannot hold {', '.join(other)}, which {found.name} does not know; {more}")
    families = [family for family in (_LINES, _AREAS, _POINTS) if kinds & family]
    if found.driver == "ESRI Shapefile" and len(families) > 1:
        raise OutputError(f"{place.name} holds one kind of geometry, got {', '.join(sorted(kinds))}; choose .gpkg")


def require_held(gdf: gpd.GeoDataFrame, place: Path) -> None:
    """Refuse features that a format cannot hold, as `require_kinds`; degrees in a drawing, too."""
    require_kinds(place, map(str, gdf.geom_type.dropna()))
    if place.suffix.lower() == ".dxf" and gdf.crs is not None and gdf.crs.is_geographic:
        raise OutputError(f"{place.name} is a drawing in metres, got degrees ({gdf.crs.name}); use gdf.to_crs first")


@dataclass(frozen=True)
class Labels:
    """How features are called and coloured in formats that show them to people.

    Parameters
    ----------
    word
        What a feature is, such as "Segment".
    number
        Column with its number; its row by default.
    group
        Column by which features are gathered in folders or layers and coloured.
    colours
        "#rrggbb" from the first group to the last.
    """

    word: str = "Feature"
    number: str = ""
    group: str = ""
    colours: Sequence[str] = ("#1f4fd8",)

    def rows(self, gdf: gpd.GeoDataFrame) -> list[Row]:
        """The features of a frame, named, in its order."""
        columns = [str(name) for name in gdf.columns if name != gdf.geometry.name]
        numbers = gdf[self.number] if self.number in gdf else range(1, len(gdf) + 1)
        groups = gdf[self.group] if self.group in gdf else [None] * len(gdf)
        return [
            Row(
                _whole(number),
                f"{self.word} {_whole(number)}",
                None if group is None else _whole(group),
                {name: plain(value) for name, value in zip(columns, values, strict=True)},
                shape,
            )
            for number, group, values, shape in zip(
                numbers,
                groups,
                gdf[columns].itertuples(index=False, name=None) if columns else [()] * len(gdf),
                gdf.geometry,
                strict=True,
            )
        ]

    def colour(self, group: str | None, groups: Sequence[str | None]) -> str:
        """Colour of a group among all of them, in order."""
        place = list(groups).index(group) * len(self.colours) // max(len(groups), 1)
        return self.colours[place]


#: Of features of which nothing is known.
PLAIN = Labels()


@dataclass(frozen=True)
class Row:
    """One feature: its number and name, its group, its values by column (None for nothing), its shape."""

    number: str
    name: str
    group: str | None
    values: Mapping[str, Any]
    shape: Any

    def told_of(self, names: Iterable[str] = COLUMNS) -> list[tuple[str, str]]:
        """What it says of itself: text and value of each of these columns that it has."""
        known = [name for name in names if self.values.get(name) is not None]
        return [(COLUMNS[name].text, COLUMNS[name].told(self.values[name])) for name in known]


def groups_of(rows: Sequence[Row]) -> list[str | None]:
    """Groups in the order of their first features."""
    return list(dict.fromkeys(row.group for row in rows))


def plain(value: Any) -> Any:
    """A value as Python holds it; None for nothing."""
    value = value.item() if hasattr(value, "item") else value
    return None if value is None or (isinstance(value, float) and math.isnan(value)) else value


def clean(value: object) -> str:
    """Text without the controls that XML and tables cannot hold."""
    return "".join(letter for letter in str(value) if letter >= " " or letter in "\t\n")


def _whole(number: Any) -> str:
    number = plain(number)
    return str(int(number)) if isinstance(number, float) and number.is_integer() else clean(number)
