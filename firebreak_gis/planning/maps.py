"""Maps in files on which fires burn by windows, so that the map need not fit into memory."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.files import sha256
from firebreak_gis.landscape.folder import LandscapeFolder
from firebreak_gis.planning.scene import files_of, require_no_more, timed_for
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.windows import breaks_in
from firebreak_gis.spread.raster import NetworkFile

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.simulation.weather import Weather
    from firebreak_gis.simulation.window import Window

    Rectangle = tuple[int, int, int, int]

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
        self._source, self._spread = source, spread
        self._map: LandscapeFolder | NetworkFile
        if Path(source).is_dir():
            if plugins.halo_of(spread.model) is None:
                raise ParameterError(f"the spread model {spread.model} must see the whole map; leave --window out")
            self._map = LandscapeFolder(source)
            self._spread = timed_for(spread, self.weather, clock=clock)
        else:
            require_no_more(source, spread, self.weather)
            self._map = NetworkFile(source)
        self.grid: Grid = self._map.grid

    def __reduce__(self) -> Any:
        """As the names of its files: whoever gets it opens them for himself."""
        names = {name: _absolute(getattr(self._spread, name)) for name in ("wind_speed", "wind_from", "moisture")}
        uv = self._spread.wind_uv
        spread = replace(self._spread, **names, wind_uv=uv and (_absolute(uv[0]), _absolute(uv[1])))
        return _again, (str(Path(self._source).absolute()), spread, self.weather, self.breaks, self.barriers)

    def content(self) -> list[Any]:
        """What tells it from other maps."""
        files = [sha256(file) for file in (*files_of(self._source), *self._spread.sources)]
        return [files, replace(self._spread), self.weather, self.breaks, self.barriers]

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

    def _fuel(self, part: Rectangle) -> np.ndarray:
        if isinstance(self._map, NetworkFile):
            return self._map.fuel(part)
        return np.asarray(self._map.read(part)["burnable"])

    def _ground(self, part: Rectangle) -> Ground:
        from firebreak_gis.spread import spread_network

        if isinstance(self._map, NetworkFile):
            return Ground(self._map.read(part))
        landscape = self._map.read(part)
        if self.weather is not None:
            networks = self._spread.networks(landscape, self.weather)
            return Ground(networks[0].network, networks)
        return Ground(spread_network(landscape, model=self._spread.model, **self._spread.params(landscape)))


def _absolute(value: Any) -> Any:
    """The name of a raster as any process of this file system finds it; numbers stay."""
    return str(Path(value).absolute()) if isinstance(value, str) else value


def _again(
    source: str,
    spread: SpreadRequest,
    weather: Weather | None,
    breaks: np.ndarray | LineBreaks | None,
    barriers: np.ndarray | None,
) -> MapInFiles:
    if not Path(source).exists():
        raise InputError(f"a worker does not find {source}; maps read by windows must lie where all workers reach them")
    made = MapInFiles(source, spread, WeatherRequest(weather), clock=spread.clock)
    made.breaks, made.barriers = breaks, barriers
    return made
