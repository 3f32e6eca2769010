"""One run of the engine: arguments in, JSON lines out, stopped on request."""

from __future__ import annotations

import contextlib
import json
import queue
import subprocess  # nosec B404 # the engine is a program of its own
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from .environment import start_options
from .errors import EngineCancelledError, EngineFailedError
from .lookup import Engine

_POLL = 0.1  # seconds between two looks at the cancel button
_GRACE = 0.6  # seconds that the engine has to stop by itself
_FAREWELL = 5.0  # seconds from the last word of the engine to its end
_KEPT_LINES = 20  # of what the engine writes on stderr


def _ignore(*_: Any) -> None:
    """Drop what nobody asked for."""


@dataclass(frozen=True)
class Listener:
    """Who is told what happens during a run.

    Parameters
    ----------
    progress
        Called with the share done (0 to 1) and a text.
    warning
        Called with every warning.
    said
        Called with everything else that the engine tells, such as what was done to the layers, or how long it takes.
    cancelled
        Asked ten times a second whether to stop.
    """

    progress: Callable[[float, str], None] = _ignore
    warning: Callable[[str], None] = _ignore
    said: Callable[[str], None] = _ignore
    cancelled: Callable[[], bool] = bool


def run(engine: Engine, arguments: Sequence[str], listener: Listener | None = None, *, folder: str) -> dict[str, Any]:
    """Run one command of the engine and return its result.

    Parameters
    ----------
    engine
        From `find_engine`.
    arguments
        Name of the command, options and arguments, without --json and --progress.
    listener
        Who is told of progress.
    folder
        Working folder.

    Raises
    ------
    EngineFailedError
        If the engine refuses the work, cannot be started, or dies.
    EngineCancelledError
        If the listener asked to stop; the process has ended.
    """
    listener = listener or Listener()
    command = [*engine.command, arguments[0], "--json", "--progress", "json", *arguments[1:]]
    try:
        process = subprocess.Popen(  # nosec B603 # argument list, no shell, program chosen by the user
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=folder,
            **start_options(),
        )
    except OSError as error:
        raise EngineFailedError(f"The engine does not start: {error}") from error
    complaints: deque[str] = deque(maxlen=_KEPT_LINES)
    lines: queue.Queue[str | None] = queue.Queue()
    readers = [
        threading.Thread(target=_read, args=(process.stdout, lines.put, lambda: lines.put(None)), daemon=True),
        threading.Thread(target=_read, args=(process.stderr, complaints.append, _ignore), daemon=True),
    ]
    try:
        for reader in readers:
            reader.start()
        told = _converse(lines, listener)
        _ended(process, _FAREWELL)
    except _Stop:
        raise EngineCancelledError("Stopped as asked.") from None
    finally:
        _end(process)
        for reader, stream in zip(readers, (process.stdout, process.stderr)):  # noqa: B905 - QGIS may run Python 3.9
            reader.join(_GRACE)
            if not reader.is_alive():
                stream.close()
    return _result(told, process.returncode, complaints)


class _Stop(Exception):  # noqa: N818 - not an error
    """The listener wants to stop."""


def _read(stream: Any, put: Callable[[str], None], done: Callable[[], None]) -> None:
    with contextlib.suppress(ValueError, OSError):
        for line in stream:
            put(line.decode("utf-8", "replace").rstrip("\r\n"))
    done()


def _converse(lines: queue.Queue[str | None], listener: Listener) -> dict[str, Any]:
    """Pass on what the engine says until it falls silent; return its last word."""
    told: dict[str, Any] = {}
    last = None
    while True:
        if listener.cancelled():
            raise _Stop
        try:
            line = lines.get(timeout=_POLL)
        except queue.Empty:
            continue
        if line is None:
            return told
        document = _parsed(line)
        if "progress" in document:
            now = (float(document["progress"]), str(document.get("message", "")))
            if now != last:
                listener.progress(*now)
                last = now
        elif "warning" in document:
            listener.warning(str(document["warning"]))
        elif "said" in document:
            listener.said(str(document["said"]))
        elif "result" in document or "error" in document:
            told = document


def _parsed(line: str) -> dict[str, Any]:
    """Return the document of a line; empty for anything that is no message, such as a stray print."""
    try:
        document = json.loads(line)
    except ValueError:
        return {}
    return document if isinstance(document, dict) else {}


def _end(process: subprocess.Popen[bytes]) -> None:
    """Leave no process behind: ask it to stop, then end it."""
    if process.poll() is None:
        with contextlib.suppress(OSError, ValueError):
            process.stdin.write(b"cancel\n")
            process.stdin.flush()
        for step in (_ignore, process.terminate, process.kill):
            with contextlib.suppress(OSError):
                step()
            if _ended(process, _GRACE if step is _ignore else _POLL):
                break
        process.wait()
    with contextlib.suppress(OSError, ValueError):
        process.stdin.close()


def _ended(process: subprocess.Popen[bytes], patience: float) -> bool:
    stop = time.monotonic() + patience
    while process.poll() is None and time.monotonic() < stop:
        time.sleep(0.02)
    return process.poll() is not None


def _result(told: dict[str, Any], code: int, complaints: Iterable[str]) -> dict[str, Any]:
    if isinstance(told.get("result"), dict):
        return told["result"]
    error = told.get("error")
    if isinstance(error, dict):
        raise EngineFailedError(str(error.get("message", "")), kind=str(error.get("kind", "error")), exit_code=code)
    if code < 0 or code in (137, 0xC0000005):
        cause = f"signal {-code}" if code < 0 else f"code {code}"
        raise EngineFailedError(
            f"The engine was ended from outside or crashed ({cause}). Perhaps memory ran out: choose larger "
            f"cells or a smaller extent. {_tail(complaints)}",
            exit_code=code,
        )
    raise EngineFailedError(
        f"The engine ended with code {code} and without a result. {_tail(complaints)}", exit_code=code
    )


def _tail(complaints: Iterable[str]) -> str:
    text = "\n".join(line for line in complaints if line.strip())
    return f"It said last:\n{text}" if text else "It said nothing."
