"""Names of rasters: files, variables in files, addresses; and a sentence for each name that leads nowhere."""

from __future__ import annotations

import re
from pathlib import Path

from firebreak_gis.errors import InputError
from firebreak_gis.files.gate import REMOTE_HELP, shortened, stands
from firebreak_gis.files.sources import such_as, vector_name

#: Extensions of rasters that are named where a folder is given in place of one.
_RASTERS = (".tif", ".tiff")
#: `FILE.nc:variable`, a variable of a file that holds several.
_VARIABLE = re.compile(r"^(?P<file>.+\.(?P<kind>nc|nc4|cdf|h5|hdf5|he5)):(?P<variable>/*\w[\w/ .-]*)$", re.IGNORECASE)
#: The same as GDAL writes it, `NETCDF:"FILE.nc":variable`.
_SUBDATASET = re.compile(
    r"^(?P<driver>NETCDF|HDF5|HDF4_SDS|HDF4_EOS|GTIFF_DIR|GPKG|ZARR):(?P<rest>.+)$", re.IGNORECASE | re.DOTALL
)
#: `FILE.tif:2`, a band by its number.
_BAND = re.compile(r"^(?P<raster>.+):(?P<band>[1-9]\d{0,4})$", re.DOTALL)
#: Addresses of the net, of archives and of servers.
_REMOTE = re.compile(r"^(/vsi|[A-Za-z0-9+.-]{2,}://|[A-Za-z0-9_]{2,}:)")


def gdal_name(name: str) -> str:
    """Return the name under which GDAL opens a raster: `a.nc:dem` becomes `NETCDF:"a.nc":dem`."""
    found = None if stands(name) else _VARIABLE.match(name)
    if found is None:
        return name
    driver = "NETCDF" if found["kind"].lower() in ("nc", "nc4", "cdf") else "HDF5"
    return f'{driver}:"{found["file"]}":{found["variable"]}'


def banded(name: str) -> tuple[str, int | None]:
    """Split off the number of a band: `a.tif:2` is band 2 of a.tif, if that is a file and the whole name is none."""
    found = None if stands(name) else _BAND.match(name)
    if found is None or not stands(file_of(found["raster"])):
        return name, None
    return found["raster"], int(found["band"])


def short_name(name: str) -> str:
    """Return the name for people: `NETCDF:"a.nc":dem` becomes `a.nc:dem`."""
    found = re.match(r'^(?:NETCDF|HDF5):"?(?P<file>[^"]+?)"?:(?P<variable>[^:"]+)$', name, re.IGNORECASE)
    short = f"{found['file']}:{found['variable']}" if found else name
    return short if _VARIABLE.match(short) else name


def file_of(name: str) -> str:
    """Return the file that a name speaks of: `a.nc` for `a.nc:dem`, `a.gpkg` for `a.gpkg|layername=roads`."""
    if stands(name):
        return name
    if (found := _BAND.match(name)) and stands(file_of(found["raster"])):
        return file_of(found["raster"])
    name = vector_name(name).file
    if found := _VARIABLE.match(name):
        return found["file"]
    if found := _SUBDATASET.match(name):
        rest = found["rest"]
        if quoted := re.match(r'^"([^"]+)"', rest):
            return quoted[1]
        without_number = re.sub(r"^\d+:", "", rest) if found["driver"].upper() == "GTIFF_DIR" else rest
        ends = [i for i, letter in enumerate(without_number) if letter == ":"] + [len(without_number)]
        return next((without_number[:i] for i in ends if stands(without_number[:i])), without_number)
    return name


def look_first(name: str, remote: bool) -> None:
    """Answer what GDAL would answer badly: addresses, folders, missing and empty files.

    Raises
    ------
    InputError
        Saying what the name leads to.
    """
    path = file_of(name)
    if _REMOTE.match(path) and not stands(path):
        if not remote:
            raise InputError(f"{shortened(name)} is a network or archive address; {REMOTE_HELP}")
        return
    try:
        if Path(path).is_dir():
            if path == name:
                raise InputError(f"{name} is a folder, expected a raster file in it{such_as(path, _RASTERS)}")
            return
        if not Path(path).exists():
            raise InputError(f"{path} does not exist; check the name and the folder {Path(path).absolute().parent}")
        start = first_bytes(path)
    except OSError as error:
        raise InputError(f"{shortened(name)} cannot be opened: {error.strerror or error}") from error
    if not start:
        raise InputError(f"{path} is empty (0 bytes); copy or export it again")
    if start.startswith(b"version https://git-lfs"):
        raise InputError(f"{path} is a Git LFS pointer, a text in place of the file; fetch it with: git lfs pull")


def first_bytes(path: str) -> bytes:
    """Return how a file begins."""
    with Path(path).open("rb") as stream:
        return stream.read(1024)


def is_markup(start: bytes) -> bool:
    """Whether a file that begins so is XML or HTML."""
    return start.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<")
