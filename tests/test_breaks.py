"""Breaks: exact budgets, nested plans, ties, polygons."""

import math

import geopandas as gpd
import numpy as np
import pytest
from affine import Affine
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from firebreak_gis.breaks import Budget, first_cut, removal_order, select_breaks
from firebreak_gis.construction.pieces import break_polygons
from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from tests.twins import breaks as twin

GRID = Grid((9, 14), Affine(25, 0, 500_000, 0, -25, 4_000_000), parse_crs("EPSG:32635"))
PRIORITIES = hnp.arrays(np.float64, (5, 7), elements=st.sampled_from([0.0, 1.0, 2.5, -3.0, -math.inf, math.nan]))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(PRIORITIES, st.floats(0, 1))
def test_exactly_the_budget_is_cut_in_order(priority, budget):
    order = twin.removal_order(priority)
    count = math.floor(budget * len(order) + 0.5)
    mask = select_breaks(priority, budget=budget).to_numpy()
    assert {tuple(cell) for cell in np.argwhere(mask).tolist()} == set(order[:count])
    position = removal_order(priority)
    assert [tuple(c) for c in np.argwhere(position >= 0).tolist()] == sorted(order)
    for k, cell in enumerate(order):
        assert position[cell] == k


@settings(max_examples=100, deadline=None, derandomize=True)
@given(
    hnp.arrays(np.float64, (5, 7), elements=st.sampled_from([0.0, 1.0, 2.5, -3.0, math.inf, -math.inf, math.nan])),
    st.lists(st.integers(0, 40), max_size=6).map(sorted),
)
def test_the_first_number_that_cuts_a_cell_is_told_by_its_place(priority, counts):
    expected = np.full(priority.shape, len(counts))
    for place, cell in enumerate(twin.removal_order(priority)):
        expected[cell] = sum(count <= place for count in counts)
    np.testing.assert_array_equal(first_cut(priority, counts), expected)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(PRIORITIES, st.floats(0, 1), st.floats(0, 1))
def test_plans_are_nested(priority, a, b):
    small, large = (select_breaks(priority, budget=x).to_numpy() for x in sorted((a, b)))
    assert (small <= large).all()


@settings(max_examples=40, deadline=None, derandomize=True)
@given(st.integers(0, 2**32 - 1), st.floats(0, 40))
def test_money_is_spent_to_the_last_cell_that_fits(seed, budget):
    rng = np.random.default_rng(seed)
    priority, cost = rng.random((5, 7)), rng.integers(0, 4, (5, 7)).astype(float)
    mask = select_breaks(priority, budget=budget, unit="cost", cost=cost).to_numpy() > 0
    order = twin.removal_order(priority)
    spent, count = 0.0, 0
    while count < len(order) and spent + cost[order[count]] <= budget:
        spent += cost[order[count]]
        count += 1
    assert cost[mask].sum() == spent
    assert {tuple(cell) for cell in np.argwhere(mask).tolist()} == set(order[:count])


def test_hectares():
    priority = GRID.dataarray(np.random.default_rng(0).random(GRID.shape), "priority")
    mask = select_breaks(priority, budget=1.0, unit="ha")
    assert mask.attrs["cells_cut"] == mask.sum() == 16  # 625 m2 a cell


def test_share_counts_fuel_that_may_not_be_cut():
    priority = np.full((4, 5), -np.inf)
    priority[:2] = 1.0
    mask = select_breaks(priority, budget=0.25, burnable=np.ones((4, 5), bool))
    assert mask.sum() == 5
    with pytest.raises(ParameterError, match=r"only 10 cells can be cut.*0\.5"):
        select_breaks(priority, budget=0.6, burnable=np.ones((4, 5), bool))


@pytest.mark.parametrize("budget", [-0.1, 1.1, math.nan, math.inf, "much"])
def test_impossible_budgets_are_refused(budget):
    with pytest.raises(ParameterError, match="budget"):
        Budget(budget).cells(n_burnable=100)


def test_wrong_requests_are_refused():
    priority = np.ones((3, 4))
    with pytest.raises(ParameterError, match="share, ha or cost"):
        select_breaks(priority, budget=1, unit="acres")
    with pytest.raises(ParameterError, match="cost of every cell"):
        select_breaks(priority, budget=1, unit="cost")
    with pytest.raises(GridError):
        select_breaks(priority, budget=0.1, burnable=np.ones((4, 3)))
    with pytest.raises(GridError):
        removal_order(np.ones(4))


def test_halves_are_rounded_up():
    assert [Budget(b).cells(n_burnable=10) for b in (0.05, 0.15, 0.25, 0.14, 0.0, 1.0)] == [1, 2, 3, 1, 0, 10]


@settings(max_examples=25, deadline=None, derandomize=True)
@given(hnp.arrays(np.bool_, GRID.shape))
def test_polygons_are_the_pieces(cut):
    priority = np.random.default_rng(0).random(GRID.shape)
    frame = break_polygons(GRID.dataarray(cut.astype(np.uint8), "breaks"), GRID.dataarray(priority, "priority"))
    pieces = twin.pieces(cut)
    assert len(frame) == len(pieces)
    assert frame.crs == GRID.crs
    if not pieces:
        return
    assert frame.geometry.is_valid.all()
    np.testing.assert_allclose(frame["area_ha"], frame.area / 10_000)
    assert sorted(frame["cells"]) == sorted(len(p) for p in pieces)
    means = sorted((np.mean([priority[cell] for cell in piece]) for piece in pieces), reverse=True)
    np.testing.assert_allclose(frame["mean_priority"], means)
    assert frame["order"].tolist() == list(range(1, len(pieces) + 1))
    row, col = np.nonzero(cut)
    points = gpd.GeoSeries(gpd.points_from_xy(GRID.x[col], GRID.y[row]), crs=GRID.crs)
    assert points.within(frame.union_all()).all()


