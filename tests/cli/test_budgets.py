"""`--budget 10%`, `5ha`, `20000eur` cut what the plain number with its unit cuts, in every command."""

from __future__ import annotations

import json

import numpy as np
import pandas as pd
import pytest
import rasterio
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from firebreak_gis.landscape import write_landscape

pytestmark = pytest.mark.usefixtures("no_pictures")

#: As words of a command line: the same budget told twice.
SAME = {
    "share": (["--budget", "14%"], ["--budget", "0.14"]),
    "hectares": (["--budget", "2.5 ha"], ["--budget", "2.5", "--budget-unit", "ha"]),
    "money": (["--budget", "900 EUR"], ["--budget", "900", "--budget-unit", "cost"]),
}


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


@pytest.fixture(scope="module")
def files(make_landscape, tmp_path_factory):
    folder = tmp_path_factory.mktemp("budgets")
    landscape = make_landscape((18, 23), seed=3, holes=0.05)
    write_landscape(landscape, folder / "land")
    run("network", folder / "land", "-o", folder / "network.tif")
    with rasterio.open(folder / "network.tif") as source:
        profile = {**source.profile, "count": 1, "driver": "GTiff", "dtype": "float32"}
    for key in ("blockxsize", "blockysize", "tiled", "interleave", "compress"):
        profile.pop(key, None)
    with rasterio.open(folder / "cost.tif", "w", **profile) as target:
        target.write(np.full(landscape["burnable"].shape, 350.0, np.float32), 1)
    return folder


def pixels(path):
    with rasterio.open(path) as source:
        return source.read(1)


@pytest.mark.parametrize("words", SAME.values(), ids=SAME)
def test_plans_are_the_same_and_repeat_from_their_account(files, tmp_path, words):
    layers = [files / "land" / f"{name}.tif" for name in ("elevation", "vegetation", "density")]
    usual = ["--runs", 4, "--method", "flammability", "--cost", files / "cost.tif"]
    for name, budget in zip("ab", words, strict=True):
        run("plan", *layers, *usual, *budget, "-o", tmp_path / name)
    one, two = (pixels(tmp_path / name / "breaks.tif") for name in "ab")
    assert one.sum() > 0
    np.testing.assert_array_equal(one, two)
    asked = json.loads((tmp_path / "a/run.json").read_text(encoding="utf-8"))["parameters"]
    assert asked["budget"] == words[0][1]
    assert "budget_unit" not in asked
    run("plan", "--config", tmp_path / "a/run.json", "-o", tmp_path / "again")
    assert (tmp_path / "again/breaks.tif").read_bytes() == (tmp_path / "a/breaks.tif").read_bytes()


@pytest.mark.parametrize("words", [SAME["share"], SAME["hectares"]], ids=["share", "hectares"])
def test_rank_and_breaks(files, tmp_path, words):
    for name, budget in zip("ab", words, strict=True):
        run("rank", files / "network.tif", "--method", "stripes", *budget, "-o", tmp_path / f"{name}_priority.tif")
        told = run("breaks", tmp_path / f"{name}_priority.tif", *budget, "-o", tmp_path / f"{name}.tif")
        assert "ranked for" not in told.output
    assert (tmp_path / "a_priority.tif").read_bytes() == (tmp_path / "b_priority.tif").read_bytes()
    assert (tmp_path / "a.tif").read_bytes() == (tmp_path / "b.tif").read_bytes()


@pytest.mark.parametrize("command", ["compare", "evaluate"])
def test_lists_of_budgets(files, tmp_path, command):
    """Hectares become the share that cuts the same cells; money buys each ranking another area and is refused."""
    methods = ["--methods", "flammability,random", "--runs", 5, "--timeless"]
    with rasterio.open(files / "network.tif") as source:
        area = abs(source.transform.a * source.transform.e) / 10_000
    run(command, files / "network.tif", *methods, "--budgets", "2ha,5%,0.1", "-o", tmp_path / "a")
    table = pd.read_csv(tmp_path / "a" / {"compare": "comparison.csv", "evaluate": "evaluation.csv"}[command])
    assert {0.05, 0.1} <= set(table["d_f"])
    other = table[~table["d_f"].isin([0.05, 0.1])]
    assert set(other["cells_cut"]) == {int(2 / area + 1e-9)}
    money = run(command, files / "network.tif", *methods, "--budgets", "500eur", "-o", tmp_path / "b", code=2)
    assert "--cost" in money.output if command == "compare" else "another area" in money.output
    assert not (tmp_path / "b").exists()
