"""Where fires start: random cells, points of any kind, probability rasters, refusals."""

import geopandas as gpd
import numpy as np
import pytest
from affine import Affine
from scipy import stats
from shapely.geometry import LineString, MultiPoint, MultiPolygon, Point, box

from firebreak_gis import SpreadNetwork, simulate, write_vector
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import NEVER
from firebreak_gis.simulation.ignitions import ignition_places, resolve_ignitions
from firebreak_gis.simulation.products import Products
from tests.places import write

UTM = {"crs": "EPSG:32635", "transform": Affine(20, 0, 586_440, 0, -20, 3_999_900)}


@pytest.fixture
def network():
    fuel = np.ones((8, 11), bool)
    fuel[2, 3:6] = False
    return SpreadNetwork(np.full((8, 8, 11), 0.4), burnable=fuel, **UTM)


def centre(network, row, col):
    return network.grid.x[col], network.grid.y[row]


def test_random_ignitions_are_uniform_over_fuel_and_the_same_for_any_number(network):
    cells = resolve_ignitions(network, n_runs=20_000, seed=1).cells
    count = np.bincount(cells, minlength=88)
    assert count[~network.burnable.ravel()].sum() == 0
    assert stats.chisquare(count[network.burnable.ravel()]).pvalue > 1e-3
    assert (resolve_ignitions(network, n_runs=50, seed=1).cells == cells[:50]).all()
    assert (resolve_ignitions(network, n_runs=50, seed=2).cells != cells[:50]).any()


def test_raster_is_drawn_in_proportion(network):
    weights = np.random.default_rng(0).random(network.shape)
    weights[0] = 0
    weights[2, 4] = np.nan  # no fuel there
    cells = resolve_ignitions(network, weights, n_runs=30_000, seed=4).cells
    expected = np.where(network.burnable, np.nan_to_num(weights), 0).ravel()
    count = np.bincount(cells, minlength=88)
    assert count[expected == 0].sum() == 0
    used = expected > 0
    assert stats.chisquare(count[used], expected[used] / expected.sum() * 30_000).pvalue > 1e-3
    as_data = resolve_ignitions(network, network.grid.dataarray(weights, "burn_frequency"), n_runs=50, seed=4)
    assert (as_data.cells == cells[:50]).all()


def test_points_of_every_kind_give_the_same_fires(network, tmp_path):
    places = [(1, 1), (6, 9), (4, 0)]
    points = [centre(network, *place) for place in places]
    frame = gpd.GeoDataFrame(geometry=[Point(p) for p in points], crs="EPSG:32635")
    path = tmp_path / "starts.gpkg"
    write_vector(path, frame.to_crs("EPSG:4326"))
    several = gpd.GeoDataFrame(geometry=[MultiPoint(points)], crs="EPSG:32635")
    expected = np.array([r * 11 + c for r, c in places])
    for source in (points, frame, frame.to_crs("EPSG:4326"), frame.geometry, path, str(path), several):
        each = resolve_ignitions(network, source, n_runs=7, seed=0)
        assert sorted(each.cells[:3]) == sorted(expected)
        assert (each.cells == each.cells[np.arange(7) % 3]).all()
        together = resolve_ignitions(network, source, mode="all", n_runs=2, seed=0)
        assert together.starts.tolist() == [0, 3, 6]
        assert (together.cells == np.tile(expected, 2)).all()
    one = resolve_ignitions(network, points[0], n_runs=2, seed=0)
    assert (one.cells == expected[0]).all()


def test_points_that_cannot_burn_are_named(network):
    with pytest.raises(InputError, match=r"point 2 .* without fuel \(row 2, col 4\)"):
        resolve_ignitions(network, [centre(network, 0, 0), centre(network, 2, 4)], n_runs=5, seed=0)
    with pytest.raises(InputError, match=r"point 1 .* outside the grid"):
        resolve_ignitions(network, [(0.0, 0.0)], n_runs=5, seed=0)
    with pytest.raises(InputError, match="and 3 more"):
        resolve_ignitions(network, [(float(i), 0.0) for i in range(8)], n_runs=5, seed=0)


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"n_runs": 0}, ParameterError),
        ({"n_runs": 1.5}, ParameterError),
        ({"n_runs": True}, ParameterError),
        ({"mode": "some"}, ParameterError),
        ({"ignitions": np.zeros((8, 11))}, InputError),
        ({"ignitions": np.full((8, 11), -1.0)}, InputError),
        ({"ignitions": np.full((8, 11), np.nan)}, InputError),
        ({"ignitions": np.full((8, 11), np.inf)}, InputError),
        ({"ignitions": np.full((8, 11), "a")}, InputError),
        ({"ignitions": [1.0, 2.0, 3.0]}, ParameterError),
        ({"ignitions": "nowhere.gpkg"}, InputError),
    ],
)
def test_impossible_requests_are_refused(network, arguments, error):
    given = {"ignitions": None, "mode": "each", "n_runs": 3, "seed": 0} | arguments
    with pytest.raises(error):
        resolve_ignitions(network, given.pop("ignitions"), **given)


