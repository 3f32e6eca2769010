"""Fires with a clock on a map that need not fit into memory: each burns in a window around its start.

A fire of some hours reaches a few kilometres. So the map is read by windows, as large as the fires in them need: a fire
that comes to the rim of its window burns again in one of twice the side. All draws belong to runs and to cells of the
map, so windows of any size, on any thread, give the fires of the whole map, run by run. Memory: 5 B a cell of the map
(where there is fuel, how often it burns) and about 300 B a cell of the windows at work, one a thread.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Protocol, cast

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.progress import silent
from firebreak_gis.simulation.durations import ENDLESS
from firebreak_gis.simulation.engine import in_use, ranges, spread, using
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.window import Window, tiles
from firebreak_gis.stakes import checked_amounts
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from collections.abc import Mapping

    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.weather import Weather

    Plane = np.ndarray | xr.DataArray

#: Side of the windows in which fires burn first [cells].
SIDE = 512


class MapSource(Protocol):
    """A map that is read by windows."""

    @property
    def grid(self) -> Grid:
        """Of the whole map."""

    @property
    def burnable(self) -> np.ndarray:
        """(rows, cols) bool: where there is fuel."""

    @property
    def weather(self) -> Weather | None:
        """Of which each run draws one, or None."""

    def read(self, window: Window) -> tuple[Ground, np.ndarray | LineBreaks | None]:
        """What fires burn on in a window, and the breaks there: (rows, cols) above 0, or lines."""


def breaks_in(window: Window, breaks: np.ndarray | LineBreaks | None, grid: Grid) -> np.ndarray | LineBreaks | None:
    """Breaks on the grid of a map, in a window of it."""
    if breaks is None:
        return None
    if isinstance(breaks, LineBreaks):
        return breaks.part(*window.slices, window.grid(grid))
    return breaks[window.slices]


class _FuelMap:
    """What is asked of a network where fires start: where fuel is, and where a plane of cells lies."""

    def __init__(self, source: MapSource) -> None:
        self.grid, self.burnable, self.boundary = source.grid, source.burnable, "open"
        self.shape = source.grid.shape
        self.provenance: dict[str, Any] = {}

    @cached_property
    def n_burnable(self) -> int:
        return int(np.count_nonzero(self.burnable))

    mask = SpreadNetwork.mask
    plane = SpreadNetwork.plane


def fuel_map(source: MapSource) -> SpreadNetwork:
    """Stand-in for the network of a map that is not in memory, for `resolve_ignitions` and the like."""
    return cast("SpreadNetwork", _FuelMap(source))


def burn_windows(
    source: MapSource,
    request: FireRequest,
    *,
    side: int | None = None,
    value: Plane | None = None,
    first_run: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn a map by windows; equal, to the bit, to `fires.burn` of the whole.

    Parameters
    ----------
    source
        The map, its breaks and barriers.
    request
        The fires; they must have an end, or every one may need the whole map.
    side
        Of the windows in which fires burn first [cells], a power of two; None: `SIDE`.
    value
        (rows, cols) value lost where a cell burns, or None.
    first_run, threads, progress
        As in `fires.simulate`.

    Returns
    -------
    xarray.Dataset
        `burn_count`, `burn_frequency` (y, x) and what `fires.burn` tells of each run.

    Raises
    ------
    ParameterError
        If the side is no power of two of at least 16, or breaks hold by flames or by crews that travel, for which a
        window does not know enough of the map.

    Examples
    --------
    >>> import numpy as np, firebreak_gis as fb
    >>> from firebreak_gis.simulation.request import FireRequest
    >>> from firebreak_gis.simulation.durations import Duration
    >>> from firebreak_gis.simulation.ground_fires import MapInMemory
    >>> network = fb.SpreadNetwork(np.full((8, 90, 80), 0.8), travel_time=np.full((8, 90, 80), 600.0))
    >>> request = FireRequest(n_runs=5, duration=Duration("fixed", (3600.0,)))
    >>> burns = burn_windows(MapInMemory(network), request, side=16)
    >>> bool((burns["fire_size"] == fb.simulate(network, n_runs=5, duration="1h")["fire_size"]).all())
    True
    """
    from firebreak_gis.simulation.fires import resolved

    side = side or SIDE
    _require_windows(request, side)
    fuel = fuel_map(source)
    worth = None if value is None else checked_amounts(fuel, value, "value")
    start = resolved(fuel, request, first_run=first_run)
    return _Work(source, request, start, progress or silent, worth).all(side, threads).burns(fuel)


