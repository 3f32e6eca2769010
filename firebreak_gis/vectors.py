"""Reading points, lines and polygons of any vector file; writing vector files."""

from __future__ import annotations

import io
import os
import tempfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import (
    CRSError,
    InputError,
    MissingComponentError,
    OutputError,
    VerificationError,
)
from firebreak_gis.files import require_writable, together, write_bytes
from firebreak_gis.files.features import read_frame
from firebreak_gis.files.formats import FORMATS, PLAIN, Labels, format_of, parts_of, require_held
from firebreak_gis.files.gate import vector_settings
from firebreak_gis.files.sources import names_vector
from firebreak_gis.grid import crs_name, parse_crs

if TYPE_CHECKING:
    import geopandas as gpd
    import numpy as np
    from pyproj import CRS

#: Formats that are written without GDAL.
_ENCODED = (".kml", ".gpx", ".dxf")
#: Time stamp inside GeoPackages, the same in every run so that equal data give equal bytes.
FIXED_DATE = "2000-01-01T00:00:00Z"
#: Lets SQLite keep its journal to itself, too: nobody else has the file open.
_WRITING: Mapping[str, str] = MappingProxyType({"OGR_CURRENT_DATE": FIXED_DATE, "OGR_SQLITE_JOURNAL": "MEMORY"})


def is_vector(source: Any) -> bool:
    """Whether a source is vector data: geometries, or a name with the extension of a vector file.

    The one answer for every option that takes either; `a.nc:variable`, `.jp2` and names without an extension are
    rasters.

    Examples
    --------
    >>> [is_vector(name) for name in ("roads.gpkg", "A.SHP", "risk.jp2", "data.nc:risk")]
    [True, True, False, False]
    """
    if hasattr(source, "geometry"):
        return True
    return isinstance(source, (str, os.PathLike)) and names_vector(os.fspath(source))


def read_points(source: Any, crs: Any) -> gpd.GeoDataFrame:
    """Read all points of a layer, multipoints taken apart, reprojected to `crs`.

    Parameters
    ----------
    source
        Any vector file that GDAL reads, `FILE|layername=NAME|subset=CONDITION` if it has several layers or not all
        features count; a CSV file with x and y (in `crs`), or lon and lat; or a GeoDataFrame or GeoSeries with CRS.
    crs
        Target CRS, anything that pyproj reads.

    Raises
    ------
    InputError
        If there are no points, other geometries, or a file that cannot be read; `CRSError` without CRS.
    """
    return _read(source, crs, "points", {"Point"})


def read_polygons(source: Any, crs: Any) -> gpd.GeoDataFrame:
    """Read all polygons of a layer, one row a feature, reprojected to `crs`; as `read_points`.

    Self-crossing outlines are repaired; `attrs["notes"]` says how many.
    """
    return _read(source, crs, "polygons", {"Polygon"}, explode=False)


def read_features(source: Any, crs: Any) -> gpd.GeoDataFrame:
    """Read lines and polygons together, reprojected to `crs`; as `read_points`."""
    return _read(source, crs, "lines or polygons", {"LineString", "LinearRing", "Polygon"})


def read_lines(source: Any, crs: Any) -> gpd.GeoDataFrame:
    """Read all lines of a layer, one row a feature, reprojected to `crs`; as `read_points`."""
    return _read(source, crs, "lines", {"LineString", "LinearRing"}, explode=False)


def read_starts(source: Any, crs: Any, *, explode: bool = True) -> gpd.GeoDataFrame:
    """Read points and polygons together, such as where fires start, reprojected to `crs`; as `read_points`."""
    return _read(source, crs, "points or polygons", {"Point", "Polygon"}, explode=explode)


