"""A datum shift that a CRS carries itself is kept: places lie where PROJ with the shift puts them, in and out."""

import geopandas as gpd
import numpy as np
import pytest
import rasterio
from affine import Affine
from pyproj import CRS, Transformer
from shapely.geometry import box

from firebreak_gis.grid import Grid, crs_name
from firebreak_gis.landscape import read_landscape, read_landscape_folder, write_landscape
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.projections import horizontal, shift_unknown, to_lonlat, unsuitable
from firebreak_gis.rasters import read_header, read_raster, read_variable, write_raster
from firebreak_gis.vectors import write_vector
from tests.places import relief, write

#: Systems without a code of their own, and a place: GGRS87 in Crete, MGI in Austria (7 parameters, degrees too).
AUSTRIA = "+towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232"
GREECE = "+ellps=GRS80 +towgs84=-199.87,74.79,246.62"
SHIFTED = {
    "Greece": (
        f"+proj=tmerc +lon_0=24 +k=0.9996 +x_0=500000 {GREECE} +units=m +no_defs",
        "EPSG:32634",
        (700_000.0, 4_010_000.0),
    ),
    "Austria": (
        f"+proj=lcc +lat_0=47.5 +lon_0=13.33333333 +lat_1=49 +lat_2=46 +x_0=400000 +y_0=400000 +ellps=bessel {AUSTRIA}",
        "EPSG:32633",
        (500_000.0, 5_260_000.0),
    ),
}
DEGREES = f"+proj=longlat +ellps=bessel {AUSTRIA} +no_defs"


def halves(there, utm, corner, cell=20.0, n=200):
    """Classes on a grid in `there`: 2 west of the middle of a square in `utm`, 3 east; exact by transformation."""
    x0, y0 = corner
    edge = x0 + n * cell / 2
    to_there = Transformer.from_crs(utm, there, always_xy=True)
    x, y = to_there.transform(*np.array([(x0 + dx, y0 - dy) for dx in (0, n * cell) for dy in (0, n * cell)]).T)
    step = cell if CRS(there).is_projected else cell / 90_000
    left, top = min(x) - 20 * step, max(y) + 20 * step
    rows, cols = int((top - min(y)) / step) + 20, int((max(x) - left) / step) + 20
    row, col = np.mgrid[0:rows, 0:cols] + 0.5
    east, _ = Transformer.from_crs(there, utm, always_xy=True).transform(left + col * step, top - row * step)
    return np.where(east < edge, 2, 3).astype(np.uint8), Affine(step, 0, left, 0, -step, top), edge


@pytest.mark.parametrize("place", ["Greece", "Austria", "degrees"])
def test_a_layer_lies_where_its_shift_puts_it(tmp_path, place):
    there, utm, corner = SHIFTED["Austria" if place == "degrees" else place]
    there = DEGREES if place == "degrees" else there
    codes, transform, edge = halves(there, utm, corner)
    vegetation = write(tmp_path / "v.tif", codes, crs=CRS(there).to_wkt(), transform=transform)
    dem = write(tmp_path / "d.tif", relief(200, 200), crs=utm, transform=Affine(20, 0, corner[0], 0, -20, corner[1]))
    got = read_landscape(dem, vegetation, "normal")
    expected = np.where(Grid.of(got["vegetation"]).x < edge, 2, 3)
    assert (got["vegetation"].to_numpy() != expected).mean() < 1e-3  # a cell of either side at most, on the seam


@pytest.mark.parametrize("extra", ["", " +geoidgrids=none.gtx +vunits=us-ft"])
def test_the_horizontal_part_keeps_the_shift(extra):
    full = CRS(SHIFTED["Greece"][0] + extra)
    flat = horizontal(full)
    assert flat.is_bound
    assert len(flat.axis_info) == 2
    assert "datum shift" in crs_name(flat)
    lon, lat = to_lonlat(flat, np.array([500_000.0]), np.array([4_000_000.0]))
    np.testing.assert_allclose((lon[0], lat[0]), (24.0016625, 36.1473217), atol=1e-6)
    assert unsuitable(flat, 500_000.0, 4_000_000.0) is None


def test_mercator_with_a_shift_is_still_mercator():
    crs = CRS("+proj=merc +lon_0=24 +ellps=GRS80 +towgs84=-199.87,74.79,246.62 +units=m +no_defs")
    assert "Mercator" in unsuitable(horizontal(crs), 0.0, 4_000_000.0)


