"""Plans made for the fires that come, against those made without a clock: ``python -m tests.benchmarks.timed_plans``.

Every row is one landscape, wind, duration, way that breaks fail and budget; all plans of a row meet the same fires with
embers, which none of them was designed with. Plans without a clock are those that the program made before designs knew
the time: `dissection`, the same for breaks that keep a tenth, and square compartments 1, 2 and 3 cells wide.

The table grows row by row in a CSV file, and what stands there is not made again: all of it takes hours. It is shown as
Markdown at the end, and drawn with ``--figure FILE``.
"""

from __future__ import annotations

import argparse
import csv
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from firebreak_gis import read_landscape
from firebreak_gis.breaks import Budget, select_breaks
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.placement.trial import Trial
from firebreak_gis.planning.design import design
from firebreak_gis.planning.designs.lines import usual
from firebreak_gis.planning.judging import Scene
from firebreak_gis.planning.line_design import design_lines
from firebreak_gis.planning.request import PlanRequest
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.holding import as_hold
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes

#: The same three layers under both winds.
WINDS: Mapping[str, tuple[SpreadRequest, WeatherRequest]] = {
    "NW": (SpreadRequest(wind_speed=5.0, wind_from=315.0), WeatherRequest()),
    "rose": (SpreadRequest(), WeatherRequest("rose:N=4x.2,NE=3x.1,E=3x.05,SE=4x.1,S=5x.1,SW=6x.15,W=6x.1,NW=8x.2")),
}
HOURS = (8, 24)
BUDGETS = (0.03, 0.05, 0.10)
#: What treated cells keep, and how often stretches hold.
BREAKS: Mapping[str, tuple[float, float]] = {
    "perfect": (0.0, 1.0),
    "keep .05": (0.05, 1.0),
    "keep .10": (0.10, 1.0),
    "hold .47": (0.0, 0.47),
}
#: Plans without a clock: method, residual that they are made for, parameters.
TODAY: Mapping[str, tuple[str, float, dict[str, Any]]] = {
    "dissection": ("dissection", 0.0, {}),
    "dissection for .1": ("dissection", 0.1, {}),
    **{f"compartments {width}": ("compartments", 0.0, {"width": width}) for width in (1, 2, 3)},
}
NEW = "default"
RUNS, SEED = 300, 777
COLUMNS = ("landscape", "wind", "hours", "breaks", "d_f", "plan", "saved", "low", "high", "seconds", "note")


class Row(NamedTuple):
    """What is asked."""

    landscape: str
    wind: str
    hours: int
    breaks: str
    d_f: float

    @property
    def fires(self) -> FireRequest:
        residual, hold = BREAKS[self.breaks]
        return FireRequest(
            n_runs=RUNS,
            seed=SEED,
            residual=residual,
            duration=as_duration(f"{self.hours}h"),
            hold=as_hold(hold),
            embers=as_embers(True),
        )


def landscape(name: str, shared: Path | None) -> Any:
    """Rhodes in cells of 40 or 20 m, Vilopriu, or the sample."""
    if name == "sample":
        return read_landscape(*(f"sample_data/{layer}.tif" for layer in ("dem", "vegetation", "density")))
    if shared is None:
        raise SystemExit(f"{name} is not shipped; say where it lies with --shared FOLDER")
    if name.startswith("Rhodes"):
        layers = (shared / "rhodes_20m" / f"rhodes_{layer}.tif" for layer in ("dem", "vegetation", "density"))
        return read_landscape(*layers, resolution=float(name.split()[1]))
    layers = (shared / "vilopriu_2013" / f"{layer}.tif" for layer in ("elevation", "fuels", "ccf"))
    codes = {"legend": "scott_burgan_40", "density_legend": "canopy_cover", "unknown": "nonburnable"}
    return read_landscape(*layers, **codes)


