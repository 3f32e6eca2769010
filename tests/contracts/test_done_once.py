"""What takes time, or could be answered in two ways, is done once in a run."""

from __future__ import annotations

import sys
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner

import firebreak_gis
from firebreak_gis.cli import firebreak

SAMPLE = Path(__file__).resolve().parents[2] / "sample_data"
PACKAGE = str(Path(firebreak_gis.__file__).parent)


@contextmanager
def counting():
    """Calls of the package's functions, by qualified name."""
    counts = Counter()

    def note(frame, event, _):
        if event == "call" and frame.f_code.co_filename.startswith(PACKAGE):
            counts[frame.f_code.co_qualname] += 1

    sys.setprofile(note)
    try:
        yield counts
    finally:
        sys.setprofile(None)


@pytest.fixture(scope="module")
def network(tmp_path_factory):
    folder = tmp_path_factory.mktemp("network")
    layers = [str(SAMPLE / f"{name}.tif") for name in ("dem", "vegetation", "density")]
    for words in (
        ["align", *layers, "--res", "200", "-o", str(folder / "land"), "-q"],
        ["network", str(folder / "land"), "-o", str(folder / "net.tif"), "-q"],
    ):
        assert CliRunner().invoke(firebreak, words).exit_code == 0
    return folder / "net.tif"


FIRES = ["--ignitions", str(SAMPLE / "ignitions.gpkg"), "--runs", "5"]


def test_a_plan_reads_and_finds_everything_once(tmp_path):
    layers = [str(SAMPLE / f"{name}.tif") for name in ("dem", "vegetation", "density")]
    words = ["plan", *layers, "--res", "200", "--method", "degree", "--wind-speed", "3", *FIRES]
    with counting() as counts:
        outcome = CliRunner().invoke(firebreak, [*words, "-o", str(tmp_path / "out"), "-q"])
    assert outcome.exit_code == 0, outcome.output
    once = ("survey", "SpreadRequest.params", "StakesRequest.read", "ignition_places", "feasibility")
    assert {name: counts[name] for name in once} == dict.fromkeys(once, 1)
    assert counts["spread_network"] == 2  # the one that designs rank on, and the one with a clock that is burnt


@pytest.mark.parametrize("words", [["compare", "--methods", "degree,random"], ["evaluate", "--methods", "degree"]])
def test_places_of_fires_are_read_once(words, network, tmp_path):
    command, *more = words
    with counting() as counts:
        said = [command, str(network), *more, *FIRES, "-o", str(tmp_path / "out"), "-q"]
        outcome = CliRunner().invoke(firebreak, said)
    assert outcome.exit_code == 0, outcome.output
    assert counts["ignition_places"] == counts["read_starts"] == 1
