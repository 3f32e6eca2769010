"""Each kind of layer on the grid: elevation in metres, codes for the legends."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from firebreak_gis.errors import InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_classes, align_quantity, align_values
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header
from firebreak_gis.rasters.units import LENGTH, require_known, told

#: Gives the values of a layer in strips of rows from the north, each time it is called.
Strips = Callable[[], Iterable[np.ndarray]]
#: Elevations in metres that exist on land; the deepest sea bed.
HIGHEST, LOWEST, DEEPEST = 9000.0, -500.0, -12000.0
#: A lowest value is asked about where nearly all steps up from it are higher than so many metres, and most of them than
#: so many times nearly all other steps from cell to cell: so are voids and collars that are not declared, and no shore.
CLIFF, CLIFF_STEPS, OUTLYING = 10.0, 2.0, 0.01


def elevation_on(header: Header, grid: Grid, account: Account) -> np.ndarray:
    """Elevation on the grid in metres, NaN for no data."""

    def settle(values: np.ndarray) -> np.ndarray:
        look_at_elevations(lambda: [values], header, account)
        return _on_land(values, header)

    values = align_values(header, grid, "elevation", account, settle=settle)
    require_some(np.isfinite(values).any(), header, "elevation")
    return values


def part_of_elevation(header: Header, part: Grid, account: Account) -> np.ndarray:
    """Elevation on a part of the grid, of a layer that has been looked at."""
    return align_values(header, part, "elevation", account, settle=lambda values: _on_land(values, header))


def require_some(known: Any, header: Header, name: str) -> None:
    """Refuse a layer that holds no data."""
    if not known:
        raise InputError(f"{header.path} ({name}) holds no data on the grid; is its no-data value the true one?")


def _on_land(values: np.ndarray, header: Header) -> np.ndarray:
    """Metres, and NaN on the sea bed."""
    values = _in_metres(values, header)
    with np.errstate(invalid="ignore"):
        deep = values < LOWEST
    return np.where(deep, np.float32(np.nan), values) if deep.any() else values


def _in_metres(values: np.ndarray, header: Header) -> np.ndarray:
    factor = _metres(header)
    return values if factor == 1 else values * np.float32(factor)


def look_at_elevations(strips: Strips, header: Header, account: Account) -> None:
    """Refuse what cannot be ground, ask about what does not look like it, and say what is done.

    Parameters
    ----------
    strips
        Gives the values as they are stored, NaN for no data, in strips of rows, each time it is called.
    header, account
        Of the layer.
    """
    require_known(header.units, LENGTH, header.path)
    factor = _metres(header)
    if factor != 1:
        account.alignment.append(
            f"elevation: multiplied by {factor:.9g} to get metres from {told(header.units) or 'the unit of its CRS'}"
        )
    elif _silent(header) and "foot" in _unit_of(header):
        account.warn(
            f"elevation: its CRS is in {_unit_of(header)} but its own unit is not stated and was taken "
            "as metres; if it is feet, set it: gdal_edit.py -units ft FILE"
        )
    low, high, deep = np.inf, -np.inf, 0
    for stored in strips():
        values = _in_metres(stored, header)
        if np.isfinite(values).any():
            low, high = min(low, float(np.nanmin(values))), max(high, float(np.nanmax(values)))
            deep += int(np.count_nonzero(values < LOWEST))
    if low > high:
        return
    if high > HIGHEST or low < DEEPEST:
        raise InputError(
            f"{header.path} has elevations from {low:g} to {high:g} m, expected {DEEPEST:g} to "
            f"{HIGHEST:g}; declare its no-data "
            "value (--src-nodata) or its unit (gdal_edit.py -units ft FILE)"
        )
    if deep:
        account.warn(f"elevation: {deep} cells of it below {LOWEST:g} m were taken as sea bed, without elevation")
    if not header.declared:
        _ask_about_lowest(lambda: (_on_land(stored, header) for stored in strips()), header)


def _ask_about_lowest(strips: Strips, header: Header) -> None:
    """Refuse elevations whose lowest value stands in holes with cliffs all round, until the user says what it is."""
    ranges = [(np.nanmin(part), np.nanmax(part)) for part in strips() if np.isfinite(part).any()]
    if not ranges:
        return
    low = min(least for least, _ in ranges)
    found = [np.abs(one - other)[(one == low) != (other == low)] for one, other in _neighbours(strips)]
    steps = np.concatenate(found)
    steps = steps[~np.isnan(steps)]
    if not steps.size or float(np.percentile(steps, 5)) <= CLIFF:
        return
    most, others, high = float(np.median(steps)) / CLIFF_STEPS, 0, 0
    for one, other in _neighbours(strips):
        step = np.abs(one - other)[(one != low) & (other != low)]
        others += int(np.count_nonzero(step > 0))
        high += int(np.count_nonzero(step >= most))
    if high > OUTLYING * others:
        return
    inside, cells, least = 0, 0, np.inf
    for part in strips():
        cells += part.size
        inside += int(np.count_nonzero(part == low))
        above = part[part > low]
        least = min(least, float(above.min())) if above.size else least
    stored = (low / _metres(header) - header.offset) / header.scale
    raise InputError(
        f"{header.path} (elevation) is {low:g} m in {inside} cells ({inside / cells:.1%}) with cliffs of "
        f"about {np.median(steps):.0f} m all round, all else is {least:g} to {max(top for _, top in ranges):g} m: it "
        f"looks like a void or a collar. Say what it is: --src-nodata dem={stored:g} if it means no data, "
        "--src-nodata dem=none if it is ground"
    )


def _neighbours(strips: Strips) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Values of cells and of those south and west of them, strip by strip."""
    last: np.ndarray | None = None
    for part in strips():
        joined = part if last is None else np.concatenate([last, part])
        yield joined[1:], joined[:-1]
        yield part[:, 1:], part[:, :-1]
        last = part[-1:]


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
    coded, seen = part_of_codes(header, grid, name, table, account), Seen()
    seen.add(coded, table)
    seen.require(header, name, table)
    return coded


