"""The manifest of the command line turned into fields, the plain description of a form.

A field is one parameter of QGIS; an option that may be one of two things (a number or a raster, a built-in
legend or a file) becomes two. Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import PurePath
from typing import Any

from . import forms, labels, names
from .words import choice_word, label_of, words_of_forms
from .words import document as _document

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
    "directory": "folder",
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
        `raster`, `vector`, `field`, `file`, `folder`, `crs`, `extent`, `number`, `integer`, `boolean`, `choice`,
        `choices` or `text`.
    label, help
        Texts.
    variant
        What tells the field from others of the same option, such as "as a raster".
    option
        Name of the command's parameter that takes the value.
    flag
        Its flag, empty for arguments.
    required, advanced, multiple
        As in the manifest and the table of forms.
    default, choices, low, high
        As far as they are known.
    words
        What the form shows for each choice.
    parent
        Of a `field`: the parameter of its layer.
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
    words: tuple[str, ...] = ()
    variant: str = ""
    low: float | None = None
    high: float | None = None
    parent: str = ""


@dataclass(frozen=True)
class Output:
    """One file that an algorithm can leave behind.

    Parameters
    ----------
    name
        Of the QGIS parameter.
    kind
        `raster`, `vector`, `file` or `folder`.
    label
        Text.
    file
        Name under which the command writes it; empty for the folder of all that a run writes.
    flag
        Flag that asks the command to write it; empty if it writes it anyway.
    shown
        Whether it stands on the form and is made unless switched off. Others can be named in scripts and models.
    """

    name: str
    kind: str
    label: str
    file: str
    flag: str
    shown: bool

    def file_for(self, path: str) -> str:
        """Return the name of the file that the command writes for a destination, whose ending may choose the format."""
        endings = names.ENDINGS.get(self.file)
        if endings is None:
            return self.file
        given = PurePath(path).suffix.lower()
        return PurePath(self.file).stem + (given if given in endings else endings[0])


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
    options = [option for option in options if option["name"] not in names.LEFT_OUT.get(form.name, ())]
    for option in options:
        if option["name"] not in names.HIDDEN and not _is_written(option):
            fields += _fields(option, form, _either(document))
    order = {name: place for place, name in enumerate(form.main)}
    fields = [f for f in fields if form.name in names.ONLY_IN.get(f.name, (form.name,))]
    fields.sort(key=lambda f: (f.advanced, order.get(f.option, len(order))))
    chosen = [set(f.choices) for f in fields if f.choices]
    kinds = {
        kind
        for kind, known in document["methods"].items()
        if any({method["name"] for method in known} <= choices for choices in chosen)
    }
    return Description(
        form,
        form.about,
        tuple(fields),
        tuple(_outputs(form, command)),
        _into_folder(command),
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
        low, high = labels.RANGES.get(option["name"], (None, None))
        default = option.get("default") if place == 0 else None
        if kind in ("number", "integer") and default is not None:
            default = float(default) if kind == "number" else int(default)
        choices = tuple(option.get("choices", ())) if kind in ("choice", "choices") else ()
        told = labels.HELP_OF_FORMS.get(option["name"]) or option.get("help") or labels.HELP.get(option["name"], "")
        yield Field(
            _name(
                option["name"],
                kind,
                second=place > 0 or (kind == "raster" and option["name"] in either) or kinds == ["file", "text"],
            ),
            kind,
            label_of(option["name"]),
            words_of_forms(told, form.name),
            option["name"],
            (option.get("flags") or [""])[-1],
            required=bool(option.get("required")) and len(kinds) == 1,
            advanced=place > 0 or option["name"] not in form.main,
            parent=parent,
            multiple=bool(option.get("multiple")),
            default=default,
            low=low,
            high=high,
            choices=choices,
            variant=(_VARIANTS.get(option["name"]) or _OTHERS.get(kind, f"as a {kind}")) if place > 0 else "",
            words=tuple(choice_word(option["name"], choice) for choice in choices),
        )


_VARIANTS = {
    "run": "as its segments (segments.gpkg)",
    "weather": "as a wind rose: rose:NW=5x0.4,N=8x0.2",
    "treatments": "as a word",
}
_OTHERS = {
    "choice": "as one class for all fuel",
    "file": "as a CSV file",
    "text": "as classes: agricultural=500,pines=1500",
    "vector": "as polygons or lines",
}


def _kind(word: str) -> str:
    return word if word in (*_LAYER_KINDS, "extent", "field") else _PLAIN_KINDS.get(word, "text")


def _name(option: str, kind: str, *, second: bool = False) -> str:
    """Return the name of a parameter; `second` tells that the plain name belongs to another kind."""
    if second and kind in _LAYER_KINDS:
        return f"INPUT_{option.upper()}_{kind.upper()}"
    if second and kind == "file":
        return f"{option.upper()}_FILE"
    if option in names.RENAMED:
        return names.RENAMED[option]
    return f"INPUT_{option.upper()}" if kind in _LAYER_KINDS else option.upper()


def _is_written(option: dict[str, Any]) -> bool:
    """Tell whether the option names what the command writes."""
    return option["type"].startswith("new-") or (option["type"] == "directory" and bool(option.get("flags")))


def _into_folder(command: dict[str, Any]) -> bool:
    return any(o["name"] == "output" and o["type"] == "directory" for o in command["parameters"])


def _outputs(form: forms.Form, command: dict[str, Any]) -> Iterator[Output]:
    if form.name in names.FILES:
        file, label = names.FILES[form.name]
        yield _output(form, file, label)
    for file, label in command.get("outputs", {}).items():
        yield _output(form, file, label)
    suffixes = {"new-raster": ".tif", "new-vector": ".gpkg", "new-table": ".csv"}
    if _into_folder(command):
        yield Output("OUTPUT_FOLDER", "folder", "Folder for all files", "", "", shown=False)
    for option in command["parameters"]:
        if option["name"] != "output" and option["type"] == "directory" and option.get("flags"):
            name = f"OUTPUT_{option['name'].upper()}"
            yield Output(name, "folder", label_of(option["name"]), option["name"], option["flags"][-1], shown=False)
        if option["type"] in suffixes and option["name"] != "output":
            file = option["name"] + suffixes[option["type"]]
            yield _output(form, file, label_of(option["name"]), names.RENAMED.get(option["name"]), option["flags"][-1])


def _output(form: forms.Form, file: str, label: str, name: str | None = None, flag: str = "") -> Output:
    path = PurePath(file)
    name = name or names.RENAMED.get(file) or f"OUTPUT_{path.stem.upper()}"
    return Output(name, _OUTPUT_KINDS.get(path.suffix, "file"), label, file, flag, name in form.shown)


def parameter_names(command: str) -> set[str]:
    """Return the names of the parameters of a command."""
    return {option["name"] for option in _document()["commands"][command]["parameters"]}
