"""Sixty-four fires at once are the same fires as one by one, to the bit, across tiles and round the torus."""

from itertools import pairwise

import numpy as np
import pytest

from firebreak_gis import SpreadNetwork
from firebreak_gis.kernels import draws, lanes, percolation


def stakes(seed, shape, boundary, high, n_runs):
    rng = np.random.default_rng(seed)
    probability = rng.uniform(0, high, (8, *shape)).astype(np.float32)
    network = SpreadNetwork(probability, burnable=rng.random(shape) > 0.1, boundary=boundary)
    per_run = rng.integers(0, 4, n_runs)
    starts = np.concatenate([[0], np.cumsum(per_run)])
    cells = rng.choice(np.flatnonzero(network.burnable), starts[-1])
    cells[rng.random(cells.size) < 0.1] = -1
    grid_steps = percolation.steps(shape, periodic=boundary == "periodic")
    given = (draws.thresholds(network.probability), draws.run_keys(seed, "edges", n_runs), grid_steps, starts, cells)
    return network, given


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("high", [0.4, 0.55, 0.9])
@pytest.mark.parametrize("shape", [(5, 9), (64, 32), (65, 33), (150, 97)])
def test_blocks_make_the_runs_of_the_single_kernel(shape, high, boundary):
    n_runs = 90
    network, given = stakes(1, shape, boundary, high, n_runs)
    counts, sizes = np.zeros(network.burnable.size, np.uint32), np.zeros(n_runs, np.int64)
    ground, spared = np.random.default_rng(3).integers(-5, 9, counts.size).clip(0), np.zeros(n_runs, np.int64)
    percolation.burn_runs(*given, 0, n_runs, counts, sizes, np.zeros(0), np.zeros(n_runs), ground, spared)
    state = lanes.lanes(shape)
    for cut in ((0, 64, 90), (0, 1, 33, 90), (0, 30, 90)):
        again, size_again, spared_again = np.zeros_like(counts), np.zeros_like(sizes), np.ones_like(spared)
        for first, last in pairwise(cut):
            lanes.burn_block(*given, first, last, state, again, size_again, ground, spared_again)
        np.testing.assert_array_equal(again, counts)
        np.testing.assert_array_equal(size_again, sizes)
        np.testing.assert_array_equal(spared_again, spared)
    assert sizes.max() > 0
    assert spared.sum() == (ground * counts).sum() > 0


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("shape", [(7, 11), (70, 41)])
def test_blocks_make_the_curves_of_the_single_kernel(shape, boundary):
    n_runs = 80
    network, given = stakes(2, shape, boundary, 0.8, n_runs)
    rng = np.random.default_rng(5)
    for n_levels in (1, 2, 37):
        levels = rng.integers(-1, n_levels, network.burnable.size).astype(np.int32)
        expected, got = np.zeros((n_runs, n_levels), np.int64), np.zeros((n_runs, n_levels), np.int64)
        percolation.burn_curve(*given, 0, n_runs, levels, expected)
        state = lanes.lanes(shape, curve=True)
        for first, last in ((0, 64), (64, 80)):
            lanes.curve_block(*given, first, last, levels, state, got)
        np.testing.assert_array_equal(got, expected)
        assert expected[:, 0].max() > 0


def test_the_choice_of_kernel_follows_the_burnt_share():
    counts = np.ones(10_000, np.uint32)
    assert lanes.block_pays(counts, np.array([5_000, 6_000]), 64)
    assert not lanes.block_pays(counts, np.array([10, 20]), 64)
    assert not lanes.block_pays(counts, np.array([5_000]), 2)
