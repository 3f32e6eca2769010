"""Writing rasters: cloud-optimised GeoTIFF, with everything a reader needs inside, verified."""

from __future__ import annotations

import contextlib
import json
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, OutputError, VerificationError
from firebreak_gis.files import together, write_bytes, write_text
from firebreak_gis.grid import Grid, crs_name, parse_crs
from firebreak_gis.lattice import DIRECTIONS
from firebreak_gis.projections import outline, to_lonlat
from firebreak_gis.rasters.opening import open_raster
from firebreak_gis.rasters.packing import largest_error, pack, packed, step
from firebreak_gis.rasters.reading import TAG
from firebreak_gis.schema import VARIABLES, Variable
from firebreak_gis.styles.rasters import qml, rgba
from firebreak_gis.threads import thread_count

if TYPE_CHECKING:
    import xarray as xr
    from pyproj import CRS

_LOADED_IN = os.getpid()

#: Attributes of the data that become tags.
_KEPT = ("boundary", "made_for")
#: Files that GDAL keeps beside a raster; those of an overwritten raster would describe the old one.
SIDECARS = (".aux.xml", ".ovr", ".msk")


def write_raster(
    path: str | os.PathLike[str],
    data: xr.DataArray | xr.Dataset,
    *,
    overwrite: bool = False,
    provenance: Mapping[str, Any] | None = None,
    creation_options: Mapping[str, Any] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
    bits: int | None = None,
) -> Path:
    """Write variables of the schema as a cloud-optimised GeoTIFF, and the QGIS style of the first beside it.

    "No data", units, texts and colours come from the schema. No date is stored: equal data give
    equal bytes. The file is read back and compared before it takes its place.

    Parameters
    ----------
    path
        Target, usually named .tif.
    data
        Named as in `schema.VARIABLES`, with its dims, on a `Grid`. NaN is written as "no data",
        and so is -inf in `priority`. The variables of a dataset become the bands of one file, one after another;
        they must have the type and the "no data" value in common.
    overwrite
        Whether an existing file may be replaced.
    provenance
        Software, version, parameters hash, seed, ...; kept as tags, read back by `read_variable`. So are the
        attributes `boundary` and `made_for` of `data`.
    creation_options
        More options of the GDAL driver COG, for example {"compress": "zstd"}.
    forbid
        Input files, none of which may be the target.
    bits
        8 or 16: probabilities, travel times and heat are packed into so many bits, which `read_variable` undoes. The
        file tells the largest errors. None: numbers as they are.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    InputError
        If `data` does not fit the schema.
    OutputError
        If the file cannot be written.
    VerificationError
        If what was written does not read back the same.

    Notes
    -----
    Memory at the peak: twice the values, and the compressed file.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> breaks = fb.select_breaks(fb.rank(network, "degree"), budget=0.1)
    >>> fb.write_raster("breaks.tif", breaks).name
    'breaks.tif'
    """
    require_geotiff(path)
    layers: list[Any] = [data] if hasattr(data, "dtype") else list(data.data_vars.values())
    variables = variables_of(layers, bits)
    variable = variables[0]
    grid = Grid.of(data)
    planes = planes_of(layers, variables, grid.shape)
    tags = tags_of(data, provenance or {})
    place = Path(path)
    with (
        together(place.parent),
        _encoded(planes, grid, variables, tags, lower(creation_options or {})) as content,
    ):
        write_bytes(
            path,
            content,
            overwrite=overwrite,
            forbid=forbid,
            verify=lambda part: _verify(part, planes, grid, variable),
            remove=[place.with_name(place.name + suffix) for suffix in SIDECARS],
        )
        write_style(place, planes[: len(variable.bands)], variable, overwrite)
    return place


def require_geotiff(path: str | os.PathLike[str]) -> None:
    """Refuse a name that is not that of a GeoTIFF."""
    if Path(path).suffix.lower() not in (".tif", ".tiff"):
        raise OutputError(f"{path}: rasters are written as GeoTIFF, expected a name that ends in .tif")


