"""Plans of large maps: networks on the disk, fires by windows; the plans are those of maps in memory."""

from __future__ import annotations

import numpy as np
import pytest

import firebreak_gis as fb
from firebreak_gis import memory
from firebreak_gis.planning.blocks import network_of
from firebreak_gis.simulation import ground_fires, windows

pytestmark = pytest.mark.usefixtures("no_pictures")


@pytest.fixture(scope="module")
def landscape():
    return fb.read_landscape(**fb.sample_layers(), resolution=150.0)


@pytest.mark.parametrize("clock", [False, True])
@pytest.mark.parametrize("cells", [1, 1000, 10**9])
def test_a_network_by_blocks_is_that_of_the_whole(landscape, clock, cells, tmp_path):
    shape = landscape["burnable"].shape
    wind = np.random.default_rng(0).uniform(0, 9, shape)
    params = {"model": "alexandridis", "wind_speed": wind, "wind_from_direction": 300.0, "clock": clock}
    whole = fb.spread_network(landscape, **params)
    found = network_of(landscape, folder=tmp_path, cells=cells, **params)
    for name in ("probability", "burnable", "travel_time", "heat"):
        np.testing.assert_array_equal(getattr(found, name), getattr(whole, name))
    assert isinstance(found.probability, np.memmap) == (cells < shape[0] * shape[1])
    assert (found.grid, found.boundary, found.provenance) == (whole.grid, whole.boundary, whole.provenance)
    assert not found.probability.flags.writeable
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("valued", [False, True])
def test_a_plan_of_a_large_map_is_that_of_the_map_in_memory(landscape, valued, monkeypatch):
    rng = np.random.default_rng(1)
    asked = {"budget": 0.1, "n_runs": 12, "model_params": {"wind_speed": 5.0, "wind_from_direction": 315.0}}
    asked |= {"value": rng.integers(1, 9, landscape["burnable"].shape)} if valued else {}
    whole = fb.plan(landscape, **asked)
    monkeypatch.setattr(memory, "BLOCK_CELLS", 500)
    monkeypatch.setattr(ground_fires, "WINDOWS_FROM", 500)
    monkeypatch.setattr(windows, "SIDE", 16)
    large = fb.plan(landscape, **asked)
    assert isinstance(large.network.probability, np.memmap)
    for name in ("priority", "breaks", "before", "after", "evaluation", "paper"):
        assert getattr(large, name).identical(getattr(whole, name)), name
    assert large.summary == whole.summary
