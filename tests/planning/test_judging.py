"""`plan`, `evaluate` and `compare` on the command line are judged by the clock, say so, and can be repeated."""

from __future__ import annotations

import json

import numpy as np
import pandas as pd
import pytest
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis.cli import firebreak
from firebreak_gis.landscape import read_landscape_folder, write_landscape
from firebreak_gis.planning.comparison import compare_plans, comparison_table
from firebreak_gis.planning.judging import ASSUMED_DURATION, ASSUMED_HOLD, Judging, judging
from firebreak_gis.simulation.containment import as_containment
from firebreak_gis.simulation.durations import Duration
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.holding import Hold
from firebreak_gis.simulation.request import FireRequest

pytestmark = pytest.mark.usefixtures("no_pictures")

ROSE = "rose:NW=5x0.4,N=8x0.2"


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome


@pytest.fixture(scope="module")
def folder(make_landscape, tmp_path_factory):
    place = tmp_path_factory.mktemp("judged")
    write_landscape(make_landscape((26, 37), seed=3, relief=4.0, holes=0.05), place / "land")
    run("network", place / "land", "-o", place / "still.tif")
    run("network", place / "land", "-o", place / "timed.tif", "--clock", "--wind-speed", 4, "--wind-from", 90)
    return place


def layers(folder):
    return [folder / "land" / f"{name}.tif" for name in ("elevation", "vegetation", "density")]


def told(outcome):
    return json.loads(outcome.stdout)["result"]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, ["each 400 m of break holds in 0.47 of fires"]),
        ({"hold": Hold(1.0)}, ["breaks hold"]),
        ({"hold": Hold(1.0), "residual": 0.1}, ["breaks keep 0.1 of the spread probability"]),
        ({"residual": 0.1}, ["holds in 0.47 of fires", "breaks that hold keep 0.1 of the spread probability"]),
        ({"barriers_hold": 0.6}, ["holds in 0.47 of fires", "barriers hold in 0.6 of fires"]),
        ({"embers": fb.Embers()}, ["embers", "holds in 0.47 of fires"]),
    ],
)
def test_the_headline_and_the_assumptions_tell_every_way_in_which_breaks_fail(given, said):
    judged = judging(FireRequest(**given), timed=True)
    assumptions = " ".join(judged.assumptions).lower()
    for words in said:
        assert words in judged.short
        assert words in assumptions
    assert ("breaks hold" in judged.short) == ("breaks hold in every fire" in assumptions) == (said == ["breaks hold"])


def test_a_plan_of_the_command_line_is_that_of_python(folder, tmp_path):
    words = ["--budget", 0.1, "--runs", 30, "--seed", 3, "--json"]
    asked = {
        "nothing": ([], {}),
        "all": (
            ["--duration", "2h", "--hold", "0.7:100", "--embers", "rate=300", "--weather", ROSE, "--residual", 0.1],
            {
                "duration": "2h",
                "hold": "0.7:100",
                "embers": fb.Embers(rate=300.0),
                "weather": ROSE,
                "residual": 0.1,
            },
        ),
        "timeless": (["--timeless"], {"timeless": True}),
    }
    landscape = read_landscape_folder(folder / "land")
    for name, (options, given) in asked.items():
        said = told(run("plan", *layers(folder), "-o", tmp_path / name, *words, *options))
        made = fb.plan(landscape, budget=0.1, n_runs=30, seed=3, **given)
        table = pd.read_csv(tmp_path / name / "fire_sizes.csv")
        np.testing.assert_array_equal(table["cells_with_breaks"], made.after["fire_size"])
        np.testing.assert_array_equal(table["cells_without_breaks"], made.before["fire_size"])
        assert said["headline"] == made.headline
        assert said["assumptions"] == list(made.judged.assumptions)
        account = json.loads((tmp_path / name / "run.json").read_text())
        assert account["headline"] == made.headline
        assert account["assumptions"] == said["assumptions"]
        page = (tmp_path / name / "report.html").read_text()
        assert made.judged.assumptions[0] in page
        paper = pd.read_csv(tmp_path / name / "evaluation_timeless.csv")
        assert len(paper) == 3 * made.paper.sizes["budget"]
    outcome = run("plan", *layers(folder), "-o", tmp_path / "said", "--runs", 5)
    for word in ("8 h in the median", "holds in 0.47", "assumed, not known", "Without a clock and with perfect breaks"):
        assert word in outcome.stdout
    mean, paper = outcome.stdout.index("the mean fire burns"), outcome.stdout.index("Without a clock")
    assert mean < paper


