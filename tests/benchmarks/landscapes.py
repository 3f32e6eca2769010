"""Fractal landscapes to measure on: the same for every competitor."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from firebreak_gis import SpreadNetwork


def fractal(side: int, *, scale: float = 0.72, seed: int = 1) -> SpreadNetwork:
    """A square of correlated probabilities; at the default scale about half of it burns."""
    rng = np.random.default_rng(seed)
    field = np.zeros((side, side))
    for width in (1, 4, 16, 40):
        field += width * gaussian_filter(rng.standard_normal((side, side)), width, mode="wrap")
    field = (field - field.min()) / np.ptp(field)
    # Never zero, so that every cell has a route to every other and all libraries mean the same by closeness.
    target = np.clip(0.93 * scale * field, 0.01, 1.0).astype(np.float32)
    tilt = np.linspace(0.9, 1.1, 8, dtype=np.float32)[:, None, None]
    return SpreadNetwork(np.clip(tilt * target, 0.0, 1.0))
