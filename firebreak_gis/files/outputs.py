"""What a command writes, as one table: names, labels and writers.

The check before the work, `--dry-run`, `firebreak describe` (and so QGIS) and the writing all follow from the table. To
add an output, add an `Output` to it, before the account of the run, which comes last.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, TypeVar

from firebreak_gis.errors import OutputError
from firebreak_gis.files import make_folder, remove_file, require_writable, together
from firebreak_gis.progress import Progress, part

Q = TypeVar("Q")
R = TypeVar("R")


@dataclass(frozen=True)
class Writing:
    """How the files of one run are written.

    Parameters
    ----------
    overwrite
        Whether existing files may be replaced.
    inputs
        Files that went in, for the account.
    forbid
        Files that are never overwritten: those, and what they are made of.
    creation_options
        More options of GDAL's COG driver.
    parameters
        What was asked, for the account.
    tags
        Provenance of rasters.
    written
        Files written so far.
    entries
        What the account says of the inputs, once they were looked at.
    """

    overwrite: bool = False
    inputs: Sequence[str | os.PathLike[str]] = ()
    forbid: Sequence[str | os.PathLike[str]] = ()
    creation_options: Mapping[str, Any] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)
    tags: Mapping[str, str] = field(default_factory=dict)
    written: list[Path] = field(default_factory=list)
    entries: list[dict[str, Any]] = field(default_factory=list)


@dataclass(frozen=True)
class Output(Generic[R]):
    """One file in the output folder of a command.

    Parameters
    ----------
    name
        Of the file.
    label
        For people.
    write
        Called with the result, the path and how to write.
    needs
        Variable of the landscape without which the file is not written; a file of that name that an earlier run left
        is removed.
    main
        Whether it is shown among the first.
    """

    name: str
    label: str
    write: Callable[[R, Path, Writing], object]
    needs: str = ""
    main: bool = False

    def of(self, part_of: Callable[[Q], R]) -> Output[Q]:
        """The same file of a larger result, of which `part_of` takes what is written."""
        return Output(
            self.name,
            self.label,
            lambda result, path, how: self.write(part_of(result), path, how),
            self.needs,
            self.main,
        )


def names(table: Iterable[Output[Any]], variables: Container[Any] | None = None) -> tuple[str, ...]:
    """Names of the files; with `variables`, those of a landscape that has these."""
    return tuple(o.name for o in table if variables is None or not o.needs or o.needs in variables)


def labels(table: Iterable[Output[Any]]) -> dict[str, str]:
    """Labels by name, those that are shown first in front."""
    return {o.name: o.label for o in sorted(table, key=lambda o: not o.main)}


def require_all(table: Iterable[Output[Any]], folder: str | os.PathLike[str], how: Writing) -> None:
    """Refuse, before the work, what must not be written into a folder that is there.

    Raises
    ------
    OutputError
        As `files.require_writable`, for every file that the table may hold or remove.
    """
    for output in table:
        require_writable(Path(folder) / output.name, overwrite=how.overwrite, forbid=how.forbid)


def write_all(
    table: Sequence[Output[R]],
    result: R,
    folder: str | os.PathLike[str],
    how: Writing,
    *,
    variables: Container[Any] = (),
    progress: Progress | None = None,
) -> list[Path]:
    """Write the files of a table: all of them appear together, or none.

    Parameters
    ----------
    table
        The account of the run last.
    result
        What the writers take.
    folder
        Made if it does not exist.
    how
        How to write.
    variables
        Those of the landscape.
    progress
        Callback (share done, message).

    Returns
    -------
    list of Path
        The files, in the order of the table.

    Raises
    ------
    OutputError
        If a file exists and must not be replaced, or cannot be written; checked for all before the first is written.
    """
    report = part(progress, 0.0, 1.0, "write ")
    present = set(names(table, variables))
    with together(make_folder(folder), alone=True):
        place = Path(folder)
        for output in table:
            path = place / output.name
            if output.name in present:
                require_writable(path, overwrite=how.overwrite, forbid=how.forbid)
            elif path.exists():
                _remove(path, how)
        for i, output in enumerate(o for o in table if o.name in present):
            report(i / len(present), output.name)
            output.write(result, place / output.name, how)
            how.written.append(place / output.name)
        # The last look at a stop: once the files are in place the run is done.
        report(1.0, "done")
    return how.written


def _remove(old: Path, how: Writing) -> None:
    """A file of an earlier run would be taken for one of this."""
    if not how.overwrite:
        raise OutputError(
            f"{old} belongs to another landscape; choose another folder or allow overwriting (--overwrite)"
        )
    require_writable(old, overwrite=True, forbid=how.forbid)
    remove_file(old)
