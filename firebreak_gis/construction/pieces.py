"""Connected pieces of a break mask as polygons."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.grid import Grid, outlines

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr


def break_polygons(breaks: xr.DataArray, priority: xr.DataArray | None = None) -> gpd.GeoDataFrame:
    """Outline the connected pieces of a break mask.

    Pieces are connected over sides and corners; each row is one piece.

    Parameters
    ----------
    breaks
        (y, x), above 0 where cut, with a CRS in metres.
    priority
        The ranking, which gives the construction order and the mean score.

    Returns
    -------
    geopandas.GeoDataFrame
        Columns `order` (1 = highest mean priority), `cells`, `area_ha`, `mean_priority`, `geometry` (valid
        polygons or multipolygons), sorted by `order`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> priority = fb.rank(network, "degree")
    >>> pieces = fb.break_polygons(fb.select_breaks(priority, budget=0.1), priority)
    >>> int(pieces["cells"].sum()) == round(0.1 * network.n_burnable)
    True
    """
    import geopandas as gpd
    from scipy import ndimage

    grid = Grid.of(breaks)
    cut = np.asarray(breaks) > 0
    labels, n_pieces = ndimage.label(cut, structure=np.ones((3, 3)))
    drawn = outlines(labels, n_pieces, grid)
    cells = np.bincount(labels.ravel(), minlength=n_pieces + 1)[1:]
    scores = np.zeros(n_pieces)
    if priority is not None:
        grid.require(Grid.of(priority), "priority")
        total = np.bincount(labels[cut], weights=np.asarray(priority, dtype=np.float64)[cut], minlength=n_pieces + 1)[
            1:
        ]
        scores = total / np.maximum(cells, 1)
    sequence = np.argsort(-scores, kind="stable")
    return gpd.GeoDataFrame(
        {
            "order": np.arange(1, n_pieces + 1),
            "cells": cells[sequence],
            "area_ha": cells[sequence] * grid.cell_area_ha,
            "mean_priority": scores[sequence],
        },
        geometry=[drawn[i] for i in sequence],
        crs=grid.crs,
    )
