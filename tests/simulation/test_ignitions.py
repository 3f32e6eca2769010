"""Where fires start: random cells, points of any kind, probability rasters, refusals."""

import geopandas as gpd
import numpy as np
import pytest
from affine import Affine
from scipy import stats
from shapely.geometry import MultiPoint, Point

from firebreak_gis import SpreadNetwork, simulate, write_vector
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.simulation.ignitions import resolve_ignitions

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
    weights[3, 3] = np.nan
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
        assert (each.cells == expected[np.arange(7) % 3]).all()
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
