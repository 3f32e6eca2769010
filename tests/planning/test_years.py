"""A plan over years: money of a year, upkeep before building, and what burns with what stands."""

from __future__ import annotations

import csv
import itertools
import json
import re
from dataclasses import replace

import geopandas as gpd
import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

import firebreak_gis as fb
from firebreak_gis.breaks import Budget
from firebreak_gis.cli import firebreak
from firebreak_gis.construction.years import RETURN, mean_rates, return_intervals, schedule, upkeep_rates, visits
from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.existing import existing_breaks
from firebreak_gis.landscape.lines import LineBreaks
from firebreak_gis.planning.outputs import write_plan
from firebreak_gis.planning.pipeline import plan
from firebreak_gis.planning.years import YearsRequest, over_years
from firebreak_gis.report.page.folder import report_page
from firebreak_gis.schema import COLUMNS
from tests.places import three, write


@st.composite
def segments(draw):
    n = draw(st.integers(1, 12))
    cost = np.array(draw(st.lists(st.floats(0.0, 50.0), min_size=n, max_size=n)))
    rate = np.array(draw(st.lists(st.floats(0.0, 1.0), min_size=n, max_size=n)))
    return cost, cost * rate


@settings(max_examples=200, deadline=None)
@given(work=segments(), budget=st.floats(0.0, 80.0), years=st.integers(1, 15))
def test_no_year_spends_more_than_its_budget(work, budget, years):
    cost, yearly = work
    made = schedule(cost, yearly, budget=budget, years=years)
    assert (made.built + made.kept <= budget * (1 + 1e-9)).all()
    assert (made.built >= 0).all()
    assert made.built.sum() <= cost.sum() * (1 + 1e-9)
    # Upkeep is due on all that stood before the year, and is paid in full.
    for y in range(1, years + 1):
        due = yearly[(made.year > 0) & (made.year < y)].sum()
        assert made.kept[y - 1] >= due - 1e-6
    assert (made.begun[made.year > 0] <= made.year[made.year > 0]).all()
    stands = np.where(made.year > 0, made.year, years + 1)
    assert (np.diff(stands) >= 0).all()  # in the order of construction


@settings(max_examples=200, deadline=None)
@given(work=segments(), budget=st.floats(0.0, 80.0), more=st.floats(0.0, 40.0), years=st.integers(1, 15))
def test_more_money_never_leaves_less_standing(work, budget, more, years):
    cost, yearly = work
    poor = schedule(cost, yearly, budget=budget, years=years)
    rich = schedule(cost, yearly, budget=budget + more, years=years)
    for y in range(1, years + 1):
        here, there = ((found.year > 0) & (found.year <= y) for found in (poor, rich))
        assert (there | ~here).all()
    longer = schedule(cost, yearly, budget=budget, years=years + 3)
    assert longer.built[:years].tolist() == poor.built.tolist()


def test_upkeep_is_by_the_fuel_under_the_segment():
    codes = np.array([[1, 2, 3, 0]])
    assert upkeep_rates(codes, RETURN).tolist() == [[1 / 3, 1 / 4, 1 / 4, 0.0]]
    assert return_intervals("5") == dict.fromkeys(RETURN, 5.0)
    for wrong in ("0.5", "trees=3", "pines=x", "inf", "3,4"):
        with pytest.raises(ParameterError, match="return intervals are"):
            return_intervals(wrong)
    assert visits(np.array([2, 1, 0]), np.array([3.0, np.inf, 2.0]), 9) == ["5 8", "", ""]


def test_what_cannot_be_is_refused():
    one = np.ones(2)
    for wrong, word in (({"budget": -1.0, "years": 3}, "at least 0"), ({"budget": 1.0, "years": 0}, "at least 1")):
        with pytest.raises(ParameterError, match=word):
            schedule(one, one / 2, **wrong)
    with pytest.raises(ParameterError, match="at most as much"):
        schedule(one, one * 2, budget=1.0, years=2)
    with pytest.raises(ParameterError, match="needs the number of years"):
        YearsRequest(budget_per_year=Budget(0.01)).require()
    for wrong in ({"discount": -0.1}, {"fires_per_year": -1.0}, {"upkeep_cost": 2.0}):
        with pytest.raises(ParameterError, match="expected a number"):
            YearsRequest(years=2, **wrong).require()


@pytest.fixture(scope="module")
def planned(make_landscape):
    landscape = make_landscape((20, 27), relief=3.0)

    def make(**years):
        asked = YearsRequest(**years) if years else None
        return plan(landscape, budget=0.2, n_runs=40, seed=3, timeless=True, years=asked)

    return make


