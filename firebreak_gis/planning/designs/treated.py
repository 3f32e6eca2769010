"""Breaks whose segments each get a treatment from a table, see `treating`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.treating import Treated
from firebreak_gis.construction.treatments import totals
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.measures import worst_mean
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.planning.burning import fires_of
from firebreak_gis.planning.designs import Design, Rest
from firebreak_gis.planning.designs.cells import Cells
from firebreak_gis.planning.treating import treat
from firebreak_gis.progress import part, silent
from firebreak_gis.simulation.fires import resolved

if TYPE_CHECKING:
    from firebreak_gis.construction.segments import Segments
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.planning.request import DesignRequest, PlanRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

ORDER = 10
#: Fires on which treatments are tried out, at least.
_RUNS = 600


def asked(request: DesignRequest) -> bool:
    """Whether there is a table."""
    return request.treatments is not None


def require(request: PlanRequest) -> None:
    """Refuse a residual beside the table.

    Raises
    ------
    ParameterError
        If both are asked.
    """
    if request.fires.leaks:
        raise ParameterError("the table of treatments tells what treated cells keep; leave --residual out")


def rankings(request: DesignRequest) -> int:
    """For a budget in money each treatment has its own plan, which it pays in full."""
    assert request.treatments is not None
    return 1 + (_alternatives(request) if request.amount.unit == "cost" else 0)


def _alternatives(request: DesignRequest) -> int:
    names = () if request.treatments is None else request.treatments.names
    return len(names) if len(names) > 1 else 0


def make(setting: Setting, rest: Rest, progress: Progress) -> TreatedCells:
    """Give each segment of a design its treatment, unless one treatment alone loses less for the same money.

    The table chooses by a model of savings. What that choice and each single treatment lose is then found by fires of
    the kind that judges the plan, with other draws; of those that cost no more, that which loses least is taken.
    """
    request, offers = setting.request.design, setting.offers
    assert offers is not None
    money = request.amount.unit == "cost"
    count = _alternatives(request)
    steps = [part(progress, k / (1 + count), (k + 1) / (1 + count)) for k in range(1 + count)]
    table = _treated(setting, rest(setting, steps[0]))
    tried = [table]
    for name, step in zip(offers.treatments.names if count else (), steps[1:], strict=True):
        alone = setting.offering(offers.alone(name))
        if (alone.network.burnable & ~alone.stakes.protected).any():
            tried.append(_treated(alone, rest(alone, step) if money else table))
    return replace(_best(tried, setting), setting=setting) if count else table


def _treated(setting: Setting, found: Design) -> TreatedCells:
    assert setting.offers is not None
    amount = setting.request.design.amount
    treated = treat(setting.offers, setting.network, setting.stakes, found.breaks, found.priority, amount)
    return TreatedCells(setting, found.priority, found.breaks, treated)


def _best(tried: list[TreatedCells], setting: Setting) -> TreatedCells:
    """What loses least, the first of equals, of all that cost no more than the first."""
    costs = [each.figures["cost"] for each in tried]
    amount = setting.request.design.amount
    limit = (amount.amount if amount.unit == "cost" else costs[0]) * (1 + 1e-9)
    losses = [trial_loss(setting, each) if cost <= limit else np.inf for each, cost in zip(tried, costs, strict=True)]
    return tried[int(np.argmin(losses))]


def trial_loss(setting: Setting, design: Design) -> float:
    """What the mean fire, or that of the worst tenth if that is the goal, takes of the fires of the design."""
    fires = design.under(setting.judged).fires
    own = replace(fires, seed=seed_for(fires.seed, "design"), n_runs=max(_RUNS, fires.n_runs), ignitions=setting.start)
    own = replace(own, ignitions=resolved(setting.network, own))
    run = fires_of(setting, replace(setting.judged, fires=own))(design.laid, setting.value, silent)
    lost = run["fire_size" if setting.value is None else "value_lost"].to_numpy().astype(float)
    return float(worst_mean(lost) if setting.request.design.goal == "worst-tenth" else lost.mean())


@dataclass(frozen=True, eq=False)
class TreatedCells(Cells):
    """Cells that are cut, in segments with a treatment each.

    Parameters
    ----------
    treated
        Segments, and what each cell keeps.
    """

    treated: Treated

    @property
    def segments(self) -> Segments:
        """With their treatments."""
        return self.treated.segments

    @property
    def figures(self) -> dict[str, Any]:
        """The cost is that of the treatments."""
        return {**super().figures, "cost": float(self.segments.polygons["treatment_cost"].sum())}

    @property
    def priced(self) -> bool:
        """The table tells it."""
        return True

    def under(self, judged: Judging) -> Judging:
        """Fires burn with what the treatments leave."""
        hectares = {name: row["area_ha"] for name, row in totals(self.segments.polygons).items()}
        return replace(judged, fires=replace(judged.fires, residual=self.treated.residual), hectares=hectares)
