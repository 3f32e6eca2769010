"""What treated cells keep, cell by cell; the twins know it too (`test_timed`, `tests/kernels/test_arrival.py`)."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from firebreak_gis import simulate
from tests.simulation.test_timed import WINDY, network_of


@pytest.mark.parametrize("fires", [{}, {"duration": "40min"}, {"hold": 0.5}, {"embers": WINDY, "duration": "1h"}])
def test_a_plane_of_one_residual_is_that_number(fires):
    network = network_of(3)
    cut = np.random.default_rng(8).random(network.shape) < 0.2
    for residual in (0.0, 0.1, 0.7, 1.0):
        given = {"breaks": cut, "n_runs": 40, "seed": 2, **fires}
        alike = np.where(network.burnable, residual, np.nan)
        xr.testing.assert_identical(
            simulate(network, residual=alike, **given), simulate(network, residual=residual, **given)
        )


@pytest.mark.parametrize("fires", [{}, {"duration": "40min", "hold": 0.5}])
def test_a_cell_that_keeps_all_is_not_cut_and_more_kept_burns_more(fires):
    network = network_of(3)
    random = np.random.default_rng(8)
    cut = random.random(network.shape) < 0.3
    given = {"n_runs": 80, "seed": 2, **fires}
    kept = np.where(random.random(network.shape) < 0.5, 1.0, 0.0)
    half = simulate(network, breaks=cut, residual=kept, **given)
    xr.testing.assert_identical(half, simulate(network, breaks=cut & (kept == 0), **given))
    some = simulate(network, breaks=cut, residual=np.maximum(kept, 0.4), **given)
    assert (some["burn_count"] >= half["burn_count"]).all()
    assert some["fire_size"].sum() > half["fire_size"].sum()
