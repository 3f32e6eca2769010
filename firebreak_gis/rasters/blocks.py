"""Writing rasters that are made block by block, so that they need not fit into memory."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, OutputError, VerificationError
from firebreak_gis.files import replacing, together
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
) -> Path:
    """Write variables of the schema that come in blocks of rows; the file is, byte for byte, that of `write_raster`.

    Parameters
    ----------
    path, overwrite, provenance, creation_options, forbid
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
    Memory: one block. Disk: beside the file, until it stands, a copy that is hardly compressed. A style is written for
    classes and shares alone: the ends of other ramps are those of the whole map.
    """
    from rasterio.errors import RasterioError

    require_geotiff(path)
    place = Path(path)
    remove = [place.with_name(place.name + suffix) for suffix in SIDECARS]
    with (
        together(place.parent),
        replacing(path, overwrite=overwrite, forbid=forbid, remove=remove) as part,
    ):
        scratch = part.with_name(f"{part.name}.rows.tif")  # goes with the part, whatever happens
        try:
            variables = _gather(scratch, blocks, grid, provenance or {})
            _encode(scratch, part, {**cog_options(variables[0]), **lower(creation_options or {})})
            _compare(scratch, part)
        except (RasterioError, OSError) as error:
            raise OutputError(f"cannot write the raster {place}: {error}; is the disk full?") from error
        finally:
            scratch.unlink(missing_ok=True)
        if (variables[0].minimum, variables[0].maximum) == (0, 1) or variables[0].classes:
            write_style(place, np.zeros(0), variables[0], overwrite)
    return place


def _gather(
    scratch: Path, blocks: Iterable[tuple[int, xr.Dataset]], grid: Grid, provenance: Mapping[str, Any]
) -> list[Any]:
    """Write the blocks into one file of tiles."""
    import rasterio
    from rasterio.errors import NotGeoreferencedWarning
    from rasterio.windows import Window

    target: Any = None
    variables: list[Any] = []
    written = 0
    with rasterio.Env(GDAL_PAM_ENABLED="NO"), warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        try:
            for row, data in blocks:
                layers = list(data.data_vars.values())
                if target is None:
                    variables = variables_of(layers)
                    tiles = {"tiled": True, "blockxsize": ROWS, "blockysize": ROWS, "compress": "DEFLATE", "zlevel": 1}
                    how = {"driver": "GTiff", "bigtiff": "YES", "interleave": "band", **tiles}
                    target = rasterio.open(scratch, "w", **profile_of(grid, variables), **how)
                    describe(target, variables, tags_of(data, provenance))
                rows = data.sizes["y"]
                if row != written or row % ROWS:
                    raise InputError(f"a block begins at row {row}, expected row {written}, a multiple of {ROWS}")
                planes = planes_of(layers, variables, (rows, grid.shape[1]))
                target.write(planes, window=Window(0, row, grid.shape[1], rows))
                written += rows
        finally:
            if target is not None:
                target.close()
    if written != grid.shape[0]:
        raise InputError(f"the blocks have {written} rows, expected {grid.shape[0]}")
    return variables


def _encode(scratch: Path, part: Path, options: Mapping[str, Any]) -> None:
    import rasterio
    import rasterio.shutil

    with rasterio.Env(GDAL_PAM_ENABLED="NO"):
        rasterio.shutil.copy(scratch, part, driver="COG", **options)


def _compare(scratch: Path, part: Path) -> None:
    """Read the finished file anew, overviews as well, and hold it against the blocks."""
    import rasterio
    from rasterio.windows import Window

    with open_raster(scratch) as source, open_raster(part) as copy:
        rows, cols = source.shape
        for row in range(0, rows, ROWS):
            where = Window(0, row, cols, min(ROWS, rows - row))
            if not np.array_equal(source.read(window=where), copy.read(window=where)):
                raise VerificationError(f"{part}: rows from {row} do not read back as they were written")
        factors = copy.overviews(1)
    for level in range(len(factors)):
        with rasterio.open(part, overview_level=level) as small:
            for row in range(0, small.height, ROWS):
                small.read(window=Window(0, row, small.width, min(ROWS, small.height - row)))
