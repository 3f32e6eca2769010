"""Locks on outputs, and the temporary files that go with them.

A lock is a file beside the output that the operating system locks for the process: it is free again when
the process dies, however it dies. Temporary files carry the key of the output, so whoever holds its lock
owns them and may remove what a killed process left.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from firebreak_gis.errors import OutputError

#: Names of temporary and lock files begin with this; a stranger's file is never touched.
PREFIX = ".firebreak-"
_KEY_LENGTH = 12

#: Lock files that this process holds for the length of a whole run.
_claimed: set[Path] = set()


def key_of(place: Path) -> str:
    """Short stable name of an output; short because names may be at the limit of the file system."""
    return hashlib.sha256(place.name.casefold().encode("utf-8", "surrogateescape")).hexdigest()[:_KEY_LENGTH]


@contextlib.contextmanager
def claimed(folder: Path, key: str) -> Iterator[None]:
    """Hold a lock for a whole run; `locked` in the same process passes through meanwhile.

    Raises
    ------
    OutputError
        If another run holds it.
    """
    path = _lock_file(folder, key)
    with locked(folder, key):
        new = path not in _claimed
        _claimed.add(path)
        try:
            yield
        finally:
            if new:
                _claimed.discard(path)


@contextlib.contextmanager
def locked(folder: Path, key: str) -> Iterator[bool]:
    """Hold the lock of one output; yields False where the file system knows no locks.

    Raises
    ------
    OutputError
        If another run holds it, or the folder cannot be written.
    """
    path = _lock_file(folder, key)
    if path in _claimed:
        yield True
        return
    handle, exclusive = _acquire(path)
    try:
        yield exclusive
    finally:
        if os.name != "nt":
            _remove(path)  # before the lock is given up: nobody else can hold this file
        with contextlib.suppress(OSError):
            os.close(handle)
        if os.name == "nt":
            _remove(path)


def remove_stale(place: Path) -> None:
    """Remove what killed processes left in the folder of `place`, whose lock the caller holds."""
    own = key_of(place)
    remove_parts(place.parent, f"{PREFIX}{own}-")
    digits = "?" * len(own)
    keys = {
        entry.name[len(PREFIX) : len(PREFIX) + len(own)]
        for pattern in (f"{PREFIX}{digits}-*.part*", f"{PREFIX}{digits}.lock")
        for entry in place.parent.glob(pattern)
    }
    for key in keys - {own}:
        if _lock_file(place.parent, key) in _claimed:
            continue
        with contextlib.suppress(OutputError), locked(place.parent, key) as exclusive:
            if exclusive:
                remove_parts(place.parent, f"{PREFIX}{key}-")


def remove_parts(folder: Path, prefix: str) -> None:
    """Remove the temporary files with that prefix, with what drivers put beside them."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.startswith(prefix) and ".part" in entry.name:
                _remove(Path(entry.path))


def reason(error: OSError) -> str:
    """Say in words why the operating system refused, and what to do."""
    hints = {
        errno.ENOSPC: "the disk is full; free some space or choose another disk",
        errno.EDQUOT: "the disk quota is used up; free some space or choose another disk",
        errno.EFBIG: "the file is larger than this disk or your account allows; choose another disk",
        errno.EACCES: "no permission, or open in another program; close it there or choose another folder",
        errno.EPERM: "not permitted; choose another folder",
        errno.EROFS: "the disk is read-only; choose another folder",
        errno.EMFILE: "too many files are open at once; raise the limit (ulimit -n)",
        errno.EPIPE: "the program that reads it has gone",
        errno.ENAMETOOLONG: "the name is too long for this file system; choose a shorter one",
    }
    return hints.get(error.errno or 0) or error.strerror or str(error)


def _lock_file(folder: Path, key: str) -> Path:
    return folder / f"{PREFIX}{key}.lock"


def _acquire(path: Path) -> tuple[int, bool]:
    """Open and lock `path`; return the handle and whether the lock holds."""
    while True:
        try:
            handle = _open(path)
        except OSError as error:
            raise OutputError(f"cannot write in the folder {path.parent}: {reason(error)}") from error
        try:
            _lock(handle)
            # The holder before us may have removed the file between our opening and our locking it.
            if os.path.samestat(os.fstat(handle), path.stat()):
                return handle, True
        except FileNotFoundError:
            pass
        except OSError as error:
            if error.errno not in (errno.EACCES, errno.EAGAIN, errno.EDEADLK):
                return handle, False
            os.close(handle)
            raise OutputError(
                f"another run is writing the same output in {path.parent}; wait for it or choose another name"
            ) from error
        os.close(handle)


def _open(path: Path) -> int:
    try:
        return os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    except PermissionError:
        # Left by another user's killed run in a shared folder: readable is enough to lock it.
        if not path.exists():
            raise
        return os.open(path, os.O_RDONLY)


def _lock(handle: int) -> None:
    if sys.platform == "win32":
        import msvcrt

        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):
        path.unlink()
