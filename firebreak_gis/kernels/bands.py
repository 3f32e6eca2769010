"""Threads over bands of rows.

A band owns its rows: it alone writes them, and every row is computed in the same way in any band. Results
are therefore the same bits for any number of threads. Kernels release the interpreter lock.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from types import TracebackType

from firebreak_gis.threads import thread_count

#: Fewer cells than this are not worth a second thread.
SMALL = 200_000


class Bands:
    """Runs a kernel over the rows of a grid, one band a thread.

    Parameters
    ----------
    shape
        (rows, cols).
    threads
        See `workers.thread_count`; None: one on a small grid.
    """

    def __init__(self, shape: tuple[int, int], threads: int | None = None) -> None:
        rows, cols = shape
        wanted = 1 if threads is None and rows * cols < SMALL else thread_count(threads)
        self.threads = max(1, min(wanted, rows))
        self._edges = [rows * k // self.threads for k in range(self.threads + 1)]
        self._pool = ThreadPoolExecutor(self.threads - 1) if self.threads > 1 else None

    def __enter__(self) -> Bands:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def run(self, call: Callable[[int, int], object]) -> None:
        """Call `call(first_row, stop_row)` for every band and wait."""
        if self._pool is None:
            call(self._edges[0], self._edges[-1])
            return
        *others, (first, stop) = itertools.pairwise(self._edges)
        waiting = [self._pool.submit(call, *band) for band in others]
        call(first, stop)  # here, rather than wake one more thread
        for future in waiting:
            future.result()
