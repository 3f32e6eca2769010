"""Workers of dask: processes of this machine, or of a cluster.

dask is imported here alone, and only when it is asked for.
"""

from __future__ import annotations

import asyncio
import contextlib
import dataclasses
import importlib
import logging
import os
import signal
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import (
    Cancelled,
    FirebreakError,
    InputError,
    MissingComponentError,
    ParameterError,
    ResourceError,
)
from firebreak_gis.simulation.engine import Engine, fingerprint, is_one_of_a_kind, using

if TYPE_CHECKING:
    from pathlib import Path

    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.engine import Result, Work

_LISTEN_EVERY = 0.2  # seconds
#: A scheduler that does not answer for so long is taken for absent [s].
_PATIENCE = 8.0
#: Workers and schedulers that have not let go by then are left alone [s].
_FAREWELL = 0.7
#: A part is made anew so often where its worker or its data are lost.
_TRIES = 3
#: What is kept on the workers beside what the parts at work need; sent again when it is needed again.
_KEPT = 12
#: Arrays of fewer bytes are small.
_SMALL = 1 << 14
#: Large pieces are handed out as long as those that are out have fewer bytes, or threads are idle.
_OUT = 1 << 28
_PLAIN = (bool, int, float, str, tuple, type(None))
#: What must be the same wherever parts are made, so that equal fires have equal bytes.
_ALIKE = ("firebreak_gis", "numpy", "numba", "python")
#: Ctrl-C is for us: we tell the workers.
_PRELOAD = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"


@contextlib.contextmanager
def cluster(
    workers: int | None = None,
    *,
    scheduler: str | None = None,
    client: Any = None,
    keep: str | os.PathLike[str] | None = None,
    say: Callable[[str], None] | None = None,
) -> Iterator[Engine]:
    """Let workers make what is heavy inside the block: fires, regions of large maps, parts of large landscapes.

    Parameters
    ----------
    workers
        So many processes of this machine, of one thread each, for as long as the block lasts.
    scheduler
        Address of a dask scheduler such as "tcp://host:8786", or the file that ``dask scheduler --scheduler-file``
        writes.
    client
        A `dask.distributed.Client` that is there, such as of dask-jobqueue; it is left open.
    keep
        Folder in which finished parts are kept until the block ends well, and from which those of an earlier,
        stopped run are taken; with or without workers.
    say
        Told what a person should know of it, such as parts that were kept and are not what is needed now.

    Yields
    ------
    Engine
        What makes the parts.

    Raises
    ------
    ParameterError
        If more than one of `workers`, `scheduler` and `client` is given.
    MissingComponentError
        If dask is not installed (extra `scale`), or the workers have other versions.
    ResourceError
        If no scheduler answers.

    Notes
    -----
    Whatever the workers, results are equal to the bit to those of one machine. In a script, put it below
    ``if __name__ == "__main__":``: processes begin by importing the script.

    Examples
    --------
    >>> import tempfile, firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> with tempfile.TemporaryDirectory() as folder, fb.cluster(keep=folder + "/parts"):
    ...     burns = fb.simulate(network, n_runs=100)
    >>> burns.identical(fb.simulate(network, n_runs=100))
    True
    """
    from firebreak_gis.files.parts import Parts

    if sum(given is not None for given in (workers, scheduler, client)) > 1:
        raise ParameterError("give one of workers, scheduler and client")
    with contextlib.ExitStack() as open_:
        found = None
        if workers is not None:
            found = open_.enter_context(_local(workers))
        elif scheduler is not None:
            found = open_.enter_context(_remote(scheduler))
        elif client is not None:
            found = Cluster(client)
        kept = None if keep is None else Parts(keep, say)
        engine = Engine(found, kept)
        with using(engine):
            yield engine
        if kept is not None:
            kept.remove()


