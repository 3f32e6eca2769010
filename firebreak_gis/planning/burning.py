"""The fires that judge a plan: without and with its breaks, for each value at risk, and over the budgets."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis import memory
from firebreak_gis.breaks import select_breaks
from firebreak_gis.evaluation.curves import ByBudget, evaluate_fires
from firebreak_gis.landscape.lines import beside
from firebreak_gis.planning.budgets import default_budgets, few_budgets
from firebreak_gis.planning.designs import lines
from firebreak_gis.planning.timing import fire_seconds, ranking_seconds
from firebreak_gis.progress import Progress, part, silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.budgets import Sizes
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.ground_fires import burn_on

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.planning.designs import Design
    from firebreak_gis.planning.judging import Judging
    from firebreak_gis.planning.setting import Setting

    Laid = xr.DataArray | LineBreaks | np.ndarray | None

#: Rankings that every plan is judged against.
BASELINES = ("random", "flammability")
#: Shares of the time that the steps of a plan take where nobody looks.
USUAL: Mapping[str, float] = {"ranking": 6.0, "fires": 5.0, "curve without a clock": 4.0, "curve": 4.0}


@dataclass(frozen=True, eq=False)
class Burnt:
    """What the fires take.

    Parameters
    ----------
    before, after
        Burns of the same fires without and with the breaks, as `simulate` returns them.
    objectives
        By name, what each fire loses of single values at risk, without and with the breaks, (n_runs,) each.
    paper
        R(d_f) of the ranking and the baselines for fires that end by themselves and perfect breaks.
    evaluation
        The same under the fires that judge the plan; with a clock at a few budgets.
    """

    before: xr.Dataset
    after: xr.Dataset
    objectives: Mapping[str, tuple[np.ndarray, np.ndarray]]
    paper: xr.Dataset
    evaluation: xr.Dataset


def burnt_with(design: Design, judged: Judging, spans: Mapping[str, tuple[float, float]], progress: Progress) -> Burnt:
    """Burn the fires that judge a plan.

    Parameters
    ----------
    design
        The breaks.
    judged
        The fires, with what the breaks keep.
    spans
        From and to which share of the progress each of `USUAL` goes.
    progress
        Of the whole plan.
    """
    memory.give_back()  # a design leaves many small pieces
    setting, laid = design.setting, design.laid
    fires = fires_of(setting, judged)
    first, last = spans["fires"]
    half = (first + last) / 2
    before = fires(None, setting.value, part(progress, first, half, "without breaks: "))
    after = fires(laid, setting.value, part(progress, half, last, "with breaks: "))

    def lost(plane: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        bare, cut = (fires(breaks, plane, part(progress, last, last))["value_lost"] for breaks in (None, laid))
        return bare.to_numpy(), cut.to_numpy()

    network, planes = setting.network, setting.planes
    objectives = {name: lost(network.plane(plane, name)) for name, plane in planes.objectives.items()}
    known = Sizes()
    for breaks, burns in ((None, before), (laid, after)):
        known.keep(beside(breaks, setting.standing), burns["fire_size"].to_numpy())
    paper, evaluation = _curves(design, judged, known, spans, progress)
    return Burnt(before, after, objectives, paper, evaluation)


def fires_of(setting: Setting, judged: Judging) -> Callable[[Laid, np.ndarray | None, Progress], xr.Dataset]:
    """Burn those fires with any breaks beside those that stand: ``(breaks, value, progress)``, as `simulate` does."""
    ground = setting.ground

    def fires(breaks: Laid, value: np.ndarray | None, progress: Progress = silent) -> xr.Dataset:
        return burn_on(
            ground,
            judged.fires,
            breaks=beside(breaks, setting.standing),
            value=value,
            threads=setting.threads,
            progress=progress,
        )

    return fires


def _curves(
    design: Design, judged: Judging, known: Sizes, spans: Mapping[str, tuple[float, float]], progress: Progress
) -> tuple[xr.Dataset, xr.Dataset]:
    """R(d_f) without a clock and with perfect breaks, and under the fires that judge the plan, some of them known."""
    setting, method = design.setting, design.setting.request.design.method
    baselines = {
        name: rank(setting.network, name, stakes=setting.stakes, seed=judged.fires.seed) for name in _baselines(method)
    }
    rankings = {method: design.ranked, **baselines}
    paper = evaluate_fires(
        setting.network,
        rankings,
        judged.paper,
        budgets=design.budgets(few_budgets if design.EACH_ANEW else default_budgets),
        threads=setting.threads,
        progress=part(progress, *spans["curve without a clock"], "evaluate "),
    )
    if not judged.reburnt:
        return paper, paper
    evaluation = evaluate_fires(
        setting.network,
        {name: _beside_standing(ranked, setting) for name, ranked in rankings.items()},
        judged.fires,
        budgets=design.budgets(few_budgets),
        ground=setting.ground,
        known=known,
        threads=setting.threads,
        progress=part(progress, *spans["curve"], "evaluate with a clock: "),
    )
    return paper, evaluation


def _beside_standing(ranked: xr.DataArray | ByBudget, setting: Setting) -> xr.DataArray | ByBudget:
    """What a curve burns: where breaks stand already, those of each budget with them."""
    network, standing = setting.network, setting.standing
    if standing is None:
        return ranked
    if isinstance(ranked, ByBudget):
        return ByBudget(lambda budget: beside(ranked.breaks(budget), standing))
    return ByBudget(lambda budget: beside(select_breaks(ranked, budget=budget, burnable=network.burnable), standing))


def _baselines(method: str) -> list[str]:
    return [name for name in BASELINES if name != method]


def seconds_of(setting: Setting, rankings: int) -> dict[str, float]:
    """Seconds that each step of a plan takes, of which so many rankings are made, as a small part of it tells."""
    judged, method = setting.judged, setting.request.design.method
    network, threads, n_runs = setting.network, setting.threads, judged.fires.n_runs
    walls = {"stakes": setting.stakes, "lines": lines.asked(setting.request.design), **setting.about}
    ranking = ranking_seconds(network, method, **walls)
    curves = 1 + len(_baselines(method))
    levels = (few_budgets(0.1).size - 1) * judged.reburnt  # what burns where nothing is cut is known
    paper = each = fire_seconds(Ground(network), judged.paper, passes=curves, threads=threads)
    if judged.reburnt:
        # A pass of a curve draws for all levels at once; breaks make fires smaller, which is left out.
        passes = 2 + curves * levels
        each = fire_seconds(setting.ground, judged.fires, passes=passes, value=setting.value, threads=threads)
    return {
        "ranking": ranking * rankings,
        "fires": 2 * n_runs * each,
        "curve without a clock": curves * n_runs * paper,
        "curve": curves * levels * n_runs * each,
    }
