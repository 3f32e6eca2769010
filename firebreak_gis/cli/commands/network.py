"""firebreak network: an aligned landscape in, the spread network out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np

from firebreak_gis.cli import options, outputs, weather_options
from firebreak_gis.cli.layers import input_files
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.planning.weather import WEATHER, SpreadRequest

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork

#: Place in the list of commands, which is the order of the work.
STEP = 3


@click.command("network")
@click.argument("folder", type=click.Path(file_okay=False))
@outputs.output_file("GeoTIFF of 8 bands, or 17 with --clock,")
@weather_options.spread
@weather_options.clock
@click.option(
    "--export",
    type=click.Path(dir_okay=False),
    metavar="FILE",
    help="Also write the probabilities for other tools: .mtx (Matrix Market), .mat (MATLAB), .npz (scipy.sparse) or "
    ".graphml (up to 20,000 cells with fuel). Cells are numbered row by row from the upper left.",
)
@options.fitting("network")
@options.common
@built(output=OutputRequest, spread=SpreadRequest)
def command(session: Session, folder: str, output: OutputRequest, spread: SpreadRequest, export: str | None) -> None:
    """Build the spread network of the landscape in FOLDER (made by align).

    Band d holds the probability that fire spreads from the cell to its neighbour in direction d, in the order
    N NE E SE S SW W NW. With --clock bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the
    cell releases (kJ/m2): fires on such a network can have a clock. Wind and slope then act on the times and leave the
    probabilities, unless --model-param probability_keeps= says otherwise; so take a network without --clock for
    fires without one.
    """
    from firebreak_gis.files import require_distinct, require_writable, together
    from firebreak_gis.files.graphs import require_format, write_graph
    from firebreak_gis.landscape import read_landscape_folder
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.manifest import provenance
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.spread import spread_network

    inputs = files_behind([*map(str, Path(folder).glob("*.tif")), *input_files(spread.sources)])
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    if export:
        require_format(export)
        require_writable(export, overwrite=output.overwrite, forbid=inputs)
        require_distinct({"--output": output.output, "--export": export})
    spread.require()
    landscape = read_landscape_folder(folder)
    session.progress(0.2, "spread network")
    account = Account()
    network = spread_network(landscape, model=spread.model, **spread.params(landscape, account))
    for sentence in account.alignment:
        session.say(sentence)
    for sentence in account.warnings:
        session.warn(sentence)
    if spread.clock:
        network.require_times("--clock")
    session.progress(0.6, "writing")
    told = {
        key: value
        for key, value in recorded().items()
        if key in ("model", "wind_uv", *WEATHER)
        or (key == "clock" and value)
        or (key == "neighbourhood" and value != "moore")
    }
    tags = (
        provenance({**told, "model_params": [f"{name}={value}" for name, value in spread.model_params.items()]})
        | network.provenance
    )
    files = [output.output, *([export] if export else [])]
    with together(*(Path(name).parent for name in files)):
        write_raster(
            output.output,
            network.to_dataset(),
            overwrite=output.overwrite,
            provenance=tags,
            forbid=inputs,
            creation_options=output.creation_options,
        )
        if export:
            write_graph(network, export, overwrite=output.overwrite)
    session.finish(
        {"files": files, "burnable_cells": network.n_burnable, **_pace(network)},
        f"{network.n_burnable} cells with fuel, mean edge probability "
        f"{network.probability[:, network.burnable].mean():.3f}{_told(network)}; written to {', '.join(files)}",
    )


def _pace(network: SpreadNetwork) -> dict[str, float]:
    """Median rate of spread over the edges [m/h]."""
    if network.travel_time is None:
        return {}
    rates = network.rate()[network.probability > 0]
    return {"median_rate_m_h": round(float(np.median(rates)), 1) if rates.size else 0.0}


def _told(network: SpreadNetwork) -> str:
    if network.travel_time is None:
        return ""
    left_out = network.provenance.get("left_out")
    warning = f", in the times alone: {left_out}" if left_out else ""
    return f", median rate of spread {_pace(network)['median_rate_m_h']:g} m/h{warning}"