class Cluster:
    """Workers behind a `dask.distributed.Client`."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self._sent: OrderedDict[str, Any] = OrderedDict()
        self._versions = _versions()
        self._require_alike()

    @property
    def threads(self) -> int:
        """Threads of the workers that are there now, at least 1."""
        return max(int(sum(self._client.nthreads().values())), 1)

    @property
    def dashboard(self) -> str:
        """Address of the page on which dask shows the work; empty if it has none."""
        return str(self._client.dashboard_link or "")

    def run(
        self,
        work: Work,
        pieces: Sequence[Any],
        numbers: Sequence[int],
        shared: Mapping[str, Any],
        take: Callable[[int, Result], None],
        progress: Progress,
        message: str,
    ) -> None:
        """Make those pieces of these numbers, the others are there already; see `engine.spread`."""
        client, left, tries = self._client, set(numbers), 0
        failed: dict[int, BaseException] = {}

        def listen() -> None:
            there = bool(client.nthreads())
            progress(1.0 - len(left) / len(pieces), message if there else "waiting for workers")

        while left:
            while not client.nthreads():
                listen()
                time.sleep(_LISTEN_EVERY)
            few = {name: value for name, value in shared.items() if _small(value)}
            sent = {name: self._send(value) for name, value in shared.items() if name not in few}
            few = self._send(few)
            rest, out = deque(sorted(left)), _Out(self._client)
            try:
                while rest or out.waiting:
                    while rest and (out.bytes < _OUT or len(out.waiting) < self.threads):
                        i = rest.popleft()
                        piece, size = self._handed(pieces[i])
                        out.add(i, client.submit(_make, work, piece, self._versions, sent, few, pure=False), size)
                    listen()
                    for i, made in out.ready():
                        error = made.exception()
                        if error is None:
                            take(i, made.result())
                            left.discard(i)
                        elif not _lost(error):
                            failed[i] = _told(error)
                    if failed:  # one before it may fail as well, and is told then
                        first = min(failed)
                        out.drop(first)
                        rest.clear()
                        left = {i for i in left if i < first}
            finally:
                out.drop()
            tries += 1
            if left and tries > _TRIES:
                raise ResourceError(
                    f"{len(left)} parts of the work were lost {tries} times, with the workers that held their data; "
                    "look into the logs of the workers, and give them more memory"
                )
            if left:
                self._sent.clear()
        if failed:
            raise failed[min(failed)]
        progress(1.0, message)

    def _handed(self, piece: Any) -> tuple[Any, int]:
        """A piece and 0; what stands for it on a worker if it is large, and its bytes."""
        from dask.sizeof import sizeof

        size = sizeof(piece)
        if size < _SMALL:
            return piece, 0
        # In a list: of a mapping dask sends every item by itself, under its own name.
        return self._client.scatter([piece], hash=False)[0], size

    def _send(self, value: Any) -> Any:
        """What stands for the value on the workers, to which it is sent once."""
        key = fingerprint(value)
        if key not in self._sent:
            # In a list, see `_handed`.
            (self._sent[key],) = self._client.scatter([value], broadcast=True, hash=False)
            while len(self._sent) > _KEPT:
                self._sent.popitem(last=False)
        self._sent.move_to_end(key)
        return self._sent[key]

    def _require_alike(self) -> None:
        """Refuse workers of other versions than ours."""
        told = self._client.get_versions(check=False, packages=["firebreak_gis", "numba"])
        for address, worker in told["workers"].items():
            _require_same(self._versions, {name: worker["packages"].get(name) for name in _ALIKE}, address)


class _Out:
    """Parts that are handed out to the workers of a client, and have not come back."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self._futures: dict[int, Any] = {}
        self._sizes: dict[int, int] = {}
        self.waiting: dict[Future[Result], int] = {}

    @property
    def bytes(self) -> int:
        """Of their large pieces."""
        return sum(self._sizes.values())

    def add(self, i: int, future: Any, size: int) -> None:
        """Wait for part `i`, with a large piece of so many bytes; dask waits for it, and this thread need not."""
        self._futures[i], self._sizes[i] = future, size
        self.waiting[self._soon(self._client.gather(future, asynchronous=True))] = i

    def ready(self) -> list[tuple[int, Future[Result]]]:
        """Parts that are made, or have failed, once there is one or a moment has gone by."""
        made = wait(self.waiting, timeout=_LISTEN_EVERY, return_when=FIRST_COMPLETED).done
        found = [(self.waiting.pop(each), each) for each in made]
        for i, _ in found:
            self._futures.pop(i).release()
            del self._sizes[i]
        return found

    def drop(self, after: int = -1) -> None:
        """Let go of the parts after one: nobody waits for them any more."""
        gone = [self._futures.pop(i) for i in list(self._futures) if i > after]
        self._sizes = {i: size for i, size in self._sizes.items() if i in self._futures}
        self.waiting = {each: i for each, i in self.waiting.items() if i in self._futures}
        if gone:
            self._soon(self._client.cancel(gone, force=True, asynchronous=True))

    def _soon(self, work: Any) -> Future[Any]:
        """Let the thread of dask do what it calls asynchronous."""
        return asyncio.run_coroutine_threadsafe(work, self._client.loop.asyncio_loop)


