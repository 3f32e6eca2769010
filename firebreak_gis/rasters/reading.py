"""Reading values: "no data", scales and sentinels are settled here, once."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import GridError, InputError
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import DIRECTIONS
from firebreak_gis.rasters.header import Header, read_header, require_georeferenced
from firebreak_gis.rasters.nodata import is_value, told_of, undeclared_nodata
from firebreak_gis.rasters.opening import open_raster
from firebreak_gis.rasters.packing import packed, unpack
from firebreak_gis.schema import VARIABLES, Variable

if TYPE_CHECKING:
    import xarray as xr

#: Row and column of the first cell, then rows and columns.
Window = tuple[int, int, int, int]


@dataclass(frozen=True)
class Cells:
    """Values of a window, and which of them are data.

    Parameters
    ----------
    values
        (rows, cols); meaningless where not `valid`.
    valid
        (rows, cols) bool.
    notes
        Sentences on what may be wrong with them.
    said
        Sentences on what was done, as the file asks for it.
    """

    values: np.ndarray
    valid: np.ndarray
    notes: tuple[str, ...] = ()
    said: tuple[str, ...] = ()


def read_cells(header: Header, window: Window | None = None, *, strict: bool = False, sentinels: bool = True) -> Cells:
    """Read one band, settle "no data", apply scale and offset.

    Parameters
    ----------
    header
        From `read_header` or `header_of_array`.
    window
        Part to read; all by default. Must lie inside the raster.
    strict
        Refuse an undeclared "no data" value instead of masking it.
    sentinels
        Whether to look for undeclared "no data" values (not sensible for class codes).

    Raises
    ------
    InputError
        If the file is damaged, holds infinite values or packed numbers, or (`strict`) undeclared "no data".
    """
    if header.bits:
        raise InputError(f"{header.path} holds numbers packed into {header.bits} bits, and is read as a network alone")
    return _settled(header, *_stored([header], window or (0, 0, *header.shape))[0], strict, sentinels)


def _settled(header: Header, values: np.ndarray, valid: np.ndarray, strict: bool, sentinels: bool) -> Cells:
    notes, said = list(header.notes), list[str]()
    for value in header.nodata:
        valid &= ~is_value(values, value)
    if values.dtype.kind == "f":
        valid &= ~np.isnan(values)
    if sentinels and not header.nodata and not header.masked and not header.declared:
        found = undeclared_nodata(values, valid)
        notes += told_of(found, header.path, strict=strict)
        for value in found:
            valid &= ~is_value(values, value)
    infinite = int(np.count_nonzero(np.isinf(values) & valid)) if values.dtype.kind == "f" else 0
    if infinite:
        raise InputError(
            f"{header.path} holds infinite values in {infinite} cells; repair them or declare them as no "
            f"data "
            "(--src-nodata)"
        )
    if header.scale != 1 or header.offset != 0:
        values = values.astype(np.float64) * header.scale + header.offset
        said.append(
            f"stored numbers were multiplied by {header.scale:g} and {header.offset:g} was added, as the file says"
        )
    return Cells(values, valid, tuple(notes), tuple(said))


def read_raster(
    path: str | os.PathLike[str],
    *,
    band: int | None = None,
    src_nodata: float | Sequence[float] | None = None,
    strict: bool = False,
    remote: bool = False,
) -> xr.DataArray:
    """Read one band of any north-up (or south-up) raster with CRS.

    Integers without missing cells keep their type; otherwise the values are floats with NaN for "no
    data" (float32 stays float32). South-up rasters are turned.

    Parameters
    ----------
    path
        Any raster that GDAL reads.
    band
        Band number from 1; needed when there are several data bands.
    src_nodata
        Value or values that mean "no data", instead of what the file says.
    strict
        Refuse undeclared "no data" values; otherwise they are masked and noted in `attrs["notes"]`.
    remote
        Whether network addresses and paths into archives are allowed.

    Returns
    -------
    xarray.DataArray
        Dims (y, x), CRS in `spatial_ref`; `attrs["notes"]` lists what was done.

    Raises
    ------
    InputError
        If the file cannot be used; `CRSError`, `GridError` if it does not say where it lies or is rotated.
    """
    header = read_header(path, band=band, src_nodata=src_nodata, remote=remote)
    require_georeferenced(header)
    cells = read_cells(header, strict=strict)
    grid = _grid_north_up(header)
    values, valid = (_north_up(header, plane) for plane in (cells.values, cells.valid))
    if not valid.any():
        raise InputError(f"{header.path} holds no data in any cell")
    if not valid.all():
        exact = (
            np.float32
            if values.dtype in (np.float32, np.float16, np.int8, np.uint8, np.int16, np.uint16)
            else np.float64
        )
        values = np.where(valid, values, np.nan).astype(exact)
    return grid.dataarray(values, "raster", units=header.units, notes=[*cells.notes, *cells.said])


def read_variable(
    path: str | os.PathLike[str],
    name: str,
    *,
    bands: Sequence[int] | None = None,
    unreferenced: bool = False,
    remote: bool = False,
) -> xr.DataArray:
    """Read a raster as a variable of the schema, own output or brought along.

    Floats have NaN for "no data", `priority` -inf, classes and counts 0 ("none").

    Parameters
    ----------
    path
        Raster with the right number of bands: 8 for variables with a direction, ordered
        N NE E SE S SW W NW, 1 otherwise. Or one that holds several variables and says so (`variable_bands`).
    name
        Name in `schema.VARIABLES`, for example "spread_probability".
    bands
        Numbers of its bands, from 1, for a raster of several variables that does not say so.
    unreferenced
        Accept a raster without CRS, as written for an artificial forest.
    remote
        As in `read_raster`.

    Returns
    -------
    xarray.DataArray
        Dims and dtype of the schema; `attrs["provenance"]` as written by `write_raster`.

    Raises
    ------
    InputError
        If bands, order of directions, CRS, values or range do not fit the variable.
    """
    file = VariableFile(path, name, bands=bands, unreferenced=unreferenced, remote=remote)
    variable = VARIABLES[name]
    data = file.grid.dataarray(file.read(), name, long_name=variable.text, units=variable.units)
    return data.assign_attrs(provenance=file.provenance) if file.provenance else data


class VariableFile:
    """A variable of the schema in a raster, read as a whole or by windows; parameters and errors as `read_variable`.

    Attributes
    ----------
    grid : Grid
        Of the raster, north up.
    provenance : dict
        As written by `write_raster`.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        name: str,
        *,
        bands: Sequence[int] | None = None,
        unreferenced: bool = False,
        remote: bool = False,
    ) -> None:
        self._variable = VARIABLES[name]
        chosen = _require_bands(path, self._variable, bands, remote)
        self._headers = [read_header(path, band=band, remote=remote) for band in chosen]
        first = self._headers[0]
        if first.crs is not None or not unreferenced:
            require_georeferenced(first)
        self.grid = _grid_north_up(first)
        self.provenance = {key[len(TAG) :].lower(): text for key, text in first.tags.items() if key.startswith(TAG)}

    def read(self, window: Window | None = None) -> np.ndarray:
        """Read the values, (rows, cols), or (directions, rows, cols); of a window of `grid`, if one is given."""
        return read_variables({"": self}, window)[""]

    def part(self, window: Window) -> Grid:
        """Return the grid of a window."""
        from affine import Affine

        row, col, rows, cols = window
        return Grid((rows, cols), self.grid.transform * Affine.translation(col, row), self.grid.crs)


