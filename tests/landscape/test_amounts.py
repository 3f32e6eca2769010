"""Amounts keep their sum whatever the cells; what is missing is said, and never free."""

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.amounts import cost_per_hectare, value_at_risk
from firebreak_gis.landscape.stake_layers import StakesRequest
from firebreak_gis.landscape.target_grid import Account
from tests.places import NORTH_WEST, UTM, square, write

GRID = Grid((40, 60), square(), parse_crs(UTM))
LEFT, TOP = NORTH_WEST
FUEL = np.ones(GRID.shape, bool)


def drawn(*shapes, **columns):
    placed = [
        shapely.transform(s, lambda p: np.column_stack((LEFT + 20 * p[:, 0], TOP - 20 * p[:, 1]))) for s in shapes
    ]
    return gpd.GeoDataFrame(columns, geometry=placed, crs=UTM)


@pytest.mark.parametrize("cell", [4, 10, 20, 25, 33, 50, 100, 400])
def test_people_in_cells_of_any_size_stay_as_many(tmp_path, cell):
    rows, cols = -(-800 // cell), -(-1200 // cell)
    people = np.random.default_rng(cell).integers(0, 50, (rows + 4, cols + 4)).astype("float32")
    people[:2], people[-2:], people[:, :2], people[:, -2:] = 0, 0, 0, 0
    # Nobody lives at the edge, so all are inside the grid.
    people[2 + 800 // cell :], people[:, 2 + 1200 // cell :] = 0, 0
    path = write(tmp_path / "p.tif", people, transform=Affine(cell, 0, LEFT - 2 * cell, 0, -cell, TOP + 2 * cell))
    account = Account()
    plane = value_at_risk(path, GRID, account=account)
    assert plane.sum() == pytest.approx(people.sum(), rel=1e-12)
    if 100 % cell == 0 and cell < 100:  # blocks of 100 m have exactly their own
        own = (
            people[2 : 2 + 800 // cell, 2 : 2 + 1200 // cell].reshape(8, 100 // cell, 12, 100 // cell).sum(axis=(1, 3))
        )
        np.testing.assert_allclose(plane.reshape(8, 5, 12, 5).sum(axis=(1, 3)), own, rtol=1e-9)
    if cell == 100:
        np.testing.assert_allclose(plane, np.kron(people[2:10, 2:14], np.full((5, 5), 1 / 25)), rtol=1e-6)
    assert any(f"{people.sum():,.10g} in all on the landscape" in text for text in account.alignment)


def test_people_of_another_crs_stay_as_many(tmp_path):
    degrees = Affine(1 / 1200, 0, 27.95, 0, -1 / 1200, 36.15)
    people = np.zeros((60, 60), "float32")
    people[20:26, 20:28] = np.random.default_rng(0).integers(1, 90, (6, 8))
    path = write(tmp_path / "world.tif", people, transform=degrees, crs="EPSG:4326")
    for cell, rows in ((10.0, 1200), (30.0, 400), (300.0, 40)):
        grid = Grid((rows, rows), square(cell, (584_000.0, 4_003_500.0)), parse_crs(UTM))
        assert value_at_risk(path, grid).sum() == pytest.approx(people.sum(), rel=1e-12)


def test_cells_far_larger_than_the_landscape_give_it_its_share(tmp_path):
    path = write(
        tmp_path / "big.tif", np.full((3, 3), 1e6, "float32"), transform=square(100_000.0, (LEFT - 1.4e5, TOP + 1.3e5))
    )
    share = 40 * 60 * 400 / 1e10
    assert value_at_risk(path, GRID).sum() == pytest.approx(1e6 * share, rel=1e-9)


def test_densities_are_so_much_a_hectare(tmp_path):
    for cell in (5, 20, 70):
        path = write(tmp_path / f"{cell}.tif", np.full((900 // cell, 1300 // cell), 3.0), transform=square(float(cell)))
        plane = value_at_risk(path, GRID, values_as="density")
        np.testing.assert_allclose(plane, 3.0 * 0.04, rtol=1e-6)
    area = drawn(shapely.box(1.5, 2, 4, 4.25), n=[10.0])
    plane = value_at_risk(area, GRID, field="n", values_as="density")
    assert plane.sum() == pytest.approx(10 * 2.5 * 2.25 * 0.04)
    assert plane[2, 1] == pytest.approx(10 * 0.5 * 0.04)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10**6))
def test_what_polygons_and_points_hold_is_kept(seed):
    rng = np.random.default_rng(seed)
    shapes, people = [], []
    for _ in range(rng.integers(1, 12)):
        x, y = rng.uniform(3, 55), rng.uniform(3, 35)
        size = rng.choice([0.0, 0.001, 0.1, 2.9])
        shapes.append(shapely.Point(x, y).buffer(size) if size else shapely.Point(x, y))
        people.append(int(rng.integers(0, 1000)))
    plane = value_at_risk(drawn(*shapes, people=people), GRID, field="people")
    assert plane.sum() == pytest.approx(sum(people), rel=1e-12)
    assert (plane >= 0).all()


def test_half_a_polygon_outside_leaves_half_of_its_amount_there():
    account = Account()
    frame = drawn(shapely.box(-2, 5, 2, 9), shapely.box(90, 90, 91, 91), people=[100, 7])
    assert value_at_risk(frame, GRID, field="people", account=account).sum() == pytest.approx(50)
    assert any("of 107 in the file; 1 of 2 features lie outside" in text for text in account.alignment)


def test_overlapping_polygons_add_up_and_without_a_column_each_counts_one():
    frame = drawn(shapely.box(5, 5, 6, 6), shapely.box(5, 5, 6, 6), shapely.Point(5.5, 5.5), people=[3, 4, 5])
    assert value_at_risk(frame, GRID, field="people")[5, 5] == 12
    assert value_at_risk(frame, GRID)[5, 5] == 3


def test_what_makes_no_sense_is_refused(tmp_path):
    points = drawn(shapely.Point(5, 5), people=[3])
    with pytest.raises(InputError, match="a point has no hectares"):
        value_at_risk(points, GRID, field="people", values_as="density")
    with pytest.raises(ParameterError, match="has no field 'persons'; it has: people"):
        value_at_risk(points, GRID, field="persons")
    with pytest.raises(ParameterError, match="expected amount or density"):
        value_at_risk(points, GRID, values_as="total")
    for wrong in (None, "many", np.inf):
        with pytest.raises(InputError, match="in 1 of 1 features, expected numbers"):
            value_at_risk(drawn(shapely.Point(5, 5), people=[wrong]), GRID, field="people")
    for source in (
        drawn(shapely.Point(500, 5)),
        write(tmp_path / "f.tif", np.ones((3, 3)), transform=square(20.0, (9e5, 1e6))),
    ):
        with pytest.raises(InputError, match="landscape"):
            value_at_risk(source, GRID)


def test_gaps_in_values_count_as_nothing_and_are_said(tmp_path):
    values = np.ones((40, 60), "float32")
    values[:, :15] = -9999
    path = write(tmp_path / "v.tif", values, nodata=-9999)
    for kind, total in (("amount", 1800), ("density", 72)):
        account = Account()
        plane = value_at_risk(path, GRID, values_as=kind, account=account)
        assert plane.sum() == pytest.approx(total)
        assert any("no data on 600 cells (24 ha), counted as 0" in text for text in account.alignment)


def half_priced(folder):
    """No cost is known west of column 30: as a raster, and as polygons."""
    cost = np.full((40, 60), 1000, "float32")
    cost[:, :30] = -9999
    return write(folder / "c.tif", cost, nodata=-9999), drawn(shapely.box(30, 0, 60, 40), c=[1000.0])


def test_where_no_cost_is_known_nothing_is_cut_unless_its_cost_is_said(tmp_path):
    raster, polygons = half_priced(tmp_path)
    polygons.to_file(tmp_path / "c.gpkg")
    for source, field in ((str(raster), None), (str(tmp_path / "c.gpkg"), "c")):
        plane = cost_per_hectare(source, GRID, field=field)
        assert np.isnan(plane[:, :30]).all()
        assert (plane[:, 30:] == 1000).all()
        account = Account()
        planes = StakesRequest(cost=source, cost_field=field).read(GRID, fuel=FUEL, account=account)
        assert planes.unpriced[:, :30].all()
        assert not planes.unpriced[:, 30:].any()
        assert any(
            "cost is not known on 1200 cells with fuel (48 ha), where nothing is cut" in w for w in account.warnings
        )
        with pytest.raises(InputError, match="refused by --strict"):
            StakesRequest(cost=source, cost_field=field).read(GRID, fuel=FUEL, account=Account(strict=True))
        told = StakesRequest(cost=source, cost_field=field, cost_default=250).read(GRID, fuel=FUEL)
        assert told.unpriced is None
        np.testing.assert_allclose(told.cost[:, :30], 250 * 0.04)
        east = np.zeros(GRID.shape, bool)
        east[:, 30:] = True
        assert (
            StakesRequest(cost=source, cost_field=field).read(GRID, fuel=east).unpriced is None
        )  # the sea in the west
        with pytest.raises(InputError, match="cost is known on no cell"):
            StakesRequest(cost=source, cost_field=field).read(GRID, fuel=~east)


def test_cost_polygons_need_their_column_and_none_vanishes(tmp_path):
    frame = drawn(
        shapely.box(0, 0, 60, 40), shapely.box(4.1, 4.1, 4.3, 4.3), shapely.box(10, 10, 12, 12), c=[5.0, 9, 7]
    )
    with pytest.raises(ParameterError, match="--cost-field"):
        cost_per_hectare(frame, GRID)
    account = Account()
    plane = cost_per_hectare(frame, GRID, field="c", account=account)
    assert (plane[10:12, 10:12] == 7).all()  # the last one counts
    assert plane[4, 4] == 5
    assert any("1 of 3 polygons hold no centre of a cell" in text for text in account.warnings)
    for wrong in (-1, np.nan, np.inf):
        with pytest.raises(ParameterError, match="expected a number of at least 0"):
            cost_per_hectare(frame, GRID, field="c", default=wrong)


def test_one_cost_for_all_and_columns_of_rasters(tmp_path):
    planes = StakesRequest(cost_default=500).read(GRID, fuel=FUEL)
    np.testing.assert_allclose(planes.cost, 20.0)
    path = write(tmp_path / "r.tif", np.ones((40, 60)))
    with pytest.raises(ParameterError, match=r"is a raster and has no columns; leave --cost-field out"):
        cost_per_hectare(path, GRID, field="c")
    with pytest.raises(ParameterError, match=r"is a raster and has no columns; leave --values-field out"):
        value_at_risk(path, GRID, field="c")


def test_value_where_nothing_burns_is_told(tmp_path):
    frame = drawn(shapely.box(0, 0, 10, 4), people=[100])
    frame.to_file(tmp_path / "v.gpkg")
    bare = FUEL.copy()
    bare[:2] = False
    account = Account()
    StakesRequest(values=str(tmp_path / "v.gpkg"), values_field="people").read(GRID, fuel=bare, account=account)
    assert any("50 of it (50 %) lie on cells without fuel" in text for text in account.alignment)
