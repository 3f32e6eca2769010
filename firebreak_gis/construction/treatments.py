"""Ways to treat a segment of break: what each leaves of the spread, what it costs, and which to take where.

A table of treatments is a CSV file with a line for each treatment and type of vegetation:

    name,vegetation,residual,cost_ha,cost_per_degree,years,max_slope_deg

`residual` is the share of its spread probability that a treated cell keeps; a hectare costs `cost_ha` and
`cost_per_degree` more for each degree of slope; after `years` it has grown back, so that a year costs the cost over
`years`. A treatment is not allowed on types without a line, nor on slopes above `max_slope_deg`. The built-in table is
an example: that clearing costs about 1,000 EUR/ha (Portugal) and work in California from 4,900 USD/ha is told in
practice, all its other numbers are assumptions.

What a segment saves is its gain, by the model of `compartments`, times the share of fires that it stops, see `stops`.
This is a model to choose by; the fires that judge a plan burn with what the treatments leave, cell by cell.
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

from firebreak_gis.errors import InputError
from firebreak_gis.schema import VEGETATION

if TYPE_CHECKING:
    import geopandas as gpd

    Amount = float | np.ndarray

#: What the numbers of a plan mean.
ASSUMED = (
    "a segment saves its gain times exp(-m (3 p r)^w), m cells met, w wide, that keep r of p (a model, for the choice "
    "alone); the simulated fires burn with what the chosen treatments leave"
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


def as_treatments(given: Any) -> Treatments | None:
    """Read a table of treatments: None, `Treatments`, "default" for the built-in one, or the name of a file."""
    if given is None or isinstance(given, Treatments):
        return given
    return read_treatments(None if str(given).strip().lower() == "default" else given)


def stops(residual: Amount, width: Amount, met: Amount, probability: float) -> np.ndarray:
    """Share of the fires that meet a segment which it stops, by a model of thin walls that leak.

    A cell beside the wall has three neighbours in it, and so lights 3 p r cells of its first row in the mean; each of
    those does the same with the next. So m (3 p r)^w fires are expected behind a wall of w rows which m cells of fire
    meet, and exp(-m (3 p r)^w) is the share of fires without any, were they independent. What runs along inside the
    wall is left out.

    Parameters
    ----------
    residual
        Share r of its spread probability that a treated cell keeps.
    width, met
        w and m [cells].
    probability
        Mean spread probability p.

    Examples
    --------
    >>> stops(np.array([0.0, 0.05, 0.3]), 1, 14, 0.5).round(3), float(stops(0.3, 3, 14, 0.5).round(2))
    (array([1.   , 0.35 , 0.002]), 0.28)
    """
    behind = met * (3.0 * probability * np.asarray(residual)) ** width
    return np.asarray(np.exp(-behind))


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
    pick = _cheapest(cost, saving)
    while saving[every, pick].sum() < target and _better(cost, saving, pick, np.inf):
        pass
    for segment in np.argsort(-cost[every, pick], kind="stable"):
        spare = saving[every, pick].sum() - target
        enough = saving[segment, pick[segment]] - worth[segment] <= spare
        pick[segment] = int(np.argmin(np.where(enough, cost[segment], np.inf)))
    choices = [single for single in singles(cost, saving) if saving[every, single].sum() >= target]
    return min([pick, *choices], key=lambda chosen: float(cost[every, chosen].sum()))


def spend(cost: np.ndarray, saving: np.ndarray, money: float) -> np.ndarray:
    """Take a treatment for each segment, so that all cost at most `money` and save much.

    As `choose`, but the steps to better treatments are made as long as the money lasts. Where one single treatment
    everywhere can be paid and saves more, that is taken.

    Parameters
    ----------
    cost, saving
        As in `choose`.
    money
        At least what the cheapest treatments cost together.

    Returns
    -------
    numpy.ndarray
        (n,) treatment of each segment.

    Examples
    --------
    >>> cost, saving = np.array([[1.0, 9.0], [1.0, 2.0]]), np.array([[5.0, 6.0], [1.0, 8.0]])
    >>> spend(cost, saving, 4.0).tolist(), spend(cost, saving, 11.0).tolist()
    ([0, 1], [1, 1])
    """
    every = np.arange(len(cost))
    money *= 1 + 1e-12
    pick = _cheapest(cost, saving)
    while _better(cost, saving, pick, money - float(cost[every, pick].sum())):
        pass
    choices = [single for single in singles(cost, saving) if cost[every, single].sum() <= money]
    return max([pick, *choices], key=lambda chosen: float(saving[every, chosen].sum()))


def _cheapest(cost: np.ndarray, saving: np.ndarray) -> np.ndarray:
    """Cheapest treatment of each segment; of those the one that saves most."""
    return np.asarray(np.lexsort((-saving.T, cost.T), axis=0)[0])


def singles(cost: np.ndarray, saving: np.ndarray) -> list[np.ndarray]:
    """Each treatment everywhere, with the cheapest where it is not allowed."""
    return [np.where(np.isfinite(column), k, _cheapest(cost, saving)) for k, column in enumerate(cost.T)]


def _better(cost: np.ndarray, saving: np.ndarray, pick: np.ndarray, money: float) -> bool:
    """Make the step to a better treatment that adds most for its cost, at most `money`; tell whether there is one."""
    every = np.arange(len(cost))
    price = cost - cost[every, pick][:, np.newaxis]
    more = saving - saving[every, pick][:, np.newaxis]
    ratio = np.where((price <= money) & (more > 0), more / np.maximum(price, 1e-12), 0.0)
    if not ratio.size or not ratio.max() > 0:
        return False
    segment, step = np.unravel_index(int(np.argmax(ratio)), ratio.shape)
    pick[segment] = step
    return True


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