def read_variables(files: Mapping[str, VariableFile], window: Window | None = None) -> dict[str, np.ndarray]:
    """Read variables that lie in one file, each as `VariableFile.read` does; tiles of all bands are decoded once."""
    headers = [header for file in files.values() for header in file._headers]
    where = (0, 0, *headers[0].shape) if window is None else _stored_window(headers[0], window)
    stored = iter(_stored(headers, where))
    made = {}
    for name, file in files.items():
        planes = []
        for header in file._headers:
            stands, valid = next(stored)
            if header.bits:
                stands, header = (
                    unpack(stands, packed(file._variable, header.bits)),
                    replace(header, nodata=(), scale=1.0),
                )
            cells = _settled(header, stands, valid, strict=False, sentinels=False)
            values, valid = (_north_up(header, plane) for plane in (cells.values, cells.valid))
            planes.append(_as_variable(values, valid, file._variable, header.path))
        made[name] = planes[0] if file._variable.dims[0] != "direction" else np.stack(planes)
    return made


def require_role(path: str | os.PathLike[str], name: str, *, known: bool = False, remote: bool = False) -> bool:
    """Refuse a raster that this product wrote as something else.

    Parameters
    ----------
    path
        Any raster.
    name
        What it is taken for, in `schema.VARIABLES`.
    known
        Whether a raster that tells nothing of itself, or something else, is refused, too. Otherwise one of another
        product passes, and for `priority`, which any numbers may be, one of this product.
    remote
        As in `read_raster`.

    Returns
    -------
    bool
        Whether the file was written as `name`.

    Raises
    ------
    InputError
        Saying what it is.
    """
    with open_raster(path, remote=remote) as source:
        role = source.tags(1).get("variable", "") if source.count else ""
    if role == name:
        return True
    what = f"{os.fspath(path)} was written as {VARIABLES[role].text}" if role in VARIABLES else ""
    if known:
        what = what or f"{os.fspath(path)} does not say that it is a {VARIABLES[name].text}"
        raise InputError(f"{what}; if its numbers are to be taken as {name} all the same, say so (--foreign)")
    if what and name != "priority":
        raise InputError(f"{what}, expected {name} ({VARIABLES[name].text}); is it the right file?")
    return False


#: Provenance tags in files begin with this.
TAG = "FIREBREAK_"


