"""Treatments on the map: what each leaves and costs in every cell, and segments with one each."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.construction.segments import Segments
from firebreak_gis.construction.treatments import NONE, Treatments, choose, singles, spend, stops
from firebreak_gis.grid import Grid
from firebreak_gis.schema import VEGETATION
from firebreak_gis.simulation.holding import Hold

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

#: Length of the front that meets a segment [m]: that of the stretches that hold or fail, an assumption.
FRONT = Hold.length
_SIZES = ("gain", "width_m", "length_m")


@dataclass(frozen=True, eq=False)
class Offers:
    """What each treatment would leave and cost in each cell of a landscape.

    Parameters
    ----------
    landscape
        With `vegetation`, `elevation` and `burnable`.
    treatments
        The table.
    probability
        Mean spread probability of the fuel.
    """

    landscape: xr.Dataset
    treatments: Treatments
    probability: float

    def of(self, name: str) -> np.ndarray:
        """Residual, cost and yearly cost of a treatment, (3, rows, cols); 1 and infinite where it is not allowed."""
        codes = self.landscape["vegetation"].to_numpy()
        planes = np.stack([np.ones(codes.shape), *(np.full(codes.shape, np.inf) for _ in range(2))])
        for code, word in VEGETATION.items():
            row = self.treatments.rows.get((name, word))
            if row is not None:
                here = (codes == code) & (self._slope <= row.max_slope_deg)
                price = self.grid.cell_area_ha * (row.cost_ha + row.cost_per_degree * self._slope[here])
                planes[:, here] = np.array([np.full(price.size, row.residual), price, price / row.years])
        return planes

    @cached_property
    def usual(self) -> np.ndarray:
        """Residual, cost and yearly cost in each cell before segments choose, and the number of the treatment.

        (4, rows, cols): of the single treatment that stops most fires for its yearly cost on all fuel, in walls of one
        cell; where it is not allowed, of the cheapest that is; 1, infinite and -1 where none is.
        """
        every = [np.concatenate([self.of(name), [np.full(self._slope.shape, k)]]) for k, name in self._numbered]
        cheapest = _none_allowed(self._slope.shape)
        for each in every:
            cheapest = np.where(each[2] < cheapest[2], each, cheapest)
        fuel = self.fuel & np.isfinite(cheapest[2])
        filled = [np.where(np.isfinite(each[2]), each, cheapest) for each in every]
        met = max(FRONT / self.grid.cell_size, 1.0)
        stopped = [stops(each[0][fuel], 1.0, met, self.probability).sum() for each in filled]
        worth = [share / max(each[2][fuel].sum(), 1e-12) for share, each in zip(stopped, filled, strict=True)]
        return np.asarray(filled[int(np.argmax(worth))])

    def alone(self, name: str) -> Offers:
        """What one of the treatments offers, as if there were no other."""
        table = self.treatments
        rows = {key: row for key, row in table.rows.items() if key[0] == name}
        return replace(self, treatments=replace(table, rows=rows))

    @property
    def grid(self) -> Grid:
        """Of the landscape."""
        return Grid.of(self.landscape["vegetation"])

    @property
    def fuel(self) -> np.ndarray:
        """(rows, cols) bool: where there is any."""
        return np.asarray(self.landscape["burnable"].to_numpy() > 0)

    @property
    def allowed(self) -> np.ndarray:
        """(rows, cols) bool: where any treatment is."""
        return np.asarray(np.isfinite(self.usual[1]))

    @property
    def residual(self) -> float:
        """Mean that the usual treatments leave on the fuel, which designs are told."""
        found = self.usual[0][self.fuel & self.allowed]
        # Equal numbers have themselves as mean, which a sum of them would miss by its rounding.
        return float(np.clip(found.mean(), found.min(), found.max())) if found.size else 1.0

    @property
    def _numbered(self) -> list[tuple[int, str]]:
        return list(enumerate(self.treatments.names))

    @cached_property
    def _slope(self) -> np.ndarray:
        from firebreak_gis.kernels.terrain import horn_slope

        elevation = self.landscape["elevation"].to_numpy().astype(np.float64)
        return np.asarray(np.nan_to_num(horn_slope(elevation, self.grid.cell_size)))


def _none_allowed(shape: tuple[int, ...]) -> np.ndarray:
    return np.stack([np.full(shape, value) for value in (1.0, np.inf, np.inf, -1.0)])


class Treated(NamedTuple):
    """Segments with their treatments.

    Attributes
    ----------
    segments
        Lines and polygons, see `with_treatments`.
    residual
        (rows, cols) share of its spread probability that each cell would keep: by the treatment of its segment, and
        by the usual one outside of all segments.
    """

    segments: Segments
    residual: np.ndarray


def with_treatments(frames: Segments, offers: Offers, *, money: float | None = None) -> Treated:
    """Give each segment a treatment: together they save as much as the best single one, for as little as possible.

    The best single treatment saves most for its yearly cost; where it is not allowed, the cheapest that is. A segment
    over several fuels may also have what is usual in each of its cells, see `Offers.usual`.

    Parameters
    ----------
    frames
        Lines and polygons, as `segments.segments_of` returns them.
    offers
        The table, on the grid of the segments.
    money
        What all treatments may cost together, at least what the usual ones do; then they save as much as can be found
        for it.

    Returns
    -------
    segments, residual
        See `Treated`. The tables have the columns `treatment` (several names with + between them where cells differ),
        `treatment_residual` (mean over the cells), `treatment_cost`, `treatment_yearly` (in the unit of the table) and
        `treatment_saving`, in the unit of the gain. `none` where a cell of the segment may not be treated.
    """
    lines, polygons = frames
    names, n = offers.treatments.names, len(polygons)
    owner = _owners(polygons, offers.usual.shape[1:], offers.grid)
    residual, cost, yearly = _options(owner, n, offers)
    gain, width, length = (polygons[name].to_numpy(dtype=float)[:, np.newaxis] for name in _SIZES)
    size = offers.grid.cell_size
    met = np.clip(length, size, max(FRONT, size)) / size
    saving = gain * stops(residual, np.maximum(width / size, 1.0), met, offers.probability)
    free = ~np.isfinite(cost).any(axis=1)
    # A segment that cannot be treated takes part with nothing.
    yearly[free, 0], cost[free, 0], saving[free, 0] = 0.0, 0.0, 0.0
    if not n:
        pick = np.zeros(0, np.int64)
    elif money is None:
        pick = choose(yearly, saving, _best_single(yearly, saving))
    else:
        pick = spend(cost, saving, money)
    every = np.arange(n)
    planes = _laid(offers, owner, pick, free)
    columns: dict[str, Any] = {
        "treatment": _names(owner, planes[1], n, names),
        "treatment_residual": np.where(free, 1.0, residual[every, pick]),
        "treatment_cost": cost[every, pick],
        "treatment_yearly": yearly[every, pick],
        "treatment_saving": saving[every, pick],
    }
    return Treated(Segments(lines.assign(**columns), polygons.assign(**columns)), planes[0])


def _best_single(yearly: np.ndarray, saving: np.ndarray) -> float:
    """Saving of the single treatment that saves most for its cost, with the cheapest where it is not allowed."""
    every = np.arange(len(yearly))
    found = []
    for pick in singles(yearly, saving):
        saved = float(saving[every, pick].sum())
        found.append((saved / max(float(yearly[every, pick].sum()), 1e-12), saved))
    return max(found)[1]


def _owners(polygons: gpd.GeoDataFrame, shape: tuple[int, ...], grid: Grid) -> np.ndarray:
    """Number of the segment of each cell, from 1, (rows, cols) int32; 0 outside."""
    from rasterio.features import rasterize

    if not len(polygons):
        return np.zeros(shape, np.int32)
    shapes = zip(polygons.geometry, range(1, len(polygons) + 1), strict=True)
    return np.asarray(rasterize(shapes, shape, transform=grid.transform, dtype="int32"))


def _options(owner: np.ndarray, n: int, offers: Offers) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Mean residual, cost and yearly cost on `n` segments of each treatment, and of the usual ones, (n, k + 1) each.

    Costs are infinite where a treatment is not allowed.
    """
    inside = owner > 0
    segment = owner[inside] - 1
    cells = np.maximum(np.bincount(segment, minlength=n), 1)
    columns = []
    for planes in [*map(offers.of, offers.treatments.names), offers.usual[:3]]:
        sums = [np.bincount(segment, weights=plane[inside], minlength=n) for plane in planes]
        columns.append([sums[0] / cells, sums[1], sums[2]])
    residual, cost, yearly = np.array(columns).transpose(1, 2, 0)
    return residual, cost, yearly


def _laid(offers: Offers, owner: np.ndarray, pick: np.ndarray, free: np.ndarray) -> np.ndarray:
    """Residual and number of the treatment of each cell, (2, rows, cols); outside the segments those that are usual."""
    planes = offers.usual[[0, 3]]
    chosen = np.concatenate([[-1], np.where(free, -2, pick)])[owner]
    for k, name in enumerate(offers.treatments.names):
        here = chosen == k
        planes[0, here], planes[1, here] = offers.of(name)[0, here], k
    planes[0, chosen == -2], planes[1, chosen == -2] = 1.0, -1
    planes[0, ~offers.allowed & (owner == 0)] = offers.residual
    return planes


def _names(owner: np.ndarray, number: np.ndarray, n: int, names: tuple[str, ...]) -> np.ndarray:
    """Names of the treatments in each segment, (n,) object, joined by +."""
    inside = owner > 0
    found: list[list[str]] = [[] for _ in range(n)]
    for segment, k in np.unique(np.column_stack([owner[inside], number[inside].astype(np.int64)]), axis=0).tolist():
        found[segment - 1].append(names[k] if k >= 0 else NONE)
    return np.array([" + ".join(each) or NONE for each in found], object)
