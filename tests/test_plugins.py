"""Plug-ins: found by file or entry point, parameters converted and held to their ranges, described as data."""

from __future__ import annotations

import dataclasses
import json
import types

import numpy as np
import pytest

from firebreak_gis import SpreadNetwork, plugins, rank, spread_network
from firebreak_gis.errors import ParameterError
from firebreak_gis.plugins import parameter

EVERY = [(kind, name) for kind in plugins.KINDS for name in plugins.names(kind)]


@pytest.mark.parametrize(("kind", "name"), EVERY)
def test_described_parameters_are_those_that_can_be_given(kind, name):
    entry = plugins.describe(kind, name)
    assert json.loads(json.dumps(entry)) == entry
    assert entry["summary"]
    assert "\n" not in entry["summary"]
    module = plugins.load(kind, name)
    assert [p["name"] for p in entry["parameters"]] == [f.name for f in dataclasses.fields(module.Params)]
    defaults = {p["name"]: p["default"] for p in entry["parameters"]}
    assert plugins.build_params(module, defaults) == module.Params()
    as_text = {key: str(value) for key, value in defaults.items() if value is not None}
    assert plugins.build_params(module, as_text) == module.Params()
    for p in entry["parameters"]:
        assert p["text"]
        for bound, beyond in (("minimum", -1), ("maximum", 1)):
            if bound in p:
                with pytest.raises(ParameterError, match=p["name"]):
                    plugins.build_params(module, {p["name"]: p[bound] + beyond})
    with pytest.raises(ParameterError, match="no_such_thing"):
        plugins.build_params(module, {"no_such_thing": 1})


@pytest.mark.parametrize("kind", plugins.KINDS)
def test_unknown_methods_are_refused_naming_the_known(kind):
    with pytest.raises(ParameterError) as caught:
        plugins.load(kind, "none_of_these")
    for name in plugins.names(kind):
        assert name in str(caught.value)


@dataclasses.dataclass(frozen=True)
class Params:
    share: float = parameter(0.5, text="a share", minimum=0.0, maximum=1.0, open_maximum=True)
    count: int = parameter(3, text="a count", minimum=1)
    exact: bool = parameter(True, text="a switch")
    limit: float | None = parameter(None, text="a limit or none")
    word: str = parameter("in", text="a word", choices=("in", "out"))
    wind: float = parameter(0.0, text="a number or raster", minimum=0.0, raster=True)


MODULE = types.ModuleType("somewhere.sketch")
MODULE.Params = Params


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"share": "0.25"}, 0.25),
        ({"share": 0}, 0.0),
        ({"count": "7"}, 7),
        ({"count": 7.0}, 7),
        ({"exact": "no"}, False),
        ({"exact": "TRUE"}, True),
        ({"exact": False}, False),
        ({"limit": None}, None),
        ({"limit": "2"}, 2.0),
        ({"word": "out"}, "out"),
        ({"wind": "3.5"}, 3.5),
        ({"wind": np.float32(2)}, 2.0),
    ],
)
def test_values_are_converted(given, expected):
    (name,) = given
    got = getattr(plugins.build_params(MODULE, given), name)
    assert got == expected
    assert type(got) is type(expected)


@pytest.mark.parametrize(
    "given",
    [
        {"share": 1.0},
        {"share": -0.1},
        {"share": "half"},
        {"share": float("nan")},
        {"share": None},
        {"count": 2.5},
        {"count": 0},
        {"count": "many"},
        {"exact": "perhaps"},
        {"exact": 2},
        {"word": "both"},
        {"limit": "inf"},
        {"wind": -1},
        {"wind": "raster.tif"},
        {"wind": np.int64(-1)},
    ],
)
def test_impossible_values_are_refused(given):
    with pytest.raises(ParameterError, match=f"sketch parameter {next(iter(given))}"):
        plugins.build_params(MODULE, given)


def test_every_fault_is_named_at_once():
    with pytest.raises(ParameterError) as caught:
        plugins.build_params(MODULE, {"share": 2, "count": "x", "colour": "red"})
    for word in ("share", "count", "colour"):
        assert word in str(caught.value)


def test_a_raster_passes_as_it_is():
    plane = np.ones((2, 3))
    assert plugins.build_params(MODULE, {"wind": plane}).wind is plane


PLUGIN = '''"""West first: for the tests.

More text.
"""
from dataclasses import dataclass
import numpy as np
from firebreak_gis.plugins import parameter

@dataclass(frozen=True)
class Params:
    """Parameters."""
    sign: float = parameter(-1.0, text="Sign", minimum=-1.0, maximum=1.0)

def rank(network, params, *, stakes, seed, progress):
    progress(1.0, "done")
    return params.sign * np.broadcast_to(np.arange(network.shape[1], dtype=float), network.shape)

def probability(landscape, params):
    return np.full((8, *landscape["burnable"].shape), 0.25, np.float32)
'''


@pytest.fixture
def stranger(tmp_path, monkeypatch):
    """An installed distribution of somebody else with two plug-ins in one module, and one that is broken."""
    (tmp_path / "strange_plugin.py").write_text(PLUGIN)
    (tmp_path / "broken_plugin.py").write_text("def rank(network): ...\n")
    info = tmp_path / "strange-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: strange\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(
        "[firebreak_gis.ranking]\nwest = strange_plugin\nbroken = broken_plugin\n"
        "[firebreak_gis.spread]\nflat = strange_plugin\n"
    )
    monkeypatch.syspath_prepend(tmp_path)


def test_strangers_add_methods(stranger, make_landscape):
    assert "west" in plugins.names("ranking")
    assert "flat" in plugins.names("spread")
    assert plugins.describe("ranking", "west")["summary"] == "West first: for the tests."
    network = spread_network(make_landscape(), model="flat")
    assert set(np.unique(network.probability)) == {np.float32(0), np.float32(0.25)}
    priority = rank(network, "west").to_numpy()
    assert np.isneginf(priority[~network.burnable]).all()
    assert (priority[network.burnable] == -np.nonzero(network.burnable)[1]).all()
    assert isinstance(network, SpreadNetwork)
    with pytest.raises(ParameterError, match=r"lacks a function rank\(\) or a dataclass Params"):
        plugins.load("ranking", "broken")
    with pytest.raises(ParameterError, match="sign"):
        rank(network, "west", sign=3)


def test_strangers_are_gone_again():
    assert "west" not in plugins.names("ranking")


def test_what_is_installed_is_looked_through_once(monkeypatch):
    plugins.names("ranking")
    monkeypatch.setattr(plugins.importlib.metadata, "entry_points", lambda **_: pytest.fail("looked again"))
    assert plugins.load("ranking", "degree").__name__ == "firebreak_gis.ranking.degree"
    monkeypatch.syspath_prepend("elsewhere")
    with pytest.raises(pytest.fail.Exception, match="looked again"):
        plugins.names("ranking")
