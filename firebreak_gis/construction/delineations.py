"""Potential operational delineations: the whole landscape in compartments bounded by the best control lines.

Fire managers agree on such compartments before any fire burns, and then on what to do in each (Thompson, Bowden,
Brough et al. 2016, doi 10.3390/f7030064; Thompson, O'Connor, Gannon et al. 2022, doi 10.1186/s42408-022-00139-2). Their
borders are lines where fires can be stopped, from a map of potential control locations (O'Connor, Calkin, Thompson
2017, doi 10.1071/WF16135), drawn by experts. Here they are nested minimum cuts: each compartment that is too large is
split by the line of least price, where a cell costs the more the worse a line can be held there. Then neighbours that
together are no larger than asked are joined, over the worst border first.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.compartments import split, weights
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import outlines
from firebreak_gis.placement.dissection import dissect
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.schema import VEGETATION, MapLayer, Shown
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork

    Plane = np.ndarray | xr.DataArray

#: The largest compartment, in target sizes; cuts then leave compartments about the target.
_LARGEST = 1.5
#: Ground without fuel belongs to the compartment of the nearest fuel up to so many metres from it.
_REACH = 200.0
#: A border cell is on a road, a ridge and so on if the factor is at least this.
_ON = 0.5


@dataclass(frozen=True, repr=False, eq=False)
class Delineation(Shown):
    """Compartments and their borders.

    Parameters
    ----------
    labels
        `compartment` (y, x) int32: numbers from 1, from north to south; 0 on ground without fuel far from any.
    pods
        One polygon a compartment: `pod`, `area_ha`, `fuel_ha`, a share of the fuel for each type of vegetation
        (`agricultural`, `shrubs`, `pines`), `ignition_share`, `value`, `burnt_ha` (of it, in the mean fire; NaN without
        fires), `border_m` (shared with others), `suitability` (mean along it, NaN without any) and for each factor of
        the siting the share of it that lies on such ground (`on_road`, ...).
    borders
        One line (or several in one) a pair of neighbours: `pod_a`, `pod_b`, `length_m`, `suitability`, `on_...`.
    """

    labels: xr.DataArray
    pods: gpd.GeoDataFrame
    borders: gpd.GeoDataFrame

    def facts(self) -> dict[str, object]:
        """How many, how large and how well bounded, as `repr` and notebooks show them."""
        fuel, length = self.pods["fuel_ha"], self.borders["length_m"]
        return {
            "compartments": len(fuel),
            "fuel of each": f"{fuel.min():,.4g} to {fuel.max():,.4g} ha",
            "borders": f"{length.sum() / 1000:,.4g} km",
            "mean suitability": f"{self.suitability:.2f}",
        }

    @property
    def suitability(self) -> float:
        """Mean along all borders, 0 to 1; 0 without any."""
        length = self.borders["length_m"]
        return float((length * self.borders["suitability"]).sum() / max(float(length.sum()), 1e-9))

    def layers(self) -> tuple[MapLayer, ...]:
        """Compartments by what burns of them, borders by how well they can be held."""
        return (
            MapLayer(f"{len(self.pods)} compartments", self.pods, "burnt_ha", "burnt in the mean fire [ha]"),
            MapLayer("Borders of the compartments", self.borders, "suitability", "suitability of the border"),
        )


def delineate(
    network: SpreadNetwork,
    suitability: Plane,
    *,
    size_ha: float = 500.0,
    strength: float = 30.0,
    factors: Mapping[str, Plane] | None = None,
    vegetation: Plane | None = None,
    value: Plane | None = None,
    ignition: Plane | None = None,
    burn_frequency: Plane | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Delineation:
    """Delineate a landscape.

    Parameters
    ----------
    network
        The spread network before cutting.
    suitability
        (y, x) how well a line can be held, 0 to 1, see `landscape.siting`.
    size_ha
        Size of the compartments [ha of fuel]: none is larger than one and a half times this, unless it cannot be split.
    strength
        How many times as much as the best ground the worst counts; 1: lines are as short as can be.
    factors
        By name, (y, x) planes from 0 to 1 of which the suitability is made.
    vegetation
        (y, x) class codes.
    value, ignition
        As in `compartments.compartments_of`.
    burn_frequency
        (y, x) share of the fires in which each cell burns.
    threads, progress
        Threads, and callback (share done, message).

    Raises
    ------
    ParameterError
        If the size is less than 16 cells, or the strength not from 1 to 100.
    InputError
        If nothing holds fuel, or the suitability is unknown on fuel.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.SpreadNetwork(np.full((8, 40, 60), 0.5))  # cells of a square metre
    >>> road = np.zeros((40, 60))
    >>> road[:, 31] = 1.0
    >>> found = delineate(network, road, size_ha=0.0001 * 1000)
    >>> len(found.pods), float(found.borders["suitability"].iloc[0].round(1))
    (2, 1.0)
    """
    grid = network.grid
    target = size_ha / grid.cell_area_ha
    if not target >= 16:
        raise ParameterError(
            f"compartments of {size_ha:g} ha are asked, of {target:.3g} cells; expected at least 16 cells, "
            f"{16 * grid.cell_area_ha:.3g} ha"
        )
    if not 1.0 <= strength <= 100.0:
        raise ParameterError(f"the strength is {strength:g}, expected a number from 1 (all ground alike) to 100")
    good = network.plane(suitability, "suitability").astype(np.float64)
    if not network.burnable.any() or np.isnan(good[network.burnable]).any():
        raise InputError("the suitability must be known on all fuel, and there must be some")
    report = progress or silent
    stakes = Stakes(network, difficulty=_price(good, network.burnable, strength))
    largest = int(_LARGEST * target)
    walls = np.zeros(network.burnable.size, bool)
    for cut in dissect(
        network, stakes, smallest=largest + 1, threads=threads, progress=part(report, 0.0, 0.8, "control lines: ")
    ):
        walls[cut.cells] = True
    parts = split(network, walls.reshape(network.shape))
    report(0.8, "compartments")
    labels = _grown(parts.labels, network)
    labels = _joined(labels, network.burnable, good, target, largest)
    report(0.9, "borders")
    return _described(
        labels,
        network,
        good,
        {name: network.plane(plane, name).astype(np.float64) for name, plane in (factors or {}).items()},
        None if vegetation is None else network.plane(vegetation, "vegetation"),
        weights(network, value, "value"),
        weights(network, ignition, "ignition"),
        None
        if burn_frequency is None
        else np.nan_to_num(network.plane(burn_frequency, "burn_frequency").astype(float)),
    )


def _price(good: np.ndarray, fuel: np.ndarray, strength: float) -> np.ndarray:
    """What a border in each cell costs, from 1 on the best ground, in halves, since small prices are cut fast."""
    low, high = float(good[fuel].min()), float(good[fuel].max())
    worse = np.clip((high - good) / max(high - low, 1e-12), 0.0, 1.0)
    return np.where(fuel, np.rint(2.0 * strength**worse) / 2.0, 1.0)


def _grown(labels: np.ndarray, network: SpreadNetwork) -> np.ndarray:
    """Labels also on walls and near ground without fuel: cells of the nearest labelled cell.

    Walls go first, and only to fuel, so that a compartment does not reach over a river.
    """
    from scipy import ndimage

    grown = labels.copy()
    reach = _REACH / network.grid.cell_size
    for within, cells in ((np.inf, network.burnable), (max(reach, 2.0), np.ones(labels.shape, bool))):
        away, (row, col) = ndimage.distance_transform_edt(grown == 0, return_indices=True)
        fill = (grown == 0) & cells & (away <= within)
        grown = np.where(fill, grown[row, col], grown)
    return np.asarray(grown, np.int32)


@dataclass
class _Border:
    """Sides of cells between two compartments: their number, and the sum of their suitability."""

    sides: int = 0
    good: float = 0.0

    def add(self, other: _Border) -> None:
        self.sides += other.sides
        self.good += other.good

    @property
    def mean(self) -> float:
        return self.good / max(self.sides, 1)


def _sides(labels: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs of cells that lie side by side in two compartments: cells, and the lower and higher number, (m, 2)."""
    number = np.arange(labels.size).reshape(labels.shape)
    one = np.concatenate([number[:, :-1].ravel(), number[:-1].ravel()])
    two = np.concatenate([number[:, 1:].ravel(), number[1:].ravel()])
    flat = labels.ravel()
    apart = (flat[one] != flat[two]) & (flat[one] > 0) & (flat[two] > 0)
    one, two = one[apart], two[apart]
    return one, two, np.sort(np.column_stack([flat[one], flat[two]]), axis=1)


