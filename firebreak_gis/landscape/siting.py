"""Where a line can be held: ridges and valley bottoms, roads, rivers, edges of the fuel, gentle ground, access.

Lines come first: a cell within `reach` of a ridge, a valley bottom, a road, a river or an edge of the fuel counts what
the best of them is worth, any other cell nothing. Gentle ground and a short way from the next road add to it. The
factors are those that held fires in the study of potential control locations (O'Connor, Calkin, Thompson 2017, doi
10.1071/WF16135) and in indices of suppression difficulty (Rodriguez y Silva et al. 2014, doi 10.1071/WF13137). The
study fits a statistical model to one region's fires; which factor counts how much elsewhere has no source, so the
weights are parameters, and assumptions.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.progress import silent
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from collections.abc import Mapping

    import xarray as xr

#: Cells of which crests are sought together.
_TOGETHER = 250_000
#: Largest strength that is taken for meant.
_STRONGEST = 10.0


@dataclass(frozen=True)
class Siting:
    """What makes a line easy to hold, and how much of it counts; all of it assumed, see the text of the module.

    Weights of 0 leave a factor out; a factor without data (no roads given) is left out too.

    Parameters
    ----------
    scales
        Standard deviations of the smoothing under which ridges and valleys are looked for [m]; the lines of all
        scales count.
    flank
        Slope at one scale from the crest or the bottom from which on it counts [degrees].
    ridge, valley, road, river, edge
        What each line is worth, 0 to 1. Valleys draw fire uphill, and crews are not safe in them, so they count half.
    patch
        Ground without fuel has an edge if it is at least so large [ha].
    reach
        How near a line counts as on the feature [m]; one cell always does.
    slope, gentle, steep
        Weight of the slope beside that of the lines; up to `gentle` degrees machines work freely, from `steep` on not
        at all.
    access, access_reach
        Weight of the way for crews from the next road, and the distance at which it is worth a third [m].
    """

    scales: tuple[float, ...] = (200.0,)
    flank: float = 4.5
    ridge: float = 1.0
    valley: float = 0.5
    road: float = 1.0
    river: float = 1.0
    edge: float = 1.0
    patch: float = 20.0
    reach: float = 30.0
    slope: float = 0.5
    gentle: float = 15.0
    steep: float = 35.0
    access: float = 0.25
    access_reach: float = 500.0

    def __post_init__(self) -> None:
        """Refuse what cannot be."""
        for f in fields(self):
            if f.name == "scales":
                continue
            value = getattr(self, f.name)
            if not (np.isfinite(value) and value >= 0.0):
                raise ParameterError(f"siting {f.name} is {value}, expected a number of at least 0")
            if f.name in ("ridge", "valley", "road", "river", "edge") and value > 1.0:
                raise ParameterError(f"siting {f.name} is {value}, expected a worth from 0 to 1")
        if not self.scales or not all(np.isfinite(scale) and scale > 0 for scale in self.scales):
            raise ParameterError(f"siting scales are {self.scales}, expected lengths above 0 m")
        if self.steep <= self.gentle:
            raise ParameterError(f"siting steep is {self.steep} degrees, expected more than gentle, {self.gentle}")


def siting_of(weights: Mapping[str, Any], siting: Siting | None = None) -> Siting:
    """A `Siting` in which some fields, given by name, numbers or text, are others.

    Raises
    ------
    ParameterError
        Naming what is unknown or no number.

    Examples
    --------
    >>> siting_of({"ridge": "0.8"}).ridge
    0.8
    """
    siting = siting or Siting()
    known = {f.name for f in fields(siting)}
    strangers = sorted(set(weights) - known)
    if strangers:
        raise ParameterError(f"siting has no {', '.join(strangers)}; it has {', '.join(sorted(known))}")
    try:
        numbers = {k: _scales(v) if k == "scales" else float(v) for k, v in weights.items()}
    except (TypeError, ValueError):
        raise ParameterError(f"siting got {dict(weights)!r}, expected numbers") from None
    return replace(siting, **numbers)  # type: ignore[arg-type]


def _scales(given: Any) -> tuple[float, ...]:
    words = given.replace("+", " ").split() if isinstance(given, str) else np.atleast_1d(given)
    return tuple(float(word) for word in words)


def features(
    elevation: np.ndarray | None,
    cell_size: float,
    *,
    burnable: np.ndarray,
    roads: np.ndarray | None = None,
    rivers: np.ndarray | None = None,
    siting: Siting | None = None,
) -> dict[str, np.ndarray]:
    """Lines that a break can follow, by name, (rows, cols) bool each: those with data and worth.

    Parameters are those of `suitability`.
    """
    chosen = siting or Siting()
    found: dict[str, np.ndarray] = {}
    if elevation is not None:
        height = np.asarray(elevation, dtype=np.float64)
        found["ridge"], found["valley"] = crests(height, cell_size, chosen.scales, chosen.flank)
    for name, mask in (("road", roads), ("river", rivers)):
        if mask is not None:
            found[name] = np.asarray(mask, dtype=bool)
    found["edge"] = fuel_edges(burnable, patch=max(chosen.patch * 1e4 / cell_size**2, 1.0))
    return {name: mask for name, mask in found.items() if getattr(chosen, name) > 0.0 and mask.any()}


def beside(mask: np.ndarray, cell_size: float, reach: float) -> np.ndarray:
    """Cells within reach of a mask [m], the eight next ones always, (rows, cols) bool."""
    from scipy import ndimage

    if reach < 2.0 * cell_size:  # no more than the eight; distances would take thirty times the memory
        return np.asarray(ndimage.binary_dilation(mask, np.ones((3, 3), bool)))
    return np.asarray(distance(mask, cell_size) <= reach)


def suitability(
    elevation: np.ndarray | None,
    cell_size: float,
    *,
    burnable: np.ndarray,
    roads: np.ndarray | None = None,
    rivers: np.ndarray | None = None,
    siting: Siting | None = None,
    lines: Mapping[str, np.ndarray] | None = None,
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
    roads, rivers
        (rows, cols) bool; rivers are all water that stops fire.
    siting
        Weights and reaches.
    lines
        What `features` finds of the same, where that is known already.

    Returns
    -------
    tuple
        (rows, cols) float64 from 0 to 1: the best line's worth, the slope and the access, by their weights; and the
        factors that went in, by name, likewise.

    Raises
    ------
    ParameterError
        If no factor has data and weight.

    Examples
    --------
    A ridge between two valleys:

    >>> import numpy as np
    >>> height = 200 - np.abs(np.arange(61) - 30.0) * 5 + np.zeros((41, 1))
    >>> found, _ = suitability(height, 20.0, burnable=np.ones(height.shape, bool))
    >>> np.flatnonzero(found[20] == found[20].max())
    array([29, 30, 31])
    """
    from firebreak_gis.kernels.terrain import horn_slope

    chosen = siting or Siting()
    if lines is None:
        lines = features(elevation, cell_size, burnable=burnable, roads=roads, rivers=rivers, siting=chosen)
    factors = {name: beside(mask, cell_size, chosen.reach).astype(np.float64) for name, mask in lines.items()}
    worth = np.zeros(np.shape(burnable))
    for name, plane in factors.items():
        worth = np.maximum(worth, getattr(chosen, name) * plane)
    weighed = [(1.0, worth)] if factors else []
    if elevation is not None and chosen.slope > 0.0:
        steepness = horn_slope(np.asarray(elevation, dtype=np.float64), cell_size)
        machine = np.clip((chosen.steep - steepness) / (chosen.steep - chosen.gentle), 0.0, 1.0)
        factors["slope"] = np.where(np.isnan(machine), 0.0, machine)
        weighed.append((chosen.slope, factors["slope"]))
    if "road" in lines and chosen.access > 0.0:
        factors["access"] = np.exp(-distance(lines["road"], cell_size) / max(chosen.access_reach, 1e-9))
        weighed.append((chosen.access, factors["access"]))
    if not weighed:
        raise ParameterError("siting has nothing to go by: give the terrain, roads or rivers, or weights above 0")
    total = sum(weight * plane for weight, plane in weighed) / sum(weight for weight, _ in weighed)
    return np.asarray(total), factors


