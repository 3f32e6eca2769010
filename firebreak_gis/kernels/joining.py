"""Compartments that become one again, border by border."""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import kernel


@kernel
def take_away(
    one: np.ndarray,
    other: np.ndarray,
    cost: np.ndarray,
    ignition: np.ndarray,
    value: np.ndarray,
    mass: np.ndarray,
    least: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Take away the border whose absence loses least for its cost, again and again; of equal ones the first.

    Two compartments whose border is gone are one, and their borders to a common neighbour are one from then on.

    Parameters
    ----------
    one, other
        (n,) int64 compartments on the two sides of each border; no two borders have the same.
    cost, ignition, value
        (n,) float64, of the cells of each border.
    mass
        (2, m) float64: ignition and value of each compartment.
    least
        Costs count as that at least.

    Returns
    -------
    tuple
        (n,) int64 borders in the order in which they are gone, and for each that was joined to another that one, -1
        for others.

    Notes
    -----
    Cost: a look at all borders at each turn.
    """
    n = one.size
    one, other, mass = one.copy(), other.copy(), mass.copy()
    cost, ignition, value = cost.copy(), ignition.copy(), value.copy()
    ratio = np.empty(n, np.float64)
    stale, there = np.ones(n, np.bool_), np.ones(n, np.bool_)
    place = np.full(mass.shape[1], -1, np.int64)
    into, turns = np.full(n, -1, np.int64), np.empty(n, np.int64)
    n_gone = 0
    while n_gone < n:
        k = -1
        for i in range(n):
            if not there[i]:
                continue
            if stale[i]:
                a, b = one[i], other[i]
                lit = mass[0, a] + mass[0, b] + ignition[i]
                worth = mass[1, a] + mass[1, b] + value[i]
                lost = lit * worth - mass[0, a] * mass[1, a] - mass[0, b] * mass[1, b]
                ratio[i] = max(lost, 0.0) / max(cost[i], least)  # rounding may leave less than nothing
                stale[i] = False
            if k < 0 or ratio[i] < ratio[k]:
                k = i
        keep, gone = one[k], other[k]
        mass[0, keep] += mass[0, gone] + ignition[k]
        mass[1, keep] += mass[1, gone] + value[k]
        there[k] = False
        turns[n_gone] = k
        n_gone += 1
        for i in range(n):
            if there[i] and (one[i] == keep or other[i] == keep):
                place[one[i] + other[i] - keep] = i
                stale[i] = True
        for i in range(n):
            if there[i] and (one[i] == gone or other[i] == gone):
                j = place[one[i] + other[i] - gone]
                if j >= 0:
                    cost[j] += cost[i]
                    ignition[j] += ignition[i]
                    value[j] += value[i]
                    there[i] = False
                    into[i] = j
                    turns[n_gone] = i
                    n_gone += 1
                elif one[i] == gone:
                    one[i] = keep
                else:
                    other[i] = keep
                stale[i] = True
        for i in range(n):
            if there[i] and (one[i] == keep or other[i] == keep):
                place[one[i] + other[i] - keep] = -1
    return turns, into
