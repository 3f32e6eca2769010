"""Four neighbours or eight: which walls hold under which."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis import rank, select_breaks, simulate, spread_network
from firebreak_gis.errors import ParameterError
from firebreak_gis.lattice import DIRECTIONS


def certain(make_landscape, shape=(14, 21)):
    """Even dense pines: every edge is certain (p = 1)."""
    return make_landscape(shape, holes=0.0, relief=0.0, vegetation=3, density=3)


@pytest.mark.parametrize("model", ["alexandridis", "artificial"])
def test_four_neighbours_are_the_straight_ones(make_landscape, model):
    from firebreak_gis import forest

    landscape = make_landscape(seed=2) if model == "alexandridis" else forest((9, 12), seed=1)
    moore = spread_network(landscape, model=model)
    four = spread_network(landscape, model=model, neighbourhood="von_neumann")
    straight = [len(name) == 1 for name in DIRECTIONS]
    np.testing.assert_array_equal(four.probability[straight], moore.probability[straight])
    assert not four.probability[np.logical_not(straight)].any()
    assert moore.probability[np.logical_not(straight)].any()
    np.testing.assert_array_equal(four.burnable, moore.burnable)


def wall(shape, kind):
    """A closed wall from the west side to the south side: cells that touch at corners, or at sides."""
    rows = shape[0]
    breaks = np.zeros(shape, np.uint8)
    for k in range(rows - 3):
        breaks[3 + k, k] = 1
        if kind == "staircase":
            breaks[3 + k, k + 1] = 1
    return breaks


@pytest.mark.parametrize(
    ("kind", "neighbourhood", "holds"),
    [
        ("diagonal", "von_neumann", True),
        ("diagonal", "moore", False),
        ("staircase", "von_neumann", True),
        ("staircase", "moore", True),
    ],
)
def test_which_walls_hold(make_landscape, kind, neighbourhood, holds):
    landscape = certain(make_landscape)
    network = spread_network(landscape, neighbourhood=neighbourhood)
    breaks = wall(network.shape, kind)
    start = np.zeros(network.shape)
    start[0, -1] = 1.0
    burns = simulate(network, breaks=breaks, ignitions=start, n_runs=3, seed=1)
    below = np.tril(np.ones(network.shape, bool), -4) & (breaks == 0)
    reached = burns["burn_frequency"].to_numpy()[below] > 0
    assert below.sum() > 20
    assert reached.any() != holds
    assert (burns["burn_frequency"].to_numpy()[0] == 1.0).all()


def test_dissection_needs_fewer_cells_against_four(make_landscape):
    """Diagonal walls hold there, so the same budget burns less."""
    landscape = make_landscape((48, 61), holes=0.0, relief=0.0, vegetation=3, density=3)
    left = {}
    for neighbourhood in ("moore", "von_neumann"):
        network = spread_network(landscape, neighbourhood=neighbourhood)
        breaks = select_breaks(rank(network, "dissection"), budget=0.06)
        left[neighbourhood] = float(simulate(network, breaks=breaks, n_runs=300, seed=2)["fire_size"].mean())
    assert left["von_neumann"] < 0.95 * left["moore"]


def test_other_words_are_refused(make_landscape):
    with pytest.raises(ParameterError, match="moore, von_neumann"):
        spread_network(make_landscape(), neighbourhood="hexagon")