class Stage:
    """One landscape under one wind."""

    def __init__(self, name: str, wind: str, shared: Path | None) -> None:
        spread, weather = WINDS[wind]
        self.scene = Scene.of(landscape(name, shared), spread, weather.read())
        self.network = self.scene.network
        self.stakes = Stakes(self.network)
        judged = self.scene.judging(FireRequest(duration=as_duration("8h")))
        self.ground = self.scene.ground(judged, self.network, None)
        self._today: dict[tuple[str, float], np.ndarray] = {}
        self._bare: dict[int, np.ndarray] = {}
        self.told = ""

    def sizes(self, fires: FireRequest, cut: np.ndarray | LineBreaks | None) -> np.ndarray:
        """Cells that each fire burns."""
        burns = burn(self.ground.network, fires, breaks=cut, weather=self.ground.weather)
        return burns["fire_size"].to_numpy()

    def bare(self, row: Row) -> np.ndarray:
        """The same without breaks."""
        if row.hours not in self._bare:
            self._bare[row.hours] = self.sizes(row.fires, None)
        return self._bare[row.hours]

    def cut(self, row: Row, plan: str) -> np.ndarray | LineBreaks | None:
        """What a plan builds: cells, or lines."""
        if plan in TODAY:
            if (plan, row.d_f) not in self._today:
                method, residual, params = TODAY[plan]
                self._today[plan, row.d_f] = self._design(row, method, residual, params)
            return self._today[plan, row.d_f]
        trial = Trial(self.ground, row.fires, self.stakes, seed=0)
        width = usual(PlanRequest(fires=row.fires), self.scene.judging(row.fires), self.network)
        if width != "cells":
            budget = Budget(row.d_f)
            found = design_lines(self.network, stakes=self.stakes, budget=budget, width=float(width), trial=trial)
            self.told = found.told
            return found.breaks(budget)
        return self._design(row, "dissection", row.fires.residual, {}, trial)

    def _design(
        self, row: Row, method: str, residual: float, params: dict[str, Any], trial: Trial | None = None
    ) -> np.ndarray:
        budget = Budget(row.d_f)
        made = design(
            self.network, method, stakes=self.stakes, budget=budget, residual=residual, params=params, trial=trial
        )
        self.told = made.attrs.get("design", "")
        cut: np.ndarray = select_breaks(made, budget=budget, burnable=self.network.burnable).to_numpy() > 0
        return cut


def measured(stage: Stage, row: Row, plan: str) -> dict[str, Any]:
    """One line of the table; the interval is that of 1,000 resamples of the fires."""
    start = time.perf_counter()
    cut = stage.cut(row, plan)
    took = time.perf_counter() - start
    bare, left = stage.bare(row).astype(float), stage.sizes(row.fires, cut).astype(float)
    picks = np.random.default_rng(0).integers(0, RUNS, (1000, RUNS))
    saved = 100 * (1 - left[picks].sum(axis=1) / bare[picks].sum(axis=1))
    low, high = np.percentile(saved, [2.5, 97.5])
    numbers = {"saved": 100 * (1 - left.sum() / bare.sum()), "low": low, "high": high}
    told = {key: f"{value:.2f}" for key, value in numbers.items()}
    return {**row._asdict(), "plan": plan, **told, "seconds": f"{took:.1f}", "note": stage.told if plan == NEW else ""}


def rows(landscapes: list[str], winds: list[str]) -> Iterator[Row]:
    for name in landscapes:
        for wind in winds:
            for d_f in BUDGETS:
                yield from (Row(name, wind, hours, breaks, d_f) for hours in HOURS for breaks in BREAKS)


def read_table(file: Path) -> list[dict[str, str]]:
    if not file.exists():
        return []
    with file.open(newline="") as lines:
        return list(csv.DictReader(lines))


def make(file: Path, wanted: list[Row], plans: list[str], shared: Path | None) -> None:
    """Add what is missing to the table."""
    done = {tuple(line[key] for key in COLUMNS[:6]) for line in read_table(file)}
    stage, at = None, ("", "")
    if not file.exists():
        file.write_text(",".join(COLUMNS) + "\n")
    for row in wanted:
        for plan in plans:
            if (*map(str, row), plan) in done:
                continue
            if stage is None or at != (row.landscape, row.wind):
                stage, at = Stage(row.landscape, row.wind, shared), (row.landscape, row.wind)
            line = measured(stage, row, plan)
            with file.open("a", newline="") as lines:
                csv.DictWriter(lines, COLUMNS, lineterminator="\n").writerow(line)


class Line(NamedTuple):
    """One row of the table with all plans: saved, % of the mean burnt area."""

    row: tuple[str, ...]
    today: dict[str, float]
    new: float
    low: float
    note: str

    @property
    def best(self) -> float:
        return max(self.today.values())

    @property
    def more(self) -> float:
        """How much more than the best of today's is saved, in % of it."""
        return 100 * (self.new / self.best - 1)


