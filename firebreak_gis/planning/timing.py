"""How long work will take on this machine, found by doing a little of it.

Rankings and compartments are made on two pieces of the map; how their times grow with the cells tells that of the
whole. Fires take the same time each, in the mean, so that a few tell that of all. Compiling, which comes once, is not
counted. Results do not depend on any of this.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Budget
from firebreak_gis.construction.delineations import delineate
from firebreak_gis.errors import FirebreakError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.lines import dissect_by_lines
from firebreak_gis.planning.design import design
from firebreak_gis.progress import silent, worked
from firebreak_gis.simulation.engine import in_use, using
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.ignitions import Ignitions
from firebreak_gis.simulation.windows import window_work
from firebreak_gis.stakes import Stakes
from firebreak_gis.threads import thread_count

if TYPE_CHECKING:
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.windows import MapSource

#: The larger of the two pieces that are ranked has this share of the cells, and at most so many; the other a quarter.
_PIECE, _MOST_CELLS = 1 / 16, 150_000
#: Smaller maps are ranked at once [cells]; smaller pieces tell nothing.
_SMALL = 40_000
#: Powers of the cells that costs may grow with.
_POWERS = (1.0, 2.5)
#: Of all fires that will be burnt so many are burnt for the pilot, at most so many; in a window few and more.
_PILOT, _MOST_FIRES, _IN_WINDOW = 1 / 50, 64, (8, 64)
#: A piece that is delineated has so many compartments, and at most this share of the cells.
_COMPARTMENTS, _MOST_OF_MAP = 8, 1 / 4

Now = Callable[[], float]


@dataclass(frozen=True)
class Estimate:
    """How long work will take.

    Parameters
    ----------
    steps
        Seconds by step, in order.
    without
        What takes its time beside them, and is not counted.
    """

    steps: Mapping[str, float]
    without: str = ""

    @property
    def seconds(self) -> float:
        """In all."""
        return sum(self.steps.values())

    def told(self) -> str:
        """One sentence.

        Examples
        --------
        >>> Estimate({"ranking": 40.0, "fires": 140.0}).told()
        'This takes about 3 min (ranking 40 s, fires 2.3 min), as far as a small part of it tells.'
        """
        each = ", ".join(f"{name} {_about(seconds)}" for name, seconds in self.steps.items() if seconds >= 1.0)
        rest = f", {self.without} not counted" if self.without else ""
        return f"This takes about {_about(self.seconds)} ({each}){rest}, as far as a small part of it tells."


def ranking_seconds(
    network: SpreadNetwork,
    method: str,
    *,
    stakes: Stakes,
    budget: Budget,
    elevation: Any = None,
    roads: Any = None,
    lines: bool = False,
    now: Now = time.perf_counter,
    **more: Any,
) -> float:
    """Seconds that a ranking takes, from those of two pieces of the map; 0 on small maps, or if no piece can tell.

    Parameters
    ----------
    network, method, stakes, budget, elevation, roads, more
        As in `design.design`; local search is left out.
    lines
        Whether walls are lines, which `method` and what it takes then do not tell.
    now
        Tells the time [s].
    """
    share = Budget(min(1.0, budget.cell_share(network, stakes)))
    more["refine"] = False  # the search takes as long on a piece as on a map

    def rank(rows: slice, cols: slice) -> None:
        piece = SpreadNetwork(network.probability[:, rows, cols], burnable=network.burnable[rows, cols])
        given = {name: getattr(stakes, name)[rows, cols] for name in ("cost", "protected", "difficulty")}
        for name in ("value", "ignition"):
            if (plane := getattr(stakes, name)[rows, cols]).any():  # nothing at all is refused
                given[name] = plane
        if lines:
            dissect_by_lines(piece, Stakes(piece, **given), progress=silent)
            return
        planes = {"elevation": elevation, "roads": roads}
        planes = {name: None if plane is None else np.asarray(plane)[rows, cols] for name, plane in planes.items()}
        design(piece, method, stakes=Stakes(piece, **given), budget=share, **planes, **more)

    try:
        return by_pieces(rank, network.shape, now)
    except FirebreakError:  # a piece without fuel, or without what the method needs
        return 0.0


def by_pieces(work: Callable[[slice, slice], None], shape: tuple[int, int], now: Now = time.perf_counter) -> float:
    """Seconds that work on a grid takes, by the power of the cells between two pieces from its middle.

    Parameters
    ----------
    work
        Does it on rows and columns.
    shape
        (rows, cols) of the whole.
    now
        Tells the time [s].
    """
    cells = shape[0] * shape[1]
    if cells < _SMALL:
        return 0.0
    sizes: list[int] = []
    times: list[float] = []
    largest = min(_PIECE, _MOST_CELLS / cells)
    for share in (largest / 4, largest):
        rows, cols = (_middle(n, math.sqrt(share)) for n in shape)
        if not times:  # what is loaded at the first call does not count
            work(rows, cols)
        times.append(max(worked(partial(work, rows, cols), now), 1e-9))
        sizes.append((rows.stop - rows.start) * (cols.stop - cols.start))
        if times[-1] * (cells / sizes[-1]) ** 2 < 1.0:  # short at any power
            break
    if len(times) == 1:
        return times[0] * cells / sizes[0]
    power = math.log(times[1] / times[0]) / math.log(sizes[1] / sizes[0])
    return times[1] * math.pow(cells / sizes[1], min(max(power, _POWERS[0]), _POWERS[1]))


def fire_seconds(
    ground: Ground, fires: FireRequest, *, passes: float, now: Now = time.perf_counter, **how: Any
) -> float:
    """Seconds of a run, from those of a few, which this process burns whoever burns the others.

    Parameters
    ----------
    ground, fires
        What burns, and where.
    passes
        How often all runs will be burnt: few runs are no measure of few, and too much of a pilot.
    now
        Tells the time [s].
    how
        As in `simulate`, such as `value` and `threads`.
    """
    n_runs = int(min(max(fires.n_runs * passes * _PILOT, 1.0), _MOST_FIRES, fires.n_runs))
    starts = fires.ignitions
    given = {"weather": ground.weather, "barriers": ground.barriers, **how}
    with using(None):
        for count in (1, n_runs):  # what is loaded at the first call does not count
            first = starts.first(count) if isinstance(starts, Ignitions) else starts
            few = replace(fires, n_runs=count, ignitions=first)
            seconds = worked(partial(burn, ground.network, few, **given), now)
    return seconds / n_runs / _faster(how.get("threads"))


def _faster(threads: int | None) -> float:
    """How many times the threads of this process those are that will do the work."""
    engine = in_use()
    return 1.0 if engine is None or engine.threads is None else engine.threads / thread_count(threads)


def runs_seconds(
    work: Callable[[int], Any], n_runs: int, before: float, *, times: float = 1.0, now: Now = time.perf_counter
) -> float:
    """Seconds of simulations, from those of one run and of a few; all but those before the first, which are over.

    Parameters
    ----------
    work
        Simulates so many runs.
    n_runs
        Runs of each simulation.
    before
        Seconds that each simulation takes before its first run.
    times
        How many simulations there are.
    now
        Tells the time [s].
    """
    with using(None):
        work(1)  # what is loaded at the first call does not count
        one = min(worked(partial(work, 1), now) for _ in range(2))
        count = int(min(max(n_runs * times * _PILOT, 2.0), _MOST_FIRES))
        each = _each(one, 1, worked(partial(work, count), now), count)
    return times * (max(one - each, 0.0) + each * n_runs / _faster(None)) + (times - 1.0) * before


def _each(short: float, few: int, long: float, many: int) -> float:
    """Seconds of a run, from those of a few and of many, which both take so long before.

    On a busy machine the few may have taken longer; then what comes before is not taken off.
    """
    return (long - short) / (many - few) if long > short else long / many


def window_seconds(
    source: MapSource, fires: FireRequest, *, side: int, threads: int | None = None, now: Now = time.perf_counter
) -> float:
    """Seconds that fires in windows take, from those of a few runs in two windows; each is read once, then burnt in.

    Parameters
    ----------
    source, fires, side, threads
        As in `windows.burn_windows`.
    now
        Tells the time [s].
    """
    counts, burn_in = window_work(source, fires, side=side)
    first, each = [], []
    for k in {len(counts) // 3, 2 * len(counts) // 3}:
        # One run alone mostly stays in its window; of a few, some need the larger ones, which then all share.
        few, more = (min(counts[k], most) for most in _IN_WINDOW)
        burn_in(k, 1)
        first.append(worked(partial(burn_in, k, few), now))
        if more > few:
            each.append(_each(first[-1], few, worked(partial(burn_in, k, more), now), more))
            first[-1] -= min((few - 1) * each[-1], first[-1])
    run = float(np.mean(each)) if each else 0.0
    whole = float(np.mean(first)) * len(counts) + run * (sum(counts) - len(counts))
    engine = in_use()
    there = (None if engine is None else engine.threads) or thread_count(threads)
    return whole / min(there, len(counts))


def delineation_seconds(
    network: SpreadNetwork, suitability: np.ndarray, *, size_ha: float, now: Now = time.perf_counter, **asked: Any
) -> float:
    """Seconds that compartments take, from those of a piece of the map; 0 on small maps, or if the piece cannot tell.

    All cells are looked at on each level of the nested cuts, and levels are the binary logarithm of the compartments.

    Parameters
    ----------
    network, suitability, size_ha, asked
        As in `delineations.delineate`.
    now
        Tells the time [s].
    """
    cells = network.burnable.size
    target = size_ha / network.grid.cell_area_ha
    share = min(max(_PIECE, _COMPARTMENTS * target / cells), _MOST_OF_MAP)
    if cells < _SMALL:
        return 0.0
    rows, cols = (_middle(n, math.sqrt(share)) for n in network.shape)
    transform = network.grid.transform
    piece = SpreadNetwork(
        network.probability[:, rows, cols], burnable=network.burnable[rows, cols], transform=transform
    )
    work = partial(delineate, piece, suitability[rows, cols], size_ha=size_ha, **asked)
    try:
        work()  # what is loaded at the first call does not count
        taken = worked(work, now)
    except FirebreakError:  # a piece without fuel
        return 0.0
    levels, known = (math.log2(max(n / target, 1.0) + 1.0) for n in (cells, piece.burnable.size))
    return taken * cells / piece.burnable.size * levels / known


def _middle(n: int, share: float) -> slice:
    size = max(round(n * share), 1)
    return slice((n - size) // 2, (n - size) // 2 + size)


def _about(seconds: float) -> str:
    for unit, factor in (("h", 3600.0), ("min", 60.0)):
        if seconds >= 1.5 * factor:
            return f"{seconds / factor:.2g} {unit}"
    return f"{seconds:.0f} s"
