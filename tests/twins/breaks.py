"""Cutting cells and outlining pieces, by sorting lists and flooding sets."""

from __future__ import annotations

import math

import numpy as np


def removal_order(priority: np.ndarray) -> list[tuple[int, int]]:
    """Cells in the order of cutting."""
    cells = [
        (-float(priority[row, col]), row, col)
        for row in range(priority.shape[0])
        for col in range(priority.shape[1])
        if not math.isnan(priority[row, col]) and priority[row, col] != -math.inf
    ]
    return [(row, col) for _, row, col in sorted(cells)]


def pieces(cut: np.ndarray) -> list[frozenset[tuple[int, int]]]:
    """Sets of cut cells that hang together over sides and corners."""
    left = {(int(row), int(col)) for row, col in np.argwhere(cut)}
    found = []
    while left:
        piece, todo = set(), [left.pop()]
        while todo:
            row, col = todo.pop()
            piece.add((row, col))
            near = {(row + i, col + j) for i in (-1, 0, 1) for j in (-1, 0, 1)} & left
            left -= near
            todo += near
        found.append(frozenset(piece))
    return found
