"""Estimated against measured memory of the commands: `python -m tests.benchmarks.estimates 1000 3000`; and against the
time that they take: `python -m tests.benchmarks.estimates times 300`.

Each command runs in a process of its own, whose peak the operating system tells. Rankings that take long on large
grids are left out unless they are named after the sizes, e.g. `... 1000 dissection,betweenness`.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import rasterio

from firebreak_gis import memory
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.rasters import write_raster

QUICK = ("flammability", "random", "bonacich")


def layers(folder: Path, size: int) -> list[str]:
    """Write hills, fuel in patches and densities of `size` x `size` cells; return the paths."""
    from affine import Affine

    grid = Grid((size, size), Affine(20.0, 0, 586_440.0, 0, -20.0, 3_999_900.0), parse_crs("EPSG:32635"))
    rng = np.random.default_rng(7)
    y, x = np.mgrid[0:size, 0:size].astype(np.float32) / 25
    blocks = rng.integers(0, 4, (size // 7 + 1, size // 7 + 1), dtype=np.uint8)
    planes = {
        "elevation": (300 + 200 * np.sin(x) * np.cos(0.7 * y)).astype(np.float32),
        "vegetation": np.kron(blocks, np.ones((7, 7), np.uint8))[:size, :size],
        "density": np.kron(1 + blocks[::-1] % 3, np.ones((7, 7), np.uint8))[:size, :size],
    }
    return [str(write_raster(folder / f"{name}.tif", grid.dataarray(v, name))) for name, v in planes.items()]


#: Starts a program and prints its exit code and peak. A new program counts the memory of the one that starts it as its
#: own peak, so that one must be small.
_START = """
import os, sys
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, 2, 1)])
_, status, usage = os.wait4(child, 0)
print(os.waitstatus_to_exitcode(status), usage.ru_maxrss)
"""


def peak(words: list[str]) -> int:
    """Bytes that `firebreak WORDS` held at its peak."""
    started = [sys.executable, "-I", "-S", "-c", _START, sys.executable, "-m", "firebreak_gis", *words]
    code, size = map(int, subprocess.run(started, check=True, stdout=subprocess.PIPE, text=True).stdout.split())
    if code != 0:
        raise SystemExit(f"firebreak {' '.join(words)} failed")
    # Kilobytes, but bytes on macOS.
    return size * (1 if sys.platform == "darwin" else 1024)


def measure(size: int, rankings: tuple[str, ...], *, whole: bool = True) -> dict[str, tuple[int, int]]:
    """Estimate and peak of every command on `size` x `size` cells, in bytes."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paths, network, timed = layers(folder, size), str(folder / "network.tif"), str(folder / "timed.tif")
        work = {
            "align": ["align", *paths, "-o", str(folder / "land")],
            "network": ["network", str(folder / "land"), "-o", network],
            **{f"rank {m}": ["rank", network, "--method", m, "-o", str(folder / f"{m}.tif")] for m in rankings},
            "burn": ["burn", network, "-o", str(folder / "f.tif")],
            "network, clock": ["network", str(folder / "land"), "-o", timed, "--clock", "--wind-speed", "5"],
            "rank random, clock": ["rank", timed, "--method", "random", "-o", str(folder / "timed_random.tif")],
        }
        if whole:
            plan = ["plan", *paths, "--method", rankings[0], "-o", str(folder / "plan")]
            work |= {"plan": plan}
        result = {}
        for what, words in work.items():
            command, _, method = what.removesuffix(", clock").partition(" ")
            method = rankings[0] if command == "plan" else method
            clock = what.endswith(", clock")
            estimated = memory.bytes_for(command, size * size, method=method or None, clock=clock)
            result[what] = estimated, peak([*words, "-q"])
        return result


def seconds_told(words: list[str], folder: Path) -> tuple[float, float]:
    """Seconds that `firebreak WORDS` said that it would take, and those from then to its end."""
    told, said_at = 0.0, 0.0
    with subprocess.Popen(
        [sys.executable, "-m", "firebreak_gis", *words, "--progress", "json"],
        cwd=folder,
        stdin=subprocess.PIPE,  # its end would be a stop
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        for line in process.stdout or ():
            found = re.match(r"This takes about ([\d.]+) (s|min|h)\b", json.loads(line).get("said", ""))
            if found:
                told, said_at = float(found[1]) * {"s": 1, "min": 60, "h": 3600}[found[2]], time.perf_counter()
    return told, time.perf_counter() - said_at if said_at else float("nan")


def measure_times(size: int) -> dict[str, tuple[float, float]]:
    """Seconds told first and seconds taken by commands that burn long, on `size` x `size` cells."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run = [sys.executable, "-m", "firebreak_gis"]
        subprocess.run([*run, "align", *layers(folder, size), "-o", "land", "-q"], cwd=folder, check=True)
        subprocess.run([*run, "network", "land", "-o", "net.tif", "--clock", "-q"], cwd=folder, check=True)
        with rasterio.open(folder / "land" / "vegetation.tif") as source:
            grid = Grid(source.shape, source.transform, parse_crs(source.crs.to_wkt()))
        rows, cols = np.indices(grid.shape)
        middle = np.maximum(np.abs(rows - size // 2), np.abs(cols - size // 2))
        wall = (rows % (size // 6) == size // 12) & (cols % (size // 3) > size // 24)
        for file, plane in (("wall", wall), ("start", middle < 8), ("scar", middle < size // 12)):
            write_raster(folder / f"{file}.tif", grid.dataarray(plane.astype(np.uint8), "breaks"))
        table = "landscape,scar,start,duration,weather\nland,scar.tif,start.tif,8h,rose:NW=4\n"
        (folder / "scars.csv").write_text(table)
        commands = {
            "burn": "burn net.tif --duration 8h --runs 20000 -o f.tif",
            "burn --window": "burn net.tif --duration 8h --window 128 --runs 20000 -o w.tif",
            "assess": "assess net.tif wall.tif --placements 1 --runs 400 -o a",
            "delineate": "delineate land --size 100 --runs 10000 -o d",
            "validate": "validate land scar.tif --start start.tif --duration 8h --weather rose:NW=4 --runs 8000 -o v",
            "calibrate": "calibrate scars.csv --runs 3000 -o fit.toml",
        }
        return {name: seconds_told(words.split(), folder) for name, words in commands.items()}


if __name__ == "__main__":
    if "times" in sys.argv[1:]:
        for number in [int(word) for word in sys.argv[1:] if word.isdigit()] or [300]:
            for row, (told, taken) in measure_times(number).items():
                print(
                    f"{number:5} {row:20} told {told:7.1f} s, taken {taken:7.1f} s, ratio {told / taken:.2f}",
                    flush=True,
                )
        raise SystemExit
    given = [word for word in sys.argv[1:] if not word.isdigit()]
    names = tuple(given[0].split(",")) if given else QUICK
    for number in [int(word) for word in sys.argv[1:] if word.isdigit()] or [1000]:
        for row, (estimated, measured) in measure(number, names).items():
            print(
                f"{number:5} {row:20} estimated {estimated / 1e6:7.0f} MB, measured {measured / 1e6:7.0f} MB, "
                f"ratio {estimated / measured:.2f}"
            )
