"""Rankings: one file a method, each giving one priority raster.

A method file holds a frozen dataclass `Params` and

    rank(network, params, *, stakes, seed, progress) -> (rows, cols) float64, higher is cut earlier

and needs no registration: its file name is its name. `stakes` holds costs, protected cells, values at risk and
where fires start; a method uses what it can. One that takes `trial` too is given the fires with a clock that the plan
is for, to try designs on, or None. It may return `Ranked`, the scores and a text on what was chosen. Cells without
fuel and protected cells get -inf here, whatever the method returned for them. A method whose result depends on how
ties between equally good plans are broken says so by `UNIQUE = False`. A method whose rankings for other parameters
share work may have

    rankings(network, *, stakes, seed) -> function of (params, progress) that returns what `rank` does

beside it, which keeps what they share, and takes `trial` last if `rank` does. `rank` and `rankings` below are the
only ways in. What is done here, network science calls dismantling.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.errors import GridError, VerificationError
from firebreak_gis.plugins import build_params, load, takes_trial
from firebreak_gis.progress import Progress, silent
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.trial import Trial


class Ranked(NamedTuple):
    """What a method may return.

    Parameters
    ----------
    scores
        (rows, cols) float64, higher is cut earlier.
    told
        What was chosen, in words.
    """

    scores: np.ndarray
    told: str


def rank(
    network: SpreadNetwork,
    method: str = "dissection",
    *,
    stakes: Stakes | None = None,
    trial: Trial | None = None,
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
    trial
        Fires with a clock that methods may try designs on; None: there is no clock.
    seed
        Seed of methods that draw.
    progress
        Callback (share done, message); raise `Cancelled` in it to stop.
    **params
        Parameters of the method, for example ``beta=0.5``.

    Returns
    -------
    xarray.DataArray
        `priority` (y, x) float64, higher is cut earlier, -inf where there is no fuel or nothing may be cut. The
        attribute `design` tells what the method has chosen, if it says it.

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
    return rankings(network, method, stakes=stakes or Stakes(network), seed=seed)(params, progress or silent, trial)


def rankings(
    network: SpreadNetwork, method: str, *, stakes: Stakes, seed: int = 0
) -> Callable[[Mapping[str, Any], Progress, Trial | None], xr.DataArray]:
    """Return `rank` as a function of (parameters, progress, trial), for many; what they share is made once."""
    module = load("ranking", method)
    if stakes.cost.shape != network.shape:
        raise GridError(f"stakes has shape {stakes.cost.shape}, expected {network.shape}; make it for this network")
    sharing = getattr(module, "rankings", None)
    made = sharing(network, stakes=stakes, seed=seed) if sharing else None

    def one(params: Mapping[str, Any], progress: Progress, trial: Trial | None) -> xr.DataArray:
        from firebreak_gis.schema import annotate

        values = build_params(module, params)
        given = {"trial": trial} if takes_trial(module) else {}
        if made is None:
            answer = module.rank(network, values, stakes=stakes, seed=seed, progress=progress, **given)
        else:
            answer = made(values, progress, **given)
        scores, told = answer if isinstance(answer, Ranked) else (answer, "")
        priority = np.array(scores, dtype=np.float64)
        if priority.shape != network.shape or np.isnan(priority[network.burnable]).any():
            raise VerificationError(
                f"ranking {method!r} returned shape {priority.shape} or NaN, expected {network.shape} without NaN"
            )
        priority[~network.burnable | stakes.protected] = -np.inf
        progress(1.0, f"{method} done")
        named = {"method": method, **({"design": told} if told else {})}
        return annotate(network.grid.dataarray(priority, "priority")).assign_attrs(named)

    return one