def crests(
    height: np.ndarray, cell_size: float, scales: tuple[float, ...], flank: float
) -> tuple[np.ndarray, np.ndarray]:
    """Crest lines of a terrain, and of its negative: the valley bottoms.

    A cell is on a crest of a scale if the smoothed terrain bends down most across a line through the cell, so much that
    one scale from the crest the slope is `flank`. Lines do not know the directions of the grid, and go on over saddles.

    Parameters
    ----------
    height
        (rows, cols) [m], NaN where unknown; no crest lies within a scale of unknown ground.
    cell_size, scales
        Of a cell, and of the Gaussian smoothing [m]; scales below a cell find nothing.
    flank
        Slope [degrees].

    Returns
    -------
    tuple
        (rows, cols) bool each.

    Notes
    -----
    Steger 1998, doi 10.1109/34.659930. Cost: five smoothings a scale.
    """
    from scipy import ndimage

    found = np.zeros((2, *height.shape), bool)
    unknown = ~np.isfinite(height)
    if unknown.all():
        return found[0], found[1]
    known = height
    if unknown.any():
        nearest = ndimage.distance_transform_edt(unknown, return_distances=False, return_indices=True)
        known = height[tuple(nearest)]
    for scale in scales:
        sigma = scale / cell_size
        if sigma < 1.0:
            continue
        lines = _crest(known, sigma, np.tan(np.radians(flank)) * cell_size)
        if unknown.any():
            lines &= distance(unknown, cell_size) > scale
        found |= lines
    return found[0], found[1]


