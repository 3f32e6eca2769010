"""A plan over years: what is built when, and what keeping it up takes.

Treated fuel grows back. A break is kept up by treating a share of it anew every year, one over its return interval, so
that it is never older than that: the same money every year as if a crew came back to each segment when it has grown
back. Each year upkeep is paid first; what is left builds on, segment by segment in the order of construction, and a
segment that costs more than a year affords is begun in one year and finished in a later one. It stands from the year in
which its last part is built.

A year more or a coin more never leaves less standing: what has been built by the end of a year is a function of the
money before, rising since keeping a part up takes no more a year than building it does.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.schema import VEGETATION

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

#: Years until cleared fuel has grown back, by type: those of clearing in the built-in table of treatments, which are
#: assumptions; three to five years are told in practice for shrubs in the Mediterranean.
RETURN: Mapping[str, float] = MappingProxyType({"agricultural": 3.0, "shrubs": 4.0, "pines": 4.0})
#: Sums of costs may pass a budget by this share, for their rounding.
_ROUNDING = 1.0 + 1e-12


def return_intervals(text: str) -> dict[str, float]:
    """Read years until fuel has grown back: "4", or "agricultural=3,shrubs=4,pines=8"; types left out are assumed.

    Raises
    ------
    ParameterError
        If a word is no type, or a number is less than 1 or infinite.

    Examples
    --------
    >>> return_intervals("pines=8")
    {'agricultural': 3.0, 'shrubs': 4.0, 'pines': 8.0}
    """
    words = [word.partition("=") for word in str(text).split(",")]
    if len(words) == 1 and not words[0][1]:
        words = [(name, "=", words[0][0]) for name in RETURN]
    found = dict(RETURN)
    for name, _, number in words:
        try:
            years = float(number)
        except ValueError:
            years = math.nan
        if name.strip() not in RETURN or not (math.isfinite(years) and years >= 1.0):
            raise ParameterError(
                f"return intervals are {text!r}, expected years of at least 1, such as 4, or by type of vegetation "
                "agricultural=3,shrubs=4,pines=8"
            )
        found[name.strip()] = years
    return found


def upkeep_rates(codes: np.ndarray, intervals: Mapping[str, float]) -> np.ndarray:
    """Share of each cell that is treated anew every year, by its vegetation code; 0 without fuel."""
    rates = np.zeros(256)
    for code, word in VEGETATION.items():
        rates[code] = 1.0 / intervals[word] if code else 0.0
    return np.asarray(rates[np.asarray(codes).astype(np.int64)])


@dataclass(frozen=True)
class Schedule:
    """What is built when.

    Parameters
    ----------
    year, begun
        (n,) int64, year in which each segment stands, and in which its building begins, from 1; 0 for never.
    built, kept
        (years,) spent on building and on upkeep in each year.
    """

    year: np.ndarray
    begun: np.ndarray
    built: np.ndarray
    kept: np.ndarray


def schedule(cost: np.ndarray, yearly: np.ndarray, *, budget: float, years: int) -> Schedule:
    """Build segments in order as the money of each year allows, upkeep first.

    Parameters
    ----------
    cost
        (n,) of building each segment, in the order of construction.
    yearly
        (n,) cost of keeping it up for a year, at most `cost`; due from the year after a part is built.
    budget
        Money of each year.
    years
        Number of years.

    Raises
    ------
    ParameterError
        If there is less than one year, the budget is negative, or keeping up costs more than building.

    Examples
    --------
    >>> import numpy as np
    >>> plan = schedule(np.array([2.0, 2.0, 2.0]), np.array([0.5, 0.5, 0.5]), budget=2.0, years=3)
    >>> plan.year.tolist(), plan.built.tolist(), plan.kept.tolist()
    ([1, 3, 0], [2.0, 1.5, 1.125], [0.0, 0.5, 0.875])
    """
    if years < 1:
        raise ParameterError(f"{years} years are asked, expected at least 1")
    if not (np.isfinite(budget) and budget >= 0):
        raise ParameterError(f"the budget of a year is {budget}, expected a number of at least 0")
    if (yearly > cost * _ROUNDING).any():
        raise ParameterError("keeping a segment up costs more a year than building it, expected at most as much")
    ends = np.cumsum(cost)
    starts, total = ends - cost, float(ends[-1]) if ends.size else 0.0
    rate = np.divide(yearly, cost, out=np.zeros(cost.size), where=cost > 0)
    done = 0.0
    year, begun = np.zeros(cost.size, np.int64), np.zeros(cost.size, np.int64)
    built, kept = np.zeros(years), np.zeros(years)
    for y in range(years):
        kept[y] = min(float((np.clip(done - starts, 0.0, cost) * rate).sum()), budget)
        built[y] = max(min(budget - kept[y], total - done), 0.0)
        done += built[y]
        year[(year == 0) & (ends <= done * _ROUNDING)] = y + 1
        begun[(begun == 0) & ((starts < done / _ROUNDING) | (year > 0))] = y + 1
    return Schedule(year, begun, built, kept)


def visits(year: np.ndarray, interval: np.ndarray, years: int) -> list[str]:
    """Years in which a crew comes back to each segment, as text: "5 9"; empty where it is not built, or not again."""
    found = []
    for first, step in zip(year.tolist(), interval.tolist(), strict=True):
        count = int((years - first) / step + 1e-9) if first and np.isfinite(step) and step > 0 else 0
        found.append(" ".join(str(first + round(k * step)) for k in range(1, count + 1)))
    return found


def mean_rates(polygons: gpd.GeoDataFrame, codes: xr.DataArray, intervals: Mapping[str, float]) -> np.ndarray:
    """Share of each segment that is treated anew every year, (n,): the mean over its cells."""
    from rasterio.features import rasterize

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.footprints import footprints

    n = len(polygons)
    if not n:
        return np.zeros(0)
    grid = Grid.of(codes)
    shapes = zip(polygons.geometry, range(1, n + 1), strict=True)
    owner = rasterize(shapes, grid.shape, transform=grid.transform, dtype="int32").ravel()
    rates = upkeep_rates(codes.to_numpy(), intervals).ravel()
    cells = np.bincount(owner, minlength=n + 1)[1:]
    mean = np.bincount(owner, weights=rates, minlength=n + 1)[1:] / np.maximum(cells, 1)
    if (cells == 0).any():  # narrower than a cell: by the area in each
        prints = footprints(polygons, grid)
        area, total = (
            np.bincount(prints.feature, weights=weight, minlength=n)
            for weight in (prints.part, prints.part * rates[prints.cell])
        )
        mean = np.where(cells > 0, mean, total / np.maximum(area, 1e-300))
    return np.asarray(mean)
