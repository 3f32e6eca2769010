"""Two and a half million cells from layers to fires and rankings in half the memory that the whole needs."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
import rasterio

from tests.benchmarks.landscapes import write_layers

#: What the steps are given [bytes]: half of what the network as a whole takes; and what is too little for that.
LIMIT, TOO_LITTLE = 480_000_000, 920_000_000
SIDE = 1600

#: Runs a command with a limit to its memory, and with blocks of so many cells. What lies in files is not counted.
RUN = """
import resource, sys
limit, cells = int(sys.argv[1]), int(sys.argv[2])
resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))
from firebreak_gis import memory
memory.BLOCK_CELLS = cells
from firebreak_gis.cli import main
sys.argv = ["firebreak", *sys.argv[3:]]
main()
"""


def steps(folder, side):
    """Words of each command, in turn; the second makes the network."""
    network, land = folder / "network.tif", folder / "land"
    return [
        ("align", *write_layers(folder / "layers", side), "-o", land),
        ("network", land, "--clock", "--wind-speed", 4, "--wind-from", 300, "-o", network),
        ("burn", network, "--window", 128, "--duration", "1h", "--runs", 8, "-o", folder / "burnt.tif"),
        ("rank", network, "--method", "degree", "-o", folder / "degree.tif"),
        ("rank", network, "--method", "bonacich", "-o", folder / "priority.tif"),
    ]


def run(*words, limit=LIMIT, cells=100_000):
    environment = {**os.environ, "FIREBREAK_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "GDAL_CACHEMAX": "32"}
    command = [sys.executable, "-c", RUN, str(limit), str(cells), *map(str, words), "--quiet"]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux limits what a process allocates")
def test_millions_of_cells_in_little_memory(tmp_path):
    # Compiling takes memory too, so all is compiled before: on a small map in blocks, and what only large ones need.
    for step in steps(tmp_path / "small", 200)[:-2]:
        done = run(*step, limit=8 * LIMIT, cells=10_000)
        assert done.returncode == 0, (step[0], done.stderr[-2000:])
    asked = steps(tmp_path, SIDE)
    for step in asked:
        if step[0] == "rank":
            run(*step[:-1], tmp_path / "compiled.tif", "--overwrite", limit=8 * LIMIT)
        done = run(*step)
        assert done.returncode == 0, (step[0], done.stderr[-2000:])
    with rasterio.open(tmp_path / "priority.tif") as priority, rasterio.open(tmp_path / "burnt.tif") as burnt:
        assert priority.shape == burnt.shape == (SIDE, SIDE)
        assert burnt.read(1).max() > 0
    assert run(*asked[1][:-1], tmp_path / "whole.tif", limit=TOO_LITTLE, cells=10**9).returncode != 0
