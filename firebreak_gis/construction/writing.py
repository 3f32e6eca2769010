"""What goes to the field: segments to build and the compartments between them, as GeoPackages in colour."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from firebreak_gis.styles.vectors import Symbol, graduated
from firebreak_gis.vectors import write_layers

if TYPE_CHECKING:
    import os
    from pathlib import Path

    import geopandas as gpd

#: From the first stage of construction to the last, and from the least expected loss to the largest.
STAGE_COLOURS = ("#67001f", "#d6604d", "#f4a582", "#4393c3", "#2166ac")
LOSS_COLOURS = ("#ffffcc99", "#fecc5c99", "#e31a1c99")


def write_segments(
    path: str | os.PathLike[str], lines: gpd.GeoDataFrame, polygons: gpd.GeoDataFrame, **options: Any
) -> Path:
    """Write segments as a GeoPackage with the layers `lines` and `polygons`, coloured by stage, with their order.

    Parameters
    ----------
    path
        Target, .gpkg.
    lines, polygons
        As `segments.segments` returns them.
    **options
        `overwrite` and `forbid` of `vectors.write_layers`.
    """

    def style(frame: gpd.GeoDataFrame, symbol: Symbol, label: str | None) -> str:
        return graduated(frame["stage"].to_numpy(), column="stage", symbol=symbol, colours=STAGE_COLOURS, label=label)

    styles = {"lines": style(lines, "line", "order"), "polygons": style(polygons, "fill", None)}
    kinds = {"lines": "LineString", "polygons": "MultiPolygon"}
    return write_layers(path, {"lines": lines, "polygons": polygons}, styles=styles, kinds=kinds, **options)


def write_compartments(path: str | os.PathLike[str], table: gpd.GeoDataFrame, **options: Any) -> Path:
    """Write compartments as a GeoPackage with the layer `compartments`, coloured by expected loss.

    Parameters
    ----------
    path
        Target, .gpkg.
    table
        As `compartments.compartments` returns it.
    **options
        `overwrite` and `forbid` of `vectors.write_layers`.
    """
    style = graduated(
        table["expected_loss"].to_numpy(),
        column="expected_loss",
        symbol="fill",
        colours=LOSS_COLOURS,
        label="compartment",
    )
    styles, kinds = {"compartments": style}, {"compartments": "MultiPolygon"}
    return write_layers(path, {"compartments": table}, styles=styles, kinds=kinds, **options)
