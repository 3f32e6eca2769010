"""How every kernel is compiled; the only place that decorates with numba.

Compiled on first call (no eager signatures), kept on disk, without the interpreter lock, with exact
IEEE arithmetic (no fastmath) so that results do not depend on the machine. Set the environment variable
FIREBREAK_NO_CACHE=1 to compile afresh, for example when the install folder is read-only and no
NUMBA_CACHE_DIR is set.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import numba

_CACHE = os.environ.get("FIREBREAK_NO_CACHE", "") in ("", "0")

#: Decorator of kernels that are called from Python.
kernel: Callable[..., Any] = numba.njit(nogil=True, cache=_CACHE, error_model="numpy", boundscheck=False)
#: Decorator of small functions of scalars that only kernels call; always inlined.
inlined: Callable[..., Any] = numba.njit(nogil=True, cache=_CACHE, error_model="numpy", inline="always")
