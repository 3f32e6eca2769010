"""Small made-up rasters for the tests: written with plain rasterio, so that the reader is tested too."""

import functools
from pathlib import Path

import numpy as np
import pytest
import rasterio
from affine import Affine

ROOT = Path(__file__).resolve().parents[1]
SHARED = ROOT.parent / "shared" / "data"

UTM = "EPSG:32635"
NORTH_WEST = (586_440.0, 3_999_900.0)

#: Marks a test that needs the real landscapes.
real = pytest.mark.shared


def shared(*parts):
    """Path of a real raster; skips the test where the folder is absent."""
    path = SHARED.joinpath(*parts)
    if not path.exists():
        pytest.skip("the real landscapes are not here")
    return path


def square(cell=20.0, north_west=NORTH_WEST):
    return Affine(cell, 0, north_west[0], 0, -cell, north_west[1])


def write(path, values, *, transform=None, crs=UTM, nodata=None, **more):
    """Write a plain GeoTIFF (or what `driver` says) of (rows, cols) or (bands, rows, cols)."""
    planes = values if values.ndim == 3 else values[np.newaxis]
    units = more.pop("units", None)
    scale = more.pop("scale", None)
    profile = {
        "driver": "GTiff",
        "count": planes.shape[0],
        "height": planes.shape[1],
        "width": planes.shape[2],
        "dtype": planes.dtype.name,
        "transform": transform if transform is not None else square(),
        "crs": crs,
        "nodata": nodata,
        **more,
    }
    with rasterio.open(path, "w", **profile) as target:
        target.write(planes)
        if units is not None:
            target.units = (units,) * planes.shape[0]
        if scale is not None:
            target.scales, target.offsets = (scale[0],), (scale[1],)
    return path


@functools.cache
def relief(rows, cols, seed=7):
    """Smooth hills from 0 to about 900 m, float32; treat as read-only."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[0:rows, 0:cols] / 12.0
    hills = sum(np.sin(x * a + p) * np.cos(y * b + q) for a, b, p, q in rng.uniform(0.4, 2.0, (5, 4)))
    return ((hills - hills.min()) * 100).astype(np.float32)


def patches(rows, cols, codes, seed=3, size=3):
    """Class codes in small patches, uint8."""
    rng = np.random.default_rng(seed)
    coarse = rng.choice(np.asarray(codes, dtype=np.uint8), (rows // size + 1, cols // size + 1))
    return np.kron(coarse, np.ones((size, size), dtype=np.uint8))[:rows, :cols]


def three(folder, rows=24, cols=31, **more):
    """Write matching dem.tif, vegetation.tif, density.tif; return the paths."""
    return (
        write(folder / "dem.tif", relief(rows, cols), **more),
        write(folder / "vegetation.tif", patches(rows, cols, [0, 1, 2, 3]), nodata=255, **more),
        write(folder / "density.tif", patches(rows, cols, [1, 2, 3], seed=5), nodata=255, **more),
    )
