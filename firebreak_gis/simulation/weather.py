"""Weather of fires: an ensemble of which each run draws one, steady or changing with time.

A `Weather` holds `Spell`s with weights; a spell is one `Step` or several that follow each other. Which spell a run has
depends on (seed, run) alone. `spread.weather_networks` gives the network of a landscape in each spell, made when it is
asked for.
"""

from __future__ import annotations

import functools
import threading
from collections import OrderedDict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.schema import Shown

#: Greatest wind speed [m/s] that is taken for one.
_STRONGEST = 60.0


class Step(NamedTuple):
    """Weather that stays the same for a while.

    Parameters
    ----------
    wind_speed
        [m/s]
    wind_from_direction
        Degrees clockwise from north, where the wind comes from.
    moisture
        Moisture of the fine dead fuel, a share of its dry weight; None if not told.
    """

    wind_speed: float
    wind_from_direction: float
    moisture: float | None = None


@dataclass(frozen=True)
class Spell:
    """One weather of an ensemble.

    Parameters
    ----------
    steps
        One, or several that follow each other; the last one stays.
    starts
        Seconds after the fire starts at which each step begins, whole and rising from 0.
    weight
        How likely it is, relative to the others.
    duration
        Seconds that a fire burns in it; None if not told.
    span
        Seconds for which the steps are told; None for a steady weather.
    name
        As the table has it, may be empty.
    """

    steps: tuple[Step, ...]
    starts: tuple[int, ...] = (0,)
    weight: float = 1.0
    duration: float | None = None
    span: float | None = None
    name: str = ""

    @property
    def steady(self) -> bool:
        """Whether it does not change with time."""
        return len(self.steps) == 1


@dataclass(frozen=True, repr=False)
class Weather(Shown):
    """An ensemble of weathers.

    Parameters
    ----------
    spells
        At least one; weights of at least 0, not all 0.
    said
        How a table was read, in words, for the account of a run.

    Raises
    ------
    InputError
        Naming every number that cannot be.

    Examples
    --------
    >>> weather = Weather((Spell((Step(5.0, 315.0),), weight=3.0), Spell((Step(9.0, 0.0),))))
    >>> weather.of_runs(seed=1, n_runs=8).tolist()
    [1, 0, 0, 0, 0, 0, 0, 0]
    """

    spells: tuple[Spell, ...]
    said: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        problems = [p for number, spell in enumerate(self.spells, start=1) for p in _problems(spell, number)]
        if not sum(spell.weight for spell in self.spells if spell.weight > 0) > 0:
            problems.append("no weather has a weight above 0")
        if problems:
            raise InputError("the weather cannot be used: " + "; ".join(problems))

    def facts(self) -> dict[str, object]:
        """How many weathers of what wind, as `repr` and notebooks show them."""
        return {
            "weathers": len(self.spells),
            "changing": sum(not spell.steady for spell in self.spells),
            "mean wind": f"{self._mean(lambda step: step.wind_speed):.3g} m/s",
            "durations": ("not told", "told")[self.timed],
        }

    @property
    def steady(self) -> bool:
        """Whether no spell changes with time."""
        return all(spell.steady for spell in self.spells)

    @property
    def timed(self) -> bool:
        """Whether every spell tells how long fires burn in it."""
        return all(spell.duration is not None for spell in self.spells if spell.weight > 0)

    @property
    def shares(self) -> np.ndarray:
        """Weights as shares of their sum, (n_spells,) float64."""
        weights = np.array([spell.weight for spell in self.spells])
        return np.asarray(weights / weights.sum())

    def of_runs(self, *, seed: int, n_runs: int, first_run: int = 0) -> np.ndarray:
        """Return the spell of each run, (n_runs,) int64 indices into `spells`.

        The draw is keyed by (seed, run): a run has the same weather with any breaks, however runs are split.
        """
        from firebreak_gis.kernels.draws import first_uniforms, run_keys

        ends = np.cumsum(self.shares)
        draws = first_uniforms(run_keys(seed, "weather", n_runs, first_run))
        found = np.searchsorted(ends, draws * ends[-1], side="right")
        return np.asarray(np.minimum(found, np.flatnonzero(self.shares)[-1]))

    def of_run(self, seed: int, run: int) -> Spell:
        """Return the spell of one run."""
        return self.spells[int(self.of_runs(seed=seed, n_runs=1, first_run=run)[0])]

    def groups(self, *, seed: int, n_runs: int, first_run: int = 0) -> Iterator[tuple[int, np.ndarray]]:
        """Yield each spell that some run has, and the numbers of its runs, rising: one network at a time will do."""
        spells = self.of_runs(seed=seed, n_runs=n_runs, first_run=first_run)
        for spell in np.unique(spells):
            yield int(spell), first_run + np.flatnonzero(spells == spell)

    def durations(self, *, seed: int, n_runs: int, first_run: int = 0) -> np.ndarray:
        """Return the seconds that the fire of each run burns, (n_runs,) float64, as the weather tells them.

        Raises
        ------
        ParameterError
            If a spell does not tell a duration.
        """
        if not self.timed:
            raise ParameterError(
                "the weather tells no duration of fires; give the table a column such as duration_h, or a --duration"
            )
        told = np.array([np.nan if spell.duration is None else spell.duration for spell in self.spells])
        return np.asarray(told[self.of_runs(seed=seed, n_runs=n_runs, first_run=first_run)])

    def steps(self) -> list[tuple[Step, float]]:
        """Return every step that occurs, with the share of the time that it has, in order of first occurrence."""
        shares: dict[Step, float] = {}
        for spell, share in zip(self.spells, self.shares, strict=True):
            lengths = _lengths(spell)
            for step, part in zip(spell.steps, lengths / lengths.sum(), strict=True):
                if share > 0:
                    shares[step] = shares.get(step, 0.0) + float(share * part)
        return list(shares.items())

    def describe(self) -> dict[str, Any]:
        """Return what the ensemble is, as plain data for accounts and tags."""
        return {
            "weathers": len(self.spells),
            "changing": sum(not spell.steady for spell in self.spells),
            "mean_wind_speed": round(self._mean(lambda step: step.wind_speed), 3),
            "said": list(self.said),
            "spells": [
                {
                    "name": spell.name,
                    "share": round(float(share), 9),
                    "duration": spell.duration,
                    "starts": list(spell.starts),
                    "steps": [list(step) for step in spell.steps],
                }
                for spell, share in zip(self.spells, self.shares, strict=True)
            ],
        }

    def _mean(self, of: Callable[[Step], float]) -> float:
        return sum(
            float(share) * float(np.average([of(step) for step in spell.steps], weights=_lengths(spell)))
            for spell, share in zip(self.spells, self.shares, strict=True)
        )


