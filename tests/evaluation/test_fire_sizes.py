"""Sizes of many fires, and the durations that explain them."""

import math

import numpy as np
import pytest
from scipy import stats

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation import fire_sizes
from firebreak_gis.evaluation.fire_sizes import Durations, Growth

TIMES = np.geomspace(600, 400 * 3600, 16)


def growing(n_runs=300, seed=0, cap=50_000.0):
    """Fires that grow with the square of time at their own rates; each meets a sea somewhere."""
    random = np.random.default_rng(seed)
    rate = np.exp(random.normal(0.0, 0.5, n_runs))
    shore = cap * np.exp(random.normal(-2.0, 1.5, n_runs))
    sizes = 10.0 * (rate[:, None] * TIMES / 3600) ** 2
    return Growth(TIMES, np.minimum(sizes, shore[:, None]))


def drawn(growth, durations, n_fires, seed):
    sizes = fire_sizes.sample_sizes(growth, durations, seed=seed, draws=20)
    return np.random.default_rng(seed).permutation(sizes)[:n_fires]


def test_sizes_at_a_time_and_times_of_a_size_are_each_others_inverse():
    growth = growing()
    seconds = np.full(300, 7000.0)
    sizes = growth.at(seconds)
    grows = sizes < growth.hectares[:, -1] * 0.99
    back = np.array([Growth(TIMES, growth.hectares[i : i + 1]).log_time_of(sizes[i : i + 1])[0, 0] for i in range(300)])
    assert np.exp(back[grows]) == pytest.approx(7000.0, rel=1e-6)
    ends = growth.log_time_of(np.array([1e-6, 1e12]))
    assert (ends[:, 0] == -np.inf).all()
    assert (ends[:, 1] == np.inf).all()


def test_at_and_times_against_numpy_run_by_run():
    growth = growing(20, seed=3)
    seconds = np.random.default_rng(1).uniform(100, 2e6, 20)
    expected = [
        np.exp(np.interp(np.log(t), np.log(TIMES), np.log(line)))
        for t, line in zip(seconds, growth.hectares, strict=True)
    ]
    assert growth.at(seconds) == pytest.approx(expected)
    size = 137.0
    for log_time, line in zip(growth.log_time_of(np.array([size]))[:, 0], growth.hectares, strict=True):
        if line[-1] <= size:
            assert log_time == np.inf
        else:
            assert np.exp(np.interp(log_time, np.log(TIMES), np.log(line))) == pytest.approx(size)


def test_growth_ends_where_it_is_told():
    growth = growing(20, seed=3)
    short = growth.until(9 * 3600.0)
    assert short.times[-1] == 9 * 3600.0
    early = np.full(20, 5000.0)
    assert short.at(early) == pytest.approx(growth.at(early))
    assert short.at(np.full(20, 1e6)) == pytest.approx(growth.at(np.full(20, 9 * 3600.0)))
    size = float(np.median(short.hectares[:, -1])) * 1.01
    assert np.isinf(short.log_time_of(np.array([size]))).sum() >= 10


@pytest.mark.parametrize("durations", [Durations(5 * 3600, 0.4), Durations(12 * 3600, 1.5)])
def test_the_formula_is_what_drawing_gives(durations):
    growth = growing()
    sizes = np.array([5.0, 50.0, 500.0, 5000.0])
    drawn_sizes = fire_sizes.sample_sizes(growth, durations, draws=200)
    expected = [(drawn_sizes <= size).mean() for size in sizes]
    assert fire_sizes.share_within(growth, sizes, durations) == pytest.approx(expected, abs=0.01)


def test_faster_fires_are_longer_fires():
    """Rates c times as high and times c times as long are one thing."""
    growth, sizes = growing(), np.geomspace(1, 1e5, 20)
    fast = Growth(TIMES / 3.0, growth.hectares)
    assert fire_sizes.share_within(fast, sizes, Durations(3600, 1.0)) == pytest.approx(
        fire_sizes.share_within(growth, sizes, Durations(3 * 3600, 1.0))
    )


