"""How long work reports its progress and is stopped.

A progress callback takes the share done (0 to 1) and a short text. To stop the work it raises
`firebreak_gis.errors.Cancelled`; whoever calls it lets that pass through.
"""

from __future__ import annotations

from collections.abc import Callable

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
