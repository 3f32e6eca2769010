"""Fires on a network in memory: by windows where it is large, since fires that have an end see little of it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.ground import Ground, part_of
from firebreak_gis.simulation.windows import breaks_in, burn_windows

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.simulation.weather import Weather
    from firebreak_gis.simulation.window import Window

    Plane = np.ndarray | xr.DataArray

#: On maps of more cells fires that have an end burn by windows: to make the whole map ready takes some 160 B a cell,
#: to make a window ready as long as twenty fires.
WINDOWS_FROM = 16_000_000


@dataclass(frozen=True, eq=False)
class MapInMemory:
    """A network and its breaks in memory, read by windows.

    Parameters
    ----------
    network
        Before cutting, with an open boundary.
    breaks, barriers
        (y, x), above 0 where the fuel is cut, or lines; and on barriers which may fail; or None.
    """

    network: SpreadNetwork
    breaks: Plane | LineBreaks | None = None
    barriers: Plane | None = None

    @property
    def grid(self) -> Grid:
        """Of the whole map."""
        return self.network.grid

    @property
    def burnable(self) -> np.ndarray:
        """(rows, cols) bool."""
        return self.network.burnable

    @property
    def weather(self) -> Weather | None:
        """None: a network is made for one wind."""
        return None

    def read(self, window: Window) -> tuple[Ground, np.ndarray | LineBreaks | None]:
        """What fires burn on in a window, and the breaks there."""
        rows, cols = window.slices
        whole = self.network
        if whole.boundary != "open":
            raise ParameterError("a map that is a torus has no windows; burn it as a whole")
        part = part_of(whole, rows, cols, window.grid(whole.grid))
        barriers = None if self._barred is None else self._barred[rows, cols]
        return Ground(part, None, barriers), breaks_in(window, self._cut, whole.grid)

    @cached_property
    def _barred(self) -> np.ndarray | None:
        return None if self.barriers is None else self.network.mask(self.barriers, "barriers")

    @cached_property
    def _cut(self) -> np.ndarray | LineBreaks | None:
        return self.breaks if isinstance(self.breaks, LineBreaks | None) else self.network.mask(self.breaks, "breaks")


def by_windows(ground: Ground, request: FireRequest) -> bool:
    """Whether fires on a network in memory are better burnt by windows: on a large one, fires that have an end."""
    network = ground.network
    return (
        network.burnable.size > WINDOWS_FROM
        and network.timed
        and network.boundary == "open"
        and ground.weather is None
        and stays_near(request)
    )


def stays_near(request: FireRequest) -> bool:
    """Whether fires have an end, and nothing far from them must be known: they can burn by windows."""
    return (
        request.duration is not None
        and not request.duration.endless
        and request.holding.share is not None
        and request.called is None
    )


def burn_on(
    ground: Ground,
    request: FireRequest,
    *,
    breaks: np.ndarray | xr.DataArray | LineBreaks | None = None,
    value: np.ndarray | xr.DataArray | None = None,
    first_run: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Burn as `fires.burn` does, by windows where that is better."""
    if by_windows(ground, request):
        source = MapInMemory(ground.network, breaks, ground.barriers)
        return burn_windows(source, request, value=value, first_run=first_run, threads=threads, progress=progress)
    return burn(
        ground.network,
        request,
        breaks=breaks,
        value=value,
        weather=ground.weather,
        barriers=ground.barriers,
        first_run=first_run,
        threads=threads,
        progress=progress,
    )
