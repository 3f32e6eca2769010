"""Where fires start: random cells, points, polygons that burn already, or a map of how likely each cell is."""

from __future__ import annotations

import itertools
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.kernels.draws import stream_key, uniforms
from firebreak_gis.landscape.footprints import footprints
from firebreak_gis.landscape.planes import ignition_source
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.schema import Shown
from firebreak_gis.simulation.request import IgnitionMode, Outside
from firebreak_gis.stakes import checked_amounts
from firebreak_gis.vectors import is_vector

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.network import SpreadNetwork

__all__ = ["IgnitionMode", "Ignitions", "Outside", "Places", "ignition_places", "resolve_ignitions"]


@dataclass(frozen=True, repr=False)
class Ignitions(Shown):
    """Ignition cells of every run.

    Parameters
    ----------
    starts
        (n_runs + 1,) int64.
    cells
        Row-major cell numbers; run i ignites ``cells[starts[i]:starts[i + 1]]``.
    first_run
        Number of the first run.
    at
        When each of them is lit [s after the start of the run]; None: at once.
    notes
        Sentences on what was left out or done.
    """

    starts: np.ndarray
    cells: np.ndarray
    first_run: int = 0
    at: np.ndarray | None = None
    notes: tuple[str, ...] = ()

    def first(self, n_runs: int) -> Ignitions:
        """Those of the first runs alone."""
        return self.of_runs(0, n_runs)

    def of_runs(self, first: int, last: int) -> Ignitions:
        """Those of the runs from `first` to before `last` alone, counted from the first run."""
        starts = self.starts[first : last + 1]
        own = slice(starts[0], starts[-1])
        at = None if self.at is None else self.at[own]
        return Ignitions(starts - starts[0], self.cells[own], self.first_run + first, at, self.notes)

    def facts(self) -> dict[str, object]:
        """How many runs start in how many cells, as `repr` shows it."""
        return {"runs": self.starts.size - 1, "cells": self.cells.size}


@dataclass(frozen=True, eq=False, repr=False)
class Places(Shown):
    """Where fires may start on one network.

    Parameters
    ----------
    weights
        (n_cells,) float64: how likely a fire starts in each cell, relative to the others; or bool: in which it starts,
        alike. None for single places.
    starts, cells
        Place k is ``cells[starts[k]:starts[k + 1]]``: one cell of a point, all with fuel that a polygon cuts.
    notes
        Sentences on what was left out or done.
    at
        (n_places,) uint64, when each place is lit [s after the start of a run]; None: at once.
    """

    weights: np.ndarray | None
    starts: np.ndarray
    cells: np.ndarray
    notes: tuple[str, ...] = ()
    at: np.ndarray | None = None

    def facts(self) -> dict[str, object]:
        """How many places, or cells that are likely, as `repr` shows it."""
        if self.weights is not None:
            return {"cells": int(np.count_nonzero(self.weights)), "lit": "by their weights"}
        return {"places": self.starts.size - 1, "cells": self.cells.size}


