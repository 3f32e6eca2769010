"""Any rasters go to one square grid: against slow twins, by properties, and every refusal."""

import json
import tracemalloc

import numpy as np
import pytest
import rasterio
from affine import Affine
from hypothesis import given, settings
from hypothesis import strategies as st
from pyproj import CRS, Transformer
from scipy import ndimage

from firebreak_gis import projections
from firebreak_gis.errors import (
    CRSError,
    GridError,
    InputError,
    LegendError,
    OutputError,
    ParameterError,
    ResourceError,
)
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape import (
    alignment,
    memory_needed,
    read_landscape,
    read_landscape_folder,
    target_grid,
    write_landscape,
)
from firebreak_gis.landscape.request import LandscapeRequest
from firebreak_gis.landscape.surveying import survey
from firebreak_gis.rasters import read_header, read_raster
from firebreak_gis.spread import spread_network
from tests.places import NORTH_WEST, UTM, patches, relief, square, three, write

FULL = ("elevation", "vegetation", "density", "burnable")


def lay(dem, vegetation, density="normal", **more):
    return read_landscape(dem, vegetation, density, **more)


def told(dataset, layer):
    return next(text for text in dataset.attrs["alignment"] if text.startswith(f"{layer}: "))


# What comes out


def test_matching_layers_are_copied(tmp_path):
    dem, vegetation, density = three(tmp_path)
    data = read_landscape(dem, vegetation, density)
    grid = Grid.of(data)
    assert grid.matches(Grid((24, 31), square(), parse_crs(UTM)))
    np.testing.assert_array_equal(data["elevation"], relief(24, 31))
    np.testing.assert_array_equal(data["vegetation"], patches(24, 31, [0, 1, 2, 3]))
    expected = np.where(data["vegetation"] > 0, patches(24, 31, [1, 2, 3], seed=5), 0)
    np.testing.assert_array_equal(data["density"], expected)
    np.testing.assert_array_equal(data["burnable"], data["vegetation"] > 0)
    assert [str(data[name].dtype) for name in FULL] == ["float32", "uint8", "uint8", "bool"]
    assert all(data[name].dims == ("y", "x") for name in FULL)
    assert data["elevation"].attrs["units"] == "m"
    assert all("copied" in told(data, layer) for layer in FULL[:3])
    assert data.attrs["warnings"] == []
    json.dumps(data.attrs)


@pytest.mark.parametrize(("off", "lost"), [(0.0, 0), (0.0005, 0), (-0.0005, 0), (0.005, 1), (-0.005, 1)])
def test_edges_within_a_thousandth_of_a_cell_are_the_same(tmp_path, off, lost):
    """Corners that were rounded in a file lose no row or column; those farther off do."""
    dem, vegetation, _ = three(tmp_path)
    corner = (NORTH_WEST[0] + 20.0 * off, NORTH_WEST[1] - 20.0 * off)
    vegetation = write(tmp_path / "moved.tif", patches(24, 31, [0, 1, 2, 3]), transform=square(20.0, corner))
    assert Grid.of(lay(dem, vegetation)).shape == (24 - lost, 31 - lost)


@pytest.mark.parametrize("off", [0.0005, -0.0005])
def test_bounds_within_a_thousandth_of_a_cell_are_on_its_edge(tmp_path, off):
    dem, vegetation, _ = three(tmp_path)
    left, top = NORTH_WEST
    bounds = (left + 20.0 * (4 + off), top - 20.0 * (15 + off), left + 20.0 * (13 + off), top - 20.0 * (2 + off))
    grid = Grid.of(lay(dem, vegetation, bounds=bounds))
    assert grid.matches(Grid((13, 9), square(20.0, (left + 80.0, top - 40.0)), parse_crs(UTM)))
    wide = (bounds[0] - 0.2, bounds[1] - 0.2, bounds[2] + 0.2, bounds[3] + 0.2)  # a hundredth is not
    assert Grid.of(lay(dem, vegetation, bounds=wide)).shape == (15, 11)


def test_inputs_are_not_changed(tmp_path):
    paths = three(tmp_path)
    before = [path.read_bytes() for path in paths]
    arrays = [read_raster(path) for path in paths]
    copies = [array.copy(deep=True) for array in arrays]
    from_files, from_arrays = read_landscape(*paths), read_landscape(*arrays)
    assert from_files.equals(from_arrays)
    assert [path.read_bytes() for path in paths] == before
    assert all(array.identical(copy) for array, copy in zip(arrays, copies, strict=True))


def test_an_array_without_crs_is_refused_with_the_way_out(tmp_path):
    dem, vegetation, density = three(tmp_path)
    array = read_raster(vegetation).drop_vars("spatial_ref")
    with pytest.raises(CRSError, match="write_crs"):
        read_landscape(dem, array, density)
    with pytest.raises(InputError, match="select one band"):
        read_landscape(dem, read_raster(vegetation).expand_dims(band=2), density)


@pytest.mark.filterwarnings("ignore:Use `@` matmul")
def test_rioxarray_arrays_are_taken(tmp_path):
    import rioxarray

    paths = three(tmp_path)
    arrays = [rioxarray.open_rasterio(path) for path in paths]
    assert read_landscape(*arrays).equals(read_landscape(*paths))
    for array in arrays:
        array.close()


