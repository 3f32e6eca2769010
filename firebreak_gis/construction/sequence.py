"""The order in which to build the segments of a plan, and what each saves."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.keys import distinct, keyed


def construction_order(
    pair: np.ndarray,
    *,
    cost: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    compartment_ignition: np.ndarray,
    compartment_value: np.ndarray,
    score: np.ndarray,
) -> list[list[int]]:
    """Order segments by what they save for their cost.

    From the complete plan, the border whose absence loses least for its cost is taken away, again and again; the
    reverse is the order of construction. All segments between the same two compartments are one border, since one gap
    joins them. Segments that separate nothing come last. Costs of less than a billionth of the mean count as that.

    Parameters
    ----------
    pair
        (n, 2) compartments on the two sides of each segment, from 1; 0 for none. A segment with the second 0
        separates nothing.
    cost, ignition, value
        (n,) of the cells of each segment.
    compartment_ignition, compartment_value
        (m,) of compartments 1 to m.
    score
        (n,) decides between equal ratios, higher first; then the lower number.

    Returns
    -------
    list of list of int
        Borders in order of construction, each with its segments.

    Notes
    -----
    Cost: n log n, and a look at all borders of two compartments when they become one.
    """
    from firebreak_gis.kernels.contracting import taken_away

    mean = float(cost.mean()) if cost.size else 0.0
    least = 1e-9 * mean if mean > 0 else 1.0
    mass = np.array([np.append(0.0, compartment_ignition), np.append(0.0, compartment_value)])
    loose = np.flatnonzero(pair[:, 1] == 0)
    side = pair[loose, 0]
    saved = _joined(mass[:, side], np.zeros((2, loose.size)), np.array([ignition[loose], value[loose]]))
    last = loose[np.lexsort((loose, -score[loose], -saved / np.maximum(cost[loose], least)))]
    np.add.at(mass[0], side, ignition[loose])
    np.add.at(mass[1], side, value[loose])
    sides, closing, border = _borders(pair, score)
    sums = [np.bincount(border, weights=plane[closing], minlength=len(sides)) for plane in (cost, ignition, value)]
    order, into = taken_away(sides[:, 0].copy(), sides[:, 1].copy(), *sums, *mass, least)
    while (into[into] != into).any():
        into = into[into]
    # Segments border by border in the order in which they go, those of a border by their score.
    turn = np.empty(len(sides), np.int64)
    turn[order] = np.arange(order.size)
    when = turn[into[border]]
    by_turn = np.lexsort((closing, -score[closing], when))
    removed = np.split(closing[by_turn], np.flatnonzero(np.diff(when[by_turn])) + 1) if closing.size else []
    return [members.tolist() for members in removed[::-1]] + [[int(i)] for i in last]


def _joined(one: np.ndarray, other: np.ndarray, own: np.ndarray) -> np.ndarray:
    """Expected loss when two compartments and the fuel between them become one; arrays are (ignition, value)."""
    both = one + other + own
    loss: np.ndarray = both[0] * both[1] - one[0] * one[1] - other[0] * other[1]
    loss[loss < 0] = 0.0  # rounding
    return loss


def _borders(pair: np.ndarray, score: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """All segments between the same two compartments as one border.

    Returns
    -------
    sides
        (m, 2) compartments of each border, in the order in which equal ones are taken away.
    closing
        Segments that separate something.
    border
        The border of each of them.
    """
    closing = np.flatnonzero(pair[:, 1] > 0)
    sides, group = np.unique(pair[closing], axis=0, return_inverse=True)
    group = group.ravel()
    best = np.full(len(sides), -np.inf)
    np.maximum.at(best, group, score[closing])
    order = np.lexsort((-np.arange(len(sides)), best))
    return sides[order].astype(np.int64), closing, np.argsort(order)[group]


def gains(
    position: np.ndarray,
    owner: np.ndarray,
    labels: np.ndarray,
    links: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
) -> np.ndarray:
    """Expected loss that each segment saves at its turn.

    Found backwards: cells come back, the segment built last first, and each union of two parts adds what it loses.

    Parameters
    ----------
    position
        (n,) place of each segment in the order of construction, from 0.
    owner
        (cells,) segment of each cut cell, -1 for others.
    labels
        (cells,) compartments from 1, 0 for none.
    links
        (2, m) cells between which fire can pass; those between cells that are not cut are not needed.
    ignition, value
        (cells,) 0 off fuel.

    Returns
    -------
    numpy.ndarray
        (n,) at least 0, in the unit of ignition x value.
    """
    from firebreak_gis.kernels.contracting import come_back

    n_parts = int(labels.max(initial=0))
    cut = np.flatnonzero(owner >= 0)
    node = labels.astype(np.int64) - 1
    node[cut] = n_parts + np.arange(cut.size)
    turn = np.full(n_parts + cut.size, -1)
    turn[n_parts:] = position.size - 1 - position[owner[cut]]
    saved = np.bincount(turn[n_parts:], weights=ignition[cut] * value[cut], minlength=position.size)
    mass_i, mass_v = (_node_mass(plane, labels, cut, n_parts) for plane in (ignition, value))
    ways = node[links]
    key, sizes = keyed(*np.sort(ways[:, (turn[ways[0]] >= 0) | (turn[ways[1]] >= 0)], axis=0))
    ways = np.array(np.unravel_index(distinct(key), sizes))
    when = turn[ways].max(axis=0, initial=-1)
    order = np.argsort(when, kind="stable")
    come_back(ways[0, order], ways[1, order], when[order], mass_i, mass_v, saved)
    found: np.ndarray = saved[position.size - 1 - position]
    return found


def _node_mass(plane: np.ndarray, labels: np.ndarray, cut: np.ndarray, n_parts: int) -> np.ndarray:
    whole = np.bincount(labels, weights=plane, minlength=n_parts + 1)[1:]
    return np.concatenate([whole, plane[cut]])
