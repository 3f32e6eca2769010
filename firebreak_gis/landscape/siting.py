"""Where a line can be held: ridges and valley bottoms, gentle ground, roads, rivers, the edges of fuel, access.

Each factor is a plane from 0 (bad) to 1 (good); the suitability is their weighted mean. The factors are those that
held fires in the study of potential control locations (O'Connor, Calkin, Thompson 2017, doi 10.1071/WF16135) and in
indices of suppression difficulty (Rodriguez y Silva et al. 2014, doi 10.1071/WF13137). The study fits a statistical
model to one region's fires; which factor counts how much elsewhere has no source, so the weights are parameters.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError

if TYPE_CHECKING:
    from collections.abc import Mapping

    import xarray as xr

#: Standard deviations of the heights around at which a ridge or a valley counts in full.
_PROMINENT = 1.5


@dataclass(frozen=True)
class Siting:
    """What makes a line easy to hold, and how much of it counts.

    Weights of 0 leave a factor out; a factor without data (no roads given) is left out too.

    Parameters
    ----------
    scales
        Radii over which ridges and valleys are looked for [m]; the most prominent counts.
    ridge, valley
        Weight of the landform, and what a valley bottom is worth beside a ridge (0 to 1).
    slope, gentle, steep
        Weight of the slope; up to `gentle` degrees machines work freely, from `steep` on not at all.
    road, road_reach
        Weight of a road or track in the line, and the distance at which it is worth a third [m].
    river, river_reach
        The same for rivers and lakes.
    edge, edge_reach
        The same for edges of the fuel: ground without fuel, and where the fuel turns less flammable.
    access, access_reach
        Weight of the way for crews from the next road, and the distance at which it is worth a third [m].
    """

    scales: tuple[float, ...] = (100.0, 300.0, 1000.0)
    ridge: float = 1.0
    valley: float = 0.5
    slope: float = 0.5
    gentle: float = 15.0
    steep: float = 35.0
    road: float = 1.0
    road_reach: float = 40.0
    river: float = 0.75
    river_reach: float = 40.0
    edge: float = 0.75
    edge_reach: float = 40.0
    access: float = 0.5
    access_reach: float = 500.0

    def __post_init__(self) -> None:
        """Refuse what cannot be."""
        for f in fields(self):
            if f.name == "scales":
                continue
            value = getattr(self, f.name)
            if not (np.isfinite(value) and value >= 0.0):
                raise ParameterError(f"siting {f.name} is {value}, expected a number of at least 0")
        if not self.scales or min(self.scales) <= 0:
            raise ParameterError(f"siting scales are {self.scales}, expected lengths above 0 m")
        if self.valley > 1.0:
            raise ParameterError(f"siting valley is {self.valley}, expected a share of a ridge's worth from 0 to 1")
        if self.steep <= self.gentle:
            raise ParameterError(f"siting steep is {self.steep} degrees, expected more than gentle, {self.gentle}")


def suitability(
    elevation: np.ndarray | None,
    cell_size: float,
    *,
    burnable: np.ndarray,
    flammability: np.ndarray | None = None,
    roads: np.ndarray | None = None,
    rivers: np.ndarray | None = None,
    siting: Siting | None = None,
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """How well a line can be held in each cell.

    Parameters
    ----------
    elevation
        (rows, cols) heights [m]; NaN where unknown. None leaves landform and slope out.
    cell_size
        Of a cell [m].
    burnable
        (rows, cols) bool, true where there is fuel.
    flammability
        (rows, cols) how readily each cell is lit, any unit; edges lie where it falls by a quarter or more.
    roads, rivers
        (rows, cols) bool; rivers are all water that stops fire.
    siting
        Weights and reaches.

    Returns
    -------
    tuple
        (rows, cols) float64 from 0 to 1, and the factors that went in, by name, likewise.

    Raises
    ------
    ParameterError
        If no factor has data and weight.

    Examples
    --------
    A ridge between two valleys:

    >>> import numpy as np
    >>> height = 100 - np.abs(np.arange(41) - 20.0) * 5 + np.zeros((31, 1))
    >>> found, _ = suitability(height, 20.0, burnable=np.ones(height.shape, bool))
    >>> np.flatnonzero(found[15] == found[15].max())
    array([19, 20, 21])
    """
    from firebreak_gis.kernels.terrain import horn_slope

    chosen = siting or Siting()
    planes: dict[str, tuple[float, np.ndarray]] = {}
    if elevation is not None:
        height = np.asarray(elevation, dtype=np.float64)
        planes["landform"] = (chosen.ridge, _landform(height, cell_size, chosen))
        steepness = horn_slope(height, cell_size)
        machine = np.clip((chosen.steep - steepness) / (chosen.steep - chosen.gentle), 0.0, 1.0)
        planes["slope"] = (chosen.slope, np.where(np.isnan(machine), 0.0, machine))
    if roads is not None and roads.any():
        away = _distance(roads, cell_size)
        planes["road"] = (chosen.road, np.exp(-away / max(chosen.road_reach, 1e-9)))
        planes["access"] = (chosen.access, np.exp(-away / max(chosen.access_reach, 1e-9)))
    if rivers is not None and rivers.any():
        planes["river"] = (chosen.river, np.exp(-_distance(rivers, cell_size) / max(chosen.river_reach, 1e-9)))
    edges = fuel_edges(burnable, flammability)
    if edges.any():
        planes["edge"] = (chosen.edge, np.exp(-_distance(edges, cell_size) / max(chosen.edge_reach, 1e-9)))
    used = {name: plane for name, plane in planes.items() if plane[0] > 0.0}
    if not used:
        raise ParameterError("siting has nothing to go by: give the terrain, roads or rivers, or weights above 0")
    total = sum(weight * plane for weight, plane in used.values()) / sum(weight for weight, _ in used.values())
    return np.asarray(total), {name: plane for name, (_, plane) in used.items()}


def fuel_edges(burnable: np.ndarray, flammability: np.ndarray | None = None) -> np.ndarray:
    """Cells with fuel beside ground without fuel, or beside fuel that is lit a quarter less readily, (rows, cols)."""
    fuel = np.asarray(burnable, dtype=bool)
    edges = np.zeros(fuel.shape, bool)
    lit = np.where(fuel, 1.0 if flammability is None else np.asarray(flammability, dtype=np.float64), 0.0)
    for axis in (0, 1):
        one = (slice(None, -1), slice(None)) if axis == 0 else (slice(None), slice(None, -1))
        two = (slice(1, None), slice(None)) if axis == 0 else (slice(None), slice(1, None))
        apart = np.minimum(lit[one], lit[two]) <= 0.75 * np.maximum(lit[one], lit[two])
        apart &= np.maximum(lit[one], lit[two]) > 0
        edges[one] |= apart
        edges[two] |= apart
    return np.asarray(edges & fuel)


def difficulty(suitable: np.ndarray, *, strength: float = 1.0) -> np.ndarray:
    """What a wall counts as in each cell beside its cost, from how suitable the cell is.

    The best cell of the map counts 1, and one that is worse by the whole range of suitability ``exp(2 strength)``: 7
    times as much at the default strength. The range runs from the 2 % to the 98 % quantile. Numbers are rounded to
    halves, so that walls are found fast.

    Parameters
    ----------
    suitable
        (rows, cols) from `suitability`.
    strength
        0 makes all cells alike.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64, at least 1.
    """
    if not (np.isfinite(strength) and 0.0 <= strength <= 5.0):
        raise ParameterError(f"the strength of the siting is {strength}, expected a number from 0 to 5")
    low, high = np.quantile(suitable, [0.02, 0.98])
    worse = np.clip((high - suitable) / max(high - low, 1e-12), 0.0, 1.0)
    factor: np.ndarray = np.rint(2.0 * np.exp(2.0 * strength * worse)) / 2.0
    return factor


def site(
    landscape: xr.Dataset,
    *,
    roads: np.ndarray | None = None,
    rivers: np.ndarray | None = None,
    siting: Siting | None = None,
    **weights: Any,
) -> xr.Dataset:
    """Where a line can be held on a landscape.

    Parameters
    ----------
    landscape
        As `read_landscape` returns it.
    roads, rivers
        (rows, cols) bool, or above 0 where there is one.
    siting
        Weights and reaches; single ones may be given by name instead, for example ``road=2``.

    Returns
    -------
    xarray.Dataset
        `suitability` (y, x) float32, and each factor that went in as `suitability_NAME`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> found = fb.site(fb.read_landscape(**fb.sample_layers(), resolution=250.0), ridge=2.0)
    >>> 0.0 <= float(found["suitability"].min()) <= float(found["suitability"].max()) <= 1.0
    True
    """
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.schema import annotate

    grid = Grid.of(landscape["burnable"])
    grid.require_metres("slopes and distances")
    chosen = _with(siting or Siting(), weights)
    fuel = landscape["burnable"].to_numpy()
    flammability = (1.0 + 0.35 * (landscape["vegetation"].to_numpy().astype(np.float64) - 2.0)) * (
        1.0 + 0.35 * (landscape["density"].to_numpy().astype(np.float64) - 2.0)
    )
    found, factors = suitability(
        landscape["elevation"].to_numpy(),
        grid.cell_size,
        burnable=fuel,
        flammability=flammability,
        roads=None if roads is None else np.asarray(roads) > 0,
        rivers=None if rivers is None else np.asarray(rivers) > 0,
        siting=chosen,
    )
    data = {"suitability": annotate(grid.dataarray(found.astype(np.float32), "suitability"))}
    for name, plane in factors.items():
        data[f"suitability_{name}"] = annotate(grid.dataarray(plane.astype(np.float32), "suitability")).rename(
            f"suitability_{name}"
        )
    return xr.Dataset(data)


def _with(siting: Siting, weights: Mapping[str, Any]) -> Siting:
    known = {f.name for f in fields(siting)}
    strangers = sorted(set(weights) - known)
    if strangers:
        raise ParameterError(f"siting has no {', '.join(strangers)}; it has {', '.join(sorted(known))}")
    try:
        numbers = {k: tuple(float(x) for x in v) if k == "scales" else float(v) for k, v in weights.items()}
    except (TypeError, ValueError):
        raise ParameterError(f"siting got {dict(weights)!r}, expected numbers") from None
    return replace(siting, **numbers)  # type: ignore[arg-type]


def _distance(mask: np.ndarray, cell_size: float) -> np.ndarray:
    """Distance of every cell's centre from the next cell of a mask [m]."""
    from scipy.ndimage import distance_transform_edt

    return np.asarray(distance_transform_edt(~np.asarray(mask, bool), sampling=cell_size))


