"""Anything that a user has on the map, a raster on its own grid or a vector, as one plane on the grid of a network."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_values
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import header_of_array, read_header, require_georeferenced
from firebreak_gis.vectors import is_vector, read_features, read_polygons

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

Source = str | os.PathLike[str] | Any


def value_plane(source: Source, grid: Grid, *, what: str, field: str | None = None, fill: float = 0.0) -> np.ndarray:
    """Read a quantity, such as a cost or a value at risk, onto a grid.

    Parameters
    ----------
    source
        Raster (path or DataArray), interpolated or averaged onto the grid; or polygons (path, GeoDataFrame), of which
        each cell whose centre lies inside takes the number in `field`, the last one where they overlap.
    grid
        The grid of the network.
    what
        Name for messages.
    field
        Column of the polygons; 1 inside if not given.
    fill
        Where there is no data.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.

    Raises
    ------
    InputError
        If the source cannot be read or lies elsewhere, or `field` is missing or holds no numbers.
    """
    if is_vector(source):
        return _burn_in(read_polygons(source, grid.crs), grid, what, field, fill, all_touched=False)
    values = _raster(source, grid, what)
    if not np.isfinite(values).any():
        raise InputError(f"{what} holds no data on the landscape {grid.describe()}; is it the right file?")
    return np.asarray(np.where(np.isfinite(values), values, fill))


def mask_plane(source: Source, grid: Grid, *, what: str, touched: bool = False) -> np.ndarray:
    """Read an area or lines as a mask on a grid.

    Parameters
    ----------
    source
        Raster, true where above 0; or polygons or lines. Lines always take every cell that they touch, since fire
        passes between the corners of a thinner line.
    grid
        The grid of the network.
    what
        Name for messages.
    touched
        Whether polygons also take every cell that they touch, rather than those whose centre they hold.

    Returns
    -------
    numpy.ndarray
        (rows, cols) bool.
    """
    if not is_vector(source):
        return np.asarray(np.nan_to_num(_raster(source, grid, what)) > 0)
    frame = read_features(source, grid.crs)
    is_line = ~frame.geometry.geom_type.str.contains("Polygon")
    mask = np.zeros(grid.shape, dtype=bool)
    for part, everything in ((frame[is_line], True), (frame[~is_line], touched)):
        if len(part):
            mask |= _burn_in(part, grid, what, None, 0.0, all_touched=everything) > 0
    if not mask.any():
        raise InputError(f"{what} does not touch the landscape {grid.describe()}; is it the right file?")
    return mask


def wind_planes(speed: Source | float, from_direction: Source | float, grid: Grid) -> tuple[Any, Any]:
    """Read wind onto a grid, the direction as a vector: between 350 and 10 degrees lies 0, not 180.

    Parameters
    ----------
    speed, from_direction
        Numbers or rasters [m/s; degrees clockwise from north, where the wind comes from].
    grid
        The grid of the network.

    Returns
    -------
    tuple
        Speed and direction, each a number or (rows, cols) float64.
    """
    if _number(speed) is not None and _number(from_direction) is not None:
        return _number(speed), _number(from_direction)
    strength: Any = _number(speed)
    if strength is None:
        strength = value_plane(speed, grid, what="wind speed", fill=np.nan)
    direction: Any = _number(from_direction)
    if direction is None:
        header = _header(from_direction)
        angle = np.radians(_whole(header))
        east, north = (_aligned(header, np.asarray(f(angle)), grid, "wind direction") for f in (np.sin, np.cos))
        direction = np.degrees(np.arctan2(east, north)) % 360.0
    _require_whole("wind speed", strength)
    _require_whole("wind direction", direction)
    return strength, direction


def ignition_source(source: Source | None, grid: Grid) -> Any:
    """Return what tells where fires start: a raster laid on the grid, anything else as it is.

    Parameters
    ----------
    source
        None, points (path of a vector file), or a raster of weights on any grid.
    grid
        The grid of the network.
    """
    if source is None or is_vector(source):
        return source
    return value_plane(source, grid, what="ignitions")


def moisture_plane(source: Source | float, grid: Grid) -> Any:
    """Read the moisture of the fine dead fuel, a share of its dry weight, onto a grid.

    Parameters
    ----------
    source
        A number or a raster.
    grid
        The grid of the network.

    Returns
    -------
    float or numpy.ndarray
        The number, or (rows, cols) float64.
    """
    if (number := _number(source)) is not None:
        return number
    plane = value_plane(source, grid, what="moisture", fill=np.nan)
    _require_whole("moisture", plane)
    if plane.max() > 1:
        raise InputError(
            f"{source} holds moisture up to {plane.max():g}, expected shares of the dry weight (8 % is 0.08); "
            "if it is in percent, set the scale: gdal_edit.py -scale 0.01 FILE"
        )
    return plane


def _require_whole(name: str, plane: Any) -> None:
    missing = int(np.count_nonzero(~np.isfinite(plane)))
    if missing:
        raise InputError(f"{name} has no data on {missing} cells of the landscape; give a raster that covers it")


def _number(value: Any) -> float | None:
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


def _header(source: Source) -> Any:
    as_array: Any = source
    header = header_of_array(as_array) if hasattr(source, "dims") else read_header(source)
    require_georeferenced(header)
    return header


def _raster(source: Source, grid: Grid, what: str) -> np.ndarray:
    if isinstance(source, np.ndarray):
        if source.shape != grid.shape:
            raise InputError(f"{what} has shape {source.shape}, expected {grid.shape}")
        return source.astype(np.float64)
    return align_values(_header(source), grid, what, Account()).astype(np.float64)


def _whole(header: Any) -> np.ndarray:
    """All values of a raster, NaN where it has none."""
    from firebreak_gis.rasters import read_cells

    cells = read_cells(header)
    return np.where(cells.valid, cells.values, np.nan)


def _aligned(header: Any, values: np.ndarray, grid: Grid, what: str) -> np.ndarray:
    source: xr.DataArray = Grid(header.shape, header.transform, header.crs).dataarray(values, what.replace(" ", "_"))
    return align_values(header_of_array(source), grid, what, Account()).astype(np.float64)


def _burn_in(
    frame: gpd.GeoDataFrame, grid: Grid, what: str, field: str | None, fill: float, *, all_touched: bool
) -> np.ndarray:
    from rasterio.features import rasterize

    numbers = np.ones(len(frame))
    if field is not None:
        if field not in frame.columns:
            names = ", ".join(c for c in frame.columns if c != frame.geometry.name)
            raise ParameterError(f"{what} has no field {field!r}; it has: {names or 'none'}")
        import pandas as pd

        numbers = pd.to_numeric(frame[field], errors="coerce").to_numpy(dtype=np.float64)
        if np.isnan(numbers).any():
            raise InputError(f"{what}: the field {field!r} holds empty cells or words, expected numbers")
    return np.asarray(
        rasterize(
            zip(frame.geometry, numbers, strict=True),
            out_shape=grid.shape,
            transform=grid.transform,
            fill=fill,
            all_touched=all_touched,
            dtype="float64",
        )
    )
