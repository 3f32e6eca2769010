"""One observed fire simulated: landscape, scar, start, weather and duration in, what the runs say of it out."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation.fire_sizes import Growth
from firebreak_gis.evaluation.nulls import mean_wind
from firebreak_gis.evaluation.validation import Forecast, Validation, judge
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape_folder
from firebreak_gis.landscape.scars import Scar, read_scar
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.progress import Progress, part, worked
from firebreak_gis.simulation.durations import Duration, as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.weather import Weather, WeatherNetworks
from firebreak_gis.simulation.weather_reading import read_weather
from firebreak_gis.spread import spread_network, weather_networks
from firebreak_gis.spread.raster import read_network

if TYPE_CHECKING:
    import xarray as xr

#: Times at which the growth of simulated fires is looked at; that of an observed fire up to twice its duration.
_TIMES = 24
_FIRST_TIME = 600.0
#: Called before the fires of the first simulation: with what burns so many runs, how many runs a simulation has, and
#: the seconds that it took to come here, so that it can be told how long all takes.
Foreseen = Callable[[Callable[[int], Any], int, float], None]


@dataclass(frozen=True)
class Case:
    """An observed fire as it is given.

    Parameters
    ----------
    landscape
        Folder that `align` writes, or the landscape itself; or a network with times (file or object) of its weather.
    scar, start
        As `scars.read_scar` takes them.
    duration
        How long the fire spread: "3h", "lognormal:3h,0.5", seconds, ...
    weather
        As `read_weather` takes it; None with a network, or for calm.
    step
        How long each line of a table of weather lasts, where it tells no times.
    name
        For messages and tables.
    """

    landscape: Any
    scar: Any
    start: Any
    duration: Any
    weather: Any = None
    step: Any = None
    name: str = "fire"


@dataclass(frozen=True)
class OpenCase:
    """An observed fire, read and laid on the grid of its landscape.

    Parameters
    ----------
    name
        As given.
    source
        The landscape; or a network.
    scar
        On the grid.
    grid, fuel
        Of the landscape; (rows, cols) bool.
    duration
        Of the fire.
    weather
        Its weather, or None.
    """

    name: str
    source: xr.Dataset | SpreadNetwork
    scar: Scar
    grid: Grid
    fuel: np.ndarray
    duration: Duration
    weather: Weather | None

    def networks(self, params: Mapping[str, Any]) -> tuple[SpreadNetwork, WeatherNetworks | None]:
        """Networks of the landscape in its weather, with a clock."""
        if isinstance(self.source, SpreadNetwork):
            if params:
                raise ParameterError(
                    f"{', '.join(params)} cannot be set where a network is given, which is made; give the landscape"
                )
            self.source.require_times("the simulation of an observed fire")
            return self.source, None
        if self.weather is None:
            return spread_network(self.source, **{"clock": True, **params}), None
        made = weather_networks(self.source, self.weather, **params)
        return made[0].network, made

    def wind(self, params: Mapping[str, Any]) -> tuple[float, float]:
        """Mean wind speed [m/s] and direction [degrees] of the weather, by the time that each lasts."""
        if self.weather is None:
            given = (params.get(name, 0.0) for name in ("wind_speed", "wind_from_direction"))
            speed, direction = (float(np.mean(np.asarray(value, dtype=np.float64))) for value in given)
            return speed, direction
        speeds, directions, shares = [], [], []
        for spell, share in zip(self.weather.spells, self.weather.shares, strict=True):
            ends = [*spell.starts[1:], spell.span or spell.starts[-1] + max(spell.starts[-1], 3600)]
            lengths = np.diff([*spell.starts, ends[-1]]).astype(np.float64)
            for step, length in zip(spell.steps, lengths / lengths.sum(), strict=True):
                speeds.append(step.wind_speed)
                directions.append(step.wind_from_direction)
                shares.append(share * length)
        return mean_wind(np.array(speeds), np.array(directions), weights=np.array(shares))


def open_case(case: Case) -> OpenCase:
    """Read an observed fire.

    Raises
    ------
    InputError, ParameterError
        If a file cannot be read, or something is missing.
    """
    source = _source(case.landscape)
    fuel = source.burnable if isinstance(source, SpreadNetwork) else source["burnable"].to_numpy()
    grid = source.grid if isinstance(source, SpreadNetwork) else Grid.of(source["burnable"])
    if isinstance(source, SpreadNetwork) and case.weather is not None:
        raise ParameterError(
            "a network is of one weather already; give the landscape (a folder that align wrote) for others"
        )
    weather = None if case.weather is None else read_weather(case.weather, step=case.step)
    scar = read_scar(case.scar, case.start, grid, fuel=fuel)
    return OpenCase(case.name, source, scar, grid, fuel, as_duration(case.duration), weather)


def run_case(
    case: OpenCase,
    params: Mapping[str, Any],
    *,
    embers: Any = None,
    n_runs: int = 200,
    seed: int = 0,
    threads: int | None = None,
    foreseen: Foreseen | None = None,
    progress: Progress | None = None,
) -> Forecast:
    """Simulate an observed fire.

    Parameters
    ----------
    case
        The fire.
    params
        Of the spread model.
    embers, n_runs, seed, threads, progress
        As in `simulate`.
    foreseen
        See `Foreseen`.
    """
    made: list[tuple[SpreadNetwork, WeatherNetworks | None]] = []
    before = worked(lambda: made.append(case.networks(params)))
    ((network, weather),) = made
    rows, cols = np.nonzero(case.scar.start & case.fuel)
    points = np.column_stack([case.grid.x[cols], case.grid.y[rows]])
    if case.duration.kind == "weather":
        assert weather is not None
        limits = weather.weather.durations(seed=seed, n_runs=n_runs)
    else:
        limits = case.duration.of_runs(seed=seed, n_runs=n_runs)
    longest = float(np.max(limits))
    times = _times(longest)
    flying = None if embers is None else as_embers(embers)
    request = FireRequest(points, "all", n_runs, seed, duration=case.duration, embers=flying)

    def fires(count: int, progress: Progress | None = None) -> tuple[xr.Dataset, xr.Dataset]:
        how: dict[str, Any] = {"weather": weather, "threads": threads}
        asked, kept = replace(request, n_runs=count), Products(quantiles=(0.5,))
        burns = burn(network, asked, products=kept, progress=part(progress, 0.0, 0.6), **how)
        # How fires grow is told by those that nobody stops.
        asked, kept = replace(asked, duration=as_duration(2.0 * longest)), Products(by=tuple(times.tolist()))
        return burns, burn(network, asked, products=kept, progress=part(progress, 0.6, 1.0), **how)

    if foreseen is not None:
        foreseen(fires, n_runs, before)
    burns, growing = fires(n_runs, progress)
    return Forecast(
        burns["burn_frequency"].to_numpy(),
        burns["arrival_time"].to_numpy()[0] / 3600.0,
        times / 3600.0,
        growing["fire_size_by"].to_numpy(),
        burns["fire_size"].to_numpy(),
    )


def validate(
    landscape: Any,
    scar: Any,
    *,
    start: Any,
    duration: Any,
    weather: Any = None,
    step: Any = None,
    embers: Any = None,
    n_runs: int = 200,
    seed: int = 0,
    threads: int | None = None,
    foreseen: Foreseen | None = None,
    progress: Progress | None = None,
    wind: tuple[float, float] | None = None,
    **params: Any,
) -> Validation:
    """Hold a simulated fire against an observed one, beside the fires that know nothing.

    Parameters
    ----------
    landscape
        Folder that `firebreak align` writes, or the landscape as `read_landscape` returns it; or a network with travel
        times (file or object), which is of one weather.
    scar, start
        The burnt area, and where the fire was first seen, see `landscape.scars.read_scar`: vector files, GeoDataFrames
        or rasters.
    duration
        How long the fire spread, such as "3h"; a distribution, such as "lognormal:3h,0.5", if that is not known well.
        The reliability of the probabilities depends on it.
    weather
        A table or a wind rose, see `read_weather`; calm if not given.
    step
        How long each line of a table lasts, such as "1h", where it tells no times: the lines follow each other.
    embers, n_runs, seed, threads, progress
        As in `simulate`.
    foreseen
        See `Foreseen`.
    wind
        Speed [m/s] and direction it comes from, for the elliptical null model alone; by default those of the weather.
    **params
        Of the spread model, such as ``rate_scale=0.5``.

    Returns
    -------
    Validation
        Scores, null models, reliability, the time at which the observed size is reached.

    Raises
    ------
    InputError, ParameterError, GridError
        If an input cannot be used.

    Examples
    --------
    A fire of an hour, held against a circle of 400 m about its start:

    >>> import geopandas as gpd
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> land = fb.read_landscape(*layers, resolution=100)
    >>> start = gpd.read_file("sample_data/ignitions.gpkg").to_crs("EPSG:32635").iloc[:1]
    >>> result = fb.validate(land, start.buffer(400), start=start, duration="1h", weather="rose:NW=4", n_runs=20)
    >>> sorted(result.beats), result.scores["none"]["growth_iou"]
    (['distance', 'ellipse', 'none'], 0.0)
    """
    case = open_case(Case(landscape, scar, start, duration, weather, step))
    how: dict[str, Any] = {"n_runs": n_runs, "seed": seed, "threads": threads}
    forecast = run_case(case, params, embers=embers, foreseen=foreseen, progress=progress, **how)
    wind = case.wind(params) if wind is None else wind
    flying = None if embers is None else as_embers(embers)
    notes = (
        f"assumed: duration {case.duration.told()}; wind of the ellipse {wind[0]:.1f} m/s from {wind[1]:.0f} degrees",
        "not simulated: fire fighting, embers" if flying is None else "not simulated: fire fighting",
        *([] if flying is None else [flying.told()]),
    )
    account = {"n_runs": n_runs, "seed": seed, "duration": case.duration.told(), "spread": dict(params)}
    account |= {"weather": None if case.weather is None else case.weather.describe()}
    return judge(forecast, case.scar, case.grid, fuel=case.fuel, wind=wind, notes=notes, account=account)


def growth_of(
    landscape: xr.Dataset,
    weather: Any,
    *,
    ignitions: Any = None,
    longest: float,
    n_runs: int,
    seed: int = 0,
    threads: int | None = None,
    foreseen: Foreseen | None = None,
    progress: Progress | None = None,
    **params: Any,
) -> Growth:
    """Simulate long fires all over a landscape and see how they grow.

    Parameters
    ----------
    landscape, weather, params
        As in `weather_networks`.
    ignitions
        See `simulate`.
    longest
        How long they grow [s].
    n_runs, seed, threads, progress
        As in `simulate`.
    foreseen
        See `Foreseen`.
    """
    made: list[WeatherNetworks] = []
    before = worked(lambda: made.append(weather_networks(landscape, weather, **params)))
    (networks,) = made
    times = np.unique(np.round(np.geomspace(_FIRST_TIME, longest, _TIMES)))
    network = networks[0].network

    def fires(count: int, progress: Progress | None = None) -> xr.Dataset:
        request = FireRequest(ignitions, "each", count, seed, duration=as_duration(float(longest)))
        kept = Products(by=tuple(times.tolist()))
        return burn(network, request, weather=networks, products=kept, threads=threads, progress=progress)

    if foreseen is not None:
        foreseen(fires, n_runs, before)
    burns = fires(n_runs, progress)
    cells = np.maximum(burns["fire_size_by"].to_numpy(), 1)
    return Growth(times, cells * network.grid.cell_area_ha)


def _source(landscape: Any) -> xr.Dataset | SpreadNetwork:
    if not isinstance(landscape, (str, os.PathLike)):
        return landscape  # type: ignore[no-any-return]
    if Path(landscape).is_dir():
        return read_landscape_folder(landscape)
    if not Path(landscape).exists():
        raise InputError(f"{landscape} does not exist; expected a folder that firebreak align wrote, or a network")
    return read_network(landscape)  # type: ignore[arg-type]


def _times(longest: float) -> np.ndarray:
    """Whole seconds, rising, up to twice the longest duration, which is among them."""
    half = np.linspace(longest / _TIMES * 2, longest, _TIMES // 2)
    return np.unique(np.round(np.append(half, half + longest)))
