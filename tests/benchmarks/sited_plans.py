"""How much of a plan lies beside the lines of the ground, and what it saves, with siting off and on.

Run `python -m tests.benchmarks.sited_plans sample rhodes40 rhodes20 vilopriu`; but for the sample the landscapes lie
beside the clone. Fires are those of `firebreak plan` in calm air: 8 h in the median, breaks of which each 400 m holds
in 0.47 of fires; all plans of a landscape meet the same ones. "Beside" is within one cell of a ridge, a river or the
edge of the fuel; valley bottoms stand apart, since no map says that water runs in them.

A plan is METHOD:STRENGTH, with the strength of the siting; `lines` are at most 30 m wide and tried out on other fires,
as those of `plan`, the other methods cut cells and know no clock. All plans take the same area and are set beside
the first one.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

import firebreak_gis as fb
from firebreak_gis.breaks import Budget
from firebreak_gis.landscape.footprints import footprints
from firebreak_gis.landscape.sited import STRENGTH, SitingRequest
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.placement.trial import Trial
from firebreak_gis.planning.design import design
from firebreak_gis.planning.designs.lines import USUAL
from firebreak_gis.planning.judging import Scene
from firebreak_gis.planning.line_design import design_lines
from firebreak_gis.planning.weather import SpreadRequest
from firebreak_gis.simulation.fires import burn, resolved
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import StakePlanes

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared" / "data"
#: Whole cells with all ground alike, and the plans that are set beside them: without siting, by default, stronger.
PLANS = [f"{method}:{strength:g}" for method in ("dissection", "compartments", "lines") for strength in (0.0, STRENGTH)]
PLANS += ["lines:3", "lines:6", "lines:10"]
BUDGETS = (0.03, 0.05, 0.1)


def landscape(name: str):
    if name.startswith("sample"):
        layers = [ROOT / "sample_data" / f"{layer}.tif" for layer in ("dem", "vegetation", "density")]
        return fb.read_landscape(*map(str, layers))
    if name.startswith("rhodes"):
        layers = [SHARED / "rhodes_20m" / f"rhodes_{layer}.tif" for layer in ("dem", "vegetation", "density")]
        return fb.read_landscape(*map(str, layers), resolution=float(name.removeprefix("rhodes")))
    files = [SHARED / "vilopriu_2013" / f"{layer}.tif" for layer in ("elevation", "fuels")]
    return fb.read_landscape(*map(str, files), legend="scott_burgan_40", unknown="nonburnable")


def measure(name: str, plans: list[str], n_runs: int) -> None:
    """Print a row a plan of one landscape."""
    land = landscape(name)
    scene = Scene.of(land, SpreadRequest(), None, Account())
    network, height = scene.network, land["elevation"].to_numpy()
    cell = network.grid.cell_size
    fires = FireRequest(None, "each", n_runs, 77)
    judged = scene.judging(replace(fires, ignitions=resolved(network, fires)), timeless=False)
    ground = scene.ground(judged, network, None)

    def mean_fire(breaks=None) -> float:
        return float(burn(ground.network, judged.fires, breaks=breaks)["fire_size"].mean())

    untreated, first = mean_fire(), {}
    for method, strength in (plan.split(":") for plan in plans):
        sited = SitingRequest(float(strength)).on(StakePlanes(), network, height)
        _, stakes = sited.planes.on(network)
        strict = np.logical_or.reduce([mask for line, mask in sited.lines.items() if line != "valley"])
        every = strict | sited.lines.get("valley", np.False_)
        trial = Trial(ground, replace(judged.fires, seed=0), stakes, 0)
        for budget in map(Budget, BUDGETS):
            if method == "lines":
                found = design_lines(network, stakes=stakes, budget=budget, width=min(USUAL, cell), trial=trial)
                prints = footprints(found.walls.iloc[: found.bought(budget)], network.grid)
                breaks, cells, length = found.breaks(budget), prints.cell, prints.part
            else:
                priority = design(network, method, stakes=stakes, budget=budget, elevation=height)
                breaks = fb.select_breaks(priority, budget=budget, burnable=network.burnable)
                cells = np.flatnonzero(breaks.to_numpy() > 0)
                length = np.ones(len(cells))
            near, all_near = (float(length[on.ravel()[cells]].sum()) for on in (strict, every))
            whole = float(length.sum())
            saved = 1.0 - mean_fire(breaks) / untreated
            known_near, known_saved = first.setdefault(budget.amount, (near, saved))
            print(
                f"| {name} | {method} | {strength} | {100 * budget.amount:g} % | {whole * cell / 1000:.0f} | "
                f"{near * cell / 1000:.1f}, {100 * near / whole:.0f} % | x {near / known_near:.1f} | "
                f"{100 * all_near / whole:.0f} % | {100 * saved:.1f} % | {100 * (saved / known_saved - 1):+.0f} % |",
                flush=True,
            )


def main() -> None:
    """Print a row a plan."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("landscapes", nargs="+")
    parser.add_argument("--plans", nargs="+", metavar="METHOD:STRENGTH", default=PLANS)
    parser.add_argument("--runs", type=int, default=3000)
    given = parser.parse_args()
    for place in given.landscapes:
        measure(place, given.plans, given.runs)


if __name__ == "__main__":
    main()
