"""Kinds of design, one file each: what a plan is made of once its setting is known.

A module of this package has

* `ORDER`: its place in the chain, outermost first;
* `asked(request)`: whether a `DesignRequest` asks for it; without it, it always is;
* `make(setting, rest, progress)`: the `Design`; `rest(setting, progress)` makes that of the kinds further in, which it
  may call as often as it likes, in settings of its own (with other ignitions, say), or not at all;
* and, if it needs them, `require(request)`, which refuses what it cannot be asked for beside, and `rankings(request)`,
  how many rankings it takes in place of one.

So a kind may stand in the place of others (lines for cells), choose among several (the worst tenth), or add to one
(treatments). `planning.pipeline` knows none of them.
"""

from __future__ import annotations

import importlib
import math
import pkgutil
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from types import ModuleType

    import geopandas as gpd
    import numpy as np
    import xarray as xr

    from firebreak_gis.construction.segments import Segments
    from firebreak_gis.evaluation.curves import ByBudget
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.planning.request import DesignRequest, PlanRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

#: Makes the design of the kinds further in.
Rest = Callable[["Setting", "Progress"], "Design"]


@dataclass(frozen=True, eq=False)
class Design(ABC):
    """Breaks, as fires meet them, as they are built, and what they cost.

    Parameters
    ----------
    setting
        What they were designed in.
    priority, breaks
        (y, x): the ranking, and 1 where cut, or passed by a line.
    """

    #: Whether the breaks of each budget are burnt by themselves, since they do not follow from the priority.
    EACH_ANEW: ClassVar[bool] = False

    setting: Setting
    priority: xr.DataArray
    breaks: xr.DataArray

    @property
    @abstractmethod
    def laid(self) -> xr.DataArray | LineBreaks | None:
        """The breaks as fires meet them; None for none."""

    @property
    @abstractmethod
    def ranked(self) -> xr.DataArray | ByBudget:
        """What a curve over budgets cuts."""

    @property
    @abstractmethod
    def share(self) -> float:
        """The budget as a share of the fuel."""

    @property
    @abstractmethod
    def segments(self) -> Segments:
        """Middle lines and outlines of what is to be built, in order."""

    @property
    @abstractmethod
    def polygons(self) -> gpd.GeoDataFrame:
        """Pieces of the breaks."""

    @property
    @abstractmethod
    def figures(self) -> dict[str, Any]:
        """`cells_cut`, `ha_cut`, `cost`, and what else tells how much it is, as plain numbers."""

    @property
    @abstractmethod
    def told(self) -> str:
        """What is built, in words."""

    @abstractmethod
    def part(self, stands: np.ndarray) -> xr.DataArray | LineBreaks | np.ndarray | None:
        """Some of the segments, (n_segments,) bool, as fires meet them; None for none."""

    def budgets(self, usual: Callable[[float], np.ndarray]) -> np.ndarray:
        """Budgets of a curve, of those that are usual about one."""
        return usual(self.share)

    def under(self, judged: Judging) -> Judging:
        """What the plan is judged by, once it is known what treated cells keep."""
        return judged

    @property
    def priced(self) -> bool:
        """Whether it is known what cutting costs."""
        return self.setting.stakes.priced

    @property
    def walls(self) -> gpd.GeoDataFrame | None:
        """Lines that are built, one row a wall in order; None where breaks are cells."""
        return None

    @property
    def parameters(self) -> Mapping[str, Any]:
        """What else was asked, for an account of the plan."""
        return {}


def designed(setting: Setting, progress: Progress) -> Design:
    """Make the design that the request asks for."""
    return _made(asked_for(setting.request.design), setting, progress)


def _made(chain: Sequence[ModuleType], setting: Setting, progress: Progress) -> Design:
    made: Design = chain[0].make(setting, lambda inner, step: _made(chain[1:], inner, step), progress)
    return made


def rankings(request: DesignRequest) -> int:
    """How many rankings a design takes."""
    return math.prod(kind.rankings(request) for kind in asked_for(request) if hasattr(kind, "rankings"))


def require(request: PlanRequest) -> None:
    """Refuse what the kinds of design that are asked for cannot be asked beside.

    Raises
    ------
    ParameterError
        Naming all of it.
    """
    for kind in asked_for(request.design):
        if hasattr(kind, "require"):
            kind.require(request)


def asked_for(request: DesignRequest) -> list[ModuleType]:
    """The kinds that a request asks for, outermost first."""
    return [kind for kind in _kinds() if not hasattr(kind, "asked") or kind.asked(request)]


@cache
def _kinds() -> list[ModuleType]:
    modules = [importlib.import_module(f"{__name__}.{found.name}") for found in pkgutil.iter_modules(__path__)]
    return sorted(modules, key=lambda kind: int(kind.ORDER))
