"""Writing rasters that are made block by block, so that they need not fit into memory."""

from __future__ import annotations

import contextlib
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any
from zlib import crc32

import numpy as np

from firebreak_gis.errors import InputError, OutputError, VerificationError
from firebreak_gis.files import replacing, together
from firebreak_gis.files.locks import remove_parts
from firebreak_gis.memory import BLOCK_CELLS
from firebreak_gis.rasters.opening import open_raster
from firebreak_gis.rasters.writing import (
    SIDECARS,
    cog_options,
    describe,
    lower,
    planes_of,
    profile_of,
    require_geotiff,
    tags_of,
    variables_of,
    write_raster,
    write_style,
)

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid

#: Rows of a block: those of the tiles in the file.
ROWS = 256


def write_blocks(
    path: str | os.PathLike[str],
    blocks: Iterable[tuple[int, xr.Dataset]],
    grid: Grid,
    *,
    overwrite: bool = False,
    provenance: Mapping[str, Any] | None = None,
    creation_options: Mapping[str, Any] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
    bits: int | None = None,
) -> Path:
    """Write variables of the schema that come in blocks of rows; cells and texts are those of `write_raster`.

    Overviews may differ in the last digits: GDAL makes those of a file on the disk another way.

    Parameters
    ----------
    path, overwrite, provenance, creation_options, forbid, bits
        As in `write_raster`.
    blocks
        First row of each block, a multiple of `ROWS`, and its data, over the whole width. All have the variables of the
        first, whose attributes are kept.
    grid
        Of the whole.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    InputError, OutputError, VerificationError
        As `write_raster`.

    Notes
    -----
    Memory: one block; one that is the whole is written by `write_raster`. Disk: beside the file, until it stands, a
    copy that is hardly compressed. A style is written for classes and shares alone, since the ends of other ramps are
    those of the whole map.
    """
    require_geotiff(path)
    waiting = iter(blocks)
    first = next(waiting, None)
    if first is not None and first[1].sizes["y"] == grid.shape[0]:
        return write_raster(
            path,
            first[1],
            overwrite=overwrite,
            provenance=provenance,
            creation_options=creation_options,
            forbid=forbid,
            bits=bits,
        )
    blocks = waiting if first is None else chain([first], waiting)
    del first  # as every block, it goes once it is written
    place = Path(path)
    remove = [place.with_name(place.name + suffix) for suffix in SIDECARS]
    with (
        together(place.parent),
        replacing(path, overwrite=overwrite, forbid=forbid, remove=remove) as part,
    ):
        scratch = part.with_name(f"{part.name}.rows.tif")  # goes with the part, whatever happens
        try:
            variables, sums = _gather(scratch, blocks, grid, provenance or {}, bits)
            with _failing(place):
                _encode(scratch, part, {**cog_options(variables[0]), **lower(creation_options or {})})
                _compare(scratch, part, sums)
        finally:
            remove_parts(part.parent, scratch.name)
        if (variables[0].minimum, variables[0].maximum) == (0, 1) or variables[0].classes:
            write_style(place, np.zeros(0), variables[0], overwrite)
    return place


def rows_of(data: xr.Dataset, *, cells: int = BLOCK_CELLS) -> Iterator[tuple[int, xr.Dataset]]:
    """Blocks of rows of what is there, for `write_blocks`, of about so many cells; all is one block if it has fewer."""
    rows, cols = data.sizes["y"], data.sizes["x"]
    step = rows if rows * cols <= cells else max(cells // cols // ROWS, 1) * ROWS
    for row in range(0, rows, step):
        yield row, data.isel(y=slice(row, row + step))


@contextlib.contextmanager
def _failing(place: str | os.PathLike[str]) -> Iterator[None]:
    """Say that a file cannot be written where GDAL cannot write it, or not read back what it wrote."""
    from rasterio._err import CPLE_BaseError
    from rasterio.errors import RasterioError

    try:
        yield
    except VerificationError:
        raise
    except (InputError, RasterioError, CPLE_BaseError, OSError) as error:
        raise OutputError(f"cannot write the raster {place}: {error}; is the disk full?") from error


def _gather(
    scratch: Path,
    blocks: Iterable[tuple[int, xr.Dataset]],
    grid: Grid,
    provenance: Mapping[str, Any],
    bits: int | None,
) -> tuple[list[Any], dict[int, int]]:
    """Write the blocks into one file of tiles; return the variables, and a checksum of each block.

    The file is GDAL's own: what is in memory for other rasters would be as large as the map.
    """
    import rasterio
    from rasterio.errors import NotGeoreferencedWarning
    from rasterio.windows import Window

    target: Any = None
    variables: list[Any] = []
    sums: dict[int, int] = {}
    written = 0
    with rasterio.Env(GDAL_PAM_ENABLED="NO"), warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        try:
            for row, data in blocks:
                layers = list(data.data_vars.values())
                if target is None:
                    variables = variables_of(layers, bits)
                    tiles = {"tiled": True, "blockxsize": ROWS, "blockysize": ROWS, "compress": "DEFLATE", "zlevel": 1}
                    how = {"driver": "GTiff", "bigtiff": "YES", "interleave": "pixel", **tiles}
                    with _failing(scratch):
                        target = rasterio.open(scratch, "w", **profile_of(grid, variables), **how)
                        describe(target, variables, tags_of(data, provenance))
                rows = data.sizes["y"]
                if row != written or row % ROWS:
                    raise InputError(f"a block begins at row {row}, expected row {written}, a multiple of {ROWS}")
                planes = planes_of(layers, variables, (rows, grid.shape[1]))
                sums |= {row + i: crc32(planes[:, i : i + ROWS].tobytes()) for i in range(0, rows, ROWS)}
                with _failing(scratch):
                    target.write(planes, window=Window(0, row, grid.shape[1], rows))
                written += rows
                del data, layers, planes  # before the next block is made
        finally:
            if target is not None:
                with _failing(scratch):
                    target.close()
    if written != grid.shape[0]:
        raise InputError(f"the blocks have {written} rows, expected {grid.shape[0]}")
    return variables, sums


def _encode(scratch: Path, part: Path, options: Mapping[str, Any]) -> None:
    import rasterio
    import rasterio.shutil

    with rasterio.Env(GDAL_PAM_ENABLED="NO"):
        rasterio.shutil.copy(scratch, part, driver="COG", **options)


def _compare(scratch: Path, part: Path, sums: Mapping[int, int]) -> None:
    """Read the finished file anew, overviews as well, and hold it against what was to be written."""
    import rasterio
    from rasterio.windows import Window

    with open_raster(scratch) as source, open_raster(part) as copy:
        rows, cols = source.shape
        for row in range(0, rows, ROWS):
            found = crc32(copy.read(window=Window(0, row, cols, min(ROWS, rows - row))).tobytes())
            if found != sums[row]:
                raise VerificationError(f"{part}: rows from {row} do not read back as they were written")
        if (source.tags(), source.descriptions) != (copy.tags(), copy.descriptions):
            raise VerificationError(f"{part}: the texts do not read back as they were written")
        factors = copy.overviews(1)
    for level in range(len(factors)):
        with rasterio.open(part, overview_level=level) as small:
            for row in range(0, small.height, ROWS):
                small.read(window=Window(0, row, small.width, min(ROWS, small.height - row)))
