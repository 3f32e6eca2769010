"""Ways to treat a segment of break: what each leaves of the spread, what it costs, and which to take where.

A table of treatments is a CSV file with a line for each treatment and type of vegetation:

    name,vegetation,residual,cost_ha,cost_per_degree,years,max_slope_deg

`residual` is the share of its spread probability that a treated cell keeps; a hectare costs `cost_ha` and
`cost_per_degree` more for each degree of slope; after `years` it has grown back, so that a year costs the cost over
`years`. A treatment is not allowed on types without a line, nor on slopes above `max_slope_deg`. The built-in table is
an example: that clearing costs about 1,000 EUR/ha (Portugal) and work in California from 4,900 USD/ha is told in
practice, all its other numbers are assumptions.

What a segment saves is its gain, by the model of `compartments`, times 1 less its mean residual: as if that share of
the fires that meet it passed. This is an assumption, and with many fires on a thin line an optimistic one.
"""

from __future__ import annotations

import csv
import importlib.resources
import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.segments import Segments
from firebreak_gis.errors import InputError
from firebreak_gis.schema import VEGETATION

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

#: What the numbers of a plan mean.
ASSUMED = (
    "a segment saves its gain times 1 less its residual; "
    "the simulated fires of the plan take --residual for all segments"
)
#: What is written where nothing is allowed.
NONE = "none"


@dataclass(frozen=True)
class Row:
    """A treatment on one type of vegetation; see the text of the module."""

    residual: float
    cost_ha: float
    cost_per_degree: float
    years: float
    max_slope_deg: float


@dataclass(frozen=True)
class Treatments:
    """A table of treatments.

    Parameters
    ----------
    source
        The file that it was read from.
    rows
        By name and word of the vegetation.
    """

    source: str
    rows: Mapping[tuple[str, str], Row]

    @property
    def names(self) -> tuple[str, ...]:
        """The treatments, in the order of the table."""
        return tuple(dict.fromkeys(name for name, _ in self.rows))


def read_treatments(path: str | os.PathLike[str] | None = None) -> Treatments:
    """Read a table of treatments; None is the built-in one.

    Raises
    ------
    InputError
        If it cannot be read, or a line of it makes no sense.

    Examples
    --------
    >>> read_treatments().names
    ('clearing', 'thinning', 'mastication', 'prescribed burning', 'grazing')
    """
    if path is None:
        text = importlib.resources.files("firebreak_gis.construction").joinpath("treatments.csv").read_text("utf-8")
        source = ""
    else:
        source = os.fspath(path)
        try:
            text = Path(source).read_text(encoding="utf-8-sig")
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"{source} cannot be read as a table of treatments: {error}") from error
    lines = csv.DictReader(text.splitlines())
    numbers = [each.name for each in fields(Row)]
    missing = {"name", "vegetation", *numbers} - set(lines.fieldnames or ())
    if missing:
        raise InputError(f"{source} lacks the columns {', '.join(sorted(missing))} of a table of treatments")
    rows: dict[tuple[str, str], Row] = {}
    for line in lines:
        where = f"line {lines.line_num} of {source or 'the built-in table'}"
        key = ((line["name"] or "").strip(), (line["vegetation"] or "").strip())
        words = [word for code, word in VEGETATION.items() if code]
        if not key[0] or key[0] == NONE or key[1] not in words or key in rows:
            raise InputError(
                f"{where} is for {key[0]!r} on {key[1]!r}, expected a name, one of {', '.join(words)}, each pair once"
            )
        try:
            row = Row(**{name: float(line[name] or "") for name in numbers})
        except (TypeError, ValueError):
            raise InputError(f"{where} has a cell that is no number, expected {', '.join(numbers)}") from None
        values = [getattr(row, name) for name in numbers]
        if not all(math.isfinite(v) and v >= 0 for v in values) or row.residual > 1 or row.years <= 0:
            raise InputError(f"{where}: expected a residual from 0 to 1, years above 0 and all else at least 0")
        rows[key] = row
    if not rows:
        raise InputError(f"{source} holds no treatment")
    return Treatments(source, rows)


def choose(cost: np.ndarray, saving: np.ndarray, target: float) -> np.ndarray:
    """Take a treatment for each segment, so that all save at least `target` for little.

    From the cheapest treatment of each segment, that step to a better one is made that adds most for its cost, until
    the target is reached; then what is not needed is taken back. Where one single treatment everywhere reaches the
    target for less, that is taken: the choice is never dearer than the best single treatment for the same saving.

    Parameters
    ----------
    cost, saving
        (n, k) of each segment under each treatment; an infinite cost where it is not allowed. Each segment has one that
        is allowed.
    target
        Sum of savings to reach; one that cannot be reached is lowered to the most that can.

    Returns
    -------
    numpy.ndarray
        (n,) treatment of each segment.

    Examples
    --------
    >>> cost, saving = np.array([[1.0, 9.0], [1.0, 2.0]]), np.array([[5.0, 6.0], [1.0, 8.0]])
    >>> choose(cost, saving, 13.0).tolist()
    [0, 1]
    """
    every = np.arange(len(cost))
    worth = np.where(np.isfinite(cost), saving, -np.inf)
    target = min(target, float(worth.max(axis=1).sum())) * (1 - 1e-12)
    best = np.lexsort((-saving.T, cost.T), axis=0)[0]
    pick = best.copy()
    while saving[every, pick].sum() < target:
        more = np.where(np.isfinite(cost), saving - saving[every, pick][:, np.newaxis], 0.0)
        price = np.maximum(cost - cost[every, pick][:, np.newaxis], 1e-12)
        ratio = np.where(more > 0, more / price, -np.inf)
        segment, step = np.unravel_index(int(np.argmax(ratio)), ratio.shape)
        if not ratio[segment, step] > 0:
            break
        pick[segment] = step
    for segment in np.argsort(-cost[every, pick], kind="stable"):
        spare = saving[every, pick].sum() - target
        enough = saving[segment, pick[segment]] - worth[segment] <= spare
        pick[segment] = int(np.argmin(np.where(enough, cost[segment], np.inf)))
    choices = [pick]
    for k in range(cost.shape[1]):
        single = np.where(np.isfinite(cost[:, k]), k, best)
        if saving[every, single].sum() >= target:
            choices.append(single)
    return min(choices, key=lambda chosen: float(cost[every, chosen].sum()))


