"""Options of where the result goes, the same for all commands: claimed, distinct, and looked at before the work."""

from __future__ import annotations

import contextlib
import functools
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

import click

from firebreak_gis.cli import kinds

if TYPE_CHECKING:
    from firebreak_gis.files.outputs import Output

F = TypeVar("F", bound=Callable[..., Any])

#: Where a command keeps the table of its outputs.
_TABLE = "firebreak_outputs"


def _settle_xarray() -> None:
    """Make a first array while nothing large is held.

    xarray then loads dask if it is installed, and dask keeps the calling functions' variables for good.
    """
    import numpy as np
    import xarray as xr

    xr.Variable("x", np.zeros(1))


def output_folder(
    table: Sequence[Output[Any]], *, default: str | None = None, required: bool = True, more: str = ""
) -> Callable[[F], F]:
    """-o DIR and --overwrite; other runs are kept out of the folder while the command writes what the table names."""

    def decorate(command: F) -> F:
        @functools.wraps(command)
        def wrapper(*args: Any, **kwargs: Any) -> Any:
            from firebreak_gis.files import claiming

            if kwargs.get("dry_run") or kwargs["output"] is None:
                return command(*args, **kwargs)
            _settle_xarray()  # the command's own variables do not exist yet
            with claiming(kwargs["output"], folder=True):
                return command(*args, **kwargs)

        setattr(wrapper, _TABLE, table)
        option = click.option(
            "-o",
            "--output",
            type=click.Path(file_okay=False),
            required=required and default is None,
            default=default,
            show_default=default is not None,
            help=f"Folder to write into; made if it does not exist.{more}",
        )
        return overwrite(option(wrapper))  # type: ignore[return-value]

    return decorate


def outputs_of(command: click.Command) -> Sequence[Output[Any]]:
    """What a command writes into its folder; nothing for one that writes single files."""
    table: Sequence[Output[Any]] = getattr(command.callback, _TABLE, ())
    return table


def listed(command: click.Command) -> str:
    """Name, for help pages, the files that a command writes into its folder; nothing for one that has none."""
    table = outputs_of(command)
    width = max((len(output.name) for output in table), default=0)
    lines = [f"  {output.name:{width}}  {output.label}" for output in table]
    return "\n".join(["\b", "Files written:", *lines]) if table else ""


def _claiming_files(command: F) -> F:
    """Look at every file that the options name to be written, and keep other runs from writing them meanwhile."""

    @functools.wraps(command)
    def wrapper(*args: Any, **kwargs: Any) -> Any:
        from firebreak_gis.files import claiming, require_distinct

        asked = click.get_current_context().command.params
        files = {max(p.opts, key=len): kwargs[str(p.name)] for p in asked if isinstance(p.type, kinds.NewFile)}
        files = {flag: path for flag, path in files.items() if path is not None}
        require_distinct(files)
        _settle_xarray()  # the command's own variables do not exist yet
        with contextlib.ExitStack() as claims:
            for path in sorted(files.values(), key=os.path.realpath):
                claims.enter_context(claiming(path))
            return command(*args, **kwargs)

    return wrapper  # type: ignore[return-value]


def output_file(what: str, kind: kinds.NewFile = kinds.NEW_RASTER) -> Callable[[F], F]:
    """-o FILE and --overwrite; all files that options of the command name to be written are claimed for it."""

    def decorate(command: F) -> F:
        option = click.option("-o", "--output", type=kind, metavar="FILE", required=True, help=f"{what} to write.")
        command = option(_claiming_files(command))
        return overwrite(command) if kind is kinds.NEW_RASTER else _overwrite(command)

    return decorate


def overwrite(command: F) -> F:
    """--overwrite and --co."""
    command = click.option(
        "--co",
        "creation_options",
        multiple=True,
        callback=kinds.pairs,
        metavar="NAME=VALUE",
        help="Creation option of GDAL's COG driver, e.g. COMPRESS=ZSTD.",
    )(command)
    return _overwrite(command)


_overwrite = click.option("--overwrite", is_flag=True, help="Replace existing files.")
#: --what: the layer of segments that goes into a format with one.
what = click.option(
    "--what",
    type=click.Choice(["lines", "polygons"]),
    help="Layer of the segments to write: middle lines or outlines [default: both in .gpkg, else the lines].",
)
