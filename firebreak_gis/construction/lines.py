"""Walls that are lines, as segments to build and as outlines of their width."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.construction.compartments import split
from firebreak_gis.construction.segments import Segments, slope
from firebreak_gis.landscape.footprints import footprints
from firebreak_gis.landscape.lines import LineBreaks, links_crossed
from firebreak_gis.lattice import COL_STEP, ROW_STEP

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Plane = np.ndarray | xr.DataArray

#: A line shorter than this is no job of its own, where another of its wall is this near [m].
_SHORT, _NEAR = 100.0, 100.0


def line_segments(
    network: SpreadNetwork,
    walls: gpd.GeoDataFrame,
    breaks: LineBreaks | None,
    *,
    elevation: Plane | None = None,
    value: Plane | None = None,
    ignition: Plane | None = None,
) -> Segments:
    """Take walls that are lines apart into segments, in the order of building.

    Parameters
    ----------
    network
        The spread network before cutting.
    walls
        In order: `length_m`, `width_m`, `cost`, `saved`, and multilines, see `planning.line_design`.
    breaks
        The same on the grid; None for none.
    elevation, value, ignition
        As in `segments.segments_of`.

    Returns
    -------
    Segments
        With the columns of `segments.segments_of`. Each line of a wall is a segment, short ones together with what they
        are near; each wall is a `stage`, whose gain is told at its last segment. `area_ha` is length times width,
        `cells` counts the cells that a segment passes, and the means are by length. Polygons are the lines in their
        width.
    """
    import geopandas as gpd

    crossed = None if breaks is None else breaks.crossed
    parts = split(network, np.zeros(network.shape, bool), crossed=crossed, value=value, ignition=ignition)
    lines = _jobs(walls)
    stage = lines.index.to_numpy() + 1
    lines = lines.reset_index(drop=True)
    length = lines.length.to_numpy()
    last = np.append(np.diff(stage) > 0, True)[: len(stage)]
    saved = walls["saved"].to_numpy() * float(parts.value.sum())
    share = saved / max(float(saved.sum()), np.finfo(float).tiny)
    whole = walls.length.to_numpy()
    sides = _sides(network, lines, parts.labels)
    prints = footprints(lines, network.grid)
    cells = np.bincount(prints.feature, minlength=len(lines))

    def mean(plane: np.ndarray) -> np.ndarray:
        values = plane.ravel()[prints.cell]
        known = np.isfinite(values)
        total, length = (
            np.bincount(prints.feature[known], weights=weight, minlength=len(lines))
            for weight in ((values * prints.part)[known], prints.part[known])
        )
        return np.where(length > 0, total / np.maximum(length, 1e-300), np.nan)

    def steepest(plane: np.ndarray) -> np.ndarray:
        found = np.full(len(lines), -np.inf)
        np.fmax.at(found, prints.feature, plane.ravel()[prints.cell])
        return np.where(np.isfinite(found), found, np.nan)

    steepness = slope(network, elevation)
    table = {
        "order": np.arange(1, len(lines) + 1),
        "stage": stage,
        "length_m": length,
        "width_m": lines["width_m"].to_numpy(),
        "cells": cells,
        "area_ha": length * lines["width_m"].to_numpy() / 10_000.0,
        "mean_slope_deg": mean(steepness),
        "max_slope_deg": steepest(steepness),
        "cost": lines["cost"].to_numpy() * length / np.maximum(whole[stage - 1], 1e-300),
        "compartment_a": sides[:, 0],
        "compartment_b": sides[:, 1],
        "gain": np.where(last, saved[stage - 1], 0.0),
        "gain_share": np.where(last, share[stage - 1], 0.0),
        "stage_gain_share": share[stage - 1],
    }
    if network.heat is not None and network.travel_time is not None:
        from firebreak_gis.simulation import holding

        hold = holding.Hold(share=None)
        intensity, trees = holding.fire_before(network, hold)
        flame = holding.flame_length(intensity)
        table |= {
            "intensity_kw_m": mean(intensity),
            "flame_length_m": mean(flame),
            "breach": holding.breach(mean(intensity), table["width_m"], trees=mean(trees) >= 0.5),
            "width_wilson_m": mean(holding.width_needed(intensity, trees=trees)),
            "width_flames_m": hold.flames * mean(flame),
        }
    outlines = lines.geometry.buffer(lines["width_m"].to_numpy() / 2, cap_style="flat", join_style="mitre")
    return Segments(
        gpd.GeoDataFrame(table, geometry=lines.geometry.array, crs=network.grid.crs),
        gpd.GeoDataFrame(table, geometry=outlines.array, crs=network.grid.crs),
    )


def _jobs(walls: gpd.GeoDataFrame) -> gpd.GeoDataFrame:
    """Lines of walls as they are built: short ones go with the next of their wall, if that is near."""
    import geopandas as gpd
    import shapely

    lines = walls.explode(index_parts=False)
    if len(lines) < 2:
        return lines
    stage, shapes = lines.index.to_numpy(), lines.geometry.array
    begin, end = (shapely.get_coordinates(shapely.get_point(shapes, k)) for k in (0, -1))
    short = shapely.length(shapes) < _SHORT
    apart = np.hypot(*(begin[1:] - end[:-1]).T) > _NEAR
    new = np.append(True, (np.diff(stage) != 0) | apart | ~(short[1:] | short[:-1]))
    first = np.flatnonzero(new)
    parts = np.split(np.asarray(shapes), first[1:])
    whole = [each[0] if len(each) == 1 else shapely.MultiLineString(list(each)) for each in parts]
    table = lines.drop(columns="geometry").iloc[first]
    return gpd.GeoDataFrame(table, geometry=whole, crs=walls.crs)


def line_polygons(walls: gpd.GeoDataFrame) -> gpd.GeoDataFrame:
    """Connected pieces of lines in their width: `order`, `area_ha` (overlaps once), `length_m` and polygons.

    Parameters
    ----------
    walls
        In the order of building, with `width_m`; a piece has the order of its first wall.
    """
    import geopandas as gpd
    import shapely

    outlines = walls.geometry.buffer(walls["width_m"].to_numpy() / 2, cap_style="flat", join_style="mitre")
    pieces = np.asarray(shapely.get_parts(shapely.union_all(outlines.array)))
    tree = shapely.STRtree(pieces)
    lines = walls.explode(index_parts=False)
    line, piece = tree.query(shapely.line_interpolate_point(lines.geometry.array, 0.5, normalized=True), "intersects")
    first = np.full(len(pieces), len(walls))
    np.minimum.at(first, piece, lines.index.to_numpy()[line])
    length = np.bincount(piece, weights=lines.length.to_numpy()[line], minlength=len(pieces))
    order = np.argsort(first, kind="stable")
    return gpd.GeoDataFrame(
        {
            "order": np.arange(1, len(pieces) + 1),
            "length_m": length[order],
            "area_ha": shapely.area(pieces[order]) / 10_000.0,
        },
        geometry=pieces[order],
        crs=walls.crs,
    )


def _sides(network: SpreadNetwork, lines: gpd.GeoDataFrame, labels: np.ndarray) -> np.ndarray:
    """The two compartments that most of the links across each line part, (n, 2), a < b; both 0 if it parts none."""
    out = np.zeros((len(lines), 2), np.int64)
    for i in range(len(lines)):
        crossed, *_ = links_crossed(lines.iloc[[i]], network.grid)
        row, col = np.nonzero(crossed)
        pairs = []
        for d in range(4):
            far = (crossed[row, col] >> d) & 1 > 0
            one = labels[row[far], col[far]]
            other = labels[row[far] + ROW_STEP[d], col[far] + COL_STEP[d]]
            pairs.append(np.sort(np.column_stack([one, other]), axis=1))
        both = np.concatenate(pairs)
        both = both[(both[:, 0] > 0) & (both[:, 0] != both[:, 1])]
        if len(both):
            found, count = np.unique(both, axis=0, return_counts=True)
            out[i] = found[np.argmax(count)]
    return out
