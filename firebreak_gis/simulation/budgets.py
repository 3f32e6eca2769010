"""Fires at every budget of a ranking, or under several plans, by the same draws."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Amount, Budget, first_cut, require_priority, shares_of
from firebreak_gis.errors import ParameterError
from firebreak_gis.progress import Progress, part
from firebreak_gis.simulation.fires import resolved
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.ground_fires import burn_on
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.timeless import burn_levels

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ignitions import IgnitionMode


class Sizes:
    """Sizes of the fires of one request on one ground, by the cells that are cut: the same cells burn once."""

    def __init__(self) -> None:
        self._known: dict[bytes, np.ndarray] = {}

    def of(self, breaks: np.ndarray | xr.DataArray | LineBreaks | None) -> np.ndarray | None:
        """(n_runs,) if they are known; lines never are."""
        return self._known.get(_told_by(breaks))

    def keep(self, breaks: np.ndarray | xr.DataArray | LineBreaks | None, burnt: np.ndarray) -> np.ndarray:
        """Keep and return them."""
        if (key := _told_by(breaks)) != _LINES:
            self._known[key] = burnt
        return burnt


#: In place of the cells of lines, which do not tell how fires meet them.
_LINES = b"lines"


def _told_by(breaks: np.ndarray | xr.DataArray | LineBreaks | None) -> bytes:
    """The same for the same cells."""
    from firebreak_gis.landscape.lines import LineBreaks

    if isinstance(breaks, LineBreaks):
        return _LINES
    cut = np.zeros(0, bool) if breaks is None else np.asarray(breaks) > 0
    return hashlib.blake2b(np.packbits(cut).tobytes()).digest() if cut.any() else b""


def burn_curve(
    network: SpreadNetwork,
    priority: np.ndarray | xr.DataArray,
    *,
    budgets: Sequence[Amount] | np.ndarray,
    ignitions: Any = None,
    ignition_mode: IgnitionMode = "each",
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Cells burnt at every budget of a ranking, all budgets in one pass a run.

    Equal, run by run, to `simulate` with the breaks of each budget and the same seed.

    Parameters
    ----------
    network
        The spread network before cutting.
    priority
        (y, x), higher is cut earlier, -inf is never cut.
    budgets
        Shares d_f of the cells that hold fuel such as 0.05 or "5%", or areas such as "20ha"; rising.
    ignitions, ignition_mode, n_runs, seed, threads, progress
        As in `simulate`.

    Returns
    -------
    xarray.DataArray
        `cells_burnt` (run, budget) int64 with the coordinate `budget`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> burnt = fb.burn_curve(network, fb.rank(network, "bonacich"), budgets=[0.0, 0.1, 0.3], n_runs=50)
    >>> burnt.sizes["run"], burnt.sizes["budget"], bool((burnt[:, 0] >= burnt[:, 2]).all())
    (50, 3, True)
    """
    request = FireRequest(ignitions, ignition_mode, n_runs, seed)
    shares = shares_of(budgets, network)
    return burn_budgets(network, priority, request, budgets=shares, threads=threads, progress=progress)


def burn_budgets(
    network: SpreadNetwork,
    priority: np.ndarray | xr.DataArray,
    request: FireRequest,
    *,
    budgets: Sequence[float] | np.ndarray,
    ground: Ground | None = None,
    known: Sizes | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.DataArray:
    """Burn the network at every budget as a request says; all else as in `burn_curve`.

    Without a clock, embers or failing breaks the breaks are perfect, and all budgets take one pass a run. With them
    every budget is burnt by itself, by the same draws: a break that fire goes round may make it come too late, so that
    the level of a cell on the best way to it does not tell whether it burns.

    Parameters
    ----------
    ground
        Where the fires burn, if that is not `network`, of whose fuel the budgets are shares.
    known
        As in `burn_each`.
    """
    ground = ground or Ground(network)
    require_priority(priority)
    start, n_runs = resolved(network, request), request.n_runs
    levels = cut_levels(network, priority, budgets)
    burnt = np.zeros((n_runs, len(budgets)), np.int64)
    if request.timeless and ground.weather is None and ground.barriers is None:
        burn_levels(ground.network, start, levels.ravel(), burnt, request, threads, progress)
    else:
        plans = [levels < k for k in range(len(budgets))]
        same = replace(request, ignitions=start)
        burnt = burn_each(ground, same, plans, known=known, threads=threads, progress=progress)
    return _curve(network, burnt, budgets, request.seed)


def burn_each(
    ground: Ground,
    request: FireRequest,
    plans: Sequence[np.ndarray | xr.DataArray | LineBreaks | None],
    *,
    known: Sizes | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> np.ndarray:
    """Burn the same fires under each of some plans, plans that cut the same cells once.

    Parameters
    ----------
    ground, request
        Where and how fires burn.
    plans
        n times breaks.
    known
        Of the same ground and request; what burns here is kept there.

    Returns
    -------
    numpy.ndarray
        (n_runs, n) int64 cells burnt in every run; float64 with lines.
    """
    known = Sizes() if known is None else known
    burnt = []
    for k, breaks in enumerate(plans):
        step = part(progress, k / len(plans), (k + 1) / len(plans))
        sizes = known.of(breaks)
        if sizes is None:
            burns = burn_on(ground, request, breaks=breaks, threads=threads, progress=step)
            sizes = known.keep(breaks, burns["fire_size"].to_numpy())
        burnt.append(sizes)
    return np.stack(burnt, axis=1)


def _curve(network: SpreadNetwork, burnt: np.ndarray, budgets: Sequence[float] | np.ndarray, seed: int) -> xr.DataArray:
    import xarray as xr

    return xr.DataArray(
        burnt,
        dims=("run", "budget"),
        coords={"budget": ("budget", np.asarray(budgets, dtype=np.float64), {"units": "1", "long_name": "d_f"})},
        name="cells_burnt",
        attrs={"n_burnable": network.n_burnable, "seed": seed},
    )


def cut_levels(
    network: SpreadNetwork, priority: np.ndarray | xr.DataArray, budgets: Sequence[float] | np.ndarray
) -> np.ndarray:
    """Last budget at which each cell is still there.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int32: index into `budgets`; -1 if the cell is cut at all of them.

    Raises
    ------
    ParameterError
        If the budgets do not rise or are not shares.
    """
    if len(budgets) == 0 or np.any(np.diff(budgets) < 0):
        raise ParameterError("budgets must be a rising list of shares, for example 0.0, 0.05, 0.1")
    cut = [Budget(budget).cells(n_burnable=network.n_burnable) for budget in budgets]
    return first_cut(network.plane(priority, "priority"), cut) - np.int32(1)
