"""Rows about shortest paths: betweenness and closeness against graph libraries."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from firebreak_gis.kernels.centrality import betweenness, closeness, sampled_betweenness
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import Comparison, Figure, close, seconds

_PIVOTS, _PEER_PIVOTS = 16, 8


class _Ours:
    """Centralities of one network on one thread."""

    def __init__(self, side: int) -> None:
        self.network = fractal(side, scale=1.0)
        self.cells = self.network.burnable.size
        #: The demands are for landscapes of at least so many cells.
        self.asked = self.cells >= 10_000
        self.rounds = 3 if self.cells < 5_000 else 2

    def betweenness(self) -> np.ndarray:
        return betweenness(self.network.probability, self.network.burnable, threads=1)

    def closeness(self) -> np.ndarray:
        """Closeness by the distances from a cell."""
        return closeness(self.network.probability, self.network.burnable, threads=1)

    def closeness_to(self) -> np.ndarray:
        """Closeness by the distances to a cell."""
        return closeness(self.network.probability, self.network.burnable, transpose=True, threads=1)


def rows(side: int) -> Iterator[Comparison]:
    """Exact betweenness and closeness against igraph and networkit."""
    ours = _Ours(side)
    yield from _against_igraph(ours)
    yield from _against_networkit(ours)


def _against_igraph(ours: _Ours) -> Iterator[Comparison]:
    graph = peers.igraph_graph(ours.network)
    yield Comparison(
        "betweenness, exact",
        ours.cells,
        "igraph",
        ours.betweenness,
        lambda: graph.betweenness(weights="length"),
        close,
        rounds=ours.rounds,
        at_least=4.0 if ours.asked else None,
    )
    yield Comparison(
        "closeness",
        ours.cells,
        "igraph",
        ours.closeness,
        lambda: graph.closeness(weights="length", mode="out", normalized=True),
        close,
        rounds=ours.rounds,
        at_least=3.0 if ours.asked else None,
    )


def _against_networkit(ours: _Ours) -> Iterator[Comparison]:
    from networkit.centrality import Betweenness, Closeness, ClosenessVariant

    graph = peers.networkit_graph(ours.network)
    yield Comparison(
        "betweenness, exact",
        ours.cells,
        "networkit",
        ours.betweenness,
        lambda: Betweenness(graph).run().scores(),
        close,
        rounds=ours.rounds,
        at_least=5.0 if ours.asked else None,
    )
    yield Comparison(
        "closeness",
        ours.cells,
        "networkit",
        ours.closeness,
        lambda: Closeness(graph, True, ClosenessVariant.GENERALIZED).run().scores(),
        close,
        rounds=ours.rounds,
        at_least=3.0 if ours.asked else None,
    )


def networkx_rows(side: int) -> Iterator[Comparison]:
    """Against networkx, where a quarter of an hour passes on 10,000 cells."""
    import networkx as nx

    ours = _Ours(side)
    graph = peers.networkx_graph(ours.network)
    yield Comparison(
        "betweenness, exact",
        ours.cells,
        "networkx",
        ours.betweenness,
        lambda: list(nx.betweenness_centrality(graph, weight="weight", normalized=False).values()),
        close,
        rounds=1,
        at_least=150.0,
    )
    if not ours.asked:
        yield Comparison(
            "closeness",
            ours.cells,
            "networkx",
            ours.closeness_to,
            lambda: list(nx.closeness_centrality(graph, distance="weight").values()),
            close,
            rounds=1,
        )


def sampled_rows(side: int) -> Iterator[Comparison | Figure]:
    """Betweenness from a sample of sources."""
    import networkit

    network = fractal(side, scale=1.0)
    n_cells = network.burnable.size

    def ours() -> np.ndarray:
        return sampled_betweenness(network.probability, network.burnable, pivots=_PIVOTS, threads=1).values

    yield Figure(
        "betweenness, a pivot", n_cells, 1e3 * seconds(ours) / _PIVOTS, "ms", at_most=110.0 if side >= 1000 else None
    )
    graph = peers.networkit_graph(network)

    def theirs() -> np.ndarray:
        return np.array(networkit.centrality.EstimateBetweenness(graph, _PEER_PIVOTS).run().scores())

    def alike(a: np.ndarray, b: np.ndarray) -> bool:
        """Other sources, so only the sum over all cells, the mean number of cells between two, is alike."""
        return bool(abs(np.log(a.sum() / b.sum())) < 0.4)

    yield Comparison(
        f"betweenness, {_PIVOTS} pivots",
        n_cells,
        f"networkit, {_PEER_PIVOTS} pivots",
        ours,
        theirs,
        alike,
        lambda result: _PIVOTS if result.ndim == 2 else _PEER_PIVOTS,
        "ms/pivot",
        1e3,
        at_least=5.0,
    )
