"""Making an environment with the engine in it, on the user's explicit wish only."""

from __future__ import annotations

import os
import queue
import re
import shutil
import subprocess  # nosec B404 # pip is a program of its own
import sys
import threading
from collections import deque
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from .environment import interpreter_in, own_interpreter, start_options
from .errors import EngineCancelledError, EngineError, EngineMissingError
from .lookup import command_of, forget, handshake

#: What pip is asked to install where the user says nothing else.
PACKAGE = "firebreak_gis"
#: Python releases that the engine runs on: from, up to but without.
RELEASES = ((3, 11), (3, 14))

_POLL = 0.1  # seconds
_SHARE_OF_VENV = 0.1  # of the whole work
_EXPECTED_LINES = 110  # that pip writes for a new environment; the bar nears its end towards them

Report = Callable[[float, str], None]


def base_interpreters() -> list[Path]:
    """Return the interpreters on this machine that an engine can be made from, the best first."""
    names = [f"python{major}.{minor}" for major, minor in _releases()] + ["python3", "python"]
    found = [Path(path) for path in map(shutil.which, names) if path]
    own = own_interpreter()
    if own is not None:
        found.append(own)
    result: list[Path] = []
    for path in found:
        if path not in result and RELEASES[0] <= _release(path) < RELEASES[1]:
            result.append(path)
    return result


def make_engine(
    folder: Path,
    *,
    base: Path | None = None,
    package: str = PACKAGE,
    report: Report,
    cancelled: Callable[[], bool],
) -> str:
    """Make a virtual environment with the engine and return the engine's version.

    Parameters
    ----------
    folder
        Of the environment; what stands there is replaced. Removed again if the work fails or is stopped.
    base
        Interpreter to make it from, by default the best of `base_interpreters`.
    package
        What pip shall install: a name, or the path of a clone or a wheel.
    report
        Called with the share done and a line of text.
    cancelled
        Asked ten times a second whether to stop.

    Raises
    ------
    EngineError
        Saying which step failed and with what words.
    EngineCancelledError
        If asked to stop.
    """
    base = base or next(iter(base_interpreters()), None)
    if base is None:
        raise EngineError(
            "No Python from {}.{} to {}.{} was found. Install one, or choose its path here.".format(
                *RELEASES[0], RELEASES[1][0], RELEASES[1][1] - 1
            )
        )
    if folder.exists() and not (folder / "pyvenv.cfg").is_file():
        raise EngineError(f"The folder {folder} holds something else than an environment; move it away first.")
    forget()
    try:
        shutil.rmtree(folder, ignore_errors=True)
        report(0.0, f"Making an environment with {base}")
        _step("making the environment", [str(base), "-I", "-m", "venv", str(folder)], lambda _: None, cancelled)
        python = interpreter_in(folder)
        if python is None:
            raise EngineError(f"{base} made no environment in {folder}.")
        lines = 0

        def said(line: str) -> None:
            nonlocal lines
            lines += 1
            report(_SHARE_OF_VENV + (0.95 - _SHARE_OF_VENV) * lines / (lines + _EXPECTED_LINES / 3), line)

        _step(
            "installing",
            [
                str(python),
                "-I",
                "-u",
                "-X",
                "utf8",
                "-m",
                "pip",
                "install",
                "--no-input",
                "--disable-pip-version-check",
                "--progress-bar",
                "off",
                package,
            ],
            said,
            cancelled,
        )
        report(0.95, "Starting the engine")
        version = handshake(command_of(str(python)))
    except EngineMissingError as error:
        shutil.rmtree(folder, ignore_errors=True)
        raise EngineError(f"The engine was installed, but {error}.") from error
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    finally:
        forget()
    report(1.0, f"firebreak_gis {version} is ready")
    return version


def _releases() -> list[tuple[int, int]]:
    (major, low), (_, high) = RELEASES
    return [(major, minor) for minor in range(high - 1, low - 1, -1)]


def _release(python: Path) -> tuple[int, int]:
    """Return major and minor release of an interpreter, (0, 0) if it does not answer."""
    if python == Path(sys.executable):
        return sys.version_info[0], sys.version_info[1]
    try:
        answer = subprocess.run(  # nosec B603 # argument list, no shell, interpreters found on the PATH
            [str(python), "-I", "--version"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            timeout=10,
            check=False,
            **start_options(),
        )
    except (OSError, subprocess.TimeoutExpired):
        return 0, 0
    found = re.match(rb"Python (\d+)\.(\d+)", answer.stdout)
    return (int(found.group(1)), int(found.group(2))) if found else (0, 0)


def _step(what: str, command: Sequence[str], said: Callable[[str], None], cancelled: Callable[[], bool]) -> None:
    options: dict[str, Any] = start_options()
    if os.name != "nt":
        options["start_new_session"] = True  # pip starts processes of its own; all are ended together
    try:
        process = subprocess.Popen(  # nosec B603 # argument list, no shell, interpreter chosen by the user
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
        )
    except OSError as error:
        raise EngineError(f"Failed at {what}: {error}") from error
    lines: queue.Queue[str | None] = queue.Queue()
    threading.Thread(target=_read, args=(process.stdout, lines), daemon=True).start()
    last: deque[str] = deque(maxlen=12)
    while True:
        if cancelled():
            _end(process)
            raise EngineCancelledError("Stopped as asked; nothing was installed.")
        try:
            line = lines.get(timeout=_POLL)
        except queue.Empty:
            continue
        if line is None:
            break
        last.append(line)
        said(line)
    if process.wait() != 0:
        raise EngineError(f"Failed at {what}:\n" + "\n".join(last))


def _read(stream: Any, lines: queue.Queue[str | None]) -> None:
    with stream:
        for line in stream:
            text = line.decode("utf-8", "replace").strip()
            if text:
                lines.put(text)
    lines.put(None)


def _end(process: subprocess.Popen[bytes]) -> None:
    import signal

    if os.name == "nt":
        process.kill()
    else:
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
