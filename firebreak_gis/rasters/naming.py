"""Names of rasters: files, variables in files, addresses; and a sentence for each name that leads nowhere."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import unescape
from pathlib import Path

from firebreak_gis.errors import InputError

#: `FILE.nc:variable`, a variable of a file that holds several.
_VARIABLE = re.compile(r"^(?P<file>.+\.(?P<kind>nc|nc4|cdf|h5|hdf5|he5)):(?P<variable>/*\w[\w/ .-]*)$", re.IGNORECASE)
#: The same as GDAL writes it, `NETCDF:"FILE.nc":variable`.
_SUBDATASET = re.compile(
    r"^(?P<driver>NETCDF|HDF5|HDF4_SDS|HDF4_EOS|GTIFF_DIR|GPKG|ZARR):(?P<rest>.+)$", re.IGNORECASE | re.DOTALL
)
#: Addresses of the net, of archives and of servers.
_REMOTE = re.compile(r"^(/vsi|[A-Za-z0-9+.-]{2,}://|[A-Za-z0-9_]{2,}:)")
_REMOTE_WITHIN = ("/vsi", "://")
#: So much of a virtual raster is searched for addresses.
_VRT_BYTES = 4 << 20


def gdal_name(name: str) -> str:
    """Return the name under which GDAL opens a raster: `a.nc:dem` becomes `NETCDF:"a.nc":dem`."""
    found = None if Path(name).exists() else _VARIABLE.match(name)
    if found is None:
        return name
    driver = "NETCDF" if found["kind"].lower() in ("nc", "nc4", "cdf") else "HDF5"
    return f'{driver}:"{found["file"]}":{found["variable"]}'


def short_name(name: str) -> str:
    """Return the name for people: `NETCDF:"a.nc":dem` becomes `a.nc:dem`."""
    found = re.match(r'^(?:NETCDF|HDF5):"?(?P<file>[^"]+?)"?:(?P<variable>[^:"]+)$', name, re.IGNORECASE)
    short = f"{found['file']}:{found['variable']}" if found else name
    return short if _VARIABLE.match(short) else name


def file_of(name: str) -> str:
    """Return the file that a name speaks of: `a.nc` for `a.nc:dem`."""
    if Path(name).exists():
        return name
    if found := _VARIABLE.match(name):
        return found["file"]
    if found := _SUBDATASET.match(name):
        rest = found["rest"]
        if quoted := re.match(r'^"([^"]+)"', rest):
            return quoted[1]
        without_number = re.sub(r"^\d+:", "", rest) if found["driver"].upper() == "GTIFF_DIR" else rest
        ends = [i for i, letter in enumerate(without_number) if letter == ":"] + [len(without_number)]
        return next((without_number[:i] for i in ends if Path(without_number[:i]).exists()), without_number)
    return name


def files_behind(names: Iterable[str]) -> list[str]:
    """Return the files that these names speak of, and those that virtual rasters among them are made of."""
    waiting, found = [file_of(str(name)) for name in names], dict[str, None]()
    while waiting:
        name = waiting.pop()
        if name not in found and Path(name).is_file():
            found[name] = None
            if name.lower().endswith(".vrt"):
                inner = [file_of(source) for source in _sources(Path(name))]
                # As written, and as seen from the folder of the virtual raster.
                waiting += [*inner, *(str(Path(name).parent / source) for source in inner)]
    return list(found)


def look_first(name: str, remote: bool) -> None:
    """Answer what GDAL would answer badly: addresses, folders, missing, empty and text files.

    Raises
    ------
    InputError
        Saying what the name leads to.
    """
    path = Path(file_of(name))
    inside = str(path) != str(Path(name))
    if _REMOTE.match(str(path)) and not _exists(path):
        if not remote:
            raise InputError(
                f"{name} is a network or archive address; download or unpack it first "
                "(DEM, VEGETATION and DENSITY may be read from it with --remote)"
            )
        return
    try:
        if path.is_dir() and not inside:
            raise InputError(f"{name} is a folder, expected a raster file in it")
        if not path.exists():
            raise InputError(f"{path} does not exist; check the name and the folder {path.absolute().parent}")
        if path.is_dir():
            return
        with path.open("rb") as stream:
            start = stream.read(512)
    except OSError as error:
        raise InputError(f"{name} cannot be opened: {error.strerror or error}") from error
    _look_at(start, path, remote)


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except OSError:
        return False


def _look_at(start: bytes, path: Path, remote: bool) -> None:
    """Refuse contents that are no raster, by their first bytes."""
    virtual = path.suffix.lower() == ".vrt"
    if not start:
        raise InputError(f"{path} is empty (0 bytes); copy or export it again")
    if start.startswith(b"version https://git-lfs"):
        raise InputError(f"{path} is a Git LFS pointer, a text in place of the file; fetch it with: git lfs pull")
    if b"<VRTDataset" in start and not virtual:
        raise InputError(f"{path} is a virtual raster (VRT) under another name; name it .vrt if that is what you mean")
    if start.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<") and not virtual:
        raise InputError(
            f"{path} is an XML or HTML text, not a raster; was it downloaded from a page that asks to log in?"
        )
    if virtual and not remote:
        _refuse_addresses(path)


def _refuse_addresses(path: Path) -> None:
    """A virtual raster may name any file; what lies elsewhere is not fetched unasked."""
    for source in _sources(path):
        if any(word in source for word in _REMOTE_WITHIN):
            raise InputError(
                f"{path} refers to {source[:80]}, a network or archive address; download it first "
                "(DEM, VEGETATION and DENSITY may be read from it with --remote)"
            )


def _sources(path: Path) -> list[str]:
    """Names of the rasters that a virtual raster refers to."""
    with path.open("rb") as stream:
        text = stream.read(_VRT_BYTES).decode("utf-8", "replace")
    found = re.findall(r"<SourceFilename[^>]*>([^<]*)<|<SourceDataset[^>]*>([^<]*)<", text)
    return [unescape((one or other).strip()) for one, other in found]
