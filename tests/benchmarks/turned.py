"""What a plan of lines saves and costs on a turned map: `python -m tests.benchmarks.turned DEM VEGETATION DENSITY`.

The landscape, its wind and the places where fires start are turned together, by 30 and 45 degrees; the lattice is not.
What then differs is the lattice's doing: that of the walls, and that of the fires, which are told apart by the burnt
area without breaks. Whole cells are beside the lines. The last column is the standard error of what is saved. At last
comes the length of line that saves some shares of the burnt area, read off the plans of several budgets.
"""

from __future__ import annotations

import argparse

import geopandas as gpd
import numpy as np
import xarray as xr
from affine import Affine
from scipy.ndimage import map_coordinates

import firebreak_gis as fb
from firebreak_gis.breaks import Budget
from firebreak_gis.grid import Grid
from firebreak_gis.placement.dissection import sequence
from firebreak_gis.placement.lines import dissect_by_lines
from firebreak_gis.planning.line_design import design_lines
from firebreak_gis.progress import silent
from firebreak_gis.stakes import Stakes

WIND, FROM, RUNS, HOURS = 5.0, 315.0, 300, 8
#: Budgets, as shares of the fuel times width / cell size, and shares saved for which the length is told, by hold.
STEPS = (0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.12)
LEVELS = {1.0: (0.6, 0.8, 0.9), 0.47: (0.1, 0.2, 0.3)}


def turned(landscape: xr.Dataset, angle: float) -> tuple[xr.Dataset, Affine]:
    """The landscape turned clockwise by an angle [degrees], and the transform from old to new (col, row)."""
    grid = Grid.of(landscape["burnable"])
    rows, cols = grid.shape
    side = int(np.ceil(np.hypot(rows, cols))) + 2 if angle else 0
    shape = (side, side) if angle else (rows, cols)
    there = (
        Affine.translation(shape[1] / 2, shape[0] / 2)
        @ Affine.rotation(angle)
        @ Affine.translation(-cols / 2, -rows / 2)
    )
    row, col = np.mgrid[: shape[0], : shape[1]] + 0.5
    back = ~there
    x, y = back.a * col + back.b * row + back.c, back.d * col + back.e * row + back.f
    inside = (x >= 0) & (x < cols) & (y >= 0) & (y < rows)
    place = Grid(shape, grid.transform, grid.crs)
    planes = {}
    for name in ("elevation", "vegetation", "density", "burnable"):
        old = landscape[name].to_numpy()
        if name == "elevation":
            new = map_coordinates(np.nan_to_num(old.astype(float)), [y - 0.5, x - 0.5], order=1, mode="nearest")
        else:
            at = np.clip(y.astype(int), 0, rows - 1), np.clip(x.astype(int), 0, cols - 1)
            new = np.where(inside, old[at], 0)
        planes[name] = place.dataarray(new.astype(old.dtype), name).assign_attrs(landscape[name].attrs)
    return xr.Dataset(planes, attrs=landscape.attrs), there


def points_on(network: fb.SpreadNetwork, places: np.ndarray, there: Affine) -> tuple[gpd.GeoDataFrame, np.ndarray]:
    """Places (col, row) of the old map on the new one, and whether they hold fuel there."""
    col = there.a * places[:, 0] + there.b * places[:, 1] + there.c
    row = there.d * places[:, 0] + there.e * places[:, 1] + there.f
    t = network.grid.transform
    fuel = network.burnable[row.astype(int), col.astype(int)]
    points = gpd.points_from_xy(t.c + t.a * col, t.f + t.e * row, crs=network.grid.crs)
    return gpd.GeoDataFrame(geometry=points), fuel


