"""How commands read what their requests name, and what they check of it before the work."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.files.gate import is_file
from firebreak_gis.rasters import file_of

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.landscape import Survey
    from firebreak_gis.landscape.lines import LineBreaks
    from firebreak_gis.landscape.request import LandscapeRequest
    from firebreak_gis.landscape.stake_layers import StakesRequest
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.simulation.request import FireRequest
    from firebreak_gis.stakes import StakePlanes


def input_files(names: Iterable[str | None]) -> list[str]:
    """Files among the names that the options give."""
    named = [file_of(name) for name in names if name]
    return list(dict.fromkeys(name for name in named if is_file(name)))


def read_layers(
    request: LandscapeRequest, found: Survey, session: Session, *, folder: str | None = None, progress: Progress
) -> xr.Dataset:
    """Read a landscape that was surveyed and say what was done; by parts, on the disk of a folder, if one is given."""
    from firebreak_gis.landscape import read_surveyed
    from firebreak_gis.landscape.strips import read_by_parts
    from firebreak_gis.simulation.engine import spread

    if folder is not None and found.by_parts:
        landscape = read_by_parts(request, found, folder, spread=spread, progress=progress)
    else:
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


def read_stakes(
    request: StakesRequest,
    session: Session,
    *,
    grid: Grid,
    fuel: np.ndarray,
    ignitions: Any = None,
    landscape: xr.Dataset | None = None,
    strict: bool = False,
) -> tuple[StakePlanes, Account]:
    """Lay what a planner adds on a grid, see `StakesRequest.read`, and say what was done.

    Raises
    ------
    ParameterError, InputError
        Naming everything that cannot be read.
    """
    from firebreak_gis.landscape.target_grid import Account

    account = Account(strict=strict)
    planes = request.read(grid, fuel=fuel, ignitions=ignitions, landscape=landscape, account=account)
    tell(account, session)
    return planes, account


def read_line_breaks(source: str, grid: Grid, width: float | str, session: Session) -> LineBreaks:
    """Lay own or planned lines with a width [m, or a column] on a grid, see `landscape.lines`."""
    from firebreak_gis.landscape.lines import line_breaks
    from firebreak_gis.vectors import is_vector

    if not is_vector(source):
        raise ParameterError(f"--line-width asks for lines, but {source} is a raster; leave the width out")
    breaks = line_breaks(source, grid, width=width)
    session.say(
        f"breaks: {len(breaks.lines)} lines of {breaks.lines.length.sum() / 1000:,.6g} km, {breaks.area_ha:,.6g} ha; "
        "they stop fire between the cells that they part, and where they hold, the ground that they take does not burn"
    )
    return breaks


def read_breaks(source: str, grid: Grid, session: Session) -> np.ndarray:
    """Lay own or planned breaks, drawn or as a raster on any grid, on a grid; (rows, cols) bool.

    Raises
    ------
    InputError
        If they cannot be read, lie elsewhere, or are another of the product's own files.
    """
    from firebreak_gis.landscape.masks import mask_plane
    from firebreak_gis.landscape.target_grid import Account
    from firebreak_gis.rasters import require_role
    from firebreak_gis.vectors import is_vector

    if not is_vector(source):
        require_role(source, "breaks")
    account = Account()
    mask = mask_plane(source, grid, what="breaks", rule="touched", solid=is_vector(source), account=account)
    tell(account, session)
    return mask


def read_kept(source: str, residual: Any, network: SpreadNetwork) -> np.ndarray:
    """Read what treated cells keep, (rows, cols), which must lie on the grid of the network.

    Raises
    ------
    ParameterError
        If one share for all cells is given as well.
    InputError, GridError
        If the raster is something else, or lies on another grid.
    """
    from firebreak_gis.rasters import read_variable, require_role

    if residual:
        raise ParameterError("--kept tells what each cell keeps, --residual what all do; give one of them")
    require_role(source, "kept_share")
    return network.plane(read_variable(source, "kept_share"), f"--kept {source}")


def read_priority(source: str, session: Session, *, foreign: bool) -> xr.DataArray:
    """Read a ranking; one that `firebreak rank` did not write must be confirmed, and be plausible.

    Raises
    ------
    InputError
        If it is no ranking, or is not confirmed.
    """
    from firebreak_gis.rasters import read_variable, require_role

    if not require_role(source, "priority", known=not foreign):
        session.warn(f"{source} was not written as a ranking; its greatest numbers are cut first, as asked")
    ranking = read_variable(source, "priority")
    if float(ranking.where(ranking > float("-inf")).std()) == 0.0:
        session.warn(f"{source} ranks all cells alike, so that they are cut row by row")
    return ranking


def tell(account: Account, session: Session) -> None:
    """Say what was done, and what should be looked at."""
    for sentence in account.alignment:
        session.say(sentence)
    for sentence in account.warnings:
        session.warn(sentence)


def checked_fires(request: FireRequest, network: SpreadNetwork, session: Session) -> FireRequest:
    """Find where fires may start, before hours of ranking, and say what was left out.

    Raises
    ------
    InputError
        If no fire can start where it should.
    ParameterError
        If a number is impossible.
    """
    from firebreak_gis.simulation.ignitions import ignition_places, require_runs

    left_out = network.provenance.get("left_out")
    ends = [request.duration, *([] if request.crews is None or request.crews.attack else [request.crews])]
    if left_out and all(each is None or each.endless for each in ends):
        session.warn(
            f"the network was made for fires with a clock: {left_out} act on its travel times alone, so fires "
            "that burn until they end by themselves do not feel them; give a duration, or a network without --clock"
        )
    places = ignition_places(
        network, request.ignitions, outside=request.ignitions_outside, times=request.ignition_times
    )
    for sentence in places.notes:
        session.say(sentence)
    require_runs(places, mode=request.ignition_mode, n_runs=request.n_runs, seed=request.seed)
    return replace(request, ignitions=places)
