"""Crews that come from stations: a break holds only against fire that comes after them.

Crews set out when the fire starts and a get-away delay is over, and take the fastest way over the cells of the map to
their eight neighbours: at one speed on roads, at another off them. They reach a stretch of break, see `holding`, when
they reach the first cell of its block of the map. Fire that comes to a treated cell before that goes through as if the
cell had not been cut; of what comes later, stretches hold as `hold` says. All stations send enough crews for all
stretches at once, crews cross any ground, and fire does not stop them: so what they save is an upper bound.

Speeds and delay have no universal source. The defaults are assumptions: 40 km/h of a loaded engine on forest roads,
3 km/h of people with tools on foot, and 10 min from the start of the fire until they leave.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH
from firebreak_gis.simulation.holding import stretches
from firebreak_gis.vectors import is_vector, read_starts

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid


@dataclass(frozen=True)
class Travel:
    """How crews travel.

    Parameters
    ----------
    road, off
        Speed on roads and off them [km/h]; assumptions.
    delay
        From the start of the fire until they leave [min]; an assumption.

    Examples
    --------
    >>> as_travel("off=2,delay=20")
    Travel(road=40.0, off=2.0, delay=20.0)
    """

    road: float = 40.0
    off: float = 3.0
    delay: float = 10.0

    def __post_init__(self) -> None:
        for name in ("road", "off"):
            if not 0 < getattr(self, name) < np.inf:
                raise ParameterError(f"{name} of the crews is {getattr(self, name):g} km/h, expected more than 0")
        if not 0 <= self.delay < np.inf:
            raise ParameterError(f"delay of the crews is {self.delay:g} min, expected at least 0")


def as_travel(given: Any, what: str = "crew travel") -> Travel:
    """Read how crews travel: None for the defaults, "road=40,off=3,delay=10", or `Travel`.

    Raises
    ------
    ParameterError
        If it is none of these.
    """
    if given is None or isinstance(given, Travel):
        return given or Travel()
    names = [each.name for each in fields(Travel)]
    told: dict[str, float] = {}
    for word in str(given).split(","):
        name, equals, number = (part.strip() for part in word.partition("="))
        try:
            told[name] = float(number)
        except ValueError:
            equals = ""
        if not equals or name not in names:
            raise ParameterError(
                f"{what} has {word.strip()!r}, expected {', '.join(names)} with a number: off=2,delay=20"
            )
    return Travel(**told)


@dataclass(frozen=True, eq=False)
class Stations:
    """Where crews come from, and how.

    Parameters
    ----------
    places
        Points, polygons (of which a point inside counts) or a raster above 0; those off the map are left out.
    roads
        Lines or a raster, or None.
    travel
        Speeds and delay.
    """

    places: Any
    roads: Any = None
    travel: Travel = field(default_factory=Travel)
    _found: list[tuple[Grid, float, np.ndarray]] = field(default_factory=list, repr=False)

    def arrival(self, grid: Grid, length: float) -> np.ndarray:
        """When crews are at the stretch of each cell [s after the start of the fire], (rows, cols) uint64.

        Parameters
        ----------
        grid
            In metres.
        length
            Of stretches [m], see `holding.Hold`.

        Raises
        ------
        InputError
            If no station lies on the map.
        """
        for known, side, seconds in self._found:  # the same for all budgets and weathers
            if known.matches(grid) and side == length:
                return seconds
        from firebreak_gis.landscape.masks import mask_plane

        grid.require_metres("crews that travel")
        start = _cells_of(self.places, grid)
        if not start.any():
            raise InputError("no station lies on the map; give --stations on it, such as where a road comes in")
        roads = (
            np.zeros(grid.shape, bool)
            if self.roads is None
            else mask_plane(self.roads, grid, what="roads", rule="touched")
        )
        hours = travel_hours(start, roads, self.travel, grid.cell_size)
        block = stretches(grid.shape, grid.cell_size, length)
        first = np.full(int(block.max()) + 1, np.inf)
        np.minimum.at(first, block.ravel(), hours.ravel())
        seconds = np.asarray(np.ceil(60.0 * self.travel.delay + 3600.0 * first)[block], np.uint64)
        self._found.append((grid, length, seconds))
        return seconds

    def settled(self, grid: Grid, length: float) -> Stations:
        """The same on one grid and stretches of one length, without what it was read from."""
        return Stations(None, None, self.travel, [(grid, length, self.arrival(grid, length))])

    def told(self) -> str:
        """What is assumed, in words, for accounts and pictures."""
        way = f"{self.travel.off:g} km/h off roads"
        if self.roads is not None:
            way = f"{self.travel.road:g} km/h on roads and {way}"
        leave = f"crews leave after {self.travel.delay:g} min at {way} (assumed)"
        return f"{leave}; no break holds against fire that comes first"


def _cells_of(places: Any, grid: Grid) -> np.ndarray:
    """Cells with a station, (rows, cols) bool; points off the map are left out."""
    import shapely

    from firebreak_gis.landscape.footprints import in_cells
    from firebreak_gis.landscape.masks import mask_plane

    if not is_vector(places):
        return mask_plane(places, grid, what="stations", rule="touched")
    at = shapely.get_coordinates(shapely.point_on_surface(in_cells(read_starts(places, grid.crs), grid)))
    col, row = np.floor(at).astype(np.int64).T
    here = (row >= 0) & (row < grid.shape[0]) & (col >= 0) & (col < grid.shape[1])
    start = np.zeros(grid.shape, bool)
    start[row[here], col[here]] = True
    return start


def travel_hours(start: np.ndarray, roads: np.ndarray, travel: Travel, cell_size: float) -> np.ndarray:
    """Fastest way from any start to each cell [h], (rows, cols) float64; half of each step at the speed of either cell.

    Parameters
    ----------
    start, roads
        (rows, cols) bool.
    travel
        The speeds.
    cell_size
        [m]

    Examples
    --------
    >>> start = np.array([[True, False, False]])
    >>> travel_hours(start, np.zeros((1, 3), bool), Travel(off=2.0), 1000.0)
    array([[0. , 0.5, 1. ]])
    """
    import scipy.sparse
    from scipy.sparse.csgraph import dijkstra

    rows, cols = start.shape
    slowness = cell_size / 1000.0 / np.where(roads, travel.road, travel.off)
    number = np.arange(start.size, dtype=np.int32).reshape(start.shape)
    ends, lengths = [], []
    for d in range(2, 6):  # E SE S SW; the others are these, the other way round
        down, right = ROW_STEP[d], COL_STEP[d]
        here = (slice(0, rows - down), slice(max(-right, 0), cols - max(right, 0)))
        there = (slice(down, rows), slice(max(right, 0), cols + min(right, 0)))
        ends.append(np.array([number[here].ravel(), number[there].ravel()]))
        lengths.append((STEP_LENGTH[d] * 0.5 * (slowness[here] + slowness[there])).ravel())
    graph = scipy.sparse.csr_array(
        (np.concatenate(lengths), tuple(np.concatenate(ends, axis=1))), shape=(start.size, start.size)
    )
    hours = dijkstra(graph, directed=False, indices=np.flatnonzero(start), min_only=True)
    return np.asarray(hours).reshape(start.shape)
