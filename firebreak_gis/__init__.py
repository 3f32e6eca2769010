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
    from firebreak_gis.breaks import Budget, removal_order, select_breaks
    from firebreak_gis.construction.compartments import compartments_of
    from firebreak_gis.construction.delineations import delineate
    from firebreak_gis.construction.pieces import break_polygons
    from firebreak_gis.construction.segments import segments_of
    from firebreak_gis.errors import Cancelled, FirebreakError
    from firebreak_gis.evaluation.assessment import assess
    from firebreak_gis.evaluation.calibration import calibrate_scars, calibrate_sizes
    from firebreak_gis.evaluation.curves import evaluate
    from firebreak_gis.evaluation.forecasting import validate
    from firebreak_gis.evaluation.paper.artificial_forest import artificial_forest
    from firebreak_gis.evaluation.paper.landscape import landscape_experiment
    from firebreak_gis.landscape import read_landscape, read_landscape_folder, write_landscape
    from firebreak_gis.landscape.existing import existing_breaks
    from firebreak_gis.landscape.legends import read_legend
    from firebreak_gis.landscape.lines import line_breaks
    from firebreak_gis.landscape.samples import sample_layers
    from firebreak_gis.landscape.siting import site
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.planning.comparison import compare
    from firebreak_gis.planning.design import rank
    from firebreak_gis.planning.lazy import lazy_network
    from firebreak_gis.planning.outputs import write_plan
    from firebreak_gis.planning.pipeline import plan
    from firebreak_gis.planning.years import YearsRequest
    from firebreak_gis.plugins import methods
    from firebreak_gis.rasters import write_raster
    from firebreak_gis.report.exploring import explore
    from firebreak_gis.report.mapbook import write_book
    from firebreak_gis.report.mapbook.atlas import read_atlas
    from firebreak_gis.report.page.folder import report_page
    from firebreak_gis.report.plotting import plot
    from firebreak_gis.simulation.budgets import burn_curve
    from firebreak_gis.simulation.embers import Embers
    from firebreak_gis.simulation.fires import simulate
    from firebreak_gis.simulation.holding import Hold
    from firebreak_gis.simulation.ignitions import ignition_places
    from firebreak_gis.simulation.products import Products
    from firebreak_gis.simulation.weather_reading import read_weather
    from firebreak_gis.simulation.workers import cluster
    from firebreak_gis.spread import spread_network, weather_networks
    from firebreak_gis.spread.artificial import forest
    from firebreak_gis.spread.raster import read_network
    from firebreak_gis.stakes import Stakes
    from firebreak_gis.vectors import write_vector

_HOMES = {
    "artificial_forest": "evaluation.paper.artificial_forest",
    "assess": "evaluation.assessment",
    "break_polygons": "construction.pieces",
    "Budget": "breaks",
    "burn_curve": "simulation.budgets",
    "calibrate_scars": "evaluation.calibration",
    "calibrate_sizes": "evaluation.calibration",
    "Cancelled": "errors",
    "cluster": "simulation.workers",
    "compare": "planning.comparison",
    "compartments_of": "construction.compartments",
    "delineate": "construction.delineations",
    "Embers": "simulation.embers",
    "evaluate": "evaluation.curves",
    "existing_breaks": "landscape.existing",
    "explore": "report.exploring",
    "FirebreakError": "errors",
    "forest": "spread.artificial",
    "Hold": "simulation.holding",
    "ignition_places": "simulation.ignitions",
    "landscape_experiment": "evaluation.paper.landscape",
    "lazy_network": "planning.lazy",
    "line_breaks": "landscape.lines",
    "methods": "plugins",
    "plan": "planning.pipeline",
    "plot": "report.plotting",
    "Products": "simulation.products",
    "rank": "planning.design",
    "read_atlas": "report.mapbook.atlas",
    "read_landscape": "landscape",
    "read_landscape_folder": "landscape",
    "read_legend": "landscape.legends",
    "read_network": "spread.raster",
    "read_weather": "simulation.weather_reading",
    "removal_order": "breaks",
    "report_page": "report.page.folder",
    "sample_layers": "landscape.samples",
    "segments_of": "construction.segments",
    "select_breaks": "breaks",
    "simulate": "simulation.fires",
    "site": "landscape.siting",
    "spread_network": "spread",
    "SpreadNetwork": "network",
    "Stakes": "stakes",
    "validate": "evaluation.forecasting",
    "weather_networks": "spread",
    "write_book": "report.mapbook",
    "write_landscape": "landscape",
    "write_plan": "planning.outputs",
    "write_raster": "rasters",
    "write_vector": "vectors",
    "YearsRequest": "planning.years",
}

#: What each command is called here, where it has another name; None for those that look after the installation.
COMMANDS: dict[str, str | None] = {
    "align": "read_landscape",
    "breaks": "select_breaks",
    "burn": "simulate",
    "calibrate": "calibrate_scars",
    "demo": "sample_layers",
    "describe": None,
    "doctor": None,
    "export": "write_vector",
    "legends": "read_legend",
    "mapbook": "write_book",
    "network": "spread_network",
    "report": "report_page",
    "reproduce": "landscape_experiment",
    "segments": "segments_of",
    "siting": "site",
    "warmup": None,
    "weather": "read_weather",
}

__all__ = ["__version__", *_HOMES]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        meant = COMMANDS.get(name)
        hint = f"; firebreak {name} is fb.{meant}" if meant else ""
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}{hint}")
    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
