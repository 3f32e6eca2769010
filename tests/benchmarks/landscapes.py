"""Fractal landscapes to measure on: the same for every competitor."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.ndimage import gaussian_filter

from firebreak_gis import SpreadNetwork
from firebreak_gis.lattice import STEP_LENGTH


def field(side: int, seed: int, widths: tuple[int, ...] = (1, 4, 16, 40)) -> np.ndarray:
    """Correlated noise on all scales, (side, side) from 0 to 1."""
    rng = np.random.default_rng(seed)
    total = np.zeros((side, side))
    for width in widths:
        total += width * gaussian_filter(rng.standard_normal((side, side)), width, mode="wrap")
    return np.asarray((total - total.min()) / np.ptp(total))


@lru_cache(maxsize=2)
def fractal(side: int, *, scale: float = 0.72, seed: int = 1) -> SpreadNetwork:
    """A square of correlated probabilities; at the default scale about half of it burns."""
    # Never zero, so that every cell has a route to every other and all libraries mean the same by closeness.
    target = np.clip(0.93 * scale * field(side, seed), 0.01, 1.0).astype(np.float32)
    tilt = np.linspace(0.9, 1.1, 8, dtype=np.float32)[:, None, None]
    return SpreadNetwork(np.clip(tilt * target, 0.0, 1.0))


@lru_cache(maxsize=2)
def paced(side: int) -> SpreadNetwork:
    """The same, with travel times: 20 m cells, rates about 180 m/h that differ by a factor of 1.6 from cell to cell."""
    network = fractal(side)
    rate = 0.05 * np.exp(np.random.default_rng(5).normal(0.0, 0.5, (side, side)))
    lengths = 20.0 * np.array(STEP_LENGTH)[:, None, None]
    return SpreadNetwork(network.probability, travel_time=np.maximum(lengths / rate, 1.0))


def write_layers(folder: Path, side: int) -> list[Path]:
    """Terrain, vegetation and density as GeoTIFFs of 20 m cells in UTM; returns their paths, terrain first."""
    import rasterio
    from affine import Affine

    hills = gaussian_filter(field(side, 1, (16, 64)), 12, mode="wrap")
    vegetation = np.digitize(field(side, 2), [0.34, 0.45, 0.6]).astype(np.uint8)
    density = np.where(vegetation > 0, np.digitize(field(side, 3), [0.5, 0.62]) + 1, 0).astype(np.uint8)
    folder.mkdir(parents=True, exist_ok=True)
    layers = {"dem": (900 * hills).astype(np.float32), "vegetation": vegetation, "density": density}
    paths = []
    for name, values in layers.items():
        paths.append(folder / f"{name}.tif")
        with rasterio.open(
            paths[-1],
            "w",
            driver="GTiff",
            height=side,
            width=side,
            count=1,
            dtype=values.dtype,
            crs="EPSG:32635",
            transform=Affine(20, 0, 580_000, 0, -20, 4_020_000),
            tiled=True,
            compress="deflate",
        ) as target:
            target.write(values, 1)
    return paths
