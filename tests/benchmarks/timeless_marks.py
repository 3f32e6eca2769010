"""Perfect breaks, fires without a clock, siting off, on Rhodes: ``python -m tests.benchmarks.timeless_marks FOLDER``.

The mean share R of the fuel that a fire burns under plans of `dissection`, with its standard error, in cells of 40 m:
no wind, random ignitions, fresh fires. The marks were measured when nested minimum cuts were added, in 2026.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from firebreak_gis import evaluate, read_landscape, spread_network
from firebreak_gis.kernels.draws import seed_for
from firebreak_gis.planning.design import Designs
from firebreak_gis.stakes import Stakes

#: R by d_f.
MARKS = {0.015: 0.0755, 0.025: 0.0357, 0.04: 0.0172, 0.095: 0.0040}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rhodes", type=Path, help="folder of rhodes_dem.tif, rhodes_vegetation.tif, ...")
    parser.add_argument("--runs", type=int, default=1000)
    options = parser.parse_args()
    layers = (options.rhodes / f"rhodes_{name}.tif" for name in ("dem", "vegetation", "density"))
    network = spread_network(read_landscape(*layers, resolution=40.0))
    plans = {"dissection": Designs(network, "dissection", stakes=Stakes(network))}
    result = evaluate(
        network,
        plans,
        budgets=list(MARKS),
        baseline="dissection",
        n_runs=options.runs,
        seed=seed_for(0, "comparison"),
    )
    cells = result["burnt_cells"].sel(ranking="dissection").transpose("budget", "run").to_numpy()
    for (budget, mark), burnt in zip(MARKS.items(), cells / network.n_burnable, strict=True):
        error = burnt.std(ddof=1) / np.sqrt(burnt.size)
        print(f"d_f {budget:g}: R {burnt.mean():.4f} (standard error {error:.4f}, {burnt.size} fires), mark {mark:.4f}")


if __name__ == "__main__":
    main()