def _landform(height: np.ndarray, cell_size: float, siting: Siting) -> np.ndarray:
    """From 0 on an even slope to 1 on a ridge and `valley` in a valley bottom, the most prominent of the scales.

    The height over the mean around, in standard deviations of the heights around (De Reu et al. 2013,
    doi 10.1016/j.geomorph.2012.12.015); the mean is Gaussian, so that it does not know the directions of the grid.
    """
    best = np.zeros(height.shape)
    level = height - np.nanmean(height) if np.isfinite(height).any() else height
    for radius in siting.scales:
        sigma = radius / cell_size / np.sqrt(2.0)
        if sigma < 0.5:
            continue
        mean, square = (_smooth(values, sigma) for values in (level, level**2))
        spread = np.sqrt(np.maximum(square - mean**2, 1e-12))
        over = (level - mean) / np.maximum(spread, 0.01 * radius)
        ridge, valley = np.clip(over / _PROMINENT, 0.0, 1.0), np.clip(-over / _PROMINENT, 0.0, 1.0)
        best = np.fmax(best, np.maximum(ridge, siting.valley * valley))
    return np.asarray(best)


def _smooth(values: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian mean of the known values around each cell."""
    from scipy.ndimage import gaussian_filter

    known = np.isfinite(values)
    weight = gaussian_filter(known.astype(np.float64), sigma, mode="constant", truncate=3.0)
    total = gaussian_filter(np.where(known, values, 0.0), sigma, mode="constant", truncate=3.0)
    return np.asarray(np.where(weight > 1e-9, total / np.maximum(weight, 1e-9), np.nan))
