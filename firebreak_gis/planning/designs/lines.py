"""Breaks that are lines of one width, narrower than a cell too, see `line_design`."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Budget
from firebreak_gis.construction.lines import line_polygons, line_segments
from firebreak_gis.construction.segments import Segments
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.curves import ByBudget
from firebreak_gis.landscape.lines import LineBreaks, laid_on
from firebreak_gis.planning.designs import Design, Rest
from firebreak_gis.planning.line_design import LineDesign, design_lines, line_params

if TYPE_CHECKING:
    import geopandas as gpd

    from firebreak_gis.planning.request import DesignRequest, PlanRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

ORDER = 50


def asked(request: DesignRequest) -> bool:
    """Whether lines have a width."""
    return request.line_width is not None


def require(request: PlanRequest) -> None:
    """Refuse what breaks that are lines cannot have.

    Raises
    ------
    ParameterError
        Naming all of it.
    """
    design = request.design
    refused = [f"--method {design.method}"] if design.method != "dissection" else []
    refused += ["--width"] if design.width is not None else []
    refused += ["--refine"] if design.refine else []
    refused += ["--goal"] if design.goal != "mean" else []
    refused += ["--treatments"] if design.treatments is not None else []
    if refused:
        raise ParameterError(
            f"--line-width plans lines by dissection, which {', '.join(refused)} cannot change; leave "
            f"{'it' if len(refused) == 1 else 'them'} out, or the width of lines"
        )
    line_params(design.method_params)
    if design.line_width == "auto" and (request.timeless or request.fires.holding.share is not None):
        raise ParameterError(
            "--line-width auto is the width that suits the flames, by fires with a clock; give --hold flame, under "
            "which wider lines hold more often, or the width in metres"
        )


def make(setting: Setting, _: Rest, progress: Progress) -> Lines:
    """Find the walls."""
    request, width = setting.request.design, setting.request.design.line_width
    if setting.standing is not None:
        raise ParameterError("--existing stands beside breaks of whole cells; leave --existing or --line-width out")
    assert width is not None
    found = design_lines(
        setting.network,
        stakes=setting.stakes,
        budget=request.amount,
        width=None if width == "auto" else width,
        params=request.method_params,
        trial=setting.trial,
        threads=setting.threads,
        progress=progress,
    )
    return Lines(setting, found.priority, found.passed(request.amount), found)


@dataclass(frozen=True, eq=False)
class Lines(Design):
    """Walls that are lines; `breaks` are the cells that they pass.

    Parameters
    ----------
    found
        All walls, beyond the budget too.
    """

    EACH_ANEW = True

    found: LineDesign

    @cached_property
    def laid(self) -> LineBreaks | None:
        """The walls that the budget pays, on the grid."""
        return self.found.breaks(self._amount)

    @property
    def ranked(self) -> ByBudget:
        """The first walls that each budget pays."""
        return ByBudget(lambda budget: self.found.breaks(Budget(budget)))

    @property
    def share(self) -> float:
        """As asked, or what the walls are."""
        return self._amount.amount if self._amount.unit == "share" else self.found.share(self._amount)

    @property
    def walls(self) -> gpd.GeoDataFrame:
        """The walls that the budget pays, in order."""
        return self.found.walls.iloc[: self.found.bought(self._amount)]

    def part(self, stands: np.ndarray) -> LineBreaks | None:
        """The walls, of which the last may have some of its lines only."""
        import geopandas as gpd
        import shapely

        lines = self.segments.lines[stands]
        if not len(lines):
            return None
        parts = lines.groupby("stage")
        shapes = [shapely.MultiLineString(list(shapely.get_parts(each.array))) for _, each in parts.geometry]
        walls = gpd.GeoDataFrame({"width_m": parts["width_m"].first().to_numpy()}, geometry=shapes, crs=lines.crs)
        return laid_on(walls, self.setting.network.grid)

    @cached_property
    def segments(self) -> Segments:
        """See `lines.line_segments`."""
        return line_segments(
            self.setting.network,
            self.walls,
            self.laid,
            elevation=self.setting.landscape["elevation"],
            value=self.setting.stakes.value,
            ignition=self.setting.stakes.ignition,
        )

    @property
    def polygons(self) -> gpd.GeoDataFrame:
        """The lines in their width, see `lines.line_polygons`."""
        return line_polygons(self.walls)

    @property
    def figures(self) -> dict[str, Any]:
        """Length times width and what it costs, kilometres and walls, beside the cells that they pass."""
        walls = self.walls
        return {
            "cells_cut": int(np.count_nonzero(self.breaks.to_numpy() > 0)),
            "ha_cut": round(float(walls["area_ha"].sum()), 4),
            "cost": float(walls["cost"].sum()),
            "line_km": round(float(walls["length_m"].sum()) / 1000.0, 4),
            "walls": len(walls),
        }

    @property
    def told(self) -> str:
        """Kilometres, width, hectares and walls."""
        figures = self.figures
        return (
            f"{figures['line_km']:,.1f} km of lines {self.found.width:g} m wide "
            f"({figures['ha_cut']:,.1f} ha) in {figures['walls']} walls"
        )

    @property
    def parameters(self) -> dict[str, Any]:
        """The width."""
        return {"line_width": self.found.width}

    @property
    def _amount(self) -> Budget:
        return self.setting.request.design.amount
