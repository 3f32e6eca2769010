"""Runs as tasks of dask: equal to one call, wherever they are made."""

import sys

import dask
import dask.array
import numpy as np
import pytest
import xarray as xr

from firebreak_gis import SpreadNetwork, rank, select_breaks, simulate, simulate_distributed
from firebreak_gis.errors import InputError, MissingComponentError, ParameterError
from firebreak_gis.simulation.products import Products


@pytest.fixture(scope="module")
def network():
    random = np.random.default_rng(3)
    return SpreadNetwork(random.uniform(0.0, 0.6, (8, 13, 21)), burnable=random.random((13, 21)) > 0.1)


@pytest.fixture(scope="module")
def points(network):
    rows, cols = np.nonzero(network.burnable)
    return [(col + 0.5, -row - 0.5) for row, col in zip(rows[::60].tolist(), cols[::60].tolist(), strict=True)]


@pytest.mark.parametrize("runs_per_task", [1, 7, 64, 1000])
@pytest.mark.parametrize("scheduler", ["synchronous", "threads"])
def test_equal_to_one_call_however_split(network, runs_per_task, scheduler):
    given = {
        "breaks": np.random.default_rng(0).random(network.shape) < 0.1,
        "residual": 0.1,
        "value": np.arange(273.0).reshape(network.shape),
    }
    with dask.config.set(scheduler=scheduler):
        found = simulate_distributed(network, n_runs=75, runs_per_task=runs_per_task, seed=5, **given)
    assert found.identical(simulate(network, n_runs=75, seed=5, **given))


@pytest.mark.parametrize("scheduler", ["synchronous", "threads", "processes"])
def test_fires_with_a_clock_are_equal_however_split(scheduler):
    random = np.random.default_rng(4)
    network = SpreadNetwork(random.uniform(0.0, 0.6, (8, 13, 21)), travel_time=random.integers(20, 300, (8, 13, 21)))
    given = {
        "breaks": random.random((13, 21)) < 0.1,
        "hold": 0.5,
        "duration": "lognormal:20min,0.5",
        "n_runs": 50,
        "seed": 3,
    }
    with dask.config.set(scheduler=scheduler, num_workers=2):
        found = simulate_distributed(network, runs_per_task=13, **given)
    assert found.identical(simulate(network, **given))
    with pytest.raises(ParameterError, match="products"):
        simulate_distributed(network, products=Products(by=(60.0,)), **given)


def test_equal_in_other_processes(network, points):
    with dask.config.set(scheduler="processes", num_workers=2):
        found = simulate_distributed(network, n_runs=40, runs_per_task=20, ignitions=points)
    assert found.identical(simulate(network, n_runs=40, ignitions=points))


@pytest.mark.parametrize("source", ["anywhere", "points", "weights"])
def test_a_range_of_runs_is_that_part_of_all_runs(network, points, source):
    weights = np.random.default_rng(1).random(network.shape)
    ignitions = {"anywhere": None, "points": points, "weights": weights}[source]
    whole = simulate(network, n_runs=150, seed=2, ignitions=ignitions)
    first = simulate(network, n_runs=70, seed=2, ignitions=ignitions)
    rest = simulate(network, n_runs=80, first_run=70, seed=2, ignitions=ignitions)
    assert (first["burn_count"] + rest["burn_count"]).equals(whole["burn_count"])
    assert (np.concatenate([first["fire_size"], rest["fire_size"]]) == whole["fire_size"].to_numpy()).all()


def test_layers_of_dask_are_computed(network):
    """Chunked arrays go in wherever arrays do."""
    lazy = xr.DataArray(network.probability, dims=("direction", "y", "x")).chunk({"y": 5, "x": 8})
    other = SpreadNetwork(lazy, burnable=dask.array.from_array(network.burnable, chunks=4))
    assert (other.probability == network.probability).all()
    priority = rank(other, "degree")
    breaks = select_breaks(priority.chunk({"y": 6}), budget=0.1)
    assert breaks.equals(select_breaks(rank(network, "degree"), budget=0.1))
    found = simulate(other, breaks=breaks.chunk({"x": 4}), n_runs=20)
    assert isinstance(found, xr.Dataset)
    assert found.equals(simulate(network, breaks=breaks, n_runs=20))


def test_refused_before_any_task(network):
    with pytest.raises(InputError, match="outside the grid"):
        simulate_distributed(network, n_runs=10, ignitions=[(-50.0, 50.0)])
    with pytest.raises(ParameterError, match="runs_per_task"):
        simulate_distributed(network, n_runs=10, runs_per_task=0)


def test_without_dask(network, monkeypatch):
    monkeypatch.setitem(sys.modules, "dask.delayed", None)
    with pytest.raises(MissingComponentError, match=r"firebreak_gis\[scale\]"):
        simulate_distributed(network, n_runs=10)
