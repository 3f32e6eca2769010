"""The network of a landscape made block by block, so that neither need fit into memory."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import memory, plugins
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.progress import silent
from firebreak_gis.rasters.blocks import ROWS

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.folder import LandscapeFolder
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.weather import SpreadRequest
    from firebreak_gis.progress import Progress

#: Rates of spread are counted in steps of this [m/h], up to the largest of which the median is told.
_STEP, _MOST = 0.05, 100_000.0


def network_of(
    landscape: xr.Dataset, *, model: str, folder: str | os.PathLike[str], cells: int | None = None, **params: Any
) -> SpreadNetwork:
    """The network of a landscape in memory; that of a large one is made by blocks, and its planes lie on the disk.

    Parameters
    ----------
    landscape, model, params
        As in `spread.spread_network`, to which the network is equal.
    folder
        On whose disk they lie, see `files.scratch`.
    cells
        Landscapes of more cells are large, and about so many are in a block; None: `memory.BLOCK_CELLS`.
    """
    from firebreak_gis.files.scratch import let_go, on_disk
    from firebreak_gis.simulation.ground import network_of_planes
    from firebreak_gis.spread import spread_network

    rows, cols = landscape["burnable"].shape
    halo, together = plugins.halo_of(model), cells or memory.BLOCK_CELLS
    if rows * cols <= together or halo is None or landscape.attrs.get("boundary", "open") != "open":
        return spread_network(landscape, model=model, **params)
    step = max(together // cols, 1)
    planes: dict[str, np.ndarray] = {}
    provenance: dict[str, Any] = {}
    for start in range(0, rows, step):
        stop = min(start + step, rows)
        top, bottom = max(start - halo, 0), min(stop + halo, rows)
        part = landscape.isel(y=slice(top, bottom))
        given = {name: value[top:bottom] if np.ndim(value) == 2 else value for name, value in params.items()}
        network = spread_network(part, model=model, **given)
        made = {name: getattr(network, name) for name in ("probability", "burnable", "travel_time", "heat")}
        for name, plane in made.items():
            if plane is not None:
                if name not in planes:
                    planes[name] = on_disk(folder, (*plane.shape[:-2], rows, cols), plane.dtype)
                planes[name][..., start:stop, :] = plane[..., start - top : stop - top, :]
                let_go(planes[name])
        provenance = network.provenance
    burnable = np.array(planes.pop("burnable"))  # looked at often
    grid = Grid.of(landscape["burnable"])
    return network_of_planes(planes.pop("probability"), burnable, grid, provenance=provenance, **planes)


class NetworkBlocks:
    """Blocks of rows of a network, for `rasters.write_blocks`, and what is told of the whole once they are through.

    Parameters
    ----------
    landscape
        The landscape in files.
    spread
        Spread model and wind. A model that does not say in `HALO` how many rows around a block its edges depend on is
        given the landscape as a whole.
    cells
        About so many cells are in a block; None: `memory.BLOCK_CELLS`.
    progress
        Callback (share done, message).

    Attributes
    ----------
    account : Account
        How rasters of the wind were laid on the grid.
    provenance : dict
        Of the network.
    n_burnable : int
        Cells with fuel.
    mean : float
        Mean probability of the edges from cells with fuel.
    rate : float or None
        Median rate of spread over the edges [m/h], to 0.1; None without a clock.
    """

    def __init__(
        self,
        landscape: LandscapeFolder,
        spread: SpreadRequest,
        *,
        cells: int | None = None,
        progress: Progress | None = None,
    ) -> None:
        self._landscape, self._spread, self._progress = landscape, spread, progress or silent
        self._halo = plugins.halo_of(spread.model)
        rows, cols = landscape.grid.shape
        step = max((cells or memory.BLOCK_CELLS) // cols // ROWS, 1) * ROWS
        self._starts = [0] if self._halo is None else list(range(0, rows, step))
        self._step = rows if self._halo is None else step
        self.account = Account()
        self.n_burnable, self._sum, self._rates = 0, 0.0, np.zeros(0, np.int64)
        self._first: tuple[slice, SpreadNetwork] | None = self._made(0)
        network = self._first[1]
        self.provenance: dict[str, Any] = dict(network.provenance)
        self._timed = network.timed
        if spread.clock:
            network.require_times("--clock")

    def __iter__(self) -> Iterator[tuple[int, xr.Dataset]]:
        """Give the first row and the data of each block."""
        for start in self._starts:
            yield start, self._data(start)

    def _data(self, start: int) -> xr.Dataset:
        """The data of a block, of which nothing else is kept."""
        self._progress(start / self._landscape.grid.shape[0], "spread network")
        rows, network = self._first if start == 0 and self._first is not None else self._made(start)
        self._first = None
        self._add(network, rows)
        return network.to_dataset().isel(y=rows)

    def whole(self) -> SpreadNetwork:
        """Make the network of the whole landscape at once."""
        return self._network(self._landscape.read())

    @property
    def mean(self) -> float:
        """Mean probability of the edges from cells with fuel."""
        return self._sum / (8 * self.n_burnable) if self.n_burnable else float("nan")

    @property
    def rate(self) -> float | None:
        """Median rate of spread over the edges [m/h]."""
        if not self._timed:
            return None
        until = np.cumsum(self._rates)
        if until.size == 0 or until[-1] == 0:
            return 0.0
        middle = np.searchsorted(until, [(until[-1] - 1) // 2, until[-1] // 2], side="right")
        return round(float(middle.mean() * _STEP), 1)

    def _made(self, start: int) -> tuple[slice, SpreadNetwork]:
        """Rows of the block in a network that is larger by the halo, and that network."""
        n_rows, cols = self._landscape.grid.shape
        if self._halo is None or len(self._starts) == 1:
            return slice(0, n_rows), self.whole()
        stop = min(start + self._step, n_rows)
        top, bottom = max(start - self._halo, 0), min(stop + self._halo, n_rows)
        network = self._network(self._landscape.read((top, 0, bottom - top, cols)))
        return slice(start - top, stop - top), network

    def _network(self, landscape: xr.Dataset) -> SpreadNetwork:
        from firebreak_gis.spread import spread_network

        account = Account()
        network = spread_network(landscape, model=self._spread.model, **self._spread.params(landscape, account))
        for known, found in ((self.account.alignment, account.alignment), (self.account.warnings, account.warnings)):
            known += [sentence for sentence in found if sentence not in known]
        return network

    def _add(self, network: SpreadNetwork, rows: slice) -> None:
        fuel = network.burnable[rows]
        probability = network.probability[:, rows]
        self.n_burnable += int(np.count_nonzero(fuel))
        self._sum += float(probability.sum(dtype=np.float64))
        if network.timed:
            found = network.rate()[:, rows][probability > 0]
            counts = np.bincount(np.rint(np.minimum(found, _MOST) / _STEP).astype(np.int64))
            self._rates = np.bincount(
                np.concatenate([np.arange(self._rates.size), np.arange(counts.size)]),
                weights=np.concatenate([self._rates, counts]),
            ).astype(np.int64)
