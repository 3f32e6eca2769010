"""Maps in files on which fires burn by windows, so that the map need not fit into memory."""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.folder import LandscapeFolder
from firebreak_gis.planning.scene import require_no_more, timed_for
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.windows import breaks_in
from firebreak_gis.spread.raster import NetworkFile

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.simulation.weather import Weather
    from firebreak_gis.simulation.window import Window

#: Rows of a map that are looked at together for where fuel is.
_ROWS = 256


class MapInFiles:
    """A network file, or the folder of a landscape, as `windows.burn_windows` takes it.

    Parameters
    ----------
    source
        A network file, or a folder that `align` wrote.
    spread, weather
        Spread model, wind and ensemble, for a folder.
    clock
        Whether fires need travel times.

    Attributes
    ----------
    breaks, barriers
        (rows, cols) bool where the fuel is cut, or lines, and of barriers which may fail; to be set.

    Raises
    ------
    ParameterError
        As `scene.read_scene`.
    """

    def __init__(self, source: str, spread: SpreadRequest, weather: WeatherRequest, *, clock: bool) -> None:
        self.breaks: np.ndarray | LineBreaks | None = None
        self.barriers: np.ndarray | None = None
        self.weather: Weather | None = weather.read()
        self._fuel: Callable[[tuple[int, int, int, int]], np.ndarray]
        self._ground: Callable[[tuple[int, int, int, int]], Ground]
        if Path(source).is_dir():
            if plugins.halo_of(spread.model) is None:
                raise ParameterError(f"the spread model {spread.model} must see the whole map; leave --window out")
            self._folder = LandscapeFolder(source)
            self._spread = timed_for(spread, self.weather, clock=clock)
            self.grid: Grid = self._folder.grid
            self._fuel = lambda part: np.asarray(self._folder.read(part)["burnable"])
            self._ground = self._of_landscape
        else:
            require_no_more(source, spread, self.weather)
            file = NetworkFile(source)
            self.grid = file.grid
            self._fuel = file.fuel
            self._ground = lambda part: Ground(file.read(part))

    @cached_property
    def burnable(self) -> np.ndarray:
        """(rows, cols) bool: where there is fuel."""
        rows, cols = self.grid.shape
        out = np.empty(self.grid.shape, bool)
        for row in range(0, rows, _ROWS):
            out[row : row + _ROWS] = self._fuel((row, 0, min(_ROWS, rows - row), cols))
        return out

    def read(self, window: Window) -> tuple[Ground, np.ndarray | LineBreaks | None]:
        """What fires burn on in a window, and the breaks there."""
        made = self._ground((window.top, window.left, *window.shape))
        barriers = None if self.barriers is None else self.barriers[window.slices]
        return Ground(made.network, made.weather, barriers), breaks_in(window, self.breaks, self.grid)

    def _of_landscape(self, part: tuple[int, int, int, int]) -> Ground:
        from firebreak_gis.spread import spread_network

        landscape = self._folder.read(part)
        if self.weather is not None:
            networks = self._spread.networks(landscape, self.weather)
            return Ground(networks[0].network, networks)
        return Ground(spread_network(landscape, model=self._spread.model, **self._spread.params(landscape)))
