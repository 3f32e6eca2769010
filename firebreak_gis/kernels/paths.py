"""Shortest paths on the implicit grid: the search that betweenness and closeness share.

The length of an edge is 1/p, rounded to a multiple of 2**-24 (at most 3e-8 of it) and capped at 2**32; an edge
with p = 0 does not exist. Distances are whole numbers of that unit, so they are exact: two routes made of the same
lengths tie, whatever the order of their edges, and a mirrored network has the mirrored shortest paths. A route
longer than 2**38 does not count as one.

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
#: Distance, in units, of a cell that is not reached.
UNREACHED = np.uint64(1 << 62)
_LONGEST = 2.0**56
#: Most buckets in the ring.
_RING = 1 << 12
#: Path counts are kept below this; the excess goes to an exponent.
FULL = 2.0**512
_NONE = np.uint32(0xFFFFFFFF)
_ZERO, _ONE = np.uint64(0), np.uint64(1)
#: Lowest set bit of a byte.
LOWEST = np.array([0] + [(b & -b).bit_length() - 1 for b in range(1, 256)], dtype=np.uint8)


@dataclass(frozen=True)
class Lattice:
    """The network as the search reads it.

    Parameters
    ----------
    lengths
        (rim cells, 8): length of the edge to the neighbour in each direction, in units. uint32 (32 B a cell) if all
        are below 256, else uint64.
    absent
        Stands in `lengths` for an edge that does not exist.
    offset
        (8,) uint64: step to the neighbour in the flat grid, modulo 2**64.
    home
        (rim cells,) uint32 for a periodic grid, else empty.
    cells
        (burnable cells,) uint32: flat index of every burnable cell in row-major order.
    shape
        (rows, cols) without the rim.
    shift
        Distances with the same bits above this one share a bucket.
    ring
        Buckets in the ring, a power of two.
    """

    lengths: np.ndarray
    absent: np.uint64
    offset: np.ndarray
    home: np.ndarray
    cells: np.ndarray
    shape: tuple[int, int]
    shift: np.uint64
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
    some = probability[probability > 0]
    if some.size == 0:
        some = np.ones(1, dtype=np.float32)
    shortest, longest = (float(edge_lengths(p)) / UNIT for p in (some.max(), some.min()))
    kind = np.uint32 if longest < 2.0**32 - 1 else np.uint64
    absent = np.iinfo(kind).max
    lengths = np.full((rows + 2, width, 8), absent, dtype=kind)
    for d in range(8):
        r, c = ROW_STEP[d], COL_STEP[d]
        if transpose:  # the edge from the neighbour to the cell
            source = planes[OPPOSITE[d], 1 + r : rows + 1 + r, 1 + c : cols + 1 + c]
        else:
            source = planes[d, 1:-1, 1:-1]
        exists = source > 0
        lengths[1:-1, 1:-1, d][exists] = edge_lengths(source[exists]) / UNIT
    shift = int(shortest).bit_length() - 1
    reach = min(int(longest) >> shift, _RING) + 3
    return Lattice(
        lengths=lengths.reshape(-1, 8),
        absent=np.uint64(absent),
        offset=np.array([r * width + c for r, c in zip(ROW_STEP, COL_STEP, strict=True)], dtype=np.int64).view(
            np.uint64
        ),
        home=number.ravel() if boundary == "periodic" else np.empty(0, dtype=np.uint32),
        cells=number[1:-1, 1:-1][np.asarray(burnable)],
        shape=(rows, cols),
        shift=np.uint64(shift),
        ring=min(1 << reach.bit_length(), _RING),
    )


class Workspace:
    """What one thread needs for its searches, about 45 B a cell.

    Parameters
    ----------
    network
        The lattice to be searched.

    Attributes
    ----------
    labels
        Arrays of `search`, in the order of its parameters.
    counts
        Arrays for counting paths: `paths`, `exponent`, `dependency`.
    """

    def __init__(self, network: Lattice) -> None:
        n_cells = network.lengths.shape[0]
        self.labels = (
            np.full(n_cells, UNREACHED, dtype=np.uint64),
            np.empty(n_cells, dtype=np.uint8),
            np.empty(n_cells, dtype=np.uint32),
            np.full(network.ring, _NONE, dtype=np.uint32),
            # A cell is put into a bucket at most once an edge; untouched pages cost nothing.
            np.empty((8 * n_cells + 1, 2), dtype=np.uint32),
        )
        self.counts = (np.empty(n_cells), np.zeros(n_cells, dtype=np.int16), np.zeros(n_cells))


@kernel
def search(
    source: np.uint64,
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
) -> tuple[int, bool]:
    """Settle all cells that `source` reaches.

    `distance` must be `UNREACHED` everywhere and `head` empty (it is left empty). Fills `order` (cells by bucket),
    `distance` and `came_from` (bit d: a shortest path arrives by an edge of direction d). Returns the number of
    cells, and whether any cell is reached by more than one shortest path (or may be).
    """
    ring = np.uint64(head.size)
    mask, half = ring - _ONE, ring >> _ONE
    periodic = home.size > 0
    used, free, far = np.uint32(0), _NONE, _NONE
    near = 0
    current, horizon = _ZERO, ring
    count = _ZERO

    tied = False

    distance[source] = _ZERO
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
                bucket = distance[entry[far, 0]] >> shift
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
                bucket = distance[entry[kept, 0]] >> shift
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
            if d_cell >> shift != current:
                continue
            order[count] = np.uint32(cell)
            count += _ONE
            for d in range(8):
                step = np.uint64(lengths[cell, np.uint64(d)])
                target = cell + offset[np.uint64(d)]
                if periodic:
                    target = np.uint64(home[target])
                reach = d_cell + step
                old = distance[target]
                if reach > old or step == absent:  # in this order: most edges lead back
                    continue
                if reach < old:
                    distance[target] = reach
                    came_from[target] = np.uint8(1 << d)
                    bucket = reach >> shift
                    before = old >> shift
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
                else:
                    came_from[target] |= np.uint8(1 << d)
                    tied = True
        current += _ONE
    return np.int64(count), tied


@kernel
def count_paths(
    count: int,
    offset: np.ndarray,
    home: np.ndarray,
    paths: np.ndarray,
    exponent: np.ndarray,
    came_from: np.ndarray,
    order: np.ndarray,
) -> None:
    """Number of shortest paths from the last source to every cell: `paths` * 2**(512 * `exponent`)."""
    periodic = home.size > 0
    paths[order[0]], exponent[order[0]] = 1.0, 0
    for i in range(1, count):
        cell = np.uint64(order[i])
        total, power = 0.0, np.int16(0)
        bits = came_from[cell]
        while bits != 0:
            before = cell - offset[LOWEST[bits]]
            if periodic:
                before = np.uint64(home[before])
            ahead = exponent[before] - power
            if ahead == 0:
                total += paths[before]
            elif ahead > 0:
                total = paths[before] + (total / FULL if ahead == 1 else 0.0)
                power = exponent[before]
            elif ahead == -1:
                total += paths[before] / FULL
            bits &= bits - np.uint8(1)
        if total >= FULL:
            total /= FULL
            power += np.int16(1)
        paths[cell], exponent[cell] = total, power


@kernel
def add_dependencies(
    count: int,
    offset: np.ndarray,
    home: np.ndarray,
    paths: np.ndarray,
    exponent: np.ndarray,
    came_from: np.ndarray,
    order: np.ndarray,
    dependency: np.ndarray,
    weight: float,
    total: np.ndarray,
) -> None:
    """Add to `total`, for every cell, `weight` times the share of shortest paths from the last source through it."""
    periodic = home.size > 0
    for i in range(count - 1, 0, -1):
        cell = np.uint64(order[i])
        passing = dependency[cell]
        dependency[cell] = 0.0
        total[cell] += weight * passing
        per_path = (1.0 + passing) / paths[cell]
        bits = came_from[cell]
        while bits != 0:
            before = cell - offset[LOWEST[bits]]
            if periodic:
                before = np.uint64(home[before])
            n_paths = paths[before]
            behind = exponent[cell] - exponent[before]
            if behind > 0:
                n_paths = n_paths / FULL if behind == 1 else 0.0
            dependency[before] += n_paths * per_path
            bits &= bits - np.uint8(1)
    dependency[order[0]] = 0.0


@kernel
def add_tree_dependencies(
    count: int,
    offset: np.ndarray,
    home: np.ndarray,
    came_from: np.ndarray,
    order: np.ndarray,
    dependency: np.ndarray,
    weight: float,
    total: np.ndarray,
) -> None:
    """Do as `add_dependencies` where every cell is reached by one shortest path."""
    periodic = home.size > 0
    for i in range(count - 1, 0, -1):
        cell = np.uint64(order[i])
        passing = dependency[cell]
        dependency[cell] = 0.0
        total[cell] += weight * passing
        before = cell - offset[LOWEST[came_from[cell]]]
        if periodic:
            before = np.uint64(home[before])
        dependency[before] += 1.0 + passing
    dependency[order[0]] = 0.0


@kernel
def betweenness_batch(
    sources: np.ndarray,
    weights: np.ndarray,
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
    total: np.ndarray,
) -> None:
    """Write to `total` the weighted dependencies of all `sources` on every cell; `dependency` stays 0."""
    total[:] = 0.0
    for k in range(sources.size):
        distance[:] = UNREACHED
        count, tied = search(
            np.uint64(sources[k]), lengths, absent, offset, home, shift, distance, came_from, order, head, entry
        )
        if tied:
            count_paths(count, offset, home, paths, exponent, came_from, order)
            add_dependencies(count, offset, home, paths, exponent, came_from, order, dependency, weights[k], total)
        else:
            add_tree_dependencies(count, offset, home, came_from, order, dependency, weights[k], total)


@kernel
def distance_batch(
    sources: np.ndarray,
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
    sums: np.ndarray,
    reached: np.ndarray,
) -> None:
    """Write, for every source, the sum of distances (units) to the cells that it reaches, and their number."""
    for k in range(sources.size):
        distance[:] = UNREACHED
        count, _ = search(
            np.uint64(sources[k]), lengths, absent, offset, home, shift, distance, came_from, order, head, entry
        )
        total = 0.0
        for i in range(count):
            total += np.float64(distance[order[i]])
        sums[k] = total
        reached[k] = count - 1
