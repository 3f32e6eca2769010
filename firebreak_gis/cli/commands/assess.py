"""firebreak assess: existing breaks in, what each is worth and which gap matters most out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import filters, fire_options, kinds, options, outputs, weather_options, years_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import checked_fires, input_files, tell
from firebreak_gis.cli.rehearsal import require_outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.manifest import account
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from collections.abc import Mapping

    from firebreak_gis.evaluation.assessment import Assessment
    from firebreak_gis.progress import Progress

#: Place in the list of commands, which is the order of the work.
STEP = 8


@dataclass(frozen=True)
class _Assessed:
    """What is written."""

    found: Assessment
    headline: list[str]
    told: dict[str, Any]


def _layers(made: _Assessed, path: Path, how: Writing) -> None:
    from firebreak_gis.styles.vectors import Symbol, graduated
    from firebreak_gis.vectors import write_layers

    found = made.found
    symbol: Symbol = "line" if found.breaks.geometry.geom_type.str.contains("Line").any() else "fill"
    styles = {
        "breaks": graduated(
            found.breaks["worth_ha"].to_numpy(), column="worth_ha", symbol=symbol, colours=_WORTH, label="rank"
        ),
        "gaps": graduated(
            found.gaps["saved_per_km"].to_numpy(), column="saved_per_km", symbol="line", colours=_WORTH, label="rank"
        ),
    }
    write_layers(
        path,
        {"breaks": found.breaks, "gaps": found.gaps},
        styles=styles,
        kinds={"gaps": "LineString"},
        overwrite=how.overwrite,
        forbid=how.forbid,
    )


def _table(name: str) -> Any:
    def write(made: _Assessed, path: Path, how: Writing) -> None:
        from firebreak_gis.files import write_text

        frame = getattr(made.found, name).drop(columns="geometry")
        write_text(path, frame.to_csv(index=False, lineterminator="\n", float_format="%.8g"), overwrite=how.overwrite)

    return write


def _summary(made: _Assessed, path: Path, how: Writing) -> None:
    from firebreak_gis.files import write_text

    write_text(path, "\n".join([*made.headline, *made.told["assumptions"], ""]), overwrite=how.overwrite)


#: From what is worth least to what is worth most.
_WORTH = ("#fee8c8", "#fdbb84", "#e34a33", "#b30000", "#67001f")
#: What the command writes into its folder.
OUTPUTS: tuple[Output[_Assessed], ...] = (
    Output(
        "assessment.gpkg", "Breaks with what each is worth, and gaps with what closing them saves", _layers, main=True
    ),
    Output("break_worth.csv", "What each break is worth", _table("breaks")),
    Output("gap_worth.csv", "What closing each gap saves", _table("gaps")),
    Output("summary.txt", "What stands and what is missing, in words", _summary),
    account("assess", lambda made: {"headline": made.headline, **made.told}),
)


@click.command("assess")
@click.argument("network", type=kinds.RASTER)
@click.argument("mask", metavar="BREAKS", type=kinds.RASTER_OR_VECTOR)
@outputs.output_folder(OUTPUTS)
@click.option(
    "--longest-gap",
    type=float,
    default=500.0,
    show_default=True,
    metavar="METRES",
    help="Length of the longest gap that is looked at, in metres.",
)
@click.option(
    "--most-gaps", type=kinds.SEED, default=40, show_default=True, help="Number of gaps looked at, the shortest."
)
@click.option(
    "--placements",
    type=kinds.SEED,
    default=3,
    show_default=True,
    help="Number of random places at which each break and gap is tried as well, to compare with; 0 leaves them out.",
)
@years_options.fires_per_year
@years_options.return_interval
@options.residual
@options.fires
@fire_options.judging
@weather_options.weather
@weather_options.spread
@filters.where
@options.seed
@options.fitting("burn")
@options.common
@engine
@built(output=OutputRequest, fires=FireRequest, spread=SpreadRequest, weather=WeatherRequest)
def command(
    session: Session,
    network: str,
    mask: str,
    output: OutputRequest,
    fires: FireRequest,
    spread: SpreadRequest,
    weather: WeatherRequest,
    timeless: bool,
    longest_gap: float,
    most_gaps: int,
    placements: int,
    fires_per_year: float,
    return_interval: Mapping[str, float] | None,
) -> None:
    """Judge the existing BREAKS on NETWORK: what each is worth, and which gap matters most.

    NETWORK is a file made by network, or the folder of a landscape made by align, whose fuel must still lie on the
    breaks. BREAKS are lines or polygons, each a break, or a raster, of which each connected piece is one.

    The same fires burn with all breaks, without each of them, and with each gap closed; so differences are the work of
    the break alone, with 95 % intervals. The same break at random places stands beside it. A break is worth its upkeep
    if it saves more hectares a year than must be treated anew.
    """
    import numpy as np

    from firebreak_gis.construction.years import RETURN, upkeep_rates
    from firebreak_gis.evaluation.assessment import assess, told
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.landscape.existing import existing_breaks
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.planning.scene import files_of, open_scene
    from firebreak_gis.planning.timing import Estimate, fire_seconds
    from firebreak_gis.progress import part
    from firebreak_gis.simulation.fires import burn, resolved

    fires.require_stations()
    inputs = input_files([*files_of(network), mask, *fires.sources, *spread.sources, *weather.sources])
    how = require_outputs(output, OUTPUTS, inputs)
    laid = Account()
    scene = open_scene(network, spread, weather, account=laid)
    existing = existing_breaks(mask, scene.network.grid, account=laid)
    tell(laid, session)
    judged = scene.judging(fires, timeless=timeless)
    fires = checked_fires(judged.fires, scene.network, session)
    fires = replace(fires, ignitions=resolved(scene.network, fires))
    for sentence in judged.notes:
        session.warn(sentence)
    ground = scene.ground(judged, scene.network, None)

    def burnt(cut: np.ndarray, progress: Progress) -> np.ndarray:
        breaks = cut if cut.any() else None
        sizes: np.ndarray = burn(ground.network, fires, breaks=breaks, weather=ground.weather, progress=progress)[
            "fire_size"
        ].to_numpy()
        return sizes

    def foresee(few: int, most: int) -> None:
        standing = np.zeros(scene.network.shape, bool)
        for cells in existing.cells:
            standing.ravel()[cells] = True
        seconds = 0.0
        for count, cut in ((few, None), (most, standing)):
            seconds += count * fires.n_runs * fire_seconds(ground, fires, passes=count, breaks=cut)
        session.foresee(Estimate({"fires": seconds}))

    # A network does not tell its vegetation: shrubs, unless one number is given for all.
    codes = np.full(scene.network.shape, 2) if scene.landscape is None else scene.landscape["vegetation"].to_numpy()
    intervals = return_interval or RETURN
    found = assess(
        scene.network,
        existing,
        burnt,
        longest_gap=longest_gap,
        most_gaps=most_gaps,
        placements=placements,
        upkeep=upkeep_rates(codes, intervals),
        fires_per_year=fires_per_year,
        seed=fires.seed,
        foreseen=foresee,
        progress=part(session.progress, 0.05, 0.97),
    )
    headline = told(found)
    each = ", ".join(f"{name} {years:g}" for name, years in intervals.items())
    some = "fire" if fires_per_year == 1.0 else "fires"
    known = f"{fires_per_year:g} {some} a year; years until treated fuel has grown back: {each}."
    about = {
        "assumptions": [*judged.assumptions, known],
        "alignment": laid.alignment,
        "warnings": [*laid.warnings, *judged.notes],
    }
    files = write_all(OUTPUTS, _Assessed(found, headline, about), output.output, how, progress=session.progress)
    shown = found.breaks.head(8)[
        ["rank", "number", "length_m", "worth_ha", "worth_ha_low", "worth_ha_high", "random_ha"]
    ]
    session.finish(
        {"files": files, "headline": headline, "assumptions": about["assumptions"]},
        f"{chr(10).join(headline)}\n{' '.join(about['assumptions'])}\n"
        f"{shown.to_string(index=False, float_format='%.4g')}\nwritten to {output.output}",
    )
