"""Where the engine is, and whether it is one that this plugin can drive."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess  # nosec B404 # the engine is a program of its own
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from .environment import interpreter_in, own_interpreter, start_options
from .errors import EngineMissingError

#: Oldest release of firebreak_gis whose commands the forms of this plugin fit.
OLDEST = "0.2.0"
#: Names a Python with firebreak_gis, or the `firebreak` program, for one run; wins over the setting.
VARIABLE = "FIREBREAK_PYTHON"

_PATIENCE = 60.0  # seconds that a first start on a slow disk may take
_PYTHON_OPTIONS = ("-I", "-u", "-X", "utf8", "-m", "firebreak_gis")
_HOW_TO = (
    "Open Settings > Options > Firebreak and press 'Make engine', or install it yourself "
    "(pip install firebreak_gis, Python 3.11 or later) and choose its Python there."
)


@dataclass(frozen=True)
class Engine:
    """An engine that answered.

    Parameters
    ----------
    command
        Program and arguments before the name of a command.
    version
        Release of firebreak_gis.
    origin
        How it was found, for the user.
    """

    command: tuple[str, ...]
    version: str
    origin: str


@dataclass(frozen=True)
class Places:
    """Where to look.

    Parameters
    ----------
    setting
        The path in the plugin's settings, empty for none.
    made
        Folder of the environment that the plugin makes.
    environment
        Variables, those of the process by default.
    """

    setting: str = ""
    made: Path | None = None
    environment: Mapping[str, str] | None = None


def candidates(places: Places) -> list[tuple[str, tuple[str, ...]]]:
    """Return (origin, command) of every place that holds something, in the order of the look-up.

    A place that the user names shuts out all others, so that a mistake in it is told and not passed over.
    """
    variables = os.environ if places.environment is None else places.environment
    named = {f"the variable {VARIABLE}": variables.get(VARIABLE, ""), "the settings": places.setting}
    for origin, path in named.items():
        if path.strip():
            return [(origin, command_of(path.strip()))]
    found = []
    made = interpreter_in(places.made) if places.made is not None else None
    if made is not None:
        found.append(("the engine made by the plugin", command_of(str(made))))
    on_path = shutil.which("firebreak", path=variables.get("PATH"))
    if on_path:
        found.append(("firebreak on the PATH", command_of(on_path)))
    own = own_interpreter()
    if own is not None and (Path(sys.prefix) / "conda-meta").is_dir():
        found.append(("the conda environment of QGIS", command_of(str(own))))
    return found


def command_of(path: str) -> tuple[str, ...]:
    """Turn a path, of a Python, of an environment or of the `firebreak` program, into a command."""
    place = Path(path).expanduser()
    if place.is_dir():
        place = interpreter_in(place) or place
    if place.stem.lower() == "firebreak":
        return (str(place),)
    return (str(place), *_PYTHON_OPTIONS)


_answers: dict[tuple[str, ...], tuple[float, Engine]] = {}


def find_engine(places: Places) -> Engine:
    """Return the first engine that answers and is not too old.

    Raises
    ------
    EngineMissingError
        Saying what was found where, what was wrong with it, and what to do.
    """
    problems = []
    for origin, command in candidates(places):
        try:
            return _checked(origin, command)
        except EngineMissingError as error:
            problems.append(f"{origin} ({command[0]}): {error}")
    if problems:
        raise EngineMissingError(f"The engine firebreak_gis cannot be used. {'; '.join(problems)}. {_HOW_TO}")
    raise EngineMissingError("The engine firebreak_gis is not installed. " + _HOW_TO)


def forget() -> None:
    """Ask again at the next look-up, because something was installed or removed."""
    _answers.clear()


def _checked(origin: str, command: tuple[str, ...]) -> Engine:
    try:
        stamp = Path(command[0]).stat().st_mtime
    except OSError:
        raise EngineMissingError("there is no such file") from None
    if Path(command[0]).is_dir():
        raise EngineMissingError("there is no Python in this folder")
    known = _answers.get(command)
    if known and known[0] == stamp:
        return known[1]
    engine = Engine(command, handshake(command), origin)
    _answers[command] = (stamp, engine)
    return engine


def handshake(command: tuple[str, ...]) -> str:
    """Ask for the version.

    Raises
    ------
    EngineMissingError
        If the program does not start, is not firebreak_gis, or is older than `OLDEST`.
    """
    try:
        answer = subprocess.run(  # nosec B603 # argument list, no shell, program chosen by the user
            [*command, "--version", "--json"],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=_PATIENCE,
            cwd=tempfile.gettempdir(),
            check=False,
            **start_options(),
        )
    except subprocess.TimeoutExpired:
        raise EngineMissingError(f"it did not answer within {_PATIENCE:.0f} seconds") from None
    except OSError as error:
        raise EngineMissingError(f"it does not start ({error.strerror or error})") from None
    complaint = answer.stderr.decode("utf-8", "replace").strip()
    if answer.returncode != 0:
        if "No module named firebreak_gis" in complaint:
            raise EngineMissingError("this Python has no firebreak_gis")
        last = complaint.splitlines()[-1] if complaint else "no message"
        raise EngineMissingError(f"it is broken (exit code {answer.returncode}: {last})")
    try:
        told = json.loads(answer.stdout.decode("utf-8", "replace"))
        software, version = told["software"], str(told["version"])
    except (ValueError, KeyError, TypeError):
        raise EngineMissingError("it is not firebreak_gis") from None
    if software != "firebreak_gis":
        raise EngineMissingError("it is not firebreak_gis")
    if _numbers(version) < _numbers(OLDEST):
        raise EngineMissingError(f"its version {version} is too old, at least {OLDEST} is needed")
    return version


def _numbers(version: str) -> tuple[int, ...]:
    """Return major, minor and patch of a version such as 1.2.0rc1."""
    found = re.match(r"(\d+)(?:\.(\d+))?(?:\.(\d+))?", version)
    return tuple(int(word or 0) for word in found.groups()) if found else (0, 0, 0)
