"""firebreak rank: a spread network in, a priority raster out."""

from __future__ import annotations

from typing import Any

import click

from firebreak_gis.cli import kinds, options, parsing, stakes
from firebreak_gis.cli.session import Session


@click.command("rank")
@click.argument("network", type=kinds.RASTER)
@options.output_file("Priority GeoTIFF")
@options.ranking
@stakes.stakes
@options.seed
@options.fitting("rank")
@options.common
def command(session: Session, network: str, output: str, **given: Any) -> None:
    """Rank the cells of NETWORK by the order in which they should be cut: higher is earlier."""
    from firebreak_gis.files import require_writable
    from firebreak_gis.manifest import provenance
    from firebreak_gis.progress import part
    from firebreak_gis.ranking import rank
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.spread.raster import read_network

    inputs = files_behind([network, *stakes.stake_files(given)])
    require_writable(output, overwrite=given["overwrite"], forbid=inputs)
    seed = parsing.checked_seed(given["seed"])
    params = parsing.pairs(given["method_params"], "--param")
    spread, at_stake = stakes.network_and_stakes(read_network(network), given)
    priority = rank(
        spread,
        given["method"],
        stakes=at_stake,
        seed=seed,
        progress=part(session.progress, 0.05, 0.9),
        **params,
    )
    write_raster(
        output,
        priority,
        overwrite=given["overwrite"],
        forbid=inputs,
        provenance=provenance({"method": given["method"], "method_params": params}, seed=seed),
        creation_options=parsing.pairs(given["creation_options"], "--co"),
    )
    session.finish({"files": [output]}, f"ranked by {given['method']}; written to {output}")
