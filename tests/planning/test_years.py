"""A plan over years: money of a year, upkeep before building, and what burns with what stands."""

from __future__ import annotations

import csv
import itertools
import json

import geopandas as gpd
import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis.breaks import Budget
from firebreak_gis.cli import firebreak
from firebreak_gis.construction.years import RETURN, mean_rates, return_intervals, schedule, upkeep_rates, visits
from firebreak_gis.errors import ParameterError
from firebreak_gis.planning.pipeline import plan
from firebreak_gis.planning.request import DesignRequest, PlanRequest
from firebreak_gis.planning.years import YearsRequest, over_years
from tests.places import three


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
    with pytest.raises(ParameterError, match="whole cells"):
        PlanRequest(DesignRequest(line_width=5.0), calendar=YearsRequest(years=2)).require()
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

    def losses(cut):
        calls.append(int(cut.sum()))
        return float(today.network.n_burnable - cut.sum()), np.nan

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
    assert calls == [0, cut]
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
    assert "Over 4 years" in done.output
    rows = list(csv.DictReader((tmp_path / "out" / "years.csv").read_text().splitlines()))
    assert [row["year"] for row in rows] == ["1", "2", "3", "4"]
    assert all(float(row["spent"]) <= 1.0 + 1e-9 for row in rows)
    lines = gpd.read_file(tmp_path / "out" / "segments.gpkg", layer="lines")
    assert {"year", "year_begun", "upkeep_years", "upkeep_year"} <= set(lines)
    account = json.loads((tmp_path / "out" / "run.json").read_text())
    assert [row["year"] for row in account["summary"]["years"]] == [1, 2, 3, 4]
    page = (tmp_path / "out" / "report.html").read_text()
    assert "Year by year" in page
    assert (lines["year"] == 0).any()  # not within the years, which the page does not call a year
    assert "Year 1," in page
    assert "Year 0" not in page
    assert "Value lost" not in page
