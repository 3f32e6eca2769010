"""Plug-ins: one file a method, found by name, described as plain data.

A plug-in is a module with a frozen dataclass `Params`, whose fields are made by `parameter`, and one
function (`rank` or `probability`). Its name is the module's name. Strangers add modules through the
entry points `firebreak_gis.ranking` and `firebreak_gis.spread`.
"""

from __future__ import annotations

import dataclasses
import functools
import importlib
import importlib.metadata
import importlib.util
import inspect
import math
import pkgutil
import sys
import typing
from collections.abc import Mapping
from types import ModuleType
from typing import Any

import numpy as np

from firebreak_gis.errors import ParameterError

#: The kinds of plug-in: package that holds them and the function each must have.
KINDS: Mapping[str, tuple[str, str]] = {
    "ranking": ("firebreak_gis.ranking", "rank"),
    "spread": ("firebreak_gis.spread", "probability"),
}

#: What a plan knows of itself and tells a method whose parameter declares it (`parameter(..., told=...)`).
FACTS: Mapping[str, str] = {
    "cost_share": "share of the cost of all fuel that the budget is; cells and hectares at the mean cost",
    "cell_share": "share of the cells with fuel that the budget is; money at the mean cost",
    "residual": "share of its spread probability that a treated cell keeps",
    "least_width": "least width of the breaks, cells; the default of the parameter counts where it is larger",
    "elevation": "terrain elevation, (rows, cols) in metres",
    "roads": "(rows, cols), above 0 on a road or another barrier",
}

_USUAL_MEMORY = (200, 0)


def parameter(
    default: Any,
    *,
    text: str,
    units: str = "1",
    minimum: float | None = None,
    maximum: float | None = None,
    open_maximum: bool = False,
    choices: tuple[str, ...] | None = None,
    raster: bool = False,
    path: bool = False,
    told: str | None = None,
) -> Any:
    """Declare a field of a plug-in's `Params`.

    Parameters
    ----------
    default
        Default value; its type is the type of the parameter unless the annotation says more.
    text
        One line for help pages and forms.
    units
        Units of the value; "1" for none.
    minimum, maximum
        Closed range.
    open_maximum
        Whether `maximum` itself is excluded.
    choices
        Allowed words, for text parameters.
    raster
        Whether a raster on the grid of the network may stand in place of the number.
    path
        Whether the value names a file.
    told
        Which of `FACTS` a plan tells the parameter where it is not given.
    """
    if told is not None and told not in FACTS:
        raise ParameterError(f"a parameter asks to be told {told!r}; a plan knows {', '.join(FACTS)}")
    metadata = {
        "text": text,
        "units": units,
        "minimum": minimum,
        "maximum": maximum,
        "open_maximum": open_maximum,
        "choices": choices,
        "raster": raster,
        "path": path,
        "told": told,
    }
    return dataclasses.field(default=default, metadata=metadata)


def names(kind: str) -> list[str]:
    """Names of all plug-ins of a kind (`ranking` or `spread`), sorted."""
    package = importlib.import_module(KINDS[kind][0])
    own = {m.name for m in pkgutil.iter_modules(package.__path__) if not m.name.startswith("_")}
    return sorted(own | set(_entry_points(kind)))


def load(kind: str, name: str) -> ModuleType:
    """Import the plug-in `name`.

    Raises
    ------
    ParameterError
        If there is none of that name, naming those that there are.
    """
    if name not in names(kind):
        raise ParameterError(f"there is no {kind} method {name!r}; there are: {', '.join(names(kind))}")
    entry_points = _entry_points(kind)
    if name in entry_points:
        module = entry_points[name].load()
    else:
        module = importlib.import_module(f"{KINDS[kind][0]}.{name}")
    function = KINDS[kind][1]
    if not callable(getattr(module, function, None)) or not dataclasses.is_dataclass(getattr(module, "Params", None)):
        raise ParameterError(f"the {kind} method {name!r} lacks a function {function}() or a dataclass Params")
    return typing.cast(ModuleType, module)