def _crest(height: np.ndarray, sigma: float, drop: float) -> np.ndarray:
    """Crests, and those of the negative, of one scale in cells; `drop` is the fall over a cell at that distance.

    Found band by band of rows, on several threads, each with the rows around it as far as smoothing reaches.
    """
    rows, cols = height.shape
    margin = int(np.ceil(4.0 * sigma))
    step = max(_TOGETHER // cols, 4 * margin, 1)  # what is smoothed twice is a small part
    found = np.empty((2, *height.shape), bool)

    def work(first: int) -> None:
        top, bottom = max(first - margin, 0), min(first + step + margin, rows)
        # Beyond the border the terrain goes on as it falls, so that the border is no ridge.
        beyond = (margin - (first - top), margin - (bottom - min(first + step, rows)))
        part = height[top:bottom]
        if min(height.shape) > 1:
            part = np.pad(part, (beyond, (margin, margin)), mode="reflect", reflect_type="odd")
            inner = np.s_[margin:-margin, margin:-margin]
        else:
            inner = np.s_[first - top : first - top + step, 0:cols]
        found[:, first : first + step] = _crest_of(part, sigma, drop, inner)

    run_pieces(work, range(0, rows, step), threads=None, progress=silent, message="crests")
    return found


def _crest_of(height: np.ndarray, sigma: float, drop: float, inner: tuple[slice, slice]) -> np.ndarray:
    """Crests, and those of the negative, in the inner part of a terrain, (2, rows, cols) bool."""
    from scipy.ndimage import gaussian_filter1d

    # Along columns, then along rows, as `gaussian_filter` does; the first are made once.
    down_by = [gaussian_filter1d(height, sigma, axis=0, order=order, mode="nearest") for order in range(3)]

    def smooth(down: int, right: int) -> np.ndarray:
        across = down_by[down][inner[0]]
        return np.asarray(gaussian_filter1d(across, sigma, axis=1, order=right, mode="nearest")[:, inner[1]])

    down, right = smooth(1, 0), smooth(0, 1)
    rows, cols, both = smooth(2, 0), smooth(0, 2), smooth(1, 1)
    mean, half = 0.5 * (rows + cols), np.hypot(0.5 * (cols - rows), both)
    found = []
    for sign in (1.0, -1.0):  # the derivatives of the negative are the negatives
        bend = sign * mean - half
        turn = 0.5 * np.arctan2(sign * 2.0 * both, sign * (cols - rows)) + 0.5 * np.pi
        across = np.cos(turn), np.sin(turn)
        with np.errstate(divide="ignore", invalid="ignore"):
            away = -sign * (right * across[0] + down * across[1]) / bend
        # The crest passes through the cell if it lies within half a cell along the nearer axis.
        passes = np.abs(away) * np.maximum(np.abs(across[0]), np.abs(across[1])) <= 0.5 + 1e-9
        found.append(passes & (-bend * sigma >= drop))
    return np.stack(found)


def fuel_edges(burnable: np.ndarray, *, patch: float = 1.0) -> np.ndarray:
    """Cells with fuel that share a side with ground without fuel, (rows, cols) bool.

    Parameters
    ----------
    burnable
        (rows, cols) bool.
    patch
        Cells that ground without fuel has at least; smaller patches have no edge.
    """
    from scipy import ndimage

    fuel = np.asarray(burnable, dtype=bool)
    label, _ = ndimage.label(~fuel, structure=np.ones((3, 3)))
    size = np.bincount(label.ravel())
    size[0] = 0
    return np.asarray(ndimage.binary_dilation(size[label] >= patch) & fuel)


def difficulty(suitable: np.ndarray, *, strength: float = 1.0) -> np.ndarray:
    """What a wall counts as in each cell beside its cost, from how suitable the cell is.

    Ground of suitability 1 counts once its cost, ground of suitability 0 ``1 + strength`` times. Numbers are rounded to
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
    require_strength(strength)
    factor: np.ndarray = np.rint(2.0 * (1.0 + strength * (1.0 - suitable))) / 2.0
    return factor


def require_strength(strength: float) -> None:
    """Refuse a strength that cannot be meant.

    Raises
    ------
    ParameterError
        Saying what it may be.
    """
    if not (np.isfinite(strength) and 0.0 <= strength <= _STRONGEST):
        raise ParameterError(
            f"the strength of the siting is {strength}, expected a number from 0 (all ground alike) to {_STRONGEST:g}"
        )


def site(
    landscape: xr.Dataset,
    *,
    roads: np.ndarray | xr.DataArray | None = None,
    rivers: np.ndarray | xr.DataArray | None = None,
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
        Weights and reaches; single ones may be given by name instead, for example ``road=0.5``.

    Returns
    -------
    xarray.Dataset
        `suitability` (y, x) float32, and each factor that went in as `suitability_NAME`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> found = fb.site(fb.read_landscape(**fb.sample_layers(), resolution=250.0), valley=1.0)
    >>> 0.0 <= float(found["suitability"].min()) <= float(found["suitability"].max()) <= 1.0
    True
    """
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.schema import annotate

    grid = Grid.of(landscape["burnable"])
    grid.require_metres("slopes and distances")
    found, factors = suitability(
        landscape["elevation"].to_numpy(),
        grid.cell_size,
        burnable=landscape["burnable"].to_numpy(),
        roads=None if roads is None else np.asarray(roads) > 0,
        rivers=None if rivers is None else np.asarray(rivers) > 0,
        siting=siting_of(weights, siting),
    )
    data = {"suitability": annotate(grid.dataarray(found.astype(np.float32), "suitability"))}
    for name, plane in factors.items():
        data[f"suitability_{name}"] = annotate(grid.dataarray(plane.astype(np.float32), "suitability")).rename(
            f"suitability_{name}"
        )
    return xr.Dataset(data)


def distance(mask: np.ndarray, cell_size: float) -> np.ndarray:
    """Distance of every cell's centre from the next cell of a mask [m]."""
    from scipy.ndimage import distance_transform_edt

    return np.asarray(distance_transform_edt(~np.asarray(mask, bool), sampling=cell_size))
