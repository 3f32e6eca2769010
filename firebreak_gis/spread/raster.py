"""Raster: your own probabilities, and perhaps travel times, from another fire model.

Band d holds the probability that fire spreads from the cell to its neighbour in direction d, in the order N
NE E SE S SW W NW. Cells that are nodata in all eight hold no fuel. Eight more bands in the same order may hold the
seconds that fire takes there (nodata where it cannot go), and a 17th the heat that a cell releases [kJ/m2]: then fires
can have a clock. Bands are told by their descriptions ("N", "travel_time N", "heat"), or else by this order.
Cost: one read.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import CRSError, InputError, ParameterError
from firebreak_gis.files.scratch import let_go, on_disk
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import DIRECTIONS
from firebreak_gis.memory import BLOCK_CELLS
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.plugins import parameter
from firebreak_gis.progress import silent
from firebreak_gis.rasters import VariableFile, open_raster, read_variables, variable_bands
from firebreak_gis.simulation.ground import network_of_planes

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr

    from firebreak_gis.progress import Progress
    from firebreak_gis.rasters.reading import Window


@dataclass(frozen=True)
class Params:
    """Where the probabilities stand."""

    path: str = parameter(
        "", text="Raster of 8 bands of spread probabilities, and perhaps 8 of travel times, on the grid", path=True
    )


def read_network(path: str | Path) -> SpreadNetwork:
    """Read a network from a raster of 8, 16 or 17 bands, as `firebreak network` writes it.

    Parameters
    ----------
    path
        Raster with bands N NE E SE S SW W NW, values in [0, 1]. Cells that are nodata in all of them hold no
        fuel. If the raster is not of this package and has no nodata cell, cells with no edge in or out hold
        none. Eight more bands are travel times [s], a 17th is heat [kJ/m2]; without them the network has no times.

    Raises
    ------
    InputError
        If the file cannot be read, has other bands or values outside [0, 1]; `CRSError` if it has no
        CRS, unless this package wrote it (an artificial forest).

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> path = fb.write_raster("network.tif", network.to_raster())
    >>> bool((fb.read_network(path).probability == network.probability).all())
    True
    """
    return NetworkFile(path).read()


class NetworkFile:
    """A network in a raster, read as a whole or by windows; see `read_network`.

    Attributes
    ----------
    grid : Grid
        Of the whole network.
    """

    def __init__(self, path: str | Path) -> None:
        self._path = path
        self._files = _files(path, unreferenced=True)
        first = self._files["spread_probability"]
        self.grid = first.grid
        self._boundary: Any = first.provenance.get("boundary")
        if self._boundary is None and self.grid.crs is None:
            raise CRSError(
                f"{path} has no coordinate reference system; assign the one it was made in, e.g. "
                "gdal_edit.py -a_srs EPSG:32635 FILE"
            )

    def read(self, window: Window | None = None) -> SpreadNetwork:
        """Read the network, or a window (row, column, rows, columns) of it."""
        return self._network(self._files, window)

    def _network(self, files: Mapping[str, VariableFile], window: Window | None) -> SpreadNetwork:
        planes = read_variables(files, window)
        values, burnable = _split(planes["spread_probability"])
        grid = self.grid if window is None else self._files["spread_probability"].part(window)
        return SpreadNetwork(
            values,
            burnable=None if self._boundary is None and burnable.all() else burnable,
            boundary=self._boundary or "open",
            crs=grid.crs,
            transform=grid.transform,
            provenance=_account(files),
            travel_time=planes.get("travel_time"),
            heat=planes.get("heat"),
        )

    def on_disk(self, folder: str | Path, *, cells: int = BLOCK_CELLS, progress: Progress = silent) -> SpreadNetwork:
        """Read the network block by block; its probabilities lie on the disk, 32 B a cell, and it has no times.

        Parameters
        ----------
        folder
            On whose disk they lie, see `files.scratch`.
        cells
            Of a block, about.
        progress
            Callback (share done, message).

        Returns
        -------
        SpreadNetwork
            Equal to that of `read`, but for the times; read as a whole if only the whole raster tells where fuel is.
        """
        rows, cols = self.grid.shape
        if self._boundary != "open":
            return self.read()
        files = {"spread_probability": self._files["spread_probability"]}
        probability = on_disk(folder, (8, rows, cols), np.float32)
        burnable = np.zeros((rows, cols), bool)
        step = max(cells // cols, 1)
        for row in range(0, rows, step):
            progress(row / rows, "reading the network")
            # Edges end where there is no fuel, so that a row more on each side is looked at.
            top, stop = max(row - 1, 0), min(row + step, rows)
            part = self._network(files, (top, 0, min(stop + 1, rows) - top, cols))
            own = slice(row - top, stop - top)
            probability[:, row:stop], burnable[row:stop] = part.probability[:, own], part.burnable[own]
            let_go(probability)
        return network_of_planes(probability, burnable, self.grid)

    def fuel(self, window: Window) -> np.ndarray:
        """Read which cells of a window hold fuel, (rows, cols) bool.

        Raises
        ------
        InputError
            If only the whole raster would tell.
        """
        if self._boundary != "open":
            raise InputError(
                f"{self._path} was not written by firebreak network for a landscape, so only the whole of it tells "
                "where fuel is; burn it without --window"
            )
        return _split(self._files["spread_probability"].read(window))[1]


def probability(
    landscape: xr.Dataset, params: Params
) -> tuple[np.ndarray, np.ndarray | None, np.ndarray | None, dict[str, Any]]:
    """Return a `Spread` read from `params.path`; it must lie on the grid of the landscape."""
    if not params.path:
        raise ParameterError("the spread model 'raster' needs path=..., a raster of 8 bands of probabilities")
    files = _files(params.path)
    Grid.of(landscape["burnable"]).require(files["spread_probability"].grid, params.path)
    planes = read_variables(files)
    return _split(planes["spread_probability"])[0], planes.get("travel_time"), planes.get("heat"), _account(files)


def _account(files: Mapping[str, VariableFile]) -> dict[str, Any]:
    """What the tags of a network with times tell of it."""
    if "travel_time" not in files:
        return {}
    written = files["spread_probability"].provenance
    return {key: read(written[key]) for key, read in _KEPT.items() if key in written}


#: Tags that are taken over, and how they are read.
_KEPT = {"wind_speed": float, "wind_from_direction": float, "left_out": str}
#: Bands of each variable in a raster that does not say what its bands are.
_BANDS = {"spread_probability": range(1, 9), "travel_time": range(9, 17), "heat": range(17, 18)}


def _files(path: str | Path, *, unreferenced: bool = False) -> dict[str, VariableFile]:
    """The variables of a network that the raster holds."""
    told = variable_bands(path)
    if not told.keys() & {"travel_time", "heat"}:
        with open_raster(path) as source:
            count = source.count
        told = {name: list(bands) for name, bands in _BANDS.items() if count > len(DIRECTIONS) and bands[-1] <= count}
        if count > len(DIRECTIONS) and count not in (16, 17):
            raise InputError(
                f"{path} has {count} bands, expected 8 of probabilities, perhaps 8 more of travel times, perhaps one "
                "more of heat"
            )
    names = ["spread_probability", *(name for name in ("travel_time", "heat") if name in told)]
    return {name: VariableFile(path, name, bands=told.get(name), unreferenced=unreferenced) for name in names}


def _split(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Probabilities without gaps, and the cells that have one in any direction."""
    missing = np.isnan(values)
    return np.where(missing, np.float32(0.0), values), ~missing.all(axis=0)
