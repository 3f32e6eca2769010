"""Names of vector sources: a file, one of its layers, a filter, as QGIS writes them."""

from __future__ import annotations

import os
import re
import zipfile
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import InputError

if TYPE_CHECKING:
    import pandas as pd

#: Extensions of vector files; whatever else is named is a raster.
VECTORS = (
    *(".gpkg", ".shp", ".shz", ".geojson", ".json", ".geojsonl", ".geojsons", ".geojsonseq", ".topojson", ".fgb"),
    *(".parquet", ".kml", ".kmz", ".gml", ".gpx", ".sqlite", ".zip", ".gdb", ".tab", ".mif", ".dxf", ".osm", ".pbf"),
    *(".csv",),
)
#: Those that are named where a folder is given in place of one.
MAPPED = tuple(each for each in VECTORS if each not in (".csv", ".json", ".zip"))
#: How many files of a folder are named.
_NAMED = 4
#: Names of columns with coordinates: in degrees, and in the units of the map.
DEGREES = (("lon", "long", "longitude", "lng"), ("lat", "latitude"))
METRES = (("x", "easting", "east", "point_x", "coord_x"), ("y", "northing", "north", "point_y", "coord_y"))
_PARTS = re.compile(
    r"\|(?=(?:layername|layerid|subset|geometrytype|uniqueGeometryType|authid|option:\w+)=)", re.IGNORECASE
)


@dataclass(frozen=True)
class VectorName:
    """What the name of a vector source says.

    Parameters
    ----------
    file
        The file, or folder of a file geodatabase.
    layer
        Name of the layer, or its number from 0; None if not told.
    where
        SQL condition on the attributes; "" for all features.
    """

    file: str
    layer: str | int | None = None
    where: str = ""


def vector_name(name: str) -> VectorName:
    """Take apart `FILE|layername=NAME|subset=CONDITION`.

    Examples
    --------
    >>> vector_name("osm.gpkg|layername=roads|subset=highway = 'primary'")
    VectorName(file='osm.gpkg', layer='roads', where="highway = 'primary'")
    """
    file, *parts = _PARTS.split(name)
    told = {key.lower(): value for key, _, value in (part.partition("=") for part in parts)}
    number = told.get("layerid", "")
    layer: str | int | None = told.get("layername") or (int(number) if number.isdigit() else None)
    return VectorName(file, layer, told.get("subset", "").strip())


def filtered(name: str, where: str) -> str:
    """Return the name with one more condition on the attributes.

    Examples
    --------
    >>> filtered("roads.gpkg|subset=lanes > 1", "highway = 'primary'")
    "roads.gpkg|subset=(lanes > 1) AND (highway = 'primary')"
    """
    found = vector_name(name)
    layer = {str: f"|layername={found.layer}", int: f"|layerid={found.layer}"}.get(type(found.layer), "")
    condition = f"({found.where}) AND ({where})" if found.where else where
    return f"{found.file}{layer}|subset={condition}"


def such_as(folder: str | os.PathLike[str], extensions: tuple[str, ...]) -> str:
    """The first files of a folder that have one of the extensions, as words to go on a sentence; "" for none."""
    found = sorted(str(each) for each in Path(folder).iterdir() if each.suffix.lower() in extensions)
    return f", such as {', '.join(found[:_NAMED])}" if found else ""


def names_vector(name: str) -> bool:
    """Whether a name is that of a vector file, by its extension."""
    return vector_name(name).file.lower().rstrip("/\\").endswith(VECTORS)


def within_archive(name: str, layer: str | int | None) -> tuple[str, str | int | None]:
    """Return the name under which GDAL finds the vector file in a `.zip`, and which layer of it is meant.

    Raises
    ------
    InputError
        If the archive is damaged, or it is not clear which of its files is meant.
    """
    try:
        with zipfile.ZipFile(name) as archive:
            members = archive.namelist()
    except (zipfile.BadZipFile, OSError) as error:
        raise InputError(f"{name} cannot be read as an archive ({error}); copy or export it again") from error
    folders = {str(parent) for member in members for parent in PurePosixPath(member).parents}
    inside = sorted(
        path
        for path in {*(m.rstrip("/") for m in members), *folders}
        if path.lower().endswith(VECTORS) and ".gdb/" not in path.lower() and not path.startswith("__MACOSX")
    )
    chosen = inside if len(inside) == 1 else [path for path in inside if PurePosixPath(path).stem == layer]
    if len(chosen) != 1:
        told = ", ".join(inside[:8]) or f"no vector file, but {', '.join(members[:5])}"
        raise InputError(f"{name} holds {told}; {_which(name, [PurePosixPath(path).stem for path in inside])}")
    place = f"/vsizip/{Path(name).absolute().as_posix()}/{chosen[0]}"
    return place, layer if len(inside) == 1 else None


def chosen_layer(name: str, layers: dict[str, int], layer: str | int | None) -> str:
    """Return the layer that is meant.

    Parameters
    ----------
    name
        Of the file.
    layers
        Number of features by name of the layer, those with geometries.
    layer
        As in `VectorName`.

    Raises
    ------
    InputError
        If there is no such layer, or several hold features and none is told.
    """
    names = list(layers)
    if isinstance(layer, str) and layer in layers:
        return layer
    if isinstance(layer, int) and 0 <= layer < len(names):
        return names[layer]
    if layer is not None:
        raise InputError(f"{name} has no layer {layer!r}; it has {', '.join(names)}")
    filled = [one for one, count in layers.items() if count] or names[:1]
    if len(filled) > 1:
        raise InputError(f"{name} holds several layers: {', '.join(filled)}; {_which(name, filled)}")
    return filled[0]


def _which(name: str, layers: list[str]) -> str:
    return f"say which, e.g. '{name}|layername={layers[0]}'" if layers else "unpack it first"


def table_of_points(name: str) -> tuple[pd.DataFrame, Any, Any, bool] | None:
    """Read a CSV file with coordinates: the table, x, y, and whether they are degrees; None without such columns.

    Commas, semicolons or tabs part the columns; with the last two numbers may have decimal commas.

    Raises
    ------
    InputError
        If it cannot be read, or a coordinate is no number.
    """
    import pandas as pd

    data = Path(name).read_bytes()
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    head = text.partition("\n")[0]
    sep = max((";", "\t", ","), key=head.count)
    try:
        import io

        table = pd.read_csv(io.StringIO(text), sep=sep, decimal="," if sep != "," and "." not in text else ".")
    except ValueError as error:  # of which those of pandas are
        raise InputError(f"{name} cannot be read as a table ({str(error)[:120]})") from error
    columns = {str(column).strip().lower(): column for column in table.columns}
    for (xs, ys), degrees in ((DEGREES, True), (METRES, False)):
        x, y = (next((columns[word] for word in words if word in columns), None) for words in (xs, ys))
        if x is None or y is None:
            continue
        numbers = [pd.to_numeric(table[column], errors="coerce") for column in (x, y)]
        wrong = numbers[0].isna() | numbers[1].isna()
        if wrong.any():
            raise InputError(f"{name}: {x} and {y} hold no numbers in line {int(wrong.to_numpy().argmax()) + 2}")
        return table, *(each.to_numpy(dtype=float) for each in numbers), degrees
    return None
