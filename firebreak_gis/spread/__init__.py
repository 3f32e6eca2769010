"""Spread models: one file a model, each turning a landscape into spread probabilities.

A model file holds a frozen dataclass `Params` and

    probability(landscape, params) -> (8, rows, cols) float32, from the cell to its neighbour

and needs no registration: its file name is its name. `spread_network` below is the only way in.

A model that knows how fast fire goes returns (probability, travel_time) or (probability, travel_time, heat), or the
`Spread` that they are: then fires can have a clock.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, get_args

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import COL_STEP, ROW_STEP
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.plugins import build_params, describe, load

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.simulation.weather import Step, Weather, WeatherNetworks

#: Neighbours that a cell can light: all eight, or the four that share a side with it.
Neighbourhood = Literal["moore", "von_neumann"]


class Spread(NamedTuple):
    """What a spread model knows.

    Parameters
    ----------
    probability
        (8, rows, cols) in [0, 1], from the cell to its neighbour in direction d.
    travel_time
        (8, rows, cols) seconds along each edge, floats or whole numbers; None if the model has no clock.
    heat
        (rows, cols) heat that a cell releases per area of the map [kJ/m2]; None if not known.
    account
        What is to be known of a network with times, as plain data: `left_out`, what its probabilities leave out because
        the times have it, in words such as "wind"; `wind_speed` [m/s] and `wind_from_direction` [degrees], if they are
        the same everywhere. It becomes the `provenance` of the network.
    """

    probability: np.ndarray
    travel_time: np.ndarray | None = None
    heat: np.ndarray | None = None
    account: Mapping[str, Any] = MappingProxyType({})


def spread_network(
    landscape: xr.Dataset, *, model: str = "alexandridis", neighbourhood: Neighbourhood = "moore", **params: Any
) -> SpreadNetwork:
    """Build the spread network of a landscape.

    Parameters
    ----------
    landscape
        Variables on one square grid in metres, as `read_landscape` returns them. The attribute `boundary`
        ("open" if absent) is taken over.
    model
        Name of a spread model (`firebreak methods` lists them).
    neighbourhood
        `"moore"`: a cell can light its eight neighbours, as in the paper; `"von_neumann"`: only the four that share a
        side with it. A wall of cells that touch at corners alone holds against the second, not against the first.
    **params
        Parameters of the model, for example ``wind_speed=8, wind_from_direction=315``; with ``clock=True``
        `alexandridis` also gives travel times and heat.

    Returns
    -------
    SpreadNetwork
        On the grid of the landscape, with times and heat if the model returns them. Then its `provenance` is the
        `account` of the `Spread`.

    Raises
    ------
    ParameterError
        If the model or a parameter is unknown or out of range.
    InputError
        If a variable that the model needs is missing or out of range.

    Notes
    -----
    Memory at the peak: at most 110 B a cell, the landscape included; the network keeps 33 B a cell.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> landscape = fb.read_landscape(*layers, resolution=200.0)
    >>> network = fb.spread_network(landscape, wind_speed=5.0, wind_from_direction=270.0)
    >>> west_to_east, east_to_west = network.probability[2].mean(), network.probability[6].mean()
    >>> bool(west_to_east > east_to_west)
    True
    """
    if neighbourhood not in get_args(Neighbourhood):
        raise ParameterError(
            f"neighbourhood is {neighbourhood!r}, expected one of {', '.join(get_args(Neighbourhood))}"
        )
    module = load("spread", model)
    values = build_params(module, params)
    if "burnable" not in landscape:
        raise InputError("the landscape has no variable 'burnable'; make it with read_landscape")
    grid = Grid.of(landscape["burnable"])
    result = module.probability(landscape, values)
    spread = Spread(*result) if isinstance(result, tuple) else Spread(result)
    if neighbourhood == "von_neumann":
        straight = (np.array(ROW_STEP) == 0) | (np.array(COL_STEP) == 0)
        spread = spread._replace(probability=np.where(straight[:, None, None], spread.probability, np.float32(0.0)))
    return SpreadNetwork(
        spread.probability,
        burnable=landscape["burnable"].to_numpy(),
        boundary=landscape.attrs.get("boundary", "open"),
        crs=grid.crs,
        transform=grid.transform,
        provenance=dict(spread.account),
        travel_time=spread.travel_time,
        heat=spread.heat,
    )


def weather_networks(
    landscape: xr.Dataset,
    weather: Weather | str,
    *,
    model: str = "alexandridis",
    clock: bool = True,
    keep: int = 4,
    **params: Any,
) -> WeatherNetworks:
    """Networks of a landscape in every weather of an ensemble, made when asked for.

    Parameters
    ----------
    landscape
        As in `spread_network`.
    weather
        From `read_weather`; or what that function reads, a file or a wind rose.
    model
        Name of a spread model that knows wind.
    clock
        Whether the networks have travel times. Weather that changes with time needs them.
    keep
        So many networks are kept at a time, those used last.
    **params
        Other parameters of the model. `moisture` holds where the weather tells none.

    Returns
    -------
    WeatherNetworks
        `networks[i]` is the landscape in `networks.weather.spells[i]`.

    Raises
    ------
    ParameterError
        If the model knows no wind, or the wind is also given as a parameter, or the weather changes without a clock.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> landscape = fb.read_landscape(*layers, resolution=200.0)
    >>> networks = fb.weather_networks(landscape, "rose:NW=5x0.4,N=36km/hx0.2;duration=8h")
    >>> [spell.steps[0].wind_from_direction for spell in networks.weather.spells]
    [315.0, 0.0]
    """
    from firebreak_gis.simulation.weather import WeatherNetworks
    from firebreak_gis.simulation.weather_reading import read_weather

    ensemble = read_weather(weather)
    wet = any(step.moisture is not None for spell in ensemble.spells for step in spell.steps)
    told = ("wind_speed", "wind_from_direction", *(["moisture"] if wet else []))
    known = {p["name"] for p in describe("spread", model)["parameters"]}
    needed = {*told, *(["clock"] if clock else [])}
    if not needed <= known:
        raise ParameterError(
            f"the spread model {model!r} knows no {', '.join(sorted(needed - known))}, so it cannot follow the weather"
        )
    twice = [name for name in told if name in params]
    if twice:
        raise ParameterError(f"{', '.join(twice)} is told by the weather and given besides; give it once")
    if not clock and not ensemble.steady:
        raise ParameterError("weather that changes with time needs fires with a clock; give a duration")
    given = {**params, **({"clock": True} if clock else {})}
    return WeatherNetworks(ensemble, _InWeather(landscape, model, given), keep=keep)


@dataclass(frozen=True, eq=False)
class _InWeather:
    """Makes the network of a landscape in one step of a weather."""

    landscape: xr.Dataset
    model: str
    given: Mapping[str, Any]

    def __call__(self, step: Step) -> SpreadNetwork:
        conditions = {name: value for name, value in step._asdict().items() if value is not None}
        return spread_network(self.landscape, model=self.model, **{**self.given, **conditions})
