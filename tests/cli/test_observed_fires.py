"""firebreak validate and firebreak calibrate, from files to files."""

import json
import tomllib

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import shapely
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from firebreak_gis.evaluation.forecasting import Case, open_case, run_case
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import write_landscape
from firebreak_gis.rasters import read_variable
from firebreak_gis.spread.raster import read_network

SHAPE = (45, 57)
ROSE = "rose:W=4"


def run(*words):
    return CliRunner().invoke(firebreak, [str(word) for word in words])


@pytest.fixture(scope="module")
def place(tmp_path_factory, make_landscape):
    """A folder with a landscape, the scar of a fire with half the usual rate, its start, and a table of fires."""
    folder = tmp_path_factory.mktemp("observed")
    land = make_landscape(SHAPE, holes=0.0, relief=0.0, vegetation=2, density=2)
    write_landscape(land, folder / "land")
    grid = Grid.of(land["burnable"])
    start = gpd.GeoDataFrame(geometry=[shapely.Point(grid.x[18], grid.y[22])], crs=grid.crs)
    start.to_file(folder / "start.gpkg")
    everything = np.ones(SHAPE, bool)
    made = run_case(open_case(Case(land, everything, start, "90min", ROSE)), {"rate_scale": 0.5}, n_runs=40)
    rows, cols = np.nonzero(made.probability >= 0.5)
    cells = [shapely.box(x - 10, y - 10, x + 10, y + 10) for x, y in zip(grid.x[cols], grid.y[rows], strict=True)]
    gpd.GeoDataFrame(geometry=[shapely.unary_union(cells)], crs=grid.crs).to_file(folder / "scar.shp")
    sizes = [0.5, 1.5, 2.0, 3.0, 4.5, 6.0, 8.0, 11.0]
    pd.DataFrame({"area_ha": sizes, "begun": "2020-08-01", "over": "2020-08-01"}).to_csv(
        folder / "fires.csv", index=False
    )
    line = "land,scar.shp,start.gpkg,90min,rose:W=4\n"
    (folder / "cases.csv").write_text("landscape,scar,start,duration,weather\n" + 2 * line)
    return folder


def validate(place, *more):
    return run("validate", place / "land", place / "scar.shp", "--start", place / "start.gpkg", "--runs", 40, *more)


def test_validate_tells_scores_and_writes_them(place, tmp_path):
    out = tmp_path / "out"
    told = validate(
        place, "--duration", "90min", "--weather", ROSE, "--model-param", "rate_scale=0.5", "-o", out, "--json"
    )
    assert told.exit_code == 0, told.output
    result = json.loads(told.stdout)["result"]
    assert result["beats"] == {"none": True, "distance": True, "ellipse": True}
    assert result["simulated_ha"] == pytest.approx(result["observed_ha"], rel=0.2)
    table = pd.read_csv(out / "scores.csv").set_index("model")
    assert table.loc["simulated", "growth_iou"] == pytest.approx(result["scores"]["simulated"]["growth_iou"])
    assert table["skill"].notna().tolist() == [False, False, True, True, True]
    assert pd.read_csv(out / "reliability.csv")["cells"].sum() == SHAPE[0] * SHAPE[1]
    assert read_variable(out / "burn_frequency.tif", "burn_frequency").max() == 1.0
    assert (out / "validation.png").stat().st_size > 20_000
    account = json.loads((out / "run.json").read_text())
    assert account["result"]["scores"] == result["scores"]
    assert any(entry["path"].endswith("scar.shp") for entry in account["inputs"])
    again = run("validate", "--config", out / "run.json", place / "land", place / "scar.shp", "-o", tmp_path / "b")
    assert again.exit_code == 0, again.output
    for name in ("scores.csv", "reliability.csv", "burn_frequency.tif", "validation.png"):
        assert (tmp_path / "b" / name).read_bytes() == (out / name).read_bytes(), name
    assert validate(place, "--duration", "90min", "-o", out).exit_code == 4


