"""Slow twins of the scores and the null models: sets of cells and plain loops."""

import heapq
import math

STEPS = [(r, c) for r in (-1, 0, 1) for c in (-1, 0, 1) if (r, c) != (0, 0)]


def cells(plane):
    """Set of (row, col) that are true."""
    return {(r, c) for r, line in enumerate(plane.tolist()) for c, value in enumerate(line) if value}


def jaccard(one, other):
    """Shared over joint cells; two empty sets are equal."""
    return len(one & other) / len(one | other) if one | other else 1.0


def overlap(burnt, observed, start):
    """The indices of `skill.overlap` from sets."""
    a, b, s = cells(burnt), cells(observed), cells(start)
    return {
        "sorensen": 2 * len(a & b) / (len(a) + len(b)) if a or b else 1.0,
        "iou": jaccard(a, b),
        "growth_iou": jaccard(a - s, b - s),
        "size_ratio": len(a) / len(b) if b else (math.inf if a else math.nan),
    }


def brier(probability, observed, within):
    """Mean squared error over the cells that count, one by one."""
    errors = [(probability[cell] - observed[cell]) ** 2 for cell in cells(within)]
    return sum(errors) / len(errors)


def reliability(probability, observed, within, bins):
    """List of (cells, mean forecast, share burnt), None where a bin is empty."""
    found = [[] for _ in range(bins)]
    for cell in cells(within):
        p = float(probability[cell])
        place = next(k for k in range(bins) if p < (k + 1) / bins or k == bins - 1)
        found[place].append((p, bool(observed[cell])))
    return [
        (len(f), sum(p for p, _ in f) / len(f), sum(o for _, o in f) / len(f)) if f else (0, None, None) for f in found
    ]


def distances(fuel, start):
    """Length of the shortest way from the start through the fuel, by (row, col): Bellman and Ford."""
    n_rows, n_cols = fuel.shape
    found = dict.fromkeys(cells(start), 0.0)
    changed = True
    while changed:
        changed = False
        for (row, col), length in list(found.items()):
            for dr, dc in STEPS:
                r, c = row + dr, col + dc
                if 0 <= r < n_rows and 0 <= c < n_cols and fuel[r, c]:
                    further = length + math.hypot(dr, dc)
                    if further < found.get((r, c), math.inf) - 1e-9:
                        found[r, c] = further
                        changed = True
    return found


def in_ellipse(row, col, focus, ratio, course, length):
    """Whether a point lies in the ellipse with this rear focus, ratio and whole length, by its centre and axes."""
    half, breadth = length / 2, length / 2 / ratio
    to_centre = math.sqrt(half**2 - breadth**2)
    east, south = math.sin(course), -math.cos(course)
    along = (col - focus[1]) * east + (row - focus[0]) * south - to_centre
    across = (col - focus[1]) * south - (row - focus[0]) * east
    return (along / half) ** 2 + (across / breadth) ** 2 <= 1 + 1e-9


def rates(times, size):
    """The `size` cells that are reached first, ties by (row, col)."""
    heap = [(time, cell) for cell, time in times.items()]
    heapq.heapify(heap)
    return {heapq.heappop(heap)[1] for _ in range(min(size, len(heap)))}
