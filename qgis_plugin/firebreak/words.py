"""Sentences of the command line in the words of the forms: labels in the place of flags and arguments.

Nothing here imports QGIS.
"""

from __future__ import annotations

import json
import re
from functools import lru_cache
from pathlib import Path
from typing import Any

from . import labels

FILE = Path(__file__).with_name("manifest.json")

#: Where the explaining part of a label begins.
_SHORT = re.compile(r" \([a-z]| \[|, ")


@lru_cache(maxsize=1)
def document() -> dict[str, Any]:
    """Return what `firebreak describe` says."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def label_of(option: str) -> str:
    """Return what an option is called in the forms."""
    return labels.LABELS.get(option) or option.replace("_", " ").capitalize()


def words_of_forms(text: str, form: str) -> str:
    """Put the labels of the form in the place of flags, and leave out what points to commands."""
    text = text.replace(f"(firebreak {form} only) ", "")
    text = re.sub(r"(, or)? \(firebreak \w+ only\)[^.]*", "", text)
    text = re.sub(r" \(firebreak [\w ]+\)", "", text)
    return in_form_words(text.replace("may be repeated", "several are separated by ;"))


def in_form_words(text: str) -> str:
    """Return a sentence of the command line, such as a refusal, with labels of the forms in the place of flags."""

    def label(flag: re.Match[str]) -> str:
        words = _flags().get(flag.group(), flag.group().strip("-").replace("-", " ").capitalize())
        return f'"{_SHORT.split(words, maxsplit=1)[0]}"'

    text = re.sub(r"(?<![\w-])--[a-z][a-z-]*", label, text)
    return re.sub(r"\b[A-Z]{3,}\b", lambda word: _arguments().get(word.group(), word.group()), text)


@lru_cache(maxsize=1)
def _arguments() -> dict[str, str]:
    """Return the quoted label of every argument, by its name in help texts."""
    options = (option for c in document()["commands"].values() for option in c.get("parameters", ()))
    return {
        o["name"].upper(): f'"{_SHORT.split(label_of(o["name"]), maxsplit=1)[0]}"' for o in options if "flags" not in o
    }


@lru_cache(maxsize=1)
def _flags() -> dict[str, str]:
    """Return the label of every flag."""
    options = (option for c in document()["commands"].values() for option in c.get("parameters", ()))
    return {flag: label_of(option["name"]) for option in options for flag in option.get("flags", ())}
