"""Plans of lines for several budgets and leaks, each as `plan` makes it, for comparisons."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from firebreak_gis.breaks import Budget
from firebreak_gis.planning.designs.lines import width_of
from firebreak_gis.planning.line_design import LineDesign, Walls, design_lines

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.planning.line_design import LineWidth
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes


class LineDesigns:
    """The plans of lines for any budget and residual; the walls are sought once for all.

    Parameters
    ----------
    network, stakes, params, trial, threads
        As in `line_design.design_lines`.
    width
        Of the lines [m], or "auto". None: as `plan` makes lines where nobody asks for them, so that there are none
        where treated cells keep something of their spread, see `designs.lines.usual`.
    walls
        Of this network and these stakes, where lines of several widths are compared.
    """

    def __init__(
        self,
        network: SpreadNetwork,
        *,
        stakes: Stakes,
        width: LineWidth | None = None,
        params: Mapping[str, Any] | None = None,
        trial: Trial | None = None,
        walls: Walls | None = None,
        threads: int | None = None,
    ) -> None:
        self._network, self._trial, self._usual = network, trial, width is None
        self.width = width_of(network) if width is None else width
        self._about: dict[str, Any] = {
            "stakes": stakes,
            "width": None if self.width == "auto" else self.width,
            "params": params,
            "walls": walls or Walls(network, stakes, threads),
            "threads": threads,
        }
        self._made: dict[tuple[Budget, float], LineDesign] = {}

    def __call__(self, budget: float | Budget, residual: float, progress: Progress) -> LineDesign | None:
        """Return the plan; None where there is none, or its budget pays no wall, where `plan` cuts cells."""
        amount = Budget.of(budget)
        if self._usual and residual:
            return None
        key = amount, residual
        if key not in self._made:
            trial = None if self._trial is None else self._trial.under(residual)
            self._made[key] = design_lines(self._network, budget=amount, trial=trial, **self._about, progress=progress)
        return self._made[key] if self._made[key].bought(amount) else None

    def distinct(self, budgets: Iterable[float], residuals: Iterable[float] = (0.0,)) -> int:
        """How often walls are sought for these budgets and residuals: once, if there is any plan."""
        return int(any(True for _ in budgets) and any(not (self._usual and each) for each in residuals))

    @property
    def searches(self) -> bool:
        """Whether walls are exchanged by what each saves in fires, as where breaks may fail."""
        return self._trial is not None and not self._trial.fires.holding.perfect
