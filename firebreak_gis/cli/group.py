"""The command group: commands loaded on first use, errors turned into words and exit codes."""

from __future__ import annotations

import contextlib
import difflib
import errno
import importlib
import json
import os
import pkgutil
import signal
import sys
import threading
import traceback
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any, NoReturn

import click

import firebreak_gis
from firebreak_gis.cli import outputs
from firebreak_gis.errors import (
    Cancelled,
    FirebreakError,
    InputError,
    MissingComponentError,
    OutputError,
    ResourceError,
)
from firebreak_gis.files.commit import ENDINGS
from firebreak_gis.files.locks import reason

EXIT_BUG = 1
#: Exit code, less the number of the signal, of a process that was asked to end.
ENDED = 128

_AS_JSON = "firebreak_gis.as_json"


class Commands(click.Group):
    """Finds commands by file, and is the one place of the program that catches errors."""

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - the interface of click
        """Name every command: those with a `STEP` in the order of the work, then the others."""
        return sorted(_names(), key=lambda name: (getattr(_module(name), "STEP", sys.maxsize), name))

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:  # noqa: ARG002
        """Import the file of a command; its help ends with the files that it writes."""
        if cmd_name not in _names():
            return None
        command = _module(cmd_name).command
        if not isinstance(command, click.Command):
            return None
        for one in (command, *(command.commands.values() if isinstance(command, click.Group) else ())):
            one.epilog = outputs.listed(one) or one.epilog
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the commands with their whole first sentence, over as many lines as it takes."""
        found = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        rows = [(name, command.get_short_help_str(limit=500)) for name, command in found if command is not None]
        with formatter.section("Commands"):
            formatter.write_dl(rows)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command of the first word; a word that is none is answered with those that are like it."""
        if args and not args[0].startswith("-") and self.get_command(ctx, args[0]) is None:
            like = difflib.get_close_matches(args[0], self.list_commands(ctx), n=3)
            hint = f"; did you mean {' or '.join(like)}?" if like else "; firebreak --help lists them"
            raise click.UsageError(f"there is no command {args[0]!r}{hint}", ctx)
        return super().resolve_command(ctx, args)

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Note before anything can fail whether errors are wanted as JSON too."""
        flags = {*args, *(f"{one}={other}" for one, other in pairwise(args))}
        ctx.meta[_AS_JSON] = bool(flags & {"--json", "--progress=json"})
        with _answering(ctx.meta[_AS_JSON]):
            for word in args:
                require_text(word)
            return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        """Run a command; on an error say it and exit with its code."""
        with _answering(ctx.meta[_AS_JSON]), _ending_well():
            return super().invoke(ctx)


class _Ended(KeyboardInterrupt):
    """The process was asked from outside to end, by the signal `number`."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


@contextlib.contextmanager
def _answering(as_json: bool) -> Iterator[None]:
    """Turn errors into words and exit codes."""
    try:
        yield
    except _Ended as stop:
        name = signal.Signals(stop.number).name
        _fail(
            Cancelled(f"ended from outside ({name}); no half-written file was left behind"),
            as_json,
            ENDED + stop.number,
        )
    except KeyboardInterrupt:
        _fail(Cancelled("stopped; no half-written file was left behind"), as_json)
    except FirebreakError as error:
        _fail(error, as_json)
    except MemoryError:
        _fail(ResourceError("out of memory; use a coarser --res, a smaller --bounds or a larger machine"), as_json)
    except click.ClickException as error:
        if as_json:
            _print_error("usage", error.format_message(), error.exit_code)
        with contextlib.suppress(OSError):
            error.show()
        hush()
        sys.exit(error.exit_code)
    except click.exceptions.Exit:
        raise
    except ImportError as error:
        _fail(MissingComponentError(f"a library cannot be loaded: {error}; firebreak doctor looks for what"), as_json)
    except OSError as error:
        _fail(_of_the_system(error), as_json)
    except UnicodeEncodeError as error:
        _fail(InputError(f"{_shown(error.object)} holds letters that no file in UTF-8 can; rename it"), as_json)
    except Exception as error:
        if as_json:
            _print_error("bug", f"{type(error).__name__}: {error}", EXIT_BUG)
        with contextlib.suppress(OSError):
            traceback.print_exc()
            click.echo("This is a bug in firebreak_gis; please report it with the lines above.", err=True)
        hush()
        sys.exit(EXIT_BUG)


@contextlib.contextmanager
def _ending_well() -> Iterator[None]:
    """Let a signal that asks the process to end clean up first, unless somebody else listens to it."""

    def stop(number: int, _: FrameType | None) -> None:
        signal.signal(number, signal.SIG_IGN)  # the cleaning up is short
        raise _Ended(number)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    ours = [n for n in ENDINGS if n != signal.SIGINT and signal.getsignal(n) == signal.SIG_DFL]
    for number in ours:
        signal.signal(number, stop)
    try:
        yield
    finally:
        for number in ours:
            if signal.getsignal(number) is stop:
                signal.signal(number, signal.SIG_DFL)


def _of_the_system(error: OSError) -> FirebreakError:
    """Say what the operating system refused: never the fault of this program."""
    if error.errno == errno.ENOMEM:
        return ResourceError("out of memory; use a coarser --res, a smaller --bounds or a larger machine")
    where = f"{error.filename}: " if error.filename else "reading or writing failed: "
    return OutputError(_shown(where + reason(error)))


def require_text(word: str) -> None:
    """Refuse words of the command line that are not UTF-8: they can be written into no account and no layer.

    Raises
    ------
    InputError
        Showing the word.
    """
    try:
        word.encode("utf-8")
    except UnicodeEncodeError:
        raise InputError(f"{_shown(word)} is not a name in UTF-8; rename the file or folder") from None


def _shown(text: str) -> str:
    return text.encode("utf-8", "backslashreplace").decode()


def stand_streams() -> None:
    """Open the standard streams that whoever started us has closed: else files that we open take their places."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open(mode, encoding="utf-8"))  # noqa: SIM115 - for good


def hush() -> None:
    """Flush what was said; a stream that cannot be written, a full disk or a reader who has gone, leads nowhere now."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        except ValueError:  # closed already
            continue


def _names() -> set[str]:
    """Names of the files of commands."""
    return {m.name for m in pkgutil.iter_modules(_module().__path__)}


def _module(name: str = "") -> ModuleType:
    """The file of a command; without a name the folder of all."""
    return importlib.import_module(f"firebreak_gis.cli.commands.{name}".rstrip("."))


def _fail(error: FirebreakError, as_json: bool, code: int | None = None) -> NoReturn:
    code = error.exit_code if code is None else code
    if as_json:
        _print_error(error.kind, str(error), code)
    with contextlib.suppress(OSError):
        click.echo(f"Error: {_shown(str(error))}", err=True)
    hush()
    sys.exit(code)


def _print_error(kind: str, message: str, code: int) -> None:
    document = {"error": {"kind": kind, "message": _shown(message), "exit_code": code}}
    with contextlib.suppress(OSError):
        click.echo(json.dumps(document, ensure_ascii=False))


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
    "7 verification failed, 130 cancelled, 143 ended (SIGTERM).",
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
