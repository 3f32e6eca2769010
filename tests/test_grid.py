"""The grid as a value: coordinates, comparison, reading from xarray."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from affine import Affine
from hypothesis import given
from hypothesis import strategies as st

from firebreak_gis.errors import CRSError, GridError
from firebreak_gis.grid import UNREFERENCED, Grid, crs_name, parse_crs

UTM = parse_crs("EPSG:32635")
GRID = Grid((5, 8), Affine(20, 0, 586_440, 0, -20, 3_999_900), UTM)


def test_centres_and_bounds():
    assert GRID.bounds == (586_440, 3_999_800, 586_600, 3_999_900)
    assert GRID.x.tolist() == [586_450 + 20 * k for k in range(8)]
    assert GRID.y.tolist() == [3_999_890 - 20 * k for k in range(5)]
    assert GRID.cell_size == 20
    assert GRID.cell_area_ha == pytest.approx(0.04)


@given(row=st.integers(-2, 6), col=st.integers(-2, 9), u=st.floats(0.01, 0.99), v=st.floats(0.01, 0.99))
def test_a_point_lies_in_its_cell(row, col, u, v):
    x, y = GRID.transform @ (col + u, row + v)
    (got,) = GRID.cells_of(np.array([x]), np.array([y]))
    inside = 0 <= row < 5 and 0 <= col < 8
    assert got == (row * 8 + col if inside else -1)


def test_points_that_are_nowhere():
    x = np.array([np.nan, np.inf, 586_450])
    y = np.array([3_999_890, 3_999_890, -np.inf])
    assert GRID.cells_of(x, y).tolist() == [-1, -1, -1]
    assert GRID.cells_of(GRID.x[[0]], GRID.y[[0]]).dtype == np.int64


@pytest.mark.parametrize("share", [0.0, 5e-4, 2e-3, 0.5])
def test_small_shifts_are_the_same_grid(share):
    moved = Grid(GRID.shape, GRID.transform @ Affine.translation(share, -share), UTM)
    assert GRID.matches(moved) == (share < 1e-3)
    assert moved.matches(GRID) == GRID.matches(moved)


def test_cells_that_grow_part_from_the_grid():
    """A cell size wrong by little adds up over the columns."""
    wide = Grid((5, 8000), GRID.transform, UTM)
    stretched = Grid((5, 8000), GRID.transform @ Affine.scale(1 + 1e-6, 1), UTM)
    assert not wide.matches(stretched)
    assert GRID.matches(Grid(GRID.shape, stretched.transform, UTM))


def test_require_tells_both_grids():
    other = Grid((5, 9), GRID.transform, parse_crs("EPSG:32634"))
    with pytest.raises(GridError) as caught:
        GRID.require(other, "the mask")
    for word in ("the mask", "5 x 8", "5 x 9", "EPSG:32635", "EPSG:32634"):
        assert word in str(caught.value)
    assert not GRID.matches(Grid(GRID.shape, GRID.transform))


def test_oblong_cells_and_units_are_refused():
    with pytest.raises(GridError, match="20 x 25"):
        _ = Grid((5, 8), Affine(20, 0, 0, 0, -25, 0)).cell_size
    for code in ("EPSG:4326", "EPSG:2263"):
        with pytest.raises(CRSError, match=code):
            _ = Grid((5, 8), GRID.transform, parse_crs(code)).cell_area_ha
    with pytest.raises(CRSError, match="cannot read"):
        parse_crs("somewhere")


@pytest.mark.parametrize("crs", [UTM, parse_crs("EPSG:4326")])
@pytest.mark.parametrize("shape", [(5, 8), (1, 8), (5, 1), (1, 1)])
def test_grid_of_an_array_is_the_grid(crs, shape):
    grid = Grid(shape, Affine(0.1, 0, 27.3, 0, -0.1, 36.7), crs)
    data = grid.dataarray(np.zeros(shape), "elevation")
    assert Grid.of(data) == grid
    assert Grid.of(xr.Dataset({"elevation": data})) == grid
    assert Grid.of(grid.dataarray(np.zeros((8, *shape)), "spread_probability")) == grid
    assert (data["y"].attrs["units"] == "degrees_north") == crs.is_geographic


@pytest.mark.parametrize("shape", [(5, 8), (1, 8), (5, 1)])
def test_grid_without_crs_comes_from_the_coordinates(shape):
    grid = Grid(shape, Affine(0.1, 0, 27.3, 0, -0.1, 36.7))
    assert Grid.of(grid.dataarray(np.zeros(shape), "elevation")).matches(grid)


def test_a_selection_moves_the_grid():
    data = GRID.dataarray(np.arange(40.0).reshape(5, 8), "elevation")
    part = Grid.of(data[1:4, 2:7])
    assert part.shape == (3, 5)
    assert part.transform == GRID.transform @ Affine.translation(2, 1)
    coarse = Grid.of(data.coarsen(y=2, x=2, boundary="trim").mean())
    assert coarse.transform.almost_equals(GRID.transform @ Affine.scale(2))


def test_arrays_that_are_no_grid():
    data = GRID.dataarray(np.zeros((5, 8)), "elevation")
    for wrong in (data.T, data.rename(x="lon"), data[0], data.expand_dims("time", -1)):
        with pytest.raises(GridError, match="dimensions"):
            Grid.of(wrong)
    with pytest.raises(GridError, match="north-up"):
        Grid.of(data[::-1])
    with pytest.raises(GridError, match="evenly"):
        Grid.of(data[:, [0, 1, 2, 4]])
    with pytest.raises(GridError, match="shape"):
        GRID.dataarray(np.zeros((8, 5)), "elevation")
    assert Grid.of(xr.DataArray(np.zeros((2, 3)), dims=("y", "x"))).transform == UNREFERENCED


@pytest.mark.filterwarnings("ignore:Use `@` matmul:PendingDeprecationWarning")
def test_rioxarray_reads_the_same_grid():
    import rioxarray  # noqa: F401 - gives arrays the accessor

    data = GRID.dataarray(np.zeros(GRID.shape), "elevation")
    assert data.rio.crs.to_epsg() == 32635
    assert data.rio.transform() == GRID.transform
    assert data.rio.bounds() == GRID.bounds


def test_names_of_systems():
    assert crs_name(UTM) == "EPSG:32635"
    own = parse_crs("+proj=tmerc +lat_0=36 +lon_0=28 +units=m +type=crs")
    assert crs_name(own) == own.name