def test_all_in_the_first_year_is_the_plan_of_today(planned):
    today = planned()
    made = planned(years=4, budget_per_year=Budget(1.0), fires_per_year=2.0)
    expected = 2.0 * float(today.after["fire_size"].mean()) * today.network.grid.cell_area_ha
    assert made.breaks.equals(today.breaks)
    assert (made.segments.lines["year"] == 1).all()
    assert made.years.table["burnt_ha"].to_numpy() == pytest.approx(np.full(4, expected))
    assert made.years.table["burnt_ha_now"].to_numpy() == pytest.approx(np.full(4, expected))  # a discount of 0
    assert made.years.table["spent_building"].tolist()[1:] == [0.0, 0.0, 0.0]
    assert today.years is None
    assert "year" not in today.segments.lines


def test_one_year_of_the_whole_cost_builds_all(planned):
    """The budget of a year is by default what all costs, over the years: of one year, everything."""
    today = planned()
    calls = []

    def losses(stands, standing):
        assert standing is None
        calls.append(int(stands.sum()))
        cut = today.design.part(stands)
        return float(today.network.n_burnable - (0 if cut is None else cut.sum())), np.nan

    found = over_years(
        YearsRequest(years=1),
        today.segments.polygons,
        today.landscape["vegetation"],
        today.network,
        losses,
        budget=Budget(0.2),
        priced=False,
    )
    cut = int(today.breaks.sum())
    assert calls == [0, len(today.segments.polygons)]
    assert found.table["standing_ha"].tolist() == pytest.approx([cut * today.network.grid.cell_area_ha])
    assert found.table["burnt_ha"].tolist() == [today.network.n_burnable - cut]
    rates = mean_rates(today.segments.polygons, today.landscape["vegetation"], RETURN)
    assert found.columns["upkeep_year"] == pytest.approx(rates * today.segments.polygons["area_ha"].to_numpy())


def test_more_money_a_year_never_loses_more(planned):
    shares = (0.01, 0.03, 0.1)
    tables = [planned(years=5, budget_per_year=Budget(share), discount=0.03).years.table for share in shares]
    for poor, rich in itertools.pairwise(tables):
        assert (rich["burnt_ha"] <= poor["burnt_ha"]).all()
    first = tables[0]
    assert first["burnt_ha"].is_monotonic_decreasing
    assert (first["spent"] <= first["budget"] * (1 + 1e-9)).all()
    factor = 1.03 ** -np.arange(5.0)
    assert first["burnt_ha_now"].to_numpy() == pytest.approx(first["burnt_ha"].to_numpy() * factor)
    assert tables[-1]["burnt_ha"].iloc[-1] < first["burnt_ha"].iloc[0]


def test_the_command_tells_the_years(tmp_path):
    three(tmp_path, 20, 26)
    words = ["plan", *(tmp_path / f"{n}.tif" for n in ("dem", "vegetation", "density")), "--runs", "10", "--timeless"]
    words += ["--budget", "20%", "--years", "4", "--budget-per-year", "1ha", "--discount", "3%", "-o", tmp_path / "out"]
    done = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert done.exit_code == 0, done.output
    account = json.loads((tmp_path / "out" / "run.json").read_text())
    years, whole, *_ = account["headline"]
    # What is not built within the years is not promised.
    assert re.match(r"Over 4 years .* segments are not built, and .* ha less burn in all .*\(fires burn until", years)
    assert whole.startswith("If all of it were built: cutting ")
    assert done.output.index(years) < done.output.index(whole)
    assert "If all of it were built: saved, " in done.output
    rows = list(csv.DictReader((tmp_path / "out" / "years.csv").read_text().splitlines()))
    assert [row["year"] for row in rows] == ["1", "2", "3", "4"]
    assert all(float(row["spent"]) <= 1.0 + 1e-9 for row in rows)
    lines = gpd.read_file(tmp_path / "out" / "segments.gpkg", layer="lines")
    assert set(lines.columns) - {"geometry"} <= set(COLUMNS)
    assert {"year", "year_begun", "upkeep_years", "upkeep_year"} <= set(lines)
    assert [row["year"] for row in account["summary"]["years"]] == [1, 2, 3, 4]
    page = (tmp_path / "out" / "report.html").read_text()
    assert "Year by year" in page
    assert (lines["year"] == 0).any()  # not within the years, which the page does not call a year
    assert "Year 1," in page
    assert "Year 0" not in page
    assert "Value lost" not in page
    assert account["summary"]["unbuilt_segments"] == np.count_nonzero(lines["year"] == 0)
    assert "a fire, if all breaks were built" in page