@pytest.mark.parametrize("truth", [Durations(4 * 3600, 1.0), Durations(10 * 3600, 0.5)])
def test_fitted_durations_are_those_that_made_the_fires(truth):
    growth = growing(300)
    found = fire_sizes.fit_durations(growth, drawn(growth, truth, 1000, 5), least=20.0)
    assert found.median == pytest.approx(truth.median, rel=0.2)
    assert found.sigma == pytest.approx(truth.sigma, rel=0.2)


def test_small_fires_do_not_count():
    growth, truth = growing(), Durations(4 * 3600, 1.0)
    sizes = drawn(growth, truth, 500, 2)
    once = fire_sizes.fit_durations(growth, sizes, least=100.0)
    more = fire_sizes.fit_durations(growth, np.concatenate([sizes, np.full(300, 3.0)]), least=100.0)
    assert more == once


def test_the_distance_is_that_of_anderson_and_darling():
    sizes = np.sort(np.random.default_rng(0).random(40))
    known = -40 - sum((2 * i - 1) * (math.log(sizes[i - 1]) + math.log(1 - sizes[40 - i])) for i in range(1, 41)) / 40
    assert fire_sizes._anderson_darling(sizes) == pytest.approx(known)
    even = (np.arange(40) + 0.5) / 40
    assert fire_sizes._anderson_darling(even) < 0.1 < fire_sizes._anderson_darling(even**3)


def test_left_out_fires_lie_evenly_where_the_model_is_true():
    growth, truth = growing(), Durations(4 * 3600, 1.2)
    sizes = np.append(drawn(growth, truth, 60, 9), 1.0)
    places = fire_sizes.leave_one_out(growth, sizes, least=20.0)
    assert np.isnan(places[sizes < 20]).all()
    kept = places[sizes >= 20]
    assert stats.kstest(kept, "uniform").pvalue > 0.01
    moved = fire_sizes.leave_one_out(Growth(TIMES, growth.hectares), np.append(sizes[:-1], 30_000.0), least=20.0)
    assert moved[-1] > np.nanmax(kept) - 1e-9  # a fire larger than all others is not foretold by them


def test_rate_factor():
    growth = growing(800, cap=1e9)
    seconds = np.random.default_rng(3).uniform(3600, 20 * 3600, 400)
    picked = np.random.default_rng(4).integers(0, 800, 400)
    for factor in (0.5, 1.0, 2.5):
        sizes = Growth(TIMES, growth.hectares[picked]).at(factor * seconds)
        assert fire_sizes.rate_factor(growth, sizes, seconds) == pytest.approx(factor, rel=0.1)
    with pytest.raises(ParameterError, match="no fire has both"):
        fire_sizes.rate_factor(growth, np.zeros(0), np.zeros(0))
    with pytest.raises(InputError, match="no simulated fire reaches"):
        fire_sizes.rate_factor(growth, np.array([1e15]), np.array([1.0]))


def test_too_few_fires_and_fires_out_of_reach_are_refused():
    growth = growing()
    with pytest.raises(ParameterError, match="1 fires of at least 100 ha cannot tell 2 parameters"):
        fire_sizes.fit_durations(growth, np.array([200.0, 5.0]), least=100.0)
    with pytest.raises(InputError, match="no simulated fire grows to 1e\\+09 ha within 400 h"):
        fire_sizes.fit_durations(growth, np.array([1e9, 2e9]), least=100.0)


def test_statistics_and_their_intervals():
    sizes = np.array([1.0, 50.0, 100.0, 200.0, 300.0, 2400.0])
    found = fire_sizes.statistics(sizes, least=100.0, large=1000.0)
    assert found == {"median_ha": 250.0, "p90_ha": pytest.approx(1770.0), "large_share": 2400 / 3051}
    ends = fire_sizes.bootstrap(sizes, least=100.0, large=1000.0)
    assert ends["median_ha"][0] < 250 < ends["median_ha"][1]
    assert ends["large_share"][0] == 0.0
    assert fire_sizes.bootstrap(sizes, least=100.0, large=1000.0) == ends
    assert np.isnan(fire_sizes.statistics(sizes, least=1e6, large=1e7)["median_ha"])
    with pytest.raises(InputError, match="no fire has"):
        fire_sizes.bootstrap(sizes, least=1e6, large=1e7)
