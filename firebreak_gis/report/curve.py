"""The figure of R(d_f): mean burnt share against the share of cells cut."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.report.figures import LINE_COLOURS, new_figure

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def curve_figure(result: xr.Dataset, *, title: str = "Burnt share against share of cells cut") -> Figure:
    """Draw R(d_f) of every ranking.

    Parameters
    ----------
    result
        As `evaluation.summarise` returns it.
    title
        Title of the figure.
    """
    figure = new_figure(7.5, 5.0)
    axes = figure.subplots()
    draw_curve(axes, result)
    axes.set_title(title, fontsize=11, loc="left", fontweight="bold")
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
        Whether to draw the band from the mean to the 90 % percentile, bars up to the maximum, and the strip that shows
        where the first ranking differs from the baseline.
    """
    names = result["ranking"].to_numpy().tolist()
    baseline = result.attrs["baseline"]
    d_f = result["budget"].to_numpy()
    colours = iter(LINE_COLOURS * (1 + len(names) // len(LINE_COLOURS)))
    for name in names:
        is_baseline = name == baseline
        colour = "#6c757d" if is_baseline else next(colours)
        rows = result.sel(ranking=name)
        mean, p90, top = (rows[key].to_numpy() for key in ("mean", "p90", "max"))
        axes.plot(d_f, mean, color=colour, lw=1.8, ls="--" if is_baseline else "-", label=name, zorder=3)
        if detail and len(names) <= 3:
            axes.fill_between(d_f, mean, p90, color=colour, alpha=0.15, lw=0)
            every = max(1, d_f.size // 25)
            axes.vlines(d_f[::every], mean[::every], top[::every], color=colour, lw=0.6, alpha=0.6)
    if detail:
        _mark_significance(axes, result, names, baseline, d_f)
    if budget is not None:
        axes.axvline(budget, color="black", lw=0.8, ls=":")
    axes.set_xlabel("share of burnable cells cut, $d_f$", fontsize=9)
    axes.set_ylabel("burnt share of the fuel, $R$", fontsize=9)
    axes.set_ylim(0.0, min(1.02, max(0.05, 1.08 * float(result["max" if detail and len(names) <= 3 else "mean"].max()))))
    axes.set_xlim(float(d_f[0]), float(d_f[-1]) if d_f.size > 1 else float(d_f[0]) + 1e-3)
    axes.tick_params(labelsize=8)
    axes.grid(color="#dddddd", lw=0.5)
    axes.legend(fontsize=8, frameon=False)


def _mark_significance(axes: Axes, result: xr.Dataset, names: list[str], baseline: str, d_f: np.ndarray) -> None:
    """Shade the budgets at which the first ranking burns significantly less than the baseline."""
    others = [name for name in names if name != baseline]
    if not others or d_f.size < 2:
        return
    first = result.sel(ranking=others[0])
    better = first["significant"].to_numpy() & (first["effect_size"].to_numpy() < 0)
    if better.any():
        axes.fill_between(d_f, 0, 1, where=better, transform=axes.get_xaxis_transform(), color="#f4d35e", alpha=0.25, lw=0,
                          label=f"{others[0]} below {baseline}, alpha = {result.attrs['alpha']:g}", zorder=0)
