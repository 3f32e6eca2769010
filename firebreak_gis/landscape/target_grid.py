"""Choosing the one square grid, in true metres, on which all layers are laid."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from affine import Affine

from firebreak_gis.errors import CRSError, GridError, InputError, ParameterError
from firebreak_gis.grid import SAME_GRID_TOLERANCE, Grid, crs_name, parse_crs
from firebreak_gis.projections import (
    convergence,
    horizontal,
    outline,
    shift_unknown,
    suggest_utm,
    to_lonlat,
    transform,
    unsuitable,
)
from firebreak_gis.rasters import Header, read_header, require_georeferenced

if TYPE_CHECKING:
    import xarray as xr
    from pyproj import CRS

#: Layers that share less than this part of the smallest one do not belong together.
LEAST_OVERLAP = 0.05
#: Smallest grid with a cell that has all its neighbours.
LEAST_CELLS = 3
#: Grid north further than this from true north is warned of (wind directions are taken from grid north).
CONVERGENCE_LIMIT = 5.0

Box = tuple[float, float, float, float]


@dataclass
class Account:
    """What was done to the data, in words.

    Parameters
    ----------
    alignment
        One sentence for each step.
    warnings
        What the user should look at.
    strict
        Whether to refuse what would be warned of.
    """

    alignment: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    strict: bool = False

    def warn(self, text: str) -> None:
        """Keep a warning.

        Raises
        ------
        InputError
            In place of it, if strict.
        """
        if self.strict:
            raise InputError(f"{text}; refused by --strict")
        self.warnings.append(text)

    def added_to(self, landscape: xr.Dataset) -> xr.Dataset:
        """Return a landscape whose own account, in its attributes, goes on with this one."""
        more = {"alignment": self.alignment, "warnings": self.warnings}
        return landscape.assign_attrs({key: [*landscape.attrs.get(key, []), *lines] for key, lines in more.items()})


def choose_grid(
    layers: Mapping[str, Header],
    account: Account,
    *,
    crs: Any = None,
    resolution: float | None = None,
    bounds: Box | None = None,
    like: Any = None,
) -> Grid:
    """Return the grid for the layers; "elevation" is the one that leads.

    Parameters
    ----------
    layers
        Header by layer name; must hold "elevation".
    account
        Sentences are added to it.
    crs, resolution, bounds, like
        As in `landscape.read_landscape`.

    Raises
    ------
    InputError
        If layers do not say where they lie, do not overlap, or no suitable grid exists.
    ParameterError
        If the wishes contradict each other or are impossible.
    """
    for header in layers.values():
        require_georeferenced(header)
    if like is not None:
        if any(wish is not None for wish in (crs, resolution, bounds)):
            raise ParameterError("like gives the whole grid; leave out crs, resolution and bounds")
        grid = grid_like(like)
        _common_box(layers, grid.crs, account)
        _warn_of_shifts(layers, grid.crs, account)
        account.alignment.append(f"grid: taken as given, {grid.describe()}")
        return grid
    _check_wishes(resolution, bounds)
    centre = _common_centre(layers)
    target = _target_crs(layers["elevation"], crs, centre, account)
    box = _common_box(layers, target, account)
    _warn_of_shifts(layers, target, account)
    cell = float(resolution) if resolution is not None else _default_cell(layers["elevation"], target, box, account)
    grid = _snap(layers, target, cell, box, bounds)
    account.alignment.append(
        f"grid: {grid.describe()}, the extent that all layers cover"
        + (" within the bounds given" if bounds is not None else "")
    )
    _warn_of_north(grid, account)
    return grid


def cell_in(header: Header, target: CRS, x: float, y: float) -> tuple[float, float]:
    """Return the sides of a cell of `header`, measured in `target`, at the point (x, y) of `target`."""
    source, t = header.crs, header.transform
    assert source is not None
    if source == target:
        return math.hypot(t.a, t.d), math.hypot(t.b, t.e)
    x0, y0 = (float(v) for v in transform(target, source, x, y))
    xs = np.array([x0 - t.a / 2, x0 + t.a / 2, x0 - t.b / 2, x0 + t.b / 2])
    ys = np.array([y0 - t.d / 2, y0 + t.d / 2, y0 - t.e / 2, y0 + t.e / 2])
    tx, ty = transform(source, target, xs, ys)
    return float(np.hypot(tx[1] - tx[0], ty[1] - ty[0])), float(np.hypot(tx[3] - tx[2], ty[3] - ty[2]))


def box_in(header: Header, target: CRS) -> Box:
    """Return (left, bottom, right, top) of the footprint of a layer in `target`."""
    assert header.crs is not None
    x, y = outline(header.transform, header.shape)
    x, y = transform(header.crs, target, x, y)
    inside = np.isfinite(x) & np.isfinite(y)
    if not inside.all():
        raise CRSError(
            f"{header.path} reaches beyond what {crs_name(target)} can describe; crop it, or choose "
            f"another CRS (--dst-crs)"
        )
    return float(x.min()), float(y.min()), float(x.max()), float(y.max())


def _check_wishes(resolution: float | None, bounds: Box | None) -> None:
    if resolution is not None and not (math.isfinite(resolution) and resolution > 0):
        raise ParameterError(f"the resolution is {resolution}, expected a positive number of metres")
    if bounds is not None:
        if len(bounds) != 4 or not all(math.isfinite(v) for v in bounds):
            raise ParameterError(f"the bounds are {bounds}, expected four numbers: left, bottom, right, top")
        if bounds[0] >= bounds[2] or bounds[1] >= bounds[3]:
            raise ParameterError(f"the bounds {bounds} are empty, expected left < right and bottom < top")


def grid_like(like: Any) -> Grid:
    """Return the grid of a `Grid`, an array or a raster file, if work can be done on it."""
    if isinstance(like, Grid):
        grid = like
    elif isinstance(like, str | os.PathLike):
        header = read_header(like, band=1)
        require_georeferenced(header)
        if not header.north_up:
            raise GridError(
                f"{header.path} is rotated or south-up and cannot give the grid; turn it first with gdalwarp"
            )
        grid = header.grid
    else:
        grid = Grid.of(like)
    if grid.crs is None:
        raise CRSError("the grid to follow has no coordinate reference system")
    grid.cell_size  # noqa: B018 - refuses cells that are not square
    left, bottom, right, top = grid.bounds
    why = unsuitable(grid.crs, (left + right) / 2, (bottom + top) / 2)
    if why:
        raise CRSError(f"the grid to follow is in {crs_name(grid.crs)}, which {why}; choose one in metres, e.g. UTM")
    if min(grid.shape) < LEAST_CELLS:
        raise GridError(f"the grid to follow has {grid.shape[0]} x {grid.shape[1]} cells, expected at least 3 x 3")
    return grid


def _common_centre(layers: Mapping[str, Header]) -> tuple[np.ndarray, np.ndarray]:
    """Return longitudes and latitudes (west, east) and (south, north) of what all layers share."""
    boxes: dict[str, Box] = {}
    for name, header in layers.items():
        assert header.crs is not None
        lon, lat = to_lonlat(header.crs, *outline(header.transform, header.shape))
        if not (np.isfinite(lon).all() and np.isfinite(lat).all()):
            raise CRSError(
                f"{header.path} has coordinates that {crs_name(header.crs)} cannot describe; is its CRS the true one?"
            )
        lon = np.unwrap(lon, period=360.0)
        if boxes:  # the same turn of the globe as the first layer
            first = next(iter(boxes.values()))
            lon = lon - 360.0 * round((float(lon.mean()) - (first[0] + first[2]) / 2) / 360.0)
        boxes[name] = (float(lon.min()), float(lat.min()), float(lon.max()), float(lat.max()))
    shared = _intersection(list(boxes.values()))
    if shared is None:
        told = "; ".join(
            f"{name}: longitude {b[0]:.4f} to {b[2]:.4f}, latitude {b[1]:.4f} to {b[3]:.4f}"
            for name, b in boxes.items()
        )
        raise GridError(
            f"the layers do not overlap ({told}); are they of the same place, and are their CRS the true ones?"
        )
    return np.array([shared[0], shared[2]]), np.array([shared[1], shared[3]])


def _target_crs(dem: Header, wish: Any, centre: tuple[np.ndarray, np.ndarray], account: Account) -> CRS:
    assert dem.crs is not None
    target = dem.crs if wish is None else horizontal(parse_crs(wish))
    x, y = (float(v) for v in transform(parse_crs("EPSG:4326"), target, centre[0].mean(), centre[1].mean()))
    why = unsuitable(target, x, y) if math.isfinite(x) and math.isfinite(y) else "does not cover this place"
    if why is None:
        return target
    if wish is not None:
        # At the middle alone: an extent too wide for a zone must not hide what is wrong with the wish.
        utm = suggest_utm(centre[0].mean(), centre[1].mean())
        raise CRSError(f"the CRS {crs_name(target)} {why}; choose one in metres, e.g. {crs_name(utm)}")
    utm = suggest_utm(*centre)
    account.alignment.append(
        f"CRS: {crs_name(utm)} ({utm.name}), since that of the elevation, {crs_name(target)}, {why}"
    )
    return utm


def _common_box(layers: Mapping[str, Header], target: CRS | None, account: Account) -> Box:
    assert target is not None
    boxes = {name: box_in(header, target) for name, header in layers.items()}
    shared = _intersection(list(boxes.values()))
    areas = {name: (b[2] - b[0]) * (b[3] - b[1]) for name, b in boxes.items()}
    smallest = min(areas, key=lambda name: areas[name])
    share = 0.0 if shared is None else (shared[2] - shared[0]) * (shared[3] - shared[1]) / areas[smallest]
    if shared is None or share < LEAST_OVERLAP:
        told = "; ".join(f"{name}: x {b[0]:.6g} to {b[2]:.6g}, y {b[1]:.6g} to {b[3]:.6g}" for name, b in boxes.items())
        raise GridError(
            f"the layers overlap on {share:.1%} of the smallest of them, expected at least "
            f"{LEAST_OVERLAP:.0%} "
            f"(in {crs_name(target)}: {told}); are they of the same place, and are their CRS the true ones?"
        )
    if share < 0.99:
        account.warn(f"the layers overlap only in part: {share:.0%} of the {smallest} layer is covered by all")
    return shared


def _warn_of_shifts(layers: Mapping[str, Header], target: CRS | None, account: Account) -> None:
    for name, header in layers.items():
        assert header.crs is not None
        assert target is not None
        if shift_unknown(header.crs, target):
            word = "dem" if name == "elevation" else name
            account.warn(
                f"{name}: no datum shift is known from its CRS {crs_name(header.crs)} to {crs_name(target)}, so it may "
                f"lie up to some hundred metres off; give its true CRS (--src-crs {word}=EPSG:...)"
            )


def _intersection(boxes: list[Box]) -> Box | None:
    left, bottom = max(b[0] for b in boxes), max(b[1] for b in boxes)
    right, top = min(b[2] for b in boxes), min(b[3] for b in boxes)
    return (left, bottom, right, top) if left < right and bottom < top else None


def _default_cell(dem: Header, target: CRS, box: Box, account: Account) -> float:
    width, height = cell_in(dem, target, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    square = abs(width - height) <= SAME_GRID_TOLERANCE * min(width, height)
    if dem.crs == target and square:
        return width
    mean = math.sqrt(width * height)
    digits = 1 - math.floor(math.log10(mean))
    cell = round(mean, digits)
    account.alignment.append(
        f"cell: {cell:g} m, rounded from {width:.4g} x {height:.4g} m, what a cell of the elevation measures there"
    )
    return cell


def _snap(layers: Mapping[str, Header], target: CRS, cell: float, box: Box, bounds: Box | None) -> Grid:
    """Lay cells over `box`: whole cells inside it; user bounds are rounded outwards within it."""
    x0, y0 = _anchor(layers, target, cell)
    slack = SAME_GRID_TOLERANCE
    first_col, last_col = math.ceil((box[0] - x0) / cell - slack), math.floor((box[2] - x0) / cell + slack)
    first_row, last_row = math.ceil((y0 - box[3]) / cell - slack), math.floor((y0 - box[1]) / cell + slack)
    if bounds is not None:
        first_col = max(first_col, math.floor((bounds[0] - x0) / cell + slack))
        last_col = min(last_col, math.ceil((bounds[2] - x0) / cell - slack))
        first_row = max(first_row, math.floor((y0 - bounds[3]) / cell + slack))
        last_row = min(last_row, math.ceil((y0 - bounds[1]) / cell - slack))
    rows, cols = last_row - first_row, last_col - first_col
    if bounds is not None and (rows <= 0 or cols <= 0):
        _refuse_bounds(bounds, box, target)
    if rows < LEAST_CELLS or cols < LEAST_CELLS:
        told = f"x {box[0]:.6g} to {box[2]:.6g}, y {box[1]:.6g} to {box[3]:.6g}"
        raise GridError(
            f"only {max(rows, 0)} x {max(cols, 0)} cells of {cell:g} m lie in the extent that all layers "
            f"cover ({told} in "
            f"{crs_name(target)}){'' if bounds is None else ' and the bounds'}, expected at least 3 x 3; "
            f"take finer cells or a larger extent"
        )
    return Grid((rows, cols), Affine(cell, 0.0, x0 + first_col * cell, 0.0, -cell, y0 - first_row * cell), target)


def _refuse_bounds(bounds: Box, box: Box, target: CRS) -> None:
    """Say that bounds lie beside the layers, and whether they look like degrees."""
    told = f"x {box[0]:.6g} to {box[2]:.6g}, y {box[1]:.6g} to {box[3]:.6g} in {crs_name(target)}"
    left, bottom, right, top = bounds
    if max(abs(left), abs(right)) <= 360 and max(abs(bottom), abs(top)) <= 90:
        x, y = transform(
            parse_crs("EPSG:4326"), target, *outline(Affine(right - left, 0, left, 0, bottom - top, top), (1, 1))
        )
        if np.isfinite(x).all() and np.isfinite(y).all():
            inside = f"{x.min():.0f} {y.min():.0f} {x.max():.0f} {y.max():.0f}"
            raise ParameterError(
                f"the bounds {left:g} {bottom:g} {right:g} {top:g} look like degrees, expected coordinates in "
                f"{crs_name(target)}: there they are {inside} (the layers cover {told})"
            )
    raise GridError(
        f"the bounds {left:.6g} {bottom:.6g} {right:.6g} {top:.6g} lie beside the extent that all layers cover ({told})"
    )


def _anchor(layers: Mapping[str, Header], target: CRS, cell: float) -> tuple[float, float]:
    """Corner for the cells to meet: of a layer with such cells, else of the elevation, else the origin."""
    straight = [h for h in layers.values() if h.crs == target and h.transform.b == 0 and h.transform.d == 0]
    for header in straight:
        sides = abs(header.transform.a), abs(header.transform.e)
        if all(abs(side - cell) * max(header.shape) <= SAME_GRID_TOLERANCE * cell for side in sides):
            left, _, _, top = header.bounds
            return left, top
    if layers["elevation"] in straight:
        left, _, _, top = layers["elevation"].bounds
        return left, top
    return 0.0, 0.0


def _warn_of_north(grid: Grid, account: Account) -> None:
    assert grid.crs is not None
    left, bottom, right, top = grid.bounds
    angle = convergence(grid.crs, (left + right) / 2, (bottom + top) / 2)
    if abs(angle) > CONVERGENCE_LIMIT:
        account.warn(
            f"north of the grid lies {angle:.1f} degrees clockwise from true north in "
            f"{crs_name(grid.crs)}; wind directions are "
            "taken from the north of the grid"
        )
