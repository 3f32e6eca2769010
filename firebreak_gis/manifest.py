"""The account of a run, `run.json`: what went in, what was done, what came out. It is a valid `--config`."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from firebreak_gis import __version__
from firebreak_gis.errors import InputError, OutputError, ParameterError
from firebreak_gis.files import sha256, write_text
from firebreak_gis.files.outputs import Output, Writing

SOFTWARE = "firebreak_gis"

R = TypeVar("R")


def provenance(parameters: Mapping[str, Any], *, seed: int | None = None) -> dict[str, str]:
    """Tags that tell which program and parameters made a file; the same for equal runs."""
    text = json.dumps(plain(parameters), sort_keys=True)
    tags = {
        "software": SOFTWARE,
        "version": __version__,
        "parameters_sha256": hashlib.sha256(text.encode()).hexdigest()[:16],
    }
    if seed is not None:
        tags["seed"] = str(seed)
    return tags


def told(command: str, how: Writing, account: Mapping[str, Any]) -> dict[str, Any]:
    """What `run.json` will hold but for the outputs, for a report that is written before it.

    Parameters
    ----------
    command
        Name of the command.
    how
        How the run writes; the inputs are looked at once.
    account
        More to keep: grid, alignment, warnings, results.
    """
    return {
        "software": SOFTWARE,
        "version": __version__,
        "command": command,
        "parameters": plain(how.parameters),
        "inputs": _inputs(how),
        **plain(account),
    }


def _inputs(how: Writing) -> list[dict[str, Any]]:
    """Entries of the inputs, made once a run: hashing large rasters takes its time."""
    if not how.entries:
        how.entries.extend(_input(path) for path in how.inputs)
    return how.entries


def account(command: str, tell: Callable[[R], Mapping[str, Any]]) -> Output[R]:
    """The last output of every table: `run.json`.

    Parameters
    ----------
    command
        Name of the command.
    tell
        What to keep of a result, see `told`.
    """

    def write(result: R, path: Path, how: Writing) -> None:
        document = told(command, how, tell(result))
        document["outputs"] = [_output(name, path.parent) for name in how.written]
        write_text(path, json.dumps(document, indent=2, ensure_ascii=False) + "\n", overwrite=how.overwrite)

    return Output("run.json", "Account of the run", write)


def _output(path: str | os.PathLike[str], folder: Path) -> dict[str, str]:
    try:
        return {"path": Path(os.path.relpath(path, folder)).as_posix(), "sha256": sha256(path)}
    except InputError as error:
        raise OutputError(f"the output {path} cannot be read back: {error}") from error


def _input(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Path and hash of an input; of a raster also its CRS and grid."""
    from firebreak_gis.grid import crs_name
    from firebreak_gis.rasters import read_header
    from firebreak_gis.vectors import is_vector

    entry: dict[str, Any] = {"path": str(path), "sha256": sha256(path)}
    if is_vector(path):
        return entry
    try:
        header = read_header(path)
    except InputError:
        # Several bands, or no layer at all: the hash must do.
        return entry
    entry["crs"] = None if header.crs is None else crs_name(header.crs)
    entry["shape"] = list(header.shape)
    entry["transform"] = list(header.transform)[:6]
    return entry


#: What a configuration says of itself that any command takes: `for = "every command"`.
SHARED = "every command"


def read_config(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read parameters from a TOML file, or from a JSON file such as a `run.json`.

    Raises
    ------
    ParameterError
        If the file cannot be read or holds no parameters.
    """
    document = _read_document(path)
    parameters = document.get("parameters", document)
    if not isinstance(parameters, dict):
        raise ParameterError(f"'parameters' in {path} is not a table")
    return parameters


def read_account(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read the `run.json` of an earlier run.

    Raises
    ------
    InputError
        If there is none, or it is no account of a run of this program.
    """
    try:
        document = _read_document(path)
    except ParameterError as error:
        raise InputError(f"{path} cannot be read as the account of a run: {error}") from error
    if document.get("software") != SOFTWARE or "command" not in document:
        raise InputError(f"{path} is not the account of a run of {SOFTWARE}")
    return document


def is_shared_config(path: str | os.PathLike[str]) -> bool:
    """Whether a configuration is meant for every command, each of which takes what it knows (as `calibrate` writes)."""
    return _read_document(path).get("for") == SHARED


def _read_document(path: str | os.PathLike[str]) -> dict[str, Any]:
    import tomllib

    source = Path(path)
    try:
        text = source.read_text(encoding="utf-8")
        document = json.loads(text) if source.suffix.lower() == ".json" else tomllib.loads(text)
    except (OSError, UnicodeDecodeError, json.JSONDecodeError, tomllib.TOMLDecodeError) as error:
        raise ParameterError(f"cannot read the configuration {source}: {error}") from error
    if not isinstance(document, dict):
        raise ParameterError(f"the configuration {source} holds no table of parameters")
    return document


def plain(value: Any) -> Any:
    """Turn paths, numpy numbers and tuples into JSON types; a raster is named by its content."""
    if isinstance(value, Mapping):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "item") and getattr(value, "size", 1) == 1:
        return value.item()
    if hasattr(value, "to_numpy") or hasattr(value, "tobytes"):
        array = value.to_numpy() if hasattr(value, "to_numpy") else value
        digest = hashlib.sha256(array.tobytes()).hexdigest()[:16]
        return f"array {' x '.join(str(n) for n in array.shape)}, sha256 {digest}"
    return value
