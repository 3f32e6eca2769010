"""What burns by way of each cell in fires with a clock."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.simulation.timed import Spaces, made_ready

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest


def let_through(
    network: SpreadNetwork,
    request: FireRequest,
    start: Ignitions,
    limits: np.ndarray,
    *,
    value: np.ndarray,
    chosen: np.ndarray,
    **fires: Any,
) -> np.ndarray:
    """Value that each cell lets through, summed over chosen runs on the calling thread, (n_cells,) float64.

    Parameters as in `burn_timed`.
    """
    from firebreak_gis.kernels.passing import let_through as hand_up

    spaces, hanging, out = Spaces(), np.zeros(value.size), np.zeros(value.size)
    for ready in made_ready(network, request, start, limits, chosen=chosen, **fires):
        hand_up(*ready.given, spaces.mine(value.size, ready.span), ready.group.runs, value, hanging, out)
    return out
