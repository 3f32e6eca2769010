"""firebreak network: an aligned landscape in, the spread network out."""

from __future__ import annotations

from pathlib import Path

import click

from firebreak_gis.cli import kinds, options, outputs, weather_options
from firebreak_gis.cli.layers import input_files
from firebreak_gis.cli.requests import built, recorded
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.planning.weather import WEATHER, SpreadRequest

#: Place in the list of commands, which is the order of the work.
STEP = 3


@click.command("network")
@click.argument("folder", type=kinds.LANDSCAPE_FOLDER)
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
@click.option(
    "--bits",
    type=click.Choice(["exact", "16", "8"]),
    default="exact",
    show_default=True,
    help="Bits of a number in the file. With 16 probabilities are wrong by 8e-6 at most, times and heat by 0.013 %; "
    "with 8 by 0.002 and 3.4 %. Every command reads such files.",
)
@options.fitting("network")
@options.common
@built(output=OutputRequest, spread=SpreadRequest)
def command(
    session: Session, folder: str, output: OutputRequest, spread: SpreadRequest, export: str | None, bits: str
) -> None:
    """Build the spread network of the landscape in FOLDER (made by align).

    Band d holds the probability that fire spreads from the cell to its neighbour in direction d, in the order
    N NE E SE S SW W NW. With --clock bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the
    cell releases (kJ/m2): fires on such a network can have a clock. Wind and slope then act on the times and leave the
    probabilities, unless --model-param probability_keeps= says otherwise; so take a network without --clock for
    fires without one.
    """
    from firebreak_gis.files import require_distinct, require_writable, together
    from firebreak_gis.files.graphs import require_format, write_graph
    from firebreak_gis.landscape.folder import LandscapeFolder
    from firebreak_gis.manifest import provenance
    from firebreak_gis.planning.blocks import NetworkBlocks
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, write_blocks
    from firebreak_gis.rasters.packing import errors_of

    inputs = files_behind([*map(str, Path(folder).glob("*.tif")), *input_files(spread.sources)])
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    if export:
        require_format(export)
        require_writable(export, overwrite=output.overwrite, forbid=inputs)
        require_distinct({"--output": output.output, "--export": export})
    spread.require()
    landscape = LandscapeFolder(folder)
    made = NetworkBlocks(landscape, spread, progress=part(session.progress, 0.0, 0.7))
    for sentence in made.account.alignment:
        session.say(sentence)
    for sentence in made.account.warnings:
        session.warn(sentence)
    told = {
        key: value
        for key, value in recorded().items()
        if key in ("model", "wind_uv", *WEATHER)
        or (key == "clock" and value)
        or (key == "neighbourhood" and value != "moore")
    }
    tags = (
        provenance({**told, "model_params": [f"{name}={value}" for name, value in spread.model_params.items()]})
        | made.provenance
    )
    files = [output.output, *([export] if export else [])]
    few = None if bits == "exact" else int(bits)
    errors = {} if few is None else errors_of(few, timed=spread.clock)
    tags |= errors
    with together(*(Path(name).parent for name in files)):
        write_blocks(
            output.output,
            made,
            landscape.grid,
            overwrite=output.overwrite,
            provenance=tags,
            forbid=inputs,
            creation_options=output.creation_options,
            bits=few,
        )
        if export:
            write_graph(made.whole(), export, overwrite=output.overwrite)
    warning = f", in the times alone: {made.provenance['left_out']}" if made.provenance.get("left_out") else ""
    pace = {} if made.rate is None else {"median_rate_m_h": made.rate}
    told_pace = "" if made.rate is None else f", median rate of spread {made.rate:g} m/h{warning}"
    megabytes = Path(output.output).stat().st_size / 1e6
    told_errors = "".join(f", {name.replace('_', ' ')} at most {error:.2g}" for name, error in errors.items())
    session.finish(
        {"files": files, "burnable_cells": made.n_burnable, **pace, **errors},
        f"{made.n_burnable} cells with fuel, mean edge probability {made.mean:.3f}{told_pace}{told_errors}; written to "
        f"{', '.join(files)} ({megabytes:.3g} MB)",
    )
