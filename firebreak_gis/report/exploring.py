"""Maps to pan and zoom in notebooks, on a street map of the web; made by folium, which is installed apart."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import InputError, MissingComponentError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.report.plotting import map_layers, plane_of
from firebreak_gis.schema import Shown

if TYPE_CHECKING:
    import folium

    from firebreak_gis.grid import Grid
    from firebreak_gis.schema import MapLayer

#: Web maps are drawn in this projection, so a raster laid between two corners fits only if it is in it.
_WEB = "EPSG:3857"
_RASTER_OPACITY = 0.7


def explore(thing: Any, **options: Any) -> folium.Map:
    """Show a plan, segments, compartments, a network or a raster on a map to pan and zoom.

    Parameters
    ----------
    thing
        A plan; segments (polygons and lines, by stage); existing breaks, and what `assess` and `delineate` return; any
        GeoDataFrame, such as compartments; a `SpreadNetwork` (mean probability of spread), a raster (y, x), or burns as
        `simulate` returns them.
    **options
        Handed to `geopandas.GeoDataFrame.explore` for vectors, such as `column`, `cmap`, `tiles`, `m`. For rasters `m`,
        a map to draw on, and `name`, that of the layer, count.

    Returns
    -------
    folium.Map
        Shown by a notebook, or written with its `save`. The street map behind it is fetched by the browser.

    Raises
    ------
    MissingComponentError
        If folium is not installed.
    InputError
        If there is no coordinate system.
    ParameterError
        If it is none of these.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> layers = fb.sample_layers()
    >>> network = fb.spread_network(fb.read_landscape(**layers, resolution=200.0))
    >>> breaks = fb.select_breaks(fb.rank(network), budget="10%")
    >>> page = fb.explore(fb.segments_of(network, breaks), m=fb.explore(network))
    >>> "stage" in page.get_root().render()
    True
    """
    _require_folium()
    if isinstance(thing, Shown) and hasattr(thing, "explore"):
        found: folium.Map = thing.explore(**options)
        return found
    if layers := map_layers(thing):
        return _vectors(layers, options)
    return _raster(thing, **options)


def explore_plan(plan: Any, **options: Any) -> folium.Map:
    """Show burn frequency without and with the breaks, compartments, breaks and segments of a plan, as layers."""
    folium = _require_folium()
    found = _raster(plan.before, name="Burn frequency without breaks", **options)
    _raster(plan.after, name="Burn frequency with the breaks", m=found)
    compartments = map_layers(plan.compartments)
    _vectors(compartments, {"m": found, "name": "Compartments", "show": False, "style_kwds": {"fill": False}})
    _vectors(plan.segments.layers(), {"m": found})
    folium.LayerControl(collapsed=False).add_to(found)
    return found


def _vectors(layers: tuple[MapLayer, ...], options: dict[str, Any]) -> folium.Map:
    """Layers over each other; the options are those of the lowest."""
    found = _vector(layers[0], options)
    for layer in layers[1:]:
        if len(layer.frame):
            _vector(layer, {"m": found})
    return found


def _vector(layer: MapLayer, options: dict[str, Any]) -> folium.Map:
    frame = layer.frame
    if frame.crs is None:
        raise InputError("the table has no coordinate system, so it lies nowhere on a map; set it: table.set_crs(...)")
    known = layer.column is not None and frame[layer.column].notna().any()
    coloured = {"column": layer.column, "cmap": "viridis", "legend_kwds": {"caption": layer.legend}} if known else {}
    shown: folium.Map = frame.explore(**{"name": layer.title, **coloured, **options})
    return shown


def _raster(thing: Any, *, m: folium.Map | None = None, name: str | None = None) -> folium.Map:
    """Lay a raster over the map, brought into its projection; what is not known, and 0 of burns, is transparent."""
    folium = _require_folium()
    title, values, grid = plane_of(thing)
    if grid.crs is None:
        raise InputError(f"{title!r} has no coordinate system, so it lies nowhere on a map")
    burns = not isinstance(thing, SpreadNetwork) and "burn_frequency" in (
        getattr(thing, "name", None),
        *getattr(thing, "data_vars", ()),
    )
    values = np.where(np.isfinite(values) & ~(burns & (values == 0.0)), values, np.nan)
    warped, corners = _on_the_web(values, grid)
    known = warped[np.isfinite(warped)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
    found = m or folium.Map()
    folium.raster_layers.ImageOverlay(
        _coloured(warped, low, high),
        bounds=corners,
        opacity=_RASTER_OPACITY,
        name=f"{name or title} ({low:.3g} to {high:.3g})",
    ).add_to(found)
    if m is None:
        found.fit_bounds(corners)
    return found


def _on_the_web(values: np.ndarray, grid: Grid) -> tuple[np.ndarray, list[list[float]]]:
    """The raster in the projection of web maps, and its lower left and upper right corners as latitude, longitude."""
    from rasterio.warp import Resampling, calculate_default_transform, reproject, transform_bounds

    rows, cols = grid.shape
    source = grid.crs.to_wkt()  # type: ignore[union-attr]
    transform, width, height = calculate_default_transform(source, _WEB, cols, rows, *grid.bounds)
    target = np.full((height, width), np.nan)
    reproject(
        values,
        target,
        src_transform=grid.transform,
        src_crs=source,
        dst_transform=transform,
        dst_crs=_WEB,
        src_nodata=np.nan,
        dst_nodata=np.nan,
        resampling=Resampling.nearest,
    )
    left, top = transform.c, transform.f
    edges = (left, top + height * transform.e, left + width * transform.a, top)
    west, south, east, north = transform_bounds(_WEB, "EPSG:4326", *edges)
    return target, [[south, west], [north, east]]


def _coloured(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """(rows, cols, 4) uint8 in viridis; NaN is transparent."""
    from matplotlib import colormaps

    scaled = (values - low) / (high - low) if high > low else np.zeros_like(values)
    image = colormaps["viridis"](np.nan_to_num(scaled), bytes=True)
    image[~np.isfinite(values), 3] = 0
    return np.asarray(image)


def _require_folium() -> Any:
    try:
        import folium
    except ImportError as error:
        raise MissingComponentError(
            'maps to pan and zoom are made by folium, which is not installed: pip install "firebreak_gis[maps]"'
        ) from error
    return folium
