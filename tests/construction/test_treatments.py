"""Treatments of segments: the choice against all choices, and the columns against counts by hand."""

from __future__ import annotations

import itertools
from importlib import resources

import numpy as np
import pytest
import xarray as xr
from rasterio.features import geometry_mask

import firebreak_gis as fb
from firebreak_gis import rank, select_breaks, spread_network
from firebreak_gis.breaks import Budget
from firebreak_gis.construction.segments import segments_of
from firebreak_gis.construction.treating import with_treatments
from firebreak_gis.construction.treatments import Treatments, choose, read_treatments, spend, stops, totals
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.kernels.terrain import horn_slope
from firebreak_gis.planning.designs.treated import TreatedCells, trial_loss
from firebreak_gis.planning.treating import offers_of, treat
from firebreak_gis.schema import VEGETATION

pytestmark = pytest.mark.usefixtures("no_pictures")

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


@pytest.mark.parametrize("seed", range(40))
def test_money_buys_what_no_single_treatment_does(seed):
    random = np.random.default_rng(seed)
    n, k = 6, 3
    cost = random.uniform(0.1, 10, (n, k))
    saving = random.uniform(0, 5, (n, k))
    cost[random.random((n, k)) < 0.2] = np.inf
    cost[:, 0] = np.where(np.isfinite(cost).any(axis=1), cost[:, 0], 4.0)
    every = np.arange(n)
    floor = cost.min(axis=1).sum()
    for money in floor + random.uniform(0, 30, 4):
        pick = spend(cost, saving, money)
        assert cost[every, pick].sum() <= money * (1 + 1e-9)
        saved = saving[every, pick].sum()
        for single in range(k):
            if cost[:, single].sum() <= money:
                assert saved >= saving[:, single].sum() - 1e-9
        all_choices = np.array(list(itertools.product(range(k), repeat=n)))
        affordable = cost[every, all_choices].sum(axis=1) <= money
        best = saving[every, all_choices].sum(axis=1)[affordable].max()
        assert 0.7 * best <= saved <= best + 1e-9
    assert cost[every, spend(cost, saving, floor)].sum() == pytest.approx(floor)


@pytest.mark.parametrize("width", [1, 2, 3])
def test_what_a_wall_stops_lies_near_simulated_fires(width):
    """A front of 14 cells before a wall, one step of fire a row: the model leaves out what runs along the wall."""
    random = np.random.default_rng(width)
    front, p, residual, runs = 14, 0.5, 0.12, 4000
    stopped = 0
    for _ in range(runs):
        lit = np.ones(front, bool)
        for _ in range(width):
            into = np.zeros(lit.size + 2, bool)
            for shift in range(3):
                into[shift : shift + lit.size] |= lit & (random.random(lit.size) < p * residual)
            lit = into
        stopped += not lit.any()
    assert stopped / runs == pytest.approx(float(stops(residual, width, front, p)), abs=0.06)


@pytest.fixture(scope="module")
def plan(sample):
    network = spread_network(sample)
    breaks = select_breaks(rank(network, "dissection", budget=0.08), budget=0.08, burnable=network.burnable)
    return network, breaks, segments_of(network, breaks, elevation=sample["elevation"])


def treated(sample, plan, table, **more):
    return with_treatments(plan[2], offers_of(sample, table, plan[0]), **more)


def expected_saving(network, polygons):
    size = network.grid.cell_size
    p = network.probability[network.probability > 0].mean()
    expected = []
    for row in polygons.itertuples():
        behind = max(min(row.length_m, max(400.0, size)), size) / size
        behind *= (3 * p * row.treatment_residual) ** max(row.width_m / size, 1.0)
        expected.append(0.0 if row.treatment == "none" else row.gain * np.exp(-behind))
    return expected


