"""How far rankings and the local search are from the best plan: ``python -m tests.benchmarks.yardstick``.

Windows of 20 x 20 cells with a fixed set of fires each. The cells where fires start are protected, since else the best
plan would be to cut just those. The optimum is found by integer programming (`tests.twins.optimum`); where that is not
proven in time, its bound is given too. Rankings know the network, not the fires; the local search and the optimum
know both.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.ndimage import gaussian_filter

from firebreak_gis import plugins
from firebreak_gis.breaks import Budget
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.fires import Fires, design_fires, losses
from firebreak_gis.planning.design import design
from firebreak_gis.planning.refinement import refine
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes
from tests.twins.optimum import Optimum, optimum

SIDE = 20
#: Parameters that fit the small windows.
OPTIONS = {"splat": {"width": 2, "length": 5, "overlap": 1}, "dfpz": {"width": 1}}
SEARCHED = "dissection + local search"


class Window(NamedTuple):
    """A small problem: at most `count` cells are cut."""

    name: str
    network: SpreadNetwork
    stakes: Stakes
    fires: Fires
    count: int

    def lost(self, cut: np.ndarray) -> float:
        return float(losses(self.network, self.stakes, cut, self.fires, progress=silent).mean())

    def first(self, priority: np.ndarray) -> np.ndarray:
        """Cells that the budget buys."""
        position = np.argsort(np.argsort(-priority.ravel(), kind="stable"), kind="stable")
        return (position < self.count).reshape(priority.shape) & (priority > -np.inf)


def window(name: str, network: SpreadNetwork, *, n_fires: int, count: int, seed: int = 1) -> Window:
    fires = design_fires(network, Stakes(network), n_runs=n_fires, seed=seed)
    starts = np.zeros(network.burnable.size, bool)
    starts[fires.cells] = True
    return Window(name, network, Stakes(network, protected=starts.reshape(network.shape)), fires, count)


def artificial(scale: float, seed: int) -> SpreadNetwork:
    """Correlated probabilities with gaps in a fifth of the land; fires just hold at scales near .25."""
    random = np.random.default_rng(seed)
    field = gaussian_filter(random.standard_normal((SIDE, SIDE)), 2, mode="wrap")
    field = (field - field.min()) / np.ptp(field)
    gaps = gaussian_filter(random.standard_normal((SIDE, SIDE)), 1.5, mode="wrap")
    probability = np.clip(scale * (0.5 + field) * np.ones((8, 1, 1)), 0, 1).astype(np.float32)
    return SpreadNetwork(probability, burnable=gaps > np.quantile(gaps, 0.2))


def artificial_windows(n: int) -> Iterator[Window]:
    for i in range(n):
        scale = (0.22, 0.25, 0.28)[i % 3]
        yield window(f"artificial {scale}, {i}", artificial(scale, 100 + i), n_fires=20, count=8)


def rhodes_windows(n: int, folder: Path) -> Iterator[Window]:
    """Windows of Rhodes in cells of 40 m (every second row and column), where 150 to 330 cells burn."""
    from firebreak_gis import read_landscape, spread_network

    landscape = read_landscape(*(folder / f"rhodes_{name}.tif" for name in ("dem", "vegetation", "density")))
    whole = spread_network(landscape.isel(y=slice(None, None, 2), x=slice(None, None, 2)))
    random = np.random.default_rng(0)
    while n:
        row, col = (int(random.integers(0, size - SIDE)) for size in whole.shape)
        area = np.s_[row : row + SIDE, col : col + SIDE]
        burnable = whole.burnable[area]
        if 150 < burnable.sum() < 330:
            n -= 1
            network = SpreadNetwork(whole.probability[(slice(None), *area)], burnable=burnable)
            yield window(f"Rhodes, row {row}, column {col}", network, n_fires=8, count=10)


def plans(problem: Window, *, moves: int = 800) -> dict[str, np.ndarray]:
    """Cells that each ranking cuts, and those of the local search."""
    cuts = {}
    network, stakes = problem.network, problem.stakes
    for method in plugins.names("ranking"):
        budget = Budget(problem.count / network.n_burnable)
        made = design(network, method, stakes=stakes, budget=budget, params=OPTIONS.get(method)).values
        cuts[method] = problem.first(made)
        if method == "dissection":
            cuts[SEARCHED] = searched(problem, made, moves=moves)
    for method in ("bonacich", "betweenness"):
        again = rank(network, method, stakes=stakes, recompute_every=1e-6).values
        cuts[f"{method}, cell by cell"] = problem.first(again)
    return cuts


def searched(problem: Window, priority: np.ndarray, *, moves: int) -> np.ndarray:
    return problem.first(
        refine(
            problem.network,
            problem.stakes,
            priority,
            budget=Budget(float(problem.count), "cost"),
            fires=problem.fires,
            moves=moves,
            progress=silent,
        )
    )


def best(problem: Window, *, seconds: float) -> Optimum:
    return optimum(problem.network, problem.stakes, problem.fires, budget=problem.count, seconds=seconds)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rhodes", type=Path, help="folder of rhodes_dem.tif, rhodes_vegetation.tif, ...")
    parser.add_argument("--windows", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=60.0, help="for each optimum")
    parser.add_argument("--output", type=Path, help="JSON of every window")
    options = parser.parse_args()
    half = options.windows // 2 if options.rhodes else 0
    problems = [*artificial_windows(options.windows - half)]
    if half:
        problems += rhodes_windows(half, options.rhodes)
    rows = []
    for problem in problems:
        answer = best(problem, seconds=options.seconds)
        lost = {name: problem.lost(cut) for name, cut in plans(problem).items()}
        none = problem.lost(np.zeros(problem.network.shape, bool))
        rows.append(
            {
                "window": problem.name,
                "none": none,
                "optimum": answer.lost,
                "bound": answer.bound,
                "proven": answer.proven,
                "lost": lost,
            }
        )
        print(
            f"{problem.name}: none {none:.4f}, optimum {answer.lost:.4f} "
            f"({'proven' if answer.proven else f'bound {answer.bound:.4f}'}), {SEARCHED} {lost[SEARCHED]:.4f}",
            flush=True,
        )
        if options.output:
            options.output.write_text(json.dumps(rows, indent=1))
    print("\n" + table(rows))


def table(rows: list[dict]) -> str:  # type: ignore[type-arg]
    """Means over windows; the best plan known stands for the optimum where that is not proven."""
    names = list(rows[0]["lost"])
    proven = [row["proven"] for row in rows]
    known = np.array([min(row["optimum"], *row["lost"].values()) for row in rows])
    none = np.array([row["none"] for row in rows])
    bound = np.array([row["optimum"] if row["proven"] else row["bound"] for row in rows])
    lines = [
        f"{len(rows)} windows, {sum(proven)} optima proven",
        f"{'plan':28} loss / best known  loss / bound  loss / proven optimum  share of the possible saving",
    ]
    for name in sorted(names, key=lambda name: np.mean([row["lost"][name] for row in rows] / known)):
        lost = np.array([row["lost"][name] for row in rows])
        lines.append(
            f"{name:28} {np.mean(lost / known):17.3f}  {np.mean(lost / bound):12.3f}  "
            f"{np.mean((lost / bound)[proven]):21.3f}  {np.mean((none - lost) / (none - known)):28.2f}"
        )
    return "\n".join(lines)


if __name__ == "__main__":
    main()
