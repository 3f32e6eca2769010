"""The keyed generator: known answers, the twin, frequencies and independence."""

import numpy as np
import pytest
from scipy import stats

from firebreak_gis.kernels import draws
from firebreak_gis.kernels.policy import kernel
from tests.twins import percolation as twin


@kernel
def _open_all(top, rest, keys, out):
    for i in range(keys.size):
        for cell in range(top.size):
            out[i, cell] = draws.open_edges(keys[i], np.uint64(cell), top[cell], rest)


def opened(probability, keys):
    """(runs, cells, 8) bool: which edges open."""
    limits = draws.thresholds(probability)
    out = np.empty((keys.size, limits.top.size), np.uint64)
    _open_all(limits.top, limits.rest, keys, out)
    high = np.arange(8, dtype=np.uint64) * np.uint64(8) + np.uint64(7)
    return ((out[..., None] >> high) & np.uint64(1)).astype(bool)


def test_published_words_of_splitmix64():
    expected = [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
        4593380528125082431,
        16408922859458223821,
    ]
    assert draws.words(np.uint64(1234567), 0, 5).tolist() == expected
    assert [twin.word(1234567, n) for n in range(5)] == expected
    assert draws.words(np.uint64(1234567), 3, 2).tolist() == expected[3:]


def test_keys_differ_by_seed_purpose_and_run():
    keys = [int(draws.stream_key(s, p)) for s in range(20) for p in draws.PURPOSES]
    keys += draws.run_keys(0, "edges", 500).tolist()
    assert len(set(keys)) == len(keys)
    assert (draws.run_keys(3, "edges", 10) == draws.run_keys(3, "edges", 90)[:10]).all()


def test_seeds_for_a_purpose():
    """Published: other values would change every plan and comparison."""
    assert draws.PURPOSES[9:12] == ("design", "check", "comparison")
    known = [draws.seed_for(0, purpose) for purpose in ("design", "check", "comparison")]
    assert known == [5949034261645103510, 7570335421732594259, 1185441883537222340]
    derived = [draws.seed_for(s, p) for s in range(30) for p in ("design", "check", "comparison")]
    assert len(set(derived)) == len(derived)
    assert all(30 < seed < 2**63 for seed in derived)
    keys = [int(k) for s in derived for k in draws.run_keys(s, "edges", 20)]
    keys += [int(k) for s in range(30) for k in draws.run_keys(s, "edges", 20)]
    assert len(set(keys)) == len(keys)


def test_edges_open_as_in_the_twin():
    rng = np.random.default_rng(0)
    probability = rng.random((8, 5, 7)).astype(np.float32)
    probability.ravel()[:60] = np.repeat(np.float32([0, 1, 1e-8, 1 - 2**-24, 0.5, 1 / 256]), 10)
    keys = draws.run_keys(7, "edges", 300)
    got = opened(probability, keys)
    flat = probability.reshape(8, -1)
    for run in range(0, 300, 7):
        for cell in range(35):
            for d in range(8):
                assert got[run, cell, d] == twin.is_open(int(keys[run]), cell, d, float(flat[d, cell]))


def test_digits_beyond_the_first_byte_count():
    """A threshold that shares its first byte with the draw is decided by the later ones."""
    keys = draws.run_keys(1, "edges", 40)
    checked = 0
    for key in keys:
        for cell in range(6):
            digits = twin.draw(int(key), cell, 3)
            for change, expected in ((1, True), (0, False), (-1, False)):
                limit = digits + change
                if not 0 < limit < 2**32 - 2:
                    continue
                probability = np.zeros((8, 2, 3), np.float64)
                probability.reshape(8, 6)[3, cell] = limit / 2**32
                assert opened(probability, np.array([key]))[0, cell, 3] == expected
                checked += 1
    assert checked > 600


@pytest.mark.parametrize("p", [0.0, 1e-4, 0.02, 1 / 256, 0.25, 0.5, 0.77, 0.999, 1.0])
def test_edges_open_as_often_as_they_should(p):
    got = opened(np.full((8, 40, 50), p, np.float32), draws.run_keys(11, "edges", 100))
    n, k = got.size, int(got.sum())
    if p in (0.0, 1.0):
        assert k == n * p
    else:
        assert abs(k - n * p) < 4.5 * np.sqrt(n * p * (1 - p)) + 1


def test_directions_cells_and_runs_are_independent():
    got = opened(np.full((8, 30, 40), 0.5, np.float32), draws.run_keys(5, "edges", 64)).astype(float) - 0.5
    n = got.size
    pairs = {
        "next direction": got * np.roll(got, 1, axis=2),
        "next cell": got * np.roll(got, 1, axis=1),
        "next row": got * np.roll(got, 40, axis=1),
        "next run": got * np.roll(got, 1, axis=0),
        "opposite edge": got[:, :-1, 2] * got[:, 1:, 6],
    }
    for name, product in pairs.items():
        z = 4 * product.sum() / np.sqrt(product.size)
        assert abs(z) < 4.5, name
    counts = np.bincount((got > 0).sum(axis=2).ravel(), minlength=9)
    expected = stats.binom.pmf(np.arange(9), 8, 0.5) * n / 8
    assert stats.chisquare(counts, expected).pvalue > 1e-4


def test_uniform_numbers():
    u = draws.uniforms(draws.stream_key(2, "ranking"), 100_000)
    assert u.min() >= 0
    assert u.max() < 1
    assert stats.kstest(u, "uniform").pvalue > 1e-3
    assert (u[10:20] == draws.uniforms(draws.stream_key(2, "ranking"), 10, start=10)).all()


def test_first_numbers_of_some_keys():
    keys = draws.run_keys(4, "durations", 50, first_run=7)
    np.testing.assert_array_equal(draws.first_uniforms(keys), [draws.uniforms(key, 1)[0] for key in keys])
