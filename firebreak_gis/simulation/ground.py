"""What fires burn on, where that is more than the network that breaks are designed on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.lattice import NEVER, close_boundary
from firebreak_gis.network import SpreadNetwork

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid
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


def network_of_planes(
    probability: np.ndarray,
    burnable: np.ndarray,
    grid: Grid,
    *,
    provenance: dict[str, Any] | None = None,
    travel_time: np.ndarray | None = None,
    heat: np.ndarray | None = None,
) -> SpreadNetwork:
    """An open network of planes that were taken from networks, block by block: not looked at again, and not copied.

    Parameters
    ----------
    probability, burnable, grid, provenance, travel_time, heat
        As `SpreadNetwork` keeps them; the planes become read-only.
    """
    network = object.__new__(SpreadNetwork)
    planes = {"probability": probability, "burnable": burnable, "travel_time": travel_time, "heat": heat}
    for plane in planes.values():
        if plane is not None:
            plane.flags.writeable = False
    for name, value in {**planes, "boundary": "open", "grid": grid, "provenance": provenance or {}}.items():
        object.__setattr__(network, name, value)
    return network


def part_of(network: SpreadNetwork, rows: slice, cols: slice, grid: Grid) -> SpreadNetwork:
    """A rectangle of an open network, on its own grid: edges that leave it are closed."""
    probability, times = np.array(network.probability[:, rows, cols]), network.travel_time
    close_boundary(probability)
    if times is not None:
        times = np.array(times[:, rows, cols])
        close_boundary(times, NEVER)
    heat = None if network.heat is None else np.array(network.heat[rows, cols])
    burnable = np.array(network.burnable[rows, cols])
    about: dict[str, Any] = {"provenance": network.provenance, "travel_time": times, "heat": heat}
    return network_of_planes(probability, burnable, grid, **about)
