"""Anything that a user has on the map, a raster on its own grid or a vector, as one plane on the grid of a network."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_values
from firebreak_gis.landscape.layers import elevation_on
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import header_of_array, read_header, require_georeferenced
from firebreak_gis.vectors import is_vector, read_features, read_polygons

if TYPE_CHECKING:
    import geopandas as gpd

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


def elevation_plane(source: Source, grid: Grid, account: Account | None = None) -> np.ndarray:
    """Read elevations onto a grid, in metres, looked at as those of a landscape are.

    Parameters
    ----------
    source
        Raster on any grid (path or DataArray).
    grid
        The grid of the network.
    account
        Gets sentences on what was done.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64, NaN where it has no data.
    """
    return elevation_on(_header(source), grid, Account() if account is None else account).astype(np.float64)


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