def test_columns_of_the_sample(sample, plan):
    network, breaks, _ = plan
    table = read_treatments()
    (_, polygons), residual = treated(sample, plan, table)
    assert {name for each in polygons["treatment"] for name in each.split(" + ")} <= {*table.names, "none"}
    assert polygons["treatment"].nunique() > 1
    np.testing.assert_allclose(polygons["treatment_saving"], expected_saving(network, polygons), rtol=1e-5, atol=1e-9)
    told = totals(polygons)
    assert sum(row["segments"] for row in told.values()) == len(polygons)
    assert abs(sum(row["area_ha"] for row in told.values()) - int((breaks > 0).sum()) * network.grid.cell_area_ha) < 1
    # The plane holds in each segment what its columns say.
    for row in polygons.itertuples():
        inside = geometry_mask([row.geometry], network.shape, network.grid.transform, invert=True)
        assert residual[inside].mean() == pytest.approx(row.treatment_residual)
        if row.treatment in table.names:
            words = sample["vegetation"].to_numpy()[inside]
            left = [table.rows[row.treatment, VEGETATION[int(code)]].residual for code in words]
            np.testing.assert_array_equal(residual[inside], left)


def test_no_dearer_than_each_treatment_of_the_table_alone(sample, plan):
    """For the saving of the usual treatment everywhere, the choice costs no more a year."""
    network, _, frames = plan
    table = read_treatments()
    offers = offers_of(sample, table, network)
    (_, polygons), _ = with_treatments(frames, offers)
    alone = {}
    for name in table.names:
        rows = {key: row for key, row in table.rows.items() if key[0] == name}
        (_, one), _ = treated(sample, plan, Treatments("", rows))
        if (one["treatment"] == name).all():
            alone[name] = one
    for one in alone.values():
        if one["treatment_saving"].sum() >= polygons["treatment_saving"].sum():
            assert polygons["treatment_yearly"].sum() <= one["treatment_yearly"].sum()


@pytest.mark.parametrize("share", [1.0, 1.3, 3.0])
def test_money_is_kept_to(sample, plan, share):
    network, breaks, frames = plan
    offers = offers_of(sample, read_treatments(), network)
    floor = offers.usual[1][breaks.to_numpy() > 0]
    money = share * float(floor[np.isfinite(floor)].sum())
    (_, polygons), _ = with_treatments(frames, offers, money=money)
    assert polygons["treatment_cost"].sum() <= money * (1 + 1e-9)
    (_, richer), _ = with_treatments(frames, offers, money=2 * money)
    assert richer["treatment_saving"].sum() >= polygons["treatment_saving"].sum()


ONE = "".join(f"cut,{word},0.1,500,0,5,90\n" for word in ("agricultural", "shrubs", "pines"))


def test_one_treatment_is_one_residual(sample, plan, tmp_path):
    """Everywhere the same: its residual, its cost a hectare and year."""
    (_, polygons), residual = treated(sample, plan, read_treatments(written(tmp_path, ONE)))
    assert set(polygons["treatment"]) == {"cut"}
    assert (residual == 0.1).all()
    np.testing.assert_allclose(polygons["treatment_residual"], 0.1)
    np.testing.assert_allclose(polygons["treatment_cost"], 500 * polygons["area_ha"])
    np.testing.assert_allclose(polygons["treatment_yearly"], 100 * polygons["area_ha"])


def test_where_nothing_is_allowed(sample, plan, tmp_path):
    flat = "cut,pines,0.1,500,10,5,0.000001\n"
    (_, polygons), residual = treated(sample, plan, read_treatments(written(tmp_path, flat)))
    barred = polygons[polygons["treatment"] == "none"]
    assert len(barred) > 0.9 * len(polygons)
    assert (barred["treatment_saving"] == 0).all()
    assert (barred["treatment_residual"] == 1).all()
    inside = geometry_mask(barred.geometry, plan[0].shape, plan[0].grid.transform, invert=True)
    assert (residual[inside] == 1).all()


def test_slope_has_its_price(sample, plan, tmp_path):
    steep = "".join(f"cut,{word},0,0,10,1,90\n" for word in ("agricultural", "shrubs", "pines"))
    (_, polygons), _ = treated(sample, plan, read_treatments(written(tmp_path, steep)))
    np.testing.assert_allclose(
        polygons["treatment_cost"], 10 * polygons["mean_slope_deg"] * polygons["area_ha"], rtol=1e-6
    )


