"""From two sides of a cut to the line between them: its channel, the shortest line in it, and shorter ones beside it.

Centres of cells are the corners of triangles, two in each square of four centres. A line between two sides goes from
triangle to triangle through gates, the edges from a centre of one side to one of the other. All places are in cells, x
to the east and y to the south from the corner of a box; centres lie at halves.

Common arguments:

label
    (rows, cols) uint8: 1 and 2 on the two sides, 0 off the patch; the cells along the border of the box are 0.
price
    (rows, cols) float64 of a line of one cell's length in each cell, below 0 where no line may be.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

#: How near to a centre a line may pass, in lengths of the link.
_MARGIN = 1.0 / 16.0
#: How far an end lies off the patch, beyond the corner of its cells.
_BEYOND = 1.0 / 8.0
#: Cells of forbidden ground that a line may touch at its ends.
_TOUCH = 0.25
#: Vertices that a straight piece may pass over.
_SPAN = 32


@inlined
def _rising(label: np.ndarray, r: int, c: int) -> bool:
    """Whether the square with its north-western centre in (r, c) is split from south-west to north-east.

    It is split along a gate if there is one, else so that a centre off the patch has a triangle of its own.
    """
    a, b, e, f = label[r, c], label[r, c + 1], label[r + 1, c], label[r + 1, c + 1]
    falls = a * f == 2
    return not falls and (b * e == 2 or (b > 0 and e > 0 and (a == 0 or f == 0)))


@inlined
def _gate(r: int, c: int, kind: int, cols: int) -> int:
    """Number of an edge: 0 to the east of a centre, 1 to the south, 2 the diagonal of the square."""
    return 3 * (r * cols + c) + kind


@kernel
def _ends_of(label: np.ndarray, gate: int) -> tuple[int, int, int, int]:
    """Row and column of the centres of an edge on side 1 and on side 2; -1 if it is no gate."""
    cols = label.shape[1]
    kind, cell = gate % 3, gate // 3
    r, c = cell // cols, cell % cols
    r0, c0, r1, c1 = r, c, r, c + 1
    if kind == 1:
        r1, c1 = r + 1, c
    elif kind == 2:
        if _rising(label, r, c):
            r0, c0, r1, c1 = r + 1, c, r, c + 1
        else:
            r1, c1 = r + 1, c + 1
    one, other = label[r0, c0], label[r1, c1]
    if one * other != 2:
        return -1, -1, -1, -1
    if one == 1:
        return r0, c0, r1, c1
    return r1, c1, r0, c0


@kernel
def _triangle(label: np.ndarray, r: int, c: int, half: int) -> tuple[int, int, int, int, int]:
    """The three edges of a triangle, and row and column of its corner off the patch; -1 if it has none.

    Half 0 holds the northern edge of the square, half 1 the southern one.
    """
    cols = label.shape[1]
    rising = _rising(label, r, c)
    level = _gate(r + half, c, 0, cols)
    upright = _gate(r, c if rising != (half == 1) else c + 1, 1, cols)
    diagonal = _gate(r, c, 2, cols)
    for row in range(r, r + 2):
        for col in range(c, c + 2):
            # The corner that is not in this half is the one across the diagonal.
            if rising:
                away = (row == r + 1 and col == c + 1) if half == 0 else (row == r and col == c)
            else:
                away = (row == r + 1 and col == c) if half == 0 else (row == r and col == c + 1)
            if not away and label[row, col] == 0:
                return level, upright, diagonal, row, col
    return level, upright, diagonal, -1, -1


@kernel
def _across(label: np.ndarray, r: int, c: int, half: int, gate: int) -> tuple[int, int, int]:
    """The triangle on the other side of an edge of a triangle."""
    cols = label.shape[1]
    kind, cell = gate % 3, gate // 3
    if kind == 2:
        return r, c, 1 - half
    if kind == 0:
        if half == 0:
            return r - 1, c, 1
        return r + 1, c, 0
    if cell % cols == c:  # the western edge; the triangle beyond holds the eastern edge of its square
        return r, c - 1, 1 if _rising(label, r, c - 1) else 0
    return r, c + 1, 0 if _rising(label, r, c + 1) else 1


@kernel
def channels(label: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Find the channels between the two sides.

    Returns
    -------
    gates
        (m, 4) float64: x and y of the centre on side 1, then on side 2, of each gate, channel after channel, in order.
    first
        (n + 1,) int64: channel i has the gates ``first[i]`` to before ``first[i + 1]``.
    ends
        (n, 4) float64: where each channel begins and ends, beyond the corner of its cells; NaN for rings.
    """
    rows, cols = label.shape
    seen = np.zeros(3 * rows * cols, np.uint8)
    n_gates = 0
    for gate in range(seen.size):
        kind, cell = gate % 3, gate // 3
        r, c = cell // cols, cell % cols
        if (kind == 1 or c + 1 < cols) and (kind == 0 or r + 1 < rows) and _ends_of(label, gate)[0] >= 0:
            n_gates += 1
        else:
            seen[gate] = 1
    gates = np.empty((n_gates, 4))
    first = np.zeros(n_gates + 1, np.int64)
    ends = np.full((n_gates, 4), np.nan)
    count = 0
    done = 0
    for rings in range(2):  # channels with ends first
        for r0 in range(rows - 1):
            for c0 in range(cols - 1):
                for h0 in range(2):
                    level, upright, diagonal, off_r, off_c = _triangle(label, r0, c0, h0)
                    if rings == 0 and off_r < 0:
                        continue
                    gate = -1
                    for each in (level, upright, diagonal):
                        # A ring starts in the middle of a gate, which must not be that of a square.
                        if seen[each] == 0 and (rings == 0 or each != diagonal):
                            gate = each
                    if gate < 0:
                        continue
                    if rings == 0:
                        ends[count, 0] = c0 + 1 + 2 * _BEYOND * (off_c - c0 - 0.5)
                        ends[count, 1] = r0 + 1 + 2 * _BEYOND * (off_r - r0 - 0.5)
                    r, c, half = r0, c0, h0
                    while gate >= 0:
                        seen[gate] = 1
                        ay, ax, by, bx = _ends_of(label, gate)
                        gates[done, 0], gates[done, 1] = ax + 0.5, ay + 0.5
                        gates[done, 2], gates[done, 3] = bx + 0.5, by + 0.5
                        done += 1
                        r, c, half = _across(label, r, c, half, gate)
                        level, upright, diagonal, off_r, off_c = _triangle(label, r, c, half)
                        gate = -1
                        for each in (level, upright, diagonal):
                            if seen[each] == 0:
                                gate = each
                    if rings == 0:
                        ends[count, 2] = c + 1 + 2 * _BEYOND * (off_c - c - 0.5)
                        ends[count, 3] = r + 1 + 2 * _BEYOND * (off_r - r - 0.5)
                    count += 1
                    first[count] = done
    return gates, first[: count + 1], ends[:count]


