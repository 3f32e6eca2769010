"""Rankings that are found anew after every few cuts, against removing cell by cell."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis.breaks import removal_order
from firebreak_gis.errors import Cancelled
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.placement.rounds import in_rounds
from firebreak_gis.progress import silent
from firebreak_gis.ranking import rank
from firebreak_gis.stakes import Stakes, with_barriers
from tests.twins import centrality as twin

METHODS = ["bonacich", "betweenness"]


def case(seed: int, boundary: str = "open", shape: tuple[int, int] = (7, 9)):
    random = np.random.default_rng(seed)
    probability = (0.05 + 0.9 * random.random((8, *shape))).astype(np.float32)
    network = SpreadNetwork(probability, burnable=random.random(shape) > 0.15, boundary=boundary)
    return network, Stakes(network, cost=random.integers(1, 4, shape), protected=random.random(shape) < 0.1)


def removed_one_by_one(network, stakes, method, count):
    """The first cells to go, ranking the network afresh for each."""
    gone = []
    cut = np.zeros(network.shape, bool)
    for _ in range(count):
        left = with_barriers(network, cut)
        scores = rank(left, method, stakes=Stakes(left, protected=stakes.protected & left.burnable)).values
        gone.append(int(np.argmax(scores)))
        cut.ravel()[gone[-1]] = True
    return gone


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("method", METHODS)
def test_the_order_is_that_of_removing_one_cell_after_another(method, boundary):
    network, stakes = case(1, boundary)
    priority = rank(network, method, stakes=stakes, recompute_every=1e-9, until=1.0).values
    gone = removed_one_by_one(network, stakes, method, 20)
    assert np.argsort(-priority.ravel(), kind="stable")[:20].tolist() == gone


@pytest.mark.parametrize("method", METHODS)
def test_until_and_never_keep_the_last_scores(method):
    network, stakes = case(2)
    plain = rank(network, method, stakes=stakes).values
    assert (removal_order(plain) == removal_order(rank(network, method, stakes=stakes, recompute_every=0.0))).all()
    once = rank(network, method, stakes=stakes, recompute_every=1.0, until=1.0)
    assert (removal_order(once) == removal_order(plain)).all()
    stopped = rank(network, method, stakes=stakes, recompute_every=1e-9, until=1e-6).values
    first = removed_one_by_one(network, stakes, method, 1)[0]
    cut = np.zeros(network.shape, bool)
    cut.ravel()[first] = True
    left = with_barriers(network, cut)
    rest = rank(left, method, stakes=Stakes(left, protected=stakes.protected & left.burnable)).values
    order = np.argsort(-rest, axis=None, kind="stable")
    expected = [first, *order[: int(np.isfinite(rest).sum())].tolist()]
    assert np.argsort(-stopped.ravel(), kind="stable")[: len(expected)].tolist() == expected


@pytest.mark.parametrize("method", METHODS)
def test_turned_maps_give_turned_orders(method):
    network, _ = case(3)
    expected = rank(network, method, recompute_every=0.05).values
    got = rank(twin.turn_network(network, (True, 1)), method, recompute_every=0.05).values
    assert (got == twin.turn(expected, (True, 1))).all()


def test_as_much_is_cut_a_round_as_its_share_buys():
    network, stakes = case(4, shape=(12, 17))
    left = []

    def scores(alive, progress):
        left.append(float(stakes.cost.ravel()[alive].sum()))
        return np.arange(alive.size, dtype=float)

    in_rounds(network, stakes, scores, recompute_every=0.1, until=0.5, progress=silent)
    share = -np.diff(left) / stakes.cost.sum()
    assert (share <= 0.1).all()
    assert (share > 0.1 - 3 / stakes.cost.sum()).all()
    assert left[-1] <= 0.5 * left[0]


@pytest.mark.parametrize("method", METHODS)
def test_progress_rises_and_cancelling_passes_through(method):
    network, stakes = case(5)
    shares: list[float] = []
    rank(network, method, stakes=stakes, recompute_every=0.05, progress=lambda share, text: shares.append(share))
    assert (np.diff(shares) >= -1e-12).all()

    def stop(share: float, text: str) -> None:
        if share > 0.3:
            raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        rank(network, method, stakes=stakes, recompute_every=0.05, progress=stop)
