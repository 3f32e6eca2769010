"""How long fires burn: a fixed time, times in turn, or times drawn from a distribution."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, Final, Literal

import numpy as np

from firebreak_gis.errors import ParameterError

#: Limit of a run that ends by itself [s].
ENDLESS: Final = 1 << 62
#: The longest time that can be asked for [s], 136 years.
_LONGEST = 1 << 32
_UNITS: Final = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86_400.0}
_TIME = re.compile(r"\s*([0-9]*\.?[0-9]+(?:e[+-]?[0-9]+)?)\s*(s|min|h|d)?\s*", re.IGNORECASE)
_FORMS = "8h, 90min, 2d, inf, a list such as 4h,8h, lognormal:8h,0.7, lognormal:8h,0.7,48h, uniform:2h,12h, or weather"


@dataclass(frozen=True)
class Duration:
    """How long the fire of each run burns.

    Parameters
    ----------
    kind
        `fixed`: always `values[0]` seconds. `turns`: the runs take the values in turn. `lognormal`: `values` are the
        median [s], the standard deviation of the logarithm, and perhaps the longest time [s], to which longer ones are
        cut. `uniform`: between two values. `weather`: as the weather of the run tells.
    values
        See `kind`; infinite times are those of fires that end by themselves.

    Examples
    --------
    >>> as_duration("8h")
    Duration(kind='fixed', values=(28800.0,))
    >>> as_duration("lognormal:8h,0.7").of_runs(seed=1, n_runs=3).tolist()
    [78531, 73263, 25279]
    """

    kind: Literal["fixed", "turns", "lognormal", "uniform", "weather"]
    values: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        times = self.values[::2] if self.kind == "lognormal" else self.values
        for time in times:
            if not (time > 0 and (time <= _LONGEST or (math.isinf(time) and self.kind in ("fixed", "turns")))):
                raise ParameterError(
                    f"a duration is {time:g} s, expected more than 0 and at most {_LONGEST:.2g} s, or inf"
                )
        if self.kind == "lognormal" and not 0 <= self.values[1] <= 5:
            raise ParameterError(f"the sigma of the durations is {self.values[1]:g}, expected 0 to 5")
        if self.kind == "uniform" and self.values[0] > self.values[1]:
            raise ParameterError("the durations' lower end lies above their upper end")

    @property
    def endless(self) -> bool:
        """Whether every fire ends by itself."""
        return self.kind in ("fixed", "turns") and all(math.isinf(time) for time in self.values)

    def of_runs(self, *, seed: int, n_runs: int, first_run: int = 0, purpose: str = "durations") -> np.ndarray:
        """Return the seconds that each run burns, (n_runs,) int64; `ENDLESS` where it ends by itself.

        A drawn duration depends on (seed, purpose, run) alone.
        """
        if self.kind == "weather":
            raise ParameterError("durations from the weather need a weather")
        if self.kind in ("fixed", "turns"):
            times = np.array([ENDLESS if math.isinf(t) else round(t) for t in self.values], np.int64)
            return np.asarray(times[np.arange(first_run, first_run + n_runs) % times.size])
        from firebreak_gis.kernels.draws import first_uniforms, run_keys

        shares = first_uniforms(run_keys(seed, purpose, n_runs, first_run)).tolist()
        if self.kind == "uniform":
            low, high = self.values
            drawn = [low + (high - low) * share for share in shares]
        else:
            median, sigma, *most = self.values
            normal = NormalDist().inv_cdf
            drawn = [median * math.exp(sigma * normal(max(share, 2.0**-53))) for share in shares]
            drawn = [min(time, *most) for time in drawn] if most else drawn
        return np.array([min(max(round(t), 1), _LONGEST) for t in drawn], np.int64)

    @property
    def middle(self) -> float:
        """The duration that half of the fires exceed [s].

        Raises
        ------
        ParameterError
            If only the weather tells it.
        """
        if self.kind == "weather":
            raise ParameterError("durations from the weather need a weather")
        return self.values[0] if self.kind == "lognormal" else float(np.median(self.values))

    def told(self) -> str:
        """The duration in words, for accounts and pictures."""
        if self.kind == "weather":
            return "as long as the weather tells"
        if self.kind == "lognormal":
            most = "".join(f", at most {clock(time)}" for time in self.values[2:])
            return f"{clock(self.values[0])} in the median (lognormal, sigma {self.values[1]:g}{most})"
        if self.kind == "uniform":
            return f"uniform, {clock(self.values[0])} to {clock(self.values[1])}"
        return ", ".join(map(clock, self.values))


def clock(seconds: float) -> str:
    """Write a time in the unit that suits it.

    Examples
    --------
    >>> clock(28800), clock(5400), clock(float("inf"))
    ('8 h', '1.5 h', 'until it ends by itself')
    """
    if math.isinf(seconds):
        return "until it ends by itself"
    for unit, factor in (("d", 86_400.0), ("h", 3600.0), ("min", 60.0)):
        if seconds >= factor * (2 if unit == "d" else 1):
            return f"{seconds / factor:.4g} {unit}"
    return f"{seconds:.4g} s"


def as_seconds(text: str | float, what: str = "a time") -> float:
    """Read a time such as 8h, 90min, 2d or 3600 (seconds).

    Raises
    ------
    ParameterError
        If it is none.

    Examples
    --------
    >>> as_seconds("1.5h")
    5400.0
    """
    if isinstance(text, (int, float, np.integer, np.floating)) and not isinstance(text, bool):
        return float(text)
    word = str(text).strip().lower()
    if word in ("inf", "infinite"):
        return math.inf
    match = _TIME.fullmatch(word)
    if match is None:
        raise ParameterError(f"{what} is {text!r}, expected a number with a unit (s, min, h, d), such as 8h")
    return float(match[1]) * _UNITS[match[2] or "s"]


def as_duration(given: Any, what: str = "duration") -> Duration:
    """Read how long fires burn.

    Parameters
    ----------
    given
        Seconds; a text such as "8h", "4h,8h", "lognormal:8h,0.7", "uniform:2h,12h" or "weather"; several of the first;
        or a `Duration`.
    what
        How it is called in messages.

    Raises
    ------
    ParameterError
        If it is none of these.
    """
    if isinstance(given, Duration):
        return given
    if isinstance(given, str):
        name, colon, rest = given.partition(":")
        words = (rest if colon else given).split(",")
        kind = name.strip().lower()
        if kind == "weather" and not colon:
            return Duration("weather")
        if not colon:
            return _times(words, what)
        if kind == "lognormal" and len(words) in (2, 3):
            most = [as_seconds(word, what) for word in words[2:]]
            return Duration("lognormal", (as_seconds(words[0], what), _number(words[1], what), *most))
        if kind == "uniform" and len(words) == 2:
            return Duration("uniform", (as_seconds(words[0], what), as_seconds(words[1], what)))
        raise ParameterError(f"{what} is {given!r}, expected {_FORMS}")
    if isinstance(given, (Sequence, np.ndarray)):
        return _times(given, what)
    return Duration("fixed", (as_seconds(given, what),))


def _times(given: Sequence[Any] | np.ndarray, what: str) -> Duration:
    if len(given) == 0:
        raise ParameterError(f"{what} is empty, expected {_FORMS}")
    values = tuple(as_seconds(each, what) for each in given)
    return Duration("fixed" if len(values) == 1 else "turns", values)


def _number(text: str, what: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ParameterError(f"{what} has {text!r} where a number is expected") from None
