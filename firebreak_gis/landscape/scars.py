"""Observed fires on the grid of a landscape: scars, where they started, and tables of sizes and days."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.planes import Source
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd

#: Share of a scar that may lie off the landscape; more, and its size would be wrong.
_MOST_OUTSIDE = 0.05
#: Columns that tables of fires often have, by what they mean; upper and lower case are the same.
SIZE_NAMES = ("area_ha", "size_ha", "burnt_ha", "burned_ha", "area", "ha")
FIRST_DAY_NAMES = ("date_ini", "date_start", "start_date", "start", "ignition", "date")
LAST_DAY_NAMES = ("date_end", "end_date", "end", "date_out", "date_fin")


@dataclass(frozen=True)
class Scar:
    """An observed fire on a grid.

    Parameters
    ----------
    burnt
        (rows, cols) bool: what burnt in the end, the start included.
    start
        (rows, cols) bool: where the fire was first seen.
    notes
        What is doubtful, in sentences.
    """

    burnt: np.ndarray
    start: np.ndarray
    notes: tuple[str, ...] = ()


def read_scar(scar: Source, start: Source, grid: Grid, *, fuel: np.ndarray) -> Scar:
    """Lay an observed fire and its start on a grid.

    A cell has burnt if its centre lies in the perimeter: then areas are right on average, and a scar of many small
    parts neither grows nor shrinks. (A share of one half or more would differ in few cells, along the edge only.)

    Parameters
    ----------
    scar
        Perimeter: polygons (path or GeoDataFrame), or a raster above 0 where it burnt.
    start
        Points, or polygons of a fire that was burning already, or a raster above 0 there. A polygon without the centre
        of a cell takes the cell of its middle.
    grid
        The grid of the landscape.
    fuel
        (rows, cols) bool. A point on a cell without fuel is moved to the nearest cell with fuel within the scar, or
        else at all, and a note says so; of polygons only the cells with fuel burn on.

    Returns
    -------
    Scar

    Raises
    ------
    InputError
        If a file cannot be read, scar or start do not lie on the landscape, or more than 5 % of the scar's area lies
        off it.
    """
    notes: list[str] = []
    burnt = mask_plane(scar, grid, what="the scar", rule="centre")
    if not burnt.any():
        raise InputError("the scar holds the centre of no cell of the landscape; take smaller cells (align --res)")
    if is_vector(scar):
        _require_inside(scar, grid, notes)
    bare = int(np.count_nonzero(burnt & ~fuel))
    if bare:
        notes.append(
            f"{bare} of the {int(burnt.sum())} cells of the scar hold no fuel on the map; no simulated fire burns them"
        )
    begun = _start(start, grid, burnt, fuel, notes)
    if not (begun & burnt).any():
        notes.append("the start lies outside the scar")
    return Scar(burnt | begun, begun, tuple(notes))


def fire_table(
    source: Any,
    *,
    size: str | None = None,
    first_day: str | None = None,
    last_day: str | None = None,
) -> pd.DataFrame:
    """Read sizes and days of observed fires.

    Parameters
    ----------
    source
        A CSV file, a vector file (its geometries are left aside but for the area), or a DataFrame.
    size
        Column with the size [ha]; by default the first of `SIZE_NAMES` that there is, else the area of the polygons.
    first_day, last_day
        Columns with the first and the last day of burning, as dates; by default from `FIRST_DAY_NAMES` and
        `LAST_DAY_NAMES`, if there are any.

    Returns
    -------
    pandas.DataFrame
        `ha` (above 0) and `days` (whole days with fire: a fire out on the day it began has 1; NaN where not known), one
        row a fire in the order of the file. Fires without a size, or of 0 ha, are left out.

    Raises
    ------
    InputError
        If the file cannot be read, holds no size, or no fire is left.
    ParameterError
        If a column that was named is not there.

    Examples
    --------
    >>> import pandas as pd
    >>> days = {"Date_ini": ["2016-09-03"] * 3, "Date_end": ["2016-09-05"] * 3}
    >>> fire_table(pd.DataFrame({"Area_ha": [12, 0, 300], **days}))
          ha  days
    0   12.0   3.0
    1  300.0   3.0
    """
    import pandas as pd

    where, table, areas = _rows(source)
    column = _column(table, size, SIZE_NAMES, where, "size")
    if column is not None:
        hectares = pd.to_numeric(table[column], errors="coerce").to_numpy(dtype=np.float64)
    elif areas is not None:
        hectares = areas
    else:
        raise InputError(f"{where} has no column with the size of the fires [ha]; name it (--size-column)")
    begun, ended = (
        _column(table, name, usual, where, what)
        for name, usual, what in (
            (first_day, FIRST_DAY_NAMES, "first day"),
            (last_day, LAST_DAY_NAMES, "last day"),
        )
    )
    days = np.full(len(table), np.nan)
    if begun is not None and ended is not None:
        first, last = (pd.to_datetime(table[name], errors="coerce").dt.normalize() for name in (begun, ended))
        days = ((last - first).dt.days + 1).to_numpy(dtype=np.float64)
        if (days < 1).any():
            row = int(np.flatnonzero(days < 1)[0])
            raise InputError(f"{where}: fire {row + 1} ends before it begins; mend {begun} or {ended}")
    kept = np.isfinite(hectares) & (hectares > 0)
    if not kept.any():
        raise InputError(f"{where} holds no fire with a size above 0 ha")
    return pd.DataFrame({"ha": hectares[kept], "days": days[kept]})


def _start(start: Source, grid: Grid, burnt: np.ndarray, fuel: np.ndarray, notes: list[str]) -> np.ndarray:
    if not is_vector(start):
        begun = mask_plane(start, grid, what="the start", rule="centre")
        return _with_fuel(begun, fuel)
    from firebreak_gis.vectors import read_starts

    frame = read_starts(start, grid.crs)
    areas = frame[frame.geometry.geom_type.str.contains("Polygon")]
    begun = np.zeros(grid.shape, bool)
    if len(areas):
        begun |= mask_plane(areas, grid, what="the start", rule="centre")
        if not begun.any():
            notes.append("the start is smaller than a cell")
    points = (
        frame.geometry.representative_point() if not begun.any() else frame[~frame.index.isin(areas.index)].geometry
    )
    for cell in grid.cells_of(points.x.to_numpy(), points.y.to_numpy()).tolist():
        if cell < 0:
            raise InputError(f"the start lies outside the landscape {grid.describe()}; is it the right file?")
        place = divmod(cell, grid.shape[1])
        if not fuel[place]:
            place, metres = _nearest(place, burnt & fuel if (burnt & fuel).any() else fuel, grid)
            notes.append(f"the start lies on a cell without fuel and was moved by {metres:.0f} m")
        begun[place] = True
    return _with_fuel(begun, fuel)


def _with_fuel(begun: np.ndarray, fuel: np.ndarray) -> np.ndarray:
    if not (begun & fuel).any():
        raise InputError("the start lies on land without fuel only; check the legend, or move the start")
    return begun


def _nearest(place: tuple[int, int], wanted: np.ndarray, grid: Grid) -> tuple[tuple[int, int], float]:
    cells = np.argwhere(wanted)
    if not cells.size:
        raise InputError("the landscape holds no fuel; check the legend")
    away = np.hypot(*(cells - np.array(place)).T)
    row, col = cells[int(np.argmin(away))].tolist()
    return (row, col), float(away.min() * grid.cell_size)


def _require_inside(scar: Source, grid: Grid, notes: list[str]) -> None:
    import shapely

    from firebreak_gis.vectors import read_polygons

    areas = read_polygons(scar, grid.crs).geometry.union_all()
    outside = 1.0 - areas.intersection(shapely.box(*grid.bounds)).area / areas.area
    if outside > _MOST_OUTSIDE:
        raise InputError(
            f"{100 * outside:.0f} % of the scar lie off the landscape {grid.describe()}; align layers that cover it"
        )
    if outside > 1e-6:
        notes.append(f"{100 * outside:.2g} % of the scar lie off the landscape")


def _rows(source: Any) -> tuple[str, pd.DataFrame, np.ndarray | None]:
    """Name, columns and, where there are polygons, areas in hectares."""
    import pandas as pd

    if isinstance(source, pd.DataFrame) and not hasattr(source, "geometry"):
        return "the table of fires", source.reset_index(drop=True), None
    if isinstance(source, (str, os.PathLike)) and os.fspath(source).lower().endswith(".csv"):
        try:
            return os.fspath(source), pd.read_csv(source), None
        except (OSError, ValueError) as error:
            raise InputError(f"{source} cannot be read as a table ({str(error)[:120]})") from error
    from firebreak_gis.vectors import read_polygons

    frame: gpd.GeoDataFrame = read_polygons(source, "EPSG:6933")  # equal areas
    where = "the features" if hasattr(source, "geometry") else os.fspath(source)
    return where, pd.DataFrame(frame.drop(columns=frame.geometry.name)), frame.area.to_numpy() / 10_000.0


def _column(table: pd.DataFrame, name: str | None, usual: tuple[str, ...], where: str, what: str) -> str | None:
    if name is not None:
        if name not in table.columns:
            raise ParameterError(f"{where} has no column {name!r} with the {what}; it has: {', '.join(table.columns)}")
        return name
    known = {str(column).lower(): str(column) for column in table.columns}
    return next((known[word] for word in usual if word in known), None)