def test_the_account_of_a_plan_repeats_it(folder, tmp_path):
    options = ["--duration", "uniform:1h,3h", "--hold", "flame", "--embers", "on", "--weather", ROSE, "--runs", 20]
    run("plan", *layers(folder), "-o", tmp_path / "one", *options)
    run("plan", "--config", tmp_path / "one" / "run.json", "-o", tmp_path / "two")
    for file in ("fire_sizes.csv", "evaluation.csv", "evaluation_timeless.csv", "burn_frequency_with_breaks.tif"):
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes(), file
    run("plan", *layers(folder), "-o", tmp_path / "paper", "--timeless", "--runs", 20)
    run("plan", "--config", tmp_path / "paper" / "run.json", "-o", tmp_path / "again")
    assert (tmp_path / "paper/fire_sizes.csv").read_bytes() == (tmp_path / "again/fire_sizes.csv").read_bytes()
    assert (tmp_path / "paper/fire_sizes.csv").read_bytes() != (tmp_path / "one/fire_sizes.csv").read_bytes()
    assert (tmp_path / "paper/breaks.tif").stat().st_size == (tmp_path / "again/breaks.tif").stat().st_size


@pytest.mark.parametrize("command", ["evaluate", "compare"])
def test_a_network_without_times_is_judged_as_ever(folder, tmp_path, command):
    words = ["--methods", "flammability,random", "--budgets", "0,0.1", "--runs", 20, "--json"]
    outcome = run(command, folder / "still.tif", "-o", tmp_path / "a", *words)
    assert "tells no times" in outcome.stderr
    paper = run(command, folder / "still.tif", "-o", tmp_path / "b", "--timeless", *words)
    assert "tells no times" not in paper.stderr
    folded = run(command, folder / "land", "-o", tmp_path / "c", "--timeless", *words)
    table = {"evaluate": "evaluation.csv", "compare": "comparison.csv"}[command]
    one, two, three = ((tmp_path / name / table).read_bytes() for name in "abc")
    assert one == two == three
    assert told(paper)["assumptions"][:2] == told(folded)["assumptions"][:2]
    refused = run(command, folder / "still.tif", "-o", tmp_path / "d", "--duration", "8h", *words, code=3)
    assert "travel times" in refused.output
    refused = run(command, folder / "land", "-o", tmp_path / "d", "--duration", "8h", "--timeless", *words, code=2)
    assert "--timeless" in refused.output
    refused = run(command, folder / "timed.tif", "-o", tmp_path / "d", "--weather", ROSE, *words, code=2)
    assert "firebreak align" in refused.output
    assert not (tmp_path / "d").exists()


