"""What may be opened: files on this machine; the network and archives only where it was asked for.

GDAL follows names wherever they lead: to servers, into archives, from one description to the next. So it is not the
text of a name that decides, but GDAL: while a file is open without leave, its HTTP client has no way out, whatever
asks for it; then it tells which driver took the file and which names stand in it.
"""

from __future__ import annotations

import contextlib
import os
import threading
import warnings
from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from firebreak_gis.errors import InputError

#: GDAL hands these to its HTTP client, which knows no proxy of that kind and gives up before it connects.
_NO_WAY_OUT: Mapping[str, str] = MappingProxyType(
    {"GDAL_HTTP_PROXY": "closed://closed", "GDAL_HTTPS_PROXY": "closed://closed"}
)
#: Variables that let the HTTP client pass a proxy by.
_BYPASSES = ("no_proxy", "NO_PROXY")
#: Drivers whose files describe data elsewhere: on servers, or in other files that GDAL does not tell.
DESCRIPTIONS = frozenset(
    {
        *("AmigoCloud", "CSW", "Carto", "DAAS", "EEDA", "EEDAI", "Elasticsearch", "GDALG", "GTI", "HANA", "HTTP"),
        *("MSSQLSpatial", "MongoDBv3", "MySQL", "NGW", "OAPIF", "OCI", "ODBC", "OGCAPI", "PLMOSAIC", "PLSCENES"),
        *("PostGISRaster", "PostgreSQL", "STACIT", "STACTA", "WCS", "WFS", "WMS", "WMTS"),
    }
)
REMOTE_HELP = "download or unpack it first (DEM, VEGETATION and DENSITY may be read from it with --remote)"

_lock = threading.RLock()


@contextlib.contextmanager
def offline(settings: Callable[[Mapping[str, str]], contextlib.AbstractContextManager[Any]]) -> Iterator[None]:
    """Cut GDAL off the network for as long as the block lasts.

    Parameters
    ----------
    settings
        Context in which a GDAL has the configuration that it is given; rasterio and pyogrio may each bring their own.
    """
    with _bypasses_closed(), settings(_NO_WAY_OUT):
        yield


@contextlib.contextmanager
def _bypasses_closed() -> Iterator[None]:
    """Take variables away that would let an address pass the proxy by; usually there are none."""
    if not any(name in os.environ for name in _BYPASSES):
        yield
        return
    with _lock:
        before = {name: os.environ.pop(name) for name in _BYPASSES if name in os.environ}
        try:
            yield
        finally:
            os.environ.update(before)


def asked_for_network(error: BaseException) -> bool:
    """Whether GDAL failed because a file sent it to the network."""
    return _NO_WAY_OUT["GDAL_HTTP_PROXY"] in str(error)


def require_file(name: str, driver: str) -> None:
    """Refuse a file that only describes data elsewhere.

    Parameters
    ----------
    name
        Of the file.
    driver
        GDAL's driver that opened it, cut off the network.

    Raises
    ------
    InputError
        If the driver is one of `DESCRIPTIONS`.
    """
    if driver in DESCRIPTIONS:
        raise InputError(f"{name} describes data that lie elsewhere ({driver}); {REMOTE_HELP}")


def require_local(name: str, references: Iterable[str]) -> None:
    """Refuse a virtual file with a part that is no file on this machine.

    Parameters
    ----------
    name
        Of the virtual file.
    references
        Names of its parts, see `located`.

    Raises
    ------
    InputError
        Naming the first such part.
    """
    for reference in references:
        if not stands(reference):
            raise InputError(
                f"{name} refers to {shortened(reference)}, which is no file on this machine; restore it if it is "
                f"missing; if it is a network or archive address, {REMOTE_HELP}"
            )


def require_local_vector(name: str, place: str) -> None:
    """Refuse a vector file that only describes data elsewhere, also where a virtual file leads to one.

    Call it inside `offline`.

    Parameters
    ----------
    name
        As the user wrote it.
    place
        Where it is.

    Raises
    ------
    InputError
        If it leads off this machine; errors of pyogrio if the file itself cannot be read.
    """
    import pyogrio
    from pyogrio.errors import DataLayerError, DataSourceError

    waiting, known = [place], set[str]()
    while waiting:
        inner = waiting.pop()
        if (real := os.path.realpath(inner)) in known:
            continue
        known.add(real)
        driver = ""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", RuntimeWarning)  # of what cannot be reached
                for layer, _ in pyogrio.list_layers(inner)[:1]:  # names of columns may be in any encoding
                    driver = pyogrio.read_info(inner, layer=layer, encoding="ISO-8859-1")["driver"]
        except (DataSourceError, DataLayerError):
            if inner == place:
                raise
        whose = name if inner == place else f"{name} refers to {inner}, which"
        require_file(whose, driver)
        if driver == "OGR_VRT":
            text = Path(inner).read_text(encoding="utf-8-sig", errors="replace")
            more = [located(found, Path(inner).parent) for found in names_in(text, {"srcdatasource"})]
            require_local(whose, more)
            waiting += more


@contextlib.contextmanager
def vector_settings(values: Mapping[str, str]) -> Iterator[None]:
    """Configure the GDAL of pyogrio for the length of a block."""
    import pyogrio

    before = {key: pyogrio.get_gdal_config_option(key) for key in values}
    pyogrio.set_gdal_config_options(dict(values))
    try:
        yield
    finally:
        pyogrio.set_gdal_config_options(before)


def names_in(text: str, elements: Container[str] | None = None) -> list[str]:
    """Return the texts in an XML document, in order.

    Parameters
    ----------
    text
        The document.
    elements
        Names of elements, lower case, whose text is wanted; the text of all, and all attributes, by default.

    Raises
    ------
    InputError
        If it is no XML.
    """
    from xml.etree import ElementTree as ET

    try:
        tree = list(ET.fromstring(text).iter())
    except (ET.ParseError, ValueError) as error:
        raise InputError(f"not well-formed XML: {error}") from error
    found: list[str | None] = []
    for element in tree:
        if elements is None:
            found += [element.text, element.tail, *element.attrib.values()]
        elif element.tag.lower() in elements:
            found.append(element.text)
    return [word.strip() for word in found if word and word.strip()]


def located(reference: str, folder: str | os.PathLike[str]) -> str:
    """Return where a name in a file of `folder` leads: from there, else as it is."""
    beside = os.path.join(folder, reference)  # noqa: PTH118 - a name may hold what a Path would change
    return beside if stands(beside) else reference


def stands(name: str | os.PathLike[str]) -> bool:
    """Whether something stands under that name; False for names that no file can have."""
    return os.path.exists(name)  # noqa: PTH110 - a Path raises for names that are too long


def is_file(name: str | os.PathLike[str]) -> bool:
    """Whether a file stands under that name; False for names that no file can have."""
    return os.path.isfile(name)  # noqa: PTH113 - a Path raises for names that are too long


def has_controls(name: str) -> bool:
    """Whether a name holds line breaks or tabs, which libraries leave out: they would find another file."""
    return any(letter in name for letter in "\n\r\t")


def shortened(name: str) -> str:
    """Return the beginning of a name, for messages."""
    return name if len(name) <= 100 else f"{name[:100]}..."
