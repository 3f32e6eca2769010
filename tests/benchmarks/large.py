"""Landscapes of any size: `python -m tests.benchmarks.large make FOLDER SIDE` writes the layers of one.

`... run FOLDER SIDE [STEP ...]` does the steps on them, each in a process of its own, and adds its seconds and its
memory to FOLDER/SIDE.jsonl; `... draw FOLDER` draws all that is there against the number of cells.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

#: Cells between the numbers of each octave of the noise, and how much an octave weighs.
_OCTAVES = {4: 1.0, 16: 3.0, 64: 5.0, 256: 8.0, 1024: 8.0}
#: Rows that are made at once.
_ROWS = 256
RUNS = 1000


def noise(side: int, seed: int, first: int, rows: int) -> np.ndarray:
    """Rows of smooth noise of mean 0 and deviation about 1, (rows, side) float32; the same whatever is made at once."""
    out = np.zeros((rows, side), np.float32)
    for spacing, weight in _OCTAVES.items():
        size = side // spacing + 3
        knots = np.random.default_rng([seed, spacing]).standard_normal((size, size)).astype(np.float32)
        row, col = (np.arange(first, first + rows) / spacing, np.arange(side) / spacing)
        up, left = row.astype(int), col.astype(int)
        down, right = (row - up).astype(np.float32)[:, None], (col - left).astype(np.float32)
        near = [knots[up + k][:, left] * (1 - right) + knots[up + k][:, left + 1] * right for k in (0, 1)]
        out += np.float32(weight) * (near[0] * (1 - down) + near[1] * down)
    return out / np.float32(0.6 * np.sqrt(sum(weight**2 for weight in _OCTAVES.values())))


def make(folder: Path, side: int) -> None:
    """Terrain, vegetation and density of 20 m cells as GeoTIFFs, made by rows."""
    import rasterio
    from affine import Affine
    from rasterio.windows import Window

    folder.mkdir(parents=True, exist_ok=True)
    how = {"driver": "GTiff", "height": side, "width": side, "count": 1, "crs": "EPSG:32635", "tiled": True}
    how |= {"transform": Affine(20, 0, 400_000, 0, -20, 4_200_000), "compress": "deflate", "zlevel": 1}
    kinds = {"dem": np.float32, "vegetation": np.uint8, "density": np.uint8}
    files = {name: rasterio.open(folder / f"{name}.tif", "w", dtype=kind, **how) for name, kind in kinds.items()}
    for first in range(0, side, _ROWS):
        rows = min(_ROWS, side - first)
        vegetation = np.digitize(noise(side, 2, first, rows), [-1.2, -0.7, 0.3]).astype(np.uint8)
        density = np.digitize(noise(side, 3, first, rows), [-0.4, 0.5]) + 1
        layers = {
            "dem": np.round(400 + 150 * noise(side, 1, first, rows), 1),
            "vegetation": vegetation,
            "density": np.where(vegetation > 0, density, 0),
        }
        for name, values in layers.items():
            files[name].write(values.astype(kinds[name]), 1, window=Window(0, first, side, rows))
    for file in files.values():
        file.close()


def steps(place: Path, side: int) -> dict[str, list[str]]:
    """Words of each command."""
    layers = [str(place / f"{name}.tif") for name in ("dem", "vegetation", "density")]
    out = {
        name: str(place / name)
        for name in ("land", "network.tif", "burnt.tif", "priority.tif", "walls.tif", "judged", "plan")
    }
    cells = ["--max-memory", "64GB"]
    wind = ["--wind-speed", "5", "--wind-from", "315"]
    ends = ["--duration", "8h", "--hold", "0.47"]
    return {
        "align": ["align", *layers, "-o", out["land"], *cells],
        "network": ["network", out["land"], "-o", out["network.tif"], "--clock", *wind, *cells],
        "1,000 fires of 8 h": [
            *("burn", out["network.tif"], "-o", out["burnt.tif"], "--window", "512"),
            *("--runs", str(RUNS), *ends, *cells),
        ],
        "degree": ["rank", out["network.tif"], "-o", out["priority.tif"], "--method", "degree", *cells],
        "Bonacich": ["rank", out["network.tif"], "-o", out["priority.tif"], "--method", "bonacich", *cells],
        "evaluate": [
            *(
                "evaluate",
                out["network.tif"],
                "-o",
                out["judged"],
                "--methods",
                "degree,random",
                "--budgets",
                "0,5%,10%",
            ),
            *("--runs", "100", "--duration", "8h", *cells),
        ],
        "dissection": ["rank", out["network.tif"], "-o", out["walls.tif"], "--method", "dissection", *cells],
        "plan": ["plan", *layers, "-o", out["plan"], *wind, "--line-width", "cells", *cells],
    }


def run(folder: Path, side: int, wanted: Iterable[str] = ()) -> Iterator[dict[str, Any]]:
    """Do the steps; seconds by the clock and of processor time, and the most resident memory [bytes] of each."""
    place = folder / str(side)
    if not (place / "dem.tif").exists():
        make(place, side)
    todo = steps(place, side)
    for name in wanted or todo:
        yield {"step": name, "cells": side * side, **measured([sys.executable, "-m", "firebreak_gis", *todo[name]])}


def measured(words: list[str]) -> dict[str, Any]:
    """Run a command that may write over its last output, and measure it."""
    started = time.perf_counter()
    process = subprocess.Popen([*words, "--overwrite", "--quiet"], stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{' '.join(words)} ended with {process.returncode}")
    seconds = {"wall": time.perf_counter() - started, "processor": used.ru_utime + used.ru_stime}
    return {name: round(value, 2) for name, value in seconds.items()} | {"memory": 1024 * used.ru_maxrss}


def read(folder: Path) -> list[dict[str, Any]]:
    """All that was measured; of each step and size the last."""
    lines = [json.loads(line) for file in sorted(folder.glob("*.jsonl")) for line in file.read_text().splitlines()]
    return list({(line["step"], line["cells"]): line for line in lines}.values())


def main(what: str, folder: str, *more: str) -> None:
    """Make, run or draw."""
    place = Path(folder)
    if what == "make":
        make(place, int(more[0]))
    elif what == "run":
        for line in run(place, int(more[0]), more[1:]):
            print(line, flush=True)
            with (place / f"{more[0]}.jsonl").open("a") as file:
                file.write(json.dumps(line) + "\n")
    else:
        from tests.benchmarks.growth import draw

        print(draw(read(place)))


if __name__ == "__main__":
    main(*sys.argv[1:])
