"""Where the parts of the work are made: on the threads of this machine, or by the workers of a cluster.

Heavy work falls into parts: simulations into ranges of runs, whose results are whole numbers to be added up, or numbers
a run; maps into regions and windows. It does not matter who makes a part, how often, or in what order: the parts are
the same. Whoever has such work hands its parts to `spread`, and whoever wants them made elsewhere, or kept, says so
around it (`using`): nobody in between needs to know.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import math
import os
import pickle
import weakref
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import __version__
from firebreak_gis.progress import part, silent

if TYPE_CHECKING:
    from firebreak_gis.files.parts import Parts
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.workers import Cluster

    Result = Mapping[str, np.ndarray]
    Work = Callable[..., Result]


@dataclass
class Engine:
    """Who makes the parts.

    Parameters
    ----------
    cluster
        Workers; None: the threads of this process.
    kept
        Where finished parts are kept, and taken from; None: nowhere.
    """

    cluster: Cluster | None = None
    kept: Parts | None = None
    #: Calls so far, which with the number of the part name it among those that are kept.
    _calls: int = field(default=0, repr=False)

    @property
    def threads(self) -> int | None:
        """Threads of all workers; None where this process does the work."""
        return None if self.cluster is None else self.cluster.threads

    def run(
        self,
        work: Work,
        pieces: Sequence[Any],
        shared: Mapping[str, Any],
        take: Callable[[int, Result], None],
        threads: int | None,
        progress: Progress,
        message: str = "burning",
    ) -> None:
        """Make the pieces, see `spread`."""
        left = list(range(len(pieces)))
        keep: Callable[[int, Result], None] = take
        if self.kept is not None:
            self._calls += 1
            known = fingerprint((work.__module__, work.__qualname__, dict(shared)))
            keys = [fingerprint((known, pieces[i])) for i in left]
            kept, call = self.kept, self._calls
            for i in left.copy():
                found = kept.get(f"{call:04}-{i:04}", keys[i])
                if found is not None:
                    take(i, found)
                    left.remove(i)

            def keep(i: int, result: Result) -> None:
                kept.put(f"{call:04}-{i:04}", keys[i], result)
                take(i, result)

        if self.cluster is not None:
            self.cluster.run(work, pieces, left, shared, keep, progress, message)
            return
        for done, i in enumerate(left, len(pieces) - len(left)):
            step = part(progress, done / len(pieces), (done + 1) / len(pieces))
            keep(i, work(pieces[i], threads=threads, progress=step, **shared))


_engine: ContextVar[Engine | None] = ContextVar("_engine", default=None)


def in_use() -> Engine | None:
    """The engine that the block around sets; None: this process, and nothing is kept."""
    return _engine.get()


@contextlib.contextmanager
def using(engine: Engine | None) -> Iterator[None]:
    """Let an engine make what is heavy inside the block; None: this process, whatever stands further out."""
    token = _engine.set(engine)
    try:
        yield
    finally:
        _engine.reset(token)


def spread(
    work: Work,
    pieces: Sequence[Any],
    shared: Mapping[str, Any],
    *,
    take: Callable[[int, Result], None],
    threads: int | None,
    progress: Progress | None,
    message: str = "burning",
) -> None:
    """Make pieces of work on the engine in use.

    Parameters
    ----------
    work
        Called as ``work(piece, threads=..., progress=..., **shared)``, it returns arrays by name; `threads` changes the
        speed only, and `progress` raises to stop it. A function at the top of a module.
    pieces
        What tells the parts apart; small, or made when it is asked for: a few pieces are held at a time.
    shared
        What all of them need, by name: sent to each worker once, and not again while its content is the same.
    take
        Told the number of each piece and its result as soon as it is made, in any order, on the calling thread.
    threads
        See `threads.thread_count`; of the parts that this process makes.
    progress
        Told the share done, at least five times a second. If it raises, the work is stopped.
    message
        Text for `progress` while workers make the parts.

    Notes
    -----
    Where parts fail, the error is that of the first of them, whoever made them and whichever failed before.
    """
    (in_use() or Engine()).run(work, pieces, shared, take, threads, progress or silent, message)


def ranges(n: int, least: int) -> list[tuple[int, int]]:
    """Split 0 to `n` into ranges, whoever will make them.

    They have at least `least`, and grow with half the root of `n`: so there is something to do for many workers, and
    not much more to send.

    Examples
    --------
    >>> ranges(20, 8)
    [(0, 8), (8, 16), (16, 20)]
    >>> len(ranges(100_000, 8))
    633
    """
    size = max(least, math.isqrt(n) // 2)
    return [(first, min(first + size, n)) for first in range(0, n, size)]


_known: weakref.WeakKeyDictionary[Any, str] = weakref.WeakKeyDictionary()


def fingerprint(value: Any) -> str:
    """Hash of a value by what it holds: arrays, numbers, texts, data classes, and mappings and sequences of them.

    Objects with a method `content` are told by what it returns. Equal values have equal fingerprints in every process
    of this version of the program.

    Examples
    --------
    >>> fingerprint({"a": np.arange(3)}) == fingerprint({"a": np.arange(3)})
    True
    >>> fingerprint(1) == fingerprint(1.0)
    False
    """
    digest = hashlib.sha256(__version__.encode())
    _feed(digest, value)
    return digest.hexdigest()


def _feed(digest: Any, value: Any) -> None:
    digest.update(type(value).__qualname__.encode() + b"\0")
    if value is None or isinstance(value, (bool, int, float, str, np.generic)):
        digest.update(repr(value).encode("utf-8", "surrogateescape") + b"\0")
    elif isinstance(value, np.ndarray) and value.dtype != object:
        digest.update(f"{value.dtype.str}{value.shape}".encode())
        digest.update(np.ascontiguousarray(value).data)
    elif isinstance(value, os.PathLike):
        digest.update(os.fsencode(value) + b"\0")
    elif isinstance(value, Mapping):
        for key, each in value.items():
            _feed(digest, key)
            _feed(digest, each)
    elif isinstance(value, (list, tuple)):
        digest.update(str(len(value)).encode())
        for each in value:
            _feed(digest, each)
    elif hasattr(value, "to_numpy") and hasattr(value, "dims"):
        _feed(digest, [value.dims, value.to_numpy()])
    elif hasattr(value, "data_vars"):
        _feed(digest, {name: value[name] for name in value.data_vars} | {"attrs": dict(value.attrs)})
    elif hasattr(value, "content"):  # what stands for files, or is made of something
        _feed(digest, value.content())
    elif is_one_of_a_kind(value):  # large, and never changed: looked at once
        if value not in _known:
            _known[value] = fingerprint([getattr(value, each.name) for each in dataclasses.fields(value)])
        digest.update(_known[value].encode())
    elif dataclasses.is_dataclass(value):
        for each in dataclasses.fields(value):
            _feed(digest, getattr(value, each.name))
    else:
        digest.update(pickle.dumps(value))


def is_one_of_a_kind(value: Any) -> bool:
    """Whether a value is a frozen data class whose objects are compared by identity, as networks are."""
    how: Any = getattr(value, "__dataclass_params__", None)
    return how is not None and how.frozen and not how.eq
