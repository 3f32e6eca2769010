"""Betweenness of groups of cells: which routes a cell covers that a group leaves open."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.centrality import Searches, without_rim
from firebreak_gis.kernels.draws import stream_key, uniforms
from firebreak_gis.kernels.paths import FULL, LOWEST, UNREACHED, Lattice, Workspace, count_paths, lattice, search
from firebreak_gis.kernels.policy import kernel
from firebreak_gis.progress import Progress, silent


def uncovered(
    probability: np.ndarray,
    burnable: np.ndarray,
    *,
    boundary: str = "open",
    pivots: int = 0,
    seed: int = 0,
    threads: int | None = None,
) -> Uncovered:
    """Prepare to ask what a cell adds to the betweenness of a group of cells, see `Uncovered`."""
    network = lattice(probability, burnable, boundary=boundary)
    sources = network.cells
    if 0 < pivots < sources.size:
        sources = sources[np.argsort(uniforms(stream_key(seed, "pivots"), sources.size), kind="stable")[:pivots]]
    return Uncovered(network, sources, threads)


class Uncovered:
    """Betweenness that a cell adds to that of a group: pairs whose routes the group covers count no more.

    Parameters
    ----------
    network, sources
        The lattice and the sources whose routes are counted.
    threads
        Number of threads.
    """

    def __init__(self, network: Lattice, sources: np.ndarray, threads: int | None) -> None:
        self._network, self._sources, self._threads = network, sources, threads

    def gains(self, group: np.ndarray, *, progress: Progress = silent) -> np.ndarray:
        """Sum over pairs outside the group of the share of shortest paths through a cell and past the group.

        Parameters
        ----------
        group
            (rows, cols) bool: the cells of the group.

        Returns
        -------
        numpy.ndarray
            (rows, cols) float64, scaled up to all sources; 0 in the group.
        """
        rows, cols = self._network.shape
        inside = np.zeros((rows + 2, cols + 2), dtype=np.uint8)
        inside[1:-1, 1:-1] = group
        flat = inside.ravel()
        sources = self._sources[flat[self._sources] == 0]
        total = np.zeros(flat.size)

        def batch(space: Workspace, chosen: slice, part: np.ndarray) -> None:
            past = np.empty(flat.size)
            _uncovered_batch(sources[chosen], flat, *searches.graph(), *space.labels, *space.counts, past, part)

        with Searches(self._network, self._threads) as searches:
            for done in searches.add(sources.size, batch, total):
                progress(done / max(sources.size, 1), f"{done} of {sources.size} sources")
        return without_rim(total * (self._network.cells.size / max(self._sources.size, 1)), self._network)


@kernel
def _uncovered_batch(
    sources: np.ndarray,
    group: np.ndarray,
    lengths: np.ndarray,
    absent: np.uint64,
    offset: np.ndarray,
    home: np.ndarray,
    shift: np.uint64,
    distance: np.ndarray,
    came_from: np.ndarray,
    order: np.ndarray,
    head: np.ndarray,
    entry: np.ndarray,
    paths: np.ndarray,
    exponent: np.ndarray,
    dependency: np.ndarray,
    past: np.ndarray,
    total: np.ndarray,
) -> None:
    """Write to `total` the share of shortest paths from all `sources` through a cell and past `group`, summed.

    Targets in the group do not count. `past` (the share of the paths from the source to a cell that pass the group
    by) is work space; `dependency` is 0 before and after.
    """
    periodic = home.size > 0
    total[:] = 0.0
    for k in range(sources.size):
        distance[:] = UNREACHED
        count, _ = search(
            np.uint64(sources[k]), lengths, absent, offset, home, shift, distance, came_from, order, head, entry
        )
        count_paths(count, offset, home, paths, exponent, came_from, order)
        past[order[0]] = 1.0
        for i in range(1, count):
            cell = np.uint64(order[i])
            share = 0.0
            bits = came_from[cell]
            while bits != 0 and group[cell] == 0:
                before = cell - offset[LOWEST[bits]]
                if periodic:
                    before = np.uint64(home[before])
                share += past[before] * _ratio(paths[before], exponent[before], paths[cell], exponent[cell])
                bits &= bits - np.uint8(1)
            past[cell] = share
        for i in range(count - 1, 0, -1):
            cell = np.uint64(order[i])
            behind = dependency[cell]
            dependency[cell] = 0.0
            if group[cell] != 0:
                continue
            total[cell] += past[cell] * behind
            bits = came_from[cell]
            while bits != 0:
                before = cell - offset[LOWEST[bits]]
                if periodic:
                    before = np.uint64(home[before])
                dependency[before] += _ratio(paths[before], exponent[before], paths[cell], exponent[cell]) * (
                    1.0 + behind
                )
                bits &= bits - np.uint8(1)
        dependency[order[0]] = 0.0


@kernel
def _ratio(paths: float, exponent: int, of_paths: float, of_exponent: int) -> float:
    """Quotient of two path counts, which are `paths` * 2**(512 * `exponent`)."""
    behind = of_exponent - exponent
    if behind <= 0:
        return paths / of_paths
    return paths / FULL / of_paths if behind == 1 else 0.0
