"""The reference: a lasting anchor for every command and method, and the way from a command to its name in Python."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

import firebreak_gis as fb
from firebreak_gis import plugins
from firebreak_gis.cli import firebreak

DOCS = Path(__file__).resolve().parents[2] / "docs"


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The pages as a build writes them, by name."""
    spec = importlib.util.spec_from_file_location("reference", DOCS / "reference.py")
    reference = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(reference)
    folder = tmp_path_factory.mktemp("generated")
    reference.write(folder)
    return {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}


def anchors(text):
    """Names of targets that stand right above a heading, with the heading."""
    return dict(re.findall(r"^\(([a-z0-9.-]+)\)=\n+#+ (.+)$", text, re.MULTILINE))


def test_commands(pages):
    found = anchors(pages["commands.md"])
    assert set(firebreak.list_commands(None)) <= set(found)
    assert {"reproduce-landscape", "reproduce-artificial-forest"} <= set(found)
    for name, heading in found.items():
        assert heading == f"firebreak {name.replace('-', ' ', 1) if name.startswith('reproduce-') else name}"


def test_methods(pages):
    found = anchors(pages["methods.md"])
    for kind in plugins.KINDS:
        for name in plugins.names(kind):
            assert found[name.replace("_", "-")] == name


def test_no_anchor_is_there_twice(pages):
    every = [name for text in pages.values() for name in re.findall(r"^\(([^)]+)\)=$", text, re.MULTILINE)]
    assert len(every) == len(set(every))
    assert every == [name.lower() for name in every]  # as they stand in an address


def test_commands_lead_to_their_names_in_python(pages):
    api = anchors(pages["api.md"])
    assert len(api) == len([name for name in fb.__all__ if not name.startswith("__")])
    for command, target in re.findall(r"## firebreak (\w+)\n.*?api\.md#([\w-]+)\)", pages["commands.md"], re.DOTALL):
        assert target in api, command
    assert "[`fb.simulate`](api.md#fb-simulate)" in pages["commands.md"]
