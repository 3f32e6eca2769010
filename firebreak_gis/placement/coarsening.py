"""Large patches are searched in blocks of their cells: how large these are, and what a wall pays across one."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.flow import UNCUTTABLE

#: A cell that may not be cut counts in a block as so many of the dearest.
_DEAR = 8


def factor_for(n_cells: int, coarse_from: int) -> int:
    """Side of the squares of a patch in whose blocks it is searched, about half as many as `coarse_from`."""
    return int(np.ceil(np.sqrt(2 * n_cells / coarse_from)))


def coarse_price(price: np.ndarray, barred: np.ndarray, dearest: float) -> np.ndarray:
    """What cells count in a block; those that may not be cut as some of the dearest each."""
    return np.where(barred, _DEAR * dearest, price)


def coarse_costs(price: np.ndarray, whole: np.ndarray, factor: int) -> np.ndarray:
    """Cost of a wall across blocks, int32, from what their cells count in all and whether none may be cut."""
    across = price / factor
    return np.where(whole, UNCUTTABLE, np.maximum(np.rint(across), across > 0)).astype(np.int32)


def joined_costs(capacity: np.ndarray, label: np.ndarray, factor: int) -> np.ndarray:
    """Cost of a wall across each of some groups of cells, int32."""
    firm = capacity >= UNCUTTABLE
    price = coarse_price(capacity, firm, int(capacity[~firm].max(initial=1)))
    return coarse_costs(np.bincount(label, weights=price), np.bincount(label, weights=~firm) == 0, factor)
