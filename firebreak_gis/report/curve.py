"""The figure of R(d_f): mean burnt share against the share of cells cut."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.report.figures import LINE_COLOURS, caption_under, new_figure, own_looks

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@own_looks
def curve_figure(
    result: xr.Dataset, *, title: str = "Burnt share against share of cells cut", caption: str = ""
) -> Figure:
    """Draw R(d_f) of every ranking.

    Parameters
    ----------
    result
        As `evaluation.summarise` returns it.
    title
        Title of the figure.
    caption
        What the numbers assume.
    """
    figure = new_figure(7.5, 5.0)
    axes = figure.subplots()
    draw_curve(axes, result)
    axes.set_title(title, fontsize=11, loc="left", fontweight="bold")
    caption_under(figure, caption, 110)
    return figure


def draw_curve(axes: Axes, result: xr.Dataset, *, budget: float | None = None, detail: bool = True) -> None:
    """Draw R(d_f) on given axes.

    Parameters
    ----------
    axes
        Where to draw.
    result
        As `evaluation.summarise` returns it.
    budget
        Share to mark with a vertical line.
    detail
        Whether to shade where the first ranking differs from the baseline and, for up to three rankings, to
        draw the band from the mean to the 90 % percentile and bars up to the maximum.
    """
    names = result["ranking"].to_numpy().tolist()
    baseline = result.attrs["baseline"]
    d_f = result["budget"].to_numpy()
    colours = iter(LINE_COLOURS * (1 + len(names) // len(LINE_COLOURS)))
    full = detail and len(names) <= 3
    every = max(1, d_f.size // 25)
    for k, name in enumerate(names):
        is_baseline = name == baseline
        colour = "#6c757d" if is_baseline else next(colours)
        rows = result.sel(ranking=name)
        mean, p90, top = (rows[key].to_numpy() for key in ("mean", "p90", "max"))
        axes.plot(d_f, mean, color=colour, lw=1.8, ls="--" if is_baseline else "-", label=name, zorder=3)
        if full:
            axes.fill_between(d_f, mean, p90, color=colour, alpha=0.12, lw=0)
            # Side by side, so that the bars of one ranking do not hide those of another.
            shift = (k - len(names) / 2) * 0.12 * (d_f[-1] - d_f[0]) / max(d_f.size, 1)
            axes.vlines(d_f[::every] + shift, mean[::every], top[::every], color=colour, lw=0.8, alpha=0.7)
    if detail:
        _mark_significance(axes, result, names, baseline, d_f)
    if budget is not None:
        axes.axvline(budget, color="black", lw=0.8, ls=":")
    axes.set_xlabel("share of burnable cells cut, $d_f$", fontsize=9)
    axes.set_ylabel("burnt share of the fuel, $R$", fontsize=9)
    axes.set_ylim(0.0, min(1.02, 1.08 * float(result["max" if full else "mean"].max()) or 0.05))
    axes.set_xlim(float(d_f[0]), float(d_f[-1]) if d_f.size > 1 else float(d_f[0]) + 1e-3)
    axes.tick_params(labelsize=8)
    axes.grid(color="#dddddd", lw=0.5)
    axes.legend(fontsize=8, frameon=False)


def _mark_significance(axes: Axes, result: xr.Dataset, names: list[str], baseline: str, d_f: np.ndarray) -> None:
    """Shade the budgets at which the first ranking burns significantly less, or more, than the baseline."""
    others = [name for name in names if name != baseline]
    if not others or d_f.size < 2:
        return
    first = result.sel(ranking=others[0])
    for found, colour, word in (("better", "#f4d35e", "below"), ("worse", "#b8a9c9", "above")):
        mask = first["significant"].to_numpy() == found
        if mask.any():
            axes.fill_between(
                d_f,
                0,
                1,
                where=mask,
                transform=axes.get_xaxis_transform(),
                color=colour,
                alpha=0.3,
                lw=0,
                label=f"{others[0]} {word} {baseline}, alpha = {result.attrs['alpha']:g}",
                zorder=0,
            )