def test_transforms_that_differ_by_less_than_a_thousandth_are_the_same_grid(tmp_path):
    dem = write(tmp_path / "dem.tif", relief(20, 30))
    shifted = square(20.0, (NORTH_WEST[0] + 0.01, NORTH_WEST[1] - 0.01))
    data = lay(dem, write(tmp_path / "v.tif", patches(20, 30, [1, 2, 3]), transform=shifted))
    assert "copied" in told(data, "vegetation")
    np.testing.assert_array_equal(data["vegetation"], patches(20, 30, [1, 2, 3]))


def test_the_extent_is_what_all_cover(tmp_path):
    dem = write(tmp_path / "dem.tif", relief(40, 50))
    part = square(20.0, (NORTH_WEST[0] + 100, NORTH_WEST[1] - 60))
    data = lay(dem, write(tmp_path / "v.tif", patches(20, 30, [1, 2, 3]), transform=part))
    assert Grid.of(data).matches(Grid((20, 30), part, parse_crs(UTM)))
    np.testing.assert_array_equal(data["elevation"], relief(40, 50)[3:23, 5:35])
    assert data.attrs["warnings"] == []


def test_partial_overlap_is_told_and_too_little_refused(tmp_path):
    dem = write(tmp_path / "dem.tif", relief(40, 50))

    def at(cols):
        return square(20.0, (NORTH_WEST[0] + 20 * cols, NORTH_WEST[1]))

    data = lay(dem, write(tmp_path / "v.tif", patches(40, 50, [1, 2, 3]), transform=at(25)))
    assert "50%" in data.attrs["warnings"][0]
    assert data.sizes["x"] == 25
    with pytest.raises(GridError, match=r"overlap on 4\.0%.*elevation: x 586440 to 587440.*vegetation: x 587400"):
        lay(dem, write(tmp_path / "w.tif", patches(40, 50, [1, 2, 3]), transform=at(48)))
    with pytest.raises(GridError, match=r"do not overlap.*longitude"):
        lay(dem, write(tmp_path / "z.tif", patches(40, 50, [1, 2, 3]), transform=at(5000)))


# Slow twins


def nearest_twin(values, transform, crs, grid):
    """Look up every cell centre on its own; -2 where it falls on the edge between two cells."""
    turn = Transformer.from_crs(grid.crs, crs, always_xy=True)
    result = np.full(grid.shape, -1)
    for row, y in enumerate(grid.y):
        for col, x in enumerate(grid.x):
            source_col, source_row = ~transform @ turn.transform(x, y)
            if abs(source_col - round(source_col)) < 1e-5 or abs(source_row - round(source_row)) < 1e-5:
                result[row, col] = -2
            elif 0 <= source_row < values.shape[0] and 0 <= source_col < values.shape[1]:
                result[row, col] = values[int(source_row), int(source_col)]
    return result


@pytest.mark.parametrize(
    ("crs", "transform"),
    [
        ("EPSG:32635", square(33.0, (NORTH_WEST[0] + 7, NORTH_WEST[1] + 11))),
        ("EPSG:4326", Affine(0.00031, 0, 27.9608, 0, -0.00027, 36.1425)),
        ("EPSG:3035", Affine(27, 0, 5_936_000, 0, -24, 1_642_700)),
        ("EPSG:32635", Affine.translation(*NORTH_WEST) @ Affine.rotation(-17) @ Affine.scale(26, -26)),
        ("EPSG:32635", Affine(31, 0, NORTH_WEST[0], 0, 29, NORTH_WEST[1] - 1400)),
    ],
    ids=["shifted", "degrees", "laea", "rotated", "south_up"],
)
def test_classes_are_the_nearest_cell(tmp_path, crs, transform):
    dem = write(tmp_path / "dem.tif", relief(45, 38))
    values = patches(50, 50, [0, 1, 2, 3], size=1)
    data = lay(dem, write(tmp_path / "v.tif", values, transform=transform, crs=crs), like=dem)
    twin = nearest_twin(values, transform, CRS(crs), Grid.of(data))
    sure = twin != -2
    assert sure.mean() > 0.9
    assert (twin > 0).mean() > 0.2
    np.testing.assert_array_equal(data["vegetation"].to_numpy()[sure], np.maximum(twin, 0)[sure])
    assert "nearest" in told(data, "vegetation")


@pytest.mark.parametrize("crs", ["EPSG:32635", "EPSG:4326"])
def test_elevation_is_interpolated_between_cell_centres(tmp_path, crs):
    transform = square(30.0) if crs == UTM else Affine(0.0004, 0, 27.9610, 0, -0.0004, 36.1425)
    values = relief(40, 45)
    dem = write(tmp_path / "dem.tif", values, transform=transform, crs=crs)
    vegetation = write(tmp_path / "v.tif", patches(40, 50, [1, 2, 3]))
    data = lay(dem, vegetation, like=vegetation)
    grid = Grid.of(data)
    x, y = np.meshgrid(grid.x, grid.y)
    sx, sy = Transformer.from_crs(grid.crs, crs, always_xy=True).transform(x, y)
    col, row = ~transform @ (sx, sy)
    twin = ndimage.map_coordinates(values.astype(float), [row - 0.5, col - 0.5], order=1, cval=np.nan)
    inside = np.isfinite(twin) & (row > 1) & (col > 1) & (row < 39) & (col < 44)
    assert inside.mean() > 0.5
    np.testing.assert_allclose(data["elevation"].to_numpy()[inside], twin[inside], atol=0.01)