def tags_of(data: xr.DataArray | xr.Dataset, provenance: Mapping[str, Any]) -> dict[str, Any]:
    """What is kept as tags."""
    return {**provenance, **{key: data.attrs[key] for key in _KEPT if key in data.attrs}}


def variables_of(layers: Sequence[xr.DataArray], bits: int | None = None) -> list[Variable]:
    """Variables of the schema that are to be bands of one file."""
    variables = [_variable_of(layer) for layer in layers]
    if bits is not None:
        variables = [packed(variable, bits) for variable in variables]
    variable = variables[0]
    for other in variables[1:]:
        if (disk_dtype(other), disk_nodata(other)) != (disk_dtype(variable), disk_nodata(variable)):
            raise InputError(
                f"{variable.name} and {other.name} cannot be bands of one file: {disk_dtype(variable)} with no data "
                f"{variable.nodata} and {disk_dtype(other)} with {other.nodata}; write one file each"
            )
    return variables


def planes_of(layers: Sequence[xr.DataArray], variables: Sequence[Variable], shape: tuple[int, int]) -> np.ndarray:
    """Bands of a file, (bands, rows, cols), one layer after another."""
    if len(layers) == 1:
        values = _stored_values(layers[0].to_numpy(), variables[0])
        return values if values.ndim == 3 else values[np.newaxis]
    planes = np.empty((sum(len(variable.bands) for variable in variables), *shape), disk_dtype(variables[0]))
    first = 0
    for layer, variable in zip(layers, variables, strict=True):
        planes[first : first + len(variable.bands)] = _stored_values(layer.to_numpy(), variable)
        first += len(variable.bands)
    return planes


def _variable_of(data: xr.DataArray) -> Variable:
    variable = VARIABLES.get(str(data.name))
    if variable is None:
        raise InputError(f"{data.name!r} is not a variable of the schema; expected one of {', '.join(VARIABLES)}")
    if variable.along in data.coords and data.coords[variable.along].ndim == 0:
        where = data.coords[variable.along]
        place = f"{variable.along.replace('_', ' ')} {where.item():g} {where.attrs.get('units', '1')}"
        variable = replace(variable, text=f"{variable.text} ({place.removesuffix(' 1')})")
    if data.dims != variable.dims or variable.dims[-2:] != ("y", "x"):
        raise InputError(f"{variable.name} has dims {data.dims}, expected {variable.dims} with y and x last")
    if variable.dims[0] == "direction" and data.sizes["direction"] != len(DIRECTIONS):
        raise InputError(f"{variable.name} has {data.sizes['direction']} directions, expected {len(DIRECTIONS)}")
    return variable


def disk_dtype(variable: Variable) -> np.dtype[Any]:
    """Return the data type of a variable in files; GeoTIFF has no booleans."""
    if variable.bits:
        return np.dtype(f"uint{variable.bits}")
    return np.dtype("uint8" if variable.dtype == "bool" else variable.dtype)


def disk_nodata(variable: Variable) -> float | None:
    """Return what stands for "no data" in files."""
    return float((1 << variable.bits) - 1) if variable.bits else variable.nodata