def memory_of(kind: str, name: str, *, large: bool = False) -> tuple[int, int]:
    """Bytes that a plug-in needs at its peak, beside its input: for each cell, and for each cell and thread.

    A module tells them as `MEMORY`, and as `LARGE_MEMORY` if large maps (more than `memory.BLOCK_CELLS`) need less; the
    default is enough for a few arrays.
    """
    module = load(kind, name)
    usual = getattr(module, "MEMORY", _USUAL_MEMORY)
    cell, thread = getattr(module, "LARGE_MEMORY", usual) if large else usual
    return int(cell), int(thread)


def halo_of(model: str) -> int | None:
    """Cells around a part of a landscape that a spread model must see to give that part of the network.

    A module tells it as `HALO`; None: the model must see the whole landscape.
    """
    halo = getattr(load("spread", model), "HALO", None)
    return None if halo is None else int(halo)


def build_params(module: ModuleType, values: Mapping[str, Any]) -> Any:
    """Make the `Params` of a plug-in from given values, texts included ("0.5", "true").

    Raises
    ------
    ParameterError
        Naming every unknown parameter and every value out of range.
    """
    name = module.__name__.rpartition(".")[2]
    fields = {f.name: f for f in dataclasses.fields(module.Params)}
    kinds = typing.get_type_hints(module.Params)
    problems = [
        f"{name} has no parameter {key!r} (it has: {', '.join(fields) or 'none'})"
        for key in values
        if key not in fields
    ]
    converted = {}
    for key, value in values.items():
        if key in fields:
            try:
                converted[key] = _convert(value, kinds[key], fields[key].metadata)
            except ValueError as error:
                problems.append(f"{name} parameter {key}: {error}")
    if problems:
        raise ParameterError("; ".join(problems))
    return module.Params(**converted)


