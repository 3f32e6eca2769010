"""What kernels of fires with a clock are given of a network, laid out as they read it."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np

from firebreak_gis.lattice import NEVER

if TYPE_CHECKING:
    from firebreak_gis.kernels.arrival import Clock
    from firebreak_gis.kernels.draws import Thresholds

T = TypeVar("T")


def clock_of(times: Sequence[np.ndarray], starts: np.ndarray, longest: int, *, embers: bool) -> tuple[Clock, int]:
    """Times as kernels read them, and how many buckets ahead a step leads at most.

    Parameters
    ----------
    times, starts
        Of the steps of a weather, as in `timed.Group`.
    longest
        How long the longest run burns [s].
    embers
        Whether they fly.
    """
    from firebreak_gis.kernels.arrival import Clock
    from firebreak_gis.kernels.embers import SOONEST

    if not times:  # all that matters is that fire comes
        return Clock(np.ones(8, np.uint32), np.zeros(0, np.uint64), np.uint64(0)), 2
    # Steps that begin after the last fire has ended are not needed.
    n_steps = max(int(np.count_nonzero(starts < longest)), 1)
    seconds, least, most = _SECONDS.of(times[:n_steps])
    if embers:
        least = min(least, SOONEST)
    shift = max(least.bit_length() - 1, 0) if least < NEVER else 0
    clock = Clock(seconds, starts[1:n_steps].astype(np.uint64), np.uint64(shift))
    return clock, min(most, longest) >> shift


def _laid_out(*times: np.ndarray) -> tuple[np.ndarray, int, int]:
    """Times of the steps of a weather as kernels read them, and the least and the most of any of them."""
    from firebreak_gis.kernels.arrival import lay_out

    n_cells = times[0][0].size
    seconds = np.empty((len(times), n_cells, 8), np.uint32)
    ends = [lay_out(np.asarray(step).reshape(8, n_cells), laid) for step, laid in zip(times, seconds, strict=True)]
    return seconds.ravel(), int(min(least for least, _ in ends)), int(max(most for _, most in ends))


def _thresholds(probability: np.ndarray) -> Thresholds:
    from firebreak_gis.kernels.draws import thresholds

    return thresholds(probability)


class _Last(Generic[T]):
    """What was made of arrays, kept while they live and nothing is made of others: designs burn one network often."""

    def __init__(self, make: Callable[..., T]) -> None:
        self._make = make
        self._kept: tuple[list[weakref.ref[np.ndarray]], T] | None = None

    def of(self, arrays: Sequence[np.ndarray]) -> T:
        """Make it of arrays that do not change, or return what was made of them."""
        kept = self._kept  # other threads may put theirs here at any time
        if kept is not None and [id(ref()) for ref in kept[0]] == [id(array) for array in arrays]:
            return kept[1]
        made = self._make(*arrays)
        self._kept = [weakref.ref(array, self._forget) for array in arrays], made
        return made

    def _forget(self, ref: weakref.ref[np.ndarray]) -> None:
        if self._kept is not None and any(ref is each for each in self._kept[0]):
            self._kept = None


#: Draw thresholds of the probabilities of a network.
THRESHOLDS = _Last(_thresholds)
_SECONDS = _Last(_laid_out)