@pytest.mark.parametrize("timeless", [False, True])
def test_a_plan_with_one_treatment_is_that_with_its_residual(sample, tmp_path, timeless):
    given = {"budget": 0.08, "method": "compartments", "n_runs": 30, "seed": 3, "timeless": timeless}
    one = fb.plan(sample, treatments=written(tmp_path, ONE), **given)
    plain = fb.plan(sample, residual=0.1, **given)
    for name in ("breaks", "before", "after", "priority", "evaluation", "paper"):
        xr.testing.assert_identical(getattr(one, name), getattr(plain, name))
    assert one.summary["burnt_share_with_breaks"] == plain.summary["burnt_share_with_breaks"]
    assert one.summary["cost"] == pytest.approx(500 * one.summary["ha_cut"])


def test_a_plan_burns_with_the_treatments_that_it_chose(sample):
    given = {"budget": 0.08, "method": "compartments", "n_runs": 30, "seed": 3}
    made = fb.plan(sample, treatments="default", **given)
    again = fb.simulate(
        fb.spread_network(sample, clock=True),
        breaks=made.breaks,
        residual=made.design.treated.residual,
        hold=made.judged.fires.hold,
        duration=made.judged.fires.duration,
        n_runs=30,
        seed=3,
    )
    np.testing.assert_array_equal(again["burn_count"], made.after["burn_count"])
    assert any("Segments are treated by" in each for each in made.judged.assumptions)
    # The same breaks leak more, or less, with another plane.
    perfect = fb.plan(sample, **given)
    assert perfect.after["fire_size"].sum() != made.after["fire_size"].sum()


@pytest.mark.parametrize("money", [20_000.0, 150_000.0])
def test_a_plan_within_a_budget_in_money_stays_within_it(sample, money):
    given = {"budget_unit": "cost", "method": "compartments", "n_runs": 10}
    made = fb.plan(sample, budget=money, treatments="default", **given)
    cost = made.segments.polygons["treatment_cost"].sum()
    assert 0.8 * money < cost <= money
    assert made.summary["cost"] == cost
    assert (made.segments.polygons["treatment"] != "none").all()


def test_nothing_is_cut_where_no_treatment_is_allowed(sample, tmp_path):
    table = written(tmp_path, "cut,shrubs,0.1,500,10,5,12\ncut,pines,0.1,500,10,5,12\n")
    made = fb.plan(sample, budget=0.03, method="flammability", n_runs=10, treatments=table)
    cut = made.breaks.to_numpy() > 0
    assert cut.any()
    assert np.isin(sample["vegetation"].to_numpy()[cut], [2, 3]).all()
    slope = horn_slope(sample["elevation"].to_numpy().astype(float), made.network.grid.cell_size)
    assert (np.nan_to_num(slope)[cut] <= 12).all()
    assert set(made.segments.polygons["treatment"]) == {"cut"}


def test_two_prices_or_residuals_are_refused(sample):
    with pytest.raises(ParameterError, match="leave --residual out"):
        fb.plan(sample, treatments="default", residual=0.1)
    with pytest.raises(ParameterError, match="leave --cost out"):
        fb.plan(sample, treatments="default", cost=np.ones(sample["burnable"].shape), budget=9.0, budget_unit="cost")


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
    """Columns, account and page."""
    import json

    import geopandas as gpd
    from click.testing import CliRunner

    from firebreak_gis.cli import firebreak

    layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    told = {}
    for name, more in (("plain", []), ("treated", ["--treatments", "default"])):
        words = [
            "plan",
            *layers,
            "--res",
            "100",
            "--budget",
            "0.08",
            "--method",
            "compartments",
            "--runs",
            "10",
            *more,
            "-o",
            str(tmp_path / name),
        ]
        outcome = CliRunner().invoke(firebreak, words)
        assert outcome.exit_code == 0, outcome.output
        told[name] = json.loads((tmp_path / name / "run.json").read_text())
    assert told["treated"]["summary"]["cost"] == pytest.approx(
        sum(row["cost"] for name, row in told["treated"]["treatments"].items() if name != "assumed"), abs=0.01
    )
    assert told["treated"]["summary"]["fire_ha_with_breaks"] != told["plain"]["summary"]["fire_ha_with_breaks"]
    assert any("Segments are treated by" in sentence for sentence in told["treated"]["assumptions"])
    assert "treatments" not in told["plain"]
    frame = gpd.read_file(tmp_path / "treated" / "segments.gpkg", layer="polygons")
    for name, row in told["treated"]["treatments"].items():
        if name != "assumed":
            assert row["segments"] == (frame["treatment"] == name).sum()
    assert "Treatment" in (tmp_path / "treated" / "report.html").read_text()
    assert "treatment" not in gpd.read_file(tmp_path / "plain" / "segments.gpkg", layer="polygons")


