"""How breaks hold: they leak, they fail by stretches, or they are too narrow for the flames.

`residual` says that every treated cell keeps a share of its spread probability, fire by fire and cell by cell. `hold`
says that a stretch of a break holds in a run or is as if it had not been cut. Both may be asked: what holds may leak.

A stretch of cells is the part of a break inside one block of the map, `length` metres wide and high; breaks in the same
block hold or fail together. A stretch of a line is about `length` metres along it. Neither depends on what else is
cut, or on lines that come later. A cell of a larger plan therefore holds in the very runs in which it holds in a
smaller one, and cutting more never lets any cell burn earlier.

Half of the fires that meet a break pass it: 46.9 % of 563 encounters held in Ortega et al. 2024, 46 % in Syphard et al.
2011 (doi 10.1071/WF10089).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.lattice import NEVER, STEP_LENGTH
from firebreak_gis.network import neighbour

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.walls import Cleared, Walls
    from firebreak_gis.network import Residual, SpreadNetwork
    from firebreak_gis.simulation.window import Window

#: Share of encounters that hold in the field, see the text of the module.
FIELD = 0.47


@dataclass(frozen=True)
class Hold:
    """How often a stretch of a break holds in a run.

    Parameters
    ----------
    share
        Probability that a stretch holds; None: by width and flames, see `rule`.
    length
        Of a stretch along a line, and of the sides of the blocks that cut breaks of cells into stretches [m]; an
        assumption, one to two hours of work of a crew.
    rule
        `wilson`: a break of width W [m] before a fire of intensity I [kW/m] is breached with probability z / (1 + z),
        z = exp(1.36 + 0.00036 I - b W), b = 0.99 without trees near and 0.38 with (Wilson 1988, doi 10.1139/x88-104;
        113 grass fires, breaks up to 15 m, I up to 17,000: optimistic for forest). `flames`: it holds if it is at least
        `flames` flame lengths wide. Embers fly over it in either case.
    flames
        Flame lengths that a break must be wide, a rule of practice.
    trees_heat
        Fuel that releases at least this [kJ/m2] counts as trees in the rule of Wilson: all that is heavier than grass.

    Examples
    --------
    >>> as_hold("0.47").share, as_hold("flame").rule
    (0.47, 'wilson')
    """

    share: float | None = 1.0
    length: float = 400.0
    rule: Literal["wilson", "flames"] = "wilson"
    flames: float = 1.5
    trees_heat: float = 15_000.0

    def __post_init__(self) -> None:
        if self.share is not None and not 0.0 <= self.share <= 1.0:
            raise ParameterError(f"hold is {self.share:g}, expected a share from 0 to 1, or flame")
        if not self.length > 0:
            raise ParameterError(f"the length of a stretch is {self.length:g} m, expected more than 0")
        if self.rule not in ("wilson", "flames"):
            raise ParameterError(f"the rule of holding is {self.rule!r}, expected wilson or flames")
        if not self.flames > 0:
            raise ParameterError(f"a break of {self.flames:g} flame lengths was asked, expected more than 0")

    @property
    def perfect(self) -> bool:
        """Whether every break holds in every run."""
        return self.share == 1.0

    def told(self) -> str:
        """How breaks hold, in words, for accounts and pictures."""
        if self.share is not None:
            return (
                "breaks hold" if self.perfect else f"each {self.length:g} m of break holds in {self.share:.3g} of fires"
            )
        if self.rule == "wilson":
            return "breaks hold by width and intensity (Wilson 1988)"
        return f"breaks hold where {self.flames:g} flame lengths wide"


def as_hold(given: Any, what: str = "hold") -> Hold:
    """Read how breaks hold: "0.47", "0.47:800" with the length of stretches [m], "flame", "flame:flames", or a `Hold`.

    Raises
    ------
    ParameterError
        If it is none of these.
    """
    if given is None:
        return Hold()
    if isinstance(given, Hold):
        return given
    word = str(given).strip().lower()
    if word in ("flame", "flame:wilson"):
        return Hold(share=None)
    if word == "flame:flames":
        return Hold(share=None, rule="flames")
    share, colon, length = word.partition(":")
    try:
        numbers = float(share), float(length) if colon else Hold.length
    except ValueError:
        raise ParameterError(
            f"{what} is {given!r}, expected a share from 0 to 1, perhaps with the length of a stretch in metres "
            "(0.47:800), flame or flame:flames"
        ) from None
    return Hold(*numbers)


def breach(intensity: np.ndarray | float, width: np.ndarray | float, *, trees: np.ndarray | bool) -> np.ndarray:
    """Probability that fire breaches a break (Wilson 1988, doi 10.1139/x88-104).

    Parameters
    ----------
    intensity
        Fire-line intensity [kW/m].
    width
        Of the break [m].
    trees
        Whether trees stand within 20 m of it.

    Examples
    --------
    >>> breach(10_000, np.array([5, 10, 20]), trees=True).round(2)
    array([0.96, 0.76, 0.07])
    """
    exponent = 1.36 + 0.00036 * np.asarray(intensity) - np.where(trees, 0.38, 0.99) * width
    return np.asarray(1.0 / (1.0 + np.exp(-exponent)))


def width_needed(intensity: np.ndarray | float, *, trees: np.ndarray | bool, breached: float = 0.05) -> np.ndarray:
    """Width at which a share `breached` of the fires breach a break [m], by the rule of Wilson.

    Examples
    --------
    >>> float(width_needed(10_000, trees=False).round(1)), float(width_needed(10_000, trees=True).round(1))
    (8.0, 20.8)
    """
    needed = (1.36 + 0.00036 * np.asarray(intensity) - np.log(breached / (1 - breached))) / np.where(trees, 0.38, 0.99)
    return np.asarray(np.maximum(needed, 0.0))


def strongest(network: SpreadNetwork, what: str, times: np.ndarray | None = None) -> np.ndarray:
    """Intensity of the fastest fire that can leave each cell [kW/m], (rows, cols) float32.

    It does not depend on how fire comes to the cell, nor on what is cut elsewhere.

    Parameters
    ----------
    network
        With times and heat.
    what
        What it is needed for, in messages.
    times
        (8, rows, cols) uint32 [s] in place of those of the network.
    """
    seconds = network.require_times(what) if times is None else times
    heat = network.require_heat(what)
    network.grid.require_metres(what)
    rate = np.zeros(network.shape, np.float32)
    for d in range(8):
        length = np.float32(network.grid.cell_size * STEP_LENGTH[d])
        np.maximum(rate, np.divide(length, seconds[d], where=seconds[d] != NEVER, out=np.zeros_like(rate)), out=rate)
    rate *= heat
    return rate


def widths(cut: np.ndarray, cell_size: float) -> np.ndarray:
    """Width of the break at each cut cell [m], 0 elsewhere: the side of the largest square of cut cells that holds it.

    Cutting more never makes it less.
    """
    from scipy import ndimage

    width = np.zeros(cut.shape)
    square = cut
    side = 1
    while square.any():
        width[square] = side * cell_size
        side += 1
        square = ndimage.binary_opening(cut, np.ones((side, side), bool))
    return width


def stretches(shape: tuple[int, int], cell_size: float, length: float, window: Window | None = None) -> np.ndarray:
    """Number of the block of the map in which each cell lies, (rows, cols) uint32; the map may go on round a window."""
    side = max(round(length / cell_size), 1)
    first, map_cols = ((0, 0), shape[1]) if window is None else ((window.top, window.left), window.map_shape[1])
    row, col = (
        np.arange(low, low + n, dtype=np.uint32) // np.uint32(side) for low, n in zip(first, shape, strict=True)
    )
    return np.asarray(row[:, np.newaxis] * np.uint32(-(-map_cols // side)) + col, np.uint32)


def chances(network: SpreadNetwork, cut: np.ndarray, hold: Hold, intensity: np.ndarray | None = None) -> np.ndarray:
    """Probability that each cut cell holds in a run, (rows, cols) float64; 0 elsewhere.

    Parameters
    ----------
    network
        The network before cutting.
    cut
        (rows, cols) bool.
    hold
        How breaks hold.
    intensity
        (rows, cols) [kW/m]; needed where it goes by flames. Of the fire before the break: the mean over the fuel of the
        block, also of that which is cut.
    """
    width = cut if hold.share is not None else widths(cut, network.grid.cell_size)
    return chances_by_width(network, width, hold, intensity)


def chances_by_width(
    network: SpreadNetwork,
    width: np.ndarray,
    hold: Hold,
    intensity: np.ndarray | None = None,
    cells: np.ndarray | None = None,
) -> np.ndarray:
    """Probability that a break of some width [m] holds in a run, 0 where it is 0; all else as in `chances`.

    Widths are those of all cells, (rows, cols), or of the given `cells` by their row-major numbers, (n,).
    """
    if hold.share is not None:
        return np.where(width > 0, hold.share, 0.0)
    mean, trees = fire_before(network, hold, intensity)
    if cells is not None:
        mean, trees = mean.ravel()[cells], trees.ravel()[cells]
    if hold.rule == "flames":
        return np.where((width > 0) & (width >= hold.flames * flame_length(mean)), 1.0, 0.0)
    return np.where(width > 0, 1.0 - breach(mean, width, trees=trees), 0.0)


def fire_before(
    network: SpreadNetwork, hold: Hold, intensity: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """The fire that a break in each cell must stop, from the fuel of the block of the map, whatever is cut.

    Returns
    -------
    intensity : numpy.ndarray
        (rows, cols) float64, mean over the fuel of the fastest fire that can leave each cell [kW/m].
    trees : numpy.ndarray
        (rows, cols) bool, whether a tenth of the fuel counts as trees.
    """
    what = "hold by flames"
    if intensity is None:
        intensity = strongest(network, what)
    block = stretches(network.shape, network.grid.cell_size, hold.length)
    fuel = network.burnable
    n = np.maximum(np.bincount(block[fuel], minlength=int(block.max()) + 1), 1)
    heavy = network.require_heat(what) >= hold.trees_heat
    mean, share = (np.bincount(block[fuel], weights=plane[fuel], minlength=n.size) / n for plane in (intensity, heavy))
    return mean[block], (share >= 0.1)[block]


def flame_length(intensity: np.ndarray) -> np.ndarray:
    """Flame length [m] of a fire line [kW/m], Byram 1959."""
    return np.asarray(0.0775 * np.asarray(intensity) ** 0.46)


def build_walls(
    network: SpreadNetwork,
    keys: np.ndarray,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    residual: Residual,
    hold: Hold,
    barriers: np.ndarray | xr.DataArray | None = None,
    barriers_hold: float = 1.0,
    intensity: np.ndarray | None = None,
    window: Window | None = None,
    crews: np.ndarray | None = None,
) -> Walls:
    """What the kernel is given of the breaks.

    Parameters
    ----------
    network
        The network before cutting.
    keys
        (n_runs,) uint64 keys of the runs for the purpose `hold`.
    breaks
        (y, x), above 0 where the fuel is cut; or lines, perhaps with cells; or None.
    residual
        Share of its spread probability that a treated cell keeps where it holds, one number or (y, x).
    hold
        How the breaks hold.
    barriers
        (y, x), above 0 on cells of roads, rivers and the like that the network holds as fuel: what burns there when
        the barrier fails.
    barriers_hold
        Probability that a stretch of a barrier holds in a run; drawn apart from that of the breaks.
    intensity
        As in `chances`.
    window
        Of which map the network is a window.
    crews
        (rows, cols) uint64, when crews are at each cell [s]; nothing cut holds against fire that comes before, barriers
        do. None: there is no need of them.
    """
    from firebreak_gis.kernels.walls import Walls

    n_cells = network.burnable.size
    probability = network.probability.reshape(8, n_cells)
    kept = network.kept_share(residual).ravel()
    none, no_links = np.zeros(0, np.uint32), np.zeros(0, np.uint8)
    awaited = np.zeros(0, np.uint64) if crews is None else crews.ravel()
    if breaks is None and barriers is None:
        bare = (np.zeros(0, bool), none, none, keys, kept, probability)
        return Walls(*bare, no_links, none, none, awaited)
    near = np.zeros(network.shape, bool)
    chance = np.zeros(network.shape)
    crossed, line_holds, line_stretch = no_links, none, none
    cells: np.ndarray | xr.DataArray | None
    if isinstance(breaks, LineBreaks):
        network.grid.require(breaks.grid, "the lines")
        crossed = breaks.crossed.ravel()
        line_holds = _digits(chances_by_width(network, breaks.width, hold, intensity))
        line_stretch = breaks.stretches(hold.length).ravel()
        near |= breaks.crossed > 0
        cells = breaks.cells
    else:
        cells = breaks
    if cells is not None:
        chance = chances(network, network.mask(cells, "breaks"), hold, intensity)
    stretch = 2 * stretches(network.shape, network.grid.cell_size, hold.length, window)
    if barriers is not None:
        barrier = network.mask(barriers, "barriers") & (chance < barriers_hold)
        chance = np.where(barrier, barriers_hold, chance)
        stretch += barrier.astype(np.uint32)
        awaited = awaited if crews is None else np.where(barrier.ravel(), np.uint64(0), awaited)
    holds = _digits(chance)
    for d in range(8):
        near |= neighbour(holds.reshape(network.shape) > 0, d, network.boundary)
    on_cells = (near.ravel(), holds, stretch.ravel(), keys, kept, probability)
    return Walls(*on_cells, crossed, line_holds, line_stretch, awaited)


def cleared_ground(
    network: SpreadNetwork,
    keys: np.ndarray,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None,
    hold: Hold,
    intensity: np.ndarray | None = None,
) -> Cleared:
    """Ground that lines clear, for the kernel; parameters as in `build_walls`, keys of the purpose `ground`."""
    from firebreak_gis.kernels.walls import Cleared

    if not isinstance(breaks, LineBreaks):
        return Cleared(np.zeros((0, 4), np.uint32), np.zeros(0, np.uint32), keys)
    part = breaks.cleared
    often = chances_by_width(network, part.width, hold, intensity, part.cell)
    ground = np.column_stack([part.cell, part.part, _digits(often), part.stretches(hold.length)]).astype(np.uint32)
    first = np.full(network.burnable.size, len(ground), np.uint32)
    first[part.cell[::-1]] = np.arange(len(ground))[::-1]  # of those in a cell, the first is set last
    return Cleared(ground, first, keys)


def _digits(chance: np.ndarray) -> np.ndarray:
    """Chances as `draws.digits_of` tells them, (n_cells,) uint32."""
    from firebreak_gis.kernels.draws import each_digits

    out = np.empty(chance.size, np.uint32)
    each_digits(chance.ravel(), out)
    return out