def told_length(
    network: fb.SpreadNetwork,
    timed: fb.SpreadNetwork,
    stakes: Stakes,
    starts: gpd.GeoDataFrame,
    asked: argparse.Namespace,
    angle: float,
) -> None:
    """Print the kilometres of line that save some shares of the burnt area."""
    budgets = [Budget(step * asked.width / network.grid.cell_size) for step in STEPS]
    lines = design_lines(network, stakes=stakes, budget=budgets[-1], width=asked.width)
    length = [lines.walls["length_m"].iloc[: lines.bought(budget)].sum() / 1000.0 for budget in budgets]
    for hold, levels in LEVELS.items():
        fires = {"ignitions": starts, "n_runs": asked.runs, "duration": f"{HOURS}h", "hold": hold, "seed": 1}
        before = fb.simulate(timed, **fires)["fire_size"].mean()
        after = [fb.simulate(timed, breaks=lines.breaks(budget), **fires)["fire_size"].mean() for budget in budgets]
        saved = [0.0, *(float(1 - each / before) for each in after)]
        km = np.interp(levels, saved, [0.0, *length])
        print(
            f"{angle:g} hold {hold:g}: km that save", dict(zip(levels, km.round(1).tolist(), strict=True)), flush=True
        )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("layers", nargs=3)
    parser.add_argument("--resolution", type=float)
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--width", type=float, default=12.0)
    parser.add_argument("--budgets", type=float, nargs="+", default=[0.02, 0.05])
    asked = parser.parse_args()
    landscape = fb.read_landscape(*asked.layers, resolution=asked.resolution)
    made = []
    for angle in (0.0, 30.0, 45.0):
        new, there = turned(landscape, angle)
        wind = {"wind_speed": WIND, "wind_from_direction": (FROM + angle) % 360.0}
        made.append((angle, fb.spread_network(new, **wind), fb.spread_network(new, **wind, clock=True), there))
    rows, cols = landscape["burnable"].shape
    places = np.random.default_rng(0).uniform(0, [cols, rows], (40 * asked.runs, 2))
    good = np.logical_and.reduce([points_on(network, places, there)[1] for _, network, _, there in made])
    places = places[good][: asked.runs]
    print("angle plan budget hold walls km ha before_% after_% saved_% +-")
    picks = np.random.default_rng(0).integers(0, asked.runs, (400, asked.runs))
    for angle, network, timed, there in made:
        starts, _ = points_on(network, places, there)
        stakes = Stakes(network)
        cuts = dissect_by_lines(network, stakes, progress=silent)
        order = sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])
        closed = np.cumsum([cuts[i].saved for i in order])
        length = np.cumsum([cuts[i].length for i in order]) * network.grid.cell_size / 1000.0
        needed = [np.append(length, np.nan)[np.searchsorted(closed, part)] for part in (0.5, 0.9, 0.98, 0.995)]
        print(f"{angle:g}: km of line for .5, .9, .98, .995 of the expected loss:", np.round(needed, 2))
        told_length(network, timed, stakes, starts, asked, angle)
        for budget in asked.budgets:
            lines = design_lines(network, stakes=stakes, budget=Budget(budget), width=asked.width)
            cells = fb.select_breaks(fb.rank(network, budget=budget), budget=budget, burnable=network.burnable)
            for hold in (1.0, 0.47):
                fires = {"ignitions": starts, "n_runs": asked.runs, "duration": f"{HOURS}h", "hold": hold, "seed": 1}
                before = fb.simulate(timed, **fires)["fire_size"].to_numpy()
                for name, breaks in (("lines", lines.breaks(Budget(budget))), ("cells", cells)):
                    after = fb.simulate(timed, breaks=breaks, **fires)["fire_size"].to_numpy()
                    spread = 100 * (after[picks].mean(axis=1) / before[picks].mean(axis=1)).std()
                    n, told = lines.bought(Budget(budget)), lines.walls
                    n = n if name == "lines" else 0
                    print(
                        f"{angle:g} {name} {budget:g} {hold:g} {n} {told['length_m'][:n].sum() / 1000:.1f} "
                        f"{told['area_ha'][:n].sum():.1f} {100 * before.mean() / network.n_burnable:.2f} "
                        f"{100 * after.mean() / network.n_burnable:.2f} "
                        f"{100 * (1 - after.mean() / before.mean()):.2f} {spread:.2f}",
                        flush=True,
                    )


if __name__ == "__main__":
    main()
