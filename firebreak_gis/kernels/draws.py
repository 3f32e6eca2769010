"""Keyed random draws: the outcome of one trial depends on (seed, purpose, run, edge) alone.

The generator is SplitMix64 (Steele, Lea, Flood 2014, doi 10.1145/2714064.2660195) read at any position:
word n of the stream of `key` is mix64(key + (n + 1) * GAMMA). The key of a purpose comes from numpy's
SeedSequence, the key of run i is word i of that purpose's stream.

A cell tries its eight edges at once. The draw of the edge in direction d of a cell has 32 binary digits: its
byte j, from the most significant, is byte d of word 4 * cell + j of the run's stream. One word therefore
decides all eight edges unless a byte equals that of the threshold (once in 256), and the order in which
cells are visited, one run at a time or 64 together, makes no difference to any bit.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from firebreak_gis.kernels.policy import inlined, kernel

GAMMA = np.uint64(0x9E3779B97F4A7C15)
_MIX_1 = np.uint64(0xBF58476D1CE4E5B9)
_MIX_2 = np.uint64(0x94D049BB133111EB)

#: Threshold that stands for certainty.
CERTAIN = 0xFFFFFFFF
_HIGH = np.uint64(0x8080808080808080)
_ONES = np.uint64(0x0101010101010101)

#: What a stream is for; part of the key, so that purposes never share draws.
PURPOSES = (
    "edges",
    "ignitions",
    "ranking",
    "forest",
    "pivots",
    "durations",
    "weather",
    "embers",
    "hold",
    "design",
    "check",
    "comparison",
    "places",
    "containment",
    "ground",
)


class Thresholds(NamedTuple):
    """Draw thresholds of all edges, byte d of a word for direction d.

    Parameters
    ----------
    top
        (n_cells,) uint64: most significant byte of the eight thresholds of a cell.
    rest
        (n_cells, 3) uint64: the other bytes, most significant first.
    """

    top: np.ndarray
    rest: np.ndarray


def stream_key(seed: int, purpose: str) -> np.uint64:
    """Key of the stream of (seed, purpose); `purpose` is one of `PURPOSES`, `seed` any integer >= 0."""
    sequence = np.random.SeedSequence([seed, PURPOSES.index(purpose)])
    return np.uint64(sequence.generate_state(1, np.uint64)[0])


def seed_for(seed: int, purpose: str) -> int:
    """Seed of fires that share no draw with those of `seed` itself, nor with those for another purpose.

    Designs see the fires "design", a plan that was improved is checked on "check", and comparisons burn "comparison",
    so that no plan is judged on fires that it has seen.
    """
    return int(stream_key(seed, purpose)) >> 1  # fits into 64 bits with a sign, as files and tables keep it


def run_keys(seed: int, purpose: str, n_runs: int, first_run: int = 0) -> np.ndarray:
    """Keys of runs first_run .. first_run + n_runs - 1, (n_runs,) uint64."""
    return words(stream_key(seed, purpose), first_run, n_runs)


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
    return _numbers(words(key, start, count))


def first_uniforms(keys: np.ndarray) -> np.ndarray:
    """The first of the `uniforms` of each of some keys, (n,) uint64: (n,) float64."""
    return _numbers(_first_words(keys))


def _numbers(drawn: np.ndarray) -> np.ndarray:
    return (drawn >> np.uint64(11)).astype(np.float64) * 2.0**-53


@kernel
def _first_words(keys: np.ndarray) -> np.ndarray:
    out = np.empty(keys.size, np.uint64)
    for i in range(keys.size):
        out[i] = word(keys[i], np.uint64(0))
    return out


def thresholds(probability: np.ndarray) -> Thresholds:
    """Thresholds below which a 32-digit draw opens an edge; 1 always opens, 0 never.

    Parameters
    ----------
    probability
        (8, rows, cols) float32, in [0, 1].
    """
    n_cells = probability.shape[1] * probability.shape[2]
    out = Thresholds(np.empty(n_cells, np.uint64), np.empty((n_cells, 3), np.uint64))
    _fill_thresholds(np.ascontiguousarray(probability).reshape(8, n_cells), out.top, out.rest)
    return out


@inlined
def digits_of(p: float) -> np.uint64:
    """Threshold of a probability, 32 binary digits; `CERTAIN` for 1."""
    digits = np.uint64(CERTAIN)
    if p < 1.0:
        digits = np.uint64(min(np.floor(p * 4294967296.0 + 0.5), 4294967294.0))
    return digits


@kernel
def each_digits(chance: np.ndarray, out: np.ndarray) -> None:
    """Set `out`, (n,) uint32, to the thresholds of chances, (n,) float64."""
    for i in range(chance.size):
        out[i] = digits_of(chance[i]) if chance[i] > 0.0 else np.uint64(0)


@kernel
def _fill_thresholds(probability: np.ndarray, top: np.ndarray, rest: np.ndarray) -> None:
    # Planes by name, and the digits of `digits_of` without a branch: so the compiler does several cells at once.
    n, ne, e, se = probability[0], probability[1], probability[2], probability[3]
    s, sw, w, nw = probability[4], probability[5], probability[6], probability[7]
    later = rest.reshape(-1)
    for cell in range(top.shape[0]):
        first, second, third, last = np.uint64(0), np.uint64(0), np.uint64(0), np.uint64(0)
        shift = np.uint64(0)
        for p in (n[cell], ne[cell], e[cell], se[cell], s[cell], sw[cell], w[cell], nw[cell]):
            most = 4294967295.0 if p >= np.float32(1.0) else 4294967294.0
            digits = np.uint64(np.int64(min(np.float64(p) * 4294967296.0 + 0.5, most)))
            first |= (digits >> np.uint64(24)) << shift
            second |= ((digits >> np.uint64(16)) & np.uint64(255)) << shift
            third |= ((digits >> np.uint64(8)) & np.uint64(255)) << shift
            last |= (digits & np.uint64(255)) << shift
            shift += np.uint64(8)
        top[cell] = first
        later[3 * cell], later[3 * cell + 1], later[3 * cell + 2] = second, third, last


@inlined
def bytes_below(x: np.uint64, limit: np.uint64) -> np.uint64:
    """High bit of every byte of `x` that is smaller than the same byte of `limit`."""
    difference = (x | _HIGH) - (limit & ~_HIGH)
    return ((~x & limit) | (~(x ^ limit) & ~difference)) & _HIGH


@inlined
def bytes_equal(x: np.uint64, limit: np.uint64) -> np.uint64:
    """High bit of every byte in which `x` and `limit` agree."""
    z = x ^ limit
    return ~(((z & ~_HIGH) + ~_HIGH) | z) & _HIGH


@inlined
def open_edges(key: np.uint64, cell: np.uint64, top: np.uint64, rest: np.ndarray) -> np.uint64:
    """Edges of `cell` that are open in the run of `key`: the high bit of byte d for direction d."""
    digits = word(key, cell * np.uint64(4))
    opened = bytes_below(digits, top)
    undecided = bytes_equal(digits, top)
    if undecided != np.uint64(0):
        opened |= later_digits(key, cell, cell, top, rest, undecided)
    return opened


@kernel
def later_digits(
    key: np.uint64, number: np.uint64, cell: np.uint64, top: np.uint64, rest: np.ndarray, undecided: np.uint64
) -> np.uint64:
    """Edges that open of those whose first digits are the threshold's own; called for one cell in thirty.

    `number` is that of the cell on the whole map, `cell` where it stands in `rest`.
    """
    opened = np.uint64(0)
    certain = undecided & bytes_equal(top, ~np.uint64(0))
    for j in range(3):
        digits = word(key, number * np.uint64(4) + np.uint64(j + 1))
        limit = rest[cell, j]
        opened |= undecided & bytes_below(digits, limit)
        undecided &= bytes_equal(digits, limit)
        certain &= bytes_equal(limit, ~np.uint64(0))
    # All 32 digits of the draw equal the threshold, or it is certain whatever the draw.
    return opened | certain


@inlined
def below(digits: np.uint64, threshold: np.uint64) -> bool:
    """Whether a draw of 32 digits comes true at a threshold of `digits_of`."""
    return digits < threshold or threshold == np.uint64(CERTAIN)


@inlined
def edge_draw(key: np.uint64, cell: np.uint64, direction: np.uint64) -> np.uint64:
    """The 32 digits of the draw of one edge: those that `open_edges` compares, eight edges at a time."""
    digits = np.uint64(0)
    for j in range(4):
        byte = (word(key, cell * np.uint64(4) + np.uint64(j)) >> (np.uint64(8) * direction)) & np.uint64(255)
        digits = (digits << np.uint64(8)) | byte
    return digits


@inlined
def uniform(key: np.uint64, position: np.uint64) -> float:
    """Number in [0, 1) with 53 digits at `position` of the stream of `key`."""
    return np.float64(word(key, position) >> np.uint64(11)) * 2.0**-53


@inlined
def normal(key: np.uint64, position: np.uint64) -> float:
    """Standard normal number from one word of the stream of `key` (Box, Muller 1958, doi 10.1214/aoms/1177706645)."""
    digits = word(key, position)
    radius = (np.float64(digits >> np.uint64(32)) + 1.0) * 2.0**-32
    turn = np.float64(digits & np.uint64(0xFFFFFFFF)) * 2.0**-32
    return np.sqrt(-2.0 * np.log(radius)) * np.cos(2.0 * np.pi * turn)
