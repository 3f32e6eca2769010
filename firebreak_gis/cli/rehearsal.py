"""What a command needs and will do, told before anything is read or written; the whole of it with --dry-run."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis import memory, plugins
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import InputError, OutputError
from firebreak_gis.files.gate import stands
from firebreak_gis.files.scratch import standing_folder
from firebreak_gis.rasters import file_of, files_behind

if TYPE_CHECKING:
    from firebreak_gis.files.outputs import Output, Writing
    from firebreak_gis.files.request import OutputRequest
    from firebreak_gis.landscape import Survey
    from firebreak_gis.landscape.request import LandscapeRequest
    from firebreak_gis.planning.request import PlanRequest

#: Bytes a cell that the layers and all rasters of a plan take on the disk uncompressed, overviews included.
_LAYER_BYTES, _PLAN_BYTES = 8, 32
#: Tables, styles, vectors and the picture.
_OTHER_BYTES = 4_000_000
#: Rasters of real landscapes shrink to a third or less.
_COMPRESSION = 4


@dataclass(frozen=True)
class Foreseen:
    """What is known of a run before any value is read.

    Parameters
    ----------
    survey
        Layers, legends and grid.
    memory, memory_limit, disk, disk_free
        Bytes needed and there.
    files
        Paths that will be written.
    """

    survey: Survey
    memory: int
    memory_limit: int
    disk: int
    disk_free: int
    files: tuple[str, ...]

    def told(self) -> dict[str, Any]:
        """All of it as plain data."""
        rows, cols = self.survey.grid.shape
        return {
            "grid": self.survey.grid.describe(),
            "cells": rows * cols,
            "legend": self.survey.legend.name,
            "alignment": self.survey.account.alignment,
            "warnings": self.survey.account.warnings,
            "memory_bytes": self.memory,
            "memory_limit_bytes": self.memory_limit,
            "disk_bytes": self.disk,
            "disk_free_bytes": self.disk_free,
            "files": list(self.files),
        }


def foresee(
    layers: LandscapeRequest,
    output: OutputRequest,
    session: Session,
    table: Sequence[Output[Any]],
    *,
    method: str | None = None,
    clock: bool = False,
    away: bool = False,
) -> Foreseen:
    """Resolve the grid from the headers; refuse what will fit neither into memory nor on the disk.

    Parameters
    ----------
    layers, output
        What `align` or `plan` is asked.
    session
        Gets a warning where the disk may not suffice.
    table
        What is written into the output folder.
    method
        Ranking of a plan; None if layers are only aligned.
    clock
        Whether its fires need travel times.
    away
        Whether its networks lie on the disk where the map is large, see `setting.away`.

    Raises
    ------
    InputError, ParameterError
        As `landscape.survey`.
    ResourceError
        If it does not fit into memory.
    OutputError
        If it does not fit on the disk.
    """
    from firebreak_gis.files.outputs import names
    from firebreak_gis.landscape import survey

    found = survey(layers)
    rows, cols = found.grid.shape
    workers = click.get_current_context().params.get("workers")
    needed = memory.bytes_for("align", 0) + (found.memory_by_parts if method is None else found.memory)
    if method is None and found.by_parts:
        needed *= 1 + (workers or 0)  # each reads a part
    if method is not None:
        about: dict[str, Any] = {"method": method, "clock": clock, "workers": workers, "blocks": away}
        needed = max(needed, memory.bytes_for("plan", rows * cols, **about))
    what = f"a landscape of {rows} x {cols} cells" if method is None else f"a plan of {rows} x {cols} cells by {method}"
    memory.require_memory(needed, what, max_memory=layers.max_memory)
    memory.suit(needed, max_memory=layers.max_memory)
    size = (_LAYER_BYTES if method is None else _PLAN_BYTES) * rows * cols + _OTHER_BYTES
    scratch = _LAYER_BYTES * rows * cols if method is None and found.by_parts else 0
    return Foreseen(
        found,
        needed,
        memory.allowed(layers.max_memory),
        size + scratch,
        _require_disk(Path(output.output), size, scratch, session),
        tuple(str(Path(output.output) / name) for name in names(table, found.variables)),
    )


def rehearse(foreseen: Foreseen, session: Session) -> None:
    """Show what --dry-run found out; nothing is written."""
    account = foreseen.survey.account
    for sentence in account.alignment:
        session.say(sentence)
    for sentence in account.warnings:
        session.warn(sentence)
    lines = [
        f"grid    {foreseen.survey.grid.describe()}",
        f"memory  about {memory.size(foreseen.memory)} of {memory.size(foreseen.memory_limit)} allowed",
        f"disk    at most {memory.size(foreseen.disk)} of {memory.size(foreseen.disk_free)} free",
        *(f"writes  {path}" for path in foreseen.files),
        "Nothing was read but headers, and nothing was written.",
    ]
    session.finish(foreseen.told(), "\n".join(lines))


def require_possible(request: PlanRequest) -> None:
    """Refuse parameters of a plan that cannot be, before hours of work.

    Raises
    ------
    ParameterError
        Naming the parameter.
    InputError
        If a file that an option names does not exist.
    """
    from firebreak_gis.network import checked_residual
    from firebreak_gis.planning.judging import judging

    checked_residual(request.fires.leak)
    if request.design.amount.unit == "share":
        request.design.amount.require()
    plugins.build_params(plugins.load("ranking", request.design.method), request.design.method_params)
    request.siting.require()
    request.spread.require()
    request.require()
    request.weather.read()
    judging(request.fires, timed=True, timeless=request.timeless)
    named = {"ignitions": request.fires.ignitions, **request.stakes.layers}
    for option, name in named.items():
        if name and not stands(file_of(name)):
            folder = Path(name).absolute().parent
            raise InputError(f"--{option} {name} does not exist; check the name and the folder {folder}")


def require_outputs(output: OutputRequest, table: Sequence[Output[Any]], inputs: Sequence[str]) -> Writing:
    """Refuse outputs that must not be written, without making their folder; return how to write them.

    Raises
    ------
    OutputError
        As `files.require_writable`.
    """
    from firebreak_gis.cli.requests import recorded
    from firebreak_gis.files import require_writable
    from firebreak_gis.files.outputs import Writing, require_all

    folder = Path(output.output)
    how = Writing(output.overwrite, inputs, files_behind(inputs), output.creation_options, recorded())
    if folder.is_dir():
        require_all(table, folder, how)
    else:  # the nearest folder that there is must take a new one
        require_writable(Path(standing_folder(folder)) / f"{folder.name}.new", forbid=how.forbid)
    return how


def _require_disk(folder: Path, size: int, scratch: int, session: Session) -> int:
    """Bytes that are free where `folder` is or will be; outputs shrink, what is kept while the work lasts does not."""
    free = shutil.disk_usage(standing_folder(folder)).free
    told = f"the disk of {folder} has {memory.size(free)} free"
    least, most = scratch + size / _COMPRESSION, scratch + size
    if free < least:
        raise OutputError(f"{told}, the work takes {memory.size(least)} or more; free some space")
    if free < most:
        session.warn(f"{told}, the work takes up to {memory.size(most)}")
    return free