def test_evaluate_takes_the_clock(folder, tmp_path):
    words = ["--methods", "flammability,random", "--budgets", "0,0.1,0.2", "--runs", 25, "--seed", 2, "--json"]
    landscape = read_landscape_folder(folder / "land")
    still = fb.spread_network(landscape)
    rankings = {name: fb.rank(still, name, seed=2) for name in ("flammability", "random")}
    fires = {"budgets": [0.0, 0.1, 0.2], "n_runs": 25, "seed": 2}
    timed = fb.spread_network(landscape, clock=True)
    expected = fb.evaluate(timed, rankings, **fires, duration=ASSUMED_DURATION, hold=ASSUMED_HOLD)
    said = told(run("evaluate", folder / "land", "-o", tmp_path / "clock", *words))
    assert "assumed, not known" in " ".join(said["assumptions"])
    assert json.loads((tmp_path / "clock/run.json").read_text())["assumptions"] == said["assumptions"]
    table = pd.read_csv(tmp_path / "clock/evaluation.csv")
    np.testing.assert_allclose(table["mean"], expected["mean"].to_numpy().ravel())
    np.testing.assert_allclose(table["p_value"], expected["p_value"].to_numpy().ravel())
    networks = fb.weather_networks(landscape, ROSE)
    expected = fb.evaluate(networks[0].network, rankings, **fires, weather=networks, duration="1h", hold=1)
    words += ["--weather", ROSE, "--duration", "1h", "--hold", 1]
    run("evaluate", folder / "land", "-o", tmp_path / "weather", *words)
    table = pd.read_csv(tmp_path / "weather/evaluation.csv")
    ranked = table[table["method"] == "random"]["mean"]
    np.testing.assert_allclose(ranked, expected["mean"].sel(ranking="random"))


def test_compare_takes_the_clock(folder, tmp_path):
    words = ["--methods", "flammability,random", "--budgets", "0.1,0.2", "--residuals", "0,0.2", "--runs", 25]
    run("compare", folder / "timed.tif", "-o", tmp_path / "one", *words, "--duration", "3h", "--hold", 0.6)
    network = fb.read_network(folder / "timed.tif")
    rankings = {name: fb.rank(network, name) for name in ("flammability", "random")}
    fires = FireRequest(n_runs=25, duration=Duration("fixed", (10800.0,)), hold=Hold(0.6))
    expected = comparison_table(compare_plans(network, rankings, fires, budgets=[0.1, 0.2], residuals=[0.0, 0.2]))
    table = pd.read_csv(tmp_path / "one/comparison.csv")
    np.testing.assert_allclose(table["burnt_ha"], expected["burnt_ha"], rtol=1e-6)
    assumptions = json.loads((tmp_path / "one/run.json").read_text())["assumptions"]
    assert "Wind 4 m/s from 90 degrees." in assumptions
    other = compare_plans(
        fb.spread_network(read_landscape_folder(folder / "land")),
        rankings,
        fires,
        budgets=[0.1, 0.2],
        residuals=[0.0, 0.2],
        ground=Ground(network),
    )
    np.testing.assert_allclose(comparison_table(other)["burnt_ha"], expected["burnt_ha"])


def test_what_is_assumed_where_nothing_is_said():
    nothing = judging(FireRequest(), timed=True, wind="no wind")
    assert isinstance(nothing, Judging)
    assert (nothing.fires.duration, nothing.fires.hold) == (ASSUMED_DURATION, ASSUMED_HOLD)
    assert nothing.assumptions[-1] == "How long fires burn and how often breaks hold are assumed, not known."
    known = judging(FireRequest(duration=Duration("fixed", (60.0,))), timed=True)
    assert known.assumptions[-1] == "How often breaks hold is assumed, not known."
    assert known.fires.hold == ASSUMED_HOLD
    paper = judging(FireRequest(), timed=True, timeless=True)
    assert paper.fires == FireRequest()
    assert not paper.reburnt
    assert "Breaks hold in every fire." in paper.assumptions
    assert judging(FireRequest(), timed=False).fires == FireRequest()
    told_hours = fb.read_weather("rose:N=4x1;duration=3h")
    assert judging(FireRequest(), timed=True, weather=told_hours).fires.duration == Duration("weather")
    untold = fb.read_weather("rose:N=4x1")
    assert judging(FireRequest(), timed=True, weather=untold).fires.duration == ASSUMED_DURATION
    crews = FireRequest(containment=as_containment("2h"))
    assert judging(crews, timed=True).fires.duration is None
