"""What a plan tells its ranking: leak, budget, width, terrain; exact budgets whatever is asked."""

from __future__ import annotations

import numpy as np
import pytest
from affine import Affine
from hypothesis import given, settings
from hypothesis import strategies as st

from firebreak_gis import plugins
from firebreak_gis.breaks import Budget, removal_order, select_breaks
from firebreak_gis.errors import ParameterError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.trial import Trial
from firebreak_gis.placement.widening import offsets
from firebreak_gis.planning.design import Designs, design
from firebreak_gis.planning.pipeline import plan
from firebreak_gis.planning.thickening import thickened
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.ground import Ground
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.stakes import Stakes


def random_network(seed, shape=(11, 14), boundary="open"):
    rng = np.random.default_rng(seed)
    return SpreadNetwork(
        rng.random((8, *shape)).astype(np.float32), burnable=rng.random(shape) > 0.15, boundary=boundary
    )


def timed_network(seed=0, shape=(24, 30)):
    rng = np.random.default_rng(seed)
    return SpreadNetwork(
        rng.uniform(0.4, 0.8, (8, *shape)),
        burnable=rng.random(shape) > 0.05,
        travel_time=rng.integers(100, 400, (8, *shape)),
        crs="EPSG:32635",
        transform=Affine(20, 0, 586_440, 0, -20, 3_999_900),
    )


def told(method, given=None, *, share=0.2, **more):
    network = random_network(0)
    residual = more.pop("residual", 0.1)
    designs = Designs(network, method, stakes=Stakes(network), **{"width": 3, **more})
    known = designs.facts(Budget(share), residual)
    assert set(known) == set(plugins.FACTS)
    return plugins.told(plugins.load("ranking", method), known, given or {})


def test_methods_are_told_what_they_ask_for():
    assert told("dissection") == {"residual": 0.1, "cost_share": 0.2, "least_width": 3}
    assert told("dissection", {"residual": 0.3, "cost_share": 0.5}) == {"least_width": 3}
    assert told("compartments") == {"cost_share": 0.2, "width": 3}
    assert told("stripes", width=1) == {"cost_share": 0.2, "width": 1}
    assert told("splat", width=5) == {"cell_share": 0.2, "width": 5}
    assert told("dfpz") == {"width": 5}  # its own is wider
    plane = np.zeros((2, 3))
    assert set(told("dfpz", elevation=plane, roads=plane)) == {"width", "elevation", "roads"}
    assert told("bonacich", {"beta": 0.2}) == {}
    assert told("compartments", {"width": "4"}) == {"cost_share": 0.2}
    with pytest.raises(ParameterError, match="at least 3 cells wide"):
        told("compartments", {"width": "2"})
    with pytest.raises(ParameterError, match=r"no parameter 'height'.*width"):
        told("compartments", {"height": "2", "width": "x"})
    assert told("dissection", {"width": 0})["least_width"] == 3
    network = random_network(0)
    with pytest.raises(ParameterError, match="at least 3 cells wide"):
        design(network, "dissection", stakes=Stakes(network), budget=Budget(0.2), width=3, params={"width": 2})
    for name in plugins.names("ranking"):
        module = plugins.load("ranking", name)
        asked = {p["name"]: p["told"] for p in plugins.describe("ranking", name)["parameters"] if "told" in p}
        plane = np.zeros(network.shape)
        assert set(told(name, elevation=plane, roads=plane)) == set(asked)
        assert set(asked.values()) == {fact for fact in plugins.FACTS if plugins.asks_for(module, fact)}
        plugins.build_params(module, told(name, share=0.0))  # never out of range


def test_a_parameter_can_only_ask_for_what_a_plan_knows():
    with pytest.raises(ParameterError, match=r"told 'colour'.*cost_share"):
        plugins.parameter(1.0, text="a colour", told="colour")


