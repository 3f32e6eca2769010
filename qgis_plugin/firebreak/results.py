"""What the engine wrote, put where the user wants it."""

from __future__ import annotations

import contextlib
import os
import shutil
from pathlib import Path
from uuid import uuid4

#: Vector formats that can be chosen, by the ending of the name; the engine writes the first, QGIS turns it into others.
VECTOR_FORMATS = ("gpkg", "geojson", "fgb", "shp")


class DestinationError(OSError):
    """A destination cannot be written; the text is meant for the user."""


def deliver(file: Path, destination: Path) -> None:
    """Copy a file, and the style beside it if it is a raster, to their destination; whole or not at all.

    Raises
    ------
    DestinationError
        If the destination cannot be written; what stood there is intact.
    """
    _place(file, destination)
    style = file.with_suffix(".qml")
    if file.suffix == ".tif" and style.is_file():
        _place(style, destination.with_suffix(".qml"))


def deliver_folder(folder: Path, destination: Path) -> None:
    """Copy all files of a folder, each whole or not at all.

    Raises
    ------
    DestinationError
        If one of them cannot be written.
    """
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        _place(file, destination / file.relative_to(folder))


def refuse_inputs(destinations: dict[str, str], inputs: list[str]) -> None:
    """Refuse destinations that are inputs, hold inputs, or are the same file twice.

    Raises
    ------
    DestinationError
        Naming the destination.
    """
    taken = {_identity(path): "an input" for path in inputs}
    for name, path in destinations.items():
        other = taken.get(_identity(path))
        if other:
            raise DestinationError(f"{name} would overwrite {other}: {path}. Choose another file.")
        taken[_identity(path)] = name
        held = [one for one in inputs if Path(_identity(one)).parent == Path(_identity(path))]
        if held:
            raise DestinationError(f"{name} is the folder of an input, {held[0]}. Choose another folder.")


def refuse_formats(destinations: dict[str, str], files: dict[str, str]) -> None:
    """Refuse destinations whose names say another format than the engine writes.

    Parameters
    ----------
    destinations
        Path by name of the output.
    files
        File that the engine makes, by name of the output.

    Raises
    ------
    DestinationError
        Naming the destination and the ending that it needs.
    """
    for name, path in destinations.items():
        ending = Path(files[name]).suffix
        given = Path(path).suffix.lower()
        converted = ending == ".gpkg" and given[1:] in VECTOR_FORMATS
        if ending and given != ending and not converted and (given, ending) != (".tiff", ".tif"):
            raise DestinationError(
                f"{name} is written as {ending}, but {Path(path).name} says another format. Let its name end in "
                f"{ending}, and export the layer to the other format afterwards."
            )


def _identity(path: str) -> str:
    return os.path.normcase(os.path.realpath(path))


def _place(file: Path, destination: Path) -> None:
    part = destination.with_name(f".{destination.stem[:40]}-{uuid4().hex}.part")
    try:
        destination.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, part)
        part.replace(destination)
    except OSError as error:
        with contextlib.suppress(OSError):
            part.unlink()
        reason = error.strerror or error
        raise DestinationError(
            f"{destination} cannot be written ({reason}). If it is open somewhere, close it there first."
        ) from error