def test_nothing_to_burn_is_said():
    with pytest.raises(InputError, match="no cell of the network holds fuel"):
        simulate(SpreadNetwork(np.zeros((8, 3, 4))))


def test_ignition_on_a_break_burns_nothing(network):
    cut = np.zeros(network.shape)
    cut[1, 1] = 1
    start = [centre(network, 1, 1)]
    assert (simulate(network, breaks=cut, ignitions=start, n_runs=10)["fire_size"] == 0).all()
    leaky = simulate(network, breaks=cut, residual=0.5, ignitions=start, n_runs=10)["fire_size"]
    assert (leaky >= 1).all()


def test_few_runs_start_all_over_the_map():
    """Points in the order of the file, west to east: with fewer runs than points the east never burnt."""
    network = SpreadNetwork(np.full((8, 4, 1000), 0.1), **UTM)
    points = [centre(network, 1, col) for col in range(1000)]
    cells = resolve_ignitions(network, points, n_runs=50, seed=3).cells
    assert np.unique(cells).size == 50
    assert stats.kstest(cells % 1000 / 1000.0, "uniform").pvalue > 1e-3
    # Run i is the same for any number of runs, and every point has its turn.
    longer = resolve_ignitions(network, points, n_runs=1700, seed=3).cells
    assert (longer[:50] == cells).all()
    assert (resolve_ignitions(network, points, n_runs=20, first_run=30, seed=3).cells == cells[30:]).all()
    assert np.unique(longer[:1000]).size == 1000
    assert (longer[1000:] == longer[:700]).all()
    assert (resolve_ignitions(network, points, n_runs=50, seed=4).cells != cells).any()


def test_weights_of_any_size_stay_on_the_grid(network):
    weights = np.random.default_rng(2).random(network.shape)
    expected = resolve_ignitions(network, weights, n_runs=500, seed=1).cells
    for exponent in (-1070, -300, 60, 1000):
        with np.errstate(under="ignore"):
            scaled = np.ldexp(weights, exponent)
        cells = resolve_ignitions(network, scaled, n_runs=500, seed=1).cells
        assert (cells == expected).mean() > (0.9 if exponent < -1000 else 1 - 1e-9)  # few digits are left there
    for tiny in (5e-324, 1e-310):
        cells = resolve_ignitions(network, np.full(network.shape, tiny), n_runs=500, seed=1).cells
        assert network.burnable.ravel()[cells].all()
    with pytest.raises(InputError, match="its sum is infinite"):
        resolve_ignitions(network, np.full(network.shape, 1e308), n_runs=500, seed=1)


def test_places_that_cannot_burn_are_left_out_when_asked(network, tmp_path):
    kept = [centre(network, 1, 1), centre(network, 6, 9)]
    points = [kept[0], (0.0, 0.0), centre(network, 2, 4), kept[1], (1.0, 1.0)]
    with pytest.raises(InputError, match="--ignitions-outside drop"):
        ignition_places(network, points)
    places = ignition_places(network, points, outside="drop")
    assert places.cells.tolist() == [12, 75]
    assert places.notes == ("ignitions: 3 of 5 were left out, 2 outside the grid and 1 on cells without fuel",)
    frame = gpd.GeoDataFrame(geometry=[Point(p) for p in points], crs="EPSG:32635")
    assert ignition_places(network, frame, outside="drop").cells.tolist() == [12, 75]
    fires = simulate(network, ignitions=places, n_runs=9, seed=2)
    assert fires.identical(simulate(network, ignitions=kept, n_runs=9, seed=2))
    with pytest.raises(InputError, match="none is left"):
        ignition_places(network, [(0.0, 0.0)], outside="drop")
    with pytest.raises(ParameterError, match="refuse"):
        ignition_places(network, points, outside="ignore")