def test_money_buys_only_cells_whose_cost_is_known():
    priority = np.arange(12.0).reshape(3, 4)
    for wrong in (np.nan, -1.0, np.inf):
        cost = np.ones((3, 4))
        cost[1, 2] = wrong
        with pytest.raises(InputError, match="missing, negative or infinite on 1 cells"):
            select_breaks(priority, budget=3.0, unit="cost", cost=cost)
        never = np.where(np.isfinite(cost) & (cost >= 0), priority, -np.inf)
        assert select_breaks(never, budget=3.0, unit="cost", cost=cost).attrs["cells_cut"] == 3


def test_another_variable_is_no_ranking():
    from firebreak_gis import SpreadNetwork, burn_curve, evaluate

    network = SpreadNetwork(np.full((8, 3, 4), 0.5))
    other = network.grid.dataarray(np.arange(12.0).reshape(3, 4), "elevation")
    meant = other.rename("priority")
    with pytest.raises(InputError, match=r"is elevation \(terrain elevation\), expected priority"):
        select_breaks(other, budget=0.5)
    assert select_breaks(meant, budget=0.5).attrs["cells_cut"] == 6
    with pytest.raises(InputError, match="expected priority"):
        burn_curve(network, other, budgets=[0.0, 0.5], n_runs=2)
    with pytest.raises(InputError, match="expected priority"):
        evaluate(network, {"random": meant, "dem": other}, budgets=[0.0, 0.5], n_runs=2)


@pytest.mark.parametrize(
    ("text", "amount", "unit"),
    [
        ("10%", 0.1, "share"),
        (" 10 % ", 0.1, "share"),
        ("10 percent", 0.1, "share"),
        ("10 per cent", 0.1, "share"),
        ("0.1", 0.1, "share"),
        ("5ha", 5.0, "ha"),
        ("5 Hectares", 5.0, "ha"),
        ("2 km2", 200.0, "ha"),
        ("10 acres", 4.0468564224, "ha"),
        ("20000eur", 2e4, "cost"),
        ("20 000 EUR", 2e4, "cost"),
        ("€20000", 2e4, "cost"),
        ("US$ 1 500 000", 1.5e6, "cost"),
        ("2e4 chf", 2e4, "cost"),
        ("99.95 dollars", 99.95, "cost"),
    ],
)
def test_a_budget_tells_what_it_counts(text, amount, unit):
    assert Budget.of(text) == Budget(amount, unit)
    assert Budget.of(Budget.of(text)) == Budget(amount, unit)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(0, 100_000))
def test_percents_are_the_share_itself(thousandths):
    """Not a neighbour of it, so that a plan for 35% is that for 0.35 to the byte."""
    whole, rest = divmod(thousandths, 1000)
    assert Budget.of(f"{whole}.{rest:03d}%").amount == float(f"{thousandths}e-5")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "%",
        "ha",
        "abc",
        "5 apples",
        "5 m",
        "5 mm",
        "20,000 eur",
        "20.000 EUR",
        "1,5%",
        "1 2 eur",
        "5 unknown",
        "5% ha",
    ],
)
def test_what_might_be_misread_is_refused(text):
    with pytest.raises(ParameterError, match=r"10%.*5ha.*20000eur"):
        Budget.of(text)


def test_a_unit_may_be_given_beside_but_not_against():
    assert Budget.of(5, "ha") == Budget.of("5", "ha") == Budget.of("5 ha", "ha") == Budget(5.0, "ha")
    assert Budget.of(Budget(5.0, "ha"), "ha") == Budget(5.0, "ha")
    for budget, unit in (("5ha", "cost"), ("10%", "ha"), ("20 eur", "share"), (Budget(0.1), "ha")):
        with pytest.raises(ParameterError, match=f"given as {unit}.*leave the unit away"):
            Budget.of(budget, unit)


def test_texts_cut_what_numbers_cut():
    priority = GRID.dataarray(np.random.default_rng(0).random(GRID.shape), "priority")
    cost = np.full(GRID.shape, 2.0)
    assert (select_breaks(priority, budget="35%") == select_breaks(priority, budget=0.35)).all()
    assert (select_breaks(priority, budget="1ha") == select_breaks(priority, budget=1.0, unit="ha")).all()
    assert select_breaks(priority, budget="21 eur", cost=cost).attrs["cells_cut"] == 10


@settings(max_examples=30, deadline=None, derandomize=True)
@given(st.integers(1, 500), st.floats(0, 30))
def test_the_share_of_an_area_cuts_its_cells(n_burnable, hectares):
    class Network:
        grid = GRID

    Network.n_burnable = n_burnable
    budget = Budget(hectares, "ha")
    cells = budget.cells(n_burnable=n_burnable, cell_area_ha=GRID.cell_area_ha)
    if cells <= n_burnable:
        assert Budget(budget.share(Network)).cells(n_burnable=n_burnable) == cells
    assert Budget(0.07).share(Network) == 0.07
    with pytest.raises(ParameterError, match="buys each ranking another area"):
        Budget(5.0, "cost").share(Network)
