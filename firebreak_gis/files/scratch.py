"""Arrays on the disk, for what need not fit into memory."""

from __future__ import annotations

import math
import mmap
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import OutputError
from firebreak_gis.files.locks import reason

if TYPE_CHECKING:
    from numpy.typing import DTypeLike


def on_disk(folder: str | os.PathLike[str], shape: tuple[int, ...], dtype: DTypeLike) -> Any:
    """Return an array of zeros whose values lie in a file without a name, which goes with the array, or the process.

    Parameters
    ----------
    folder
        On whose disk it lies.
    shape, dtype
        As of `numpy.zeros`.

    Raises
    ------
    OutputError
        If the disk does not take it.
    """
    try:
        with tempfile.TemporaryFile(dir=folder) as file:
            size = math.prod(shape) * np.dtype(dtype).itemsize
            if hasattr(os, "posix_fallocate") and size:
                os.posix_fallocate(file.fileno(), 0, size)  # a full disk is told now, not by a signal later
            return np.memmap(file, dtype, "r+" if size else "w+", shape=shape)
    except OSError as error:
        raise OutputError(
            f"cannot keep {math.prod(shape):,} numbers on the disk of {folder}: {reason(error)}"
        ) from error


def let_go(array: np.ndarray) -> None:
    """Let the system have the pages of an array of `on_disk`: its values stay, and are read where they are needed."""
    mapped = getattr(array, "_mmap", None)
    if mapped is not None and hasattr(mmap, "MADV_DONTNEED"):  # elsewhere the system takes them when it needs them
        mapped.madvise(mmap.MADV_DONTNEED)


def standing_folder(folder: str | os.PathLike[str]) -> str:
    """Return the folder, or the nearest one above it that exists."""
    place = Path(folder).absolute()
    while not place.is_dir() and place != place.parent:
        place = place.parent
    return str(place)