@pytest.mark.parametrize("width", [0, 2])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_parameters_that_make_no_difference_give_one_plan(width, residual):
    """Plans of two budgets are one and the same where the method says so, and only there."""
    network = random_network(3, shape=(16, 21))
    module = plugins.load("ranking", "dissection")
    both = [{"width": width, "residual": residual, "cost_share": share} for share in (0.05, 0.4)]
    settled = [plugins.effective(module, plugins.build_params(module, p)) for p in both]
    ranked = [rank(network, "dissection", **p).to_numpy() for p in both]
    if settled[0] == settled[1]:
        np.testing.assert_array_equal(*ranked)
    assert (settled[0] == settled[1]) == (width > 0 or residual == 0.0)
    designs = Designs(network, "dissection", stakes=Stakes(network), params={"width": width})
    plans = [designs(b, residual, silent) for b in (0.05, 0.4)]
    assert (plans[0] is plans[1]) == (settled[0] == settled[1])
    for plan_, expected in zip(plans, ranked, strict=True):
        np.testing.assert_array_equal(plan_, expected)


def test_share_of_the_cost():
    network = random_network(0)
    cost = np.where(network.burnable, np.arange(154.0).reshape(11, 14), 0.0)
    stakes = Stakes(network, cost=cost)
    assert Budget(0.3).cost_share(network, stakes) == 0.3
    assert Budget(cost.sum() / 4, "cost").cost_share(network, stakes) == pytest.approx(0.25)
    assert Budget(network.n_burnable * network.grid.cell_area_ha / 5, "ha").cost_share(
        network, stakes
    ) == pytest.approx(0.2)
    assert Budget(10.0, "cost").cost_share(network, Stakes(network, cost=np.zeros(network.shape))) == 1.0


def test_a_plan_with_leaks_is_designed_for_them(make_landscape):
    """The same as when the method itself is asked for that leak and budget, where no fire has a clock."""
    landscape = make_landscape((30, 40), seed=1, relief=3.0, holes=0.03)
    timeless = {"budget": 0.3, "residual": 0.3, "timeless": True, "n_runs": 5, "seed": 4}
    made = plan(landscape, **timeless)
    asked = rank(made.network, "dissection", seed=4, residual=0.3, cost_share=0.3, least_width=1)
    np.testing.assert_array_equal(made.priority, asked)
    perfect = plan(landscape, **timeless, method_params={"residual": 0.0})
    np.testing.assert_array_equal(perfect.priority, rank(made.network, "dissection", seed=4))
    assert (made.priority != perfect.priority).any()
    assert made.after["fire_size"].mean() < perfect.after["fire_size"].mean()


def test_a_plan_with_a_clock_is_tried_out_on_its_fires(make_landscape):
    """Told in the plan, other for other leaks, left out where asked, whatever the number of judging fires."""
    landscape = make_landscape((40, 50), seed=1, relief=3.0, holes=0.03)
    given = {"budget": 0.15, "n_runs": 5, "seed": 4, "hold": 1.0, "duration": "4h"}
    made = plan(landscape, **given, residual=0.1)
    assert made.summary["design"] == made.priority.attrs["design"] != ""
    without = plan(landscape, **given, residual=0.1, method_params={"by_fires": False})
    np.testing.assert_array_equal(
        without.priority, plan(landscape, **given, residual=0.1, method_params={"by_fires": "no"}).priority
    )
    asked = rank(made.network, "dissection", seed=4, residual=0.1, cost_share=0.15, least_width=1)
    np.testing.assert_array_equal(without.priority, asked)
    assert (made.priority != without.priority).any()
    perfect = plan(landscape, **given)
    assert (perfect.priority != made.priority).any()
    # The number of fires that judge changes nothing.
    np.testing.assert_array_equal(perfect.priority, plan(landscape, **{**given, "n_runs": 9}).priority)


