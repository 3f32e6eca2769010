"""Null models: fires that know nothing."""

import math

import numpy as np
import pytest

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation import nulls
from tests.twins import skill as twin

SHAPE = (13, 18)


@pytest.fixture(params=range(4))
def ground(request):
    rng = np.random.default_rng(request.param)
    fuel = rng.random(SHAPE) < 0.7
    start = np.zeros(SHAPE, bool)
    start[5:7, 4:8] = True
    start[rng.integers(13), rng.integers(18)] = True
    return fuel, start


def test_no_growth(ground):
    _, start = ground
    assert np.array_equal(nulls.no_growth(start), start)
    assert nulls.no_growth(start) is not start


@pytest.mark.parametrize("size", [3, 9, 40, 120, 10_000])
def test_equal_distance_takes_the_nearest_cells_through_the_fuel(ground, size):
    fuel, start = ground
    grown = nulls.equal_distance(fuel, start, size)
    distance = {cell: round(length, 6) for cell, length in twin.distances(fuel, start).items()}
    assert twin.cells(grown) == twin.rates(distance, size)


def test_equal_distance_never_crosses_land_without_fuel():
    fuel = np.ones(SHAPE, bool)
    fuel[:, 9] = False
    start = np.zeros(SHAPE, bool)
    start[6, 2] = True
    grown = nulls.equal_distance(fuel, start, 10_000)
    assert grown.sum() == 13 * 9
    assert not grown[:, 9:].any()
    calm = nulls.wind_ellipse(fuel, start, 10_000, wind_speed=0, wind_from_direction=0)
    assert np.array_equal(calm, fuel)


def test_equal_distance_grows_octagons():
    start = np.zeros((41, 41), bool)
    start[20, 20] = True
    grown = nulls.equal_distance(np.ones((41, 41), bool), start, 800)
    row, col = np.argwhere(grown).T - 20
    octile = np.maximum(abs(row), abs(col)) + (math.sqrt(2) - 1) * np.minimum(abs(row), abs(col))
    outside = np.argwhere(~grown).T - 20
    assert octile.max() <= (abs(outside).max(axis=0) + (math.sqrt(2) - 1) * abs(outside).min(axis=0)).min() + 1e-9
    assert octile.max() == pytest.approx(math.sqrt(800 / math.sqrt(8)), rel=0.05)


@pytest.mark.parametrize("size", [9, 40, 120])
@pytest.mark.parametrize(("wind", "direction"), [(0, 0), (4, 270), (7, 200)])
def test_the_ellipse_is_one(ground, size, wind, direction):
    """The cells taken are those in ellipses, grown about every cell of the start's rim, of the same length."""
    fuel, start = ground
    grown = nulls.wind_ellipse(fuel, start, size, wind_speed=wind, wind_from_direction=direction)
    assert grown.sum() == size
    assert grown[start].all()
    assert not grown[~fuel & ~start].any()
    ratio, course = nulls.length_to_breadth(wind), math.radians(direction + 180)
    rim = [c for c in twin.cells(start) if not all((c[0] + r, c[1] + s) in twin.cells(start) for r, s in twin.STEPS)]

    def reached(length):
        return {
            (r, c)
            for r, c in twin.cells(fuel | start)
            if start[r, c] or any(twin.in_ellipse(r, c, focus, ratio, course, length) for focus in rim)
        }

    low, high = 1e-6, 4000.0
    for _ in range(33):  # the longest ellipse that holds no more cells than were taken
        middle = (low + high) / 2
        low, high = (middle, high) if len(reached(middle)) <= size else (low, middle)
    assert reached(low) <= twin.cells(grown) <= reached(high + 1e-6)


def test_the_ellipse_blows_with_the_wind_and_turns_with_it():
    fuel, start = np.ones((61, 61), bool), np.zeros((61, 61), bool)
    start[30, 30] = True
    west = nulls.wind_ellipse(fuel, start, 200, wind_speed=5, wind_from_direction=270)
    row, col = np.argwhere(west).T - 30
    assert col.mean() > 5
    assert abs(row.mean()) < 0.2
    north = nulls.wind_ellipse(fuel, start, 200, wind_speed=5, wind_from_direction=0)
    assert np.count_nonzero(north ^ np.rot90(west, -1)) <= 6  # ties
    length, breadth = np.ptp(col) + 1, np.ptp(row) + 1
    assert length / breadth == pytest.approx(nulls.length_to_breadth(5), rel=0.2)


def test_length_to_breadth_rises_and_ends():
    values = [nulls.length_to_breadth(v) for v in (0, 1, 3, 6, 9, 12, 60)]
    assert values[0] == pytest.approx(1.0)
    assert values == sorted(values)
    assert values[-1] == 8.0
    # Anderson's own form, in miles an hour, before the constant was added.
    mph = 4 / 0.44704
    assert nulls.length_to_breadth(4) + 0.397 == pytest.approx(
        0.936 * math.exp(0.1147 * mph) + 0.461 * math.exp(-0.0692 * mph), rel=1e-3
    )
    for bad in (-1.0, math.nan, math.inf):
        with pytest.raises(ParameterError, match="wind_speed"):
            nulls.length_to_breadth(bad)
    with pytest.raises(ParameterError, match="ratio"):
        nulls.wind_ellipse(np.ones((3, 3)), np.eye(3), 3, wind_speed=0, wind_from_direction=0, ratio=0.5)


def test_a_fire_must_start_somewhere():
    nowhere = np.zeros(SHAPE, bool)
    for grow in (
        lambda: nulls.equal_distance(~nowhere, nowhere, 5),
        lambda: nulls.wind_ellipse(~nowhere, nowhere, 5, wind_speed=1, wind_from_direction=0),
    ):
        with pytest.raises(InputError, match="starts nowhere"):
            grow()


def test_mean_wind_is_that_of_the_vectors():
    assert nulls.mean_wind(np.array([3.0, 3.0]), np.array([0.0, 90.0])) == (3.0, pytest.approx(45.0))
    speed, direction = nulls.mean_wind(np.array([1.0, 9.0]), np.array([180.0, 270.0]))
    assert speed == 5.0
    assert direction == pytest.approx(math.degrees(math.atan2(-9, -1)) % 360)
