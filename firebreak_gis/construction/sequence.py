"""The order in which to build the segments of a plan, and what each saves."""

from __future__ import annotations

import numpy as np

from firebreak_gis.construction.keys import keyed
from firebreak_gis.kernels.joining import take_away


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
    Cost: at most n steps over arrays of the borders that still stand.
    """
    mean = float(cost.mean()) if cost.size else 0.0
    least = 1e-9 * mean if mean > 0 else 1.0
    mass = np.array([np.append(0.0, compartment_ignition), np.append(0.0, compartment_value)])
    loose = np.flatnonzero(pair[:, 1] == 0)
    side = pair[loose, 0]
    saved = _joined(mass[:, side], np.zeros((2, loose.size)), np.array([ignition[loose], value[loose]]))
    last = loose[np.lexsort((loose, -score[loose], -saved / np.maximum(cost[loose], least)))]
    np.add.at(mass[0], side, ignition[loose])
    np.add.at(mass[1], side, value[loose])
    one, other, sums, members = _borders(pair, cost, ignition, value, score)
    turns, into = take_away(one, other, *sums, mass, least)
    for k in turns.tolist():  # what is joined to a border is gone before it
        if into[k] >= 0:
            members[into[k]] += members[k]
    removed = [sorted(members[k], key=lambda i: (-score[i], i)) for k in turns.tolist() if into[k] < 0]
    return removed[::-1] + [[int(i)] for i in last]


def _joined(one: np.ndarray, other: np.ndarray, own: np.ndarray) -> np.ndarray:
    """Expected loss when two compartments and the fuel between them become one; arrays are (ignition, value)."""
    both = one + other + own
    loss: np.ndarray = both[0] * both[1] - one[0] * one[1] - other[0] * other[1]
    loss[loss < 0] = 0.0  # rounding
    return loss


def _borders(
    pair: np.ndarray, cost: np.ndarray, ignition: np.ndarray, value: np.ndarray, score: np.ndarray
) -> tuple[np.ndarray, np.ndarray, list[np.ndarray], list[list[int]]]:
    """Borders in the order in which equal ones are taken away: compartments, sums of cost and so on, and segments."""
    closing = np.flatnonzero(pair[:, 1] > 0)
    sides, group = np.unique(pair[closing], axis=0, return_inverse=True)
    group = group.ravel()
    best = np.full(len(sides), -np.inf)
    np.maximum.at(best, group, score[closing])
    order = np.lexsort((-np.arange(len(sides)), best))
    rank = np.argsort(order)[group]
    members: list[list[int]] = [[] for _ in sides]
    for i, k in zip(closing.tolist(), rank.tolist(), strict=True):
        members[k].append(i)
    sums = [np.bincount(rank, weights=plane[closing], minlength=len(sides)) for plane in (cost, ignition, value)]
    return sides[order, 0], sides[order, 1], sums, members


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
        (2, m) cells between which fire can pass.
    ignition, value
        (cells,) 0 off fuel.

    Returns
    -------
    numpy.ndarray
        (n,) at least 0, in the unit of ignition x value.
    """
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
    ways = np.array(np.unravel_index(np.unique(key), sizes))
    when = turn[ways].max(axis=0, initial=-1)
    order = np.argsort(when, kind="stable")
    root = list(range(turn.size))
    back = saved.tolist()
    for a, b, t in zip(ways[0, order].tolist(), ways[1, order].tolist(), when[order].tolist(), strict=True):
        a, b = _find(root, a), _find(root, b)
        if a != b:
            a, b = min(a, b), max(a, b)
            back[t] += mass_i[a] * mass_v[b] + mass_i[b] * mass_v[a]
            root[b] = a
            mass_i[a] += mass_i[b]
            mass_v[a] += mass_v[b]
    found: np.ndarray = np.array(back, dtype=np.float64)[position.size - 1 - position]
    return found


def _node_mass(plane: np.ndarray, labels: np.ndarray, cut: np.ndarray, n_parts: int) -> list[float]:
    whole = np.bincount(labels, weights=plane, minlength=n_parts + 1)[1:]
    masses: list[float] = np.concatenate([whole, plane[cut]]).tolist()
    return masses


def _find(root: list[int], a: int) -> int:
    while root[a] != a:
        root[a] = root[root[a]]
        a = root[a]
    return a