def _make(work: Work, piece: Any, versions: Mapping[str, str], *shared: Mapping[str, Any]) -> Result:
    """Make a part, on a worker."""
    from distributed import get_worker

    worker = get_worker()
    _require_same(versions, _versions(), worker.address)
    key = worker.get_current_task()

    def listen(share: float, message: str) -> None:  # noqa: ARG001
        task = worker.state.tasks.get(key)
        if task is None or task.state in ("cancelled", "released", "forgotten"):
            raise Cancelled("nobody waits for this part any more")

    return work(piece, threads=1, progress=listen, **{name: value for some in shared for name, value in some.items()})


def _small(value: Any) -> bool:
    """Whether a value is sent together with others, and not by itself, once for all that need it."""
    if isinstance(value, np.ndarray):
        return value.nbytes < _SMALL
    return not is_one_of_a_kind(value) and (dataclasses.is_dataclass(value) or isinstance(value, _PLAIN))


def _versions() -> dict[str, str]:
    import platform

    found = {name: str(importlib.import_module(name).__version__) for name in _ALIKE if name != "python"}
    return found | {"python": platform.python_version()}


def _require_same(ours: Mapping[str, str], theirs: Mapping[str, Any], where: str) -> None:
    for name, version in ours.items():
        other = "none" if theirs.get(name) is None else str(theirs[name])
        if name == "python":  # dask tells more: 3.11.7.final.0
            other, version = (".".join(each.split(".")[:2]) for each in (other, version))
        if other != version:
            raise MissingComponentError(
                f"the worker at {where} has {name} {other}, this machine {version}; install the same version on both"
            )


def _lost(error: BaseException) -> bool:
    """Whether a part failed since what it needs was on workers that have gone, and not of itself."""
    from distributed.client import FutureCancelledError

    return isinstance(error, FutureCancelledError)


def _told(error: BaseException) -> BaseException:
    """An error of a part, for whoever waits for it."""
    from distributed.scheduler import KilledWorker

    if isinstance(error, KilledWorker):
        return ResourceError(
            "several workers ended at the same part of the work, as they do for want of memory; give fewer workers, "
            f"or more memory to each ({error})"
        )
    if isinstance(error, FileNotFoundError) and not isinstance(error, FirebreakError):
        return InputError(f"a worker does not find {error.filename}; inputs must lie where all workers can read them")
    return error


@contextlib.contextmanager
def _local(workers: int) -> Iterator[Cluster]:
    """Processes of this machine; when the block ends badly they are killed, for what they do is not wanted any more."""
    if workers < 1:
        raise ParameterError(f"workers is {workers}, expected at least 1")
    distributed = _dask()
    try:
        processes = distributed.LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address="127.0.0.1:0",
            memory_limit=0,
            silence_logs=logging.CRITICAL,
            preload=[_PRELOAD],
        )
    except OSError as error:
        raise ResourceError(f"the system starts no workers: {error}") from error
    client = None
    try:
        client = distributed.Client(processes)
        yield Cluster(client)
    finally:
        for nanny in processes.workers.values():  # what they still do is not wanted any more
            nanny.auto_restart = False
            with contextlib.suppress(OSError, TypeError):  # one that has ended has no number
                os.kill(nanny.pid, getattr(signal, "SIGKILL", signal.SIGTERM))
        for each in (client, processes):
            with contextlib.suppress(TimeoutError):
                if each is not None:
                    each.close(timeout=_FAREWELL)


@contextlib.contextmanager
def _remote(scheduler: str) -> Iterator[Cluster]:
    """The cluster of a scheduler that is there, and stays."""
    distributed = _dask()
    where: dict[str, Path | str] = {"scheduler_file": scheduler} if scheduler.endswith(".json") else {}
    try:
        client = distributed.Client(**where or {"address": scheduler}, timeout=_PATIENCE)
    except (OSError, TimeoutError, ValueError) as error:
        raise ResourceError(
            f"no dask scheduler answers at {scheduler} ({error}); start one (dask scheduler), or give its address"
        ) from error
    try:
        yield Cluster(client)
    finally:
        with contextlib.suppress(TimeoutError):
            client.close(timeout=_FAREWELL)


def _dask() -> Any:
    try:
        return importlib.import_module("distributed")
    except ImportError:
        raise MissingComponentError(
            "dask.distributed, which spreads the work over workers, is not installed; install firebreak_gis[scale]"
        ) from None
