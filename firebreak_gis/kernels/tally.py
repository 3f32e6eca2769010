"""What is kept of fires with a clock: everything is added up a cell or a run, nothing a cell and run.

What is not asked for is an empty array.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.percolation import Steps
from firebreak_gis.kernels.policy import inlined, kernel
from firebreak_gis.kernels.walls import Cleared, Walls, spared, spared_of

_ZERO = np.uint64(0)
_ONE = np.uint64(1)
_NOT = np.uint32(0xFFFFFFFF)


class Tally(NamedTuple):
    """Sums over the runs.

    Parameters
    ----------
    counts
        (n_cells,) uint32 runs in which the cell burns.
    unit
        In how many parts of a cell `sizes`, `growth` and `classes` are told: 1, or `walls.GROUND` where lines clear
        ground, which then does not count as burnt.
    sizes
        (n_runs,) int64 burnt [cells / unit].
    value
        (n_cells,) float64 lost when the whole cell burns.
    lost
        (n_runs,) float64 sum of it over the burnt cells, in the order in which they burn.
    edges
        (n_bins,) uint64, rising [s].
    by_time
        (n_cells, n_bins) uint32 runs in which fire arrives after the edge before and not after this one.
    growth
        (n_runs, n_bins) int64 burnt by each edge [cells / unit].
    classes
        (n_classes,) int64, rising: largest fire of each class but the last [cells / unit].
    by_size
        (n_cells, n_classes) uint32 runs in which the cell burns in a fire of the class.
    hanging
        (n_cells,) uint32, zero between runs: for `onwards`.
    onwards
        (n_cells,) uint64 sum over the runs of the cells that the fire reached by way of this one.
    heat
        (n_cells,) float32 [kJ/m2].
    lengths
        (8,) float64 [m] along the map.
    intensities
        (n_limits,) float64 [kW/m].
    above
        (n_cells, n_limits) uint32 runs in which the fire that comes to the cell is stronger than the limit.
    arrivals
        (n_runs, n_cells) uint32 arrival [s], 0xFFFFFFFF where the run does not burn.
    rim
        (n_cells,) bool: cells from which fire could leave a window of the map. A run that burns one is not added.
    reached
        (n_runs,) bool, set where that happens.
    """

    counts: np.ndarray
    unit: int
    sizes: np.ndarray
    value: np.ndarray
    lost: np.ndarray
    edges: np.ndarray
    by_time: np.ndarray
    growth: np.ndarray
    classes: np.ndarray
    by_size: np.ndarray
    hanging: np.ndarray
    onwards: np.ndarray
    heat: np.ndarray
    lengths: np.ndarray
    intensities: np.ndarray
    above: np.ndarray
    arrivals: np.ndarray
    rim: np.ndarray
    reached: np.ndarray


@inlined
def comes_to(rim: np.ndarray, order: np.ndarray, size: np.uint64) -> bool:
    """Whether any of the first `size` cells of `order` is on a rim, (n_cells,) bool, or empty where there is none."""
    reached = False
    if rim.size > 0:
        for i in range(size):
            if rim[order[i]]:
                reached = True
                break
    return reached


@kernel
def add_run(
    tally: Tally,
    run: int,
    order: np.ndarray,
    size: np.uint64,
    arrival: np.ndarray,
    parent: np.ndarray,
    steps: Steps,
    strongest: np.ndarray,
    walls: Walls,
    cleared: Cleared,
) -> None:
    """Add one run.

    Parameters
    ----------
    order, size
        The first `size` entries are the burnt cells, each after the one that lit it.
    arrival
        (n_cells,) uint64 [s], of the burnt cells.
    parent
        (n_cells,) uint32 cell that lit each burnt cell; itself if an ignition.
    steps
        Of the grid.
    strongest
        (n_cells,) float32 intensity of a fire that starts in the cell [kW/m].
    walls, cleared
        Breaks, and how they hold.
    """
    if comes_to(tally.rim, order, size):
        tally.reached[run] = True
        return
    burnt = np.int64(size) * tally.unit
    first, none = cleared.first, np.uint32(cleared.ground.shape[0])  # a look that spares most calls
    # Arrays by plain names in loops over what burns, see `arrival.burn_run`.
    counts = tally.counts
    for i in range(size):
        counts[order[i]] += np.uint32(1)
    key, ground, residual, crews = walls.keys[run], cleared.ground, walls.residual, walls.crews
    value, valued, clears = tally.value, tally.value.size > 0, none > 0
    alike, awaited = residual.size == 1, crews.size > 0
    total = 0.0
    for i in range(size):
        cell = order[i]
        share = 1.0
        if clears and first[cell] < none:
            keeps = residual[0 if alike else cell]
            if awaited and arrival[cell] < crews[cell]:
                keeps = 1.0
            left = spared_of(key, first[cell], ground, np.uint64(cell), keeps)
            burnt -= left
            share -= left / tally.unit
        if valued:
            total += value[cell] * share
    tally.sizes[run] = burnt
    if valued:
        tally.lost[run] = total
    if tally.by_time.size > 0 or tally.growth.size > 0:
        _by_time(tally, run, order, size, arrival, walls, cleared)
    if tally.by_size.size > 0:
        k, by_size = np.searchsorted(tally.classes, burnt), tally.by_size
        for i in range(size):
            by_size[order[i], k] += np.uint32(1)
    if tally.onwards.size > 0:
        below, onwards = tally.hanging, tally.onwards
        for i in range(size):
            cell = order[size - _ONE - np.uint64(i)]
            hanging = below[cell]
            below[cell] = np.uint32(0)
            onwards[cell] += np.uint64(hanging)
            if parent[cell] != cell:
                below[parent[cell]] += hanging + np.uint32(1)
    if tally.above.size > 0:
        _by_intensity(tally, order, size, arrival, parent, steps, strongest)
    if tally.arrivals.size > 0:
        arrivals = tally.arrivals
        for i in range(size):
            arrivals[run, order[i]] = np.uint32(min(arrival[order[i]], np.uint64(_NOT - np.uint32(1))))


@kernel
def _by_time(
    tally: Tally,
    run: int,
    order: np.ndarray,
    size: np.uint64,
    arrival: np.ndarray,
    walls: Walls,
    cleared: Cleared,
) -> None:
    edges, by_time, growth, clears = tally.edges, tally.by_time, tally.growth, tally.unit > 1
    first, none = cleared.first, np.uint32(cleared.ground.shape[0])
    mapped, grows = by_time.size > 0, growth.size > 0
    k = 0
    for i in range(size):
        cell = order[i]
        t = arrival[cell]
        # Cells come nearly in the order of time.
        while k < edges.size and edges[k] < t:
            k += 1
        while k > 0 and edges[k - 1] >= t:
            k -= 1
        if k < edges.size:
            if mapped:
                by_time[cell, k] += np.uint32(1)
            if grows:
                growth[run, k] += tally.unit
                if clears and first[cell] < none:
                    growth[run, k] -= spared(walls, cleared, run, np.uint64(cell), t)
    if grows:
        for k in range(1, edges.size):
            growth[run, k] += growth[run, k - 1]


@kernel
def _by_intensity(
    tally: Tally,
    order: np.ndarray,
    size: np.uint64,
    arrival: np.ndarray,
    parent: np.ndarray,
    steps: Steps,
    strongest: np.ndarray,
) -> None:
    """Count how strong the fire is that comes to each cell: heat of the cell times the rate at which fire came.

    Where no neighbour lit the cell, the strongest fire that the cell can have is taken.
    """
    offsets, positions, heat, lengths = steps.offsets, steps.position, tally.heat, tally.lengths
    limits, above = tally.intensities, tally.above
    for i in range(size):
        cell = np.uint64(order[i])
        source = np.uint64(parent[cell])
        intensity = np.float64(strongest[cell])
        position = np.uint8(0)
        if positions.size > 0:
            position = positions[source]
        for d in range(8):
            if source != cell and source + offsets[position, d] == cell:
                intensity = heat[cell] * lengths[d] / np.float64(arrival[cell] - arrival[source])
        for k in range(limits.size):
            if intensity > limits[k]:
                above[cell, k] += np.uint32(1)
