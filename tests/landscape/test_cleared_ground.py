"""Ground that lines clear: how much of each cell, and that it counts as burnt only where the line fails."""

from __future__ import annotations

from itertools import pairwise

import geopandas as gpd
import numpy as np
import pytest
import shapely

from firebreak_gis import SpreadNetwork, simulate
from firebreak_gis.kernels import draws
from firebreak_gis.kernels.walls import GROUND
from firebreak_gis.landscape.lines import line_breaks
from firebreak_gis.lattice import NEVER
from firebreak_gis.simulation.budgets import burn_each
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import Hold
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.request import FireRequest
from tests.landscape.test_lines import CRS, PLACE, breaks_of, drawn, grid_of, network_of, spared_by_hand, wild

CELL = 20.0
TIMES = (600.0, 1500.0)


def rectangles(line, width):
    """Each straight piece of a line in (column, row) coordinates, in its width [cells]."""
    for a, b in pairwise(line):
        yield shapely.LineString([a, b]).buffer(width / 2, cap_style="flat")


@pytest.mark.parametrize("seed", range(4))
def test_what_a_line_clears_of_each_cell_is_what_shapely_says(seed):
    grid = grid_of((13, 17))
    lines, widths = wild(seed, grid.shape), np.array([2.0, 9.0, 15.0, 40.0])
    cleared = line_breaks(drawn(lines, grid, widths), grid, width="width_m").cleared
    found = np.bincount(cleared.cell, cleared.part, minlength=13 * 17).reshape(13, 17) / GROUND
    every = [piece for line, width in zip(lines, widths, strict=True) for piece in rectangles(line, width / CELL)]
    expected = np.zeros((13, 17))
    for row, col in np.ndindex(13, 17):
        cell = shapely.box(col, row, col + 1, row + 1)
        expected[row, col] = sum(piece.intersection(cell).area for piece in every)
    np.testing.assert_allclose(found, expected, atol=2e-2)  # vertices are rounded
    assert abs(found.sum() - np.sum(expected)) < 0.05
    assert (np.diff(cleared.cell) >= 0).all()


def test_what_a_line_clears_adds_up_to_length_times_width():
    grid = grid_of((40, 50))
    frame = drawn([[(4.2, 5.1), (30.7, 9.4), (22.2, 33.3)], [(40, 8), (40, 30)]], grid, np.array([7.0, 33.0]))
    breaks = line_breaks(frame, grid, width="width_m")
    hectares = breaks.cleared.part.sum() / GROUND * grid.cell_area_ha
    assert hectares == pytest.approx(breaks.area_ha, rel=1e-3)


def test_ground_knows_how_far_along_its_line_it_lies():
    grid = grid_of((23, 31))
    frame = drawn(wild(5, grid.shape, 3), grid, 3.0)
    breaks = line_breaks(frame, grid, width="width_m")
    inside = frame.geometry.intersection(shapely.box(*grid.bounds).buffer(2 * CELL))
    for k, line in enumerate(inside):
        marks = line_breaks(frame.iloc[[k]], grid, width="width_m").cleared
        own = np.isin(breaks.cleared.line, marks.line)
        np.testing.assert_array_equal(breaks.cleared.along[own], marks.along)
        row, col = np.divmod(marks.cell, 31)
        places = shapely.line_interpolate_point(line, marks.along)
        x, y = grid.x[col], grid.y[row]
        off = np.hypot(shapely.get_x(places) - x, shapely.get_y(places) - y)
        assert off.max() < 0.75 * CELL * np.sqrt(2), k  # the line passes the cell there
        np.testing.assert_allclose(marks.whole, line.length, rtol=1e-3)


@pytest.mark.parametrize("hold", [Hold(1.0), Hold(0.5, length=60.0), Hold(share=None, length=100.0)])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_sizes_growth_and_losses_are_those_of_plain_python(hold, residual):
    network = network_of(3)
    breaks = breaks_of(4, network, width=np.array([2.0, 9.0, 15.0, 40.0]))
    value = np.random.default_rng(2).uniform(0, 9, network.shape) * network.burnable
    n_runs = 25
    burns = simulate(
        network,
        breaks=breaks,
        hold=hold,
        residual=residual,
        value=value,
        n_runs=n_runs,
        seed=3,
        duration=3000,
        products=Products(by=TIMES, size_classes=(0.2, 1.0), arrivals=True),
    )
    holds = draws.run_keys(3, "hold", n_runs)
    large = np.zeros((3, *network.shape))
    for run in range(n_runs):
        spared = spared_by_hand(breaks, int(holds[run]), hold, residual, network).reshape(network.shape)
        arrival = burns["arrival"][run].to_numpy()
        burnt = arrival != NEVER
        size = float((1 - spared)[burnt].sum())
        assert float(burns["fire_size"][run]) == size
        assert float(burns["value_lost"][run]) == pytest.approx(float((value * (1 - spared))[burnt].sum()))
        for k, t in enumerate(TIMES):
            assert float(burns["fire_size_by"][run, k]) == (1 - spared)[arrival <= t].sum()
        large[np.searchsorted([0.2, 1.0], size * network.grid.cell_area_ha)][burnt] += 1
    found = burns["burnt_in_class"].fillna(0).to_numpy()
    np.testing.assert_allclose(found, large / n_runs, atol=1e-6)
    assert (large.reshape(3, -1).max(axis=1) > 0).all()
    assert (burns["fire_size"] % 1 > 0).sum() > 10


