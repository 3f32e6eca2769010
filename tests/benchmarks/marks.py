"""What asked times mean on this machine: `python -m tests.benchmarks.marks FOLDER [SIDE ...]`, some ten minutes.

The seconds that commands may take were asked for when files to files (`whole.py`: align, network, Bonacich, 100 fires
twice, write; none of it younger than the marks) took 16.6 s for nine million cells. It stands before and after each
command here; the command's time over theirs, times 16.6, is what holds against the mark. FOLDER keeps the landscapes.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

from tests.benchmarks.landscapes import write_layers
from tests.benchmarks.large import make
from tests.benchmarks.start import program

#: Files to files, nine million cells, where the marks were set [s].
THERE = 16.6
#: Cells a side of maps, and the seconds asked for their plans.
PLANS = {1000: 15.0, 3000: 180.0}
SAMPLE = [f"sample_data/{layer}.tif" for layer in ("dem", "vegetation", "density")]
EVERYTHING = (
    *("--wind-speed", "5", "--wind-from", "315", "--years", "10", "--budget-per-year", "30ha", "--embers", "on"),
    *("--existing", "sample_data/roads.gpkg", "--roads", "sample_data/roads.gpkg"),
    *("--values", "sample_data/villages.gpkg", "--max-slope", "35"),
)


def seconds(*words: str) -> float:
    """Of one run of a module by the clock."""
    return program("-m", *words).clock


def commands(folder: Path, sides: Iterable[int]) -> dict[str, tuple[float, list[str]]]:
    """By what they are: seconds asked, and the words."""
    found = {}
    for side in sides:
        place = folder / str(side)
        if not (place / "dem.tif").exists():
            make(place, side)
        layers = [str(place / f"{layer}.tif") for layer in ("dem", "vegetation", "density")]
        found[f"plan of {side:,} x {side:,}"] = (
            PLANS[side],
            ["plan", *layers, "--wind-speed", "5", "--wind-from", "315"],
        )
    found["plan of the sample, everything on"] = 20.0, ["plan", *SAMPLE, *EVERYTHING]
    seconds("firebreak_gis", "align", *SAMPLE, "--overwrite", "-o", str(folder / "land"))
    found["compare of the sample"] = 60.0, ["compare", str(folder / "land")]
    return found


def main(place: str, *sides: str) -> None:
    """Print a row a command."""
    folder = Path(place)
    layers = [str(path) for path in write_layers(folder / "yardstick", 3000)]
    yardstick = ("tests.benchmarks.whole", *layers, str(folder / "out"))
    seconds("firebreak_gis", "warmup")
    todo = commands(folder, map(int, sides or PLANS))
    seconds(*yardstick)  # the first compiles
    before = seconds(*yardstick)
    print("| command | s here | files to files, before and after | s where that takes 16.6 | asked |")
    print("|---|---|---|---|---|")
    for name, (asked, words) in todo.items():
        took = seconds("firebreak_gis", *words, "--overwrite", "-o", str(folder / words[0]))
        after = seconds(*yardstick)
        there = THERE * 2.0 * took / (before + after)
        print(f"| {name} | {took:.1f} | {before:.1f}, {after:.1f} | {there:.1f} | {asked:g} |", flush=True)
        before = after


if __name__ == "__main__":
    main(*sys.argv[1:])
