"""Words of the forms: no command line in them, lists to read, errors of the engine with the labels that are seen."""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "qgis_plugin" / "firebreak"
sys.path.insert(0, str(PLUGIN.parent))

from firebreak import forms, manifest, translation, words  # noqa: E402

DESCRIPTIONS = manifest.descriptions()
#: What belongs to a command line: flags, commands, its name, arguments in capitals, pipes, Python calls.
COMMAND_LINE = re.compile(
    r"(?<![\w-])--?[a-z]|firebreak [a-z]+\b(?! of)|command.line|"
    r"\b(DEM|VEGETATION|DENSITY|NETWORK|PRIORITY|BREAKS|FOLDER|LANDSCAPE|FILE|NAME)\b|stdin|stdout|\w+\([^)]*=[^)]*\)"
)


def texts_of_forms() -> dict[str, str]:
    """Every text that a form shows, and where."""
    found = dict.fromkeys(forms.GROUPS.values(), "group")
    for description in DESCRIPTIONS:
        form = description.form
        found |= dict.fromkeys((form.title, description.text, *form.numbers.values()), form.name)
        found |= {output.label: f"{form.name} {output.name}" for output in description.outputs}
        for field in description.fields:
            found |= dict.fromkeys((field.label, field.help, *field.words), f"{form.name} {field.name}")
        for method in description.methods:
            texts = (method["summary"], *(p["text"] for p in method["parameters"]))
            found |= dict.fromkeys(texts, f"{form.name} {method['name']}")
    return found


def test_no_text_of_the_forms_speaks_of_a_command_line():
    found = texts_of_forms()
    assert len(found) > 300
    assert {text: place for text, place in found.items() if COMMAND_LINE.search(text)} == {}


@pytest.mark.parametrize(
    "text",
    [
        "give --budget",
        "see firebreak rank",
        "command line",
        "-p beta=1",
        "lay NETWORK",
        "read_landscape(like=x)",
    ],
)
def test_the_rule_against_command_lines_bites(text):
    assert COMMAND_LINE.search(text)


# --- lists --------------------------------------------------------------------------------------------------


def test_lists_are_read_and_no_two_words_are_alike():
    seen = 0
    for description in DESCRIPTIONS:
        for field in description.fields:
            assert len(field.words) == len(field.choices) == len(set(field.words))
            for choice, word in zip(field.choices, field.words, strict=True):
                assert "_" not in word, (field.name, word)
                assert word[0].isupper() or word[0].isdigit()
                assert word != choice, (field.name, word)
                seen += 1
    assert seen > 200


def test_words_of_lists_come_from_where_methods_and_legends_are_described():
    plan = next(d for d in DESCRIPTIONS if d.form.name == "plan")
    lists = {f.name: dict(zip(f.choices, f.words, strict=True)) for f in plan.fields if f.choices}
    assert lists["METHOD"]["dissection"].startswith("Dissection: walls between compartments")
    for method in words.document()["methods"]["ranking"]:
        assert method["summary"].rstrip(".").lower().endswith(lists["METHOD"][method["name"]][-20:].lower())
    assert lists["LEGEND"]["corine"] == "CORINE Land Cover, level 3, three-digit codes"
    assert lists["BUDGET_UNIT"]["ha"] == "Hectares"


def test_a_new_method_or_choice_is_shown_without_edits(monkeypatch):
    later = {"name": "wet_first", "summary": "Cells that are wettest.", "parameters": []}
    monkeypatch.setattr(words, "document", lambda: {"methods": {"ranking": [later]}, "legends": {}, "commands": {}})
    words._summaries.cache_clear()
    try:
        assert words.choice_word("method", "wet_first") == "Wet first: cells that are wettest"
        assert words.choice_word("anything", "every-part") == "Every part"
        assert words.choice_word("legend", "own_codes") == "Own codes"
    finally:
        words._summaries.cache_clear()


# --- messages -----------------------------------------------------------------------------------------------


