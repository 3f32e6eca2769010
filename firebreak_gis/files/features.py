"""Reading the features of one layer of a vector file, of an archive, or of a table with coordinates."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from firebreak_gis.errors import InputError, MissingComponentError, ResourceError
from firebreak_gis.files.gate import (
    asked_for_network,
    has_controls,
    offline,
    require_local_vector,
    shortened,
    stands,
    vector_settings,
)
from firebreak_gis.files.sources import MAPPED, chosen_layer, such_as, table_of_points, vector_name, within_archive
from firebreak_gis.grid import crs_name, parse_crs

if TYPE_CHECKING:
    import geopandas as gpd
    from pyproj import CRS


def read_frame(source: str, target: CRS, notes: list[str]) -> tuple[str, gpd.GeoDataFrame]:
    """Read the features of the one layer that is meant.

    Parameters
    ----------
    source
        `FILE|layername=NAME|subset=CONDITION`, see `sources.vector_name`.
    target
        CRS in which x and y of a table are taken.
    notes
        Gets sentences on what was taken for what.

    Returns
    -------
    tuple
        Name of the file for messages, and the features in the CRS of the file.

    Raises
    ------
    InputError
        If it cannot be read, or it is not clear which layer is meant.
    MissingComponentError
        For .parquet without pyarrow.
    ResourceError
        If it does not fit into memory.
    """
    asked = vector_name(source)
    name, layer = asked.file, asked.layer
    if has_controls(os.path.abspath(name)):  # noqa: PTH100 - as below
        raise InputError(f"{name!r} has a line break or tab in its name; rename it")
    if not stands(name):
        raise InputError(
            f"{shortened(name)} does not exist on this machine; check the name and the folder, or, if it is a network "
            "or archive address, download or unpack it first"
        )
    if name.lower().endswith((".parquet", ".csv")):
        frame = _read_parquet(name) if name.lower().endswith(".parquet") else _read_table(name, target, notes)
        if asked.where and frame is not None:
            raise InputError(f"{name} cannot be filtered; make a .gpkg of it, or filter it first")
        if frame is not None:
            return name, frame
    place = os.path.abspath(name)  # noqa: PTH100 - a relative name may look like an address
    place, layer = within_archive(place, layer) if name.lower().endswith(".zip") else (place, layer)
    from pyogrio.errors import DataLayerError, DataSourceError, FeatureError
    from shapely.errors import ShapelyError

    try:
        with offline(vector_settings):
            require_local_vector(name, place)
            chosen = _layer_in(place, name, layer)
            frame = _read_layer(place, chosen, asked.where)
            if not asked.where:
                _require_whole(place, chosen, frame)
    except InputError:
        raise
    except (FeatureError, DataSourceError, DataLayerError, ShapelyError, OSError, ValueError) as error:
        if isinstance(error, FeatureError) or (asked.where and "SQL" in str(error)):  # pyogrio up to 0.11 says so
            text = str(error).replace(place, "the file")[-160:]
            raise InputError(f"{name}: the filter {asked.where!r} does not work: {text}") from error
        if asked_for_network(error):
            raise InputError(f"{name} describes data on a server; download them first") from error
        if Path(place).is_dir():
            raise InputError(f"{name} is a folder, expected a vector file in it{such_as(name, MAPPED)}") from error
        text = str(error).replace(place, "the file")[:120]
        raise InputError(f"{name} cannot be read as vector data ({text}); is it complete?") from error
    except MemoryError as error:  # as many features as the header of a damaged file may claim
        raise ResourceError(f"{name} claims more features than fit into memory; is it damaged?") from error
    return name, frame


def _layer_in(place: str, name: str, layer: str | int | None) -> str:
    import pyogrio

    layers = [str(row[0]) for row in pyogrio.list_layers(place) if row[1] is not None]
    if not layers:
        table = "; a table needs the columns x and y, or lon and lat" if name.lower().endswith(".csv") else ""
        raise InputError(f"{name} holds no layer with geometries{table}")
    if len(layers) == 1 and layer is None:
        return layers[0]
    told = {each: pyogrio.read_info(place, layer=each, force_feature_count=True) for each in layers}
    return chosen_layer(name, {each: info["features"] for each, info in told.items()}, layer)


def _read_layer(name: str, layer: str, where: str) -> gpd.GeoDataFrame:
    """Shapefiles cut names after ten bytes, perhaps in the middle of a letter; then each byte is read as one."""
    import geopandas as gpd

    options = {"where": where} if where else {}
    try:
        return gpd.read_file(name, layer=layer, engine="pyogrio", **options)
    except UnicodeDecodeError:
        return gpd.read_file(name, layer=layer, engine="pyogrio", ENCODING="ISO-8859-1", **options)


def _read_table(name: str, target: CRS, notes: list[str]) -> gpd.GeoDataFrame | None:
    """Points of a CSV file with coordinates; None if it has none."""
    import geopandas as gpd
    import numpy as np

    found = table_of_points(name)
    if found is None:
        return None
    table, x, y, degrees = found
    if not degrees and not target.is_geographic and len(x) and np.abs(x).max() <= 180 and np.abs(y).max() <= 90:
        raise InputError(
            f"{name}: x and y look like degrees, expected coordinates in {crs_name(target)}; if they are degrees, name "
            "the columns lon and lat"
        )
    crs = parse_crs("EPSG:4326") if degrees else target
    notes.append(f"the coordinates of the table were taken as {crs_name(crs)}")
    return gpd.GeoDataFrame(table, geometry=gpd.points_from_xy(x, y), crs=crs)


def _require_whole(name: str, layer: str, frame: gpd.GeoDataFrame) -> None:
    """A FlatGeobuf cut off between two features reads without a word; its header knows how many there were."""
    import pyogrio

    try:
        told = pyogrio.read_info(name, layer=layer)
    except UnicodeDecodeError:
        return  # a Shapefile, see _read_layer
    if told["driver"] == "FlatGeobuf" and told["features"] > len(frame):
        raise InputError(
            f"{name} is damaged or cut off: {len(frame)} features were found, {told['features']} expected; copy or "
            "export it again"
        )


def _read_parquet(name: str) -> gpd.GeoDataFrame:
    import geopandas as gpd

    try:
        return gpd.read_parquet(name)
    except ImportError as error:
        raise MissingComponentError("reading .parquet needs pyarrow: pip install pyarrow (or use .gpkg)") from error
    except (OSError, ValueError) as error:
        raise InputError(f"{name} cannot be read as GeoParquet ({str(error)[:120]}); is it complete?") from error