@pytest.mark.parametrize("width", [None, 6.0])
def test_all_segments_are_the_breaks_of_the_plan(make_landscape, width):
    """Whole cells or lines, all built: the fires of the last year are those of the plan; none built: those before."""
    land = make_landscape((40, 47), seed=2, relief=3.0)
    years = YearsRequest(years=3, budget_per_year=Budget(1.0))
    made = plan(land, budget=0.08, line_width=width, n_runs=30, seed=2, years=years)
    area = made.network.grid.cell_area_ha
    every = np.ones(len(made.segments.lines), bool)
    assert made.design.part(~every) is None
    assert made.headline[0].startswith("Over 3 years")
    assert made.headline[1].startswith("Once all of it stands: cutting ")
    assert "if all is built" not in made.title
    assert made.summary["unbuilt_segments"] == 0
    assert made.years.table["burnt_ha"].iloc[-1] == pytest.approx(float(made.after["fire_size"].mean()) * area)
    # Lines narrower than a cell have fuel under them too, but for a few pieces over bare ground.
    assert (made.segments.lines["upkeep_year"] > 0).mean() > 0.8
    few = plan(land, budget=0.08, line_width=width, n_runs=30, seed=2, years=YearsRequest(2, Budget(0.02)))
    stands = few.segments.lines["year"].to_numpy() > 0
    assert set(stands) == {False, True}
    assert f", {np.count_nonzero(~stands)} segments are not built" in few.headline[0]
    assert few.headline[1].startswith("If all of it were built: cutting ")
    assert few.title.endswith("saved if all is built")
    part = few.years.table["burnt_ha"].iloc[-1] / area
    assert few.after["fire_size"].mean() < part < few.before["fire_size"].mean()


def columns_of(shape, *numbers):
    """Existing breaks along whole columns of a map."""
    plane = np.zeros(shape, np.uint8)
    plane[:, list(numbers)] = 1
    return plane


@pytest.fixture(scope="module")
def old(make_landscape):
    """A landscape that a break of one column cuts in two, and one along its rim that nothing is behind."""
    land = make_landscape((24, 41), seed=5, relief=3.0)
    grid = Grid.of(land["burnable"])
    return land, existing_breaks(grid.dataarray(columns_of((24, 41), 20, 40), "breaks"), grid)


def test_existing_breaks_stand_before_and_after(old):
    """Fires before are those with the existing breaks, after those with both; the plan pays for none of their cells."""
    land, existing = old
    given = {"budget": 0.06, "n_runs": 40, "seed": 4}
    made = plan(land, existing=existing, line_width="cells", **given)
    cut, there = made.breaks.to_numpy() > 0, existing.mask((24, 41))
    assert not (cut & there).any()
    fires = {"hold": made.judged.fires.hold, "duration": made.judged.fires.duration, "n_runs": 40, "seed": 4}
    timed = fb.spread_network(land, clock=True)
    fires["ignitions"] = made.judged.fires.ignitions
    for breaks, burnt in ((there, made.before), (there | cut, made.after)):
        again = fb.simulate(timed, breaks=breaks, **fires)
        np.testing.assert_array_equal(again["fire_size"], burnt["fire_size"])
    curve = made.evaluation["burnt_cells"].sel(ranking="dissection")
    np.testing.assert_array_equal(curve.sel(budget=made.share), made.after["fire_size"])
    np.testing.assert_array_equal(curve.sel(budget=0.0), made.before["fire_size"])
    worth = made.existing["worth_ha"].to_numpy()
    alone = fb.simulate(timed, breaks=columns_of((24, 41), 40) | cut, **fires)["fire_size"].mean()
    area = made.network.grid.cell_area_ha
    assert worth[0] == pytest.approx(float(alone - made.after["fire_size"].mean()) * area)
    assert worth[0] > abs(worth[1])
    with pytest.raises(ParameterError, match="no existing breaks"):
        _ = plan(land, method="degree", **given).existing


def test_existing_breaks_are_on_the_page_and_in_the_picture(old, tmp_path):
    land, existing = old
    made = plan(land, existing=existing, budget=0.06, n_runs=10, seed=4)
    write_plan(made, tmp_path / "out")
    for page in ((tmp_path / "out" / "report.html").read_text(), report_page(tmp_path / "out")):
        shown = page[page.index('"key":"existing"') : page.index('"key":"segments"')]
        assert shown.count('"Existing break"') == 2
        worth = made.existing["worth_ha"].iloc[0]
        assert f'"Burns more in the mean fire without it":"{worth:,.1f} ha"' in shown
    texts = [text.get_text() for axes in made.plot().axes if (key := axes.get_legend()) for text in key.get_texts()]
    assert "existing breaks" in texts
    without = plan(land, budget=0.06, n_runs=10, seed=4)
    write_plan(without, tmp_path / "without")
    assert '"key":"existing"' not in (tmp_path / "without" / "report.html").read_text()


