"""How commands read what their requests name, and what they check of it before the work."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from firebreak_gis.cli.session import Session
from firebreak_gis.rasters import file_of

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import Survey
    from firebreak_gis.landscape.request import LandscapeRequest
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.request import FireRequest


def input_files(names: Iterable[str | None]) -> list[str]:
    """Files among the names that the options give."""
    named = [file_of(name) for name in names if name]
    return list(dict.fromkeys(name for name in named if Path(name).is_file()))


def read_layers(request: LandscapeRequest, found: Survey, session: Session, *, progress: Progress) -> xr.Dataset:
    """Read a landscape that was surveyed and say what was done."""
    from firebreak_gis.landscape import read_surveyed

    landscape = read_surveyed(request, found, progress=progress)
    for sentence in landscape.attrs["alignment"]:
        session.say(sentence)
    for sentence in landscape.attrs["warnings"]:
        session.warn(sentence)
    return landscape


def ridges(dem: str | None, grid: Grid) -> np.ndarray | None:
    """Lay the elevation that --dem names on a grid; NaN where there is none, None where none is named."""
    from firebreak_gis.landscape.planes import elevation_plane

    return elevation_plane(dem, grid) if dem else None


def checked_fires(request: FireRequest, network: SpreadNetwork) -> FireRequest:
    """Lay a raster of ignitions on the grid, and look at where fires start before hours of ranking.

    Raises
    ------
    InputError
        If no fire can start where it should.
    ParameterError
        If a number is impossible.
    """
    from firebreak_gis.landscape.planes import ignition_source
    from firebreak_gis.simulation.fires import resolved

    request = replace(request, ignitions=ignition_source(request.ignitions, network.grid))
    resolved(network, request)
    return request
