"""firebreak validate: a landscape, a scar and a start in, how well the simulated fire fits out."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, weather_options
from firebreak_gis.cli.layers import input_files
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest

#: What the command writes into its folder.
OUTPUTS = {
    "scores.csv": "Scores of the simulated fire and of the null models",
    "reliability.csv": "How often cells burnt, by the probability forecast",
    "burn_frequency.tif": "Share of the simulated fires in which each cell burns",
    "validation.png": "Picture of the simulated fire over the scar, with the reliability",
    "run.json": "Account of the run",
}


@click.command("validate")
@click.argument("folder", metavar="LANDSCAPE", type=click.Path())
@click.argument("scar", type=kinds.VECTOR_OR_RASTER)
@click.option(
    "--start",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    required=True,
    help="Where the fire was first seen: points, or polygons that burnt already (any vector file), or a raster.",
)
@weather_options.weather
@click.option(
    "--duration",
    metavar="TIME",
    required=True,
    help="How long the fire spread, e.g. 3h; lognormal:3h,0.5 (median, sigma) where that is not known well.",
)
@click.option("--runs", "n_runs", type=kinds.COUNT, default=200, show_default=True, help="Number of simulated fires.")
@weather_options.spread
@options.seed
@click.option(
    "-o",
    "--output",
    type=click.Path(file_okay=False),
    help="Folder to write into; made if it does not exist. Without it the scores are only told.",
)
@options.overwrite
@options.common
@built(spread=SpreadRequest, weather=WeatherRequest)
def command(
    session: Session, folder: str, scar: str, spread: SpreadRequest, weather: WeatherRequest, **given: Any
) -> None:
    """Hold a simulated fire against SCAR, the area that burnt, beside fires that know nothing.

    LANDSCAPE is the folder that align wrote, or a network with travel times (then the wind given is that of the
    elliptical null model). Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are
    told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.
    """
    from firebreak_gis.evaluation.forecasting import validate
    from firebreak_gis.files import claiming, make_folder, require_writable, together, write_text
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.manifest import provenance, write_manifest
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.report.figures import save
    from firebreak_gis.report.validation import validation_figure
    from firebreak_gis.schema import annotate
    from firebreak_gis.spread.raster import read_network

    output = given["output"]
    whole = Path(folder).is_dir()
    spread.require()
    told = weather.read()
    source: Any = read_landscape_folder(folder) if whole else read_network(folder)
    named = [*map(str, Path(folder).glob("*.tif")), folder, scar, given["start"], *weather.sources, *spread.sources]
    inputs = input_files(named)
    wind = None
    if not whole:
        params = dict(spread.model_params)
        if isinstance(spread.wind_speed, float) and isinstance(spread.wind_from, float):
            wind = (spread.wind_speed, spread.wind_from)
    else:
        params = spread.params(source) if told is None else spread.params_beside(source, told)
        params["model"] = spread.model
    with claiming(output, folder=True) if output else nullcontext():
        files = [] if output is None else [Path(output) / name for name in OUTPUTS]
        for file in files:
            require_writable(file, overwrite=given["overwrite"], forbid=files_behind(inputs))
        result = validate(
            source,
            scar,
            start=given["start"],
            duration=given["duration"],
            weather=told,
            n_runs=given["n_runs"],
            seed=given["seed"],
            wind=wind,
            progress=part(session.progress, 0.05, 0.9),
            **params,
        )
        summary = result.summary()
        if output is not None:
            place = make_folder(output)
            grid = result.grid
            frequency = annotate(grid.dataarray(result.forecast.probability, "burn_frequency"))
            title = f"{Path(scar).stem}: {summary['observed_ha']:.4g} ha observed"
            fuel = source["burnable"].to_numpy() if whole else source.burnable
            with together(place):
                for name, table in (("scores.csv", result.table()), ("reliability.csv", result.reliability_table())):
                    text = table.to_csv(index=False, lineterminator="\n")
                    write_text(place / name, text, overwrite=given["overwrite"])
                write_raster(
                    place / "burn_frequency.tif",
                    frequency,
                    overwrite=given["overwrite"],
                    provenance=provenance(recorded(), seed=given["seed"]),
                    creation_options=given["creation_options"],
                )
                figure = validation_figure(result, title=title, fuel=fuel)
                save(figure, place / "validation.png", overwrite=given["overwrite"])
                write_manifest(
                    place / "run.json",
                    command="validate",
                    inputs=inputs,
                    outputs=files[:-1],
                    parameters=recorded(),
                    account={"result": summary, **result.account},
                    overwrite=given["overwrite"],
                )
    session.finish({"files": files, **summary}, _told(summary, output))


def _told(summary: dict[str, Any], output: str | None) -> str:
    lines = [f"{'':12}growth IoU    IoU  Sorensen  size/observed   Brier"]
    lines += [
        f"{name:12}{score['growth_iou']:10.3f} {score['iou']:6.3f} {score['sorensen']:9.3f} "
        f"{score['size_ratio']:14.3f} {score['brier']:7.4f}"
        for name, score in summary["scores"].items()
    ]
    hours, gap = summary["hours_to_observed_size"], summary["reliability_largest_gap"]
    lines.append(
        "the mean fire never grows as large as the scar"
        if hours is None
        else f"the mean fire is as large as the scar after {hours:.3g} h"
    )
    if gap is not None:
        lines.append(f"largest gap of the reliability in bins of 100 cells or more: {gap:.2f}")
    worse = [name for name, better in summary["beats"].items() if not better]
    lines.append(
        f"No better than {' and '.join(worse)}." if worse else "Better than every null model by the IoU of the growth."
    )
    lines += summary["notes"]
    return "\n".join(lines + ([f"written to {output}"] if output else []))
