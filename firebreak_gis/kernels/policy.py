"""How every kernel is compiled; the only place that decorates with numba.

Compiled on first call (no eager signatures), kept on disk, without the interpreter lock, with exact
IEEE arithmetic (no fastmath) so that results do not depend on the machine. Set the environment variable
FIREBREAK_NO_CACHE=1 to compile afresh, for example when the install folder is read-only and no
NUMBA_CACHE_DIR is set.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba.core import event
from numba.core.caching import IndexDataCacheFile

from firebreak_gis.progress import COMPILING

#: Of all kernels: numba itself looks at the file of a function alone, not at those of the functions that it calls.
_SOURCES = tuple(
    (file.name, file.stat().st_mtime, file.stat().st_size) for file in sorted(Path(__file__).parent.glob("*.py"))
)
_CACHE = os.environ.get("FIREBREAK_NO_CACHE", "") in ("", "0")


class _Compiles(event.Listener):
    """Runs the clock while numba compiles; what is found in the cache is no such event."""

    def on_start(self, _: event.Event) -> None:
        COMPILING.start()

    def on_end(self, _: event.Event) -> None:
        COMPILING.stop()


event.register("numba:compile", _Compiles())


class _CacheFile(IndexDataCacheFile):
    """Compiled code of one function on disk, which several programs may fill at once.

    numba keeps an index of a function's files, and numbers them. Two programs that compile it at once then write
    one file for both, and the machine code that a third one loads takes other arguments than it is given; or the later
    one's index forgets what the earlier one compiled. A file named by what it holds needs no index.
    """

    def _name(self, key: Any) -> str:
        mark = hashlib.sha256(repr((self._version, self._source_stamp, key)).encode()).hexdigest()[:16]
        return self._index_name.removesuffix(".nbi") + f".{mark}.nbc"

    def save(self, key: Any, data: Any) -> None:
        """Keep compiled code in a file named by what it was compiled for."""
        self._save_data(self._name(key), data)

    def load(self, key: Any) -> Any:
        """Find code compiled for the same before, or None."""
        try:
            return self._load_data(self._name(key))
        except OSError:
            return None

    def flush(self) -> None:
        """Nothing to forget: what was compiled for something else has another name."""


def _compiled(**how: Any) -> Callable[..., Any]:
    """Decorator with what all kernels share."""
    decorate = numba.njit(nogil=True, cache=_CACHE, error_model="numpy", **how)

    def compiled(function: Callable[..., Any]) -> Any:
        dispatcher = decorate(function)
        file = getattr(getattr(dispatcher, "_cache", None), "_cache_file", None)
        if type(file) is IndexDataCacheFile:  # not without a cache, and perhaps not in a later numba
            file.__class__ = _CacheFile
            file._source_stamp = (file._source_stamp, _SOURCES)
        return dispatcher

    return compiled


#: Decorator of kernels that are called from Python.
kernel: Callable[..., Any] = _compiled(boundscheck=False)
#: Decorator of small functions of scalars that only kernels call; always inlined.
inlined: Callable[..., Any] = _compiled(inline="always")
