"""The grid as one frozen value: CRS, transform and shape.

Two objects lie on the same grid when their `Grid` values match; nothing else is compared.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from affine import Affine

from firebreak_gis.errors import CRSError, GridError

if TYPE_CHECKING:
    import xarray as xr
    from pyproj import CRS
    from shapely import Geometry, Polygon

#: Transforms that differ by less than this share of a cell are the same grid.
SAME_GRID_TOLERANCE = 1e-3

UNREFERENCED = Affine(1.0, 0.0, 0.0, 0.0, -1.0, 0.0)


@dataclass(frozen=True)
class Grid:
    """A north-up grid of square or rectangular cells.

    Parameters
    ----------
    shape
        (rows, cols).
    transform
        Affine transform from (col, row) of cell corners to map coordinates.
    crs
        Coordinate reference system, or None for a bare array (an artificial forest).
    """

    shape: tuple[int, int]
    transform: Affine = UNREFERENCED
    crs: CRS | None = None

    @property
    def cell_size(self) -> float:
        """Side of a cell in CRS units; raises `GridError` if cells are not square."""
        width, height = abs(self.transform.a), abs(self.transform.e)
        if abs(width - height) > SAME_GRID_TOLERANCE * width:
            raise GridError(
                f"cells are {width:g} x {height:g}, expected square cells; align the layers first "
                "(firebreak align, or read_landscape)"
            )
        return width

    @property
    def cell_area_ha(self) -> float:
        """Area of a cell in hectares; raises `CRSError` if the CRS is not in metres."""
        self.require_metres("areas in hectares")
        return abs(self.transform.a * self.transform.e) / 10_000.0

    @property
    def in_metres(self) -> bool:
        """Whether coordinates are metres: so it is told by the CRS, or taken where there is none."""
        if self.crs is None:
            return True
        return bool(self.crs.is_projected and all(a.unit_conversion_factor == 1.0 for a in self.crs.axis_info[:2]))

    def require_metres(self, purpose: str) -> None:
        """Raise `CRSError` if there is a CRS whose unit is not the metre; `purpose` says what needs it."""
        if self.in_metres or self.crs is None:
            return
        unit = self.crs.axis_info[0].unit_name if self.crs.axis_info else "unknown units"
        raise CRSError(
            f"{purpose} need a projected CRS in metres, got {crs_name(self.crs)} in {unit}; align the layers "
            "first (firebreak align, or read_landscape)"
        )

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """(left, bottom, right, top) in CRS units."""
        rows, cols = self.shape
        left, top = self.transform @ (0, 0)
        right, bottom = self.transform @ (cols, rows)
        return left, bottom, right, top

    @property
    def x(self) -> np.ndarray:
        """Cell-centre x coordinates, length cols."""
        return self.transform.c + self.transform.a * (np.arange(self.shape[1]) + 0.5)

    @property
    def y(self) -> np.ndarray:
        """Cell-centre y coordinates, length rows (falling)."""
        return self.transform.f + self.transform.e * (np.arange(self.shape[0]) + 0.5)

    def position(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(col, row) of points as fractions, counted from the corner of the grid."""
        t = ~self.transform
        return t.a * x + t.b * y + t.c, t.d * x + t.e * y + t.f

    def matches(self, other: Grid) -> bool:
        """Whether both describe the same cells (transforms within 1e-3 of a cell)."""
        if self.shape != other.shape or (self.crs is None) != (other.crs is None):
            return False
        if self.crs is not None and self.crs != other.crs:
            return False
        cell = min(abs(self.transform.a), abs(self.transform.e))
        corners = ((0, 0), (self.shape[1], self.shape[0]))
        return all(
            abs(mine - theirs) <= SAME_GRID_TOLERANCE * cell
            for corner in corners
            for mine, theirs in zip(self.transform @ corner, other.transform @ corner, strict=True)
        )

    def require(self, other: Grid, what: str) -> None:
        """Raise `GridError` unless `other` matches this grid; `what` names the other object."""
        if not self.matches(other):
            raise GridError(
                f"{what} lies on another grid: got {other.describe()}, expected {self.describe()}; "
                "align it first (firebreak align --like, or read_landscape(like=...))"
            )

    def describe(self) -> str:
        """One line for messages and reports."""
        rows, cols = self.shape
        left, _, _, top = self.bounds
        name = "no CRS" if self.crs is None else crs_name(self.crs)
        return (
            f"{rows} x {cols} cells of {abs(self.transform.a):.6g} x {abs(self.transform.e):.6g}, "
            f"upper left ({left:.6g}, {top:.6g}), {name}"
        )

    def cells_of(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Row-major cell index of each point; -1 outside the grid.

        Parameters
        ----------
        x, y
            Coordinates in the CRS of the grid, 1-D, equal length.
        """
        with np.errstate(invalid="ignore"):  # a coordinate may be infinite
            col_f, row_f = self.position(np.asarray(x, dtype=float), np.asarray(y, dtype=float))
        row, col = np.floor(row_f), np.floor(col_f)
        inside = (row >= 0) & (row < self.shape[0]) & (col >= 0) & (col < self.shape[1])
        index = np.full(inside.shape, -1, dtype=np.int64)
        index[inside] = (row * self.shape[1] + col)[inside].astype(np.int64)
        return index

    def dataarray(self, values: np.ndarray, name: str, **attrs: Any) -> xr.DataArray:
        """Wrap a (..., rows, cols) array as a DataArray on this grid, with CF coordinates.

        A leading axis of length 8 is named `direction`.

        Raises
        ------
        GridError
            If the last two axes are not the shape of the grid.
        """
        import xarray as xr

        from firebreak_gis.lattice import DIRECTIONS

        if values.shape[-2:] != self.shape:
            raise GridError(f"{name} has shape {values.shape}, expected (..., {self.shape[0]}, {self.shape[1]})")
        dims: tuple[str, ...] = ("y", "x")
        coords: dict[str, Any] = dict(self.coords())
        if values.ndim == 3:
            dims = ("direction", "y", "x")
            coords["direction"] = list(DIRECTIONS)
        return xr.DataArray(values, dims=dims, coords=coords, name=name, attrs=attrs)

    def coords(self) -> dict[str, Any]:
        """CF coordinates `y`, `x` and, with a CRS, `spatial_ref` (as rioxarray reads them)."""
        import xarray as xr

        geographic = self.crs is not None and self.crs.is_geographic
        units = "degrees" if geographic else "m"
        coords: dict[str, Any] = {
            "y": (
                "y",
                self.y,
                {
                    "standard_name": "latitude" if geographic else "projection_y_coordinate",
                    "units": f"{units}_north" if geographic else units,
                    "axis": "Y",
                },
            ),
            "x": (
                "x",
                self.x,
                {
                    "standard_name": "longitude" if geographic else "projection_x_coordinate",
                    "units": f"{units}_east" if geographic else units,
                    "axis": "X",
                },
            ),
        }
        if self.crs is not None:
            attrs = _cf_attributes(self.crs)
            attrs["spatial_ref"] = attrs["crs_wkt"]
            attrs["GeoTransform"] = " ".join(repr(float(v)) for v in self.transform.to_gdal())
            coords["spatial_ref"] = xr.Variable((), 0, attrs)
        return coords

    @staticmethod
    def crs_told(data: Any) -> CRS | None:
        """Return the CRS that a DataArray or Dataset tells in a grid mapping."""
        return _mapped_crs(_grid_mapping(data))

    @classmethod
    def of_directions(cls, data: Any) -> Grid:
        """Read the grid of a (direction, y, x) array whose directions, if named, stand in the order of the lattice."""
        from firebreak_gis.lattice import DIRECTIONS

        if data.ndim == 3 and data.dims[0] in data.coords:
            order = tuple(str(name) for name in data[data.dims[0]].to_numpy())
            if set(order) == set(DIRECTIONS) and order != DIRECTIONS:
                raise GridError(
                    f"{data.name or 'the array'} has its directions in the order {' '.join(order)}, expected "
                    f"{' '.join(DIRECTIONS)}; reorder them with .sel(direction=[...])"
                )
        return cls.of(data)

    @classmethod
    def of(cls, data: Any) -> Grid:
        """Read the grid of a DataArray or Dataset with `y`, `x` and a CF grid mapping (rioxarray's is `spatial_ref`).

        Raises
        ------
        GridError
            If the last dimensions of an array are not (y, x), or the coordinates are not evenly spaced and
            north-up.
        """
        dims = tuple(data.dims)
        is_array = hasattr(data, "ndim")
        if not {"y", "x"} <= set(dims) or (is_array and dims[-2:] != ("y", "x")):
            raise GridError(f"expected dimensions (..., y, x), got {dims}; rename or transpose")
        shape = (int(data.sizes["y"]), int(data.sizes["x"]))
        told = _grid_mapping(data)
        transform = None
        if "x" in data.coords and "y" in data.coords:
            transform = _transform_from_centres(data["x"].to_numpy(), data["y"].to_numpy(), told)
        return cls(shape, transform or UNREFERENCED, _mapped_crs(told))


def _cf_attributes(crs: CRS) -> dict[str, Any]:
    try:
        return crs.to_cf()
    except KeyError as error:
        raise CRSError(
            f"the coordinate reference system {crs_name(crs)} lacks the parameter {error}; its description (.prj?) is "
            "broken, assign the true one, e.g. EPSG:32635"
        ) from error


def with_y_and_x(data: xr.DataArray) -> xr.DataArray:
    """Return an array with dimensions (..., y, x), north-up, whatever the file that it comes from calls them.

    Parameters
    ----------
    data
        Dimensions such as (lat, lon), (northing, easting), or any whose coordinates say which they are (CF `axis`,
        `standard_name`, degrees north and east). Latitudes and longitudes without a CRS are taken as of WGS 84.

    Returns
    -------
    xarray.DataArray
        As it was if its dimensions are not known.
    """
    found = {_axis_of(data, dim): dim for dim in data.dims}
    if not {"y", "x"} <= set(found):
        return data
    names = {found[axis]: axis for axis in ("y", "x")}
    degrees = all(_is_degrees(data, dim) for dim in names)
    result = data.rename({dim: axis for dim, axis in names.items() if dim != axis}).transpose(..., "y", "x")
    for axis, sign in (("y", -1), ("x", 1)):
        if axis in result.coords and result.sizes[axis] > 1 and sign * float(result[axis][-1] - result[axis][0]) < 0:
            result = result.isel({axis: slice(None, None, -1)})
    if degrees and _mapped_crs(_grid_mapping(result)) is None:
        import xarray as xr

        result = result.assign_coords(spatial_ref=xr.Variable((), 0, {"crs_wkt": parse_crs("EPSG:4326").to_wkt()}))
    return result


#: What files call the axes, in lower case.
_AXES = {
    "y": {"y", "lat", "latitude", "northing", "northings"},
    "x": {"x", "lon", "long", "longitude", "easting", "eastings"},
}
_STANDARD = {
    "y": {"latitude", "projection_y_coordinate", "grid_latitude"},
    "x": {"longitude", "projection_x_coordinate", "grid_longitude"},
}
_DEGREES = {"latitude", "longitude", "lat", "lon", "long"}


def _axis_of(data: xr.DataArray, dim: Any) -> str:
    """Whether a dimension is "y" or "x"; else its own name."""
    told = data.coords[dim].attrs if dim in data.coords else {}
    for axis in ("y", "x"):
        if str(told.get("axis", "")).lower() == axis or str(told.get("standard_name", "")).lower() in _STANDARD[axis]:
            return axis
        if str(dim).lower() in _AXES[axis]:
            return axis
    return str(dim)


def _is_degrees(data: xr.DataArray, dim: Any) -> bool:
    told = data.coords[dim].attrs if dim in data.coords else {}
    words = {str(dim).lower(), str(told.get("standard_name", "")).lower()}
    return bool(words & _DEGREES) or str(told.get("units", "")).lower() in ("degrees_north", "degrees_east")


def _grid_mapping(data: Any) -> dict[str, Any]:
    """Attributes of the variable that holds the CRS, by the name that the data give or by what it holds."""
    variables = {**(data.variables if hasattr(data, "data_vars") else {}), **data.coords}
    named = [data.attrs.get("grid_mapping"), getattr(data, "encoding", {}).get("grid_mapping"), "spatial_ref"]
    names = [str(name).partition(":")[0].strip() for name in named if name]
    names += [name for name, variable in variables.items() if not variable.dims]
    for name in names:
        attrs = dict(variables[name].attrs) if name in variables else {}
        if any(attrs.get(key) for key in ("crs_wkt", "spatial_ref", "grid_mapping_name")):
            return attrs
    return {}


def _mapped_crs(told: dict[str, Any]) -> CRS | None:
    """CRS of a grid mapping: its text, else the CF attributes."""
    if text := told.get("crs_wkt") or told.get("spatial_ref"):
        return parse_crs(text)
    if not told.get("grid_mapping_name"):
        return None
    from pyproj import CRS
    from pyproj.exceptions import CRSError as ProjError

    try:
        return CRS.from_cf(told)
    except (ProjError, KeyError, ValueError) as error:
        raise CRSError(
            f"cannot read the grid mapping {told['grid_mapping_name']!r} ({error}); set the CRS, e.g. "
            'data.rio.write_crs("EPSG:32635")'
        ) from error


def _transform_from_centres(x: np.ndarray, y: np.ndarray, told: dict[str, Any]) -> Affine:
    if "GeoTransform" in told:
        stored = Affine.from_gdal(*(float(v) for v in str(told["GeoTransform"]).split()))
        # A selection or a coarsening leaves the stored transform behind; then the coordinates count.
        same = Grid((y.size, x.size), stored)
        off_x, off_y = np.abs(x - same.x).max(), np.abs(y - same.y).max()
        if off_x < 1e-6 * abs(stored.a) and off_y < 1e-6 * abs(stored.e):
            return stored
    step_x = (x[-1] - x[0]) / (x.size - 1) if x.size > 1 else None
    step_y = (y[-1] - y[0]) / (y.size - 1) if y.size > 1 else None
    step_x = step_x or (abs(step_y) if step_y else 1.0)
    step_y = step_y or -abs(step_x)
    for name, values, step in (("x", x, step_x), ("y", y, step_y)):
        if values.size > 1 and not np.allclose(np.diff(values), step, rtol=1e-3):
            raise GridError(f"the {name} coordinates are not evenly spaced; resample to a regular grid first")
    if step_x < 0 or step_y > 0:
        raise GridError(
            "expected a north-up grid (x rising, y falling); sort the coordinates, e.g. "
            "data.sortby('y', ascending=False).sortby('x')"
        )
    return Affine(step_x, 0.0, x[0] - step_x / 2, 0.0, step_y, y[0] - step_y / 2)


def parse_crs(value: Any) -> CRS:
    """Return a `pyproj.CRS` from anything that pyproj reads.

    Raises
    ------
    CRSError
        If it cannot be read.
    """
    from pyproj import CRS
    from pyproj.exceptions import CRSError as ProjError

    try:
        return CRS.from_user_input(value)
    except ProjError as error:
        raise CRSError(
            f"cannot read the coordinate reference system {str(value)[:80]!r}; give for example EPSG:32635"
        ) from error


def crs_name(crs: CRS) -> str:
    """Short name for people: the EPSG code if there is one, else the name; and whether it carries a datum shift."""
    if crs.is_bound and crs.source_crs is not None:
        return f"{crs_name(crs.source_crs)} with its own datum shift"
    epsg = crs.to_epsg()
    return f"EPSG:{epsg}" if epsg else str(crs.name)


def _traced(ids: np.ndarray, n: int, grid: Grid) -> list[list[Polygon]]:
    """Trace the cells of each number from 1 to n over their sides, so that what touches at corners is valid.

    Parameters
    ----------
    ids
        (rows, cols) int, 0 for cells that are in none.
    n
        Number of lists.
    grid
        Where the cells lie.
    """
    import shapely
    from rasterio.features import shapes

    parts: list[list[Polygon]] = [[] for _ in range(n)]
    numbers, sizes, rings, points = [], [], [], []
    for geometry, number in shapes(ids.astype("int32"), mask=ids > 0, connectivity=4, transform=grid.transform):
        numbers.append(int(number) - 1)
        rings.append(len(geometry["coordinates"]))
        for ring in geometry["coordinates"]:
            sizes.append(len(ring))
            points += ring
    if not numbers:
        return parts
    # At once: a polygon by itself takes longer than to trace it.
    drawn = shapely.linearrings(np.array(points), indices=np.repeat(np.arange(len(sizes)), sizes))
    for number, polygon in zip(
        numbers, shapely.polygons(drawn, indices=np.repeat(np.arange(len(numbers)), rings)), strict=True
    ):
        parts[number].append(polygon)
    return parts


def outlines(ids: np.ndarray, n: int, grid: Grid) -> list[Geometry]:
    """Outline the cells of each number, over their sides: a valid polygon or multipolygon each, empty without cells."""
    import shapely

    groups = _traced(ids, n, grid)
    found = np.empty(n, object)
    found[:] = [
        each[0] if len(each) == 1 else shapely.MultiPolygon(each) if each else shapely.Polygon() for each in groups
    ]
    wrong = ~shapely.is_valid(found)
    found[wrong] = shapely.make_valid(found[wrong])
    return list(found)
