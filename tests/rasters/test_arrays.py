"""Arrays in memory as other programs hold them: their dims, grid mappings and orders give the same layer."""

import numpy as np
import pytest
import xarray as xr
from pyproj import CRS

from firebreak_gis.errors import CRSError, GridError, InputError
from firebreak_gis.grid import Grid, parse_crs, with_y_and_x
from firebreak_gis.landscape import read_landscape
from firebreak_gis.rasters import header_of_array, read_cells
from tests.places import UTM, relief, square, write

ROWS, COLS = 24, 31
GRID = Grid((ROWS, COLS), square(), parse_crs(UTM))
CODES = np.full((ROWS, COLS), 2, np.uint8)


def plain():
    return GRID.dataarray(relief(ROWS, COLS), "elevation")


def bare(dims=("y", "x"), **coords):
    """The same without any CRS."""
    return xr.DataArray(relief(ROWS, COLS), dims=dims, coords={dims[0]: GRID.y, dims[1]: GRID.x, **coords})


def mapped(name, attrs, where):
    data = bare()
    data = data.assign_coords({name: xr.Variable((), 0, attrs)})
    if where == "attrs":
        data.attrs["grid_mapping"] = name
    if where == "encoding":
        data.encoding["grid_mapping"] = f"{name}: x y"
    return data


CF = CRS(UTM).to_cf()
WITHOUT_TEXT = {key: value for key, value in CF.items() if key != "crs_wkt"}


@pytest.mark.parametrize("name", ["crs", "transverse_mercator", "spatial_ref"])
@pytest.mark.parametrize("where", ["attrs", "encoding", "nowhere"])
@pytest.mark.parametrize("attrs", [CF, {"spatial_ref": CRS(UTM).to_wkt()}, WITHOUT_TEXT], ids=["cf", "text", "no text"])
def test_a_crs_is_found_under_any_grid_mapping(name, where, attrs):
    found = Grid.of(mapped(name, attrs, where))
    expected = CRS.from_cf(WITHOUT_TEXT) if attrs is WITHOUT_TEXT else GRID.crs
    assert found.crs.equals(expected)
    assert found.crs.coordinate_operation == GRID.crs.coordinate_operation
    assert found.transform.almost_equals(GRID.transform, precision=1e-6)


def test_the_mapping_that_the_data_name_wins_and_a_broken_one_is_refused():
    data = mapped("crs", CF, "attrs").assign_coords(other=xr.Variable((), 0, CRS("EPSG:32601").to_cf()))
    assert Grid.of(data).crs == GRID.crs
    with pytest.raises(CRSError, match="grid mapping 'nonsense'"):
        Grid.of(mapped("crs", {"grid_mapping_name": "nonsense"}, "attrs"))


def test_a_dataset_tells_its_crs_by_a_variable_too():
    data = bare().to_dataset(name="a").assign(crs=xr.Variable((), 0, CF))
    assert Grid.of(data).crs == GRID.crs


ORDERS = {
    "south-up": lambda a: a.isel(y=slice(None, None, -1)),
    "east first": lambda a: a.isel(x=slice(None, None, -1)),
    "both": lambda a: a.isel(y=slice(None, None, -1), x=slice(None, None, -1)),
    "transposed": lambda a: a.transpose("x", "y"),
    "one time": lambda a: a.expand_dims(time=1),
    "northing": lambda a: a.rename(y="northing", x="easting"),
    "upper case": lambda a: a.rename(y="Y", x="X"),
    "named by axis": lambda a: a.rename(y="south_north", x="west_east"),
}


@pytest.mark.parametrize("order", ORDERS)
def test_dims_and_orders_of_other_programs(order):
    given = plain()
    header = header_of_array(ORDERS[order](given))
    assert header.grid.matches(GRID)
    np.testing.assert_array_equal(read_cells(header).values, given.to_numpy())
    assert header.notes == ()


@pytest.mark.parametrize("dims", [("lat", "lon"), ("latitude", "longitude"), ("south_north", "west_east")])
@pytest.mark.parametrize("rising", [False, True])
def test_latitudes_and_longitudes_are_of_wgs_84_unless_they_say_more(dims, rising):
    step = 0.0002
    lat, lon = 36.14 - step * np.arange(ROWS), 27.96 + step * np.arange(COLS)
    data = xr.DataArray(relief(ROWS, COLS), dims=dims, coords={dims[0]: lat, dims[1]: lon})
    if dims[0] == "south_north":
        data["south_north"].attrs["units"], data["west_east"].attrs["units"] = "degrees_north", "degrees_east"
        data["south_north"].attrs["axis"], data["west_east"].attrs["axis"] = "Y", "X"
    given = data.isel({dims[0]: slice(None, None, -1)}) if rising else data
    header = header_of_array(given)
    assert header.crs.to_epsg() == 4326
    assert "WGS 84" in header.notes[0]
    np.testing.assert_array_equal(read_cells(header).values, data.to_numpy())
    np.testing.assert_allclose(
        header.bounds, (lon[0] - step / 2, lat[-1] - step / 2, lon[-1] + step / 2, lat[0] + step / 2)
    )
    other = given.assign_coords(crs=xr.Variable((), 0, CRS("EPSG:4258").to_cf()))
    assert header_of_array(other).crs.to_epsg() == 4258
    assert not header_of_array(other).notes


def test_metres_without_a_crs_are_not_guessed():
    assert header_of_array(bare()).crs is None
    assert header_of_array(bare(("northing", "easting"))).crs is None
    with pytest.raises(CRSError, match="has no coordinate reference system"):
        read_landscape(bare(), CODES, "normal")


def test_unknown_dims_are_left_alone():
    data = xr.DataArray(np.zeros((3, 4)), dims=("row", "col"))
    assert with_y_and_x(data) is data
    with pytest.raises(InputError, match="has dimensions"):
        header_of_array(data)


def test_plain_arrays_lie_where_the_elevation_does_or_like(tmp_path):
    dem = write(tmp_path / "d.tif", relief(ROWS, COLS))
    expected = read_landscape(dem, write(tmp_path / "v.tif", CODES), "normal")
    for elevation, like in ((dem, None), (plain(), None), (relief(ROWS, COLS), GRID), (relief(ROWS, COLS), dem)):
        got = read_landscape(elevation, CODES, np.full((ROWS, COLS), 2, np.uint8), like=like)
        for name in ("elevation", "vegetation", "density"):
            np.testing.assert_array_equal(got[name], expected[name])
    with pytest.raises(InputError, match=r"elevation is a plain array.*like="):
        read_landscape(relief(ROWS, COLS), CODES, "normal")
    with pytest.raises(GridError, match="vegetation has shape"):
        read_landscape(dem, CODES[1:], "normal")
