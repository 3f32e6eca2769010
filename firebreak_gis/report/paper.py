"""The paper's figures, drawn from our results."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.grid import Grid
from firebreak_gis.report.curve import draw_curve
from firebreak_gis.report.figures import (
    BREAK_COLOUR,
    draw_breaks,
    hillshade,
    map_axes,
    new_figure,
    own_looks,
    ramp,
    show,
    show_classes,
)

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

#: Lines of Figure 1: label, colour, dash.
_LOOKS = {
    "bonacich 0.5": ("#d1495b", "-"),
    "bonacich 0.2": ("#e8899a", "-"),
    "bonacich 0.8": ("#8c1c2e", "-"),
    "betweenness": ("#00798c", "-"),
    "closeness": ("#edae49", "-"),
    "degree": ("#8d5a97", "-"),
    "eigenvector": ("#3b7a57", "-"),
    "flammability": ("#b5651d", ":"),
    "information": ("#1d3557", "-"),
    "current flow": ("#e76f51", "-"),
    "percolation": ("#8d5a97", "-"),
    "pagerank": ("#6a994e", "-"),
    "domirank": ("#edae49", "-"),
    "group betweenness": ("#00b4d8", "-"),
    "conventional": ("#b5651d", ":"),
    "random": ("#555555", "--"),
}


@own_looks
def figure_1(result: xr.Dataset, *, fallen: float) -> Figure:
    """R(d_f) of centralities on artificial forests; strips below show where each differs from random."""
    figure = new_figure(9.0, 7.0)
    top, strips = figure.subplots(2, 1, sharex=True, height_ratios=(4, 1.3))
    d_f = result["budget"].to_numpy()
    names = result["ranking"].to_numpy().tolist()
    for name in names:
        colour, dash = _LOOKS.get(name, ("#30638e", "-"))
        top.plot(d_f, result["mean"].sel(ranking=name), color=colour, ls=dash, lw=1.8, label=name)
    for name in ("bonacich 0.5", "random"):
        rows = result.sel(ranking=name)
        top.fill_between(d_f, rows["mean"], rows["p90"], color=_LOOKS[name][0], alpha=0.10, lw=0)
    top.axhline(fallen, color="#999999", lw=0.7, ls=":")
    top.set_ylabel("burnt share of the fuel, $R(d_f)$")
    top.set_ylim(0.0, 1.0)
    top.grid(color="#e3e3e3", lw=0.5)
    top.legend(fontsize=9, frameon=False, ncols=2)
    top.set_title(
        f"Artificial forests 50 x 50: mean of {result.attrs['n_forests']} forests x "
        f"{result.attrs['n_runs']} fires (bands: to the 90 % percentile)",
        fontsize=11,
        loc="left",
        fontweight="bold",
    )
    others = [name for name in names if name != result.attrs["baseline"]]
    for row, name in enumerate(reversed(others)):
        picked = result.sel(ranking=name)
        for word, alpha in (("better", 1.0), ("worse", 0.25)):
            mask = picked["significant"].to_numpy() == word
            strips.scatter(
                d_f[mask],
                np.full(mask.sum(), row),
                marker="s",
                s=14,
                color=_LOOKS[name][0],
                alpha=alpha,
                lw=0,
            )
    strips.set_yticks(range(len(others)), list(reversed(others)), fontsize=7)
    strips.set_ylim(-0.7, len(others) - 0.3)
    strips.set_xlim(float(d_f[0]), float(d_f[-1]))
    strips.set_xlabel("share of cells cut, $d_f$")
    strips.set_title(
        f"burns less (full) or more (pale) than random, Wilcoxon alpha = {result.attrs['alpha']:g}",
        fontsize=8,
        loc="left",
    )
    return figure


@own_looks
def figure_3(landscape: xr.Dataset) -> Figure:
    """Map of the vegetation density."""
    figure = new_figure(7.0, 6.5)
    axes = figure.subplots()
    grid = Grid.of(landscape["burnable"])
    map_axes(axes, grid, "Vegetation density (axes in km)")
    show_classes(axes, landscape["density"].to_numpy(), grid, "density")
    return figure


@own_looks
def figure_4(landscape: xr.Dataset, fire: xr.Dataset, grey: np.ndarray, *, wind: str) -> Figure:
    """Burn frequency from one ignition with wind, in colour and in the paper's grey levels."""
    figure = new_figure(13.0, 6.3)
    left, right = figure.subplots(1, 2)
    grid = Grid.of(landscape["burnable"])
    shade = hillshade(landscape["elevation"].to_numpy().astype(float), grid.cell_size)
    map_axes(left, grid, f"Burn frequency of {fire.attrs['n_runs']} runs, {wind}")
    show(left, shade, grid, cmap="gray", alpha=0.4, vmin=0, vmax=1)
    frequency = fire["burn_frequency"].to_numpy()
    image = show(left, np.where(frequency > 0, frequency, np.nan), grid, cmap=ramp("burn_frequency"), vmin=0, vmax=1)
    figure.colorbar(image, ax=left, shrink=0.8, label="share of runs")
    map_axes(right, grid, "The same in 16 grey levels, dark burns often")
    picture = np.where(grey == 0, np.nan, grey)
    image = show(right, picture, grid, cmap="gray", vmin=0, vmax=256)
    right.set_facecolor("#cfe2ee")
    figure.colorbar(image, ax=right, shrink=0.8, label="grey level", ticks=range(16, 257, 48))
    return figure


