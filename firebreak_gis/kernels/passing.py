"""What burns by way of each cell in fires with a clock, over the tree of who lit whom."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.arrival import UNSEEN, Clock, Starts, Workspace, burn_run
from firebreak_gis.kernels.draws import Thresholds
from firebreak_gis.kernels.embers import Embers
from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.kernels.tally import comes_to
from firebreak_gis.kernels.walls import Cleared, Walls

_ONE = np.uint64(1)


@kernel
def let_through(
    thresholds: Thresholds,
    keys: np.ndarray,
    steps: Steps,
    clock: Clock,
    starts: Starts,
    walls: Walls,
    cleared: Cleared,
    embers: Embers,
    space: Workspace,
    runs: np.ndarray,
    value: np.ndarray,
    hanging: np.ndarray,
    through: np.ndarray,
    rim: np.ndarray,
    reached: np.ndarray,
) -> float:
    """Burn runs, and add up the value that each cell lets through: its own and that of all that it lit, in turn.

    Parameters
    ----------
    thresholds, keys, steps, clock, starts, walls, cleared, embers, space, runs
        As in `arrival.burn_timed`.
    value
        (n_cells,) float64 lost when the cell burns.
    hanging
        (n_cells,) float64, zero between runs.
    through
        (n_cells,) float64, added to.
    rim, reached
        As in `tally.Tally`: a run that comes to the rim is marked, and nothing of it is added. Empty where there is
        none.

    Returns
    -------
    float
        Value lost, summed over the runs.
    """
    order, parent, arrival = space.order, space.parent, space.arrival  # by plain names, see `arrival.burn_run`
    lost = 0.0
    for k in range(runs.size):
        run = runs[k]
        size = burn_run(thresholds, keys[run], steps, clock, starts, walls, cleared, embers, space, run)
        if comes_to(rim, order, size):
            reached[run] = True
            for i in range(size):
                arrival[order[i]] = UNSEEN
            continue
        for i in range(size):
            cell = order[size - _ONE - np.uint64(i)]
            whole = hanging[cell] + value[cell]
            hanging[cell] = 0.0
            through[cell] += whole
            lost += value[cell]
            if parent[cell] != cell:
                hanging[parent[cell]] += whole
            arrival[cell] = UNSEEN
    return lost
