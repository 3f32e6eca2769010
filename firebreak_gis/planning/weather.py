"""What is asked of the spread model: its name, its parameters and the weather, which may be rasters or an ensemble.

To add a quantity of the weather: add a field to `SpreadRequest`, its name among the model's parameters to `WEATHER`,
how it is read to `SpreadRequest.params`, and an option of that name to `cli.weather_options.spread`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.landscape.weather_layers import WeatherReader
from firebreak_gis.spread import Neighbourhood

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.simulation.weather import Weather, WeatherNetworks

#: Fields for wind and moisture, and the parameters of spread models that they set.
WEATHER: Mapping[str, str] = MappingProxyType(
    {"wind_speed": "wind_speed", "wind_from": "wind_from_direction", "moisture": "moisture"}
)


@dataclass(frozen=True)
class SpreadRequest:
    """A spread model and its weather.

    Parameters
    ----------
    model, model_params
        Name and parameters, see `spread.spread_network`; what is given here wins over the weather.
    wind_speed, wind_from, moisture
        [m/s], [degrees], [1]: numbers, or rasters on any grid; None is left to the model.
    wind_uv
        Rasters of the components of the wind towards east and north, in place of `wind_speed` and `wind_from`.
    clock
        Whether the model is to tell how long fire takes, too.
    neighbourhood
        Neighbours that a cell can light, see `spread.spread_network`.
    """

    model: str = "alexandridis"
    model_params: Mapping[str, Any] = field(default_factory=dict)
    wind_speed: float | str | None = None
    wind_from: float | str | None = None
    moisture: float | str | None = None
    wind_uv: tuple[float | str, float | str] | None = None
    clock: bool = False
    neighbourhood: Neighbourhood = "moore"

    @property
    def weather(self) -> dict[str, float | str]:
        """What is given of the weather, by field."""
        given = {name: getattr(self, name) for name in WEATHER}
        return {name: value for name, value in given.items() if value is not None}

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of rasters."""
        return tuple(value for value in (*self.weather.values(), *(self.wind_uv or ())) if isinstance(value, str))

    def require(self) -> None:
        """Refuse what the model does not know, or numbers out of its range, before any raster is read.

        Raises
        ------
        ParameterError
            Naming the parameter.
        """
        module = plugins.load("spread", self.model)
        known = self._known()
        for option, value in self.weather.items():
            if WEATHER[option] not in known and value != 0.0:
                flag = option.replace("_", "-")
                raise ParameterError(f"the spread model {self.model!r} knows no {WEATHER[option]}; leave --{flag} out")
        if self.wind_uv and not {"wind_speed", "wind_from_direction"} <= known:
            raise ParameterError(f"the spread model {self.model!r} knows no wind; leave --wind-uv out")
        still = (None, 0.0)
        if self.wind_uv and any(isinstance(w, np.ndarray) or w not in still for w in (self.wind_speed, self.wind_from)):
            raise ParameterError("--wind-uv is the whole wind; leave --wind-speed and --wind-from out")
        if self.clock and "clock" not in known and self.model != "raster":
            raise ParameterError(f"the spread model {self.model!r} tells no times; leave --clock out")
        numbers = {
            WEATHER[option]: value
            for option, value in self.weather.items()
            if isinstance(value, float) and WEATHER[option] in known
        }
        plugins.build_params(module, {**numbers, **self.model_params})

    def params(self, landscape: xr.Dataset, account: Account | None = None) -> dict[str, Any]:
        """Parameters of `spread_network` beside the model; rasters of the weather are laid on the grid of a landscape.

        Parameters
        ----------
        landscape
            As `read_landscape` returns it; where nothing burns the weather may be unknown.
        account
            Gets sentences on what was done.

        Raises
        ------
        InputError
            If a raster cannot be laid on the grid.
        """
        reader = WeatherReader(
            Grid.of(landscape["burnable"]), landscape["burnable"].to_numpy(), Account() if account is None else account
        )
        planes: dict[str, Any] = {}
        if self.wind_uv:
            planes |= dict(zip(("wind_speed", "wind_from"), reader.components(*self.wind_uv), strict=True))
        elif self.wind_speed is not None or self.wind_from is not None:
            speed, direction = reader.wind(
                *(0.0 if wind is None else wind for wind in (self.wind_speed, self.wind_from))
            )
            planes |= {"wind_speed": speed, "wind_from": direction}
        if self.moisture is not None:
            planes["moisture"] = reader.moisture(self.moisture)
        known = self._known()
        told = {WEATHER[option]: plane for option, plane in planes.items() if WEATHER[option] in known}
        if self.clock and "clock" in known:
            told["clock"] = True
        if self.neighbourhood != "moore":
            told["neighbourhood"] = self.neighbourhood
        return {**told, **self.model_params}

    def networks(self, landscape: xr.Dataset, weather: Weather, *, keep: int = 4) -> WeatherNetworks:
        """Networks of a landscape in every weather of an ensemble, which takes the place of the one wind.

        Raises
        ------
        ParameterError
            As `params_beside`, or `spread.weather_networks`.
        """
        from firebreak_gis.spread import weather_networks

        rest = self.params_beside(landscape, weather)
        return weather_networks(landscape, weather, model=self.model, clock=self.clock, keep=keep, **rest)

    def params_beside(self, landscape: xr.Dataset, weather: Weather) -> dict[str, Any]:
        """Parameters of the spread model without those that an ensemble of weathers tells, and without `clock`.

        Raises
        ------
        ParameterError
            If a wind, or a moisture that the ensemble tells, is given besides.
        """
        told = {"wind_speed", "wind_from"}
        if any(step.moisture is not None for spell in weather.spells for step in spell.steps):
            told.add("moisture")
        twice = [name for name, value in self.weather.items() if name in told and value != 0.0]
        twice += ["wind_uv"] if self.wind_uv else []
        if twice:
            flags = ", ".join(f"--{name.replace('_', '-')}" for name in twice)
            raise ParameterError(f"the weather tells what {flags} gives besides; leave {flags} out")
        params = self.params(landscape)
        return {k: v for k, v in params.items() if k != "clock" and k not in {WEATHER[name] for name in told}}

    def _known(self) -> set[str]:
        return {f.name for f in fields(plugins.load("spread", self.model).Params)}


