"""Which coordinate reference systems the work can be done in, and which one to suggest."""

from __future__ import annotations

import functools
import math
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import CRSError
from firebreak_gis.grid import crs_name

if TYPE_CHECKING:
    from affine import Affine
    from pyproj import CRS, Transformer

#: A unit that differs from a true metre on the ground by more than this share is not used for slopes.
METRE_TOLERANCE = 0.05
#: Extents wider than this many degrees do not fit one UTM zone.
WIDEST_UTM = 30.0

#: How to give a raster its CRS, for messages.
ASSIGNING = ", e.g. gdal_translate -a_srs EPSG:32635 in.tif out.tif (DEM, VEGETATION and DENSITY: --src-crs EPSG:32635)"

_EARTH_RADIUS = (6.3e6, 6.45e6)


def horizontal(crs: CRS) -> CRS:
    """Return the two-dimensional horizontal part of a compound, 3-D or bound CRS.

    A datum shift that the CRS carries itself (TOWGS84, grid files) stays with it: without it places would lie up to
    some hundreds of metres off.
    """
    if crs.is_compound:
        return horizontal(crs.sub_crs_list[0])
    if crs.is_bound and crs.source_crs is not None and crs.source_crs.is_compound:
        from pyproj.crs import BoundCRS

        inner = horizontal(crs.source_crs)
        return inner if inner.is_bound else BoundCRS(inner, crs.target_crs, crs.coordinate_operation)
    return crs.to_2d()


def without_shift(crs: CRS) -> CRS:
    """Return the CRS itself of one that carries a datum shift: for what it is called and how it is projected."""
    return crs.source_crs if crs.is_bound and crs.source_crs is not None else crs


def vertical_factor(crs: CRS) -> float | None:
    """Return metres per unit of the vertical axis, None if the CRS has none."""
    for part in crs.sub_crs_list if crs.is_compound else [crs]:
        for axis in part.axis_info:
            if axis.direction in ("up", "down"):
                return float(axis.unit_conversion_factor)
    return None


def require_plausible(crs: CRS, bounds: tuple[float, float, float, float], where: str) -> None:
    """Refuse a CRS that cannot be true for coordinates in `bounds` (left, bottom, right, top).

    Raises
    ------
    CRSError
        If the CRS is not of the Earth, is local, or does not fit the coordinates.
    """
    fix = f"assign the true one{ASSIGNING}"
    if crs.ellipsoid is None or not (crs.is_projected or crs.is_geographic):
        raise CRSError(f"{where} has the CRS {crs_name(crs)}, which is not tied to the Earth; {fix}")
    if not _EARTH_RADIUS[0] < crs.ellipsoid.semi_major_metre < _EARTH_RADIUS[1]:
        raise CRSError(f"{where} has the CRS {crs_name(crs)}, which is not of the Earth; {fix}")
    left, bottom, right, top = bounds
    box = f"x {left:.6g} to {right:.6g}, y {bottom:.6g} to {top:.6g}"
    if not all(math.isfinite(v) for v in bounds):
        raise CRSError(f"{where} has no finite extent ({box}); its georeference is broken, {fix}")
    if crs.is_geographic:
        degrees = math.degrees(crs.axis_info[0].unit_conversion_factor)
        if (
            min(left, right) * degrees < -360.5
            or max(left, right) * degrees > 540.5
            or max(abs(bottom), abs(top)) * degrees > 90.5
        ):
            raise CRSError(f"{where} claims degrees ({crs_name(crs)}) but its coordinates are {box}; {fix}")
    elif max(abs(left), abs(right)) <= 360 and max(abs(bottom), abs(top)) <= 90 and right - left < 90:
        lon, lat = to_lonlat(crs, np.array([(left + right) / 2]), np.array([(bottom + top) / 2]))
        area = without_shift(crs).area_of_use
        # Degrees read as metres lie beside the false origin, which is outside the area of most systems.
        outside = area is None or not (
            area.south - 1 <= lat[0] <= area.north + 1
            and (area.west > area.east or area.west - 1 <= lon[0] <= area.east + 1)
        )
        if outside or not math.isfinite(lon[0]):
            raise CRSError(
                f"{where} claims projected units ({crs_name(crs)}) but its coordinates look like degrees: {box}; {fix}"
            )


