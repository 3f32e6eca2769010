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

#: How the bands are described, by GDAL's driver for .lcp and by LANDFIRE.
_BANDS: Mapping[str, re.Pattern[str]] = {
    "elevation": re.compile(r"elev", re.IGNORECASE),
    "vegetation": re.compile(r"fuel model|fbfm", re.IGNORECASE),
    "density": re.compile(r"canopy cov|cc\d*$", re.IGNORECASE),
}
#: Codes above this one are of Scott and Burgan; those up to it of Anderson, or bare land in both.
_HIGHEST_ANDERSON = 99
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
    """

    bands: Mapping[str, int]
    legend: str


def read_landscape_file(path: str | os.PathLike[str], *, remote: bool = False) -> LandscapeFile:
    """Find the layers in a landscape file.

    Parameters
    ----------
    path
        A `.lcp`, or another raster whose bands are described as in one.
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
        bands = {
            layer: [band for band, text in enumerate(source.descriptions, start=1) if text and pattern.search(text)]
            for layer, pattern in _BANDS.items()
        }
        if any(len(bands[layer]) != 1 for layer in ("elevation", "vegetation")) or len(bands["density"]) > 1:
            told = ", ".join(f"{band} {text or '?'}" for band, text in enumerate(source.descriptions, start=1))
            raise InputError(
                f"VEGETATION is left out, but {name} is no FlamMap landscape with one band for elevation and one for "
                f"fuel models (bands: {told}); give VEGETATION too"
            )
        chosen = {layer: found[0] for layer, found in bands.items() if found}
        _require_unit(source, name)
        cover = source.tags(chosen["density"]).get("CANOPY_COV_UNIT_NAME", "") if "density" in chosen else ""
        if cover.lower().startswith("categor"):
            raise LegendError(
                f"{name} holds the canopy cover in categories, expected percent; give the layers one by one, with "
                f"their bands (--bidx dem={chosen['elevation']} ...) and a density legend for the categories"
            )
        highest = source.tags(chosen["vegetation"]).get("FUEL_MODEL_MAX", "")
    anderson = highest.lstrip("-").isdigit() and int(highest) <= _HIGHEST_ANDERSON
    return LandscapeFile(chosen, "anderson_13" if anderson else "scott_burgan_40")


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
