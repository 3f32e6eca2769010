"""Landscape files of FlamMap and FARSITE, `.lcp` or GeoTIFF: terrain, fuel models and canopy cover in one file."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import GridError, InputError, LegendError, ParameterError
from firebreak_gis.rasters import open_raster

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np

#: How the bands are described, by GDAL's driver for .lcp and by LANDFIRE: "US_ELEV2020", "LF2024_CC_CONUS".
_BANDS: Mapping[str, re.Pattern[str]] = {
    "elevation": re.compile(r"elev", re.IGNORECASE),
    "vegetation": re.compile(r"fuel model|fbfm", re.IGNORECASE),
    "density": re.compile(r"canopy cov|(?<![a-z])cc(?![a-z])", re.IGNORECASE),
}
#: What a user calls the layers.
_CALLED: Mapping[str, str] = {"elevation": "dem", "vegetation": "vegetation", "density": "density"}
#: Bands of a landscape without names, in the order of FlamMap, and what their values may be.
_IN_ORDER: Mapping[str, tuple[float, float]] = {
    "elevation": (-500.0, 30_000.0),
    "slope": (0.0, 400.0),
    "aspect": (-1.0, 360.0),
    "fuel models": (0.0, 256.0),
    "canopy cover": (0.0, 100.0),
}
#: How many bands a landscape has: with or without crown fuels, and ground fuels.
_COUNTS = (5, 7, 8, 10)
#: Descriptions that say nothing.
_NAMELESS = re.compile(r"^(band[ _]?\d+)?$", re.IGNORECASE)
#: Codes above this one are of Scott and Burgan; those up to it of Anderson, or bare land in both.
_HIGHEST_ANDERSON = 99
#: So many rows and columns of a band are looked at where only its values tell what it is.
_LOOKED_AT = 512
_NO_VALUE = (-9999, 32767, -32768)
#: How far a unit may be from the one that the file claims.
_SAME_UNIT = 0.01
_UNITS = {"meters": 1.0, "feet": 0.3048, "kilometers": 1000.0}


@dataclass(frozen=True)
class LandscapeFile:
    """What a landscape file holds.

    Parameters
    ----------
    bands
        Band of "elevation", "vegetation" (fuel models) and, if there, "density" (canopy cover in percent).
    legend
        Built-in legend for the fuel models.
    told
        Sentence on how the bands are called, and on what was not found.
    """

    bands: Mapping[str, int]
    legend: str
    told: str


def read_landscape_file(
    path: str | os.PathLike[str],
    *,
    band: Mapping[str, int] | None = None,
    legend: str | None = None,
    remote: bool = False,
) -> LandscapeFile:
    """Find the layers in a landscape file.

    Parameters
    ----------
    path
        A `.lcp`, or another raster whose bands are described as in one; or a GeoTIFF with as many bands as a landscape
        of FlamMap, in its order, and no descriptions.
    band
        Bands that the user chose, by "dem", "vegetation" and "density".
    legend
        Legend that the user chose: of two bands of fuel models that for which it is made is taken.
    remote
        As in `rasters.read_header`.

    Raises
    ------
    InputError
        If bands for elevation and fuel models cannot be told, the canopy cover is in categories, or the unit of
        lengths contradicts the CRS.
    """
    if not isinstance(path, str | os.PathLike):
        raise ParameterError("vegetation may only be left out where dem is the path of a landscape file (.lcp)")
    name = os.fspath(path)
    with open_raster(name, remote=remote) as source:
        names = [text or "" for text in source.descriptions]
        nameless = all(_NAMELESS.match(text) for text in names)
        found = _by_order(source, name) if nameless else _by_name(names, legend)
        bands = {**found, **{layer: [(band or {})[key]] for layer, key in _CALLED.items() if key in (band or {})}}
        if any(len(bands[layer]) != 1 for layer in ("elevation", "vegetation")) or len(bands["density"]) > 1:
            told = ", ".join(f"{number} {text or '?'}" for number, text in enumerate(names, start=1))
            raise InputError(
                f"VEGETATION is left out, but {name} is no FlamMap landscape with one band for elevation and one for "
                f"fuel models (bands: {told}); choose bands (--bidx vegetation=NUMBER), or give VEGETATION too"
            )
        chosen = {layer: numbers[0] for layer, numbers in bands.items() if numbers}
        _require_unit(source, name)
        cover = source.tags(chosen["density"]).get("CANOPY_COV_UNIT_NAME", "") if "density" in chosen else ""
        if cover.lower().startswith("categor"):
            raise LegendError(
                f"{name} holds the canopy cover in categories, expected percent; give the layers one by one, with "
                f"their bands (--bidx dem={chosen['elevation']} ...) and a density legend for the categories"
            )
        fuels = _legend_for(source, chosen["vegetation"])
    if nameless:
        told = "its bands have no names and were taken in the order of FlamMap"
    else:
        told = "its bands are " + ", ".join(f"{number} {text or '?'}" for number, text in enumerate(names, start=1))
    if "density" not in chosen:
        told += "; none of them is a canopy cover"
    return LandscapeFile(chosen, fuels, told)


def _by_name(names: list[str], legend: str | None) -> dict[str, list[int]]:
    bands = {
        layer: [band for band, text in enumerate(names, start=1) if pattern.search(text)]
        for layer, pattern in _BANDS.items()
    }
    fitting = [band for band in bands["vegetation"] if _legend_by_name(names[band - 1]) == legend]
    return bands | ({"vegetation": fitting} if fitting else {})


def _by_order(source: Any, name: str) -> dict[str, list[int]]:
    if source.count not in _COUNTS:
        return {layer: [] for layer in _BANDS}
    for band, (what, (low, high)) in enumerate(_IN_ORDER.items(), start=1):
        values = _look_at(source, band)
        if values.size and not (low <= values.min() and values.max() <= high):
            raise InputError(
                f"VEGETATION is left out, and the {source.count} bands of {name} have no names; in the order of FlamMap"
                f" band {band} would be {what}, but its values go from {values.min():g} to {values.max():g}, expected "
                f"{low:g} to {high:g}; choose bands (--bidx dem=1 --bidx vegetation=4 ...), or give VEGETATION too"
            )
    return {"elevation": [1], "vegetation": [4], "density": [5]}


def _look_at(source: Any, band: int) -> np.ndarray:
    """Some values of a band, those that stand for no data left out."""
    import numpy as np

    shape = (min(source.height, _LOOKED_AT), min(source.width, _LOOKED_AT))
    values = source.read(band, out_shape=shape, masked=True).compressed()
    return np.asarray(values[~np.isin(values, _NO_VALUE) & np.isfinite(values)])


def _legend_by_name(text: str) -> str | None:
    """Legend that the name of a band of fuel models tells: FBFM13 is Anderson's, FBFM40 that of Scott and Burgan."""
    number = re.search(r"fbfm_?(13|40)", text, re.IGNORECASE)
    return None if number is None else {"13": "anderson_13", "40": "scott_burgan_40"}[number[1]]


def _legend_for(source: Any, band: int) -> str:
    """Legend for a band of fuel models: by its name, else by the highest code in the header, else by its values."""
    if by_name := _legend_by_name(source.descriptions[band - 1] or ""):
        return by_name
    told = source.tags(band).get("FUEL_MODEL_MAX", "")
    if told.lstrip("-").isdigit():
        highest = int(told)
    else:
        highest = int(_look_at(source, band).max(initial=0))
    return "anderson_13" if 0 < highest <= _HIGHEST_ANDERSON else "scott_burgan_40"


def _require_unit(source: Any, name: str) -> None:
    """The header of a .lcp tells the unit of lengths, and so does the .prj beside it."""
    word = str(source.tags().get("LINEAR_UNIT", "")).lower()
    if source.driver != "LCP" or source.crs is None or not source.crs.is_projected or word not in _UNITS:
        return
    factor = float(source.crs.linear_units_factor[1])
    if abs(factor / _UNITS[word] - 1) > _SAME_UNIT:
        raise GridError(
            f"{name} says that its lengths are in {word}, its .prj says {source.crs.linear_units}; "
            "correct the one that is wrong, e.g. write the true CRS into the .prj"
        )
