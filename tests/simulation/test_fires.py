"""Simulated fires through the public functions: results, pairing, sources of ignitions, refusals, stops."""

from __future__ import annotations

import numpy as np
import pytest
from affine import Affine

from firebreak_gis import SpreadNetwork, burn_curve, select_breaks, simulate
from firebreak_gis.errors import Cancelled, GridError, InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.kernels import draws, lanes
from firebreak_gis.rasters import write_raster
from firebreak_gis.simulation import timeless
from firebreak_gis.simulation.ignitions import resolve_ignitions
from tests.twins import percolation as twin

UTM = {"crs": "EPSG:32635", "transform": Affine(20, 0, 586_440, 0, -20, 3_999_900)}


@pytest.fixture(scope="module")
def network():
    random = np.random.default_rng(11)
    return SpreadNetwork(random.uniform(0.0, 0.65, (8, 17, 26)), burnable=random.random((17, 26)) > 0.15, **UTM)


@pytest.fixture(scope="module")
def cut(network):
    return np.random.default_rng(1).random(network.shape) < 0.25


def test_what_comes_out(network):
    burns = simulate(network, n_runs=37, seed=2)
    count, frequency = burns["burn_count"].to_numpy(), burns["burn_frequency"].to_numpy()
    assert count.dtype == np.uint32
    assert frequency.dtype == np.float32
    assert (np.isnan(frequency) == ~network.burnable).all()
    assert (frequency[network.burnable] == (count[network.burnable] / 37).astype(np.float32)).all()
    assert (count[~network.burnable] == 0).all()
    assert count.sum() == burns["fire_size"].sum()
    assert burns["fire_size"].min() >= 1
    assert burns["fire_size"].dtype == np.int64
    assert burns.attrs == {"n_runs": 37, "seed": 2, "n_burnable": network.n_burnable}
    assert Grid.of(burns["burn_count"]).matches(network.grid)
    assert burns["burn_frequency"].attrs["units"] == "1"


def test_fires_with_breaks_are_parts_of_the_same_fires(network, cut):
    """One run at a time, so that the map is the burnt set of the run."""
    smaller = 0
    for seed in range(60):
        free = simulate(network, n_runs=1, seed=seed)
        less = simulate(network, breaks=cut, n_runs=1, seed=seed)
        assert (less["burn_count"] <= free["burn_count"]).all()
        smaller += int(less["fire_size"][0] < free["fire_size"][0])
        for residual in (0.3, 1.0):
            leaky = simulate(network, breaks=cut, residual=residual, n_runs=1, seed=seed)
            assert (leaky["burn_count"] <= free["burn_count"]).all()
            assert (less["burn_count"] <= leaky["burn_count"]).all()
        assert leaky["burn_count"].equals(free["burn_count"])
    assert smaller > 30


def test_residual_is_a_factor_on_edges_into_treated_cells(network, cut):
    keys = draws.run_keys(5, "edges", 25)
    start = resolve_ignitions(network, n_runs=25, seed=5).cells
    burns = simulate(network, breaks=cut, residual=0.4, n_runs=25, seed=5)
    treated = network.treated(cut, residual=0.4)
    for run in range(25):
        assert burns["fire_size"][run] == len(twin.burn(treated, int(keys[run]), [int(start[run])]))


def test_a_raster_file_of_ignitions_is_the_array(network, tmp_path):
    weights = np.where(network.burnable, np.random.default_rng(3).random(network.shape), np.nan).astype(np.float32)
    data = network.grid.dataarray(weights, "burn_frequency")
    path = write_raster(tmp_path / "likely.tif", data)
    expected = simulate(network, ignitions=weights, n_runs=50, seed=1)
    for source in (data, path, str(path)):
        assert simulate(network, ignitions=source, n_runs=50, seed=1).identical(expected)
    assert not simulate(network, n_runs=50, seed=1).equals(expected)


def test_rasters_of_ignitions_lie_on_the_grid(network):
    weights = np.ones(network.shape)
    moved = Grid(network.shape, network.grid.transform @ Affine.translation(1, 0), network.grid.crs)
    with pytest.raises(GridError, match="another grid"):
        simulate(network, ignitions=moved.dataarray(weights, "burn_frequency"))
    with pytest.raises(GridError, match="another grid"):
        simulate(network, breaks=moved.dataarray(weights, "breaks"))
    with pytest.raises(InputError, match="finite numbers"):
        simulate(network, ignitions=np.where(network.burnable, np.inf, 0.0))


def test_many_points_at_once_burn_the_union_of_their_fires(network):
    cells = np.argwhere(network.burnable)[[0, 100, 250]]
    points = [(network.grid.x[col], network.grid.y[row]) for row, col in cells]
    for seed in range(10):
        union = np.zeros(network.shape, bool)
        for point in points:
            union |= simulate(network, ignitions=point, n_runs=1, seed=seed)["burn_count"].to_numpy() > 0
        together = simulate(network, ignitions=points, ignition_mode="all", n_runs=1, seed=seed)
        assert ((together["burn_count"].to_numpy() > 0) == union).all()


