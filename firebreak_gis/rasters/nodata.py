"""Values that stand for "no data", declared or not."""

from __future__ import annotations

import numpy as np

from firebreak_gis.errors import InputError

#: Numbers that programs write for "no data" without saying so; below the last one all are.
SENTINELS = (-9999.0, -99999.0, -32768.0, -32767.0, 32767.0, 65535.0, 1e20)
LOWEST_VALUE = -1e30


def is_value(values: np.ndarray, value: float) -> np.ndarray:
    """Return which values are a number that stands for "no data"."""
    if np.isnan(value):
        return np.isnan(values) if values.dtype.kind == "f" else np.zeros(values.shape, dtype=bool)
    if values.dtype.kind == "f":
        # -3.4e38 is written with different roundings by different programs.
        if abs(value) > 1e30:
            return np.abs(values / value - 1) < 1e-5
        return np.asarray(values == values.dtype.type(value))
    return np.asarray(values == int(value))


def undeclared_nodata(values: np.ndarray, valid: np.ndarray) -> list[float]:
    """Return well-known "no data" numbers that stand far off all other valid values.

    A number counts when it is the least or greatest value and its gap to the rest is wider than the
    range of the rest: -9999 among elevations of 0 to 2500 does, -9999 among -12000 to 500 does not.
    """
    found: list[float] = []
    rest = values[valid]
    for _ in range(2):
        if rest.size == 0:
            break
        for extreme in (float(rest.min()), float(rest.max())):
            if extreme not in SENTINELS and extreme > LOWEST_VALUE:
                continue
            others = rest[rest != extreme]
            if others.size == 0:
                continue
            low, high = float(others.min()), float(others.max())
            gap = low - extreme if extreme < low else extreme - high
            if gap > high - low or extreme <= LOWEST_VALUE:
                found.append(extreme)
                rest = others
                break
    return found


def told_of(found: list[float], path: str, *, strict: bool) -> list[str]:
    """Say that undeclared values were taken as "no data"; refuse them if strict."""
    if not found:
        return []
    text = ", ".join(f"{v:g}" for v in found)
    if strict:
        raise InputError(
            f"{path} uses {text} as no data without declaring it; "
            f"declare it: gdal_edit.py -a_nodata {found[0]:g} FILE (or --src-nodata)"
        )
    return [f"{text} is not declared as no data but stands for it; taken as no data"]


class Extremes:
    """The three least and the three greatest values of a raster that is read in parts.

    They are all that `undeclared_nodata` looks at, which takes out at most one value at a time, twice.
    """

    def __init__(self) -> None:
        self._kept = np.zeros(0)

    def add(self, values: np.ndarray, valid: np.ndarray) -> None:
        """Look at one more part, as `undeclared_nodata`."""
        rest = np.concatenate([self._kept, values[valid].astype(np.float64)])
        ends: list[float] = []
        for least in (True, False):
            left = rest
            for _ in range(3):
                if left.size:
                    ends.append(float(left.min() if least else left.max()))
                    left = left[left > ends[-1]] if least else left[left < ends[-1]]
        self._kept = np.unique(ends)

    def undeclared(self) -> list[float]:
        """What stands for "no data" in the whole."""
        return undeclared_nodata(self._kept, np.ones(self._kept.size, bool))
