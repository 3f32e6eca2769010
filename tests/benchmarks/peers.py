"""What the kernels are measured against: the same results by other means.

What a peer needs to know of the network is made once, before it is timed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse as sp
from scipy.sparse import csgraph
from scipy.sparse.linalg import LinearOperator, bicgstab, eigs

from firebreak_gis import SpreadNetwork
from firebreak_gis.kernels.percolation import steps
from firebreak_gis.lattice import COL_STEP, ROW_STEP

Burns = tuple[np.ndarray, np.ndarray]


class NumpyFrontier:
    """Fires with whole frontiers as arrays, as an expert of numpy would write them."""

    def __init__(self, network: SpreadNetwork) -> None:
        self.n_cells = network.burnable.size
        self.offsets = steps(network.shape, periodic=False).offsets[0].astype(np.int64)
        self.probability = np.ascontiguousarray(network.probability.reshape(8, self.n_cells).T)

    def __call__(self, starts: np.ndarray) -> Burns:
        """Return how often each cell burns, and the size of every fire."""
        rng = np.random.default_rng(1)
        counts, sizes = np.zeros(self.n_cells, np.uint32), np.zeros(starts.size, np.int64)
        for run, start in enumerate(starts):
            burnt = np.zeros(self.n_cells, bool)
            frontier = np.array([start])
            burnt[start] = True
            while frontier.size:
                draws = rng.random((frontier.size, 8), dtype=np.float32)
                source, d = np.nonzero(draws < self.probability[frontier])
                lit = frontier[source] + self.offsets[d]
                frontier = np.unique(lit[~burnt[lit]])
                burnt[frontier] = True
            counts += burnt
            sizes[run] = np.count_nonzero(burnt)
        return counts, sizes


class MaskAndCsgraph:
    """Fires by drawing all edges and searching the open ones with scipy."""

    def __init__(self, network: SpreadNetwork) -> None:
        self.matrix = network.to_csr()
        self.probability = self.matrix.data.astype(np.float32)
        self.matrix.indices = self.matrix.indices.astype(np.int32)
        self.rows = np.repeat(np.arange(self.matrix.shape[0], dtype=np.int32), np.diff(self.matrix.indptr))

    def __call__(self, starts: np.ndarray) -> Burns:
        """Return how often each cell burns, and the size of every fire."""
        rng = np.random.default_rng(1)
        n_cells = self.matrix.shape[0]
        counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(starts.size, np.int64)
        for run, start in enumerate(starts):
            is_open = rng.random(self.matrix.nnz, dtype=np.float32) < self.probability
            degree = np.bincount(self.rows[is_open], minlength=n_cells)
            pointer = np.concatenate([[0], np.cumsum(degree)]).astype(np.int32)
            target = self.matrix.indices[is_open]
            graph = sp.csr_array((np.ones(target.size, np.int8), target, pointer), shape=self.matrix.shape)
            reached = csgraph.breadth_first_order(graph, int(start), return_predecessors=False)
            counts[reached] += 1
            sizes[run] = reached.size
        return counts, sizes


class MaskAndDijkstra(MaskAndCsgraph):
    """Fires with a clock by drawing all edges and searching the open ones with scipy."""

    def __init__(self, network: SpreadNetwork, limit: float) -> None:
        super().__init__(network)
        cells, cols = network.burnable.size, network.shape[1]
        step = self.matrix.indices - self.rows
        directions = {r * cols + c: d for d, (r, c) in enumerate(zip(ROW_STEP, COL_STEP, strict=True))}
        direction = np.vectorize(directions.get)(np.unique(step))[np.unique(step, return_inverse=True)[1]]
        assert network.travel_time is not None
        self.seconds = network.travel_time.reshape(8, cells)[direction, self.rows].astype(np.float64)
        self.limit = limit

    def open_edges(self, run: int) -> sp.csr_array:
        """Graph of the open edges of a run, in seconds."""
        n_cells = self.matrix.shape[0]
        is_open = np.random.default_rng(run).random(self.matrix.nnz, dtype=np.float32) < self.probability
        degree = np.bincount(self.rows[is_open], minlength=n_cells)
        pointer = np.concatenate([[0], np.cumsum(degree)]).astype(np.int32)
        return sp.csr_array((self.seconds[is_open], self.matrix.indices[is_open], pointer), shape=self.matrix.shape)

    def search(self, graph: sp.csr_array, start: int) -> int:
        """Cells reached in time."""
        return int(np.isfinite(csgraph.dijkstra(graph, indices=start, limit=self.limit)).sum())

    def __call__(self, starts: np.ndarray) -> np.ndarray:
        """Size of every fire."""
        return np.array([self.search(self.open_edges(run), int(start)) for run, start in enumerate(starts)])


def lengths(network: SpreadNetwork) -> sp.coo_array:
    """Edge lengths as the kernels round them."""
    from firebreak_gis.kernels.paths import edge_lengths

    matrix = network.to_csr()
    matrix.data = edge_lengths(matrix.data.astype(np.float32)).astype(float)
    return matrix.tocoo()


def igraph_graph(network: SpreadNetwork) -> Any:
    """The network in igraph."""
    import igraph

    matrix = lengths(network)
    edges = np.column_stack(matrix.coords).tolist()
    return igraph.Graph(n=matrix.shape[0], edges=edges, directed=True, edge_attrs={"length": matrix.data.tolist()})


def networkit_graph(network: SpreadNetwork) -> Any:
    """The network in networkit, which then uses one thread."""
    import networkit

    networkit.setNumberOfThreads(1)
    matrix = lengths(network)
    return networkit.GraphFromCoo((matrix.data, matrix.coords), n=matrix.shape[0], weighted=True, directed=True)


def networkx_graph(network: SpreadNetwork) -> Any:
    """The network in networkx."""
    import networkx as nx

    matrix = lengths(network)
    graph = nx.DiGraph()
    graph.add_nodes_from(range(matrix.shape[0]))
    row, col = matrix.coords
    graph.add_weighted_edges_from(zip(row.tolist(), col.tolist(), matrix.data.tolist(), strict=True))
    return graph


def scipy_bonacich(network: SpreadNetwork, beta: float) -> np.ndarray:
    """Bonacich centrality by the book: CSR, ARPACK for the eigenvalue, BiCGSTAB for the system."""
    matrix = network.to_csr().T.tocsr()
    radius = eigs(matrix, k=1, which="LM", return_eigenvectors=False, tol=1e-9)[0].real
    degree = matrix @ np.ones(matrix.shape[0])
    system = LinearOperator(matrix.shape, matvec=lambda x: x - beta / radius * (matrix @ x))
    solution, failed = bicgstab(system, degree, rtol=1e-10)
    if failed:
        raise RuntimeError(f"bicgstab stopped with {failed}")
    return np.asarray(solution)
