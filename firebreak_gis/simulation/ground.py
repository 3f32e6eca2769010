"""What fires burn on, where that is more than the network that breaks are designed on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.weather import WeatherNetworks


@dataclass(frozen=True, eq=False)
class Ground:
    """Where fires burn: the last three arguments that `fires.burn` needs beside the fires and the breaks.

    Parameters
    ----------
    network
        Before cutting, with travel times where fires have a clock. It has the grid of the network that breaks are
        designed on, and at least its fuel.
    weather
        Networks of an ensemble of weathers, in place of the one.
    barriers
        (rows, cols), above 0 on barriers which may fail, and which the network therefore holds as fuel.
    """

    network: SpreadNetwork
    weather: WeatherNetworks | None = None
    barriers: np.ndarray | xr.DataArray | None = None
