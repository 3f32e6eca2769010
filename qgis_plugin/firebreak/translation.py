"""Texts in the user's language, from the catalogues (.ts) beside this file.

They are read as translators write them, so that there is no compiled twin to build, to ship and to forget. A text that
a catalogue lacks is shown in English. Nothing here imports QGIS.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree as ET  # nosec B405 # reads files of the plugin alone

FOLDER = Path(__file__).with_name("i18n")
CONTEXT = "Firebreak"

_texts: dict[str, str] = {}


def languages() -> tuple[str, ...]:
    """Return the codes of the languages that have a catalogue."""
    return tuple(sorted(path.stem.partition("_")[2] for path in FOLDER.glob("firebreak_*.ts")))


def catalogue(language: str) -> dict[str, str]:
    """Return the translation of every text that has one in a language, such as "de"; empty if there is no catalogue."""
    path = FOLDER / f"firebreak_{language}.ts"
    if not path.is_file():
        return {}
    found = {}
    for message in ET.parse(path).iter("message"):  # nosec B314 # a file of the plugin
        source, target = message.find("source"), message.find("translation")
        if source is not None and target is not None and target.get("type") != "unfinished" and target.text:
            found[source.text or ""] = target.text
    return found


def use(locale: str) -> None:
    """Take the language of a locale, such as "pt_BR", for all texts from now on."""
    _texts.clear()
    _texts.update(catalogue(locale.partition("_")[0].partition("-")[0].lower()))


def translate(context: str, text: str, texts: Mapping[str, str] = _texts) -> str:  # noqa: ARG001
    """Return a text in the user's language. The context is there for the tools of translators, who look for it."""
    return texts.get(text, text)
