"""When crews contain a fire: at a drawn time, or by an attack that fails where the fire is large or fierce.

A fire that is contained burns on no further: cells that it would reach later do not burn. Containment is off unless
asked for, and how soon it comes has no universal source: all times and limits here are parameters, and their defaults
are assumptions. That direct attack fails above 4,000 kW/m, flames of 3.5 m, is a rule of practice; Hirsch and Martell
1996, "A review of initial attack fire crew productivity and effectiveness", tell where such rules come from.

Where crews are and how they drive is not known here; that a break holds only if crews reach it in time is a matter of
`stations`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.simulation.durations import Duration, as_duration

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid

_FORMS = "a time (see --duration), or attack:TIME, perhaps with limits: attack:1h;size=4;intensity=4000;intense=1"


@dataclass(frozen=True)
class Containment:
    """When fires are contained.

    Parameters
    ----------
    time
        After the start of the run; drawn apart from the durations.
    attack
        Whether this is the time of a direct attack, which may fail, so that the fire burns on as if nobody had come.
    size
        The attack fails if the fire has burnt more than this by then [ha]; an assumption, 10 acres.
    intensity
        Fire-line intensity [kW/m] above which direct attack fails, see the text of the module.
    intense
        It fails if more than this has burnt above that intensity by then [ha]; an assumption. The intensity of a cell
        is that of the fastest fire that can leave it, in the mean over the steps of a weather that changes.

    Examples
    --------
    >>> as_containment("attack:1h;size=10").told()
    'direct attack after 1 h; fails beyond 10 ha, or 1 ha above 4000 kW/m (assumed)'
    """

    time: Duration = field(default_factory=lambda: Duration("fixed", (math.inf,)))
    attack: bool = False
    size: float = 4.0
    intensity: float = 4000.0
    intense: float = 1.0

    def __post_init__(self) -> None:
        if self.time.kind == "weather":
            raise ParameterError("containment is no matter of the weather; give a time or a distribution of times")
        for name in _LIMITS:
            value = getattr(self, name)
            if not value >= 0:
                raise ParameterError(f"{name} of the containment is {value:g}, expected a number of at least 0")

    @property
    def endless(self) -> bool:
        """Whether no fire is ever contained."""
        return self.time.endless

    def of_runs(self, *, seed: int, n_runs: int, first_run: int = 0) -> np.ndarray:
        """Return the seconds after which crews contain or attack the fire of each run, (n_runs,) int64."""
        return self.time.of_runs(seed=seed, n_runs=n_runs, first_run=first_run, purpose="containment")

    def succeeds(self, burnt: np.ndarray, intense: np.ndarray, grid: Grid) -> np.ndarray:
        """Whether the attack succeeds, (n_runs,) bool.

        Cutting more never makes one fail that succeeded, as neither number of cells grows by it.

        Parameters
        ----------
        burnt, intense
            (n_runs,) cells burnt by the time of the attack, and those of them above the intensity.
        grid
            Of the network.
        """
        area = grid.cell_area_ha
        return np.asarray((burnt * area <= self.size) & (intense * area <= self.intense))

    def told(self) -> str:
        """What is assumed, in words, for accounts and pictures."""
        if not self.attack:
            return f"fires are contained after {self.time.told()} (assumed)"
        return (
            f"direct attack after {self.time.told()}; fails beyond {self.size:g} ha, or {self.intense:g} ha above "
            f"{self.intensity:g} kW/m (assumed)"
        )


_LIMITS = tuple(each.name for each in fields(Containment) if each.name not in ("time", "attack"))


def as_containment(given: Any, what: str = "containment") -> Containment | None:
    """Read when fires are contained: None, what `as_duration` reads, "attack:" before it, or `Containment`.

    Limits of an attack follow after semicolons, such as "attack:1h;size=4;intense=1".

    Raises
    ------
    ParameterError
        If it is none of these.
    """
    if given is None or isinstance(given, Containment):
        return given
    if not isinstance(given, str) or not given.strip().lower().startswith("attack"):
        return Containment(as_duration(given, what))
    head, *rest = given.split(";")
    word, colon, time = head.partition(":")
    if word.strip().lower() != "attack" or not colon:
        raise ParameterError(f"{what} is {given!r}, expected {_FORMS}")
    limits: dict[str, float] = {}
    for each in rest:
        name, equals, number = (part.strip() for part in each.partition("="))
        try:
            limits[name] = float(number)
        except ValueError:
            raise ParameterError(f"{what} has {each.strip()!r}, expected NAME=NUMBER") from None
        if not equals or name not in _LIMITS:
            raise ParameterError(f"{what} has {each.strip()!r}, expected one of {', '.join(_LIMITS)} with its number")
    return Containment(as_duration(time, what), attack=True, **limits)
