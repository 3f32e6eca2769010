"""Benchmarks can be run, their landscapes are the same however made, and what is told of growth was measured."""

from __future__ import annotations

import importlib
import json
from pathlib import Path

import numpy as np
import pytest
import rasterio

from tests.benchmarks import fires, large
from tests.benchmarks.growth import draw, slope
from tests.benchmarks.measuring import Comparison


@pytest.mark.parametrize("name", sorted(file.stem for file in Path(large.__file__).parent.glob("[a-z]*.py")))
def test_every_benchmark_finds_what_it_measures(name):
    assert importlib.import_module(f"tests.benchmarks.{name}").__doc__


def test_fires_are_burnt_as_the_program_burns_them_now():
    for row in fires.rows(40):
        if isinstance(row, Comparison):
            assert row.agree(row.ours(), row.theirs())


def test_noise_does_not_depend_on_the_rows_that_are_made_at_once():
    whole = large.noise(300, 7, 0, 300)
    parts = [large.noise(300, 7, first, min(77, 300 - first)) for first in range(0, 300, 77)]
    np.testing.assert_array_equal(np.concatenate(parts), whole)
    assert not np.array_equal(whole, large.noise(300, 8, 0, 300))


def test_layers_are_the_same_again_and_differ_in_themselves(tmp_path, monkeypatch):
    large.make(tmp_path / "a", 200)
    monkeypatch.setattr(large, "_ROWS", 64)
    large.make(tmp_path / "b", 200)
    for name in ("dem", "vegetation", "density"):
        with rasterio.open(tmp_path / f"a/{name}.tif") as one, rasterio.open(tmp_path / f"b/{name}.tif") as other:
            np.testing.assert_array_equal(one.read(), other.read())
    with rasterio.open(tmp_path / "a/vegetation.tif") as vegetation:
        assert len(np.unique(vegetation.read(1))) > 1


def test_growth_is_told_from_what_was_measured(tmp_path):
    sizes = (10**4, 10**5, 10**6, 10**7)
    lines = [
        {
            "step": "step",
            "cells": n,
            "wall": 0.0,
            "processor": 2.0 + 3e-6 * (n - 10**4) ** 1.2,
            "memory": 10**8 + 40 * n,
        }
        for n in sizes
    ]
    assert slope(lines, "processor") == pytest.approx(1.2, abs=0.05)
    assert slope(lines, "memory") == pytest.approx(1.0, abs=0.05)
    (tmp_path / "1.jsonl").write_text("\n".join(json.dumps(line) for line in [*lines, {**lines[0], "wall": 9.0}]))
    read = large.read(tmp_path)
    assert len(read) == 4
    assert next(line["wall"] for line in read if line["cells"] == 10**4) == 9.0
    table = draw(read, tmp_path)
    assert "| step |" in table
    assert (tmp_path / "growth.png").stat().st_size > 1000
    assert len((tmp_path / "growth.csv").read_text().splitlines()) == 5
