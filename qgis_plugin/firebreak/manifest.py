"""The manifest of the command line turned into fields, the plain description of a form.

A field is one parameter of QGIS; an option that may be one of two things (a number or a raster, a built-in
legend or a file) becomes two. Nothing here imports QGIS.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePath
from typing import Any

from . import forms, labels

FILE = Path(__file__).with_name("manifest.json")

#: Fields for layers are named INPUT_..., those for files written OUTPUT_...
_LAYER_KINDS = ("raster", "vector")
_FIELD = "_field"  # how options end that name a column of the layer of another option
_PLAIN_KINDS = {
    "text": "text",
    "integer": "integer",
    "float": "number",
    "number": "number",
    "boolean": "boolean",
    "choice": "choice",
    "choices": "choices",
    "crs": "crs",
    "file": "file",
    "path": "file",
}
_OUTPUT_KINDS = {".tif": "raster", ".gpkg": "vector"}


@dataclass(frozen=True)
class Field:
    """One parameter of a form.

    Parameters
    ----------
    name
        Of the QGIS parameter.
    kind
        `raster`, `vector`, `field`, `file`, `crs`, `extent`, `number`, `integer`, `boolean`, `choice`,
        `choices` or `text`.
    label, help
        Texts.
    option
        Name of the command's parameter that takes the value.
    flag
        Its flag, empty for arguments.
    required, advanced, multiple
        As in the manifest and the table of forms.
    default, choices, low, high
        As far as they are known.
    parent
        Of a `field`: the parameter of its layer.
    method
        The method (and the option that chooses it) that has to be chosen for this value to count.
    """

    name: str
    kind: str
    label: str
    help: str
    option: str
    flag: str = ""
    required: bool = False
    advanced: bool = True
    multiple: bool = False
    default: Any = None
    choices: tuple[str, ...] = ()
    low: float | None = None
    high: float | None = None
    parent: str = ""
    method: tuple[str, str] | None = None


@dataclass(frozen=True)
class Output:
    """One file that an algorithm can leave behind.

    Parameters
    ----------
    name
        Of the QGIS parameter.
    kind
        `raster`, `vector` or `file`.
    label
        Text.
    file
        Name under which the command writes it.
    flag
        Flag that asks the command to write it; empty if it writes it anyway.
    shown
        Whether it is made unless switched off.
    """

    name: str
    kind: str
    label: str
    file: str
    flag: str
    shown: bool


@dataclass(frozen=True)
class Description:
    """A form with everything that the manifest knows of it."""

    form: forms.Form
    text: str
    fields: tuple[Field, ...]
    outputs: tuple[Output, ...]
    into_folder: bool
    methods: tuple[dict[str, Any], ...]


@lru_cache(maxsize=1)
def _document() -> dict[str, Any]:
    return json.loads(FILE.read_text(encoding="utf-8"))


@lru_cache(maxsize=1)
def descriptions() -> tuple[Description, ...]:
    """Return the description of every form whose command the manifest has."""
    document = _document()
    commands = document["commands"]
    return tuple(
        _description(form, document)
        for form in forms.FORMS
        if form.name in commands and (form.before is None or form.before in commands)
    )


def _description(form: forms.Form, document: dict[str, Any]) -> Description:
    command = document["commands"][form.name]
    options = list(command["parameters"])
    if form.before is not None:
        known = {option["name"] for option in options}
        options += [o for o in document["commands"][form.before]["parameters"] if o["name"] not in known]
    fields: list[Field] = []
    options = [option for option in options if option["name"] not in forms.LEFT_OUT.get(form.name, ())]
    for option in options:
        if option["name"] in forms.METHOD_OPTIONS:
            fields += _method_fields(option, document)
        elif option["name"] not in forms.HIDDEN and not option["type"].startswith("new-"):
            fields += _fields(option, form, _either(document))
    order = {name: place for place, name in enumerate(form.main)}
    fields = [f for f in fields if form.name in forms.ONLY_IN.get(f.name, (form.name,))]
    fields.sort(key=lambda f: (f.advanced, f.method is not None, order.get(f.option, len(order))))
    kinds = {kind for option, kind in forms.METHOD_OPTIONS.values() if any(f.option == option for f in fields)}
    if any(f.kind == "choices" for f in fields):
        kinds.add("ranking")
    return Description(
        form,
        _words_of_forms(command["help"], form.name),
        tuple(fields),
        tuple(_outputs(form, command)),
        any(o["name"] == "output" and o["type"] == "directory" for o in command["parameters"]),
        tuple(method for kind in sorted(kinds) for method in document["methods"][kind]),
    )


def _either(document: dict[str, Any]) -> set[str]:
    """Return the options that some command takes as vector or raster; rasters get names of their own."""
    options = (option for c in document["commands"].values() for option in c.get("parameters", ()))
    return {option["name"] for option in options if option["type"].startswith("vector|raster")}


def _fields(option: dict[str, Any], form: forms.Form, either: set[str]) -> Iterator[Field]:
    """Yield one field a kind; the usual kind comes first and carries the default, the others are advanced."""
    kinds = ["extent"] if option.get("count") == 4 else option["type"].split("|")
    parent = ""
    if option["name"].endswith(_FIELD):
        kinds, parent = ["field"], _name(option["name"][: -len(_FIELD)], "vector")
    for place, word in enumerate(kinds):
        kind = _kind(word)
        label = _label(option["name"])
        low, high = labels.RANGES.get(option["name"], (None, None))
        default = option.get("default") if place == 0 else None
        if place > 0:
            label = f"{label}, as {_TEXTS.get(option['name']) or _ARTICLES.get(kind, 'a ' + kind)}"
        if kind in ("number", "integer") and default is not None:
            default = float(default) if kind == "number" else int(default)
        yield Field(
            _name(option["name"], kind, second=place > 0 or option["name"] in either or kinds == ["file", "text"]),
            kind,
            label,
            _words_of_forms(option.get("help") or labels.HELP.get(option["name"], ""), form.name),
            option["name"],
            (option.get("flags") or [""])[-1],
            required=bool(option.get("required")) and len(kinds) == 1,
            advanced=place > 0 or option["name"] not in form.main,
            parent=parent,
            multiple=bool(option.get("multiple")),
            default=default,
            low=low,
            high=high,
            choices=tuple(option.get("choices", ())) if kind in ("choice", "choices") else (),
        )


_TEXTS = {"weather": "a wind rose: rose:NW=5x0.4,N=8x0.2"}
_ARTICLES = {"choice": "one class for all fuel", "file": "a CSV file", "text": "classes: agricultural=500,pines=1500"}


def _words_of_forms(text: str, form: str) -> str:
    """Put the labels of the form in the place of flags, and leave out what points to commands."""
    text = text.replace(f"(firebreak {form} only) ", "")
    text = re.sub(r"(, or)? \(firebreak \w+ only\)[^.]*", "", text)
    text = re.sub(r" \(firebreak [\w ]+\)", "", text)
    return re.sub(r"--[a-z][a-z-]*", lambda flag: f'"{_flags().get(flag.group(), flag.group())}"', text)


@lru_cache(maxsize=1)
def _flags() -> dict[str, str]:
    """Return the label of every flag."""
    options = (option for c in _document()["commands"].values() for option in c.get("parameters", ()))
    return {flag: _label(option["name"]) for option in options for flag in option.get("flags", ())}


def _kind(word: str) -> str:
    return word if word in (*_LAYER_KINDS, "extent", "field") else _PLAIN_KINDS.get(word, "text")


def _name(option: str, kind: str, *, second: bool = False) -> str:
    """Return the name of a parameter; `second` tells that the plain name belongs to another kind."""
    if second and kind in ("raster", "file"):
        return f"INPUT_{option.upper()}_RASTER" if kind == "raster" else f"{option.upper()}_FILE"
    if option in forms.RENAMED:
        return forms.RENAMED[option]
    return f"INPUT_{option.upper()}" if kind in _LAYER_KINDS else option.upper()


def _label(option: str) -> str:
    return labels.LABELS.get(option) or option.replace("_", " ").capitalize()


def _method_fields(option: dict[str, Any], document: dict[str, Any]) -> Iterator[Field]:
    """Yield a field for every parameter of every method that the option's parameters may be meant for."""
    chooser, kind = forms.METHOD_OPTIONS[option["name"]]
    types = {"int": "integer", "float": "number", "bool": "boolean", "str": "text"}
    for method in document["methods"][kind]:
        for parameter in method["parameters"]:
            if parameter["name"] in forms.SET_BY_OPTION:
                continue
            choices = tuple(parameter.get("choices", ()))
            is_path = parameter.get("path", False)
            words = "raster" if is_path else "choice" if choices else types.get(parameter["type"], "text")
            units = "" if parameter.get("units", "1") == "1" else f" [{parameter['units']}]"
            name = f"{method['name']}_{parameter['name']}".upper()
            yield Field(
                f"INPUT_{name}" if is_path else name,
                words,
                f"{method['name']}: {parameter['name']}{units}",
                f"{parameter['text']} (counts for {method['name']} only)",
                f"{option['name']}:{parameter['name']}",
                option["flags"][-1],
                default=None if is_path else parameter.get("default"),
                choices=choices,
                low=parameter.get("minimum"),
                high=parameter.get("maximum"),
                method=(chooser, method["name"]),
            )


def _outputs(form: forms.Form, command: dict[str, Any]) -> Iterator[Output]:
    if form.name in forms.FILES:
        file, label = forms.FILES[form.name]
        yield _output(form, file, label)
    for file, label in command.get("outputs", {}).items():
        yield _output(form, file, label)
    suffixes = {"new-raster": ".tif", "new-vector": ".gpkg", "new-table": ".csv"}
    for option in command["parameters"]:
        if option["type"] in suffixes and option["name"] != "output":
            file = option["name"] + suffixes[option["type"]]
            yield _output(form, file, _label(option["name"]), forms.RENAMED.get(option["name"]), option["flags"][-1])


def _output(form: forms.Form, file: str, label: str, name: str | None = None, flag: str = "") -> Output:
    path = PurePath(file)
    name = name or forms.RENAMED.get(file) or f"OUTPUT_{path.stem.upper()}"
    return Output(name, _OUTPUT_KINDS.get(path.suffix, "file"), label, file, flag, name in form.shown)


def parameter_names(command: str) -> set[str]:
    """Return the names of the parameters of a command."""
    return {option["name"] for option in _document()["commands"][command]["parameters"]}
