"""Local search on common fires: never worse on its fires, exact to the budget, nothing protected is cut."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis.breaks import Budget, removal_order, select_breaks
from firebreak_gis.errors import Cancelled, ParameterError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.fires import design_fires, losses
from firebreak_gis.planning.refinement import refine
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes


def case(seed: int, boundary: str = "open", shape: tuple[int, int] = (17, 22)):
    random = np.random.default_rng(seed)
    probability = (0.25 + 0.3 * random.random((8, *shape))).astype(np.float32)
    network = SpreadNetwork(probability, burnable=random.random(shape) > 0.1, boundary=boundary)
    stakes = Stakes(
        network,
        cost=random.integers(1, 9, shape),
        value=random.random(shape),
        ignition=random.random(shape),
        protected=random.random(shape) < 0.1,
    )
    return network, stakes


def cut_by(network, stakes, priority, budget, unit="share"):
    grid = network.grid.dataarray(np.asarray(priority), "priority")
    return select_breaks(grid, budget=budget, unit=unit, burnable=network.burnable, cost=stakes.cost).values > 0


@pytest.mark.parametrize("unit", ["share", "cost"])
@pytest.mark.parametrize("residual", [0.0, 0.2])
@pytest.mark.parametrize("method", ["random", "dissection"])
def test_not_worse_on_its_fires_and_exact_to_the_budget(method, residual, unit):
    network, stakes = case(1)
    budget = 0.12 if unit == "share" else 0.1 * stakes.cost.sum()
    priority = rank(network, method, stakes=stakes).values
    fires = design_fires(network, stakes, n_runs=60, seed=3, residual=residual)
    refined = refine(
        network,
        stakes,
        priority,
        budget=Budget(budget, unit),
        residual=residual,
        moves=30,
        fires=fires,
        progress=silent,
    )
    before, after = (cut_by(network, stakes, plan, budget, unit) for plan in (priority, refined))
    old, new = (
        losses(network, stakes, cut, fires, residual=residual, progress=silent).mean() for cut in (before, after)
    )
    assert new <= old
    if method == "random":
        assert new < 0.8 * old
    if unit == "share":
        assert after.sum() == before.sum()
    else:
        assert stakes.cost[after].sum() <= budget
        assert budget - stakes.cost[after].sum() < stakes.cost.max()
    assert not after[stakes.protected].any()
    assert not after[~network.burnable].any()


def test_one_priority_with_the_cells_kept_in_their_old_order():
    network, stakes = case(2, "periodic")
    priority = rank(network, "random", stakes=stakes).values
    fires = design_fires(network, stakes, n_runs=40, seed=3)
    refined = refine(network, stakes, priority, budget=Budget(0.1), moves=12, fires=fires, progress=silent)
    assert (np.isfinite(refined) == np.isfinite(priority)).all()
    old, new = removal_order(priority), removal_order(refined)
    for cut in (cut_by(network, stakes, refined, 0.1), ~cut_by(network, stakes, refined, 0.1)):
        chosen = cut & (old >= 0)
        assert (np.argsort(old[chosen]) == np.argsort(new[chosen])).all()


def test_a_result_that_is_not_better_on_other_fires_is_not_taken():
    taken = []
    for seed in range(6):
        network, stakes = case(10 + seed)
        priority = rank(network, "dissection", stakes=stakes).values
        refined = refine(network, stakes, priority, budget=Budget(0.1), moves=10, n_runs=8, seed=seed, progress=silent)
        taken.append(not np.array_equal(refined, priority))
        if taken[-1]:
            assert not np.array_equal(*(cut_by(network, stakes, plan, 0.1) for plan in (priority, refined)))
    assert not all(taken)  # eight fires mislead


def test_better_on_fires_that_it_has_not_seen():
    network, stakes = case(3)
    priority = rank(network, "bonacich", stakes=stakes).values
    fresh = design_fires(network, stakes, n_runs=600, seed=77)
    refined = refine(network, stakes, priority, budget=Budget(0.1), moves=40, n_runs=150, progress=silent)
    old, new = (
        losses(network, stakes, cut_by(network, stakes, plan, 0.1), fresh, progress=silent).mean()
        for plan in (priority, refined)
    )
    assert new < 0.9 * old


def test_useless_cells_go_to_the_gap():
    burnable = np.ones((11, 15), bool)
    burnable[:, 7] = False
    burnable[4, 7] = True
    network = SpreadNetwork(np.full((8, 11, 15), 0.9, np.float32), burnable=burnable)
    column = np.arange(15) * np.ones((11, 1))
    stakes = Stakes(network, value=np.where(column > 7, 1.0, 1e-6), ignition=column < 7)
    priority = rank(network, "random", stakes=stakes).values
    refined = refine(network, stakes, priority, budget=Budget(2.0, "cost"), n_runs=50, progress=silent)
    after = cut_by(network, stakes, refined, 2.0, "cost")
    assert after[4, 7]
    fires = design_fires(network, stakes, n_runs=50, seed=1)
    assert losses(network, stakes, after, fires, progress=silent).sum() < 1e-3


def test_walls_are_widened_where_breaks_leak():
    shape = (9, 24)
    network = SpreadNetwork(np.full((8, *shape), 0.8, np.float32))
    column = np.arange(24) * np.ones((9, 1))
    stakes = Stakes(network, value=np.where(column > 13, 1.0, 1e-3), ignition=column < 5)
    # A wall, and as many cells where no fire comes from.
    priority = np.where(column == 10, 2.0, np.where(column == 23, 1.0, -column))
    budget = 18.0
    refined = refine(
        network, stakes, priority, budget=Budget(budget, "cost"), residual=0.15, n_runs=200, moves=25, progress=silent
    )
    after = cut_by(network, stakes, refined, budget, "cost")
    fresh = design_fires(network, stakes, n_runs=1000, seed=9, residual=0.15)
    old, new = (
        losses(network, stakes, cut, fresh, residual=0.15, progress=silent).mean()
        for cut in (cut_by(network, stakes, priority, budget, "cost"), after)
    )
    assert new < 0.75 * old
    assert after[:, 23].sum() <= 1
    assert after[:, 5:14].sum(axis=1).min() >= 1


def test_threads_do_not_change_the_result():
    network, stakes = case(4)
    priority = rank(network, "random", stakes=stakes).values
    plans = [
        refine(
            network,
            stakes,
            priority,
            budget=Budget(0.1),
            residual=0.1,
            moves=8,
            n_runs=600,
            seed=5,
            threads=threads,
            progress=silent,
        )
        for threads in (1, 3)
    ]
    assert (plans[0] == plans[1]).all()


def test_cancelling_and_refusing():
    network, stakes = case(5)
    priority = rank(network, "random", stakes=stakes).values

    def stop(share: float, text: str) -> None:
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        refine(network, stakes, priority, budget=Budget(0.1), progress=stop)
    with pytest.raises(ParameterError, match="budget"):
        refine(network, stakes, priority, budget=Budget(1.2), progress=silent)


def test_nothing_to_cut_comes_back_as_it_is():
    network = SpreadNetwork(np.full((8, 3, 4), 0.5, np.float32), burnable=np.zeros((3, 4), bool))
    plane = np.zeros((3, 4))
    assert np.isneginf(refine(network, Stakes(network), plane, budget=Budget(0.1), progress=silent)).all()