@inlined
def _area(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> float:
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


@kernel
def shortest(gates: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Shortest line through the gates of a channel from end to end, (k, 2) x and y.

    The funnel of Lee and Preparata 1984 (doi 10.1002/net.3230140304) through gates that are narrowed a little. A ring
    starts and ends in the middle of its first gate.
    """
    n = gates.shape[0]
    ring = np.isnan(ends[0])
    sx, sy, ex, ey = ends[0], ends[1], ends[2], ends[3]
    start = 0
    if ring:
        sx, sy = 0.5 * (gates[0, 0] + gates[0, 2]), 0.5 * (gates[0, 1] + gates[0, 3])
        ex, ey = sx, sy
        start = 1
    m = n - start
    left, right = np.empty((m + 1, 2)), np.empty((m + 1, 2))
    flip = m > 0 and _area(sx, sy, gates[start, 0], gates[start, 1], gates[start, 2], gates[start, 3]) < 0
    for i in range(m):
        for k in range(2):
            one, other = gates[start + i, k], gates[start + i, 2 + k]
            near, far = one + _MARGIN * (other - one), other + _MARGIN * (one - other)
            right[i, k], left[i, k] = (far, near) if flip else (near, far)
    left[m, 0], left[m, 1] = ex, ey
    right[m, 0], right[m, 1] = ex, ey
    line = np.empty((m + 2, 2))
    line[0, 0], line[0, 1] = sx, sy
    size = 1
    ax, ay = sx, sy
    lx, ly, rx, ry = ax, ay, ax, ay
    at_left, at_right = -1, -1
    i = 0
    while i <= m:
        nx, ny = right[i, 0], right[i, 1]
        if _area(ax, ay, rx, ry, nx, ny) >= 0:
            if (rx == ax and ry == ay) or _area(ax, ay, lx, ly, nx, ny) < 0:
                rx, ry, at_right = nx, ny, i
            else:  # over the left side: it is a corner of the line
                line[size, 0], line[size, 1] = lx, ly
                size += 1
                ax, ay = lx, ly
                i = at_left + 1
                lx, ly, rx, ry = ax, ay, ax, ay
                at_right = at_left
                continue
        nx, ny = left[i, 0], left[i, 1]
        if _area(ax, ay, lx, ly, nx, ny) <= 0:
            if (lx == ax and ly == ay) or _area(ax, ay, rx, ry, nx, ny) > 0:
                lx, ly, at_left = nx, ny, i
            else:
                line[size, 0], line[size, 1] = rx, ry
                size += 1
                ax, ay = rx, ry
                i = at_right + 1
                lx, ly, rx, ry = ax, ay, ax, ay
                at_left = at_right
                continue
        i += 1
    if ring or line[size - 1, 0] != ex or line[size - 1, 1] != ey:
        line[size, 0], line[size, 1] = ex, ey
        size += 1
    return line[:size]


@kernel
def price_along(price: np.ndarray, ax: float, ay: float, bx: float, by: float) -> float:
    """Price of a straight piece; infinite if more of it than may touch forbidden ground lies there."""
    rows, cols = price.shape
    length = np.hypot(bx - ax, by - ay)
    if length == 0:
        return 0.0
    # Shares of the way at which it enters the next column and the next row.
    next_x = np.ceil(ax) if bx > ax else np.floor(ax)
    next_y = np.ceil(ay) if by > ay else np.floor(ay)
    step_x, step_y = 1.0 if bx > ax else -1.0, 1.0 if by > ay else -1.0
    at, total, forbidden = 0.0, 0.0, 0.0
    while at < 1.0:
        to_x = (next_x - ax) / (bx - ax) if bx != ax else np.inf
        to_y = (next_y - ay) / (by - ay) if by != ay else np.inf
        until = min(to_x, to_y, 1.0)
        if to_x <= until:
            next_x += step_x
        if to_y <= until:
            next_y += step_y
        if until > at:
            middle = 0.5 * (at + until)
            row, col = int(np.floor(ay + middle * (by - ay))), int(np.floor(ax + middle * (bx - ax)))
            part = (until - at) * length
            here = -1.0
            if 0 <= row < rows and 0 <= col < cols:
                here = price[row, col]
            if here < 0:
                forbidden += part
                if forbidden > _TOUCH:
                    return np.inf
            else:
                total += part * here
            at = until
    return total


@kernel
def pulled(line: np.ndarray, price: np.ndarray) -> np.ndarray:
    """The cheapest line of straight pieces through some of the vertices of a line, its ends among them."""
    n = line.shape[0]
    best = np.full(n, np.inf)
    before = np.zeros(n, np.int64)
    best[0] = 0.0
    for j in range(1, n):
        for i in range(max(j - _SPAN, 0), j):
            if best[i] < np.inf:
                whole = best[i] + price_along(price, line[i, 0], line[i, 1], line[j, 0], line[j, 1])
                if whole < best[j] - 1e-9:
                    best[j] = whole
                    before[j] = i
    if best[n - 1] == np.inf:
        return line
    count, j = 1, n - 1
    while j > 0:
        j = before[j]
        count += 1
    out = np.empty((count, 2))
    j = n - 1
    for k in range(count - 1, -1, -1):
        out[k] = line[j]
        j = before[j]
    return out


@kernel
def landings(label: np.ndarray) -> np.ndarray:
    """Places where lines across a patch may end, (n, 2): beyond the corners of its cells, off it."""
    rows, cols = label.shape
    out = np.empty((4 * rows * cols, 2))
    count = 0
    for r in range(rows - 1):
        for c in range(cols - 1):
            if label[r, c] == 0 and label[r, c + 1] == 0 and label[r + 1, c] == 0 and label[r + 1, c + 1] == 0:
                continue
            for i in range(2):
                for j in range(2):
                    if label[r + i, c + j] == 0:
                        out[count, 0] = c + 1 + 2 * _BEYOND * (j - 0.5)
                        out[count, 1] = r + 1 + 2 * _BEYOND * (i - 0.5)
                        count += 1
    return out[:count]


@inlined
def _apart(places: np.ndarray, k: int, x: float, y: float) -> float:
    return float(np.hypot(places[k, 0] - x, places[k, 1] - y))


@kernel
def slid(line: np.ndarray, price: np.ndarray, places: np.ndarray) -> np.ndarray:
    """The line with its ends moved to where the last pieces cost least; in turn, until nothing moves or four times.

    An end moves no farther than its piece is long, so that it stays on its side of the line.
    """
    out = line.copy()
    n = out.shape[0]
    least = np.inf
    for row in range(price.shape[0]):
        for col in range(price.shape[1]):
            if price[row, col] >= 0:
                least = min(least, price[row, col])
    for _turn in range(4):
        moved = False
        for side in range(2):
            end, fixed = (0, 1) if side == 0 else (n - 1, n - 2)
            fx, fy = out[fixed, 0], out[fixed, 1]
            ex, ey = out[end, 0], out[end, 1]
            best = price_along(price, fx, fy, ex, ey)
            reach = np.hypot(ex - fx, ey - fy)
            for k in range(places.shape[0] if best < np.inf else 0):
                if _apart(places, k, ex, ey) > reach:
                    continue
                if _apart(places, k, fx, fy) > 1.0 and (_apart(places, k, fx, fy) - _TOUCH) * least < best - 1e-6:
                    cost = price_along(price, fx, fy, places[k, 0], places[k, 1])
                    if cost < best - 1e-6:
                        best = cost
                        out[end, 0], out[end, 1] = places[k, 0], places[k, 1]
                        moved = True
        if not moved:
            break
    return out


@kernel
def lines_in(
    gates: np.ndarray,
    starts: np.ndarray,
    ends: np.ndarray,
    price: np.ndarray,
    places: np.ndarray,
    freedom: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Lines in channels, one each.

    Parameters
    ----------
    gates, starts, ends
        As `channels` returns them.
    places
        As `landings` returns them.
    freedom
        (n,) uint8 of each channel. 0: the line stays in it. 1: it may leave it where that is cheaper, and then crosses
        other links. 2: its ends may move, too.

    Returns
    -------
    points
        (m, 2) float64, x and y of the vertices, line after line.
    first
        (n + 1,) int64: line i has the points ``first[i]`` to before ``first[i + 1]``.
    """
    n = ends.shape[0]
    points = np.empty((gates.shape[0] + 3 * n, 2))
    first = np.zeros(n + 1, np.int64)
    size = 0
    for i in range(n):
        line = shortest(gates[starts[i] : starts[i + 1]], ends[i])
        if freedom[i] > 0:
            line = pulled(line, price)
        if freedom[i] > 1 and not np.isnan(ends[i, 0]):
            line = pulled(slid(line, price, places), price)
        points[size : size + line.shape[0]] = line
        size += line.shape[0]
        first[i + 1] = size
    return points[:size], first


@kernel
def prices_of(points: np.ndarray, first: np.ndarray, price: np.ndarray) -> float:
    """Price of all lines together, what lies on forbidden ground left out."""
    open_ground = np.maximum(price, 0.0)
    total = 0.0
    for i in range(first.size - 1):
        for k in range(first[i], first[i + 1] - 1):
            total += price_along(open_ground, points[k, 0], points[k, 1], points[k + 1, 0], points[k + 1, 1])
    return total
