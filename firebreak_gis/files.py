"""Putting files in place: absent, old, or whole and verified; never half.

Every writer of the package goes through `replacing`: the content is made under a temporary name in
the folder of the target, checked, flushed to the disk and moved over the target in one step.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import itertools
import os
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from firebreak_gis.errors import FirebreakError, InputError, OutputError

#: Names of temporary and lock files begin with this; a stranger's file is never touched.
PREFIX = ".firebreak-"

_serial = itertools.count()


@contextlib.contextmanager
def replacing(
    target: str | os.PathLike[str],
    *,
    overwrite: bool = False,
    verify: Callable[[Path], None] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
) -> Iterator[Path]:
    """Give a temporary path to write to; move it over `target` when the block ends well.

    On any exception, a keyboard interrupt included, the temporary file is removed and an old target
    stays as it was. While the block runs, a second writer of the same target is refused; what a
    killed process left behind is removed.

    Parameters
    ----------
    target
        File to make or to replace. A link is followed: what it points to is replaced.
    overwrite
        Whether an existing target may be replaced.
    verify
        Called with the temporary path once it is written; raises if the content is not right.
    forbid
        Inputs of the work: the target may be none of them, not even by a link.

    Yields
    ------
    Path
        Not yet existing file beside the target, with the suffix of the target.

    Raises
    ------
    OutputError
        If the target cannot or must not be written, or if writing fails.
    """
    place = require_writable(target, overwrite=overwrite, forbid=forbid)
    with _locked(place.parent, _key(place)) as exclusive:
        if exclusive:
            _remove_stale(place)
        part = place.with_name(f"{PREFIX}{_key(place)}-{os.getpid()}-{next(_serial)}.part{place.suffix}")
        try:
            yield part
            _finish(part, place, overwrite, verify)
        except FirebreakError:
            raise
        except OSError as error:
            raise OutputError(f"cannot write {place}: {_reason(error)}") from error
        finally:
            _remove_parts(place.parent, part.name.partition(".part")[0])


def write_text(target: str | os.PathLike[str], text: str, *, overwrite: bool = False) -> None:
    """Write UTF-8 text with Unix line ends through `replacing`.

    Raises
    ------
    OutputError
        As `replacing`.
    """
    with replacing(target, overwrite=overwrite) as part:
        part.write_text(text, encoding="utf-8", newline="\n")


def require_writable(
    target: str | os.PathLike[str],
    *,
    overwrite: bool = False,
    forbid: Iterable[str | os.PathLike[str]] = (),
) -> Path:
    """Check, before hours of work, that `target` can be written; return its real path.

    Raises
    ------
    OutputError
        If the folder is missing or read-only, if the target is a folder, is one of the inputs in
        `forbid` (also by a link), or exists and `overwrite` is not set.
    """
    place = Path(os.path.realpath(target))
    try:
        if not place.parent.is_dir():
            raise OutputError(f"the folder {place.parent} of the output {place.name} does not exist; create it first")
        if place.is_dir():
            raise OutputError(f"the output {place} is a folder, expected the name of a file")
        for source in forbid:
            if same_file(place, source):
                raise OutputError(
                    f"the output {place} is the input {source}; choose another name, inputs are never changed"
                )
        if place.exists():
            if not overwrite:
                raise OutputError(f"the output {place} exists; choose another name or allow overwriting (--overwrite)")
            if not os.access(place, os.W_OK):
                raise OutputError(
                    f"the output {place} is write-protected; remove the protection or choose another name"
                )
        # Asking for permission flags lies on network drives and for administrators: try.
        with tempfile.TemporaryFile(dir=place.parent, prefix=PREFIX):
            pass
    except OutputError:
        raise
    except OSError as error:
        raise OutputError(f"cannot write {place}: {_reason(error)}") from error
    return place


def same_file(one: str | os.PathLike[str], other: str | os.PathLike[str]) -> bool:
    """Whether two paths are one file, by name, symbolic link or hard link."""
    try:
        return Path(one).samefile(other)
    except OSError:
        return os.path.normcase(os.path.realpath(one)) == os.path.normcase(os.path.realpath(other))


def make_folder(folder: str | os.PathLike[str]) -> Path:
    """Make a folder with its parents unless it is there; return its path.

    Raises
    ------
    OutputError
        If it cannot be made, for example because a file has that name.
    """
    place = Path(folder)
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot make the folder {place}: {_reason(error)}") from error
    return place


def sha256(path: str | os.PathLike[str]) -> str:
    """Return the SHA-256 of a file in hexadecimal.

    Raises
    ------
    InputError
        If the file cannot be read.
    """
    try:
        with Path(path).open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise InputError(f"cannot read {path}: {_reason(error)}") from error


def _finish(part: Path, place: Path, overwrite: bool, verify: Callable[[Path], None] | None) -> None:
    if not part.exists():
        raise OutputError(f"nothing was written for {place}")
    if verify is not None:
        verify(part)
    with part.open("r+b") as stream:
        os.fsync(stream.fileno())
    if not overwrite and place.exists():
        raise OutputError(f"the output {place} appeared while it was being made; it was left as it is")
    part.replace(place)
    _flush_folder(place.parent)


def _flush_folder(folder: Path) -> None:
    if os.name == "nt":  # folders cannot be opened there, and renames are journalled
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    except OSError as error:
        # Some network file systems cannot flush folders; the file itself is safe by now.
        if error.errno not in (errno.EINVAL, errno.ENOTSUP):
            raise
    finally:
        os.close(handle)


def _key(place: Path) -> str:
    """Short stable name of a target; short because names may be at the limit of the file system."""
    return hashlib.sha256(place.name.casefold().encode("utf-8", "surrogateescape")).hexdigest()[:12]


@contextlib.contextmanager
def _locked(folder: Path, key: str) -> Iterator[bool]:
    """Hold the lock of one target; yields False where the file system knows no locks.

    The operating system frees the lock when a process dies, so it is never stale.
    """
    path = folder / f"{PREFIX}{key}.lock"
    handle, exclusive = _acquire(path)
    try:
        yield exclusive
    finally:
        if os.name != "nt":
            path.unlink(missing_ok=True)  # before the lock is given up: nobody else can hold this file
        os.close(handle)
        if os.name == "nt":
            with contextlib.suppress(OSError):
                path.unlink()


def _acquire(path: Path) -> tuple[int, bool]:
    """Open and lock `path`; return the handle and whether the lock holds."""
    while True:
        try:
            handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        except OSError as error:
            raise OutputError(f"cannot write in the folder {path.parent}: {_reason(error)}") from error
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


def _lock(handle: int) -> None:
    if sys.platform == "win32":
        import msvcrt

        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
    else:
        import fcntl

        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)


def _remove_stale(place: Path) -> None:
    """Remove what killed processes left in the folder: whoever holds the lock of a name owns its parts."""
    own = _key(place)
    _remove_parts(place.parent, PREFIX + own + "-")
    digits = "?" * len(own)
    keys = {
        entry.name[len(PREFIX) : len(PREFIX) + len(own)]
        for pattern in (f"{PREFIX}{digits}-*.part*", f"{PREFIX}{digits}.lock")
        for entry in place.parent.glob(pattern)
    }
    for key in keys - {own}:
        with contextlib.suppress(OutputError), _locked(place.parent, key) as exclusive:
            if exclusive:
                _remove_parts(place.parent, PREFIX + key + "-")


def _remove_parts(folder: Path, prefix: str) -> None:
    """Remove the temporary files with that prefix, with what drivers put beside them."""
    with contextlib.suppress(OSError):
        for entry in os.scandir(folder):
            if entry.name.startswith(prefix) and ".part" in entry.name:
                with contextlib.suppress(OSError):
                    Path(entry.path).unlink()


def _reason(error: OSError) -> str:
    hints = {
        errno.ENOSPC: "the disk is full; free some space or choose another disk",
        errno.EDQUOT: "the disk quota is used up; free some space or choose another disk",
        errno.EACCES: "no permission, or open in another program; close it there or choose another folder",
        errno.EPERM: "not permitted; choose another folder",
        errno.EROFS: "the disk is read-only; choose another folder",
        errno.ENAMETOOLONG: "the name is too long for this file system; choose a shorter one",
    }
    return hints.get(error.errno or 0) or error.strerror or str(error)
