"""Run pieces of work on threads while the main thread reports progress and listens for a stop."""

from __future__ import annotations

import heapq
import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from functools import partial
from itertools import count
from threading import Event
from typing import TypeVar

from firebreak_gis.errors import ParameterError, ResourceError
from firebreak_gis.progress import Progress

Piece = TypeVar("Piece")
Result = TypeVar("Result")

_LISTEN_EVERY = 0.2  # seconds


def thread_count(threads: int | None) -> int:
    """Threads to use: as given, else FIREBREAK_THREADS, else the processors this process may use."""
    if threads is None:
        given = os.environ.get("FIREBREAK_THREADS", "").strip()
        if given and not given.isdigit():
            raise ParameterError(f"FIREBREAK_THREADS is {given!r}, expected a whole number of at least 1")
        affinity = getattr(os, "sched_getaffinity", None)
        threads = int(given) if given else len(affinity(0)) if affinity else os.cpu_count() or 1
    if threads < 1:
        raise ParameterError(f"threads is {threads}, expected at least 1")
    return threads


def run_pieces(
    work: Callable[[Piece], None],
    pieces: Sequence[Piece],
    *,
    threads: int | None,
    progress: Progress,
    message: str,
) -> None:
    """Call `work` on every piece, several at a time.

    `work` must release the interpreter lock to gain speed, and its effect must not depend on the order of
    pieces.

    Parameters
    ----------
    work
        Called as ``work(piece)``.
    pieces
        The pieces.
    threads
        See `thread_count`.
    progress
        Told the share of pieces done, at least five times a second. If it raises, pieces not yet begun are
        dropped and the exception passes through at once.
    message
        Text for `progress`.

    Raises
    ------
    ResourceError
        If no thread can be started.
    """
    n_threads = thread_count(threads)
    # Each thread takes the next piece itself: handed out one by one, pieces of a millisecond took a tenth longer.
    number, stopped = count(), Event()
    done: list[int] = []

    def take() -> None:
        while not stopped.is_set() and (i := next(number)) < len(pieces):
            work(pieces[i])
            done.append(i)

    pool = ThreadPoolExecutor(n_threads)
    running: set[Future[None]] = set()
    try:
        running |= {_submitted(pool, take) for _ in range(min(n_threads, len(pieces)))}
        while running:
            progress(len(done) / len(pieces), message)
            finished, running = wait(running, timeout=_LISTEN_EVERY, return_when=FIRST_COMPLETED)
            for future in finished:
                future.result()
    finally:
        # Not waited for: what is at work ends by itself, and its results are not looked at after a stop.
        stopped.set()
        pool.shutdown(wait=False, cancel_futures=True)
    progress(1.0, message)


def run_growing(
    work: Callable[[Piece], Iterable[Piece]],
    pieces: Iterable[Piece],
    *,
    size: Callable[[Piece], float],
    threads: int | None,
    progress: Progress,
    message: Callable[[], str],
) -> None:
    """Call `work` on every piece, and on the pieces that it returns, several at a time, the largest first.

    Parameters
    ----------
    work
        As in `run_pieces`; returns what is left to do of a piece.
    pieces
        Those to begin with.
    size
        Work that a piece is with all that will come of it; what is returned is no more than what was given.
    threads, progress
        As in `run_pieces`; the share done is that of the sizes.
    message
        Returns the text for `progress`.

    Raises
    ------
    ResourceError
        If no thread can be started.
    """
    number = count()
    waiting = [(-size(piece), next(number), piece) for piece in pieces]
    heapq.heapify(waiting)
    total = left = -sum(each for each, _, _ in waiting)
    n_threads = thread_count(threads)
    pool = ThreadPoolExecutor(n_threads)
    running: dict[Future[Iterable[Piece]], float] = {}
    try:
        while waiting or running:
            while waiting and len(running) < n_threads:
                heaviness, _, piece = heapq.heappop(waiting)
                running[_submitted(pool, partial(work, piece))] = -heaviness
            progress(min(max(1.0 - left / max(total, 1e-300), 0.0), 1.0), message())
            finished, _ = wait(running, timeout=_LISTEN_EVERY, return_when=FIRST_COMPLETED)
            for future in finished:
                left -= running.pop(future)
                for piece in future.result():
                    left += size(piece)
                    heapq.heappush(waiting, (-size(piece), next(number), piece))
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
    progress(1.0, message())


def _submitted(pool: ThreadPoolExecutor, work: Callable[[], Result]) -> Future[Result]:
    try:
        return pool.submit(work)
    except RuntimeError as error:
        raise ResourceError("the system starts no further thread; raise its limit or allow more memory") from error
