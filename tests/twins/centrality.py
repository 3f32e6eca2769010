"""Centralities by dense matrices, dictionaries and exact integers, and maps turned round."""

from __future__ import annotations

import heapq
from fractions import Fraction

import numpy as np

from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork

#: The eight turns of a square, as functions of a (rows, cols) array.
SYMMETRIES = {
    f"{'mirrored ' if mirror else ''}turned {quarter * 90}": (mirror, quarter)
    for mirror in (False, True)
    for quarter in range(4)
}


def turn(plane: np.ndarray, symmetry: tuple[bool, int]) -> np.ndarray:
    """Mirror a map left to right if asked, then turn it by quarters anticlockwise."""
    mirror, quarters = symmetry
    return np.rot90(plane[..., ::-1] if mirror else plane, quarters, axes=(-2, -1))


def turn_direction(direction: int, symmetry: tuple[bool, int]) -> int:
    """Direction into which `direction` is carried by `turn`."""
    mirror, quarters = symmetry
    row, col = ROW_STEP[direction], COL_STEP[direction]
    if mirror:
        col = -col
    for _ in range(quarters):
        row, col = -col, row
    return list(zip(ROW_STEP, COL_STEP, strict=True)).index((row, col))


def turn_network(network: SpreadNetwork, symmetry: tuple[bool, int]) -> SpreadNetwork:
    """Return the network of the turned landscape, on no particular ground."""

    def turned(planes: np.ndarray) -> np.ndarray:
        out = np.empty((8, *turn(network.burnable, symmetry).shape), planes.dtype)
        for d in range(8):
            out[turn_direction(d, symmetry)] = turn(planes[d], symmetry)
        return out

    times, heat = network.travel_time, network.heat
    return SpreadNetwork(
        turned(network.probability),
        burnable=turn(network.burnable, symmetry),
        boundary=network.boundary,
        travel_time=None if times is None else turned(times),
        heat=None if heat is None else turn(heat, symmetry),
    )


def adjacency(network: SpreadNetwork) -> np.ndarray:
    """Dense matrix a_lk = p(l -> k), written edge by edge."""
    rows, cols = network.shape
    matrix = np.zeros((rows * cols, rows * cols))
    for d in range(8):
        for row in range(rows):
            for col in range(cols):
                p = float(network.probability[d, row, col])
                if p > 0:
                    to_row, to_col = (row + ROW_STEP[d]) % rows, (col + COL_STEP[d]) % cols
                    matrix[row * cols + col, to_row * cols + to_col] = p
    return matrix


def bonacich(network: SpreadNetwork, beta: float, orientation: str) -> np.ndarray:
    """Dense solve of x = (I - beta / lambda A)^-1 A 1."""
    matrix = adjacency(network)
    matrix = matrix.T if orientation == "in" else matrix
    radius = np.abs(np.linalg.eigvals(matrix)).max()
    x = np.linalg.solve(np.eye(len(matrix)) - beta / radius * matrix, matrix.sum(axis=1))
    return x.reshape(network.shape)


def eigenvector(network: SpreadNetwork, orientation: str) -> np.ndarray:
    """Eigenvector of the largest eigenvalue from a dense decomposition, largest entry 1."""
    matrix = adjacency(network)
    values, vectors = np.linalg.eig(matrix.T if orientation == "in" else matrix)
    x = np.abs(vectors[:, np.argmax(values.real)])
    return (x / x.max()).reshape(network.shape)


def length(probability: float) -> Fraction:
    """Length of an edge, a multiple of 2**-24."""
    return Fraction(round(Fraction(2**24) / Fraction(float(np.float32(probability)))), 2**24)


def edges(network: SpreadNetwork) -> list[tuple[int, int, Fraction]]:
    """Source, target and length of every edge."""
    matrix = adjacency(network)
    return [(int(a), int(b), length(matrix[a, b])) for a, b in np.argwhere(matrix)]


def dependencies(network: SpreadNetwork, source: int) -> np.ndarray:
    """Share of shortest paths from `source` through each cell, summed over targets; paths counted as integers."""
    leaving: dict[int, list[tuple[int, int]]] = {}
    for a, b, step in edges(network):
        leaving.setdefault(a, []).append((b, int(step * 2**24)))
    distance, n_paths = {source: 0}, {source: 1}
    before: dict[int, list[int]] = {source: []}
    waiting, order, settled = [(0, source)], [], set()
    while waiting:
        _, cell = heapq.heappop(waiting)
        if cell in settled:
            continue
        settled.add(cell)
        order.append(cell)
        for target, step in leaving.get(cell, []):
            reach = distance[cell] + step
            if target not in distance or reach < distance[target]:
                distance[target], n_paths[target], before[target] = reach, n_paths[cell], [cell]
                heapq.heappush(waiting, (reach, target))
            elif reach == distance[target]:
                n_paths[target] += n_paths[cell]
                before[target].append(cell)
    through = np.zeros(network.burnable.size)
    for cell in reversed(order):
        for previous in before[cell]:
            # Division of integers of any size is rounded once.
            through[previous] += n_paths[previous] / n_paths[cell] * (1 + through[cell])
    through[source] = 0
    return through.reshape(network.shape)


def conductances(network: SpreadNetwork) -> np.ndarray:
    """Dense matrix of the mean of the two probabilities between cells."""
    matrix = adjacency(network)
    return 0.5 * (matrix + matrix.T)


def domirank(network: SpreadNetwork, competition: float, orientation: str) -> np.ndarray:
    """Dense solve of Gamma = sigma (I + sigma A)^-1 A 1, sigma a share of 1 / |least eigenvalue|."""
    matrix = adjacency(network)
    matrix = matrix.T if orientation == "in" else matrix
    sigma = competition / -np.linalg.eigvals(matrix).real.min()
    x = np.linalg.solve(np.eye(len(matrix)) + sigma * matrix, sigma * matrix.sum(axis=1))
    return x.reshape(network.shape)


def shortest_paths(network: SpreadNetwork, source: int) -> dict[int, list[list[int]]]:
    """All shortest paths from `source` to every cell that it reaches, each as a list of cells, one by one."""
    found = {source: [[source]]}
    distance: dict[int, int] = {source: 0}
    leaving: dict[int, list[tuple[int, int]]] = {}
    for a, b, step in edges(network):
        leaving.setdefault(a, []).append((b, int(step * 2**24)))
    waiting, settled = [(0, source)], set()
    while waiting:
        reach, cell = heapq.heappop(waiting)
        if cell in settled:
            continue
        settled.add(cell)
        for target, step in leaving.get(cell, []):
            if target not in distance or reach + step < distance[target]:
                distance[target], found[target] = reach + step, []
                heapq.heappush(waiting, (reach + step, target))
            if reach + step == distance[target]:
                found[target] += [[*path, target] for path in found[cell]]
    return found


def uncovered(network: SpreadNetwork, group: set[int]) -> np.ndarray:
    """What each cell adds to the betweenness of a group: shares of shortest paths, listed one by one."""
    gains = np.zeros(network.burnable.size)
    for source in set(np.flatnonzero(network.burnable).tolist()) - group:
        for target, ways in shortest_paths(network, source).items():
            if target == source or target in group:
                continue
            for way in ways:
                if not group & set(way):
                    gains[way[1:-1]] += 1.0 / len(ways)
    return gains.reshape(network.shape)