def test_lines_beside_existing_breaks(old):
    """Fires meet both; no line is laid on what is cut already, and over years each may be dropped."""
    land, existing = old
    made = plan(land, existing=existing, budget=0.06, n_runs=60, seed=4, years=YearsRequest(3, fires_per_year=2.0))
    there, laid = existing.mask((24, 41)), made.design.laid
    assert isinstance(laid, LineBreaks)
    assert laid.cells is None
    assert made.parameters["line_width"] == made.network.grid.cell_size
    timed = fb.spread_network(land, clock=True)
    fires = {"hold": made.judged.fires.hold, "duration": made.judged.fires.duration, "n_runs": 60, "seed": 4}
    fires["ignitions"] = made.judged.fires.ignitions
    both = replace(laid, cells=there)
    for breaks, burnt in ((there, made.before), (both, made.after)):
        again = fb.simulate(timed, breaks=breaks, **fires)
        np.testing.assert_array_equal(again["fire_size"], burnt["fire_size"])
        np.testing.assert_array_equal(again["burn_count"], burnt["burn_count"])
    assert made.after["fire_size"].sum() < 0.95 * made.before["fire_size"].sum()
    curve = made.evaluation["burnt_cells"].sel(ranking="dissection")
    np.testing.assert_array_equal(curve.sel(budget=made.share), made.after["fire_size"])
    np.testing.assert_array_equal(curve.sel(budget=0.0), made.before["fire_size"])
    middle = made.walls.geometry.interpolate(0.5, normalized=True)
    old_ground = existing.frame.geometry.union_all()
    assert not middle.within(old_ground).any()
    worth = made.existing["worth_ha"].to_numpy()
    alone = fb.simulate(timed, breaks=replace(laid, cells=columns_of((24, 41), 40)), **fires)["fire_size"].mean()
    area = made.network.grid.cell_area_ha
    assert worth[0] == pytest.approx(float(alone - made.after["fire_size"].mean()) * area)
    assert made.years.table["existing_ha"].iloc[0] > 0


def test_existing_breaks_are_kept_up_or_dropped(old):
    land, existing = old
    given = {"budget": 0.06, "n_runs": 40, "seed": 4, "existing": existing, "timeless": True}
    ask = {"years": 6, "return_interval": dict.fromkeys(RETURN, 3.0)}
    pays = plan(land, years=YearsRequest(**ask), **given).existing
    pays = (pays["upkeep_ha"] / pays["worth_ha"].clip(lower=1e-9)).to_numpy()
    between = float(np.sqrt(pays[0] * pays[1]))  # with so many fires the one pays, the other does not
    assert pays[0] < between
    many = plan(land, years=YearsRequest(fires_per_year=between, **ask), **given)
    table = many.existing
    saved = between * table["worth_ha"]
    assert (table["keep"] == np.where(saved >= table["upkeep_ha"], "yes", "no")).all()
    assert table["keep"].tolist() == ["yes", "no"]
    assert table["stands_until"].tolist() == [6, 3]
    assert table["upkeep_years"].iloc[0] == "4"
    fuel = table["upkeep_ha"].to_numpy() * 3.0
    assert (fuel <= table["area_ha"] + 1e-9).all()
    years = many.years.table
    kept = table["upkeep_year"].iloc[0]
    assert (years["spent_upkeep"] >= kept - 1e-9).all()
    assert (years["spent"] <= years["budget"] * (1 + 1e-9)).all()
    assert years["existing_ha"].tolist() == pytest.approx([table["area_ha"].sum()] * 3 + [table["area_ha"].iloc[0]] * 3)
    none = plan(land, years=YearsRequest(fires_per_year=0.0, **ask), **given)
    assert none.existing["keep"].tolist() == ["no", "no"]
    assert none.years.table["existing_ha"].tolist()[3:] == [0.0] * 3
    assert none.years.table["spent_upkeep"].iloc[0] == 0.0
    poor = plan(
        land, years=YearsRequest(budget_per_year=Budget(kept / 2, "ha"), fires_per_year=between, **ask), **given
    )
    assert poor.existing["keep"].tolist() == ["no", "no"]


def test_the_command_takes_existing_breaks(tmp_path):
    three(tmp_path, 20, 26)
    write(tmp_path / "old.tif", columns_of((20, 26), 13))
    words = ["plan", *(tmp_path / f"{n}.tif" for n in ("dem", "vegetation", "density")), "--runs", "10", "--timeless"]
    words += ["--budget", "10%", "--existing", tmp_path / "old.tif", "--years", "3", "-o", tmp_path / "out"]
    done = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert done.exit_code == 0, done.output
    assert "existing breaks" in done.output
    table = gpd.read_file(tmp_path / "out" / "existing.gpkg")
    assert set(table.columns) - {"geometry"} <= set(COLUMNS)
    assert {"worth_ha", "upkeep_year", "keep", "stands_until"} <= set(table)
    account = json.loads((tmp_path / "out" / "run.json").read_text())
    assert any(each["path"].endswith("old.tif") for each in account["inputs"])
