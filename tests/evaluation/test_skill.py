"""Scores of a simulated fire against a scar."""

import doctest

import numpy as np
import pytest

from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.evaluation import nulls, skill
from tests.twins import skill as twin

SHAPE = (7, 11)


def random_sets(seed):
    rng = np.random.default_rng(seed)
    return (rng.random(SHAPE) < share for share in (0.4, 0.5, 0.15))


@pytest.mark.parametrize("seed", range(5))
def test_overlap_is_that_of_the_sets(seed):
    burnt, observed, start = random_sets(seed)
    found = skill.overlap(burnt, observed, start=start)
    assert found == pytest.approx(twin.overlap(burnt, observed, start))
    without = skill.overlap(burnt, observed)
    assert without["growth_iou"] == without["iou"] == found["iou"]
    swapped = skill.overlap(observed, burnt, start=start)
    assert swapped["iou"] == found["iou"]
    assert swapped["sorensen"] == found["sorensen"]
    assert swapped["size_ratio"] == pytest.approx(1 / found["size_ratio"])


def test_overlap_at_the_ends():
    empty, some = np.zeros(SHAPE, bool), np.zeros(SHAPE, bool)
    some[2, 3:6] = True
    other = np.roll(some, 4, axis=0)
    assert skill.overlap(some, some) == {"sorensen": 1.0, "iou": 1.0, "growth_iou": 1.0, "size_ratio": 1.0}
    disjoint = skill.overlap(some, other)
    assert (disjoint["sorensen"], disjoint["iou"], disjoint["size_ratio"]) == (0.0, 0.0, 1.0)
    nothing = skill.overlap(empty, empty)
    assert (nothing["sorensen"], nothing["iou"]) == (1.0, 1.0)
    assert np.isnan(nothing["size_ratio"])
    assert skill.overlap(empty, some)["size_ratio"] == 0.0
    assert skill.overlap(some, empty)["size_ratio"] == np.inf
    assert skill.overlap(some, some, start=some)["growth_iou"] == 1.0  # neither grew
    with pytest.raises(GridError, match=r"burnt \(7, 11\), observed \(11, 7\)"):
        skill.overlap(some, some.T)


@pytest.mark.parametrize("seed", range(5))
def test_brier_and_reliability_are_those_of_the_cells(seed):
    rng = np.random.default_rng(seed)
    probability = rng.integers(0, 21, SHAPE) / 20  # many on the edges of bins
    observed, within = rng.random(SHAPE) < probability, rng.random(SHAPE) < 0.7
    assert skill.brier(probability, observed, within=within) == pytest.approx(twin.brier(probability, observed, within))
    for bins in (1, 5, 10):
        curve = skill.reliability(probability, observed, within=within, bins=bins)
        for k, (count, forecast, share) in enumerate(twin.reliability(probability, observed, within, bins)):
            assert curve.cells[k] == count
            if count:
                assert curve.forecast[k] == pytest.approx(forecast)
                assert curve.observed[k] == pytest.approx(share)
            else:
                assert np.isnan(curve.forecast[k])
                assert np.isnan(curve.observed[k])
    assert curve.cells.sum() == within.sum()


def test_a_perfect_and_an_inverse_forecast():
    _, observed, _ = random_sets(3)
    assert skill.brier(observed.astype(float), observed) == 0.0
    assert skill.brier(1.0 - observed, observed) == 1.0
    curve = skill.reliability(observed.astype(float), observed)
    assert curve.largest_gap(1) == 0.0
    assert skill.reliability(1.0 - observed, observed).largest_gap(1) == 1.0
    assert np.isnan(curve.largest_gap(1000))


def test_a_forecast_that_is_right_on_average_is_reliable():
    rng = np.random.default_rng(1)
    probability = rng.random((300, 300))
    observed = rng.random((300, 300)) < probability
    assert skill.reliability(probability, observed).largest_gap(100) < 0.03
    assert skill.reliability(np.sqrt(probability), observed).largest_gap(100) > 0.15


def test_impossible_probabilities_are_refused():
    observed = np.ones((2, 2), bool)
    for bad in (np.nan, -0.1, 1.1):
        with pytest.raises(InputError, match="from 0 to 1"):
            skill.brier(np.array([[bad, 0.0], [0.0, 0.0]]), observed)
    assert skill.brier(np.array([[np.nan, 1.0], [1.0, 1.0]]), observed, within=~np.eye(2, dtype=bool)) == 0.0
    with pytest.raises(InputError, match="no cell counts"):
        skill.brier(np.zeros((2, 2)), observed, within=np.zeros((2, 2), bool))
    with pytest.raises(ParameterError, match="bins"):
        skill.reliability(np.zeros((2, 2)), observed, bins=0)


def test_brier_skill():
    assert skill.brier_skill(0.0, 0.3) == 1.0
    assert skill.brier_skill(0.3, 0.3) == 0.0
    assert skill.brier_skill(0.6, 0.3) == -1.0
    assert skill.brier_skill(0.0, 0.0) == 0.0
    assert skill.brier_skill(0.1, 0.0) == -np.inf


def test_skill_does_not_depend_on_how_much_unburnt_land_counts():
    rng = np.random.default_rng(2)
    small = rng.random((10, 10))
    observed = rng.random((10, 10)) < small
    null = rng.random((10, 10)) < 0.3

    def of(pad):
        wide = [np.pad(plane.astype(float), pad) for plane in (small, observed, null)]
        return skill.brier_skill(skill.brier(wide[0], wide[1]), skill.brier(wide[2], wide[1]))

    assert of(0) == pytest.approx(of(7))


@pytest.mark.parametrize("size", [0, 1, 5, 30, 77])
def test_area_matched_takes_the_likeliest_cells(size):
    rng = np.random.default_rng(4)
    probability = np.round(rng.random(SHAPE), 1)
    probability[0, 0] = np.nan
    taken = skill.area_matched(probability, size)
    assert taken.sum() == min(size, (probability > 0).sum())
    if taken.any() and not taken.all():
        assert probability[taken].min() >= np.nan_to_num(probability[~taken]).max()


def test_time_of_size():
    times, sizes = np.array([1.0, 2.0, 4.0, 8.0]), np.array([1.0, 1.0, 5.0, 5.0])
    assert skill.time_of_size(times, sizes, 3.0) == 3.0
    assert skill.time_of_size(times, sizes, 5.0) == 4.0
    assert skill.time_of_size(times, sizes, 0.5) == 1.0
    assert np.isnan(skill.time_of_size(times, sizes, 5.1))
    for wrong in ((times[::-1], sizes), (times, sizes[::-1]), (times[:2], sizes), (times[:0], sizes[:0])):
        with pytest.raises(ParameterError, match="times must rise"):
            skill.time_of_size(*wrong, 3.0)


@pytest.mark.parametrize("module", [skill, nulls])
def test_examples_run(module):
    assert doctest.testmod(module).failed == 0