@own_looks
def figure_5(result: xr.Dataset, *, fires: str) -> Figure:
    """R(d_f) of Bonacich against the conventional policy and random cutting, with maxima and significance."""
    figure = new_figure(8.0, 5.5)
    axes = figure.subplots()
    draw_curve(axes, result)
    axes.set_title(
        f"Burnt share of the fuel, {result.sizes['run']} fires (bars: maximum)\n{fires}",
        fontsize=11,
        loc="left",
        fontweight="bold",
    )
    return figure


@own_looks
def figure_6(window: xr.Dataset, plans: dict[tuple[str, float], xr.DataArray]) -> Figure:
    """Breaks of two plans side by side."""
    from matplotlib.patches import Patch

    figure = new_figure(6.5 * len(plans), 6.3)
    grid = Grid.of(window["burnable"])
    shade = hillshade(window["elevation"].to_numpy().astype(float), grid.cell_size)
    for axes, ((label, budget), mask) in zip(figure.subplots(1, len(plans)), plans.items(), strict=True):
        map_axes(axes, grid, f"Breaks by {label}, $d_f$ = {budget:g}")
        show(
            axes,
            np.where(window["burnable"].to_numpy(), shade, np.nan),
            grid,
            cmap="gray",
            alpha=0.5,
            vmin=0,
            vmax=1,
        )
        draw_breaks(axes, mask.to_numpy(), grid)
        axes.legend(
            handles=[Patch(color=BREAK_COLOUR, label=f"{int((mask > 0).sum())} cells cut")],
            loc="upper left",
            fontsize=8,
            framealpha=0.85,
        )
    return figure


@own_looks
def class_figure(table: pd.DataFrame) -> Figure:
    """Classes of vegetation and density that rankings cut, beside what random cutting takes.

    Parameters
    ----------
    table
        As `evaluation.classes.class_table` returns it.
    """
    budgets, layers, methods = (list(dict.fromkeys(table[name])) for name in ("d_f", "layer", "method"))
    figure = new_figure(10.0, 3.2 * len(budgets))
    panels = figure.subplots(len(budgets), len(layers), squeeze=False, sharey=True)
    width = 0.8 / len(methods)
    for row, budget in zip(panels, budgets, strict=True):
        for axes, layer in zip(row, layers, strict=True):
            part = table[(table["d_f"] == budget) & (table["layer"] == layer)]
            for k, method in enumerate(methods):
                one = part[part["method"] == method]
                places = np.arange(len(one)) + (k - (len(methods) - 1) / 2) * width
                colour = _LOOKS.get(method, ("#30638e", "-"))[0]
                axes.bar(places, one["share"], width=0.92 * width, color=colour, label=method)
            spots = np.arange(len(one))
            axes.hlines(one["random"], spots - 0.45, spots + 0.45, color="black", lw=1.4, label="share of the fuel")
            axes.set_xticks(spots, one["class"], fontsize=9)
            axes.set_title(f"{layer}, $d_f$ = {budget:g}", fontsize=10, loc="left")
            axes.set_ylim(0.0, 1.0)
            axes.grid(axis="y", color="#e3e3e3", lw=0.5)
            axes.set_axisbelow(True)
        row[0].set_ylabel("share of the cut cells", fontsize=9)
    panels[0, 0].legend(fontsize=8, frameon=False)
    return figure