def to_lonlat(crs: CRS, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return longitude and latitude in degrees (WGS 84); inf where a point has none."""
    return transform(crs, None, x, y)


def transform(source: CRS, target: CRS | None, x: Any, y: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return coordinates of `source` in `target` (None: degrees in WGS 84), inf where impossible.

    Always x (east, longitude) first, whatever order the CRS has.
    """
    if source == target:
        return np.asarray(x, dtype=float), np.asarray(y, dtype=float)
    tx, ty = _transformer(source, target).transform(x, y)
    return np.asarray(tx, dtype=float), np.asarray(ty, dtype=float)


@functools.lru_cache(maxsize=64)  # finding the best of several ways between two systems takes 0.1 s
def _transformer(source: CRS, target: CRS | None) -> Transformer:
    from pyproj import Transformer
    from pyproj.exceptions import ProjError

    try:
        return Transformer.from_crs(source, "EPSG:4326" if target is None else target, always_xy=True)
    except ProjError as error:  # a .prj may be readable and yet make no sense
        other = "longitude and latitude" if target is None else crs_name(target)
        raise CRSError(
            f"there is no way from {crs_name(source)} to {other}; one of them is broken, assign the true one{ASSIGNING}"
        ) from error


@functools.lru_cache(maxsize=64)
def shift_unknown(source: CRS, target: CRS) -> bool:
    """Whether no datum shift between two systems is known, so that places may lie up to some hundred metres off.

    Systems on the ellipsoid of WGS 84 without a name for their datum are taken for WGS 84.
    """
    from pyproj.exceptions import ProjError
    from pyproj.transformer import TransformerGroup

    if source == target or all(
        crs.ellipsoid is not None and crs.ellipsoid.name == "WGS 84" for crs in (source, target)
    ):
        return False
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # that better grids could be downloaded
            ways = TransformerGroup(source, target, always_xy=True).transformers
    except ProjError:
        return False  # there is no way at all, which `transform` says
    return bool(ways) and all("Ballpark" in way.description for way in ways)


def suggest_utm(lon: np.ndarray, lat: np.ndarray) -> CRS:
    """Return the UTM (near the poles: UPS) CRS for a range of longitudes and latitudes in degrees.

    Longitudes must be continuous: 179 to 181 (or -181 to -179) is two degrees wide, 179 to -179 is 358.

    Raises
    ------
    CRSError
        If the range is not finite or too wide for one zone.
    """
    from pyproj import CRS

    if not (np.isfinite(lon).all() and np.isfinite(lat).all()):
        raise CRSError(
            "the extent reaches beyond what its CRS can describe; crop the raster, or give --bounds and --dst-crs"
        )
    width = float(lon.max() - lon.min())
    middle_lat = float(lat.min() + lat.max()) / 2
    if abs(middle_lat) > 84 or (middle_lat < -80):
        return CRS.from_epsg(32661 if middle_lat > 0 else 32761)
    if width > WIDEST_UTM:
        raise CRSError(
            f"the extent spans {width:.0f} degrees of longitude, too wide for one UTM zone; crop it, "
            "or choose a projected CRS in metres (--dst-crs)"
        )
    middle = (float(lon.min() + lon.max()) / 2 + 180.0) % 360.0
    zone = min(int(middle // 6) + 1, 60)
    if 56 <= middle_lat < 64 and 183 <= middle < 192:  # the widened zone 32 of south-west Norway
        zone = 32
    return CRS.from_epsg((32600 if middle_lat >= 0 else 32700) + zone)


def unsuitable(crs: CRS, x: float, y: float) -> str | None:
    """Say why slopes and distances at (x, y) must not be computed in `crs`; None if they may.

    The unit must be the metre, and true to METRE_TOLERANCE on the ground in both directions.
    """
    if not crs.is_projected:
        return "is in degrees"
    if any(abs(axis.unit_conversion_factor - 1) > 1e-9 for axis in crs.axis_info[:2]):
        return f"is in {crs.axis_info[0].unit_name}, not in metres"
    conversion = without_shift(crs).coordinate_operation
    method = conversion.method_name if conversion else ""
    if "Mercator" in method and not any(word in method for word in ("Transverse", "Oblique", "Space")):
        return "is Mercator, whose metres are not true"
    east, north = ground_size(crs, x, y, (1.0, 0.0)), ground_size(crs, x, y, (0.0, 1.0))
    for size, way in ((east, "x"), (north, "y")):
        if not math.isfinite(size):
            return "does not cover this place"
        if abs(size - 1) > METRE_TOLERANCE:
            return f"is not true here: one unit of {way} is {size:.3g} m on the ground"
    return None


def ground_size(crs: CRS, x: float, y: float, step: tuple[float, float]) -> float:
    """Return the length in metres, on the ellipsoid, of one `step` in CRS units about the point (x, y)."""
    from pyproj import Geod

    # Longer than the step for short ones: the difference of two degrees must not drown in rounding.
    length = math.hypot(*step)
    scale = max(1.0, (1e-4 if crs.is_geographic else 10.0) / length)
    half = (step[0] * scale / 2, step[1] * scale / 2)
    lon, lat = to_lonlat(crs, np.array([x - half[0], x + half[0]]), np.array([y - half[1], y + half[1]]))
    if not (np.isfinite(lon).all() and np.isfinite(lat).all()):
        return math.inf
    return float(Geod(ellps="WGS84").inv(lon[0], lat[0], lon[1], lat[1])[2]) / scale


def outline(transform: Affine, shape: tuple[int, int], points: int = 21) -> tuple[np.ndarray, np.ndarray]:
    """Return x and y along the border of a raster, `points` on each side, in order round it."""
    rows, cols = shape
    share = np.linspace(0.0, 1.0, points)
    col = np.concatenate([share, np.ones(points), share[::-1], np.zeros(points)]) * cols
    row = np.concatenate([np.zeros(points), share, np.ones(points), share[::-1]]) * rows
    # affine is annotated for numbers but computes with arrays as well
    x, y = transform @ (col, row)  # type: ignore[operator]
    return np.asarray(x), np.asarray(y)


def convergence(crs: CRS, x: float, y: float) -> float:
    """Return the angle from true north to grid north at (x, y), degrees, positive clockwise."""
    lon, lat = to_lonlat(crs, np.array([x, x]), np.array([y - 50.0, y + 50.0]))
    east = (lon[1] - lon[0]) * math.cos(math.radians(float(lat.mean())))
    return math.degrees(math.atan2(east, float(lat[1] - lat[0])))
