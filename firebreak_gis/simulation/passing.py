"""What burns by way of each cell in fires with a clock."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.simulation.timed import Spaces, made_ready

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.window import Window


def let_through(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    *,
    value: np.ndarray,
    chosen: np.ndarray,
    window: Window,
    reach: int,
    **fires: Any,
) -> tuple[np.ndarray, np.ndarray]:
    """Value that each cell lets through, summed over chosen runs on the calling thread.

    Parameters as in `burn_timed`.

    Returns
    -------
    through : numpy.ndarray
        (n_cells,) float64.
    reached : numpy.ndarray
        (n_runs,) bool: runs that came to the rim of the window, of which nothing is added.
    """
    from firebreak_gis.kernels.passing import let_through as hand_up

    spaces, hanging, out = Spaces(), np.zeros(value.size), np.zeros(value.size)
    reached = np.zeros(request.n_runs, bool)
    rim = np.zeros(0, bool) if window.whole else window.rim(reach).ravel()
    for ready in made_ready(network, request, start, limits, chosen=chosen, window=window, **fires):
        space = spaces.mine(value.size, ready.span)
        hand_up(*ready.given, space, ready.group.runs, value, hanging, out, rim, reached)
    return out, reached
