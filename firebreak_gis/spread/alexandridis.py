"""Cellular automaton of vegetation type, density, slope and wind.

A burning cell l lights its neighbour k with

    p = min(1, p0 (1 + type_k) (1 + density_k) exp(a theta) exp(V (c1 + c2 (cos phi - 1))))

where theta is the slope angle from l to k in degrees (positive uphill, so fire runs uphill), V the wind speed
at l and phi the angle between the direction l -> k and the direction in which the wind blows. Cost: one pass.

The paper knows no moisture. Where the moisture m of the fine dead fuel is given, p is multiplied by the factor that
the PROPAGATOR model, an automaton of the same family, takes for the cell k that is lit:

    e(x) = 1.0003 - 1.7211 x + 6.598 x^2 - 17.331 x^3 + 22.963 x^4 - 11.507 x^5, x = m / 0.3, within 0 and 1

and 0 from the moisture of extinction, 0.3, on. Dry fuel (m = 0) gives the paper's p.

Sources: Alexandridis, Vakalis, Siettos, Bafas 2008, doi 10.1016/j.amc.2008.06.046; Russo, Russo, Siettos
2016, doi 10.1371/journal.pone.0163226 (Table 1); moisture: Trucchia et al. 2020, doi 10.3390/fire3030026.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import AZIMUTH, DIRECTIONS
from firebreak_gis.network import Boundary, neighbour
from firebreak_gis.plugins import parameter
from firebreak_gis.schema import validate
from firebreak_gis.threads import thread_count

if TYPE_CHECKING:
    import xarray as xr

#: Powers of the share of the moisture of extinction, from 0 on.
_MOISTURE_POLYNOMIAL = (1.0003, -1.7211, 6.598, -17.331, 22.963, -11.507)
_MOISTURE_OF_EXTINCTION = 0.3


@dataclass(frozen=True)
class Params:
    """Parameters of the model; the defaults are those of the paper's Table 1."""

    wind_speed: Any = parameter(
        0.0, text="Wind speed at mid-flame height", units="m s-1", minimum=0.0, maximum=60.0, raster=True
    )
    wind_from_direction: Any = parameter(
        0.0,
        text="Direction the wind comes from, clockwise from north",
        units="degree",
        minimum=0.0,
        maximum=360.0,
        raster=True,
    )
    moisture: Any = parameter(
        0.0,
        text="Moisture of the fine dead fuel as a share of its dry weight: 8 % is 0.08, from 0.3 on nothing burns",
        minimum=0.0,
        maximum=1.0,
        raster=True,
    )
    p0: float = parameter(
        0.58,
        text="Spread probability on flat calm ground, shrubs of normal density",
        minimum=0.0,
        maximum=1.0,
    )
    a: float = parameter(0.078, text="Effect of slope", units="degree-1", minimum=0.0, maximum=1.0)
    c1: float = parameter(0.045, text="Effect of wind speed", units="s m-1", minimum=0.0, maximum=1.0)
    c2: float = parameter(0.131, text="Effect of wind direction", units="s m-1", minimum=0.0, maximum=1.0)
    agricultural: float = parameter(-0.3, text="Effect of agricultural land", minimum=-1.0, maximum=5.0)
    shrubs: float = parameter(0.0, text="Effect of shrubs", minimum=-1.0, maximum=5.0)
    pines: float = parameter(0.4, text="Effect of pines", minimum=-1.0, maximum=5.0)
    sparse: float = parameter(-0.4, text="Effect of sparse vegetation", minimum=-1.0, maximum=5.0)
    normal: float = parameter(0.0, text="Effect of normal vegetation", minimum=-1.0, maximum=5.0)
    dense: float = parameter(0.3, text="Effect of dense vegetation", minimum=-1.0, maximum=5.0)