def _joined(labels: np.ndarray, fuel: np.ndarray, good: np.ndarray, target: float, largest: float) -> np.ndarray:
    """Join neighbours over the worst border first, while both together hold no more than the target.

    What is then smaller than a quarter of the target joins the neighbour over the worst border that leaves no more than
    the largest.
    """
    one, two, pairs = _sides(labels)
    value = np.maximum(good.ravel()[one], good.ravel()[two])
    n = int(labels.max(initial=0))
    near: list[dict[int, _Border]] = [{} for _ in range(n + 1)]
    for (a, b), v in zip(pairs.tolist(), value.tolist(), strict=True):
        border = near[a].setdefault(b, _Border())
        near[b][a] = border
        border.add(_Border(1, v))
    size = np.bincount(labels[fuel], minlength=n + 1).astype(float)
    name = np.arange(n + 1)

    def join(a: int, b: int) -> None:
        """Compartment b becomes part of a."""
        name[name == b] = a
        size[a] += size[b]
        del near[a][b], near[b][a]
        for c, border in near[b].items():
            del near[c][b]
            if c in near[a]:
                near[a][c].add(border)
            else:
                near[a][c] = near[c][a] = border
        near[b] = {}

    def worst(limit: float, least: float) -> tuple[int, int] | None:
        options = [
            (border.mean, a, b)
            for a in range(1, n + 1)
            for b, border in near[a].items()
            if a < b and size[a] + size[b] <= limit and min(size[a], size[b]) < least
        ]
        return min(options)[1:] if options else None

    for limit, least in ((target, np.inf), (largest, 0.25 * target)):
        while (pair := worst(limit, least)) is not None:
            join(*pair)
    joined = name[labels]
    first = {int(k): i for i, k in enumerate(dict.fromkeys(joined[joined > 0].tolist()), start=1)}
    table = np.zeros(n + 1, np.int32)
    for k, i in first.items():
        table[k] = i
    return np.asarray(table[joined])


