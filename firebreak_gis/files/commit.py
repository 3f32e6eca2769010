"""Moving finished files over old ones: all of them or none.

Each move is one step of the file system. Where a later step fails, the earlier ones are taken back: the
old files were kept by hard links meanwhile. A process killed between two moves leaves some files old and
some new, each whole, and the kept links tell (`unfinished`). The last file to come, the account of the run, is
the first of the old ones to go: where it stands, the files are those that it names.
"""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import FrameType

from firebreak_gis.files.locks import PREFIX, key_of

#: Signals that ask a process to end: Ctrl-C, `kill`, and a terminal that is closed.
ENDINGS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
#: Ending of the links that keep old files for an undo.
_KEPT = ".part-old"


def move_all(parts: Mapping[Path, Path], removals: Sequence[Path], *, whole: bool = False) -> None:
    """Move every part over its target, in order, and remove `removals`; flush the folders.

    Parameters
    ----------
    parts
        Target to finished file, in the same folder. If there are several, the last one is the account.
    removals
        Files that must not stay beside the new ones; may be missing.
    whole
        Whether the files are all that the folder is about: then no earlier move is unfinished any more.

    Raises
    ------
    OSError
        If a step fails; what was there before is there again.
    """
    places = list(parts)
    gone = [*places[-1:], *removals] if len(places) > 1 else list(removals)
    folders = {place.parent for place in places}
    with contextlib.ExitStack() as undo, _uninterrupted():
        kept = [_keep(place, undo) for place in dict.fromkeys((*gone, *places))]
        for place in gone:
            place.unlink(missing_ok=True)
        for place, part in parts.items():
            part.replace(place)
        for folder in folders:
            _flush_folder(folder)
        undo.pop_all()
        for copy in (*kept, *(old for folder in folders if whole for old in folder.glob(f"{PREFIX}*{_KEPT}"))):
            _forget(copy)


def unfinished(places: Iterable[Path]) -> bool:
    """Whether a process was killed while it moved several files, so that they may be of two runs."""
    return any(_kept(place).exists() for place in places)


def _kept(place: Path) -> Path:
    return place.with_name(f"{PREFIX}{key_of(place)}{_KEPT}")


def _keep(place: Path, undo: contextlib.ExitStack) -> Path:
    """Keep the present state of `place` for an undo; return the link that keeps it."""
    copy = _kept(place)
    try:
        copy.unlink(missing_ok=True)
        if place.exists():
            copy.hardlink_to(place)
    except OSError as error:
        if error.errno in (errno.EIO, errno.ENOSPC, errno.EDQUOT):
            raise
        return copy  # no hard links on this file system: no undo
    if copy.exists():
        undo.callback(_bring_back, copy, place)
    else:
        undo.callback(_forget, place)
    return copy


def _forget(place: Path) -> None:
    with contextlib.suppress(OSError):
        place.unlink(missing_ok=True)


def _bring_back(copy: Path, place: Path) -> None:
    with contextlib.suppress(OSError):
        copy.replace(place)
        copy.unlink(missing_ok=True)  # a rename between two links of one file does nothing


def _flush_folder(folder: Path) -> None:
    if os.name == "nt":  # folders cannot be opened there, and renames are journalled
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    except OSError as error:
        # Some network file systems cannot flush folders; the files themselves are safe by now.
        if error.errno not in (errno.EINVAL, errno.ENOTSUP):
            raise
    finally:
        os.close(handle)


@contextlib.contextmanager
def _uninterrupted() -> Iterator[None]:
    """Let a Ctrl-C, and every other asking to end, wait until the block, which is short, is through."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    asked: list[tuple[int, FrameType | None]] = []
    before = {number: handler for number in ENDINGS if (handler := signal.getsignal(number)) is not None}
    for number in before:
        signal.signal(number, lambda number, frame: asked.append((number, frame)))
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    for number, frame in asked:
        handler = before[number]
        if callable(handler):
            handler(number, frame)
        elif handler == signal.SIG_DFL:
            signal.raise_signal(number)
