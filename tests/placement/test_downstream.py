"""Gains of single cells in simulated fires: the tree of who lit whom, dominators, cells left uncut."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis.kernels import gains
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.fires import design_fires, losses
from firebreak_gis.placement.gains import mean_gain
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes
from tests.twins import placement as twin


def case(
    seed: int, boundary: str = "open", shape: tuple[int, int] = (9, 12), density: float = 0.35, residual: float = 0.0
):
    random = np.random.default_rng(seed)
    probability = (random.random((8, *shape)) * density * 2).clip(0, 1).astype(np.float32)
    network = SpreadNetwork(probability, burnable=random.random(shape) > 0.1, boundary=boundary)
    stakes = Stakes(network, value=random.integers(0, 9, shape), ignition=random.random(shape))
    alive = (network.burnable & (random.random(shape) > 0.05)).ravel()
    fires = design_fires(network, stakes, n_runs=12, seed=seed, residual=residual)
    return network, stakes, alive, fires


def by_twin(function, network, stakes, alive, fires):
    value = stakes.value.ravel()
    runs = range(fires.keys.size)
    return sum(
        function(twin.open_graph(network, fires, run), int(fires.cells[run]), alive, value) for run in runs
    ) / len(runs)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("density", [0.2, 0.35, 0.5])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_downstream_value_equals_the_tree_climbed_cell_by_cell(boundary, density, residual):
    network, stakes, alive, fires = case(1, boundary, density=density, residual=residual)
    gain, lost = mean_gain(gains.downstream, fires, alive, stakes.value.ravel(), progress=silent)
    np.testing.assert_allclose(gain, by_twin(twin.downstream, network, stakes, alive, fires), rtol=1e-12, atol=1e-12)
    assert lost == pytest.approx(by_twin(twin.loss, network, stakes, alive, fires))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("density", [0.2, 0.35, 0.5])
def test_dominated_value_is_what_deleting_the_cell_saves(boundary, density):
    network, stakes, alive, fires = case(2, boundary, density=density)
    gain, lost = mean_gain(gains.dominated, fires, alive, stakes.value.ravel(), progress=silent)
    deleted = by_twin(twin.gain_by_deleting, network, stakes, alive, fires)
    np.testing.assert_allclose(gain, deleted, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(
        gain, by_twin(twin.gain_by_dominators, network, stakes, alive, fires), rtol=1e-12, atol=1e-12
    )
    assert lost == pytest.approx(by_twin(twin.loss, network, stakes, alive, fires))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("density", [0.2, 0.35, 0.5])
@pytest.mark.parametrize("residual", [0.1, 0.5])
def test_dominated_value_is_what_treating_the_cell_saves_where_breaks_leak(boundary, density, residual):
    network, stakes, alive, fires = case(7, boundary, density=density, residual=residual)
    gain, lost = mean_gain(gains.dominated, fires, alive, stakes.value.ravel(), progress=silent)
    treated = by_twin(twin.gain_by_deleting, network, stakes, alive, fires)
    np.testing.assert_allclose(gain, treated, rtol=1e-12, atol=1e-12)
    assert lost == pytest.approx(by_twin(twin.loss, network, stakes, alive, fires))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_reopened_value_is_what_leaving_the_cell_costs(boundary, residual):
    network, stakes, alive, fires = case(3, boundary, residual=residual)
    value = stakes.value.ravel()
    loss = np.zeros(alive.size)
    given = (fires.limits, fires.leaks, fires.keys, fires.grid_steps, fires.cells, alive, value, 0, fires.keys.size)
    gains.reopened(*given, np.inf, loss)
    before = by_twin(twin.loss, network, stakes, alive, fires)
    cut = np.flatnonzero(network.burnable.ravel() & ~alive)
    for cell in cut:
        left = alive.copy()
        left[cell] = True
        expected = by_twin(twin.loss, network, stakes, left, fires) - before
        assert loss[cell] / fires.keys.size == pytest.approx(expected)
    assert not loss[alive].any()
    capped = np.zeros(alive.size)
    enough = float(np.median(loss[cut]))
    gains.reopened(*given, enough, capped)
    assert (capped[loss < enough] == loss[loss < enough]).all()
    assert (capped[loss >= enough] >= enough).all()


@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_losses_of_the_design_are_those_of_the_twin(residual):
    network, stakes, alive, fires = case(4, residual=residual)
    cut = (network.burnable.ravel() & ~alive).reshape(network.shape)
    expected = by_twin(twin.loss, network, stakes, alive, fires) / stakes.value.sum()
    assert losses(network, stakes, cut, fires, residual=residual, progress=silent).mean() == pytest.approx(expected)


def test_gains_do_not_depend_on_threads():
    _, stakes, alive, fires = case(5)
    value = stakes.value.ravel()
    for kernel in (gains.downstream, gains.dominated):
        one = mean_gain(kernel, fires, alive, value, threads=1, progress=silent)
        two = mean_gain(kernel, fires, alive, value, threads=3, progress=silent)
        assert (one[0] == two[0]).all()
        assert one[1] == two[1]


@pytest.mark.parametrize("method", ["downstream", "dominator"])
def test_value_at_risk_behind_a_gap_draws_the_cut_to_the_gap(method):
    burnable = np.ones((9, 15), bool)
    burnable[:, 7] = False
    burnable[4, 7] = True
    network = SpreadNetwork(np.full((8, 9, 15), 0.8, np.float32), burnable=burnable)
    value = np.where(np.arange(15) > 7, 5.0, 0.01) * burnable
    stakes = Stakes(network, value=value, ignition=np.arange(15) * np.ones((9, 1)) < 7)
    priority = rank(network, method, stakes=stakes)
    assert np.unravel_index(priority.values.argmax(), priority.shape) == (4, 7)


@pytest.mark.parametrize("method", ["downstream", "dominator"])
def test_cheap_cells_come_before_dear_ones_and_protected_ones_never(method):
    random = np.random.default_rng(6)
    network = SpreadNetwork(np.full((8, 12, 14), 0.5, np.float32))
    dear = random.random(network.shape) < 0.5
    kept = random.random(network.shape) < 0.1
    stakes = Stakes(network, cost=np.where(dear, 10.0, 1.0), protected=kept)
    priority = rank(network, method, stakes=stakes).values
    assert np.isneginf(priority[kept]).all()
    first = np.argsort(-priority.ravel(), kind="stable")[:20]
    assert dear.ravel()[first].mean() < 0.2