def ignition_places(
    network: SpreadNetwork, source: Any = None, *, outside: Outside = "refuse", times: Any = None
) -> Places:
    """Find the cells where fires may start.

    Parameters
    ----------
    network
        The network before any cutting.
    source
        None: every cell with fuel alike. A raster (path, on any grid, or an array on this one): in proportion to its
        values. Points or polygons (path of a vector file, GeoDataFrame, GeoSeries, in any CRS) or a sequence of
        (x, y) in the CRS of the network: at these. A polygon is the perimeter of a fire: all cells with fuel that it
        cuts burn from the start.
    outside
        Points and polygons outside the grid or without fuel: `"refuse"` them, or `"drop"` them with a note.
    times
        When each point or polygon is lit [s after the start of a run]: as many numbers, or the name of a column that
        tells it in hours. Default: at once.

    Returns
    -------
    Places
        To be given as `ignitions` wherever fires are simulated.

    Raises
    ------
    ParameterError
        If `outside` is neither.
    InputError
        If a place cannot burn, none is left, or weights are NaN on fuel, negative, infinite or all zero.

    Examples
    --------
    >>> import numpy as np
    >>> from firebreak_gis import SpreadNetwork
    >>> network = SpreadNetwork(np.full((8, 4, 5), 0.5))  # cells of 1 x 1, rows from y = 0 to -4
    >>> places = ignition_places(network, [(0.5, -0.5), (99.0, 0.0)], outside="drop")
    >>> places.cells
    array([0])
    >>> places.notes
    ('ignitions: 1 of 2 were left out, 1 outside the grid and 0 on cells without fuel',)
    """
    if outside not in ("refuse", "drop"):
        raise ParameterError(f"ignitions outside are {outside!r}, expected 'refuse' or 'drop'")
    if network.n_burnable == 0:
        raise InputError("no cell of the network holds fuel, so nothing can burn; check the legend and the layers")
    nowhere = np.zeros(0, np.int64)
    account = Account()
    weights = _weights(network, source, account)
    if weights is not None and times is not None:
        raise ParameterError("times of ignitions need points or polygons that are lit, and cells are drawn here")
    if weights is not None:
        return Places(weights, np.zeros(1, np.int64), nowhere, tuple(account.alignment + account.warnings))
    if is_vector(source):
        groups, words, frame = _drawn_groups(network, source, account)
    else:
        (groups, words), frame = _pairs(network, source), None
    lit = None if times is None else _lit_at(times, frame, len(groups))
    fuel = network.burnable.ravel()
    problems, kept, there, off = [], [], [], 0
    for i, (group, word) in enumerate(zip(groups, words, strict=True)):
        burning = group[fuel[group]]
        if burning.size:
            kept.append(burning)
            there.append(i)
            continue
        off += not group.size
        where = f"outside the grid {network.grid.describe()}"
        if group.size:
            row, col = divmod(int(group[0]), network.shape[1])
            where = f"on {'a cell' if group.size == 1 else 'cells'} without fuel (row {row}, col {col})"
        problems.append(f"{word} lies {where}")
    if problems and (outside == "refuse" or not kept):
        shown = "; ".join(problems[:5]) + (f"; and {len(problems) - 5} more" if len(problems) > 5 else "")
        remedy = "--ignitions-outside drop leaves them out" if kept else "none is left"
        raise InputError(f"{len(problems)} of {len(groups)} ignitions cannot burn ({remedy}): {shown}")
    if problems:
        account.alignment.append(
            f"ignitions: {len(problems)} of {len(groups)} were left out, {off} outside the grid and "
            f"{len(problems) - off} on cells without fuel"
        )
    if perimeters := sum(word.startswith("polygon") for word in words):
        account.alignment.append(
            f"ignitions: {perimeters} polygons are perimeters, of which all cells with fuel burn from the start"
        )
    starts = np.concatenate(([0], np.cumsum([group.size for group in kept])))
    notes = tuple(account.alignment + account.warnings)
    return Places(None, starts, np.concatenate(kept), notes, None if lit is None else lit[there])


def resolve_ignitions(
    network: SpreadNetwork,
    ignitions: Any = None,
    *,
    mode: IgnitionMode = "each",
    n_runs: int,
    first_run: int = 0,
    seed: int,
    outside: Outside = "refuse",
    times: Any = None,
) -> Ignitions:
    """Decide the ignition cells of every run.

    Parameters
    ----------
    network
        The network before any cutting, so that runs with and without breaks start alike.
    ignitions
        As the `source` of `ignition_places`, or its result. From weights one cell a run is drawn; places are used as
        `mode` says. `Ignitions` of these runs, decided earlier for this network: returned as they are.
    mode
        `"each"`: the runs take the places in turn, in an order drawn by the seed, so that fewer runs than places start
        all over the map. `"all"`: every run starts at all places. `"density"`: they are fires of the past; one cell a
        run is drawn from their middles, smoothed by a Gaussian kernel with the bandwidth of Scott 1992 (doi
        10.1002/9780470316849), at least 500 m.
    n_runs
        Number of runs, at least 1. Run i is the same for any number of runs.
    first_run
        Number of the first run.
    seed
        Seed of the draws.
    outside, times
        As in `ignition_places`.

    Raises
    ------
    ParameterError
        If `n_runs`, `seed` or `mode` is impossible.
    InputError
        If a point lies outside the grid or on a cell without fuel, or the raster has no weight on fuel.
    """
    places = ignitions
    if not isinstance(places, (Places, Ignitions)):
        places = ignition_places(network, ignitions, outside=outside, times=times)
    require_runs(places, mode=mode, n_runs=n_runs, first_run=first_run, seed=seed)
    if isinstance(ignitions, Ignitions):
        if (ignitions.first_run, ignitions.starts.size - 1) != (first_run, n_runs):
            raise ParameterError(
                f"the ignitions are those of {ignitions.starts.size - 1} runs from run {ignitions.first_run}, expected "
                f"{n_runs} runs from run {first_run}"
            )
        return ignitions
    weights = _density(network, places) if mode == "density" else places.weights
    if weights is not None:
        cells = _drawn(weights, uniforms(stream_key(seed, "ignitions"), n_runs, first_run), network.shape)
        return Ignitions(np.arange(n_runs + 1), cells, first_run, notes=places.notes)
    if mode == "all":
        all_lit = None if places.at is None else np.tile(np.repeat(places.at, np.diff(places.starts)), n_runs)
        all_cells = np.tile(places.cells, n_runs)
        return Ignitions(np.arange(n_runs + 1) * places.cells.size, all_cells, first_run, all_lit, places.notes)
    n_places = places.starts.size - 1
    order = np.argsort(uniforms(stream_key(seed, "places"), n_places), kind="stable")
    turn = order[np.arange(first_run, first_run + n_runs) % n_places]
    first, size = places.starts[turn], np.diff(places.starts)[turn]
    starts = np.concatenate(([0], np.cumsum(size)))
    within = np.arange(starts[-1]) - np.repeat(starts[:-1], size)
    lit = None if places.at is None else np.repeat(places.at[turn], size)
    return Ignitions(starts, places.cells[np.repeat(first, size) + within], first_run, lit, places.notes)


