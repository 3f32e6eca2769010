"""Which classes of vegetation and density are cut, against what random cutting would take."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.schema import DENSITY, VEGETATION

if TYPE_CHECKING:
    from collections.abc import Mapping

    import pandas as pd
    import xarray as xr

#: Layers and their classes.
LAYERS = (("vegetation", VEGETATION), ("density", DENSITY))


def class_shares(landscape: xr.Dataset, cut: np.ndarray, fuel: np.ndarray) -> dict[str, dict[str, dict[str, float]]]:
    """Share of the cut cells, and of all fuel, which is what random cutting takes on average, by layer and class.

    Parameters
    ----------
    landscape
        With `vegetation` and `density`; the classes that hold fuel count. Fuel that a legend gives effects counts under
        the class nearest to them.
    cut, fuel
        (rows, cols) bool.

    Returns
    -------
    dict
        ``[layer][class]`` is ``{"cut": share, "random": share}``.

    Examples
    --------
    >>> import numpy as np, xarray as xr
    >>> land = xr.Dataset({name: (("y", "x"), np.array([[1, 1, 2, 3]])) for name in ("vegetation", "density")})
    >>> fuel = np.ones((1, 4), bool)
    >>> class_shares(land, np.array([[True, False, True, False]]), fuel)["density"]["normal"]
    {'cut': 0.5, 'random': 0.25}
    """
    cut = cut & fuel
    n_cut, n_fuel = max(int(np.count_nonzero(cut)), 1), max(int(np.count_nonzero(fuel)), 1)
    found: dict[str, dict[str, dict[str, float]]] = {}
    for layer, classes in LAYERS:
        codes = landscape[layer].to_numpy()
        found[layer] = {
            name: {
                "cut": int(np.count_nonzero(codes[cut] == code)) / n_cut,
                "random": int(np.count_nonzero(codes[fuel] == code)) / n_fuel,
            }
            for code, name in classes.items()
            if code
        }
    return found


def class_table(landscape: xr.Dataset, plans: Mapping[tuple[str, float], xr.DataArray]) -> pd.DataFrame:
    """Class shares of several plans, one row a plan, layer and class.

    Parameters
    ----------
    landscape
        As in `class_shares`.
    plans
        (y, x), above 0 where cut, by method and d_f.

    Returns
    -------
    pandas.DataFrame
        method, d_f, cells_cut, layer, class, share (of the cut cells), random (the share of the fuel, which random
        cutting takes on average) and random_sd, the standard deviation of that share over random cuts of as many cells
        (hypergeometric).
    """
    import pandas as pd

    fuel = landscape["burnable"].to_numpy() > 0
    n_fuel = int(np.count_nonzero(fuel))
    rows: list[dict[str, Any]] = []
    for (method, budget), mask in plans.items():
        cut = (mask.to_numpy() > 0) & fuel
        n_cut = int(np.count_nonzero(cut))
        left = (n_fuel - n_cut) / max(n_fuel - 1, 1) / max(n_cut, 1)
        for layer, classes in class_shares(landscape, cut, fuel).items():
            for name, share in classes.items():
                p = share["random"]
                rows.append(
                    {"method": method, "d_f": budget, "cells_cut": n_cut, "layer": layer, "class": name}
                    | {"share": share["cut"], "random": p, "random_sd": float(np.sqrt(p * (1.0 - p) * left))}
                )
    return pd.DataFrame(rows)
