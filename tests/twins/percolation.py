"""Fires the slow way: draw every edge of a run in plain Python, then search breadth first."""

from __future__ import annotations

from collections import deque

import numpy as np

from firebreak_gis.network import SpreadNetwork

_MASK = (1 << 64) - 1
_STEPS = ((-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1))


def word(key: int, position: int) -> int:
    """Word of the SplitMix64 stream of `key`, in whole numbers without limit."""
    z = (key + (position + 1) * 0x9E3779B97F4A7C15) & _MASK
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
    return z ^ (z >> 31)


def draw(key: int, cell: int, direction: int) -> int:
    """The 32 digits of one edge: byte `direction` of four words, the most significant first."""
    digits = 0
    for j in range(4):
        digits = digits << 8 | (word(key, 4 * cell + j) >> (8 * direction)) & 255
    return digits


def is_open(key: int, cell: int, direction: int, probability: float) -> bool:
    """Whether the edge opens in the run of `key`."""
    if probability >= 1.0:
        return True
    return draw(key, cell, direction) < min(int(probability * 2**32 + 0.5), 2**32 - 2)


def open_edges(network: SpreadNetwork, key: int) -> dict[int, list[int]]:
    """Cells lit by each cell in the run of `key`."""
    rows, cols = network.shape
    found: dict[int, list[int]] = {}
    for row in range(rows):
        for col in range(cols):
            for d, (down, right) in enumerate(_STEPS):
                p = float(network.probability[d, row, col])
                if p > 0 and is_open(key, row * cols + col, d, p):
                    target = ((row + down) % rows) * cols + (col + right) % cols
                    found.setdefault(row * cols + col, []).append(target)
    return found


def burn(network: SpreadNetwork, key: int, ignitions: list[int], cut: np.ndarray | None = None) -> set[int]:
    """Cells that burn in one run; cut cells are passed over."""
    gone = set() if cut is None else set(np.flatnonzero(cut).tolist())
    edges = open_edges(network, key)
    burnt = {cell for cell in ignitions if cell >= 0 and cell not in gone}
    todo = deque(burnt)
    while todo:
        for target in edges.get(todo.popleft(), []):
            if target not in burnt and target not in gone:
                burnt.add(target)
                todo.append(target)
    return burnt
