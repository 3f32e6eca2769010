"""A simulated fire held against an observed one, beside the fires that know nothing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.errors import GridError
from firebreak_gis.evaluation import nulls
from firebreak_gis.evaluation.skill import (
    Reliability,
    area_matched,
    brier,
    brier_skill,
    overlap,
    reliability,
    time_of_size,
)
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.scars import Scar
from firebreak_gis.schema import Shown

if TYPE_CHECKING:
    import pandas as pd

#: Cells that a bin of a reliability curve needs before its gap counts.
LEAST_CELLS = 100
#: A cell is in the simulated fire if it burns in at least this share of the runs.
_LIKELY = 0.5


class Forecast(NamedTuple):
    """What a simulation says of one fire.

    Parameters
    ----------
    probability
        (rows, cols) share of the runs in which the cell burns.
    arrival
        (rows, cols) median hours until fire arrives, over the runs in which it does; nan where it never does.
    hours
        (n_times,) hours, rising.
    sizes
        (n_runs, n_times) cells burnt by then if no run ends before, not falling.
    burnt
        (n_runs,) cells burnt when the run ended.
    """

    probability: np.ndarray
    arrival: np.ndarray
    hours: np.ndarray
    sizes: np.ndarray
    burnt: np.ndarray


@dataclass(frozen=True, repr=False)
class Validation(Shown):
    """What came out.

    Parameters
    ----------
    grid
        The grid of all planes.
    scar
        The observed fire.
    forecast
        The simulated one.
    fires
        (rows, cols) bool by name: "simulated" (burns in half of the runs or more), "shape" (the likeliest cells, as
        many as burnt), and the null models "none", "distance", "ellipse".
    scores
        For each of those `sorensen`, `iou`, `growth_iou`, `size_ratio` and `brier`. The size and the Brier score of
        "simulated" are those of the probabilities. Null models have `skill` too: the share of their Brier score that
        the simulation saves.
    curve
        Reliability of the probabilities, over the cells with fuel or in the scar.
    hours_to_size
        Hours until the mean simulated fire is as large as the observed one, if it may go on; nan if it never is.
    notes
        What is doubtful or assumed, in sentences.
    """

    grid: Grid
    scar: Scar
    forecast: Forecast
    fires: Mapping[str, np.ndarray]
    scores: Mapping[str, Mapping[str, float]]
    curve: Reliability
    hours_to_size: float
    notes: tuple[str, ...] = ()
    account: Mapping[str, Any] = field(default_factory=dict)

    def facts(self) -> dict[str, object]:
        """Sizes and scores, as `repr` and notebooks show them."""
        scores, area = self.scores["simulated"], self.grid.cell_area_ha
        return {
            "observed": f"{self.scar.burnt.sum() * area:,.4g} ha",
            "simulated": f"{self.forecast.burnt.mean() * area:,.4g} ha",
            "growth IoU": f"{scores['growth_iou']:.3g}",
            "better than": ", ".join(name for name, better in self.beats.items() if better) or "no null model",
        }

    @property
    def beats(self) -> dict[str, bool]:
        """For each null model, whether the growth IoU of the simulated fire lies above its own."""
        own = self.scores["simulated"]["growth_iou"]
        return {name: own > self.scores[name]["growth_iou"] for name in nulls.NULLS}

    def table(self) -> pd.DataFrame:
        """Scores, one row a fire: model, sorensen, iou, growth_iou, size_ratio, brier, skill."""
        import pandas as pd

        rows = [{"model": name, **scores} for name, scores in self.scores.items()]
        return pd.DataFrame(rows)

    def reliability_table(self) -> pd.DataFrame:
        """Reliability curve, one row a bin: low, high, cells, forecast, observed."""
        import pandas as pd

        return pd.DataFrame(self.curve._asdict())

    def summary(self) -> dict[str, Any]:
        """What matters, as plain data."""
        sizes = self.forecast.burnt * self.grid.cell_area_ha
        low, middle, high = np.percentile(sizes, (10, 50, 90))
        return {
            "observed_ha": float(self.scar.burnt.sum() * self.grid.cell_area_ha),
            "simulated_ha": float(sizes.mean()),
            "simulated_ha_p10": float(low),
            "simulated_ha_p50": float(middle),
            "simulated_ha_p90": float(high),
            "hours_to_observed_size": None if np.isnan(self.hours_to_size) else float(self.hours_to_size),
            "scores": {name: dict(scores) for name, scores in self.scores.items()},
            "beats": self.beats,
            "reliability": self.reliability_table().astype(object).where(lambda t: t.notna(), None).to_dict("records"),
            "reliability_largest_gap": _or_none(self.curve.largest_gap(LEAST_CELLS)),
            "notes": list(self.notes),
        }


def judge(
    forecast: Forecast,
    scar: Scar,
    grid: Grid,
    *,
    fuel: np.ndarray,
    wind: tuple[float, float],
    notes: tuple[str, ...] = (),
    account: Mapping[str, Any] | None = None,
) -> Validation:
    """Score a forecast and the null models against a scar.

    Parameters
    ----------
    forecast
        Of a simulation.
    scar
        The observed fire.
    grid
        Where they lie.
    fuel
        (rows, cols) bool.
    wind
        Speed [m/s] and direction it comes from [degrees], for the elliptical null model.
    notes, account
        Kept with those of the scar.

    Raises
    ------
    GridError
        If a plane does not lie on the grid.
    """
    for name, plane in (("probability", forecast.probability), ("scar", scar.burnt), ("fuel", fuel)):
        if plane.shape != grid.shape:
            raise GridError(f"the {name} has shape {plane.shape}, expected {grid.shape}")
    probability = np.nan_to_num(np.asarray(forecast.probability, dtype=np.float64))
    size = int(scar.burnt.sum())
    fires = {
        "simulated": probability >= _LIKELY,
        "shape": area_matched(probability, size),
        "none": nulls.no_growth(scar.start),
        "distance": nulls.equal_distance(fuel, scar.start, size),
        "ellipse": nulls.wind_ellipse(fuel, scar.start, size, wind_speed=wind[0], wind_from_direction=wind[1]),
    }
    counted = fuel | scar.burnt
    scores = {name: overlap(fire, scar.burnt, start=scar.start) for name, fire in fires.items()}
    for name, fire in fires.items():
        scores[name]["brier"] = brier(fire.astype(np.float64), scar.burnt, within=counted)
    scores["simulated"]["size_ratio"] = float(probability.sum()) / size
    scores["simulated"]["brier"] = brier(probability, scar.burnt, within=counted)
    for name in nulls.NULLS:
        scores[name]["skill"] = brier_skill(scores["simulated"]["brier"], scores[name]["brier"])
    return Validation(
        grid,
        scar,
        forecast,
        fires,
        scores,
        reliability(probability, scar.burnt, within=counted),
        time_of_size(forecast.hours, forecast.sizes.mean(axis=0), size),
        (*scar.notes, *notes),
        dict(account or {}),
    )


def _or_none(number: float) -> float | None:
    return None if np.isnan(number) else float(number)
