"""Finished parts of long work, kept in a folder so that a run that was stopped goes on where it was.

A part is a file: what it was made of (a hash), the hash of its content, the content. A part that is not what is needed
now, or does not hold what was written, is made anew and that is said; so a wrong one is never trusted.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np

from firebreak_gis.errors import OutputError
from firebreak_gis.files.locks import reason

#: Of a folder that holds nothing but parts.
FOLDER = ".parts"
_ENDING = ".part"
_MARK = b"firebreak part 1\n"
_HASH = hashlib.sha256().digest_size


class Parts:
    """The parts in a folder.

    Parameters
    ----------
    folder
        Made when the first part is kept.
    say
        Told, once each, of parts that cannot be used.
    """

    def __init__(self, folder: str | os.PathLike[str], say: Callable[[str], None] | None = None) -> None:
        self.folder = Path(folder)
        self._say = say or (lambda _: None)
        self._told: set[str] = set()
        #: Parts that were there already, and that were made since.
        self.found = self.made = 0

    def get(self, name: str, key: str) -> dict[str, np.ndarray] | None:
        """Content of a part; None if there is none, or not this one.

        Parameters
        ----------
        name
            Of the part.
        key
            Hash, in hexadecimal, of all that it is made of.
        """
        try:
            data = self._path(name).read_bytes()
        except FileNotFoundError:
            return None
        except OSError as error:
            self._tell(f"a kept part cannot be read ({reason(error)})")
            return None
        begin = len(_MARK)
        made_of, digest, content = (
            data[begin : begin + _HASH],
            data[begin + _HASH : begin + 2 * _HASH],
            data[begin + 2 * _HASH :],
        )
        if data[:begin] != _MARK or hashlib.sha256(made_of + content).digest() != digest:
            self._tell("a kept part is damaged")
            return None
        if made_of.hex() != key:
            self._tell("a kept part was made of other inputs or parameters")
            return None
        with np.load(io.BytesIO(zlib.decompress(content)), allow_pickle=False) as arrays:
            result = dict(arrays)
        self.found += 1
        return result

    def put(self, name: str, key: str, arrays: Mapping[str, np.ndarray]) -> None:
        """Keep a part.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        stream = io.BytesIO()
        np.savez(stream, **cast("dict[str, Any]", arrays))
        made_of, content = bytes.fromhex(key), zlib.compress(stream.getbuffer(), 1)
        path = self._path(name)
        new = path.with_suffix(".new")
        try:
            self.folder.mkdir(exist_ok=True)
            new.write_bytes(_MARK + made_of + hashlib.sha256(made_of + content).digest() + content)
            new.replace(path)
        except OSError as error:
            raise OutputError(f"cannot keep a finished part in {self.folder}: {reason(error)}") from error
        self.made += 1

    @property
    def count(self) -> int:
        """Parts that are there."""
        return sum(path.suffix == _ENDING for path in self.folder.iterdir()) if self.folder.is_dir() else 0

    def remove(self) -> None:
        """Remove all parts, and the folder if nothing else is in it."""
        with contextlib.suppress(OSError):
            for path in self.folder.iterdir():
                if path.suffix in (_ENDING, ".new"):
                    path.unlink()
            self.folder.rmdir()

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}{_ENDING}"

    def _tell(self, what: str) -> None:
        if what not in self._told:
            self._told.add(what)
            self._say(f"{what}; it is made anew, as are others like it ({self.folder})")
