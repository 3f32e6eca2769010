"""firebreak burn: a spread network and perhaps breaks in, burn frequency out."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import click

from firebreak_gis.cli import filters, kinds, options, outputs
from firebreak_gis.cli.layers import checked_fires, read_breaks
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.simulation.request import FireRequest


@click.command("burn")
@click.argument("network", type=kinds.RASTER)
@outputs.output_file("Burn frequency GeoTIFF")
@click.option(
    "--breaks",
    "mask",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    help="Cut cells: a raster (firebreak breaks), or own breaks as polygons or lines.",
)
@click.option("--sizes", type=kinds.NEW_TABLE, metavar="FILE", help="Also write the fire sizes as CSV.")
@options.residual
@options.fires
@filters.where
@options.seed
@options.fitting("burn")
@options.common
@built(output=OutputRequest, fires=FireRequest)
def command(
    session: Session, network: str, output: OutputRequest, fires: FireRequest, mask: str | None, sizes: str | None
) -> None:
    """Burn NETWORK many times and write how often each cell burns.

    With the same --seed the fires are the same with and without --breaks, so their difference is the breaks'
    work alone.
    """
    from firebreak_gis.files import require_writable, together, write_text
    from firebreak_gis.manifest import provenance
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.simulation.fires import burn
    from firebreak_gis.spread.raster import read_network

    inputs = files_behind(filter(None, (network, mask, *fires.sources)))
    files = [output.output] + ([sizes] if sizes else [])
    for name in files:
        require_writable(name, overwrite=output.overwrite, forbid=inputs)
    untouched = read_network(network)
    burns = burn(
        untouched,
        checked_fires(fires, untouched, session),
        breaks=read_breaks(mask, untouched.grid, session) if mask else None,
        progress=part(session.progress, 0.05, 0.95),
    )
    # What makes no difference is not told, so that equal fires have equal files as fields are added.
    usual = ("ignitions", "ignition_mode", "n_runs", "residual")
    default = asdict(FireRequest(seed=fires.seed))
    told = {key: value for key, value in asdict(fires).items() if key in usual or value != default[key]}
    tags = provenance({**told, "breaks": mask is not None}, seed=fires.seed)
    cells = burns["fire_size"].to_numpy()
    with together(*(Path(name).parent for name in files)):
        write_raster(
            output.output,
            burns["burn_frequency"],
            overwrite=output.overwrite,
            provenance=tags,
            forbid=inputs,
            creation_options=output.creation_options,
        )
        if sizes:
            table = burns["fire_size"].to_dataframe(name="cells").reset_index()
            table["ha"] = (table["cells"] * untouched.grid.cell_area_ha).round(6)
            write_text(sizes, table.to_csv(index=False, lineterminator="\n"), overwrite=output.overwrite)
    share = cells.mean() / untouched.n_burnable
    session.finish(
        {"files": files, "mean_burnt_share": share, "max_burnt_share": cells.max() / untouched.n_burnable},
        f"{cells.size} runs, mean burnt share {100 * share:.1f} %; written to {', '.join(files)}",
    )
