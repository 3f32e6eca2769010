"""The pages of a map book: an overview, a list of all segments, a page for each segment."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import TYPE_CHECKING, Any

from firebreak_gis.construction.writing import STAGE_COLOURS
from firebreak_gis.grid import crs_name
from firebreak_gis.report.mapbook import maps
from firebreak_gis.report.mapbook.atlas import Atlas, percent
from firebreak_gis.report.mapbook.columns import GREY, Box, Column, Flow, fitting, put
from firebreak_gis.schema import COLUMNS, VARIABLES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Width and height of upright paper [inch].
PAPERS = {"a4": (8.268, 11.693), "a3": (11.693, 16.535), "letter": (8.5, 11.0)}
#: Colour of the segment of a page, and the finest scale of its map.
THIS, FINEST = "#d7191c", 5000.0
_EDGE = 0.45

#: Writes something in a column.
Block = Callable[[Column], None]


@dataclass(frozen=True)
class Sheet:
    """A page: its size, and where its parts lie, all in inches from the lower left corner.

    Parameters
    ----------
    width, height
        Of the paper.
    """

    width: float
    height: float

    @property
    def wide(self) -> bool:
        """Whether it lies on its long side."""
        return self.width > self.height

    @property
    def map(self) -> Box:
        """Left, bottom, width and height of the map."""
        if self.wide:
            return _EDGE + 0.1, 0.55, self.width - 4.35, self.height - 1.35
        return _EDGE + 0.1, 0.55 + 3.85, self.width - 2 * _EDGE - 0.2, self.height - 1.35 - 3.85

    def columns(self, *shares: float) -> list[Box]:
        """Boxes for texts: one beside the map, or as many under it as shares of the width are given."""
        if self.wide:
            return [(self.width - 3.5, 0.55, 3.5 - _EDGE, self.height - 1.35)]
        room, left = self.width - 2 * _EDGE, _EDGE
        boxes = []
        for share in shares:
            boxes.append((left, 0.5, share * room - 0.15, 3.55))
            left += share * room
        return boxes


def sheet(paper: str, *, portrait: bool) -> Sheet:
    """Return a page of `PAPERS`."""
    short, long = PAPERS[paper]
    return Sheet(short, long) if portrait else Sheet(long, short)


def stage_colours(atlas: Atlas) -> list[str]:
    """Colour of the stage of each segment, from the first to the last."""
    stages = atlas.lines["stage"].to_numpy()
    last = max(int(stages.max()), 1)
    count = len(STAGE_COLOURS)
    return [STAGE_COLOURS[min(count - 1, count * (int(s) - 1) // last)] for s in stages]


def empty(paper: Sheet, title: str, right: str, footer: str) -> Figure:
    """A page with its head and foot."""
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    figure = Figure(figsize=(paper.width, paper.height))
    put(figure, _EDGE, paper.height - 0.42, title, fontsize=15, fontweight="bold", va="center")
    put(figure, paper.width - _EDGE, paper.height - 0.42, right, fontsize=10, ha="right", va="center")
    level = (paper.height - 0.66) / paper.height
    figure.add_artist(Line2D([_EDGE / paper.width, 1 - _EDGE / paper.width], [level, level], color="black", lw=0.8))
    put(figure, _EDGE, 0.22, footer, fontsize=6.5, color=GREY, va="center")
    return figure


def overview(atlas: Atlas, paper: Sheet, footer: str, note: str) -> Figure:
    """The whole plan on one map, with what it saves and what that assumes beside it."""
    figure = empty(paper, _short(atlas.title, 74 if paper.wide else 52), f"{len(atlas.lines)} segments", footer)
    bounds = atlas.grid.bounds
    window = maps.window_of(bounds, paper.map[2:], margin=0.01)
    axes = maps.frame(figure, paper.map, window)
    maps.draw_ground(axes, atlas, window, contours=False)
    maps.draw_lines(axes, list(atlas.lines.geometry), "white", 2.6, zorder=3)
    maps.draw_lines(axes, list(atlas.lines.geometry), stage_colours(atlas), 1.7, zorder=3.5)
    maps.draw_numbers(axes, atlas, window, size=5.0)
    maps.dress(axes, window, metres=atlas.grid.crs is not None)
    _tell(figure, atlas, paper, note, whole=_tell(None, atlas, paper, note, whole=True))
    return figure


def about(atlas: Atlas, paper: Sheet, footer: str, note: str, first_page: int) -> list[Figure]:
    """Pages of what the plan saves and assumes, if there is no room for all of it beside the overview."""
    if _tell(None, atlas, paper, note, whole=True):
        return []
    numbers = count(first_page)
    width = (paper.width - 3 * _EDGE) / 2

    def turn() -> tuple[Figure, list[Box]]:
        figure = empty(paper, "What the plan saves, and what that assumes", f"page {next(numbers)}", footer)
        return figure, [(left, 0.55, width, paper.height - 1.35) for left in (_EDGE, 2 * _EDGE + width)]

    flow = Flow(turn)
    _saved(atlas, flow)
    _assumed(atlas, flow)
    return flow.figures


def _tell(figure: Figure | None, atlas: Atlas, paper: Sheet, note: str, *, whole: bool) -> bool:
    """Write what stands beside the overview, or with no figure nothing; whether it has room."""
    columns = [Column(figure, box) for box in paper.columns(0.5, 0.5)]
    for column, blocks in zip(columns, _beside(atlas, paper, note, whole=whole), strict=True):
        for block in blocks:
            block(column)
    return all(column.fits for column in columns)


def _beside(atlas: Atlas, paper: Sheet, note: str, *, whole: bool) -> list[list[Block]]:
    """What stands in each column beside the overview."""
    plan: list[Block] = [partial(_saved, atlas, most=None if whole else _FIRST)]
    plan.append(partial(_assumed, atlas) if whole else _further)
    use: list[Block] = [partial(_use, atlas, note)]
    return [plan + use] if paper.wide else [plan, use]


#: Sentences of the headline that stand beside the overview where there is no room for all.
_FIRST = 2


def _saved(atlas: Atlas, column: Column, *, most: int | None = None) -> None:
    for k, sentence in enumerate(atlas.headline[:most]):
        column.say(sentence, size=8.5 if k == 0 else 7.5, bold=k == 0)
    column.gap()


def _further(column: Column) -> None:
    column.say("What this assumes stands on the next page.", bold=True)


def _assumed(atlas: Atlas, column: Column) -> None:
    if atlas.assumptions:
        column.head("What this assumes")
        column.say(" ".join(atlas.assumptions))
    if atlas.warnings:
        column.head("Look at this first")
        column.say(" ".join(atlas.warnings))


def _use(atlas: Atlas, note: str, column: Column) -> None:
    """How to read the book, and what the colours of the map mean."""
    column.head("How to read the pages")
    column.say(note)
    column.head("Map")
    first, last = (int(pick(atlas.lines["stage"])) for pick in (min, max))
    stages = [(f"built first (stage {first})", STAGE_COLOURS[0]), (f"built last (stage {last})", STAGE_COLOURS[-1])]
    column.key(stages, patch=False)
    _ground_key(column, atlas)
    column.say(_system(atlas))
    for line in atlas.sources:
        column.say(line, size=6, colour=GREY)


def pages_of_list(atlas: Atlas, paper: Sheet) -> int:
    """Pages that the list of segments takes."""
    return -(-len(atlas.lines) // _rows(paper))


def _rows(paper: Sheet) -> int:
    return int((paper.height - 1.75) / _ROW)


def contents(atlas: Atlas, paper: Sheet, footer: str, page_of: dict[int, int], first_page: int) -> Iterator[Figure]:
    """Tables of all segments, as many pages as they need; `first_page` is the number of the first."""
    columns = [(name, head) for name, head in _HEADS if name == "page" or name in atlas.lines]
    columns = [(name, head) for name, head in columns if name != "cost" or atlas.has_cost]
    room = _rows(paper)
    table = atlas.lines
    for start in range(0, len(table), room):
        number = start // room
        figure = empty(paper, "Segments in order of construction", f"page {first_page + number}", footer)
        y = paper.height - 0.95
        shares = [_WIDE.get(name, 1.0) for name, _ in columns]
        ends = [
            _EDGE + (paper.width - 2 * _EDGE) * (sum(shares[: k + 1]) / sum(shares)) - 0.08 for k in range(len(shares))
        ]
        for k, (_, head) in enumerate(columns):
            put(figure, ends[k], y, head, fontsize=7.5, fontweight="bold", ha="right")
        rows = list(range(start, min(start + room, len(table))))
        for line, place in enumerate(rows, 1):
            row = table.iloc[place]
            if line % 2:
                _stripe(figure, paper, y - line * _ROW)
            for k, (name, _) in enumerate(columns):
                text = _cell(name, page_of.get(place) if name == "page" else row[name])
                width = ends[k] - (ends[k - 1] if k else _EDGE) - 0.1
                put(figure, ends[k], y - line * _ROW, text, fontsize=fitting(text, 72 * width, 7.5), ha="right")
        if rows[-1] == len(table) - 1:
            sums = {name: table[name].sum() for name in ("length_m", "area_ha", "cost", "gain_share") if name in table}
            level = y - (len(rows) + 1.2) * _ROW
            for k, (name, _) in enumerate(columns):
                text = "Sum" if k == 0 else _cell(name, sums[name]) if name in sums else ""
                put(figure, ends[k], level, text, fontsize=7.5, fontweight="bold", ha="right")
        yield figure


def segment(atlas: Atlas, paper: Sheet, footer: str, k: int, number: int) -> Figure:
    """The page of a segment, by its place in the table."""
    row = atlas.lines.iloc[k]
    shape = row.geometry
    outline = None if atlas.polygons is None else atlas.polygons.geometry.iloc[k]
    stage = f"stage {int(row['stage'])} of {int(atlas.lines['stage'].max())}"
    figure = empty(
        paper, f"Segment {int(row['order'])} of {len(atlas.lines)}", f"{stage}   \N{MIDDLE DOT}   page {number}", footer
    )
    bounds = (shape if outline is None else outline).bounds
    window = maps.window_of(bounds, paper.map[2:], margin=0.14, least=FINEST)
    axes = maps.frame(figure, paper.map, window)
    contours = maps.draw_ground(axes, atlas, window)
    _neighbours(axes, atlas, window, k)
    if outline is not None:
        maps.draw_area(axes, outline, THIS, width=0.8, opacity=0.28, zorder=3)
    maps.draw_lines(axes, [shape], "white", 5.0, zorder=4)
    maps.draw_lines(axes, [shape], THIS, 3.0, zorder=4.5)
    maps.draw_numbers(axes, atlas, window, skip=k, size=7.0)
    _named(axes, window, shape, str(int(row["order"])))
    _sides(axes, atlas, window, row)
    ends = _ends(shape)
    maps.dress(axes, window, metres=atlas.grid.crs is not None)
    boxes = paper.columns(0.38, 0.34, 0.28)
    column = Column(figure, boxes[0])
    for name, value in atlas.facts(k):
        column.pair(name, value)
    column.head("Ends")
    for letter, place in ends.items():
        for line in _placed(atlas, place):
            column.pair(letter, line)
            letter = ""
    column = column if paper.wide else Column(figure, boxes[1])
    column.head("Why")
    for sentence in atlas.why(k):
        column.say(sentence, size=8.5)
    column.head("Map")
    _ground_key(column, atlas)
    if contours:
        column.say(f"Contour lines every {contours:g} m.", size=7)
    left, bottom, width, height = boxes[-1]
    room = column.y - bottom - 0.08 if paper.wide else height
    if room > 0.7:
        high = min(room, 2.2)
        _locator(figure, atlas, (left, bottom + room - high if not paper.wide else bottom, width, high), window, k)
    return figure


#: What else is drawn, and its colour in the key.
_DRAWN = (("roads", "#6b4a2b"), ("water", "#4a90c2"))
#: Height of a row of the list [inch].
_ROW = 0.185
#: Columns of the list that need more room than others.
_WIDE = {"treatment": 1.7}
_HEADS = (
    ("order", "Segment"),
    ("stage", "Stage"),
    ("year", "Year"),
    ("length_m", "Length"),
    ("width_m", "Width"),
    ("area_ha", "Area"),
    ("mean_slope_deg", "Slope"),
    ("max_slope_deg", "Steepest"),
    ("treatment", "Treatment"),
    ("cost", "Cost"),
    ("gain_share", "Saves"),
    ("page", "Page"),
)


def _cell(name: str, value: Any) -> str:
    if value is None or value != value or (name in COLUMNS and COLUMNS[name].zero and value == 0):
        return "\N{EN DASH}"
    if name == "gain_share":
        return percent(value).replace("less than ", "< ")
    return str(value) if name == "page" else COLUMNS[name].told(value).replace(" degrees", "\N{DEGREE SIGN}")


def _ground_key(column: Column, atlas: Atlas) -> None:
    """Colours of the ground, and what is drawn on it."""
    if atlas.vegetation is not None:
        variable = VARIABLES["vegetation"]
        named = {**variable.classes, 0: "no fuel"}
        column.key([(named[code], maps.faint(colour)) for code, colour in variable.colours.items()], patch=True)
    column.key([(word, colour) for word, colour in _DRAWN if getattr(atlas, word) is not None], patch=False)


def _stripe(figure: Figure, paper: Sheet, y: float) -> None:
    from matplotlib.patches import Rectangle

    place = (_EDGE / paper.width, (y - 0.055) / paper.height)
    size = (1 - 2 * _EDGE / paper.width, _ROW / paper.height)
    figure.add_artist(Rectangle(place, *size, color="#f0f0f0", lw=0, zorder=-2))


def _short(text: str, letters: int) -> str:
    return textwrap.shorten(text, letters, placeholder=" ...")


def _neighbours(axes: Any, atlas: Atlas, window: maps.Window, k: int) -> None:
    """The other segments of the window, thin."""
    import shapely

    shapes = atlas.lines.geometry.to_numpy()
    near = [i for i in range(len(shapes)) if i != k and shapes[i].intersects(window.box)]
    if atlas.polygons is not None:
        for i in near:
            maps.draw_area(axes, atlas.polygons.geometry.iloc[i], maps.NEIGHBOUR, width=0.3, opacity=0.10, zorder=2)
    if near:
        lines = [shapely.clip_by_rect(shapes[i], window.left, window.bottom, window.right, window.top) for i in near]
        maps.draw_lines(axes, lines, maps.NEIGHBOUR, 1.0, zorder=2.5)


def _named(axes: Any, window: maps.Window, shape: Any, number: str) -> None:
    """The number of the segment on its middle, or beside it if it is short; A and B beyond its ends."""
    import numpy as np

    part = max(getattr(shape, "geoms", [shape]), key=lambda each: each.length)
    x, y = maps.middle(shape)
    ends = _ends(shape)
    way = np.subtract(*[np.array(place) for place in list(ends.values())[::-1]]) if len(ends) == 2 else np.zeros(2)
    length = float(np.hypot(*way))
    way = way / length if length else np.array([1.0, 0.0])
    mm = window.millimetre
    if part.length < 18 * mm:
        x, y = x - 5.5 * mm * way[1], y + 5.5 * mm * way[0]
    maps.write(axes, (x, y), number, fontsize=13, fontweight="bold", color=THIS, zorder=7)
    for sign, (letter, (a, b)) in zip((-1, 1), ends.items(), strict=False):
        axes.plot([a], [b], "o", ms=3.2, mfc="white", mec=THIS, mew=1.0, zorder=6.5)
        place = (a + 3.2 * sign * mm * way[0], b + 3.2 * sign * mm * way[1])
        maps.write(axes, place, letter, fontsize=9, fontweight="bold", color="black", zorder=6.6)


def _sides(axes: Any, atlas: Atlas, window: maps.Window, row: Any) -> None:
    """Names of the compartments on both sides, inside them."""
    if atlas.compartments is None:
        return
    table = atlas.compartments
    for side in "ab":
        number = int(row[f"compartment_{side}"])
        for shape in table.geometry[table["compartment"] == number] if number else []:
            around = row.geometry.buffer(25 * window.millimetre)
            seen = shape.intersection(window.box).intersection(around)
            beside = seen.difference(row.geometry.buffer(11 * window.millimetre))
            seen = seen if beside.is_empty else beside  # beside the number of the segment
            if not seen.is_empty:
                part = max(getattr(seen, "geoms", [seen]), key=lambda each: each.area)
                point = part.representative_point()
                look = {"fontsize": 7.5, "style": "italic", "color": "#1d3d1d"}
                maps.write(axes, (point.x, point.y), f"compartment\n{number}", **look)


def _ends(shape: Any) -> dict[str, tuple[float, float]]:
    """The western end is A; a ring has one place where it starts."""
    part = max(getattr(shape, "geoms", [shape]), key=lambda each: each.length)
    places = sorted({tuple(map(float, part.coords[0][:2])), tuple(map(float, part.coords[-1][:2]))})
    return {letter: (place[0], place[1]) for letter, place in zip("AB", places, strict=False)}


def _placed(atlas: Atlas, place: tuple[float, float]) -> list[str]:
    """Where a point lies: in degrees for a device, and in the coordinates on the frame of the map."""
    lines = [f"{place[0]:,.0f} E  {place[1]:,.0f} N".replace(",", "\N{NO-BREAK SPACE}")]
    if atlas.grid.crs is not None:
        from pyproj import Transformer

        lon, lat = Transformer.from_crs(atlas.grid.crs, "EPSG:4326", always_xy=True).transform(*place)
        lines.insert(0, f"{abs(lat):.5f}\N{DEGREE SIGN} {'NS'[lat < 0]}  {abs(lon):.5f}\N{DEGREE SIGN} {'EW'[lon < 0]}")
    return lines


def _locator(figure: Figure, atlas: Atlas, box: Box, window: maps.Window, k: int) -> None:
    from matplotlib.patches import Rectangle

    whole = maps.window_of(atlas.grid.bounds, box[2:], margin=0.02, even=False)
    axes = maps.frame(figure, box, whole)
    axes.set_xticks([])
    axes.set_yticks([])
    left, bottom, right, top = atlas.grid.bounds
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, fc="#ececec", ec="#999999", lw=0.5))
    maps.draw_lines(axes, list(atlas.lines.geometry), "#8a8a8a", 0.5, zorder=2)
    maps.draw_lines(axes, [atlas.lines.geometry.iloc[k]], THIS, 1.8, zorder=3)
    size = (window.right - window.left, window.top - window.bottom)
    axes.add_patch(Rectangle((window.left, window.bottom), *size, fill=False, ec="black", lw=0.8, zorder=4))


def _system(atlas: Atlas) -> str:
    if atlas.grid.crs is None:
        return "Without a coordinate system: numbers on the frame count cells."
    return f"Coordinates on the frame: {crs_name(atlas.grid.crs)}, metres. Up is grid north."
