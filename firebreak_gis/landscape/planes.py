"""Anything that a user has on the map, a raster on its own grid or a vector, as one plane on the grid of a network."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_values
from firebreak_gis.landscape.layers import elevation_on
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header, header_of_array, read_header, require_georeferenced
from firebreak_gis.vectors import is_vector

Source = str | os.PathLike[str] | Any


def value_plane(
    source: Source,
    grid: Grid,
    *,
    what: str,
    fill: float = np.nan,
    account: Account | None = None,
    settle: Callable[[np.ndarray, Header, Account], np.ndarray] | None = None,
) -> np.ndarray:
    """Read a quantity, such as a cost a hectare, onto a grid, interpolated or averaged.

    Parameters
    ----------
    source
        Raster on any grid (path or DataArray), or an array on this one.
    grid
        The grid of the network.
    what
        Name for messages.
    fill
        Where there is no data.
    account
        Gets sentences on what was done.
    settle
        Settles units and flags before neighbours are mixed, see `alignment.align_values`; also gets the layer and the
        account.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.

    Raises
    ------
    InputError
        If the source cannot be read or lies elsewhere, or holds numbers below 0.
    """
    if isinstance(source, np.ndarray):
        if source.shape != grid.shape:
            raise InputError(f"{what} has shape {source.shape}, expected {grid.shape}")
        return source.astype(np.float64)
    header, account = open_header(source), Account() if account is None else account

    def settled(values: np.ndarray) -> np.ndarray:
        require_not_negative(values, header, what)
        return values if settle is None else settle(values, header, account)

    values = align_values(header, grid, what, account, settle=settled)
    if not np.isfinite(values).any():
        raise InputError(f"{what} holds no data on the landscape {grid.describe()}; is it the right file?")
    return np.asarray(np.where(np.isfinite(values), values, fill), dtype=np.float64)


def require_not_negative(values: np.ndarray, header: Header, what: str) -> None:
    """Refuse numbers below 0, such as flags for "no data", before they are mixed with others.

    Raises
    ------
    InputError
        Saying how to declare them.
    """
    wrong = values < 0
    if wrong.any():
        raise InputError(
            f"{header.path} ({what}) holds {values[wrong].flat[0]:g} in {int(wrong.sum())} cells, expected finite "
            "numbers of at least 0; if that means no data, declare it: gdal_edit.py -a_nodata VALUE FILE"
        )


def ignition_source(source: Source | None, grid: Grid, account: Account | None = None) -> Any:
    """Return what tells where fires start: a raster laid on the grid, anything else as it is.

    Parameters
    ----------
    source
        None, points or polygons, or a raster of weights on any grid.
    grid
        The grid of the network.
    account
        Gets sentences on what was done.

    Returns
    -------
    Any
        (rows, cols) float64 of a raster, 0 where it has no data, which is said.
    """
    is_raster = hasattr(source, "dims") or (isinstance(source, (str, os.PathLike)) and not is_vector(source))
    if not is_raster:
        return source
    account = Account() if account is None else account
    plane = value_plane(source, grid, what="ignitions", account=account)
    if missing := int(np.count_nonzero(np.isnan(plane))):
        account.alignment.append(
            f"ignitions: no data on {missing} cells ({missing * grid.cell_area_ha:,.6g} ha), where no fire starts"
        )
    return np.nan_to_num(plane, nan=0.0)


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
    return elevation_on(open_header(source), grid, Account() if account is None else account).astype(np.float64)


def open_header(source: Source) -> Any:
    """Return the header of a raster, of a file or in memory, that says where it lies."""
    as_array: Any = source
    header = header_of_array(as_array) if hasattr(source, "dims") else read_header(source)
    require_georeferenced(header)
    return header
