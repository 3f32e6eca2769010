"""Breaks whose segments each get a treatment from a table, see `treating`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from firebreak_gis.construction.treating import Treated
from firebreak_gis.construction.treatments import totals
from firebreak_gis.errors import ParameterError
from firebreak_gis.planning.designs import Rest
from firebreak_gis.planning.designs.cells import Cells
from firebreak_gis.planning.treating import treat

if TYPE_CHECKING:
    from firebreak_gis.construction.segments import Segments
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.planning.request import DesignRequest, PlanRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

ORDER = 10


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


def make(setting: Setting, rest: Rest, progress: Progress) -> TreatedCells:
    """Give each segment of a design its treatment."""
    found = rest(setting, progress)
    assert setting.offers is not None
    amount = setting.request.design.amount
    treated = treat(setting.offers, setting.network, setting.stakes, found.breaks, found.priority, amount)
    return TreatedCells(setting, found.priority, found.breaks, treated)


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