def sentences() -> dict[str, str]:
    """Every text of the engine, outside of docstrings and help, that names an option or a command, and where."""
    found = {}
    for path in sorted((ROOT / "firebreak_gis").rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        bodies = (n.body for n in ast.walk(tree) if isinstance(n, (ast.Module, ast.ClassDef, ast.FunctionDef)))
        passed = {id(body[0].value) for body in bodies if body and isinstance(body[0], ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Call):
                passed |= {id(n) for k in node.keywords if k.arg in ("help", "epilog") for n in ast.walk(k.value)}
            if isinstance(node, ast.JoinedStr):
                passed |= {id(n) for n in node.values}
        for node in ast.walk(tree):
            text = ""
            if isinstance(node, ast.JoinedStr) and id(node) not in passed:
                parts = (n.value if isinstance(n, ast.Constant) else "7" for n in node.values)
                text = "".join(map(str, parts))
            elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in passed:
                text = node.value
            if " " in text and re.search(r"(?<![\w-])--[a-z]|(?<![\w.])firebreak [a-z]", text):
                found[text] = f"{path.relative_to(ROOT)}:{node.lineno}"
    return found


#: What is never told to a form: the program's own talk on a terminal.
TERMINAL = re.compile(r"group\.py|/(doctor|demo|legends|methods|describe)\.py|calibration\.py")


def test_every_message_that_names_an_option_is_told_in_the_labels_of_the_form():
    found = {text: place for text, place in sentences().items() if not TERMINAL.search(place)}
    assert len(found) > 50
    options = [o for c in words.document()["commands"].values() for o in c.get("parameters", ())]
    flags = {flag for option in options for flag in option.get("flags", ())}
    for text, place in found.items():
        told = words.in_form_words(text)
        assert not re.search(r"(?<![\w-])--[a-z]|(?<![\w.])firebreak [a-z]+\b", told), (place, told)
        for flag in re.findall(r"(?<![\w-])--[a-z][a-z-]+", text):
            assert flag in flags, f"{place}: no command has {flag}"


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Invalid value for '--budget': 'abc' is no number", "Invalid value for \"Budget\": 'abc' is no number"),
        ("Invalid value for '--model-param' / '-p': no", 'Invalid value for "Parameters of the spread model": no'),
        ("give --wind-from or a--b, see --no-such-flag", 'give "Wind from" or a--b, see "No such flag"'),
        ("there is none; give --weather FILE", 'there is none; give "Table of weather"'),
        (
            "align it first (firebreak align --like, or read_landscape(like=...))",
            'align it first ("Align landscape" "Take the grid of this raster")',
        ),
        (
            "make it with firebreak network --clock (spread_network(..., clock=True)), or bring 8 bands",
            'make it with "Spread network" "Tell times too", or bring 8 bands',
        ),
        ("say so (--src-nodata dem=-1) for DEM", 'say so ("No-data values" dem=-1) for "Elevation"'),
    ],
)
def test_messages_are_told_in_the_words_of_the_form(said, told):
    assert words.in_form_words(said) == told


def test_messages_name_the_labels_of_the_language(monkeypatch):
    monkeypatch.setitem(translation._texts, words.label_of("budget"), "Umfang, z. B. 10%")
    assert words.in_form_words("--budget is 2") == '"Umfang" is 2'


# --- documentation ------------------------------------------------------------------------------------------


def test_the_help_address_of_every_form_is_in_the_documentation(tmp_path):
    """The page that `docs/reference.py` writes has the heading whose anchor the help opens."""
    spec = importlib.util.spec_from_file_location("reference", ROOT / "docs" / "reference.py")
    reference = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(reference)
    conf = (ROOT / "docs" / "conf.py").read_text(encoding="utf-8")
    page = re.search(r'^PAGE = "(.*)"$', (PLUGIN / "texts.py").read_text(encoding="utf-8"), re.MULTILINE)[1]
    folder, _, anchor = page.strip("/").partition("/commands.html#")
    assert f'reference.write(HERE / "{folder}")' in conf
    reference.write(tmp_path)
    text = (tmp_path / "commands.md").read_text(encoding="utf-8")
    titles = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    anchors = {re.sub("[^a-z0-9]+", "-", title.lower()).strip("-") for title in titles}
    anchors |= set(re.findall(r"^\((.+)\)=$", text, re.MULTILINE))
    assert {anchor.format(command=form.name) for form in forms.FORMS} <= anchors
