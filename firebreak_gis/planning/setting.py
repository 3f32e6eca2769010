"""What a plan is made in: scene, stakes, fires, and what can be reached, settled before the design."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.files.scratch import standing_folder
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.placement.trial import Trial
from firebreak_gis.planning.designs import lines
from firebreak_gis.planning.feasibility import feasibility, width_in_cells
from firebreak_gis.planning.judging import Judging, Scene, judging
from firebreak_gis.planning.treating import offers_of, priced
from firebreak_gis.simulation.fires import resolved
from firebreak_gis.simulation.ground_fires import stays_near
from firebreak_gis.simulation.ignitions import Ignitions

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.construction.treating import Offers
    from firebreak_gis.landscape.sited import Sited
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.feasibility import Feasibility
    from firebreak_gis.planning.request import PlanRequest
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.stakes import StakePlanes, Stakes


@dataclass(frozen=True, eq=False)
class Setting:
    """All that a design is told.

    Parameters
    ----------
    request
        What is asked.
    landscape
        `elevation`, `vegetation`, `density`, `burnable` (y, x).
    network
        What is designed on, barriers and existing breaks in it.
    planes, stakes
        What a planner adds, and what that comes to on this network.
    sited
        Lines of the ground that breaks can follow.
    offers
        What each treatment would leave and cost in each cell; None where all cells are treated alike.
    judged
        The fires that judge the plan, with where each starts.
    start
        Where they start as it was asked, of which other fires can be drawn.
    ground
        Where they burn.
    found
        What can be reached.
    standing
        (rows, cols) bool: cells of existing breaks, which fires meet before and after; None for none.
    threads
        Threads to use; None: all.
    lines_usual
        Whether nobody said what breaks are, so that cells may stand in for lines that the budget does not pay.
    """

    request: PlanRequest
    landscape: xr.Dataset
    network: SpreadNetwork
    planes: StakePlanes
    stakes: Stakes
    sited: Sited
    offers: Offers | None
    judged: Judging
    start: Any
    ground: Ground
    found: Feasibility
    standing: np.ndarray | None = None
    threads: int | None = None
    lines_usual: bool = False

    @property
    def leak(self) -> float:
        """Share of its spread probability that a treated cell keeps, as designs are told it."""
        return self.judged.fires.leak if self.offers is None else self.offers.residual

    @property
    def value(self) -> np.ndarray | None:
        """(rows, cols) lost where a cell burns; None where nothing is at stake but its area."""
        return None if self.planes.value is None else self.stakes.value

    def offering(self, offers: Offers) -> Setting:
        """The same with other treatments, by which the stakes are priced."""
        stakes = priced(self.planes, offers, self.request.design.amount).on(self.network)[1]
        return replace(self, offers=offers, stakes=stakes)

    @property
    def price(self) -> np.ndarray | None:
        """(rows, cols) cost of treating each cell, existing breaks too; None where it is not known."""
        if self.offers is not None:
            return np.where(self.offers.allowed, self.offers.usual[1], 0.0)
        return None if self.planes.cost is None else self.network.plane(self.planes.cost, "cost")

    @property
    def trial(self) -> Trial | None:
        """Fires to try designs on; None without a clock."""
        fires = self.judged.fires
        if not self.judged.clock:
            return None
        return Trial(self.ground, fires, self.stakes, fires.seed, self.threads, self.standing)

    @property
    def searches(self) -> bool:
        """Whether the design is improved by local search: where that is asked, and lines that may fail."""
        asked = self.request.design
        fails = self.judged.clock and not self.judged.fires.holding.perfect
        return asked.refine or (lines.asked(asked) and fails)

    @property
    def uncounted(self) -> str:
        """What takes its time beside the steps whose time is foreseen, in words."""
        method = plugins.load("ranking", self.request.design.method)
        tries = self.judged.clock and plugins.takes_trial(method)
        named = ["trying designs out"] * tries + ["local search"] * self.searches + ["writing"]
        return " and ".join(filter(None, [", ".join(named[:-1]), named[-1]]))

    @property
    def about(self) -> dict[str, Any]:
        """What `design.design` is told beside the network, the method and the stakes."""
        asked = self.request.design
        return {
            "budget": asked.amount,
            "residual": self.leak,
            "refine": asked.refine,
            "width": width_in_cells(asked.width, self.network.grid.cell_size),
            "params": asked.method_params,
            "elevation": self.landscape["elevation"].to_numpy(),
            "roads": self.planes.followed(self.network),
            "seed": self.judged.fires.seed,
        }


def away(request: PlanRequest) -> bool:
    """Whether a plan of a large map has its networks on the disk, and burns fires with a clock by windows."""
    one_wind = request.weather.read() is None and plugins.halo_of(request.spread.model) is not None
    return one_wind and stays_near(judging(request.fires, timed=True, timeless=request.timeless).fires)


def settle(landscape: xr.Dataset, request: PlanRequest, planes: StakePlanes, *, threads: int | None = None) -> Setting:
    """Settle what a plan is made in, and refuse what cannot be.

    Parameters
    ----------
    landscape, request, planes, threads
        As in `pipeline.make_plan`.

    Raises
    ------
    ParameterError, InputError
        Naming everything that stands in the way, before the ranking.
    """
    asked, fires = request.design, request.fires
    account = Account()
    scratch = "" if request.output is None else standing_folder(request.output.output)
    scene = Scene.of(landscape, request.spread, request.weather.read(), account, scratch=scratch)
    landscape = account.added_to(landscape)
    sited = request.siting.on(planes, scene.network, landscape["elevation"].to_numpy())
    planes = sited.planes
    offers = None if asked.treatments is None else offers_of(landscape, asked.treatments, scene.network)
    network, stakes = (planes if offers is None else priced(planes, offers, asked.amount)).on(scene.network)
    if planes.ignition is not None and fires.ignitions is None:
        fires = replace(fires, ignitions=stakes.ignition)
    judged = replace(scene.judging(fires, timeless=request.timeless), sited=sited.told)
    asked = replace(asked, line_width=lines.usual(request, judged, network))
    starts: list[Ignitions] = []

    def start() -> Ignitions:
        starts.append(resolved(network, fires))
        return starts[0]

    found = feasibility(
        network,
        stakes,
        budget=asked.amount,
        width=asked.width,
        residual=fires.leak if offers is None else offers.residual,
        refine=asked.refine,
        line_width=asked.line_width,
        ignitions=start,
    )
    found.require()
    found = replace(found, account=(*found.account, *sited.account), warnings=(*found.warnings, *judged.notes))
    judged = replace(judged, fires=replace(judged.fires, ignitions=starts[0]))
    ground = scene.ground(judged, planes.barred(scene.network), planes.barriers)
    standing = planes.standing(network)
    return Setting(
        replace(request, design=asked),
        landscape,
        network,
        planes,
        stakes,
        sited,
        offers,
        judged,
        fires.ignitions,
        ground,
        found,
        standing,
        threads,
        lines_usual=request.design.line_width is None,
    )
