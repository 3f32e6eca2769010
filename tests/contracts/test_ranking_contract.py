"""What every ranking must do, whoever wrote it."""

from __future__ import annotations

import json

import numpy as np
import pytest

from firebreak_gis import plugins
from firebreak_gis.errors import Cancelled, ParameterError
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.budgets import burn_curve
from firebreak_gis.stakes import Stakes
from tests.twins import centrality as twin

METHODS = plugins.names("ranking")
pytestmark = pytest.mark.parametrize("method", METHODS)

#: Seeds over which methods that draw are compared in the mean.
DRAWS = 150


def landscape(boundary: str = "open", shape: tuple[int, int] = (11, 14), seed: int = 3) -> SpreadNetwork:
    random = np.random.default_rng(seed)
    probability = random.random((8, *shape)).astype(np.float32)
    probability[random.random(probability.shape) < 0.1] = 0
    return SpreadNetwork(probability, burnable=random.random(shape) > 0.15, boundary=boundary)


def special(name: str) -> SpreadNetwork:
    random = np.random.default_rng(9)
    if name == "two islands":
        burnable = np.ones((9, 13), bool)
        burnable[:, 5] = False
        return SpreadNetwork(random.random((8, 9, 13)).astype(np.float32), burnable=burnable)
    shape = {"one cell": (1, 1), "one row": (1, 9), "one column": (8, 1), "nothing burns": (6, 7)}[name]
    burnable = np.full(shape, name != "nothing burns")
    return SpreadNetwork(random.random((8, *shape)).astype(np.float32), burnable=burnable)


def draws(method: str, network: SpreadNetwork) -> bool:
    """Whether the method's result depends on the seed."""
    return bool((rank(network, method, seed=0).values != rank(network, method, seed=1).values).any())


def mean_order(method: str, network: SpreadNetwork, symmetry: tuple[bool, int] | None = None) -> np.ndarray:
    """Cell's place in the order of cutting for many seeds, (seeds, rows, cols); turned if asked."""
    places = []
    for seed in range(DRAWS):
        priority = rank(network, method, seed=seed).values
        order = np.empty(priority.size)
        order[np.argsort(-priority.ravel(), kind="stable")] = np.arange(priority.size)
        place = order.reshape(priority.shape)
        places.append(place if symmetry is None else twin.turn(place, symmetry))
    return np.array(places)


def quality(method: str, network: SpreadNetwork) -> float:
    """Mean burnt share over budgets up to a half."""
    priority = rank(network, method)
    burnt = burn_curve(network, priority, budgets=np.linspace(0.02, 0.5, 25), n_runs=400, seed=1)
    return float(burnt.mean()) / network.n_burnable


def turned_alike(method: str, network: SpreadNetwork, symmetry: tuple[bool, int], seed: int) -> bool:
    """Whether the turned map gives the turned priority for one seed, as some methods that draw do."""
    got = rank(twin.turn_network(network, symmetry), method, seed=seed).values
    return np.array_equal(got, twin.turn(rank(network, method, seed=seed).values, symmetry))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_shape_type_and_unburnable_cells(method, boundary):
    network = landscape(boundary)
    priority = rank(network, method)
    assert priority.shape == network.shape
    assert priority.dtype == np.float64
    assert priority.name == "priority"
    assert np.isneginf(priority.values[~network.burnable]).all()
    assert np.isfinite(priority.values[network.burnable]).all()
    assert np.unique(priority.values[network.burnable]).size > 1


def test_inputs_are_untouched(method):
    network = landscape()
    probability, burnable = network.probability.copy(), network.burnable.copy()
    rank(network, method)
    assert (network.probability == probability).all()
    assert (network.burnable == burnable).all()


def test_same_seed_gives_the_same_bits(method):
    network = landscape()
    assert (rank(network, method, seed=5).values == rank(network, method, seed=5).values).all()


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_turned_maps_give_turned_priorities(method, boundary):
    """Cell by cell; for a method that draws, seed by seed or at least in the mean over seeds."""
    network = landscape(boundary)
    symmetries = [s for s in twin.SYMMETRIES.values() if s != (False, 0)]
    if not getattr(plugins.load("ranking", method), "UNIQUE", True):
        network = landscape(boundary, (31, 40))
        burnt = [quality(method, network), quality(method, twin.turn_network(network, (True, 1)))]
        assert max(burnt) <= 1.2 * min(burnt)
        return
    if not draws(method, network):
        expected = rank(network, method).values
        for symmetry in symmetries:
            got = rank(twin.turn_network(network, symmetry), method).values
            np.testing.assert_allclose(got, twin.turn(expected, symmetry), rtol=1e-9, atol=1e-12)
        return
    if all(turned_alike(method, network, symmetry, seed) for seed in (0, 1) for symmetry in symmetries):
        return
    symmetry = (True, 1)
    expected = mean_order(method, network, symmetry)
    got = mean_order(method, twin.turn_network(network, symmetry))
    error = np.sqrt((got.var(axis=0) + expected.var(axis=0)) / DRAWS)
    burnable = twin.turn(network.burnable, symmetry)  # the others stand last, in the order of their rows
    assert (np.abs(got.mean(axis=0) - expected.mean(axis=0))[burnable] <= 5 * error[burnable] + 1e-9).all()


@pytest.mark.parametrize("name", ["one cell", "one row", "one column", "nothing burns", "two islands"])
def test_special_maps(method, name):
    network = special(name)
    priority = rank(network, method).values
    assert priority.shape == network.shape
    assert np.isfinite(priority[network.burnable]).all()
    assert np.isneginf(priority[~network.burnable]).all()


def test_progress_reaches_the_end(method):
    calls: list[tuple[float, str]] = []
    rank(landscape(), method, progress=lambda share, text: calls.append((share, text)))
    assert calls
    assert all(0.0 <= share <= 1.0 for share, _ in calls)
    assert calls[-1][0] == 1.0
    assert all(text for _, text in calls)


def test_cancelling_passes_through(method):
    def stop(share: float, text: str) -> None:
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        rank(landscape(), method, progress=stop)


def test_description_is_plain_and_complete(method):
    description = plugins.describe("ranking", method)
    assert json.loads(json.dumps(description)) == json.loads(json.dumps(description, default=str))
    assert description["summary"].endswith(".")
    assert len(description["summary"]) <= 110
    assert "doi" in description["text"]
    assert "Cost" in description["text"]
    for entry in description["parameters"]:
        assert entry["text"]
        assert entry["units"]
        if entry["type"] in ("int", "float") and entry["default"] is not None:
            assert "minimum" in entry
        if entry["type"] == "str":
            assert entry.get("choices") or entry.get("path")


def test_parameters_are_checked(method):
    module = plugins.load("ranking", method)
    with pytest.raises(ParameterError, match="no parameter 'nonsense'"):
        plugins.build_params(module, {"nonsense": 1})
    for entry in plugins.describe("ranking", method)["parameters"]:
        if "minimum" in entry:
            with pytest.raises(ParameterError, match=entry["name"]):
                plugins.build_params(module, {entry["name"]: entry["minimum"] - 1})
        if "choices" in entry:
            for choice in entry["choices"]:
                values = plugins.build_params(module, {entry["name"]: choice})
                network = landscape()
                scores = module.rank(network, values, stakes=Stakes(network), seed=0, progress=silent)
                assert scores.shape == network.shape
