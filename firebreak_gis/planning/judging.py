"""What plans are judged by: fires with a clock and breaks that fail, assumed where nothing is said, and in words.

Breaks are designed on the network of the paper, which knows no time. Fires burn on a second network, with travel times,
on which methods may try their designs; the first is kept for the paper's own case, which is told beside.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.errors import ParameterError
from firebreak_gis.planning.weather import SpreadRequest
from firebreak_gis.schema import percent
from firebreak_gis.simulation.durations import Duration
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import FIELD, Hold
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.weather import Weather

#: How long fires burn where nobody says it. Of 164 fires in Portugal (PT-FireSprd, Benali et al. 2023, doi
#: 10.5194/essd-15-3791-2023) a tenth of the burn periods took less than 2 h, half less than 7.5 h, nine tenths less
#: than 14.5 h. Fires that many crews fight last less, those of a week of wind longer: it is an assumption.
ASSUMED_DURATION = Duration("lognormal", (8 * 3600.0, 0.7))
#: How breaks hold where nobody says it: nearly half of the encounters in the field, see `simulation.holding`.
ASSUMED_HOLD = Hold(FIELD)


@dataclass(frozen=True, eq=False)
class Judging:
    """The fires that plans are judged by.

    Parameters
    ----------
    fires
        With what is assumed.
    clock
        Whether they have one.
    weather
        Of which each run draws one, or None.
    sky
        The wind or the weathers in words; empty if nothing is known.
    assumed
        What nobody said, in words.
    notes
        What should be known of it, such as that the spread model tells no times.
    hectares
        Treated by each treatment, by name; empty if all breaks are alike.
    sited
        What the breaks keep to, and where nothing is cut, in words.
    """

    fires: FireRequest
    clock: bool
    weather: Weather | None
    sky: str
    assumed: tuple[str, ...]
    notes: tuple[str, ...] = ()
    hectares: Mapping[str, float] = field(default_factory=dict)
    sited: tuple[str, ...] = ()

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What the numbers rest on, sentences."""
        told = [*self.fires.assumptions]
        if self.fires.holding.perfect and not self.fires.leaks:
            told.append("breaks hold in every fire")
        if self.hectares:
            told.append("segments are treated by " + ", ".join(f"{k} ({v:,.4g} ha)" for k, v in self.hectares.items()))
        told.append(self.sky)
        if self.assumed:
            told.append(f"{' and '.join(self.assumed)} {'is' if len(self.assumed) == 1 else 'are'} assumed, not known")
        told += self.sited
        return tuple(_sentence(words) for words in told if words)

    @property
    def reburnt(self) -> bool:
        """Whether every budget must be burnt by itself: whether anything is asked but the fires of the paper."""
        return not self.fires.timeless or self.weather is not None or self.fires.barriers_hold < 1.0

    @property
    def short(self) -> str:
        """The fires, the weather and the breaks in a few words."""
        fires = "until they end by themselves" if self.fires.duration is None else self.fires.duration.told()
        way = "" if self.fires.called is None else "where crews come before the fire"
        crews = "" if self.fires.crews is None else self.fires.crews.told()
        holds = self.fires.failures or [self.fires.holding.told()]
        embers = "" if self.fires.embers is None else "embers fly"
        return "; ".join(filter(None, (f"fires burn {fires}", crews, self.sky, embers, *holds, way)))

    @property
    def paper(self) -> FireRequest:
        """The same fires, until they end by themselves, with perfect breaks."""
        fires = self.fires
        return FireRequest(
            fires.ignitions,
            fires.ignition_mode,
            fires.n_runs,
            fires.seed,
            ignitions_outside=fires.ignitions_outside,
        )


