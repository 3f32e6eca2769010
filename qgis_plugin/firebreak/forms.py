"""The table of algorithms: which command stands behind each, and how its form is laid out.

Everything else of a form - parameters, kinds, choices, defaults, help, files written - is read from
`manifest.json`, which the command line writes (`firebreak describe`). An option that this table does not
name appears among the advanced ones. Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

#: Groups in the order of the work; the toolbox sorts them by their titles.
GROUPS: Mapping[str, str] = {
    "prepare": "1 Prepare",
    "cut": "2 Rank and cut",
    "burn": "3 Burn",
    "judge": "4 Judge",
}


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
        Outputs (by parameter name) that stand on the form and are made unless switched off.
    about
        What it does, in the words of somebody who has layers and no command line; paragraphs as in the help.
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
    about: str
    numbers: Mapping[str, str] = field(default_factory=dict)
    before: str | None = None
    tags: tuple[str, ...] = ()


_LAYERS = ("dem", "vegetation", "density", "legend")
_AT_STAKE = ("values", "protected", "barriers")
_FIRES = ("ignitions", "n_runs", "seed")
_WIND = ("wind_speed", "wind_from")
_CLOCK = ("duration", "hold", "embers")
_SHARES = {
    "burnt_share_without_breaks": "Mean burnt share without breaks",
    "burnt_share_with_breaks": "Mean burnt share with the breaks",
}
_CUT = {"cells_cut": "Cells cut", "ha_cut": "Area cut in hectares"}
_ANY_GRID = (
    "The layers may have any CRS, extent and cell size; they are laid on one square grid in metres. The density may be "
    "a raster, one word for all fuel (how closed it is), or left out if the legend gives it. A FlamMap landscape "
    "(.lcp) as elevation holds all layers."
)

#: All algorithms, in the order of the work; those whose command the manifest lacks are left out.
FORMS = (
    Form(
        "align",
        "Align landscape",
        "prepare",
        _LAYERS,
        ("OUTPUT_ELEVATION", "OUTPUT_VEGETATION", "OUTPUT_DENSITY"),
        "Lay elevation, vegetation and density on one square grid in metres, the codes turned into classes of fuel.\n\n"
        + _ANY_GRID,
        tags=("reproject", "legend", "corine"),
    ),
    Form(
        "network",
        "Spread network",
        "prepare",
        (*_LAYERS, "model", *_WIND, "clock"),
        ("OUTPUT_NETWORK",),
        "Find how likely fire spreads from each cell to its neighbours.\n\n"
        "Bands 1 to 8 hold the probability that fire spreads to the N, NE, E, SE, S, SW, W and NW. If times are told "
        "too, bands 9 to 16 hold the seconds that this takes, and band 17 the heat that the cell releases (kJ/m2). "
        "Wind and slope then act on the times; so make a network without times for fires without a duration.",
        {"burnable_cells": "Cells with fuel"},
        before="align",
        tags=("wind", "slope", "probability"),
    ),
    Form(
        "siting",
        "Where a line can be held",
        "prepare",
        (*_LAYERS, "roads", "rivers"),
        ("OUTPUT_SUITABILITY",),
        "Rate from 0 to 1 how well a line can be held in each cell: what the best line within reach is worth (ridges, "
        "valley bottoms, roads, rivers, edges of the fuel), with the slope for machines and the access. Plans go by "
        "it.\n\nThe weights have no source for your region: they are yours to set.",
        {"mean_suitability": "Mean suitability where there is fuel"},
        before="align",
        tags=("suitability", "ridge", "road", "access"),
    ),
    Form(
        "delineate",
        "Compartments bounded by control lines",
        "prepare",
        (*_LAYERS, "size_ha", "roads", "rivers", "values", *_WIND, "duration", "ignitions", "n_runs", "seed"),
        ("OUTPUT_PODS",),
        "Divide the landscape into compartments of about one size, bounded by the lines that are easiest to hold: "
        "potential operational delineations (PODs), on which crews agree before a fire.\n\n"
        "Each compartment has its fuel, ignitions, values, what burns in simulated fires, and how good its border is. "
        "The second layer of the file holds the borders.",
        {
            "compartments": "Compartments",
            "km": "Borders in kilometres",
            "border_suitability": "Mean suitability of the borders",
        },
        before="align",
        tags=("pod", "delineation", "control line"),
    ),
    Form(
        "plan",
        "Plan fire breaks",
        "cut",
        (*_LAYERS, *_AT_STAKE, *_WIND, "duration", "budget", "method", "ignitions", "n_runs"),
        (
            "OUTPUT_BREAKS",
            "OUTPUT_SEGMENTS",
            "OUTPUT_FREQUENCY",
            "OUTPUT_FREQUENCY_WITH_BREAKS",
            "OUTPUT_REPORT",
        ),
        "Plan fire breaks from layers: where to cut, what to build first, and how often each cell burns without and "
        "with the breaks.\n\n" + _ANY_GRID,
        {**_CUT, **_SHARES},
        tags=("fuel break", "wildfire", "centrality"),
    ),
    Form(
        "rank",
        "Rank cells",
        "cut",
        ("network", "method", "budget", *_AT_STAKE, "seed"),
        ("OUTPUT_PRIORITY",),
        "Rank the cells of a spread network by the order in which they should be cut: higher is earlier.\n\n"
        "Rankings that lay a pattern for the budget give another order for another budget.",
        tags=("centrality", "bonacich", "betweenness", "priority"),
    ),
    Form(
        "breaks",
        "Select fire breaks",
        "cut",
        ("priority", "budget"),
        ("OUTPUT_BREAKS", "OUTPUT_BREAK_POLYGONS"),
        "Cut the cells of highest priority, as many as the budget allows.\n\n"
        "Ties are cut by row, then column. A priority that was made for another budget is warned of.",
        {"cells_cut": "Cells cut"},
        tags=("fuel break", "mask"),
    ),
    Form(
        "segments",
        "Segments to build",
        "cut",
        ("network", "mask", "priority", "dem"),
        ("OUTPUT_SEGMENTS", "OUTPUT_COMPARTMENTS"),
        "Take fire breaks apart into segments to build, best first.\n\n"
        "Each segment separates two compartments of fuel, and has an order of construction, a length, width, area, "
        "mean slope and cost, and the share of all that the breaks save that it adds.",
        {
            "segments": "Segments",
            "stages": "Stages of construction",
            "km": "Length in kilometres",
            "compartments": "Compartments",
        },
        tags=("line", "stage", "compartment"),
    ),
    Form(
        "mapbook",
        "Map book for crews",
        "cut",
        ("run", "title", "date", "roads", "water", "pages", "paper"),
        ("OUTPUT_MAPBOOK",),
        "Print a plan as a PDF: an overview, a list of the segments, and a page for each with a map at a round scale, "
        "its ends, sizes, slope, cost and treatment, and what it is for.\n\n"
        "Choose the folder into which all files of the plan were written. Its segments alone do as well, without the "
        "vegetation; then the elevation is asked for.",
        {"segments": "Segments", "segments_with_page": "Segments with a page"},
        tags=("pdf", "print", "atlas", "crew"),
    ),
    Form(
        "export",
        "Files for crews",
        "cut",
        ("made", "what"),
        ("OUTPUT_CREWS",),
        "Write segments, breaks or compartments of a plan in the format of a crew.\n\n"
        "The ending of the file chooses it: .kml for Google Earth and phones, .gpx for GPS devices, .dxf for drawings, "
        ".zip for a Shapefile, .geojson for the web.",
        {"features": "Features"},
        tags=("kml", "gpx", "dxf", "shapefile", "gps", "crew"),
    ),
    Form(
        "burn",
        "Burn frequency",
        "burn",
        ("network", "mask", "barriers", *_CLOCK, *_FIRES),
        ("OUTPUT_FREQUENCY",),
        "Let many fires start and tell how often each cell burns.\n\n"
        "Fires with a duration need a network with times. With the same seed the fires are the same with and without "
        "breaks, so their difference is the breaks' work alone.",
        {
            "mean_burnt_share": "Mean burnt share",
            "max_burnt_share": "Largest burnt share",
            "mean_ha": "Mean fire in hectares",
            "max_ha": "Largest fire in hectares",
        },
        tags=("simulation", "cellular automaton", "ignition"),
    ),
    Form(
        "assess",
        "Judge existing breaks",
        "judge",
        ("network", "mask", "longest_gap", "residual", *_CLOCK, *_FIRES),
        ("OUTPUT_ASSESSMENT", "OUTPUT_SUMMARY"),
        "Tell what each existing fire break is worth, and which gap between breaks matters most.\n\n"
        "The same fires burn with all breaks, without each of them, and with each gap closed, so the differences are "
        "the work of that break alone. The same break at random places stands beside it. The network must hold the "
        "fuel that lies on the breaks.",
        tags=("gap", "existing", "maintenance"),
    ),
    Form(
        "evaluate",
        "Evaluate",
        "judge",
        ("network", "method_list", "baseline", *_FIRES),
        ("OUTPUT_EVALUATION", "OUTPUT_FIGURE", "OUTPUT_REPORT"),
        "Judge rankings: mean, 90 % percentile and maximum of the burnt share at every budget.\n\n"
        "All rankings meet the same fires, and each plan is made for its budget.",
        tags=("statistics", "wilcoxon", "curve"),
    ),
    Form(
        "compare",
        "Compare",
        "judge",
        ("network", "method_list", "budgets", "residuals", *_FIRES),
        ("OUTPUT_COMPARISON", "OUTPUT_FIGURE", "OUTPUT_REPORT"),
        "Compare plans: expected burnt area, value lost, worst fires and hectares saved per hectare cut, with "
        "intervals.\n\nThe fires are fresh: no plan was designed with them, and all burn in the same ones.",
        tags=("statistics", "leak", "budget"),
    ),
    Form(
        "validate",
        "Validate against a scar",
        "judge",
        (*_LAYERS, "scar", "start", "duration", "weather", "weather_step", *_WIND, "n_runs", "seed"),
        ("OUTPUT_SCORES", "OUTPUT_FREQUENCY", "OUTPUT_VALIDATION", "OUTPUT_REPORT"),
        "Hold a simulated fire against the area that burnt, beside fires that know nothing.\n\n"
        "Sorensen's index, IoU, the IoU of the growth alone, size, Brier score and reliability are told for the "
        "simulated fire and for the null models: no growth, equal distance in fuel, an ellipse in the wind.",
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
        "Fit the rate of spread, durations and spread probability to the fires of a region.\n\n"
        "The fires are polygons or a table with their sizes and perhaps their days; the weather tells the winds in "
        "which they burn. More numbers than the fires can tell are refused.",
        {"n_fires": "Fires", "n_parameters": "Numbers fitted"},
        before="align",
        tags=("duration", "fire size", "rate of spread"),
    ),
    Form(
        "report",
        "Report of a run",
        "judge",
        ("run",),
        ("OUTPUT_REPORT",),
        "Show a plan or a comparison on one page: map, segments, curve, assumptions, files.\n\n"
        "Choose the folder into which all files of the run were written. The page opens in any browser without a "
        "network. Its links lead to files beside the page, so write it into that folder.",
        tags=("html", "page", "map"),
    ),
)