def _drawn(weights: np.ndarray, draws: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """Cells drawn by their weights, (n_runs,) int64; `draws` are uniform in [0, 1)."""
    if weights.dtype != np.bool_:
        cumulative = np.cumsum(weights)
        return np.asarray(np.searchsorted(cumulative, draws * cumulative[-1], side="right"), np.int64)
    # The same numbers, without eight bytes for each cell of a large map.
    plane = weights.reshape(shape)
    until = np.cumsum(np.count_nonzero(plane, axis=1))
    rank = np.floor(draws * float(until[-1])).astype(np.int64)
    rows = np.searchsorted(until, rank, side="right")
    cells = np.empty(draws.size, np.int64)
    for i, (row, nth) in enumerate(zip(rows.tolist(), rank.tolist(), strict=True)):
        before = int(until[row - 1]) if row else 0
        cells[i] = row * shape[1] + np.flatnonzero(plane[row])[nth - before]
    return cells


def require_runs(
    places: Places | Ignitions, *, mode: IgnitionMode, n_runs: int, first_run: int = 0, seed: int = 0
) -> None:
    """Refuse what no run can be drawn with; parameters as in `resolve_ignitions`.

    Raises
    ------
    ParameterError
        Naming the parameter.
    """
    for name, number, least in (("n_runs", n_runs, 1), ("first_run", first_run, 0), ("seed", seed, 0)):
        if not isinstance(number, (int, np.integer)) or isinstance(number, bool) or number < least:
            raise ParameterError(f"{name} is {number!r}, expected a whole number of at least {least}")
    if mode not in get_args(IgnitionMode):
        raise ParameterError(f"ignition mode is {mode!r}, expected one of {', '.join(get_args(IgnitionMode))}")
    if mode == "density" and isinstance(places, Places) and places.weights is not None:
        raise ParameterError("a density of past fires needs points or polygons of them (--ignitions)")


def _density(network: SpreadNetwork, places: Places) -> np.ndarray:
    """Density of fires in places on the cells with fuel, (n_cells,) float64."""
    from scipy import ndimage

    row, col = (np.add.reduceat(axis, places.starts[:-1]) for axis in np.divmod(places.cells, network.shape[1]))
    n = np.diff(places.starts)
    middle = np.array([row / n, col / n])
    size = network.grid.cell_size
    bandwidth = max(float(np.std(middle, axis=1).mean()) * size * n.size ** (-1 / 6), 500.0)
    counts = np.zeros(network.shape)
    np.add.at(counts, tuple(np.floor(middle + 0.5).astype(np.int64)), 1.0)
    wrap = "wrap" if network.boundary == "periodic" else "constant"
    return np.where(network.burnable, ndimage.gaussian_filter(counts, bandwidth / size, mode=wrap), 0.0).ravel()


def _lit_at(times: Any, frame: gpd.GeoDataFrame | None, n: int) -> np.ndarray:
    """When each of n features is lit, (n,) uint64 [s]."""
    if isinstance(times, str):
        if frame is None or times not in frame.columns:
            known = "" if frame is None else f"; there are {', '.join(map(str, frame.columns.drop('geometry')))}"
            raise InputError(f"the ignitions have no column {times!r} that tells when they are lit{known}")
        seconds = 3600.0 * np.asarray(frame[times], dtype=np.float64)
    else:
        seconds = np.asarray(times, dtype=np.float64).ravel()
    if seconds.size != n or not ((seconds >= 0) & (seconds < 2.0**32)).all():
        raise InputError(
            f"the times of the ignitions are {seconds.size} numbers, expected {n}, none missing or below 0"
        )
    return np.rint(seconds).astype(np.uint64)


def _weights(network: SpreadNetwork, source: Any, account: Account) -> np.ndarray | None:
    """Weight of every cell as in `Places`, greatest between 0.5 and 1; None if `source` are places."""
    if source is None:
        return network.burnable.ravel()
    if isinstance(source, np.ndarray):
        if source.shape != network.shape:
            return None
        plane = source
    elif hasattr(source, "dims"):
        plane = source
    elif isinstance(source, (str, os.PathLike)) and not is_vector(source):
        plane = np.asarray(ignition_source(source, network.grid, account))
    else:
        return None
    plane = checked_amounts(network, plane, "the ignition raster")
    if not plane.any():
        raise InputError("the ignition raster is zero on every cell that holds fuel, so no fire can start")
    # By a power of two, which changes no draw; the sum of weights near the greatest number would be infinite.
    return np.asarray(np.ldexp(plane.ravel(), -int(np.frexp(plane.max())[1])))


def _drawn_groups(
    network: SpreadNetwork, source: Any, account: Account
) -> tuple[list[np.ndarray], list[str], gpd.GeoDataFrame]:
    """Cells of every point and polygon, what to call it, and the features."""
    from firebreak_gis.vectors import read_starts

    frame = read_starts(source, network.grid.crs, explode=False)
    account.alignment.extend(f"ignitions: {note}" for note in frame.attrs["notes"])
    # Each point of a multipoint is a fire of its own; a polygon of several parts is one fire.
    is_point = frame.geometry.geom_type.str.contains("Point")
    frame = _apart(frame, is_point.to_numpy())
    prints = footprints(frame, network.grid)
    bounds = np.searchsorted(prints.feature, np.arange(len(frame) + 1))
    groups = [prints.cell[one:two] for one, two in itertools.pairwise(bounds)]
    middle = frame.geometry.representative_point()
    kinds = ["point" if name == "Point" else "polygon" for name in frame.geometry.geom_type]
    words = [
        f"{kind} {i} ({x:.6g}, {y:.6g})"
        for i, (kind, x, y) in enumerate(zip(kinds, middle.x, middle.y, strict=True), start=1)
    ]
    # Points on edges of cells belong where they belong everywhere else.
    cells = network.grid.cells_of(middle.x.to_numpy(), middle.y.to_numpy())
    for i in np.flatnonzero(np.array(kinds) == "point").tolist():
        groups[i] = cells[i : i + 1][cells[i : i + 1] >= 0]
    return groups, words, frame


def _apart(frame: gpd.GeoDataFrame, chosen: np.ndarray) -> gpd.GeoDataFrame:
    """Take the chosen features apart, in place."""
    import pandas as pd

    parts = frame[chosen].explode(index_parts=False)
    return pd.concat([parts, frame[~chosen]]).sort_index(kind="stable").reset_index(drop=True)


def _pairs(network: SpreadNetwork, source: Any) -> tuple[list[np.ndarray], list[str]]:
    """Cells of (x, y) pairs, and what to call each."""
    try:
        pairs = np.asarray(source, dtype=np.float64)
    except (TypeError, ValueError):
        raise ParameterError(
            f"ignitions are {str(source)[:80]!r}, expected (n, 2) coordinates, a raster, points or polygons"
        ) from None
    if pairs.ndim == 1 and pairs.size == 2:
        pairs = pairs[None]
    if pairs.ndim != 2 or pairs.shape[1] != 2 or pairs.shape[0] == 0:
        raise ParameterError(
            f"ignitions have shape {pairs.shape}, expected (n, 2) coordinates, a raster, points or polygons"
        )
    cells = network.grid.cells_of(pairs[:, 0], pairs[:, 1])
    groups = [np.array([cell] if cell >= 0 else [], np.int64) for cell in cells.tolist()]
    return groups, [f"point {i} ({x:.6g}, {y:.6g})" for i, (x, y) in enumerate(pairs.tolist(), start=1)]