def judging(
    fires: FireRequest,
    *,
    timed: bool,
    timeless: bool = False,
    weather: Weather | None = None,
    wind: str = "",
) -> Judging:
    """Decide what plans are judged by.

    Parameters
    ----------
    fires
        What is asked of the fires.
    timed
        Whether the network can tell how long fire takes.
    timeless
        Whether the fires of the paper are asked for: no clock, and breaks that hold unless `fires` says otherwise.
    weather
        Ensemble of which each run draws one. If it tells durations and `fires` none, they are taken.
    wind
        The one wind in words, where there is no ensemble.

    Raises
    ------
    ParameterError
        If fires without a clock are to have a duration, embers or crews.
    """
    if timeless:
        for option in ("duration", "embers", "containment", "stations"):
            if getattr(fires, option) is not None:
                raise ParameterError(f"--timeless asks for fires without a clock; leave --{option} out")
    notes: list[str] = []
    assumed: list[str] = []
    clock = timed and not timeless
    if clock:
        if fires.duration is None and fires.crews is None:
            by_weather = weather is not None and weather.timed
            fires = replace(fires, duration=Duration("weather") if by_weather else ASSUMED_DURATION)
            assumed += [] if by_weather else ["how long fires burn"]
        if fires.hold is None:
            fires = replace(fires, hold=ASSUMED_HOLD)
            assumed.append("how often breaks hold")
    elif not timeless and fires.duration is None:
        notes.append(
            "the network tells no times, so fires burn until they end by themselves and breaks hold unless --hold says "
            "otherwise; these numbers promise too much"
        )
    sky = wind if weather is None else _weather_told(weather)
    return Judging(fires, clock, weather, sky, tuple(assumed), tuple(notes))


def headline(summary: Mapping[str, Any], judged: Judging) -> list[str]:
    """What a plan saves, as sentences.

    Parameters
    ----------
    summary
        As `Plan.summary` has it.
    judged
        What its fires are.

    Returns
    -------
    list of str
        First under these fires; then, if they are not the paper's, without a clock and with perfect breaks.
    """
    sides = ("without_breaks", "with_breaks")
    bare, cut = (100 * summary[f"burnt_share_{side}"] for side in sides)
    first = (
        f"Cutting {summary['ha_cut']:,.1f} ha saves {100 * summary['saved_share']:.3g} % of the burnt area: the mean "
        f"fire burns {summary['fire_ha_without_breaks']:,.4g} ha ({bare:.3g} % of the fuel) without the breaks, "
        f"{summary['fire_ha_with_breaks']:,.4g} ha ({cut:.3g} %) with them"
    )
    told = [f"{first} ({judged.short})."]
    if judged.reburnt:
        ever, still = (percent(summary["timeless"][f"burnt_share_{side}"]) for side in sides)
        told.append(
            f"Without a clock and with perfect breaks, as in the paper, {ever} of the fuel burns without them, "
            f"{still} with them."
        )
    return told