def test_inputs_stay_as_they_were(network, cut):
    given = cut.copy()
    probability = network.probability.copy()
    simulate(network, breaks=cut, n_runs=5)
    assert (cut == given).all()
    assert (network.probability == probability).all()


@pytest.mark.parametrize("n_runs", [1, 3, 5, 64, 65, 200])
def test_any_number_of_runs_begins_alike(network, n_runs):
    whole = simulate(network, n_runs=200, seed=7)["fire_size"].to_numpy()
    assert (simulate(network, n_runs=n_runs, seed=7, threads=2)["fire_size"].to_numpy() == whole[:n_runs]).all()
    priority = np.random.default_rng(2).random(network.shape)
    priority[~network.burnable] = -np.inf
    curve = burn_curve(network, priority, budgets=[0, 0.3], n_runs=n_runs, seed=7, threads=3)
    assert (curve[:, 0] == whole[:n_runs]).all()


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_no_way_of_sharing_out_the_runs_changes_a_count(monkeypatch, boundary):
    """One by one or 64 at once, by one thread or more, in pieces of any size: the same map and the same curve."""
    random = np.random.default_rng(4)
    network = SpreadNetwork(random.uniform(0.0, 0.6, (8, 70, 83)), boundary=boundary)
    priority = random.random(network.shape)
    made = []
    # Pilot, piece, runs of a block, and whether blocks are taken.
    for pilot, piece, block, pays in ((4, 8, 64, False), (1, 3, 64, False), (4, 8, 64, True), (2, 8, 17, True)):
        monkeypatch.setattr(timeless, "_PILOT", pilot)
        monkeypatch.setattr(timeless, "_PIECE", piece)
        monkeypatch.setattr(lanes, "LANES", block)
        monkeypatch.setattr(lanes, "block_pays", lambda *given, pays=pays, **more: pays)
        for threads in (1, 2, 3):
            given = {"n_runs": 150, "seed": 6, "threads": threads}
            made.append((simulate(network, **given), burn_curve(network, priority, budgets=[0, 0.1, 0.3], **given)))
    burns, curve = made[0]
    assert burns["burn_count"].max() > 64
    for other, other_curve in made[1:]:
        assert other.identical(burns)
        assert other_curve.identical(curve)


def test_protected_cells_are_never_cut_in_the_curve(network):
    priority = np.random.default_rng(2).random(network.shape)
    priority[~network.burnable] = -np.inf
    priority[:, ::3] = -np.inf
    priority = network.grid.dataarray(priority, "priority")
    budgets = [0.0, 0.2, 0.5]
    curve = burn_curve(network, priority, budgets=budgets, n_runs=30, seed=1)
    for k, budget in enumerate(budgets):
        mask = select_breaks(priority, budget=budget, burnable=network.burnable)
        assert (curve[:, k] == simulate(network, breaks=mask, n_runs=30, seed=1)["fire_size"]).all()


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"n_runs": 0}, ParameterError),
        ({"n_runs": 2.0}, ParameterError),
        ({"n_runs": None}, ParameterError),
        ({"seed": -1}, ParameterError),
        ({"seed": 0.5}, ParameterError),
        ({"threads": 0}, ParameterError),
        ({"breaks": np.zeros((26, 17))}, GridError),
        ({"breaks": np.zeros((17, 26)), "residual": 1.5}, ParameterError),
        ({"ignitions": [("a", "b")]}, ParameterError),
        ({"ignitions": [(1.0, 2.0), (3.0,)]}, ParameterError),
        ({"value": np.zeros((3, 3))}, GridError),
    ],
    ids=str,
)
def test_impossible_requests_are_refused(network, arguments, error):
    with pytest.raises(error):
        simulate(network, **{"n_runs": 3, **arguments})


@pytest.mark.parametrize("budgets", [[], [0.2, 0.1], [0.1, np.nan], [-0.1, 0.2], [0.5, 1.2]])
def test_impossible_budgets_are_refused(network, budgets):
    with pytest.raises(ParameterError, match="budget"):
        burn_curve(network, np.zeros(network.shape), budgets=budgets, n_runs=2)


@pytest.mark.parametrize("threads", [1, 2])
def test_progress_rises_and_may_stop_the_work(network, threads):
    heard = []

    def listen(fraction, message):
        heard.append(fraction)
        assert message

    def stop(fraction, message):
        if fraction > 0:
            raise Cancelled("stopped")

    priority = np.zeros(network.shape)
    simulate(network, n_runs=500, threads=threads, progress=listen)
    assert heard == sorted(heard)
    assert heard[-1] == 1.0
    with pytest.raises(Cancelled):
        simulate(network, n_runs=500, threads=threads, progress=stop)
    with pytest.raises(Cancelled):
        burn_curve(network, priority, budgets=[0, 0.5], n_runs=500, threads=threads, progress=stop)


@pytest.mark.parametrize("wrong", [np.nan, -1.0, np.inf, 1e308])
def test_values_that_make_no_sense_are_refused(network, wrong):
    value = np.ones(network.shape)
    value[~network.burnable] = np.nan  # nothing is lost there
    simulate(network, value=value, n_runs=2)
    value[network.burnable] = wrong
    with pytest.raises(InputError, match="value"):
        simulate(network, value=value, n_runs=2)