def told(module: ModuleType, facts: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters that a plan tells a plug-in which asks for them (`told`), but for those that are given.

    Parameters
    ----------
    module
        The plug-in.
    facts
        By the names of `FACTS`; None is not told. Numbers are kept above the minimum of the parameter.
    given
        Parameters that are given, which win.

    Raises
    ------
    ParameterError
        As `build_params`; or if the least width is given and less than that of the plan.
    """
    params = build_params(module, given)
    result: dict[str, Any] = {}
    for field in dataclasses.fields(module.Params):
        fact, low = field.metadata["told"], field.metadata["minimum"]
        value = facts.get(fact) if fact else None
        if value is None:
            continue
        if fact == "least_width":
            if field.name in given:
                require_width(module.__name__, getattr(params, field.name), value)
            value = max(value, field.default)
        if field.name not in given:
            result[field.name] = value if low is None else max(value, low)
    return result


def require_width(module: str, asked: int, least: int) -> None:
    """Refuse a width in cells that is less than the least of the plan.

    Raises
    ------
    ParameterError
        Naming both.
    """
    if 0 < asked < least:
        name = module.rpartition(".")[2]
        raise ParameterError(
            f"{name} is asked for a width of {asked} cells, but the breaks must be at least {least} cells wide; "
            "leave one of the two out"
        )


def asks_for(module: ModuleType, fact: str) -> bool:
    """Whether a parameter of the plug-in asks to be told one of `FACTS`."""
    return any(field.metadata["told"] == fact for field in dataclasses.fields(module.Params))


def takes_trial(module: ModuleType) -> bool:
    """Whether a ranking takes the fires with a clock that a plan is for."""
    return "trial" in inspect.signature(module.rank).parameters


def uses_trial(module: ModuleType, params: Any) -> bool:
    """Whether those fires make a difference with these `Params`; a module may tell it by a function of that name."""
    function = getattr(module, "uses_trial", None)
    return takes_trial(module) and (function is None or bool(function(params)))


def effective(module: ModuleType, params: Any) -> Any:
    """`Params` in which those that make no difference have their defaults; equal ones give equal results.

    A module tells it by a function `effective(params)`; without one every parameter counts.
    """
    function = getattr(module, "effective", None)
    return function(params) if function else params


def methods(kind: str | None = None) -> list[dict[str, Any]]:
    """Describe the rankings and spread models that there are, those of other packages included.

    Parameters
    ----------
    kind
        `"ranking"` or `"spread"`; None: both.

    Returns
    -------
    list of dict
        `name`, `kind`, `summary`, `text` and `parameters` of each, by kind and name.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> [method["name"] for method in fb.methods("spread")]
    ['alexandridis', 'artificial', 'raster']
    """
    kinds = KINDS if kind is None else (kind,)
    return [describe(each, name) for each in kinds for name in names(each)]


def describe(kind: str, name: str) -> dict[str, Any]:
    """Everything known of a plug-in, as plain data (JSON types)."""
    module = load(kind, name)
    doc = inspect.getdoc(module) or ""
    parameters = []
    for field in dataclasses.fields(module.Params):
        entry = {"name": field.name, "default": field.default, "type": _type_name(field)}
        told = {k: v for k, v in field.metadata.items() if v is not None and v is not False}
        entry |= {k: list(v) if isinstance(v, tuple) else v for k, v in told.items()}
        parameters.append(entry)
    return {
        "name": name,
        "kind": kind,
        "summary": doc.split("\n", 1)[0],
        "text": doc,
        "parameters": parameters,
    }


def _entry_points(kind: str) -> dict[str, importlib.metadata.EntryPoint]:
    return _installed(KINDS[kind][0], tuple(sys.path))


@functools.lru_cache(maxsize=len(KINDS))
def _installed(group: str, _: tuple[str, ...]) -> dict[str, importlib.metadata.EntryPoint]:
    """Looking through all that is installed takes as long as a small ranking, so it is done once a path."""
    return {e.name: e for e in importlib.metadata.entry_points(group=group)}


def _type_name(field: dataclasses.Field[Any]) -> str:
    return type(field.default).__name__ if field.default is not None else "float"


def _convert(value: Any, kind: Any, metadata: Mapping[str, Any]) -> Any:
    options = [t for t in (typing.get_args(kind) or (kind,)) if t is not type(None)]
    if value is None:
        if type(None) in typing.get_args(kind):
            return None
        raise ValueError("got nothing, expected a value")
    if metadata["raster"] and np.ndim(value) > 0:
        return value
    if bool in options:
        return _to_bool(value)
    if metadata["raster"] or float in options or int in options:
        return _to_number(value, whole=options == [int], metadata=metadata)
    text = str(value)
    if metadata["choices"] and text not in metadata["choices"]:
        raise ValueError(f"got {text!r}, expected one of {', '.join(metadata['choices'])}")
    return text


def _to_bool(value: Any) -> bool:
    words = {"true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}
    try:
        return words[str(value).lower()]
    except KeyError:
        raise ValueError(f"got {value!r}, expected true or false") from None


def _to_number(value: Any, *, whole: bool, metadata: Mapping[str, Any]) -> float | int:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"got {value!r}, expected a number") from None
    if not math.isfinite(number):
        raise ValueError(f"got {value!r}, expected a finite number")
    if whole and number != np.floor(number):
        raise ValueError(f"got {value!r}, expected a whole number")
    low, high = metadata["minimum"], metadata["maximum"]
    if low is not None and number < low:
        raise ValueError(f"got {number:g}, expected at least {low:g}")
    if high is not None and (number > high or (metadata["open_maximum"] and number == high)):
        raise ValueError(f"got {number:g}, expected {'less than' if metadata['open_maximum'] else 'at most'} {high:g}")
    return int(number) if whole else number
