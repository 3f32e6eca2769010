"""firebreak calibrate: observed fires in, a configuration for every command out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, outputs, weather_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import input_files, tell
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation.request import HOURS_A_DAY, CalibrationRequest
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.planning.weather import WeatherRequest
from firebreak_gis.simulation.request import FireRequest

#: Columns of a table of observed fires; the last two may be missing or empty.
_COLUMNS = ("landscape", "scar", "start", "duration", "weather", "step")


@click.command("calibrate")
@click.argument("folder", metavar="LANDSCAPE", type=click.Path())
@click.argument("fires", type=kinds.VECTOR_OR_TABLE, required=False)
@click.option(
    "--fit",
    type=kinds.WORDS,
    metavar="LIST",
    help="What to fit: rate, duration and p0, separated by commas "
    "[default: rate and duration; of fewer than three scars the rate alone].",
)
@weather_options.weather
@click.option(
    "--ignitions",
    type=kinds.RASTER,
    metavar="RASTER",
    help="How likely a fire starts in each cell, relative to the others [default: everywhere alike].",
)
@click.option(
    "--size-column", metavar="NAME", help="Column of FIRES with the size in hectares [default: found by name]."
)
@click.option("--first-day-column", metavar="NAME", help="Column of FIRES with the first day [default: found by name].")
@click.option("--last-day-column", metavar="NAME", help="Column of FIRES with the last day [default: found by name].")
@click.option(
    "--least",
    type=float,
    default=100.0,
    show_default=True,
    help="Fires of fewer hectares do not count: small ones are often not mapped.",
)
@click.option(
    "--hours-a-day",
    type=float,
    default=HOURS_A_DAY,
    show_default=True,
    help="Hours for which a fire spreads on each of its days; an assumption that tells rates and durations apart.",
)
@click.option(
    "--longest",
    type=kinds.TIME,
    metavar="TIME",
    help="No fire spreads longer [default: as many whole days as the longest observed fire, or 200h].",
)
@click.option("--runs", "n_runs", type=kinds.COUNT, default=400, show_default=True, help="Number of simulated fires.")
@click.option(
    "--model-param",
    "model_params",
    multiple=True,
    callback=kinds.pairs,
    metavar="NAME=VALUE",
    help="Parameter of the spread model that stays as it is, e.g. moisture=0.06; may be repeated.",
)
@options.seed
@click.option("--table", type=kinds.NEW_TABLE, metavar="FILE", help="Also write what is told of each fire as CSV.")
@outputs.output_file("Configuration (TOML), which every command takes as --config,", kinds.NEW_CONFIG)
@options.common
@engine
@built(output=OutputRequest, weather=WeatherRequest, burning=FireRequest, asked=CalibrationRequest)
def command(
    session: Session,
    folder: str,
    fires: str | None,
    output: OutputRequest,
    table: str | None,
    weather: WeatherRequest,
    burning: FireRequest,
    asked: CalibrationRequest,
) -> None:
    """Fit the rate of spread, durations and spread probability to observed fires.

    With FIRES, a table or polygons with sizes and days of the fires of a region, LANDSCAPE is the folder that align
    wrote for it, and --weather tells the winds in which its fires burn. Without FIRES, LANDSCAPE is a CSV file with a
    line for each observed fire: the columns landscape, scar, start and duration, and perhaps weather and step.
    """
    from firebreak_gis.evaluation.calibration import calibrate_scars, calibrate_sizes
    from firebreak_gis.files import require_writable, together, write_text
    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.landscape.planes import ignition_source
    from firebreak_gis.landscape.scars import fire_table
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.planning.timing import Estimate, runs_seconds
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind

    files = [output.output, *([table] if table else [])]
    inputs = files_behind(input_files([folder, fires, *weather.sources, *burning.sources]))
    progress = part(session.progress, 0.05, 0.95)
    for name in files:
        require_writable(name, overwrite=output.overwrite, forbid=inputs)

    def foresee(times: float, work: Callable[[int], Any], n_runs: int, before: float) -> None:
        session.foresee(Estimate({"simulations": runs_seconds(work, n_runs, before, times=times)}))

    if fires is None:
        result = calibrate_scars(
            _cases(folder),
            fit=asked.fit,
            n_runs=burning.n_runs,
            seed=burning.seed,
            foreseen=foresee,
            progress=progress,
            **asked.model_params,
        )
    else:
        ensemble = weather.read()
        if ensemble is None:
            raise ParameterError("--weather is missing: the winds in which the fires of the region burn")
        landscape = read_landscape_folder(folder)
        account = Account()
        ignitions = ignition_source(burning.ignitions, Grid.of(landscape["burnable"]), account)
        tell(account, session)
        observed = fire_table(
            fires,
            size=asked.size_column,
            first_day=asked.first_day_column,
            last_day=asked.last_day_column,
        )
        result = calibrate_sizes(
            landscape,
            observed,
            weather=ensemble,
            told=weather.weather,
            ignitions=ignitions,
            fit=asked.fit or ("rate", "duration"),
            least=asked.least,
            hours_a_day=asked.hours_a_day,
            longest=asked.longest,
            n_runs=burning.n_runs,
            seed=burning.seed,
            foreseen=foresee,
            progress=progress,
            **asked.model_params,
        )
    with together(*(Path(name).parent for name in files)):
        write_text(output.output, result.config(), overwrite=output.overwrite)
        if table:
            text = result.table.to_csv(index=False, lineterminator="\n")
            write_text(table, text, overwrite=output.overwrite)
    rows = result.table.astype(object).where(result.table.notna(), None).to_dict("records")
    told = {"parameters": result.parameters, "n_parameters": result.n_parameters, "n_fires": result.n_fires}
    session.finish(
        {"files": files, **told, **result.account, "fires": rows, "notes": list(result.notes)},
        "\n".join([result.config(), result.table.to_string(index=False), f"written to {', '.join(files)}"]),
    )


def _cases(path: str) -> list[Any]:
    """Read the observed fires of a table; files are named from where the table lies."""
    import csv

    from firebreak_gis.evaluation.forecasting import Case

    place = Path(path)
    if place.is_dir():
        raise ParameterError(f"FIRES is missing: the fires that burnt on the landscape {path}, with their sizes")
    try:
        with place.open(encoding="utf-8-sig", newline="") as file:
            rows = [{str(k).strip(): (v or "").strip() for k, v in row.items()} for row in csv.DictReader(file)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"{path} cannot be read as a table of observed fires: {error}") from error
    missing = [name for name in _COLUMNS[:4] if not rows or name not in rows[0]]
    if missing:
        raise InputError(
            f"{path} lacks {', '.join(missing)}; expected a line for each fire with the columns {', '.join(_COLUMNS)}"
        )

    def file_of(name: str) -> str:
        return name if not name or name.startswith("rose:") else str(place.parent / name)

    return [
        Case(
            file_of(row["landscape"]),
            file_of(row["scar"]),
            file_of(row["start"]),
            row["duration"],
            file_of(row.get("weather", "")) or None,
            row.get("step") or None,
            Path(row["scar"]).parent.name or Path(row["scar"]).stem,
        )
        for row in rows
    ]
