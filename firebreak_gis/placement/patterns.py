"""Regular patterns of breaks: bands across a direction, grids of compartments, staggered patches."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.breaks import Budget
from firebreak_gis.kernels.keys import distinct
from firebreak_gis.kernels.patches import patch_links, pieces_after
from firebreak_gis.lattice import AZIMUTH, COL_STEP, ROW_STEP
from firebreak_gis.placement.bending import bent, is_even, prices
from firebreak_gis.placement.dissection import along, lines_first
from firebreak_gis.placement.edges import links

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: How often a pattern of lines moved to better ground is laid wider until its cost is paid.
_TRIES = 12
#: Shifts of a pattern that are tried, as shares of its spacing.
_SHIFTS = (0.0, 0.25, 0.5, 0.75)


class ExpectedLoss:
    """Expected loss of a plan, as if a fire burnt all of the compartment that it starts in.

    Parameters
    ----------
    network, stakes
        What is planned for.
    """

    def __init__(self, network: SpreadNetwork, stakes: Stakes) -> None:
        self._fuel = np.flatnonzero(network.burnable.ravel())
        self._near = patch_links(
            self._fuel, links(network).ravel(), *network.shape, np.array(ROW_STEP), np.array(COL_STEP)
        )
        self._ignition = stakes.ignition.ravel()[self._fuel]
        self._value = stakes.value.ravel()[self._fuel]

    def __call__(self, cut: np.ndarray) -> float:
        """Share of all value that a fire takes in the mean; `cut` is (rows, cols) bool."""
        label = pieces_after(self._near, cut.ravel()[self._fuel].astype(np.uint8)) + 1
        ignition = np.bincount(label, weights=self._ignition)[1:]
        value = np.bincount(label, weights=self._value)[1:]
        return float(ignition @ value / max(self._ignition.sum() * self._value.sum(), 1e-300))


def heading_coordinate(shape: tuple[int, int], azimuth: float) -> np.ndarray:
    """Distance of every cell along a heading, in cells, (rows, cols); azimuth in degrees clockwise from north."""
    east, north = math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth))
    row, col = np.indices(shape)
    return np.round(col * east - row * north, 9)


def thickness(azimuth: float, width: int) -> float:
    """Thickness along the heading, in cells, of a band that every way across meets at least `width` times."""
    return width * (abs(math.sin(math.radians(azimuth))) + abs(math.cos(math.radians(azimuth))))


def prevailing(network: SpreadNetwork) -> float:
    """Azimuth into which fire spreads most, degrees clockwise from north; 0 if none is preferred by 1 %."""
    strength = network.probability.sum(axis=(1, 2), dtype=np.float64)
    angle = np.radians(AZIMUTH)
    east, north = float(strength @ np.sin(angle)), float(strength @ np.cos(angle))
    if math.hypot(east, north) <= 0.01 * strength.sum():
        return 0.0
    return math.degrees(math.atan2(east, north)) % 360.0


def middle_first(n: int) -> list[int]:
    """0 .. n - 1, the middle first, then the middles of the halves, and so on."""
    order, spans = [], [(0, n)]
    while spans:
        low, high = spans.pop(0)
        if low < high:
            middle = (low + high) // 2
            order.append(middle)
            spans += [(low, middle), (middle + 1, high)]
    return order


def bands(
    shape: tuple[int, int], azimuth: float, *, width: int, spacing: float, shift: float
) -> tuple[np.ndarray, np.ndarray]:
    """Parallel bands across a heading.

    Parameters
    ----------
    azimuth
        Heading that the bands lie across, degrees clockwise from north.
    width
        Cells across a band, see `thickness`.
    spacing
        From band to band along the heading, cells.
    shift
        Share of the spacing by which the bands are moved along the heading.

    Returns
    -------
    tuple
        (rows, cols) bool: in a band; and int64: the number of the band, rising along the heading from 0.
    """
    place = heading_coordinate(shape, azimuth)
    place = place - place.min() + shift * spacing
    number = np.floor(place / spacing).astype(np.int64)
    return place - number * spacing < thickness(azimuth, width) - 1e-9, number


def stripes(shape: tuple[int, int], azimuth: float, *, width: int, spacing: float, shift: float) -> list[np.ndarray]:
    """Cells of the bands across one heading, middle band first, each along itself."""
    inside, number = bands(shape, azimuth, width=width, spacing=spacing, shift=shift)
    cells = np.flatnonzero(inside.ravel())
    band = number.ravel()[cells]
    order = np.argsort(band, kind="stable")
    groups = np.split(cells[order], np.cumsum(np.bincount(band, minlength=int(number.max()) + 1))[:-1])
    return [along(groups[k], shape) for k in middle_first(len(groups))]


def square_grid(
    shape: tuple[int, int], azimuth: float, *, width: int, spacing: float, shift: float
) -> list[np.ndarray]:
    """Cells of bands across a heading and along it, the two in turn."""
    one = stripes(shape, azimuth, width=width, spacing=spacing, shift=shift)
    two = stripes(shape, azimuth + 90.0, width=width, spacing=spacing, shift=shift)
    longest = max(len(one), len(two))
    return [lines[i] for i in range(longest) for lines in (one, two) if i < len(lines)]


def best_pattern(
    network: SpreadNetwork,
    stakes: Stakes,
    draw: Callable[..., list[np.ndarray]],
    *,
    azimuths: Sequence[float],
    width: int,
    spacing: float | None,
    families: int,
    cost_share: float,
    progress: Progress,
) -> np.ndarray:
    """Priority of the pattern that loses least over azimuths and shifts, its lines moved to the better ground beside.

    Parameters
    ----------
    draw
        `stripes` or `square_grid`.
    azimuths
        Headings tried, degrees clockwise from north.
    spacing
        Cells; None: the densest that the budget affords.
    families
        1 for stripes, 2 for a grid: how many sets of bands share the budget.
    cost_share
        Share of the cost of all fuel that the pattern may take.

    Returns
    -------
    numpy.ndarray
        (rows, cols) float64; cells off the pattern come last, the nearest to it first.
    """
    expected = ExpectedLoss(network, stakes)
    money = Budget.of_cost_share(cost_share, stakes)
    best: tuple[float, list[np.ndarray], float, float, float] = (np.inf, [], 0.0, 0.0, 1.0)
    tries = [(azimuth, shift) for azimuth in azimuths for shift in _SHIFTS]
    for i, (azimuth, shift) in enumerate(tries):
        progress(i / len(tries), "trying patterns")
        start = spacing or max(families * thickness(azimuth, width) / max(cost_share, 1e-6), 1.0)
        for wider in range(1 if spacing else 30):
            lines = draw(network.shape, azimuth, width=width, spacing=start * 1.01**wider, shift=shift)
            cut = np.zeros(network.shape, bool)
            cut.ravel()[np.concatenate(lines)] = True
            cut &= network.burnable & ~stakes.protected
            if money.pays(stakes.cost[cut].sum()):
                break
        lost = expected(cut)
        if lost < best[0]:
            best = (lost, lines, azimuth, shift, start * 1.01**wider)
    lines = best[1]
    if not is_even(stakes):
        lines = _bent_pattern(
            network, stakes, draw, lines, *best[2:], width=width, money=None if spacing else money, progress=progress
        )
    progress(1.0, "pattern chosen")
    return pattern_first(network, stakes, lines)


def _bent_pattern(
    network: SpreadNetwork,
    stakes: Stakes,
    draw: Callable[..., list[np.ndarray]],
    lines: list[np.ndarray],
    azimuth: float,
    shift: float,
    spacing: float,
    *,
    width: int,
    money: Budget | None,
    progress: Progress,
) -> list[np.ndarray]:
    """The lines of a pattern moved to better ground, within half the spacing in all.

    They grow longer by that, so the pattern is laid wider until `money` pays; None: it is laid as asked.
    """
    price = prices(network, stakes, width)
    free = (network.burnable & ~stakes.protected).ravel()
    moved: list[np.ndarray] = []
    for i in range(_TRIES):
        progress(i / _TRIES, "moving lines to better ground")
        moved = [bent(line, network, price, width=width, reach=spacing / 4.0) for line in lines]
        cut = distinct(np.concatenate(moved))
        cost = float(stakes.cost.ravel()[cut[free[cut]]].sum())
        if money is None or money.pays(cost):
            break
        spacing *= max(cost / max(money.amount, 1e-300), 1.01)
        lines = draw(network.shape, azimuth, width=width, spacing=spacing, shift=shift)
    return moved


def pattern_first(network: SpreadNetwork, stakes: Stakes, lines: Sequence[np.ndarray]) -> np.ndarray:
    """Priority that cuts a pattern line by line, then the cells nearest to it."""
    from scipy import ndimage

    free = (network.burnable & ~stakes.protected).ravel()
    kept = [line[free[line]] for line in lines]
    drawn = np.zeros(network.shape, bool)
    if kept:
        drawn.ravel()[np.concatenate(kept)] = True
    distance = ndimage.distance_transform_edt(~drawn) if drawn.any() else np.zeros(network.shape)
    return lines_first(kept, stakes, -np.round(distance, 6))


def staggered_patches(
    shape: tuple[int, int], azimuth: float, *, width: float, length: float, gap: float, overlap: float
) -> np.ndarray:
    """Number of the patch of every cell, -1 outside, (rows, cols) int64.

    Rows of rectangles lie across the heading; every other row is moved so that each patch overlaps two of the
    next row.

    Parameters
    ----------
    azimuth
        Heading of the fire, degrees clockwise from north.
    width, length
        Of a patch along and across the heading, cells.
    gap
        Between rows along the heading, cells.
    overlap
        Of patches of neighbouring rows across the heading, cells.
    """
    ahead = heading_coordinate(shape, azimuth)
    across = heading_coordinate(shape, azimuth + 90.0)
    ahead, across = ahead - ahead.min(), across - across.min()
    row = np.floor(ahead / (width + gap)).astype(np.int64)
    period = 2.0 * (length - overlap)
    moved = across + np.where(row % 2 == 1, length - overlap, 0.0)
    place = np.floor(moved / period).astype(np.int64)
    inside = (ahead - row * (width + gap) < width - 1e-9) & (moved - place * period < length - 1e-9)
    return np.where(inside, row * (int(place.max()) + 1) + place, -1)
