"""Rows about the rankings by currents, percolation, PageRank, DomiRank and groups, against networkx and dense matrices.

networkx does not build a group cell by cell; it tells the betweenness of given groups, so `group_betweenness` has a row
about the first choice, the gain of every cell in an empty group.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import networkx as nx
import numpy as np

from firebreak_gis import rank
from firebreak_gis.kernels.groups import uncovered
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import Comparison, close, threads
from tests.twins import centrality as twin


def rows(side: int) -> Iterator[Comparison]:
    """Exact rankings of a landscape whose cells all hold fuel."""
    network = fractal(side, scale=1.0)
    n = network.n_burnable
    currents = nx.Graph()
    weights = twin.conductances(network)
    currents.add_weighted_edges_from(
        (int(a), int(b), float(weights[a, b])) for a, b in np.argwhere(np.triu(weights, 1))
    )
    graph = network.to_networkx()

    def told(found: dict[object, float], cells: list[object], factor: float = 1.0) -> np.ndarray:
        return factor * np.array([found[cell] for cell in cells])

    plain: list[object] = list(range(n))
    pairs: list[object] = [(int(row), int(col)) for row, col in np.argwhere(network.burnable)]
    peers: dict[str, tuple[str, Callable[[], np.ndarray]]] = {
        "information": (
            "networkx",
            lambda: told(nx.current_flow_closeness_centrality(currents, weight="weight"), plain, n - 1.0),
        ),
        "current_flow": (
            "networkx",
            lambda: told(nx.current_flow_betweenness_centrality(currents, weight="weight"), plain),
        ),
        "percolation": (
            "networkx",
            lambda: told(nx.percolation_centrality(graph, states=dict.fromkeys(graph, 0.5), weight="length"), pairs),
        ),
        "pagerank": (
            "networkx",
            lambda: told(nx.pagerank(graph, alpha=0.85, weight="probability", tol=1e-14, max_iter=1000), pairs),
        ),
        "domirank": ("dense numpy", lambda: twin.domirank(network, 0.95, "in").ravel()),
    }
    given = {"pagerank": {"damping": 0.85}, "domirank": {"competition": 0.95}}
    for name, (peer, theirs) in peers.items():

        def ours(name: str = name) -> np.ndarray:
            with threads(1):
                return np.asarray(rank(network, name, **given.get(name, {})).to_numpy()).ravel()

        yield Comparison(name, n, peer, ours, theirs, _alike, rounds=1)


def pagerank(side: int) -> Iterator[Comparison]:
    """PageRank of a larger landscape: on a small one finding the ranking takes longer than making it."""
    network = fractal(side, scale=1.0)
    graph = network.to_networkx()
    cells = [(int(row), int(col)) for row, col in np.argwhere(network.burnable)]

    def ours() -> np.ndarray:
        with threads(1):
            return np.asarray(rank(network, "pagerank", damping=0.85).to_numpy()).ravel()

    def theirs() -> np.ndarray:
        told = nx.pagerank(graph, alpha=0.85, weight="probability", tol=1e-14, max_iter=1000)
        return np.array([told[cell] for cell in cells])

    yield Comparison("pagerank", network.n_burnable, "networkx", ours, theirs, _alike, rounds=3)


def groups(side: int) -> Iterator[Comparison]:
    """What each cell adds to an empty group, which is what every round of `group_betweenness` asks of a larger one."""
    network = fractal(side, scale=1.0)
    graph = network.to_networkx()
    cells = [(int(row), int(col)) for row, col in np.argwhere(network.burnable)]
    nobody = np.zeros(network.shape, bool)

    def ours() -> np.ndarray:
        routes = uncovered(network.probability, network.burnable, threads=1)
        return routes.gains(nobody).ravel()

    def theirs() -> np.ndarray:
        told = nx.group_betweenness_centrality(graph, [[cell] for cell in cells], normalized=False, weight="length")
        return np.array(told)

    yield Comparison("gains of group_betweenness", network.n_burnable, "networkx", ours, theirs, _alike, rounds=1)


def _alike(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two scores agree up to a common factor: some count pairs once and some twice."""
    return close(one / np.abs(one).max(), other / np.abs(other).max(), 1e-6)
