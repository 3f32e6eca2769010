"""Designs tried out on fires with a clock, so that the one which loses least value is chosen."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np

from firebreak_gis.simulation.holding import FIELD

if TYPE_CHECKING:
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.simulation.holding import Hold

T = TypeVar("T")

#: Cells that the fires of one comparison burn, and how many there are for each cell of the map.
_WORK, _COVER = 2.0e6, 4.0


class Choice(Generic[T]):
    """Designs of the same money that were tried out.

    Parameters
    ----------
    trial
        The fires.
    n_cells
        Cells with fuel, which tell how many fires are needed.
    laid
        Breaks of a design: (rows, cols) bool, or lines; None for none.
    like
        Design that may not be the best, beside which the fires that are needed are as many as burn so much; None: as
        many as do where nothing is cut.

    Attributes
    ----------
    n_runs
        Fires that each design meets.
    """

    def __init__(
        self, trial: Trial, n_cells: int, laid: Callable[[T], np.ndarray | LineBreaks | None], like: T | None = None
    ) -> None:
        self._trial, self._laid = trial, laid
        self._tried: list[tuple[float, T]] = []
        cut = None if like is None else laid(like)
        self.n_runs = trial.runs(max(_WORK, _COVER * n_cells), cut=cut)

    def attempt(self, design: T) -> float:
        """Value that the fires take where the design is built."""
        lost = self._loss(design)
        # More than the best two are not looked at again.
        self._tried = sorted([*self._tried, (lost, design)], key=lambda each: each[0])[:2]
        return lost

    def rising(self, designs: Iterable[T]) -> T:
        """Try designs in turn until two in a row are worse than the best, which is returned."""
        lowest, worse = np.inf, 0
        for design in designs:
            lost = self.attempt(design)
            worse = 0 if lost < lowest else worse + 1
            if lost < lowest:
                lowest, best = lost, design
            if worse == 2:
                break
        return best

    def chosen(self) -> T:
        """The design that loses least; the best two meet other fires as well, since of many the first looks better."""
        if len(self._tried) == 1:
            return self._tried[0][1]
        whole = [lost + self._loss(design, self.n_runs) for lost, design in self._tried]
        return self._tried[int(np.argmin(whole))][1]

    def _loss(self, design: T, first: int = 0) -> float:
        return float(self._trial.losses(self._laid(design), n_runs=self.n_runs, first_run=first).sum())


def all_hold(hold: Hold, stretches: float) -> float:
    """How often all stretches of a wall hold, as a share of what one does.

    Examples
    --------
    >>> from firebreak_gis.simulation.holding import Hold
    >>> all_hold(Hold(0.5), 3), all_hold(Hold(0.5), 0)
    (0.25, 1.0)
    """
    each = FIELD if hold.share is None else hold.share
    return float(each ** max(stretches - 1, 0))
