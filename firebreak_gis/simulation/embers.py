"""Embers that fly ahead of a fire: how many, how far, what they light and when.

The law of distances is that of PROPAGATOR (Trucchia et al. 2020, doi 10.3390/fire3030026, and its public constants).
How many embers a fire throws has no universal source and is an assumption, as are the other numbers unless calibrated.
Every draw is keyed by (seed, run, cell): a cell that burns throws the same embers with and without breaks.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.simulation.holding import strongest

if TYPE_CHECKING:
    from collections.abc import Sequence

    from firebreak_gis.kernels.embers import Embers as Flying
    from firebreak_gis.network import SpreadNetwork

#: Intensity to which the numbers of embers refer [kW/m].
_REFERENCE = 10_000.0


@dataclass(frozen=True)
class Embers:
    """Embers; all defaults are assumptions.

    Parameters
    ----------
    rate
        Embers able to light a fire that a burning square kilometre throws, if its fire line has 10,000 kW/m.
    rate_power
        The number grows with this power of the intensity.
    least_heat
        Cells that release less heat throw none [kJ/m2]: grass and crops.
    distance
        Median distance downwind at a wind of 20 km/h and 10,000 kW/m [m]; it grows with the wind speed and with the
        cube root of the intensity.
    sigma
        Standard deviation of the logarithm of the distance.
    longest
        No ember flies further [m].
    spread
        Standard deviation of the direction about downwind [degrees].
    focus
        An ember at the angle a to the wind flies exp(focus (cos a - 1)) times as far.
    ignition
        Probability that an ember lights a fire in fuel.
    ignition_heavy
        The same in fuel that releases at least `least_heat`.
    delay, delay_sigma
        Median [s] and standard deviation of the logarithm of the time until the new fire spreads.
    wind_speed, wind_from_direction
        Wind [m/s, degrees], where the weather or the network does not tell it.

    Examples
    --------
    >>> as_embers("rate=12,longest=1000").longest
    1000.0
    """

    rate: float = 6.0
    rate_power: float = 0.0
    least_heat: float = 15_000.0
    distance: float = 100.0
    sigma: float = 0.5
    longest: float = 2000.0
    spread: float = 15.0
    focus: float = 5.0
    ignition: float = 0.6
    ignition_heavy: float = 0.84
    delay: float = 600.0
    delay_sigma: float = 0.4
    wind_speed: float | None = None
    wind_from_direction: float | None = None

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None and not 0 <= value < float("inf"):
                raise ParameterError(f"{field.name} of the embers is {value:g}, expected a number of at least 0")
        if max(self.ignition, self.ignition_heavy) > 1:
            raise ParameterError("the ignition of the embers is above 1, expected a probability")

    def told(self) -> str:
        """What is assumed, in words, for accounts and pictures."""
        return (
            f"embers (assumed): {self.rate:g} a burning km2, median {self.distance:g} m at 20 km/h and 10 MW/m, "
            f"{self.ignition_heavy:.0%} of them light heavy fuel after {self.delay / 60:g} min"
        )


def as_embers(given: Any, what: str = "embers") -> Embers | None:
    """Read embers: False or None for none, True or "on" for the defaults, "rate=12,longest=1000", or `Embers`.

    Raises
    ------
    ParameterError
        If it is none of these.
    """
    if given is None or given is False or isinstance(given, Embers):
        return given or None
    word = str(given).strip()
    if given is True or word.lower() == "on":
        return Embers()
    if word.lower() == "off":
        return None
    known = [field.name for field in fields(Embers)]
    values: dict[str, float] = {}
    for part in word.split(","):
        name, equals, number = part.partition("=")
        key = name.strip().replace("-", "_")
        if not equals or key not in known:
            raise ParameterError(
                f"{what} has {part.strip()!r}, expected on, off, or NAME=VALUE with NAME one of {', '.join(known)}"
            )
        try:
            values[key] = float(number)
        except ValueError:
            raise ParameterError(f"{what} has {part.strip()!r}, expected a number after the =") from None
    return Embers(**values)


def nothing_flies(keys: np.ndarray) -> Flying:
    """What the kernel is given where there are no embers."""
    from firebreak_gis.kernels.embers import Embers as Flying

    none = np.zeros((1, 0), np.float32)
    return Flying(keys, none, none, none, none, 0.0, 0.0, 0.0, none[0], 0.0, 0.0)


def what_flies(
    embers: Embers,
    network: SpreadNetwork,
    keys: np.ndarray,
    *,
    times: Sequence[np.ndarray],
    winds: Sequence[tuple[float, float]],
) -> Flying:
    """What the kernel is given of the embers.

    Parameters
    ----------
    embers
        The law.
    network
        With heat, on a grid in metres.
    keys
        (n_runs,) uint64 keys of the runs for the purpose `embers`.
    times
        Travel times (8, rows, cols) under the weather of each step.
    winds
        Wind speed [m/s] and the direction that it comes from [degrees] in each step.
    """
    from firebreak_gis.kernels.embers import Embers as Flying

    heat = network.require_heat("embers")
    heavy = heat >= embers.least_heat
    size = network.grid.cell_size
    area_km2 = (size / 1000.0) ** 2
    intensity = [strongest(network, "embers", each) / _REFERENCE for each in times]
    mean = [np.where(heavy, embers.rate * area_km2 * each**embers.rate_power, 0.0) for each in intensity]
    median = [
        embers.distance * (speed * 3.6 / 20.0) * np.cbrt(each) / size
        for each, (speed, _) in zip(intensity, winds, strict=True)
    ]
    downwind = np.radians([(blows_from + 180.0) % 360.0 for _, blows_from in winds])
    catches = np.where(network.burnable, np.where(heavy, embers.ignition_heavy, embers.ignition), 0.0)
    return Flying(
        keys,
        np.array(mean, np.float32).reshape(len(times), -1),
        np.array(median, np.float32).reshape(len(times), -1),
        np.full((len(times), 1), embers.sigma, np.float32),
        downwind.astype(np.float32)[:, np.newaxis],
        float(np.radians(embers.spread)),
        embers.focus,
        embers.longest / size,
        catches.astype(np.float32).ravel(),
        embers.delay,
        embers.delay_sigma,
    )


def wind_of(embers: Embers, network: SpreadNetwork) -> tuple[float, float]:
    """Wind speed and direction for embers where no weather tells them: as given, or as the network was made with.

    Raises
    ------
    InputError
        If neither tells it.
    """
    speed = network.provenance.get("wind_speed") if embers.wind_speed is None else embers.wind_speed
    blows_from = (
        network.provenance.get("wind_from_direction")
        if embers.wind_from_direction is None
        else embers.wind_from_direction
    )
    if not isinstance(speed, (int, float)) or not isinstance(blows_from, (int, float)):
        raise InputError(
            "embers need to know the wind, and the network does not tell one; give it as "
            "embers wind_speed=8,wind_from_direction=315, or give a weather"
        )
    return float(speed), float(blows_from)
