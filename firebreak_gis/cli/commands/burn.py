"""firebreak burn: a spread network and perhaps breaks in, burn frequency out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, parsing
from firebreak_gis.cli.session import Session


@click.command("burn")
@click.argument("network", type=kinds.RASTER)
@options.output_file("Burn frequency GeoTIFF")
@click.option("--breaks", "mask", type=kinds.RASTER, metavar="RASTER", help="Mask of cut cells (firebreak breaks).")
@click.option("--sizes", type=kinds.NEW_TABLE, metavar="FILE", help="Also write the fire sizes as CSV.")
@options.residual
@options.fires
@options.seed
@options.fitting("burn")
@options.common
def command(session: Session, network: str, output: str, mask: str | None, sizes: str | None, **given: Any) -> None:
    """Burn NETWORK many times and write how often each cell burns.

    With the same --seed the fires are the same with and without --breaks, so their difference is the breaks'
    work alone.
    """
    from firebreak_gis.files import require_writable, together, write_text
    from firebreak_gis.landscape.planes import ignition_source
    from firebreak_gis.manifest import provenance
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, read_variable, write_raster
    from firebreak_gis.simulation.fires import simulate
    from firebreak_gis.spread.raster import read_network

    inputs = files_behind(filter(None, (network, mask, given["ignitions"])))
    files = [output] + ([sizes] if sizes else [])
    for name in files:
        require_writable(name, overwrite=given["overwrite"], forbid=inputs)
    seed = parsing.checked_seed(given["seed"])
    spread = read_network(network)
    fires = {key: given[key] for key in ("n_runs", "ignitions", "ignition_mode")}
    burns = simulate(
        spread,
        **(fires | {"ignitions": ignition_source(given["ignitions"], spread.grid)}),
        breaks=read_variable(mask, "breaks") if mask else None,
        residual=given["residual"],
        seed=seed,
        progress=part(session.progress, 0.05, 0.95),
    )
    tags = provenance({**fires, "breaks": mask is not None, "residual": given["residual"]}, seed=seed)
    cells = burns["fire_size"].to_numpy()
    with together(Path(output).parent):
        write_raster(
            output,
            burns["burn_frequency"],
            overwrite=given["overwrite"],
            provenance=tags,
            forbid=inputs,
            creation_options=parsing.pairs(given["creation_options"], "--co"),
        )
        if sizes:
            table = burns["fire_size"].to_dataframe(name="cells").reset_index()
            table["ha"] = (table["cells"] * spread.grid.cell_area_ha).round(6)
            write_text(sizes, table.to_csv(index=False, lineterminator="\n"), overwrite=given["overwrite"])
    share = cells.mean() / spread.n_burnable
    session.finish(
        {"files": files, "mean_burnt_share": share, "max_burnt_share": cells.max() / spread.n_burnable},
        f"{cells.size} runs, mean burnt share {100 * share:.1f} %; written to {', '.join(files)}",
    )
