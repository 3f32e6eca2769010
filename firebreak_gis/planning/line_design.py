"""A plan of lines: walls in the order of building, and those that a budget buys.

The budget counts what the lines take of the land, length times width, or what that costs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.breaks import Budget
from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.footprints import footprints
from firebreak_gis.landscape.lines import LineBreaks, laid_on
from firebreak_gis.planning.wall_shapes import joined, on_map, resting
from firebreak_gis.schema import annotate
from firebreak_gis.simulation.holding import Hold

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.lines import LineCut
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Of lines [m], or that which suits the flames.
LineWidth = float | Literal["auto"]
#: The same, or whole cells in place of lines.
Widths = LineWidth | Literal["cells"]
#: Parameters of `dissection` that lines take.
PARAMS = frozenset({"directions", "smallest"})
#: Widths that are tried, from the narrowest up until two in a row are worse than the best [m].
WIDTHS = (5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 40.0, 60.0, 80.0, 120.0)
#: Walls are kept up to so many times the budget, for the curve about it.
_BEYOND = 2.0
#: Compartments of fewer cells are left whole, where nothing else is asked; the next where the budget pays all walls.
_SMALLEST = (64, 16, 4)


@dataclass(frozen=True, eq=False)
class LineDesign:
    """Walls in the order of building; each stands on those before it.

    Parameters
    ----------
    walls
        One row a wall: `length_m`, `width_m`, `area_ha`, `cost` (in the unit of the stakes), `saved` (expected loss
        that it saves at its turn, as a share of all ignitions times all value), and multilines.
    grid
        The grid of the network.
    fuel_ha
        Area of all fuel, of which budgets are shares.
    width
        Of the lines [m].
    told
        What they are, in words.
    """

    walls: gpd.GeoDataFrame
    grid: Grid
    fuel_ha: float
    width: float
    told: str

    def bought(self, budget: Budget) -> int:
        """How many walls a budget pays, the first ones."""
        budget.require()
        if budget.unit == "cost":
            return budget.affordable(self.walls["cost"].to_numpy())
        return Budget(_money(budget, self.fuel_ha), "cost").affordable(self.walls["area_ha"].to_numpy())

    def built(self, budget: Budget) -> gpd.GeoDataFrame:
        """Those walls."""
        return self.walls.iloc[: self.bought(budget)]

    def breaks(self, budget: Budget) -> LineBreaks | None:
        """The walls that a budget pays, on the grid; None if it pays none."""
        built = self.built(budget)
        return laid_on(built[["width_m", "geometry"]], self.grid) if len(built) else None

    def figures(self, budget: Budget) -> dict[str, Any]:
        """What the walls are that a budget pays: cells that they pass, hectares, cost, kilometres and their number."""
        built = self.built(budget)
        return {
            "cells_cut": int(self.passed(budget).attrs["cells_cut"]),
            "ha_cut": round(float(built["area_ha"].sum()), 4),
            "cost": float(built["cost"].sum()),
            "line_km": round(float(built["length_m"].sum()) / 1000.0, 4),
            "walls": len(built),
        }

    def share(self, budget: Budget) -> float:
        """Share of the area of the fuel that the walls take which a budget pays."""
        return float(self.built(budget)["area_ha"].sum()) / max(self.fuel_ha, 1e-300)

    @property
    def priority(self) -> xr.DataArray:
        """`priority` (y, x): cells that the first wall passes highest; -inf where none does."""
        prints = footprints(self.walls, self.grid)
        plane = np.full(self.grid.shape, -np.inf)
        np.maximum.at(plane.ravel(), prints.cell, len(self.walls) - prints.feature.astype(np.float64))
        return annotate(self.grid.dataarray(plane, "priority")).assign_attrs(design=self.told)

    def passed(self, budget: Budget) -> xr.DataArray:
        """`breaks` (y, x) uint8: 1 in cells that a line passes which the budget pays."""
        prints = footprints(self.built(budget), self.grid)
        plane = np.zeros(self.grid.shape, np.uint8)
        plane.ravel()[prints.cell] = 1
        told = {"budget": float(budget.amount), "unit": budget.unit, "cells_cut": int(plane.sum())}
        return annotate(self.grid.dataarray(plane, "breaks")).assign_attrs(told)


class Walls:
    """The walls of a landscape, which are the same for every budget, sought once for each size of compartments.

    Parameters
    ----------
    network, stakes, threads
        As in `design_lines`.
    """

    def __init__(self, network: SpreadNetwork, stakes: Stakes, threads: int | None = None) -> None:
        self._network, self._stakes, self._threads = network, stakes, threads
        self._found: dict[tuple[int, int], list[LineCut]] = {}

    def __call__(self, directions: int, smallest: int, progress: Progress) -> list[LineCut]:
        """As `placement.lines.dissect_by_lines` returns them."""
        from firebreak_gis.placement.lines import dissect_by_lines

        key = directions, smallest
        if key not in self._found:
            self._found[key] = dissect_by_lines(
                self._network,
                self._stakes,
                directions=directions,
                smallest=smallest,
                threads=self._threads,
                progress=progress,
            )
        return self._found[key]


def design_lines(
    network: SpreadNetwork,
    *,
    stakes: Stakes,
    budget: Budget,
    width: float | None,
    params: Mapping[str, Any] | None = None,
    trial: Trial | None = None,
    refine: bool = False,
    walls: Walls | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> LineDesign:
    """Find walls that are lines of one width, see `placement.lines`.

    Where breaks fail, walls of many stretches hold seldom. So they are tried out on fires in two orders of building:
    by what a wall saves, and by that times how often it holds. Then those that save least by themselves make way for
    others that would save more, see `placement.exchanging`; `saved` is what the fires of that search tell. All this is
    weighed against cost times difficulty of the ground; what is paid is the cost alone.

    Parameters
    ----------
    network, stakes
        What is planned for, on square cells in metres.
    budget
        For what it is: walls are kept up to twice as much.
    width
        Of the lines [m]; None: that of `WIDTHS` with which the fires of the trial take least.
    params
        `directions` and `smallest` of the ranking `dissection`.
    trial
        Fires with a clock of the kind that will judge the plan; None: walls are built in the order of what they save.
    refine
        Whether that search takes more fires, and is made where breaks never fail too.
    walls
        Of this network and these stakes, where other budgets have been or will be asked as well.
    threads, progress
        As in `plan`.

    Raises
    ------
    ParameterError
        If the width is not above 0, or there are no fires to choose it by, or another parameter is given.
    """
    from firebreak_gis.placement.choosing import Choice
    from firebreak_gis.progress import part

    directions, smallest = line_params(params or {})
    sizes = (smallest,) if "smallest" in (params or {}) else _SMALLEST
    if width is not None and not (np.isfinite(width) and width > 0):
        raise ParameterError(f"the width of lines is {width} m, expected a number above 0")
    if width is None and trial is None:
        raise ParameterError(
            "the width of lines is chosen by fires with a clock; give one in metres where there is none"
        )
    network.grid.require_metres("lines with a width")
    first = part(progress, 0.0, 0.6 if trial else 1.0)
    grid = network.grid
    money = _money(budget, network.n_burnable * grid.cell_area_ha)
    seek = walls or Walls(network, stakes, threads)
    for each in sizes:
        cuts = seek(directions, each, first)
        if _each(cuts, budget, width or WIDTHS[-1], grid).sum() >= money:
            break
    drawing = partial(_drawn, cuts, network, stakes, budget, hold=Hold() if trial is None else trial.fires.holding)
    if trial is None or (width is not None and trial.fires.holding.perfect and not refine):
        return drawing(WIDTHS[0] if width is None else width, fails=False)
    step = part(progress, 0.6, 0.8)
    choice: Choice[LineDesign] = Choice(trial, network.n_burnable, lambda design: design.breaks(budget))

    def told(each: float) -> LineDesign:
        step(0.0, f"trying lines {each:g} m wide")
        return drawing(each, fails=False)

    best = choice.rising(told(each) for each in (WIDTHS if width is None else (width,)))
    if not trial.fires.holding.perfect:
        choice.attempt(drawing(best.width, fails=True))
    found = choice.chosen()
    if trial.fires.holding.perfect and not refine:
        return found
    return _exchanged(found, trial, budget, refine, part(progress, 0.8, 1.0, "exchanging lines: "))


def _exchanged(design: LineDesign, trial: Trial, budget: Budget, refine: bool, progress: Progress) -> LineDesign:
    """The design with the walls first that `placement.exchanging` builds of those that are drawn."""
    from firebreak_gis.placement.exchanging import exchange_lines

    walls = design.walls
    built = np.arange(len(walls)) < design.bought(budget)
    if not built.any():
        return design
    laid = laid_on(walls[["width_m", "geometry"]], design.grid)
    costs = walls["cost" if budget.unit == "cost" else "area_ha"].to_numpy()
    money = _money(budget, design.fuel_ha)
    rests = resting(walls.geometry.array, design.grid.cell_size)
    plane = trial.stakes.difficulty  # 0 where there is no fuel
    hard, fuel = _along(walls, design.grid, plane, plane > 0)
    hard = np.divide(hard, fuel, out=np.ones(len(walls)), where=fuel > 0)
    found = exchange_lines(
        laid, trial, costs, built, money=money, rests=rests, hard=hard, short=not refine, progress=progress
    )
    if found is None:
        return design
    after, worth = found
    order = np.concatenate([np.flatnonzero(after), np.flatnonzero(~after)])
    share = worth / max(float(trial.stakes.value.sum()), 1e-300)
    told = f"{design.told}, and exchanged by what each saves in fires"
    return replace(design, walls=walls.assign(saved=share).iloc[order].reset_index(drop=True), told=told)


def _drawn(
    cuts: list[LineCut],
    network: SpreadNetwork,
    stakes: Stakes,
    budget: Budget,
    width: float,
    *,
    hold: Hold,
    fails: bool,
) -> LineDesign:
    """Lines of a width, in an order of building that knows that walls fail, or does not."""
    import geopandas as gpd

    from firebreak_gis.placement.choosing import all_hold
    from firebreak_gis.placement.dissection import sequence

    grid = network.grid
    often = [all_hold(hold, round(cut.length * grid.cell_size / hold.length)) if fails else 1.0 for cut in cuts]
    order = sequence(
        [cut.saved * share for cut, share in zip(cuts, often, strict=True)],
        [cut.price for cut in cuts],
        [cut.parent for cut in cuts],
    )
    fuel_ha = network.n_burnable * grid.cell_area_ha
    money = _money(budget, fuel_ha)
    each = _each(cuts, budget, width, grid)
    order = paid_first(order, each, [cut.parent for cut in cuts], money)
    # Beyond the budget for the curve about it.
    order = order[: int(np.searchsorted(np.cumsum(each[order]), _BEYOND * money, side="right")) + 1]
    kept = [cuts[i] for i in order]
    geometry = joined([on_map(cut, grid) for cut in kept], grid.cell_size)
    length = np.array([shape.length for shape in geometry])
    frame = gpd.GeoDataFrame(geometry=geometry, crs=grid.crs)
    (cost,) = _along(frame, grid, stakes.cost)
    price = width / grid.cell_size
    table = {
        "length_m": length,
        "width_m": np.full(len(kept), float(width)),
        "area_ha": length * width / 10_000.0,
        "cost": cost * price,
        "saved": np.array([cut.saved for cut in kept]),
    }
    place = {i: k for k, i in enumerate(order)}
    drawn = table["cost" if budget.unit == "cost" else "area_ha"]
    final = paid_first(list(range(len(kept))), drawn, [place.get(cut.parent, -1) for cut in kept], money)
    told = f"lines {width:g} m wide, those first that save most" + (" and hold most often" if fails else "")
    walls = frame.assign(**table).iloc[final].reset_index(drop=True)
    return LineDesign(walls, grid, fuel_ha, float(width), told)


def _along(walls: gpd.GeoDataFrame, grid: Grid, *planes: np.ndarray) -> list[np.ndarray]:
    """Sums of planes along every wall, by lengths in cells, (n,) each."""
    prints = footprints(walls, grid)
    return [
        np.bincount(prints.feature, prints.part * plane.ravel()[prints.cell], minlength=len(walls)) for plane in planes
    ]


def _money(budget: Budget, fuel_ha: float) -> float:
    """What there is, in hectares or money."""
    return budget.amount * (fuel_ha if budget.unit == "share" else 1.0)


def _each(cuts: list[LineCut], budget: Budget, width: float, grid: Grid) -> np.ndarray:
    """What each wall takes of the budget, before it is drawn, (n,) hectares or money."""
    if budget.unit == "cost":
        return np.array([cut.cost * width / grid.cell_size for cut in cuts])
    return np.array([cut.length * width * grid.cell_size / 10_000.0 for cut in cuts])


def line_params(params: Mapping[str, Any]) -> tuple[int, int]:
    """Directions and smallest compartment for walls of lines; anything else is refused."""
    other = sorted(set(params) - PARAMS)
    if other:
        raise ParameterError(f"lines take the parameters directions and smallest of dissection, not {', '.join(other)}")
    module = plugins.load("ranking", "dissection")
    built = plugins.build_params(module, {"smallest": _SMALLEST[0], **params})
    return int(built.directions), int(built.smallest)


def paid_first(order: Sequence[int], cost: np.ndarray, parent: Sequence[int], money: float) -> list[int]:
    """Move walls behind all others that the money does not pay at their turn, or whose parent it does not.

    Parameters
    ----------
    order
        Positions of walls, parents first.
    cost, parent
        Of every wall; a parent is its position, -1 for none.
    money
        What there is, in the unit of the costs.

    Returns
    -------
    list of int
        The same positions: those that are paid in their order, then the others in theirs.

    Examples
    --------
    >>> paid_first([0, 1, 2, 3], np.array([2.0, 9.0, 1.0, 3.0]), [-1, 0, 1, 0], 6.0)
    [0, 3, 1, 2]
    """
    paid, waiting, left = set(), [], Budget(money, "cost")
    out: list[int] = []
    spent = 0.0
    for wall in order:
        if (parent[wall] < 0 or parent[wall] in paid) and left.pays(spent + float(cost[wall])):
            paid.add(wall)
            out.append(wall)
            spent += float(cost[wall])
        else:
            waiting.append(wall)
    return out + waiting
