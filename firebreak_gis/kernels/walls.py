"""Breaks that may fail, run by run: which treated cells hold, and what passes them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.bits import lowest
from firebreak_gis.kernels.draws import below, digits_of, edge_draw, word
from firebreak_gis.kernels.policy import inlined, kernel

_ONE = np.uint64(1)
#: Parts of a cell in which the ground is told that lines clear.
GROUND = 1 << 20


class Walls(NamedTuple):
    """Treated cells, and lines between cells. Without any, the arrays of cells are empty.

    Parameters
    ----------
    near
        (n_cells,) bool: whether a neighbour of the cell is treated, or a line crosses a link of it.
    holds
        (n_cells,) uint32, `draws.digits_of` the probability that the cell holds in a run; 0 for untreated ones.
    stretch
        (n_cells,) uint32: cells of one stretch hold or fail by one draw a run.
    keys
        (n_runs,) uint64 from `draws.run_keys`.
    residual
        (n_cells,) float64 share of its spread probability that a cell keeps where it holds; (1,) if all keep alike.
    probability
        (8, n_cells) float32 of the network without breaks.
    crossed
        (n_cells,) uint8: bit d set where a line crosses the link in direction d; empty without lines.
    line_holds
        (n_cells,) uint32: as `holds`, of the lines across the links to cells of a higher number.
    line_stretch
        (n_cells,) uint32: as `stretch`, of those lines.
    crews
        (n_cells,) uint64 [s]: nothing holds against fire that comes to the cell before; empty if crews are everywhere.
    """

    near: np.ndarray
    holds: np.ndarray
    stretch: np.ndarray
    keys: np.ndarray
    residual: np.ndarray
    probability: np.ndarray
    crossed: np.ndarray
    line_holds: np.ndarray
    line_stretch: np.ndarray
    crews: np.ndarray


class Cleared(NamedTuple):
    """Ground that lines clear; apart from `Walls`, which the hot loop is given. Without lines, empty.

    Parameters
    ----------
    ground
        (n, 4) uint32: a cell, how many of the `GROUND` parts of it a line clears, and as `Walls.holds` and
        `Walls.stretch`, of that line; cells rise.
    first
        (n_cells,) uint32: the first of `ground` in the cell; n where there is none.
    keys
        (n_runs,) uint64 from `draws.run_keys`, for where in its cell a fire starts.
    """

    ground: np.ndarray
    first: np.ndarray
    keys: np.ndarray


@inlined
def holding(key: np.uint64, stretch: np.uint32, threshold: np.uint32) -> bool:
    """Whether a stretch holds in the run of `key`."""
    result = False
    if threshold != np.uint32(0):
        result = below(word(key, np.uint64(stretch)) >> np.uint64(32), np.uint64(threshold))
    return result


@inlined
def stands(walls: Walls, run: int, cell: np.uint64) -> bool:
    """Whether a cell is treated and holds in the run."""
    return holding(walls.keys[run], walls.stretch[cell], walls.holds[cell])


@inlined
def manned(walls: Walls, cell: np.uint64, t: np.uint64) -> bool:
    """Whether crews are at a cell before fire that comes at t [s]."""
    return walls.crews.size == 0 or t >= walls.crews[cell]


@inlined
def kept(walls: Walls, cell: np.uint64) -> float:
    """Share of its spread probability that a treated cell keeps where it holds."""
    return walls.residual[cell if walls.residual.size > 1 else np.uint64(0)]


@inlined
def spared_of(key: np.uint64, k: np.uint32, ground: np.ndarray, cell: np.uint64, keeps: float) -> int:
    """See `spared`; `k` is the first of `ground` in the cell, `keeps` what lines leave of the spread, 1 without crews.

    By plain values, for loops over what burns: numba counts the holders of an array wherever it goes.
    """
    result = 0
    while k < ground.shape[0] and ground[k, 0] == cell:
        if holding(key, ground[k, 3], ground[k, 2]):
            result += np.int64(ground[k, 1])
        k += np.uint32(1)
    return np.int64(np.floor(min(result, GROUND) * (1.0 - keeps)))


@kernel
def spared(walls: Walls, cleared: Cleared, run: int, cell: np.uint64, t: np.uint64) -> int:
    """Ground that does not burn of a cell to which fire comes at t [s], of `GROUND`: what lines clear that hold.

    Of the ground under lines that leak, as much burns as they leave of the spread.
    """
    keeps = kept(walls, cell) if manned(walls, cell, t) else 1.0
    return spared_of(walls.keys[run], cleared.first[cell], cleared.ground, cell, keeps)


@inlined
def falls_on(key: np.uint64, cell: np.uint64, ground: int) -> bool:
    """Whether a fire that starts in a cell, told by its number on the map, does so on some ground, of `GROUND`."""
    return np.int64(word(key, cell) >> np.uint64(44)) < ground


@kernel
def off_ground(keys: np.ndarray, starts: np.ndarray, cells: np.ndarray, ground: np.ndarray) -> np.ndarray:
    """Ignitions of runs without those that fall on ground which does not burn: (n,) int64, -1 for these.

    Parameters
    ----------
    keys
        (n_runs,) uint64, as `Cleared.keys`.
    starts, cells
        Those of run i are ``cells[starts[i]:starts[i + 1]]``; -1 burns nothing.
    ground
        (n_cells,) int64, of `GROUND`.
    """
    out = cells.copy()
    for run in range(keys.size):
        for i in range(starts[run], starts[run + 1]):
            if cells[i] >= 0 and falls_on(keys[run], np.uint64(cells[i]), ground[cells[i]]):
                out[i] = -1
    return out


@inlined
def held_back(
    hold_key: np.uint64,
    holds: np.ndarray,
    stretch: np.ndarray,
    residual: np.ndarray,
    probability: np.ndarray,
    crossed: np.ndarray,
    line_holds: np.ndarray,
    line_stretch: np.ndarray,
    key: np.uint64,
    here: np.uint64,
    digits: np.uint64,
    offsets: np.ndarray,
    position: np.uint8,
    cell: np.uint64,
    opened: np.uint64,
) -> np.uint64:
    """What is left of the open edges of a cell once the breaks beside it have done their work.

    The probability of an edge into a cell that holds, or across a line that does, is multiplied by what the cell keeps;
    the draw stays the same. Crews are taken to be there. Arrays by plain names, see `arrival.burn_run`; `here` is the
    number of the cell on the map, `digits` are the first eight of the draws of each of its edges.
    """
    left = opened
    across = crossed[cell] if crossed.size > 0 else np.uint8(0)
    while opened != np.uint64(0):
        bit = lowest(opened)
        opened &= opened - _ONE
        d = bit >> np.uint64(3)
        target = cell + offsets[position, d]
        held = holding(hold_key, stretch[target], holds[target])
        if not held and (across >> np.uint8(d)) & np.uint8(1):
            first = min(cell, target)
            held = holding(hold_key, line_stretch[first], line_holds[first])
        if held:
            passes = False
            share = np.float32(residual[target if residual.size > 1 else np.uint64(0)])
            if share > np.float32(0):
                chance = np.float32(probability[d, cell] * share)
                threshold = digits_of(np.float64(chance))
                most, draw = threshold >> np.uint64(24), (digits >> (bit - np.uint64(7))) & np.uint64(255)
                passes = draw < most or (draw == most and below(edge_draw(key, here, d), threshold))
            if not passes:
                left &= ~(_ONE << bit)
    return left