def write_vector(
    path: str | os.PathLike[str],
    gdf: gpd.GeoDataFrame,
    *,
    layer: str | None = None,
    labels: Labels = PLAIN,
    kind: str = "Unknown",
    overwrite: bool = False,
    forbid: Iterable[str | os.PathLike[str]] = (),
) -> Path:
    """Write a GeoDataFrame; the extension chooses the format.

    .gpkg, .shp, .zip (a zipped Shapefile), .geojson, .kml, .gpx, .dxf, .fgb and .parquet are known. GeoJSON, KML and
    GPX are in longitude and latitude (WGS 84), as their standards demand. Columns of a Shapefile have short names
    (`schema.COLUMNS`); a GPX holds lines and points, a DXF no columns. Rows keep their order. What GDAL writes is read
    back and compared before it takes its place. No date is stored. The files of a Shapefile appear together.

    Parameters
    ----------
    path
        Target.
    gdf
        With a CRS; may be empty.
    layer
        Name of the layer; the stem of the file by default, which is the title in KML and GPX.
    labels
        How features are called and coloured where a format shows them to people.
    kind
        Kind of geometry of a layer that may be empty, such as "LineString".
    overwrite
        Whether an existing file may be replaced (as a whole, with all its layers).
    forbid
        Input files, none of which may be the target.

    Raises
    ------
    OutputError
        If the extension is unknown, the format cannot hold the features, or the file cannot be written.
    CRSError
        If `gdf` has no CRS.
    MissingComponentError
        For .parquet without pyarrow.
    VerificationError
        If the file does not hold the features of `gdf`.

    Examples
    --------
    >>> import geopandas as gpd
    >>> points = gpd.GeoDataFrame({"people": [40]}, geometry=gpd.points_from_xy([586500], [3999800]), crs=32635)
    >>> [write_vector(name, points).name for name in ("villages.gpkg", "villages.kml", "villages.shp")]
    ['villages.gpkg', 'villages.kml', 'villages.shp']
    """
    place = Path(path)
    driver = format_of(place).driver
    _require_crs(gdf, place.name)
    require_held(gdf, place)
    _require_closed(place)
    layer = layer or place.stem
    if driver == "ESRI Shapefile":
        _write_shapefile(place, gdf, kind, overwrite=overwrite, forbid=forbid)
        return place
    write_bytes(
        place,
        _encoded(gdf, place, layer, labels, kind),
        overwrite=overwrite,
        forbid=forbid,
        verify=lambda part: _verify(part, {layer: gdf}, driver, place.name),
    )
    return place


def require_writable_vector(
    path: str | os.PathLike[str], *, overwrite: bool = False, forbid: Iterable[str | os.PathLike[str]] = ()
) -> None:
    """Check before the work that all files that `write_vector` makes can be written, as `files.require_writable`."""
    forbid = tuple(forbid)
    for place in parts_of(Path(path)):
        require_writable(place, overwrite=overwrite, forbid=forbid)


def write_layers(
    path: str | os.PathLike[str],
    layers: Mapping[str, gpd.GeoDataFrame],
    *,
    styles: Mapping[str, str] = MappingProxyType({}),
    kinds: Mapping[str, str] = MappingProxyType({}),
    overwrite: bool = False,
    forbid: Iterable[str | os.PathLike[str]] = (),
) -> Path:
    """Write GeoDataFrames as the layers of one GeoPackage, as `write_vector` writes one.

    Parameters
    ----------
    path
        Target, with the extension .gpkg.
    layers
        By name of the layer, each with a CRS; may be empty.
    styles
        Text of a QGIS style (.qml) by name of the layer; QGIS takes them up with the layers.
    kinds
        Kind of geometry by name of the layer, such as "LineString", for layers that may be empty: QGIS takes an
        empty layer of unknown kind for a table.
    overwrite, forbid
        As in `write_vector`.
    """
    place = Path(path)
    if place.suffix.lower() != ".gpkg":
        raise OutputError(f"{place.name} has several layers, which only .gpkg can hold; give it that extension")
    from firebreak_gis.files.formats.geopackage import with_aliases

    for name, gdf in layers.items():
        _require_crs(gdf, f"{place.name}, layer {name}")
    _require_closed(place)

    def verify(part: Path) -> None:
        _verify(part, layers, "GPKG", place.name)

    forbid = tuple(forbid)
    require_writable(place, overwrite=overwrite, forbid=forbid)
    # GDAL adds layers to files on a disk only, and what fails there it may not tell: so it writes twice.
    with tempfile.TemporaryDirectory(prefix="firebreak-") as folder:
        copies = [Path(folder) / "one.gpkg", Path(folder) / "again.gpkg"]
        for copy in copies:
            for name, gdf in layers.items():
                _write_ogr(copy, gdf, "GPKG", name, kinds.get(name, "Unknown"))
            if styles:
                _write_styles(copy, styles)
        content = copies[0].read_bytes()
        if content != copies[1].read_bytes():
            raise OutputError(f"{place.name} cannot be written as it should; is the disk full or failing?")
    content = with_aliases(content, {name: gdf.columns for name, gdf in layers.items()})
    write_bytes(place, content, overwrite=overwrite, forbid=forbid, verify=verify)
    return place


