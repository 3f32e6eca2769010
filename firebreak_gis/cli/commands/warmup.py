"""firebreak warmup: compile the kernels before they are needed."""

from __future__ import annotations

import time
from typing import Any

import click

from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session
from firebreak_gis.progress import Progress, part, silent


@click.command("warmup")
@options.common
def command(session: Session) -> None:
    """Compile every kernel once, so that later runs start at once.

    The compiled code is kept beside the package, or in NUMBA_CACHE_DIR if that is set.
    """
    started = time.perf_counter()
    _warm_rankings(part(session.progress, 0.0, 0.4))
    _warm_large()
    _warm_clock()
    _warm_plans(part(session.progress, 0.5, 1.0))
    seconds = time.perf_counter() - started
    session.finish({"seconds": seconds}, f"kernels ready after {seconds:.1f} s")


def _warm_rankings(progress: Progress) -> None:
    """Compile every ranking, and fires without a clock."""
    from firebreak_gis import plugins
    from firebreak_gis.evaluation.curves import evaluate
    from firebreak_gis.ranking import rank
    from firebreak_gis.simulation.fires import simulate
    from firebreak_gis.spread import spread_network
    from firebreak_gis.spread.artificial import forest

    network = spread_network(forest((40, 50)), model="artificial")
    names = plugins.names("ranking")
    priorities = {}
    for i, name in enumerate(names):
        progress(i / len(names), name)
        priorities[name] = rank(network, name)
    progress(1.0, "fires")
    # Few runs are made one by one, many 64 at once: both kernels.
    for n_runs in (2, 200):
        simulate(network, value=None, n_runs=n_runs)
        evaluate(network, {"random": priorities["random"]}, budgets=[0.0, 0.1], n_runs=n_runs)


def _warm_large() -> None:
    """Compile what only a large network needs, on a small one that is treated as such."""
    import numpy as np

    from firebreak_gis.kernels.linear import katz
    from firebreak_gis.kernels.spectrum import perron_vector

    # One dense spot in thin fuel, so that the eigenvector is localised and its bound must be raised.
    probability = np.full((8, 90, 100), 0.05, np.float32)
    probability[:, 20:30, 20:30] = 0.9
    probability[:, 60:68, 60:68] = 0.8
    perron_vector(probability, boundary="periodic", direct_cells=0)
    katz(probability, 0.1, 0.99, boundary="periodic")


def _warm_clock() -> None:
    """Compile fires with a clock, embers, breaks that may fail, and all that is kept of them."""
    import numpy as np

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.simulation.embers import Embers
    from firebreak_gis.simulation.fires import simulate
    from firebreak_gis.simulation.products import Products

    shape = (8, 9, 11)
    network = SpreadNetwork(np.full(shape, 0.5), travel_time=np.full(shape, 90), heat=np.full(shape[1:], 2e4))
    products = Products((600.0,), (0.5,), (1.0,), (1.0,), paths=True, arrivals=True)
    embers = Embers(wind_speed=3.0, wind_from_direction=0.0)
    simulate(network, breaks=np.eye(9, 11), hold=0.5, duration=900, embers=embers, products=products, n_runs=2)


def _warm_plans(progress: Progress) -> None:
    """Compile what only a real landscape needs, by a small plan of each kind."""
    import numpy as np
    import xarray as xr
    from affine import Affine
    from pyproj import CRS

    from firebreak_gis.grid import Grid
    from firebreak_gis.placement.dissection import dissect
    from firebreak_gis.planning.pipeline import plan
    from firebreak_gis.planning.years import YearsRequest
    from firebreak_gis.stakes import Stakes

    y, x = np.mgrid[:48, :60]
    grid = Grid((48, 60), Affine(40.0, 0.0, 5e5, 0.0, -40.0, 4e6), CRS(32635))
    planes = {
        "elevation": (60.0 * np.sin(x / 7.0) * np.cos(y / 5.0)).astype(np.float32),
        "vegetation": np.ones(grid.shape, np.uint8),
        "density": np.ones(grid.shape, np.uint8),
        "burnable": (x + y) % 41 > 0,
    }
    landscape = xr.Dataset({name: grid.dataarray(plane, name) for name, plane in planes.items()})
    roads = (x == 30).astype(np.uint8)
    kinds: tuple[dict[str, Any], ...] = (
        {"embers": True, "roads": roads, "value": np.ones(grid.shape), "years": YearsRequest(years=2)},
        {"residual": 0.1, "duration": "2h"},
        {"line_width": "cells", "refine": True},
        {"timeless": True, "refine": True},
    )
    for i, kind in enumerate(kinds):
        progress(i / len(kinds), "plans")
        made = plan(landscape, budget="5%", n_runs=4, **kind)
        progress((i + 0.9) / len(kinds), f"a plan of {len(made.segments.lines)} segments")
    for leaky in (False, True):  # as large maps are cut
        dissect(made.network, Stakes(made.network), leaky=leaky, coarse_from=100, regions_from=500, progress=silent)
