#!/usr/bin/env python3
"""Bring the catalogues of the plugin's texts in step with its sources: ``python qgis_plugin/renew_translations.py``.

Texts that are new are marked unfinished in ``firebreak/i18n/*.ts``: open them in Qt Linguist, or write the translation
and take ``type="unfinished"`` out. Those that no source has any more are dropped, all others stay as they are.

What is translated: everything that a form shows (titles, groups, what an algorithm does, labels, lists, tips, outputs,
numbers) and what the plugin itself says. The parameters of methods in the help, and the messages of the engine, stay
English, but for the labels in them.
"""

from __future__ import annotations

import ast
import sys
from pathlib import Path
from xml.etree import ElementTree as ET
from xml.sax.saxutils import escape

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from firebreak import forms, manifest, translation  # noqa: E402


def sources() -> list[str]:
    """Return every text that is translated, in the order in which it is met."""
    found: dict[str, None] = dict.fromkeys(forms.GROUPS.values())
    for description in manifest.descriptions():
        form = description.form
        paragraphs = (" ".join(text.split()) for text in form.about.split("\n\n"))
        found |= dict.fromkeys((form.title, *paragraphs, *form.numbers.values()))
        for field in description.fields:
            found |= dict.fromkeys((field.label, field.variant, field.help, *field.words))
        found |= dict.fromkeys(output.label for output in description.outputs)
    for path in sorted((HERE / "firebreak").rglob("*.py")):
        found |= dict.fromkeys(_spoken(path))
    found.pop("", None)
    return list(found)


def _spoken(path: Path) -> list[str]:
    """Return the literals in calls of ``translate("Firebreak", ...)``."""
    calls = (node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call))
    named = (call for call in calls if getattr(call.func, "id", "") == "translate" and len(call.args) > 1)
    return [call.args[1].value for call in named if isinstance(call.args[1], ast.Constant)]


def write(path: Path, texts: list[str], known: dict[str, str]) -> int:
    """Write a catalogue; return how many texts it lacks."""
    language = path.stem.partition("_")[2]
    lines = [
        '<?xml version="1.0" encoding="utf-8"?>',
        "<!DOCTYPE TS>",
        f'<TS version="2.1" language="{language}" sourcelanguage="en">',
        "<context>",
        f"    <name>{translation.CONTEXT}</name>",
    ]
    for text in texts:
        told = known.get(text)
        target = (
            f"<translation>{escape(told)}</translation>" if told else '<translation type="unfinished"></translation>'
        )
        lines += ["    <message>", f"        <source>{escape(text)}</source>", f"        {target}", "    </message>"]
    path.write_text("\n".join([*lines, "</context>", "</TS>", ""]), encoding="utf-8")
    return sum(text not in known for text in texts)


def sources_of(path: Path) -> list[str]:
    """Return the sources that a catalogue has, translated or not."""
    return [source.text or "" for source in ET.parse(path).iter("source")]


def main() -> None:
    """Renew all catalogues."""
    texts = sources()
    for language in translation.languages():
        path = translation.FOLDER / f"firebreak_{language}.ts"
        stale = len(set(sources_of(path)) - set(texts))
        lacking = write(path, texts, translation.catalogue(language))
        print(f"{path.name}: {len(texts)} texts, {lacking} to translate, {stale} dropped")  # noqa: T201


if __name__ == "__main__":
    main()
