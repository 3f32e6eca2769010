"""Putting files in place: absent, old, or whole and verified; never half.

Every writer of the package goes through `replacing`: the content is made under a temporary name in
the folder of the target, checked, flushed to the disk and moved over the target in one step. Inside
`together` the files of a folder wait for each other and are moved when the last one is ready.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import os
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path

from firebreak_gis.errors import FirebreakError, InputError, OutputError, VerificationError
from firebreak_gis.files.commit import move_all
from firebreak_gis.files.gate import has_controls
from firebreak_gis.files.locks import PREFIX, claimed, key_of, locked, reason, remove_parts, remove_stale

_serial = itertools.count()
_PIECE = 1 << 20


@dataclass
class _Batch:
    """Files of one or more folders that are finished but not yet in place."""

    folders: frozenset[Path]
    alone: bool
    locks: contextlib.ExitStack
    parts: dict[Path, Path] = field(default_factory=dict)
    removals: list[Path] = field(default_factory=list)
    replaceable: set[Path] = field(default_factory=set)

    def taken(self, place: Path) -> bool:
        """Whether a file stands, or will stand, at `place`."""
        return place in self.parts or (place.exists() and place not in self.removals)

    def commit(self) -> None:
        """Move everything into place."""
        for place in self.parts:
            if place not in self.replaceable and place.exists():
                raise OutputError(f"the output {place} appeared while it was being made; it was left as it is")
        move_all(self.parts, self.removals, whole=self.alone)

    def drop(self) -> None:
        """Remove what was not moved."""
        for part in self.parts.values():
            remove_parts(part.parent, part.name)


_batch: ContextVar[_Batch | None] = ContextVar("_batch", default=None)


@contextlib.contextmanager
def together(folder: str | os.PathLike[str], *more: str | os.PathLike[str], alone: bool = False) -> Iterator[Path]:
    """Let the files that the block writes into folders appear together at its end, or none of them.

    Where a file cannot be written, or the block is left by an exception, all old files stay. The file
    written last is taken as the account of the others: it is the first of the old ones to go and the last
    of the new ones to come. Blocks on the same folder may be nested; the outermost moves the files.

    Parameters
    ----------
    folder, more
        Where they go. Files that the block writes elsewhere are moved at once.
    alone
        Whether no other run may write a set of files into `folder` meanwhile.

    Yields
    ------
    Path
        The folder.

    Raises
    ------
    OutputError
        If another run is writing into the folder, or the files cannot be moved.
    """
    place = Path(os.path.realpath(folder))
    outer = _batch.get()
    places = frozenset((place, *(Path(os.path.realpath(other)) for other in more)))
    if outer is not None and places <= outer.folders:
        yield Path(folder)
        return
    lock = locked(place, _FOLDER_KEY) if alone else contextlib.nullcontext()
    with lock, _collecting(places, alone) as batch:
        token = _batch.set(batch)
        try:
            yield Path(folder)
        finally:
            _batch.reset(token)


@contextlib.contextmanager
def claiming(target: str | os.PathLike[str], *, folder: bool = False) -> Iterator[None]:
    """Keep other runs from writing the same output for as long as the block lasts.

    Parameters
    ----------
    target
        File or folder. A file whose folder is missing is not claimed: writing it will be refused.
    folder
        Whether it is a folder; it is made if missing, and removed again if it stays empty.

    Raises
    ------
    OutputError
        If another run holds it, or the folder cannot be made or written.
    """
    place = Path(os.path.realpath(target))
    if not folder and not place.parent.is_dir():
        yield
        return
    new = folder and not place.exists()
    try:
        with claimed(make_folder(place), _FOLDER_KEY) if folder else claimed(place.parent, key_of(place)):
            yield
    finally:
        if new:
            with contextlib.suppress(OSError):
                place.rmdir()


@contextlib.contextmanager
def replacing(
    target: str | os.PathLike[str],
    *,
    overwrite: bool = False,
    verify: Callable[[Path], None] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
    remove: Iterable[str | os.PathLike[str]] = (),
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
    remove
        Files beside the target that belong to the old one and go with it.

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
    outer = _batch.get()
    with contextlib.ExitStack() as stack:
        batch = outer if outer is not None and place.parent in outer.folders else None
        if batch is None:
            batch = stack.enter_context(_collecting(frozenset((place.parent,))))
        if place not in batch.parts and batch.locks.enter_context(locked(place.parent, key_of(place))):
            remove_stale(place)
        part = place.with_name(f"{PREFIX}{key_of(place)}-{os.getpid()}-{next(_serial)}.part{place.suffix}")
        try:
            yield part
            _finish(part, place, verify)
            earlier = batch.parts.pop(place, part)
            batch.parts[place] = part
            if earlier != part:
                remove_parts(place.parent, earlier.name)
        except FirebreakError:
            raise
        except OSError as error:
            raise OutputError(f"cannot write {place}: {reason(error)}") from error
        finally:
            if batch.parts.get(place) != part:
                remove_parts(place.parent, part.name)
        batch.removals.extend(Path(extra) for extra in remove)
        if overwrite:
            batch.replaceable.add(place)


@contextlib.contextmanager
def _collecting(folders: frozenset[Path], alone: bool = False) -> Iterator[_Batch]:
    """Collect finished files of folders and move them when the block ends well."""
    with contextlib.ExitStack() as locks:
        batch = _Batch(folders, alone, locks)
        try:
            yield batch
            batch.commit()
        except FirebreakError:
            raise
        except OSError as error:
            names = ", ".join(str(place) for place in batch.parts)
            raise OutputError(f"cannot write {names}: {reason(error)}") from error
        finally:
            batch.drop()


def write_text(target: str | os.PathLike[str], text: str, *, overwrite: bool = False) -> None:
    """Write UTF-8 text through `replacing`; as `write_bytes`."""
    write_bytes(target, text.encode("utf-8"), overwrite=overwrite)


def write_bytes(
    target: str | os.PathLike[str],
    content: bytes | memoryview,
    *,
    overwrite: bool = False,
    verify: Callable[[Path], None] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
    remove: Iterable[str | os.PathLike[str]] = (),
) -> None:
    """Write a file through `replacing`, and read it back.

    GDAL and SQLite make their files in memory and leave the writing to this function: on a disk that is
    full or fails they may say nothing, and leave a file whose values read well but whose overviews, texts or
    index are broken.

    Parameters
    ----------
    target, overwrite, verify, forbid, remove
        As in `replacing`.
    content
        What goes into it.

    Raises
    ------
    OutputError
        As `replacing`.
    VerificationError
        If it does not read back as it was written.
    """

    def compare(part: Path) -> None:
        with part.open("rb") as stream:
            same = all(stream.read(_PIECE) == content[i : i + _PIECE] for i in range(0, len(content), _PIECE))
            if not same or stream.read(1):
                raise VerificationError(f"{target} does not read back as it was written; is the disk failing?")
        if verify is not None:
            verify(part)

    with (
        replacing(target, overwrite=overwrite, verify=compare, forbid=forbid, remove=remove) as part,
        part.open("wb") as stream,
    ):
        stream.write(content)


def remove_file(path: str | os.PathLike[str]) -> None:
    """Remove an old output, inside `together` when the new ones come.

    Raises
    ------
    OutputError
        If it cannot be removed.
    """
    place = Path(os.path.realpath(path))
    batch = _batch.get()
    if batch is not None and place.parent in batch.folders:
        batch.removals.append(place)
        return
    try:
        place.unlink(missing_ok=True)
    except OSError as error:
        raise OutputError(f"cannot remove {place}: {reason(error)}") from error


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
    if has_controls(str(place)):
        raise OutputError(f"the output {str(place)!r} has a line break or tab in its name; choose another")
    try:
        if not place.parent.is_dir():
            raise OutputError(f"the folder {place.parent} of the output {place.name} does not exist; create it first")
        if place.is_dir():
            raise OutputError(f"the output {place} is a folder, expected the name of a file")
        if place.exists() and not place.is_file():
            raise OutputError(f"the output {place} is a device or a pipe, expected the name of a file")
        for source in forbid:
            if same_file(place, source):
                raise OutputError(
                    f"the output {place} is the input {source}; choose another name, inputs are never changed"
                )
        batch = _batch.get()
        if place.exists() if batch is None else batch.taken(place):
            if not overwrite:
                raise OutputError(f"the output {place} exists; choose another name or allow overwriting (--overwrite)")
            if place.exists() and not os.access(place, os.W_OK):
                raise OutputError(
                    f"the output {place} is write-protected; remove the protection or choose another name"
                )
        # Asking for permission flags lies on network drives and for administrators: try.
        with tempfile.TemporaryFile(dir=place.parent, prefix=f"{PREFIX}{key_of(place)}-", suffix=".part"):
            pass
    except OutputError:
        raise
    except OSError as error:
        raise OutputError(f"cannot write {place}: {reason(error)}") from error
    return place


def require_distinct(files: Mapping[str, str | os.PathLike[str]]) -> None:
    """Refuse outputs that cannot be, before one of them is claimed.

    Parameters
    ----------
    files
        Path by the option that names it.

    Raises
    ------
    OutputError
        If two are one file, or one is a device or a pipe, which nothing is ever written to.
    """
    named = list(files.items())
    for i, (option, path) in enumerate(named):
        for other, earlier in named[:i]:
            if same_file(path, earlier):
                raise OutputError(f"{other} and {option} both name the output {path}; give them different names")
        place = Path(path)
        if place.exists() and not (place.is_file() or place.is_dir()):
            raise OutputError(f"the output {path} is a device or a pipe, expected the name of a file")


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
        raise OutputError(f"cannot make the folder {place}: {reason(error)}") from error
    return place


def sha256(path: str | os.PathLike[str]) -> str:
    """Return the SHA-256 of a file in hexadecimal; inside `together` that of the file to come.

    Raises
    ------
    InputError
        If the file cannot be read.
    """
    batch = _batch.get()
    source = Path(path) if batch is None else batch.parts.get(Path(os.path.realpath(path)), Path(path))
    try:
        with source.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError as error:
        raise InputError(f"cannot read {path}: {reason(error)}") from error


def _finish(part: Path, place: Path, verify: Callable[[Path], None] | None) -> None:
    if not part.exists():
        raise OutputError(f"nothing was written for {place}")
    if verify is not None:
        verify(part)
    if place.exists():
        # Who may read or write the old one may read or write the new one.
        with contextlib.suppress(OSError):
            shutil.copymode(place, part)
    with part.open("r+b") as stream:
        os.fsync(stream.fileno())


#: Key of the folder itself: no file can have this name.
_FOLDER_KEY = key_of(Path("/"))
