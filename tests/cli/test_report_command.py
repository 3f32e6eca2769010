"""`firebreak report`: the page of a folder is the page that the run wrote; other folders are refused."""

from __future__ import annotations

import json
import shutil

import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from tests.places import three


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome.output


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    three(folder)
    layers = [folder / f"{name}.tif" for name in ("dem", "vegetation", "density")]
    run("plan", *layers, "--method", "degree", "--runs", 5, "-o", folder / "plan", "-q")
    run("align", *layers, "-o", folder / "land", "-q")
    run("network", folder / "land", "-o", folder / "net.tif", "-q")
    words = ["--methods", "degree,random", "--budgets", "0.05,0.1", "--residuals", 0, "--runs", 5]
    run("compare", folder / "net.tif", *words, "-o", folder / "compared", "-q")
    return folder


@pytest.mark.parametrize("made", ["plan", "compared"])
def test_the_page_of_a_folder_is_that_of_the_run(place, tmp_path, made):
    run("report", place / made, "-o", tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    own = (place / made / "report.html").read_text(encoding="utf-8")
    if made == "plan":
        assert page == own
    for name in ("run.json", "breaks.tif" if made == "plan" else "comparison.csv"):
        assert f'href="./{name}"' in page
    for text in (page, own):
        assert text.startswith("<!DOCTYPE html>")
        assert text.count("<section") >= 3


def test_other_folders_are_refused_in_words(place, tmp_path):
    assert "run.json" in run("report", tmp_path, "-o", tmp_path / "page.html", code=3)
    (tmp_path / "run.json").write_text(json.dumps({"software": "firebreak_gis", "command": "align"}))
    assert "'align'" in run("report", tmp_path, "-o", tmp_path / "page.html", code=3)
    (tmp_path / "run.json").write_text(json.dumps({"software": "another", "command": "plan"}))
    assert "not the account" in run("report", tmp_path, "-o", tmp_path / "page.html", code=3)
    shutil.copytree(place / "plan", tmp_path / "cut")
    (tmp_path / "cut" / "segments.gpkg").unlink()
    assert "lacks segments.gpkg" in run("report", tmp_path / "cut", "-o", tmp_path / "page.html", code=3)
    assert not (tmp_path / "page.html").exists()


def test_files_of_the_run_are_never_written_over(place):
    before = (place / "plan" / "run.json").read_bytes()
    assert "exists" in run("report", place / "plan", "-o", place / "plan" / "report.html", code=4)
    run("report", place / "plan", "-o", place / "plan" / "report.html", "--overwrite")
    assert (place / "plan" / "run.json").read_bytes() == before