def passing_windows(
    source: MapSource,
    request: FireRequest,
    *,
    value: np.ndarray,
    side: int | None = None,
    first_run: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> np.ndarray:
    """Value that each cell lets through, (rows, cols) float64 in the mean of the fires; see `passing`.

    Parameters and errors as in `burn_windows`.
    """
    from firebreak_gis.simulation.fires import resolved

    side = side or SIDE
    _require_windows(request, side)
    start = resolved(fuel_map(source), request, first_run=first_run)
    work = _Work(source, request, start, progress or silent, value, passing=True)
    return work.all(side, threads).passed()


def window_work(
    source: MapSource, request: FireRequest, *, side: int = SIDE
) -> tuple[list[int], Callable[[int, int], None]]:
    """What `burn_windows` has to do, and a means to do a little of it, to tell how long all takes.

    Returns
    -------
    list of int, callable
        How many runs burn in each of the first windows; and what burns the first `count` of those in window `k`,
        called as ``burn(k, count)``, on one thread.
    """
    from firebreak_gis.simulation.fires import resolved

    _require_windows(request, side)
    work = _Work(source, request, resolved(fuel_map(source), request), silent)
    windows = work.windows(side)

    def burn(k: int, count: int) -> None:
        waiting = [(windows[k][0][:count], side)]
        with using(None):
            while waiting:
                waiting = work.burn(waiting, 1)

    return [runs.size for runs, _ in windows], burn


def _require_windows(request: FireRequest, side: int) -> None:
    """Refuse what windows of a side cannot burn, see `burn_windows`."""
    if side < 16 or side & (side - 1):
        raise ParameterError(f"windows have a side of {side} cells, expected a power of two of at least 16")
    if request.holding.share is None:
        raise ParameterError("breaks that hold by flames need the map as a whole; give --hold a share, or no windows")
    if request.called is not None:
        raise ParameterError("the way of crews needs the map as a whole; leave the stations out, or the windows")


#: Numbers of runs, and the side of the window in which they burn first.
_Batch = tuple[np.ndarray, int]


def window_part(batches: Sequence[_Batch], **work: Any) -> dict[str, np.ndarray]:
    """Burn runs in windows of a map, one after the other.

    Returns
    -------
    dict
        `cells` of the map that burn and `counts`, how often, or what they let through; `runs` that are through, with
        `sizes` and `lost` (0 where it is told what cells let through) and `contained`; and those that need a `larger`
        window, with the number of the batch that each is `of`.
    """
    made = [_burn_window(batch, **work) for batch in batches]
    for k, each in enumerate(made):
        each["of"] = np.full(each["larger"].size, k)
    return {name: np.concatenate([each[name] for each in made]) for name in made[0]}


def _burn_window(
    batch: _Batch,
    *,
    source: MapSource,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    value: np.ndarray | None,
    passing: bool,
    threads: int | None,
    progress: Progress,
) -> dict[str, np.ndarray]:
    """Burn runs in a window; returns what `window_part` does."""
    from firebreak_gis.simulation.passing import let_through
    from firebreak_gis.simulation.timed import burn_timed, containment

    runs, side = batch
    window, start = _window(source.grid.shape, start, runs, side)
    ground, breaks = source.read(window)
    if np.ndim(request.residual):
        request = replace(request, residual=np.asarray(request.residual)[window.slices])
    embers = request.embers
    fires: dict[str, Any] = {
        "breaks": breaks,
        "barriers": ground.barriers,
        "weather": ground.weather,
        "threads": threads,
        "window": window,
        "reach": 1 if embers is None else int(embers.longest / ground.network.grid.cell_size) + 2,
        "progress": progress,
    }
    contained, left = np.full(request.n_runs, ENDLESS), runs
    if request.crews is not None:
        contained, far = containment(ground.network, request, start, limits, chosen=runs, **fires)
        left = runs[~far[runs]]
    ends = np.minimum(limits, contained)
    worth = None if value is None else value[window.slices].ravel()
    sizes, lost = np.zeros(request.n_runs, np.int64), np.zeros(request.n_runs)
    if passing and worth is not None:
        given = {name: fires[name] for name in ("breaks", "barriers", "weather", "window", "reach")}
        counts, reached = let_through(ground.network, request, start, ends, value=worth, chosen=left, **given)
    else:
        tally = burn_timed(ground.network, request, start, ends, value=worth, products=Products(), chosen=left, **fires)
        counts, reached, sizes = tally.counts, tally.reached, tally.sizes
        lost = lost if worth is None else tally.lost
    left = left[~reached[left]]
    burnt = np.flatnonzero(counts)
    return {
        "cells": window.on_map(burnt),
        "counts": counts[burnt],
        "runs": left,
        "sizes": sizes[left],
        "lost": lost[left],
        "contained": contained[left],
        "larger": np.setdiff1d(runs, left),
    }


def _window(map_shape: tuple[int, int], start: Ignitions, runs: np.ndarray, side: int) -> tuple[Window, Ignitions]:
    """The window in which runs start, and their ignitions in it."""
    own = np.zeros(start.cells.size, bool)
    for run in runs.tolist():
        own[start.starts[run] : start.starts[run + 1]] = True
    own &= start.cells >= 0
    row, col = np.divmod(start.cells[own], map_shape[1])
    window = Window.around(int(row.min()), int(col.min()), int(row.max()), int(col.max()), map_shape, side)
    cells = np.full(start.cells.size, -1)
    cells[own] = window.local(start.cells[own])
    return window, replace(start, cells=cells)


class _Work:
    """What the fires have come to so far; whole numbers, so that the order of the windows makes no difference.

    What cells let through is kept window by window, and added up in their order.
    """

    def __init__(
        self,
        source: MapSource,
        request: FireRequest,
        start: Ignitions,
        progress: Progress,
        value: np.ndarray | None = None,
        *,
        passing: bool = False,
    ) -> None:
        from firebreak_gis.simulation.fires import limits_of

        self.start = start
        self._source, self._request, self._progress = source, request, progress
        self._limits, self._spells = limits_of(request, source.weather, start.first_run)
        self._shared: dict[str, Any] = {
            "source": source,
            "request": request.settled(source.grid),
            "start": start,
            "limits": self._limits,
            "value": value,
            "passing": passing,
        }
        self._lost = None if value is None else np.zeros(request.n_runs)
        self._passed: list[tuple[np.ndarray, np.ndarray]] = []
        self._contained = np.full(request.n_runs, ENDLESS)
        self._counts = np.zeros(0 if passing else source.grid.shape[0] * source.grid.shape[1], np.uint32)
        self._sizes = np.zeros(request.n_runs, np.int64)
        self._done = 0
        self._lock = threading.Lock()

    def windows(self, side: int) -> list[_Batch]:
        """The runs of each of the first windows, and their side."""
        start = self.start
        return [(runs, side) for runs in tiles(start.cells, start.starts, self._source.grid.shape, side // 2)]

    def all(self, side: int, threads: int | None) -> _Work:
        """Burn all runs, those that need it in larger windows."""
        batches = self.windows(side)
        while batches:
            batches = self.burn(batches, threads)
        return self

    def burn(self, batches: list[_Batch], threads: int | None) -> list[_Batch]:
        """Burn runs in windows of about the side of each batch; return those that need a larger one, with it."""
        alone = in_use() is None
        pieces = (
            [batches[first:last] for first, last in ranges(len(batches), 1)] if not alone else [[b] for b in batches]
        )
        again: dict[int, list[_Batch]] = {}
        passed: dict[int, tuple[np.ndarray, np.ndarray]] = {}

        def take(i: int, part: Mapping[str, np.ndarray]) -> None:
            with self._lock:
                # A cell may burn in several windows of a part.
                if self._shared["passing"]:
                    passed[i] = part["cells"], part["counts"]
                else:
                    np.add.at(self._counts, part["cells"], part["counts"])
                if self._lost is not None:
                    self._lost[part["runs"]] = part["lost"]
                self._sizes = self._sizes.astype(part["sizes"].dtype, copy=False)  # parts of cells with lines
                self._sizes[part["runs"]] = part["sizes"]
                self._contained[part["runs"]] = part["contained"]
                self._done += part["runs"].size
                again[i] = [(part["larger"][part["of"] == k], 2 * pieces[i][k][1]) for k in np.unique(part["of"])]

        def report(share: float, message: str) -> None:  # noqa: ARG001
            self._progress(self._done / self._request.n_runs, "burning windows")

        if alone:
            run_pieces(
                lambda i: take(i, window_part(pieces[i], threads=1, progress=silent, **self._shared)),
                range(len(pieces)),
                threads=threads,
                progress=report,
                message="burning windows",
            )
        else:
            spread(window_part, pieces, self._shared, take=take, threads=threads, progress=report)
        self._passed += [passed[i] for i in sorted(passed)]
        return [batch for i in sorted(again) for batch in again[i]]

    def passed(self) -> np.ndarray:
        """Value that each cell lets through in the mean of the fires, (rows, cols) float64."""
        out = np.zeros(self._source.grid.shape)
        for cells, values in self._passed:
            np.add.at(out.ravel(), cells, values)
        out /= self._request.n_runs
        return out

    def burns(self, fuel: SpreadNetwork) -> xr.Dataset:
        """The result as `fires.burn` returns it."""
        from firebreak_gis.simulation.fires import burn_maps, told_of_runs

        counts = self._counts.reshape(fuel.shape)
        burns = burn_maps(fuel, counts, self._sizes, seed=self._request.seed, lost=self._lost)
        return burns.assign(told_of_runs(self._request, self._limits, self._contained, self._spells))