def test_fires_with_a_clock_are_told_to_methods_that_take_them():
    network = timed_network()
    stakes = Stakes(network)
    trial = Trial(Ground(network), FireRequest(duration=as_duration("1h")), stakes, 0)
    for method, differs in (("dissection", True), ("influence", True), ("flammability", False)):
        assert plugins.takes_trial(plugins.load("ranking", method)) is differs
        params = {"cover": 5.0, "recompute_every": 0.1} if method == "influence" else {}
        plans = Designs(network, method, stakes=stakes, params=params, trial=trial)
        one, other = plans(0.1, 0.0, silent), plans(0.1, 0.3, silent)
        assert (one is not other) == differs
        assert plans(0.1, 0.0, silent) is one
        assert ("made_for" in one.attrs) == (differs and method == "dissection")
    fixed = Designs(network, "dissection", stakes=stakes, params={"width": 2}, trial=trial)
    assert fixed(0.1, 0.0, silent) is fixed(0.2, 0.0, silent)


def thick_twin(order, network, protected, width):
    """Cells in the order in which squares around the ranked cells bring them along."""
    rows, cols = network.shape
    rank_of = {cell: k for k, cell in enumerate(order)}
    seen, found = set(), []
    for r, c in order:
        square = {(r + a, c + b) for a in offsets(width) for b in offsets(width)}
        if network.boundary == "periodic":
            square = {(a % rows, b % cols) for a, b in square}
        new = [
            (a, b)
            for a, b in square - seen
            if 0 <= a < rows and 0 <= b < cols and network.burnable[a, b] and not protected[a, b]
        ]
        found += sorted(new, key=lambda cell: (rank_of.get(cell, rows * cols), cell))
        seen |= square
    return found


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("width", [1, 2, 3, 4, 7])
def test_thick_breaks_are_those_of_the_twin(width, boundary):
    network = random_network(width, boundary=boundary)
    rng = np.random.default_rng(width)
    protected = rng.random(network.shape) < 0.2
    priority = np.where(network.burnable & ~protected, rng.integers(0, 40, network.shape), -np.inf)
    stakes = Stakes(network, protected=protected)
    wide = thickened(removal_order(priority), network, stakes, width)
    position = removal_order(priority)
    order = [tuple(map(int, np.argwhere(position == k)[0])) for k in range(position.max() + 1)]
    expected = thick_twin(order, network, protected, width)
    place = removal_order(wide)
    assert [tuple(map(int, np.argwhere(place == k)[0])) for k in range(place.max() + 1)] == expected
    if width == 1:
        np.testing.assert_array_equal(place, position)


@pytest.mark.parametrize("method", ["random", "dissection", "compartments"])
def test_breaks_have_the_width_asked_for(method):
    """Every cut cell lies in a square of that width that is cut as far as it holds fuel, but for the last piece."""
    network = SpreadNetwork(np.full((8, 40, 50), 0.6))
    stakes = Stakes(network)
    wide = design(network, method, stakes=stakes, budget=Budget(0.2), width=3)
    cut = select_breaks(wide, budget=0.2, burnable=network.burnable).to_numpy() > 0
    padded = np.pad(cut, 3, constant_values=True)
    whole = np.zeros(cut.shape, bool)
    for r in range(-2, 1):
        for c in range(-2, 1):
            square = np.ones(cut.shape, bool)
            for a in range(3):
                for b in range(3):
                    square &= padded[3 + r + a : 43 + r + a, 3 + c + b : 53 + c + b]
            whole |= square
    assert (cut & whole).sum() >= cut.sum() - (9 if method == "random" else 0.1 * cut.sum())
    thin = select_breaks(rank(network, method), budget=0.2).to_numpy() > 0
    assert cut.sum() == thin.sum()


