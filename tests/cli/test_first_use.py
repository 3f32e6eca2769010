"""The first minutes: a demo without any file, and hints for words that are almost right."""

from __future__ import annotations

import json
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak


def test_the_demo_plans_on_the_sample_and_opens_the_report(tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(click, "launch", lambda address: opened.append(address) or 0)
    words = ["demo", "-o", str(tmp_path / "out"), "--res", "120", "--runs", "5", "--method", "degree", "-q"]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    assert opened == [(tmp_path / "out" / "report.html").resolve().as_uri()]
    told = json.loads((tmp_path / "out" / "run.json").read_text(encoding="utf-8"))
    assert told["parameters"]["resolution"] == 120
    assert told["parameters"]["dem"].endswith("dem.tif")


def test_the_demo_may_leave_the_browser_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(click, "launch", lambda _: pytest.fail("a browser was opened"))
    words = ["demo", "-o", str(tmp_path / "out"), "--no-open", "--res", "120", "--runs", "5", "--method", "degree"]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    assert "report.html" in outcome.output
    assert CliRunner().invoke(firebreak, [*words, "--budget", "2"]).exit_code == 2


@pytest.mark.parametrize(
    ("word", "hint"), [("pln", "did you mean plan"), ("segment", "segments"), ("xyzzy", "firebreak --help")]
)
def test_words_that_are_almost_commands(word, hint):
    outcome = CliRunner().invoke(firebreak, [word])
    assert outcome.exit_code == 2
    assert hint in outcome.output


def test_options_that_are_almost_right():
    outcome = CliRunner().invoke(firebreak, ["plan", "--budgt", "0.1"])
    assert outcome.exit_code == 2
    assert "--budget" in outcome.output


def test_the_list_of_commands_cuts_no_sentence():
    text = CliRunner().invoke(firebreak, ["--help"]).output
    assert "..." not in text.split("Commands:")[1]
    for name in firebreak.list_commands(None):
        assert f"  {name} " in text


def completed(words):
    """What bash would be told for the last of the words."""
    told = {"COMP_WORDS": "firebreak " + words, "COMP_CWORD": str(len(words.split(" ")))}
    outcome = CliRunner().invoke(
        firebreak, [], prog_name="firebreak", env={"_FIREBREAK_COMPLETE": "bash_complete", **told}
    )
    assert outcome.exit_code == 0, outcome.output
    return list(filter(None, outcome.output.splitlines()))


@pytest.mark.parametrize("shell", ["zsh", "fish"])
def test_scripts_for_shells(shell):
    source = {"_FIREBREAK_COMPLETE": f"{shell}_source"}
    outcome = CliRunner().invoke(firebreak, [], prog_name="firebreak", env=source)
    assert outcome.exit_code == 0, outcome.output
    assert f"_FIREBREAK_COMPLETE={shell}_complete" in outcome.output


def test_the_page_on_commands_tells_of_the_scripts():
    page = (Path(__file__).parents[2] / "docs/commands-and-files.md").read_text(encoding="utf-8")
    for shell in ("bash", "zsh", "fish"):
        assert f"_FIREBREAK_COMPLETE={shell}_source firebreak" in page


def test_words_are_completed():
    assert completed("pl") == ["plain,plan"]
    assert "plain,--budget" in completed("plan --bud")
    assert completed("plan --method diss") == ["plain,dissection"]
    assert completed("compare --methods random,compart") == ["plain,random,compartments"]
    assert completed("plan --legend cori") == ["plain,corine", "plain,corine_grid"]
    assert completed("plan --budget 1") == []
    assert completed("plan de") == ["file,de"]