def probability(landscape: xr.Dataset, params: Params) -> np.ndarray:
    """Return (8, rows, cols) float32 from `elevation`, `vegetation`, `density` and `burnable`.

    `vegetation_effect` and `density_effect`, where present and not NaN, take the place of the class effects.

    Raises
    ------
    InputError
        If a variable is missing or out of range.
    CRSError
        If the grid is not in metres.
    GridError
        If a raster of wind or moisture does not lie on the grid of the landscape.
    ParameterError
        If a raster of wind or moisture has gaps or values out of range.
    """
    from firebreak_gis.kernels.spread import fill_probability

    validate(landscape, ("elevation", "vegetation", "density", "burnable"))
    grid = Grid.of(landscape["burnable"])
    grid.require_metres("slopes")
    burnable = landscape["burnable"].to_numpy()
    elevation = landscape["elevation"].to_numpy().astype(np.float64)
    if not np.isfinite(elevation[burnable]).all():
        raise InputError("elevation is missing in cells that hold fuel; mark them as not burnable or fill the gaps")
    type_effect = _effect(landscape, "vegetation", (0.0, params.agricultural, params.shrubs, params.pines))
    density_effect = _effect(landscape, "density", (0.0, params.sparse, params.normal, params.dense))
    flammability = np.maximum(params.p0 * (1.0 + type_effect) * (1.0 + density_effect), 0.0)
    wind = _wind_factor(grid, params)
    out = np.empty((8, *grid.shape), np.float32)
    periodic = landscape.attrs.get("boundary", "open") == "periodic"
    n_bands = thread_count(None)
    edges = np.linspace(0, grid.shape[0], n_bands + 1).astype(int)
    with ThreadPoolExecutor(n_bands) as pool:
        bands = [
            pool.submit(
                fill_probability,
                flammability,
                elevation,
                burnable,
                grid.cell_size,
                params.a,
                wind,
                int(first),
                int(last),
                periodic,
                out,
            )
            for first, last in pairwise(edges)
        ]
        for band in bands:
            band.result()
    _moisten(out, _on_grid(grid, params.moisture, "moisture"), "periodic" if periodic else "open")
    return out


def _effect(landscape: xr.Dataset, name: str, effects: tuple[float, ...]) -> np.ndarray:
    values: np.ndarray = np.array(effects)[landscape[name].to_numpy()]
    if f"{name}_effect" in landscape:
        given = landscape[f"{name}_effect"].to_numpy()
        values = np.where(np.isnan(given), values, given)
    return values


def _wind_factor(grid: Grid, params: Params) -> np.ndarray:
    """(8, 1, 1) for uniform wind, (8, rows, cols) for wind rasters; float64."""
    speed = _on_grid(grid, params.wind_speed, "wind_speed")
    blows_from = _on_grid(grid, params.wind_from_direction, "wind_from_direction")
    blows_to = np.radians(blows_from + 180.0)
    azimuth = np.radians(np.array(AZIMUTH))[:, None, None]
    factor: np.ndarray = np.exp(speed * (params.c1 + params.c2 * (np.cos(azimuth - blows_to) - 1.0)))
    return factor


def _moisten(out: np.ndarray, moisture: np.ndarray, boundary: Boundary) -> None:
    """Multiply the probabilities by the effect of the moisture of the cell that is lit."""
    if not moisture.any():
        return
    share = np.minimum(moisture / _MOISTURE_OF_EXTINCTION, 1.0)
    effect = np.where(share < 1.0, np.polynomial.Polynomial(_MOISTURE_POLYNOMIAL)(share).clip(0.0, 1.0), 0.0)
    plane = np.broadcast_to(effect.astype(np.float32), out.shape[1:])
    for d in range(len(DIRECTIONS)):
        out[d] *= neighbour(plane, d, boundary)


def _on_grid(grid: Grid, value: Any, name: str) -> np.ndarray:
    """(1, 1) of a number, (rows, cols) of a raster; float64."""
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 0:
        return array.reshape(1, 1)
    if hasattr(value, "dims"):
        own = Grid.of(value)
        if grid.crs is not None:
            grid.require(own, name)
    if array.shape != grid.shape:
        raise GridError(f"{name} has shape {array.shape}, expected a number or {grid.shape}")
    limits = next(f.metadata for f in fields(Params) if f.name == name)
    low, high = limits["minimum"], limits["maximum"]
    if not ((array >= low) & (array <= high)).all():  # also catches NaN
        present = array[np.isfinite(array)]
        span = f"lies in [{present.min():g}, {present.max():g}]" if present.size else "holds no numbers"
        raise ParameterError(
            f"the raster {name} {span} with {array.size - present.size} gaps, "
            f"expected {low:g} to {high:g} {limits['units']} in every cell"
        )
    return array
