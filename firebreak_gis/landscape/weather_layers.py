"""Wind and moisture, numbers or rasters on any grid, in any unit, on the grid of a network."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.files.gate import stands
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import align_values
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import Header, file_of, header_of_array, read_header, require_georeferenced
from firebreak_gis.rasters.units import ANGLE, SHARE, SPEED, Quantity, read_number, require_known, told

Source = str | os.PathLike[str] | Any

#: What is believed of rasters; beyond lie flags and other units.
_FASTEST, _WETTEST = 60.0, 1.0


@dataclass(frozen=True)
class WeatherReader:
    """Lays weather on a grid.

    Parameters
    ----------
    grid
        The grid of the network.
    needed
        (rows, cols) bool, where values must be known: the cells with fuel; everywhere if None. Elsewhere, such as on
        the sea, where there is no data 0 is taken.
    account
        Gets sentences on what was done.
    """

    grid: Grid
    needed: np.ndarray | None = None
    account: Account = field(default_factory=Account)

    def wind(self, speed: Source | float, from_direction: Source | float) -> tuple[Any, Any]:
        """Read wind, the direction as a vector: between 350 and 10 degrees lies 0, not 180.

        Parameters
        ----------
        speed, from_direction
            Numbers, in m/s and degrees or with their unit ("20km/h", "4bf"), or rasters, in the unit that they tell,
            else in m/s and degrees; the direction is that from which the wind comes, clockwise from north.

        Returns
        -------
        tuple
            Speed [m/s] and direction [degrees], each a number or (rows, cols) float64.

        Raises
        ------
        InputError
            If a raster lies elsewhere, has gaps where it is needed, an unknown unit, or impossible values.
        """
        hint = "; if it is a component of the wind, give both components (--wind-uv U V)"
        return (
            self._values(speed, "wind speed", SPEED, (0.0, _FASTEST), hint),
            self._direction(from_direction),
        )

    def components(self, u: Source | float, v: Source | float) -> tuple[Any, Any]:
        """Read wind from its components towards the east and the north of the grid; else as `wind`.

        Of rasters in degrees, as of weather services, these are true east and north.
        """
        limits = (-_FASTEST, _FASTEST)
        east, north = (
            self._values(source, f"wind {name}", SPEED, limits)
            for source, name in ((u, "towards east"), (v, "towards north"))
        )
        direction = np.degrees(np.arctan2(-east, -north)) % 360.0
        speed = np.hypot(east, north)
        return (speed, direction) if np.ndim(speed) else (float(speed), float(direction))

    def moisture(self, source: Source | float) -> Any:
        """Read the moisture of the fine dead fuel, a share of its dry weight; numbers and rasters may be in percent."""
        return self._values(source, "moisture", SHARE, (0.0, _WETTEST))

    def _direction(self, source: Source | float) -> Any:
        if (number := measured(source, ANGLE)) is not None:
            return number
        if isinstance(source, np.ndarray):
            return self._whole(self._own(source, "wind direction"), "wind direction")
        header = _header(source, ANGLE)

        def part(function: Any, account: Account) -> np.ndarray:
            def settle(values: np.ndarray) -> np.ndarray:
                degrees = ANGLE.convert(values.astype(np.float64), header.units)
                _require_within(degrees, (-360.0, 360.0), header, "wind direction", ANGLE, "")
                return np.asarray(function(np.radians(degrees)), dtype=np.float32)

            return align_values(header, self.grid, "wind direction", account, settle=settle)

        east, north = part(np.sin, self.account), part(np.cos, Account())
        self._tell(header, "wind direction", ANGLE)
        degrees = np.degrees(np.arctan2(east.astype(np.float64), north.astype(np.float64))) % 360.0
        return self._whole(degrees, "wind direction")

    def _values(
        self, source: Source | float, name: str, quantity: Quantity, limits: tuple[float, float], hint: str = ""
    ) -> Any:
        if (number := measured(source, quantity)) is not None:
            return number
        if isinstance(source, np.ndarray):
            return self._whole(self._own(source, name), name)
        header = _header(source, quantity)

        def settle(values: np.ndarray) -> np.ndarray:
            converted = quantity.convert(values, header.units)
            _require_within(converted, limits, header, name, quantity, hint)
            return np.asarray(converted, dtype=np.float32)

        values = align_values(header, self.grid, name, self.account, settle=settle).astype(np.float64)
        self._tell(header, name, quantity)
        return self._whole(values, name)

    def _own(self, values: np.ndarray, name: str) -> np.ndarray:
        if values.shape != self.grid.shape:
            raise InputError(f"{name} has shape {values.shape}, expected {self.grid.shape}")
        return values.astype(np.float64)

    def _whole(self, values: np.ndarray, name: str) -> np.ndarray:
        gaps = ~np.isfinite(values)
        where = "the landscape" if self.needed is None else "the landscape that hold fuel"
        missing = int(np.count_nonzero(gaps if self.needed is None else gaps & self.needed))
        if missing:
            raise InputError(f"{name} has no data on {missing} cells of {where}; give a raster that covers it")
        if gaps.any():
            self.account.alignment.append(f"{name}: no data on {int(gaps.sum())} cells, none of which holds fuel")
        return np.where(gaps, 0.0, values)

    def _tell(self, header: Header, name: str, quantity: Quantity) -> None:
        unit = told(header.units)
        if unit in ("", "1"):
            self.account.alignment.append(f"{name}: its unit is not stated and was taken as {_spoken(quantity)}")
        elif quantity.convert(1.0, unit) != 1.0:
            self.account.alignment.append(f"{name}: turned from {unit} into {_spoken(quantity)}")


def measured(source: Any, quantity: Quantity) -> float | None:
    """Return a number, with or without a unit, in that of the program; None for what is a raster."""
    if isinstance(source, (str, os.PathLike)) and stands(file_of(os.fspath(source))):
        return None
    if np.ndim(source):
        return None
    number = read_number(source, quantity)
    if number is None and isinstance(source, (str, os.PathLike)):
        raise ParameterError(f"{os.fspath(source)!r} is neither a number nor a raster that exists")
    return number


def _header(source: Source, quantity: Quantity) -> Header:
    as_array: Any = source
    header = header_of_array(as_array) if hasattr(source, "dims") else read_header(source)
    require_georeferenced(header)
    require_known(header.units, quantity, header.path)
    return header


def _require_within(
    values: np.ndarray, limits: tuple[float, float], header: Header, name: str, quantity: Quantity, hint: str
) -> None:
    """Look for flags and wrong units before neighbours are mixed."""
    low, high = limits
    wrong = (values < low) | (values > high)
    if not wrong.any():
        return
    if quantity is SHARE and not (values < low).any():
        raise InputError(
            f"{header.path} holds {name} up to {np.nanmax(values):g}, expected shares of the dry weight (8 % is 0.08); "
            "if it is in percent, set the unit: gdal_edit.py -units % FILE (or -scale 0.01)"
        )
    example = values[wrong].flat[0]
    raise InputError(
        f"{header.path} holds {name} of {example:g} in {int(wrong.sum())} cells, expected {low:g} to {high:g} "
        f"{_spoken(quantity)}; if that means no data, declare it (gdal_edit.py -a_nodata VALUE FILE); if it is in "
        f"another unit, set it (gdal_edit.py -units UNIT FILE){hint}"
    )


def _spoken(quantity: Quantity) -> str:
    return "a share" if quantity is SHARE else quantity.unit
