"""Shapefiles: five files, or one archive with them; short names of columns, texts in UTF-8, no time of day."""

from __future__ import annotations

import io
import tempfile
import warnings
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import OutputError
from firebreak_gis.files.formats import SHAPEFILE_PARTS, clean
from firebreak_gis.files.gate import vector_settings
from firebreak_gis.schema import COLUMNS

if TYPE_CHECKING:
    import geopandas as gpd

#: Letters of a name of a column, and bytes of a text, that its table holds.
NAME_LENGTH, TEXT_LENGTH = 10, 254
#: Files that other programs put beside a Shapefile; of an old one they would be wrong beside the new.
BESIDE = (".qix", ".sbn", ".sbx", ".idm", ".ind", ".fbn", ".fbx", ".ain", ".aih", ".atx", ".mxs", ".qpj", ".shp.xml")
_DATE = "2000-01-01"


def field_names(columns: Iterable[str]) -> dict[str, str]:
    """Return the name in a Shapefile of each column: that of `schema.COLUMNS`, else cut, and told apart by numbers.

    Examples
    --------
    >>> field_names(["mean_slope_deg", "width_flames_m", "neighbours_north", "neighbours_south"])
    {'mean_slope_deg': 'slope_mean', 'width_flames_m': 'wid_flames', 'neighbours_north': 'neighbours', \
'neighbours_south': 'neighbou_2'}
    """
    columns = list(columns)
    made = {name: COLUMNS[name].short for name in columns if name in COLUMNS}
    taken = {short.lower() for short in made.values()}
    for name in columns:
        if name in made:
            continue
        plain = "".join(c if c.isascii() and (c.isalnum() or c == "_") else "_" for c in name)[:NAME_LENGTH]
        short, k = plain, 1
        while short.lower() in taken:
            k += 1
            short = f"{plain[: NAME_LENGTH - 1 - len(str(k))]}_{k}"
        made[name] = short
        taken.add(short.lower())
    return {name: made[name] for name in columns}


def encode(gdf: gpd.GeoDataFrame, stem: str, kind: str) -> dict[str, bytes]:
    """Return the content of each of the files, by ending.

    Parameters
    ----------
    gdf
        Of one kind of geometry.
    stem
        Name for messages.
    kind
        Kind of geometry of an empty frame.

    Raises
    ------
    OutputError
        If a text is too long, or what was made does not read back.
    """
    import pandas as pd
    import pyogrio
    from pyogrio.errors import DataLayerError, DataSourceError, FeatureError, FieldError, GeometryError

    frame = gdf.rename(columns=field_names(str(name) for name in gdf.columns if name != gdf.geometry.name))
    for name in frame.columns:
        if frame[name].dtype.kind not in "biuf" and name != frame.geometry.name:
            texts = [None if value is None or value != value else clean(value) for value in frame[name]]
            frame[name] = pd.Series(texts, index=frame.index, dtype=object)
            longest = max((len(text.encode()) for text in texts if text is not None), default=0)
            if longest > TEXT_LENGTH:
                raise OutputError(
                    f"{stem}: a Shapefile holds texts of at most {TEXT_LENGTH} bytes, column {name} has one of "
                    f"{longest}; choose .gpkg"
                )
    options: dict[str, Any] = {"DBF_DATE_LAST_UPDATE": _DATE}
    if frame.empty:
        options["geometry_type"] = kind.removeprefix("Multi") if kind != "Unknown" else "Polygon"
    # GDAL makes several files on disks only. What it may leave untold, the reading tells.
    with tempfile.TemporaryDirectory(prefix="firebreak-") as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of numbers that lose digits behind the 15th
        path = Path(folder) / "made.shp"
        try:
            with vector_settings({}):
                pyogrio.write_dataframe(frame, path, driver="ESRI Shapefile", encoding="UTF-8", **options)
            back = pyogrio.read_dataframe(path)
        except (DataSourceError, DataLayerError, FeatureError, FieldError, GeometryError, OSError) as error:
            raise OutputError(f"cannot write {stem}: {error}; is the disk full?") from error
        _require_same(frame, back, stem)
        return {end: path.with_suffix(end).read_bytes() for end in SHAPEFILE_PARTS}


def zipped(parts: Mapping[str, bytes], stem: str) -> bytes:
    """Return an archive of the files, the same bytes for the same files."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for end, content in parts.items():
            entry = zipfile.ZipInfo(f"{stem}{end}", (2000, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, content)
    return made.getvalue()


def _require_same(frame: gpd.GeoDataFrame, back: gpd.GeoDataFrame, stem: str) -> None:
    import numpy as np

    names = [name for name in frame.columns if name != frame.geometry.name]
    if len(back) != len(frame) or list(back.columns.drop("geometry")) != names:
        raise OutputError(f"{stem}: {len(frame)} features were written, {len(back)} read back; is the disk full?")
    same = np.array_equal(back.geometry.bounds.to_numpy(), frame.geometry.bounds.to_numpy(), equal_nan=True)
    for name in names:
        if frame[name].dtype.kind in "biuf":
            found, written = (each[name].to_numpy(dtype=float, na_value=np.nan) for each in (back, frame))
            same = same and np.allclose(found, written, rtol=1e-12, atol=1e-15, equal_nan=True)
        else:
            texts = [[None if v is None or v != v or v == "" else v for v in each[name]] for each in (back, frame)]
            same = same and texts[0] == texts[1]
    if not same:
        raise OutputError(f"{stem}: features do not read back as they were written; is the disk full?")
