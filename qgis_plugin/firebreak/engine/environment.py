"""What a started engine sees of the process that starts it: as little as possible."""

from __future__ import annotations

import os
import subprocess  # nosec B404 # the engine is a program of its own
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import quote

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


def proxy_address(*, enabled: str, kind: str, host: str, port: str, user: str = "", password: str = "") -> str:
    """Return the address of a proxy from the settings of QGIS, as pip takes it; empty if none is in use.

    A proxy of the system (`DefaultProxy`) is left to pip, which asks the system by itself.
    """
    if enabled.lower() not in ("true", "1") or not host or kind in ("DefaultProxy", "NoProxy"):
        return ""
    scheme = "socks5" if kind == "Socks5Proxy" else "http"
    who = quote(user, safe="") + (f":{quote(password, safe='')}" if password else "") + "@" if user else ""
    return f"{scheme}://{who}{host}" + (f":{port}" if port not in ("", "0") else "")
