"""What options are called in the forms, help where the command line has none, and ranges of numbers.

Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Mapping

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
    "scar": "Area that burnt",
    "start": "Where the fire was first seen",
    "duration": "How long the fire spread, such as 3h",
    "weather": "Table of weather",
    "weather_step": "Time of each line of the table of weather, such as 1h",
    "fires": "Observed fires with sizes and days",
    "fit": "What to fit: rate, duration, p0",
    "size_column": "Column with the size in hectares",
    "first_day_column": "Column with the first day",
    "last_day_column": "Column with the last day",
    "least": "Smallest fire that counts [hectares]",
    "hours_a_day": "Time of spread on each day of a fire [hours]",
    "longest": "Longest simulated fire, such as 200h",
    "table": "What is told of each fire",
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
    "scar": "Perimeter of the fire as polygons, or a raster above 0 where it burnt.",
    "fires": "Polygons or a table (CSV) of the fires of a region, with their sizes in hectares and perhaps their days.",
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
