"""firebreak describe: the whole program as data, for forms and documentation."""

from __future__ import annotations

import json
from typing import Any

import click

from firebreak_gis import __version__, methods
from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session


@click.command("describe")
@options.common
@click.pass_context
def command(ctx: click.Context, session: Session) -> None:
    """Describe every command, option, method and parameter as one JSON object."""
    group = ctx.find_root().command
    assert isinstance(group, click.Group)  # noqa: S101 - the type of our own group
    commands = {name: _command(group.get_command(ctx, name)) for name in group.list_commands(ctx)}
    kinds = {kind: [methods.describe(kind, name) for name in methods.names(kind)] for kind in methods.KINDS}
    document = {"software": "firebreak_gis", "version": __version__, "commands": commands, "methods": kinds}
    session.finish(document, json.dumps(document, indent=2, ensure_ascii=False))


def _command(found: click.Command | None) -> dict[str, Any]:
    if found is None:
        return {}
    return {"summary": found.get_short_help_str(200), "help": found.help or "",
            "parameters": [_parameter(p) for p in found.params]}


def _parameter(param: click.Parameter) -> dict[str, Any]:
    kind = param.type
    entry: dict[str, Any] = {
        "name": param.name,
        "type": kind.name,
        "required": param.required,
        "multiple": param.multiple or param.nargs != 1,
        "default": param.default if isinstance(param.default, (str, int, float, bool)) else None,
        "argument": isinstance(param, click.Argument),
    }
    if isinstance(kind, click.Choice):
        entry["choices"] = [str(c) for c in kind.choices]
    if isinstance(param, click.Option):
        entry |= {"flags": list(param.opts), "help": param.help or "", "is_flag": param.is_flag}
    return entry
