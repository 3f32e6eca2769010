"""Monte-Carlo fires on a spread network, with and without breaks.

The share of the runs in which a cell burns is its burn probability, given one fire.

Every edge is tried once a run with a draw keyed by (seed, run, edge). The same run therefore meets the same
open edges with and without breaks, and neither the number of threads nor the order of runs changes a result.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.progress import Progress, part
from firebreak_gis.schema import annotate
from firebreak_gis.simulation.containment import as_containment
from firebreak_gis.simulation.durations import ENDLESS, as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.holding import as_hold
from firebreak_gis.simulation.ignitions import IgnitionMode, Ignitions, resolve_ignitions
from firebreak_gis.simulation.products import Products, product_maps
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.stations import as_travel
from firebreak_gis.simulation.timed import burn_timed, containment
from firebreak_gis.simulation.timeless import burn_all
from firebreak_gis.stakes import checked_amounts

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.network import Residual, SpreadNetwork
    from firebreak_gis.simulation.weather import Weather, WeatherNetworks


def simulate(
    network: SpreadNetwork,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None = None,
    residual: Residual = 0.0,
    value: np.ndarray | xr.DataArray | None = None,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    ignition_times: Any = None,
    n_runs: int = 100,
    first_run: int = 0,
    seed: int = 0,
    duration: Any = None,
    weather: WeatherNetworks | None = None,
    embers: Any = None,
    containment: Any = None,
    hold: Any = None,
    stations: Any = None,
    roads: Any = None,
    crew_travel: Any = None,
    barriers: np.ndarray | xr.DataArray | None = None,
    barriers_hold: float = 1.0,
    products: Products | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the network `n_runs` times.

    Parameters
    ----------
    network
        The spread network before cutting.
    breaks
        (y, x), above 0 where the fuel is cut; or lines with a width, from `line_breaks`. Ignitions are drawn before
        cutting; one that falls on a cut cell burns nothing.
    residual
        Share of its spread probability that a treated cell keeps, one number or (y, x); 0 is a perfect break.
    value
        (y, x) value lost when the cell burns, finite and >= 0 on fuel; then the result holds `value_lost`.
    ignitions, ignition_mode, ignition_times
        See `firebreak_gis.simulation.ignitions.resolve_ignitions`; default: one random cell with fuel a run, lit at
        once. Without a clock the times do not matter.
    n_runs
        Number of runs. Run i is the same for any number of runs.
    first_run
        Number of the first run: runs 0 to 99 and runs 100 to 199 are together the first 200.
    seed
        Seed of the draws; the same seed gives the same fires with and without breaks.
    duration
        How long each fire burns: seconds, or a text such as "8h", a list of them that the runs take in turn,
        "lognormal:8h,0.7", "uniform:2h,12h", or "weather". Default: until it ends by itself. Needs travel times.
    weather
        Networks of an ensemble of weathers, from `spread.weather_networks`, of which each run draws one; `network` is
        then any of them.
    embers
        True, or `embers.Embers`: embers that fly ahead of the fire. Needs travel times, heat and a wind.
    containment
        When crews contain each fire: what `duration` takes, or "attack:1h", a direct attack that fails where the fire
        is large or fierce by then, or `containment.Containment`. Default: never. Needs travel times.
    hold
        How often a stretch of break holds in a run: a share, "flame", or `holding.Hold`. Default: always.
    stations, roads, crew_travel
        Points that crews set out from, lines that they drive on, and "road=40,off=3,delay=10" [km/h, min]: breaks hold
        only against fire that comes after them, see `stations`. Default: crews are everywhere. Needs travel times.
    barriers
        (y, x), above 0 on roads, rivers and the like which the network holds as fuel, and which may fail.
    barriers_hold
        How often a stretch of them holds in a run.
    products
        What else is kept of the runs.
    threads
        Threads to use; changes the speed only.
    progress
        Callback (share done, message); raise `Cancelled` in it to stop.

    Returns
    -------
    xarray.Dataset
        `burn_count` (y, x) uint32, `burn_frequency` (y, x) float32 (NaN where there is no fuel),
        `fire_size` (run) int64 [cells], float64 with lines, as the ground under lines that hold does not burn, and what
        `products` asks. With a clock also `duration` (run) [s], with crews
        `containment` (run) [s], with a weather `weather` (run), its number.

    Raises
    ------
    ParameterError, InputError, GridError
        If a parameter is out of range, an ignition cannot burn, `breaks` lies on another grid, or the network lacks
        times, heat or a wind that are needed.

    Notes
    -----
    With the same seed a run has the same open edges, ignitions, duration, weather, embers and failing stretches,
    whatever is cut, so that cutting more never lets any cell burn earlier. (With embers in weather that changes with
    time it can: a fire that was held up may throw its embers in a stronger wind.)

    Memory: 32 B a cell for the draw thresholds and up to 100 B a cell and thread, whatever the number of
    runs; with a clock 32 B a cell more for each step of the weather.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> breaks = fb.select_breaks(fb.rank(network, "compartments"), budget=0.1)
    >>> before, after = fb.simulate(network, n_runs=50), fb.simulate(network, breaks=breaks, n_runs=50)
    >>> bool(after["fire_size"].mean() < before["fire_size"].mean())
    True
    """
    request = FireRequest(
        ignitions,
        ignition_mode,
        n_runs,
        seed,
        residual,
        duration=None if duration is None else as_duration(duration),
        hold=None if hold is None else as_hold(hold),
        barriers_hold=barriers_hold,
        embers=as_embers(embers),
        ignition_times=ignition_times,
        containment=as_containment(containment),
        stations=stations,
        roads=roads,
        crew_travel=None if crew_travel is None else as_travel(crew_travel),
    )
    request.require_stations()
    return burn(
        network,
        request,
        breaks=breaks,
        value=value,
        weather=weather,
        barriers=barriers,
        products=products,
        first_run=first_run,
        threads=threads,
        progress=progress,
    )


