"""Words as sets of bits, against Python's own integers."""

import numpy as np

from firebreak_gis.kernels import bits
from firebreak_gis.kernels.policy import kernel

#: The highest bit of each byte.
HIGH = 0x8080808080808080


@kernel
def _told(words, some, out):
    """Count, lowest and highest of each word; the lowest also of a word of which the compiler knows some bits."""
    for i in range(words.size):
        out[i, 0] = bits.popcount(words[i])
        out[i, 1] = bits.lowest(words[i])
        out[i, 2] = bits.highest(words[i])
        out[i, 3] = bits.lowest(words[i] & some)


def test_bits_are_counted_and_found():
    random = np.random.default_rng(0)
    words = random.integers(1, 2**64, 500, dtype=np.uint64) >> random.integers(0, 64, 500, dtype=np.uint64)
    words = np.concatenate([words, np.uint64(1) << np.arange(64, dtype=np.uint64)])
    words = words[words & np.uint64(HIGH) > 0]
    out = np.zeros((words.size, 4), np.uint64)
    _told(words, np.uint64(HIGH), out)
    expected = [(bin(w).count("1"), _lowest(w), w.bit_length() - 1, _lowest(w & HIGH)) for w in words.tolist()]
    np.testing.assert_array_equal(out, expected)


def _lowest(word):
    return (word & -word).bit_length() - 1