def test_ground_burns_where_crews_come_too_late():
    network = SpreadNetwork(np.ones((8, 5, 40)), travel_time=np.full((8, 5, 40), 60), crs=CRS, transform=PLACE)
    line = line_breaks(drawn([[(20.0, 0), (20.0, 5)]], network.grid), network.grid, width=5.0)
    station = gpd.GeoDataFrame(geometry=[shapely.Point(network.grid.x[20], network.grid.y[2])], crs=CRS)
    fires = {"ignitions": (network.grid.x[3], network.grid.y[2]), "n_runs": 1, "breaks": line}
    for delay, size in ((1, 99.375), (60, 200.0)):
        crews = simulate(network, stations=station, crew_travel=f"road=40,off=3,delay={delay}", **fires)
        assert float(crews["fire_size"][0]) == size


@pytest.mark.parametrize("clock", [False, True])
def test_a_line_over_whole_cells_counts_as_cut_cells_do(clock):
    shape = (12, 30)
    network = SpreadNetwork(np.ones((8, *shape)), travel_time=np.full((8, *shape), 60), crs=CRS, transform=PLACE)
    cut = np.zeros(shape, bool)
    cut[:, 17] = True
    line = line_breaks(drawn([[(17.5, 0.0), (17.5, 12.0)]], network.grid), network.grid, width=CELL)
    value = np.random.default_rng(0).random(shape)
    fires = {"n_runs": 1, "value": value} | ({"duration": "2h"} if clock else {})
    for col in (3, 25, 17):
        start = (network.grid.x[col], network.grid.y[6])
        cells, lines = (simulate(network, breaks=each, ignitions=start, **fires) for each in (cut, line))
        assert float(lines["fire_size"][0]) == int(cells["fire_size"][0])
        assert float(lines["value_lost"][0]) == pytest.approx(float(cells["value_lost"][0]))


@pytest.mark.parametrize("hold", [None, Hold(0.5, length=60.0), Hold(None, 100.0)])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_more_lines_never_burn_more_of_the_land(hold, residual):
    network = network_of(8)
    lines = drawn(wild(9, network.shape, 8), network.grid, np.linspace(3.0, 40.0, 8))
    fires = {"residual": residual, "hold": hold, "n_runs": 60, "seed": 6}
    fires |= {} if hold is None else {"duration": "lognormal:40min,0.5"}
    earlier = simulate(network, **fires)["fire_size"].to_numpy()
    assert earlier.dtype == np.int64
    for n in (1, 3, 8):
        burns = simulate(network, breaks=line_breaks(lines[:n], network.grid, width="width_m"), **fires)
        found = burns["fire_size"].to_numpy()
        assert (found <= earlier).all()
        assert (found < earlier).sum() > 5
        assert found.sum() < float(burns["burn_count"].sum())
        earlier = found


def test_without_a_clock_fires_are_the_same_by_blocks_with_values_and_with_a_clock():
    network = SpreadNetwork(np.random.default_rng(1).uniform(0.3, 0.6, (8, 60, 70)), crs=CRS, transform=PLACE)
    breaks = breaks_of(6, network, 3)
    given = {"breaks": breaks, "n_runs": 150, "seed": 2, "residual": 0.1}
    blocks = simulate(network, **given)
    one = simulate(network, value=np.ones(network.shape), **given)
    slow = simulate(network, hold=Hold(1.0), products=Products(paths=True), **given)
    np.testing.assert_array_equal(blocks["fire_size"], one["fire_size"])
    np.testing.assert_array_equal(blocks["fire_size"], slow["fire_size"])
    np.testing.assert_allclose(one["value_lost"], one["fire_size"])
    each = burn_each(Ground(network), FireRequest(n_runs=150, seed=2, residual=0.1), [None, breaks])
    np.testing.assert_array_equal(each[:, 1], blocks["fire_size"])


def test_fires_that_start_on_cleared_ground_burn_nothing_as_often_as_its_share():
    network = SpreadNetwork(np.ones((8, 5, 40)), travel_time=np.full((8, 5, 40), 60), crs=CRS, transform=PLACE)
    line = line_breaks(drawn([[(20.5, -1), (20.5, 6)]], network.grid), network.grid, width=0.3 * CELL)
    fires = {"breaks": line, "ignitions": (network.grid.x[20], network.grid.y[2]), "n_runs": 1000}
    for more, often in (({}, 0.3), ({"duration": "9h"}, 0.3), ({"duration": "9h", "hold": "0.5:10000"}, 0.15)):
        sizes = simulate(network, **fires, **more)["fire_size"].to_numpy()
        assert abs((sizes == 0).mean() - often) < 0.045
    assert (simulate(network, residual=0.2, **fires)["fire_size"] > 0).all()  # what leaks is lit, as cut cells are
