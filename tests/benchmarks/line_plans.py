"""Whole cells against lines of equal area, all tried out on fires: ``python -m tests.benchmarks.line_plans sample``.

Every plan of a landscape meets the same fires (8 h in the median, wind 5 m/s from the north-west) before breaks that
are perfect, of which each 400 m holds in 0.47 of fires, or which hold by width and flames. Lines are as wide as a cell,
and under flames also as wide as the fires chose. "Beside" is the share of the length within one cell of a ridge, a
river or the edge of the fuel. But for the sample the landscapes lie beside the clone.

Cells fail by blocks of the map and lines by lengths, so with `--lengths` the last column has what cells save where each
wall fails by lengths along it, as lines do. Those are walls that were not tried out on fires.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from unittest import mock

import numpy as np

import firebreak_gis as fb
from firebreak_gis.breaks import Budget
from firebreak_gis.landscape.footprints import footprints
from firebreak_gis.landscape.sited import STRENGTH, SitingRequest
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.placement.dissection import dissect, sequence
from firebreak_gis.placement.trial import Trial
from firebreak_gis.planning.design import design
from firebreak_gis.planning.judging import Scene
from firebreak_gis.planning.line_design import design_lines
from firebreak_gis.planning.weather import SpreadRequest
from firebreak_gis.progress import silent
from firebreak_gis.simulation import holding
from firebreak_gis.simulation.fires import burn, resolved
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import StakePlanes
from tests.benchmarks.sited_plans import landscape

HOLDS = {"perfect": holding.Hold(), "hold .47": holding.Hold(holding.FIELD), "flame": holding.Hold(None)}


def along_walls(network: fb.SpreadNetwork, stakes: fb.Stakes, length: float) -> tuple[np.ndarray, np.ndarray]:
    """Cells of walls in their order, and the stretch along its wall of each cell of the map."""
    cuts = dissect(network, stakes, progress=silent)
    stretch = np.zeros(network.burnable.size, np.uint32)
    seen = np.zeros(stretch.size, bool)
    cells = []
    size = network.grid.cell_size
    for k, i in enumerate(sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])):
        wall = cuts[i].cells
        row, col = np.divmod(wall, network.shape[1])
        run = size * np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(row), np.diff(col)))])
        new = ~seen[wall]
        count = max(round(run[-1] / length), 1)
        stretch[wall[new]] = 1000 * k + np.minimum(np.floor(run[new] / max(run[-1], 1.0) * count), count - 1) + 1
        seen[wall] = True
        cells.append(wall[new & network.burnable.ravel()[wall]])
    return np.concatenate(cells), stretch.reshape(network.shape)


def main() -> None:
    """Print a row a plan."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("landscapes", nargs="+")
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--budgets", type=float, nargs="+", default=[0.03, 0.05, 0.10])
    parser.add_argument("--holds", nargs="+", choices=list(HOLDS), default=list(HOLDS))
    parser.add_argument("--strengths", type=float, nargs="+", default=[0.0, STRENGTH], help="of siting")
    parser.add_argument("--lengths", action="store_true", help="cells that fail by lengths, too")
    given = parser.parse_args()
    for name in given.landscapes:
        measure(name, given)


def measure(name: str, given: argparse.Namespace) -> None:
    land, n_runs = landscape(name), given.runs
    scene = Scene.of(land, SpreadRequest(wind_speed=5.0, wind_from=315.0), None, Account())
    network, height = scene.network, land["elevation"].to_numpy()
    size, picks = network.grid.cell_size, np.random.default_rng(0).integers(0, n_runs, (400, n_runs))
    fires = FireRequest(None, "each", n_runs, 1)
    fires = replace(fires, ignitions=resolved(network, fires))
    for told in given.holds:
        judged = scene.judging(replace(fires, hold=HOLDS[told]))
        ground = scene.ground(judged, network, None)

        def sizes(breaks=None, judged=judged, ground=ground):
            return burn(ground.network, judged.fires, breaks=breaks)["fire_size"].to_numpy().astype(float)

        bare = sizes()

        def saved(left, bare=bare):
            each = 100 * (1 - left[picks].mean(axis=1) / bare[picks].mean(axis=1))
            return f"{100 * (1 - left.mean() / bare.mean()):.1f} +- {each.std():.1f}"

        for strength in given.strengths:
            sited = SitingRequest(strength).on(StakePlanes(), network, height)
            _, stakes = sited.planes.on(network)
            near = np.logical_or.reduce([mask for line, mask in sited.lines.items() if line != "valley"])
            trial = Trial(ground, judged.fires, stakes, 0)
            by_lengths = along_walls(network, stakes, 400.0) if given.lengths and told == "hold .47" else None
            for d_f in given.budgets:
                budget = Budget(d_f)
                ranked = design(network, "dissection", stakes=stakes, budget=budget, elevation=height, trial=trial)
                cut = fb.select_breaks(ranked, budget=budget, burnable=network.burnable).to_numpy() > 0
                head = f"| {name} | {told} | {strength:g} | {100 * d_f:g} % |"
                row = f"{head} cells {size:g} m | {100 * cut.mean() / network.burnable.mean():.2f} % | "
                row += f"{100 * near[cut].mean():.0f} % | {saved(sizes(cut))} |"
                if by_lengths is not None:
                    walls, stretch = by_lengths
                    first = np.zeros(network.shape, bool)
                    first.ravel()[walls[: round(d_f * network.n_burnable)]] = True
                    with mock.patch.object(holding, "stretches", lambda *_, stretch=stretch: stretch):
                        row += f" {saved(sizes(first))} |"
                print(row, flush=True)
                for width in (size, None) if told == "flame" else (size,):
                    found = design_lines(network, stakes=stakes, budget=budget, width=width, trial=trial)
                    built = found.walls.iloc[: found.bought(budget)]
                    prints = footprints(built, network.grid)
                    beside = prints.part[near.ravel()[prints.cell]].sum() / prints.part.sum()
                    chosen = f"lines {found.width:g} m{'' if width else ' (auto)'}"
                    left = saved(sizes(found.breaks(budget)))
                    print(
                        f"{head} {chosen} | {100 * found.share(budget):.2f} % | {100 * beside:.0f} % | {left} | "
                        f"{found.told}",
                        flush=True,
                    )


if __name__ == "__main__":
    main()
