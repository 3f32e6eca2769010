"""firebreak burn: a spread network or a landscape in, and perhaps breaks; burn frequency and what is asked out."""

from __future__ import annotations

from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.cli import filters, fire_options, kinds, options, outputs, weather_options
from firebreak_gis.cli.engine_options import engine
from firebreak_gis.cli.layers import checked_fires, input_files, read_breaks, read_kept, read_line_breaks
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.files.request import OutputRequest
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.schema import percent
from firebreak_gis.simulation.request import FireRequest

if TYPE_CHECKING:
    from firebreak_gis.grid import Grid
    from firebreak_gis.simulation.weather import Weather

#: Place in the list of commands, which is the order of the work.
STEP = 7


@click.command("burn")
@click.argument("network", type=kinds.RASTER)
@outputs.output_file("Burn frequency GeoTIFF")
@click.option(
    "--breaks",
    "mask",
    type=kinds.RASTER_OR_VECTOR,
    metavar="PATH",
    help="Cut cells: a raster (firebreak breaks), or own breaks as polygons or lines.",
)
@click.option(
    "--line-width",
    type=kinds.LINE_WIDTH,
    metavar="METRES|COLUMN",
    help="Take --breaks as lines of this width, such as 12m, or of the width in that column; they may be narrower than "
    "a cell, and stop fire between the cells that they part [default: lines take every cell that they touch].",
)
@click.option(
    "--barriers",
    type=kinds.VECTOR_OR_RASTER,
    metavar="PATH",
    help="Roads, rivers and the like on ground that the network holds as fuel; they stop fire as --barriers-hold says.",
)
@click.option("--sizes", type=kinds.NEW_TABLE, metavar="FILE", help="Also write the fire sizes as CSV.")
@options.residual
@click.option(
    "--kept",
    type=kinds.RASTER,
    metavar="RASTER",
    help="What each cell keeps of its spread probability once it is treated, in place of one --residual for all: "
    "kept.tif of a plan with treatments.",
)
@options.fires
@fire_options.window
@fire_options.clock
@fire_options.holding
@weather_options.weather
@weather_options.spread
@fire_options.products
@filters.where
@options.seed
@options.fitting("burn")
@options.common
@engine
@built(output=OutputRequest, fires=FireRequest, spread=SpreadRequest, weather=WeatherRequest)
def command(
    session: Session,
    network: str,
    output: OutputRequest,
    fires: FireRequest,
    spread: SpreadRequest,
    weather: WeatherRequest,
    mask: str | None,
    line_width: float | str | None,
    kept: str | None,
    barriers: str | None,
    sizes: str | None,
    products: str | None,
    window: int | None,
    by: list[float],
    size_classes: list[float],
    flame_lengths: list[float],
) -> None:
    """Burn NETWORK many times and write how often each cell burns.

    NETWORK is a file made by network, or the folder of a landscape made by align, with --wind-speed or --weather.

    With the same --seed the fires are the same with and without --breaks, so their difference is the breaks'
    work alone.
    """
    from firebreak_gis.files import require_writable, together, write_text
    from firebreak_gis.landscape.masks import mask_plane
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.manifest import provenance
    from firebreak_gis.planning.maps import MapInFiles
    from firebreak_gis.planning.scene import read_scene
    from firebreak_gis.planning.timing import Estimate, fire_seconds, window_seconds
    from firebreak_gis.progress import part
    from firebreak_gis.rasters import files_behind, write_raster
    from firebreak_gis.simulation.fires import burn
    from firebreak_gis.simulation.ground import Ground
    from firebreak_gis.simulation.products import Products
    from firebreak_gis.simulation.windows import SIDE, burn_windows, fuel_map
    from firebreak_gis.simulation.writing import product_files, size_table, write_products

    fires.require_stations()
    folder = Path(network)
    given = [str(file) for file in folder.glob("*.tif")] if folder.is_dir() else [network]
    given += input_files([*spread.sources, *weather.sources])
    inputs = files_behind(filter(None, (*given, mask, kept, barriers, *fires.sources)))
    files = [output.output] + ([sizes] if sizes else [])
    for name in files:
        require_writable(name, overwrite=output.overwrite, forbid=inputs)
    account = Account()
    clock = fires.needs_times or products is not None
    source = None
    if window is None:
        untouched, networks = read_scene(network, spread, weather, clock=clock, account=account)
        ensemble = networks.weather if networks else None
    else:
        if products:
            raise ParameterError("--products are kept for every cell of the map; leave --window or --products out")
        source = MapInFiles(network, spread, weather, clock=clock)
        untouched, ensemble = fuel_map(source), source.weather
    for sentence in account.warnings:
        session.warn(sentence)
    wanted = None
    if products:
        flames = () if untouched.heat is None else tuple(flame_lengths)
        wanted = Products(tuple(by), (0.1, 0.5), tuple(size_classes), flames, paths=True)
    if products and wanted:
        untouched.require_times("--products")
        made = [str(Path(products) / name) for name in product_files(wanted, referenced=untouched.grid.crs is not None)]
        for name in made:
            require_writable(name, overwrite=output.overwrite, forbid=inputs)
    asked = fires
    if kept:
        fires = replace(fires, residual=read_kept(kept, fires.residual, untouched))
    checked = checked_fires(fires, untouched, session)
    cut = _breaks(mask, line_width, untouched.grid, session)
    barred = None
    if barriers:
        barred = mask_plane(barriers, untouched.grid, what="barriers", rule="touched", solid=True)
    share_done = part(session.progress, 0.02, 0.98)
    if source is None:
        each = fire_seconds(Ground(untouched, networks, barred), checked, passes=1, breaks=cut, products=wanted)
        session.foresee(Estimate({"fires": checked.n_runs * each}))
        walls: dict[str, Any] = {"breaks": cut, "barriers": barred}
        burns = burn(untouched, checked, weather=networks, products=wanted, progress=share_done, **walls)
    else:
        source.breaks, source.barriers = cut, barred
        side = window or SIDE
        session.foresee(Estimate({"fires": window_seconds(source, checked, side=side)}))
        burns = burn_windows(source, checked, side=side, progress=share_done)
    assumptions = [*fires.assumptions, *(_told(weather.weather, ensemble) if ensemble else [])]
    # What makes no difference is not told, so that equal fires have equal files as fields are added.
    usual = ("ignitions", "ignition_mode", "n_runs", "residual")
    default = asdict(FireRequest(seed=fires.seed))
    told = {key: value for key, value in asdict(asked).items() if key in usual or value != default[key]}
    told |= {} if line_width is None else {"line_width": line_width}
    told |= {} if kept is None else {"kept": True}
    tags = provenance({**told, "breaks": mask is not None}, seed=fires.seed)
    if not fires.timeless or ensemble:
        tags["assumptions"] = "; ".join(assumptions)
    cells = burns["fire_size"].to_numpy()
    rasters: dict[str, Any] = {
        "overwrite": output.overwrite,
        "forbid": inputs,
        "provenance": tags,
        "creation_options": output.creation_options,
    }
    with together(*(Path(name).parent for name in files), *([Path(products)] if products else [])):
        write_raster(output.output, burns["burn_frequency"], **rasters)
        if sizes:
            text = size_table(burns, untouched.grid).to_csv(index=False, lineterminator="\n")
            write_text(sizes, text, overwrite=output.overwrite)
        if products:
            files += write_products(products, burns, untouched.grid, **rasters)
    share = cells.mean() / untouched.n_burnable
    hectares = cells * untouched.grid.cell_area_ha
    session.finish(
        {
            "files": files,
            "mean_burnt_share": share,
            "max_burnt_share": cells.max() / untouched.n_burnable,
            "mean_ha": float(hectares.mean()),
            "max_ha": float(hectares.max()),
            "assumptions": assumptions,
        },
        f"{cells.size} runs, mean burnt share {percent(share)}, mean fire {hectares.mean():.4g} ha; "
        f"{'; '.join(assumptions)}; written to {', '.join(files)}",
    )


def _breaks(source: str | None, line_width: float | str | None, grid: Grid, session: Session) -> Any:
    """What is cut: cells, lines, or None."""
    if source is None:
        if line_width is not None:
            raise ParameterError("--line-width is that of the lines in --breaks; give them too")
        return None
    if line_width is not None:
        return read_line_breaks(source, grid, line_width, session)
    return read_breaks(source, grid, session)


def _told(source: str | None, weather: Weather) -> list[str]:
    found = weather.describe()
    n = found["weathers"]
    return [f"weather of {source}: {n} of mean wind {found['mean_wind_speed']:g} m/s, drawn by their weights"]