@pytest.mark.parametrize("place", SHIFTED)
def test_what_is_written_keeps_the_shift(tmp_path, place):
    there, utm, corner = SHIFTED[place]
    codes, transform, _ = halves(there, utm, corner, n=40)
    crs = CRS(there)
    dem = write(tmp_path / "d.tif", relief(*codes.shape), crs=crs.to_wkt(), transform=transform)
    vegetation = write(tmp_path / "v.tif", codes, crs=crs.to_wkt(), transform=transform)
    landscape = read_landscape(dem, vegetation, "normal")
    assert all("copied" in line for line in landscape.attrs["alignment"][1:])
    write_landscape(landscape, tmp_path / "land")
    again = read_landscape_folder(tmp_path / "land")
    assert Grid.of(again["elevation"]).matches(Grid.of(landscape["elevation"]))
    write_vector(tmp_path / "a.gpkg", gpd.GeoDataFrame(geometry=[box(0, 0, 1, 1)], crs=Grid.of(again["elevation"]).crs))
    x, y = np.array([transform.c]), np.array([transform.f])
    expected = Transformer.from_crs(crs, "EPSG:4326", always_xy=True).transform(x, y)
    with rasterio.open(tmp_path / "land/vegetation.tif") as source:
        for found in (source.crs.to_wkt(), gpd.read_file(tmp_path / "a.gpkg").crs, read_header(dem).crs):
            np.testing.assert_allclose(to_lonlat(CRS.from_user_input(found), x, y), expected, atol=1e-8)
    assert Grid.of(read_raster(tmp_path / "land/vegetation.tif")).crs.is_bound


def test_vectors_with_a_shift_lie_right(tmp_path):
    there, utm, corner = SHIFTED["Austria"]
    area = gpd.GeoDataFrame(geometry=[box(corner[0] + 400, corner[1] - 600, corner[0] + 800, corner[1] - 200)], crs=utm)
    area.to_crs(CRS(there)).to_file(tmp_path / "a.gpkg")
    grid = Grid((50, 50), Affine(20, 0, corner[0], 0, -20, corner[1]), CRS(utm))
    mask = mask_plane(tmp_path / "a.gpkg", grid, what="area", rule="centre")
    expected = np.zeros((50, 50), bool)
    expected[10:30, 20:40] = True
    assert (mask != expected).sum() <= 4  # corners, through rounding


def test_a_prj_beside_a_text_grid_keeps_its_shift(tmp_path):
    (tmp_path / "a.asc").write_text(
        "ncols 3\nnrows 3\nxllcorner 500000\nyllcorner 400000\ncellsize 10\n" + "1 2 3\n" * 3
    )
    crs = CRS(SHIFTED["Austria"][0])
    (tmp_path / "a.prj").write_text(crs.to_wkt("WKT1_GDAL"))
    found = read_header(tmp_path / "a.asc").crs
    np.testing.assert_allclose(
        to_lonlat(found, np.array([5e5]), np.array([4e5])), to_lonlat(crs, np.array([5e5]), np.array([4e5]))
    )


def test_a_file_that_cannot_keep_the_crs_is_refused(tmp_path, monkeypatch):
    """Were the shift lost in writing, the check of the finished file would find it."""
    import firebreak_gis.rasters.writing as writing
    from firebreak_gis.errors import VerificationError

    crs = CRS(SHIFTED["Austria"][0])
    grid = Grid((3, 4), Affine(20, 0, 500_000, 0, -20, 400_000), crs)
    parse = writing.parse_crs
    monkeypatch.setattr(writing, "parse_crs", lambda value: parse(value).source_crs)
    with pytest.raises(VerificationError, match="cannot keep the CRS"):
        write_raster(tmp_path / "e.tif", grid.dataarray(np.ones((3, 4), np.float32), "elevation"))
    monkeypatch.undo()
    write_raster(tmp_path / "e.tif", grid.dataarray(np.ones((3, 4), np.float32), "elevation"))
    assert Grid.of(read_variable(tmp_path / "e.tif", "elevation")).matches(grid)


def test_an_unknown_shift_is_warned_of(tmp_path):
    """GGRS87 without its name or its shift lies 290 m off, and nobody can know it from the file."""
    there, utm, corner = SHIFTED["Greece"]
    silent = there.replace("+towgs84=-199.87,74.79,246.62", "")
    codes, transform, _ = halves(silent, utm, corner, n=40)
    dem = write(tmp_path / "d.tif", relief(40, 40), crs=utm, transform=Affine(20, 0, corner[0], 0, -20, corner[1]))
    vegetation = write(tmp_path / "v.tif", codes, crs=CRS(silent).to_wkt(), transform=transform)
    told = read_landscape(dem, vegetation, "normal").attrs["warnings"]
    assert any(line.startswith("vegetation: no datum shift is known") for line in told)
    known = read_landscape(dem, vegetation, "normal", src_crs={"vegetation": there}).attrs["warnings"]
    assert not any("datum shift" in line for line in known)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("EPSG:25830", "EPSG:32630"),
        ("EPSG:2100", "EPSG:32634"),
        ("EPSG:3035", "EPSG:32635"),
        ("EPSG:5070", "EPSG:32611"),
        ("EPSG:27700", "EPSG:32630"),
        ("+proj=utm +zone=35 +ellps=WGS84", "EPSG:32635"),
        (SHIFTED["Austria"][0], "EPSG:32633"),
    ],
)
def test_shifts_that_are_known_are_not_warned_of(one, other):
    assert not shift_unknown(CRS(one), CRS(other))
