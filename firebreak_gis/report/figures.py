"""Shared looks of all figures: fonts, colours from the schema, map axes, saving."""

from __future__ import annotations

import contextlib
import functools
import io
import os
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from firebreak_gis.errors import OutputError
from firebreak_gis.files import write_bytes
from firebreak_gis.schema import VARIABLES

if TYPE_CHECKING:
    import geopandas as gpd
    from matplotlib.axes import Axes
    from matplotlib.colors import Colormap
    from matplotlib.figure import Figure

    from firebreak_gis.grid import Grid

#: Colour of cut cells on every map.
BREAK_COLOUR = "#1f4fd8"
EXISTING_COLOUR = "#2b2b2b"
#: Colours of rankings in curves, in order of drawing; the baseline is grey.
LINE_COLOURS = ("#d1495b", "#00798c", "#edae49", "#30638e", "#8d5a97", "#3b7a57", "#b5651d", "#c71585")
#: What each format would store of the time and the program, left out.
_DATES: dict[str, dict[str, None]] = {
    "png": {"Software": None},
    "svg": {"Date": None},
    "pdf": {"CreationDate": None},
}
#: Most cells along the longer side of a small picture.
_LONGEST = 1500
NO_FUEL = "#e4e4e4"
WATER = "#c6dbe8"

F = TypeVar("F", bound=Callable[..., Any])


def own_looks(draw: F) -> F:
    """Let a function draw with the settings of this package alone.

    A matplotlibrc of the user, who may ask for TeX or other fonts there, would change the pictures or fail.
    """

    @functools.wraps(draw)
    def wrapper(*args: Any, **kwargs: Any) -> Any:
        with _own_settings():
            return draw(*args, **kwargs)

    return wrapper  # type: ignore[return-value]


@contextlib.contextmanager
def _own_settings() -> Iterator[None]:
    import matplotlib as mpl

    settings = {key: mpl.rcParamsDefault[key] for key in mpl.rcParamsDefault if not key.startswith("backend")}
    # A fixed salt makes the identifiers inside an SVG the same each time.
    with mpl.rc_context(settings | {"svg.hashsalt": "firebreak_gis"}):
        yield


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of the given size in inches; no window, no global state."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def caption_under(figure: Figure, caption: str, width: int) -> None:
    """Write a caption of lines of `width` letters under a figure, if there is one."""
    if caption:
        figure.supxlabel(textwrap.fill(caption, width), fontsize=8)


@own_looks
def save(figure: Figure, path: str | os.PathLike[str], *, overwrite: bool = False, dpi: int = 150) -> Path:
    """Write a figure whole or not at all, without a date; .png, .svg or .pdf chooses the format."""
    target = Path(path)
    kind = target.suffix.lstrip(".").lower()
    if kind not in _DATES:
        raise OutputError(f"{target.name} has no known picture extension; expected .{', .'.join(_DATES)}")
    # Laid out here, once: to print a figure that has yet to be laid out, matplotlib draws it twice.
    figure.set_dpi(dpi)
    layout = figure.get_layout_engine()
    if layout is not None and figure.axes:  # there is nothing to lay out in a figure of words alone
        layout.execute(figure)
        figure.set_layout_engine("none")
    drawn = io.BytesIO()
    if kind == "png":  # nor by savefig, which draws once to be sure of the layout
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        FigureCanvasAgg(figure).print_png(drawn, metadata=_DATES[kind])  # type: ignore[no-untyped-call]
    else:
        figure.savefig(drawn, dpi=dpi, format=kind, metadata=_DATES[kind])
    write_bytes(target, drawn.getvalue(), overwrite=overwrite)
    return target


def ramp(name: str) -> Colormap:
    """Colour map of a continuous variable of the schema; no data is transparent."""
    from matplotlib.colors import LinearSegmentedColormap

    colours = [c for _, c in sorted(VARIABLES[name].colours.items())]
    return LinearSegmentedColormap.from_list(name, colours).with_extremes(bad=(0, 0, 0, 0))


def map_axes(axes: Axes, grid: Grid, title: str, *, scaled: bool = True) -> None:
    """Make `axes` a map of `grid`: equal scale, kilometres from the lower left corner if scaled, a north arrow."""
    left, bottom, right, top = extent(grid)
    axes.set_title(title, fontsize=10, loc="left", fontweight="bold")
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    axes.set_aspect("equal")
    axes.set_facecolor(NO_FUEL)
    if scaled:
        axes.tick_params(labelsize=7, length=2)
    else:
        axes.set(xticks=[], yticks=[])
    axes.annotate(
        "N",
        (0.965, 0.99),
        (0.965, 0.89),
        xycoords="axes fraction",
        ha="center",
        va="center",
        fontsize=7,
        arrowprops={"arrowstyle": "-|>", "color": "black", "lw": 0.8, "shrinkB": 0},
    )