def with_treatments(frames: Segments, landscape: xr.Dataset, treatments: Treatments) -> Segments:
    """Add a treatment to each segment: together they save as much as the best single one, for as little as possible.

    The best single treatment saves most for its yearly cost; where it is not allowed, the cheapest that is.

    Parameters
    ----------
    frames
        Lines and polygons, as `segments.segments_of` returns them.
    landscape
        With `vegetation` and `elevation`, on the grid of the segments.
    treatments
        The table.

    Returns
    -------
    lines, polygons : geopandas.GeoDataFrame
        With the columns `treatment`, `treatment_residual` (mean over the cells), `treatment_cost`, `treatment_yearly`
        (in the unit of the table) and `treatment_saving`, in the unit of the gain. `none` where nothing is allowed.
    """
    lines, polygons = frames
    residual, cost, yearly = _options(polygons, landscape, treatments)
    gain = polygons["gain"].to_numpy(dtype=float)[:, np.newaxis]
    saving = gain * (1.0 - residual)
    allowed = np.isfinite(cost)
    free = ~allowed.any(axis=1)
    yearly[free, 0], saving[free, 0] = 0.0, 0.0  # a segment that cannot be treated takes part with nothing
    pick = choose(yearly, saving, _best_single(yearly, saving)) if len(polygons) else np.zeros(0, np.int64)
    every = np.arange(len(polygons))
    columns: dict[str, Any] = {
        "treatment": np.where(free, NONE, np.array(treatments.names, object)[pick]),
        "treatment_residual": np.where(free, 1.0, residual[every, pick]),
        "treatment_cost": np.where(free, 0.0, cost[every, pick]),
        "treatment_yearly": yearly[every, pick],
        "treatment_saving": saving[every, pick],
    }
    return Segments(lines.assign(**columns), polygons.assign(**columns))


def totals(polygons: gpd.GeoDataFrame) -> dict[str, dict[str, float]]:
    """Segments, hectares, costs and saving of each treatment, as plain data for an account."""
    found: dict[str, dict[str, float]] = {}
    for name, part in polygons.groupby("treatment"):
        found[str(name)] = {
            "segments": len(part),
            "area_ha": round(float(part["area_ha"].sum()), 4),
            **{each: round(float(part[f"treatment_{each}"].sum()), 4) for each in ("cost", "yearly", "saving")},
        }
    return found


def _best_single(yearly: np.ndarray, saving: np.ndarray) -> float:
    """Saving of the single treatment that saves most for its cost, with the cheapest where it is not allowed."""
    every = np.arange(len(yearly))
    cheapest = np.argmin(yearly, axis=1)
    found = []
    for k in range(yearly.shape[1]):
        pick = np.where(np.isfinite(yearly[:, k]), k, cheapest)
        saved = float(saving[every, pick].sum())
        found.append((saved / max(float(yearly[every, pick].sum()), 1e-12), saved))
    return max(found)[1]


def _options(
    polygons: gpd.GeoDataFrame, landscape: xr.Dataset, treatments: Treatments
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Mean residual, cost and yearly cost of each treatment on each segment, (n, k); infinite if not allowed."""
    from rasterio.features import rasterize

    from firebreak_gis.grid import Grid
    from firebreak_gis.kernels.terrain import horn_slope

    grid = Grid.of(landscape["vegetation"])
    n, shape = len(polygons), landscape["vegetation"].shape
    owner = np.zeros(shape, np.int32)
    if n:
        owner = rasterize(
            zip(polygons.geometry, range(1, n + 1), strict=True), shape, transform=grid.transform, dtype="int32"
        )
    inside = owner > 0
    segment = owner[inside] - 1
    codes = landscape["vegetation"].to_numpy()[inside]
    elevation = landscape["elevation"].to_numpy().astype(np.float64)
    slope = np.nan_to_num(horn_slope(elevation, grid.cell_size)[inside])
    cells = np.maximum(np.bincount(segment, minlength=n), 1)
    columns = []
    for name in treatments.names:
        planes = np.array([np.ones(codes.size), np.full(codes.size, np.inf), np.full(codes.size, np.inf)])
        for code, word in VEGETATION.items():
            row = treatments.rows.get((name, word))
            if row is not None:
                here = (codes == code) & (slope <= row.max_slope_deg)
                price = grid.cell_area_ha * (row.cost_ha + row.cost_per_degree * slope[here])
                planes[:, here] = np.array([np.full(price.size, row.residual), price, price / row.years])
        sums = [np.bincount(segment, weights=plane, minlength=n) for plane in planes]
        columns.append([sums[0] / cells, sums[1], sums[2]])
    residual, cost, yearly = np.array(columns).transpose(1, 2, 0)
    return residual, cost, yearly