def _described(
    labels: np.ndarray,
    network: SpreadNetwork,
    good: np.ndarray,
    factors: Mapping[str, np.ndarray],
    vegetation: np.ndarray | None,
    value: np.ndarray,
    ignition: np.ndarray,
    frequency: np.ndarray | None,
) -> Delineation:
    """Tables of compartments and borders."""
    import geopandas as gpd

    grid, n = network.grid, int(labels.max(initial=0))

    def total(plane: np.ndarray) -> np.ndarray:
        return np.asarray(np.bincount(labels.ravel(), weights=plane.ravel().astype(float), minlength=n + 1)[1:])

    borders = _borders(labels, network, good, factors)
    fuel = total(network.burnable)
    columns: dict[str, Any] = {
        "pod": np.arange(1, n + 1),
        "area_ha": total(np.ones(labels.shape)) * grid.cell_area_ha,
        "fuel_ha": fuel * grid.cell_area_ha,
    }
    if vegetation is not None:
        for code, word in VEGETATION.items():
            if code:
                columns[word] = total(network.burnable & (vegetation == code)) / np.maximum(fuel, 1.0)
    columns["ignition_share"] = total(ignition) / max(float(ignition.sum()), 1e-300)
    columns["value"] = total(value)
    columns["burnt_ha"] = np.full(n, np.nan) if frequency is None else total(frequency) * grid.cell_area_ha
    columns |= _of_sides(borders, n)
    pods = gpd.GeoDataFrame(columns, geometry=outlines(labels, n, grid), crs=grid.crs)
    told = grid.dataarray(labels, "compartment").assign_attrs(long_name="potential operational delineation", units="1")
    return Delineation(told, pods, borders)


