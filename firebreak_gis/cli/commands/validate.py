"""firebreak validate: a landscape, a scar and a start in, how well the simulated fire fits out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import kinds, options, outputs, weather_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import input_files
from firebreak_gis.cli.rehearsal import require_outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.manifest import account
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.evaluation.validation import Validation


@dataclass(frozen=True)
class _Validated:
    """What is written."""

    result: Validation
    fuel: np.ndarray
    scar: str

    @property
    def frequency(self) -> xr.DataArray:
        from firebreak_gis.schema import annotate

        plane = self.result.grid.dataarray(self.result.forecast.probability, "burn_frequency")
        return annotate(plane)


def _table(validated: _Validated, path: Path, how: Writing) -> None:
    from firebreak_gis.files import write_text

    result = validated.result
    table = result.table() if path.name == "scores.csv" else result.reliability_table()
    write_text(path, table.to_csv(index=False, lineterminator="\n"), overwrite=how.overwrite)


def _frequency(validated: _Validated, path: Path, how: Writing) -> None:
    from firebreak_gis.rasters import write_raster

    write_raster(
        path,
        validated.frequency,
        overwrite=how.overwrite,
        forbid=how.forbid,
        provenance=how.tags,
        creation_options=how.creation_options,
    )


def _picture(validated: _Validated, path: Path, how: Writing) -> None:
    from firebreak_gis.report.figures import save
    from firebreak_gis.report.validation import validation_figure

    title = f"{Path(validated.scar).stem}: {validated.result.summary()['observed_ha']:.4g} ha observed"
    save(validation_figure(validated.result, title=title, fuel=validated.fuel), path, overwrite=how.overwrite)


#: What the command writes into its folder.
OUTPUTS: tuple[Output[_Validated], ...] = (
    Output("scores.csv", "Scores of the simulated fire and of the null models", _table),
    Output("reliability.csv", "How often cells burnt, by the probability forecast", _table),
    Output("burn_frequency.tif", "Share of the simulated fires in which each cell burns", _frequency),
    Output("validation.png", "Picture of the simulated fire over the scar, with the reliability", _picture),
    account("validate", lambda it: {"result": it.result.summary(), **it.result.account}),
)


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
@click.option(
    "--embers",
    type=kinds.EMBERS,
    metavar="on|NAME=VALUE,...",
    help="Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the assumed ones.",
)
@click.option("--runs", "n_runs", type=kinds.COUNT, default=200, show_default=True, help="Number of simulated fires.")
@weather_options.spread
@options.seed
@outputs.output_folder(OUTPUTS, required=False, more=" Without it the scores are only told.")
@options.common
@engine
@built(spread=SpreadRequest, weather=WeatherRequest)
def command(
    session: Session,
    folder: str,
    scar: str,
    start: str,
    duration: str,
    embers: Any,
    n_runs: int,
    seed: int,
    spread: SpreadRequest,
    weather: WeatherRequest,
    output: str | None,
    overwrite: bool,
    creation_options: Mapping[str, str],
) -> None:
    """Hold a simulated fire against SCAR, the area that burnt, beside fires that know nothing.

    LANDSCAPE is the folder that align wrote, or a network with travel times (then the wind given is that of the
    elliptical null model). Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are
    told for the simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.
    """
    from firebreak_gis.evaluation.forecasting import validate
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.manifest import provenance
    from firebreak_gis.planning.timing import Estimate, runs_seconds
    from firebreak_gis.progress import part
    from firebreak_gis.spread.raster import read_network

    whole = Path(folder).is_dir()
    spread.require()
    told = weather.read()
    source: Any = read_landscape_folder(folder) if whole else read_network(folder)
    named = [*map(str, Path(folder).glob("*.tif")), folder, scar, start, *weather.sources, *spread.sources]
    inputs = input_files(named)
    wind = None
    if not whole:
        params = dict(spread.model_params)
        if spread.neighbourhood != "moore":
            params["neighbourhood"] = spread.neighbourhood  # refused: a network is made
        if isinstance(spread.wind_speed, float) and isinstance(spread.wind_from, float):
            wind = (spread.wind_speed, spread.wind_from)
    else:
        params = spread.params(source) if told is None else spread.params_beside(source, told)
        params["model"] = spread.model
    target = None if output is None else OutputRequest(output, overwrite, creation_options)
    how = None if target is None else require_outputs(target, OUTPUTS, inputs)

    def foresee(work: Callable[[int], Any], n_runs: int, before: float) -> None:
        session.foresee(Estimate({"fires": runs_seconds(work, n_runs, before)}))

    result = validate(
        source,
        scar,
        start=start,
        duration=duration,
        weather=told,
        embers=embers,
        n_runs=n_runs,
        seed=seed,
        wind=wind,
        foreseen=foresee,
        progress=part(session.progress, 0.05, 0.9),
        **params,
    )
    summary = result.summary()
    files: list[Path] = []
    if target is not None and how is not None:
        fuel = source["burnable"].to_numpy() if whole else source.burnable
        how = replace(how, tags=provenance(how.parameters, seed=seed))
        files = write_all(OUTPUTS, _Validated(result, fuel, scar), target.output, how)
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