def _read(source: Any, crs: Any, what: str, kinds: set[str], *, explode: bool = True) -> gpd.GeoDataFrame:
    target = parse_crs(crs)
    notes: list[str] = []
    where, frame = _named(source) if hasattr(source, "geometry") else read_frame(os.fspath(source), target, notes)
    if frame.crs is None:
        raise CRSError(
            f"{where} has no coordinate reference system; assign one, e.g. ogr2ogr -a_srs EPSG:4326 out.gpkg in.shp"
        )
    ready = _plain(frame, where, what, kinds, notes).to_crs(target)
    if not len(ready):
        filtered = " that the filter lets through" if "|subset=" in str(source) else ""
        raise InputError(f"{where} holds no {what}{filtered}; expected at least one")
    ready = (ready.explode(index_parts=False) if explode else ready).reset_index(drop=True)
    _require_finite(ready, where, target)
    ready.attrs["notes"] = notes
    return ready


def _named(source: gpd.GeoSeries | gpd.GeoDataFrame) -> tuple[str, gpd.GeoDataFrame]:
    import geopandas as gpd

    if isinstance(source, gpd.GeoSeries):
        return "the geometries", gpd.GeoDataFrame(geometry=source)
    return "the features", source


def _plain(frame: gpd.GeoDataFrame, where: str, what: str, kinds: set[str], notes: list[str]) -> gpd.GeoDataFrame:
    """Two-dimensional, present, valid geometries of the kinds asked for."""
    import shapely

    present = ~(frame.geometry.isna() | frame.geometry.is_empty)
    if not present.all():
        notes.append(f"{int((~present).sum())} features without a geometry were left out")
    frame = frame[present]
    other = set(frame.geom_type) - kinds - {"Multi" + kind for kind in kinds}
    if other:
        raise InputError(f"{where} holds {', '.join(sorted(other))}, expected {what} only")
    geometry = shapely.force_2d(frame.geometry.array)
    if "Polygon" in kinds:
        broken = ~shapely.is_valid(geometry)
        if broken.any():
            notes.append(f"{int(broken.sum())} polygons crossed themselves and were repaired")
            geometry[broken] = shapely.make_valid(geometry[broken], method="structure")
    return frame.set_geometry(geometry, crs=frame.crs)


def _require_finite(frame: gpd.GeoDataFrame, where: str, target: CRS) -> None:
    import numpy as np

    if not np.isfinite(frame.geometry.bounds.to_numpy()).all():
        raise CRSError(f"{where} has coordinates that {crs_name(target)} cannot describe; is its CRS the true one?")


def _require_crs(gdf: gpd.GeoDataFrame, where: str) -> None:
    if gdf.crs is None:
        raise CRSError(f"the features for {where} have no coordinate reference system; set one with gdf.set_crs(...)")


def _require_closed(place: Path) -> None:
    place = Path(os.path.realpath(place))
    for suffix in ("-wal", "-journal"):
        if place.with_name(place.name + suffix).exists():
            raise OutputError(
                f"{place} is open in another program (there is {place.name + suffix}); close it there first, or "
                "remove that file if the program has crashed"
            )


def _encoded(gdf: gpd.GeoDataFrame, place: Path, layer: str, labels: Labels, kind: str) -> bytes | memoryview:
    """Return the bytes of a file with one layer."""
    from firebreak_gis.files.formats import dxf, geopackage, gpx, kml

    suffix, title = place.suffix.lower(), place.stem
    if suffix == ".parquet":
        return _parquet(gdf)
    if suffix in _ENCODED:
        ready = gdf.to_crs("EPSG:4326") if FORMATS[suffix].degrees else gdf
        encode: Callable[..., bytes] = {".kml": kml.encode, ".gpx": gpx.encode, ".dxf": dxf.encode}[suffix]
        return encode(ready, title, labels)
    memory = io.BytesIO()
    _write_ogr(memory, gdf, FORMATS[suffix].driver, layer, kind)
    return (
        geopackage.with_aliases(memory.getbuffer(), {layer: gdf.columns}) if suffix == ".gpkg" else memory.getbuffer()
    )


def _write_shapefile(
    place: Path, gdf: gpd.GeoDataFrame, kind: str, *, overwrite: bool, forbid: Iterable[str | os.PathLike[str]]
) -> None:
    """All files of a Shapefile, or none of them; or one archive of them."""
    from firebreak_gis.files.formats.shapefile import BESIDE, encode, zipped

    stem = place.name[: -len(".zip")].removesuffix(".shp") if place.suffix.lower() == ".zip" else place.stem
    parts = encode(gdf, place.name, kind)
    if place.suffix.lower() == ".zip":
        write_bytes(place, zipped(parts, stem), overwrite=overwrite, forbid=forbid)
        return
    forbid = tuple(forbid)
    require_writable_vector(place, overwrite=overwrite, forbid=forbid)
    old = [other for end in BESIDE if (other := place.with_suffix(end)).exists()]
    with together(place.parent):
        for path in parts_of(place):
            last = old if path == place else []
            write_bytes(path, parts[path.suffix.lower()], overwrite=overwrite, forbid=forbid, remove=last)


