"""Opening rasters: what a file says of itself, and a sentence for every file that cannot be used."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from affine import Affine

from firebreak_gis.errors import CRSError, GridError, InputError
from firebreak_gis.grid import Grid, parse_crs, with_y_and_x
from firebreak_gis.projections import ASSIGNING, horizontal, require_plausible, vertical_factor
from firebreak_gis.rasters.naming import banded, short_name
from firebreak_gis.rasters.opening import open_raster
from firebreak_gis.rasters.units import QUANTITIES, per_hectare, unit_in

if TYPE_CHECKING:
    import xarray as xr
    from pyproj import CRS

#: FlamMap landscapes write this for "no data", without declaring it.
LCP_NODATA = -9999.0


@dataclass(frozen=True)
class Header:
    """What is known of one band before its values are read.

    Parameters
    ----------
    path
        Where it is, for messages and for opening it; "an array" for data in memory.
    band
        Band number, from 1.
    shape, transform, crs
        Its grid; any affine transform, `crs` horizontal, None if missing.
    dtype
        numpy dtype name as stored.
    nodata
        Values that stand for "no data".
    masked
        Whether a mask or alpha band tells where data is.
    scale, offset
        Stored value times `scale` plus `offset` is the value.
    units
        Unit text of the band, may be empty.
    vertical
        Metres per vertical unit if the CRS says so, else None.
    palette
        Whether the values index a colour table.
    located_by
        "gcp" or "rpc" if only control points or a camera model say where it lies.
    tags
        Metadata of the file.
    notes
        Sentences on what was ignored.
    declared
        Whether the user said which values mean "no data": then no others are looked for.
    array
        The values, for data in memory.
    remote
        Whether the values may come over the network or out of an archive.
    bits
        Bits of a number if the band holds them packed, see `packing`; 0: it does not.
    """

    path: str
    band: int
    shape: tuple[int, int]
    transform: Affine
    crs: CRS | None
    dtype: str
    nodata: tuple[float, ...] = ()
    masked: bool = False
    scale: float = 1.0
    offset: float = 0.0
    units: str = ""
    vertical: float | None = None
    palette: bool = False
    located_by: str = ""
    tags: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    declared: bool = False
    array: np.ndarray | None = None
    remote: bool = False
    bits: int = 0

    @property
    def north_up(self) -> bool:
        """Whether rows run south and columns east, without rotation."""
        t = self.transform
        return bool(t.b == 0 and t.d == 0 and t.a > 0 and t.e < 0)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """(left, bottom, right, top) of the footprint, in CRS units."""
        rows, cols = self.shape
        corners = [self.transform @ corner for corner in ((0, 0), (cols, 0), (0, rows), (cols, rows))]
        x, y = [corner[0] for corner in corners], [corner[1] for corner in corners]
        return float(min(x)), float(min(y)), float(max(x)), float(max(y))

    @property
    def grid(self) -> Grid:
        """The grid, for north-up rasters."""
        return Grid(self.shape, self.transform, self.crs)


def read_header(
    path: str | os.PathLike[str],
    *,
    band: int | None = None,
    src_nodata: float | Sequence[float] | None = None,
    remote: bool = False,
) -> Header:
    """Read what a raster file says of one band.

    Parameters
    ----------
    path
        Any raster that GDAL reads; a variable of a file with several by name, `a.nc:dem`, or as GDAL writes it,
        `NETCDF:"a.nc":dem`; a band by its number, `a.tif:2`.
    band
        Band number from 1; needed when there are several data bands.
    src_nodata
        Value or values that mean "no data", instead of what the file says.
    remote
        Whether network addresses and paths into archives are allowed.

    Raises
    ------
    InputError
        If the file cannot be used, or it is not clear which band is meant.
    """
    name, numbered = banded(os.fspath(path))
    with open_raster(name, remote=remote) as source:
        number = _choose_band(source, name, numbered if band is None else band)
        dtype = source.dtypes[number - 1]
        if np.dtype(dtype).kind not in "iufb":
            raise InputError(f"{name} holds {dtype} values, expected real numbers; extract one part of them first")
        full, crs = _crs_of(source)
        flags = {flag.name for flag in source.mask_flag_enums[number - 1]}
        declared = source.nodatavals[number - 1]
        if declared is None and source.driver == "LCP":
            declared = LCP_NODATA
        nodata = (() if declared is None else (declared,)) if src_nodata is None else _as_tuple(src_nodata)
        usable, notes = usable_nodata(nodata, dtype)
        return Header(
            path=name,
            band=number,
            shape=(source.height, source.width),
            transform=source.transform,
            crs=crs,
            dtype=dtype,
            nodata=usable,
            masked=src_nodata is None and "per_dataset" in flags,
            scale=float(source.scales[number - 1]),
            offset=float(source.offsets[number - 1]),
            units=_unit_of(source, number),
            vertical=None if full is None else vertical_factor(full),
            palette=source.colorinterp[number - 1].name == "palette",
            located_by=_located_by(source),
            tags=dict(source.tags()),
            notes=notes,
            remote=remote,
            declared=src_nodata is not None,
            bits={"8": 8, "16": 16}.get(source.tags(number).get("packed_bits", ""), 0),
        )


def header_of_array(data: xr.DataArray, *, src_nodata: float | Sequence[float] | None = None) -> Header:
    """Return the header of an array in memory, with its CRS in a CF grid mapping, as rioxarray keeps it.

    Its dimensions may be called otherwise than (y, x), see `grid.with_y_and_x`.

    Raises
    ------
    InputError
        If it has more than one band or no real numbers.
    """
    named = data
    data = with_y_and_x(named)
    extra = [dim for dim in data.dims if dim not in ("y", "x")]
    name = f"the array {data.name!r}" if data.name else "the array"
    if any(data.sizes[dim] != 1 for dim in extra):
        raise InputError(f"{name} has dimensions {tuple(data.dims)}, expected (y, x); select one band first")
    flat = data.squeeze(extra, drop=True).transpose("y", "x") if {"y", "x"} <= set(data.dims) else data
    grid = Grid.of(flat)
    if flat.dtype.kind not in "iufb":
        raise InputError(f"{name} holds {flat.dtype} values, expected real numbers")
    told = [data.attrs.get("_FillValue"), data.encoding.get("_FillValue")]
    nodata = [v for v in told if v is not None][:1] if src_nodata is None else _as_tuple(src_nodata)
    usable, notes = usable_nodata([float(v) for v in nodata], str(flat.dtype))
    if grid.crs is not None and Grid.crs_told(named) is None:
        notes = (*notes, "its latitudes and longitudes were taken as of WGS 84, since it tells no CRS")
    return Header(
        path=name,
        band=1,
        shape=grid.shape,
        transform=grid.transform,
        crs=None if grid.crs is None else horizontal(grid.crs),
        dtype=str(flat.dtype),
        nodata=usable,
        scale=float(data.attrs.get("scale_factor", 1.0)),
        offset=float(data.attrs.get("add_offset", 0.0)),
        units=str(data.attrs.get("units", "")),
        vertical=None if grid.crs is None else vertical_factor(grid.crs),
        notes=notes,
        declared=src_nodata is not None,
        array=flat.to_numpy(),
    )


def with_crs(header: Header, crs: Any) -> Header:
    """Return the header with another CRS, for files that tell none or a wrong one."""
    full = parse_crs(crs)
    return replace(header, crs=horizontal(full), vertical=vertical_factor(full))


def require_georeferenced(header: Header) -> CRS:
    """Return the CRS of a raster that says where on the Earth it lies.

    Raises
    ------
    CRSError, GridError
        If CRS or transform are missing or cannot be true; the text says which command helps.
    """
    where = header.path
    if header.transform.is_identity:
        help_ = {
            "gcp": "it only has ground control points: gdalwarp -t_srs EPSG:32635 in.tif out.tif",
            "rpc": "it only has a camera model (RPC): gdalwarp -rpc -t_srs EPSG:32635 in.tif out.tif",
        }.get(header.located_by, "gdal_translate -a_srs EPSG:32635 -a_ullr LEFT TOP RIGHT BOTTOM in.tif out.tif")
        raise GridError(f"{where} does not say where its cells lie (no transform); {help_}")
    if header.crs is None:
        how = ASSIGNING if header.array is None else ', e.g. data.rio.write_crs("EPSG:32635")'
        raise CRSError(f"{where} has no coordinate reference system; assign the one it was made in{how}")
    if abs(header.transform.determinant) == 0 or not all(math.isfinite(v) for v in header.transform[:6]):
        raise GridError(
            f"{where} has cells without area (transform {tuple(header.transform[:6])}); its georeference is broken"
        )
    require_plausible(header.crs, header.bounds, where)
    return header.crs


def usable_nodata(values: Sequence[float], dtype: str) -> tuple[tuple[float, ...], tuple[str, ...]]:
    """Split off "no data" values that the data type cannot hold; return the usable ones and the notes."""
    kind = np.dtype(dtype)
    usable, notes = [], []
    for value in values:
        if kind.kind in "iu":
            limits = np.iinfo(kind)
            fits = math.isfinite(value) and value == int(value) and limits.min <= value <= limits.max
        else:
            fits = True
        if fits:
            usable.append(float(value))
        elif not math.isnan(value):
            notes.append(f"the no-data value {value:g} does not fit the data type {dtype} and was ignored")
    return tuple(usable), tuple(notes)


def _as_tuple(value: float | Sequence[float]) -> tuple[float, ...]:
    return tuple(float(v) for v in value) if isinstance(value, Sequence) else (float(value),)


def _choose_band(source: Any, name: str, band: int | None) -> int:
    if source.count == 0 or (source.subdatasets and band is None):
        inside = ", ".join(short_name(text) for text in source.subdatasets[:4]) or "nothing"
        raise InputError(f"{name} holds several rasters, choose one by its full name: {inside}")
    if band is not None:
        if not 1 <= band <= source.count:
            raise InputError(f"{name} has no band {band}, it has bands 1 to {source.count}")
        return band
    colours = [colour.name for colour in source.colorinterp]
    data = [i for i, colour in enumerate(colours, start=1) if colour != "alpha"]
    if len(data) == 1:
        return data[0]
    if {"red", "green", "blue"} <= set(colours) or {"cyan", "magenta", "yellow"} <= set(colours):
        raise InputError(f"{name} is a colour picture of a map, not a map of values; use the raster it was drawn from")
    raise InputError(f"{name} has {source.count} bands; choose one by its number: {name}:1 (or --bidx, band=)")


def _crs_of(source: Any) -> tuple[CRS | None, CRS | None]:
    """Return the full and the horizontal CRS; what cannot be read counts as missing."""
    if source.crs is None:
        return None, None
    full = parse_crs(source.crs.to_wkt())
    flat = horizontal(full)
    # GeoTIFF keeps the code, not the text; taking the text of the code makes equal systems compare equal.
    epsg = flat.to_epsg(min_confidence=100)
    return full, parse_crs(epsg) if epsg else flat


def _unit_of(source: Any, band: int) -> str:
    """Unit of a band: as GDAL tells it, else among its metadata (as in FlamMap landscapes), else in its description."""
    if unit := source.units[band - 1]:
        return str(unit)
    tags = {str(key).lower(): str(value) for key, value in source.tags(band).items()}
    for key in ("units", "unit", "elevation_unit_name"):
        if key in tags:
            return tags[key]
    described = unit_in(source.descriptions[band - 1] or "")
    known = per_hectare(described) is not None or any(quantity.knows(described) for quantity in QUANTITIES)
    return described if known else ""


def _located_by(source: Any) -> str:
    """What else than a transform ties the raster to the ground: "gcp", "rpc" or ""."""
    if not source.transform.is_identity:
        return ""
    if source.gcps[0]:
        return "gcp"
    return "rpc" if source.rpcs is not None else ""
