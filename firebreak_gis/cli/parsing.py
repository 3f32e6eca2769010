"""What options given as text mean: pairs, lists, sizes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from firebreak_gis import plugins
from firebreak_gis.errors import ParameterError


def pairs(values: tuple[str, ...] | Mapping[str, Any], option: str) -> dict[str, Any]:
    """Split NAME=VALUE words; a mapping (from --config) passes.

    Raises
    ------
    ParameterError
        If a word has no "=".
    """
    if isinstance(values, Mapping):
        return dict(values)
    result = {}
    for word in values:
        name, equals, value = word.partition("=")
        if not equals or not name:
            raise ParameterError(f"{option} got {word!r}, expected NAME=VALUE")
        result[name.strip()] = value.strip()
    return result


def methods_list(text: str) -> list[tuple[str, str, dict[str, Any]]]:
    """Split "bonacich:beta=0.2,random" into (label, method, parameters)."""
    result = []
    for word in filter(None, (w.strip() for w in text.split(","))):
        name, *params = word.split(":")
        plugins.load("ranking", name)
        result.append((word, name, pairs(tuple(params), "--methods")))
    labels = [label for label, _, _ in result]
    if not result or len(set(labels)) != len(labels):
        raise ParameterError(f"--methods got {text!r}, expected different names such as bonacich:beta=0.5,random")
    return result


def number_list(text: Any, option: str) -> list[float]:
    """Split "0,0.05,0.1" into rising numbers.

    Raises
    ------
    ParameterError
        If a word is no number or there is none.
    """
    try:
        numbers = sorted({float(word) for word in str(text).split(",") if word.strip()})
    except ValueError:
        numbers = []
    if not numbers:
        raise ParameterError(f"{option} got {text!r}, expected numbers such as 0,0.05,0.1")
    return numbers


def checked_seed(value: int) -> int:
    """Refuse a negative seed."""
    if value < 0:
        raise ParameterError(f"--seed is {value}, expected a whole number of at least 0")
    return value


def byte_size(text: str | None) -> int | None:
    """Read "4GB", "800 MiB" or a number of bytes.

    Raises
    ------
    ParameterError
        If the text is no size.
    """
    if text is None:
        return None
    words = str(text).strip().upper().replace("IB", "B").rstrip("B")
    factor = {"K": 2**10, "M": 2**20, "G": 2**30, "T": 2**40}.get(words[-1:], 1)
    try:
        size = int(float(words.rstrip("KMGT")) * factor)
    except (ValueError, OverflowError):
        size = 0
    if size <= 0:
        raise ParameterError(f"--max-memory got {text!r}, expected a size such as 4GB")
    return size
