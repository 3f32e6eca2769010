"""The figures of `compare`: burnt share of every plan at every budget, and what is saved against what is paid."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from firebreak_gis.report.figures import LINE_COLOURS, caption_under, new_figure, own_looks

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure
    from matplotlib.ticker import Formatter

#: Rankings that lay a pattern known from practice.
PATTERNS = ("compartments", "dfpz", "splat", "stripes")


@own_looks
def comparison_figure(rows: pd.DataFrame, *, n_burnable: int, cell_area_ha: float, caption: str = "") -> Figure:
    """Draw mean burnt share against budget.

    Parameters
    ----------
    rows
        As `comparison.comparison_table` returns it.
    n_burnable, cell_area_ha
        Cells that hold fuel, and their area.
    caption
        What the numbers assume.
    """
    from matplotlib.ticker import FuncFormatter

    residuals = sorted(rows["residual"].unique())
    labels = list(dict.fromkeys(rows["method"]))
    figure = new_figure(4.6 * len(residuals) + 0.6, 5.4)
    panels = figure.subplots(1, len(residuals), sharey=True, squeeze=False)[0]
    total = n_burnable * cell_area_ha
    for axes, residual in zip(panels, residuals, strict=True):
        for k, label in enumerate(labels):
            picked = rows[(rows["residual"] == residual) & (rows["method"] == label)].sort_values("d_f")
            colour, line = _look(label, k)
            cut = picked["ha_cut"] / total  # of lines less than the budget, of which no wall may be built in part
            axes.plot(cut, picked["R"], color=colour, ls=line, lw=1.6, marker="osD^vP*X"[k % 8], ms=4.5, label=label)
            low, high = (picked[f"burnt_ha_{end}"].clip(lower=1e-6 * total) / total for end in ("low", "high"))
            axes.fill_between(cut, low, high, color=colour, alpha=0.12, lw=0)
        untreated = _untreated(rows) / total
        axes.axhline(untreated, color="#222222", lw=0.8, ls=":")
        axes.annotate(
            "no breaks", (1, untreated), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize=7
        )
        leak = (
            "breaks without a leak" if residual == 0 else f"breaks that leak: treated cells keep {100 * residual:g} %"
        )
        axes.set_title(leak, fontsize=10, loc="left", fontweight="bold")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(FuncFormatter(lambda share, _: f"{100 * share:g} %"))
        axes.yaxis.set_minor_formatter(_percent_between())
        axes.set_xlabel("share of the fuel cut", fontsize=9)
        axes.set_xlim(left=0.0)
        axes.grid(color="#e6e6e6", lw=0.5, which="both")
        axes.tick_params(labelsize=8, which="both")
    panels[0].set_ylabel("mean share of the fuel burnt, $R$ (log scale)", fontsize=9)
    top = 1.4 * max(float(rows["R"].max()), _untreated(rows) / total)
    panels[0].set_ylim(max(5e-4, 0.7 * float(rows["R"].min())), min(1.3, top))
    caption_under(figure, caption, 60 * len(residuals))
    figure.legend(
        *panels[0].get_legend_handles_labels(),
        loc="outside upper center",
        ncols=math.ceil(len(labels) / math.ceil(len(labels) / 8)),
        fontsize=8,
        frameon=False,
    )
    return figure


@own_looks
def front_figure(front: pd.DataFrame, *, priced: bool, caption: str = "") -> Figure:
    """Draw what plans save against what is paid for them, one panel a residual.

    Parameters
    ----------
    front
        As `evaluation.front.front_table` returns it.
    priced
        Whether costs and values are money; else hectares.
    caption
        What the numbers assume.
    """
    residuals = sorted(front["residual"].unique())
    labels = list(dict.fromkeys(front["method"]))
    figure = new_figure(4.6 * len(residuals) + 0.6, 5.4)
    panels = figure.subplots(1, len(residuals), sharey=True, squeeze=False)[0]
    unit = "money" if priced else "ha"
    for axes, residual in zip(panels, residuals, strict=True):
        here = front[front["residual"] == residual]
        best = here.loc[(here["saved"] - here["paid"]).idxmax()]
        for k, label in enumerate(labels):
            rows = here[here["method"] == label].sort_values("paid")
            colour, line = _look(label, k)
            origin = {name: [0.0, *rows[name]] for name in ("paid", "saved", "saved_low", "saved_high")}
            axes.plot(origin["paid"], origin["saved"], color=colour, ls=line, lw=1.6, label=label)
            axes.fill_between(origin["paid"], origin["saved_low"], origin["saved_high"], color=colour, alpha=0.12, lw=0)
            on = rows[rows["front"]]
            axes.plot(on["paid"], on["saved"], "o", color=colour, ms=5)
        reach = float(here["paid"].max())
        axes.plot([0.0, reach], [0.0, reach], color="#222222", lw=0.8, ls=":", label="saves what it costs")
        if best["stop"] > 0:
            axes.axvline(best["stop"], color="#222222", lw=0.9)
            axes.axvspan(best["stop_low"], best["stop_high"], color="#222222", alpha=0.07, lw=0)
            axes.annotate(
                f"{best['method']}: beyond this the next\n{'money' if priced else 'hectare'} saves less than it costs",
                (best["stop"], 0.98),
                xycoords=("data", "axes fraction"),
                xytext=(4, 0),
                textcoords="offset points",
                va="top",
                fontsize=7,
            )
        axes.set_title(f"residual {residual:g}", fontsize=10, loc="left", fontweight="bold")
        axes.set_xlabel("paid" if priced else "cut [ha]", fontsize=9)
        axes.set_xlim(0.0, 1.02 * reach)
        axes.grid(color="#e6e6e6", lw=0.5)
        axes.tick_params(labelsize=8)
    panels[0].set_ylabel(f"saved [{unit}]; dots: no other saves as much for less", fontsize=9)
    top = 1.08 * float(front["saved_high"].max())
    panels[0].set_ylim(min(0.0, 1.1 * float(front["saved"].min())), top if top > 0 else 1.0)
    caption_under(figure, caption, 60 * len(residuals))
    figure.legend(
        *panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=8, fontsize=8, frameon=False
    )
    return figure


def _percent_between() -> Formatter:
    """Percent at those ticks between powers of ten that a log axis labels."""
    from matplotlib.ticker import LogFormatter

    class Percent(LogFormatter):
        def __call__(self, x: float, pos: int | None = None) -> str:
            return f"{100 * x:g} %" if super().__call__(x, pos) else ""

    return Percent()


def _look(label: str, k: int) -> tuple[str, str]:
    """Colour and line of a ranking; patterns of practice are dashed, chance is grey."""
    method = label.partition(":")[0]
    if method == "random":
        return "#6c757d", ":"
    return LINE_COLOURS[k % len(LINE_COLOURS)], "--" if method in PATTERNS else "-"


def _untreated(rows: pd.DataFrame) -> float:
    """Hectares burnt without breaks: what burns with them and what they save."""
    first = rows.sort_values("ha_cut").iloc[-1]
    return float(first["burnt_ha"] + first["leverage"] * first["ha_cut"])
