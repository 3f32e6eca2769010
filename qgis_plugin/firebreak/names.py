"""Names of parameters and files in the forms that do not follow from the manifest, and what has no place there.

Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Mapping

#: Options that the plugin sets itself or that mean nothing in a form.
HIDDEN = frozenset(
    {
        *("output", "overwrite", "as_json", "progress_mode", "verbose", "quiet", "dry_run", "folder"),
        *("workers", "scheduler", "resume"),  # dask is not where QGIS is, and a form is not started again
    }
)

_OF_A_NETWORK = (
    "weather",
    "weather_step",
    "weather_columns",
    "weather_units",
    "weather_ignore",
    "model",
    "model_params",
    "wind_speed",
    "wind_from",
    "wind_uv",
    "moisture",
    "neighbourhood",
)

#: Options that a form leaves out: these two take a network, which was made for one model and one wind.
LEFT_OUT: Mapping[str, tuple[str, ...]] = {"burn": _OF_A_NETWORK, "assess": _OF_A_NETWORK}

#: Fields that mean something in the forms named here only.
ONLY_IN: Mapping[str, tuple[str, ...]] = {"COST": ("plan",)}

#: Parameter names that do not follow from the option or file.
RENAMED: Mapping[str, str] = {
    "mask": "INPUT_BREAKS",
    "like": "INPUT_GRID",
    "method_list": "METHODS",
    "polygons": "OUTPUT_BREAK_POLYGONS",
    "sizes": "OUTPUT_FIRE_SIZES",
    "breaks.gpkg": "OUTPUT_BREAK_POLYGONS",
    "burn_frequency.tif": "OUTPUT_FREQUENCY",
    "burn_frequency_with_breaks.tif": "OUTPUT_FREQUENCY_WITH_BREAKS",
    "comparison.png": "OUTPUT_FIGURE",
    "comparison.svg": "OUTPUT_FIGURE_SVG",
    "front.png": "OUTPUT_FRONT_FIGURE",
    "evaluation.png": "OUTPUT_FIGURE",
    "evaluation.svg": "OUTPUT_FIGURE_SVG",
    "table": "OUTPUT_FIRES",
    "run.json": "OUTPUT_RUN",
    "run": "RUN_FOLDER",
    "report.html": "OUTPUT_REPORT",
}

#: The file behind -o, which names the output, of commands that write one file; the stem is that of the style.
FILES: Mapping[str, tuple[str, str]] = {
    "network": ("network.tif", "Spread network"),
    "rank": ("priority.tif", "Cutting priority"),
    "breaks": ("breaks.tif", "Fire breaks"),
    "burn": ("burn_frequency.tif", "Burn frequency"),
    "segments": ("segments.gpkg", "Segments to build, in order"),
    "siting": ("suitability.tif", "Where a line can be held"),
    "report": ("report.html", "The run on one page"),
    "calibrate": ("calibration.toml", "Calibration, which other forms take"),
    "mapbook": ("mapbook.pdf", "Map book"),
    "export": ("crews.*", "File for the crew"),
}

#: Endings among which the destination of such a file chooses; the first one is the usual one.
ENDINGS: Mapping[str, tuple[str, ...]] = {"crews.*": (".kml", ".gpx", ".dxf", ".zip", ".geojson")}

#: Parameters of methods that an option of the same meaning sets; the help leaves them out.
SET_BY_OPTION = frozenset({"wind_speed", "wind_from_direction", "moisture"})

#: Outputs from the top of the map to its bottom.
DRAWING_ORDER = (
    "OUTPUT_ASSESSMENT",
    "OUTPUT_SEGMENTS",
    "OUTPUT_BREAK_POLYGONS",
    "OUTPUT_BREAKS",
    "OUTPUT_COMPARTMENTS",
    "OUTPUT_PODS",
    "OUTPUT_FREQUENCY_WITH_BREAKS",
    "OUTPUT_FREQUENCY",
    "OUTPUT_PRIORITY",
    "OUTPUT_SUITABILITY",
    "OUTPUT_NETWORK",
    "OUTPUT_DENSITY_EFFECT",
    "OUTPUT_VEGETATION_EFFECT",
    "OUTPUT_DENSITY",
    "OUTPUT_VEGETATION",
    "OUTPUT_ELEVATION",
)