@dataclass(frozen=True, eq=False)
class Scene:
    """What plans are designed on, and what their fires burn on, which is made when asked for.

    Parameters
    ----------
    network
        What breaks are designed on, before existing barriers are put into it.
    weather
        Ensemble of which each run draws one, or None.
    wind
        The one wind in words; empty if it is not known, or there is an ensemble.
    landscape, spread, params
        What the network was made of, and the parameters of the spread model; None, none where it was read from a file.
    scratch
        Folder on whose disk networks of large landscapes lie; empty: that for temporary files.
    """

    network: SpreadNetwork
    weather: Weather | None = None
    wind: str = ""
    landscape: xr.Dataset | None = None
    spread: SpreadRequest = field(default_factory=SpreadRequest)
    params: Mapping[str, Any] = field(default_factory=dict)
    scratch: str = ""

    @classmethod
    def of(
        cls,
        landscape: xr.Dataset,
        spread: SpreadRequest,
        weather: Weather | None = None,
        account: Account | None = None,
        *,
        scratch: str = "",
    ) -> Scene:
        """A landscape under one wind or an ensemble of weathers.

        Designs know no clock; of several weathers they know the mean of the probabilities, by the weights of the
        weathers and the time that their steps take.
        """
        if weather is None:
            params = spread.params(landscape, account)
            network = _still(landscape, spread, params, scratch)
            return cls(network, None, wind_told(params), landscape, spread, params, scratch)
        params = spread.params_beside(landscape, weather)
        return cls(_mean_network(landscape, spread, params, weather), weather, "", landscape, spread, params)

    @classmethod
    def of_network(cls, network: SpreadNetwork) -> Scene:
        """A network, perhaps with times, for one wind."""
        known = network.provenance.get("wind_speed") is not None
        return cls(network, wind=wind_told(network.provenance) if known else "")

    def judging(self, fires: FireRequest, *, timeless: bool = False) -> Judging:
        """Decide what plans are judged by, see `judging`."""
        timed = self.network.timed or (self.landscape is not None and self._takes_clock)
        if fires.needs_times and not timed:
            self.network.require_times("a duration, embers, hold by flames, or crews that travel")
        return judging(fires, timed=timed, timeless=timeless, weather=self.weather, wind=self.wind)

    def ground(self, judged: Judging, barred: SpreadNetwork, barriers: np.ndarray | xr.DataArray | None) -> Ground:
        """Make what the fires burn on.

        Parameters
        ----------
        judged
            The fires.
        barred
            The network of the designs with the barriers in it; the fires burn on it unless they need another.
        barriers
            (y, x), above 0 on existing barriers.
        """
        from firebreak_gis.spread import weather_networks

        fails = barriers is not None and judged.fires.barriers_hold < 1.0
        kept = barriers if fails else None
        if self.landscape is None:
            return Ground(self.network if fails else barred, None, kept)
        fuel = self.landscape if fails else _without(self.landscape, barriers)
        clock = judged.clock and self._takes_clock
        if self.weather is not None:
            networks = weather_networks(fuel, self.weather, model=self.spread.model, clock=clock, **self.params)
            return Ground(networks[0].network, networks, kept)
        if clock:
            return Ground(_made(fuel, self.spread, {**self.params, "clock": True}, self.scratch), None, kept)
        return Ground(self.network if fails else barred, None, kept)

    @property
    def _takes_clock(self) -> bool:
        return any(p["name"] == "clock" for p in plugins.describe("spread", self.spread.model)["parameters"])


def wind_told(params: Mapping[str, Any]) -> str:
    """The one wind of a spread model's parameters, in words."""
    speed, direction = params.get("wind_speed", 0.0), params.get("wind_from_direction", 0.0)
    if np.ndim(speed) or np.ndim(direction):
        return "wind as its rasters tell"
    return f"wind {speed:g} m/s from {direction:g} degrees" if speed else "no wind"


def _still(landscape: xr.Dataset, spread: SpreadRequest, params: Mapping[str, Any], scratch: str = "") -> SpreadNetwork:
    """The network without a clock."""
    return _made(landscape, spread, {k: v for k, v in params.items() if k != "clock"}, scratch)


def _made(landscape: xr.Dataset, spread: SpreadRequest, params: Mapping[str, Any], scratch: str) -> SpreadNetwork:
    import tempfile

    from firebreak_gis.planning.blocks import network_of

    return network_of(landscape, model=spread.model, folder=scratch or tempfile.gettempdir(), **params)


def _mean_network(
    landscape: xr.Dataset, spread: SpreadRequest, params: Mapping[str, Any], weather: Weather
) -> SpreadNetwork:
    total = np.zeros((8, *landscape["burnable"].shape))
    for step, share in weather.steps():
        told = {"wind_speed": step.wind_speed, "wind_from_direction": step.wind_from_direction}
        told |= {} if step.moisture is None else {"moisture": step.moisture}
        network = _still(landscape, spread, {**params, **told})
        total += share * network.probability
    return network.derived(probability=total.clip(0.0, 1.0).astype(np.float32))


def _without(landscape: xr.Dataset, barriers: np.ndarray | xr.DataArray | None) -> xr.Dataset:
    """The landscape without fuel on barriers, (y, x) above 0."""
    if barriers is None:
        return landscape
    burnable = landscape["burnable"]
    return landscape.assign(burnable=burnable.copy(data=burnable.to_numpy() & ~(np.asarray(barriers) > 0)))


def _weather_told(weather: Weather) -> str:
    found = weather.describe()
    count = found["weathers"]
    each = "one weather" if count == 1 else f"{count} weathers, drawn by their weights"
    return f"{each}, mean wind {found['mean_wind_speed']:g} m/s"


def _sentence(words: str) -> str:
    return words[0].upper() + words[1:] + "."
