"""Fires on which a design is tried out: of the kind that judges the plan, but never those that judge it.

Clock, weather, embers and the way that breaks fail are those of the plan; the draws are other ones. Fires start by the
ignition weights of the stakes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.progress import part, silent
from firebreak_gis.simulation.ignitions import Ignitions
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.timed import Spaces, burn_timed, containment, made_ready
from firebreak_gis.stakes import beside
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.stakes import Stakes

    Breaks = np.ndarray | LineBreaks | None

#: Pieces into which the runs of one weather are split, the same for any number of threads, so that sums have one order.
_PIECES = 4
#: Fires that tell how large fires are.
_PILOT = 32


@dataclass(frozen=True, eq=False)
class Trial:
    """Fires to try designs on.

    Parameters
    ----------
    ground
        Where they burn.
    fires
        What they are, with the leak of the breaks; number and ignitions are set here.
    stakes
        Values that they take, and where they start.
    seed
        Of the design.
    threads
        Threads to use; changes the speed only.
    standing
        (rows, cols) bool: cells of breaks that stand already; None for none.
    """

    ground: Ground
    fires: FireRequest
    stakes: Stakes
    seed: int
    threads: int | None = None
    standing: np.ndarray | None = None

    def under(self, residual: float) -> Trial:
        """The same fires against breaks of another leak."""
        return replace(self, fires=replace(self.fires, residual=residual))

    def runs(self, work: float, *, least: int = 40, most: int = 2000) -> int:
        """How many fires burn about `work` cells in all where nothing is cut."""
        tally = burn_timed(**self._given(None, _PILOT, 0), value=None, products=Products(), **self._ways(silent))
        return int(np.clip(work / max(float(tally.sizes.mean()), 1.0), least, most))

    def losses(self, cut: Breaks, *, n_runs: int, first_run: int = 0, progress: Progress = silent) -> np.ndarray:
        """Value that each fire takes, (n_runs,) float64; `cut` is (rows, cols) bool, or lines."""
        given = self._given(cut, n_runs, first_run)
        tally = burn_timed(**given, value=self.stakes.value.ravel(), products=Products(), **self._ways(progress))
        return np.asarray(tally.lost)

    def passing(self, cut: Breaks, *, n_runs: int, first_run: int = 0, progress: Progress = silent) -> np.ndarray:
        """Value that each cell lets through, its own and that of all that was lit by way of it, in the mean.

        Returns
        -------
        numpy.ndarray
            (rows, cols) float64, a fire.
        """
        from firebreak_gis.kernels.passing import let_through

        value = self.stakes.value.ravel()
        given = self._given(cut, n_runs, first_run)
        total = self._summed(
            given, value.size, lambda *ready, sums: let_through(*ready, value, np.zeros(value.size), sums), progress
        )
        return np.asarray(total.reshape(self.stakes.value.shape))

    def _summed(
        self, given: dict[str, Any], size: int, kernel: Callable[..., object], progress: Progress
    ) -> np.ndarray:
        """Mean over the fires of what a kernel adds up; runs are pieced alike for any number of threads."""
        spaces, n_cells = Spaces(), self.stakes.value.size
        n_runs = given["request"].n_runs
        total = np.zeros(size)
        done = 0
        for ready in made_ready(**given):
            runs = ready.group.runs
            pieces = np.array_split(runs, min(_PIECES, runs.size))
            sums = np.zeros((len(pieces), size))

            def work(k: int, ready: Any = ready, pieces: Any = pieces, sums: Any = sums) -> None:
                kernel(*ready.given, spaces.mine(n_cells, ready.span), pieces[k], sums=sums[k])

            report = part(progress, done / n_runs, (done + runs.size) / n_runs)
            run_pieces(work, range(len(pieces)), threads=self.threads, progress=report, message="burning")
            total += sums.sum(axis=0)
            done += runs.size
        return np.asarray(total / n_runs)

    def _ways(self, progress: Progress) -> dict[str, Any]:
        return {"threads": self.threads, "progress": progress}

    def _given(self, cut: Breaks, n_runs: int, first_run: int) -> dict[str, Any]:
        """Arguments of `burn_timed` and `made_ready` that say what burns."""
        from firebreak_gis.kernels.draws import seed_for
        from firebreak_gis.simulation.fires import limits_of

        ground = self.ground
        request = replace(self.fires, n_runs=n_runs, seed=seed_for(self.seed, "design"), ignitions=None)
        start = self._start(n_runs, first_run)
        limits, _ = limits_of(request, None if ground.weather is None else ground.weather.weather, first_run)
        burnt: dict[str, Any] = {
            "breaks": beside(cut, self.standing),
            "barriers": ground.barriers,
            "weather": ground.weather,
        }
        if request.crews is not None:
            contained, _ = containment(ground.network, request, start, limits, threads=self.threads, **burnt)
            limits = np.minimum(limits, contained)
        return {"network": ground.network, "request": request, "start": start, "limits": limits, **burnt}

    def _start(self, n_runs: int, first_run: int) -> Ignitions:
        """One cell a run: the n-th fire starts in the n-th of equal shares of the weights (systematic sampling)."""
        from firebreak_gis.kernels.draws import seed_for, stream_key, uniforms

        weights = self.stakes.ignition.ravel()
        cumulative = np.cumsum(weights)
        shift = uniforms(stream_key(seed_for(self.seed, "design"), "ignitions"), 1, first_run)
        cells = np.searchsorted(cumulative, (np.arange(n_runs) + shift) / n_runs * cumulative[-1], side="right")
        last = int(np.flatnonzero(weights)[-1])
        return Ignitions(np.arange(n_runs + 1), np.minimum(cells, last), first_run)
