"""The table of algorithms: which command stands behind each, and how its form is laid out.

Everything else of a form - parameters, kinds, choices, defaults, help, files written - is read from
`manifest.json`, which the command line writes (`firebreak describe`). An option that this table does not
name appears among the advanced ones. Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

GROUPS: Mapping[str, str] = {"prepare": "Prepare", "plan": "Plan", "fire": "Fire", "judge": "Judge"}


@dataclass(frozen=True)
class Form:
    """One algorithm.

    Parameters
    ----------
    name
        Identifier after `firebreak:`, and the name of the command.
    title, group
        As the toolbox shows them; the group is a key of `GROUPS`.
    main
        Options shown at the top, in this order; all others are folded away.
    shown
        Outputs (by parameter name) that are made unless switched off; all others are made on demand.
    numbers
        Keys of the result that are given back as numbers, with their texts.
    before
        A command that is run first; it lays the given layers into the folder that the command reads.
    tags
        Words to find the algorithm by.
    """

    name: str
    title: str
    group: str
    main: tuple[str, ...]
    shown: tuple[str, ...]
    numbers: Mapping[str, str] = field(default_factory=dict)
    before: str | None = None
    tags: tuple[str, ...] = ()


_LAYERS = ("dem", "vegetation", "density", "legend")
_FIRES = ("n_runs", "ignitions", "seed")
_WIND = ("wind_speed", "wind_from")
_SHARES = {
    "burnt_share_without_breaks": "Mean burnt share without breaks",
    "burnt_share_with_breaks": "Mean burnt share with the breaks",
}
_CUT = {"cells_cut": "Cells cut", "ha_cut": "Area cut in hectares"}

#: All algorithms, in the order of the work; those whose command the manifest lacks are left out.
FORMS = (
    Form(
        "align",
        "Align landscape",
        "prepare",
        _LAYERS,
        ("OUTPUT_ELEVATION", "OUTPUT_VEGETATION", "OUTPUT_DENSITY"),
        tags=("reproject", "legend", "corine"),
    ),
    Form(
        "network",
        "Spread network",
        "prepare",
        (*_LAYERS, "model", *_WIND),
        ("OUTPUT_NETWORK",),
        {"burnable_cells": "Cells with fuel"},
        before="align",
        tags=("wind", "slope", "probability"),
    ),
    Form(
        "rank",
        "Rank cells",
        "plan",
        ("network", "budget", "method", "seed"),
        ("OUTPUT_PRIORITY",),
        tags=("centrality", "bonacich", "betweenness", "priority"),
    ),
    Form(
        "breaks",
        "Select fire breaks",
        "plan",
        ("priority", "budget"),
        ("OUTPUT_BREAKS", "OUTPUT_BREAK_POLYGONS"),
        {"cells_cut": "Cells cut"},
        tags=("fuel break", "mask"),
    ),
    Form(
        "segments",
        "Segments to build",
        "plan",
        ("network", "mask", "priority", "dem"),
        ("OUTPUT_SEGMENTS", "OUTPUT_COMPARTMENTS"),
        {
            "segments": "Segments",
            "stages": "Stages of construction",
            "km": "Length in kilometres",
            "compartments": "Compartments",
        },
        tags=("line", "stage", "compartment"),
    ),
    Form(
        "plan",
        "Plan fire breaks",
        "plan",
        (*_LAYERS, "budget", "method", *_WIND, *_FIRES),
        (
            "OUTPUT_BREAKS",
            "OUTPUT_SEGMENTS",
            "OUTPUT_FREQUENCY",
            "OUTPUT_FREQUENCY_WITH_BREAKS",
            "OUTPUT_OVERVIEW",
            "OUTPUT_REPORT",
        ),
        {**_CUT, **_SHARES},
        tags=("fuel break", "wildfire", "centrality"),
    ),
    Form(
        "burn",
        "Burn frequency",
        "fire",
        ("network", "mask", "duration", "hold", "embers", *_FIRES),
        ("OUTPUT_FREQUENCY",),
        {
            "mean_burnt_share": "Mean burnt share",
            "max_burnt_share": "Largest burnt share",
            "mean_ha": "Mean fire in hectares",
            "max_ha": "Largest fire in hectares",
        },
        tags=("simulation", "cellular automaton", "ignition"),
    ),
    Form(
        "evaluate",
        "Evaluate",
        "judge",
        ("network", "method_list", "baseline", *_FIRES),
        ("OUTPUT_EVALUATION", "OUTPUT_FIGURE", "OUTPUT_REPORT"),
        tags=("statistics", "wilcoxon", "curve"),
    ),
    Form(
        "compare",
        "Compare",
        "judge",
        ("network", "method_list", "budgets", "residuals", *_FIRES),
        ("OUTPUT_COMPARISON", "OUTPUT_FIGURE", "OUTPUT_REPORT"),
        tags=("statistics", "leak", "budget"),
    ),
    Form(
        "validate",
        "Validate against a scar",
        "judge",
        (*_LAYERS, "scar", "start", "duration", "weather", "weather_step", *_WIND, "n_runs", "seed"),
        ("OUTPUT_SCORES", "OUTPUT_FREQUENCY", "OUTPUT_VALIDATION", "OUTPUT_REPORT"),
        {"observed_ha": "Observed hectares", "simulated_ha": "Simulated hectares"},
        before="align",
        tags=("perimeter", "skill", "reliability", "calibration"),
    ),
    Form(
        "calibrate",
        "Calibrate on observed fires",
        "judge",
        (*_LAYERS, "fires", "weather", "fit", "least", "n_runs", "seed"),
        ("OUTPUT_CALIBRATION", "OUTPUT_REPORT"),
        {"n_fires": "Fires", "n_parameters": "Numbers fitted"},
        before="align",
        tags=("duration", "fire size", "rate of spread"),
    ),
)

#: Options that the plugin sets itself or that mean nothing in a form.
HIDDEN = frozenset(
    {"output", "overwrite", "as_json", "progress_mode", "verbose", "quiet", "dry_run", "folder", "config"}
)

#: Options that a form leaves out: that of burn takes a network, which was made for one model and one wind.
LEFT_OUT: Mapping[str, tuple[str, ...]] = {
    "burn": (
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
}

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
    "evaluation.png": "OUTPUT_FIGURE",
    "evaluation.svg": "OUTPUT_FIGURE_SVG",
    "table": "OUTPUT_FIRES",
    "run.json": "OUTPUT_RUN",
}

#: The file behind -o, which names the output, of commands that write one file; the stem is that of the style.
FILES: Mapping[str, tuple[str, str]] = {
    "network": ("network.tif", "Spread network"),
    "rank": ("priority.tif", "Cutting priority"),
    "breaks": ("breaks.tif", "Fire breaks"),
    "burn": ("burn_frequency.tif", "Burn frequency"),
    "segments": ("segments.gpkg", "Segments to build, in order"),
    "calibrate": ("calibration.toml", "Configuration for every command"),
}

#: Parameters of methods that an option of the same meaning sets.
SET_BY_OPTION = frozenset({"wind_speed", "wind_from_direction", "moisture"})

#: Which option takes the parameters of the method that another option chooses, and the kind of method.
METHOD_OPTIONS: Mapping[str, tuple[str, str]] = {
    "method_params": ("method", "ranking"),
    "model_params": ("model", "spread"),
}

#: Outputs from the top of the map to its bottom.
DRAWING_ORDER = (
    "OUTPUT_SEGMENTS",
    "OUTPUT_BREAK_POLYGONS",
    "OUTPUT_BREAKS",
    "OUTPUT_COMPARTMENTS",
    "OUTPUT_FREQUENCY_WITH_BREAKS",
    "OUTPUT_FREQUENCY",
    "OUTPUT_PRIORITY",
    "OUTPUT_NETWORK",
    "OUTPUT_DENSITY_EFFECT",
    "OUTPUT_VEGETATION_EFFECT",
    "OUTPUT_DENSITY",
    "OUTPUT_VEGETATION",
    "OUTPUT_ELEVATION",
)
