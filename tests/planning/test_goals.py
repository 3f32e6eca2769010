"""Goals: the mean fire or the worst tenth, hectares or several values; a plan for one tells what it does for all."""

from __future__ import annotations

import csv
import json
from types import SimpleNamespace

import numpy as np
import pytest
from click.testing import CliRunner

from firebreak_gis.breaks import select_breaks
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import ParameterError
from firebreak_gis.evaluation.measures import BOUNDS, resamples, worst_mean
from firebreak_gis.landscape.stake_layers import value_layer
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.planning.goals import for_worst_tenth, goals_table, goals_told, tail_ignition
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.fires import burn, resolved
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes
from tests.places import three, write

pytestmark = pytest.mark.usefixtures("no_pictures")


def two_islands():
    """A small island on which most fires start, and a large one on which a sixth do; fire takes all of its island."""
    fuel = np.zeros((24, 40), bool)
    fuel[1:23, 1:8] = True
    fuel[1:23, 10:39] = True
    ignition = np.zeros(fuel.shape)
    ignition[1:23, 1:8] = 0.85 / (22 * 7)
    ignition[1:23, 10:39] = 0.15 / (22 * 29)
    network = SpreadNetwork(np.ones((8, *fuel.shape), np.float32), burnable=fuel)
    return network, Stakes(network, ignition=ignition)


def designer(network, n_cells):
    def design(stakes, progress):
        priority = rank(network, "dissection", stakes=stakes)
        breaks = select_breaks(priority, budget=n_cells / network.n_burnable, burnable=network.burnable)
        return SimpleNamespace(laid=breaks)

    return design


def test_a_plan_for_the_worst_tenth_cuts_where_large_fires_start():
    network, stakes = two_islands()
    fires = FireRequest(ignitions=stakes.ignition, n_runs=200, seed=4)
    design = designer(network, 22)
    mean = design(stakes, silent).laid
    worst = for_worst_tenth(network, stakes, design, fires, Ground(network), progress=silent).laid
    fresh = FireRequest(ignitions=stakes.ignition, n_runs=400, seed=9)
    lost = [burn(network, fresh, breaks=cut)["fire_size"].to_numpy() for cut in (mean, worst)]
    assert int(worst.sum()) == int(mean.sum()) == 22
    assert worst_mean(lost[1]) < 0.8 * worst_mean(lost[0])
    assert worst.to_numpy()[:, 10:].sum() > mean.to_numpy()[:, 10:].sum()


def test_the_tail_is_where_the_worst_fires_start():
    network, stakes = two_islands()
    fires = FireRequest(ignitions=stakes.ignition, n_runs=300, seed=1)
    start = resolved(network, fires)
    losses = burn(network, fires)["fire_size"].to_numpy().astype(float)
    tail = tail_ignition(stakes, start, losses, network)
    assert tail.sum() == pytest.approx(1.0)
    assert tail[:, 10:].sum() > 0.9 > 0.2 > stakes.ignition[:, 10:].sum()
    assert (tail[~network.burnable] == 0).all()


def test_the_table_is_a_plain_bootstrap_over_pairs():
    rng = np.random.default_rng(2)
    before = rng.gamma(1.0, 100.0, 50)
    after = before * rng.random(50)
    table = goals_table(
        {"hectares": (before, after), "people": (before * 0, before * 0)}, planned="hectares", goal="mean", seed=5
    )
    assert table["planned_for"].tolist() == [True, False, False, False]
    mean, worst = table.iloc[0], table.iloc[1]
    draws = [1 - after[pick].mean() / before[pick].mean() for pick in resamples(50, 5)]
    assert mean["saved_share"] == pytest.approx(1 - after.mean() / before.mean())
    assert [mean["saved_share_low"], mean["saved_share_high"]] == pytest.approx(np.percentile(draws, BOUNDS).tolist())
    assert worst["without_breaks"] == pytest.approx(np.sort(before)[-5:].mean())
    assert worst["with_breaks"] == pytest.approx(np.sort(after)[-5:].mean())
    assert table["saved_share"].isna().tolist() == [False, False, True, True]
    assert "people" not in goals_told(table)


