"""Spread models: one file a model, each turning a landscape into spread probabilities.

A model file holds a frozen dataclass `Params` and

    probability(landscape, params) -> (8, rows, cols) float32, from the cell to its neighbour

and needs no registration: its file name is its name. `spread_network` below is the only way in.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.plugins import build_params, load

if TYPE_CHECKING:
    import xarray as xr


def spread_network(landscape: xr.Dataset, *, model: str = "alexandridis", **params: Any) -> SpreadNetwork:
    """Build the spread network of a landscape.

    Parameters
    ----------
    landscape
        Variables on one square grid in metres, as `read_landscape` returns them. The attribute `boundary`
        ("open" if absent) is taken over.
    model
        Name of a spread model (`firebreak methods` lists them).
    **params
        Parameters of the model, for example ``wind_speed=8, wind_from_direction=315``.

    Returns
    -------
    SpreadNetwork
        On the grid of the landscape.

    Raises
    ------
    ParameterError
        If the model or a parameter is unknown or out of range.
    InputError
        If a variable that the model needs is missing or out of range.

    Notes
    -----
    Memory at the peak: at most 110 B a cell, the landscape included; the network keeps 33 B a cell.
    """
    module = load("spread", model)
    values = build_params(module, params)
    if "burnable" not in landscape:
        raise InputError("the landscape has no variable 'burnable'; make it with read_landscape")
    grid = Grid.of(landscape["burnable"])
    return SpreadNetwork(
        module.probability(landscape, values),
        burnable=landscape["burnable"].to_numpy(),
        boundary=landscape.attrs.get("boundary", "open"),
        crs=grid.crs,
        transform=grid.transform,
    )