def _stored_values(values: np.ndarray, variable: Variable) -> np.ndarray:
    """Return what goes into the file: "no data" put in, type of the schema, nothing lost."""
    kind = disk_dtype(replace(variable, bits=0))
    if values.dtype.kind not in "iufb":
        raise InputError(f"{variable.name} holds {values.dtype} values, expected {variable.dtype}")
    missing = np.isnan(values) if values.dtype.kind == "f" else np.zeros(values.shape, dtype=bool)
    if variable.name == "priority":
        if missing.any():
            raise InputError(
                f"priority is NaN in {int(missing.sum())} cells; expected a number, or -inf where nothing burns"
            )
        missing = np.isneginf(values)
    inside = values[~missing]
    if inside.size and not np.isfinite(inside).all():
        raise InputError(f"{variable.name} holds infinite values; expected finite numbers, or NaN for no data")
    if variable.nodata is not None and missing.any() and kind.kind == "f" and (inside == variable.nodata).any():
        raise InputError(
            f"{variable.name} holds {variable.nodata:g}, which stands for no data in files; shift the values"
        )
    for bound, wrong, word in (
        (variable.minimum, np.less, "at least"),
        (variable.maximum, np.greater, "at most"),
    ):
        if bound is not None and inside.size and wrong(inside, bound).any():
            raise InputError(
                f"{variable.name} goes from {inside.min():g} to {inside.max():g}, expected {word} {bound:g}"
            )
    if kind.kind != "f" and values.dtype.kind == "f" and not np.array_equal(inside, np.round(inside)):
        raise InputError(f"{variable.name} holds fractions, expected whole numbers")
    if variable.bits:
        return pack(values, missing, variable)
    filled = np.where(missing, 0 if variable.nodata is None else variable.nodata, values) if missing.any() else values
    stored = filled.astype(kind)
    if kind.kind == "f" and variable.nodata is not None and (stored[~missing] == variable.nodata).any():
        raise InputError(
            f"{variable.name} holds {variable.nodata:g}, which stands for no data in files; shift the values"
        )
    return np.ascontiguousarray(stored)


def _threads() -> int:
    """Threads for GDAL, whose threads do not live on in a fork: a child that counted on them would wait for ever."""
    return thread_count(None) if os.getpid() == _LOADED_IN else 1


def lower(options: Mapping[str, Any]) -> dict[str, Any]:
    """Names of options in small letters."""
    return {str(key).lower(): value for key, value in options.items()}


@contextlib.contextmanager
def _encoded(
    planes: np.ndarray,
    grid: Grid,
    variables: Sequence[Variable],
    provenance: Mapping[str, Any],
    options: Mapping[str, Any],
) -> Iterator[memoryview]:
    """Give the bytes of the file."""
    import rasterio
    from rasterio.errors import NotGeoreferencedWarning
    from rasterio.io import MemoryFile

    variable = variables[0]
    profile = {**profile_of(grid, variables), "driver": "COG", **cog_options(variable), **options}
    with MemoryFile(ext=".tif") as memory:
        # All that is known goes into the file: a .aux.xml beside it would be lost.
        with rasterio.Env(GDAL_PAM_ENABLED="NO"), warnings.catch_warnings():
            warnings.simplefilter("ignore", NotGeoreferencedWarning)
            try:
                with memory.open(**profile) as target:
                    target.write(planes)
                    describe(target, variables, provenance)
            except Exception as error:  # GDAL has private classes for what it does not like
                raise OutputError(f"cannot write the raster {variable.name}: {error}; check --co") from error
        yield memoryview(memory.getbuffer())


def profile_of(grid: Grid, variables: Sequence[Variable]) -> dict[str, Any]:
    """What a raster of the variables is, whatever its format."""
    variable = variables[0]
    profile: dict[str, Any] = {
        "count": sum(len(each.bands) for each in variables),
        "height": grid.shape[0],
        "width": grid.shape[1],
        "dtype": disk_dtype(variable).name,
        "transform": grid.transform,
        "nodata": disk_nodata(variable),
    }
    return profile if grid.crs is None else {**profile, "crs": grid.crs.to_wkt()}


def cog_options(variable: Variable) -> dict[str, Any]:
    """Options of the GDAL driver COG unless the user gives others."""
    classes = bool(variable.classes) or variable.dtype == "bool"
    return {
        "blocksize": 256,
        "compress": "DEFLATE",
        "predictor": "YES",
        "bigtiff": "IF_SAFER",
        "num_threads": _threads(),  # the bytes are the same
        # The default is cubic, which invents classes.
        "overview_resampling": "MODE" if classes else "AVERAGE",
    }


