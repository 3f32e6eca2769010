"""A small patch split all the way down: in one call what `placement.patches.Patches.split` does piece by piece."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.bisection import best_cut
from firebreak_gis.kernels.chains import best_chain, can_chain
from firebreak_gis.kernels.patches import patch_links, pieces_after, thin
from firebreak_gis.kernels.policy import kernel


@kernel
def _sorted(row: np.ndarray, col: np.ndarray, by_row: np.ndarray, by_col: np.ndarray) -> np.ndarray:
    """Positions of cells sorted along each direction by their places, ties by number, (n_directions, n)."""
    order = np.empty((by_row.shape[0], row.size), np.int32)
    at = np.empty(row.size, np.float64)
    for k in range(order.shape[0]):
        for i in range(row.size):
            at[i] = np.rint((by_row[k, row[i]] + by_col[k, col[i]]) * 1e6)
        order[k] = np.argsort(at, kind="mergesort")
    return order


@kernel
def _is_ring(row: np.ndarray, col: np.ndarray, rows: int, cols: int) -> bool:
    """Whether cells reach both ends of an axis."""
    return (row.min() == 0 and row.max() == rows - 1) or (col.min() == 0 and col.max() == cols - 1)


@kernel
def _along(wall: np.ndarray, rows: int, cols: int) -> np.ndarray:
    """Cells of a wall, given by rising number, along the axis in which it extends most."""
    row, col = wall // cols, wall % cols
    if row.max() - row.min() >= col.max() - col.min():
        return wall
    at = np.sort(col * rows + row)
    return at % rows * cols + at // rows


@kernel
def split_down(
    cells: np.ndarray,
    links: np.ndarray,
    rows: int,
    cols: int,
    row_step: np.ndarray,
    col_step: np.ndarray,
    capacity: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    ignitions: float,
    values: float,
    by_row: np.ndarray,
    by_col: np.ndarray,
    heads: np.ndarray,
    toward: np.ndarray,
    shares: np.ndarray,
    periodic: bool,
    smallest: int,
    sizes: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Split a connected patch, and its pieces in turn, until they hold fewer than `smallest` cells.

    Parameters
    ----------
    cells, links, rows, cols, row_step, col_step
        As in `patches.patch_links`; `cells` rise.
    capacity, ignition, value
        (rows * cols,) int32, float64, float64: as in `bisection.best_cut`, of all cells.
    ignitions, values
        Sums of ignition and value over the landscape.
    by_row, by_col
        (2, n_directions, rows) and (2, n_directions, cols) float64: what a row and a column add to the place of a cell
        along each direction; first in the plane, then round a torus.
    heads, shares
        As in `bisection.best_cut`.
    toward
        As in `chains.best_chain`.
    periodic
        Whether the grid is a torus.
    sizes
        (rows * cols,) int32, set in the cells of each piece that is split to its number of cells.

    Returns
    -------
    tuple
        Cells of the walls one after another, int64; the end of each wall among them; the wall by which the piece came
        to be that it splits, -1 for none, and the place of that piece among the others; cells of the piece; ignition x
        value that it saves, float64. Walls come in levels: the first, those of its pieces, and so on.
    """
    n = cells.size
    near = patch_links(cells, links, rows, cols, row_step, col_step)
    row, col = (cells // cols).astype(np.int32), (cells % cols).astype(np.int32)
    # Positions of the cells; those of a piece lie together.
    place = np.arange(n).astype(np.int32)
    local = np.empty(n, np.int32)
    # Pieces wait in turn: from, to, the wall above, and the place among its pieces.
    start, stop = np.empty(n + 1, np.int32), np.empty(n + 1, np.int32)
    above, nth = np.empty(n + 1, np.int32), np.empty(n + 1, np.int32)
    start[0], stop[0], above[0], nth[0] = 0, n, -1, 0
    head, tail = 0, 1
    walls, ends = np.empty(n, np.int64), np.empty(n, np.int64)
    parent, sibling, size = np.empty(n, np.int32), np.empty(n, np.int32), np.empty(n, np.int32)
    saved = np.empty(n, np.float64)
    n_walls, filled = 0, 0
    while head < tail:
        first, m = start[head], stop[head] - start[head]
        here = place[first : first + m].copy()
        for i in range(m):
            local[here[i]] = i
        near_here = np.empty((m, 8), np.int32)
        for i in range(m):
            for d in range(8):
                u = near[here[i], d]
                near_here[i, d] = local[u] if u >= 0 else -1
        own = cells[here]
        lit, worth = ignition[own], value[own]
        cut = np.empty(m, np.uint8)
        row_here, col_here, share, at_risk = row[here], col[here], lit / ignitions, worth / values
        if not periodic and can_chain(row_here, col_here, links[own]):
            best_chain(row_here, col_here, capacity[own], share, at_risk, toward, shares[0], cut)
        else:
            ring = 1 if periodic and _is_ring(row_here, col_here, rows, cols) else 0
            order = _sorted(row_here, col_here, by_row[ring], by_col[ring])
            best_cut(near_here, capacity[own], share, at_risk, order, heads, shares, cut)
        for i in range(m):
            cut[i] = cut[i] == 1
        thin(near_here, cut)
        n_cut = int(cut.sum())
        if n_cut > 0:
            piece = pieces_after(near_here, cut) + 1  # 0 in the wall
            n_groups = piece.max() + 1
            count = np.zeros(n_groups, np.int32)
            lit_in, worth_in = np.zeros(n_groups), np.zeros(n_groups)
            for i in range(m):
                sizes[own[i]] = m
                count[piece[i]] += 1
                lit_in[piece[i]] += lit[i]
                worth_in[piece[i]] += worth[i]
                if cut[i]:
                    local[here[i]] = -1
            walls[filled : filled + n_cut] = _along(own[cut == 1], rows, cols)
            filled += n_cut
            gain = lit_in.sum() / ignitions * (worth_in.sum() / values)
            at = np.empty(n_groups, np.int32)
            at[0] = first
            for k in range(1, n_groups):
                gain -= lit_in[k] / ignitions * (worth_in[k] / values)
                at[k] = at[k - 1] + count[k - 1]
                if count[k] >= smallest:
                    start[tail], stop[tail], above[tail] = at[k], at[k] + count[k], n_walls
                    nth[tail] = k - 1
                    tail += 1
            ends[n_walls], parent[n_walls], sibling[n_walls] = filled, above[head], nth[head]
            size[n_walls], saved[n_walls] = m, gain
            n_walls += 1
            for i in range(m):
                place[at[piece[i]]] = here[i]
                at[piece[i]] += 1
        head += 1
    return walls[:filled], ends[:n_walls], parent[:n_walls], sibling[:n_walls], size[:n_walls], saved[:n_walls]
