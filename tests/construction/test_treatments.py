"""Treatments of segments: the choice against all choices, and the columns against counts by hand."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from firebreak_gis import rank, select_breaks, spread_network
from firebreak_gis.construction.segments import segments_of
from firebreak_gis.construction.treatments import choose, read_treatments, totals, with_treatments
from firebreak_gis.errors import InputError

HEAD = "name,vegetation,residual,cost_ha,cost_per_degree,years,max_slope_deg\n"


def written(tmp_path, text, head=HEAD):
    path = tmp_path / "treatments.csv"
    path.write_text(head + text)
    return path


@pytest.mark.parametrize("seed", range(40))
def test_never_dearer_than_the_best_single_treatment(seed):
    """For the saving of any single treatment; and near the cheapest of all choices."""
    random = np.random.default_rng(seed)
    n, k = 6, 3
    cost = random.uniform(0.1, 10, (n, k))
    saving = random.uniform(0, 5, (n, k))
    cost[random.random((n, k)) < 0.2] = np.inf
    cost[:, 0] = np.where(np.isfinite(cost).any(axis=1), cost[:, 0], 4.0)
    every = np.arange(n)
    for single in range(k):
        if not np.isfinite(cost[:, single]).all():
            continue
        pick = choose(cost, saving, saving[:, single].sum())
        assert saving[every, pick].sum() >= saving[:, single].sum() * (1 - 1e-9)
        assert cost[every, pick].sum() <= cost[:, single].sum()
        all_choices = np.array(list(itertools.product(range(k), repeat=n)))
        costs = cost[every, all_choices].sum(axis=1)
        enough = saving[every, all_choices].sum(axis=1) >= saving[:, single].sum() * (1 - 1e-9)
        assert costs[enough].min() - 1e-9 <= cost[every, pick].sum() <= 1.6 * costs[enough].min()


@pytest.fixture
def plan(sample):
    network = spread_network(sample)
    breaks = select_breaks(rank(network, "dissection", budget=0.08), budget=0.08, burnable=network.burnable)
    return network, breaks, segments_of(network, breaks, elevation=sample["elevation"])


def test_columns_of_the_sample(sample, plan):
    network, breaks, frames = plan
    table = read_treatments()
    _, polygons = with_treatments(frames, sample, table)
    assert set(polygons["treatment"]) <= {*table.names, "none"}
    assert polygons["treatment"].nunique() > 1
    np.testing.assert_allclose(
        polygons["treatment_saving"], polygons["gain"] * (1 - polygons["treatment_residual"]), atol=1e-9
    )
    told = totals(polygons)
    assert sum(row["segments"] for row in told.values()) == len(polygons)
    assert abs(sum(row["area_ha"] for row in told.values()) - int((breaks > 0).sum()) * network.grid.cell_area_ha) < 1


def test_one_treatment_is_one_residual(sample, plan, tmp_path):
    """Everywhere the same: its residual, its cost a hectare and year."""
    _, _, frames = plan
    one = "".join(f"cut,{word},0.1,500,0,5,90\n" for word in ("agricultural", "shrubs", "pines"))
    _, polygons = with_treatments(frames, sample, read_treatments(written(tmp_path, one)))
    assert set(polygons["treatment"]) == {"cut"}
    np.testing.assert_allclose(polygons["treatment_residual"], 0.1)
    np.testing.assert_allclose(polygons["treatment_cost"], 500 * polygons["area_ha"])
    np.testing.assert_allclose(polygons["treatment_yearly"], 100 * polygons["area_ha"])


def test_where_nothing_is_allowed(sample, plan, tmp_path):
    _, _, frames = plan
    flat = "cut,pines,0.1,500,10,5,0.000001\n"
    _, polygons = with_treatments(frames, sample, read_treatments(written(tmp_path, flat)))
    barred = polygons[polygons["treatment"] == "none"]
    assert len(barred) > 0.9 * len(polygons)
    assert (barred["treatment_saving"] == 0).all()
    assert (barred["treatment_residual"] == 1).all()


def test_slope_has_its_price(sample, plan, tmp_path):
    _, _, frames = plan
    steep = "".join(f"cut,{word},0,0,10,1,90\n" for word in ("agricultural", "shrubs", "pines"))
    _, polygons = with_treatments(frames, sample, read_treatments(written(tmp_path, steep)))
    np.testing.assert_allclose(
        polygons["treatment_cost"], 10 * polygons["mean_slope_deg"] * polygons["area_ha"], rtol=1e-6
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "no treatment"),
        ("cut,trees,0,1,0,1,1\n", "trees"),
        ("cut,pines,2,1,0,1,1\n", "residual from 0 to 1"),
        ("cut,pines,0,1,0,0,1\n", "years above 0"),
        ("cut,pines,0,much,0,1,1\n", "no number"),
        ("cut,pines,0,1,0,1,1\ncut,pines,0,1,0,1,1\n", "once"),
    ],
)
def test_tables_that_make_no_sense(tmp_path, text, told):
    with pytest.raises(InputError, match=told):
        read_treatments(written(tmp_path, text))
    with pytest.raises(InputError, match="lacks the columns"):
        read_treatments(written(tmp_path, text, head="name,cost\n"))


def test_plan_shows_them(tmp_path):
    """Columns, account and page; the plan itself stays as it is."""
    import json

    import geopandas as gpd
    from click.testing import CliRunner

    from firebreak_gis.cli import firebreak

    layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    told = {}
    for name, more in (("plain", []), ("treated", ["--treatments", "default"])):
        words = ["plan", *layers, "--res", "100", "--budget", "0.08", "--runs", "10", *more, "-o", str(tmp_path / name)]
        outcome = CliRunner().invoke(firebreak, words)
        assert outcome.exit_code == 0, outcome.output
        told[name] = json.loads((tmp_path / name / "run.json").read_text())
    assert told["treated"]["summary"] == told["plain"]["summary"]
    assert "treatments" not in told["plain"]
    frame = gpd.read_file(tmp_path / "treated" / "segments.gpkg", layer="polygons")
    for name, row in told["treated"]["treatments"].items():
        if name != "assumed":
            assert row["segments"] == (frame["treatment"] == name).sum()
    assert "Treatment" in (tmp_path / "treated" / "report.html").read_text()
    assert "treatment" not in gpd.read_file(tmp_path / "plain" / "segments.gpkg", layer="polygons")
