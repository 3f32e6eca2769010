"""Where fires start: random cells, given points, or a map of how likely each cell is."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.kernels.draws import stream_key, uniforms
from firebreak_gis.simulation.request import IgnitionMode
from firebreak_gis.vectors import is_vector, read_points

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork

__all__ = ["IgnitionMode", "Ignitions", "resolve_ignitions"]


@dataclass(frozen=True)
class Ignitions:
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
    """

    starts: np.ndarray
    cells: np.ndarray
    first_run: int = 0
    at: np.ndarray | None = None


def resolve_ignitions(
    network: SpreadNetwork,
    ignitions: Any = None,
    *,
    mode: IgnitionMode = "each",
    n_runs: int,
    first_run: int = 0,
    seed: int,
) -> Ignitions:
    """Decide the ignition cells of every run.

    Parameters
    ----------
    network
        The network before any cutting, so that runs with and without breaks start alike.
    ignitions
        None: one cell a run, uniform over the cells that hold fuel. A raster on the grid (array, DataArray or
        path of a raster): one cell a run, drawn in proportion to its values. Points (sequence of (x, y) in
        the CRS of the network, GeoDataFrame, GeoSeries or path of a vector file, reprojected): used as `mode`
        says. `Ignitions` of these runs, decided earlier for this network: returned as they are.
    mode
        `"each"`: run i starts at point i modulo their number. `"all"`: every run starts at all points.
    n_runs
        Number of runs, at least 1. Run i is the same for any number of runs.
    first_run
        Number of the first run.
    seed
        Seed of the draws.

    Raises
    ------
    ParameterError
        If `n_runs`, `seed` or `mode` is impossible.
    InputError
        If a point lies outside the grid or on a cell without fuel, or the raster has no weight on fuel.
    """
    for name, number, least in (("n_runs", n_runs, 1), ("first_run", first_run, 0), ("seed", seed, 0)):
        if not isinstance(number, (int, np.integer)) or isinstance(number, bool) or number < least:
            raise ParameterError(f"{name} is {number!r}, expected a whole number of at least {least}")
    if mode not in ("each", "all"):
        raise ParameterError(f"ignition mode is {mode!r}, expected 'each' or 'all'")
    if network.n_burnable == 0:
        raise InputError("no cell of the network holds fuel, so nothing can burn; check the legend and the layers")
    if isinstance(ignitions, Ignitions):
        if (ignitions.first_run, ignitions.starts.size - 1) != (first_run, n_runs):
            raise ParameterError(
                f"the ignitions are those of {ignitions.starts.size - 1} runs from run {ignitions.first_run}, expected "
                f"{n_runs} runs from run {first_run}"
            )
        return ignitions
    if isinstance(ignitions, (str, os.PathLike)) and not is_vector(ignitions):
        from firebreak_gis.rasters import read_raster

        ignitions = read_raster(ignitions)
    weights = _weights(network, ignitions)
    if weights is not None:
        cumulative = np.cumsum(weights)
        draw = uniforms(stream_key(seed, "ignitions"), n_runs, first_run) * cumulative[-1]
        cells = np.searchsorted(cumulative, draw, side="right")
        return Ignitions(np.arange(n_runs + 1), cells.astype(np.int64), first_run)
    points = _point_cells(network, ignitions)
    if mode == "all":
        return Ignitions(np.arange(n_runs + 1) * points.size, np.tile(points, n_runs), first_run)
    runs = np.arange(first_run, first_run + n_runs)
    return Ignitions(np.arange(n_runs + 1), points[runs % points.size], first_run)


def _weights(network: SpreadNetwork, ignitions: Any) -> np.ndarray | None:
    """Weight of every cell, (n_cells,) float64; None if `ignitions` are points."""
    if ignitions is None:
        return network.burnable.ravel().astype(np.float64)
    is_plane = isinstance(ignitions, np.ndarray) and ignitions.shape == network.shape
    if not (is_plane or hasattr(ignitions, "dims")):
        return None
    plane = network.plane(ignitions, "the ignition raster").astype(np.float64)
    plane = np.where(np.isnan(plane), 0.0, plane)
    if (plane < 0).any() or not np.isfinite(plane).all():
        raise InputError("the ignition raster has negative or infinite values, expected probabilities or weights")
    plane = np.where(network.burnable, plane, 0.0)
    if plane.sum() == 0.0:
        raise InputError("the ignition raster is zero on every cell that holds fuel, so no fire can start")
    return plane.ravel()


def _point_cells(network: SpreadNetwork, ignitions: Any) -> np.ndarray:
    if isinstance(ignitions, (str, os.PathLike)) or hasattr(ignitions, "geometry"):
        points = read_points(ignitions, network.grid.crs)
        x, y = points.geometry.x.to_numpy(), points.geometry.y.to_numpy()
    else:
        try:
            pairs = np.asarray(ignitions, dtype=np.float64)
        except (TypeError, ValueError):
            raise ParameterError(
                f"ignitions are {str(ignitions)[:80]!r}, expected (n, 2) coordinates, a raster or points"
            ) from None
        if pairs.ndim == 1 and pairs.size == 2:
            pairs = pairs[None]
        if pairs.ndim != 2 or pairs.shape[1] != 2 or pairs.shape[0] == 0:
            raise ParameterError(f"ignitions have shape {pairs.shape}, expected (n, 2) coordinates, a raster or points")
        x, y = pairs[:, 0], pairs[:, 1]
    cells = network.grid.cells_of(x, y)
    problems = []
    for i, cell in enumerate(cells.tolist()):
        if cell < 0:
            problems.append(f"point {i + 1} ({x[i]:.6g}, {y[i]:.6g}) lies outside the grid {network.grid.describe()}")
        elif not network.burnable.ravel()[cell]:
            row, col = divmod(cell, network.shape[1])
            problems.append(
                f"point {i + 1} ({x[i]:.6g}, {y[i]:.6g}) lies on a cell without fuel (row {row}, col {col})"
            )
    if problems:
        shown = "; ".join(problems[:5]) + (f"; and {len(problems) - 5} more" if len(problems) > 5 else "")
        raise InputError(f"ignitions cannot burn: {shown}; move or remove them")
    return cells
