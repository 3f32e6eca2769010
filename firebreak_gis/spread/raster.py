"""Probabilities from an eight-band raster: bring your own fire model.

Band d holds the probability that fire spreads from the cell to its neighbour in direction d, in the order N
NE E SE S SW W NW. Cells that are nodata in all bands hold no fuel. Cost: one read.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import CRSError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.plugins import parameter
from firebreak_gis.rasters import read_variable

if TYPE_CHECKING:
    from pathlib import Path

    import xarray as xr


@dataclass(frozen=True)
class Params:
    """Where the probabilities stand."""

    path: str = parameter("", text="Eight-band raster of spread probabilities on the grid of the landscape", path=True)


def read_network(path: str | Path) -> SpreadNetwork:
    """Read a network from an eight-band raster, as `firebreak network` writes it.

    Parameters
    ----------
    path
        Raster with bands N NE E SE S SW W NW, values in [0, 1]. Cells that are nodata in every band hold no
        fuel. If the raster is not of this package and has no nodata cell, cells with no edge in or out hold
        none.

    Raises
    ------
    InputError
        If the file cannot be read, has other than eight bands or values outside [0, 1]; `CRSError` if it has no
        CRS, unless this package wrote it (an artificial forest).
    """
    data = read_variable(path, "spread_probability", unreferenced=True)
    values, burnable = _split(data)
    boundary = data.attrs.get("provenance", {}).get("boundary")
    if boundary is None and Grid.of(data).crs is None:
        raise CRSError(
            f"{path} has no coordinate reference system; assign the one it was made in, e.g. "
            "gdal_edit.py -a_srs EPSG:32635 FILE"
        )
    if boundary is None and burnable.all():
        return SpreadNetwork(data.copy(data=values))
    return SpreadNetwork(data.copy(data=values), burnable=burnable, boundary=boundary or "open")


def probability(landscape: xr.Dataset, params: Params) -> np.ndarray:
    """Return (8, rows, cols) float32 read from `params.path`; it must lie on the grid of the landscape."""
    if not params.path:
        raise ParameterError("the spread model 'raster' needs path=..., an eight-band raster of probabilities")
    data = read_variable(params.path, "spread_probability")
    Grid.of(landscape["burnable"]).require(Grid.of(data), params.path)
    return _split(data)[0]


def _split(data: xr.DataArray) -> tuple[np.ndarray, np.ndarray]:
    """Probabilities without gaps, and the cells that have one in any direction."""
    values = data.to_numpy()
    missing = np.isnan(values)
    return np.where(missing, np.float32(0.0), values), ~missing.all(axis=0)
