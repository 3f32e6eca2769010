"""The table and the picture, as files and as a section of docs/speed.md."""

from __future__ import annotations

import csv
import dataclasses
import datetime as dt
import math
import os
import platform
from pathlib import Path

from tests.benchmarks.measuring import MEMORY, Line
from tests.benchmarks.scaling import Cost, slope

BEGIN, END = "<!-- speed -->", "<!-- end of speed -->"
_PICTURE = "cost.png"
_HEAD = "| what | cells | threads | here | peer | peer's time | ratio | asked |\n|---|---|---|---|---|---|---|---|"


def machine() -> str:
    """Processor, system and versions, and the day."""
    import importlib.metadata

    model = platform.processor() or platform.machine()
    information = Path("/proc/cpuinfo")
    if information.exists():
        lines = information.read_text(encoding="utf-8", errors="replace").splitlines()
        model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), model)
    names = ("numpy", "numba", "scipy", "networkx", "igraph", "networkit")
    versions = []
    for name in names:
        try:
            versions.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            continue
    day = dt.datetime.now(dt.UTC).date().isoformat()
    return (
        f"{model}, {os.cpu_count()} processors, {platform.system()}, Python {platform.python_version()}, "
        f"{', '.join(versions)}, {day}"
    )


def table(lines: list[Line]) -> str:
    """The lines as a Markdown table."""
    return "\n".join([_HEAD, *(_row(line) for line in lines)])


def _row(line: Line) -> str:
    theirs, ratio = "", ""
    if line.peer:
        theirs = f"{_number(line.theirs)} {line.unit}"
        ratio = f"{_number(line.ratio)}x" + (" as long" if line.asked.startswith("at most") else "")
    verdict = line.asked
    if line.holds is False or line.fault:
        verdict = f"**{line.fault or 'missed'}** {line.asked}".strip()
    cells = f"{line.cells:,}" if line.cells else ""
    return (
        f"| {line.what} | {cells} | {line.threads} | {_number(line.ours)} {line.unit} | {line.peer} | {theirs} "
        f"| {ratio} | {verdict} |"
    )


def _number(value: float) -> str:
    if math.isnan(value):
        return ""
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"


def write(lines: list[Line], costs: list[Cost], folder: Path) -> None:
    """Write table.csv, table.md, costs.csv and the picture."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, rows in (("table.csv", lines), ("costs.csv", costs)):
        if rows:
            with (folder / name).open("w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, [f.name for f in dataclasses.fields(rows[0])], lineterminator="\n")
                writer.writeheader()
                writer.writerows(dataclasses.asdict(row) for row in rows)
    if lines:
        (folder / "table.md").write_text(f"{table(lines)}\n\n{machine()}\n", encoding="utf-8")
    if costs:
        picture(costs, folder / _PICTURE)


def picture(costs: list[Cost], path: Path) -> None:
    """Cost against cells on logarithmic axes, each kernel with its slope."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 4.6), dpi=110, layout="constrained")
    axes = figure.add_subplot()
    for kernel in dict.fromkeys(cost.kernel for cost in costs):
        chosen = [cost for cost in costs if cost.kernel == kernel]
        label = f"{kernel}: slope {slope(chosen):.2f}" if len(chosen) > 1 else kernel
        axes.loglog([c.cells for c in chosen], [c.seconds for c in chosen], marker="o", markersize=4, label=label)
    axes.set_xlabel("cells")
    axes.set_ylabel("seconds, one thread")
    axes.grid(alpha=0.3, which="major")
    figure.legend(loc="outside right upper", fontsize=8, frameon=False)
    figure.savefig(path)


def put_into(readme: Path, lines: list[Line], folder: Path, command: str) -> None:
    """Replace the section between the marks in a page (docs/speed.md): rows with a demand, command, machine and day."""
    text = readme.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN, 1)
    _, after = rest.split(END, 1)
    place = os.path.relpath(folder, readme.parent).replace(os.sep, "/")
    shown = [line for line in lines if line.asked]
    memory = [f"{line.what.removeprefix(MEMORY)} {line.ours:.0f}" for line in lines if line.what.startswith(MEMORY)]
    section = f"{table(shown)}\n\n![Cost against cells on one thread]({place}/{_PICTURE})\n\n"
    if memory:
        section += f"Peak memory in bytes a cell, what goes in included: {', '.join(memory)}.\n\n"
    section += f"All rows: `{place.removeprefix('../')}/table.md`. Made by `{command}` on {machine()}.\n"
    readme.write_text(f"{before}{BEGIN}\n{section}{END}{after}", encoding="utf-8")
