"""How far plans are from the best one where fires have a clock: ``python -m tests.benchmarks.timed_yardstick``.

Windows of 14 x 14 cells with a fixed set of fires that burn for a while; travel times are whole minutes. The cells
where fires start are protected. The plan that loses least is found by integer programming, and its bound where that is
not proven in time (`tests.twins.timed_optimum`). It knows the fires, which the plans of the program do not: they are
made for the network, the duration and the budget. So all are judged twice: on the fires that the optimum knows, and on
fresh ones, which none of them knows.
"""

from __future__ import annotations

import argparse
from typing import NamedTuple

import numpy as np
from scipy.ndimage import gaussian_filter

from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.trial import Trial
from firebreak_gis.planning.design import design
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes
from tests.twins.timed_optimum import TimedFire, drawn, lost_cells, timed_optimum

SIDE, COUNT, N_FIRES, FRESH, MINUTES = 14, 8, 12, 400, 12
#: By label: method, and whether designs are tried out on fires with a clock.
PLANS = {
    "dissection, tried out (default)": ("dissection", True),
    "dissection, without a clock": ("dissection", False),
    "influence": ("influence", True),
    "downstream": ("downstream", False),
    "betweenness": ("betweenness", False),
    "flammability": ("flammability", False),
    "random": ("random", False),
}


class Window(NamedTuple):
    """A small problem: at most `COUNT` cells are cut."""

    network: SpreadNetwork
    stakes: Stakes
    fires: list[TimedFire]
    fresh: list[TimedFire]


def window(seed: int) -> Window:
    """Correlated probabilities and travel times of 1 to 3 minutes, with gaps in a fifth of the land."""
    random = np.random.default_rng(seed)
    field = gaussian_filter(random.standard_normal((SIDE, SIDE)), 2, mode="wrap")
    field = (field - field.min()) / np.ptp(field)
    gaps = gaussian_filter(random.standard_normal((SIDE, SIDE)), 1.5, mode="wrap")
    probability = np.clip((0.3 + 0.4 * field) * np.ones((8, 1, 1)), 0, 1).astype(np.float32)
    times = 60.0 * np.clip(np.round(3.4 - 2.8 * field), 1, 3) * np.ones((8, 1, 1))
    network = SpreadNetwork(probability, travel_time=times, burnable=gaps > np.quantile(gaps, 0.2))
    fires = drawn(network, n=N_FIRES, minutes=MINUTES, seed=seed)
    kept = np.zeros(network.shape, bool)
    kept.ravel()[[fire.start for fire in fires]] = True
    stakes = Stakes(network, protected=kept)
    return Window(network, stakes, fires, drawn(network, n=FRESH, minutes=MINUTES, seed=10_000 + seed))


def cut_by(problem: Window, method: str, *, tried: bool) -> np.ndarray:
    network, stakes = problem.network, problem.stakes
    budget = Budget(float(COUNT) / network.n_burnable)
    fires = FireRequest(duration=as_duration(f"{MINUTES}min"))
    trial = Trial(Ground(network), fires, stakes, seed=0) if tried else None
    made = design(network, method, stakes=stakes, budget=budget, trial=trial)
    cut: np.ndarray = select_breaks(made, budget=budget, burnable=network.burnable).to_numpy() > 0
    return cut


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--windows", type=int, default=10)
    parser.add_argument("--seconds", type=float, default=30.0, help="for each optimum")
    options = parser.parse_args()
    known: dict[str, list[float]] = {}
    fresh: dict[str, list[float]] = {}
    proven = 0
    for k in range(options.windows):
        problem = window(100 + k)
        best = timed_optimum(problem.network, problem.stakes, problem.fires, budget=COUNT, seconds=options.seconds)
        cuts = {name: cut_by(problem, method, tried=tried) for name, (method, tried) in PLANS.items()}
        cuts |= {"best found for the fires known": best.cut, "nothing cut": np.zeros(problem.network.shape, bool)}
        proven += best.proven
        for name, cut in cuts.items():
            lost = np.mean([lost_cells(problem.network, fire, cut) for fire in problem.fires])
            assert lost >= best.bound * (1 - 1e-6), name
            known.setdefault(name, []).append(float(lost) / best.bound)
            fresh.setdefault(name, []).append(
                float(np.mean([lost_cells(problem.network, fire, cut) for fire in problem.fresh]))
            )
        print(
            f"window {k}: bound {best.bound:.2f} cells a fire, best {best.lost:.2f}, proven {best.proven}", flush=True
        )
    bare = np.array(fresh["nothing cut"])
    print(f"\n{options.windows} windows, {proven} optima proven")
    print("| plan | loss / bound | saved of fresh fires |\n|---|---|---|")
    for name in sorted(known, key=lambda name: np.mean(known[name])):
        print(f"| {name} | {np.mean(known[name]):.2f} | {100 * np.mean(1 - np.array(fresh[name]) / bare):.0f} % |")


if __name__ == "__main__":
    main()
