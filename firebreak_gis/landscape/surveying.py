"""What can be known of a landscape before any value is read: layers, legends, grid, memory."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, LegendError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import placing
from firebreak_gis.landscape.continuity import CONTINUITY
from firebreak_gis.landscape.flammap import LandscapeFile, read_landscape_file
from firebreak_gis.landscape.fuel import given_instead
from firebreak_gis.landscape.legends import Legend, read_legend
from firebreak_gis.landscape.legends.burning import BURNING
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.resampling import BLOCK
from firebreak_gis.landscape.target_grid import Account, choose_grid, grid_like
from firebreak_gis.memory import BLOCK_CELLS, SOURCE_CELLS
from firebreak_gis.rasters import Header, header_of_array, read_header, with_crs
from firebreak_gis.schema import DENSITY

if TYPE_CHECKING:
    import xarray as xr

#: The legends where nothing else is said (as `LandscapeRequest` has them), and for the canopy cover of a landscape
#: file.
USUAL, USUAL_DENSITY, CANOPY = "paper", "density", "canopy_cover"


@dataclass(frozen=True)
class Survey:
    """A landscape as far as headers tell.

    Parameters
    ----------
    layers
        Header by name: "elevation", "vegetation" and perhaps "density".
    grid
        On which they will be laid.
    legend, density_legend
        For the codes.
    density
        Word in place of a density raster, or None.
    account
        What was decided, in words; more is added as the layers are read.
    """

    layers: Mapping[str, Header]
    grid: Grid
    legend: Legend
    density_legend: Legend
    density: str | None
    account: Account

    @property
    def variables(self) -> set[str]:
        """Variables that the landscape will have, see `fuel.fuel_of`."""
        return {"elevation", "vegetation", "density"} | given_instead(
            self.legend, self.density_legend if "density" in self.layers else None
        )

    @property
    def legends(self) -> dict[str, Legend]:
        """By the layer that they are for."""
        return {"vegetation": self.legend, "density": self.density_legend}

    @property
    def memory(self) -> int:
        """Estimated peak of reading it, bytes."""
        planes = sum(not np.isnan(self.legend.column(name, np.nan)).all() for name in BURNING.values())
        return memory_needed(self.layers, self.grid) + 8 * planes * self.grid.shape[0] * self.grid.shape[1]

    @property
    def by_parts(self) -> bool:
        """Whether it is laid part by part where it need not be in memory as a whole."""
        return self.grid.shape[0] * self.grid.shape[1] > BLOCK_CELLS

    @property
    def memory_by_parts(self) -> int:
        """Estimated peak of reading it by parts, bytes; less for a landscape that is one part."""
        return min(self.memory, 120 * BLOCK_CELLS + 28 * SOURCE_CELLS) if self.by_parts else self.memory


def survey(request: LandscapeRequest) -> Survey:
    """Read headers and legends and choose the grid.

    Raises
    ------
    InputError, ParameterError
        As `read_landscape`, for all that can be known without reading a value.
    """
    account = Account(strict=request.strict)
    vegetation, density = request.vegetation, request.density
    legend, density_legend = request.legend, request.density_legend
    band = dict(request.bidx)
    words = (*DENSITY.values(), CONTINUITY)
    if density is None and isinstance(vegetation, str) and vegetation in words and not Path(vegetation).exists():
        vegetation, density = None, vegetation  # DENSITY of a landscape file
    if vegetation is None:
        asked = legend if isinstance(legend, str) and legend != USUAL else None
        found = read_landscape_file(request.dem, band=band, legend=asked, remote=request.remote)
        vegetation = request.dem
        density, legend, density_legend = _of_file(found, request.dem, density, legend, density_legend, band, account)
    table, density_table = _legends(legend, density_legend, density)
    word = density if isinstance(density, str) and density in words else None
    sources = {"elevation": request.dem, "vegetation": vegetation}
    if density is not None and word is None:
        sources["density"] = density
    layers = _headers(sources, request, band)
    grid = choose_grid(
        layers,
        account,
        crs=request.crs,
        resolution=request.resolution,
        bounds=request.bounds or None,
        like=request.like,
    )
    return Survey(layers, grid, table, density_table, word, account)


def memory_needed(layers: Mapping[str, Header], grid: Grid) -> int:
    """Estimate the peak memory of `read_landscape` in bytes, from the headers alone."""
    cells = grid.shape[0] * grid.shape[1]
    largest = 0
    for header in layers.values():
        how = placing(header, grid)
        window = how.window[2] * how.window[3]
        coordinates = 0 if how.copy else min(BLOCK, max(cells, window))
        largest = max(largest, 28 * window + (60 if header.crs == grid.crs else 80) * coordinates)
    # Either looking up the legends is the peak, or laying one layer is. Bytes a cell were measured.
    return max((81 if "density" in layers else 50) * cells, 20 * cells + largest)


def _legends(legend: Any, density_legend: Any, density: Any) -> tuple[Legend, Legend]:
    table, density_table = read_legend(legend), read_legend(density_legend)
    if not table.has_vegetation:
        raise LegendError(
            f"the legend {table.name} does not give the vegetation of every code; it may be one for densities"
        )
    if density is None and not table.has_density:
        raise LegendError(
            f"no density: the legend {table.name} gives none. Give a density raster, or one class for all fuel, such "
            "as normal, or the word continuity, or a legend with densities (firebreak legends)"
        )
    if not density_table.has_density:
        raise LegendError(f"the density legend {density_table.name} does not give the density of every code")
    return table, density_table


def _headers(sources: Mapping[str, Any], request: LandscapeRequest, band: Mapping[str, int]) -> dict[str, Header]:
    src_crs, src_nodata, remote = request.src_crs, request.src_nodata, request.remote
    public = {"dem": "elevation", "elevation": "elevation", "vegetation": "vegetation", "density": "density"}
    for word, mapping in (("src_crs", src_crs), ("src_nodata", src_nodata), ("band", band)):
        wrong = set(mapping) - set(public)
        if wrong:
            raise ParameterError(f"{word} names {', '.join(sorted(wrong))}, expected dem, vegetation or density")
    nodata = {public[key]: value for key, value in src_nodata.items()}
    bands = {public[key]: value for key, value in band.items()}
    assigned = {public[key]: value for key, value in src_crs.items()}
    headers = {}
    for name, source in sources.items():
        if isinstance(source, str | os.PathLike):
            headers[name] = read_header(source, band=bands.get(name), src_nodata=nodata.get(name), remote=remote)
        else:
            placed = _placed(source, name, headers, request.like) if isinstance(source, np.ndarray) else source
            headers[name] = header_of_array(placed, src_nodata=nodata.get(name))
        if name in assigned:
            headers[name] = with_crs(headers[name], assigned[name])
    if headers["elevation"].palette:
        raise InputError(
            f"{headers['elevation'].path} has a colour table: it is a map of classes or a picture, not elevations"
        )
    return headers


def _placed(values: np.ndarray, name: str, headers: Mapping[str, Header], like: Any) -> xr.DataArray:
    """Lay a plain array where `like` lies, else where the elevation does."""
    if like is not None:
        grid = grid_like(like)
    elif "elevation" in headers and headers["elevation"].north_up:
        grid = headers["elevation"].grid
    else:
        raise InputError(
            f"{name} is a plain array, which does not say where it lies; give a DataArray with coordinates and CRS, or "
            "the grid that it lies on (like=)"
        )
    return grid.dataarray(values, name)


def _of_file(
    found: LandscapeFile,
    path: Any,
    density: Any,
    legend: Any,
    density_legend: Any,
    band: dict[str, int],
    account: Account,
) -> tuple[Any, Any, Any]:
    """Fill in bands, density and legends from a landscape file where the user gave none."""
    for layer, number in found.bands.items():
        band.setdefault("dem" if layer == "elevation" else layer, number)
    legend = found.legend if legend == USUAL else legend
    told = f"landscape file: elevation in band {band['dem']}, fuel models in band {band['vegetation']}"
    if density is None and "density" in found.bands:
        density = path
        density_legend = CANOPY if density_legend == USUAL_DENSITY else density_legend
        told += f", canopy cover in band {band['density']}"
    else:
        band.pop("density", None)
    account.alignment += [f"{told}; legend {read_legend(legend).name}", f"landscape file: {found.told}"]
    return density, legend, density_legend
