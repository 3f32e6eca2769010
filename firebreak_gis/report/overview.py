"""One page that shows a plan: terrain, fuel, burn frequency before and after, and what it saves."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.grid import Grid
from firebreak_gis.report.curve import draw_curve
from firebreak_gis.report.figures import (
    BREAK_COLOUR,
    EXISTING_COLOUR,
    WATER,
    caption_under,
    draw_breaks,
    draw_existing,
    draw_lines,
    hillshade,
    map_axes,
    new_figure,
    own_looks,
    ramp,
    show,
    show_classes,
    thin,
    thinning,
)
from firebreak_gis.schema import percent

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@own_looks
def overview_figure(
    landscape: xr.Dataset,
    breaks: xr.DataArray,
    before: xr.Dataset,
    after: xr.Dataset,
    evaluation: xr.Dataset,
    *,
    title: str,
    budget: float,
    caption: str = "",
    lines: gpd.GeoDataFrame | None = None,
    existing: gpd.GeoDataFrame | None = None,
) -> Figure:
    """Draw the overview of a plan.

    Parameters
    ----------
    landscape
        `elevation`, `vegetation`, `density`, `burnable`.
    breaks
        (y, x), above 0 where cut.
    before, after
        Burns without and with the breaks, as `simulate` returns them.
    evaluation
        As `evaluation.evaluate` returns it.
    title
        Headline.
    budget
        d_f of the plan, marked in the curve.
    caption
        What the numbers assume.
    lines
        Breaks that are lines, `breaks` being the cells that they pass; with `area_ha` and `length_m`.
    existing
        Breaks that stand already, in both burns.
    """
    grid = Grid.of(breaks)
    rows, cols = grid.shape
    figure = new_figure(13.5, 2.0 + 13.5 / 3 * 2 * 0.78 * min(max(rows / cols, 0.45), 1.6))
    figure.suptitle(title, fontsize=13, fontweight="bold")
    caption_under(figure, caption, 200)
    axes = figure.subplots(2, 3)
    # Small maps: what their pictures do not show of a large one need not be drawn. The first has the scale of all.
    elevation = thin(landscape["elevation"].to_numpy())
    shade = hillshade(elevation.astype(float), grid.cell_size * thinning(grid.shape))
    _terrain(axes[0, 0], landscape, grid, shade)
    map_axes(axes[0, 1], grid, "Vegetation type", scaled=False)
    show_classes(axes[0, 1], thin(landscape["vegetation"].to_numpy()), grid, "vegetation")
    map_axes(axes[0, 2], grid, "Vegetation density", scaled=False)
    show_classes(axes[0, 2], thin(landscape["density"].to_numpy()), grid, "density")
    # One scale for both maps, no higher than needed, so that rare fires still show.
    top = max(0.1, float(np.ceil(10 * np.nanmax(before["burn_frequency"].to_numpy(), initial=0.0)) / 10))
    _frequency(axes[1, 0], before, grid, shade, "Burn frequency without breaks", top)
    _frequency(axes[1, 1], after, grid, shade, "Burn frequency with the breaks", top)
    if existing is not None:
        for each in axes[1, :2]:
            draw_existing(each, existing, grid)
    _lay(axes[1, 1], breaks, lines, existing, grid, max(int(after.attrs["n_burnable"]), 1))
    draw_curve(axes[1, 2], evaluation, budget=budget, detail=False)
    axes[1, 2].set_title("Burnt share against share cut", fontsize=10, loc="left", fontweight="bold")
    return figure


def _terrain(axes: Axes, landscape: xr.Dataset, grid: Grid, shade: np.ndarray) -> None:
    map_axes(axes, grid, "Terrain" + ("" if grid.crs is None else " (axes in km)"))
    elevation = thin(landscape["elevation"].to_numpy())
    # Flat water at the foot of the range would otherwise look like low ground.
    water = (elevation <= 0.0) & (thin(landscape["vegetation"].to_numpy()) == 0)
    image = show(axes, np.where(water, np.nan, elevation), grid, cmap=ramp("elevation"))
    show(axes, np.where(water, np.nan, shade), grid, cmap="gray", alpha=0.35, vmin=0, vmax=1)
    axes.set_facecolor(WATER)
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.75, pad=0.02)
    bar.set_label("elevation [m]", fontsize=8)
    bar.ax.tick_params(labelsize=7)


def _frequency(
    axes: Axes,
    burns: xr.Dataset,
    grid: Grid,
    shade: np.ndarray,
    title: str,
    top: float,
) -> None:
    map_axes(axes, grid, title, scaled=False)
    frequency = thin(burns["burn_frequency"].to_numpy())
    sizes = burns["fire_size"].to_numpy()
    n_burnable = max(int(burns.attrs["n_burnable"]), 1)
    show(axes, shade, grid, cmap="gray", alpha=0.35, vmin=0, vmax=1)
    shown = np.where(frequency > 0, frequency, np.nan)
    image = show(axes, shown, grid, cmap=ramp("burn_frequency"), vmin=0.0, vmax=top)
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.75, pad=0.02)
    bar.set_label("share of runs", fontsize=8)
    bar.ax.tick_params(labelsize=7)
    mean, worst = (percent(cells / n_burnable) for cells in (sizes.mean(), sizes.max()))
    note = f"mean burnt {mean} of the fuel, worst run {worst}"
    axes.set_xlabel(note, fontsize=8)


def _lay(
    axes: Axes,
    breaks: xr.DataArray,
    lines: gpd.GeoDataFrame | None,
    existing: gpd.GeoDataFrame | None,
    grid: Grid,
    n_burnable: int,
) -> None:
    """Lay the breaks over a map, and say how much they are."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handle: Patch | Line2D
    if lines is None:
        draw_breaks(axes, thin(breaks.to_numpy()), grid)
        count = int(np.count_nonzero(breaks.to_numpy()))
        handle = Patch(color=BREAK_COLOUR, label=f"fire breaks: {count:,} cells, {percent(count / n_burnable)}")
    else:
        draw_lines(axes, lines, grid)
        share = percent(lines["area_ha"].sum() / (n_burnable * grid.cell_area_ha))
        told = f"fire breaks: {lines['length_m'].sum() / 1000:,.0f} km of lines, {share}"
        handle = Line2D([], [], color=BREAK_COLOUR, label=told)
    handles = [handle]
    if existing is not None:
        handles.append(Line2D([], [], color=EXISTING_COLOUR, linewidth=0.8, label="existing breaks"))
    axes.legend(handles=handles, loc="upper left", fontsize=7, framealpha=0.85)
