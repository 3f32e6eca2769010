"""A first look at what the functions return, for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.segments import Segments
from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.report.comparison import comparison_figure
from firebreak_gis.report.curve import curve_figure
from firebreak_gis.report.figures import draw_breaks, map_axes, new_figure, own_looks, show
from firebreak_gis.schema import Shown

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


@own_looks
def plot(thing: Any, *, breaks: xr.DataArray | None = None) -> Figure:
    """Draw a plan, segments, a network, a raster, burns, curves or a comparison.

    Parameters
    ----------
    thing
        A plan (its overview); segments (by stage); any GeoDataFrame, such as compartments; a `SpreadNetwork` (mean
        probability over the eight directions); a raster (y, x) such as a priority or breaks; burns as `simulate`
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
    if isinstance(thing, Segments) or hasattr(thing, "geometry"):
        return _outlines(thing)
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


def _outlines(thing: Any) -> Figure:
    """Outlines in kilometres from their lower left corner; segments by stage, their middle lines over them."""
    areas = thing.polygons if isinstance(thing, Segments) else thing
    figure = new_figure(7.0, 6.0)
    axes = figure.subplots()
    left, bottom = areas.total_bounds[:2] if len(areas) else (0.0, 0.0)
    scale = 1.0 if areas.crs is None else 1e-3
    for frame, looks in _layers(thing):
        moved = frame.geometry.translate(-left, -bottom).scale(scale, scale, origin=(0, 0))
        frame.set_geometry(moved.set_crs(None, allow_override=True)).plot(ax=axes, **looks)
    axes.set_aspect("equal")
    axes.set(xlabel="", ylabel="")
    axes.tick_params(labelsize=7, length=2)
    name = (
        f"Segments, {len(areas)} in {areas['stage'].nunique()} stages" if "stage" in areas else f"{len(areas)} outlines"
    )
    axes.set_title(
        name + (" (axes in km)" if areas.crs is not None else ""), fontsize=10, loc="left", fontweight="bold"
    )
    return figure


def _layers(thing: Any) -> list[tuple[Any, dict[str, Any]]]:
    """Tables to draw, and how."""
    if not isinstance(thing, Segments):
        return [(thing, {"edgecolor": "#222222", "linewidth": 0.6, "cmap": "viridis", "column": None, "alpha": 0.7})]
    if not len(thing.polygons):
        return []
    bar = {"label": "stage of construction", "shrink": 0.8}
    looks = {"column": "stage", "cmap": "viridis", "legend": True, "legend_kwds": bar}
    return [(thing.polygons, looks), (thing.lines, {"color": "black", "linewidth": 0.5})]


def plane_of(thing: Any) -> tuple[str, np.ndarray, Grid]:
    """Title, (rows, cols) values and grid of what is a map."""
    if isinstance(thing, SpreadNetwork):
        mean = np.where(thing.burnable, thing.probability.mean(axis=0), np.nan)
        return "Mean probability of spread", mean, thing.grid
    burns = "burn_frequency" in getattr(thing, "data_vars", ())
    raster = thing["burn_frequency"] if burns else thing
    if getattr(raster, "dims", ()) != ("y", "x"):
        raise ParameterError(
            f"got {type(thing).__name__}, expected a plan, segments, a GeoDataFrame, a SpreadNetwork, a raster (y, x), "
            "burns of simulate, curves of evaluate or the table of compare"
        )
    title = (
        "Share of the fires that burn the cell"
        if burns
        else str(raster.attrs.get("long_name", raster.name or "raster"))
    )
    return title, raster.to_numpy().astype(float), Grid.of(raster)