class Conditions(NamedTuple):
    """A landscape in one spell of weather.

    Parameters
    ----------
    network
        The network. In changing weather its probabilities and heat are the means over the time that is told, its
        travel times the least of all steps.
    starts
        (n_steps,) uint64, seconds after the fire starts at which each step begins; the first is 0.
    times
        For each step (8, rows, cols) uint32 seconds that fire would take along each edge if the step lasted;
        `lattice.NEVER` where fire does not move then. Of a steady weather with a clock: `network.travel_time` alone;
        without a clock: none.
    """

    network: SpreadNetwork
    starts: np.ndarray
    times: tuple[np.ndarray, ...]


class WeatherNetworks(Shown):
    """The networks of one landscape in every spell of a weather, made when asked for and kept for a while.

    `networks[i]` are the `Conditions` of `weather.spells[i]`. Made by `spread.weather_networks`.

    Parameters
    ----------
    weather
        The ensemble.
    build
        Makes the network of a step.
    keep
        So many conditions are kept, those used last; spells of equal steps share theirs.

    Notes
    -----
    Memory: about 70 B a cell for each one kept, and 32 B a cell for each step of a changing one.
    """

    def __init__(self, weather: Weather, build: Callable[[Step], SpreadNetwork], *, keep: int = 4) -> None:
        if keep < 1:
            raise ParameterError(f"keep is {keep}, expected at least 1")
        self.weather = weather
        self._build = build
        self._keep = keep
        self._kept: OrderedDict[tuple[Any, ...], Conditions] = OrderedDict()
        self._lock = threading.Lock()

    def __reduce__(self) -> Any:
        """What is kept is made again where it is needed."""
        return _networks_again, (self.weather, self._build, self._keep)

    def content(self) -> list[Any]:
        """What tells it from others."""
        return [self.weather, self._build]

    def facts(self) -> dict[str, object]:
        """Those of the weather."""
        return self.weather.facts()

    def __len__(self) -> int:
        """Spells of the weather."""
        return len(self.weather.spells)

    def __getitem__(self, index: int) -> Conditions:
        """Return the landscape in the spell of that number."""
        spell = self.weather.spells[index]
        key = (spell.steps, spell.starts, spell.span)
        with self._lock:
            if key not in self._kept:
                made = self._make(spell)
                for other in self._kept.values():
                    _share(made.network, other.network)
                self._kept[key] = made
                while len(self._kept) > self._keep:
                    self._kept.popitem(last=False)
            self._kept.move_to_end(key)
            return self._kept[key]

    def _make(self, spell: Spell) -> Conditions:
        starts = np.array(spell.starts, np.uint64)
        if spell.steady:
            network = self._build(spell.steps[0])
            return Conditions(network, starts, () if network.travel_time is None else (network.travel_time,))
        made: dict[Step, SpreadNetwork] = {}
        for step in spell.steps:
            if step not in made:
                made[step] = self._build(step)
        networks = [made[step] for step in spell.steps]
        times = tuple(network.require_times("changing weather") for network in networks)
        return Conditions(_mean(networks, times, _lengths(spell)), starts, times)


