"""What existing breaks are worth, and which gap between them matters most: the same fires with and without each.

What a break is worth is what more burns in the mean fire if it alone is given up; breaks that do the same work are
worth little one by one, so what each saves alone stands beside it. The null model is the same break somewhere else:
its cells, turned and moved at random, alone on the landscape. It tells what any break of that size would save.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation.gaps import find_gaps
from firebreak_gis.evaluation.measures import BOUNDS, resamples
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.schema import MapLayer, Shown

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.landscape.existing import Existing
    from firebreak_gis.network import SpreadNetwork

#: Cells burnt in each run where a (rows, cols) bool mask is cut.
Burner = Callable[[np.ndarray, Progress], np.ndarray]
#: A moved break has at least this share of its cells on fuel, if such a place is found in so many tries.
_ON_FUEL, _TRIES = 0.9, 60


@dataclass(frozen=True, repr=False, eq=False)
class Assessment(Shown):
    """Breaks and gaps, best first.

    Parameters
    ----------
    breaks
        One row a break: `rank`, `number` (in the order of the source, from 1), `length_m`, `cells` (with fuel),
        `worth_ha` (saved in the mean fire beside all others) and `alone_ha` (saved alone), each with `_low` and
        `_high`, the ends of its 95 % interval, `worth_per_km`, and `random_ha`: the mean of what it saves alone at
        random places. `upkeep_ha`, hectares to treat anew every year, and `keep`: whether the whole interval of what it
        is worth in the fires of a year lies above that (`yes`), below it (`no`) or neither (`unsure`).
    gaps
        One row a gap: `rank`, `from_break`, `to_break` (numbers; 0 for ground without fuel), `length_m`, `cells`,
        `saved_ha` with `_low` and `_high`, `saved_per_km`, and `random_per_km`: of the same line at random places.
    burnt_ha, burnt_bare_ha
        Hectares burnt in the mean fire with all breaks, and with none.
    left_out
        Gaps that were found and not looked at, the longest.
    """

    breaks: gpd.GeoDataFrame
    gaps: gpd.GeoDataFrame
    burnt_ha: float
    burnt_bare_ha: float
    left_out: int

    def facts(self) -> dict[str, object]:
        """What stands, what it saves and what is missing, as `repr` and notebooks show them."""
        return {
            "breaks": len(self.breaks),
            "gaps": len(self.gaps),
            "mean fire": f"{self.burnt_bare_ha:,.4g} ha without, {self.burnt_ha:,.4g} ha with the breaks",
            "worth most": f"break {self.breaks['number'].iloc[0]}, {self.breaks['worth_ha'].iloc[0]:,.3g} ha",
        }

    def layers(self) -> tuple[MapLayer, ...]:
        """Breaks by what each is worth, gaps by what closing them saves."""
        return (
            MapLayer(f"{len(self.breaks)} breaks", self.breaks, "worth_ha", "worth beside all others [ha]"),
            MapLayer("Gaps between them", self.gaps, "saved_per_km", "saved if closed [ha/km]"),
        )


def assess(
    network: SpreadNetwork,
    existing: Existing,
    burnt: Burner,
    *,
    longest_gap: float = 500.0,
    most_gaps: int = 40,
    placements: int = 3,
    upkeep: np.ndarray | None = None,
    fires_per_year: float = 1.0,
    seed: int = 0,
    foreseen: Callable[[int, int], None] | None = None,
    progress: Progress | None = None,
) -> Assessment:
    """Judge existing breaks, and the gaps between them.

    Parameters
    ----------
    network
        Before cutting; on its grid lie the breaks.
    existing
        As `landscape.existing.existing_breaks` returns it.
    burnt
        Called with a mask of what is cut and a progress; returns the cells burnt in each run, always of the same fires.
    longest_gap, most_gaps
        Length of the longest gap [m], and how many are looked at, the shortest.
    placements
        Random places of each break and gap, for the null model; 0: none, and its columns are NaN.
    upkeep
        (rows, cols) share of each cell that must be treated anew every year for a break to stay one; None: not told.
    fires_per_year
        Fires that start in a year.
    seed
        Of the places and of the bootstrap.
    foreseen
        Told, before the work, how often `burnt` will be called with at most one break standing, and with most of them.
    progress
        Callback (share done, message).

    Raises
    ------
    InputError
        If there is no break, or none has a cell with fuel.
    ParameterError
        If a number is negative.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.read_landscape(**fb.sample_layers(), resolution=200.0))
    >>> roads = fb.existing_breaks("sample_data/roads.gpkg", network.grid)
    >>> def burnt(cut, progress):
    ...     return fb.simulate(network, breaks=cut, n_runs=20, progress=progress)["fire_size"].to_numpy()
    >>> found = fb.assess(network, roads, burnt, placements=0)
    >>> len(found.breaks) == len(roads.cells), found.burnt_ha <= found.burnt_bare_ha
    (True, True)
    """
    if not (longest_gap >= 0 and most_gaps >= 0 and placements >= 0 and 0 <= fires_per_year < np.inf):
        raise ParameterError(
            f"the longest gap is {longest_gap:g} m, {most_gaps} gaps, {placements} placements and {fires_per_year:g} "
            "fires a year are asked, expected numbers of at least 0"
        )
    fuel = network.burnable.ravel()
    own = [cells[fuel[cells]] for cells in existing.cells]
    if not any(cells.size for cells in own):
        raise InputError(
            "no break lies on a cell with fuel, so none can be judged; was the fuel taken off them before?"
        )
    gaps, left_out = find_gaps(existing, network.burnable, network.grid, longest=longest_gap, most=most_gaps)
    # Alone and at random places; all but one, and with a gap closed.
    few, most = 1 + (1 + placements) * len(own), 1 + len(own) + (1 + placements) * len(gaps.cells)
    if foreseen is not None:
        foreseen(few, most)
    runs = _Runs(network, burnt, few + most, progress)
    bare, whole = runs(), runs(*own)
    rng = np.random.default_rng(seed)
    picks = resamples(bare.size, seed)
    rows: list[dict[str, Any]] = []
    for i, cells in enumerate(own):
        rest = [other for j, other in enumerate(own) if j != i]
        moved = [bare - runs(_moved(cells, network, rng)) for _ in range(placements)]
        rows.append(
            {
                "number": i + 1,
                "cells": cells.size,
                **_with_interval("worth_ha", runs(*rest) - whole, picks),
                **_with_interval("alone_ha", bare - runs(cells), picks),
                "random_ha": float(np.mean(moved)) if placements else np.nan,
            }
        )
    more: list[dict[str, Any]] = []
    for k, cells in enumerate(gaps.cells):
        km = float(gaps.frame["length_m"].iloc[k]) / 1000.0
        moved = [whole - runs(*own, _moved(cells, network, rng)) for _ in range(placements)]
        closed = _with_interval("saved_ha", whole - runs(*own, cells), picks)
        more.append(
            {
                "cells": cells.size,
                **closed,
                "saved_per_km": closed["saved_ha"] / km,
                "random_per_km": float(np.mean(moved)) / km if placements else np.nan,
            }
        )
    breaks = _ranked(existing.frame, {"length_m": existing.lengths}, rows, "worth_ha")
    if upkeep is not None:
        area = [float(upkeep.ravel()[own[k]].sum()) * network.grid.cell_area_ha for k in breaks["number"] - 1]
        breaks["upkeep_ha"] = area
        low, high = (fires_per_year * breaks[f"worth_ha_{end}"].to_numpy() for end in ("low", "high"))
        breaks["keep"] = np.select([low > area, high < area], ["yes", "no"], "unsure")
    breaks["worth_per_km"] = breaks["worth_ha"] / np.maximum(breaks["length_m"] / 1000.0, 1e-9)
    numbers = {
        "from_break": gaps.frame["from_break"].to_numpy() + 1,
        "to_break": gaps.frame["to_break"].to_numpy() + 1,
        "length_m": gaps.frame["length_m"].to_numpy(),
    }
    return Assessment(
        breaks, _ranked(gaps.frame, numbers, more, "saved_per_km"), float(whole.mean()), float(bare.mean()), left_out
    )


class _Runs:
    """Hectares burnt in each run where sets of cells are cut; counts how many of all burns are done."""

    def __init__(self, network: SpreadNetwork, burnt: Burner, count: int, progress: Progress | None) -> None:
        self._network, self._burnt, self._count, self._done = network, burnt, count, 0
        self._progress = progress or silent

    def __call__(self, *cut: np.ndarray) -> np.ndarray:
        mask = np.zeros(self._network.shape, bool)
        for cells in cut:
            mask.ravel()[cells] = True
        span = self._done / self._count, (self._done + 1) / self._count
        self._done += 1
        step = part(self._progress, *span, f"burn {self._done} of {self._count}: ")
        return np.asarray(self._burnt(mask, step) * self._network.grid.cell_area_ha)


def _with_interval(name: str, runs: np.ndarray, picks: np.ndarray) -> dict[str, float]:
    low, high = np.percentile(runs[picks].mean(axis=1), BOUNDS)
    return {name: float(runs.mean()), f"{name}_low": float(low), f"{name}_high": float(high)}


def _moved(cells: np.ndarray, network: SpreadNetwork, rng: np.random.Generator) -> np.ndarray:
    """The cells turned, mirrored and moved to a random place, that of several tries with most of them on fuel."""
    rows, cols = network.shape
    row, col = np.divmod(cells, cols)
    best = np.zeros(0, np.int64)
    for _ in range(_TRIES):
        r, c = row - row.min(initial=0), col - col.min(initial=0)
        if rng.random() < 0.5:
            r, c = c, r
        if rng.random() < 0.5:
            r = r.max(initial=0) - r
        if rng.random() < 0.5:
            c = c.max(initial=0) - c
        r, c = r + rng.integers(0, rows), c + rng.integers(0, cols)
        inside = (r < rows) & (c < cols)
        place = (r * cols + c)[inside]
        place = place[network.burnable.ravel()[place]]
        best = max(best, place, key=len)
        if place.size >= _ON_FUEL * cells.size:
            break
    return best


def _ranked(
    frame: gpd.GeoDataFrame, known: dict[str, np.ndarray], rows: list[dict[str, Any]], by: str
) -> gpd.GeoDataFrame:
    """Rows with their geometry, best first, ties in the old order."""
    import geopandas as gpd
    import pandas as pd

    table = pd.DataFrame(rows) if rows else pd.DataFrame({by: np.zeros(0)})
    for k, (name, values) in enumerate(known.items()):
        table.insert(k, name, values)
    order = np.argsort(-table[by].to_numpy(), kind="stable")
    table = table.iloc[order].reset_index(drop=True)
    table.insert(0, "rank", np.arange(1, len(table) + 1))
    return gpd.GeoDataFrame(table, geometry=frame.geometry.to_numpy()[order], crs=frame.crs)


def told(found: Assessment) -> list[str]:
    """Say what stands and what is missing, as sentences."""
    saved = found.burnt_bare_ha - found.burnt_ha
    bare = f"{found.burnt_bare_ha:,.4g} ha that the mean fire burns without them"
    sentences = [f"The {len(found.breaks)} breaks save {saved:,.4g} ha of the {bare}."]
    sure = int((found.breaks["worth_ha_low"] > 0).sum())
    first = found.breaks.iloc[0]
    sentences.append(
        f"Break {first['number']} is worth most: without it {first['worth_ha']:,.3g} ha more burn "
        f"({first['worth_ha_low']:,.3g} to {first['worth_ha_high']:,.3g}); alone it saves {first['alone_ha']:,.3g} ha"
        + ("" if np.isnan(first["random_ha"]) else f", at random places {first['random_ha']:,.3g} ha")
        + f". For {sure} of {len(found.breaks)} breaks the interval lies above 0."
    )
    if "keep" in found.breaks:
        dropped = found.breaks.loc[found.breaks["keep"] == "no", "number"].tolist()
        kept = int((found.breaks["keep"] == "yes").sum())
        sentences.append(
            f"{kept} are worth their upkeep"
            + (f"; {len(dropped)} cost more than they save: {', '.join(map(str, dropped))}" if dropped else "")
            + f"; of {len(found.breaks) - kept - len(dropped)} these fires do not tell."
        )
    if not len(found.gaps):
        sentences.append("No gap was found at a loose end.")
        return sentences
    gap = found.gaps.iloc[0]
    to = f"break {gap['to_break']}" if gap["to_break"] else "ground without fuel"
    sentences.append(
        f"The gap that matters most leads from break {gap['from_break']} to {to} over {gap['length_m']:,.0f} m: "
        f"closing it saves {gap['saved_ha']:,.3g} ha a fire "
        f"({gap['saved_ha_low']:,.3g} to {gap['saved_ha_high']:,.3g}), "
        f"{gap['saved_per_km']:,.3g} ha a km"
        + ("" if np.isnan(gap["random_per_km"]) else f"; the same line at random places {gap['random_per_km']:,.3g}")
        + "."
    )
    if found.left_out:
        sentences.append(f"{found.left_out} longer gaps were not looked at (--most-gaps).")
    return sentences
