"""From any rasters to one landscape: terrain, vegetation and density on one square grid in metres."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import InputError, LegendError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.alignment import plan
from firebreak_gis.landscape.fuel import Fuel, burnable_cells, fuel_of
from firebreak_gis.landscape.layers import codes_on, elevation_on
from firebreak_gis.landscape.resampling import BLOCK
from firebreak_gis.landscape.target_grid import Account, choose_grid
from firebreak_gis.legends import Legend, read_legend
from firebreak_gis.memory import require_memory
from firebreak_gis.progress import Progress, silent
from firebreak_gis.rasters import Header, header_of_array, read_header
from firebreak_gis.schema import DENSITY, annotate

if TYPE_CHECKING:
    import xarray as xr


def read_landscape(
    dem: str | os.PathLike[str] | xr.DataArray,
    vegetation: str | os.PathLike[str] | xr.DataArray,
    density: str | os.PathLike[str] | xr.DataArray | None = None,
    *,
    legend: str | os.PathLike[str] | Legend = "paper",
    density_legend: str | os.PathLike[str] | Legend = "density",
    crs: Any = None,
    resolution: float | None = None,
    bounds: tuple[float, float, float, float] | None = None,
    like: str | os.PathLike[str] | Grid | xr.DataArray | None = None,
    src_nodata: Mapping[str, float | Sequence[float]] | None = None,
    band: Mapping[str, int] | None = None,
    unknown: Literal["refuse", "nonburnable"] = "refuse",
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
        Elevation: a path, or an array with CRS as rioxarray keeps it. Feet are turned into metres
        where the file says so.
    vegetation
        Class codes that `legend` lists.
    density
        Class codes, or a cover, that `density_legend` lists; or one class for all fuel ("sparse",
        "normal", "dense"); may be left out where `legend` gives the densities.
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
    src_nodata, band
        By layer ("dem", "vegetation", "density"): value or values that mean "no data", and band number.
    unknown
        What codes missing from the legend are: an error, or land without fuel.
    strict
        Refuse undeclared "no data" values in the DEM instead of masking them.
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
        in a legend also `vegetation_effect`, `density_effect` float32, NaN where the class counts.
        `attrs["alignment"]` and `attrs["warnings"]` are lists of sentences.

    Raises
    ------
    InputError
        If a layer cannot be used; `CRSError`, `GridError`, `LegendError` say more closely why.
    ParameterError
        If a parameter is impossible.
    ResourceError
        If the work would not fit into memory.
    """
    report = progress or silent
    if unknown not in ("refuse", "nonburnable"):
        raise ParameterError(f"unknown is {unknown!r}, expected refuse or nonburnable")
    table, density_table = _legends(legend, density_legend, density)
    constant = density if isinstance(density, str) and density in DENSITY.values() else None
    sources = {"elevation": dem, "vegetation": vegetation}
    if density is not None and constant is None:
        sources["density"] = density
    layers = _headers(sources, src_nodata or {}, band or {}, remote)
    account = Account()
    grid = choose_grid(layers, account, crs=crs, resolution=resolution, bounds=bounds, like=like)
    require_memory(
        memory_needed(layers, grid),
        f"a landscape of {grid.shape[0]} x {grid.shape[1]} cells",
        max_memory=max_memory,
    )

    report(0.1, "elevation")
    elevation = elevation_on(layers["elevation"], grid, account, strict)
    report(0.4, "vegetation")
    codes = codes_on(layers["vegetation"], grid, "vegetation", table, account)
    report(0.7, "density")
    cover = codes_on(layers["density"], grid, "density", density_table, account) if "density" in layers else None
    report(0.9, "legend")
    fuel = fuel_of(codes, cover if constant is None else constant, table, density_table, grid, account, unknown)
    result = _assemble(grid, elevation, fuel, account)
    result.attrs.update(legend=table.name, alignment=account.alignment, warnings=account.warnings)
    report(1.0, "landscape read")
    return result


def memory_needed(layers: Mapping[str, Header], grid: Grid) -> int:
    """Estimate the peak memory of `read_landscape` in bytes, from the headers alone."""
    cells = grid.shape[0] * grid.shape[1]
    largest = 0
    for header in layers.values():
        how = plan(header, grid)
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
            f"no density: the legend {table.name} gives none. Give a density raster, or one class for all "
            f"fuel "
            '(density="normal"), or a legend with densities (see legends.names() or firebreak legends)'
        )
    if not density_table.has_density:
        raise LegendError(f"the density legend {density_table.name} does not give the density of every code")
    return table, density_table


def _headers(
    sources: Mapping[str, Any], src_nodata: Mapping[str, Any], band: Mapping[str, int], remote: bool
) -> dict[str, Header]:
    public = {"dem": "elevation", "elevation": "elevation", "vegetation": "vegetation", "density": "density"}
    for word, mapping in (("src_nodata", src_nodata), ("band", band)):
        wrong = set(mapping) - set(public)
        if wrong:
            raise ParameterError(f"{word} names {', '.join(sorted(wrong))}, expected dem, vegetation or density")
    nodata = {public[key]: value for key, value in src_nodata.items()}
    bands = {public[key]: value for key, value in band.items()}
    headers = {}
    for name, source in sources.items():
        if isinstance(source, str | os.PathLike):
            headers[name] = read_header(source, band=bands.get(name), src_nodata=nodata.get(name), remote=remote)
        else:
            headers[name] = header_of_array(source, src_nodata=nodata.get(name))
    if headers["elevation"].palette:
        raise InputError(
            f"{headers['elevation'].path} has a colour table: it is a map of classes or a picture, not elevations"
        )
    return headers


def _assemble(grid: Grid, elevation: np.ndarray, fuel: Fuel, account: Account) -> xr.Dataset:
    import xarray as xr

    layers: dict[str, np.ndarray] = {
        "elevation": elevation,
        "vegetation": fuel.vegetation,
        "density": fuel.density,
    }
    if fuel.vegetation_effect is not None:
        layers["vegetation_effect"] = fuel.vegetation_effect
    if fuel.density_effect is not None:
        layers["density_effect"] = fuel.density_effect
    burnable = burnable_cells(layers)
    blind = int(np.count_nonzero((fuel.vegetation > 0) & (fuel.density > 0) & ~np.isfinite(elevation)))
    if blind:
        account.warnings.append(
            f"{blind} cells with fuel have no elevation and are taken as not burnable "
            f"({blind / burnable.size:.2%} of the grid)"
        )
    if not burnable.any():
        raise InputError(
            "no cell can burn: nowhere do vegetation, density and elevation meet; check the legend and "
            "the no-data values"
        )
    layers["burnable"] = burnable
    return xr.Dataset({name: annotate(grid.dataarray(values, name)) for name, values in layers.items()})
