"""Rows about the rankings by currents, percolation, PageRank and DomiRank, against networkx and dense matrices.

networkx has no group betweenness that is built cell by cell, so `group_betweenness` has no row.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import networkx as nx
import numpy as np

from firebreak_gis import rank
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


def _alike(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two scores agree up to a common factor: some count pairs once and some twice."""
    return close(one / np.abs(one).max(), other / np.abs(other).max(), 1e-6)
