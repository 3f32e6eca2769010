"""Sentences of the command line in the words of the forms: labels, titles and words of lists in the place of flags.

Nothing here imports QGIS.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from . import forms, labels
from .translation import CONTEXT, translate

FILE = Path(__file__).with_name("manifest.json")

#: Where the explaining part of a label begins.
_SHORT = re.compile(r" \(| \[|, ")
#: A flag as errors quote it, with its short twin and the words in capitals that stand for values.
_FLAG = re.compile(r"'?(?<![\w-])(--[a-z][a-z-]*)'?(?: / '?-\w'?)?(?: (?:[A-Z]+\b(?!\())){0,2}")
_COMMAND = re.compile(r"(?<![\w.])firebreak ([a-z]+)\b(?: ([A-Z]{2,}|NAME)\b)?")
#: What names Python or the command line alone: " (spread_network(..., clock=True))", ", or read_landscape".
_PYTHON = re.compile(r" \(\w+\((?:[^()]*)\)\)|, or \w+_\w+(?:\([^()]*\))?(?=\))| \(\w+=\)")
#: Commands that no form stands for, and what does the same in QGIS.
_INSTEAD = {
    "methods": "the help of the form",
    "legends": "the list of legends",
    "doctor": "the check on the settings page",
    "weather": "the page on weather",
}


@lru_cache(maxsize=1)
def document() -> dict[str, Any]:
    """Return what `firebreak describe` says."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def label_of(option: str) -> str:
    """Return what an option is called in the forms."""
    return labels.LABELS.get(option) or option.replace("_", " ").capitalize()


def choice_word(option: str, choice: str) -> str:
    """Return what a list of the forms shows for a word that the engine takes.

    Rankings and spread models are shown by their summary, legends by their first line, others as `labels` says; a word
    that nobody describes is shown as it is, without underscores.
    """
    word = labels.CHOICES.get(option, {}).get(choice)
    if word:
        return word
    if option.endswith("legend"):
        return re.split(r" \(|;", document()["legends"].get(choice, ""))[0].rstrip(".") or _plain(choice)
    return _summaries().get(choice) or _plain(choice)


def _plain(choice: str) -> str:
    words = choice.replace("_", " ").replace("-", " ")
    return words[:1].upper() + words[1:]


@lru_cache(maxsize=1)
def _summaries() -> dict[str, str]:
    """Return "Name: what it does" of every method."""
    found = {}
    for method in (method for known in document()["methods"].values() for method in known):
        summary, name = method["summary"].rstrip("."), _plain(method["name"])
        begins = re.sub(r"\W", "", summary).lower().startswith(re.sub(r"\W", "", name).lower())
        found[method["name"]] = summary if begins or ":" in summary else f"{name}: {summary[:1].lower()}{summary[1:]}"
    return found


def words_of_forms(text: str, form: str) -> str:
    """Put the labels of the form in the place of flags, and leave out what points to commands."""
    text = text.replace(f"(firebreak {form} only) ", "")
    text = re.sub(r"(, or)? \(firebreak \w+ only\)[^.]*", "", text)
    text = re.sub(r" \(firebreak [\w ]+\)", "", text)
    return _told(text.replace("may be repeated", "several are separated by ;"), str)


def in_form_words(text: str) -> str:
    """Return a sentence of the engine, such as a refusal, with the labels that the user sees in the place of flags."""
    return _told(text, partial(translate, CONTEXT))


def _told(text: str, shown: Callable[[str], str]) -> str:
    def quoted(label: str) -> str:
        return f'"{_SHORT.split(shown(label), maxsplit=1)[0]}"'

    def flag(found: re.Match[str]) -> str:
        return quoted(_flags().get(found[1]) or _plain(found[1].strip("-")))

    def command(found: re.Match[str]) -> str:
        title = _titles().get(found[1])
        return quoted(title) if title else _INSTEAD.get(found[1], found[0])

    def argument(found: re.Match[str]) -> str:
        label = _arguments().get(found[0])
        return quoted(label) if label else found[0]

    text = _PYTHON.sub("", text)
    text = _COMMAND.sub(command, text)
    text = _FLAG.sub(flag, text)
    return re.sub(r"\b[A-Z]{3,}\b", argument, text)


@lru_cache(maxsize=1)
def _titles() -> dict[str, str]:
    return {form.name: form.title for form in forms.FORMS}


@lru_cache(maxsize=1)
def _arguments() -> dict[str, str]:
    """Return the label of every argument of a form, by its name in help texts."""
    commands = (document()["commands"].get(form.name, {}) for form in forms.FORMS)
    options = (option for command in commands for option in command.get("parameters", ()))
    return {o["name"].upper(): label_of(o["name"]) for o in options if "flags" not in o}


@lru_cache(maxsize=1)
def _flags() -> dict[str, str]:
    """Return the label of every flag."""
    options = (option for c in document()["commands"].values() for option in c.get("parameters", ()))
    return {flag: label_of(option["name"]) for option in options for flag in option.get("flags", ())}