def part_of_codes(header: Header, grid: Grid, name: str, table: Legend, account: Account) -> np.ndarray:
    """Codes on a grid or a part of it, not looked at."""
    if table.continuous:
        return align_quantity(header, grid, name, account, table.flagged).astype(np.float64)
    codes = align_classes(header, grid, name, account)
    return np.where(codes < 0, np.nan, codes)


@dataclass
class Seen:
    """What is asked of the codes of a whole layer, gathered part by part.

    Parameters
    ----------
    some, quantities, fractions
        Whether any code is known, any is an amount of the quantity, any such is no whole number.
    greatest, least
        Of those amounts, and 0.
    """

    some: bool = False
    quantities: bool = False
    fractions: bool = False
    greatest: float = 0.0
    least: float = 0.0

    def add(self, codes: np.ndarray, table: Legend) -> None:
        """Look at a part, as `codes_on` returns it."""
        known = np.isfinite(codes)
        self.some |= bool(known.any())
        if not table.continuous:
            return
        present = codes[known & ~table.flagged(codes)]
        if present.size:
            self.quantities = True
            self.fractions |= bool((present != np.round(present)).any())
            self.greatest = max(self.greatest, float(present.max()))
            self.least = min(self.least, float(present.min()))

    def join(self, other: Seen) -> None:
        """Add what was seen of other parts."""
        self.some |= other.some
        self.quantities |= other.quantities
        self.fractions |= other.fractions
        self.greatest, self.least = max(self.greatest, other.greatest), min(self.least, other.least)

    def require(self, header: Header, name: str, table: Legend) -> None:
        """A cover from 0 to 1 read as percent would be sparse everywhere, without a word; so would an empty band."""
        require_some(self.some, header, name)
        if not self.quantities:
            return
        ranges = [entry for entry in table.entries if entry.low != entry.high]
        low, top = ranges[0].low, max(entry.high for entry in ranges)
        if low == 0 and 50 <= top <= 255 and 0 < self.greatest <= 1 and self.fractions:
            raise LegendError(
                f"{header.path} looks like a fraction (0 to 1), the legend {table.name} goes up to {top:g}; "
                "scale it or give a legend for fractions"
            )
        if name == "density" and low == 0 and self.least == self.greatest == 0:
            raise LegendError(
                f"{header.path} (band {header.band}, {name}) is 0 on all cells: is it an empty band? Give another "
                "raster, or in its place a word: sparse if there is no cover indeed, normal, or continuity; with a "
                "landscape file: firebreak plan FILE sparse"
            )