@pytest.mark.parametrize(("money", "timeless"), [(150_000.0, False), (60_000.0, True)])
def test_the_table_never_loses_more_than_a_single_treatment_for_the_same_money(sample, tmp_path, money, timeless):
    """On the fires of the design; and the plan of a single treatment is the one that a table of it alone gives."""
    given = {"budget": money, "budget_unit": "cost", "method": "compartments", "n_runs": 30, "timeless": timeless}
    text = (resources.files("firebreak_gis.construction") / "treatments.csv").read_text("utf-8").splitlines()
    made = fb.plan(sample, treatments="default", **given)
    setting = made.design.setting
    loss = trial_loss(setting, made.design)
    assert made.summary["cost"] <= money
    lost = {}
    for name in setting.offers.treatments.names:
        rows = "\n".join(line for line in text[1:] if line.startswith(f"{name},"))
        alone = fb.plan(sample, treatments=written(tmp_path, rows, head=text[0] + "\n"), **given)
        lost[name] = trial_loss(setting, alone.design)
    assert loss <= min(lost.values()) * (1 + 1e-12)
    assert loss < max(lost.values())


def test_with_a_budget_in_cells_no_single_treatment_that_costs_less_saves_more(sample):
    made = fb.plan(sample, treatments="default", budget=0.08, method="compartments", n_runs=30)
    setting, cost, seen = made.design.setting, made.summary["cost"], 0
    for name in setting.offers.treatments.names:
        alone = setting.offering(setting.offers.alone(name))
        treated = treat(alone.offers, made.network, alone.stakes, made.breaks, made.priority, Budget(0.08))
        if float(treated.segments.polygons["treatment_cost"].sum()) <= cost:
            other = TreatedCells(alone, made.priority, made.breaks, treated)
            assert trial_loss(setting, other) >= trial_loss(setting, made.design)
            seen += 1
    assert seen


def test_burn_repeats_a_plan_with_treatments(tmp_path):
    """What the cells keep goes from the plan to burn as a raster, and nothing is lost on the way."""
    import rasterio
    from click.testing import CliRunner

    from firebreak_gis.cli import firebreak

    def run(*words, code=0):
        outcome = CliRunner().invoke(firebreak, [str(word) for word in words])
        assert outcome.exit_code == code, outcome.output
        return outcome.output

    layers = [f"sample_data/{name}.tif" for name in ("dem", "vegetation", "density")]
    plan, net, again = tmp_path / "plan", tmp_path / "net.tif", tmp_path / "again.tif"
    fires = ("--runs", 12, "--seed", 4, "--duration", "5h", "--hold", 0.5)
    quick = ("--res", 100, "--budget", 0.08, "--method", "compartments", *fires)
    run("plan", *layers, *quick, "--treatments", "default", "-o", plan)
    run("network", plan, "--clock", "-o", net)
    burn = ("burn", net, "--breaks", plan / "breaks.tif", "--kept", plan / "kept.tif", *fires)
    run(*burn, "-o", again)
    with rasterio.open(again) as mine, rasterio.open(plan / "burn_frequency_with_breaks.tif") as theirs:
        np.testing.assert_array_equal(mine.read(), theirs.read())
    windows = tmp_path / "windows.tif"
    run(*burn, "--window", 32, "-o", windows)
    assert windows.read_bytes() == again.read_bytes()
    assert "power of two" in run(*burn, "--window", 40, "-o", windows, "--overwrite", code=2)
    told = run("burn", net, "--kept", plan / "kept.tif", "--residual", 0.1, "-o", tmp_path / "no.tif", code=2)
    assert "give one of them" in told
    told = run("burn", net, "--kept", plan / "breaks.tif", "-o", tmp_path / "no.tif", code=3)
    assert "is it the right file?" in told
    run("plan", *layers, *quick, "-o", plan, "--overwrite")
    assert not (plan / "kept.tif").exists()
