"""firebreak describe: the whole program as data, for forms and documentation."""

from __future__ import annotations

import inspect
import json
from typing import Any

import click

from firebreak_gis import __version__, plugins
from firebreak_gis.cli import kinds, options, outputs
from firebreak_gis.cli.session import Session
from firebreak_gis.files.outputs import labels
from firebreak_gis.landscape import legends


@click.command("describe")
@options.common
@click.pass_context
def command(ctx: click.Context, session: Session) -> None:
    """Describe every command, option, method and parameter as one JSON object.

    What is absent is false or empty: a parameter without "flags" is an argument, one without "required" may
    be left out. "outputs" are the files that a command writes into its folder.
    """
    group = ctx.parent.command if ctx.parent else None  # not the root: `rio firebreak describe`
    assert isinstance(group, click.Group)
    commands = {name: _command(group.get_command(ctx, name)) for name in group.list_commands(ctx)}
    found = {kind: [plugins.describe(kind, name) for name in plugins.names(kind)] for kind in plugins.KINDS}
    document = {
        "software": "firebreak_gis",
        "version": __version__,
        "commands": commands,
        "methods": found,
        "legends": {name: next(iter(legends.read_legend(name).about), "") for name in legends.names()},
    }
    session.finish(document, json.dumps(document, indent=1, ensure_ascii=False))


def _command(found: click.Command | None) -> dict[str, Any]:
    if found is None:
        return {}
    entry = {
        "summary": found.get_short_help_str(200),
        "help": inspect.cleandoc(found.help or ""),
        "parameters": [_parameter(p) for p in found.params],
        "outputs": labels(outputs.outputs_of(found)),
    }
    if isinstance(found, click.Group):
        entry["commands"] = {word: _command(inner) for word, inner in sorted(found.commands.items())}
    return {key: value for key, value in entry.items() if value}


def _parameter(param: click.Parameter) -> dict[str, Any]:
    kind = param.type
    entry: dict[str, Any] = {
        "name": param.name,
        "type": kind.name,
        "required": param.required,
        "multiple": param.multiple,
        "count": param.nargs if param.nargs != 1 else None,
        "default": param.default if isinstance(param.default, (str, int, float)) else None,
    }
    if isinstance(kind, click.Choice):
        entry["choices"] = [str(c) for c in kind.choices]
    elif isinstance(kind, kinds.Kind) and kind.choices:
        entry["choices"] = list(kind.choices())
    if isinstance(kind, kinds.NewFile):
        entry["extensions"] = list(kind.extensions)
    if isinstance(param, click.Option):
        entry |= {"flags": list(param.opts), "help": param.help or ""}
    return {key: value for key, value in entry.items() if value is not None and value is not False}
