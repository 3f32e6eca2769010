"""Patterns of practice: bands and grids of given direction, spacing and width, staggered patches, ridges and roads."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest
from scipy.ndimage import find_objects, label

from firebreak_gis import plugins
from firebreak_gis.breaks import select_breaks
from firebreak_gis.errors import ParameterError
from firebreak_gis.kernels.terrain import uphill_area
from firebreak_gis.lattice import COL_STEP, ROW_STEP, STEP_LENGTH
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.patterns import (
    ExpectedLoss,
    bands,
    heading_coordinate,
    middle_first,
    prevailing,
    square_grid,
    staggered_patches,
    stripes,
    thickness,
)
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes
from tests.twins import segments as twin

PATTERNS = ["stripes", "compartments", "splat"]


def landscape(seed: int = 1, shape: tuple[int, int] = (33, 46)) -> tuple[SpreadNetwork, Stakes]:
    random = np.random.default_rng(seed)
    network = SpreadNetwork(random.random((8, *shape)).astype(np.float32), burnable=random.random(shape) > 0.1)
    return network, Stakes(
        network,
        cost=random.integers(1, 9, shape),
        value=random.random(shape),
        ignition=random.random(shape),
        protected=random.random(shape) < 0.05,
    )


def first_cells(priority, network: SpreadNetwork, share: float) -> np.ndarray:
    return select_breaks(priority, budget=share, burnable=network.burnable).values > 0


@pytest.mark.parametrize("azimuth", [0.0, 45.0, 90.0, 30.0, 157.5])
@pytest.mark.parametrize("width", [1, 2, 3])
def test_every_way_across_a_band_meets_its_width(azimuth, width):
    shape = (30, 37)
    inside, number = bands(shape, azimuth, width=width, spacing=36.0, shift=0.5)
    band = inside & (number == number[inside].max())
    place = heading_coordinate(shape, azimuth)
    before, after = (~band & side for side in (place < place[band].min(), place > place[band].max()))
    assert before.any()
    assert after.any()
    graph = nx.DiGraph()
    for row, col in np.ndindex(shape):
        for dr, dc in zip(ROW_STEP, COL_STEP, strict=True):
            to = (row + dr, col + dc)
            if 0 <= to[0] < shape[0] and 0 <= to[1] < shape[1]:
                graph.add_edge((row, col), to, met=int(band[to]))
    met = nx.multi_source_dijkstra_path_length(graph, set(map(tuple, np.argwhere(before).tolist())), weight="met")
    assert min(met[cell] for cell in map(tuple, np.argwhere(after).tolist())) == width


@pytest.mark.parametrize("azimuth", [0.0, 45.0, 20.0])
@pytest.mark.parametrize("spacing", [12.0, 17.5])
@pytest.mark.parametrize("width", [1, 3])
def test_bands_are_spaced_and_turned_as_asked(azimuth, spacing, width):
    shape = (150, 190)
    inside, number = bands(shape, azimuth, width=width, spacing=spacing, shift=0.25)
    assert inside.mean() == pytest.approx(thickness(azimuth, width) / spacing, rel=0.1)
    place = heading_coordinate(shape, azimuth)
    first = [place[inside & (number == k)].min() for k in range(2, 6)]
    np.testing.assert_allclose(np.diff(first), spacing, atol=1.5)
    for k in range(2, 6):
        assert np.ptp(place[inside & (number == k)]) < thickness(azimuth, width)


def test_lines_hold_each_band_once_and_the_middle_comes_first():
    shape = (20, 31)
    inside, _ = bands(shape, 90.0, width=2, spacing=6.0, shift=0.0)
    lines = stripes(shape, 90.0, width=2, spacing=6.0, shift=0.0)
    assert np.array_equal(np.sort(np.concatenate(lines)), np.flatnonzero(inside))
    assert set((lines[0] % 31).tolist()) == {18, 19}
    assert sorted(middle_first(9)) == list(range(9))
    assert middle_first(7) == [3, 1, 5, 0, 2, 4, 6]


def test_a_grid_encloses_squares_of_its_spacing():
    cut = np.zeros((41, 41), bool)
    cut.ravel()[np.concatenate(square_grid((41, 41), 0.0, width=1, spacing=10.0, shift=0.0))] = True
    network = SpreadNetwork(np.ones((8, 41, 41), np.float32))
    sizes = sorted(len(part) for part in twin.compartments(network, cut))
    assert sizes == [81] * 16
    one = np.full(cut.shape, 1.0)
    assert ExpectedLoss(network, Stakes(network))(cut) == pytest.approx(twin.loss(network, cut, one, one) / one.sum())


@pytest.mark.parametrize("method", PATTERNS)
def test_patterns_keep_to_the_budget_and_off_protected_cells(method):
    network, stakes = landscape()
    (name,) = (p["name"] for p in plugins.describe("ranking", method)["parameters"] if "share" in p.get("told", ""))
    for budget in (0.03, 0.12):
        priority = rank(network, method, stakes=stakes, **{name: budget}).values
        assert np.isneginf(priority[stakes.protected]).all()
        assert np.isfinite(priority[network.burnable & ~stakes.protected]).all()
    with pytest.raises(ParameterError, match=name):
        rank(network, method, stakes=stakes, **{name: 0.0})


@pytest.mark.parametrize(("direction", "axis"), [(0.0, 1), (90.0, 0)])
def test_stripes_lie_across_their_direction(direction, axis):
    network = SpreadNetwork(np.full((8, 40, 48), 0.5, np.float32))
    priority = rank(network, "stripes", direction=direction, spacing=8.0, width=2)
    cut = first_cells(priority, network, 0.25)
    assert set(cut.mean(axis=axis).tolist()) == {0.0, 1.0}  # whole rows across north, whole columns across east
    assert cut.mean() == pytest.approx(0.25)


@pytest.mark.parametrize("method", ["stripes", "compartments"])
def test_the_pattern_chosen_loses_no_more_than_any_given_direction(method):
    network, stakes = landscape(2)
    expected = ExpectedLoss(network, stakes)

    def loss(**options: float) -> float:
        priority = rank(network, method, stakes=stakes, cost_share=0.2, **options)
        cut = select_breaks(priority, budget=0.2 * stakes.cost.sum(), unit="cost", cost=stakes.cost).values > 0
        return expected(cut)

    chosen = loss()
    assert all(chosen <= loss(direction=direction) * 1.1 for direction in (0.0, 45.0))
    assert chosen < 0.7 * expected(np.zeros(network.shape, bool))


def test_patches_are_staggered_and_take_their_share():
    shape = (160, 200)
    for azimuth in (0.0, 90.0):
        patch = staggered_patches(shape, azimuth, width=4, length=12, gap=6, overlap=4)
        assert (patch >= 0).mean() == pytest.approx(4 * 12 / ((4 + 6) * 2 * (12 - 4)), rel=0.06)
        # Fire straight ahead meets a patch in one of two neighbouring rows.
        rows = patch if azimuth == 0.0 else patch.T
        window = rows[40:60] >= 0
        assert window.any(axis=0).all()
        assert not window[:10].any(axis=0).all()


def test_splat_follows_the_direction_into_which_fire_spreads():
    probability = np.full((8, 40, 40), 0.3, np.float32)
    probability[2] = 0.9  # to the east
    network = SpreadNetwork(probability)
    assert prevailing(network) == pytest.approx(90.0)
    for options in ({}, {"direction": 90.0}):
        cut = first_cells(rank(network, "splat", gap=4.0, **options), network, 0.2)
        sizes = [(rows.stop - rows.start, cols.stop - cols.start) for rows, cols in find_objects(label(cut)[0])]
        assert (12, 4) in sizes
        assert max(cols for _, cols in sizes) == 4
    with pytest.raises(ParameterError, match="overlap"):
        rank(network, "splat", length=4, overlap=4)


def by_climbing(height: np.ndarray) -> np.ndarray:
    """Cells whose way straight uphill leads through each cell, climbed from every cell."""
    rows, cols = height.shape
    area = np.zeros(height.shape)
    for row, col in np.ndindex(height.shape):
        while True:
            area[row, col] += 1
            steepest, onward = 0.0, None
            for dr, dc, length in zip(ROW_STEP, COL_STEP, STEP_LENGTH, strict=True):
                to = (row + dr, col + dc)
                if 0 <= to[0] < rows and 0 <= to[1] < cols:
                    slope = (height[to] - height[row, col]) / length
                    if slope > steepest:
                        steepest, onward = slope, to
            if onward is None:
                break
            row, col = onward
    return area


@pytest.mark.parametrize("levels", [3, 1000])
def test_uphill_area_is_that_of_climbing_from_every_cell(levels):
    height = np.random.default_rng(levels).integers(0, levels, (11, 16)).astype(float)
    assert (uphill_area(height) == by_climbing(height)).all()


def test_zones_run_along_the_ridge_and_along_roads_first():
    shape = (40, 60)
    network = SpreadNetwork(np.full((8, *shape), 0.5, np.float32))
    row, col = np.indices(shape)
    height = 500.0 - 10.0 * np.abs(row - 17) + 0.5 * col  # a roof that rises to the east
    cut = first_cells(rank(network, "dfpz", width=3, elevation=height), network, 0.1)
    assert np.abs(row[cut] - 17).max() <= 3
    assert cut[16:19].mean() > 0.7
    roads = np.zeros(shape)
    roads[30] = 1.0
    both = first_cells(rank(network, "dfpz", width=3, elevation=height, roads=roads), network, 0.1)
    assert both[29:32].all()
    assert np.abs(row[both & (row < 29)] - 17).max() <= 3
    narrow = first_cells(rank(network, "dfpz", width=1, elevation=height, roads=roads), network, 1 / 40)
    assert narrow[30].all()