def test_coarser_cells_hold_averages_and_modes(tmp_path):
    rows, cols = 30, 42
    codes = np.kron(patches(rows // 3, cols // 3, [0, 1, 2, 3], size=1), np.ones((3, 3), dtype=np.uint8))
    codes[1::3, 1::3] = (codes[1::3, 1::3] + 1) % 4  # a minority in every block
    dem = write(tmp_path / "dem.tif", relief(rows, cols))
    data = lay(dem, write(tmp_path / "v.tif", codes), resolution=60)
    blocks = relief(rows, cols).astype(float).reshape(rows // 3, 3, cols // 3, 3)
    np.testing.assert_allclose(data["elevation"], blocks.mean(axis=(1, 3)), rtol=1e-5)
    np.testing.assert_array_equal(data["vegetation"], codes[::3, ::3])
    assert "average" in told(data, "elevation")
    assert "mode" in told(data, "vegetation")


def test_bare_land_told_by_nodata_survives_coarsening(tmp_path):
    codes = np.zeros((12, 12), dtype=np.uint8)
    codes[::3, ::3] = 2  # one cell with fuel in nine
    codes[:3] = 2
    dem = write(tmp_path / "dem.tif", relief(12, 12))
    data = lay(dem, write(tmp_path / "v.tif", codes, nodata=0), resolution=60)
    np.testing.assert_array_equal(data["vegetation"], [[2] * 4] + [[0] * 4] * 3)


def test_class_255_stays_255(tmp_path):
    table = tmp_path / "legend.csv"
    table.write_text("code,vegetation,density,label\n255,pines,dense,forest\n254,none,,bare\n")
    dem = write(tmp_path / "dem.tif", relief(20, 20))
    values = np.full((20, 20), 255, dtype=np.uint8)
    data = lay(dem, write(tmp_path / "v.tif", values, transform=square(33.0)), None, legend=table)
    assert (data["vegetation"] == 3).all()


def test_missing_elevation_is_not_interpolated_over_and_told(tmp_path):
    values = relief(20, 20).copy()
    values[5:9, 5:9] = -9999
    dem = write(tmp_path / "dem.tif", values, nodata=-9999)
    data = lay(dem, write(tmp_path / "v.tif", patches(20, 20, [1, 2, 3])), like=dem)
    hole = ~np.isfinite(data["elevation"])
    assert int(hole.sum()) == 16
    np.testing.assert_array_equal(data["burnable"], ~hole)
    assert "16 cells with fuel have no elevation" in data.attrs["warnings"][0]


# The grid chosen


def test_a_dem_in_degrees_goes_to_utm_in_rounded_true_metres(tmp_path):
    dem = write(
        tmp_path / "dem.tif",
        relief(90, 90),
        transform=Affine(1 / 1200, 0, 27.9, 0, -1 / 1200, 36.2),
        crs="EPSG:4326",
    )
    data = lay(dem, write(tmp_path / "v.tif", patches(120, 120, [1, 2, 3]), transform=square(40.0)))
    grid = Grid.of(data)
    assert grid.crs.to_epsg() == 32635
    assert grid.cell_size == 83  # 3 arc seconds: 75.0 x 92.5 m
    assert grid.transform.c % 83 == 0
    assert "is in degrees" in data.attrs["alignment"][0]


@pytest.mark.parametrize(
    ("crs", "transform", "why"),
    [
        ("EPSG:3857", Affine(25, 0, 3_112_000, 0, -25, 4_320_000), "Mercator"),
        ("EPSG:2227", Affine(60, 0, 6_000_000, 0, -60, 2_100_000), "US survey foot"),
        ("EPSG:4087", Affine(25, 0, 3_112_000, 0, -25, 4_320_000), "not true here"),
    ],
)
def test_other_units_and_untrue_metres_go_to_utm(tmp_path, crs, transform, why):
    more = {"crs": crs, "transform": transform}
    data = lay(
        write(tmp_path / "dem.tif", relief(60, 60), **more),
        write(tmp_path / "v.tif", patches(60, 60, [1, 2, 3]), **more),
    )
    assert why in data.attrs["alignment"][0]
    assert str(Grid.of(data).crs.to_epsg())[:3] == "326"
    with pytest.raises(CRSError, match=f"{why}.*EPSG:326"):
        lay(tmp_path / "dem.tif", tmp_path / "v.tif", crs=crs)


@pytest.mark.parametrize("west", [179.9, -180.1])
def test_the_antimeridian(tmp_path, west):
    """Longitudes beyond 180 on one layer, below -180 on the other, UTM on a third: one place."""
    values = relief(100, 100)
    dem = write(tmp_path / "dem.tif", values, transform=Affine(0.002, 0, west, 0, -0.002, -16.5), crs="EPSG:4326")
    codes = patches(100, 100, [1, 2, 3])
    other = west - 360 if west > 0 else west + 360
    vegetation = write(tmp_path / "v.tif", codes, transform=Affine(0.002, 0, other, 0, -0.002, -16.5), crs="EPSG:4326")
    data = lay(dem, vegetation)
    assert Grid.of(data).crs.to_epsg() in (32701, 32760)
    assert float(data["burnable"].mean()) > 0.95
    assert data.sizes["x"] < 120
    twin = nearest_twin(
        codes,
        Affine(0.002, 0, 179.9, 0, -0.002, -16.5),
        CRS("+proj=longlat +datum=WGS84 +lon_wrap=180"),
        Grid.of(data),
    )
    sure = twin > 0
    np.testing.assert_array_equal(data["vegetation"].to_numpy()[sure], twin[sure])


@pytest.mark.parametrize(
    ("lon", "lat", "epsg"),
    [
        ((27.9, 28.1), (36, 36.2), 32635),
        ((-71, -70), (-36, -35), 32719),
        ((5.1, 5.5), (60, 60.5), 32632),
        ((179.5, 180.5), (-17, -16), 32701),
        ((10, 40), (85, 86), 32661),
        ((0, 1), (-81, -80.5), 32761),
    ],
)
def test_suggested_utm(lon, lat, epsg):
    assert projections.suggest_utm(np.array(lon, float), np.array(lat, float)).to_epsg() == epsg


def test_the_whole_world_fits_no_zone(tmp_path):
    more = {"transform": Affine(10, 0, -175, 0, -5, 87.5), "crs": "EPSG:4326"}
    with pytest.raises(CRSError, match="350 degrees"):
        lay(
            write(tmp_path / "d.tif", relief(33, 35), **more),
            write(tmp_path / "v.tif", patches(33, 35, [1, 2]), **more),
        )


def test_cells_that_are_not_square_become_square(tmp_path):
    more = {"transform": Affine(19.71, 0, *NORTH_WEST[:1], 0, -20.27, NORTH_WEST[1])}
    data = lay(
        write(tmp_path / "d.tif", relief(50, 60), **more),
        write(tmp_path / "v.tif", patches(50, 60, [1, 2]), **more),
    )
    assert Grid.of(data).cell_size == 20
    assert "19.71 x 20.27" in data.attrs["alignment"][0]


def test_resolution_bounds_and_crs_are_followed(tmp_path):
    dem, vegetation, density = three(tmp_path, 60, 70)
    data = read_landscape(dem, vegetation, density, resolution=25, bounds=(586_500, 3_999_010, 587_001, 3_999_600))
    left, bottom, right, top = Grid.of(data).bounds
    assert Grid.of(data).cell_size == 25
    assert left <= 586_500 < left + 25
    assert bottom <= 3_999_010 < bottom + 25
    assert right - 25 < 587_001 <= right
    assert top - 25 < 3_999_600 <= top
    assert Grid.of(read_landscape(dem, vegetation, density, crs="EPSG:2100")).crs.to_epsg() == 2100
    # Bounds beyond the data give what there is.
    assert read_landscape(dem, vegetation, density, bounds=(0, 0, 1e7, 1e7)).sizes == {"y": 60, "x": 70}


def test_like_takes_the_grid_of_path_grid_or_array(tmp_path):
    dem, vegetation, density = three(tmp_path, 60, 70)
    grid = Grid((20, 25), square(33.0, (NORTH_WEST[0] + 100, NORTH_WEST[1] - 100)), parse_crs(UTM))
    path = write(tmp_path / "like.tif", relief(20, 25), transform=grid.transform)
    for like in (grid, path, read_raster(path)):
        assert Grid.of(read_landscape(dem, vegetation, density, like=like)).matches(grid)
    with pytest.raises(ParameterError, match="whole grid"):
        read_landscape(dem, vegetation, density, like=grid, resolution=20)
    with pytest.raises(CRSError, match="in degrees"):
        read_landscape(dem, vegetation, density, like=Grid((5, 5), Affine(0.1, 0, 27, 0, -0.1, 37), parse_crs(4326)))
    with pytest.raises(GridError, match="square"):
        read_landscape(dem, vegetation, density, like=Grid((5, 5), Affine(20, 0, 5e5, 0, -30, 4e6), parse_crs(UTM)))


def test_grid_north_far_from_true_north_is_warned_of(tmp_path):
    dem, vegetation, density = three(tmp_path)
    data = read_landscape(dem, vegetation, density, crs=3035)
    assert any("11.7 degrees clockwise" in text for text in data.attrs["warnings"])
    # The twin: walk north along the meridian and measure the way on the map.
    turn = Transformer.from_crs(4326, 3035, always_xy=True)
    x0, y0 = turn.transform(27.96, 36.14)
    x1, y1 = turn.transform(27.96, 36.15)
    assert np.degrees(np.arctan2(x0 - x1, y1 - y0)) == pytest.approx(
        projections.convergence(CRS(3035), x0, y0), abs=0.2
    )


# Units, and what elevations cannot be


@pytest.mark.parametrize(("units", "factor"), [("ft", 0.3048), ("US survey foot", 1200 / 3937), ("metre", 1), ("", 1)])
def test_feet_become_metres(tmp_path, units, factor):
    dem = write(tmp_path / "d.tif", relief(9, 8), units=units)
    data = lay(dem, write(tmp_path / "v.tif", patches(9, 8, [1, 2])))
    np.testing.assert_allclose(data["elevation"], relief(9, 8) * factor, rtol=1e-6)
    assert any("multiplied" in text for text in data.attrs["alignment"]) == (factor != 1)


def test_feet_of_a_compound_crs_become_metres(tmp_path):
    dem = write(tmp_path / "d.tif", relief(9, 8), crs="EPSG:26910+8228")
    data = lay(dem, write(tmp_path / "v.tif", patches(9, 8, [1, 2]), crs="EPSG:26910"))
    np.testing.assert_allclose(data["elevation"], relief(9, 8) * 0.3048, rtol=1e-6)
    assert "copied" in told(data, "vegetation")


@pytest.mark.parametrize(
    ("change", "more", "match"),
    [
        (lambda v: v + 20_000, {}, "elevations from"),
        (lambda v: v, {"units": "degrees"}, "expected a length in one of: m, "),
        (lambda v: np.full_like(v, np.nan), {}, "no data"),
    ],
)
def test_impossible_elevations_are_refused(tmp_path, change, more, match):
    dem = write(tmp_path / "d.tif", change(relief(9, 8)), **more)
    with pytest.raises(InputError, match=match):
        lay(dem, write(tmp_path / "v.tif", patches(9, 8, [1, 2])))


def test_the_sea_bed_has_no_elevation(tmp_path):
    values = relief(9, 8).copy()
    values[:2] = np.linspace(-3000, -600, 16).reshape(2, 8)
    data = lay(write(tmp_path / "d.tif", values), write(tmp_path / "v.tif", patches(9, 8, [1, 2])))
    assert int(np.isnan(data["elevation"]).sum()) == 16
    assert "sea bed" in data.attrs["warnings"][0]


def test_a_colour_table_is_no_dem(tmp_path):
    path = write(tmp_path / "d.tif", patches(9, 8, [1, 2]))
    with rasterio.open(path, "r+") as target:
        target.write_colormap(1, {1: (255, 0, 0), 2: (0, 255, 0)})
    with pytest.raises(InputError, match="colour table"):
        lay(path, path)


# Legends at work


def test_unknown_codes_are_refused_with_areas_or_allowed(tmp_path):
    dem = write(tmp_path / "d.tif", relief(9, 10))
    codes = patches(9, 10, [1, 2])
    codes[0, :5] = 34
    codes[1, 0] = 77
    vegetation = write(tmp_path / "v.tif", codes)
    with pytest.raises(LegendError, match=r"34 \(0\.2 ha\), 77 \(0\.04 ha\).*nonburnable"):
        lay(dem, vegetation)
    data = lay(dem, vegetation, unknown="nonburnable")
    np.testing.assert_array_equal(data["burnable"], codes < 30)
    assert "34 (0.2 ha)" in data.attrs["warnings"][0]
    assert int(lay(dem, vegetation, src_nodata={"vegetation": [34, 77]})["burnable"].sum()) == 84


def test_whole_floats_are_classes_and_fractions_are_not(tmp_path):
    dem = write(tmp_path / "d.tif", relief(9, 10))
    whole = lay(dem, write(tmp_path / "v.tif", patches(9, 10, [1, 2]).astype("float64"), nodata=-9999))
    np.testing.assert_array_equal(whole["vegetation"], patches(9, 10, [1, 2]))
    with pytest.raises(InputError, match="looks resampled"):
        lay(dem, write(tmp_path / "w.tif", patches(9, 10, [1, 2]) + np.float32(0.25)))
    with pytest.raises(InputError, match="negative codes -9999"):
        lay(dem, write(tmp_path / "x.tif", np.where(patches(9, 10, [1, 2]) == 1, -9999, 2).astype("int16")))


def test_without_any_density_the_ways_out_are_said(tmp_path):
    dem, vegetation, _ = three(tmp_path)
    with pytest.raises(LegendError, match=r"density raster.*one class.*legend with densities"):
        read_landscape(dem, vegetation)
    data = read_landscape(dem, vegetation, "dense")
    assert set(np.unique(data["density"])) == {0, 3}


def test_cells_without_density_do_not_burn_and_are_told(tmp_path):
    dem, vegetation, density = three(tmp_path)
    with rasterio.open(density, "r+") as target:
        codes = target.read(1)
        codes[:4] = 255
        target.write(codes, 1)
    data = read_landscape(dem, vegetation, density)
    assert not data["burnable"][:4].any()
    assert "have no density" in data.attrs["warnings"][0]


@pytest.mark.parametrize(("scale", "match"), [(1, None), (0.01, "looks like a fraction"), (1.5, "does not list")])
def test_cover_becomes_density_by_the_thresholds_of_its_legend(tmp_path, scale, match):
    dem = write(tmp_path / "d.tif", relief(9, 10))
    codes = np.full((9, 10), 165, dtype=np.int16)
    codes[:, :2] = 101  # grass keeps the density of the legend
    cover = np.linspace(0, 100, 90, dtype=np.float32).reshape(9, 10)
    paths = dem, write(tmp_path / "v.tif", codes), write(tmp_path / "c.tif", cover * np.float32(scale))
    if match:
        with pytest.raises(LegendError, match=match):
            read_landscape(*paths, legend="scott_burgan_40", density_legend="canopy_cover")
        return
    data = read_landscape(*paths, legend="scott_burgan_40", density_legend="canopy_cover")
    expected = np.where(cover < 40, 1, np.where(cover < 70, 2, 3))
    expected[:, :2] = 1
    np.testing.assert_array_equal(data["density"], expected)
    whole = write(tmp_path / "w.tif", np.round(cover))
    with pytest.raises(LegendError, match="canopy_cover"):
        read_landscape(dem, paths[1], whole, legend="scott_burgan_40")


def test_numbers_in_a_legend_become_effects(tmp_path):
    table = tmp_path / "own.csv"
    table.write_text("code,vegetation,density,label\n0,none,,bare\n1,0.25,normal,a\n2,pines,-0.15,b\n")
    dem = write(tmp_path / "d.tif", relief(9, 10))
    codes = patches(9, 10, [0, 1, 2])
    data = lay(dem, write(tmp_path / "v.tif", codes), None, legend=table)
    effect = np.select([codes == 1], [np.float32(0.25)], np.float32(np.nan))
    np.testing.assert_array_equal(data["vegetation_effect"], effect)
    np.testing.assert_array_equal(
        data["density_effect"], np.select([codes == 2], [np.float32(-0.15)], np.float32(np.nan))
    )
    np.testing.assert_array_equal(data["vegetation"], np.select([codes == 1, codes == 2], [3, 3], 0))
    write_landscape(data, tmp_path / "out")
    assert read_landscape_folder(tmp_path / "out").identical(data)
    plain = lay(dem, tmp_path / "v.tif", None, legend=_classes_only(tmp_path))
    with pytest.raises(OutputError):
        write_landscape(plain, tmp_path / "out")
    write_landscape(plain, tmp_path / "out", overwrite=True)
    assert read_landscape_folder(tmp_path / "out").identical(plain)


def test_how_the_fuel_burns_goes_from_the_legend_into_the_folder_and_the_network(tmp_path):
    table = tmp_path / "own.csv"
    table.write_text(
        "code,vegetation,density,label,rate_m_h,dead_kg_m2,live_kg_m2,heat_kj_kg,live_moisture\n"
        "0,none,,bare,50\n1,shrubs,normal,a,70,0.4,2,19000,0.7\n2,pines,dense,b\n"
    )
    codes = patches(9, 10, [0, 1, 2])
    data = lay(write(tmp_path / "d.tif", relief(9, 10)), write(tmp_path / "v.tif", codes), None, legend=table)
    for name, value in {
        "rate": 70,
        "dead_load": 0.4,
        "live_load": 2,
        "heat_content": 19_000,
        "live_moisture": 0.7,
    }.items():
        expected = np.where(codes == 1, np.float32(value), np.float32(np.nan))
        np.testing.assert_array_equal(data[name], expected)
    write_landscape(data, tmp_path / "out")
    back = read_landscape_folder(tmp_path / "out")
    assert back.identical(data)
    network = spread_network(back, clock=True)
    heat = 0.4 * 19_000 + 2 * (19_000 * 0.3 - 2442 * 0.7)
    assert network.heat[(codes == 1) & network.burnable] == pytest.approx(heat, rel=1e-6)
    calm = spread_network(back, clock=True, rate_slope=0.0).rate()
    assert calm[:, codes == 1].max() == pytest.approx(70, rel=0.05)
    assert calm[:, codes == 2].max() == pytest.approx(200, rel=0.05)
    faster = spread_network(back, clock=True, rate_shrubs=999.0)
    np.testing.assert_array_equal(faster.travel_time, network.travel_time)  # the legend counts
    plain = lay(tmp_path / "d.tif", tmp_path / "v.tif", None, legend=_classes_only(tmp_path))
    assert "rate" not in plain
    layers = (str(tmp_path / "d.tif"), str(tmp_path / "v.tif"))
    needed = [survey(LandscapeRequest(*layers, legend=str(name))).memory for name in (table, tmp_path / "plain.csv")]
    assert needed[0] >= needed[1] + 5 * 4 * codes.size
    write_landscape(plain, tmp_path / "out", overwrite=True)  # and takes the planes of the other away
    assert read_landscape_folder(tmp_path / "out").identical(plain)


def _classes_only(folder):
    path = folder / "plain.csv"
    path.write_text("code,vegetation,density,label\n0,none,,bare\n1,shrubs,normal,a\n2,pines,sparse,b\n")
    return path


# Refusals and limits


@pytest.mark.parametrize(
    ("more", "error", "match"),
    [
        ({"resolution": -5}, ParameterError, "positive"),
        ({"resolution": float("nan")}, ParameterError, "positive"),
        ({"bounds": (5, 5, 1, 9)}, ParameterError, "empty"),
        ({"crs": "EPSG:999999"}, CRSError, "cannot read"),
        ({"crs": 4326}, CRSError, "in degrees"),
        ({"crs": 32601}, CRSError, "not true here|does not cover"),
        ({"unknown": "guess"}, ParameterError, "refuse or nonburnable"),
        ({"src_nodata": {"wind": 0}}, ParameterError, "wind"),
        ({"legend": "density"}, LegendError, "vegetation"),
        ({"legend": "nowhere"}, LegendError, "neither"),
        ({"resolution": 250}, GridError, "at least 3 x 3"),
        ({"max_memory": 10_000}, ResourceError, "memory"),
        ({"band": {"dem": 2}}, InputError, "no band 2"),
    ],
)
def test_impossible_wishes_are_refused(tmp_path, more, error, match):
    with pytest.raises(error, match=match):
        read_landscape(*three(tmp_path), **more)


def test_nothing_that_can_burn_is_refused(tmp_path):
    dem = write(tmp_path / "d.tif", relief(9, 10))
    with pytest.raises(InputError, match="no cell can burn"):
        lay(dem, write(tmp_path / "v.tif", np.zeros((9, 10), dtype="uint8")))
    with pytest.raises(InputError, match=r"vegetation.*holds no data"):
        lay(dem, write(tmp_path / "w.tif", np.zeros((9, 10), dtype="uint8"), nodata=0))


def test_a_bomb_is_refused_from_its_header(tmp_path):
    """A file of a few kB that would fill 40 GB is refused before anything is read."""
    bomb = tmp_path / "bomb.tif"
    with rasterio.open(
        bomb,
        "w",
        driver="GTiff",
        height=100_000,
        width=100_000,
        count=1,
        dtype="float32",
        crs=UTM,
        transform=square(1.0),
        tiled=True,
        blockxsize=4096,
        blockysize=4096,
        compress="deflate",
        sparse_ok=True,
    ):
        pass
    assert bomb.stat().st_size < 100_000
    with pytest.raises(ResourceError, match="GB of memory"):
        lay(bomb, bomb, max_memory=2_000_000_000)


def test_progress_rises_to_one_and_cancels(tmp_path):
    paths = three(tmp_path)
    seen = []
    read_landscape(*paths, progress=lambda share, text: seen.append(share))
    assert seen == sorted(seen)
    assert seen[-1] == 1

    def stop(share, text):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        read_landscape(*paths, progress=stop)


# Folders


def test_a_folder_reads_back_identical(tmp_path):
    data = read_landscape(*three(tmp_path))
    paths = write_landscape(data, tmp_path / "new" / "out", provenance={"seed": 3})
    assert [path.name for path in paths] == ["elevation.tif", "vegetation.tif", "density.tif"]
    assert read_landscape_folder(tmp_path / "new" / "out").identical(data)
    with pytest.raises(OutputError):
        write_landscape(data, tmp_path / "new" / "out")
    write_landscape(data, tmp_path / "new" / "out", overwrite=True)
    assert sorted(p.suffix for p in (tmp_path / "new" / "out").iterdir()) == [".qml"] * 3 + [".tif"] * 3


def test_one_forbidden_file_stops_the_whole_folder(tmp_path):
    data = read_landscape(*three(tmp_path))
    folder = tmp_path / "out"
    folder.mkdir()
    (folder / "density.tif").write_text("in the way")
    with pytest.raises(OutputError, match="exists"):
        write_landscape(data, folder)
    assert [p.name for p in folder.iterdir()] == ["density.tif"]


def test_unfit_folders_are_refused(tmp_path):
    with pytest.raises(InputError, match="not a folder"):
        read_landscape_folder(tmp_path / "missing")
    data = read_landscape(*three(tmp_path))
    folder = tmp_path / "out"
    write_landscape(data, folder)
    write(folder / "density.tif", patches(24, 31, [1, 2]), transform=square(21.0))
    with pytest.raises(GridError, match=r"density\.tif lies on another grid"):
        read_landscape_folder(folder)
    (folder / "density.tif").unlink()
    with pytest.raises(InputError, match=r"lacks density\.tif"):
        read_landscape_folder(folder)


# Properties

OFFSET = st.floats(-40, 40).map(lambda v: round(v, 2) + 0.005)
CELL = st.sampled_from([9.7, 14.3, 20.0, 26.1, 47.9])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("properties")


@settings(max_examples=25, deadline=None)
@given(dx=OFFSET, dy=OFFSET, cell=CELL, epsg=st.sampled_from([32635, 3035, 2100]), seed=st.integers(0, 99))
def test_codes_out_are_codes_in_and_aligning_again_changes_nothing(folder, dx, dy, cell, epsg, seed):
    codes = patches(60, 80, [0, 1, 2, 3], seed=seed, size=2)
    transform = square(cell, (NORTH_WEST[0] + dx, NORTH_WEST[1] + dy))
    dem = write(folder / "d.tif", relief(60, 60))
    once = lay(dem, write(folder / "v.tif", codes, transform=transform), crs=epsg)
    assert set(np.unique(once["vegetation"])) <= {0, 1, 2, 3}
    low, high = relief(60, 60).min(), relief(60, 60).max()
    assert low - 1e-3 <= float(once["elevation"].min()) <= float(once["elevation"].max()) <= high + 1e-3
    again = read_landscape(once["elevation"], once["vegetation"], once["density"])
    assert again.equals(once)
    assert all("copied" in told(again, name) for name in FULL[:3])


def mirrored(transform, shape):
    """The transform of the raster turned east-west about x = NORTH_WEST[0] + 600."""
    right = transform.c + transform.a * shape[1]
    return Affine(transform.a, 0, 2 * (NORTH_WEST[0] + 600) - right, 0, transform.e, transform.f)


@settings(max_examples=15, deadline=None)
@given(dx=OFFSET, dy=OFFSET, cell=st.sampled_from([9.7, 17.1, 26.1]), resolution=st.sampled_from([20.0, 50.0]))
def test_mirrored_layers_give_the_mirrored_landscape(folder, dx, dy, cell, resolution):
    codes, values = patches(60, 80, [1, 2, 3], size=4), relief(70, 60)
    ground = square(cell, (NORTH_WEST[0] + dx, NORTH_WEST[1] + dy))
    relief_at = square(24.7, (NORTH_WEST[0] - 101.3, NORTH_WEST[1] + 31.7))
    like = Grid(
        (30, 31),
        square(resolution, (NORTH_WEST[0] + 600 - 15.5 * resolution, NORTH_WEST[1] - 10)),
        parse_crs(UTM),
    )
    results = []
    for flip in (False, True):
        dem = write(
            folder / "md.tif",
            values[:, ::-1] if flip else values,
            transform=mirrored(relief_at, values.shape) if flip else relief_at,
        )
        vegetation = write(
            folder / "mv.tif",
            codes[:, ::-1] if flip else codes,
            transform=mirrored(ground, codes.shape) if flip else ground,
        )
        results.append(lay(dem, vegetation, like=like))
    one, other = (result["vegetation"].to_numpy() for result in results)
    np.testing.assert_allclose(results[0]["elevation"], results[1]["elevation"].to_numpy()[:, ::-1], atol=1e-2)
    np.testing.assert_array_equal(one, other[:, ::-1])


@settings(max_examples=15, deadline=None)
@given(
    row=st.integers(0, 30),
    col=st.integers(0, 30),
    rows=st.integers(3, 25),
    cols=st.integers(3, 25),
    resolution=st.sampled_from([15.0, 20.0, 70.0]),
)
def test_a_part_is_the_part_of_the_whole(folder, row, col, rows, cols, resolution):
    """Tiles do not matter: reading and warping only a window gives the same cells."""
    dem = write(
        folder / "td.tif",
        relief(300, 300),
        transform=Affine(0.0003, 0, 27.95, 0, -0.0003, 36.15),
        crs="EPSG:4326",
    )
    codes = patches(300, 300, [1, 2, 3], size=2)
    vegetation = write(
        folder / "tv.tif", codes, transform=Affine(0.0003, 0, 27.9502, 0, -0.0003, 36.1498), crs="EPSG:4326"
    )
    corner = (588_000.0, 3_997_000.0)
    whole_grid = Grid((60, 60), square(resolution, corner), parse_crs(UTM))
    part_grid = Grid(
        (rows, cols),
        square(resolution, (corner[0] + col * resolution, corner[1] - row * resolution)),
        parse_crs(UTM),
    )
    whole, part = lay(dem, vegetation, like=whole_grid), lay(dem, vegetation, like=part_grid)
    cut = whole.isel(y=slice(row, row + rows), x=slice(col, col + cols))
    np.testing.assert_array_equal(part["vegetation"], cut["vegetation"])
    np.testing.assert_allclose(part["elevation"], cut["elevation"], atol=1e-3)


def test_copying_is_what_warping_would_give(tmp_path, monkeypatch):
    dem, vegetation, density = three(tmp_path)
    copied = read_landscape(dem, vegetation, density)
    monkeypatch.setattr(alignment, "_fit", lambda *anything: None)
    warped = read_landscape(dem, vegetation, density)
    assert "nearest" in told(warped, "vegetation")
    np.testing.assert_array_equal(copied["vegetation"], warped["vegetation"])
    np.testing.assert_array_equal(copied["density"], warped["density"])
    np.testing.assert_allclose(copied["elevation"], warped["elevation"], atol=1e-4)


def test_only_the_window_is_counted_as_memory(tmp_path):
    dem = read_header(write(tmp_path / "d.tif", relief(400, 400)))
    part = Grid((10, 10), square(), parse_crs(UTM))
    whole = Grid((400, 400), square(), parse_crs(UTM))
    assert memory_needed({"elevation": dem}, part) * 100 < memory_needed({"elevation": dem}, whole)


def test_cells_are_measured_on_the_ground(tmp_path):
    header = read_header(
        write(tmp_path / "d.tif", relief(9, 9), transform=Affine(0.001, 0, 27, 0, -0.001, 36), crs="EPSG:4326")
    )
    x, y = Transformer.from_crs(4326, UTM, always_xy=True).transform(27.0, 36.0)
    width, height = target_grid.cell_in(header, CRS(UTM), x, y)
    # One thousandth of a degree on the WGS 84 ellipsoid at 36 degrees north, times the scale 0.9996 of UTM.
    assert width == pytest.approx(90.163 * 0.9996, abs=0.01)
    assert height == pytest.approx(110.957 * 0.9996, abs=0.01)


@pytest.mark.parametrize(("transform", "more"), [(square(), {}), (square(19.0), {}), (square(), {"resolution": 60})])
def test_the_memory_is_estimated_from_the_headers(tmp_path, transform, more):
    dem = write(tmp_path / "d.tif", relief(700, 700))
    vegetation = write(tmp_path / "v.tif", patches(700, 700, [1, 2, 3]), transform=transform)
    density = write(tmp_path / "c.tif", patches(700, 700, [1, 2, 3]), transform=transform)
    lay(dem, vegetation, density, **more)  # what is imported and cached at first use is not the work's
    tracemalloc.start()
    data = lay(dem, vegetation, density, **more)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    names = {"elevation": dem, "vegetation": vegetation, "density": density}
    layers = {name: read_header(path) for name, path in names.items()}
    assert 1 / 1.5 < memory_needed(layers, Grid.of(data)) / peak < 1.5
