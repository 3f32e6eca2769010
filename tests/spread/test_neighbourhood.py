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


def test_the_command_line_has_it(tmp_path, make_landscape):
    """Network, plan and burn of a landscape take it; a network that is made refuses it."""
    import json

    from click.testing import CliRunner

    from firebreak_gis.cli import firebreak
    from firebreak_gis.spread.raster import read_network

    def run(*words, code=0):
        outcome = CliRunner().invoke(firebreak, [str(word) for word in words])
        assert outcome.exit_code == code, outcome.output
        return outcome.output

    layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    folder, four = tmp_path / "land", ["--neighbourhood", "von_neumann"]
    run("align", *layers, "--res", 200, "-o", folder)
    straight = [len(name) == 1 for name in DIRECTIONS]
    for clock in ([], ["--clock"]):
        path = tmp_path / f"network{len(clock)}.tif"
        run("network", folder, *four, *clock, "-o", path)
        network = read_network(path)
        assert network.probability[straight].any()
        assert not network.probability[np.logical_not(straight)].any()
    sizes = {}
    for name in ("moore", "von_neumann"):
        words = ["--neighbourhood", name, "--runs", 30, "--json"]
        run("burn", folder, *words, "-o", tmp_path / f"{name}.tif")
        run("plan", *layers, "--res", 200, "--method", "degree", *words, "-o", tmp_path / name)
        sizes[name] = json.loads((tmp_path / name / "run.json").read_text())["summary"]["burnt_share_without_breaks"]
    assert sizes["von_neumann"] < sizes["moore"]
    assert "is a network" in run("burn", tmp_path / "network0.tif", *four, "-o", tmp_path / "no.tif", code=2)
