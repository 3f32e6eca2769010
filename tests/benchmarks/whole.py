"""The whole way on files, step by step: `python -m tests.benchmarks.whole DEM VEGETATION DENSITY FOLDER`.

Run as a program of its own, so that its start and its memory count; prints the seconds of each step as JSON.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def main(dem: str, vegetation: str, density: str, folder: str) -> None:
    """Align, network, Bonacich, breaks, 100 fires without and 100 with the breaks, write."""
    steps: dict[str, float] = {}

    @contextmanager
    def step(name: str) -> Iterator[None]:
        started = time.perf_counter()
        yield
        steps[name] = time.perf_counter() - started

    with step("import"):
        import firebreak_gis as fb
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    with step("align"):
        landscape = fb.read_landscape(dem, vegetation, density, legend="paper")
    with step("network"):
        network = fb.spread_network(landscape)
    with step("Bonacich"):
        priority = fb.rank(network, "bonacich")
    with step("breaks"):
        breaks = fb.select_breaks(priority, budget=0.1)
    with step("100 burns without breaks"):
        before = fb.simulate(network, n_runs=100)
    with step("100 burns with breaks"):
        after = fb.simulate(network, breaks=breaks, n_runs=100)
    with step("write"):
        from firebreak_gis.landscape import write_landscape
        from firebreak_gis.rasters import write_raster

        write_landscape(landscape, target, overwrite=True)
        rasters = {
            "priority": priority,
            "breaks": breaks,
            "burn_frequency": before["burn_frequency"],
            "burn_frequency_with_breaks": after["burn_frequency"],
        }
        for name, data in rasters.items():
            write_raster(target / f"{name}.tif", data, overwrite=True)
    from tests.benchmarks.memory import peak_bytes

    shares = [float(burns["fire_size"].mean()) / network.n_burnable for burns in (before, after)]
    print(json.dumps({"steps": steps, "peak": peak_bytes(), "burnt": shares}))


if __name__ == "__main__":
    main(*sys.argv[1:])