def extent(grid: Grid) -> tuple[float, float, float, float]:
    """(left, bottom, right, top) in km from the lower left corner, or in cells without a CRS."""
    rows, cols = grid.shape
    scale = grid.cell_size / 1000.0 if grid.crs is not None else 1.0
    return 0.0, 0.0, cols * scale, rows * scale


def show(axes: Axes, values: np.ndarray, grid: Grid, **options: Any) -> Any:
    """Draw a (rows, cols) array on map axes."""
    left, bottom, right, top = extent(grid)
    return axes.imshow(values, extent=(left, right, bottom, top), interpolation="nearest", **options)


def thin(values: np.ndarray) -> np.ndarray:
    """Every n-th cell, so that the longer side has at most 1,500."""
    step = thinning(values.shape[:2])
    return values[::step, ::step]


def thinning(shape: tuple[int, ...]) -> int:
    """Which n-th cell of a grid is shown where it is thinned."""
    return -(-max(shape) // _LONGEST)


def show_classes(axes: Axes, values: np.ndarray, grid: Grid, name: str) -> None:
    """Draw a class variable in the colours of the schema, with its legend below the map."""
    from matplotlib.colors import to_rgb
    from matplotlib.patches import Patch

    variable = VARIABLES[name]
    picture = np.zeros((*values.shape, 3))
    for code, colour in variable.colours.items():
        picture[values == code] = to_rgb(colour)
    show(axes, picture, grid)
    patches = [
        Patch(facecolor=variable.colours[c], edgecolor="#666666", lw=0.4, label=t) for c, t in variable.classes.items()
    ]
    axes.legend(
        handles=patches,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.07),
        ncols=len(patches),
        fontsize=7,
        frameon=False,
        handlelength=1.2,
        columnspacing=1.0,
    )


def hillshade(elevation: np.ndarray, cell_size: float) -> np.ndarray:
    """Light from the north-west at 45 degrees on a (rows, cols) terrain, 0 to 1; the vertical is doubled."""
    from matplotlib.colors import LightSource

    filled = np.where(np.isfinite(elevation), elevation, np.nanmin(elevation) if np.isfinite(elevation).any() else 0.0)
    return np.asarray(LightSource(azdeg=315, altdeg=45).hillshade(filled, vert_exag=2.0, dx=cell_size, dy=cell_size))


def draw_breaks(axes: Axes, breaks: np.ndarray, grid: Grid) -> None:
    """Lay cut cells over a map."""
    from matplotlib.colors import to_rgba

    picture = np.zeros((*breaks.shape, 4))
    picture[breaks > 0] = to_rgba(BREAK_COLOUR)
    show(axes, picture, grid)


def draw_existing(axes: Axes, existing: gpd.GeoDataFrame, grid: Grid) -> None:
    """Lay breaks that stand already over a map, lines or the outlines of areas."""
    import shapely
    from matplotlib.collections import LineCollection

    shapes = existing.geometry.array
    areas = shapely.get_dimensions(shapes) == 2
    parts = shapely.get_parts(np.where(areas, shapely.boundary(shapes), shapes))
    places = [(shapely.get_coordinates(part) - np.array(grid.bounds[:2])) / 1000.0 for part in parts]
    axes.add_collection(LineCollection(places, colors=EXISTING_COLOUR, linewidths=0.8))


def draw_lines(axes: Axes, lines: gpd.GeoDataFrame, grid: Grid) -> None:
    """Lay breaks that are lines over a map, in their order: the first ones thickest."""
    import shapely
    from matplotlib.collections import LineCollection

    left, bottom = grid.bounds[:2]
    parts, wall = shapely.get_parts(lines.geometry.array, return_index=True)
    origin = np.array([left, bottom])
    places = [(shapely.get_coordinates(part) - origin) / 1000.0 for part in parts]
    thick = 2.0 - 1.2 * wall / max(len(lines) - 1, 1)
    axes.add_collection(LineCollection(places, colors=BREAK_COLOUR, linewidths=thick, capstyle="round"))
