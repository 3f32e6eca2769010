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
        ("network", "mask", *_FIRES),
        ("OUTPUT_FREQUENCY",),
        {"mean_burnt_share": "Mean burnt share", "max_burnt_share": "Largest burnt share"},
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
)

#: Options that the plugin sets itself or that mean nothing in a form.
HIDDEN = frozenset(
    {"output", "overwrite", "as_json", "progress_mode", "verbose", "quiet", "dry_run", "folder", "config"}
)

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
    "run.json": "OUTPUT_RUN",
}

#: The file behind -o, which names the output, of commands that write one file; the stem is that of the style.
FILES: Mapping[str, tuple[str, str]] = {
    "network": ("network.tif", "Spread network"),
    "rank": ("priority.tif", "Cutting priority"),
    "breaks": ("breaks.tif", "Fire breaks"),
    "burn": ("burn_frequency.tif", "Burn frequency"),
    "segments": ("segments.gpkg", "Segments to build, in order"),
}

#: Short labels; the help of each parameter is the command line's.
LABELS: Mapping[str, str] = {
    "dem": "Elevation",
    "vegetation": "Vegetation",
    "density": "Vegetation density",
    "legend": "Legend of the vegetation codes",
    "density_legend": "Legend of the density codes",
    "network": "Spread network",
    "priority": "Cutting priority",
    "mask": "Fire breaks",
    "budget": "Budget (by default a share of the fuel)",
    "budget_unit": "Unit of the budget",
    "refine": "Improve the breaks on simulated fires (takes longer)",
    "width": "Least width of the breaks [m]",
    "residual": "Share of the spread that a break lets through",
    "residuals": "Shares that breaks let through, separated by commas",
    "cost": "Cost of cutting per hectare",
    "cost_field": "Field with the cost",
    "protected": "Area where nothing may be cut",
    "allowed": "Area outside of which nothing may be cut",
    "barriers": "Existing barriers",
    "values": "Values at risk",
    "values_field": "Field with the value",
    "method": "Ranking",
    "method_list": "Rankings",
    "baseline": "Ranking to test against",
    "budgets": "Budgets, separated by commas",
    "model": "Spread model",
    "wind_speed": "Wind speed [m/s]",
    "wind_from": "Wind from [degrees clockwise from north]",
    "moisture": "Moisture of the fine dead fuel (8 % is 0.08)",
    "n_runs": "Number of fires",
    "ignitions": "Ignition points",
    "ignition_mode": "Use of the ignition points",
    "seed": "Seed",
    "crs": "CRS of the grid",
    "resolution": "Cell size [m]",
    "bounds": "Extent (needs the CRS of the grid)",
    "like": "Take the grid of this raster",
    "src_crs": "True CRS of the layers, such as dem=EPSG:32635",
    "src_nodata": "No-data values, such as dem=-9999; vegetation=255",
    "bidx": "Bands, such as dem=1; vegetation=2",
    "unknown": "Codes that the legend does not list",
    "strict": "Refuse what would only be warned of",
    "remote": "Allow network addresses and archives",
    "max_memory": "Most memory to use, such as 4GB",
    "creation_options": "Creation options, such as COMPRESS=ZSTD",
    "alpha": "Significance threshold",
    "test": "Test",
    "polygons": "Fire breaks as polygons",
    "sizes": "Fire sizes",
    "compartments": "Compartments between the breaks",
}

#: Help for what the command line takes as arguments, which have none there.
HELP: Mapping[str, str] = {
    "dem": "Elevation in metres, in any CRS and cell size; or a landscape file (.lcp), which holds all layers.",
    "vegetation": "Codes of the vegetation, explained by the legend.",
    "density": "Codes of the density of the vegetation; without it the densities come from the legend.",
    "network": "Eight bands with the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW.",
    "priority": "Score by which cells are cut, higher is earlier.",
    "mask": "Cells that are cut: 1, all others 0.",
}

#: Ranges of numbers, None where open; the engine checks them again.
RANGES: Mapping[str, tuple[float | None, float | None]] = {
    "budget": (0.0, None),
    "width": (0.0, None),
    "residual": (0.0, 1.0),
    "alpha": (0.0, 1.0),
    "n_runs": (1, None),
    "seed": (0, None),
    "resolution": (0.0, None),
    "wind_speed": (0.0, None),
    "wind_from": (0.0, 360.0),
    "moisture": (0.0, 1.0),
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
