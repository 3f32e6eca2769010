"""Betweenness and closeness: sums over the searches from many sources.

Sources are taken in batches whose size depends on the grid alone. Threads work on batches; the batches' sums
are added in the order of the batches. Results are the same bits for any number of threads.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from queue import SimpleQueue
from typing import TypeVar

import numpy as np

from firebreak_gis.kernels.draws import stream_key, uniforms
from firebreak_gis.kernels.paths import UNIT, Lattice, Workspace, betweenness_batch, distance_batch, lattice
from firebreak_gis.progress import Progress, silent
from firebreak_gis.threads import thread_count

T = TypeVar("T")

#: Cells visited by a batch, about; at most this many sources a batch.
_BATCH_CELLS, _BATCH_SOURCES = 1_000_000, 64
#: Seconds between two calls of the progress callback while a batch runs.
_PATIENCE = 0.3
#: Factor from one look at the error bound to the next.
_GROWTH = 1.25


@dataclass(frozen=True)
class Sample:
    """Betweenness estimated from a sample of sources.

    Parameters
    ----------
    values
        (rows, cols) float64, estimated betweenness.
    pivots
        Sources used; the number of burnable cells if the result is exact.
    epsilon
        Bound of the error of all cells at once, as a share of the n (n - 1) ordered pairs of cells.
    """

    values: np.ndarray
    pivots: int
    epsilon: float


def betweenness(
    probability: np.ndarray,
    burnable: np.ndarray,
    *,
    boundary: str = "open",
    threads: int | None = None,
    progress: Progress = silent,
) -> np.ndarray:
    """Exact betweenness of every cell (Brandes 2001, doi 10.1080/0022250X.2001.9990249).

    Cost: one search a burnable cell, about 35 ns a cell each, so it grows with the square of the cells. Memory:
    32 B a cell (64 B if any p is below 1/256) and about 60 B a cell and thread.

    Parameters
    ----------
    probability
        (8, rows, cols) float32; an edge is 1/p long (see `paths`).
    burnable
        (rows, cols) bool: the cells that are sources and targets.
    boundary
        `"open"` or `"periodic"`.
    threads
        Number of threads; None: as many as the process may use.
    progress
        Callback.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64: over all ordered pairs of other cells, the share of shortest paths through the cell,
        summed. Pairs without a path count nothing.
    """
    network = lattice(probability, burnable, boundary=boundary)
    total = np.zeros(network.lengths.shape[0])
    n_cells = network.cells.size
    with Searches(network, threads) as searches:
        for done in searches.add_dependencies(network.cells, total):
            progress(done / max(n_cells, 1), f"{done} of {n_cells} sources")
    return without_rim(total, network)


def sampled_betweenness(
    probability: np.ndarray,
    burnable: np.ndarray,
    *,
    boundary: str = "open",
    pivots: int = 0,
    epsilon: float = 0.05,
    delta: float = 0.1,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress = silent,
) -> Sample:
    """Estimate betweenness from the searches of sources drawn without replacement (Brandes, Pich 2007).

    With probability of at least 1 - delta the error of every cell is at most `Sample.epsilon`, as a share of the
    n (n - 1) ordered pairs. A source's dependency on a cell, over n - 1, is a number from 0 to 1; Hoeffding's bound
    in its relative-entropy form (1963, doi 10.1080/01621459.1963.10500830, theorem 1 and section 6) holds for its
    mean over k sources, with delta shared among cells, sides and looks. It depends on the largest estimate m alone
    and falls from sqrt(m L / k) to L / k, L = log(2 n / delta), where no cell lies on many paths.

    Parameters
    ----------
    probability, burnable, boundary, threads, progress
        As for `betweenness`.
    pivots
        Number of sources; 0: as many as `epsilon` needs, looked at after numbers of sources that grow by a quarter.
    epsilon, delta
        Error allowed and chance of exceeding it.
    seed
        Seed of the draws (purpose "pivots").
    """
    network = lattice(probability, burnable, boundary=boundary)
    n_cells = network.cells.size
    key = stream_key(seed, "pivots")
    sources = network.cells[np.argsort(uniforms(key, n_cells), kind="stable")]
    total = np.zeros(network.lengths.shape[0])
    used, bound, largest, shown = 0, 1.0, 0.02, 0.0
    with Searches(network, threads) as searches:
        for look, goal in enumerate(_looks(n_cells, pivots, epsilon, delta)):
            chance = delta if pivots else delta / ((look + 1) * (look + 2))
            needed = goal if pivots else _pivots_for(largest, n_cells, epsilon, chance)
            for done in searches.add_dependencies(sources[used:goal], total):
                shown = max(shown, min(0.99, (used + done) / max(goal, min(needed, n_cells))))
                progress(shown, f"{used + done} pivots, error below {bound:.3g}")
            used = goal
            largest = float(total.max()) / (used * max(n_cells - 1, 1))
            bound = error_bound(largest, used, n_cells, chance)
            if not pivots and bound <= epsilon:
                break
    progress(1.0, f"{used} pivots, error below {bound:.3g}")
    scale = n_cells / used if used else 1.0
    return Sample(without_rim(total * scale, network), used, bound if used else 0.0)


def percolation(
    probability: np.ndarray,
    burnable: np.ndarray,
    states: np.ndarray,
    *,
    pivots: int = 0,
    seed: int = 0,
    boundary: str = "open",
    threads: int | None = None,
    progress: Progress = silent,
) -> np.ndarray:
    """Percolation centrality (Piraveenan, Prokopenko, Hossain 2013, doi 10.1371/journal.pone.0053095).

    Parameters
    ----------
    probability, burnable, boundary, threads, progress
        As for `betweenness`.
    states
        (rows, cols) float64 of at least 0: how much each cell already burns.
    pivots
        0: every cell is a source. Else so many sources are drawn in proportion to their states; with probability
        1 - delta the sum over sources is off by at most sqrt(log(2 n / delta) / (2 pivots)) of the sum of states
        times n - 1 (Hoeffding's bound).
    seed
        Seed of the draws (purpose "pivots").

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64: the mean share of shortest paths through the cell over its n - 2 possible targets and
        over sources weighted by their states; 0 where no other cell has a state.
    """
    network = lattice(probability, burnable, boundary=boundary)
    x = np.asarray(states, dtype=np.float64)[burnable]
    total = np.zeros(network.lengths.shape[0])
    n_cells = network.cells.size
    sources, weights = network.cells[x > 0.0], x[x > 0.0]
    if pivots and sources.size:
        heap = np.cumsum(weights)
        drawn = np.searchsorted(heap, uniforms(stream_key(seed, "pivots"), pivots) * heap[-1], side="right")
        sources = sources[np.minimum(drawn, sources.size - 1)]
        weights = np.full(pivots, heap[-1] / pivots)
    with Searches(network, threads) as searches:
        for done in searches.add_dependencies(sources, total, weights):
            progress(done / max(sources.size, 1), f"{done} of {sources.size} sources")
    others = np.zeros(burnable.shape)
    others[burnable] = (x.sum() - x) * max(n_cells - 2, 1)
    sums = without_rim(total, network)
    return np.divide(sums, others, out=np.zeros(burnable.shape), where=others > 1e-12 * max(float(x.sum()), 1e-300))


def error_bound(largest: float, pivots: int, n_cells: int, delta: float) -> float:
    """Error, as a share of ordered pairs, that no cell exceeds with probability 1 - delta.

    Parameters
    ----------
    largest
        Largest estimated betweenness of all cells, as a share of ordered pairs.
    pivots
        Sources drawn without replacement from `n_cells`; 0 error if these are all.
    n_cells
        Burnable cells.
    delta
        Chance of exceeding the bound.
    """
    if pivots >= n_cells:
        return 0.0
    room = math.log(2.0 * n_cells / delta) / pivots
    low, high = largest, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _entropy(largest, middle) <= room else (low, middle)
    # Up to 1/2 the deviation grows with the estimate and is the wider one upwards, so the largest estimate decides.
    return high - largest if high <= 0.5 else min(1.0, math.sqrt(0.5 * room))


def closeness(
    probability: np.ndarray,
    burnable: np.ndarray,
    *,
    boundary: str = "open",
    transpose: bool = False,
    threads: int | None = None,
    progress: Progress = silent,
) -> np.ndarray:
    """Exact closeness of every cell: r / (n - 1) * r / (sum of distances), r the cells reached of n - 1 others.

    Cost and memory as for `betweenness`.

    Parameters
    ----------
    probability, burnable, boundary, threads, progress
        As for `betweenness`.
    transpose
        Whether distances to the cell count, in place of distances from it.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64; 0 for a cell that reaches none.
    """
    network = lattice(probability, burnable, boundary=boundary, transpose=transpose)
    n_cells = network.cells.size
    sums, reached = np.zeros(n_cells), np.zeros(n_cells, dtype=np.int64)
    with Searches(network, threads) as searches:
        for done in searches.sum_distances(network.cells, sums, reached):
            progress(done / max(n_cells, 1), f"{done} of {n_cells} sources")
    scores = np.zeros(burnable.shape)
    some = reached > 0
    values = np.zeros(n_cells)
    values[some] = reached[some] / (n_cells - 1) * (reached[some] / (sums[some] * UNIT))
    scores[burnable] = values
    return scores


class Searches:
    """Threads with a workspace each, working through batches of sources."""

    def __init__(self, network: Lattice, threads: int | None) -> None:
        n_cells = network.lengths.shape[0]
        self.network = network
        self.batch = max(1, min(_BATCH_SOURCES, _BATCH_CELLS // n_cells))
        self.threads = max(1, min(thread_count(threads), -(-network.cells.size // self.batch)))
        self._free: SimpleQueue[Workspace] = SimpleQueue()
        for _ in range(self.threads):
            self._free.put(Workspace(network))
        self._spare: list[np.ndarray] = []
        self._pool = ThreadPoolExecutor(self.threads)

    def __enter__(self) -> Searches:
        return self

    def __exit__(self, *error: object) -> None:
        self._pool.shutdown(cancel_futures=True)

    def add_dependencies(
        self, sources: np.ndarray, total: np.ndarray, weights: np.ndarray | None = None
    ) -> Iterator[int]:
        """Add the dependencies of `sources`, each times its weight (1), to `total`; yields the sources done."""
        factors = np.ones(sources.size) if weights is None else weights

        def batch(space: Workspace, chosen: slice, part: np.ndarray) -> None:
            betweenness_batch(sources[chosen], factors[chosen], *self.graph(), *space.labels, *space.counts, part)

        yield from self.add(sources.size, batch, total)

    def add(
        self, n_sources: int, batch: Callable[[Workspace, slice, np.ndarray], None], total: np.ndarray
    ) -> Iterator[int]:
        """Add to `total` what `batch(space, chosen, part)` writes to `part`; yields the sources done."""

        def run(first: int) -> np.ndarray:
            part = self._spare.pop() if self._spare else np.empty_like(total)
            with self._space() as space:
                batch(space, slice(first, first + self.batch), part)
            return part

        def take(part: np.ndarray) -> None:
            np.add(total, part, out=total)
            self._spare.append(part)

        yield from self._in_order(n_sources, run, take)

    def sum_distances(self, sources: np.ndarray, sums: np.ndarray, reached: np.ndarray) -> Iterator[int]:
        """Write each source's sum of distances and number of cells reached; yields the sources done."""

        def batch(first: int) -> None:
            chosen = slice(first, first + self.batch)
            with self._space() as space:
                distance_batch(sources[chosen], *self.graph(), *space.labels, sums[chosen], reached[chosen])

        yield from self._in_order(sources.size, batch, lambda _: None)

    @contextmanager
    def _space(self) -> Iterator[Workspace]:
        """A workspace of the calling thread; put back whatever happens, or the other batches would wait for ever."""
        space = self._free.get()
        try:
            yield space
        finally:
            self._free.put(space)

    def _in_order(self, n_sources: int, batch: Callable[[int], T], take: Callable[[T], None]) -> Iterator[int]:
        """Run the batches, a few ahead, and take their results in order."""
        waiting: deque[tuple[int, Future[T]]] = deque()
        starts = iter(range(0, n_sources, self.batch))
        done = 0
        for _ in range(self.threads + 1):
            self._submit(waiting, starts, batch)
        while waiting:
            first, future = waiting.popleft()
            while not future.done():
                try:
                    future.result(timeout=_PATIENCE)
                except TimeoutError:
                    yield done
            take(future.result())
            self._submit(waiting, starts, batch)
            done = min(first + self.batch, n_sources)
            yield done

    def _submit(self, waiting: deque[tuple[int, Future[T]]], starts: Iterator[int], batch: Callable[[int], T]) -> None:
        first = next(starts, None)
        if first is not None:
            waiting.append((first, self._pool.submit(batch, first)))

    def graph(self) -> tuple[np.ndarray, np.uint64, np.ndarray, np.ndarray, np.uint64]:
        """Arguments of the kernels that say what is searched."""
        network = self.network
        return network.lengths, network.absent, network.offset, network.home, network.shift


def without_rim(values: np.ndarray, network: Lattice) -> np.ndarray:
    """(rows, cols) of a flat array over the grid with its rim."""
    rows, cols = network.shape
    return values.reshape(rows + 2, cols + 2)[1:-1, 1:-1].copy()


def _looks(n_cells: int, pivots: int, epsilon: float, delta: float) -> Iterator[int]:
    """Numbers of sources after which the bound is looked at; fixed beforehand, as the bound requires."""
    if pivots:
        yield min(pivots, n_cells)
        return
    goal = _pivots_for(0.0, n_cells, epsilon, 0.5 * delta)
    while goal < n_cells:
        yield goal
        goal = math.ceil(goal * _GROWTH)
    yield n_cells


def _pivots_for(largest: float, n_cells: int, epsilon: float, delta: float) -> int:
    """Sources that bring the bound down to epsilon if the largest estimate stays."""
    entropy = _entropy(largest, largest + epsilon) if largest + epsilon <= 0.5 else 2.0 * epsilon**2
    return math.ceil(math.log(2.0 * max(n_cells, 1) / delta) / entropy)


def _entropy(p: float, q: float) -> float:
    """Relative entropy of coins with chances p and q."""
    first = p * math.log(p / q) if p > 0.0 else 0.0
    second = (1.0 - p) * math.log((1.0 - p) / (1.0 - q)) if p < 1.0 and q < 1.0 else (0.0 if p >= q else math.inf)
    return first + second
