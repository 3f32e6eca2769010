"""Words that QGIS shows."""

from __future__ import annotations

from configparser import ConfigParser
from functools import lru_cache
from html import escape
from pathlib import Path, PurePath
from typing import Any

from . import names
from .manifest import Description, Field
from .names import SET_BY_OPTION
from .translation import translate
from .words import choice_word

_PICTURES = Path(__file__).with_name("pictures")
_PICTURE_WIDTH = 220  # of the narrow help panel
_PLACEHOLDER = "example.org"  # stands in metadata.txt until `build_zip.py --release` puts the address in
#: Where the documentation describes a command; `docs/reference.py` writes it.
PAGE = "/generated/commands.html#firebreak-{command}"
_FILTERS = {
    ".csv": "CSV",
    ".png": "PNG",
    ".svg": "SVG",
    ".html": "HTML",
    ".json": "JSON",
    ".txt": "TXT",
    ".zip": "Shapefile",
}


def translated(text: str) -> str:
    """Return a text of the manifest or the table of forms in the user's language."""
    return translate("Firebreak", text) if text else ""


@lru_cache(maxsize=1)
def documentation() -> str:
    """Return the address of the documentation from the plugin's metadata, empty where it is not published."""
    metadata = ConfigParser(interpolation=None)
    metadata.read(Path(__file__).with_name("metadata.txt"), encoding="utf-8")
    address = metadata.get("general", "documentation", fallback="")
    return "" if _PLACEHOLDER in address else address.rstrip("/")


def help_address(command: str) -> str:
    """Return the address of what the documentation says of a command, empty where it is not published."""
    return documentation() and documentation() + PAGE.format(command=command)


def field_label(field: Field) -> str:
    """Return the label of a field in the user's language."""
    return ", ".join(translated(text) for text in (field.label, field.variant) if text)


def file_filter(file: str) -> str:
    """Return the filter of a file dialog for files like this one."""
    if file in names.ENDINGS:
        return ";;".join(file_filter(f"file{ending}") for ending in names.ENDINGS[file])
    suffix = PurePath(file).suffix
    return f"{_FILTERS.get(suffix, suffix[1:].upper())} (*{suffix})"


def help_page(description: Description) -> str:
    """Return the help of an algorithm as HTML: what it does, a picture, its parameters and methods."""
    paragraphs = (" ".join(text.split()) for text in description.text.split("\n\n"))
    parts = [f"<p>{escape(translated(text))}</p>" for text in paragraphs]
    picture = _PICTURES / f"{description.form.name}.png"
    if picture.is_file():
        parts.append(f'<p><img src="{picture.as_uri()}" width="{_PICTURE_WIDTH}"></p>')
    heading = translate("Firebreak", "Parameters")
    parts.append(f"<h3>{escape(heading)}</h3>")
    parts += [_entry(field) for field in description.fields if field.help]
    if description.methods:
        parts.append(f"<h3>{escape(translate('Firebreak', 'Methods'))}</h3>")
        parts += [_method(method) for method in description.methods]
    if description.outputs:
        parts.append(f"<h3>{escape(translate('Firebreak', 'Outputs'))}</h3>")
        parts += [f"<p><b>{escape(translated(o.label))}</b> ({o.name})</p>" for o in description.outputs]
    return "".join(parts)  # QGIS shows every line break


def _method(method: dict[str, Any]) -> str:
    """Return what a method does and the parameters that it takes."""
    known = [p for p in method["parameters"] if p["name"] not in SET_BY_OPTION]
    items = "".join(f"<li>{escape(p['name'])}{_usual(p)}: {escape(translated(p['text']))}</li>" for p in known)
    about = f"<b>{escape(method['name'])}</b>: {escape(translated(choice_word('', method['name'])))}"
    return f"<p>{about}</p><ul>{items}</ul>" if items else f"<p>{about}</p>"


def _usual(parameter: dict[str, Any]) -> str:
    units = "" if parameter.get("units", "1") == "1" else f" {parameter['units']}"
    return f" = {escape(str(parameter['default']))}{escape(units)}" if parameter.get("default") is not None else ""


def _entry(field: Field) -> str:
    bounds = [f"{word} {value:g}" for word, value in (("from", field.low), ("to", field.high)) if value is not None]
    tail = f" ({' '.join(bounds)})" if bounds else ""
    return f"<p><b>{escape(field_label(field))}</b>{tail}: {escape(translated(field.help))}</p>"
