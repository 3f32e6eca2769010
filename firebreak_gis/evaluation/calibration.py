"""Rates of spread and durations fitted to a region's own fires, and what they foretell of fires that were left out.

Two kinds of observations serve:

* scars with starts, durations and weather (`calibrate_scars`). Fitted is the factor of all rates of spread under which
  the mean simulated fire is as large as the scar; of several fires, the geometric mean. How much fires differ from it
  is told as the spread of their durations (`duration`). With `p0` the spread probability is fitted as well, for the
  likest shapes.
* a table of sizes and days (`calibrate_sizes`). Fitted are the median and the spread of the durations to the sizes, the
  factor of the rates to the fires of which the days are known, and with `p0` the spread probability to the sizes.

Never are more parameters fitted than there are fires.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation import fire_sizes
from firebreak_gis.evaluation.fire_sizes import Durations, Growth
from firebreak_gis.evaluation.forecasting import Case, Foreseen, growth_of, open_case, run_case
from firebreak_gis.evaluation.request import HOURS_A_DAY
from firebreak_gis.evaluation.skill import area_matched, overlap
from firebreak_gis.progress import Progress, part
from firebreak_gis.schema import Shown

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

#: What can be fitted, and how many parameters it has.
Fitted = Literal["rate", "duration", "p0"]
PARAMETERS: Mapping[str, int] = {"rate": 1, "duration": 2, "p0": 1}
#: Spread probabilities that are tried.
P0_TRIED = (0.3, 0.4, 0.5, 0.58, 0.7, 0.85)
_DAY, _LONGEST = 24 * 3600.0, 200 * 3600.0
#: So many times as long as the longest fire simulated ones grow, for rates that are higher than those of the model.
_FURTHER = 2.0
#: The fit of a rate ends when mean size and observed size agree so well, or after so many simulations.
_CLOSE, _MOST_TRIES = 0.03, 8
#: Simulations that the fit of a rate takes, mostly.
_USUAL_TRIES = 4
_SLOWEST, _FASTEST = 0.005, 50.0


@dataclass(frozen=True, repr=False)
class Calibration(Shown):
    """What was fitted.

    Parameters
    ----------
    parameters
        Options of the command line, as a configuration holds them: `model_params`, `duration`, `clock`, ...
    n_parameters, n_fires
        How many numbers were fitted to how many fires.
    table
        One row a fire: what was observed, what is simulated, and what is foretold where the fire is left out.
    account
        More to know, as plain data.
    notes
        What is assumed, in sentences.
    """

    parameters: Mapping[str, Any]
    n_parameters: int
    n_fires: int
    table: pd.DataFrame
    account: Mapping[str, Any] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def facts(self) -> dict[str, object]:
        """What was fitted to what, as `repr` and notebooks show them."""
        fitted = {f"{name}": value for name, value in self.parameters.items() if not isinstance(value, Mapping)}
        inner = {k: v for value in self.parameters.values() if isinstance(value, Mapping) for k, v in value.items()}
        shown = {name: f"{v:.4g}" if isinstance(v, float) else str(v) for name, v in {**fitted, **inner}.items()}
        return {"fires": self.n_fires, "numbers": self.n_parameters, **shown}

    def config(self) -> str:
        """A configuration in TOML that every command takes (`--config`); what a command does not know it leaves."""
        lines = [
            f"# Fitted by firebreak calibrate: {self.n_parameters} numbers to {self.n_fires} fires.",
            *(f"# {note}" for note in self.notes),
            'for = "every command"',
            "",
            "[parameters]",
        ]
        for name, value in self.parameters.items():
            if not isinstance(value, Mapping):
                lines.append(f"{name} = {_toml(value)}")
        for name, value in self.parameters.items():
            if isinstance(value, Mapping) and value:
                lines += ["", f"[parameters.{name}]", *(f"{key} = {_toml(each)}" for key, each in value.items())]
        return "\n".join(lines) + "\n"


def calibrate_scars(
    cases: Sequence[Case],
    *,
    fit: Iterable[str] | None = None,
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    foreseen: Callable[..., None] | None = None,
    progress: Progress | None = None,
    **params: Any,
) -> Calibration:
    """Fit the rate of spread, and perhaps the spread probability, to observed scars.

    Parameters
    ----------
    cases
        The fires.
    fit
        "rate", and perhaps "duration" and "p0"; by default the rate, and the durations of three fires or more.
    n_runs, seed, threads, progress
        As in `simulate`, for each simulation.
    foreseen
        Called as `forecasting.Foreseen`, with about how many simulations there are before.
    **params
        Of the spread model, that stay as they are.

    Returns
    -------
    Calibration
        `table` has the rate that suits each fire (`rate`), the size under the rate of all (`size_ratio`), and, where
        the other fires are enough to fit to, the rate fitted to those and what it foretells of the fire left out:
        `rate_left_out`, `size_ratio_left_out`, `growth_iou_left_out` (of the cells that burn in half of the runs).

    Raises
    ------
    ParameterError
        If there are fewer fires than parameters, or something else is to be fitted.

    Examples
    --------
    >>> import geopandas as gpd
    >>> import firebreak_gis as fb
    >>> from firebreak_gis.evaluation.forecasting import Case
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> land = fb.read_landscape(*layers, resolution=100)
    >>> start = gpd.read_file("sample_data/ignitions.gpkg").to_crs("EPSG:32635").iloc[:1]
    >>> found = fb.calibrate_scars([Case(land, start.buffer(400), start, "1h", "rose:NW=4")], n_runs=20)
    >>> (found.n_parameters, found.n_fires), list(found.parameters)
    ((1, 1), ['clock', 'model-param'])
    """
    import pandas as pd

    usual = ("rate", "duration") if len(cases) >= PARAMETERS["rate"] + PARAMETERS["duration"] else ("rate",)
    wanted = _checked(usual if fit is None else {"rate", *fit}, ("rate", "duration", "p0"), len(cases))
    n_parameters = sum(PARAMETERS[name] for name in wanted)
    # What is foretold of a fire left out rests on rate and p0 alone.
    enough = len(cases) - 1 >= n_parameters - (PARAMETERS["duration"] if "duration" in wanted else 0)
    tried = P0_TRIED if "p0" in wanted else (None,)
    total = len(cases) * len(tried)
    rates, shapes = np.empty((len(cases), len(tried))), np.empty((len(cases), len(tried)))
    opened = [open_case(case) for case in cases]
    for i, case in enumerate(opened):
        for k, p0 in enumerate(tried):
            step = part(progress, 0.8 * (i * len(tried) + k) / total, 0.8 * (i * len(tried) + k + 1) / total)
            more = {**params} if p0 is None else {**params, "p0": p0}
            how: dict[str, Any] = {"n_runs": n_runs, "seed": seed, "threads": threads}
            if foreseen is not None and i == k == 0:
                # The first fire tells of all: what a fire costs goes with its size.
                sizes = [max(int(other.scar.burnt.sum()), 1) for other in opened]
                simulations = sum(sizes) / sizes[0] * (len(tried) * _USUAL_TRIES + 1 + enough)
                how["foreseen"] = partial(foreseen, simulations)
            rates[i, k], forecast = _rate_of(case, more, progress=step, **how)
            likest = area_matched(forecast.probability, int(case.scar.burnt.sum()))
            shapes[i, k] = overlap(likest, case.scar.burnt, start=case.scar.start)["growth_iou"]

    def fitted(kept: np.ndarray) -> tuple[int, float]:
        k = int(np.argmax(shapes[kept].mean(axis=0)))
        return k, float(np.exp(np.log(rates[kept, k]).mean()))

    def told(case: Any, k: int, rate: float, step: Progress) -> tuple[float, float]:
        more = {**params, "rate_scale": rate} | ({} if tried[k] is None else {"p0": tried[k]})
        found = run_case(case, more, n_runs=n_runs, seed=seed, threads=threads, progress=step)
        likely = overlap(found.probability >= 0.5, case.scar.burnt, start=case.scar.start)
        return float(found.burnt.mean() / case.scar.burnt.sum()), likely["growth_iou"]

    everything = np.arange(len(cases))
    k, rate = fitted(everything)
    rows = []
    for i, case in enumerate(opened):
        span = [0.8 + 0.2 * (i + share) / len(cases) for share in (0.0, 0.5, 1.0)]
        observed = float(case.scar.burnt.sum() * case.grid.cell_area_ha)
        row: dict[str, Any] = {"fire": case.name, "observed_ha": observed}
        row |= {"rate": float(rates[i, k]), "shape_growth_iou": float(shapes[i, k])}
        step = part(progress, span[0], span[1], f"{case.name}: ")
        row["size_ratio"], row["growth_iou"] = told(case, k, rate, step)
        if enough:
            other, row["rate_left_out"] = fitted(np.delete(everything, i))
            step = part(progress, span[1], span[2], f"{case.name} left out: ")
            row["size_ratio_left_out"], row["growth_iou_left_out"] = told(case, other, row["rate_left_out"], step)
        rows.append(row)
    given = {**params, "rate_scale": round(rate, 6), **({} if tried[k] is None else {"p0": tried[k]})}
    notes = ["durations and weather are those given for each fire; its end is taken as the end of its spread"]
    notes += [] if enough else ["no fire could be left out: there are too few"]
    parameters: dict[str, Any] = {"clock": True}
    if "duration" in wanted:
        # With the rate of all, a fire of another rate is one of another duration.
        spread = np.log([case.duration.middle for case in opened]) + np.log(rates[:, k] / rate)
        parameters["duration"] = f"lognormal:{math.exp(float(spread.mean())):.4g}s,{float(spread.std(ddof=1)):.4g}"
    parameters["model-param"] = given
    return Calibration(parameters, n_parameters, len(cases), pd.DataFrame(rows), {}, tuple(notes))


def calibrate_sizes(
    landscape: xr.Dataset,
    fires: pd.DataFrame,
    *,
    weather: Any,
    told: str | None = None,
    ignitions: Any = None,
    fit: Iterable[str] = ("rate", "duration"),
    least: float = 100.0,
    large: float = 1000.0,
    hours_a_day: float = HOURS_A_DAY,
    longest: float | None = None,
    n_runs: int = 400,
    seed: int = 0,
    threads: int | None = None,
    foreseen: Callable[..., None] | None = None,
    progress: Progress | None = None,
    **params: Any,
) -> Calibration:
    """Fit durations, rate of spread and perhaps the spread probability to the sizes and days of many fires.

    Parameters
    ----------
    landscape
        Where the fires burnt, as `read_landscape` returns it.
    fires
        `ha` and `days`, as `scars.fire_table` returns it.
    weather
        Ensemble of weathers in which fires spread, as `read_weather` takes it.
    told
        How the configuration names it; by default `weather` itself, if that is a text.
    ignitions
        Where fires start, see `simulate`: by default everywhere alike.
    fit
        Some of "rate", "duration" and "p0". Durations are always fitted.
    least
        Fires of fewer hectares do not count: small ones are often not mapped, or put out at once.
    large
        Size from which fires are large, for the share of the area that they make [ha].
    hours_a_day
        How long a fire spreads on each of its days. An assumption: it only tells rates and durations apart.
    longest
        No fire spreads longer than this [s]. By default as many whole days as the longest observed fire, or 200 hours
        if no days are known.
    n_runs, seed, threads, progress, params
        Of the simulation.
    foreseen
        Called as `forecasting.Foreseen`, with about how many simulations there are before.

    Returns
    -------
    Calibration
        `table` has one row a fire that counts: `ha`, `days` and `place_left_out`, the share of simulated fires that are
        smaller where the fire is left out of the fit. `account` has statistics of the sizes, observed (with a bootstrap
        interval of 90 %) and simulated.

    Raises
    ------
    ParameterError
        If there are fewer fires than parameters.
    InputError
        If the simulated fires do not reach the sizes of the observed ones.

    Examples
    --------
    >>> import pandas as pd
    >>> import firebreak_gis as fb
    >>> layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    >>> land = fb.read_landscape(*layers, resolution=100)
    >>> fires = pd.DataFrame({"ha": [5.0, 12.0, 20.0, 45.0, 110.0], "days": [1, 1, 1, 2, 3]})
    >>> found = fb.calibrate_sizes(land, fires, weather="rose:NW=4,N=4", least=4, n_runs=50)
    >>> found.n_parameters, found.parameters["duration"].startswith("lognormal:")
    (3, True)
    """
    import pandas as pd

    sizes, days = fires["ha"].to_numpy(dtype=np.float64), fires["days"].to_numpy(dtype=np.float64)
    counted = sizes >= least
    wanted = _checked({"duration", *fit}, ("rate", "duration", "p0"), int(counted.sum()))
    dated = counted & np.isfinite(days)
    tried = P0_TRIED if "p0" in wanted else (None,)
    if longest is None:
        longest = float(np.nanmax(days)) * _DAY if np.isfinite(days).any() else _LONGEST
    how: dict[str, Any] = {"ignitions": ignitions, "longest": _FURTHER * longest, "seed": seed, "threads": threads}
    found: list[tuple[float, float | None, float, Growth, Durations]] = []
    for k, p0 in enumerate(tried):
        step = part(progress, 0.9 * k / len(tried), 0.9 * (k + 1) / len(tried))
        more = {**params} if p0 is None else {**params, "p0": p0}
        # Fires whose rates turn out to be higher than simulated grow further in their time.
        first = partial(foreseen, len(tried)) if foreseen is not None and k == 0 else None
        growth = growth_of(landscape, weather, n_runs=n_runs, foreseen=first, progress=step, **how, **more)
        scale = 1.0
        if "rate" in wanted:
            scale = fire_sizes.rate_factor(growth, sizes[dated], days[dated] * hours_a_day * 3600.0)
        growth = growth.until(longest * min(scale, _FURTHER))
        durations = fire_sizes.fit_durations(growth, sizes, least=least)
        found.append((fire_sizes.distance(growth, durations, sizes, least=least), p0, scale, growth, durations))
    apart, p0, scale, growth, durations = min(found, key=lambda one: one[0])
    part(progress, 0.9, 1.0)(0.0, "each fire left out")
    places = fire_sizes.leave_one_out(growth, sizes, least=least)[counted]
    simulated = fire_sizes.sample_sizes(growth, durations, seed=seed)
    account = {
        "anderson_darling": apart,
        "observed": fire_sizes.statistics(sizes, least=least, large=large),
        "observed_90": fire_sizes.bootstrap(sizes, least=least, large=large, seed=seed),
        "simulated": fire_sizes.statistics(simulated, least=least, large=large),
        "left_out_within_90": float(np.mean((places >= 0.05) & (places <= 0.95))),
        "rate_scale": scale,
        "duration_median_s": durations.median / scale,
        "duration_sigma": durations.sigma,
    }
    name = told or (weather if isinstance(weather, str) else "")
    given = {**({} if p0 is None else {"p0": p0}), **({"rate_scale": round(scale, 6)} if "rate" in wanted else {})}
    parameters = {
        "clock": True,
        "duration": f"lognormal:{durations.median / scale:.4g}s,{durations.sigma:.4g},{longest:.0f}s",
        **({"weather": name} if name else {}),
        "model-param": {**params, **given},
    }
    told_apart = (
        f"rates and durations are told apart by the days of {int(dated.sum())} fires, taken as {hours_a_day:g} hours "
        "of spread each (an assumption)"
    )
    notes = [
        f"fitted to the {int(counted.sum())} fires of {least:g} ha or more; smaller ones are not foretold",
        f"no fire spreads longer than {longest / 3600:g} hours",
        told_apart if "rate" in wanted else "rates are those of the spread model; only durations were fitted",
    ]
    table = pd.DataFrame({"ha": sizes[counted], "days": days[counted], "place_left_out": places})
    n_parameters = sum(PARAMETERS[name] for name in wanted)
    return Calibration(parameters, n_parameters, int(counted.sum()), table, account, tuple(notes))


def _rate_of(
    case: Any, params: Mapping[str, Any], *, progress: Progress, foreseen: Foreseen | None = None, **how: Any
) -> tuple[float, Any]:
    """Factor of the rates under which the mean fire is as large as the scar, and the fire under it.

    Sizes grow nearly with the square of the rate, so that few steps suffice; a bracket keeps them in bounds.
    """
    target = math.log(float(case.scar.burnt.sum()))
    low, high = math.log(_SLOWEST), math.log(_FASTEST)
    guess, forecast = 0.0, None
    for attempt in range(_MOST_TRIES):
        progress(attempt / _MOST_TRIES, f"{case.name}: rate {math.exp(guess):.3g}")
        share = part(progress, attempt / _MOST_TRIES, (attempt + 1) / _MOST_TRIES, f"{case.name}: ")
        more = {**params, "rate_scale": math.exp(guess)}
        forecast = run_case(case, more, foreseen=None if attempt else foreseen, progress=share, **how)
        apart = math.log(max(float(forecast.burnt.mean()), 1.0)) - target
        if abs(apart) < _CLOSE:
            break
        low, high = (low, guess) if apart > 0 else (guess, high)
        step = guess - apart / 2.0
        guess = step if low < step < high else (low + high) / 2.0
    return math.exp(guess), forecast


def _checked(fit: Iterable[str], known: tuple[str, ...], n_fires: int) -> list[str]:
    wanted = [name for name in known if name in set(fit)]
    strange = sorted(set(fit) - set(known))
    if strange or not wanted:
        raise ParameterError(f"fit is {', '.join(sorted(set(fit))) or 'empty'}, expected some of {', '.join(known)}")
    needed = sum(PARAMETERS[name] for name in wanted)
    if needed > n_fires:
        raise ParameterError(
            f"{n_fires} fires cannot tell {needed} parameters ({', '.join(wanted)}); give more fires or fit less"
        )
    return wanted


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float, np.integer, np.floating)):
        return repr(float(value)) if isinstance(value, (float, np.floating)) else str(int(value))
    text = str(value).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{text}"'
