"""Each kind of layer on the grid: elevation in metres, codes for the legends."""

from __future__ import annotations

import numpy as np

from firebreak_gis.errors import InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_classes, align_values
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header
from firebreak_gis.rasters.units import LENGTH, require_known, told

#: Elevations in metres that exist on land; the deepest sea bed.
HIGHEST, LOWEST, DEEPEST = 9000.0, -500.0, -12000.0


def elevation_on(header: Header, grid: Grid, account: Account) -> np.ndarray:
    """Elevation on the grid in metres, NaN for no data."""
    values = align_values(header, grid, "elevation", account)
    require_known(header.units, LENGTH, header.path)
    silent = told(header.units) in ("", "1")
    factor = header.vertical if silent and header.vertical is not None else LENGTH.convert(1.0, header.units)
    if factor != 1:
        values *= np.float32(factor)
        account.alignment.append(
            f"elevation: multiplied by {factor:.9g} to get metres from {told(header.units) or 'the unit of its CRS'}"
        )
    elif silent and "foot" in _unit_of(header):
        account.warn(
            f"elevation: its CRS is in {_unit_of(header)} but its own unit is not stated and was taken "
            "as metres; if it is feet, set it: gdal_edit.py -units ft FILE"
        )
    if not np.isfinite(values).any():
        raise InputError(f"{header.path} (elevation) holds no data on the grid; is its no-data value the true one?")
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if high > HIGHEST or low < DEEPEST:
        raise InputError(
            f"{header.path} has elevations from {low:g} to {high:g} m, expected {DEEPEST:g} to "
            f"{HIGHEST:g}; declare its no-data "
            "value (--src-nodata) or its unit (gdal_edit.py -units ft FILE)"
        )
    deep = values < LOWEST
    if deep.any():
        values[deep] = np.nan
        account.warn(f"elevation: {int(deep.sum())} cells below {LOWEST:g} m were taken as sea bed, without elevation")
    return values


def _unit_of(header: Header) -> str:
    return "" if header.crs is None else str(header.crs.axis_info[0].unit_name)


def codes_on(header: Header, grid: Grid, name: str, table: Legend, account: Account) -> np.ndarray:
    """Codes as floats (rows, cols), NaN for no data."""
    if table.continuous:
        values = align_values(header, grid, name, account)
        _refuse_fractions(values, header, table)
        coded = values.astype(np.float64)
    else:
        codes = align_classes(header, grid, name, account)
        coded = np.where(codes < 0, np.nan, codes)
    if not np.isfinite(coded).any():
        raise InputError(f"{header.path} ({name}) holds no data on the grid; is its no-data value the true one?")
    return coded


def _refuse_fractions(values: np.ndarray, header: Header, table: Legend) -> None:
    """A cover from 0 to 1 read as percent would be sparse everywhere, without a word."""
    present = values[np.isfinite(values)]
    low, top = table.entries[0].low, max(entry.high for entry in table.entries)
    percent = low == 0 and 50 <= top <= 255
    if percent and present.size and 0 < present.max() <= 1 and (present != np.round(present)).any():
        raise LegendError(
            f"{header.path} looks like a fraction (0 to 1), the legend {table.name} goes up to {top:g}; "
            "scale it or give a legend for fractions"
        )
