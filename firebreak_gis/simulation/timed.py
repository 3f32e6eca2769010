"""Fires with a clock: runs shared out among threads, weather by weather.

Every draw is keyed by the number of the run, so runs may be made in any order, on any thread, in groups of any size.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from firebreak_gis.lattice import NEVER
from firebreak_gis.progress import Progress, part
from firebreak_gis.simulation.holding import no_walls
from firebreak_gis.simulation.embers import nothing_flies
from firebreak_gis.simulation.products import Products, add_up, new_tally, own_sums, product_maps
from firebreak_gis.threads import run_pieces

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.arrival import Clock, Starts, Workspace
    from firebreak_gis.kernels.draws import Thresholds
    from firebreak_gis.kernels.tally import Tally
    from firebreak_gis.network import SpreadNetwork