def _stored(headers: Sequence[Header], window: Window) -> list[tuple[np.ndarray, np.ndarray]]:
    """Values of bands of one file as they are stored, and where its masks say that there is data."""
    row, col, rows, cols = window
    first = headers[0]
    if first.array is not None:
        part = first.array[row : row + rows, col : col + cols]
        return [(part.copy(), np.ones(part.shape, dtype=bool))]
    from rasterio.errors import NotGeoreferencedWarning, RasterioError
    from rasterio.windows import Window as FileWindow

    where = FileWindow(col, row, cols, rows)
    alike = len({header.dtype for header in headers}) == 1
    with open_raster(first.path, remote=first.remote) as source, warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        try:
            bands = [header.band for header in headers]
            together = source.read(bands, window=where) if alike else [source.read(b, window=where) for b in bands]
            return [
                (
                    values,
                    source.read_masks(header.band, window=where) != 0
                    if header.masked
                    else np.ones(values.shape, dtype=bool),
                )
                for header, values in zip(headers, together, strict=True)
            ]
        except (RasterioError, OSError) as error:
            raise InputError(
                f"{first.path} is damaged or cut off: its values cannot be read; copy or export it again"
            ) from error


def _grid_north_up(header: Header) -> Grid:
    from affine import Affine

    t = header.transform
    if t.b != 0 or t.d != 0:
        raise GridError(f"{header.path} is rotated; turn it first: gdalwarp in.tif out.tif")
    left, _, _, top = header.bounds
    return Grid(header.shape, Affine(abs(t.a), 0.0, left, 0.0, -abs(t.e), top), header.crs)


def _north_up(header: Header, values: np.ndarray) -> np.ndarray:
    if header.transform.a < 0:
        values = values[:, ::-1]
    if header.transform.e > 0:
        values = values[::-1]
    return np.ascontiguousarray(values)


def _stored_window(header: Header, window: Window) -> Window:
    """Where a window of the grid, north up, stands in the file."""
    row, col, rows, cols = window
    if header.transform.a < 0:
        col = header.shape[1] - col - cols
    if header.transform.e > 0:
        row = header.shape[0] - row - rows
    return row, col, rows, cols


def variable_bands(path: str | os.PathLike[str], *, remote: bool = False) -> dict[str, list[int]]:
    """Return which bands of a raster hold which variable of the schema, as far as its bands say so.

    They do in files of `write_raster`; in others by the descriptions that it writes ("N" for the probability to the
    north, "travel_time N", "heat").
    """
    found: dict[str, list[int]] = {}
    with open_raster(path, remote=remote) as source:
        for band, text in enumerate(source.descriptions, start=1):
            name = source.tags(band).get("variable") or _described(text)
            if name in VARIABLES:
                found.setdefault(name, []).append(band)
    return found


def _described(text: str | None) -> str:
    words = (text or "").replace(":", " ").split()
    if len(words) == 1:
        return "spread_probability" if words[0].upper() in DIRECTIONS else words[0].lower()
    return words[0].lower() if len(words) == 2 and words[1].upper() in DIRECTIONS else ""


def _require_bands(
    path: str | os.PathLike[str], variable: Variable, bands: Sequence[int] | None, remote: bool
) -> Sequence[int]:
    name = os.fspath(path)
    expected = len(variable.bands)
    if variable.dims[-2:] != ("y", "x"):
        raise InputError(f"{variable.name} is a table, not a raster; it is written as CSV")
    with open_raster(path, remote=remote) as source:
        count = source.count
        if bands is None and count > expected:
            bands = variable_bands(path, remote=remote).get(variable.name)
        bands = bands or range(1, count + 1)
        if len(bands) != expected:
            more = f" in the order {' '.join(DIRECTIONS)}" if expected > 1 else ""
            raise InputError(
                f"{name} has {len(bands)} bands, expected {expected}{more} for {variable.name} ({variable.text})"
                + ("; firebreak network makes such a file" if variable.name == "spread_probability" else "")
            )
        texts = [str(source.descriptions[band - 1] or "") for band in bands]
        told = [text.split(":")[0].strip().upper().split(" ")[-1] for text in texts]
    if expected > 1 and set(told) == set(DIRECTIONS) and tuple(told) != DIRECTIONS:
        raise InputError(
            f"{name} has its bands in the order {' '.join(told)}, expected {' '.join(DIRECTIONS)}; "
            "reorder them, e.g. with gdal_translate -b"
        )
    return bands


def _as_variable(values: np.ndarray, valid: np.ndarray, variable: Variable, path: str) -> np.ndarray:
    """Bring one band to the type of the variable; refuse what does not fit."""
    inside = values[valid]
    if variable.minimum is not None and inside.size and (low := float(inside.min())) < variable.minimum:
        raise InputError(f"{path} goes down to {low:g}, expected at least {variable.minimum:g} for {variable.name}")
    if variable.maximum is not None and inside.size and (high := float(inside.max())) > variable.maximum:
        raise InputError(f"{path} goes up to {high:g}, expected at most {variable.maximum:g} for {variable.name}")
    kind = np.dtype(variable.dtype)
    if kind.kind == "f":
        missing: Any = -np.inf if variable.name == "priority" else np.nan
        return np.where(valid, values, missing).astype(kind)
    if values.dtype.kind == "f" and not np.array_equal(inside, np.round(inside)):
        raise InputError(f"{path} holds fractions, expected whole numbers for {variable.name} ({variable.text})")
    return np.where(valid, values, 0).astype(kind)
