"""Probabilities, travel times and heat in 8 or 16 bits a number, and how far that takes them from what they were.

Probabilities go in equal steps from 0 to 1. Times and heat go in equal ratios from 1 to `lattice.LONGEST`, and 0 stays
0, so that their error is relative. The highest number stands for "no data".
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Final

import numpy as np

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import LONGEST
from firebreak_gis.schema import Variable

#: Variables that can be packed, and whether their steps are equal ratios.
_IN_RATIOS: Final = {"spread_probability": False, "travel_time": True, "heat": True}


def packed(variable: Variable, bits: int) -> Variable:
    """Return the variable as one that files hold in so many bits.

    Raises
    ------
    ParameterError
        If it cannot be packed, or not into so many bits.
    """
    if bits not in (8, 16):
        raise ParameterError(f"bits is {bits}, expected 8 or 16, or None for numbers as they are")
    if variable.name not in _IN_RATIOS:
        raise ParameterError(f"{variable.name} cannot be packed, expected one of {', '.join(_IN_RATIOS)}")
    return replace(variable, bits=bits)


def largest_error(name: str, bits: int) -> float:
    """Largest error of a probability; of a time, or of heat from 1 on, relative to its true value.

    Parameters
    ----------
    name
        Of the variable.
    bits
        8 or 16.

    Examples
    --------
    >>> f"{largest_error('spread_probability', 8):.1e}, {largest_error('travel_time', 16):.1e}"
    '2.0e-03, 1.3e-04'
    """
    # Numbers are float32 before and after.
    rounding = float(np.finfo(np.float32).eps)
    half = math.log(LONGEST) / (_top(bits) - 1) / 2 if _IN_RATIOS[name] else 0.5 / _top(bits)
    return (math.expm1(half) if _IN_RATIOS[name] else half) + rounding


def errors_of(bits: int, *, timed: bool) -> dict[str, float]:
    """The largest errors of a network in so many bits, by what they are called in tags and summaries."""
    errors = {"error_of_probability": largest_error("spread_probability", bits)}
    return errors | ({"relative_error_of_time": largest_error("travel_time", bits)} if timed else {})


def step(variable: Variable) -> float:
    """What codes times which are the values; 1 where they are not equal steps."""
    return 1.0 if _IN_RATIOS[variable.name] else 1.0 / _top(variable.bits)


def pack(values: np.ndarray, missing: np.ndarray, variable: Variable) -> np.ndarray:
    """Return what a file holds, (..., rows, cols) uint8 or uint16.

    Parameters
    ----------
    values
        (..., rows, cols), within the range of the variable where not `missing`.
    missing
        (..., rows, cols) bool.
    variable
        From `packed`.

    Raises
    ------
    InputError
        If a value is larger than can be packed.
    """
    out = np.empty(values.shape, f"uint{variable.bits}")
    if values.ndim > 2:  # plane by plane, for the memory
        for plane, gone, into in zip(values, missing, out, strict=True):
            into[:] = pack(plane, gone, variable)
        return out
    known = np.where(missing, 0.0, values.astype(np.float64))  # logarithms in float32 would miss by a step
    top = _top(variable.bits)
    if _IN_RATIOS[variable.name]:
        if known.size and known.max() > LONGEST:
            raise InputError(f"{variable.name} goes up to {known.max():g}, more than the {LONGEST} that can be packed")
        steps = 1.0 + np.log(np.maximum(known, 1.0)) / math.log(LONGEST) * (top - 1)
        known = np.where(known < 0.5, 0.0, steps)
    else:
        known = known * float(top)
    out[:] = np.rint(known)
    out[missing] = top + 1
    return out


def unpack(codes: np.ndarray, variable: Variable) -> np.ndarray:
    """Return the numbers that `pack` made codes of, float32, NaN for "no data"."""
    numbers: np.ndarray = _numbers(variable.name, variable.bits)[codes]
    return numbers


def _top(bits: int) -> int:
    return (1 << bits) - 2


@cache
def _numbers(name: str, bits: int) -> np.ndarray:
    """The number of each code."""
    top = _top(bits)
    codes = np.arange(top + 1, dtype=np.float64)
    numbers = codes / top
    if _IN_RATIOS[name]:
        numbers = np.where(codes > 0, np.exp((codes - 1) / (top - 1) * math.log(LONGEST)), 0.0)
    out = np.append(np.minimum(numbers, LONGEST), np.nan).astype(np.float32)
    out.flags.writeable = False
    return out
