"""Rows of the table: two ways to one result, timed in turn, or one figure with its limit."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np

#: How rows of peak memory begin.
MEMORY = "peak memory, "


@dataclass
class Comparison:
    """One thing done in two ways.

    Parameters
    ----------
    what, cells, peer
        What is done, on how many cells, and by whom else.
    ours, theirs
        Do it and return the result.
    agree
        Whether the two results are the same; asked of the first pair.
    amount
        What the time is divided by, found from a result; with `unit` and its `factor` of seconds.
    rounds
        Pairs that are timed.
    at_least
        Asked: their time over ours.
    at_most
        Asked instead: our time over theirs.
    threads
        Threads of both sides. With one, processor time is taken: it does not count what other programs take.
    """

    what: str
    cells: int
    peer: str
    ours: Callable[[], Any]
    theirs: Callable[[], Any]
    agree: Callable[[Any, Any], bool]
    amount: Callable[[Any], float] = lambda result: 1.0
    unit: str = "s"
    factor: float = 1.0
    rounds: int = 3
    at_least: float | None = None
    at_most: float | None = None
    threads: int = 1


@dataclass
class Figure:
    """One measured number, in `unit`, and what it may be at most or must be at least."""

    what: str
    cells: int
    value: float
    unit: str
    at_most: float | None = None
    at_least: float | None = None
    threads: int = 1


@dataclass
class Line:
    """A row of the table as it is written."""

    what: str
    cells: int
    threads: int
    ours: float
    unit: str
    peer: str = ""
    theirs: float = math.nan
    ratio: float = math.nan
    asked: str = ""
    holds: bool | None = None
    fault: str = field(default="")


def line_of(row: Comparison | Figure) -> Line:
    """Measure a row."""
    if isinstance(row, Figure):
        asked, holds = _verdict(row.value, row.at_least, row.at_most, f" {row.unit}")
        return Line(row.what, row.cells, row.threads, row.value, row.unit, asked=asked, holds=holds)
    ours, theirs, fault = _in_turn(row)
    ratio = ours / theirs if row.at_most else theirs / ours
    asked, holds = _verdict(ratio, row.at_least, row.at_most, "x")
    return Line(
        row.what, row.cells, row.threads, ours, row.unit, row.peer, theirs, ratio, asked, holds and not fault, fault
    )


def _in_turn(row: Comparison) -> tuple[float, float, str]:
    """Median times of both sides, a round of each in turn; and whether their results differ."""
    clock = time.process_time if row.threads == 1 else time.perf_counter
    times: tuple[list[float], list[float]] = ([], [])
    fault = ""
    row.ours()  # compiled kernels are loaded, memory is there
    for turn in range(row.rounds):
        results = []
        for work, seconds in zip((row.ours, row.theirs), times, strict=True):
            started = clock()
            results.append(work())
            seconds.append(row.factor * (clock() - started) / row.amount(results[-1]))
        if turn == 0 and not row.agree(*results):
            fault = "results differ"
    return float(np.median(times[0])), float(np.median(times[1])), fault


def _verdict(value: float, at_least: float | None, at_most: float | None, unit: str) -> tuple[str, bool | None]:
    if at_least is not None:
        return f"at least {at_least:g}{unit}", value >= at_least
    if at_most is not None:
        return f"at most {at_most:g}{unit}", value <= at_most
    return "", None


def seconds(work: Callable[[], object], *, rounds: int = 3, clock: Callable[[], float] = time.process_time) -> float:
    """Median time of `work` after one call that does not count."""
    work()
    times = []
    for _ in range(rounds):
        started = clock()
        work()
        times.append(clock() - started)
    return float(np.median(times))


@contextmanager
def threads(number: int) -> Iterator[None]:
    """Let all kernels use `number` threads."""
    import os

    before = os.environ.get("FIREBREAK_THREADS")
    os.environ["FIREBREAK_THREADS"] = str(number)
    try:
        yield
    finally:
        if before is None:
            del os.environ["FIREBREAK_THREADS"]
        else:
            os.environ["FIREBREAK_THREADS"] = before


def close(a: object, b: object, rtol: float = 1e-9) -> bool:
    """Whether two arrays of cells agree, whatever their shape."""
    x, y = np.asarray(a).ravel(), np.asarray(b).ravel()
    return bool(np.allclose(x, y, rtol=rtol, atol=1e-12 * np.abs(y).max()))
