"""firebreak reproduce: the experiments of the paper."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import kinds, options, outputs
from firebreak_gis.cli.layers import input_files, read_layers
from firebreak_gis.cli.rehearsal import require_outputs
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.files import write_text
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.samples import sample_layers
from firebreak_gis.manifest import account

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from firebreak_gis.evaluation.paper.landscape import Curves


@click.group("reproduce")
def command() -> None:
    """Run the experiments of Russo, Russo and Siettos (2016) again."""


def _csv(get: Callable[[Any], pd.DataFrame]) -> Callable[[Any, Path, Writing], None]:
    """Write a table of the result."""

    def write(result: Any, path: Path, how: Writing) -> None:
        write_text(path, get(result).to_csv(index=False, lineterminator="\n"), overwrite=how.overwrite)

    return write


def _picture(get: Callable[[Any], Figure]) -> Callable[[Any, Path, Writing], None]:
    """Write a figure of the result."""

    def write(result: Any, path: Path, how: Writing) -> None:
        from firebreak_gis.report.figures import save

        save(get(result), path, overwrite=how.overwrite)

    return write


@dataclass(frozen=True)
class _Forest:
    """The first experiment."""

    result: xr.Dataset

    @cached_property
    def summary(self) -> dict[str, Any]:
        from firebreak_gis.evaluation.paper.artificial_forest import summary

        return summary(self.result)

    @cached_property
    def curve(self) -> pd.DataFrame:
        from firebreak_gis.evaluation.paper.artificial_forest import curve_table

        return curve_table(self.result)

    @cached_property
    def figure(self) -> Figure:
        from firebreak_gis.evaluation.paper.artificial_forest import FALLEN
        from firebreak_gis.report.paper import figure_1

        return figure_1(self.result, fallen=FALLEN)


def _summary(forest: _Forest, path: Path, how: Writing) -> None:
    write_text(path, json.dumps(forest.summary, indent=2) + "\n", overwrite=how.overwrite)


#: What `artificial-forest` writes into its folder.
FOREST: tuple[Output[_Forest], ...] = (
    Output("curve.csv", "Burnt share of every centrality at every share cut", _csv(lambda forest: forest.curve)),
    Output("summary.json", "Where the burnt share falls", _summary),
    Output("figure_1.png", "Figure 1", _picture(lambda forest: forest.figure)),
    Output("figure_1.svg", "Figure 1, to scale", _picture(lambda forest: forest.figure)),
    account("reproduce artificial-forest", lambda forest: forest.summary),
)


@dataclass(frozen=True)
class _Figures:
    """The other experiments: figures by number, and tables."""

    figures: Mapping[int, Figure]
    grey: xr.DataArray
    evaluation: pd.DataFrame
    cut: pd.DataFrame
    classes: pd.DataFrame
    classes_figure: Figure


def _figure(number: int) -> Output[_Figures]:
    return Output(f"figure_{number}.png", f"Figure {number}", _picture(lambda result: result.figures[number]))


def _grey(result: _Figures, path: Path, how: Writing) -> None:
    from firebreak_gis.rasters import write_raster

    write_raster(path, result.grey, overwrite=how.overwrite)


#: What `landscape` writes into its folder.
FIGURES: tuple[Output[_Figures], ...] = (
    *(_figure(number) for number in (3, 4, 5, 6)),
    Output("figure_4a.tif", "Figure 4a as a map: burn frequency in 16 grey levels", _grey),
    Output("evaluation.csv", "Burnt share at every budget", _csv(lambda result: result.evaluation)),
    Output("cut_cells.csv", "Classes of the cells that are cut", _csv(lambda result: result.cut)),
    Output("class_shares.csv", "Classes cut by every method, against random", _csv(lambda result: result.classes)),
    Output("class_shares.png", "The same as a figure", _picture(lambda result: result.classes_figure)),
    account("reproduce landscape", lambda result: {"cut_cells": result.cut.to_dict("records")}),
)


@command.command("artificial-forest")
@outputs.output_folder(FOREST, default="artificial-forest")
@click.option("--forests", "n_forests", type=kinds.COUNT, default=100, show_default=True, help="Number of forests.")
@click.option("--runs", "n_runs", type=kinds.COUNT, default=10, show_default=True, help="Fires a forest.")
@click.option(
    "--rankings",
    type=click.Choice(["paper", "named"]),
    default="paper",
    show_default=True,
    help="Those of the paper's figure, or those that it names or that were found since: information, current flow, "
    "percolation, PageRank, DomiRank, group betweenness (beside Bonacich, betweenness and random).",
)
@options.seed
@options.common
@built(output=OutputRequest)
def artificial_forest_command(
    session: Session, output: OutputRequest, n_forests: int, n_runs: int, rankings: str, seed: int
) -> None:
    """Figure 1: R(d_f) of every centrality on random forests of 50 x 50 cells."""
    from firebreak_gis.evaluation.paper.artificial_forest import FALLEN, artificial_forest
    from firebreak_gis.files.outputs import write_all

    how = require_outputs(output, FOREST, [])
    forest = _Forest(
        artificial_forest(rankings=rankings, n_forests=n_forests, n_runs=n_runs, seed=seed, progress=session.progress)
    )
    files = write_all(FOREST, forest, output.output, how)
    found = forest.summary
    lines = [
        f"{label:17} mean R below {FALLEN:g} from d_f = {row['d_f_below_0.3']}"
        for label, row in found["methods"].items()
    ]
    session.finish({"files": files, **found}, "\n".join([*lines, f"written to {output.output}"]))


@command.command("landscape")
@click.argument("dem", required=False)
@click.argument("vegetation", required=False)
@click.argument("density", required=False)
@outputs.output_folder(FIGURES, default="landscape-figures")
@click.option(
    "--ignition",
    type=float,
    nargs=2,
    metavar="X Y",
    help="Where the fire of figure 4 starts, in the CRS of the grid [default: the middle].",
)
@click.option(
    "--rectangle",
    type=float,
    nargs=4,
    metavar="LEFT BOTTOM RIGHT TOP",
    help="Where breaks are planned, in the CRS of the grid [default: everywhere].",
)
@click.option(
    "--curves",
    type=click.Choice(["calm", "windy"]),
    default="calm",
    show_default=True,
    help="Fires of figures 5 and 6: in calm air from random places, or with the ignition and wind of figure 4.",
)
@click.option("--wind-speed", type=float, default=8.0, show_default=True, help="Wind of figure 4 [m/s].")
@click.option(
    "--wind-from",
    type=float,
    default=315.0,
    show_default=True,
    help="Direction the wind of figure 4 comes from, degrees clockwise from north.",
)
@click.option("--runs", "n_runs", type=kinds.COUNT, default=100, show_default=True, help="Number of simulated fires.")
@options.seed
@options.landscape
@options.common
@built(output=OutputRequest, layers=LandscapeRequest)
def landscape_command(
    session: Session,
    output: OutputRequest,
    layers: LandscapeRequest,
    ignition: tuple[float, float] | None,
    rectangle: tuple[float, float, float, float] | None,
    wind_speed: float,
    wind_from: float,
    curves: Curves,
    n_runs: int,
    seed: int,
) -> None:
    """Figures 3 to 6 on a landscape: DEM, VEGETATION, DENSITY; without them on the sample data."""
    from firebreak_gis.evaluation.classes import class_table
    from firebreak_gis.evaluation.curves import table
    from firebreak_gis.evaluation.paper.landscape import cut_table, grey_levels, landscape_experiment
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import survey
    from firebreak_gis.progress import part
    from firebreak_gis.report import paper

    told = recorded()
    if layers.dem is None:
        sample = sample_layers()
        told |= sample
        layers = replace(layers, dem=sample["dem"], vegetation=sample["vegetation"], density=sample["density"])
    elif layers.vegetation is None:
        raise ParameterError("DEM was given without VEGETATION; give both, or neither to use the sample data")
    inputs = input_files(layers.sources)
    how = replace(require_outputs(output, FIGURES, inputs), parameters=told)
    landscape = read_layers(layers, survey(layers), session, progress=part(session.progress, 0.0, 0.1, "align: "))
    result = landscape_experiment(
        landscape,
        ignition=ignition or None,
        rectangle=rectangle or None,
        wind_speed=wind_speed,
        wind_from_direction=wind_from,
        curves=curves,
        n_runs=n_runs,
        seed=seed,
        progress=part(session.progress, 0.1, 0.9),
    )
    wind = f"wind {wind_speed:g} m/s from {wind_from:g} degrees"
    grey = grey_levels(result.fire["burn_frequency"].to_numpy(), n_runs)
    figures = {
        3: paper.figure_3(landscape),
        4: paper.figure_4(landscape, result.fire, grey, wind=wind),
        5: paper.figure_5(result.evaluation, fires=f"one ignition, {wind}" if curves == "windy" else "calm air"),
        6: paper.figure_6(result.window, result.breaks),
    }
    cut = cut_table(result)
    grey_map = Grid.of(landscape["burnable"]).dataarray(grey.astype("uint16"), "grey_level")
    classes = class_table(result.window, result.cut)
    made = _Figures(figures, grey_map, table(result.evaluation), cut, classes, paper.class_figure(classes))
    files = write_all(FIGURES, made, output.output, how)
    session.finish(
        {"files": files, "cut_cells": cut.to_dict("records")},
        f"{cut.to_string(index=False, float_format=lambda v: f'{v:.3f}')}\nwritten to {output.output}",
    )
