"""One page of HTML that shows a plan: a map, the doubt, what to build; it opens anywhere and asks no network.

The page holds all that it shows: pictures of the rasters, outlines, tables, the map library (Leaflet, in `leaflet/`,
BSD-2-Clause). `content` describes it as plain values, `pictures` draws rasters, `render` here puts them together.
"""

from __future__ import annotations

import html
import importlib.resources
import itertools
import json
import math
import re
from collections.abc import Sequence
from typing import Any

from firebreak_gis.report.page.content import Curve, Page, Row
from firebreak_gis.schema import percent

_RIGHT = ' class="number"'
#: Colours of lines in the style, from `--c0` on.
_COLOURS = 8
#: A browser that reads this loads nothing but what the page holds.
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"


def render(page: Page) -> str:
    """Return the page as the text of one HTML file.

    Parameters
    ----------
    page
        What it shows. Every text is escaped.

    Returns
    -------
    str
        HTML 5; the same page gives the same text.

    Examples
    --------
    >>> from firebreak_gis.report.page.content import Page
    >>> text = render(Page(title="A <plan>", headline=("Half as much burns.",)))
    >>> "A &lt;plan&gt;" in text and "http" not in text.split("<main")[1].split("</main")[0]
    True
    """
    parts = {
        "policy": _POLICY,
        "title": _text(page.title),
        "leaflet_css": _own(_asset("leaflet/leaflet.css")),
        "style": _asset("style.css"),
        "headline": "".join(f"<p>{_text(sentence)}</p>" for sentence in page.headline),
        "assumptions": _list(page.assumptions),
        "warnings": _warnings(page.warnings),
        "figures": _figures(page.figures),
        "map": _map() if page.pictures else "",
        "curve": _curve(page.curve) if page.curve else "",
        "segments": _table("segments", page.segments) if page.segments else "",
        "comparison": _table("comparison", page.comparison) if page.comparison else "",
        "goals": _table("goals", page.goals) if page.goals else "",
        "years": _table("years", page.years) if page.years else "",
        "files": _files(page.files),
        "provenance": _provenance(page.provenance),
        "data": _json(page.for_map()),
        "leaflet_js": _asset("leaflet/leaflet.js"),
        "script": _asset("page.js"),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found.group(1)], _asset("template.html"))


def _asset(name: str) -> str:
    return (importlib.resources.files(__package__) / name).read_text(encoding="utf-8")


def _own(style: str) -> str:
    """A style without addresses of pictures that lie beside it: the page uses none of them."""
    return re.sub(r"url\((?!#)[^)]*\)", "none", style)


def _text(value: object) -> str:
    return html.escape(str(value), quote=True)


def _json(data: Any) -> str:
    """JSON that may stand inside a script element, whatever its texts hold."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _list(sentences: Sequence[str]) -> str:
    if not sentences:
        return ""
    items = "".join(f"<li>{_text(s)}</li>" for s in sentences)
    return f'<div class="assumptions"><h2>What this assumes</h2><ul>{items}</ul></div>'


def _warnings(sentences: Sequence[str]) -> str:
    items = "".join(f"<li>{_text(s)}</li>" for s in sentences)
    return f'<div class="warnings" role="note"><h2>Look at this first</h2><ul>{items}</ul></div>' if items else ""


def _figures(figures: Sequence[tuple[str, str, str]]) -> str:
    cards = "".join(
        f"<div><dt>{_text(name)}</dt><dd>{_text(value)}<small>{_text(note)}</small></dd></div>"
        for name, value, note in figures
    )
    return f'<dl class="figures">{cards}</dl>' if cards else ""


def _map() -> str:
    return """<section aria-labelledby="map-title">
