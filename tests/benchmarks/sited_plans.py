"""How much of a plan lies beside the lines of the ground, and what it saves, with siting off and on.

Run `python -m tests.benchmarks.sited_plans sample rhodes40 rhodes20 vilopriu`; but for the sample the landscapes lie
beside the clone. Fires are those of `firebreak plan` in calm air: 300, 8 h in the median, breaks of which each 400 m
holds in 0.47 of fires; all plans of a landscape meet the same ones. "Beside" is within one cell of a ridge, a river or
the edge of the fuel; valley bottoms stand apart, since no map says that water runs in them.

With `--lines STRENGTH ...` plans of lines, at most 30 m wide, for each strength of the siting, beside cells without,
and 600 fires.
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


def landscape(name: str):
    if name.startswith("sample"):
        layers = [ROOT / "sample_data" / f"{layer}.tif" for layer in ("dem", "vegetation", "density")]
        return fb.read_landscape(*map(str, layers))
    if name.startswith("rhodes"):
        layers = [SHARED / "rhodes_20m" / f"rhodes_{layer}.tif" for layer in ("dem", "vegetation", "density")]
        return fb.read_landscape(*map(str, layers), resolution=float(name.removeprefix("rhodes")))
    files = [SHARED / "vilopriu_2013" / f"{layer}.tif" for layer in ("elevation", "fuels")]
    return fb.read_landscape(*map(str, files), legend="scott_burgan_40", unknown="nonburnable")


def measure(name: str, method: str, budgets: tuple[float, ...], n_runs: int) -> None:
    land = landscape(name)
    scene = Scene.of(land, SpreadRequest(), None, Account())
    network = scene.network
    fires = replace(FireRequest(None, "each", n_runs, 1), ignitions=None)
    fires = replace(fires, ignitions=resolved(network, fires))
    judged = scene.judging(fires, timeless=False)
    ground = scene.ground(judged, network, None)

    def mean_fire(breaks=None) -> float:
        burnt = burn(ground.network, judged.fires, breaks=breaks, weather=ground.weather, barriers=ground.barriers)
        return float(burnt["fire_size"].mean())

    untreated, height = mean_fire(), land["elevation"].to_numpy()
    for budget in budgets:
        row = {}
        for strength in (0.0, STRENGTH):
            sited = SitingRequest(strength).on(StakePlanes(), network, height)
            _, stakes = sited.planes.on(network)
            priority = design(network, method, stakes=stakes, budget=Budget(budget), elevation=height)
            breaks = fb.select_breaks(priority, budget=budget, burnable=network.burnable)
            cut = breaks.to_numpy() > 0
            strict = np.logical_or.reduce([mask for line, mask in sited.lines.items() if line != "valley"])
            every = strict | sited.lines.get("valley", np.False_)
            row[strength] = (strict[cut].mean(), every[cut].mean(), 1.0 - mean_fire(breaks) / untreated)
        (near, all_near, saved), (sited_near, sited_all, sited_saved) = row[0.0], row[STRENGTH]
        print(
            f"| {name} | {method} | {100 * budget:g} % | {100 * near:.0f} % | {100 * sited_near:.0f} %, "
            f"x {sited_near / near:.1f} | {100 * all_near:.0f} % | {100 * sited_all:.0f} % | {100 * saved:.1f} % | "
            f"{100 * sited_saved:.1f} % ({100 * (sited_saved / saved - 1):+.0f} %) |",
            flush=True,
        )


def measure_lines(name: str, strengths: list[float], budgets: tuple[float, ...], n_runs: int) -> None:
    land = landscape(name)
    scene = Scene.of(land, SpreadRequest(), None, Account())
    network, height = scene.network, land["elevation"].to_numpy()
    fires = FireRequest(None, "each", n_runs, 77)
    judged = scene.judging(replace(fires, ignitions=resolved(network, fires)), timeless=False)
    ground = scene.ground(judged, network, None)

    def mean_fire(breaks=None) -> float:
        return float(burn(ground.network, judged.fires, breaks=breaks)["fire_size"].mean())

    untreated = mean_fire()
    for strength in [None, *strengths]:
        sited = SitingRequest(strength or 0.0).on(StakePlanes(), network, height)
        _, stakes = sited.planes.on(network)
        near = np.logical_or.reduce([mask for line, mask in sited.lines.items() if line != "valley"])
        trial = Trial(ground, replace(judged.fires, seed=0), stakes, 0)
        for budget in map(Budget, budgets):
            if strength is None:
                priority = design(network, "dissection", stakes=stakes, budget=budget, elevation=height)
                breaks = fb.select_breaks(priority, budget=budget, burnable=network.burnable)
                beside = near[breaks.to_numpy() > 0].mean()
            else:
                width = min(USUAL, network.grid.cell_size)
                found = design_lines(network, stakes=stakes, budget=budget, width=width, trial=trial)
                prints = footprints(found.walls.iloc[: found.bought(budget)], network.grid)
                breaks, beside = found.breaks(budget), prints.part[near.ravel()[prints.cell]].sum() / prints.part.sum()
            saved = 1.0 - mean_fire(breaks) / untreated
            kind = "cells, siting 0" if strength is None else f"lines, siting {strength:g}"
            print(f"| {name} | {kind} | {budget.amount:g} | {100 * beside:.0f} % | {100 * saved:.1f} % |", flush=True)


def main() -> None:
    """Print a row a plan."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("landscapes", nargs="+")
    parser.add_argument("--lines", type=float, nargs="+", metavar="STRENGTH")
    given = parser.parse_args()
    for place in given.landscapes:
        if given.lines:
            measure_lines(place, given.lines, (0.03, 0.05, 0.1), 600)
        else:
            measure(place, "dissection", (0.03, 0.05, 0.1), 300)
            measure(place, "compartments", (0.05,), 300)


if __name__ == "__main__":
    main()
