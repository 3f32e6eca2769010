"""What a map loses that is dissected by regions: `python -m tests.benchmarks.regions [SIDE | FOLDER] [PARTS]`.

Walls of the whole and of a map parted into about PARTS regions first, on noise of SIDE x SIDE cells or on the layers
(dem, vegetation, density) in a FOLDER: processor time, expected loss, and the share of the fuel that fires burn which
end by themselves, at some budgets.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

BUDGETS = (0.01, 0.03, 0.05, 0.10)
RUNS = 256


def layers_of(what: str) -> list[str]:
    """Terrain, vegetation and density, whatever stands before these words; made where a side is given."""
    from tests.benchmarks.large import make

    folder = Path(what)
    if what.isdigit():
        folder = Path(tempfile.mkdtemp())
        make(folder, int(what))
    return [str(next(folder.glob(f"*{name}.tif"))) for name in ("dem", "vegetation", "density")]


def compared(what: str, parts: int) -> list[dict[str, Any]]:
    """One row a way: seconds, walls, expected loss and R at the budgets."""
    import firebreak_gis as fb
    from firebreak_gis.placement.dissection import dissect, lines_first, sequence
    from firebreak_gis.progress import silent

    network = fb.spread_network(fb.read_landscape(*layers_of(what)), wind_speed=5.0, wind_from_direction=315.0)
    stakes = fb.Stakes(network)
    rows = []
    for name, largest in (("whole", network.burnable.size), ("regions", network.n_burnable // parts)):
        sizes = np.zeros(network.burnable.size, np.int32)
        started = time.process_time()
        cuts = dissect(network, stakes, regions_from=largest, sizes=sizes, progress=silent)
        seconds = time.process_time() - started
        order = sequence([c.saved for c in cuts], [c.cost for c in cuts], [c.parent for c in cuts])
        spent = np.cumsum([cuts[i].cost for i in order]) / stakes.cost.sum()
        whole = sum(c.saved for c in cuts if c.parent < 0)
        loss = 1.0 - np.interp(BUDGETS, spent, np.cumsum([cuts[i].saved for i in order]))
        priority = lines_first([cuts[i].cells for i in order], stakes, sizes.reshape(network.shape))
        priority[~network.burnable] = -np.inf
        burnt = fb.burn_curve(network, priority, budgets=BUDGETS, n_runs=RUNS).mean("run") / network.n_burnable
        rows.append({"way": name, "seconds": seconds, "walls": len(cuts), "saved by the first": whole})
        rows[-1] |= {"loss": loss, "R": burnt.to_numpy()}
    return rows


def main(what: str = "1000", parts: str = "16") -> None:
    """Print the rows, and what regions lose."""
    whole, by_regions = rows = compared(what, int(parts))
    for row in rows:
        print({key: np.round(value, 5).tolist() for key, value in row.items() if key != "way"} | {"way": row["way"]})
    for key in ("loss", "R"):
        print(f"{key} by regions, more than by the whole:", (by_regions[key] / whole[key] - 1.0).round(4).tolist())


if __name__ == "__main__":
    main(*sys.argv[1:])
