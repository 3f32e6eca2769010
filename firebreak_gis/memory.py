"""How much memory there is, and refusing work that will not fit."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from firebreak_gis.errors import ResourceError

#: Share of the machine's memory that is used unless the user gives a limit.
DEFAULT_SHARE = 0.8


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
    limit = int(DEFAULT_SHARE * memory_limit()) if max_memory is None else max_memory
    if needed > limit:
        raise ResourceError(
            f"{what} needs about {_size(needed)} of memory, {_size(limit)} are allowed; take a smaller "
            f"extent, "
            "a coarser resolution, or a machine with more memory (limit: --max-memory)"
        )


def _machine_memory() -> int:
    if sys.platform == "win32":
        import ctypes

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


def _size(number: float) -> str:
    if number < 1e9:
        return f"{number / 1e6:.3g} MB"
    return f"{number / 1e9:.3g} GB"
