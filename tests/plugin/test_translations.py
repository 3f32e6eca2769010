"""The catalogues of the forms: every text in every language, nothing stale, numbers and placeholders kept.

After a change of texts: ``python qgis_plugin/renew_translations.py``, then translate what it marks unfinished.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "qgis_plugin"))

import renew_translations  # noqa: E402
from firebreak import forms, manifest, translation, words  # noqa: E402

SOURCES = renew_translations.sources()
LANGUAGES = ("de", "el", "es", "fr", "it", "pt")
#: What must be the same in a translation: placeholders, units, what is typed (beta=0.5, .csv, 4GB), numbers.
KEPT = re.compile(
    r"\{\}|\[m(?:/s)?\]|[a-z_]\w*=[\w.:-]+|\.[a-z]{3,7}\b|\d+(?:[.,]\d+)*(?:h|GB)?|\b[A-Z]{2,}[a-z]?[A-Z]+\b"
)
each = pytest.mark.parametrize("language", LANGUAGES)


def path_of(language: str) -> Path:
    return translation.FOLDER / f"firebreak_{language}.ts"


def test_the_languages():
    assert translation.languages() == LANGUAGES
    assert len(SOURCES) == len(set(SOURCES)) > 300


def test_what_is_translated_is_what_the_forms_show():
    known = set(SOURCES)
    for description in manifest.descriptions():
        assert {description.form.title, *description.form.numbers.values()} <= known
        for field in description.fields:
            assert {field.label, field.help, *field.words} <= known
        assert {output.label for output in description.outputs} <= known
    assert {"Stopped; no output was written.", "Make engine", "[not chosen]"} <= known


@each
def test_a_catalogue_is_complete_and_has_nothing_stale(language):
    found = renew_translations.sources_of(path_of(language))
    assert len(found) == len(set(found))
    assert set(found) - set(SOURCES) == set(), "stale; run qgis_plugin/renew_translations.py"
    assert set(SOURCES) - set(found) == set(), "missing; run qgis_plugin/renew_translations.py and translate"
    lacking = set(SOURCES) - set(translation.catalogue(language))
    assert lacking == set(), f"to translate in {path_of(language).name}"


@each
def test_numbers_examples_and_placeholders_are_kept(language):
    for source, target in translation.catalogue(language).items():
        kept, found = Counter(KEPT.findall(source)), Counter(KEPT.findall(target))
        for own in ("CRS", "SCR", "SRC", "KBS"):  # each language has its own word for it
            kept.pop(own, None)
            found.pop(own, None)
        assert kept == found, (source, target)


@each
def test_tips_name_the_labels_of_the_language(language):
    catalogue = translation.catalogue(language)
    labels = {words._SHORT.split(text, maxsplit=1)[0]: text for text in reversed(SOURCES)}
    seen = 0
    for source, target in catalogue.items():
        for quoted in re.findall(r'"([A-Z][^"]+)"', source):
            short = words._SHORT.split(catalogue.get(labels[quoted], quoted), maxsplit=1)[0]
            assert f'"{short}"' in target, (source, target)
            seen += 1
    assert seen > 10


@each
def test_the_toolbox_keeps_the_order_of_the_work(language):
    catalogue = translation.catalogue(language)
    titles = [catalogue.get(title, title) for title in forms.GROUPS.values()]
    assert titles == sorted(titles)


@each
def test_no_two_things_of_a_form_have_the_same_name(language):
    catalogue = translation.catalogue(language)
    titles = [catalogue.get(form.title, form.title) for form in forms.FORMS]
    assert len(titles) == len(set(titles))
    for description in manifest.descriptions():
        for field in description.fields:
            assert len({catalogue.get(word, word) for word in field.words}) == len(field.words)
        labels = {field.label for field in description.fields}
        assert len({catalogue.get(label, label) for label in labels}) == len(labels), description.form.name


@each
def test_it_is_that_language(language):
    """Few texts are as in English (names, formats), and Greek is written in Greek letters."""
    catalogue = translation.catalogue(language)
    same = [source for source, target in catalogue.items() if source == target]
    assert len(same) < 12, same
    if language == "el":
        assert sum(bool(re.search(r"[α-ωά-ώ]", target)) for target in catalogue.values()) > len(catalogue) - 5
    assert ET.parse(path_of(language)).getroot().get("language") == language


@each
@pytest.mark.skipif(shutil.which("lrelease") is None, reason="tool of Qt's translators")
def test_the_tools_of_qt_read_it(language, tmp_path):
    made = tmp_path / "x.qm"
    told = subprocess.run(
        ["lrelease", str(path_of(language)), "-qm", str(made)], capture_output=True, text=True, check=True
    )
    done = len(translation.catalogue(language))
    assert f"{done} translation(s) ({done} finished and 0 unfinished)" in told.stdout


def test_a_language_is_taken_and_let_go():
    try:
        translation.use("pt_BR")
        assert translation.translate("Firebreak", "Elevation") == "Elevação"
        assert translation.translate("Firebreak", "no such text") == "no such text"
        assert words.in_form_words("--budget is 2") == '"Orçamento" is 2'
        translation.use("xx")
        assert translation.translate("Firebreak", "Elevation") == "Elevation"
    finally:
        translation.use("en")


def test_renewing_keeps_marks_and_drops(tmp_path):
    path = tmp_path / "firebreak_de.ts"
    assert renew_translations.write(path, ["Elevation", "New <one> & more"], {"Elevation": "Höhe", "Old": "Alt"}) == 1
    assert renew_translations.sources_of(path) == ["Elevation", "New <one> & more"]
    root = ET.parse(path).getroot()
    found = {m.find("source").text: m.find("translation") for m in root.iter("message")}
    assert found["Elevation"].text == "Höhe"
    assert found["New <one> & more"].get("type") == "unfinished"
    kept = {language: path_of(language).read_bytes() for language in LANGUAGES}
    renew_translations.main()
    assert kept == {language: path_of(language).read_bytes() for language in LANGUAGES}, "renewing changes nothing"
