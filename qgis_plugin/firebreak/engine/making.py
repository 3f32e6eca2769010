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
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
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
    proxy: str = "",
    report: Report,
    cancelled: Callable[[], bool],
) -> str:
    """Make a virtual environment with the engine and return the engine's version.

    The new environment is made beside the old one and takes its place when its engine has answered; until then, and if
    the work fails or is stopped, the old one stays as it is.

    Parameters
    ----------
    folder
        Of the environment.
    base
        Interpreter to make it from, by default the best of `base_interpreters`.
    package
        What pip shall install: a name, or the path of a clone or a wheel.
    proxy
        Address of the proxy through which pip reaches the index; empty for none but that of the variables.
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
    origin = origin_of(package)
    new, old = (folder.with_name(folder.name + ending) for ending in (".new", ".old"))
    for place in (folder, new, old):
        if place.exists() and not (place / "pyvenv.cfg").is_file():
            raise EngineError(f"The folder {place} holds something else than an environment; move it away first.")
    if old.exists() and not folder.exists():
        old.rename(folder)  # an earlier run was killed between its two renames
    forget()
    try:
        for place in (new, old):
            shutil.rmtree(place, ignore_errors=True)
        report(0.0, f"Making an environment with {base}")
        _step("making the environment", [str(base), "-I", "-m", "venv", str(new)], lambda _: None, cancelled)
        python = interpreter_in(new)
        if python is None:
            raise EngineError(f"{base} made no environment in {new}.")
        through = f" through the proxy {_without_password(proxy)}" if proxy else ""
        report(
            _SHARE_OF_VENV, f"Installing firebreak_gis from {origin}, and what it needs from the package index{through}"
        )
        _install(python, package, proxy, report, cancelled)
        report(0.95, "Starting the engine")
        handshake(command_of(str(python)))
        _swap(new, folder, old)
        try:
            version = handshake(command_of(str(interpreter_in(folder) or folder)))
        except EngineMissingError:
            _swap(old, folder, new)
            raise
        shutil.rmtree(old, ignore_errors=True)
    except EngineMissingError as error:
        raise EngineError(f"The engine was installed, but {error}.") from error
    finally:
        shutil.rmtree(new, ignore_errors=True)
        forget()
    report(1.0, f"firebreak_gis {version} is ready")
    return version


def origin_of(package: str) -> str:
    """Say where a package comes from: a wheel, a folder, or the index.

    Raises
    ------
    EngineError
        If it is the path of something that is not there.
    """
    is_path = any(mark in package for mark in ("/", "\\", ".whl", ".zip", ".tar")) or package.startswith(".")
    if "://" in package:
        return f"the address {_without_password(package)}"
    if not is_path:  # to pip too, whatever lies in the working folder
        return f"the package index ({package})"
    place = Path(package).expanduser()
    if place.is_dir():
        return f"the folder {place}"
    if place.is_file():
        return f"the file {place}"
    raise EngineError(f"Failed at installing: there is no file or folder {package}.")


def _install(python: Path, package: str, proxy: str, report: Report, cancelled: Callable[[], bool]) -> None:
    lines = 0

    def said(line: str) -> None:
        nonlocal lines
        lines += 1
        report(_SHARE_OF_VENV + (0.95 - _SHARE_OF_VENV) * lines / (lines + _EXPECTED_LINES / 3), line)

    words = ["install", "--no-input", "--disable-pip-version-check", "--progress-bar", "off", package]
    command = [str(python), "-I", "-u", "-X", "utf8", "-m", "pip", *words]
    # Not on the command line, which every user of the machine can read.
    _step("installing", command, said, cancelled, {"PIP_PROXY": proxy} if proxy else {})


def _swap(new: Path, folder: Path, old: Path) -> None:
    """Put an environment in the place of another, which is kept as `old`."""
    try:
        if folder.exists():
            folder.rename(old)
        try:
            new.rename(folder)
        except OSError:
            if old.exists():
                old.rename(folder)
            raise
    except OSError as error:
        raise EngineError(
            f"The new engine could not take the place of the old one ({error.strerror or error}); is the old one at "
            "work? It was left as it is."
        ) from error
    _tell_its_place(folder, new)


def _tell_its_place(folder: Path, before: Path) -> None:
    """Mend the paths in the scripts of an environment that was moved; its Python finds itself."""
    for script in [folder / "pyvenv.cfg", *folder.glob("bin/*")]:
        if script.is_file() and not script.is_symlink():
            content = script.read_bytes()
            if b"\0" not in content and os.fsencode(before) in content:
                script.write_bytes(content.replace(os.fsencode(before), os.fsencode(folder)))


def _without_password(address: str) -> str:
    return re.sub(r"//[^/@]*@", "//", address)


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


def _step(
    what: str,
    command: Sequence[str],
    said: Callable[[str], None],
    cancelled: Callable[[], bool],
    variables: Mapping[str, str] = MappingProxyType({}),
) -> None:
    options: dict[str, Any] = start_options()
    options["env"] = {**options["env"], **variables}
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