def burn(
    network: SpreadNetwork,
    request: FireRequest,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None = None,
    value: np.ndarray | xr.DataArray | None = None,
    weather: WeatherNetworks | None = None,
    barriers: np.ndarray | xr.DataArray | None = None,
    products: Products | None = None,
    first_run: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn the network as a request says; all else as in `simulate`."""
    network.kept_share(request.residual)  # refused before anything burns
    start = resolved(network, request, first_run=first_run)
    worth = None if value is None else checked_amounts(network, value, "value").ravel()
    plain = request.timeless and weather is None and barriers is None
    asked = products or Products()
    if asked.needs_times:
        network.require_times("when fire comes")
    if plain:
        span = progress if products is None else part(progress, 0.0, 0.5)
        counts, sizes, lost = burn_all(network, request, start, breaks, worth, threads, span)
        burns = burn_maps(network, counts, sizes, seed=request.seed, lost=None if worth is None else lost)
        progress = part(progress, 0.5, 1.0)
    if request.duration is not None and not request.duration.endless:
        network.require_times("a duration")
    if request.called is not None:
        network.require_times("the way of crews (stations)")
    limits, spells = limits_of(request, None if weather is None else weather.weather, first_run)
    if plain and products is None:
        return burns if request.duration is None else burns.assign(duration=_ends(limits))
    fires: dict[str, Any] = {"breaks": breaks, "barriers": barriers, "weather": weather, "threads": threads}
    ends = contained = limits
    if request.crews is not None:
        contained, _ = containment(network, request, start, limits, progress=part(progress, 0.0, 0.3), **fires)
        ends, progress = np.minimum(limits, contained), part(progress, 0.3, 1.0)
    tally = burn_timed(network, request, start, ends, value=worth, products=asked, progress=progress, **fires)
    if not plain:
        counts = tally.counts.reshape(network.shape)
        burns = burn_maps(network, counts, tally.sizes, seed=request.seed, lost=None if worth is None else tally.lost)
    burns = burns.assign(product_maps(network, asked, tally))
    return burns.assign(told_of_runs(request, limits, contained, spells))


def told_of_runs(
    request: FireRequest, limits: np.ndarray, contained: np.ndarray, spells: np.ndarray | None
) -> dict[str, xr.DataArray]:
    """What is told of each run beside its size, as far as it is asked: `duration`, `containment`, `weather`."""
    told = {}
    if request.duration is not None:
        told["duration"] = _ends(limits)
    if request.crews is not None:
        told["containment"] = of_runs("containment", _infinite(contained))
    if spells is not None:
        told["weather"] = of_runs("weather", spells)
    return told


def limits_of(request: FireRequest, weather: Weather | None, first_run: int) -> tuple[np.ndarray, np.ndarray | None]:
    """How long each run burns [s], (n_runs,) int64, and its weather if there is any."""
    runs: dict[str, Any] = {"seed": request.seed, "n_runs": request.n_runs, "first_run": first_run}
    spells = None if weather is None else weather.of_runs(**runs)
    if request.duration is None:
        return np.full(request.n_runs, ENDLESS), spells
    if request.duration.kind == "weather":
        if weather is None:
            raise ParameterError("the duration is to be as the weather tells, but no weather is given")
        return np.maximum(np.rint(weather.durations(**runs)), 1).astype(np.int64), spells
    return request.duration.of_runs(**runs), spells


def resolved(network: SpreadNetwork, request: FireRequest, *, first_run: int = 0) -> Ignitions:
    """Where the fires of a request start, see `ignitions.resolve_ignitions`."""
    return resolve_ignitions(
        network,
        request.ignitions,
        mode=request.ignition_mode,
        n_runs=request.n_runs,
        first_run=first_run,
        seed=request.seed,
        outside=request.ignitions_outside,
        times=request.ignition_times,
    )


def burn_maps(
    network: SpreadNetwork, counts: np.ndarray, sizes: np.ndarray, *, seed: int, lost: np.ndarray | None = None
) -> xr.Dataset:
    """Dataset of `simulate` from burnt runs a cell, burnt cells a run and value lost a run."""
    import xarray as xr

    n_runs = sizes.size
    frequency = np.full(counts.shape, np.nan, np.float32)
    np.divide(counts, n_runs, out=frequency, where=network.burnable, dtype=np.float32, casting="unsafe")
    planes = {"burn_count": counts, "burn_frequency": frequency}
    runs = {"fire_size": sizes} if lost is None else {"fire_size": sizes, "value_lost": lost}
    return xr.Dataset(
        {
            **{name: annotate(network.grid.dataarray(plane, name)) for name, plane in planes.items()},
            **{name: of_runs(name, each) for name, each in runs.items()},
        },
        attrs={"n_runs": n_runs, "seed": seed, "n_burnable": network.n_burnable},
    )


def _ends(limits: np.ndarray) -> xr.DataArray:
    """How long each run may burn [s], infinite without an end."""
    return of_runs("duration", _infinite(limits))


def _infinite(times: np.ndarray) -> np.ndarray:
    return np.where(times >= ENDLESS, np.inf, times.astype(np.float64))


def of_runs(name: str, values: np.ndarray) -> xr.DataArray:
    """Return a number a run as the variable of that name."""
    import xarray as xr

    return annotate(xr.DataArray(values, dims="run", name=name))
