"""firebreak reproduce: the experiments of the paper."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import click

from firebreak_gis.cli import kinds, options
from firebreak_gis.cli.layers import input_files, read_layers
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.request import LandscapeRequest


@click.group("reproduce")
def command() -> None:
    """Run the experiments of Russo, Russo and Siettos (2016) again."""


@command.command("artificial-forest")
@click.option(
    "-o",
    "--output",
    type=click.Path(file_okay=False),
    default="artificial-forest",
    show_default=True,
    help="Folder to write into; made if it does not exist.",
)
@options.overwrite
@click.option("--forests", "n_forests", type=kinds.COUNT, default=100, show_default=True, help="Number of forests.")
@click.option("--runs", "n_runs", type=kinds.COUNT, default=10, show_default=True, help="Fires a forest.")
@options.seed
@options.common
@options.claiming_folder
@built(output=OutputRequest)
def artificial_forest_command(session: Session, output: OutputRequest, n_forests: int, n_runs: int, seed: int) -> None:
    """Figure 1: R(d_f) of every centrality on random forests of 50 x 50 cells.

    Writes curve.csv, summary.json, figure_1.png, figure_1.svg and run.json.
    """
    from firebreak_gis.evaluation.paper.artificial_forest import FALLEN, artificial_forest, curve_table, summary
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.report.figures import save
    from firebreak_gis.report.paper import figure_1

    target = make_folder(output.output)
    files = [target / name for name in ("curve.csv", "summary.json", "figure_1.png", "figure_1.svg")]
    for name in (*files, target / "run.json"):
        require_writable(name, overwrite=output.overwrite)
    result = artificial_forest(n_forests=n_forests, n_runs=n_runs, seed=seed, progress=session.progress)
    found = summary(result)
    with together(target):
        write_text(files[0], curve_table(result).to_csv(index=False, lineterminator="\n"), overwrite=output.overwrite)
        write_text(files[1], json.dumps(found, indent=2) + "\n", overwrite=output.overwrite)
        figure = figure_1(result, fallen=FALLEN)
        for name in files[2:]:
            save(figure, name, overwrite=output.overwrite)
        files.append(
            write_manifest(
                target / "run.json",
                command="reproduce artificial-forest",
                inputs=[],
                outputs=files,
                parameters=recorded(),
                account=found,
                overwrite=output.overwrite,
            )
        )
    lines = [
        f"{label:14} mean R below {FALLEN:g} from d_f = {row['d_f_below_0.3']}"
        for label, row in found["methods"].items()
    ]
    session.finish({"files": files, **found}, "\n".join([*lines, f"written to {target}"]))


@command.command("landscape")
@click.argument("dem", required=False)
@click.argument("vegetation", required=False)
@click.argument("density", required=False)
@click.option(
    "-o",
    "--output",
    type=click.Path(file_okay=False),
    default="landscape-figures",
    show_default=True,
    help="Folder to write into; made if it does not exist.",
)
@options.overwrite
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
@options.claiming_folder
@built(output=OutputRequest, layers=LandscapeRequest)
def landscape_command(
    session: Session,
    output: OutputRequest,
    layers: LandscapeRequest,
    ignition: tuple[float, float] | None,
    rectangle: tuple[float, float, float, float] | None,
    wind_speed: float,
    wind_from: float,
    n_runs: int,
    seed: int,
) -> None:
    """Figures 3 to 6 on a landscape: DEM, VEGETATION, DENSITY; without them on the sample data.

    Writes figure_3.png to figure_6.png, evaluation.csv, cut_cells.csv and run.json.
    """
    from firebreak_gis.evaluation.curves import table
    from firebreak_gis.evaluation.paper.landscape import cut_table, grey_levels, landscape_experiment
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.landscape import survey
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.progress import part
    from firebreak_gis.report import paper
    from firebreak_gis.report.figures import save

    told = recorded()
    if layers.dem is None:
        sample = sample_layers()
        told |= sample
        layers = replace(layers, dem=sample["dem"], vegetation=sample["vegetation"], density=sample["density"])
    elif layers.vegetation is None:
        raise ParameterError("DEM was given without VEGETATION; give both, or neither to use the sample data")
    inputs = input_files(layers.sources)
    target = make_folder(output.output)
    pictures = [target / f"figure_{k}.png" for k in (3, 4, 5, 6)]
    tables = [target / "evaluation.csv", target / "cut_cells.csv"]
    for name in (*pictures, *tables, target / "run.json"):
        require_writable(name, overwrite=output.overwrite, forbid=inputs)
    landscape = read_layers(layers, survey(layers), session, progress=part(session.progress, 0.0, 0.1, "align: "))
    result = landscape_experiment(
        landscape,
        ignition=ignition or None,
        rectangle=rectangle or None,
        wind_speed=wind_speed,
        wind_from_direction=wind_from,
        n_runs=n_runs,
        seed=seed,
        progress=part(session.progress, 0.1, 0.9),
    )
    wind = f"wind {wind_speed:g} m/s from {wind_from:g} degrees"
    figures = (
        paper.figure_3(landscape),
        paper.figure_4(landscape, result.fire, grey_levels(result.fire["burn_frequency"].to_numpy()), wind=wind),
        paper.figure_5(result.evaluation),
        paper.figure_6(result.window, result.breaks),
    )
    cut = cut_table(result)
    with together(target):
        for name, figure in zip(pictures, figures, strict=True):
            save(figure, name, overwrite=output.overwrite)
        for name, frame in zip(tables, (table(result.evaluation), cut), strict=True):
            write_text(name, frame.to_csv(index=False, lineterminator="\n"), overwrite=output.overwrite)
        files = [*pictures, *tables]
        files.append(
            write_manifest(
                target / "run.json",
                command="reproduce landscape",
                inputs=inputs,
                outputs=files,
                parameters=told,
                account={"cut_cells": cut.to_dict("records")},
                overwrite=output.overwrite,
            )
        )
    session.finish(
        {"files": files, "cut_cells": cut.to_dict("records")},
        f"{cut.to_string(index=False, float_format=lambda v: f'{v:.3f}')}\nwritten to {target}",
    )


def sample_layers() -> dict[str, str]:
    """The sample landscape, from the installed package or the checkout."""
    import firebreak_gis

    package = Path(firebreak_gis.__file__).parent
    for folder in (package / "sample_data", package.parent / "sample_data"):
        if (folder / "dem.tif").is_file():
            return {
                name: str(folder / f"{stem}.tif")
                for name, stem in (("dem", "dem"), ("vegetation", "vegetation"), ("density", "density"))
            }
    raise ParameterError("the sample data is not installed; give DEM, VEGETATION and DENSITY")
