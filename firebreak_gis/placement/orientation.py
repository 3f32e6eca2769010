"""Work on a landscape in its standard orientation, so that a turned or mirrored map gives the turned plan."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from affine import Affine

from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.stakes import Stakes
from firebreak_gis.threads import thread_count

if TYPE_CHECKING:
    Turn = Callable[[np.ndarray], np.ndarray]

_STEPS = list(zip(ROW_STEP, COL_STEP, strict=True))
#: Mirror left to right or not, then quarter turns anticlockwise.
_SYMMETRIES = tuple((mirror, quarters) for mirror in (False, True) for quarters in range(4))


def in_standard_orientation(
    network: SpreadNetwork, stakes: Stakes, method: Callable[[SpreadNetwork, Stakes, Turn], np.ndarray]
) -> np.ndarray:
    """Call `method` on the map turned to its standard orientation and turn the answer back.

    The standard orientation is the one of the eight turns of the square whose bytes have the smallest BLAKE2
    digest. Methods that break ties by row and column then do so alike on all eight maps.

    Parameters
    ----------
    network, stakes
        The landscape as it lies.
    method
        Called as ``method(network, stakes, turn)`` with the turned landscape; ``turn`` turns any other
        (..., rows, cols) plane alike. Returns (rows, cols) of the turned map.

    Returns
    -------
    numpy.ndarray
        (rows, cols) of the map as it lies.
    """
    with ThreadPoolExecutor(thread_count(None)) as pool:
        digests = list(pool.map(partial(_digest, network, stakes), _SYMMETRIES))
    symmetry = _SYMMETRIES[digests.index(min(digests))]
    if symmetry == (False, 0):
        return method(network, stakes, _turn(symmetry))
    turn = _turn(symmetry)
    directions = _directions(symmetry)
    times, heat, side = network.travel_time, network.heat, abs(network.grid.transform.a)
    turned = SpreadNetwork(
        np.stack([turn(network.probability[d]) for d in directions]),
        burnable=turn(network.burnable),
        boundary=network.boundary,
        transform=Affine.scale(side, -side),
        travel_time=None if times is None else np.stack([turn(times[d]) for d in directions]),
        heat=None if heat is None else turn(heat),
    )
    answer = method(turned, _turned_setting(turned, stakes, turn), turn)
    mirror, quarters = symmetry
    back = np.rot90(answer, -quarters, axes=(-2, -1))
    return np.ascontiguousarray(back[..., ::-1] if mirror else back)


def turned_corner(turn: Turn) -> tuple[int, int]:
    """Where the lower right corner of a square lies after a turn: down or up, right or left, each 1 or -1.

    Examples
    --------
    >>> turned_corner(np.fliplr), turned_corner(np.rot90)
    ((1, -1), (-1, 1))
    """
    row, col = np.argwhere(turn(np.array([[0, 0], [0, 1]])))[0]
    return int(2 * row - 1), int(2 * col - 1)


def _turned_setting(turned: SpreadNetwork, stakes: Stakes, turn: Turn) -> Stakes:
    if not turned.burnable.any():
        return Stakes(turned)
    planes = {name: getattr(stakes, name) for name in ("cost", "value", "ignition", "difficulty")}
    # What nobody gave is one plane, which is made anew.
    times = Counter(map(id, planes.values()))
    given = {name: turn(plane) for name, plane in planes.items() if times[id(plane)] == 1}
    return Stakes(turned, protected=turn(stakes.protected), **given)


def _turn(symmetry: tuple[bool, int]) -> Turn:
    mirror, quarters = symmetry

    def turn(plane: np.ndarray) -> np.ndarray:
        return np.ascontiguousarray(np.rot90(plane[..., ::-1] if mirror else plane, quarters, axes=(-2, -1)))

    return turn


def _directions(symmetry: tuple[bool, int]) -> list[int]:
    """For each direction on the turned map, the direction on the map as it lies."""
    mirror, quarters = symmetry
    before = [0] * 8
    for d, (row, col) in enumerate(_STEPS):
        step = (row, -col if mirror else col)
        for _ in range(quarters):
            step = (-step[1], step[0])
        before[_STEPS.index(step)] = d
    return before


def _digest(network: SpreadNetwork, stakes: Stakes, symmetry: tuple[bool, int]) -> bytes:
    turn = _turn(symmetry)
    seen = hashlib.blake2b(repr(turn(network.burnable).shape).encode())
    for plane in (network.burnable, stakes.protected, stakes.cost, stakes.value, stakes.ignition):
        seen.update(turn(plane).tobytes())
    if (stakes.difficulty[network.burnable] != 1.0).any():
        seen.update(turn(stakes.difficulty).tobytes())
    for d in _directions(symmetry):
        seen.update(turn(network.probability[d]).tobytes())
        if network.travel_time is not None:
            seen.update(turn(network.travel_time[d]).tobytes())
    return seen.digest()
