"""Each kind of layer on the grid: elevation in metres, codes for the legends."""

from __future__ import annotations

import numpy as np

from firebreak_gis.errors import InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_classes, align_quantity, align_values
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header
from firebreak_gis.rasters.units import LENGTH, require_known, told

#: Elevations in metres that exist on land; the deepest sea bed.
HIGHEST, LOWEST, DEEPEST = 9000.0, -500.0, -12000.0
#: A lowest value is asked about where nearly all steps up from it are higher than so many metres, and most of them than
#: so many times nearly all other steps from cell to cell: so are voids and collars that are not declared, and no shore.
CLIFF, CLIFF_STEPS = 10.0, 2.0


def elevation_on(header: Header, grid: Grid, account: Account) -> np.ndarray:
    """Elevation on the grid in metres, NaN for no data."""

    def settle(values: np.ndarray) -> np.ndarray:
        return _without_voids(_in_metres(values, header, account), header, account)

    values = align_values(header, grid, "elevation", account, settle=settle)
    if not np.isfinite(values).any():
        raise InputError(f"{header.path} (elevation) holds no data on the grid; is its no-data value the true one?")
    return values


def _in_metres(values: np.ndarray, header: Header, account: Account) -> np.ndarray:
    require_known(header.units, LENGTH, header.path)
    factor = _metres(header)
    if factor != 1:
        account.alignment.append(
            f"elevation: multiplied by {factor:.9g} to get metres from {told(header.units) or 'the unit of its CRS'}"
        )
        return values * np.float32(factor)
    if _silent(header) and "foot" in _unit_of(header):
        account.warn(
            f"elevation: its CRS is in {_unit_of(header)} but its own unit is not stated and was taken "
            "as metres; if it is feet, set it: gdal_edit.py -units ft FILE"
        )
    return values


def _without_voids(values: np.ndarray, header: Header, account: Account) -> np.ndarray:
    """Take out what cannot be ground, and ask about what does not look like it."""
    if not np.isfinite(values).any():
        return values
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if high > HIGHEST or low < DEEPEST:
        raise InputError(
            f"{header.path} has elevations from {low:g} to {high:g} m, expected {DEEPEST:g} to "
            f"{HIGHEST:g}; declare its no-data "
            "value (--src-nodata) or its unit (gdal_edit.py -units ft FILE)"
        )
    deep = values < LOWEST
    if deep.any():
        values = np.where(deep, np.float32(np.nan), values)
        account.warn(
            f"elevation: {int(deep.sum())} cells of it below {LOWEST:g} m were taken as sea bed, without elevation"
        )
    if not header.declared:
        _ask_about_lowest(values, header)
    return values


def _ask_about_lowest(values: np.ndarray, header: Header) -> None:
    """Refuse elevations whose lowest value stands in holes with cliffs all round, until the user says what it is."""
    if not np.isfinite(values).any():
        return
    low = np.nanmin(values)
    up = []
    for one, other in ((values[1:], values[:-1]), (values[:, 1:], values[:, :-1])):
        edge = (one == low) != (other == low)
        up.append(np.abs(one[edge] - other[edge]))
    steps = np.concatenate(up)
    steps = steps[~np.isnan(steps)]
    if not steps.size or float(np.percentile(steps, 5)) <= CLIFF:
        return
    ground = np.where(values == low, np.float32(np.nan), values)
    others = np.concatenate([np.abs(np.diff(ground, axis=axis)).ravel() for axis in (0, 1)])
    others = others[others > 0]
    if others.size and float(np.median(steps)) <= CLIFF_STEPS * float(np.percentile(others, 99)):
        return
    inside = values == low
    above = values[~inside & ~np.isnan(values)]
    stored = (low / _metres(header) - header.offset) / header.scale
    raise InputError(
        f"{header.path} (elevation) is {low:g} m in {int(inside.sum())} cells ({inside.mean():.1%}) with cliffs of "
        f"about {np.median(steps):.0f} m all round, all else is {above.min():g} to {above.max():g} m: it looks like a "
        f"void or a collar. Say what it is: --src-nodata dem={stored:g} if it means no data, --src-nodata dem=none if "
        "it is ground"
    )


def _silent(header: Header) -> bool:
    return told(header.units) in ("", "1")


def _metres(header: Header) -> float:
    """Metres per unit of the elevations: as the band says, else as its CRS says."""
    if _silent(header) and header.vertical is not None:
        return header.vertical
    return float(LENGTH.convert(1.0, header.units))


def _unit_of(header: Header) -> str:
    return "" if header.crs is None else str(header.crs.axis_info[0].unit_name)


def codes_on(header: Header, grid: Grid, name: str, table: Legend, account: Account) -> np.ndarray:
    """Codes as floats (rows, cols), NaN for no data."""
    if table.continuous:
        coded = align_quantity(header, grid, name, account, table.flagged).astype(np.float64)
        _refuse_odd_quantity(coded, header, name, table)
    else:
        codes = align_classes(header, grid, name, account)
        coded = np.where(codes < 0, np.nan, codes)
    if not np.isfinite(coded).any():
        raise InputError(f"{header.path} ({name}) holds no data on the grid; is its no-data value the true one?")
    return coded


def _refuse_odd_quantity(values: np.ndarray, header: Header, name: str, table: Legend) -> None:
    """A cover from 0 to 1 read as percent would be sparse everywhere, without a word; so would a band without cover."""
    present = values[np.isfinite(values) & ~table.flagged(values)]
    if not present.size:
        return
    ranges = [entry for entry in table.entries if entry.low != entry.high]
    low, top = ranges[0].low, max(entry.high for entry in ranges)
    if low == 0 and 50 <= top <= 255 and 0 < present.max() <= 1 and (present != np.round(present)).any():
        raise LegendError(
            f"{header.path} looks like a fraction (0 to 1), the legend {table.name} goes up to {top:g}; "
            "scale it or give a legend for fractions"
        )
    if name == "density" and low == 0 and (present == 0).all():
        raise LegendError(
            f"{header.path} (band {header.band}, {name}) is 0 on all cells: is it an empty band? Give another raster, "
            "or in its place a word: sparse if there is no cover indeed, normal, or continuity; with a landscape file: "
            "firebreak plan FILE sparse"
        )
