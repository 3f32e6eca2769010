"""Words as sets of bits: counting, finding, transposing. Each is a few instructions without a branch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir  # type: ignore[import-untyped]
from numba import types
from numba.extending import intrinsic

from firebreak_gis.kernels.policy import inlined

_ONE = np.uint64(1)


@inlined
def popcount(bits: np.uint64) -> np.uint64:
    """Number of ones; compilers know this form and make one instruction of it."""
    x = bits - ((bits >> np.uint64(1)) & np.uint64(0x5555555555555555))
    x = (x & np.uint64(0x3333333333333333)) + ((x >> np.uint64(2)) & np.uint64(0x3333333333333333))
    x = (x + (x >> np.uint64(4))) & np.uint64(0x0F0F0F0F0F0F0F0F)
    return (x * np.uint64(0x0101010101010101)) >> np.uint64(56)


def _lowest(typing_context: Any, bits: Any) -> Any:  # noqa: ARG001
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ARG001
        return builder.cttz(arguments[0], ir.Constant(ir.IntType(1), 0))  # 64 where there is none

    return types.uint64(types.uint64), generate


#: ``lowest(bits)`` is the position of the lowest one; `bits` is not zero. Asked of the compiler by name: where it knows
#: some bits, it does not see that a form of counting is one instruction.
lowest: Callable[[np.uint64], np.uint64] = intrinsic(_lowest)


@inlined
def highest(bits: np.uint64) -> np.uint64:
    """Position of the highest one; `bits` is not zero."""
    x = bits | (bits >> np.uint64(1))
    x |= x >> np.uint64(2)
    x |= x >> np.uint64(4)
    x |= x >> np.uint64(8)
    x |= x >> np.uint64(16)
    x |= x >> np.uint64(32)
    return popcount(x) - _ONE


@inlined
def not_zero(first: np.uint64, second: np.uint64, third: np.uint64) -> np.uint64:
    """Bits 0, 1, 2: which of the three words is not zero."""
    return (
        np.uint64(first != np.uint64(0))
        | (np.uint64(second != np.uint64(0)) << np.uint64(1))
        | (np.uint64(third != np.uint64(0)) << np.uint64(2))
    )


# Steps of the transposition of eight words of eight bytes: swap the upper half (quarters, eighths) of `a` with
# the lower half (quarters, eighths) of `b`.


@inlined
def swap_halves(a: np.uint64, b: np.uint64) -> tuple[np.uint64, np.uint64]:
    """Swap four bytes of `a` with four of `b`."""
    t = ((a >> np.uint64(32)) ^ b) & np.uint64(0x00000000FFFFFFFF)
    return a ^ (t << np.uint64(32)), b ^ t


@inlined
def swap_pairs(a: np.uint64, b: np.uint64) -> tuple[np.uint64, np.uint64]:
    """Swap every other pair of bytes of `a` with those of `b`."""
    t = ((a >> np.uint64(16)) ^ b) & np.uint64(0x0000FFFF0000FFFF)
    return a ^ (t << np.uint64(16)), b ^ t


@inlined
def swap_bytes(a: np.uint64, b: np.uint64) -> tuple[np.uint64, np.uint64]:
    """Swap every other byte of `a` with those of `b`."""
    t = ((a >> np.uint64(8)) ^ b) & np.uint64(0x00FF00FF00FF00FF)
    return a ^ (t << np.uint64(8)), b ^ t
