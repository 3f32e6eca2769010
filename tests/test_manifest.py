"""The account of a run: hashes, plain data, configurations."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import numpy as np
import pytest

from firebreak_gis import __version__, manifest
from firebreak_gis.errors import InputError, OutputError, ParameterError
from firebreak_gis.files.outputs import Writing
from firebreak_gis.manifest import plain, provenance, read_config
from tests import places


@pytest.fixture
def files(tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "out").mkdir()
    for name in ("in/dem.tif", "out/a.tif", "out/b c.csv"):
        (tmp_path / name).write_bytes(name.encode())
    return tmp_path


def write(files, **more):
    options = {
        "command": "plan",
        "parameters": {"budget": 0.14, "params": {"beta": np.float64(0.5)}, "dem": Path("x/dem.tif")},
        "inputs": [files / "in/dem.tif"],
        "written": [files / "out/a.tif", files / "out/b c.csv"],
        "account": {"cells": np.int64(7), "warnings": ("ölig",)},
    }
    return written(files / "out/run.json", **{**options, **more})


def written(path, *, command, account, **how):
    manifest.account(command, lambda result: result).write(account, path, Writing(**how))
    return path


def test_manifest_says_what_went_in_and_came_out(files):
    text = write(files).read_text(encoding="utf-8")
    document = json.loads(text)
    assert document["version"] == __version__
    assert document["command"] == "plan"
    assert document["cells"] == 7
    assert document["warnings"] == ["ölig"]
    assert "ölig" in text
    assert [entry["path"] for entry in document["outputs"]] == ["a.tif", "b c.csv"]
    names = ("in/dem.tif", "out/a.tif", "out/b c.csv")
    for entry, name in zip(document["inputs"] + document["outputs"], names, strict=True):
        assert entry["sha256"] == hashlib.sha256(name.encode()).hexdigest()
    assert read_config(files / "out/run.json") == {"budget": 0.14, "params": {"beta": 0.5}, "dem": "x/dem.tif"}


def test_manifest_is_not_replaced_unless_asked(files):
    write(files)
    old = (files / "out/run.json").read_bytes()
    with pytest.raises(OutputError, match="exists"):
        write(files, command="align")
    assert (files / "out/run.json").read_bytes() == old
    write(files, command="align", overwrite=True)
    assert json.loads((files / "out/run.json").read_text())["command"] == "align"
    with pytest.raises(InputError):
        write(files, inputs=[files / "gone.tif"], overwrite=True)
    assert json.loads((files / "out/run.json").read_text())["command"] == "align"


def test_grids_are_told_of_rasters_alone(tmp_path):
    """What is a vector is known by its name, as everywhere, and never opened as a raster."""
    raster = places.write(tmp_path / "a.tif", np.zeros((3, 4), np.uint8))
    vectors = [tmp_path / name for name in ("a.kml", "a.gml", "a.shz", "a.gdb.zip")]
    for path in vectors:
        path.write_bytes(raster.read_bytes())
    path = written(tmp_path / "run.json", command="plan", inputs=[raster, *vectors], account={})
    first, *others = json.loads(path.read_text())["inputs"]
    assert first["shape"] == [3, 4]
    assert [set(entry) for entry in others] == [{"path", "sha256"}] * len(vectors)


def test_provenance_knows_equal_parameters():
    one = provenance({"b": 1, "a": (2, 3)}, seed=4)
    assert one == provenance({"a": [2, 3], "b": 1}, seed=4)
    assert one["parameters_sha256"] != provenance({"b": 2, "a": (2, 3)}, seed=4)["parameters_sha256"]
    assert one["seed"] == "4"
    assert "seed" not in provenance({})
    assert all(isinstance(value, str) for value in one.values())


def test_plain_data_are_json():
    rasters = [np.arange(6.0).reshape(2, 3), np.arange(6.0).reshape(2, 3) + 1]
    data = {
        1: (np.float32(0.5), np.int64(3), np.bool_(True), None, "x"),
        "path": Path("a") / "b",
        "one": np.array([7]),
        "raster": rasters[0],
    }
    got = plain(data)
    assert json.loads(json.dumps(got)) == got
    assert got["1"] == [0.5, 3, True, None, "x"]
    assert got["path"] == str(Path("a") / "b")
    assert got["one"] == 7
    assert got["raster"].startswith("array 2 x 3")
    assert plain(rasters[0]) == plain(rasters[0].copy()) != plain(rasters[1])


def test_rasters_with_coordinates_are_named_by_content(make_landscape):
    elevation = make_landscape()["elevation"]
    assert plain(elevation) == plain(elevation.to_numpy())


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.toml", "budget = 0.14\n[method_params]\nbeta = 0.5\n"),
        ("a.json", '{"budget": 0.14, "method_params": {"beta": 0.5}}'),
        ("run.JSON", '{"command": "plan", "parameters": {"budget": 0.14, "method_params": {"beta": 0.5}}}'),
    ],
)
def test_configurations(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    assert read_config(tmp_path / name) == {"budget": 0.14, "method_params": {"beta": 0.5}}


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.toml", b"budget 3"),
        ("a.json", b"{"),
        ("a.json", b"[1]"),
        ("a.json", b'{"parameters": 3}'),
        ("a.toml", b"\xff"),
    ],
)
def test_broken_configurations_are_refused(tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(ParameterError, match=name):
        read_config(tmp_path / name)
    with pytest.raises(ParameterError, match=r"none\.toml"):
        read_config(tmp_path / "none.toml")
