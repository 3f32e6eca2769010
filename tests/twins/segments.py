"""Compartments by networkx, borders cell by cell, and losses by cutting in the given order."""

from __future__ import annotations

import itertools

import networkx as nx
import numpy as np

from firebreak_gis.network import SpreadNetwork

Cell = tuple[int, int]
SIDES = ((-1, 0), (0, -1), (0, 1), (1, 0))
CORNERS = ((-1, -1), (-1, 1), (1, -1), (1, 1))


def compartments(network: SpreadNetwork, cut: np.ndarray) -> list[set[Cell]]:
    """Weakly connected parts of the graph without the cut cells."""
    graph = network.to_networkx()
    graph.remove_nodes_from([tuple(cell) for cell in np.argwhere(cut).tolist()])
    return list(nx.weakly_connected_components(graph))


def loss(network: SpreadNetwork, cut: np.ndarray, ignition: np.ndarray, value: np.ndarray) -> float:
    """Sum over compartments of the share of ignitions times the value."""
    total = ignition[network.burnable].sum()
    return sum(
        sum(ignition[cell] for cell in part) / total * sum(value[cell] for cell in part)
        for part in compartments(network, cut)
    )


def gains(network: SpreadNetwork, owner: np.ndarray, n: int, ignition: np.ndarray, value: np.ndarray) -> list[float]:
    """Drop of the loss as segments 1 to n of `owner` (0 for cells that are not cut) are built in turn."""
    losses = [loss(network, (owner > 0) & (owner <= k), ignition, value) for k in range(n + 1)]
    return [before - after for before, after in itertools.pairwise(losses)]


def quarters(labels: np.ndarray, cut: np.ndarray, periodic: bool) -> dict[Cell, int]:
    """Nearest compartment of all quarters of cells; grown in rounds, over corners in every other one."""
    rows, cols = 2 * labels.shape[0], 2 * labels.shape[1]
    wall = {(r, c) for r in range(rows) for c in range(cols) if cut[r // 2, c // 2]}
    label = {
        (r, c): int(labels[r // 2, c // 2]) for r in range(rows) for c in range(cols) if labels[r // 2, c // 2] > 0
    }
    quiet, turn = 0, 1
    while quiet < 2:
        new = {}
        for r, c in wall - set(label):
            near = [(r + a, c + b) for a, b in (SIDES if turn % 2 else SIDES + CORNERS)]
            near = [(a % rows, b % cols) for a, b in near] if periodic else near
            found = [label[cell] for cell in near if cell in label]
            if found:
                new[r, c] = min(found)
        label |= new
        quiet = 0 if new else quiet + 1
        turn += 1
    return label


def border_units(labels: np.ndarray, cut: np.ndarray) -> set[tuple[tuple[int, int], Cell, Cell]]:
    """Pair of compartments and the two ends (x, y), in half cells, of each unit of border; open grid."""
    label = quarters(labels, cut, periodic=False)
    units = set()
    for (r, c), mine in label.items():
        for other, ends in (((r, c + 1), ((c + 1, r), (c + 1, r + 1))), ((r + 1, c), ((c, r + 1), (c + 1, r + 1)))):
            inside = cut[r // 2, c // 2] or (other in label and cut[other[0] // 2, other[1] // 2])
            if inside and label.get(other, mine) != mine:
                units.add((tuple(sorted((mine, label[other]))), *ends))
    return units


def order(
    pair: list[tuple[int, int]], cost: list[float], own: list[tuple[float, float]], mass: dict[int, tuple[float, float]]
) -> list[set[int]]:
    """Stages by taking away, again and again, the border that loses least for its cost."""
    root = {k: k for k in mass}
    mass, left, removed = dict(mass), set(range(len(pair))), []
    while left:
        groups: dict[tuple[int, int], set[int]] = {}
        for i in sorted(left):
            groups.setdefault(tuple(sorted((root[pair[i][0]], root[pair[i][1]]))), set()).add(i)

        def ratio(item: tuple[tuple[int, int], set[int]]) -> float:
            (a, b), members = item
            joined = [mass[a][k] + mass[b][k] + sum(own[i][k] for i in members) for k in (0, 1)]
            lost = joined[0] * joined[1] - mass[a][0] * mass[a][1] - mass[b][0] * mass[b][1]
            return lost / sum(cost[i] for i in members)

        (a, b), members = min(groups.items(), key=ratio)
        mass[a] = tuple(mass[a][k] + mass[b][k] + sum(own[i][k] for i in members) for k in (0, 1))
        root = {k: a if v == b else v for k, v in root.items()}
        removed.append(members)
        left -= members
    return removed[::-1]
