"""Keyed random draws: the outcome of one trial depends on (seed, purpose, run, index) alone.

The generator is SplitMix64 (Steele, Lea, Flood 2014, doi 10.1145/2714064.2660195) read at any position:
word n of the stream of `key` is mix64(key + (n + 1) * GAMMA). A key is made from (seed, purpose, block) by
numpy's SeedSequence.

Runs are drawn 64 at a time. The uniform number of (run, index) is spread over the words of block
run // 64: its binary digit j, from the most significant, is bit run % 64 of word 32 * index + j. Whether it
lies below a threshold is known after two digits on average, so one run reads two words a trial, and all 64
runs together about eight. One run alone and 64 at once therefore see the same draws, to the bit.
"""

from __future__ import annotations

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

GAMMA = np.uint64(0x9E3779B97F4A7C15)
_MIX_1 = np.uint64(0xBF58476D1CE4E5B9)
_MIX_2 = np.uint64(0x94D049BB133111EB)

#: Runs that share a block of words.
LANES = 64
#: Binary digits of a draw: probabilities are resolved to 2**-32.
DIGITS = 32
#: Threshold that stands for certainty.
CERTAIN = np.uint32(0xFFFFFFFF)

#: What a stream is for; part of the key, so that purposes never share draws.
PURPOSES = ("edges", "ignitions", "ranking", "forest", "pivots")


def stream_key(seed: int, purpose: str, block: int = 0) -> np.uint64:
    """Key of the stream for (seed, purpose, block).

    Parameters
    ----------
    seed
        Any integer >= 0.
    purpose
        One of `PURPOSES`.
    block
        run // 64 for draws by run, else 0.
    """
    sequence = np.random.SeedSequence([seed, PURPOSES.index(purpose), block])
    return np.uint64(sequence.generate_state(1, np.uint64)[0])


def stream_keys(seed: int, purpose: str, n_runs: int) -> np.ndarray:
    """Keys of all blocks that `n_runs` runs need: (ceil(n_runs / 64),) uint64."""
    n_blocks = -(-n_runs // LANES)
    return np.array([stream_key(seed, purpose, block) for block in range(n_blocks)], dtype=np.uint64)


@inlined
def word(key: np.uint64, position: np.uint64) -> np.uint64:
    """Word at `position` of the stream of `key`."""
    z = key + (position + np.uint64(1)) * GAMMA
    z = (z ^ (z >> np.uint64(30))) * _MIX_1
    z = (z ^ (z >> np.uint64(27))) * _MIX_2
    return z ^ (z >> np.uint64(31))


@kernel
def words(key: np.uint64, start: int, count: int) -> np.ndarray:
    """Words `start` .. `start + count - 1` of the stream of `key`, (count,) uint64."""
    out = np.empty(count, np.uint64)
    for i in range(count):
        out[i] = word(key, np.uint64(start + i))
    return out


def uniforms(key: np.uint64, count: int, start: int = 0) -> np.ndarray:
    """`count` uniform numbers in [0, 1) with 53 digits from the stream of `key`, (count,) float64."""
    return (words(key, start, count) >> np.uint64(11)).astype(np.float64) * 2.0**-53


def thresholds(probability: np.ndarray) -> np.ndarray:
    """Draw thresholds of probabilities, edges of a cell side by side.

    Parameters
    ----------
    probability
        (8, rows, cols), in [0, 1].

    Returns
    -------
    numpy.ndarray
        (rows * cols, 8) uint32: a trial succeeds when its 32-digit draw is below; `CERTAIN` always does.
    """
    n_cells = probability.shape[1] * probability.shape[2]
    out = np.empty((n_cells, 8), np.uint32)
    _fill_thresholds(np.ascontiguousarray(probability).reshape(8, n_cells), out)
    return out


@kernel
def _fill_thresholds(probability: np.ndarray, out: np.ndarray) -> None:
    for cell in range(out.shape[0]):
        for d in range(8):
            p = np.float64(probability[d, cell])
            if p >= 1.0:
                out[cell, d] = CERTAIN
            else:
                out[cell, d] = np.uint32(min(np.floor(p * 4294967296.0 + 0.5), 4294967294.0))


@inlined
def trials(key: np.uint64, index: np.uint64, threshold: np.uint32, lanes: np.uint64) -> np.uint64:
    """Lanes out of `lanes` whose draw at `index` lies below `threshold`."""
    opened = np.uint64(0)
    if threshold == CERTAIN:
        opened = lanes
    else:
        undecided = lanes
        position = index * np.uint64(DIGITS)
        rest = threshold
        # Digits of the threshold leave at the top; when none is left, no undecided draw is below.
        while undecided != np.uint64(0) and rest != np.uint32(0):
            digits = word(key, position)
            if rest & np.uint32(0x80000000):
                opened |= undecided & ~digits
                undecided &= digits
            else:
                undecided &= ~digits
            rest = np.uint32(rest << np.uint32(1))
            position += np.uint64(1)
    return opened


@inlined
def trial(key: np.uint64, index: np.uint64, threshold: np.uint32, lane: np.uint64) -> bool:
    """Whether the draw of one lane at `index` lies below `threshold`."""
    opened = threshold == CERTAIN
    position = index * np.uint64(DIGITS)
    rest = threshold
    undecided = not opened
    while undecided and rest != np.uint32(0):
        digit = (word(key, position) >> lane) & np.uint64(1)
        limit = np.uint64(rest >> np.uint32(31))
        if digit != limit:
            opened = limit == np.uint64(1)
            undecided = False
        rest = np.uint32(rest << np.uint32(1))
        position += np.uint64(1)
    return opened
