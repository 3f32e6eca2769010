"""A first look at what the functions return, for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.report.comparison import comparison_figure
from firebreak_gis.report.curve import curve_figure
from firebreak_gis.report.figures import draw_breaks, map_axes, new_figure, own_looks, show
from firebreak_gis.schema import MapLayer, Shown

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


@own_looks
def plot(thing: Any, *, breaks: xr.DataArray | None = None) -> Figure:
    """Draw a plan, segments, an assessment, a network, a raster, burns, curves or a comparison.

    Parameters
    ----------
    thing
        A plan (its overview); segments (by stage); existing breaks; what `assess` (by worth) and `delineate` return;
        any GeoDataFrame, such as compartments; a `SpreadNetwork` (mean probability over the eight directions); a
        raster (y, x) such as a priority or breaks; burns as `simulate`
        returns them (how often each cell burns); curves as `evaluate` returns them; the table of `compare`.
    breaks
        (y, x), above 0 where cut: drawn on the map.

    Returns
    -------
    matplotlib.figure.Figure
        Shown by a notebook, or written with its `savefig`.

    Raises
    ------
    ParameterError
        If it is none of these.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    >>> fb.plot(network).axes[0].get_title(loc="left")
    'Mean probability of spread'
    """
    if isinstance(thing, Shown) and hasattr(thing, "plot"):
        found: Figure = thing.plot()
        return found
    if "ranking" in getattr(thing, "dims", ()):
        return curve_figure(thing)
    if layers := map_layers(thing):
        return _outlines(layers)
    if "n_burnable" in getattr(thing, "attrs", {}) and "method" in getattr(thing, "columns", ()):
        told = thing.attrs
        return comparison_figure(thing, n_burnable=told["n_burnable"], cell_area_ha=told["cell_area_ha"])
    title, values, grid = plane_of(thing)
    rows, cols = grid.shape
    figure = new_figure(7.0, 1.0 + 6.0 * min(max(rows / cols, 0.3), 2.0))
    axes = figure.subplots()
    map_axes(axes, grid, title)
    image = show(axes, np.where(np.isfinite(values), values, np.nan), grid, cmap="viridis")
    figure.colorbar(image, ax=axes, shrink=0.8)
    if breaks is not None:
        draw_breaks(axes, breaks.to_numpy() > 0, grid)
    return figure


#: Of the layers from the lowest on.
_MAPS = ("viridis", "plasma")


def map_layers(thing: Any) -> tuple[MapLayer, ...]:
    """Lines and outlines of a result or a table, the lowest first; none if it is neither."""
    if hasattr(thing, "geometry"):
        return (MapLayer(f"{len(thing)} outlines", thing),)
    return tuple(thing.layers()) if hasattr(thing, "layers") else ()


def _outlines(layers: tuple[MapLayer, ...]) -> Figure:
    """Layers in kilometres from the lower left corner of the lowest."""
    areas = layers[0].frame
    figure = new_figure(7.0, 6.0)
    axes = figure.subplots()
    left, bottom = areas.total_bounds[:2] if len(areas) else (0.0, 0.0)
    scale = 1.0 if areas.crs is None else 1e-3
    for k, layer in enumerate(layers):
        frame = layer.frame
        if not len(frame):
            continue
        moved = frame.geometry.translate(-left, -bottom).scale(scale, scale, origin=(0, 0))
        frame.set_geometry(moved.set_crs(None, allow_override=True)).plot(ax=axes, **_looks(layer, k))
    axes.set_aspect("equal")
    axes.set(xlabel="", ylabel="")
    axes.tick_params(labelsize=7, length=2)
    kilometres = " (axes in km)" if areas.crs is not None else ""
    axes.set_title(layers[0].title + kilometres, fontsize=10, loc="left", fontweight="bold")
    return figure


def _looks(layer: MapLayer, place: int) -> dict[str, Any]:
    """How a layer is drawn; a column of which nothing is known tells nothing."""
    lines = layer.frame.geometry.geom_type.str.contains("Line").any()
    if layer.column is None or layer.frame[layer.column].isna().all():
        if lines:
            return {"color": "black", "linewidth": 0.5 if place else 1.5}
        return {"edgecolor": "#222222", "linewidth": 0.6, "alpha": 0.7}
    bar = {"label": layer.legend, "shrink": 0.8}
    looks = {"column": layer.column, "cmap": _MAPS[place % len(_MAPS)], "legend": True, "legend_kwds": bar}
    return looks | ({"linewidth": 2.5} if lines else {})


def plane_of(thing: Any) -> tuple[str, np.ndarray, Grid]:
    """Title, (rows, cols) values and grid of what is a map."""
    if isinstance(thing, SpreadNetwork):
        mean = np.where(thing.burnable, thing.probability.mean(axis=0), np.nan)
        return "Mean probability of spread", mean, thing.grid
    burns = "burn_frequency" in getattr(thing, "data_vars", ())
    raster = thing["burn_frequency"] if burns else thing
    if getattr(raster, "dims", ()) != ("y", "x"):
        raise ParameterError(
            f"got {type(thing).__name__}, expected a plan, segments, an assessment, a GeoDataFrame, a SpreadNetwork, "
            "a raster (y, x), burns of simulate, curves of evaluate or the table of compare"
        )
    title = (
        "Share of the fires that burn the cell"
        if burns
        else str(raster.attrs.get("long_name", raster.name or "raster"))
    )
    return title, raster.to_numpy().astype(float), Grid.of(raster)
