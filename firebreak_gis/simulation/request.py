"""What is asked of the simulated fires: one typed value, the same for every command that burns.

To add an option of the fires, such as how long they burn: add a field here, an option of that name to
`cli.options.fires`, and read it in `simulation.fires.burn` (and `budgets.burn_budgets`). The commands hand the whole
request on, so none of them needs to know.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.simulation.holding import Hold
from firebreak_gis.simulation.stations import Stations, Travel

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid
    from firebreak_gis.network import Residual
    from firebreak_gis.simulation.containment import Containment
    from firebreak_gis.simulation.durations import Duration
    from firebreak_gis.simulation.embers import Embers

#: `each`: each run starts at one of the given places. `all`: every run starts at all of them at once. `density`: they
#: are past fires, and runs start where such fires are dense.
IgnitionMode = Literal["each", "all", "density"]
#: What is done with places where no fire can start.
Outside = Literal["refuse", "drop"]


@dataclass(frozen=True)
class FireRequest:
    """Fires to simulate.

    Parameters
    ----------
    ignitions
        Where they start, see `ignitions.resolve_ignitions`; None is one random cell with fuel a run.
    ignition_mode
        What points and polygons mean: the runs take them in turn, every run starts at all of them, or they are fires of
        the past.
    n_runs
        Number of runs.
    seed
        Seed of all draws.
    residual
        Share of its spread probability that a treated cell keeps, one number or (rows, cols); 0 is a perfect break.
    duration
        How long fires burn; None: until they end by themselves.
    hold
        How often stretches of a break hold; None: always.
    barriers_hold
        How often stretches of a barrier hold, where barriers are given that may fail.
    embers
        Embers that fly ahead; None for none.
    ignitions_outside
        Whether points and polygons where no fire can start are refused or left out.
    ignition_times
        When each point or polygon is lit, see `ignitions.resolve_ignitions`.
    containment
        When crews contain fires; None: never.
    stations, roads, crew_travel
        Where crews set out, the roads that they take, and how, see `stations.Stations`: breaks hold only against fire
        that comes after them. Without stations, crews are everywhere.
    """

    ignitions: Any = None
    ignition_mode: IgnitionMode = "each"
    n_runs: int = 100
    seed: int = 0
    residual: Residual = 0.0
    duration: Duration | None = None
    hold: Hold | None = None
    barriers_hold: float = 1.0
    embers: Embers | None = None
    ignitions_outside: Outside = "refuse"
    ignition_times: Any = None
    containment: Containment | None = None
    stations: Any = None
    roads: Any = None
    crew_travel: Travel | None = None

    def __post_init__(self) -> None:
        if self.stations is None and self.crew_travel is not None:
            raise ParameterError("crew travel is for crews that come from stations; give --stations too")

    def require_stations(self) -> None:
        """Refuse roads that nothing drives on; plans also go by them, see `landscape.sited`.

        Raises
        ------
        ParameterError
            Saying what to give.
        """
        if self.stations is None and self.roads is not None:
            raise ParameterError("roads are for crews that come from stations; give --stations too")

    @property
    def timeless(self) -> bool:
        """Whether nothing is asked but fires that end by themselves and breaks that do not fail by stretches."""
        return self._endless and self.holding.perfect and self.embers is None and self.called is None

    @property
    def holding(self) -> Hold:
        """How breaks hold."""
        return Hold() if self.hold is None else self.hold

    @property
    def needs_times(self) -> bool:
        """Whether the network must tell how long fire takes."""
        return not self._endless or self.embers is not None or self.holding.share is None or self.called is not None

    @cached_property
    def called(self) -> Stations | None:
        """Crews whom breaks wait for; None if there is no need of them."""
        if self.stations is None:
            return None
        if isinstance(self.stations, Stations):
            return self.stations
        return Stations(self.stations, self.roads, self.crew_travel or Travel())

    def settled(self, grid: Grid) -> FireRequest:
        """The same fires once their starts are drawn, without the names of files: what a worker needs of them."""
        called = None if self.called is None else self.called.settled(grid, self.holding.length)
        residual = np.asarray(self.residual) if np.ndim(self.residual) else self.residual
        return replace(
            self, ignitions=None, ignition_times=None, stations=called, roads=None, crew_travel=None, residual=residual
        )

    @property
    def crews(self) -> Containment | None:
        """How fires are contained; None if none ever is."""
        return None if self.containment is None or self.containment.endless else self.containment

    @property
    def leak(self) -> float:
        """What treated cells keep in the mean, which designs are told."""
        return float(np.nanmean(self.residual))

    @property
    def leaks(self) -> bool:
        """Whether treated cells keep something of their spread probability."""
        return bool(np.any(self.residual))

    @property
    def _kept(self) -> str:
        least, most = float(np.nanmin(self.residual)), float(np.nanmax(self.residual))
        return f"{least:.3g}" if least == most else f"{least:.3g} to {most:.3g}, cell by cell,"

    @property
    def _endless(self) -> bool:
        """Whether all fires end by themselves."""
        return (self.duration is None or self.duration.endless) and self.crews is None

    @property
    def assumptions(self) -> list[str]:
        """What is assumed of the fires beside the spread model, in words, for accounts and pictures."""
        told = [f"fires burn {self.duration.told()}"] if self.duration else ["fires burn until they end by themselves"]
        told += [self.crews.told()] if self.crews else []
        told += self.failures
        told += [self.called.told()] if self.called else []
        return told + ([self.embers.told()] if self.embers else [])

    @property
    def failures(self) -> list[str]:
        """How breaks and barriers fail, in words; none where they never do."""
        told = [] if self.holding.perfect else [self.holding.told()]
        told += [f"barriers hold in {self.barriers_hold:.3g} of fires"] if self.barriers_hold < 1 else []
        which = "breaks" if self.holding.perfect else "breaks that hold"
        return told + ([f"{which} keep {self._kept} of the spread probability"] if self.leaks else [])

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of files that it refers to."""
        given = (self.ignitions, self.stations, self.roads)
        return tuple(os.fspath(each) for each in given if isinstance(each, (str, os.PathLike)))
