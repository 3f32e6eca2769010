"""The figure of `compare`: burnt share of every ranking at every budget, one panel a residual."""

from __future__ import annotations

from typing import TYPE_CHECKING

from firebreak_gis.report.figures import LINE_COLOURS, new_figure

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


def comparison_figure(rows: pd.DataFrame, *, n_burnable: int, cell_area_ha: float) -> Figure:
    """Draw mean burnt share against budget.

    Parameters
    ----------
    rows
        As `comparison.comparison_table` returns it.
    n_burnable, cell_area_ha
        Cells that hold fuel, and their area.
    """
    residuals = sorted(rows["residual"].unique())
    labels = list(dict.fromkeys(rows["method"]))
    figure = new_figure(4.6 * len(residuals) + 0.6, 5.2)
    panels = figure.subplots(1, len(residuals), sharey=True, squeeze=False)[0]
    total = n_burnable * cell_area_ha
    for axes, residual in zip(panels, residuals, strict=True):
        for k, label in enumerate(labels):
            picked = rows[(rows["residual"] == residual) & (rows["method"] == label)].sort_values("d_f")
            colour = "#6c757d" if label == "random" else LINE_COLOURS[k % len(LINE_COLOURS)]
            marker = "osD^vP*X"[k % 8]
            low, high = picked["burnt_ha_low"] / total, picked["burnt_ha_high"] / total
            axes.plot(
                picked["d_f"],
                picked["R"],
                color=colour,
                lw=1.6,
                marker=marker,
                ms=4,
                label=label,
                ls="--" if label == "random" else "-",
            )
            axes.fill_between(
                picked["d_f"], low.clip(lower=1e-4), high.clip(lower=1e-4), color=colour, alpha=0.15, lw=0
            )
        leak = "perfect breaks" if residual == 0 else f"treated cells keep {100 * residual:g} %"
        axes.set_title(leak, fontsize=10, loc="left", fontweight="bold")
        axes.set_yscale("log")
        axes.set_xlabel("share of burnable cells cut, $d_f$", fontsize=9)
        axes.grid(color="#e0e0e0", lw=0.5, which="both")
        axes.tick_params(labelsize=8)
    panels[0].set_ylabel("mean burnt share of the fuel, $R$ (log)", fontsize=9)
    panels[0].set_ylim(max(5e-4, 0.6 * float(rows["R"].min())), 1.1)
    figure.legend(
        *panels[0].get_legend_handles_labels(),
        loc="outside lower center",
        ncols=min(len(labels), 6),
        fontsize=8,
        frameon=False,
    )
    return figure
