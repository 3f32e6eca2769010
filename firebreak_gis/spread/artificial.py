"""Artificial forest: the probability of catching fire is the fuel of the target cell.

    p(l -> k) = 1 - s_k,   s uniform in (0, 1): 1 is empty, 0 very dense

On a flat periodic grid this is the toy landscape of the paper; `forest` generates it. Cost: one pass.
Source: Russo, Russo, Siettos 2016, doi 10.1371/journal.pone.0163226.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid
from firebreak_gis.network import neighbour

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Params:
    """The artificial forest has no parameters; the landscape says it all."""


def forest(shape: tuple[int, int] = (50, 50), *, seed: int = 0) -> xr.Dataset:
    """Generate an artificial forest: emptiness uniform in (0, 1), flat, periodic.

    Parameters
    ----------
    shape
        (rows, cols), at least 3 x 3.
    seed
        Seed of the draws; the same seed and shape give the same forest.

    Returns
    -------
    xarray.Dataset
        `emptiness` (y, x) float64 and `burnable` (all true), attribute `boundary` = "periodic".

    Examples
    --------
    >>> landscape = forest((12, 20), seed=1)
    >>> landscape["emptiness"].shape, landscape.attrs["boundary"]
    ((12, 20), 'periodic')
    """
    import xarray as xr

    from firebreak_gis.kernels.draws import stream_key, uniforms

    grid = Grid(shape)
    emptiness = uniforms(stream_key(seed, "forest"), shape[0] * shape[1]).reshape(shape)
    data = {
        "emptiness": grid.dataarray(emptiness, "emptiness", units="1", long_name="1 is empty, 0 very dense"),
        "burnable": grid.dataarray(np.ones(shape, dtype=bool), "burnable", units="1", long_name="cell holds fuel"),
    }
    return xr.Dataset(data, attrs={"boundary": "periodic", "seed": seed})


def probability(landscape: xr.Dataset, params: Params) -> np.ndarray:
    """Return (8, rows, cols) float32 from `emptiness`.

    Raises
    ------
    InputError
        If `emptiness` is missing or outside [0, 1].
    """
    if "emptiness" not in landscape:
        raise InputError(
            "the artificial model needs a variable 'emptiness' in [0, 1]; make one with spread.artificial.forest"
        )
    Grid.of(landscape["emptiness"])  # refuses other dimensions
    fuel = 1.0 - landscape["emptiness"].to_numpy()
    if not (fuel.min() >= 0.0 and fuel.max() <= 1.0):
        raise InputError("emptiness must lie in [0, 1] without NaN")
    boundary = landscape.attrs.get("boundary", "open")
    return np.stack([neighbour(fuel, d, boundary) for d in range(8)]).astype(np.float32)
