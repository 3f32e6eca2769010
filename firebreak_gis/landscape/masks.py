"""Areas and lines, drawn or as a raster on any grid, as a mask on the grid of a network."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import MASK_RULES, MaskRule, align_mask
from firebreak_gis.landscape.footprints import close_corners, corner_contacts, footprints
from firebreak_gis.landscape.planes import Source, open_header
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import geopandas as gpd

#: A polygon that covers all but so much of a cell covers it.
_NEARLY = 1e-6


def mask_plane(
    source: Source,
    grid: Grid,
    *,
    what: str,
    rule: MaskRule,
    solid: bool = False,
    account: Account | None = None,
) -> np.ndarray:
    """Read an area or lines as a mask on a grid. Nothing is interpolated.

    Parameters
    ----------
    source
        Raster on any grid, above 0 inside, no data outside; or polygons or lines (path, GeoDataFrame). Lines always
        take every cell that they touch, since fire passes between the corners of a thinner line.
    grid
        The grid of the network.
    what
        Name for messages.
    rule
        Which cells an area takes: `"touched"`, all with a part inside, however little; `"centre"`, those whose centre
        lies inside; `"within"`, those of which no part lies outside.
    solid
        Whether cells that polygons and lines pass through at a corner are taken too, so that no fire gets through.
    account
        Gets sentences on what was done.

    Returns
    -------
    numpy.ndarray
        (rows, cols) bool.

    Raises
    ------
    InputError
        If the source cannot be read or lies elsewhere.
    """
    account = Account() if account is None else account
    if is_vector(source):
        return _drawn(source, grid, what, rule, solid, account)
    if isinstance(source, np.ndarray):
        if source.shape != grid.shape:
            raise InputError(f"{what} has shape {source.shape}, expected {grid.shape}")
        return np.asarray(np.nan_to_num(source) > 0)
    mask = align_mask(open_header(source), grid, what, account, rule)
    if solid and (gaps := int(sum(np.count_nonzero(part) for part in corner_contacts(mask)))):
        account.warn(
            f"{what}: cells of the raster meet only at a corner in {gaps} places, where fire passes; give the lines or "
            "polygons that it was made from, or make it again with all cells that they touch"
        )
    return mask


def _drawn(source: Source, grid: Grid, what: str, rule: MaskRule, solid: bool, account: Account) -> np.ndarray:
    from firebreak_gis.vectors import read_features

    frame = read_features(source, grid.crs)
    account.alignment.extend(f"{what}: {note}" for note in frame.attrs["notes"])
    prints = footprints(frame, grid)
    if not prints.cell.size:
        raise InputError(f"{what} does not touch the landscape {grid.describe()}; is it the right file?")
    is_area = frame.geometry.geom_type.str.contains("Polygon").to_numpy()
    mask = np.zeros(grid.shape, dtype=bool)
    taken = np.ones(prints.cell.size, dtype=bool) if rule == "touched" else ~is_area[prints.feature]
    mask.ravel()[prints.cell[taken]] = True
    if rule != "touched" and is_area.any():
        areas = frame[is_area]
        mask |= _whole_cells(areas, grid) if rule == "within" else _by_centre(areas, grid)
        lost = np.setdiff1d(prints.feature[is_area[prints.feature]], prints.feature[mask.ravel()[prints.cell]])
        if lost.size:
            account.warn(
                f"{what}: {lost.size} of {int(is_area.sum())} polygons are too small or thin to have a cell "
                f"({MASK_RULES[rule]} count)"
            )
    if solid:
        mask = close_corners(mask, frame, grid)
    count = int(mask.sum())
    account.alignment.append(
        f"{what}: {len(frame)} polygons or lines take {count} cells ({count * grid.cell_area_ha:,.6g} ha)"
        + (f"; of polygons {MASK_RULES[rule]}" if is_area.any() else "")
    )
    return mask


def _whole_cells(areas: gpd.GeoDataFrame, grid: Grid) -> np.ndarray:
    """Cells that polygons cover together, each perhaps a part."""
    import geopandas as gpd
    import shapely

    union = gpd.GeoDataFrame(geometry=[shapely.union_all(areas.geometry.array)], crs=grid.crs)
    prints = footprints(union, grid)
    mask = np.zeros(grid.shape, dtype=bool)
    mask.ravel()[prints.cell[prints.part > 1.0 - _NEARLY]] = True
    return mask


def _by_centre(areas: gpd.GeoDataFrame, grid: Grid) -> np.ndarray:
    from rasterio.features import rasterize

    return np.asarray(rasterize(areas.geometry, out_shape=grid.shape, transform=grid.transform, dtype="uint8") > 0)