def complete(table: list[dict[str, str]]) -> list[Line]:
    """Rows for which every plan is there."""
    found: dict[tuple[str, ...], dict[str, dict[str, str]]] = {}
    for line in table:
        found.setdefault(tuple(line[key] for key in COLUMNS[:5]), {})[line["plan"]] = line
    lines = []
    for row, plans in found.items():
        if set(plans) >= {*TODAY, NEW}:
            today = {name: float(plans[name]["saved"]) for name in TODAY}
            new = plans[NEW]
            lines.append(Line(row, today, float(new["saved"]), float(new["low"]), new["note"]))
    return lines


def told(lines: list[Line]) -> str:
    """The table as Markdown, and how often it is as good, better, worse."""
    head = "| landscape | wind | fires | breaks | d_f | " + " | ".join(TODAY) + " | default | more than the best |"
    text = [head, "|---" * (7 + len(TODAY)) + "|"]
    for line in lines:
        name, wind, hours, breaks, d_f = line.row
        today = " | ".join(f"{value:.1f}" for value in line.today.values())
        text.append(
            f"| {name} | {wind} | {hours} h | {breaks} | {d_f} | {today} | {line.new:.1f} | {line.more:+.0f} % |"
        )
    worse = [line for line in lines if round(line.new, 1) < round(line.best, 1)]
    quarter = sum(line.more >= 25 for line in lines)
    within = sum(line.best <= 2 * line.new - line.low for line in worse)
    text.append("")
    text.append(
        f"{len(lines)} rows: at least as much as the best of five in {len(lines) - len(worse)}, at least 25 % more in "
        f"{quarter}. Of the {len(worse)} others {within} miss it by less than half of the 95 % interval."
    )
    return "\n".join(text)


def draw(lines: list[Line], file: Path) -> None:
    """Every row as a point: the best of the plans without a clock against the default, by landscape and wind."""
    import matplotlib.pyplot as plt

    places = sorted({line.row[:2] for line in lines}, key=lambda place: (place[1], place[0]))
    across = max(sum(wind == one for _, wind in places) for one in WINDS)
    size = (1.2 + 2.9 * across, 3.9 * -(-len(places) // across))
    figure, panels = plt.subplots(
        -(-len(places) // across), across, figsize=size, layout="constrained", squeeze=False, sharey=True
    )
    ends = np.array([0.0, 100.0])
    for axes in panels.ravel()[len(places) :]:
        axes.set_visible(False)
    for axes, (place, wind) in zip(panels.ravel(), places, strict=False):
        here = [line for line in lines if line.row[:2] == (place, wind)]
        for name, mark in zip(BREAKS, "os^D", strict=True):
            of = [line for line in here if line.row[3] == name]
            axes.scatter(
                [line.best for line in of], [line.new for line in of], marker=mark, s=36, alpha=0.8, label=name
            )
        axes.plot(ends, ends, color="0.4", lw=1, label="as much")
        axes.plot(ends, 1.25 * ends, color="0.4", lw=1, ls=":", label="a quarter more")
        axes.set(xlim=(0, 100), ylim=(0, 100), aspect="equal", title=f"{place}, {wind}: {len(here)} of 24 rows")
    figure.supylabel("saved by the default plan [% of the burnt area]", fontsize="medium")
    panels[0][0].legend(title="breaks", frameon=False)
    figure.supxlabel("saved by the best of five plans made without a clock [% of the burnt area]", fontsize="medium")
    figure.savefig(file, dpi=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = ("sample", "Rhodes 40", "Rhodes 20", "Vilopriu")
    parser.add_argument("--shared", type=Path, help="folder with rhodes_20m and vilopriu_2013")
    parser.add_argument("--landscapes", nargs="+", choices=names, default=["sample"])
    parser.add_argument("--winds", nargs="+", choices=list(WINDS), default=list(WINDS))
    parser.add_argument("--plans", nargs="+", choices=[*TODAY, NEW], default=[*TODAY, NEW])
    parser.add_argument("--table", type=Path, default=Path("timed_plans.csv"))
    parser.add_argument("--only-show", action="store_true", help="make no plan, show what the table holds")
    parser.add_argument("--figure", type=Path)
    given = parser.parse_args()
    if not given.only_show:
        make(given.table, list(rows(given.landscapes, given.winds)), given.plans, given.shared)
    lines = complete(read_table(given.table))
    print(told(lines))
    if given.figure:
        draw(lines, given.figure)


if __name__ == "__main__":
    main()
