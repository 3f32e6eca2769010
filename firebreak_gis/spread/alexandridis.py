"""Alexandridis: cellular automaton of vegetation type, density, slope and wind.

A burning cell l lights its neighbour k with

    p = min(1, p0 (1 + type_k) (1 + density_k) exp(a theta) exp(V (c1 + c2 (cos phi - 1))))

where theta is the slope angle from l to k in degrees (positive uphill, so fire runs uphill), V the wind speed
at l and phi the angle between the direction l -> k and the direction in which the wind blows. Cost: one pass.

The paper knows no moisture. Where the moisture m of the fine dead fuel is given, p is multiplied by the factor that
the PROPAGATOR model, an automaton of the same family, takes for the cell k that is lit:

    e(x) = 1.0003 - 1.7211 x + 6.598 x^2 - 17.331 x^3 + 22.963 x^4 - 11.507 x^5, x = m / 0.3, within 0 and 1

and 0 from the moisture of extinction, 0.3, on. Dry fuel (m = 0) gives the paper's p.

The paper knows no time either. With `clock` the model also tells how long fire takes from l to k: the way sqrt(d^2 +
dz^2) over the rate of spread at l,

    rate = base F(exp(0.1783 V cos phi)) F(exp(+-3.533 |tan theta|^1.2)) exp(-0.014 m)

with a base rate by vegetation on flat calm dry ground, + uphill and - downhill, m the moisture in percent, F keeping a
factor within 0.01 and 10, and the rate within 0.6 and 6000 m/h. The formula and its constants are PROPAGATOR's;
agricultural land has those of grass, pines those of conifers. The times are whole seconds.

Without a clock wind and slope can only act on p. With one they act on the rate, and would count twice in p: a strong
wind would kill the flanks and the back of a fire that it should hurry on. So with a clock p leaves both out unless
`probability_keeps` says otherwise (c1=0 or c2=0 keeps a part of the wind's effect). Moisture acts on both: damp fuel
catches less easily and burns more slowly.

The heat that a cell releases is that of its dead and live fuel, H = d0 L(m) + d1 L(live moisture), L(x) = h (1 - x) -
2442 x kJ/kg, with loads d0, d1, a heat content h and a live moisture by vegetation; it gives fire-line intensities.

Sources: Alexandridis, Vakalis, Siettos, Bafas 2008, doi 10.1016/j.amc.2008.06.046; Russo, Russo, Siettos
2016, doi 10.1371/journal.pone.0163226 (Table 1); moisture, rate and heat: Trucchia et al. 2020, doi
10.3390/fire3030026, and the constants of its public program.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields, replace
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
    from collections.abc import Callable

    import xarray as xr

#: An edge depends on its two cells alone, see `plugins.halo_of`.
HALO = 1
#: Powers of the share of the moisture of extinction, from 0 on.
_MOISTURE_POLYNOMIAL = (1.0003, -1.7211, 6.598, -17.331, 22.963, -11.507)
_MOISTURE_OF_EXTINCTION = 0.3
#: Heat that evaporates a kilogram of water [kJ/kg].
_EVAPORATION = 2442.0
_VEGETATION = ("agricultural", "shrubs", "pines")


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
    clock: bool = parameter(False, text="Whether to tell also how long fire takes from cell to cell")
    probability_keeps: str = parameter(
        "none",
        text="With a clock: which effects stay in the probability although they act on the rate of spread",
        choices=("none", "slope", "wind", "both"),
    )
    rate_scale: float = parameter(1.0, text="Factor of all rates of spread", minimum=0.001, maximum=1000.0)
    rate_agricultural: float = parameter(
        120.0, text="Rate of spread on agricultural land, flat, calm, dry", units="m h-1", minimum=0.0, maximum=6000.0
    )
    rate_shrubs: float = parameter(
        140.0, text="Rate of spread in shrubs, flat, calm, dry", units="m h-1", minimum=0.0, maximum=6000.0
    )
    rate_pines: float = parameter(
        200.0, text="Rate of spread in pines, flat, calm, dry", units="m h-1", minimum=0.0, maximum=6000.0
    )
    rate_wind: float = parameter(
        0.1783, text="Effect of wind on the rate of spread", units="s m-1", minimum=0.0, maximum=2.0
    )
    rate_slope: float = parameter(3.533, text="Effect of slope on the rate of spread", minimum=0.0, maximum=20.0)
    rate_slope_power: float = parameter(
        1.2, text="Power of the tangent of the slope in the rate of spread", minimum=0.1, maximum=4.0
    )
    rate_moisture: float = parameter(
        0.014, text="Effect of a percent of moisture on the rate of spread", units="%-1", minimum=0.0, maximum=1.0
    )
    factor_least: float = parameter(
        0.01, text="Least factor of wind, and of slope, in the rate of spread", minimum=1e-6, maximum=1.0
    )
    factor_greatest: float = parameter(
        10.0, text="Greatest factor of wind, and of slope, in the rate of spread", minimum=1.0, maximum=1000.0
    )
    rate_least: float = parameter(0.6, text="Least rate of spread", units="m h-1", minimum=1e-3, maximum=6000.0)
    rate_greatest: float = parameter(6000.0, text="Greatest rate of spread", units="m h-1", minimum=1.0, maximum=1e5)
    dead_agricultural: float = parameter(
        0.5, text="Dead fuel of agricultural land", units="kg m-2", minimum=0.0, maximum=100.0
    )
    dead_shrubs: float = parameter(1.0, text="Dead fuel of shrubs", units="kg m-2", minimum=0.0, maximum=100.0)
    dead_pines: float = parameter(1.0, text="Dead fuel of pines", units="kg m-2", minimum=0.0, maximum=100.0)
    live_agricultural: float = parameter(
        0.0, text="Live fuel of agricultural land", units="kg m-2", minimum=0.0, maximum=100.0
    )
    live_shrubs: float = parameter(3.0, text="Live fuel of shrubs", units="kg m-2", minimum=0.0, maximum=100.0)
    live_pines: float = parameter(4.0, text="Live fuel of pines", units="kg m-2", minimum=0.0, maximum=100.0)
    heat_agricultural: float = parameter(
        17_000.0, text="Heat content of agricultural land's fuel", units="kJ kg-1", minimum=0.0, maximum=50_000.0
    )
    heat_shrubs: float = parameter(
        21_000.0, text="Heat content of shrubs", units="kJ kg-1", minimum=0.0, maximum=50_000.0
    )
    heat_pines: float = parameter(
        21_000.0, text="Heat content of pines", units="kJ kg-1", minimum=0.0, maximum=50_000.0
    )
    moisture_agricultural: float = parameter(
        0.6, text="Moisture of the live fuel of agricultural land", minimum=0.0, maximum=1.0
    )
    moisture_shrubs: float = parameter(0.45, text="Moisture of the live fuel of shrubs", minimum=0.0, maximum=1.0)
    moisture_pines: float = parameter(0.55, text="Moisture of the live fuel of pines", minimum=0.0, maximum=1.0)


def probability(
    landscape: xr.Dataset, params: Params
) -> np.ndarray | tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
    """Return (8, rows, cols) float32 from `elevation`, `vegetation`, `density` and `burnable`.

    `vegetation_effect` and `density_effect`, where present and not NaN, take the place of the class effects. With
    `clock` the result is a `Spread`: `rate` [m/h], `dead_load`, `live_load` [kg/m2], `heat_content` [kJ/kg] and
    `live_moisture`, where present and not NaN, take the place of what the class has.

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
    speed, along = _wind(grid, params, burnable)
    moisture = _on_grid(grid, params.moisture, "moisture", burnable)
    kept, left_out = _kept(params, windy=bool(speed.any())) if params.clock else (params, "")
    wind = np.exp(speed * (kept.c1 + kept.c2 * (along - 1.0))) if kept.c1 or kept.c2 else np.ones((8, 1, 1))
    out = np.empty((8, *grid.shape), np.float32)
    periodic = landscape.attrs.get("boundary", "open") == "periodic"
    _in_bands(
        grid.shape[0],
        lambda first, last: fill_probability(
            flammability, elevation, burnable, grid.cell_size, kept.a, wind, first, last, periodic, out
        ),
    )
    _moisten(out, moisture, "periodic" if periodic else "open")
    if not params.clock:
        return out
    times = _travel_time(landscape, params, out, elevation, speed * along, moisture, grid.cell_size)
    account: dict[str, Any] = {"left_out": left_out} if left_out else {}
    if speed.size == 1 and np.ndim(params.wind_from_direction) == 0:
        account |= {"wind_speed": float(speed.flat[0]), "wind_from_direction": float(params.wind_from_direction)}
    return out, times, _heat(landscape, params, moisture), account