@dataclass(frozen=True)
class WeatherRequest:
    """An ensemble of weathers.

    Parameters
    ----------
    weather
        CSV file, wind rose or `Weather`, see `simulation.weather_reading.read_weather`; None for none.
    weather_step
        How long each line of a table lasts, as text ("1h").
    weather_columns, weather_units
        Names and units of columns by what they hold.
    weather_ignore
        Columns to leave out, separated by commas.
    """

    weather: Any = None
    weather_step: str | None = None
    weather_columns: Mapping[str, str] = field(default_factory=dict)
    weather_units: Mapping[str, str] = field(default_factory=dict)
    weather_ignore: str | None = None

    @property
    def sources(self) -> tuple[str, ...]:
        """Names that may be those of files."""
        return (self.weather,) if isinstance(self.weather, str) else ()

    def read(self) -> Weather | None:
        """Return the ensemble; None if none is asked for.

        Raises
        ------
        InputError, ParameterError
            As `read_weather`; or if a table is described, and there is none.
        """
        from firebreak_gis.simulation.weather_reading import read_weather

        ignore = [name.strip() for name in (self.weather_ignore or "").split(",") if name.strip()]
        if self.weather is None:
            if self.weather_step or self.weather_columns or self.weather_units or ignore:
                raise ParameterError("a table of weather is described, but there is none; give --weather FILE")
            return None
        return read_weather(
            self.weather,
            step=self.weather_step,
            columns=self.weather_columns,
            units=self.weather_units,
            ignore=ignore,
        )
