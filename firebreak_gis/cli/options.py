"""Options that several commands share; a name means the same everywhere."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import click

from firebreak_gis import memory
from firebreak_gis.cli import kinds
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.manifest import is_shared_config, read_config

F = TypeVar("F", bound=Callable[..., Any])

#: What a configuration, perhaps a stranger's, never decides: where is written, what is replaced, what is fetched, and
#: who gets the data.
_COMMAND_LINE_ONLY: frozenset[str | None] = frozenset({"output", "overwrite", "remote", "scheduler"})
_LEFT_OUT = "firebreak_gis.left_out"


def _load_config(ctx: click.Context, _: click.Parameter, path: str | None) -> str | None:
    if path is not None:
        names = {flag.lstrip("-"): p.name for p in ctx.command.params for flag in p.opts}
        given = {
            str(names.get(key, key)).replace("-", "_"): [f"{k}={v}" for k, v in value.items()]
            if isinstance(value, Mapping)
            else value
            for key, value in read_config(path).items()
        }
        known = {p.name for p in ctx.command.params}
        strangers = sorted(set(given) - known)
        if is_shared_config(path):
            given = {key: value for key, value in given.items() if key in known}
        elif strangers:
            raise ParameterError(
                f"{path} has parameters that {ctx.command.name} does not know: {', '.join(strangers)}; "
                f"it knows {', '.join(sorted(str(k) for k in known))}"
            )
        ours = _COMMAND_LINE_ONLY | {p.name for p in ctx.command.params if isinstance(p.type, kinds.NewFile)}
        ctx.meta[_LEFT_OUT] = path, sorted(name for name in ours & set(given) if name and given[name])
        ctx.default_map = {**(ctx.default_map or {}), **{k: v for k, v in given.items() if k not in ours}}
    return path


def common(command: F) -> F:
    """--json, --progress, -v, -q, --config; the command gets a `Session` as `session`."""

    @click.option(
        "--config",
        type=click.Path(exists=True, dir_okay=False),
        is_eager=True,
        expose_value=False,
        callback=_load_config,
        help="Take parameters from a TOML file, or from the run.json of an earlier run; options given here win.",
    )
    @click.option("--json", "as_json", is_flag=True, help="Print the result as one JSON object on stdout.")
    @click.option(
        "--progress",
        "progress_mode",
        type=click.Choice(["bar", "json", "none"]),
        default="bar",
        show_default=True,
        help="How progress is shown; json prints lines on stdout and stops when it reads 'cancel' or the end of stdin.",
    )
    @click.option("-v", "--verbose", is_flag=True, help="Say more.")
    @click.option("-q", "--quiet", is_flag=True, help="Say only warnings and errors.")
    @functools.wraps(command)
    def wrapper(*args: Any, as_json: bool, progress_mode: str, verbose: bool, quiet: bool, **kwargs: Any) -> Any:
        memory.return_large()
        session = Session(as_json, progress_mode, -1 if quiet else int(verbose))
        context = click.get_current_context()
        context.call_on_close(session.close)
        path, left_out = context.meta.get(_LEFT_OUT, ("", []))
        if left_out:
            session.warn(f"{path} sets {', '.join(left_out)}, which counts on the command line only; it was left out")
        return command(*args, session=session, **kwargs)

    return wrapper  # type: ignore[return-value]


def dry_run(command: F) -> F:
    """--dry-run."""
    return click.option(
        "--dry-run",
        is_flag=True,
        help="Read headers only, check grid, memory, disk and outputs, say what would be done, and write nothing.",
    )(command)


_max_memory = click.option(
    "--max-memory",
    type=kinds.SIZE,
    metavar="SIZE",
    help="Refuse work that needs more, e.g. 4GB [default: most of what there is].",
)


def fitting(work: str) -> Callable[[F], F]:
    """--max-memory, held against what the command needs for a network (or folder) of the size that its header tells."""

    def decorate(command: F) -> F:
        @functools.wraps(command)
        def wrapper(*args: Any, max_memory: int | None, **kwargs: Any) -> Any:
            _require_room(work, kwargs, max_memory)
            return command(*args, **kwargs)

        return _max_memory(wrapper)  # type: ignore[return-value]

    return decorate


def _require_room(work: str, given: Mapping[str, Any], max_memory: int | None) -> None:
    from firebreak_gis import plugins
    from firebreak_gis.rasters import read_header, variable_bands

    try:
        place = Path(given.get("network") or given["folder"])
        source = str(place / "elevation.tif" if "folder" in given or place.is_dir() else place)
        rows, cols = read_header(source, band=1).shape
        clock = bool(given.get("clock")) or "travel_time" in variable_bands(source)
    except InputError:
        return  # the command says it better
    names = [method.name for method in given.get("method_list", ())]
    names += [given["method"]] if "method" in given else []
    needed = memory.bytes_for(
        work,
        rows * cols,
        method=",".join(names),
        clock=clock,
        products=bool(given.get("products")),
        window=given.get("window"),
        workers=given.get("workers"),
        blocks=work == "rank"
        or (work == "network" and not given.get("export") and plugins.halo_of(given["model"]) is not None),
    )
    memory.require_memory(needed, f"firebreak {work} on {rows} x {cols} cells", max_memory=max_memory)
    memory.suit(needed, max_memory=max_memory)


def inputs(command: F) -> F:
    """DEM [VEGETATION] [DENSITY]; DEM alone is a landscape file."""
    command = click.argument("density", type=kinds.RASTER_OR_DENSITY, required=False)(command)
    command = click.argument("vegetation", type=kinds.RASTER, required=False)(command)
    return click.argument("dem", type=kinds.RASTER)(command)


def landscape(command: F) -> F:
    """How the layers are read and laid on one grid."""
    options = [
        click.option(
            "--legend",
            type=kinds.LEGEND,
            metavar="LEGEND",
            default="paper",
            show_default=True,
            help="What the vegetation codes mean: a built-in name (firebreak legends) or a CSV file.",
        ),
        click.option(
            "--density-legend",
            type=kinds.LEGEND,
            metavar="LEGEND",
            default="density",
            show_default=True,
            help="What the density codes mean: a built-in name or a CSV file.",
        ),
        click.option(
            "--dst-crs",
            "crs",
            type=kinds.CRS,
            metavar="CRS",
            help="CRS of the grid, projected in metres [default: the DEM's if it is in metres, else the UTM zone].",
        ),
        click.option("--res", "resolution", type=float, metavar="METRES", help="Cell size [default: the DEM's]."),
        click.option(
            "--bounds",
            type=float,
            nargs=4,
            metavar="LEFT BOTTOM RIGHT TOP",
            help="Extent in the CRS of the grid [default: what all layers cover].",
        ),
        click.option("--like", type=kinds.RASTER, metavar="RASTER", help="Take the grid of this raster."),
        click.option(
            "--src-crs",
            multiple=True,
            callback=kinds.LAYER_CRS,
            metavar="[LAYER=]CRS",
            help="The true CRS of dem, vegetation or density, or of all, where a file tells none or a wrong one.",
        ),
        click.option(
            "--src-nodata",
            multiple=True,
            callback=kinds.LAYER_NODATA,
            metavar="LAYER=VALUES",
            help="Values that mean no data in dem, vegetation or density, e.g. dem=-9999,32767; dem=none says "
            "that all are data; may be repeated.",
        ),
        click.option(
            "--bidx",
            multiple=True,
            callback=kinds.LAYER_BAND,
            metavar="LAYER=BAND",
            help="Band to read of dem, vegetation or density.",
        ),
        click.option(
            "--unknown",
            type=click.Choice(["refuse", "nonburnable"]),
            default="refuse",
            show_default=True,
            help="What to do with codes that the legend does not list.",
        ),
        click.option("--strict", is_flag=True, help="Refuse what would only be warned of."),
        click.option(
            "--remote", is_flag=True, help="Allow DEM, VEGETATION and DENSITY to be network addresses or in archives."
        ),
        _max_memory,
    ]
    return _apply(options, command)


def ranking(command: F) -> F:
    """--method and -p."""
    options = [
        click.option(
            "--method",
            type=kinds.RANKING,
            metavar="NAME",
            default="dissection",
            show_default=True,
            help="Ranking (firebreak methods).",
        ),
        click.option(
            "-p",
            "--param",
            "method_params",
            multiple=True,
            callback=kinds.pairs,
            metavar="NAME=VALUE",
            help="Parameter of the ranking, e.g. beta=0.5; may be repeated.",
        ),
    ]
    return _apply(options, command)


def fires(command: F) -> F:
    """--runs, --ignitions, --ignition-mode, --ignitions-outside."""
    options = [
        click.option("--runs", "n_runs", type=kinds.COUNT, default=100, show_default=True, help="Simulated fires."),
        click.option(
            "--ignitions",
            type=kinds.VECTOR_OR_RASTER,
            metavar="PATH",
            help="Points, polygons (perimeters that burn already; any vector file, or CSV with x and y) or a raster of "
            "ignition probability [default: one random cell with fuel a run].",
        ),
        click.option(
            "--ignition-mode",
            type=click.Choice(["each", "all", "density"]),
            default="each",
            show_default=True,
            help="With points or polygons: runs take them in turn (the seed draws the order), start at all of them, or "
            "start where such fires of the past are dense.",
        ),
        click.option(
            "--ignitions-outside",
            type=click.Choice(["refuse", "drop"]),
            default="refuse",
            show_default=True,
            help="What to do with points and polygons off the landscape or without fuel.",
        ),
    ]
    return _apply(options, command)


def ignition_map(command: F) -> F:
    """--ignitions, a raster."""
    return click.option(
        "--ignitions",
        type=kinds.RASTER,
        metavar="RASTER",
        help="How likely a fire starts in each cell, relative to the others [default: alike].",
    )(command)


def seed(command: F) -> F:
    """--seed."""
    return click.option("--seed", type=kinds.SEED, default=0, show_default=True, help="Seed of all draws.")(command)


def budget(command: F) -> F:
    """--budget and --budget-unit."""
    options = [
        click.option(
            "--budget",
            type=kinds.BUDGET,
            metavar="AMOUNT",
            default="10%",
            show_default=True,
            help="How much to cut: a share of the cells that hold fuel such as 10% or 0.1, an area such as 5ha, or "
            "money such as 20000eur (with --cost; in the currency of the costs).",
        ),
        click.option(
            "--budget-unit",
            type=click.Choice(["share", "ha", "cost"]),
            help="What a plain number for --budget counts: a share of the fuel, hectares, or money [default: share].",
        ),
    ]
    return _apply(options, command)


def dem(command: F) -> F:
    """--dem, for rankings."""
    return click.option(
        "--dem", type=kinds.RASTER, metavar="RASTER", help="Elevation, for methods that follow ridges [m]."
    )(command)


def leaks(command: F) -> F:
    """--width and --residual."""
    command = click.option(
        "--width",
        type=float,
        metavar="METRES",
        help="Least width of the breaks, rounded up to whole cells [default: one cell, or the best for --residual].",
    )(command)
    return residual(command)


def residual(command: F) -> F:
    """--residual."""
    return click.option(
        "--residual",
        type=float,
        default=0.0,
        show_default=True,
        help="Share of its spread probability that a treated cell keeps; 0 is a perfect break, real ones leak.",
    )(command)


def _apply(options: list[Callable[[Any], Any]], command: F) -> F:
    for option in reversed(options):
        command = option(command)
    return command