def _kept(params: Params, *, windy: bool) -> tuple[Params, str]:
    """Parameters of the probability under a clock, and what they leave out, in words."""
    gone: dict[str, Any] = {}
    words = []
    if params.probability_keeps in ("none", "slope") and (params.c1 or params.c2):
        gone |= {"c1": 0.0, "c2": 0.0}
        words += ["wind"] if windy else []
    if params.probability_keeps in ("none", "wind") and params.a:
        gone |= {"a": 0.0}
        words += ["slope"]
    return replace(params, **gone), " and ".join(words)


def _travel_time(
    landscape: xr.Dataset,
    params: Params,
    probability: np.ndarray,
    elevation: np.ndarray,
    tailwind: np.ndarray,
    moisture: np.ndarray,
    cell_size: float,
) -> np.ndarray:
    """Seconds along every edge, (8, rows, cols) uint32; `tailwind` is V cos phi of each direction."""
    from firebreak_gis.kernels.rate import Limits, fill_travel_time

    per_second = 1.0 / 3600.0
    limits = Limits(
        params.rate_slope,
        params.rate_slope_power,
        params.factor_least,
        params.factor_greatest,
        params.rate_least * per_second,
        params.rate_greatest * per_second,
    )
    base = _by_vegetation(landscape, params, "rate") * (params.rate_scale * per_second)
    base = base * np.exp(-params.rate_moisture * 100.0 * moisture)
    wind = np.exp(params.rate_wind * tailwind).clip(params.factor_least, params.factor_greatest)
    out = np.empty(probability.shape, np.uint32)
    _in_bands(
        base.shape[0],
        lambda first, last: fill_travel_time(probability, base, wind, elevation, cell_size, limits, first, last, out),
    )
    return out


