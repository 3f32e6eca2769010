"""Rows about time that a user waits: start-up, and the whole way on files."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.landscapes import write_layers
from tests.benchmarks.measuring import Figure

_IMPORTS = ("firebreak_gis", "networkx", "igraph", "networkit")
_FIRST_FIRE = (
    "import numpy as np, firebreak_gis as fb; fb.simulate(fb.SpreadNetwork(np.full((8, 50, 50), 0.3)), n_runs=100)"
)


@dataclass
class _Ran:
    """How long a program ran by the clock, what it took of the processor, and what it printed."""

    clock: float
    processor: float
    printed: str


def program(*arguments: str, environment: Mapping[str, str] | None = None) -> _Ran:
    """Run a fresh Python to its end."""
    before, started = os.times(), time.perf_counter()
    done = subprocess.run(
        [sys.executable, *arguments],
        env={**os.environ, **(environment or {})},
        check=True,
        capture_output=True,
        text=True,
    )
    clock, after = time.perf_counter() - started, os.times()
    processor = after.children_user + after.children_system - before.children_user - before.children_system
    return _Ran(clock, processor or clock, done.stdout)  # Windows does not count children


def _median(*arguments: str, rounds: int = 5) -> float:
    """Seconds of processor time that a program takes."""
    program(*arguments)
    return float(np.median([program(*arguments).processor for _ in range(rounds)]))


def start_rows() -> Iterator[Figure]:
    """Seconds until something can be done."""
    yield Figure("start-up, Python itself", 0, _median("-c", "pass"), "s")
    for name in _IMPORTS:
        yield Figure(f"start-up, import {name}", 0, _median("-c", f"import {name}"), "s")
    yield Figure("start-up, firebreak --help", 0, _median("-m", "firebreak_gis", "--help"), "s", at_most=0.5)
    yield Figure("start-up to 100 fires on 50 x 50 cells", 2500, _median("-c", _FIRST_FIRE), "s")


def whole_rows(side: int) -> Iterator[Figure]:
    """From three GeoTIFFs to breaks and burn maps on disk, with its steps; and the whole command."""
    warm, first = (3.0, 12.0) if side == 1000 else (60.0, None) if side == 3000 else (None, None)
    cells, number = side * side, len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1
    with tempfile.TemporaryDirectory() as folder:
        layers = [str(path) for path in write_layers(Path(folder) / "layers", side)]
        way = ("-m", "tests.benchmarks.whole", *layers, str(Path(folder) / "out"))
        runs = [program(*way) for _ in range(4 if side <= 1000 else 1)]
        runs = runs[1:] or runs
        told: list[dict[str, Any]] = [json.loads(run.printed) for run in runs]
        yield Figure("files to files", cells, float(np.median([r.clock for r in runs])), "s", warm, threads=number)
        processor = float(np.median([r.processor for r in runs]))
        yield Figure("files to files, processor time", cells, processor, "s", threads=number)
        for name in told[0]["steps"]:
            part = float(np.median([t["steps"][name] for t in told]))
            yield Figure(f"files to files, of this {name}", cells, part, "s", threads=number)
        peak = max(t["peak"] for t in told) / 1e9
        yield Figure("files to files, peak memory", cells, peak, "GB", 4.0 if side == 3000 else None, threads=number)
        command = (
            "-m",
            "firebreak_gis",
            "plan",
            *layers,
            "--legend",
            "paper",
            "--method",
            "bonacich",
            "--overwrite",
            "-q",
            "-o",
            str(Path(folder) / "plan"),
        )
        took = program(*command).clock
        yield Figure("`firebreak plan`, with evaluation and picture", cells, took, "s", threads=number)
        if first is not None:
            fresh = {"NUMBA_CACHE_DIR": str(Path(folder) / "cache")}
            took = program(*way, environment=fresh).clock
            yield Figure("files to files, the very first time", cells, took, "s", first, threads=number)
