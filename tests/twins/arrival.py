"""Fires with a clock the slow way: Dijkstra with a heap over the edges that plain Python finds open, embers and all."""

from __future__ import annotations

import heapq
import math
from dataclasses import dataclass, field

import numpy as np

from firebreak_gis.lattice import NEVER
from firebreak_gis.network import SpreadNetwork
from tests.twins.percolation import _STEPS, is_open, word


def across(t: int, seconds: list[int], starts: list[int]) -> float:
    """When fire that sets out at t is across, at `seconds[k]` from `starts[k]` on; share by share of the way."""
    step = max(k for k, start in enumerate(starts) if start <= t)
    left = 1.0
    for k in range(step, len(seconds)):
        last = k + 1 == len(seconds)
        if seconds[k] != NEVER:
            need = math.ceil(left * seconds[k] - 1e-6)
            if last or t + need <= starts[k + 1]:
                return t + need
            left = max(left - (starts[k + 1] - t) / seconds[k], 0.0)
        if not last:
            t = starts[k + 1]
    return math.inf


def uniform(key: int, position: int) -> float:
    """53 digits of a word."""
    return (word(key, position) >> 11) * 2.0**-53


def normal(key: int, position: int) -> float:
    """Box and Muller, of the two halves of a word."""
    digits = word(key, position)
    return math.sqrt(-2.0 * math.log(((digits >> 32) + 1) / 2**32)) * math.cos(
        2.0 * math.pi * (digits & 0xFFFFFFFF) / 2**32
    )


@dataclass
class Fire:
    """One run.

    Parameters
    ----------
    network
        Before cutting.
    key
        Of the run, for its edges.
    times, starts
        Travel times (8, rows, cols) in each step of the weather, and when it begins.
    limit
        Duration [s].
    stands
        Treated cells that hold in the run.
    parted
        Pairs of cells, the lower number first, between which a line holds in the run.
    ground, ground_key
        Share of each cell that lines clear which hold in the run, and the key of the run for where fires start.
    residual
        What they keep of their probability: a number, or one a cell.
    crews
        When crews are at each cell [s]; before that it does not stand. None: they always are.
    embers, ember_key
        The kernel's `Embers` as plain arrays, and the key of the run for them.
    """

    network: SpreadNetwork
    key: int
    times: list[np.ndarray]
    starts: list[int] = field(default_factory=lambda: [0])
    limit: float = math.inf
    stands: frozenset[int] = frozenset()
    parted: frozenset[tuple[int, int]] = frozenset()
    ground: np.ndarray | None = None
    ground_key: int = 0
    residual: float | np.ndarray = 0.0
    crews: np.ndarray | None = None
    embers: object = None
    ember_key: int = 0

    def burn(self, ignitions: dict[int, int]) -> dict[int, int]:
        """Arrival time of every burnt cell, from cells and the times at which they are lit."""
        arrival: dict[int, int] = {}
        heap = [(t, c) for c, t in ignitions.items() if c >= 0 and not (self._kept(c) == 0 and self._starts_not(c, t))]
        heapq.heapify(heap)
        while heap:
            t, cell = heapq.heappop(heap)
            if cell in arrival or t > self.limit:
                continue
            arrival[cell] = t
            for when, target in [*self._edges(cell, t), *self._embers(cell, t)]:
                if target not in arrival and when < math.inf:
                    heapq.heappush(heap, (int(when), target))
        return arrival

    def _manned(self, cell: int, t: float) -> bool:
        return self.crews is None or t >= self.crews.flat[cell]

    def _held(self, cell: int, t: float) -> bool:
        return cell in self.stands and self._manned(cell, t)

    def _starts_not(self, cell: int, t: float) -> bool:
        return self._held(cell, t) or (word(self.ground_key, cell) >> 44) / 2**20 < self._cleared(cell, t)

    def _cleared(self, cell: int, t: float) -> float:
        return 0.0 if self.ground is None or not self._manned(cell, t) else float(self.ground[cell])

    def _kept(self, cell: int) -> float:
        return float(np.broadcast_to(self.residual, self.network.shape).flat[cell])

    def _edges(self, cell: int, t: int):
        rows, cols = self.network.shape
        row, col = divmod(cell, cols)
        for d, (down, right) in enumerate(_STEPS):
            target = ((row + down) % rows) * cols + (col + right) % cols
            p = self.network.probability[d, row, col]
            when = across(t, [int(each[d, row, col]) for each in self.times], self.starts)
            line = (min(cell, target), max(cell, target)) in self.parted and self._manned(target, when)
            if line or self._held(target, when):
                p = np.float32(p * np.float32(self._kept(target)))
            if p > 0 and is_open(self.key, cell, d, float(p)):
                yield when, target

    def _embers(self, cell: int, t: int):
        if self.embers is None or self._held(cell, t):
            return
        e, key, base = self.embers, self.ember_key, 64 * cell
        rows, cols = self.network.shape
        step = max(k for k, start in enumerate(self.starts) if start <= t)
        mean = float(e.mean[step, cell])
        u, share, number = uniform(key, base), math.exp(-mean), 0
        total = share
        while mean > 0 and u >= total and number < 15:
            number += 1
            share *= mean / number
            total += share
        for k in range(number):
            at = base + 1 + 4 * k
            angle = e.spread * normal(key, at)
            stretch = float(e.sigma[step, 0]) * normal(key, at + 1) + e.focus * (math.cos(angle) - 1)
            distance = min(float(e.median[step, cell]) * math.exp(stretch), e.longest)
            heading = float(e.downwind[step, 0]) + angle
            row = cell // cols - round(distance * math.cos(heading))
            col = cell % cols + round(distance * math.sin(heading))
            if self.network.boundary == "periodic":
                row, col = row % rows, col % cols
            if 0 <= row < rows and 0 <= col < cols:
                target = row * cols + col
                when = t + max(60, round(e.delay * math.exp(e.delay_sigma * normal(key, at + 3))))
                chance = float(e.catches[target]) * (self._kept(target) if self._held(target, when) else 1.0)
                if uniform(key, at + 2) < chance * (1.0 - self._cleared(target, when)):
                    yield when, target
