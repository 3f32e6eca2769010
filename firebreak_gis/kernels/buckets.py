"""A queue of cells by time: doubly linked lists of cells in buckets of equal width, in a ring."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.policy import kernel

#: End of a list.
NOBODY = np.uint32(0xFFFFFFFF)
#: Stands before the first cell of those further ahead than the ring.
AFAR = np.uint32(0xFFFFFFFE)
#: Stands before a cell that waits in no list, though fire came to it in a run that goes on.
DONE = np.uint32(0xFFFFFFFD)
#: Most buckets of the ring.
MOST = 1 << 16

_ONE = np.uint64(1)
_NEVER = np.uint64(0xFFFFFFFFFFFFFFFF)


class Buckets(NamedTuple):
    """Cells that wait; a cell waits in one place at most.

    Parameters
    ----------
    heads
        (n + 1,) uint32, n a power of two: first cell of each bucket of the ring, and of those further ahead. Bucket b
        is in entry b modulo n.
    links
        (n_cells, 2) uint32: cell before and cell after in the list.
    """

    heads: np.ndarray
    links: np.ndarray


def buckets(n_cells: int, span: int) -> Buckets:
    """Empty queue for cells that come at most `span` buckets after the one that is due, or later at some cost."""
    size = min(1 << (int(span) + 1).bit_length(), MOST)
    return Buckets(np.full(size + 1, NOBODY), np.empty((n_cells, 2), np.uint32))


@kernel
def refill(queue: Buckets, time: np.ndarray, shift: np.uint64, now: np.uint64) -> np.uint64:
    """Bring those that were far ahead into the ring if they lie in it by now; return the first bucket still ahead.

    Parameters
    ----------
    queue
        The queue.
    time
        (n_cells,) uint64 time for which each cell waits.
    shift
        The bucket of a time is ``time >> shift``.
    now
        Bucket that is due.
    """
    heads, links = queue.heads, queue.links
    size = np.uint64(heads.size - 1)
    cell = heads[size]
    heads[size] = NOBODY
    first = _NEVER
    while cell != NOBODY:
        then = links[cell, 1]
        bucket = time[cell] >> shift
        slot = bucket & (size - _ONE)
        before = NOBODY
        if bucket - now >= size:
            slot = size
            before = AFAR
            first = min(first, bucket)
        after = heads[slot]
        heads[slot] = cell
        links[cell, 0] = before
        links[cell, 1] = after
        if after != NOBODY:
            links[after, 0] = cell
        cell = then
    return first
