"""Goals: what a plan is made for, and what it then does for the others.

Plans are made for the expected loss. For the mean of the worst tenth of the fires (CVaR, Rockafellar and Uryasev 2000,
doi 10.21314/JOR.2000.038) only those starts count from which such fires come. Which these are depends on the breaks,
so fires of the design are burnt, the starts of the worst tenth found, and the plan made again with ignitions moved
there, in whole or in half; then once more with the breaks of the best. That of the least worst tenth is taken, the
plan for the mean among them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeVar

import numpy as np

from firebreak_gis.evaluation.measures import BOUNDS, WORST, resamples, worst_mean
from firebreak_gis.landscape.lines import beside
from firebreak_gis.progress import Progress, part
from firebreak_gis.stakes import Stakes

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.ignitions import Ignitions
    from firebreak_gis.simulation.request import FireRequest

#: What a plan is made for.
Goal = Literal["mean", "worst-tenth"]
#: Fires of the design, at least.
_RUNS = 300
#: Shares of the ignitions that are moved to the starts of the worst tenth.
_MOVED = (1.0, 0.5)
#: How many plans are designed for the worst tenth, of which the best is taken.
N_DESIGNS = 1 + 2 * len(_MOVED)

D = TypeVar("D", bound="Laid")


class Laid(Protocol):
    """Breaks of any kind."""

    @property
    def laid(self) -> xr.DataArray | LineBreaks | None:
        """As fires meet them; None for none."""


def for_worst_tenth(
    network: SpreadNetwork,
    stakes: Stakes,
    design: Callable[[Stakes, Progress], D],
    fires: FireRequest,
    ground: Ground,
    *,
    value: np.ndarray | None = None,
    standing: np.ndarray | None = None,
    threads: int | None = None,
    progress: Progress,
) -> D:
    """Plan for the worst tenth of the fires.

    Parameters
    ----------
    network, stakes
        What is planned for.
    design
        Makes the plan for any stakes.
    fires
        What the plan is judged by, with where they start; the fires of the design have other draws.
    ground
        Where they burn.
    value
        (rows, cols) lost where a cell burns; None: its area.
    standing
        (rows, cols) bool: cells of breaks that stand already.
    threads, progress
        As in `simulate`.

    Returns
    -------
    The design of the least worst tenth.
    """
    from firebreak_gis.kernels.draws import seed_for
    from firebreak_gis.simulation.fires import burn, resolved

    own = replace(fires, seed=seed_for(fires.seed, "design"), n_runs=max(_RUNS, fires.n_runs))
    start = resolved(network, own)
    own = replace(own, ignitions=start)
    steps = 2 + 2 * len(_MOVED) * 2
    done = 0

    def step() -> Progress:
        nonlocal done
        done += 1
        return part(progress, (done - 1) / steps, done / steps)

    def lost(plan: D) -> np.ndarray:
        run = burn(
            ground.network,
            own,
            breaks=beside(plan.laid, standing),
            value=value,
            weather=ground.weather,
            barriers=ground.barriers,
            threads=threads,
            progress=step(),
        )
        return np.asarray(run["fire_size" if value is None else "value_lost"].to_numpy(), float)

    best = design(stakes, step())
    losses = lost(best)
    for _ in range(2):
        tail = tail_ignition(stakes, start, losses, network)
        for share in _MOVED:
            mixed = (1.0 - share) * stakes.ignition / stakes.ignition.sum() + share * tail
            plan = design(stakes.with_ignition(network, mixed), step())
            found = lost(plan)
            if worst_mean(found) < worst_mean(losses):
                best, losses = plan, found
    return best


def tail_ignition(stakes: Stakes, start: Ignitions, losses: np.ndarray, network: SpreadNetwork) -> np.ndarray:
    """How likely a fire of the worst tenth starts in each cell, (rows, cols), sum 1.

    The ignitions times the share of the starts near a cell that led to such a fire; near is a Gaussian wide enough to
    hold some.
    """
    from scipy.ndimage import gaussian_filter

    count = max(1, round(WORST * losses.size))
    worst = np.argsort(-losses, kind="stable")[:count]
    sigma = max(0.5 * float(np.sqrt(network.n_burnable / count)), 1.0)
    planes = []
    for runs in (worst, np.arange(losses.size)):
        plane = np.zeros(network.burnable.size)
        for run in runs.tolist():
            cells = start.cells[start.starts[run] : start.starts[run + 1]]
            np.add.at(plane, cells, 1.0 / max(cells.size, 1))
        planes.append(gaussian_filter(plane.reshape(network.shape), sigma, mode="constant"))
    share = np.divide(planes[0], planes[1], out=np.zeros(network.shape), where=planes[1] > 1e-12)
    tail = stakes.ignition * share
    return np.asarray(tail / tail.sum()) if tail.sum() > 0 else stakes.ignition / stakes.ignition.sum()


def goals_table(
    losses: Mapping[str, tuple[np.ndarray, np.ndarray]], *, planned: str, goal: Goal, seed: int
) -> pd.DataFrame:
    """What a plan does for every goal.

    Parameters
    ----------
    losses
        By name, what each fire loses without and with the breaks, (n_runs,) each, the same fires.
    planned, goal
        Loss and goal that it was made for.
    seed
        Of the bootstrap.

    Returns
    -------
    pandas.DataFrame
        Two rows a loss, of the mean fire and of the worst tenth: `loss`, `of` (`mean`, `worst-tenth`), `planned_for`,
        `without_breaks`, `with_breaks`, `saved_share` with `_low` and `_high`, the ends of its 95 % interval (bootstrap
        over pairs of fires); NaN where nothing is lost.
    """
    import pandas as pd

    rows: list[dict[str, Any]] = []
    for name, (before, after) in losses.items():
        picks = resamples(before.size, seed)
        for of, measure in (("mean", _mean), ("worst-tenth", worst_mean)):
            bare, cut = float(measure(before)), float(measure(after))
            ends = np.array([np.nan, np.nan])
            if bare > 0:
                drawn, left = measure(before[picks]), measure(after[picks])
                ends = np.percentile(1.0 - np.divide(left, drawn, out=np.ones_like(left), where=drawn > 0), BOUNDS)
            rows.append(
                {
                    "loss": name,
                    "of": of,
                    "planned_for": name == planned and of == goal,
                    "without_breaks": bare,
                    "with_breaks": cut,
                    "saved_share": 1.0 - cut / bare if bare > 0 else np.nan,
                    "saved_share_low": float(ends[0]),
                    "saved_share_high": float(ends[1]),
                }
            )
    return pd.DataFrame(rows)


def _mean(runs: np.ndarray) -> np.ndarray:
    return np.asarray(runs.mean(axis=-1))


def goals_told(table: pd.DataFrame) -> str:
    """Say in one sentence what a plan saves of everything; its own goal first."""
    rows = table.sort_values("planned_for", ascending=False, kind="stable").dropna(subset="saved_share")
    words = [
        f"{100 * row['saved_share']:.3g} % of the {row['loss']} in the "
        + ("mean fire" if row["of"] == "mean" else "worst tenth")
        + f" ({100 * row['saved_share_low']:.3g} to {100 * row['saved_share_high']:.3g})"
        for row in rows.to_dict("records")
    ]
    return f"Saved, what the plan was made for first: {'; '.join(words)}." if words else ""
