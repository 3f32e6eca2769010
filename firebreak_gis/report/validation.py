"""The figure of `validate`: the simulated fire over the scar, and how reliable its probabilities are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.evaluation.validation import LEAST_CELLS, Validation
from firebreak_gis.report.figures import extent, map_axes, new_figure, ramp, show

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SCAR = "#111111"
#: Colour, line and text of the outlines of null models.
_NULLS = {
    "distance": ("#00798c", (0, (4, 2)), "equal distance in fuel"),
    "ellipse": ("#8d5a97", (0, (1, 1.2)), "wind ellipse"),
}
_NAMES = {
    "simulated": "simulated, in half of runs",
    "shape": "simulated, likeliest cells",
    "none": "null: no growth",
    "distance": "null: equal distance",
    "ellipse": "null: wind ellipse",
}
#: Land around what burns, as a share of its extent.
_MARGIN = 0.15
_MOST_CONTOURS = 8
#: Burn probability from which contours of arrival are drawn.
_SEEN = 0.1


def validation_figure(result: Validation, *, title: str, fuel: np.ndarray) -> Figure:
    """Draw a validation.

    Parameters
    ----------
    result
        As `evaluation.validation.judge` returns it.
    title
        Headline.
    fuel
        (rows, cols) bool, shaded on the map.
    """
    figure = new_figure(13.0, 7.6)
    figure.suptitle(title, fontsize=12, fontweight="bold")
    place = figure.add_gridspec(2, 2, width_ratios=(1.45, 1.0), height_ratios=(1.25, 1.0))
    _map(figure.add_subplot(place[:, 0]), result, fuel)
    _reliability(figure.add_subplot(place[0, 1]), result)
    _scores(figure.add_subplot(place[1, 1]), result)
    return figure


def _map(axes: Axes, result: Validation, fuel: np.ndarray) -> None:
    from matplotlib.lines import Line2D

    grid, scar = result.grid, result.scar
    map_axes(axes, grid, "Burn probability, scar and arrival" + ("" if grid.crs is None else " (axes in km)"))
    show(axes, np.where(fuel, np.nan, 1.0), grid, cmap="Greys", vmin=0, vmax=2.5)
    axes.set_facecolor("white")
    probability = np.asarray(result.forecast.probability, dtype=np.float64)
    image = show(
        axes, np.where(probability > 0, probability, np.nan), grid, cmap=ramp("burn_frequency"), vmin=0, vmax=1
    )
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.7, pad=0.02)
    bar.set_label("share of the runs in which the cell burns", fontsize=8)
    bar.ax.tick_params(labelsize=7)
    handles = [Line2D([], [], color=_SCAR, lw=2.0, label="observed scar")]
    for name, (colour, line, text) in _NULLS.items():
        _outline(axes, result.fires[name], result, color=colour, ls=line, lw=1.4)
        handles.append(Line2D([], [], color=colour, ls=line, lw=1.4, label=f"null: {text}, as large as the scar"))
    levels = _hours(result)
    if levels.size:
        _, _, width, height = extent(grid)
        rows, cols = grid.shape
        x, y = (np.arange(cols) + 0.5) * width / cols, height - (np.arange(rows) + 0.5) * height / rows
        # Where few runs come, their median is noise.
        arrival = np.ma.masked_where(~(probability >= _SEEN), result.forecast.arrival)
        lines = axes.contour(x, y, arrival, levels=levels, colors="#4a3b2a", linewidths=0.6, alpha=0.75)
        axes.clabel(lines, fmt=lambda hours: f"{hours:g} h", fontsize=6)
        handles.append(Line2D([], [], color="#4a3b2a", lw=0.6, label="median arrival"))
    _outline(axes, scar.burnt, result, color=_SCAR, lw=2.0)
    row, col = np.argwhere(scar.start).mean(axis=0)
    size = extent(grid)[2] / grid.shape[1]
    axes.plot((col + 0.5) * size, extent(grid)[3] - (row + 0.5) * size, marker="*", ms=13, color="white", mec="black")
    handles.append(Line2D([], [], marker="*", ls="", ms=11, color="white", mec="black", label="start"))
    _zoom(axes, result, size)
    axes.figure.legend(handles=handles, loc="outside lower left", ncols=len(handles), fontsize=8, frameon=False)


def _outline(axes: Axes, mask: np.ndarray, result: Validation, *, color: str, lw: float, ls: Any = "-") -> None:
    """Draw the edges between cells inside and outside, not smoothed."""
    from matplotlib.collections import LineCollection

    _, _, width, height = extent(result.grid)
    size = width / mask.shape[1]
    padded = np.pad(mask.astype(bool), 1)
    lines = []
    for row, col in np.argwhere(padded[:-1] != padded[1:]).tolist():  # edges that run east and west
        y = height - row * size
        lines.append([((col - 1) * size, y), (col * size, y)])
    for row, col in np.argwhere(padded[:, :-1] != padded[:, 1:]).tolist():
        x = col * size
        lines.append([(x, height - (row - 1) * size), (x, height - row * size)])
    axes.add_collection(LineCollection(lines, colors=color, linewidths=lw, linestyles=ls))


def _hours(result: Validation) -> np.ndarray:
    """Round hours for the contours, not more than can be told apart."""
    arrival = result.forecast.arrival[result.forecast.probability >= _SEEN]
    arrival = arrival[np.isfinite(arrival)]
    if arrival.size < 4 or arrival.max() <= 0:
        return np.zeros(0)
    for step in (0.25, 0.5, 1.0, 2.0, 4.0, 6.0, 12.0, 24.0, 48.0, 96.0):
        levels = np.arange(step, arrival.max(), step)
        if 0 < levels.size <= _MOST_CONTOURS:
            return levels
    return np.zeros(0)


def _zoom(axes: Axes, result: Validation, size: float) -> None:
    """Show what burns or burnt, with a margin."""
    shown = result.scar.burnt | (result.forecast.probability >= 0.02)
    for name in _NULLS:
        shown |= result.fires[name]
    rows, cols = np.nonzero(shown)
    margin = _MARGIN * max(np.ptp(rows), np.ptp(cols)) + 3
    _, _, width, height = extent(result.grid)
    axes.set_xlim(max((cols.min() - margin) * size, 0.0), min((cols.max() + 1 + margin) * size, width))
    axes.set_ylim(
        max(height - (rows.max() + 1 + margin) * size, 0.0), min(height - (rows.min() - margin) * size, height)
    )


def _reliability(axes: Axes, result: Validation) -> None:
    curve = result.curve
    axes.set_title("Reliability", fontsize=10, loc="left", fontweight="bold")
    axes.plot([0, 1], [0, 1], color="#999999", lw=0.8, ls=":")
    axes.fill_between([0, 1], [-0.1, 0.9], [0.1, 1.1], color="#999999", alpha=0.12, lw=0)
    some = curve.cells > 0
    many = some & (curve.cells >= LEAST_CELLS)
    axes.plot(curve.forecast[some], curve.observed[some], color="#d1495b", lw=1.2)
    axes.plot(
        curve.forecast[many], curve.observed[many], "o", color="#d1495b", ms=6, label=f"{LEAST_CELLS} cells or more"
    )
    few = some & ~many
    axes.plot(curve.forecast[few], curve.observed[few], "o", color="white", mec="#d1495b", ms=5, label="fewer")
    for forecast, observed, cells in zip(curve.forecast[some], curve.observed[some], curve.cells[some], strict=True):
        axes.annotate(f"{cells}", (forecast, observed), (0, 6), textcoords="offset points", ha="center", fontsize=6)
    axes.set(xlim=(0, 1), ylim=(0, 1.05))
    axes.set_xlabel("burn probability of the simulation", fontsize=9)
    axes.set_ylabel("share of those cells that burnt", fontsize=9)
    axes.tick_params(labelsize=8)
    axes.legend(
        fontsize=7, frameon=False, loc="upper left", title="numbers are cells; grey: within 0.1", title_fontsize=7
    )


def _scores(axes: Axes, result: Validation) -> None:
    axes.axis("off")
    rows = [
        [
            _NAMES[name],
            *(f"{scores[key]:.2f}" for key in ("growth_iou", "iou", "sorensen", "size_ratio")),
            f"{scores['brier']:.4f}",
        ]
        for name, scores in result.scores.items()
    ]
    table = axes.table(
        rows,
        colLabels=["fire", "growth\nIoU", "IoU", "Sorensen", "size /\nobserved", "Brier"],
        colWidths=[0.40, 0.11, 0.09, 0.15, 0.14, 0.12],
        cellLoc="center",
        loc="upper center",
    )
    table.auto_set_font_size(False)
    table.set_fontsize(8)
    table.scale(1.0, 1.45)
    for (row, col), cell in table.get_celld().items():
        cell.set_edgecolor("#cccccc")
        if row == 0:
            cell.set_height(cell.get_height() * 1.3)
            cell.set_text_props(fontweight="bold")
        if col == 0:
            cell.set_text_props(ha="left")
        if row == 1:
            cell.set_facecolor("#fdf0e7")
    told = result.summary()
    hours = told["hours_to_observed_size"]
    reached = f"after {hours:.3g} h the mean fire is as large as the scar"
    sizes = (
        f"observed {told['observed_ha']:.4g} ha; simulated {told['simulated_ha']:.4g} ha in the mean, "
        f"{told['simulated_ha_p10']:.4g} to {told['simulated_ha_p90']:.4g} ha in 8 of 10 runs"
    )
    words = [sizes, "the observed size is never reached" if hours is None else reached, *result.notes]
    axes.text(0.0, 0.0, "\n".join(_wrapped(words)), fontsize=7, va="bottom", ha="left", transform=axes.transAxes)


def _wrapped(sentences: list[str]) -> list[str]:
    import textwrap

    return [line for sentence in sentences for line in textwrap.wrap(sentence, 88, subsequent_indent="   ")]
