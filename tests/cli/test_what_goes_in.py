"""What users bring to the commands reaches the work: options in any order, rasters on any grid, numbers in legends."""

import importlib
import json

import numpy as np
import pytest
import rasterio
import rasterio.shutil
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from tests.places import NORTH_WEST, patches, relief, square, three, write

pytestmark = pytest.mark.usefixtures("no_pictures")

ROWS, COLS = 24, 31


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


def read(path):
    with rasterio.open(path) as source:
        return source.read(masked=True)


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    folder = tmp_path_factory.mktemp("place")
    three(folder, ROWS, COLS)
    run("align", *layers(folder), "-o", folder / "land", "-q")
    run("network", folder / "land", "-o", folder / "network.tif", "-q")
    weights = np.zeros((7, 8), "float32")
    weights[2, 3] = 0.5
    write(folder / "likely.tif", weights, transform=square(100.0, (NORTH_WEST[0] - 30, NORTH_WEST[1] + 40)))
    return folder


def layers(folder):
    return [folder / f"{name}.tif" for name in ("dem", "vegetation", "density")]


@pytest.mark.parametrize("command", ["evaluate", "compare"])
def test_ignitions_are_looked_at_before_the_ranking(place, tmp_path, monkeypatch, command):
    # These take the ranking by its name when they are loaded, which must not be while it is another.
    for name in ("planning.pipeline", "planning.comparison", f"cli.commands.{command}"):
        importlib.import_module(f"firebreak_gis.{name}")

    def never(*_, **__):
        raise AssertionError("ranked before the ignitions were looked at")

    monkeypatch.setattr("firebreak_gis.ranking.rank", never)
    write(tmp_path / "none.tif", np.zeros((ROWS, COLS), "float32"))
    words = [command, place / "network.tif", "--methods", "degree,random", "-o", tmp_path / "out"]
    assert "zero on every cell" in run(*words, "--ignitions", tmp_path / "none.tif", code=3).output
    assert "n_runs is 0" in run(*words, "--runs", 0, code=2).output


@pytest.mark.parametrize("command", ["plan", "burn", "evaluate", "compare"])
def test_ignition_rasters_may_lie_on_another_grid(place, tmp_path, command):
    more = {
        "plan": [*layers(place), "--method", "degree"],
        "burn": [place / "network.tif"],
        "evaluate": [place / "network.tif", "--methods", "degree,random", "--budgets", "0,0.1"],
        "compare": [place / "network.tif", "--methods", "degree,random", "--budgets", "0.1"],
    }
    target = tmp_path / ("f.tif" if command == "burn" else "out")
    run(command, *more[command], "--ignitions", place / "likely.tif", "--runs", 30, "-o", target, "-q")
    if command in ("evaluate", "compare"):
        told = json.loads((target / "run.json").read_text())["inputs"]
        assert str(place / "likely.tif") in [entry["path"] for entry in told]
        return
    frequency = read(target if command == "burn" else target / "burn_frequency.tif")[0]
    fires = np.argwhere(frequency.filled(0) > 0)
    assert len(fires) > 5
    # The weight lies on rows 8 to 12 and columns 14 to 18: there, at least, it burns most.
    assert frequency[8:13, 14:19].mean() > frequency.mean()


def test_the_order_of_options_does_not_matter(place, tmp_path):
    options = [["--runs", 9], ["--budgets", "0,0.1"], ["--methods", "degree,random"], ["--seed", 4]]
    for command, name in (("evaluate", "evaluation.csv"), ("compare", "comparison.csv")):
        for folder, order in (("one", options), ("two", options[::-1])):
            words = [word for option in order for word in option]
            run(command, place / "network.tif", *words, "-o", tmp_path / command / folder, "-q")
        for file in ("run.json", name):
            one, two = ((tmp_path / command / folder / file).read_bytes() for folder in ("one", "two"))
            assert one == two, (command, file)


