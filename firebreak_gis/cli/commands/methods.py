"""firebreak methods: what rankings and spread models there are."""

from __future__ import annotations

from typing import Any

import click

from firebreak_gis import plugins
from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError


@click.command("methods")
@click.argument("name", required=False)
@options.common
def command(session: Session, name: str | None) -> None:
    """List the rankings and spread models, or show one: NAME with its text and parameters."""
    found = [method for method in plugins.methods() if name in (None, method["name"])]
    if not found:
        raise ParameterError(f"there is no method {name!r}; firebreak methods lists them")
    session.finish({"methods": found}, "\n".join(_full(m) for m in found) if name else _listing(found))


def _listing(found: list[dict[str, Any]]) -> str:
    lines = []
    for kind in plugins.KINDS:
        lines.append(f"{kind}:")
        lines += [f"  {m['name']:14} {m['summary']}" for m in found if m["kind"] == kind]
    return "\n".join([*lines, "firebreak methods NAME shows the parameters of one."])


def _full(method: dict[str, Any]) -> str:
    lines = [f"{method['name']} ({method['kind']})", "", method["text"], "", "Parameters:"]
    for p in method["parameters"]:
        bounds = [f"{word} {p[key]:g}" for key, word in (("minimum", "from"), ("maximum", "to")) if key in p]
        units = "" if p["units"] == "1" else f" [{p['units']}]"
        limits = f" ({' '.join(bounds)})" if bounds else ""
        told = f"; a plan tells it: {plugins.FACTS[p['told']]}" if "told" in p else ""
        lines.append(f"  {p['name']} = {p['default']}{units}  {p['text']}{limits}{told}")
    return "\n".join(lines if method["parameters"] else [*lines, "  none"])
