"""firebreak delineate: an aligned landscape in, compartments bounded by the best control lines out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import filters, fire_options, kinds, options, outputs, stakes_options, weather_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import checked_fires, input_files, read_stakes, tell
from firebreak_gis.cli.rehearsal import require_outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.outputs import Output, Writing
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.manifest import account
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from firebreak_gis.construction.delineations import Delineation

#: Place in the list of commands, which is the order of the work.
STEP = 8


@dataclass(frozen=True)
class _Delineated:
    """What is written."""

    found: Delineation
    headline: list[str]
    told: dict[str, Any]


def _layers(made: _Delineated, path: Path, how: Writing) -> None:
    from firebreak_gis.styles.vectors import graduated
    from firebreak_gis.vectors import write_layers

    pods, borders = made.found.pods, made.found.borders
    styles = {
        "pods": graduated(pods["burnt_ha"].to_numpy(), column="burnt_ha", symbol="fill", colours=_BURNT, label="pod"),
        "borders": graduated(
            borders["suitability"].to_numpy(), column="suitability", symbol="line", colours=_HELD, label=None
        ),
    }
    frames = {"pods": pods, "borders": borders}
    kinds_of = {"pods": "MultiPolygon", "borders": "MultiLineString"}
    write_layers(path, frames, styles=styles, kinds=kinds_of, overwrite=how.overwrite, forbid=how.forbid)


def _table(name: str) -> Any:
    def write(made: _Delineated, path: Path, how: Writing) -> None:
        from firebreak_gis.files import write_text

        frame = getattr(made.found, name).drop(columns="geometry")
        write_text(path, frame.to_csv(index=False, lineterminator="\n", float_format="%.8g"), overwrite=how.overwrite)

    return write


#: From what burns least to what burns most, and from lines that are hard to hold to those that are not.
_BURNT = ("#ffffcc99", "#fecc5c99", "#e31a1c99")
_HELD = ("#d7301f", "#fdae61", "#1a9850")
#: What the command writes into its folder.
OUTPUTS: tuple[Output[_Delineated], ...] = (
    Output("pods.gpkg", "Compartments bounded by control lines, and their borders", _layers, main=True),
    Output("pod_table.csv", "Compartments bounded by control lines, without outlines", _table("pods")),
    Output("border_table.csv", "Borders of the compartments, without lines", _table("borders")),
    account("delineate", lambda made: {"headline": made.headline, **made.told}),
)


@click.command("delineate")
@click.argument("folder", type=kinds.LANDSCAPE_FOLDER)
@outputs.output_folder(OUTPUTS)
@click.option(
    "--size",
    "size_ha",
    type=kinds.HECTARES,
    default="500ha",
    show_default=True,
    metavar="HECTARES",
    help="Size of the compartments, hectares of fuel; none is larger than one and a half times this.",
)
@click.option(
    "--strength",
    type=float,
    default=30.0,
    show_default=True,
    help="Number of times that the worst ground counts as much as the best, 1 to 100; 1 asks for the shortest borders.",
)
@stakes_options.rivers
@stakes_options.siting_params
@stakes_options.values
@filters.where
@options.fires
@fire_options.judging
@options.seed
@weather_options.weather
@weather_options.spread
@options.common
@engine
@built(output=OutputRequest, fires=FireRequest, spread=SpreadRequest, weather=WeatherRequest, at_stake=StakesRequest)
def command(
    session: Session,
    folder: str,
    output: OutputRequest,
    fires: FireRequest,
    spread: SpreadRequest,
    weather: WeatherRequest,
    at_stake: StakesRequest,
    timeless: bool,
    size_ha: float,
    strength: float,
    siting_params: Mapping[str, Any],
) -> None:
    """Delineate the landscape in FOLDER (made by align): compartments bounded by the best control lines.

    These are potential operational delineations (PODs). Borders are nested minimum cuts, which cost more where a line
    is hard to hold (see firebreak siting). Each compartment has its fuel, ignitions, values, what burns in simulated
    fires, and how good its border is.
    """
    from firebreak_gis.construction.delineations import delineate, square_suitability
    from firebreak_gis.files.outputs import write_all
    from firebreak_gis.landscape.folder import read_landscape_folder
    from firebreak_gis.landscape.siting import site
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.planning.scene import files_of, open_scene
    from firebreak_gis.planning.timing import Estimate, delineation_seconds, fire_seconds
    from firebreak_gis.progress import in_proportion, part
    from firebreak_gis.simulation.fires import burn

    named = (*fires.sources, *spread.sources, *weather.sources, *at_stake.sources)
    inputs = input_files([*files_of(folder), *named])
    how = require_outputs(output, OUTPUTS, inputs)
    laid = Account()
    landscape = read_landscape_folder(folder)
    scene = open_scene(folder, spread, weather, account=laid)
    network = scene.network
    planes, read = read_stakes(
        at_stake, session, grid=network.grid, fuel=network.burnable, ignitions=fires.ignitions, landscape=landscape
    )

    sited = site(landscape, roads=planes.roads, rivers=planes.rivers, **siting_params)
    tell(laid, session)
    judged = scene.judging(
        fires if planes.ignition is None else replace(fires, ignitions=planes.ignition), timeless=timeless
    )
    for sentence in judged.notes:
        session.warn(sentence)
    ground = scene.ground(judged, network, None)
    asked = checked_fires(judged.fires, network, session)
    good = sited["suitability"].to_numpy()
    burning = asked.n_runs * fire_seconds(ground, asked, passes=1)
    cutting = delineation_seconds(network, good, size_ha=size_ha, strength=strength)
    session.foresee(Estimate({"fires": burning, "control lines": cutting}))
    steps = in_proportion([burning, cutting], 0.05, 0.95)
    burns = burn(ground.network, asked, weather=ground.weather, progress=part(session.progress, *steps[0], "fires: "))
    factors = {
        str(name).removeprefix("suitability_"): sited[name].to_numpy() for name in sited if name != "suitability"
    }
    found = delineate(
        network,
        good,
        size_ha=size_ha,
        strength=strength,
        factors=factors,
        vegetation=landscape["vegetation"],
        value=planes.value,
        ignition=planes.ignition,
        burn_frequency=burns["burn_frequency"],
        progress=part(session.progress, *steps[1]),
    )
    length = found.borders["length_m"]
    square = square_suitability(good, network.burnable, size_ha / network.grid.cell_area_ha)
    fuel = found.pods["fuel_ha"]
    headline = [
        (
            f"{len(fuel)} compartments of {fuel.min():,.4g} to {fuel.max():,.4g} ha of fuel, "
            f"{float(length.sum()) / 1000:,.4g} km of borders between them."
        ),
        (
            f"Mean suitability of the borders {found.suitability:.2f}; along a square grid of such compartments "
            f"{square:.2f}, of all fuel {float(good[network.burnable].mean()):.2f}."
        ),
    ]
    about = {
        "assumptions": [*judged.assumptions, "What each factor of the siting counts is assumed."],
        "alignment": [*laid.alignment, *read.alignment],
        "warnings": [*laid.warnings, *read.warnings, *judged.notes],
    }
    files = write_all(
        OUTPUTS, _Delineated(found, headline, about), output.output, how, progress=part(session.progress, 0.95, 1.0)
    )
    session.finish(
        {
            "files": files,
            "headline": headline,
            "compartments": len(fuel),
            "km": float(length.sum()) / 1000,
            "border_suitability": found.suitability,
            "assumptions": about["assumptions"],
        },
        "\n".join([*headline, *about["assumptions"], f"written to {output.output}"]),
    )
