"""Maps at a round scale on paper: ground, coordinate lines, scale bar, north, segments."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.grid import Grid
from firebreak_gis.report.figures import WATER, hillshade
from firebreak_gis.schema import VARIABLES

if TYPE_CHECKING:
    import geopandas as gpd
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from firebreak_gis.report.mapbook.atlas import Atlas

_INCH = 0.0254
#: Scales of maps, 1 to so many; finer ones would show cells, not ground.
SCALES = tuple(m * 10**e for e in (3, 4, 5, 6) for m in (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8))[7:]
_STEPS = tuple(m * 10**e for e in range(1, 6) for m in (1, 2, 5))
#: How much of the colours of vegetation is left, how much shade changes them, and the light on flat ground, which keeps
#: its colour.
_FAINT, _SHADE, _FLAT = 0.45, 0.55, 0.5**0.5
#: Pixels across a map: small ground is drawn finer than its cells, large ground coarser.
_PIXELS = (260, 1100)
_HALO = "white"
GRID_LINE = "#1b3a57"
NEIGHBOUR = "#3a3a3a"


def faint(colour: str) -> str:
    """A colour of vegetation as the maps show it on flat ground."""
    from matplotlib.colors import to_hex, to_rgb

    red, green, blue = (1.0 - _FAINT * (1.0 - part) for part in to_rgb(colour))
    return str(to_hex((red, green, blue)))


@dataclass(frozen=True)
class Window:
    """The part of the ground that a map shows: its edges in map coordinates, and its scale, 1 to so many."""

    left: float
    bottom: float
    right: float
    top: float
    scale: float

    @property
    def millimetre(self) -> float:
        """Length on the ground of a millimetre on paper."""
        return self.scale / 1000.0

    @property
    def box(self) -> Any:
        """As a polygon."""
        import shapely

        return shapely.box(self.left, self.bottom, self.right, self.top)


def window_of(
    bounds: Sequence[float], size: tuple[float, float], *, margin: float, least: float = 0.0, even: bool = True
) -> Window:
    """Fit bounds into a frame of so many inches at a round scale.

    Parameters
    ----------
    bounds
        Left, bottom, right and top.
    size
        Width and height of the frame on paper [inch].
    margin
        Room around the bounds, as a share of the frame.
    least
        The finest scale wanted.
    even
        Whether the scale is a round one.

    Examples
    --------
    >>> window_of((0, 0, 500, 300), (7.0, 6.0), margin=0.1).scale
    5000.0
    """
    width, height = (side * _INCH for side in size)
    room = 1.0 - 2.0 * margin
    needed = max((bounds[2] - bounds[0]) / (width * room), (bounds[3] - bounds[1]) / (height * room), least)
    scale = float(next((s for s in SCALES if s >= needed), needed) if even else needed)
    x, y = (bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2
    across, up = width * scale / 2, height * scale / 2
    return Window(x - across, y - up, x + across, y + up, scale)


def frame(figure: Figure, place: tuple[float, float, float, float], window: Window) -> Axes:
    """Return axes at a place in inches (left, bottom, width, height) that show a window."""
    width, height = figure.get_size_inches()
    axes = figure.add_axes((place[0] / width, place[1] / height, place[2] / width, place[3] / height))
    axes.set_xlim(window.left, window.right)
    axes.set_ylim(window.bottom, window.top)
    axes.set_facecolor("#f7f7f7")
    return axes


def draw_ground(axes: Axes, atlas: Atlas, window: Window, *, contours: bool = True) -> float:
    """Hill shade with the vegetation faint on it, water, roads, and contour lines; their step [m], 0 for none."""
    step = 0.0
    rows, cols = _cells(atlas.grid, window)
    if rows.stop > rows.start and cols.stop > cols.start:
        image, edges = _picture(atlas, rows, cols)
        axes.imshow(image, extent=edges, interpolation="none", zorder=0)
        if contours and atlas.elevation is not None:
            step = _contours(axes, atlas.elevation[rows, cols], atlas.grid, (rows.start, cols.start))
    axes.set_xlim(window.left, window.right)
    axes.set_ylim(window.bottom, window.top)
    if atlas.water is not None:
        draw_features(axes, atlas.water, window, colour="#4a90c2", width=1.2, fill="#bcd9ea")
    if atlas.roads is not None:
        draw_features(axes, atlas.roads, window, colour="white", width=2.4)
        draw_features(axes, atlas.roads, window, colour="#6b4a2b", width=1.1)
    return step


def _cells(grid: Grid, window: Window) -> tuple[slice, slice]:
    """Rows and columns that a window shows, one more on each side."""
    transform, (n_rows, n_cols) = grid.transform, grid.shape
    size = abs(transform.a)
    first, last = (math.floor((transform.f - y) / size) for y in (window.top, window.bottom))
    west, east = (math.floor((x - transform.c) / size) for x in (window.left, window.right))
    return (
        slice(min(max(first - 1, 0), n_rows), max(min(last + 2, n_rows), 0)),
        slice(min(max(west - 1, 0), n_cols), max(min(east + 2, n_cols), 0)),
    )


def _picture(atlas: Atlas, rows: slice, cols: slice) -> tuple[np.ndarray, tuple[float, float, float, float]]:
    """(rows, cols, 3) uint8 of the ground, and its edges (left, right, bottom, top)."""
    from matplotlib.colors import to_rgb
    from scipy import ndimage

    count = max(rows.stop - rows.start, cols.stop - cols.start)
    step, fine = max(1, count // _PIXELS[1]), min(8, max(1, _PIXELS[0] // count))
    shape = ((rows.stop - rows.start) // step, (cols.stop - cols.start) // step)
    part = (
        slice(rows.start, rows.start + shape[0] * step, step),
        slice(cols.start, cols.start + shape[1] * step, step),
    )
    size = abs(atlas.grid.transform.a)
    colour = np.ones((shape[0] * fine, shape[1] * fine, 3))
    kinds = None if atlas.vegetation is None else np.kron(atlas.vegetation[part], np.ones((fine, fine), np.uint8))
    if kinds is not None:
        for code, name in VARIABLES["vegetation"].colours.items():
            colour[kinds == code] = 1.0 - _FAINT * (1.0 - np.array(to_rgb(name)))
    if atlas.elevation is not None:
        heights = atlas.elevation[part]
        known = np.isfinite(heights)
        filled = np.where(known, heights, heights[known].min() if known.any() else 0.0)
        smooth = ndimage.zoom(filled, fine, order=3, grid_mode=True, mode="nearest") if fine > 1 else filled
        shade = hillshade(smooth, size * step / fine)
        colour *= (1.0 + _SHADE * (shade - _FLAT))[..., np.newaxis]
        if kinds is not None:
            # Flat ground without fuel at the foot of the range is the sea, as in the overview of the plan.
            sea = (kinds == 0) & np.kron(~known | (heights <= 0.0), np.ones((fine, fine), bool))
            colour[sea] = to_rgb(WATER)
    left, top = atlas.grid.transform @ (cols.start, rows.start)
    return (255 * colour.clip(0, 1)).round().astype(np.uint8), (
        left,
        left + shape[1] * step * size,
        top - shape[0] * step * size,
        top,
    )


def _contours(axes: Axes, heights: np.ndarray, grid: Grid, corner: tuple[int, int]) -> float:
    if min(heights.shape) < 2 or not np.isfinite(heights).any():
        return 0.0
    low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
    step = next((s for s in _STEPS if (high - low) / s <= 20), 1000)
    levels = np.arange(math.ceil(low / step) * step, high, step)
    levels = levels[levels > max(low, 0.0) if low <= 0.0 else levels > low]
    if not levels.size:
        return 0.0
    left, top = grid.transform @ (corner[1] + 0.5, corner[0] + 0.5)
    size = abs(grid.transform.a)
    x = left + size * np.arange(heights.shape[1])
    y = top - size * np.arange(heights.shape[0])
    drawn = axes.contour(x, y, heights, levels=levels, colors="#7a4b1e", linewidths=0.35, alpha=0.75, zorder=1)
    axes.clabel(drawn, levels[::2], fontsize=5, fmt="%.0f", inline_spacing=1)
    return float(step)


def draw_features(
    axes: Axes, frame: gpd.GeoDataFrame, window: Window, *, colour: str, width: float, fill: str = "none"
) -> None:
    """Lines, and outlines of areas, inside a window."""
    import shapely
    from matplotlib.collections import LineCollection, PolyCollection

    shapes = frame.geometry.to_numpy()
    near = shapes[shapely.intersects(shapes, window.box)]
    parts = shapely.get_parts(shapely.clip_by_rect(near, window.left, window.bottom, window.right, window.top))
    areas = [np.asarray(part.exterior.coords) for part in parts if part.geom_type == "Polygon" and not part.is_empty]
    lines = [np.asarray(part.coords) for part in parts if part.geom_type in ("LineString", "LinearRing")]
    axes.add_collection(PolyCollection(areas, facecolors=fill, edgecolors=colour, linewidths=width / 2, zorder=1.5))
    axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, capstyle="round", zorder=1.6))


def draw_lines(axes: Axes, shapes: Sequence[Any], colours: Any, width: float, *, zorder: float) -> None:
    """Middle lines of segments; `colours` is one or as many as shapes."""
    import shapely
    from matplotlib.collections import LineCollection

    parts, owner = shapely.get_parts(np.asarray(shapes, dtype=object), return_index=True)
    coloured = colours if isinstance(colours, str) else [colours[k] for k in owner.tolist()]
    axes.add_collection(
        LineCollection(
            [np.asarray(part.coords) for part in parts],
            colors=coloured,
            linewidths=width,
            capstyle="round",
            joinstyle="round",
            zorder=zorder,
        )
    )


def draw_area(axes: Axes, shape: Any, colour: str, *, width: float, opacity: float, zorder: float) -> None:
    """The outline of a segment, filled faintly."""
    import shapely
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import to_rgba

    parts = [np.asarray(part.exterior.coords) for part in shapely.get_parts(shape)]
    axes.add_collection(
        PolyCollection(parts, facecolors=to_rgba(colour, opacity), edgecolors=colour, linewidths=width, zorder=zorder)
    )


def middle(shape: Any) -> tuple[float, float]:
    """The middle of the longest part of a line."""
    part = max(getattr(shape, "geoms", [shape]), key=lambda each: each.length)
    point = part.interpolate(0.5, normalized=True)
    return float(point.x), float(point.y)


def write(axes: Axes, place: tuple[float, float], text: str, **look: Any) -> None:
    """Text on a map, with a halo."""
    from matplotlib.patheffects import withStroke

    options: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 6, "zorder": 6, "clip_on": True} | look
    axes.text(*place, text, path_effects=[withStroke(linewidth=1.8, foreground=_HALO)], **options)


def draw_numbers(axes: Axes, atlas: Atlas, window: Window, *, skip: int | None = None, size: float = 6.0) -> None:
    """Numbers of the segments beside their middles, those built first where there is no room for all."""
    import shapely

    taken: list[tuple[float, float]] = []
    across, up = 0.75 * size * window.millimetre, 0.45 * size * window.millimetre
    if skip is not None:
        taken.append(middle(atlas.lines.geometry.iloc[skip]))
    for k, (number, shape) in enumerate(zip(atlas.lines["order"], atlas.lines.geometry, strict=True)):
        seen = shapely.clip_by_rect(shape, window.left, window.bottom, window.right, window.top)
        if k == skip or seen.is_empty:
            continue
        x, y = middle(seen)
        if seen.length < 5 * window.millimetre:  # the number would hide it
            y += 0.3 * size * window.millimetre
        if not any(abs(x - a) < across and abs(y - b) < up for a, b in taken):
            taken.append((x, y))
            write(axes, (x, y), str(int(number)), fontsize=size, color="#111111")


def dress(axes: Axes, window: Window, *, metres: bool) -> None:
    """Coordinate lines with their numbers on the frame, scale bar, scale, north."""
    step = next((s for s in _STEPS if s / window.millimetre >= 28), _STEPS[-1])
    for set_ticks, low, high in (
        (axes.set_xticks, window.left, window.right),
        (axes.set_yticks, window.bottom, window.top),
    ):
        places = np.arange(math.ceil(low / step) * step, high, step)
        places = places[(places > low + 7 * window.millimetre) & (places < high - 7 * window.millimetre)]
        set_ticks(places, [f"{place:,.0f}".replace(",", "\N{NO-BREAK SPACE}") for place in places])
    axes.tick_params(labelsize=6, length=2, pad=1.5, top=True, right=True)
    for label in axes.get_yticklabels():
        label.set(rotation=90, va="center")
    axes.grid(color=GRID_LINE, linewidth=0.3, alpha=0.45, zorder=1.2)
    _scale_bar(axes, window, metres=metres)
    _north(axes, window)


def _scale_bar(axes: Axes, window: Window, *, metres: bool) -> None:
    from matplotlib.patches import Rectangle

    mm = window.millimetre
    length = next((s for s in reversed(_STEPS) if s / mm <= 45), _STEPS[0])
    x, y = window.left + 5 * mm, window.bottom + 8 * mm
    axes.add_patch(
        Rectangle((x - 3 * mm, y - 6.2 * mm), length + 14 * mm, 12.6 * mm, color="white", alpha=0.82, lw=0, zorder=7)
    )
    for k in range(4):
        face = "black" if k % 2 == 0 else "white"
        axes.add_patch(Rectangle((x + k * length / 4, y), length / 4, 1.4 * mm, fc=face, ec="black", lw=0.5, zorder=8))
    unit, factor = ("km", 1000.0) if length >= 2000 else ("m", 1.0)
    unit = unit if metres else "cells"
    for share in (0.0, 0.5, 1.0):
        text = f"{share * length / factor:g}" + (f" {unit}" if share == 1.0 else "")
        axes.text(x + share * length, y + 2.3 * mm, text, fontsize=6.5, ha="center", va="bottom", zorder=8)
    if metres:
        scale = f"{window.scale:,.0f}".replace(",", "\N{NO-BREAK SPACE}")
        axes.text(x, y - 1.6 * mm, f"1 : {scale}", fontsize=7.5, fontweight="bold", va="top", zorder=8)


def _north(axes: Axes, window: Window) -> None:
    mm = window.millimetre
    x, y = window.right - 7 * mm, window.top - 15 * mm
    axes.fill(
        [x, x + 2.4 * mm, x, x - 2.4 * mm],
        [y + 9 * mm, y, y + 2 * mm, y],
        fc="black",
        ec="white",
        lw=0.8,
        zorder=8,
    )
    write(axes, (x, y + 11.2 * mm), "N", fontsize=9, fontweight="bold", zorder=8)
