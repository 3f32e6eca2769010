"""The order in which to build the segments of a plan, and what each saves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass
class _Groups:
    """All segments between the same two compartments as one; arrays of equal length, shortened as groups go."""

    one: np.ndarray
    other: np.ndarray
    cost: np.ndarray
    ignition: np.ndarray
    value: np.ndarray
    members: list[list[int]]

    def drop(self, gone: np.ndarray) -> None:
        kept = np.ones(self.one.size, bool)
        kept[gone] = False
        for name in ("one", "other", "cost", "ignition", "value"):
            setattr(self, name, getattr(self, name)[kept])
        self.members = [self.members[i] for i in np.flatnonzero(kept)]


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
    groups = _group(pair, cost, ignition, value, score)
    place = np.full(mass.shape[1], -1)
    removed: list[list[int]] = []
    while groups.one.size:
        own = np.array([groups.ignition, groups.value])
        lost = _joined(mass[:, groups.one], mass[:, groups.other], own)
        k = int(np.argmin(lost / np.maximum(groups.cost, least)))
        removed.append(sorted(groups.members[k], key=lambda i: (-score[i], i)))
        _join(groups, k, mass, place)
    return removed[::-1] + [[int(i)] for i in last]


def _joined(one: np.ndarray, other: np.ndarray, own: np.ndarray) -> np.ndarray:
    """Expected loss when two compartments and the fuel between them become one; arrays are (ignition, value)."""
    both = one + other + own
    loss: np.ndarray = both[0] * both[1] - one[0] * one[1] - other[0] * other[1]
    loss[loss < 0] = 0.0  # rounding
    return loss


def _group(pair: np.ndarray, cost: np.ndarray, ignition: np.ndarray, value: np.ndarray, score: np.ndarray) -> _Groups:
    """Borders in the order in which equal ones are taken away."""
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
    return _Groups(sides[order, 0], sides[order, 1], sums[0], sums[1], sums[2], members)


def _join(groups: _Groups, k: int, mass: np.ndarray, place: np.ndarray) -> None:
    """Take border k away: its two compartments become one, and so do their borders to a common neighbour."""
    keep, gone = int(groups.one[k]), int(groups.other[k])
    mass[:, keep] += mass[:, gone] + np.array([groups.ignition[k], groups.value[k]])
    groups.drop(np.array([k]))
    moved = np.flatnonzero((groups.one == gone) | (groups.other == gone))
    stay = np.flatnonzero((groups.one == keep) | (groups.other == keep))
    groups.one[groups.one == gone] = keep
    groups.other[groups.other == gone] = keep
    beyond = groups.one + groups.other - keep
    place[beyond[stay]] = stay
    double = moved[place[beyond[moved]] >= 0]
    into = place[beyond[double]]
    place[beyond[stay]] = -1
    for plane in (groups.cost, groups.ignition, groups.value):
        plane[into] += plane[double]
    for i, j in zip(double.tolist(), into.tolist(), strict=True):
        groups.members[j] += groups.members[i]
    groups.drop(double)


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
    ways = np.unique(np.sort(ways[:, (turn[ways[0]] >= 0) | (turn[ways[1]] >= 0)], axis=0), axis=1)
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
