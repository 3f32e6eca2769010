"""Rows about shortest paths: betweenness and closeness against graph libraries."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from firebreak_gis.kernels.centrality import betweenness, closeness, sampled_betweenness
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import Comparison, Figure, close, seconds

_PIVOTS, _PEER_PIVOTS = 16, 8


def rows(side: int, *, by_networkx: bool = False) -> Iterator[Comparison]:
    """Exact betweenness and closeness on one landscape."""
    network = fractal(side, scale=1.0)
    n_cells = network.burnable.size
    given = (network.probability, network.burnable)
    asked = n_cells >= 10_000

    def between() -> np.ndarray:
        return betweenness(*given, threads=1)

    def near() -> np.ndarray:
        return closeness(*given, threads=1)

    def near_in() -> np.ndarray:
        return closeness(*given, transpose=True, threads=1)

    if by_networkx:
        import networkx

        graph = peers.networkx_graph(network)
        yield Comparison(
            "betweenness, exact", n_cells, "networkx", between,
            lambda: np.array(list(networkx.betweenness_centrality(graph, weight="weight", normalized=False).values())),
            close, rounds=1, at_least=150.0,
        )  # fmt: skip
        if not asked:
            yield Comparison(
                "closeness", n_cells, "networkx", near_in,
                lambda: np.array(list(networkx.closeness_centrality(graph, distance="weight").values())),
                close, rounds=1,
            )  # fmt: skip
        return
    import networkit

    rounds = 3 if n_cells < 5_000 else 2
    other = peers.igraph_graph(network)
    yield Comparison(
        "betweenness, exact", n_cells, "igraph", between, lambda: other.betweenness(weights="length"), close,
        rounds=rounds, at_least=4.0 if asked else None,
    )  # fmt: skip
    yield Comparison(
        "closeness", n_cells, "igraph", near,
        lambda: other.closeness(weights="length", mode="out", normalized=True), close,
        rounds=rounds, at_least=3.0 if asked else None,
    )  # fmt: skip
    del other
    third = peers.networkit_graph(network)
    variant = networkit.centrality.ClosenessVariant.GENERALIZED
    yield Comparison(
        "betweenness, exact", n_cells, "networkit", between,
        lambda: networkit.centrality.Betweenness(third).run().scores(), close,
        rounds=rounds, at_least=5.0 if asked else None,
    )  # fmt: skip
    yield Comparison(
        "closeness", n_cells, "networkit", near,
        lambda: networkit.centrality.Closeness(third, True, variant).run().scores(), close,
        rounds=rounds, at_least=3.0 if asked else None,
    )  # fmt: skip


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
        f"betweenness, {_PIVOTS} pivots", n_cells, f"networkit, {_PEER_PIVOTS} pivots", ours, theirs, alike,
        lambda result: _PIVOTS if result.ndim == 2 else _PEER_PIVOTS, "ms/pivot", 1e3, at_least=5.0,
    )  # fmt: skip