<h2 id="map-title">Map</h2>
<div class="map-frame">
<div id="map" role="application" aria-label="Map of the plan: arrow keys move it, plus and minus zoom"></div>
<div id="layers" class="panel"></div>
</div>
<div id="compare" class="compare" hidden>
<label for="slider">Left of the line without the breaks, right of it with them</label>
<input id="slider" type="range" min="0" max="100" value="50" step="1">
</div>
<p id="card" class="card" aria-live="polite">Choose a segment on the map or in the table to see its card.</p>
</section>"""


def _curve(curve: Curve) -> str:
    """A line chart as SVG, with a title and a description for those who do not see it."""
    width, height, left, bottom, top, right = 720, 320, 56, 44, 14, 170
    reach = max(max(x) for _, x, _ in curve.lines) or 1.0
    ceiling = _round_up(max(max(y) for _, _, y in curve.lines))

    def place(x: float, y: float) -> str:
        across = left + (width - left - right) * x / reach
        up = height - bottom - (height - bottom - top) * y / ceiling
        return f"{across:.1f},{up:.1f}"

    parts = []
    for share in (ceiling * k / 4 for k in range(5)):
        x, y = place(0, share).split(",")
        end = place(reach, share).split(",")[0]
        parts.append(f'<line class="grid" x1="{x}" x2="{end}" y1="{y}" y2="{y}"/>')
        parts.append(
            f'<text class="tick" x="{float(x) - 8:.1f}" y="{float(y) + 4:.1f}" text-anchor="end">'
            f"{100 * share:.3g} %</text>"
        )
    for k in range(5):
        x, y = place(reach * k / 4, 0).split(",")
        parts.append(
            f'<text class="tick" x="{x}" y="{float(y) + 18:.1f}" text-anchor="middle">'
            f"{100 * reach * k / 4:.3g} %</text>"
        )
    labels: list[float] = []
    for number, (name, xs, ys) in enumerate(curve.lines):
        points, colour = " ".join(place(x, y) for x, y in zip(xs, ys, strict=True)), number % _COLOURS
        parts.append(f'<polyline class="line line-{colour}" points="{points}"/>')
        at, wanted = (float(v) for v in place(xs[-1], ys[-1]).split(","))
        while any(abs(wanted - other) < 15 for other in labels):  # names must not lie on each other
            wanted -= 3
        labels.append(wanted)
        parts.append(f'<text class="name name-{colour}" x="{at + 8:.1f}" y="{wanted + 4:.1f}">{_text(name)}</text>')
    if curve.marked is not None:
        x, low = place(curve.marked, 0).split(",")
        high = place(curve.marked, ceiling).split(",")[1]
        parts.append(f'<line class="mark" x1="{x}" x2="{x}" y1="{low}" y2="{high}"/>')
    middle = left + (width - left - right) / 2
    parts.append(
        f'<text class="axis" x="{middle:.0f}" y="{height - 6}" text-anchor="middle">{_text(curve.across)}</text>'
    )
    rows = "".join(
        f"<tr><th scope='row'>{_text(name)}</th>"
        + "".join(f"<td>{percent(y)}</td>" for y in ys[:: max(1, len(ys) // 8)])
        + "</tr>"
        for name, _, ys in curve.lines
    )
    steps = curve.lines[0][1]
    head = "".join(f"<th scope='col'>{100 * x:.3g} %</th>" for x in steps[:: max(1, len(steps) // 8)])
    return (
        f'<section aria-labelledby="curve-title"><h2 id="curve-title">{_text(curve.title)}</h2>'
        f"<p>{_text(curve.note)}</p>"
        f'<svg class="curve" viewBox="0 0 {width} {height}" role="img" aria-labelledby="curve-title">'
        + "".join(parts)
        + "</svg><details><summary>The same as a table</summary>"
        f'<div class="scroll"><table><thead><tr><th scope="col">{_text(curve.across)}</th>{head}</tr></thead>'
        f"<tbody>{rows}</tbody></table></div></details></section>"
    )


def _round_up(share: float) -> float:
    """The least of 1, 2, 4 or 8 times a power of ten, at most 1, that is no less than a share."""
    power = 10.0 ** math.floor(math.log10(share)) if share > 0.0 else 1.0
    return min([step * power for step in (1, 2, 4, 8, 10) if step * power >= share * (1 - 1e-9)] + [1.0])


def _table(kind: str, rows: Sequence[Row]) -> str:
    """A table whose columns sort; of segments each row leads to the map."""
    titles = {
        "segments": "What to build",
        "comparison": "Plans side by side",
        "goals": "What it does for every goal",
        "years": "Year by year",
    }
    columns = list(rows[0].cells)
    numeric = {name for name in columns if all(isinstance(r.cells[name], int | float | None) for r in rows)}
    head = "".join(
        f'<th scope="col" aria-sort="none"{_RIGHT if name in numeric else ""}>'
        f'<button type="button" data-column="{k}">{_text(name)}</button></th>'
        for k, name in enumerate(columns)
    )
    bodies = []
    for group, members in itertools.groupby(rows, key=lambda row: row.group):
        some = list(members)
        line = _sums(group, some, columns, "group") if group else ""
        bodies.append(f"<tbody>{line}{''.join(_row(row, columns[0], numeric) for row in some)}</tbody>")
    foot = f"<tfoot>{_sums('Total', rows, columns)}</tfoot>" if rows[0].summed else ""
    choice = ""
    if rows[0].group:
        words = " and ".join(dict.fromkeys(part.split(" ")[0].lower() for part in rows[0].group.split(", ")))
        choice = (
            f'<p><label><input type="checkbox" class="grouped" checked> Group by {_text(words)} '
            "(a click on a column sorts all)</label></p>"
        )
    return (
        f'<section aria-labelledby="{kind}-title"><h2 id="{kind}-title">{titles[kind]}</h2>{choice}'
        f'<div class="scroll tall"><table class="sortable" id="{kind}"><thead><tr>{head}</tr></thead>'
        f"{''.join(bodies)}{foot}</table></div></section>"
    )


def _row(row: Row, first: str, numeric: set[str]) -> str:
    cells = []
    for name, value in row.cells.items():
        key = "" if value is None else repr(value) if name in numeric else str(value)
        shown = _text(row.shown(name))
        if row.feature is not None and name == first:
            shown = f'<button type="button" class="go" data-feature="{row.feature}">{shown}</button>'
        cells.append(f'<td{_RIGHT if name in numeric else ""} data-key="{_text(key)}">{shown}</td>')
    return f"<tr>{''.join(cells)}</tr>"


def _sums(words: str, rows: Sequence[Row], columns: Sequence[str], kind: str = "") -> str:
    """A line with words under the first columns, and sums under those that have one."""
    summed = rows[0].summed
    wide = next((k for k, name in enumerate(columns) if k and name in summed), len(columns))
    scope = "rowgroup" if kind else "row"
    cells = [f'<th scope="{scope}" colspan="{wide}">{_text(words)}</th>']
    for name in columns[wide:]:
        total = sum(float(row.cells[name] or 0.0) for row in rows) if name in summed else None
        cells.append("<td></td>" if total is None else f'<td class="number">{_text(rows[0].as_text(name, total))}</td>')
    return f"<tr{f' class={chr(34)}{kind}{chr(34)}' if kind else ''}>{''.join(cells)}</tr>"


def _files(files: Sequence[tuple[str, str]]) -> str:
    if not files:
        return ""
    items = "".join(
        f'<li><a href="{_text(_address(name))}" download>{_text(name)}</a> {_text(label)}</li>' for name, label in files
    )
    return (
        '<section aria-labelledby="files-title"><h2 id="files-title">Files beside this page</h2>'
        f'<ul class="files">{items}</ul></section>'
    )


def _address(name: str) -> str:
    from urllib.parse import quote

    return "./" + quote(name)


def _provenance(provenance: Sequence[tuple[str, str]]) -> str:
    rows = "".join(f"<div><dt>{_text(name)}</dt><dd>{_text(value)}</dd></div>" for name, value in provenance)
    return (
        '<section aria-labelledby="provenance-title"><h2 id="provenance-title">Where this comes from</h2>'
        f'<dl class="provenance">{rows}</dl></section>'
        if rows
        else ""
    )