def _networks_again(weather: Weather, build: Callable[[Step], SpreadNetwork], keep: int) -> WeatherNetworks:
    return WeatherNetworks(weather, build, keep=keep)


def _mean(networks: Sequence[SpreadNetwork], times: Sequence[np.ndarray], lengths: np.ndarray) -> SpreadNetwork:
    """Network of a changing weather: mean probabilities and heat, the least times, no wind of its own."""
    shares = lengths / lengths.sum()
    first = networks[0]
    heats = [network.heat for network in networks if network.heat is not None]
    left_out = max((str(network.provenance.get("left_out", "")) for network in networks), key=len)
    return SpreadNetwork(
        _weighted([network.probability for network in networks], shares).clip(0.0, 1.0),
        burnable=first.burnable,
        boundary=first.boundary,
        crs=first.grid.crs,
        transform=first.grid.transform,
        provenance={"left_out": left_out} if left_out else None,
        travel_time=functools.reduce(np.minimum, times),
        heat=_weighted(heats, shares) if len(heats) == len(networks) else None,
    )


def _weighted(planes: Sequence[np.ndarray], shares: np.ndarray) -> np.ndarray:
    """Sum of planes times shares, float64, in the order given."""
    total = np.zeros(planes[0].shape)
    for plane, share in zip(planes, shares, strict=True):
        total += plane * share
    return total


def _share(network: SpreadNetwork, other: SpreadNetwork) -> None:
    """Let equal probabilities be one array: networks that differ by the wind alone have them under a clock."""
    if np.array_equal(network.probability, other.probability):
        object.__setattr__(network, "probability", other.probability)


def _lengths(spell: Spell) -> np.ndarray:
    """Seconds of each step, (n_steps,) float64; the last as long as it is told, or as the one before."""
    if spell.steady:
        return np.ones(1)
    steps = np.diff(np.array(spell.starts, np.float64))
    last = steps[-1] if spell.span is None else spell.span - spell.starts[-1]
    return np.append(steps, max(last, 1.0))


def _problems(spell: Spell, number: int) -> Iterator[str]:
    where = f"weather {number}" + (f" ({spell.name})" if spell.name else "")
    if not spell.steps or len(spell.steps) != len(spell.starts):
        yield f"{where} has {len(spell.steps)} steps that begin at {len(spell.starts)} times"
    elif spell.starts[0] != 0 or any(b <= a for a, b in pairwise(spell.starts)):
        yield f"{where}: its steps begin at {', '.join(map(str, spell.starts))} s, expected times that rise from 0"
    if not (0.0 <= spell.weight < float("inf")):
        yield f"{where} has the weight {spell.weight}, expected a number of at least 0"
    if spell.duration is not None and not spell.duration > 0:
        yield f"{where} has a duration of {spell.duration:g} s, expected more than 0"
    for step in spell.steps:
        if not 0.0 <= step.wind_speed <= _STRONGEST:
            yield f"{where}: the wind speed is {step.wind_speed:g} m/s, expected 0 to {_STRONGEST:g}"
        if not 0.0 <= step.wind_from_direction <= 360.0:
            yield f"{where}: the wind comes from {step.wind_from_direction:g} degrees, expected 0 to 360"
        if step.moisture is not None and not 0.0 <= step.moisture <= 1.0:
            yield f"{where}: the moisture is {step.moisture:g}, expected a share from 0 to 1 (8 % is 0.08)"
