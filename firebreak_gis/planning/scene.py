"""The networks on which a command burns: from a file, or from a landscape under one wind or an ensemble of weathers."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.folder import read_landscape_folder
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.planning.judging import Scene
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.weather import Weather, WeatherNetworks


def read_scene(
    source: str, spread: SpreadRequest, weather: WeatherRequest, *, clock: bool, account: Account | None = None
) -> tuple[SpreadNetwork, WeatherNetworks | None]:
    """Networks to burn.

    Parameters
    ----------
    source
        A network file, or a folder that `align` wrote.
    spread, weather
        Spread model, wind and ensemble, for a folder.
    clock
        Whether fires need travel times.
    account
        Gets sentences on how rasters of the wind were laid on the grid.

    Returns
    -------
    network : SpreadNetwork
        The network, or that of the first weather.
    networks : WeatherNetworks or None
        Those of all weathers.

    Raises
    ------
    ParameterError
        If a network file is to be given another wind or weather.
    """
    from firebreak_gis.spread import spread_network
    from firebreak_gis.spread.raster import read_network

    ensemble = weather.read()
    if not Path(source).is_dir():
        require_no_more(source, spread, ensemble)
        return read_network(source), None
    timed = timed_for(spread, ensemble, clock=clock)
    landscape = read_landscape_folder(source)
    if ensemble is not None:
        networks = timed.networks(landscape, ensemble)
        return networks[0].network, networks
    return spread_network(landscape, model=timed.model, **timed.params(landscape, account)), None


def files_of(source: str) -> list[str]:
    """The network file, or the rasters in the folder of a landscape."""
    folder = Path(source)
    return sorted(str(file) for file in folder.glob("*.tif")) if folder.is_dir() else [source]


def open_scene(source: str, spread: SpreadRequest, weather: WeatherRequest, *, account: Account | None = None) -> Scene:
    """What plans are designed on, and their fires burn on; parameters and errors as in `read_scene`."""
    from firebreak_gis.spread.raster import read_network

    ensemble = weather.read()
    if not Path(source).is_dir():
        require_no_more(source, spread, ensemble)
        return Scene.of_network(read_network(source))
    spread.require()
    return Scene.of(read_landscape_folder(source), spread, ensemble, account)


def timed_for(spread: SpreadRequest, ensemble: Weather | None, *, clock: bool) -> SpreadRequest:
    """Return the spread model with a clock, if fires or a weather that changes need one; and refuse what cannot be."""
    timed = replace(spread, clock=True) if clock or (ensemble is not None and not ensemble.steady) else spread
    timed.require()
    return timed


def require_no_more(source: str, spread: SpreadRequest, ensemble: Weather | None) -> None:
    """Refuse a wind, a weather or a spread model beside a network file."""
    asked = ensemble is not None or any(value != 0.0 for value in spread.weather.values())
    usual = SpreadRequest()
    asked = asked or (spread.model, spread.neighbourhood) != (usual.model, usual.neighbourhood)
    if asked or spread.wind_uv or spread.model_params:
        raise ParameterError(
            f"{source} is a network, made for one wind and one spread model; for another wind or a weather give the "
            "folder of the landscape (firebreak align) in its place"
        )
