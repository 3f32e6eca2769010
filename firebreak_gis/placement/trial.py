"""Fires on which a design is tried out: of the kind that judges the plan, but never those that judge it.

Clock, weather, embers and the way that breaks fail are those of the plan; the draws are other ones. Fires start by the
ignition weights of the stakes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.landscape.lines import beside
from firebreak_gis.progress import part, silent
from firebreak_gis.simulation.ground_fires import MapInMemory, burn_on, by_windows
from firebreak_gis.simulation.holding import build_walls
from firebreak_gis.simulation.ignitions import Ignitions
from firebreak_gis.simulation.timed import Spaces, containment, made_ready
from firebreak_gis.simulation.windows import passing_windows
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    import xarray as xr

    from firebreak_gis.kernels.arrival import Workspace
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.timed import Ready
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

    def runs(self, work: float, *, cut: Breaks = None, least: int = 40, most: int = 2000) -> int:
        """How many fires burn about `work` cells in all beside breaks, or where nothing is cut."""
        sizes = self._burnt(cut, _PILOT, 0, silent)["fire_size"]
        return int(np.clip(work / max(float(sizes.mean()), 1.0), least, most))

    def losses(self, cut: Breaks, *, n_runs: int, first_run: int = 0, progress: Progress = silent) -> np.ndarray:
        """Value that each fire takes, (n_runs,) float64; `cut` is (rows, cols) bool, or lines."""
        return np.asarray(self._burnt(cut, n_runs, first_run, progress, value=self.stakes.value)["value_lost"])

    def passing(self, cut: Breaks, *, n_runs: int, first_run: int = 0, progress: Progress = silent) -> np.ndarray:
        """Value that each cell lets through, its own and that of all that was lit by way of it, in the mean.

        Returns
        -------
        numpy.ndarray
            (rows, cols) float64, a fire.
        """
        from firebreak_gis.kernels.passing import let_through

        if by_windows(self.ground, self.fires):
            source = MapInMemory(self.ground.network, beside(cut, self.standing), self.ground.barriers)
            about: dict[str, Any] = {"first_run": first_run, "threads": self.threads, "progress": progress}
            return passing_windows(source, self._request(n_runs, first_run), value=self.stakes.value, **about)
        value = self.stakes.value.ravel()
        nowhere, none = np.zeros(0, bool), np.zeros(n_runs, bool)

        def passed(ready: Ready, space: Workspace, runs: np.ndarray, sums: np.ndarray) -> None:
            let_through(*ready.given, space, runs, value, np.zeros(value.size), sums, nowhere, none)

        groups = made_ready(**self._given(cut, n_runs, first_run))
        return self._summed(groups, n_runs, value.size, passed, progress).reshape(self.stakes.value.shape)

    def worth(
        self,
        parts: Sequence[np.ndarray],
        built: np.ndarray,
        *,
        n_runs: int,
        first_run: int = 0,
        progress: Progress = silent,
    ) -> tuple[np.ndarray, float]:
        """What each part of breaks saves by itself beside those that are built, and the value that fires take.

        Parameters
        ----------
        parts
            Row-major cells of each part; no cell is in two.
        built
            (n_parts,) bool. A built part is worth what more burns without it, another what less burns with it.
        n_runs, first_run, progress
            As in `losses`.

        Returns
        -------
        worth : numpy.ndarray
            (n_parts,) float64, mean over the fires. Embers that a change of far cells lets land are left out, and
            breaks that hold by their width are as wide as if all parts were built.
        lost : float
            Mean over the fires.
        """
        from firebreak_gis.kernels import worth as kernels

        value = self.stakes.value.ravel()
        cells = np.concatenate([*parts, np.zeros(0, np.int64)]).astype(np.int64)
        first = np.cumsum([0, *(each.size for each in parts)])
        of = np.full(value.size, -1, np.int32)
        of[cells] = np.repeat(np.arange(len(parts), dtype=np.int32), np.diff(first))
        up = cells[np.repeat(built, np.diff(first))]

        def readied() -> Iterator[Ready]:
            """With walls of all parts, which are then taken down but for those that are built."""
            everywhere = (of >= 0).reshape(self.stakes.value.shape)
            for ready in made_ready(**self._given(everywhere, n_runs, first_run)):
                walls = ready.given[5]
                uncut = build_walls(
                    ready.group.network,
                    walls.keys,
                    breaks=beside(None, self.standing),
                    residual=self.fires.residual,
                    hold=self.fires.holding,
                    barriers=self.ground.barriers,
                    barriers_hold=self.fires.barriers_hold,
                    intensity=ready.intensity,
                ).holds
                uncut = uncut if uncut.size else np.zeros_like(walls.holds)
                holds = uncut.copy()
                holds[up] = walls.holds[up]
                none = np.zeros(0, np.uint8)
                laid = kernels.Parts(first, cells, none, of, built, walls.holds, uncut)
                yield ready._replace(given=(*ready.given[:5], walls._replace(holds=holds), *ready.given[6:], laid))

        return self._worth(readied(), n_runs, len(parts), progress)

    def worth_of_lines(
        self, laid: LineBreaks, built: np.ndarray, *, n_runs: int, first_run: int = 0, progress: Progress = silent
    ) -> tuple[np.ndarray, float]:
        """The same of lines, whose ground is left out: fires start and burn on it.

        Parameters
        ----------
        laid
            All lines, the built ones and others. A link that several cross belongs to the first of them.
        built
            (n_lines,) bool.
        n_runs, first_run, progress
            As in `losses`.

        Returns
        -------
        worth, lost
            As `worth` returns them; embers that fly over a line to what it would save are left out.
        """
        from firebreak_gis.kernels import worth as kernels

        of = laid.owners.reshape(-1, 8)
        cells, towards = np.nonzero(of >= 0)
        order = np.argsort(of[cells, towards], kind="stable")
        cells, towards = cells[order], towards[order]
        first = np.searchsorted(of[cells, towards], np.arange(built.size + 1))
        stands = (of >= 0) & np.append(built, False)[of]
        crossed = (stands << np.arange(8)).sum(axis=1).astype(np.uint8)
        none = np.zeros(0, np.uint32)
        parts = kernels.Parts(first, cells, towards.astype(np.uint8), of.ravel(), built, none, none)

        def readied() -> Iterator[Ready]:
            for ready in made_ready(**self._given(laid.groundless, n_runs, first_run)):
                walls = ready.given[5]._replace(crossed=crossed)
                yield ready._replace(given=(*ready.given[:5], walls, *ready.given[6:], parts))

        return self._worth(readied(), n_runs, built.size, progress)

    def _worth(
        self, groups: Iterable[Ready], n_runs: int, n_parts: int, progress: Progress
    ) -> tuple[np.ndarray, float]:
        """See `worth`, of groups of runs with their parts."""
        from firebreak_gis.kernels import worth as kernels

        value = self.stakes.value.ravel()

        def added(ready: Ready, space: Workspace, runs: np.ndarray, sums: np.ndarray) -> None:
            *before, walls, cleared, embers, laid = ready.given
            walls = walls._replace(holds=walls.holds.copy(), crossed=walls.crossed.copy())
            memory = kernels.kept(value.size, n_runs, n_parts)
            sums[-1] += kernels.worth(*before, walls, cleared, embers, space, runs, value, laid, memory, sums[:-1])

        total = self._summed(groups, n_runs, n_parts + 1, added, progress)
        return total[:-1], float(total[-1])

    def _summed(
        self,
        groups: Iterable[Ready],
        n_runs: int,
        size: int,
        kernel: Callable[[Ready, Workspace, np.ndarray, np.ndarray], None],
        progress: Progress,
    ) -> np.ndarray:
        """Mean over the fires of what a kernel adds up; runs are pieced alike for any number of threads."""
        spaces, n_cells = Spaces(), self.stakes.value.size
        total = np.zeros(size)
        done = 0
        for ready in groups:
            runs = ready.group.runs
            pieces = np.array_split(runs, min(_PIECES, runs.size))
            sums = np.zeros((len(pieces), size))

            def work(k: int, ready: Ready = ready, pieces: Any = pieces, sums: Any = sums) -> None:
                kernel(ready, spaces.mine(n_cells, ready.span), pieces[k], sums[k])

            report = part(progress, done / n_runs, (done + runs.size) / n_runs)
            run_pieces(work, range(len(pieces)), threads=self.threads, progress=report, message="burning")
            total += sums.sum(axis=0)
            done += runs.size
        return np.asarray(total / n_runs)

    def _burnt(self, cut: Breaks, n_runs: int, first_run: int, progress: Progress, **more: Any) -> xr.Dataset:
        about: dict[str, Any] = {"first_run": first_run, "threads": self.threads, "progress": progress}
        fires = self._request(n_runs, first_run)
        return burn_on(self.ground, fires, breaks=beside(cut, self.standing), **about, **more)

    def _given(self, cut: Breaks, n_runs: int, first_run: int) -> dict[str, Any]:
        """Arguments of `burn_timed` and `made_ready` that say what burns."""
        from firebreak_gis.simulation.fires import limits_of

        ground = self.ground
        start = self._start(n_runs, first_run)
        request = replace(self._request(n_runs, first_run), ignitions=None)
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

    def _request(self, n_runs: int, first_run: int) -> FireRequest:
        """The fires, with where they start."""
        from firebreak_gis.kernels.draws import seed_for

        start = self._start(n_runs, first_run)
        return replace(self.fires, n_runs=n_runs, seed=seed_for(self.seed, "design"), ignitions=start)

    def _start(self, n_runs: int, first_run: int) -> Ignitions:
        """One cell a run: the n-th fire starts in the n-th of equal shares of the weights (systematic sampling)."""
        from firebreak_gis.kernels.draws import seed_for, stream_key, uniforms

        weights = self.stakes.ignition.ravel()
        cumulative = np.cumsum(weights)
        shift = uniforms(stream_key(seed_for(self.seed, "design"), "ignitions"), 1, first_run)
        cells = np.searchsorted(cumulative, (np.arange(n_runs) + shift) / n_runs * cumulative[-1], side="right")
        last = weights.size - 1 - int(np.argmax(weights[::-1] > 0.0))
        return Ignitions(np.arange(n_runs + 1), np.minimum(cells, last), first_run)
