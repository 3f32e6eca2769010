"""From any rasters to one landscape: terrain, vegetation and density on one square grid in metres."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.fuel import Fuel, Lacks, fuel_of
from firebreak_gis.landscape.layers import codes_on, elevation_on
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.request import LandscapeRequest, Unknown
from firebreak_gis.landscape.surveying import Survey, survey
from firebreak_gis.memory import require_memory
from firebreak_gis.progress import Progress, silent
from firebreak_gis.schema import annotate

if TYPE_CHECKING:
    import xarray as xr


def read_landscape(
    dem: str | os.PathLike[str] | xr.DataArray,
    vegetation: str | os.PathLike[str] | xr.DataArray | None = None,
    density: str | os.PathLike[str] | xr.DataArray | None = None,
    *,
    legend: str | os.PathLike[str] | Legend = "paper",
    density_legend: str | os.PathLike[str] | Legend = "density",
    crs: Any = None,
    resolution: float | None = None,
    bounds: tuple[float, float, float, float] | None = None,
    like: str | os.PathLike[str] | Grid | xr.DataArray | None = None,
    src_crs: Mapping[str, Any] | None = None,
    src_nodata: Mapping[str, float | Sequence[float]] | None = None,
    band: Mapping[str, int] | None = None,
    unknown: Unknown = "refuse",
    strict: bool = False,
    remote: bool = False,
    max_memory: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Lay terrain, vegetation and density on one square grid in a projected CRS in metres.

    The layers may have any CRS, extent, cell size and orientation. Elevation is interpolated, classes
    are never mixed; a layer whose cells already are those of the grid is copied.

    Parameters
    ----------
    dem
        Elevation: a path, or an array with its CRS in a CF grid mapping, as rioxarray keeps it (its dims may be lat and
        lon). Feet are turned into metres where the file says so. A variable of a netCDF file by name: `a.nc:height`; a
        band by its number: `a.tif:2`. A plain numpy array lies on the grid `like`.
    vegetation
        Class codes that `legend` lists. May be left out, or be a word for the density, where `dem` is a FlamMap
        landscape (`.lcp`) or a GeoTIFF of LANDFIRE's: then fuel models and canopy cover are taken from it, with the
        legends for them. A plain numpy array, here and below, lies where `dem` does.
    density
        Class codes, or a cover, that `density_legend` lists; or one class for all fuel ("sparse",
        "normal", "dense"); or "continuity", by the share of cells with fuel in the 7 x 7 cells about each (below
        0.5 sparse, below 0.9 normal, else dense); may be left out where `legend` gives the densities.
    legend, density_legend
        Built-in name (`legends.names`), path of a CSV file, or a `Legend`.
    crs
        CRS of the result; by default that of the DEM if it is in true metres, else UTM.
    resolution
        Cell size in metres; by default that of the DEM.
    bounds
        (left, bottom, right, top) in the CRS of the result; by default what all layers cover.
    like
        Path, `Grid` or array whose grid is taken; excludes `crs`, `resolution`, `bounds`.
    src_crs, src_nodata, band
        By layer ("dem", "vegetation", "density"): the CRS in place of what the file says, value or values that
        mean "no data" (NaN: none does), and band number.
    unknown
        What codes missing from the legend are: an error, or land without fuel.
    strict
        Refuse what would only be warned of, such as undeclared "no data" values in the DEM.
    remote
        Whether network addresses and paths into archives are allowed.
    max_memory
        Limit in bytes; checked from the headers before anything is read.
    progress
        Called with the share done and a text.

    Returns
    -------
    xarray.Dataset
        `elevation` float32 [m], `vegetation` uint8 (0 none, 1 agricultural, 2 shrubs, 3 pines),
        `density` uint8 (0 none, 1 sparse, 2 normal, 3 dense), `burnable` bool, dims (y, x); with numbers
        in a legend also `vegetation_effect`, `density_effect`, and how the fuel burns: `rate` [m/h], `dead_load`,
        `live_load` [kg/m2], `heat_content` [kJ/kg], `live_moisture`; float32, NaN where the class counts.
        `attrs["alignment"]` and `attrs["warnings"]` are lists of sentences.

    Raises
    ------
    InputError
        If a layer cannot be used; `CRSError`, `GridError`, `LegendError` say more closely why.
    ParameterError
        If a parameter is impossible.
    ResourceError
        If the work would not fit into memory.

    Notes
    -----
    Memory at the peak: at most 65 B a cell of the grid, beside the part of a layer that is read at once.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> landscape = fb.read_landscape(*layers, resolution=200.0)
    >>> sorted(landscape.data_vars), landscape["elevation"].attrs["units"]
    (['burnable', 'density', 'elevation', 'vegetation'], 'm')
    """
    request = LandscapeRequest(
        dem,
        vegetation,
        density,
        legend=legend,
        density_legend=density_legend,
        crs=crs,
        resolution=resolution,
        bounds=bounds,
        like=like,
        src_crs=src_crs or {},
        src_nodata=src_nodata or {},
        bidx=band or {},
        unknown=unknown,
        strict=strict,
        remote=remote,
        max_memory=max_memory,
    )
    return read_surveyed(request, survey(request), progress=progress)


def read_surveyed(request: LandscapeRequest, found: Survey, *, progress: Progress | None = None) -> xr.Dataset:
    """Read the layers of a survey, which is used up: its account goes on.

    Parameters
    ----------
    request
        What was asked.
    found
        What `surveying.survey` found for it.
    progress
        Called with the share done and a text.

    Returns
    -------
    xarray.Dataset
        As `read_landscape` returns it, and raises.
    """
    report = progress or silent
    unknown = request.unknown
    if unknown not in ("refuse", "nonburnable"):
        raise ParameterError(f"unknown is {unknown!r}, expected refuse or nonburnable")
    layers, grid, account = found.layers, found.grid, found.account
    what = f"a landscape of {grid.shape[0]} x {grid.shape[1]} cells"
    require_memory(found.memory, what, max_memory=request.max_memory)

    report(0.1, "elevation")
    elevation = elevation_on(layers["elevation"], grid, account)
    report(0.4, "vegetation")
    codes = codes_on(layers["vegetation"], grid, "vegetation", found.legend, account)
    report(0.7, "density")
    cover: np.ndarray | str | None = found.density
    if "density" in layers:
        cover = codes_on(layers["density"], grid, "density", found.density_legend, account)
    report(0.9, "legend")
    fuel, lacks = fuel_of(codes, cover, found.legend, found.density_legend), Lacks()
    planes = planes_of(elevation, fuel, lacks)
    lacks.require(found.legends, grid, account, unknown)
    result = assembled(found, grid, planes)
    report(1.0, "landscape read")
    return result


def planes_of(elevation: np.ndarray, fuel: Fuel, lacks: Lacks) -> dict[str, np.ndarray]:
    """Variables of a landscape, or of a part of it, each (rows, cols); what lacks is added to `lacks`."""
    planes = {"elevation": elevation, "vegetation": fuel.vegetation, "density": fuel.density, **fuel.instead}
    return planes | {"burnable": lacks.add(fuel, elevation)}


def assembled(found: Survey, grid: Grid, planes: Mapping[str, np.ndarray]) -> xr.Dataset:
    """Variables on a grid as a landscape with its account so far."""
    import xarray as xr

    told = {"legend": found.legend.name, "alignment": found.account.alignment, "warnings": found.account.warnings}
    return xr.Dataset({name: annotate(grid.dataarray(values, name)) for name, values in planes.items()}, attrs=told)