def test_validate_without_a_folder_writes_nothing(place, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = validate(place, "--duration", "lognormal:1h,0.5", "--wind-speed", 4, "--wind-from", 270)
    assert told.exit_code == 0, told.output
    assert "simulated" in told.stdout
    assert "assumed: duration 1 h in the median (lognormal, sigma 0.5)" in told.stdout
    assert list(tmp_path.iterdir()) == []


def test_validate_takes_a_network_with_times(place, tmp_path):
    net = tmp_path / "net.tif"
    made = run("network", place / "land", "-o", net, "--clock", "--wind-speed", 4, "--wind-from", 270)
    assert made.exit_code == 0, made.output
    words = ["--start", place / "start.gpkg", "--duration", "1h", "--runs", 30, "--json"]
    wind = ["--wind-speed", 4, "--wind-from", 270]
    one = run("validate", net, place / "scar.shp", *words, *wind)
    other = run("validate", place / "land", place / "scar.shp", *words, *wind)
    assert one.exit_code == other.exit_code == 0, one.output + other.output
    first, second = (json.loads(told.stdout)["result"] for told in (one, other))
    assert first["scores"] == second["scores"]
    timeless = tmp_path / "timeless.tif"
    assert run("network", place / "land", "-o", timeless).exit_code == 0
    refused = run("validate", timeless, place / "scar.shp", *words)
    assert refused.exit_code == 3
    assert "travel times" in refused.output


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["--duration", "soon"], 2, "expected"),
        (["--duration", "1h", "--start", "no.gpkg"], 3, "no.gpkg does not exist"),
        (["--duration", "1h", "--weather", ROSE, "--wind-speed", "3"], 2, "the weather tells what --wind-speed"),
        ([], 2, "--duration"),
    ],
)
def test_bad_validations_are_refused(place, words, code, message):
    told = validate(place, *words)
    assert told.exit_code == code, told.output
    assert message in told.output


def test_scars_calibrate_the_rate_and_every_command_takes_it(place, tmp_path):
    config = tmp_path / "region.toml"
    told = run(
        "calibrate", place / "cases.csv", "--runs", 30, "-o", config, "--table", tmp_path / "fires.csv", "--json"
    )
    assert told.exit_code == 0, told.output
    result = json.loads(told.stdout)["result"]
    rate = tomllib.loads(config.read_text())["parameters"]["model-param"]["rate_scale"]
    assert rate == result["parameters"]["model-param"]["rate_scale"] == pytest.approx(0.5, rel=0.15)
    assert pd.read_csv(tmp_path / "fires.csv")["size_ratio_left_out"].between(0.7, 1.4).all()
    nets = {}
    for name, words in {"own": ["--clock"], "fitted": ["--config", config]}.items():
        made = run("network", place / "land", "-o", tmp_path / f"{name}.tif", *words)
        assert made.exit_code == 0, made.output
        nets[name] = read_network(tmp_path / f"{name}.tif").travel_time[0, 20, 20]
    assert nets["fitted"] == pytest.approx(nets["own"] / rate, rel=0.02)
    assert (
        run("rank", tmp_path / "own.tif", "-o", tmp_path / "p.tif", "--config", config, "--method", "degree").exit_code
        == 0
    )
    assert validate(place, "--config", config, "--duration", "90min", "--weather", ROSE).exit_code == 0


def test_sizes_calibrate_durations(place, tmp_path):
    config = tmp_path / "region.toml"
    told = run(
        "calibrate",
        place / "land",
        place / "fires.csv",
        "--weather",
        ROSE,
        "--least",
        1,
        "--runs",
        40,
        "-o",
        config,
        "--first-day-column",
        "begun",
        "--last-day-column",
        "over",
        "--longest",
        "20h",
        "--json",
    )
    assert told.exit_code == 0, told.output
    result = json.loads(told.stdout)["result"]
    parameters = tomllib.loads(config.read_text())["parameters"]
    assert parameters == result["parameters"]
    assert parameters["duration"].startswith("lognormal:")
    assert parameters["weather"] == ROSE
    assert (result["n_fires"], result["n_parameters"]) == (7, 3)
    assert result["observed"]["median_ha"] == 4.5
    assert "an assumption" in config.read_text()
    burnt = run("burn", place / "land", "--config", config, "-o", tmp_path / "f.tif", "--runs", 20, "--json")
    assert burnt.exit_code == 0, burnt.output
    told = " ".join(json.loads(burnt.stdout)["result"]["assumptions"])
    assert "lognormal" in told
    assert "at most 20 h" in told
    assert ROSE in told


def test_bad_calibrations_are_refused(place, tmp_path):
    out = ["-o", tmp_path / "a.toml"]
    for words, code, message in (
        ([place / "land", place / "fires.csv", *out], 2, "--weather is missing"),
        ([place / "land", *out], 2, "FIRES is missing"),
        ([place / "fires.csv", *out], 3, "lacks landscape, scar, start, duration"),
        ([place / "cases.csv", "--fit", "rate,p0", *out, "--runs", 5, "--config", tmp_path / "no"], 2, "no"),
        ([place / "land", place / "fires.csv", "--weather", ROSE, "--least", 10, *out], 2, "1 fires cannot tell"),
        ([place / "cases.csv", "--fit", "colour", *out], 2, "expected some of rate, duration, p0"),
    ):
        told = run("calibrate", *words)
        assert told.exit_code == code, told.output
        assert message in told.output
    assert not (tmp_path / "a.toml").exists()
