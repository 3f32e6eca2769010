"""Opening rasters: a sentence for every file that cannot be used, and the files that a raster is made of."""

from __future__ import annotations

import contextlib
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from firebreak_gis.errors import InputError
from firebreak_gis.files.gate import (
    REMOTE_HELP,
    asked_for_network,
    is_file,
    located,
    names_in,
    offline,
    require_file,
    require_local,
)
from firebreak_gis.rasters.naming import file_of, first_bytes, gdal_name, is_markup, look_first

#: Elements of a virtual raster, as GDAL writes it, that name a raster.
_SOURCES = frozenset({"sourcefilename", "sourcedataset"})
#: How files begin that hold values and name no other file.
_TIFF = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
_UNEXPECTED = "{} is a virtual raster (VRT) under another name; name it .vrt if that is what you mean"


@contextlib.contextmanager
def open_raster(path: str | os.PathLike[str], *, remote: bool = False) -> Iterator[Any]:
    """Open a raster for reading with rasterio.

    Unless `remote`, GDAL is cut off the network for as long as it is open.

    Raises
    ------
    InputError
        If it is missing, a folder, empty, a text, remote (unless `remote`), made of what is not on this machine (unless
        `remote`), or not a raster.
    """
    from rasterio._err import CPLE_BaseError

    name = os.fspath(path)
    look_first(name, remote)
    with contextlib.nullcontext() if remote else offline(_settings):
        source = _opened(name)
        try:
            with source:
                _require_honest(source, name, remote)
                yield source
        except CPLE_BaseError as error:  # what GDAL finds only when a damaged file is looked into
            raise InputError(f"{name} is damaged: {_short(error, name)}; copy or export it again") from error


def files_behind(names: Iterable[str | os.PathLike[str]]) -> list[str]:
    """Return the files that these names speak of, and all those that they are made of, each once and as it is named.

    GDAL is asked for the parts of rasters; a text that names files, such as a virtual vector file, counts them all.
    """
    waiting, found = [file_of(os.fspath(name)) for name in names], dict[str, str]()
    while waiting:
        name = waiting.pop()
        real = os.path.realpath(name)
        if real not in found and is_file(name):
            found[real] = name
            waiting += _parts(name)
    return list(found.values())


def _parts(name: str) -> list[str]:
    """Files that a file names."""
    with contextlib.suppress(InputError, OSError):
        start = first_bytes(name)
        if start.startswith(_TIFF):
            return []
        with contextlib.suppress(InputError), offline(_settings), _opened(name) as source:
            texts = [*source.files, *names_in(source.tags(ns="xml:VRT").get("xml:VRT", "<none/>"))]
            return [located(file_of(text), Path(name).parent) for text in texts]
        if is_markup(start):
            texts = names_in(Path(name).read_text(encoding="utf-8", errors="replace"))
            return [located(file_of(text), Path(name).parent) for text in texts]
    return []


def _opened(name: str) -> Any:
    import rasterio
    from rasterio.errors import NotGeoreferencedWarning, RasterioError

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        try:
            return rasterio.open(gdal_name(name))
        except (RasterioError, OSError, UnicodeError) as error:  # the last of a broken .prj
            if asked_for_network(error):
                raise InputError(f"{name} describes data on a server; {REMOTE_HELP}") from error
            start = first_bytes(file_of(name)) if is_file(file_of(name)) else b""
            if b"<VRTDataset" in start and not _may_be_virtual(name):
                raise InputError(_UNEXPECTED.format(name)) from error
            if is_markup(start):
                raise InputError(
                    f"{name} is an XML or HTML text, not a raster; was it downloaded from a page that asks to log in?"
                ) from error
            raise InputError(
                f"{name} cannot be read as a raster: {_short(error, name)}; is it complete and of a format "
                "that GDAL reads?"
            ) from error


def _require_honest(source: Any, name: str, remote: bool) -> None:
    """Refuse a description of data that lie elsewhere, also where a virtual raster leads to one."""
    if source.driver == "VRT" and not _may_be_virtual(name):
        raise InputError(_UNEXPECTED.format(name))
    if remote:
        return
    require_file(name, source.driver)
    waiting, known = _references(source, name), {os.path.realpath(name)}
    require_local(name, waiting)
    while waiting:
        inner = waiting.pop()
        real = os.path.realpath(inner)
        if real in known or not is_file(inner) or first_bytes(inner).startswith(_TIFF):
            continue
        known.add(real)
        with _opened(inner) as part:
            require_file(f"{name} refers to {inner}, which", part.driver)
            more = _references(part, inner)
        require_local(name, more)
        waiting += more


def _may_be_virtual(name: str) -> bool:
    return not is_file(name) or Path(name).suffix.lower() == ".vrt"


def _references(source: Any, name: str) -> list[str]:
    """Rasters that a virtual raster is made of, as GDAL has understood it; none for other rasters."""
    if source.driver != "VRT":
        return []
    folder = Path(file_of(name)).parent
    return [located(file_of(text), folder) for text in names_in(source.tags(ns="xml:VRT")["xml:VRT"], _SOURCES)]


def _settings(values: Mapping[str, str]) -> contextlib.AbstractContextManager[Any]:
    import rasterio

    env: contextlib.AbstractContextManager[Any] = rasterio.Env(**values)
    return env


def _short(error: BaseException, name: str) -> str:
    text = str(error).replace(name, "the file").replace("\n", " ")
    return text[:160].rstrip(". ")
