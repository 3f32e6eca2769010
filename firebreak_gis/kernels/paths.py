"""Shortest paths on the implicit grid: the search that betweenness and closeness share.

The length of an edge is 1/p, rounded to a multiple of 2**-24 (at most 3e-8 of it) and capped at 2**40; an edge
with p = 0 does not exist. Distances are kept in units of 2**-24 as float64, so sums up to 2**29 are exact in
any order: two routes made of the same lengths tie exactly, whatever the order of their edges, and a mirrored
network has the mirrored shortest paths.

No length is below 1. With buckets as wide as the largest power of two that no length falls below, a cell in the
first filled bucket cannot be improved by another cell of that bucket: the bucket is settled in any order, and no
heap is needed. Buckets form a ring; labels beyond it wait on one list until the ring comes near. A cell notes the
directions from which it is reached in one byte, which replaces lists of predecessors.

The grid is stored with a rim of one cell, flat. `home` maps rim cells of a periodic grid to the cells that
they stand for.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from firebreak_gis.kernels.policy import kernel
from firebreak_gis.lattice import COL_STEP, OPPOSITE, ROW_STEP

#: Unit of lengths and distances.
UNIT = 2.0**-24
#: Distance, in units, of a cell that is not reached, and length of an edge that does not exist.
UNREACHED = 2.0**80
_ABSENT = 2.0**81
_LONGEST = 2.0**64
#: Most buckets in the ring.
_RING = 1 << 12
#: Path counts are kept below this; the excess goes to an exponent.
_FULL = 2.0**512
_NONE = np.uint32(0xFFFFFFFF)
_ZERO, _ONE = np.uint64(0), np.uint64(1)
#: Lowest set bit of a byte.
_LOWEST = np.array([0] + [(b & -b).bit_length() - 1 for b in range(1, 256)], dtype=np.uint8)


@dataclass(frozen=True)
class Lattice:
    """The network as the search reads it.

    Parameters
    ----------
    lengths
        (rim cells, 8) float64: length of the edge to the neighbour in each direction, in units; 64 B a cell.
    offset
        (8,) uint64: step to the neighbour in the flat grid, modulo 2**64.
    home
        (rim cells,) uint32 for a periodic grid, else empty.
    cells
        (burnable cells,) uint32: flat index of every burnable cell in row-major order.
    shape
        (rows, cols) without the rim.
    scale
        1 / width of a bucket.
    ring
        Buckets in the ring, a power of two.
    """

    lengths: np.ndarray
    offset: np.ndarray
    home: np.ndarray
    cells: np.ndarray
    shape: tuple[int, int]
    scale: float
    ring: int


def edge_lengths(probability: np.ndarray) -> np.ndarray:
    """Lengths of edges as the search uses them, float64; infinite where p = 0."""
    p = np.asarray(probability, dtype=np.float64)
    with np.errstate(divide="ignore"):
        units = np.minimum(np.rint((1.0 / UNIT) / p), _LONGEST)
    return np.where(p > 0.0, units * UNIT, np.inf)


def lattice(
    probability: np.ndarray, burnable: np.ndarray, *, boundary: str = "open", transpose: bool = False
) -> Lattice:
    """Prepare a network for searches.

    Parameters
    ----------
    probability
        (8, rows, cols) float32, `probability[d, row, col]` from the cell to its neighbour in direction d.
    burnable
        (rows, cols) bool.
    boundary
        `"open"` or `"periodic"`.
    transpose
        Whether to turn every edge round: the search then finds distances TO its source.
    """
    _, rows, cols = probability.shape
    width = cols + 2
    planes = np.zeros((8, rows + 2, width), dtype=np.float32)
    planes[:, 1:-1, 1:-1] = probability
    number = np.zeros((rows + 2, width), dtype=np.uint32)
    number[1:-1, 1:-1] = (np.arange(1, rows + 1)[:, None] * width + np.arange(1, cols + 1)).astype(np.uint32)
    if boundary == "periodic":
        for array in (*planes, number):
            array[0], array[-1] = array[-2], array[1]
            array[:, 0], array[:, -1] = array[:, -2], array[:, 1]
    lengths = np.full(((rows + 2), width, 8), _ABSENT)
    shortest, longest = np.inf, 0.0
    for d in range(8):
        r, c = ROW_STEP[d], COL_STEP[d]
        if transpose:  # the edge from the neighbour to the cell
            source = planes[OPPOSITE[d], 1 + r : rows + 1 + r, 1 + c : cols + 1 + c]
        else:
            source = planes[d, 1:-1, 1:-1]
        exists = source > 0
        units = edge_lengths(source[exists]) / UNIT
        lengths[1:-1, 1:-1, d][exists] = units
        if units.size:
            shortest, longest = min(shortest, float(units.min())), max(longest, float(units.max()))
    bucket = 2.0 ** np.floor(np.log2(shortest)) if np.isfinite(shortest) else 1.0
    reach = min(longest / bucket + 3.0, float(_RING))
    return Lattice(
        lengths=lengths.reshape(-1, 8),
        offset=np.array([r * width + c for r, c in zip(ROW_STEP, COL_STEP, strict=True)], dtype=np.int64).view(
            np.uint64
        ),
        home=number.ravel() if boundary == "periodic" else np.empty(0, dtype=np.uint32),
        cells=number[1:-1, 1:-1][np.asarray(burnable)],
        shape=(rows, cols),
        scale=float(1.0 / bucket),
        ring=1 << int(np.ceil(np.log2(reach))),
    )


class Workspace:
    """What one thread needs for its searches, about 50 B a cell.

    Parameters
    ----------
    network
        The lattice to be searched.
    """

    def __init__(self, network: Lattice) -> None:
        n_cells = network.lengths.shape[0]
        self.distance = np.full(n_cells, UNREACHED)
        self.paths = np.empty(n_cells)
        self.exponent = np.zeros(n_cells, dtype=np.int16)
        self.dependency = np.empty(n_cells)
        self.came_from = np.empty(n_cells, dtype=np.uint8)
        self.order = np.empty(n_cells, dtype=np.uint32)
        self.head = np.full(network.ring, _NONE, dtype=np.uint32)
        # A cell is put into a bucket at most once an edge; untouched pages cost nothing.
        self.entry = np.empty((8 * n_cells + 1, 2), dtype=np.uint32)


@kernel
def search(
    source: np.uint64, lengths: np.ndarray, offset: np.ndarray, home: np.ndarray, scale: float, distance: np.ndarray,
    paths: np.ndarray, exponent: np.ndarray, came_from: np.ndarray, order: np.ndarray, head: np.ndarray,
    entry: np.ndarray, counting: bool,
) -> int:  # fmt: skip
    """Settle all cells that `source` reaches; returns their number.

    `distance` must be `UNREACHED` everywhere and `head` empty (it is left empty). Fills `order` (cells by
    bucket), `distance`, and, if `counting`, `paths` * 2**(512 * `exponent`) (number of shortest paths) and
    `came_from` (bit d: a shortest path arrives by an edge of direction d).
    """
    ring = np.uint64(head.size)
    mask, half = ring - _ONE, ring >> _ONE
    periodic = home.size > 0
    used, free, far = np.uint32(0), _NONE, _NONE
    near = 0
    current, horizon = _ZERO, ring
    count = _ZERO

    distance[source] = 0.0
    paths[source] = 1.0
    exponent[source] = 0
    came_from[source] = 0
    entry[0, 0], entry[0, 1] = np.uint32(source), _NONE
    used = np.uint32(1)
    head[0] = 0
    near = 1

    # A label stands in the ring if its bucket is below `horizon`, else it waits on the list `far`.
    while near > 0 or far != _NONE:
        if far == _NONE:
            horizon = current + ring
        elif near == 0 or current + half >= horizon:
            first = np.uint64(0xFFFFFFFFFFFFFFFF)
            kept = _NONE
            while far != _NONE:
                follow = entry[far, 1]
                bucket = np.uint64(np.int64(distance[entry[far, 0]] * scale))
                if bucket < horizon:  # improved since then: it stands in the ring already
                    entry[far, 1] = free
                    free = far
                else:
                    entry[far, 1] = kept
                    kept = far
                    first = min(first, bucket)
                far = follow
            if near == 0:
                if kept == _NONE:
                    break
                current = first
            horizon = current + ring
            while kept != _NONE:
                follow = entry[kept, 1]
                bucket = np.uint64(np.int64(distance[entry[kept, 0]] * scale))
                if bucket < horizon:
                    entry[kept, 1] = head[bucket & mask]
                    head[bucket & mask] = kept
                    near += 1
                else:
                    entry[kept, 1] = far
                    far = kept
                kept = follow
        e = head[current & mask]
        head[current & mask] = _NONE
        while e != _NONE:
            cell = np.uint64(entry[e, 0])
            follow = entry[e, 1]
            entry[e, 1] = free
            free = e
            e = follow
            near -= 1
            d_cell = distance[cell]
            if np.uint64(np.int64(d_cell * scale)) != current:
                continue
            order[count] = np.uint32(cell)
            count += _ONE
            n_paths = paths[cell]
            if counting and n_paths >= _FULL:
                n_paths /= _FULL
                paths[cell] = n_paths
                exponent[cell] += 1
            for d in range(8):
                target = cell + offset[np.uint64(d)]
                if periodic:
                    target = np.uint64(home[target])
                reach = d_cell + lengths[cell, np.uint64(d)]
                old = distance[target]
                if reach < old:
                    distance[target] = reach
                    if counting:
                        paths[target] = n_paths
                        exponent[target] = exponent[cell]
                        came_from[target] = np.uint8(1 << d)
                    bucket = np.uint64(np.int64(reach * scale))
                    before = np.uint64(np.int64(old * scale))
                    waits = before >= horizon and old < UNREACHED
                    if bucket != before and not (waits and bucket >= horizon):
                        slot = free
                        if slot == _NONE:
                            slot = used
                            used += np.uint32(1)
                        else:
                            free = entry[slot, 1]
                        entry[slot, 0] = np.uint32(target)
                        if bucket < horizon:
                            entry[slot, 1] = head[bucket & mask]
                            head[bucket & mask] = slot
                            near += 1
                        else:
                            entry[slot, 1] = far
                            far = slot
                elif counting and reach == old:
                    came_from[target] |= np.uint8(1 << d)
                    ahead = exponent[cell] - exponent[target]
                    if ahead == 0:
                        paths[target] += n_paths
                    elif ahead > 0:
                        paths[target] = n_paths + (paths[target] / _FULL if ahead == 1 else 0.0)
                        exponent[target] = exponent[cell]
                    elif ahead == -1:
                        paths[target] += n_paths / _FULL
        current += _ONE
    return count


@kernel
def add_dependencies(
    count: np.uint64, offset: np.ndarray, home: np.ndarray, paths: np.ndarray, exponent: np.ndarray,
    came_from: np.ndarray, order: np.ndarray, dependency: np.ndarray, total: np.ndarray,
) -> None:  # fmt: skip
    """Add to `total`, for every cell, the share of shortest paths from the last source that pass through it."""
    periodic = home.size > 0
    for i in range(count):
        dependency[order[i]] = 0.0
    for i in range(count - _ONE):
        cell = np.uint64(order[count - _ONE - np.uint64(i)])
        passing = dependency[cell]
        total[cell] += passing
        per_path = (1.0 + passing) / paths[cell]
        bits = came_from[cell]
        while bits != 0:
            before = cell - offset[_LOWEST[bits]]
            if periodic:
                before = np.uint64(home[before])
            n_paths = paths[before]
            behind = exponent[cell] - exponent[before]
            if behind > 0:
                n_paths = n_paths / _FULL if behind == 1 else 0.0
            dependency[before] += n_paths * per_path
            bits &= bits - np.uint8(1)


@kernel
def betweenness_batch(
    sources: np.ndarray, lengths: np.ndarray, offset: np.ndarray, home: np.ndarray, scale: float,
    distance: np.ndarray, paths: np.ndarray, exponent: np.ndarray, came_from: np.ndarray, order: np.ndarray,
    head: np.ndarray, entry: np.ndarray, dependency: np.ndarray, total: np.ndarray,
) -> None:  # fmt: skip
    """Write to `total`, for every cell, the dependencies of all `sources` on it."""
    total[:] = 0.0
    for source in sources:
        distance[:] = UNREACHED
        count = search(
            np.uint64(source), lengths, offset, home, scale, distance, paths, exponent, came_from, order, head, entry,
            True,
        )  # fmt: skip
        add_dependencies(count, offset, home, paths, exponent, came_from, order, dependency, total)


@kernel
def distance_batch(
    sources: np.ndarray, lengths: np.ndarray, offset: np.ndarray, home: np.ndarray, scale: float,
    distance: np.ndarray, paths: np.ndarray, exponent: np.ndarray, came_from: np.ndarray, order: np.ndarray,
    head: np.ndarray, entry: np.ndarray, sums: np.ndarray, reached: np.ndarray,
) -> None:  # fmt: skip
    """Write, for every source, the sum of distances (units) to the cells that it reaches, and their number."""
    for k in range(sources.size):
        distance[:] = UNREACHED
        count = search(
            np.uint64(sources[k]), lengths, offset, home, scale, distance, paths, exponent, came_from, order, head,
            entry, False,
        )  # fmt: skip
        total = 0.0
        for i in range(count):
            total += distance[order[i]]
        sums[k] = total
        reached[k] = count - _ONE
