"""Figures 3 to 6: density map, burn frequency, R(d_f) and the breaks on a real landscape."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.breaks import select_breaks
from firebreak_gis.evaluation.curves import evaluate
from firebreak_gis.progress import Progress, part
from firebreak_gis.ranking import rank
from firebreak_gis.schema import DENSITY, Shown
from firebreak_gis.simulation.fires import simulate
from firebreak_gis.spread import spread_network

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

#: Fires of the curves.
Curves = Literal["calm", "windy"]
#: Wind of the fire of 2008: from the north-west, 4 to 5 Beaufort.
WIND_SPEED, WIND_FROM = 8.0, 315.0
#: Rankings of Figure 5; the published version calls the policy by flammability "conventional".
METHODS: tuple[tuple[str, str, dict[str, Any]], ...] = (
    ("bonacich 0.5", "bonacich", {"beta": 0.5}),
    ("conventional", "flammability", {}),
    ("random", "random", {}),
)
#: Budgets whose breaks Figure 6 shows: ranking label and d_f.
SHOWN = (("bonacich 0.5", 0.14), ("random", 0.19))
#: Budgets at which the classes of what is cut are told.
TOLD = (0.14, 0.19)
BUDGETS = tuple(round(0.01 * k, 2) for k in range(41))
GREY_LEVELS = 16


@dataclass(frozen=True, repr=False)
class LandscapeExperiment(Shown):
    """What the figures show.

    Parameters
    ----------
    landscape
        The whole landscape.
    window
        The part of it in which breaks are planned.
    fire
        Burns of the whole landscape from one ignition with wind, as `simulate` returns them.
    evaluation
        R(d_f) in the window, as `evaluate` returns it.
    breaks
        Break masks in the window by (label, d_f), as in `SHOWN`.
    cut
        Those of every ranking at the budgets `TOLD`.
    """

    landscape: xr.Dataset
    window: xr.Dataset
    fire: xr.Dataset
    evaluation: xr.Dataset
    breaks: dict[tuple[str, float], xr.DataArray]
    cut: dict[tuple[str, float], xr.DataArray]

    def facts(self) -> dict[str, object]:
        """Rankings, budgets and fires, as `repr` and notebooks show them."""
        return {
            "rankings": ", ".join(self.evaluation["ranking"].to_numpy().tolist()),
            "budgets": self.evaluation.sizes["budget"],
            "fires": self.evaluation.sizes["run"],
        }


def landscape_experiment(
    landscape: xr.Dataset,
    *,
    ignition: tuple[float, float] | None = None,
    rectangle: tuple[float, float, float, float] | None = None,
    wind_speed: float = WIND_SPEED,
    wind_from_direction: float = WIND_FROM,
    curves: Curves = "calm",
    n_runs: int = 100,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
) -> LandscapeExperiment:
    """Run the experiments of Figures 3 to 6.

    Figure 4a is a fire with wind from one ignition. Figures 5 and 6 are planned and judged inside the rectangle: in
    calm air with random ignitions (the paper's equation 9 has no wind, and it names no ignition), or with the ignition
    and the wind of Figure 4a.

    Parameters
    ----------
    landscape
        As `read_landscape` returns it.
    ignition
        (x, y) in the CRS of the landscape; by default the cell with fuel nearest to the middle.
    rectangle
        (left, bottom, right, top) in the CRS of the landscape; by default all of it.
    wind_speed, wind_from_direction
        Wind of Figure 4a [m/s, degrees].
    curves
        Fires of Figures 5 and 6: `"calm"`, or `"windy"`, those of Figure 4a. Without an ignition these start at the
        cell with fuel nearest to the middle of the rectangle. A fire whose ignition is cut burns nothing.
    n_runs, seed, threads, progress
        As in `simulate`.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> found = fb.landscape_experiment(fb.read_landscape(**fb.sample_layers(), resolution=300.0), n_runs=3)
    >>> found.evaluation.sizes["run"]
    3
    """
    window = crop(landscape, rectangle) if rectangle else landscape
    wind: dict[str, Any] = {"wind_speed": wind_speed, "wind_from_direction": wind_from_direction}
    windy = spread_network(landscape, **wind)
    start = [ignition] if ignition else [middle(landscape)]
    fire = simulate(
        windy,
        ignitions=start,
        n_runs=n_runs,
        seed=seed,
        threads=threads,
        progress=part(progress, 0.0, 0.2, "figure 4: "),
    )
    windy_curves = curves == "windy"
    network = spread_network(window, **(wind if windy_curves else {}))
    priorities = {}
    for i, (label, method, params) in enumerate(METHODS):
        step = part(progress, 0.2 + 0.1 * i, 0.3 + 0.1 * i, f"{label}: ")
        priorities[label] = rank(network, method, seed=seed, progress=step, **params)
    evaluation = evaluate(
        network,
        priorities,
        budgets=BUDGETS,
        ignitions=[ignition or middle(window)] if windy_curves else None,
        n_runs=n_runs,
        seed=seed,
        threads=threads,
        progress=part(progress, 0.5, 1.0, "figure 5: "),
    )

    def cut(label: str, budget: float) -> xr.DataArray:
        return select_breaks(priorities[label], budget=budget, burnable=network.burnable)

    return LandscapeExperiment(
        landscape,
        window,
        fire,
        evaluation,
        breaks={(label, budget): cut(label, budget) for label, budget in SHOWN},
        cut={(label, budget): cut(label, budget) for budget in TOLD for label in priorities},
    )


def crop(landscape: xr.Dataset, rectangle: tuple[float, float, float, float]) -> xr.Dataset:
    """Cut the cells whose centres lie in (left, bottom, right, top)."""
    from firebreak_gis.errors import ParameterError

    left, bottom, right, top = rectangle
    inside = landscape.sel(x=slice(left, right), y=slice(top, bottom))
    if min(inside.sizes["x"], inside.sizes["y"]) < 3:
        raise ParameterError(
            f"the rectangle {rectangle} holds {inside.sizes['y']} x {inside.sizes['x']} cells, expected at "
            "least 3 x 3; give left bottom right top in the CRS of the landscape"
        )
    return inside


def middle(landscape: xr.Dataset) -> tuple[float, float]:
    """Centre of the cell with fuel that lies nearest to the middle of the landscape."""
    burnable = landscape["burnable"].to_numpy()
    rows, cols = np.nonzero(burnable)
    distance = (rows - burnable.shape[0] / 2) ** 2 + (cols - burnable.shape[1] / 2) ** 2
    nearest = int(np.argmin(distance))
    return float(landscape["x"][cols[nearest]]), float(landscape["y"][rows[nearest]])


def grey_levels(frequency: np.ndarray, n_runs: int) -> np.ndarray:
    """Burn frequency in the paper's grey levels.

    The frequencies are sorted into 16 bins of equal width from 0 to their maximum; the bins get levels 256
    down to 16 in steps of 16, so that dark cells burn often. A frequency on the edge of two bins goes to the upper one:
    the runs are counted, so that no rounding decides.

    Parameters
    ----------
    frequency
        (rows, cols), NaN where there is no fuel.
    n_runs
        Runs of which it is the share.

    Returns
    -------
    numpy.ndarray
        (rows, cols) int32: 16 .. 256; 0 where there is no fuel.
    """
    counts = np.rint(np.nan_to_num(frequency).astype(np.float64) * n_runs).astype(np.int64)
    bins = np.minimum(GREY_LEVELS * counts // max(int(counts.max(initial=0)), 1), GREY_LEVELS - 1).astype(np.int32)
    return np.where(np.isnan(frequency), 0, 256 - 16 * bins)


def cut_table(experiment: LandscapeExperiment) -> pd.DataFrame:
    """Share of the cut cells in each density class: method, d_f, sparse, normal, dense."""
    import pandas as pd

    density = experiment.window["density"].to_numpy()
    rows = []
    for (label, budget), mask in experiment.breaks.items():
        cut = density[mask.to_numpy() > 0]
        row: dict[str, Any] = {"method": label, "d_f": budget, "cells_cut": cut.size}
        row |= {name: float(np.mean(cut == code)) for code, name in DENSITY.items() if code}
        rows.append(row)
    return pd.DataFrame(rows)
