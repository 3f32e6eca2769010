"""firebreak legends: what vegetation codes mean."""

from __future__ import annotations

from collections.abc import Mapping

import click

from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session
from firebreak_gis.landscape import legends
from firebreak_gis.landscape.legends.burning import BURNING
from firebreak_gis.schema import DENSITY, VEGETATION


@click.command("legends")
@click.argument("name", required=False)
@options.common
def command(session: Session, name: str | None) -> None:
    """List the built-in legends, or show one: NAME (or a CSV file) as a table.

    There is none for LANDFIRE EVT: its codes name plant communities, change with each release and do not tell
    how well they burn. Take FBFM40 (scott_burgan_40) or FBFM13 (anderson_13) of the same release.
    """
    if name is None:
        found = legends.names()
        about = {name: next(iter(legends.read_legend(name).about), "") for name in found}
        lines = [f"{name:20} {text}" for name, text in about.items()]
        session.finish({"legends": found, "about": about}, "\n".join([*lines, "firebreak legends NAME shows one."]))
        return
    legend = legends.read_legend(name)
    rows = [_row(entry, legend.has_vegetation) for entry in legend.entries]
    lines = [f"# {line}" for line in legend.about]
    burning = [column for column in BURNING if any(row.get(column) for row in rows)]
    more = "".join(f"{column:>14}" for column in burning)
    lines.append(f"{'code':>12}  {'vegetation':13} {'density':9} {more}{'  ' * bool(more)}label")
    for row in rows:
        more = "".join(f"{row.get(column, ''):>14}" for column in burning)
        lines.append(
            f"{row['code']:>12}  {row['vegetation']:13} {_shown(row):9} {more}{'  ' * bool(more)}{row['label']}"
        )
    if any(_shown(row).endswith("*") for row in rows):
        lines.append("* unless a density raster or word is given")
    shown = {"name": legend.name, "version": legend.version, "about": legend.about, "entries": rows}
    session.finish(shown, "\n".join(lines))


def _shown(row: Mapping[str, str]) -> str:
    replaced = row["density"] and row["vegetation"] not in ("", "none") and row["density_from_raster"] == "yes"
    return row["density"] + "*" * bool(replaced)


def _row(entry: legends.Entry, has_vegetation: bool) -> dict[str, str]:
    code = f"{entry.low:g}" if entry.low == entry.high else f"{entry.low:g} .. {entry.high:g}"
    if entry.missing:
        column = "vegetation" if has_vegetation else "density"
        blank = {"vegetation": "", "density": "", "density_from_raster": "no", "label": entry.label}
        return {"code": code, **blank, column: legends.NO_DATA}
    return {
        "code": code,
        "vegetation": _word(entry.vegetation, entry.vegetation_effect, VEGETATION),
        "density": _word(entry.density, entry.density_effect, DENSITY),
        "density_from_raster": "yes" if entry.density_from_raster else "no",
        "label": entry.label,
        **{column: f"{value:g}" for column, name in BURNING.items() if (value := getattr(entry, name)) is not None},
    }


def _word(code: int | None, effect: float | None, classes: Mapping[int, str]) -> str:
    if effect is not None:
        return f"{effect:g}"
    return "" if code is None else classes[code]
