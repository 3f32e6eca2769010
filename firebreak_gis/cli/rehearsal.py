"""What a command needs and will do, told before anything is read or written; the whole of it with --dry-run."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

from firebreak_gis import memory, plugins
from firebreak_gis.cli import parsing
from firebreak_gis.cli.layers import LAYERS, WEATHER, grid_options, weather
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import InputError, OutputError, ParameterError
from firebreak_gis.rasters import file_of, files_behind

#: Bytes a cell that the layers and all rasters of a plan take on the disk uncompressed, overviews included.
_LAYER_BYTES, _PLAN_BYTES = 8, 32
#: Tables, styles, vectors and the picture.
_OTHER_BYTES = 4_000_000
#: Rasters of real landscapes shrink to a third or less.
_COMPRESSION = 4


def foresee(
    given: Mapping[str, Any], session: Session, outputs: Sequence[str], *, method: str | None = None
) -> dict[str, Any]:
    """Resolve the grid from the headers; refuse what will fit neither into memory nor on the disk.

    Parameters
    ----------
    given
        Options of `align` or `plan`.
    session
        Gets a warning where the disk may not suffice.
    outputs
        Names of the files in the output folder.
    method
        Ranking of a plan; None if layers are only aligned.

    Returns
    -------
    dict
        What --dry-run shows.

    Raises
    ------
    InputError, ParameterError
        As `landscape.survey`.
    ResourceError
        If it does not fit into memory.
    OutputError
        If it does not fit on the disk.
    """
    from firebreak_gis.landscape import survey

    found = survey(*(given[name] for name in LAYERS), **grid_options(given))
    rows, cols = found.grid.shape
    needed = memory.bytes_for("align", 0) + found.memory
    if method is not None:
        needed = max(needed, memory.bytes_for("plan", rows * cols, method=method))
    limit = parsing.byte_size(given["max_memory"])
    what = f"a landscape of {rows} x {cols} cells" if method is None else f"a plan of {rows} x {cols} cells by {method}"
    memory.require_memory(needed, what, max_memory=limit)
    size = (_LAYER_BYTES if method is None else _PLAN_BYTES) * rows * cols + _OTHER_BYTES
    return {
        "grid": found.grid.describe(),
        "cells": rows * cols,
        "legend": found.legend.name,
        "alignment": found.account.alignment,
        "warnings": found.account.warnings,
        "memory_bytes": needed,
        "memory_limit_bytes": memory.allowed(limit),
        "disk_bytes": size,
        "disk_free_bytes": _require_disk(Path(given["output"]), size, session),
        "files": [str(Path(given["output"]) / name) for name in outputs],
    }


def rehearse(plan: Mapping[str, Any], session: Session) -> None:
    """Show what --dry-run found out; nothing is written."""
    for sentence in plan["alignment"]:
        session.say(sentence)
    for sentence in plan["warnings"]:
        session.warn(sentence)
    lines = [
        f"grid    {plan['grid']}",
        f"memory  about {memory.size(plan['memory_bytes'])} of {memory.size(plan['memory_limit_bytes'])} allowed",
        f"disk    at most {memory.size(plan['disk_bytes'])} of {memory.size(plan['disk_free_bytes'])} free",
        *(f"writes  {path}" for path in plan["files"]),
        "Nothing was read but headers, and nothing was written.",
    ]
    session.finish(plan, "\n".join(lines))


def require_possible(given: Mapping[str, Any]) -> None:
    """Refuse parameters of a plan that cannot be, before hours of work.

    Raises
    ------
    ParameterError
        Naming the parameter.
    InputError
        If a file that an option names does not exist.
    """
    from firebreak_gis.breaks import Budget
    from firebreak_gis.network import checked_residual

    parsing.checked_seed(given["seed"])
    if given["n_runs"] < 1:
        raise ParameterError(f"n_runs is {given['n_runs']}, expected a whole number of at least 1")
    checked_residual(given["residual"])
    if given["budget_unit"] == "share":
        Budget(given["budget"]).require()
    plugins.build_params(plugins.load("ranking", given["method"]), given["method_params"])
    numbers = {WEATHER[option]: value for option, value in weather(given).items() if isinstance(value, float)}
    model = plugins.load("spread", given["model"])
    known = {f.name for f in fields(model.Params)}
    plugins.build_params(model, {k: v for k, v in numbers.items() if k in known} | dict(given["model_params"]))
    for option in ("ignitions", "barriers", "protected", "allowed", "values"):
        name = given[option]
        if name and not Path(file_of(name)).exists():
            folder = Path(name).absolute().parent
            raise InputError(f"--{option} {name} does not exist; check the name and the folder {folder}")


def require_outputs(given: Mapping[str, Any], outputs: Sequence[str], inputs: Sequence[str]) -> None:
    """Refuse outputs that must not be written, without making their folder.

    Raises
    ------
    OutputError
        As `files.require_writable`.
    """
    from firebreak_gis.files import require_writable

    folder, inputs = Path(given["output"]), files_behind(inputs)
    if folder.is_dir():
        for name in outputs:
            require_writable(folder / name, overwrite=given["overwrite"], forbid=inputs)
        return
    # The nearest folder that there is must take a new one.
    require_writable(_standing(folder) / f"{folder.name}.new", forbid=inputs)


def _require_disk(folder: Path, size: int, session: Session) -> int:
    """Bytes that are free where `folder` is or will be."""
    free = shutil.disk_usage(_standing(folder)).free
    told = f"the disk of {folder} has {memory.size(free)} free"
    if free < size / _COMPRESSION:
        raise OutputError(f"{told}, the outputs take {memory.size(size / _COMPRESSION)} or more; free some space")
    if free < size:
        session.warn(f"{told}, the outputs take up to {memory.size(size)}")
    return free


def _standing(folder: Path) -> Path:
    """Return the folder, or the nearest one above it that exists."""
    place = folder.absolute()
    while not place.is_dir() and place != place.parent:
        place = place.parent
    return place
