"""What a started engine sees of the process that starts it: as little as possible."""

from __future__ import annotations

import os
import subprocess  # nosec B404 # the engine is a program of its own
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

#: Variables of QGIS' own Python, GDAL and PROJ, which would break those of the engine.
FOREIGN = ("PYTHON", "PROJ_", "GDAL_")


def stripped(environment: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the environment without the variables of `FOREIGN`, text encoded as UTF-8."""
    source = os.environ if environment is None else environment
    result = {name: value for name, value in source.items() if not name.upper().startswith(FOREIGN)}
    result.update(PYTHONUTF8="1", PYTHONUNBUFFERED="1")  # for a `firebreak` script; `python -I` reads neither
    return result


def start_options() -> dict[str, Any]:
    """Return the options of every process started here: own environment, no shell, no window."""
    options: dict[str, Any] = {"env": stripped(), "shell": False, "close_fds": True}
    if os.name == "nt":
        options["creationflags"] = getattr(subprocess, "CREATE_NO_WINDOW", 0)
    return options


def interpreter_in(folder: Path) -> Path | None:
    """Return the Python of an environment folder (venv or conda, any system), None if there is none."""
    for name in ("bin/python3", "bin/python", "Scripts/python.exe", "python.exe"):
        if (folder / name).is_file():
            return folder / name
    return None


def own_interpreter() -> Path | None:
    """Return the interpreter that belongs to this process, which itself may be QGIS and no interpreter."""
    executable = Path(sys.executable or "")
    if executable.name.lower().startswith("python") and executable.is_file():
        return executable
    return interpreter_in(Path(sys.prefix)) or interpreter_in(Path(sys.base_prefix))
