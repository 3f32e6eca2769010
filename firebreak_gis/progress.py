"""How long work reports its progress and is stopped.

A progress callback takes the share done (0 to 1) and a short text. To stop the work it raises
`firebreak_gis.errors.Cancelled`; whoever calls it lets that pass through.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from itertools import pairwise

Progress = Callable[[float, str], None]


def silent(fraction: float, message: str) -> None:
    """Report nothing; the default wherever `progress` is not given."""


def part(progress: Progress | None, start: float, stop: float, prefix: str = "") -> Progress:
    """Return a callback that maps 0..1 of a step to `start`..`stop` of the whole.

    Parameters
    ----------
    progress
        Callback of the whole, or None.
    start, stop
        Shares of the whole at which the step begins and ends.
    prefix
        Text put before each message.
    """
    if progress is None:
        return silent

    def report(fraction: float, message: str) -> None:
        progress(start + (stop - start) * min(max(fraction, 0.0), 1.0), prefix + message)

    return report


def in_proportion(seconds: Sequence[float], start: float, stop: float) -> list[tuple[float, float]]:
    """Share out `start`..`stop` to steps by the seconds that each will take; evenly if none takes any.

    Examples
    --------
    >>> in_proportion([1.0, 3.0], 0.2, 1.0)
    [(0.2, 0.4), (0.4, 1.0)]
    """
    total = sum(seconds)
    weights = seconds if total > 0.0 else [1.0] * len(seconds)
    ends, done = [start], 0.0
    for weight in weights:
        done += weight
        ends.append(start + (stop - start) * done / (total or len(seconds)))
    return list(pairwise(ends))


class CompileClock:
    """How long compiling took in this process: it comes once on a machine, and tells nothing of the work that is left.

    Parameters
    ----------
    now
        Tells the time [s].
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._depth = 0
        self._since = self._done = 0.0
        #: Told when compiling begins.
        self.begun: Callable[[], None] | None = None

    def start(self) -> None:
        """Something is compiled; what it calls is compiled within."""
        with self._lock:
            self._depth += 1
            first = self._depth == 1
            if first:
                self._since = self._now()
        if first and self.begun is not None:
            self.begun()

    def stop(self) -> None:
        """It is ready."""
        with self._lock:
            self._depth -= 1
            if self._depth == 0:
                self._done += self._now() - self._since

    @property
    def seconds(self) -> float:
        """Seconds so far; what is being compiled counts."""
        with self._lock:
            return self._done + (self._now() - self._since if self._depth else 0.0)


#: That of this process; `kernels.policy` runs it.
COMPILING = CompileClock()


def worked(work: Callable[[], object], now: Callable[[], float] = time.perf_counter) -> float:
    """Seconds that work takes, less those of compiling."""
    began, compiled = now(), COMPILING.seconds
    work()
    return max(now() - began - (COMPILING.seconds - compiled), 0.0)