def _write_ogr(
    target: Path | io.BytesIO, gdf: gpd.GeoDataFrame, driver: str, layer: str, kind: str = "Unknown"
) -> None:
    from pyogrio.errors import DataLayerError, DataSourceError, FeatureError, FieldError, GeometryError

    options: dict[str, Any] = {"layer": layer}
    if driver == "GeoJSON":
        gdf = gdf.to_crs("EPSG:4326")
        options |= {"RFC7946": "YES", "COORDINATE_PRECISION": 9}
    if driver == "GPKG":
        options["VERSION"] = "1.2"  # newer ones warn in the GDAL of older QGIS
    if driver == "FlatGeobuf":
        options["SPATIAL_INDEX"] = "NO"  # the index would reorder the features
    if gdf.empty and driver != "GeoJSON":
        options["geometry_type"] = kind
    try:
        with vector_settings(_WRITING):
            gdf.to_file(target, driver=driver, engine="pyogrio", index=False, **options)
    except (DataSourceError, DataLayerError, FeatureError, FieldError, GeometryError) as error:
        raise OutputError(f"cannot write the layer {layer}: {error}; is the disk full?") from error


def _parquet(gdf: gpd.GeoDataFrame) -> memoryview:
    memory = io.BytesIO()
    try:
        gdf.to_parquet(memory, index=False)
    except ImportError as error:
        raise MissingComponentError("writing .parquet needs pyarrow: pip install pyarrow (or write .gpkg)") from error
    return memory.getbuffer()


def _write_styles(part: Path, styles: Mapping[str, str]) -> None:
    import pyogrio
    from pyogrio.errors import DataLayerError, DataSourceError, FeatureError, FieldError

    from firebreak_gis.styles.vectors import style_table

    rows = style_table(dict(styles), geometry="geom", date=FIXED_DATE)
    try:
        with vector_settings(_WRITING):
            pyogrio.write_dataframe(rows, part, layer="layer_styles", driver="GPKG")
    except (DataSourceError, DataLayerError, FeatureError, FieldError) as error:
        raise OutputError(f"cannot write the styles: {error}; is the disk full?") from error


def _verify(part: Path, layers: Mapping[str, gpd.GeoDataFrame], driver: str, name: str) -> None:
    """Read the finished file anew; compare the number of features and where each of them lies."""
    import numpy as np
    from pyogrio.errors import DataLayerError, DataSourceError

    if not driver and part.suffix != ".parquet":
        return  # made here: its bytes are compared
    for layer, gdf in layers.items():
        try:
            found = _bounds(part, driver, layer)
            indexed = driver != "GPKG" or not len(gdf) or _indexed(part, layer)
        except (DataSourceError, DataLayerError, OSError, ValueError, RuntimeError) as error:
            raise OutputError(f"{name} was written but cannot be read back: {error}; is the disk full?") from error
        if not indexed:
            raise OutputError(f"{name} was written without the index of its layer {layer}; is the disk full?")
        if len(found) != len(gdf):
            raise VerificationError(f"{name}: {len(gdf)} features were written, {len(found)} read back")
        # GeoJSON has rounded coordinates in another system, perhaps cut at the date line.
        if driver != "GeoJSON" and not np.array_equal(found, gdf.geometry.bounds.to_numpy(), equal_nan=True):
            raise VerificationError(f"{name}: features do not read back as they were written; is the disk failing?")


def _indexed(part: Path, layer: str) -> bool:
    import pyogrio

    return bool(pyogrio.read_info(part, layer=layer)["capabilities"]["fast_spatial_filter"])


def _bounds(part: Path, driver: str, layer: str) -> np.ndarray:
    """(features, 4) bounding boxes in a layer of a vector file; reads everything."""
    import numpy as np
    import pyogrio.raw
    import shapely

    if part.suffix == ".parquet":
        import geopandas as gpd

        return np.asarray(gpd.read_parquet(part).geometry.bounds)
    geometry = pyogrio.raw.read(part, layer=layer if driver == "GPKG" else None)[2]
    return np.empty((0, 4)) if geometry is None else np.asarray(shapely.bounds(shapely.from_wkb(geometry)))