def _heat(landscape: xr.Dataset, params: Params, moisture: np.ndarray) -> np.ndarray:
    """Heat released per area [kJ/m2], (rows, cols) float32."""
    content = _by_vegetation(landscape, params, "heat")
    released = np.zeros(content.shape)
    for load, wet in (("dead", moisture), ("live", _by_vegetation(landscape, params, "moisture"))):
        gain = content * (1.0 - wet) - _EVAPORATION * wet
        released += _by_vegetation(landscape, params, load) * np.maximum(gain, 0.0)
    return released.astype(np.float32)


#: Variable of the landscape that takes the place of the parameters of this stem.
_INSTEAD = {
    "rate": "rate",
    "dead": "dead_load",
    "live": "live_load",
    "heat": "heat_content",
    "moisture": "live_moisture",
}


def _by_vegetation(landscape: xr.Dataset, params: Params, stem: str) -> np.ndarray:
    """(rows, cols) float64 of the parameters `stem`_agricultural, _shrubs, _pines."""
    by_class = np.array([0.0, *(getattr(params, f"{stem}_{name}") for name in _VEGETATION)])
    values: np.ndarray = by_class[landscape["vegetation"].to_numpy()]
    name = _INSTEAD[stem]
    if name in landscape:
        validate(landscape, (name,))
        given = landscape[name].to_numpy()
        values = np.where(np.isnan(given), values, given)
    return values


def _in_bands(rows: int, work: Callable[[int, int], None]) -> None:
    """Call ``work(first, last)`` for bands of rows, one a thread."""
    n_bands = thread_count(None)
    edges = np.linspace(0, rows, n_bands + 1).astype(int)
    with ThreadPoolExecutor(n_bands) as pool:
        for band in [pool.submit(work, int(first), int(last)) for first, last in pairwise(edges)]:
            band.result()


def _effect(landscape: xr.Dataset, name: str, effects: tuple[float, ...]) -> np.ndarray:
    values: np.ndarray = np.array(effects)[landscape[name].to_numpy()]
    if f"{name}_effect" in landscape:
        given = landscape[f"{name}_effect"].to_numpy()
        values = np.where(np.isnan(given), values, given)
    return values


def _wind(grid: Grid, params: Params, burnable: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Wind speed, (1, 1) or (rows, cols), and cos phi of every direction, (8, 1, 1) or (8, rows, cols); float64."""
    speed = _on_grid(grid, params.wind_speed, "wind_speed", burnable)
    blows_from = _on_grid(grid, params.wind_from_direction, "wind_from_direction", burnable)
    blows_to = np.radians(blows_from + 180.0)
    azimuth = np.radians(np.array(AZIMUTH))[:, None, None]
    return speed, np.cos(azimuth - blows_to)


def _moisten(out: np.ndarray, moisture: np.ndarray, boundary: Boundary) -> None:
    """Multiply the probabilities by the effect of the moisture of the cell that is lit."""
    if not moisture.any():
        return
    share = np.minimum(moisture / _MOISTURE_OF_EXTINCTION, 1.0)
    effect = np.where(share < 1.0, np.polynomial.Polynomial(_MOISTURE_POLYNOMIAL)(share).clip(0.0, 1.0), 0.0)
    plane = np.broadcast_to(effect.astype(np.float32), out.shape[1:])
    for d in range(len(DIRECTIONS)):
        out[d] *= neighbour(plane, d, boundary)


def _on_grid(grid: Grid, value: Any, name: str, burnable: np.ndarray) -> np.ndarray:
    """(1, 1) of a number, (rows, cols) of a raster, which must be known where something burns; float64."""
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
    inside = (array >= low) & (array <= high)  # not NaN
    if not (inside | (np.isnan(array) & ~burnable)).all():
        array = array[burnable | ~np.isnan(array)]
        present = array[np.isfinite(array)]
        span = f"lies in [{present.min():g}, {present.max():g}]" if present.size else "holds no numbers"
        raise ParameterError(
            f"the raster {name} {span} with {array.size - present.size} gaps, "
            f"expected {low:g} to {high:g} {limits['units']} in every cell with fuel"
        )
    return array if inside.all() else np.where(inside, array, low)  # what is not known where nothing burns