def describe(target: Any, variables: Sequence[Variable], provenance: Mapping[str, Any]) -> None:
    """Put all that is known into a file that is being written."""
    tags = {TAG + str(key).upper(): _text(value) for key, value in sorted(provenance.items())}
    target.update_tags(AREA_OR_POINT="Area", **tags)
    bands = [(variable, text) for variable in variables for text in variable.bands]
    for band, (variable, text) in enumerate(bands, start=1):
        target.set_band_description(band, text)
        target.set_band_unit(band, variable.units)
        meaning = {f"CLASS_{code}": label for code, label in variable.classes.items()}
        target.update_tags(band, variable=variable.name, long_name=variable.text, **meaning)
        if variable.bits:
            error = largest_error(variable.name, variable.bits)
            target.update_tags(band, packed_bits=variable.bits, largest_error=f"{error:.2g}")
    variable = variables[0]
    if variable.bits:
        target.scales = tuple(step(variable) for variable, _ in bands)  # so that QGIS shows probabilities
    if variable.classes and variable.colours:
        target.write_colormap(1, {code: rgba(colour) for code, colour in variable.colours.items()})


def _text(value: Any) -> str:
    return value if isinstance(value, str) else json.dumps(value, sort_keys=True)


def _verify(part: Path, planes: np.ndarray, grid: Grid, variable: Variable) -> None:
    """Read the finished file anew and compare everything that matters."""
    from rasterio.errors import RasterioError

    try:
        _compare(part, planes, grid, variable)
    except (InputError, RasterioError, OSError) as error:
        raise OutputError(
            f"the raster {variable.name} was written but cannot be read back: {error}; is the disk full?"
        ) from error


def _compare(part: Path, planes: np.ndarray, grid: Grid, variable: Variable) -> None:
    with open_raster(part) as source:
        crs = None if source.crs is None else parse_crs(source.crs.to_wkt())
        found = Grid((source.height, source.width), source.transform, crs)
        if found.shape != grid.shape or not found.transform.almost_equals(grid.transform, precision=1e-6):
            raise VerificationError(f"{variable.name}: written on {grid.describe()}, read back on {found.describe()}")
        if (crs is None) != (grid.crs is None):
            raise VerificationError(f"{variable.name}: the CRS was lost in the file")
        if crs is not None and grid.crs is not None and crs != grid.crs and _apart(crs, grid):
            raise VerificationError(
                f"{variable.name}: the file cannot keep the CRS {crs_name(grid.crs)} as it is, places would lie "
                "elsewhere; choose another one, e.g. UTM (--dst-crs)"
            )
        nodata = disk_nodata(variable)
        if source.nodata != nodata and not (source.nodata is None and nodata is None):
            raise VerificationError(f"{variable.name}: no data written as {nodata}, read back as {source.nodata}")
        for band, plane in enumerate(planes, start=1):
            if not np.array_equal(source.read(band), plane):
                raise VerificationError(
                    f"{variable.name}: band {band} does not read back as it was written; is the disk failing?"
                )


def _apart(crs: CRS, grid: Grid) -> bool:
    """Whether the border of the grid lies elsewhere on the Earth when it is read in `crs`, by 0.1 m or more."""
    assert grid.crs is not None
    x, y = outline(grid.transform, grid.shape, points=3)
    there, here = (np.array(to_lonlat(which, x, y)) for which in (crs, grid.crs))
    known = np.isfinite(here) & np.isfinite(there)
    return bool((np.abs(there - here)[known] > 1e-6).any())


def write_style(place: Path, values: np.ndarray, variable: Variable, overwrite: bool) -> None:
    """Write the QGIS style of a variable beside its raster; a ramp without fixed ends needs the values."""
    if not variable.colours:
        return
    style = place.with_suffix(".qml")
    if style.exists() and not overwrite:
        return  # the user's own
    if variable.classes or (variable.minimum == 0 and variable.maximum == 1):
        # Shares keep 0 to 1, so that two maps beside each other have the same colours.
        text = qml(variable)
    else:
        low, high = _usual_range(values[values != variable.nodata])
        text = qml(variable, minimum=low, maximum=high)
    write_text(style, text, overwrite=True)


def _usual_range(inside: np.ndarray) -> tuple[float, float]:
    """Range without the outermost 2 % on each side: few great values must not take all the colours."""
    if inside.size == 0:
        return 0.0, 1.0
    low, high = (float(v) for v in np.percentile(inside, (2, 98)))
    return (low, high) if low < high else (float(inside.min()), float(inside.max()))
