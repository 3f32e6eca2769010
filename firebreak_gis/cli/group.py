"""The command group: commands loaded on first use, errors turned into words and exit codes."""

from __future__ import annotations

import importlib
import json
import os
import pkgutil
import sys
import traceback
from itertools import pairwise
from typing import Any

import click

import firebreak_gis
from firebreak_gis.errors import Cancelled, FirebreakError, ResourceError

EXIT_BUG, EXIT_USAGE = 1, 2

_AS_JSON = "firebreak_gis.as_json"


class Commands(click.Group):
    """Finds commands by file, and is the one place of the program that catches errors."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - the interface of click
        """Name every command, in the order of the work."""
        found = {m.name for m in pkgutil.iter_modules(_package_path())}
        order = ["plan", "align", "network", "rank", "breaks", "segments", "burn", "evaluate"]
        return [name for name in order if name in found] + sorted(found - set(order))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import the file of a command."""
        if cmd_name not in self.list_commands(ctx):
            return None
        command = getattr(importlib.import_module(f"firebreak_gis.cli.commands.{cmd_name}"), "command")  # noqa: B009
        return command if isinstance(command, click.Command) else None

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Note before anything can fail whether errors are wanted as JSON too."""
        flags = {*args, *(f"{one}={other}" for one, other in pairwise(args))}
        ctx.meta[_AS_JSON] = bool(flags & {"--json", "--progress=json"})
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run a command; on an error say it and exit with its code."""
        as_json = ctx.meta[_AS_JSON]
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:
            _fail(Cancelled("stopped; no half-written file was left behind"), as_json)
        except FirebreakError as error:
            _fail(error, as_json)
        except MemoryError:
            _fail(
                ResourceError("out of memory; use a coarser --res, a smaller --bounds or a larger machine"),
                as_json,
            )
        except click.UsageError as error:
            if as_json:
                _print_error("usage", error.format_message(), EXIT_USAGE)
            raise
        except (click.ClickException, click.exceptions.Exit):
            raise
        except BrokenPipeError:
            # The reader has gone; a further write at exit would complain.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(EXIT_BUG)
        except Exception as error:
            if as_json:
                _print_error("bug", f"{type(error).__name__}: {error}", EXIT_BUG)
            traceback.print_exc()
            click.echo("This is a bug in firebreak_gis; please report it with the lines above.", err=True)
            sys.exit(EXIT_BUG)


def _package_path() -> list[str]:
    return list(importlib.import_module("firebreak_gis.cli.commands").__path__)


def _fail(error: FirebreakError, as_json: bool) -> None:
    if as_json:
        _print_error(error.kind, str(error), error.exit_code)
    click.echo(f"Error: {error}", err=True)
    sys.exit(error.exit_code)


def _print_error(kind: str, message: str, code: int) -> None:
    click.echo(json.dumps({"error": {"kind": kind, "message": message, "exit_code": code}}, ensure_ascii=False))


def _show_version(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        if "--json" in sys.argv:
            click.echo(json.dumps({"software": "firebreak_gis", "version": firebreak_gis.__version__}))
        else:
            click.echo(f"firebreak_gis {firebreak_gis.__version__}")
        ctx.exit()


@click.group(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    epilog="Exit codes: 0 done, 1 bug, 2 usage, 3 input refused, 4 output, 5 resources, 6 component missing, "
    "7 verification failed, 130 cancelled.",
)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_show_version,
    help="Show the version and exit (with --json as an object).",
)
@click.option("--json", "as_json", is_flag=True, hidden=True)
def firebreak(as_json: bool) -> None:
    """Plan wildfire fire breaks: rasters in, fire breaks and burn maps out.

    The main job in one command:

        firebreak plan DEM VEGETATION DENSITY -o OUT

    or step by step: align, network, rank, breaks, burn, evaluate.
    """