def _borders(
    labels: np.ndarray, network: SpreadNetwork, good: np.ndarray, factors: Mapping[str, np.ndarray]
) -> gpd.GeoDataFrame:
    """The sides between every two compartments as lines; their length is that of the line through their steps."""
    import geopandas as gpd
    import shapely

    grid, cols = network.grid, labels.shape[1]
    one, two, pairs = _sides(labels)
    row, col = np.divmod(two, cols)
    upright = two == one + 1  # the side lies west of the second cell, else north of it
    ends = np.stack([np.column_stack([col, row]), np.column_stack([col + ~upright, row + upright])], axis=1)
    t = grid.transform
    x, y = t.c + t.a * ends[..., 0] + t.b * ends[..., 1], t.f + t.d * ends[..., 0] + t.e * ends[..., 1]
    keys, group = np.unique(pairs, axis=0, return_inverse=True)
    group = group.ravel()
    drawn = shapely.linestrings(np.stack([x, y], axis=-1))
    rows: list[dict[str, Any]] = []
    lines = []
    for k, (a, b) in enumerate(keys.tolist()):
        own = group == k
        line = shapely.line_merge(shapely.union_all(drawn[own]))
        lines.append(line)
        on = {
            f"on_{name}": float((np.maximum(plane.ravel()[one[own]], plane.ravel()[two[own]]) >= _ON).mean())
            for name, plane in factors.items()
        }
        rows.append(
            {
                "pod_a": a,
                "pod_b": b,
                "length_m": float(shapely.simplify(line, grid.cell_size).length),
                "suitability": float(np.maximum(good.ravel()[one[own]], good.ravel()[two[own]]).mean()),
                **on,
            }
        )
    names = ("pod_a", "pod_b", "length_m", "suitability", *(f"on_{name}" for name in factors))
    table = {name: [row[name] for row in rows] for name in names}
    return gpd.GeoDataFrame(table, geometry=lines, crs=grid.crs)


def _of_sides(borders: gpd.GeoDataFrame, n: int) -> dict[str, np.ndarray]:
    """Length, and means along it, of the border that each compartment shares with others."""
    length = borders["length_m"].to_numpy(float)
    ends = np.concatenate([borders["pod_a"], borders["pod_b"]]).astype(np.int64)
    whole = np.bincount(ends, weights=np.tile(length, 2), minlength=n + 1)[1:]
    found = {"border_m": whole}
    for name in borders.columns:
        if name == "suitability" or str(name).startswith("on_"):
            weighed = np.tile(length * borders[name].to_numpy(float), 2)
            mean = np.bincount(ends, weights=weighed, minlength=n + 1)[1:]
            found[str(name)] = np.divide(mean, whole, out=np.full(n, np.nan), where=whole > 0)
    return found


def square_suitability(suitability: np.ndarray, fuel: np.ndarray, cells: float) -> float:
    """Mean suitability along a square grid of lines around compartments of so many cells: what looks at nothing gets.

    Over both sides of a line, as of the borders, and over four shifts of the grid.
    """
    side = max(round(float(np.sqrt(cells))), 2)
    means = []
    for shift in (0, side // 4, side // 2, 3 * side // 4):
        for plane, has in ((suitability, fuel), (suitability.T, fuel.T)):
            at = np.arange(shift or side, plane.shape[0], side)
            if at.size:
                on = has[at] & has[at - 1]
                means.append(np.maximum(plane[at], plane[at - 1])[on])
    found = np.concatenate(means) if means else np.zeros(0)
    return float(found.mean()) if found.size else float("nan")