@pytest.mark.parametrize("command", ["plan", "align"])
def test_creation_options_reach_every_raster(place, tmp_path, command):
    more = ["--method", "random", "--runs", 3] if command == "plan" else []
    run(command, *layers(place), *more, "-o", tmp_path / "out", "--co", "COMPRESS=LZW", "-q")
    for path in (tmp_path / "out").glob("*.tif"):
        with rasterio.open(path) as source:
            assert source.compression.name == "lzw", path.name


def test_numbers_in_a_legend_are_the_factors_of_the_network(place, tmp_path):
    """The paper's numbers in place of its classes give the same network; other numbers another one."""
    rows = {0: "none,", 1: "-0.3,-0.4", 2: "0.0,0.0", 3: "0.4,0.3"}
    words = {0: "none,", 1: "agricultural,sparse", 2: "shrubs,normal", 3: "pines,dense"}
    for name, table in (("numbers", rows), ("words", words), ("others", {**rows, 3: "1.5,0.3"})):
        lines = ["code,vegetation,density,label", *(f"{code},{text},x" for code, text in table.items())]
        (tmp_path / f"{name}.csv").write_text("\n".join(lines))
        run("align", *layers(place)[:2], "--legend", tmp_path / f"{name}.csv", "-o", tmp_path / name, "-q")
        run("network", tmp_path / name, "-o", tmp_path / f"{name}.tif", "-q")
    numbers, classes, others = (read(tmp_path / f"{name}.tif") for name in ("numbers", "words", "others"))
    np.testing.assert_allclose(numbers.filled(-1), classes.filled(-1), rtol=1e-6)
    assert (others >= numbers).all()
    assert (others > numbers).any()


def test_weather_on_grids_of_its_own(place, tmp_path):
    """Coarse rasters of constant wind and moisture are what the numbers are."""
    coarse = {"transform": square(400.0, (NORTH_WEST[0] - 100, NORTH_WEST[1] + 100))}
    for name, value in (("speed", 5.0), ("direction", 300.0), ("moisture", 0.06)):
        write(tmp_path / f"{name}.tif", np.full((4, 4), value, "float32"), **coarse)
    run("network", place / "land", "--wind-speed", 5, "--wind-from", 300, "--moisture", 0.06, "-o", tmp_path / "a.tif")
    run(
        "network",
        place / "land",
        "--wind-speed",
        tmp_path / "speed.tif",
        "--wind-from",
        tmp_path / "direction.tif",
        "--moisture",
        tmp_path / "moisture.tif",
        "-o",
        tmp_path / "b.tif",
    )
    np.testing.assert_allclose(read(tmp_path / "a.tif"), read(tmp_path / "b.tif"), rtol=1e-5)
    dry = read(place / "network.tif")
    run("network", place / "land", "--moisture", 0.06, "-o", tmp_path / "damp.tif")
    damp = read(tmp_path / "damp.tif")
    assert (damp < dry).sum() == (dry > 0).sum()
    run("network", place / "land", "--model", "artificial", "--moisture", 0.06, "-o", tmp_path / "c.tif", code=2)


def test_a_plan_from_one_landscape_file(place, tmp_path):
    heights = relief(ROWS, COLS).astype("int16")
    codes = np.where(patches(ROWS, COLS, [0, 1, 2]) == 0, 98, 165).astype("int16")
    cover = np.full((ROWS, COLS), 80, "int16")
    source = write(tmp_path / "s.tif", np.stack([heights, heights * 0, heights * 0, codes, cover]))
    rasterio.shutil.copy(source, tmp_path / "land.lcp", driver="LCP", LATITUDE="36")
    run("plan", tmp_path / "land.lcp", "-o", tmp_path / "out", "--method", "random", "--runs", 5, "-q")
    np.testing.assert_array_equal(read(tmp_path / "out/density.tif")[0], np.where(codes == 165, 3, 0))
    told = json.loads((tmp_path / "out/run.json").read_text())
    assert [entry["path"] for entry in told["inputs"]] == [str(tmp_path / "land.lcp")]
    run("plan", "--config", tmp_path / "out/run.json", "-o", tmp_path / "again", "-q")
    assert (tmp_path / "again/breaks.tif").read_bytes() == (tmp_path / "out/breaks.tif").read_bytes()
