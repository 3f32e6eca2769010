"""Values at risk and costs of any raster or vector on the grid: sums are kept, what is missing is said."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_amounts
from firebreak_gis.landscape.footprints import Footprints, footprints
from firebreak_gis.landscape.planes import Source, open_header, require_not_negative, value_plane
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header
from firebreak_gis.rasters.units import per_hectare, told
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import geopandas as gpd

#: What the numbers of values at risk count: so much in each cell or polygon, or so much a hectare.
ValuesAs = Literal["amount", "density"]


def value_at_risk(
    source: Source,
    grid: Grid,
    *,
    field: str | None = None,
    values_as: ValuesAs = "amount",
    account: Account | None = None,
) -> np.ndarray:
    """Read values at risk onto a grid, so much in each cell of it; where nothing is told, nothing is at risk.

    Parameters
    ----------
    source
        Raster on any grid; or polygons or points (path, GeoDataFrame) whose number stands in `field`, 1 without one.
    grid
        The grid of the network.
    field
        Column of the polygons or points.
    values_as
        `"amount"`: so much in each cell of the raster, polygon or point, such as people. It is shared out by area, so
        that the sum stays the same whatever the cells. `"density"`: so much a hectare. Polygons that overlap add up.
    account
        Gets sentences on what was done, the total among them.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.

    Raises
    ------
    InputError
        If the source cannot be read or lies elsewhere, or the field holds no numbers.
    ParameterError
        If there is no such field, or `values_as` is neither.
    """
    account = Account() if account is None else account
    if values_as not in ("amount", "density"):
        raise ParameterError(f"values are taken as {values_as!r}, expected amount or density")
    if is_vector(source):
        return _drawn(source, grid, field, values_as, account)
    _require_no_field(source, field, "values")
    if values_as == "amount":
        header = open_header(source)
        plane = align_amounts(header, grid, "values", account, settle=lambda values: _counted(values, header))
        _tell_total(plane, "amounts, so much in each cell of the raster", grid, account)
        return plane
    density = value_plane(source, grid, what="values", account=account, settle=_a_hectare)
    missing = int(np.count_nonzero(np.isnan(density)))
    if missing:
        account.alignment.append(
            f"values: no data on {missing} cells ({missing * grid.cell_area_ha:,.6g} ha), counted as 0"
        )
    plane = np.where(np.isnan(density), 0.0, density) * grid.cell_area_ha
    _tell_total(plane, "densities, so much a hectare", grid, account)
    return plane


def cost_per_hectare(
    source: Source | None,
    grid: Grid,
    *,
    field: str | None = None,
    default: float | None = None,
    account: Account | None = None,
) -> np.ndarray:
    """Read what cutting a hectare costs onto a grid; NaN where it is not told and there is no `default`.

    Parameters
    ----------
    source
        Raster on any grid, interpolated or averaged; or polygons, of which each cell whose centre lies inside takes
        the number in `field`, the last one where they overlap. None tells nothing.
    grid
        The grid of the network.
    field
        Column of the polygons.
    default
        Cost a hectare where the source tells nothing.
    account
        Gets sentences on what was done.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64.

    Raises
    ------
    InputError, ParameterError
        As `value_at_risk`; or if `default` is no finite number of at least 0.
    """
    account = Account() if account is None else account
    if default is not None and not (np.isfinite(default) and default >= 0):
        raise ParameterError(f"the cost where none is known is {default}, expected a number of at least 0")
    if source is None:
        plane = np.full(grid.shape, np.nan)
    elif is_vector(source):
        if field is None:
            raise ParameterError("cost polygons need the column that holds the cost a hectare; name it (--cost-field)")
        plane = _priced(source, grid, field, account)
    else:
        _require_no_field(source, field, "cost")
        plane = value_plane(source, grid, what="cost", account=account, settle=_a_hectare)
    if default is not None:
        missing = int(np.count_nonzero(np.isnan(plane)))
        if missing:
            account.alignment.append(
                f"cost: told nowhere on {missing} cells ({missing * grid.cell_area_ha:,.6g} ha), taken as {default:g} "
                "a hectare, as asked"
            )
        plane = np.where(np.isnan(plane), default, plane)
    return plane


def _require_no_field(source: Source, field: str | None, what: str) -> None:
    if field is not None:
        raise ParameterError(f"{what}: {source} is a raster and has no columns; leave --{what}-field out")


def numbers_of(frame: gpd.GeoDataFrame, field: str | None, what: str) -> np.ndarray:
    """Return the numbers in a column of a vector file, (features,) float64; 1 each without a column.

    Raises
    ------
    ParameterError
        If there is no such column.
    InputError
        If it holds anything else than finite numbers.
    """
    if field is None:
        return np.ones(len(frame))
    if field not in frame.columns:
        names = ", ".join(c for c in frame.columns if c != frame.geometry.name)
        raise ParameterError(f"{what} has no field {field!r}; it has: {names or 'none'}")
    import pandas as pd

    numbers = pd.to_numeric(frame[field], errors="coerce").to_numpy(dtype=np.float64)
    if not np.isfinite(numbers).all():
        wrong = int(np.count_nonzero(~np.isfinite(numbers)))
        raise InputError(
            f"{what}: the field {field!r} holds empty cells, words or infinite numbers in {wrong} of {len(frame)} "
            "features, expected numbers"
        )
    return np.asarray(numbers)


def _counted(amounts: np.ndarray, header: Header) -> np.ndarray:
    """Amounts as they are, if they can be: in no unit of an area."""
    require_not_negative(amounts, header, "values")
    if per_hectare(header.units) is not None:
        raise InputError(
            f"{header.path} is in {header.units!r}, so much for an area and not in each cell; take it so "
            "(--values-as density)"
        )
    return amounts


def _a_hectare(values: np.ndarray, header: Header, account: Account) -> np.ndarray:
    """Turn so much for an area into so much for a hectare."""
    unit = told(header.units)
    if unit in ("", "1"):
        return values
    factor = per_hectare(unit)
    if factor is None:
        raise InputError(
            f"{header.path} is in {unit!r}, expected so much for an area, such as EUR/ha, EUR/m2, EUR/km2 or EUR/acre; "
            "if it is so much for a hectare, say so: gdal_edit.py -units 1/ha FILE"
        )
    if factor != 1.0:
        account.alignment.append(f"{header.path}: multiplied by {factor:.6g} to turn {unit} into so much for a hectare")
    return np.asarray(values * values.dtype.type(factor))


def _drawn(source: Source, grid: Grid, field: str | None, values_as: ValuesAs, account: Account) -> np.ndarray:
    from firebreak_gis.vectors import read_starts

    frame = read_starts(source, grid.crs, explode=False)
    account.alignment.extend(f"values: {note}" for note in frame.attrs["notes"])
    is_point = frame.geometry.geom_type.str.contains("Point").to_numpy()
    if values_as == "density" and is_point.any():
        raise InputError("values at points are amounts, since a point has no hectares; leave --values-as density out")
    numbers = numbers_of(frame, field, "values")
    prints = footprints(frame, grid)
    if not prints.cell.size:
        raise InputError(f"values does not touch the landscape {grid.describe()}; is it the right file?")
    share = _shares(prints) if values_as == "amount" else prints.part * grid.cell_area_ha
    plane = np.bincount(prints.cell, weights=numbers[prints.feature] * share, minlength=grid.shape[0] * grid.shape[1])
    told = "amounts, shared out by area" if values_as == "amount" else "densities, so much a hectare"
    outside = len(frame) - np.unique(prints.feature).size
    if values_as == "amount":
        told += f", of {numbers.sum():,.10g} in the file"
    if outside:
        told += f"; {outside} of {len(frame)} features lie outside"
    _tell_total(plane, told, grid, account)
    return plane.reshape(grid.shape)


def _shares(prints: Footprints) -> np.ndarray:
    """Share of its feature that each cell has; they add up to 1 for a feature that lies inside."""
    found = np.bincount(prints.feature, weights=prints.part, minlength=prints.whole.size)
    whole = np.where(np.abs(found - prints.whole) <= 1e-6 * prints.whole, found, prints.whole)
    return np.asarray(prints.part / whole[prints.feature])


def _priced(source: Source, grid: Grid, field: str, account: Account) -> np.ndarray:
    from rasterio.features import rasterize

    from firebreak_gis.vectors import read_polygons

    frame = read_polygons(source, grid.crs)
    account.alignment.extend(f"cost: {note}" for note in frame.attrs["notes"])
    numbers = numbers_of(frame, field, "cost")
    which = rasterize(
        zip(frame.geometry, range(1, len(frame) + 1), strict=True),
        out_shape=grid.shape,
        transform=grid.transform,
        dtype="int32",
    )
    touching = np.unique(footprints(frame, grid).feature)
    if not touching.size:
        raise InputError(f"cost does not touch the landscape {grid.describe()}; is it the right file?")
    lost = np.setdiff1d(touching, which[which > 0] - 1)
    if lost.size:
        account.warn(f"cost: {lost.size} of {len(frame)} polygons hold no centre of a cell and do not count")
    account.alignment.append(f"cost: of {touching.size} polygons, each cell takes the one in which its centre lies")
    return np.asarray(np.concatenate(([np.nan], numbers))[which])


def _tell_total(plane: np.ndarray, told: str, grid: Grid, account: Account) -> None:
    account.alignment.append(f"values: {plane.sum():,.10g} in all on the landscape {grid.describe()}, taken as {told}")
