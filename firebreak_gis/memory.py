"""How much memory there is and work will need, and refusing what will not fit."""

from __future__ import annotations

import contextlib
import ctypes
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from firebreak_gis.errors import ResourceError
from firebreak_gis.plugins import memory_of
from firebreak_gis.threads import thread_count

#: Share of the machine's memory that is used unless the user gives a limit.
DEFAULT_SHARE = 0.8
#: What the C library of Linux takes for large in one piece, how much free memory it keeps at its end, and how many
#: heaps its threads have: names in the environment, and numbers in malloc.h.
_MALLOC = {"MALLOC_MMAP_THRESHOLD_": -3, "MALLOC_TRIM_THRESHOLD_": -1, "MALLOC_ARENA_MAX": -8}
#: Values of these where memory is to be returned as soon as it is free, and where it is kept for what comes next.
_RETURNING, _KEEPING = (1 << 20, 128 << 10, 1), (32 << 20, 64 << 20, 1)
#: What the user, or the process that started this one, has set.
_GIVEN = frozenset(_MALLOC) & frozenset(os.environ)
#: Share of what is allowed up to which memory is plenty.
_PLENTY = 0.25


@dataclass(frozen=True)
class Need:
    """Peak of a command, measured as resident memory on grids of 1,000 x 1,000 and 3,000 x 3,000 cells.

    Parameters
    ----------
    fixed
        The program and its libraries, bytes.
    cell
        A cell, bytes.
    thread
        A cell and thread, bytes.
    """

    fixed: int
    cell: int
    thread: int = 0

    def bytes(self, cells: int, threads: int) -> int:
        """Return the peak for a grid."""
        return self.fixed + cells * (self.cell + threads * self.thread)


_PLAIN, _COMPILED, _DRAWING = 170_000_000, 285_000_000, 435_000_000
#: What holds the network and what a planner adds while a ranking works, bytes a cell.
_NETWORK = 58
#: Of it, the probabilities.
_PLANES = 32
#: Making a network, or reading one, is the peak of each command that has one, unless its work needs more.
_MAKING, _READING = Need(_COMPILED, 210), Need(_PLAIN, 140)
#: What travel times add to making a network, and to all else, bytes a cell.
_TIMES_MADE, _TIMES = 190, 100
#: What is kept of fires by time, size, flame length and path, bytes a cell, and a cell and thread.
_KEPT, _KEPT_THREAD = 400, 200
#: Cells that are made together where a landscape or a network is made by blocks; of a finer layer so many are read.
BLOCK_CELLS, SOURCE_CELLS = 4_000_000, 8_000_000
#: Bytes a cell of a map that is read by windows, and a cell of each window at work.
_MAP, _WINDOW = 20, 700
#: A process that burns what it was sent.
_WORKER = Need(_COMPILED, 200)
#: One that dissects regions; 190 B a cell were measured, and what comes and goes is there twice.
_IN_REGIONS = Need(_COMPILED, 230)
_STAGES: Mapping[str, tuple[Need, ...]] = {
    "align": (Need(_PLAIN, 81),),
    "network": (_MAKING,),
    "rank": (_READING,),
    "burn": (_READING, Need(_COMPILED, 170, 87)),
    "evaluate": (_READING, Need(300_000_000, 150, 45)),
    "compare": (_READING, Need(_DRAWING, 170, 87)),
    "plan": (_MAKING, Need(_DRAWING, 170, 87)),
}


#: Plans of large maps, whose networks lie on the disk; measured on 3,162 x 3,162 cells, pages of their files left out.
#: Design: what does not grow with the map are the windows of large fires on two threads, and what fires have come to;
#: on maps whose fires burn on the whole, of 16 million cells at most, all takes less, 2.9 GB on 10 million.
#: 10,000 x 10,000 cells took 16.5 GB.
_AWAY: Mapping[str, tuple[Need, ...]] = {"plan": (Need(2_100_000_000, 135), Need(_DRAWING, 200))}


