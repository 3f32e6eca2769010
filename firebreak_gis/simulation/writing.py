"""What is kept of fires with a clock, as files: rasters with styles, isochrones, and a table of the fires."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.files import together, write_text
from firebreak_gis.rasters import write_raster
from firebreak_gis.simulation.durations import clock
from firebreak_gis.styles.vectors import graduated
from firebreak_gis.vectors import write_layers

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.simulation.products import Products

#: From the first fire front to the last.
_FRONT_COLOURS = ("#800026", "#fd8d3c", "#c7e9b4", "#225ea8")
#: Fronts are drawn of the time before which fire came to a cell in half of the runs that burn it.
_MEDIAN = 0.5


def write_products(
    folder: str | Path, burns: xr.Dataset, grid: Grid, *, provenance: Mapping[str, Any], **options: Any
) -> list[str]:
    """Write what `products` asked for into a folder.

    Parameters
    ----------
    folder
        It exists.
    burns
        Of `fires.simulate`.
    grid
        Of the network.
    provenance
        Tags of the rasters.
    **options
        `overwrite`, `forbid` and `creation_options` of `write_raster`.

    Returns
    -------
    list of str
        Files written.
    """
    place = Path(folder)
    vector_options = {key: options[key] for key in ("overwrite", "forbid") if key in options}
    files = []
    with together(place):
        for name, data in _rasters(burns):
            files.append(place / name)
            write_raster(files[-1], data, provenance=provenance, **options)
        if "arrival_time" in burns and "burnt_by" in burns and grid.crs is not None:
            fronts = isochrones(burns, grid)
            files.append(place / "isochrones.gpkg")
            style = graduated(
                fronts["hours"].to_numpy(), column="hours", symbol="line", colours=_FRONT_COLOURS, label="hours"
            )
            write_layers(
                files[-1],
                {"isochrones": fronts},
                styles={"isochrones": style},
                kinds={"isochrones": "MultiLineString"},
                **vector_options,
            )
        files.append(place / "fire_sizes.csv")
        text = size_table(burns, grid).to_csv(index=False, lineterminator="\n")
        write_text(files[-1], text, overwrite=bool(options.get("overwrite")))
    return [str(file) for file in files]


def product_files(products: Products, *, referenced: bool) -> list[str]:
    """Names of the files that `write_products` writes for what is asked; `referenced`: on a grid with a CRS."""
    classes = (0.0, *products.size_classes) if products.size_classes else ()
    asked = {
        "burnt_by": products.by,
        "arrival_time": products.quantiles,
        "burnt_in_class": classes,
        "flame_exceedance": products.flame_lengths,
    }
    names = [file(value) for name, (_, file) in _SLICED.items() for value in asked[name]]
    names += ["fire_paths.tif"] if products.paths else []
    names += ["isochrones.gpkg"] if products.by and products.quantiles and referenced else []
    return [*names, "fire_sizes.csv"]


def _word(seconds: float) -> str:
    return clock(seconds).replace(" ", "")


#: Variables of which every slice is a file: the dimension, and the name of the file.
_SLICED: Mapping[str, tuple[str, Callable[[float], str]]] = MappingProxyType(
    {
        "burnt_by": ("time", lambda seconds: f"burnt_by_{_word(seconds)}.tif"),
        "arrival_time": ("quantile", lambda share: f"arrival_time_{100 * share:g}.tif"),
        "burnt_in_class": ("size_from", lambda size: f"burnt_from_{size:g}_ha.tif"),
        "flame_exceedance": ("flame_length", lambda length: f"flames_above_{length:g}_m.tif"),
    }
)


def _rasters(burns: xr.Dataset) -> Iterator[tuple[str, xr.DataArray]]:
    """File name and slice of every raster."""
    for name, (dim, file) in _SLICED.items():
        if name in burns:
            for k, value in enumerate(burns[name][dim].to_numpy()):
                yield file(float(value)), burns[name].isel({dim: k})
    if "fire_paths" in burns:
        yield "fire_paths.tif", burns["fire_paths"]


def isochrones(burns: xr.Dataset, grid: Grid) -> gpd.GeoDataFrame:
    """Fronts of the fire at the times of `burnt_by`: borders of what it has reached by then in half of the runs.

    Parameters
    ----------
    burns
        Of `fires.simulate`, with `burnt_by` and the median of the arrival times.
    grid
        Of the network, with a CRS.

    Returns
    -------
    geopandas.GeoDataFrame
        A row a time with a front: `hours`, `area_ha` inside, and lines.
    """
    import geopandas as gpd
    from rasterio.features import shapes
    from shapely import line_merge, union_all
    from shapely.geometry import MultiLineString, shape

    quantiles = burns["arrival_time"]["quantile"].to_numpy()
    median = burns["arrival_time"].isel(quantile=int(np.argmin(np.abs(quantiles - _MEDIAN)))).to_numpy()
    rows = []
    for seconds in burns["burnt_by"]["time"].to_numpy():
        reached = np.nan_to_num(median, nan=np.inf) <= seconds
        if not reached.any():
            continue
        areas = [shape(area) for area, _ in shapes(reached.astype(np.uint8), reached, transform=grid.transform)]
        border = union_all(areas).boundary
        merged = line_merge(border)
        lines = MultiLineString([merged]) if merged.geom_type == "LineString" else merged
        rows.append((seconds / 3600.0, int(reached.sum()) * grid.cell_area_ha, lines))
    hours, area, lines = zip(*rows, strict=True) if rows else ((), (), ())
    return gpd.GeoDataFrame(
        {"hours": np.array(hours, np.float64), "area_ha": np.array(area, np.float64)},
        geometry=list(lines),
        crs=grid.crs,
    )


def size_table(burns: xr.Dataset, grid: Grid) -> pd.DataFrame:
    """Table of the fires: run, cells, ha, and where known value lost, weather, duration and size by each time."""
    import pandas as pd

    table = pd.DataFrame({"cells": burns["fire_size"].to_numpy()}).rename_axis("run").reset_index()
    table["ha"] = (table["cells"] * grid.cell_area_ha).round(6)
    if "value_lost" in burns:
        table["value_lost"] = burns["value_lost"].to_numpy()
    if "weather" in burns:
        table["weather"] = burns["weather"].to_numpy() + 1
    if "duration" in burns:
        table["duration_h"] = (burns["duration"].to_numpy() / 3600.0).round(6)
    if "containment" in burns:
        table["contained_h"] = (burns["containment"].to_numpy() / 3600.0).round(6)
    if "fire_size_by" in burns:
        for k, seconds in enumerate(burns["burnt_by"]["time"].to_numpy()):
            table[f"ha_by_{_word(float(seconds))}"] = (
                burns["fire_size_by"][:, k].to_numpy() * grid.cell_area_ha
            ).round(6)
    return table
