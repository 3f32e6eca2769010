"""Fires with a clock: runs shared out among threads, weather by weather.

Every draw is keyed by the number of the run, so runs may be made in any order, on any thread, in groups of any size.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.landscape.lines import LineBreaks, on_cells
from firebreak_gis.progress import Progress, part
from firebreak_gis.simulation.durations import ENDLESS
from firebreak_gis.simulation.embers import nothing_flies, what_flies, wind_of
from firebreak_gis.simulation.engine import in_use, ranges, spread
from firebreak_gis.simulation.holding import build_walls, cleared_ground, strongest
from firebreak_gis.simulation.laid_out import THRESHOLDS, clock_of
from firebreak_gis.simulation.products import Products, add_up, in_cells, new_tally, own_sums, part_of, take_part
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.arrival import Workspace
    from firebreak_gis.kernels.tally import Tally
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.weather import WeatherNetworks
    from firebreak_gis.simulation.window import Window

#: Runs that a thread makes before it looks for the next piece.
_PIECE = 8
#: Runs of a part that another process makes, at least.
_PART = 8


class Group(NamedTuple):
    """Runs under one weather.

    Parameters
    ----------
    runs
        (n,) int64, counted from the first run of the simulation.
    network
        The network before cutting.
    times
        Travel times (8, rows, cols) in each step of the weather; none if the network has none.
    starts
        (n_steps,) uint64, when each step begins [s].
    winds
        Wind speed [m/s] and direction [degrees] of each step; none if not told.
    """

    runs: np.ndarray
    network: SpreadNetwork
    times: Sequence[np.ndarray]
    starts: np.ndarray
    winds: Sequence[tuple[float, float]]


def groups_of(
    network: SpreadNetwork,
    weather: WeatherNetworks | None,
    *,
    n_runs: int,
    first_run: int,
    seed: int,
    chosen: np.ndarray | None = None,
) -> Iterator[Group]:
    """Runs by the weather that they have, all or those that are chosen."""
    if weather is None:
        times = () if network.travel_time is None else (network.travel_time,)
        yield Group(np.arange(n_runs) if chosen is None else chosen, network, times, np.zeros(1, np.uint64), ())
        return
    for spell, every in weather.weather.groups(seed=seed, n_runs=n_runs, first_run=first_run):
        runs = every if chosen is None else every[np.isin(every - first_run, chosen)]
        if runs.size == 0:
            continue
        made = weather[spell]
        network.grid.require(made.network.grid, "the weather's networks")
        winds = [(step.wind_speed, step.wind_from_direction) for step in weather.weather.spells[spell].steps]
        yield Group(runs - first_run, made.network, made.times, made.starts, winds)


def burn_timed(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    barriers: np.ndarray | xr.DataArray | None,
    value: np.ndarray | Callable[[Group], np.ndarray] | None,
    weather: WeatherNetworks | None,
    products: Products,
    threads: int | None,
    progress: Progress | None,
    window: Window | None = None,
    reach: int = 1,
    chosen: np.ndarray | None = None,
) -> Tally:
    """Burn the runs of a request, and return the sums of what is asked, sizes in cells.

    Parameters
    ----------
    network
        The network before cutting; where a weather is given, any of its networks.
    request
        The fires.
    start
        Ignitions of the runs.
    limits
        (n_runs,) int64, how long each burns [s]; `durations.ENDLESS`.
    breaks, barriers
        See `holding.build_walls`.
    value
        (n_cells,) float64 lost where a cell burns, or what tells it for a group of runs, or None.
    weather
        Networks of the weather that the runs draw.
    products
        What is asked beside counts and sizes.
    threads, progress
        As in `fires.simulate`.
    window, reach
        If the network is a window of a map: which, and how far from a cell of it fire may come out of nothing [cells].
        A run that burns within `reach` of the window's rim counts as `reached`, and is not in the sums.
    chosen
        Numbers of the runs that are made, counted from the first; None: all.
    """
    fires: dict[str, Any] = {
        "network": network,
        "request": request,
        "start": start,
        "limits": limits,
        "breaks": breaks,
        "barriers": barriers,
        "value": value,
        "weather": weather,
        "products": products,
    }
    # Windows are parts themselves, and arrivals run by run are too large to be sent.
    if in_use() is None or window is not None or products.arrivals:
        fires |= {"window": window, "reach": reach, "chosen": chosen}
        return in_cells(_burn_here(**fires, threads=threads, progress=progress))
    runs = np.arange(request.n_runs) if chosen is None else chosen
    if weather is not None:  # those of one weather together, so that few workers need its network
        spells = weather.weather.of_runs(seed=request.seed, n_runs=request.n_runs, first_run=start.first_run)
        runs = runs[np.argsort(spells[runs], kind="stable")]
    total = _tally(network, products, request.n_runs, limits, value, breaks)
    pieces = [runs[first:last] for first, last in ranges(runs.size, _PART)]
    fires |= {"request": request.settled(network.grid)}
    fires |= {name: on_cells(network, fires[name], name) for name in ("breaks", "barriers")}

    def take(i: int, made: Mapping[str, np.ndarray]) -> None:
        take_part(total, pieces[i], made)

    spread(timed_part, pieces, fires, take=take, threads=threads, progress=progress)
    return in_cells(total)


def timed_part(piece: np.ndarray, *, threads: int | None, progress: Progress, **fires: Any) -> dict[str, np.ndarray]:
    """Burn some of the runs of `burn_timed`; see `products.part_of`."""
    return part_of(_burn_here(**fires, threads=threads, progress=progress, chosen=piece), piece)


def _burn_here(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    barriers: np.ndarray | xr.DataArray | None,
    value: np.ndarray | Callable[[Group], np.ndarray] | None,
    weather: WeatherNetworks | None,
    products: Products,
    threads: int | None,
    progress: Progress | None,
    window: Window | None = None,
    reach: int = 1,
    chosen: np.ndarray | None = None,
) -> Tally:
    """Burn runs on the threads of this process."""
    n_runs = request.n_runs
    by_group = value if callable(value) else None
    rim = None if window is None or window.whole else window.rim(reach)
    total = _tally(network, products, n_runs, limits, value, breaks, rim)
    spaces = Spaces()
    tallies = _Tallies(total)
    done = 0
    for ready in made_ready(
        network,
        request,
        start,
        limits,
        breaks=breaks,
        barriers=barriers,
        weather=weather,
        flame_lengths=products.flame_lengths,
        window=window,
        chosen=chosen,
    ):
        group, intensity = ready.group, ready.intensity
        heat = total.heat if group.network.heat is None else group.network.heat.ravel()
        shown = np.zeros(0, np.float32) if intensity is None else intensity.ravel()
        own = {"heat": heat, "value": total.value if by_group is None else by_group(group)}
        piece = partial(_burn_piece, ready, spaces, tallies, own, shown)
        report = part(progress, done / n_runs, (done + group.runs.size) / n_runs)
        pieces = [group.runs[i : i + _PIECE] for i in range(0, group.runs.size, _PIECE)]
        run_pieces(piece, pieces, threads=threads, progress=report, message="burning")
        done += group.runs.size
    add_up(total, tallies.made)
    return total


def _tally(
    network: SpreadNetwork,
    products: Products,
    n_runs: int,
    limits: np.ndarray,
    value: np.ndarray | Callable[[Group], np.ndarray] | None,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    rim: np.ndarray | None = None,
) -> Tally:
    worth = np.zeros(network.burnable.size) if callable(value) else value
    parts = isinstance(breaks, LineBreaks)
    return new_tally(network, products, n_runs, longest=longest_of(limits), value=worth, by_parts=parts, rim=rim)


def longest_of(limits: np.ndarray) -> int:
    """How long the longest run burns [s]; `durations.ENDLESS` if one ends by itself."""
    ends = limits[limits < ENDLESS]
    return int(ends.max()) if ends.size == limits.size else ENDLESS


class Ready(NamedTuple):
    """What the kernels of fires with a clock are given for a group of runs.

    Parameters
    ----------
    group
        The runs, and their weather.
    given
        The first arguments of `kernels.arrival.burn_timed`, up to the workspace.
    span
        Of the workspace, see `kernels.arrival.workspace`.
    intensity
        Of the fastest fire of each cell, where it was needed.
    """

    group: Group
    given: tuple[Any, ...]
    span: int
    intensity: np.ndarray | None


def made_ready(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    barriers: np.ndarray | xr.DataArray | None,
    weather: WeatherNetworks | None,
    flame_lengths: Sequence[float] = (),
    window: Window | None = None,
    chosen: np.ndarray | None = None,
) -> Iterator[Ready]:
    """Make ready what burns, weather by weather; parameters as in `burn_timed`."""
    from firebreak_gis.kernels.arrival import Starts
    from firebreak_gis.kernels.draws import run_keys
    from firebreak_gis.kernels.percolation import steps

    n_runs, seed, first_run = request.n_runs, request.seed, start.first_run
    keys = {purpose: run_keys(seed, purpose, n_runs, first_run) for purpose in ("edges", "hold", "embers", "ground")}
    longest = longest_of(limits)
    at = np.zeros(start.cells.size, np.uint64) if start.at is None else start.at.astype(np.uint64)
    starts = Starts(start.starts, start.cells, at, limits.astype(np.uint64))
    periodic = network.boundary == "periodic"
    place = {} if window is None else {"corner": window.corner, "map_cols": window.map_shape[1]}
    grid_steps = steps(network.shape, periodic=periodic, **place)
    called = request.called
    crews = None if called is None else called.arrival(network.grid, request.holding.length)
    for group in groups_of(network, weather, n_runs=n_runs, first_run=first_run, seed=seed, chosen=chosen):
        intensity = _intensity(group, request, flame_lengths)
        walls = build_walls(
            group.network,
            keys["hold"],
            breaks=breaks,
            residual=request.residual,
            hold=request.holding,
            barriers=barriers,
            barriers_hold=request.barriers_hold,
            intensity=intensity,
            window=window,
            crews=crews,
        )
        cleared = cleared_ground(group.network, keys["ground"], breaks, request.holding, intensity)
        flying = nothing_flies(keys["embers"])
        if request.embers is not None:
            group.network.require_times("embers")
            flying = what_flies(
                request.embers,
                group.network,
                keys["embers"],
                times=group.times,
                winds=group.winds or [wind_of(request.embers, group.network)],
            )
        clock, span = clock_of(group.times, group.starts, longest, embers=request.embers is not None)
        given = (
            THRESHOLDS.of([group.network.probability]),
            keys["edges"],
            grid_steps,
            clock,
            starts,
            walls,
            cleared,
            flying,
        )
        yield Ready(group, given, span, intensity)


def containment(
    network: SpreadNetwork, request: FireRequest, start: Ignitions, limits: np.ndarray, **fires: Any
) -> tuple[np.ndarray, np.ndarray]:
    """When crews contain the fire of each run [s], (n_runs,) int64; `ENDLESS` where they do not.

    To know how a direct attack goes, the runs are burnt up to it, in a window of the map if `fires` say so. The second
    array tells which of them came to its rim, (n_runs,) bool.
    """
    crews, near = request.crews, np.zeros(request.n_runs, bool)
    if crews is None:
        return np.full(request.n_runs, ENDLESS), near
    network.require_times("containment")
    at = crews.of_runs(seed=request.seed, n_runs=request.n_runs, first_run=start.first_run)
    if not crews.attack:
        return at, near
    network.require_heat("containment by direct attack")
    fires = {"progress": None, "value": _Fierce(crews.intensity), "products": Products(), **fires}
    met = burn_timed(network, request, start, np.minimum(limits, at), **fires)
    return np.where(crews.succeeds(met.sizes, met.lost, network.grid), at, ENDLESS), met.reached


@dataclass(frozen=True)
class _Fierce:
    """1 in the cells whose strongest fire is above an intensity [kW/m], else 0."""

    intensity: float

    def __call__(self, group: Group) -> np.ndarray:
        each = [strongest(group.network, "containment by direct attack", times) for times in group.times]
        return np.asarray(np.mean(each, axis=0) > self.intensity, np.float64).ravel()


def _burn_piece(
    ready: Ready,
    spaces: Spaces,
    tallies: _Tallies,
    own: Mapping[str, Any],
    strongest: np.ndarray,
    runs: np.ndarray,
) -> None:
    """Burn a few runs on the calling thread."""
    from firebreak_gis.kernels.arrival import burn_timed as burn_runs

    tally = tallies.mine()._replace(**own)
    burn_runs(*ready.given, spaces.mine(tally.counts.size, ready.span), runs, tally, strongest)


def _intensity(group: Group, request: FireRequest, flame_lengths: Sequence[float]) -> np.ndarray | None:
    """Intensity of the fastest fire of each cell, the mean over the steps, where it is needed."""
    if request.holding.share is not None and not flame_lengths:
        return None
    what = "flame lengths" if flame_lengths else "hold by flames"
    group.network.require_times(what)
    each = [strongest(group.network, what, times) for times in group.times]
    return np.asarray(sum(each) / np.float32(len(each)), np.float32)


class Spaces:
    """Workspaces of the threads, used again from weather to weather."""

    def __init__(self) -> None:
        self._own = threading.local()

    def mine(self, n_cells: int, span: int) -> Workspace:
        """Workspace of the calling thread."""
        from firebreak_gis.kernels.arrival import workspace

        kept: Workspace | None = getattr(self._own, "space", None)
        if kept is None or kept.queue.heads.size - 1 <= span:
            kept = workspace(n_cells, span)
            self._own.space = kept
        return kept


class _Tallies:
    """Sums that each thread makes for itself."""

    def __init__(self, total: Tally) -> None:
        self._total = total
        self._own = threading.local()
        self.made: list[Tally] = []

    def mine(self) -> Tally:
        if not hasattr(self._own, "tally"):
            self._own.tally = own_sums(self._total)
            self.made.append(self._own.tally)
        tally: Tally = self._own.tally
        return tally
