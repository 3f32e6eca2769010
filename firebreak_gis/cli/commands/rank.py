"""firebreak rank: a spread network in, a priority raster out."""

from __future__ import annotations

import click

from firebreak_gis.cli import kinds, options, stakes
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.landscape.stake_layers import StakesRequest


@click.command("rank")
@click.argument("network", type=kinds.RASTER)
@options.output_file("Priority GeoTIFF")
@options.ranking
@stakes.stakes
@options.seed
@options.fitting("rank")
@options.common
@built(output=OutputRequest, at_stake=StakesRequest)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    at_stake: StakesRequest,
    method: str,
    method_params: dict[str, str],
    seed: int,
) -> None:
    """Rank the cells of NETWORK by the order in which they should be cut: higher is earlier."""
    from firebreak_gis.files import require_writable
    from firebreak_gis.manifest import provenance
    from firebreak_gis.progress import part
    from firebreak_gis.ranking import rank
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.spread.raster import read_network

    inputs = files_behind([network, *at_stake.sources])
    require_writable(output.output, overwrite=output.overwrite, forbid=inputs)
    untouched = read_network(network)
    barred, placed = at_stake.read(untouched.grid).on(untouched)
    priority = rank(
        barred,
        method,
        stakes=placed,
        seed=seed,
        progress=part(session.progress, 0.05, 0.9),
        **method_params,
    )
    write_raster(
        output.output,
        priority,
        overwrite=output.overwrite,
        forbid=inputs,
        provenance=provenance({"method": method, "method_params": method_params}, seed=seed),
        creation_options=output.creation_options,
    )
    session.finish({"files": [output.output]}, f"ranked by {method}; written to {output.output}")