def test_a_polygon_is_the_perimeter_of_a_fire(network, tmp_path):
    """Every cell with fuel that it cuts burns from the start; one feature is one fire, however many its parts."""
    left, _, _, top = network.grid.bounds

    def area(row, col, rows, cols):
        return box(left + 20 * col, top - 20 * (row + rows), left + 20 * (col + cols), top - 20 * row)

    one = area(1.5, 2.5, 2, 2)  # cuts rows 1 to 3 and columns 2 to 4, of which (2, 3) and (2, 4) hold no fuel
    two = MultiPolygon([area(6, 0, 1, 1), area(7.2, 8.2, 0.1, 0.1)])
    frame = gpd.GeoDataFrame(geometry=[one, two, Point(centre(network, 5, 5))], crs="EPSG:32635")
    path = tmp_path / "fires.gpkg"
    frame.to_crs("EPSG:4326").to_file(path)
    expected = [{13, 14, 15, 24, 35, 36, 37}, {66, 85}, {60}]
    for source in (frame, path):
        start = resolve_ignitions(network, source, n_runs=3, seed=0)
        groups = [set(start.cells[start.starts[i] : start.starts[i + 1]].tolist()) for i in range(3)]
        assert sorted(groups, key=min) == [expected[0], expected[2], expected[1]]
        together = resolve_ignitions(network, source, mode="all", n_runs=2, seed=0)
        assert set(together.cells[: together.starts[1]].tolist()) == set.union(*expected)
        assert any("2 polygons are perimeters" in note for note in start.notes)
    burns = simulate(network, ignitions=frame[:1], n_runs=20, seed=0)
    assert (burns["fire_size"] >= 7).all()
    assert (burns["burn_count"].to_numpy().ravel()[sorted(expected[0])] == 20).all()
    with pytest.raises(InputError, match=r"polygon 1 .* lies outside the grid"):
        resolve_ignitions(network, gpd.GeoSeries([box(0, 0, 9, 9)], crs="EPSG:32635"), n_runs=1, seed=0)
    with pytest.raises(InputError, match=r"polygon 1 .* lies on cells without fuel \(row 2, col 3\)"):
        resolve_ignitions(network, gpd.GeoSeries([area(2, 3, 1, 2)], crs="EPSG:32635"), n_runs=1, seed=0)
    with pytest.raises(InputError, match="holds LineString, expected points or polygons"):
        resolve_ignitions(network, gpd.GeoSeries([LineString([(0, 0), (1, 1)])], crs="EPSG:32635"), n_runs=1, seed=0)


def test_a_raster_file_on_any_grid_reads_as_on_the_command_line(network, tmp_path):
    coarse = np.array([[1.0, 3.0, -9999.0]], np.float32)
    path = write(tmp_path / "likely.tif", coarse, transform=Affine(80, 0, 586_440, 0, -160, 3_999_900), nodata=-9999.0)
    places = ignition_places(network, path)
    weights = places.weights.reshape(network.shape)
    assert (weights[:, 8:] == 0).all()
    assert weights[0, 0] / weights[0, 7] == pytest.approx(1 / 3)
    assert any("no data on 24 cells" in note for note in places.notes)
    laid = np.where(weights > 0, weights, 0)
    one = resolve_ignitions(network, path, n_runs=40, seed=1)
    assert (one.cells == resolve_ignitions(network, laid, n_runs=40, seed=1).cells).all()


def test_each_feature_is_lit_at_its_time():
    times = np.full((8, 9, 12), 600)
    network = SpreadNetwork(np.ones((8, 9, 12)), travel_time=times, **UTM)
    points = gpd.GeoDataFrame(
        {"after_h": [0.0, 0.5]},
        geometry=[Point(centre(network, 0, 0)), Point(centre(network, 8, 11))],
        crs="EPSG:32635",
    )
    given = {"ignition_mode": "all", "n_runs": 1, "products": Products(arrivals=True)}
    by_column = simulate(network, ignitions=points, ignition_times="after_h", duration="40min", **given)
    by_numbers = simulate(network, ignitions=points, ignition_times=[0, 1800], duration="40min", **given)
    assert by_column.identical(by_numbers)
    arrival = by_column["arrival"][0].to_numpy()
    row, col = np.mgrid[:9, :12]
    one, other = np.maximum(row, col) * 600, 1800 + np.maximum(8 - row, 11 - col) * 600
    expected = np.minimum(one, other)
    assert (arrival == np.where(expected <= 2400, expected, NEVER)).all()
    with pytest.raises(InputError, match="after_h"):
        simulate(network, ignitions=points, ignition_times="hours", n_runs=1)
    with pytest.raises(InputError, match="expected 2"):
        simulate(network, ignitions=points, ignition_times=[0, 1, 2], n_runs=1)
    with pytest.raises(ParameterError, match="drawn"):
        simulate(network, ignition_times=[0.0], n_runs=1)


def test_past_fires_make_a_density(tmp_path):
    network = SpreadNetwork(np.full((8, 120, 150), 0.4), **UTM)
    random = np.random.default_rng(1)
    west = [Point(centre(network, *place)) for place in random.integers((20, 10), (100, 40), (60, 2))]
    east = [Point(centre(network, 60, 120)).buffer(90.0)] * 20
    past = write_vector(tmp_path / "past.gpkg", gpd.GeoDataFrame(geometry=west + east, crs="EPSG:32635"))
    drawn = resolve_ignitions(network, past, mode="density", n_runs=4000, seed=3).cells
    col = drawn % 150
    assert len(set(drawn.tolist())) > 1000  # not the fires themselves
    near_east, near_west = (col > 80).mean(), (col < 80).mean()
    assert near_east == pytest.approx(0.25, abs=0.05)
    assert near_west == pytest.approx(0.75, abs=0.05)
    with pytest.raises(ParameterError, match="past fires"):
        resolve_ignitions(network, np.ones(network.shape), mode="density", n_runs=3, seed=3)
    far = gpd.GeoSeries([Point(0, 0)], crs="EPSG:32635")
    with pytest.raises(InputError, match="outside the grid"):
        resolve_ignitions(network, far, mode="density", n_runs=3, seed=3)
