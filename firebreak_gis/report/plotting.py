"""A first look at what the functions return, for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.report.curve import curve_figure
from firebreak_gis.report.figures import draw_breaks, map_axes, new_figure, own_looks, show

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


@own_looks
def plot(thing: Any, *, breaks: xr.DataArray | None = None) -> Figure:
    """Draw a network, a raster, burns or curves.

    Parameters
    ----------
    thing
        A `SpreadNetwork` (mean probability over the eight directions), a raster (y, x) such as a
        priority or breaks, burns as `simulate` returns them (how often each cell burns), or curves as `evaluate`
        returns them.
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
    if "ranking" in getattr(thing, "dims", ()):
        return curve_figure(thing)
    title, values, grid = _plane(thing)
    rows, cols = grid.shape
    figure = new_figure(7.0, 1.0 + 6.0 * min(max(rows / cols, 0.3), 2.0))
    axes = figure.subplots()
    map_axes(axes, grid, title)
    image = show(axes, np.where(np.isfinite(values), values, np.nan), grid, cmap="viridis")
    figure.colorbar(image, ax=axes, shrink=0.8)
    if breaks is not None:
        draw_breaks(axes, breaks.to_numpy() > 0, grid)
    return figure


def _plane(thing: Any) -> tuple[str, np.ndarray, Grid]:
    """Title, (rows, cols) values and grid of what is a map."""
    if isinstance(thing, SpreadNetwork):
        mean = np.where(thing.burnable, thing.probability.mean(axis=0), np.nan)
        return "Mean probability of spread", mean, thing.grid
    burns = "burn_frequency" in getattr(thing, "data_vars", ())
    raster = thing["burn_frequency"] if burns else thing
    if getattr(raster, "dims", ()) != ("y", "x"):
        raise ParameterError(
            f"got {type(thing).__name__}, expected a SpreadNetwork, a raster (y, x), burns of simulate, or curves of "
            "evaluate"
        )
    title = (
        "Share of the fires that burn the cell"
        if burns
        else str(raster.attrs.get("long_name", raster.name or "raster"))
    )
    return title, raster.to_numpy().astype(float), Grid.of(raster)