def test_a_layer_of_value_is_read_from_its_words():
    layer = value_layer("houses", r"C:\data, old\houses.gpkg,field=price,as=density")
    assert (layer.source, layer.field, layer.taken_as, layer.weight) == (
        r"C:\data, old\houses.gpkg",
        "price",
        "density",
        1.0,
    )
    for wrong in ("a.tif,weight=-1", "a.tif,weight=x", "a.tif,as=money", ",field=x"):
        with pytest.raises(ParameterError, match="--value houses is"):
            value_layer("houses", wrong)


@pytest.fixture(scope="module")
def planned(tmp_path_factory):
    """A plan for twice the people and the houses, with both told apart."""
    folder = tmp_path_factory.mktemp("goals")
    three(folder, 20, 26)
    rng = np.random.default_rng(0)
    for name in ("people", "houses"):
        write(folder / f"{name}.tif", rng.integers(0, 5, (20, 26)).astype("float32"))
    words = ["plan", *(folder / f"{n}.tif" for n in ("dem", "vegetation", "density")), "--runs", "20"]
    words += ["--method", "degree", "--budget", "0.1", "--timeless", "--json"]
    values = ["--value", f"people={folder / 'people.tif'},weight=2", "--value", f"houses={folder / 'houses.tif'}"]
    runs = {}
    for name, more in (("both", values), ("none", []), ("worst", [*values, "--goal", "worst-tenth"])):
        done = CliRunner().invoke(firebreak, [str(w) for w in [*words, *more, "-o", folder / name]])
        assert done.exit_code == 0, done.output
        runs[name] = json.loads(done.stdout.splitlines()[-1])["result"]
    return folder, runs


def test_a_plan_for_several_values_tells_each(planned):
    folder, runs = planned
    rows = {(r["loss"], r["of"]): r for r in runs["both"]["goals"]}
    assert {loss for loss, _ in rows} == {"hectares", "value", "people", "houses"}
    for side in ("without_breaks", "with_breaks"):
        total = 2 * rows["people", "mean"][side] + rows["houses", "mean"][side]
        assert rows["value", "mean"][side] == pytest.approx(total)
    assert rows["value", "mean"][side] == pytest.approx(runs["both"][f"value_lost_{side}"])
    assert [key for key, row in rows.items() if row["planned_for"]] == [("value", "mean")]
    written = list(csv.DictReader((folder / "both" / "goals.csv").read_text().splitlines()))
    assert [(r["loss"], r["of"]) for r in written] == list(rows)
    assert "What it does for every goal" in (folder / "both" / "report.html").read_text()
    assert {r["loss"] for r in runs["none"]["goals"]} == {"hectares"}


def test_the_goal_is_kept_and_marked(planned):
    folder, runs = planned
    marked = [(r["loss"], r["of"]) for r in runs["worst"]["goals"] if r["planned_for"]]
    assert marked == [("value", "worst-tenth")]
    account = json.loads((folder / "worst" / "run.json").read_text())
    assert account["parameters"]["goal"] == "worst-tenth"
    again = ["plan", "--config", folder / "worst" / "run.json", "-o", folder / "again"]
    layers = [folder / f"{n}.tif" for n in ("dem", "vegetation", "density")]
    done = CliRunner().invoke(firebreak, [str(w) for w in [*again[:1], *layers, *again[1:]]])
    assert done.exit_code == 0, done.output
    assert (folder / "again" / "breaks.tif").read_bytes() == (folder / "worst" / "breaks.tif").read_bytes()


def test_a_name_stands_for_one_value():
    words = ["plan", "a.tif", "b.tif", "normal", "-o", "x", "--value", "people=a.tif", "--value", "people=b.tif"]
    done = CliRunner().invoke(firebreak, words)
    assert done.exit_code == 2
    assert "name of its own" in done.output
