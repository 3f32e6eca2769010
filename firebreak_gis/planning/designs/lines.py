"""Breaks that are lines of one width, narrower than a cell too, see `line_design`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from firebreak_gis.breaks import Budget
from firebreak_gis.construction.lines import line_polygons, line_segments
from firebreak_gis.construction.segments import Segments
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.curves import ByBudget
from firebreak_gis.landscape.lines import LineBreaks, laid_on
from firebreak_gis.planning.designs import Design, Rest
from firebreak_gis.planning.line_design import PARAMS, LineDesign, design_lines, line_params

if TYPE_CHECKING:
    import geopandas as gpd
    import numpy as np

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.planning.line_design import Widths
    from firebreak_gis.planning.request import DesignRequest, PlanRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

ORDER = 50


#: Width of lines where nobody says it [m], at most that of a cell: the narrowest of California's fuel breaks, 30 to
#: 90 m, of which the share that holds in the field is known (`simulation.holding.FIELD`).
USUAL = 30.0
#: Maps of more cells with fuel get cells: their walls are found some ten times as fast.
LARGEST = 300_000
#: What is told where cells take the place of lines.
NO_WALL = "the budget pays no wall of lines where cutting is allowed, so that whole cells are cut"


def asked(request: DesignRequest) -> bool:
    """Whether lines have a width."""
    return request.line_width not in (None, "cells")


def usual(request: PlanRequest, judged: Judging, network: SpreadNetwork) -> Widths:
    """The width that is asked for, or where none is, the usual one; "cells" where lines cannot be planned or judged.

    Fires without a clock are those of the paper, whose breaks are cells; where breaks leak, cells can be cut several
    wide.
    """
    design = request.design
    if design.line_width is not None:
        return design.line_width
    others = set(design.method_params) - PARAMS
    if others or _refused(design, request.timeless) or hindered(judged, network):
        return "cells"
    return width_of(network)


def hindered(judged: Judging, network: SpreadNetwork) -> str:
    """Why lines cannot be planned or judged where nobody asks for them, in words; empty where they can."""
    if not judged.clock:
        return "the fires have no clock"
    if judged.fires.leaks:
        return "treated cells keep some of their spread"
    if not network.grid.in_metres or network.boundary != "open":
        return "lines need an open map in metres"
    if network.n_burnable > LARGEST:
        return f"the map has more than {LARGEST:,} cells with fuel"
    return ""


def width_of(network: SpreadNetwork) -> float:
    """The usual width [m]."""
    return min(USUAL, network.grid.cell_size)


def require(request: PlanRequest) -> None:
    """Refuse what breaks that are lines cannot have.

    Raises
    ------
    ParameterError
        Naming all of it.
    """
    design = request.design
    refused = _refused(design, request.timeless)
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


def _refused(design: DesignRequest, timeless: bool) -> list[str]:
    """What is asked for that lines cannot have, as it is asked for."""
    refused = [f"--method {design.method}"] if design.method != "dissection" else []
    refused += ["--width"] if design.width is not None else []
    refused += ["--refine --timeless"] if design.refine and timeless else []
    refused += ["--treatments"] if design.treatments is not None else []
    return refused


def make(setting: Setting, rest: Rest, progress: Progress) -> Design:
    """Find the walls; cells where lines are only the usual, and the budget pays no wall."""
    request, width = setting.request.design, setting.request.design.line_width
    assert width is not None
    assert width != "cells"
    found = design_lines(
        setting.network,
        stakes=setting.stakes,
        budget=request.amount,
        width=None if width == "auto" else width,
        params=request.method_params,
        trial=setting.trial,
        refine=request.refine,
        threads=setting.threads,
        progress=progress,
    )
    if setting.lines_usual and not found.bought(request.amount):
        seen = setting.found
        return rest(replace(setting, found=replace(seen, warnings=(*seen.warnings, NO_WALL))), progress)
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
        return self.found.built(self._amount)

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
        """See `lines.line_segments`; without a `cost` where nobody gave prices."""
        made = line_segments(
            self.setting.network,
            self.walls,
            self.laid,
            elevation=self.setting.landscape["elevation"],
            value=self.setting.stakes.value,
            ignition=self.setting.stakes.ignition,
        )
        return made if self.priced else Segments(*(frame.drop(columns="cost") for frame in made))

    @property
    def polygons(self) -> gpd.GeoDataFrame:
        """The lines in their width, see `lines.line_polygons`."""
        return line_polygons(self.walls)

    @property
    def figures(self) -> dict[str, Any]:
        """See `LineDesign.figures`."""
        return self.found.figures(self._amount)

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
