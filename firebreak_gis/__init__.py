"""Plan wildfire fire breaks: rasters in, a spread network, ranked cells, breaks and burn maps out.

Data goes one way: files -> landscape -> spread network -> priority -> breaks -> burns -> evaluation ->
report. Each arrow is one function of this package; names are loaded on first use, so importing it costs
nothing.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

__version__ = "0.2.0"

if TYPE_CHECKING:
    from firebreak_gis.breaks import break_polygons, removal_order, select_breaks
    from firebreak_gis.construction.compartments import compartments_of
    from firebreak_gis.construction.segments import segments_of
    from firebreak_gis.errors import Cancelled, FirebreakError
    from firebreak_gis.evaluation.calibration import calibrate_scars, calibrate_sizes
    from firebreak_gis.evaluation.curves import evaluate
    from firebreak_gis.evaluation.forecasting import validate
    from firebreak_gis.landscape import read_landscape
    from firebreak_gis.landscape.lines import line_breaks
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.comparison import compare
    from firebreak_gis.planning.design import rank
    from firebreak_gis.planning.pipeline import plan
    from firebreak_gis.rasters import write_raster
    from firebreak_gis.report.plotting import plot
    from firebreak_gis.simulation.distributed import simulate_distributed
    from firebreak_gis.simulation.embers import Embers
    from firebreak_gis.simulation.fires import burn_curve, simulate
    from firebreak_gis.simulation.holding import Hold
    from firebreak_gis.simulation.ignitions import ignition_places
    from firebreak_gis.simulation.products import Products
    from firebreak_gis.simulation.weather_reading import read_weather
    from firebreak_gis.spread import spread_network, weather_networks
    from firebreak_gis.spread.artificial import forest
    from firebreak_gis.spread.raster import read_network
    from firebreak_gis.vectors import write_vector

_HOMES = {
    "break_polygons": "breaks",
    "burn_curve": "simulation.fires",
    "calibrate_scars": "evaluation.calibration",
    "calibrate_sizes": "evaluation.calibration",
    "Cancelled": "errors",
    "compare": "planning.comparison",
    "compartments_of": "construction.compartments",
    "Embers": "simulation.embers",
    "evaluate": "evaluation.curves",
    "FirebreakError": "errors",
    "forest": "spread.artificial",
    "ignition_places": "simulation.ignitions",
    "Hold": "simulation.holding",
    "line_breaks": "landscape.lines",
    "plan": "planning.pipeline",
    "plot": "report.plotting",
    "Products": "simulation.products",
    "rank": "planning.design",
    "read_landscape": "landscape",
    "read_network": "spread.raster",
    "read_weather": "simulation.weather_reading",
    "removal_order": "breaks",
    "segments_of": "construction.segments",
    "select_breaks": "breaks",
    "simulate": "simulation.fires",
    "simulate_distributed": "simulation.distributed",
    "spread_network": "spread",
    "SpreadNetwork": "network",
    "weather_networks": "spread",
    "validate": "evaluation.forecasting",
    "write_raster": "rasters",
    "write_vector": "vectors",
}

__all__ = ["__version__", *_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
