"""How time and memory of the commands grow with the cells: the picture and the table of docs/speed.md."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

RESULTS = Path(__file__).parent / "results"


def slope(lines: Sequence[dict[str, Any]], what: str) -> float:
    """Exponent of the cells by which a step grows beyond what its smallest map takes, most of which is the start."""
    first, *others = sorted(lines, key=lambda line: float(line["cells"]))
    more = [(line["cells"], line[what] - first[what]) for line in others if line[what] > first[what]]
    if len(more) < 2:
        return float("nan")
    return float(np.polyfit(np.log([cells for cells, _ in more]), np.log([value for _, value in more]), 1)[0])


def draw(lines: Sequence[dict[str, Any]], folder: Path = RESULTS) -> str:
    """Write growth.csv and growth.png; return the table as Markdown."""
    from matplotlib.figure import Figure

    steps = {line["step"]: [each for each in lines if each["step"] == line["step"]] for line in lines}
    figure = Figure(figsize=(9, 3.8), layout="constrained")
    for axes, what, unit, factor in zip(
        figure.subplots(1, 2),
        ("processor", "memory"),
        ("processor time [s]", "peak memory [GB]"),
        (1.0, 1e-9),
        strict=True,
    ):
        for step, found in steps.items():
            ordered = sorted(found, key=lambda line: float(line["cells"]))
            cells, values = ([line[name] for line in ordered] for name in ("cells", what))
            axes.loglog(cells, np.array(values) * factor, "o-", label=step, markersize=4)
        limits = axes.get_xlim(), axes.get_ylim()
        span = np.array(limits[0])
        axes.loglog(span, limits[1][0] * span / 3e5, color="0.6", linestyle=":", linewidth=1, label="linear")
        axes.set(xlim=limits[0], ylim=limits[1])
        axes.set(xlabel="cells", ylabel=unit)
        axes.grid(alpha=0.3)
    figure.axes[1].legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.02, 1.0))
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / "growth.png", dpi=110)
    columns = ("step", "cells", "wall", "processor", "memory")
    with (folder / "growth.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: line[name] for name in columns} for line in lines)
    sizes = sorted({int(line["cells"]) for line in lines})
    head = f"| step | {' | '.join(f'{size:,}' for size in sizes)} | time grows by | memory grows by |"
    rows = [head, "|" + "---|" * (len(sizes) + 3)]
    for step, found in steps.items():
        told = {line["cells"]: f"{line['processor']:.3g} s, {line['memory'] / 1e9:.2g} GB" for line in found}
        exponents = [f"cells^{slope(found, what):.2f}" for what in ("processor", "memory")]
        rows.append(f"| {step} | {' | '.join(told.get(size, '') for size in sizes)} | {' | '.join(exponents)} |")
    return "\n".join(rows)
