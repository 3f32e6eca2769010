"""Peak memory of each step, in bytes a cell: `python -m tests.benchmarks.memory STEP SIDE` measures one.

Each step runs in a process of its own. What earlier steps have left counts, what they used and gave back does not:
the peak is reset before the step. Two sizes are measured; their difference leaves out what the interpreter and the
libraries take.
"""

from __future__ import annotations

import gc
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from tests.benchmarks.measuring import MEMORY, Figure

#: Steps, and the threads that they use.
STEPS = {
    "align": 1,
    "network": 1,
    "degree": 1,
    "Bonacich": 1,
    "eigenvector": 1,
    "sampled betweenness": 1,
    "dissection": 1,
    "breaks": 1,
    "burns": 1,
    "burns on 2 threads": 2,
    "burns of 8 h": 1,
    "curve": 1,
    "write": 1,
}
#: At most so many bytes a cell: three times the probabilities, them included.
_ASKED = {"Bonacich": 96.0}
_SIDES, _SLOW_SIDES = (700, 1400), (400, 800)


def figures(names: Iterable[str] = tuple(STEPS)) -> Iterator[Figure]:
    """Bytes a cell of every step."""
    for name in names:
        sides = _SLOW_SIDES if name == "dissection" else _SIDES
        peaks = [_peak_of(name, side) for side in sides]
        cells = [side * side for side in sides]
        per_cell = (peaks[1] - peaks[0]) / (cells[1] - cells[0])
        yield Figure(MEMORY + name, cells[1], per_cell, "B/cell", _ASKED.get(name), threads=STEPS[name])


def peak_bytes() -> int:
    """Most memory that this process has held since `reset_peak`, or since its start."""
    status = Path("/proc/self/status")
    if status.exists():
        line = next(line for line in status.read_text(encoding="ascii").splitlines() if line.startswith("VmHWM"))
        return 1024 * int(line.split()[1])
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def reset_peak() -> None:
    """Let the peak be what is held now; only Linux can."""
    gc.collect()
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")


def _peak_of(step: str, side: int) -> int:
    environment = {**os.environ, "FIREBREAK_THREADS": str(STEPS[step])}
    command = [sys.executable, "-m", "tests.benchmarks.memory", step, str(side)]
    done = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
    return int(json.loads(done.stdout)["peak"])


def _prepare(step: str, side: int, folder: Path) -> Callable[[], Any]:
    """Do all before the step; return the step."""
    import numpy as np

    import firebreak_gis as fb
    from firebreak_gis.rasters import write_raster
    from tests.benchmarks.landscapes import fractal, paced, write_layers

    if step in ("align", "network"):
        layers = write_layers(folder, side)
        if step == "align":
            return lambda: fb.read_landscape(*layers, legend="paper")
        landscape = fb.read_landscape(*layers, legend="paper")
        return lambda: fb.spread_network(landscape)
    network = fractal(side)
    if step in ("breaks", "curve", "write"):
        priority = fb.rank(network, "degree")
    work: dict[str, Callable[[], Any]] = {
        "degree": lambda: fb.rank(network, "degree"),
        "Bonacich": lambda: fb.rank(network, "bonacich", beta=0.9),
        "eigenvector": lambda: fb.rank(network, "eigenvector"),
        "sampled betweenness": lambda: fb.rank(network, "betweenness", pivots=2),
        "dissection": lambda: fb.rank(network, "dissection"),
        "breaks": lambda: fb.select_breaks(priority, budget=0.1, burnable=network.burnable),
        "curve": lambda: fb.burn_curve(network, priority, budgets=np.linspace(0, 0.4, 41), n_runs=16),
        "write": lambda: write_raster(folder / "priority.tif", priority),
    }
    if step == "burns of 8 h":
        clocked = paced(side)
        return lambda: fb.simulate(clocked, n_runs=150, duration="8h")
    return work.get(step, lambda: fb.simulate(network, n_runs=150))


def main(step: str, side: str) -> None:
    """Measure one step and print its peak."""
    with tempfile.TemporaryDirectory() as folder:
        work = _prepare(step, int(side), Path(folder))
        reset_peak()
        kept = work()
        print(json.dumps({"peak": peak_bytes(), "kept": type(kept).__name__}))


if __name__ == "__main__":
    main(*sys.argv[1:])