@settings(max_examples=25, deadline=None)
@given(
    seed=st.integers(0, 10_000),
    method=st.sampled_from(["dissection", "flammability", "random", "compartments", "downstream"]),
    width=st.sampled_from([1, 2]),
    part=st.floats(0.0, 1.0),
)
def test_costs_are_exact_to_the_budget_and_protected_cells_stay(seed, method, width, part):
    """Whatever is left would not buy the next cell; whatever may not be cut is not."""
    rng = np.random.default_rng(seed)
    network = random_network(seed, shape=(9, 12))
    protected = rng.random(network.shape) < rng.choice([0.0, 0.2, 0.7])
    cost = rng.choice([0.0, 1.0, 2.5, 40.0], network.shape) * rng.random(network.shape)
    stakes = Stakes(network, protected=protected, cost=cost)
    free = network.burnable & ~protected
    budget = part * cost[free].sum()
    priority = design(
        network,
        method,
        stakes=stakes,
        budget=Budget(budget, "cost"),
        width=width,
        seed=seed,
        params={"fires": 5} if method == "downstream" else None,
    )
    cut = select_breaks(priority, budget=budget, unit="cost", burnable=network.burnable, cost=stakes.cost) > 0
    cut = cut.to_numpy()
    assert not cut[~free].any()
    spent = cost[cut].sum()
    assert spent <= budget * (1 + 1e-9) + 1e-9
    left = removal_order(priority)
    after = cost[(left >= 0) & ~cut]
    if after.size:
        following = cost.ravel()[np.argmin(np.where((left >= 0) & ~cut, left, left.size).ravel())]
        assert spent + following > budget * (1 - 1e-9)
    else:
        assert spent == pytest.approx(cost[free].sum())


@settings(max_examples=6, deadline=None)
@given(seed=st.integers(0, 10_000), unit=st.sampled_from(["share", "ha", "cost"]))
def test_whole_plans_keep_to_their_budget(make_landscape, seed, unit):
    rng = np.random.default_rng(seed)
    landscape = make_landscape((11, 15), seed=seed, relief=3.0)
    fuel = landscape["burnable"].to_numpy()
    protected, cost = rng.random(fuel.shape) < 0.3, 10.0 * rng.random(fuel.shape)
    free = fuel & ~protected
    share = 0.3 * free.sum() / fuel.sum()
    budget = {"share": share, "ha": share * fuel.sum() * 0.04, "cost": 0.3 * cost[free].sum()}[unit]
    given = {"protected": protected, "cost": cost, "line_width": "cells", "n_runs": 3, "seed": seed}
    made = plan(landscape, budget=budget, budget_unit=unit, **given)
    cut = made.breaks.to_numpy() > 0
    assert not cut[~free].any()
    if unit == "share":
        assert cut.sum() == int(budget * fuel.sum() + 0.5)
    elif unit == "ha":
        assert 0 <= budget - 0.04 * cut.sum() < 0.04
    else:
        assert 0 <= budget - cost[cut].sum() < 10.0
        assert made.summary["cost"] == pytest.approx(cost[cut].sum())


def test_plans_of_one_landscape_share_their_walls(monkeypatch):
    """Walls are sought once for each width and kind of leak, and the plans are those of `rank` made one by one."""
    from firebreak_gis.ranking import dissection

    network = random_network(5, shape=(14, 19))
    sought = []
    plain = dissection._walls_first

    def counted(network, params, stakes, width, progress):
        sought.append((width, params.residual > 0))
        return plain(network, params, stakes, width, progress)

    cases = [(share, residual) for share in (0.05, 0.2, 0.3) for residual in (0.0, 0.1, 0.2)]
    alone = [rank(network, "dissection", residual=residual, cost_share=share).to_numpy() for share, residual in cases]
    monkeypatch.setattr(dissection, "_walls_first", counted)
    designs = Designs(network, "dissection", stakes=Stakes(network))
    for (share, residual), expected in zip(cases, alone, strict=True):
        assert np.array_equal(designs(share, residual, silent).to_numpy(), expected)
    assert len(sought) == len(set(sought)) > 2
