"""Rankings: one file a method, each giving one priority raster.

A method file holds a frozen dataclass `Params` and

    rank(network, params, *, stakes, seed, progress) -> (rows, cols) float64, higher is cut earlier

and needs no registration: its file name is its name. `stakes` holds costs, protected cells, values at risk and
where fires start; a method uses what it can. Cells without fuel and protected cells get -inf here, whatever the
method returned for them. A method whose result depends on how ties between equally good plans are broken says so
by `UNIQUE = False`. `rank` below is the only way in. What is done here, network science calls dismantling.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import GridError, VerificationError
from firebreak_gis.plugins import build_params, load
from firebreak_gis.progress import Progress, silent
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork


def rank(
    network: SpreadNetwork,
    method: str = "dissection",
    *,
    stakes: Stakes | None = None,
    seed: int = 0,
    progress: Progress | None = None,
    **params: Any,
) -> xr.DataArray:
    """Rank the cells of a network by the order in which they should be cut.

    Parameters
    ----------
    network
        The spread network.
    method
        Name of a ranking (`firebreak methods` lists them).
    stakes
        Costs, protected cells, values at risk and ignitions; default: every cell alike, nothing protected.
    seed
        Seed of methods that draw.
    progress
        Callback (share done, message); raise `Cancelled` in it to stop.
    **params
        Parameters of the method, for example ``beta=0.5``.

    Returns
    -------
    xarray.DataArray
        `priority` (y, x) float64, higher is cut earlier, -inf where there is no fuel or nothing may be cut.

    Raises
    ------
    ParameterError
        If the method or a parameter is unknown or out of range.
    GridError
        If the stakes was made for a network of another shape.

    Notes
    -----
    Memory at the peak, beside the network: `methods.memory_of("ranking", method)`; the text of each method says more.
    """
    module = load("ranking", method)
    values = build_params(module, params)
    stakes = stakes or Stakes(network)
    if stakes.cost.shape != network.shape:
        raise GridError(f"stakes has shape {stakes.cost.shape}, expected {network.shape}; make it for this network")
    scores = module.rank(network, values, stakes=stakes, seed=seed, progress=progress or silent)
    priority = np.array(scores, dtype=np.float64)
    if priority.shape != network.shape or np.isnan(priority[network.burnable]).any():
        raise VerificationError(
            f"ranking {method!r} returned shape {priority.shape} or NaN, expected {network.shape} without NaN"
        )
    priority[~network.burnable | stakes.protected] = -np.inf
    if progress is not None:
        progress(1.0, f"{method} done")
    from firebreak_gis.schema import annotate

    return annotate(network.grid.dataarray(priority, "priority")).assign_attrs(method=method)
