"""Designs for the worst tenth of the fires: that one of several which loses least in them, see `goals`."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from firebreak_gis.planning.designs import Design, Rest
from firebreak_gis.planning.goals import N_DESIGNS, for_worst_tenth

if TYPE_CHECKING:
    from firebreak_gis.planning.request import DesignRequest
    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

ORDER = 20


def asked(request: DesignRequest) -> bool:
    """Whether that is the goal."""
    return request.goal == "worst-tenth"


def rankings(_: DesignRequest) -> int:
    """Several designs, of which the best is taken."""
    return N_DESIGNS


def make(setting: Setting, rest: Rest, progress: Progress) -> Design:
    """Design for several ignitions, and take the best."""

    def design(placed: Stakes, step: Progress) -> Design:
        return rest(replace(setting, stakes=placed), step)

    best = for_worst_tenth(
        setting.network,
        setting.stakes,
        design,
        replace(setting.judged.fires, ignitions=setting.start, residual=setting.leak),
        setting.ground,
        value=setting.value,
        standing=setting.standing,
        threads=setting.threads,
        progress=progress,
    )
    return replace(best, setting=replace(setting, found=best.setting.found))
