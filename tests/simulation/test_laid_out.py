"""What kernels are given is made once for a network that is burnt again and again, and goes with it."""

from __future__ import annotations

import weakref

import numpy as np
import pytest

from firebreak_gis.kernels.draws import thresholds
from firebreak_gis.lattice import NEVER
from firebreak_gis.simulation.laid_out import THRESHOLDS, clock_of


def times_of(seed: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    times = random.integers(2**seed, 900, (8, 4, 5)).astype(np.uint32)
    times[random.random(times.shape) < 0.3] = NEVER
    return times


def test_thresholds_are_kept_while_the_network_lives_and_no_other_is_asked_for():
    one, other = (np.random.default_rng(seed).random((8, 4, 5), np.float32) for seed in (1, 2))
    first = THRESHOLDS.of([one])
    assert THRESHOLDS.of([one]) is first
    for plane in (other, one):
        for found, expected in zip(THRESHOLDS.of([plane]), thresholds(plane), strict=True):
            assert (found == expected).all()
    gone = weakref.ref(THRESHOLDS.of([one]).top)
    del one, plane, found, expected
    assert gone() is None


@pytest.mark.parametrize("n_steps", [1, 2])
def test_times_are_laid_out_cell_by_cell(n_steps):
    times = [times_of(seed) for seed in range(n_steps)]
    starts = np.arange(n_steps, dtype=np.uint64) * np.uint64(3600)
    for _ in range(2):  # made, and kept
        clock, span = clock_of(times, starts, 10_000, embers=False)
        seconds = clock.seconds.reshape(n_steps, 20, 8)
        for laid, step in zip(seconds, times, strict=True):
            for d in range(8):
                assert (laid[:, d] == step[d].ravel()).all()
        known = np.concatenate([step[step != NEVER] for step in times])
        assert 2 ** int(clock.shift) <= known.min() < 2 ** (int(clock.shift) + 1)
        assert span == int(known.max()) >> int(clock.shift)
    shorter, _ = clock_of(times, starts, 3600, embers=False)
    assert shorter.seconds.size == 160