def bytes_for(
    command: str,
    cells: int,
    *,
    method: str | None = None,
    clock: bool = False,
    products: bool = False,
    window: int | None = None,
    blocks: bool = False,
    workers: int | None = None,
    threads: int | None = None,
) -> int:
    """Estimate the peak memory of a command.

    Parameters
    ----------
    command
        "align", "network", "rank", "burn", "evaluate", "compare" or "plan".
    cells
        Of the grid.
    method
        Ranking, for the commands that rank; several names, by commas, for those that take several.
    clock
        Whether the network has travel times.
    products
        Whether more is kept of fires than how often each cell burns.
    window
        Side of the windows of the map that are read in turn; None: the map is read as a whole.
    blocks
        Whether a network is made by blocks of `BLOCK_CELLS`, or read by them while its probabilities stay on the disk;
        of a plan, whether its networks lie there.
    workers
        Processes of this machine that do the work, each with its data in its own memory; none: the threads of this one.
    threads
        See `threads.thread_count`.
    """
    n_threads, others = thread_count(threads), workers or 0
    if window is not None:
        in_windows = min(window**2, cells) * _WINDOW
        return _COMPILED + cells * _MAP + n_threads * in_windows + others * (_COMPILED + in_windows)
    away = blocks and cells > BLOCK_CELLS
    needed = [stage.bytes(cells, n_threads) for stage in _AWAY.get(command, ()) if away]
    for stage in _STAGES[command]:
        together = min(cells, BLOCK_CELLS) if blocks else cells
        needed.append(stage.bytes(together, n_threads) + clock * together * _times(stage))
    for name in (method or "").split(","):
        if name:
            cell, thread = memory_of("ranking", name, large=cells > BLOCK_CELLS)
            work = Need(_COMPILED, _NETWORK - away * _PLANES + cell, thread)
            needed.append(work.bytes(cells, n_threads) + clock * (not away) * cells * _TIMES)
    each = _WORKER.bytes(cells, 1) + clock * cells * _TIMES
    if command == "rank":
        each = _IN_REGIONS.bytes(min(cells, BLOCK_CELLS), 1)
    return max(needed) + products * cells * (_KEPT + (n_threads + others) * _KEPT_THREAD) + others * each


def _times(stage: Need) -> int:
    return _TIMES_MADE if stage is _MAKING else _TIMES


def allowed(max_memory: int | None = None) -> int:
    """Return the bytes that may be used: as given, else the usual share of what there is."""
    return int(DEFAULT_SHARE * memory_limit()) if max_memory is None else max_memory


def memory_limit() -> int:
    """Return the bytes of memory that the process may use: the machine's, or its container's if less."""
    limits = [_machine_memory()]
    for path in ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"):
        try:
            limits.append(int(Path(path).read_text(encoding="ascii")))
        except (OSError, ValueError):  # no container, or "max"
            continue
    return min(limit for limit in limits if limit > 0)


def require_memory(needed: int, what: str, *, max_memory: int | None = None) -> None:
    """Refuse work that needs more memory than allowed.

    Parameters
    ----------
    needed
        Estimated peak, bytes.
    what
        The work, in words.
    max_memory
        Limit in bytes; 0.8 of the machine's memory by default.

    Raises
    ------
    ResourceError
        If `needed` is more than the limit.
    """
    limit = allowed(max_memory)
    if needed > limit:
        raise ResourceError(
            f"{what} needs about {size(needed)} of memory, {size(limit)} are allowed; take a smaller "
            f"extent, "
            "a coarser resolution, or a machine with more memory (limit: --max-memory)"
        )


def return_large() -> None:
    """Have the C library of Linux return what is large to the system as soon as it is freed, here and in workers.

    By itself it raises what it takes for large up to 32 MB as arrays come and go, and keeps what is smaller: beside its
    network dissection then takes twice the memory. A user's own setting stands.
    """
    _set_malloc(_RETURNING)


def suit(needed: int, *, max_memory: int | None = None) -> None:
    """As `return_large`, unless work needs little of what is allowed: then what is freed is kept, which is faster.

    Each page that is returned is asked for, and filled with zeros, anew: a sixth of the time of a plan of 10^6 cells.

    Parameters
    ----------
    needed
        Estimated peak, bytes.
    max_memory
        As `require_memory` takes it.
    """
    _set_malloc(_KEEPING if needed <= _PLENTY * allowed(max_memory) else _RETURNING)


def _set_malloc(values: Sequence[int]) -> None:
    if sys.platform != "linux":
        return
    for (name, number), value in zip(_MALLOC.items(), values, strict=True):
        if name not in _GIVEN:
            os.environ[name] = str(value)
            with contextlib.suppress(OSError, AttributeError):  # other C libraries have no such thing
                ctypes.CDLL(None).mallopt(number, value)


def give_back() -> None:
    """Give the system back what was freed in small parts, which the C library of Linux keeps otherwise."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, AttributeError):  # other C libraries have no such thing
            ctypes.CDLL(None).malloc_trim(0)


def _machine_memory() -> int:
    if sys.platform == "win32":

        class Status(ctypes.Structure):
            _fields_ = (
                ("length", ctypes.c_ulong),
                ("load", ctypes.c_ulong),
                ("total", ctypes.c_ulonglong),
                ("rest", ctypes.c_ulonglong * 6),
            )

        status = Status(length=ctypes.sizeof(Status))
        ctypes.windll.kernel32.GlobalMemoryStatusEx(ctypes.byref(status))
        return int(status.total)
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")


def size(number: float) -> str:
    """Write a number of bytes for people."""
    if number < 1e9:
        return f"{number / 1e6:.3g} MB"
    return f"{number / 1e9:.3g} GB"
