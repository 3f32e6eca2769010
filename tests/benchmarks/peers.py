"""What the kernels are measured against: the same results by other means."""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy.sparse as sp
from scipy.sparse import csgraph
from scipy.sparse.linalg import LinearOperator, bicgstab, eigs

from firebreak_gis import SpreadNetwork
from firebreak_gis.kernels.percolation import steps


def numpy_frontier(network: SpreadNetwork, starts: np.ndarray, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Burn runs with whole frontiers as arrays, as an expert of numpy would; returns counts and sizes."""
    rng = np.random.default_rng(seed)
    n_cells = network.burnable.size
    offsets = steps(network.shape, periodic=False).offsets[0].astype(np.int64)
    probability = np.ascontiguousarray(network.probability.reshape(8, n_cells).T)
    counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(starts.size, np.int64)
    for run, start in enumerate(starts):
        burnt = np.zeros(n_cells, bool)
        frontier = np.array([start])
        burnt[start] = True
        while frontier.size:
            source, d = np.nonzero(rng.random((frontier.size, 8), dtype=np.float32) < probability[frontier])
            lit = frontier[source] + offsets[d]
            frontier = np.unique(lit[~burnt[lit]])
            burnt[frontier] = True
        counts += burnt
        sizes[run] = burnt.sum()
    return counts, sizes


def mask_and_csgraph(network: SpreadNetwork, starts: np.ndarray, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Burn runs by drawing all edges and searching the open ones with scipy; returns counts and sizes."""
    rng = np.random.default_rng(seed)
    n_cells = network.burnable.size
    matrix = network.to_csr()
    counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(starts.size, np.int64)
    rows = np.repeat(np.arange(n_cells), np.diff(matrix.indptr))
    for run, start in enumerate(starts):
        open_ = rng.random(matrix.nnz) < matrix.data
        pointer = np.concatenate([[0], np.cumsum(np.bincount(rows[open_], minlength=n_cells))])
        graph = sp.csr_array((np.ones(int(open_.sum()), np.int8), matrix.indices[open_], pointer), shape=matrix.shape)
        reached = csgraph.breadth_first_order(graph, int(start), return_predecessors=False)
        counts[reached] += 1
        sizes[run] = reached.size
    return counts, sizes


def lengths(network: SpreadNetwork) -> sp.csr_array:
    """Edge lengths as the kernels round them."""
    from firebreak_gis.kernels.paths import edge_lengths

    matrix = network.to_csr()
    matrix.data = edge_lengths(matrix.data.astype(np.float32)).astype(float)
    return matrix


def igraph_graph(network: SpreadNetwork) -> Any:
    """The network in igraph."""
    import igraph

    matrix = lengths(network).tocoo()
    edges = np.column_stack(matrix.coords).tolist()
    return igraph.Graph(n=matrix.shape[0], edges=edges, directed=True, edge_attrs={"length": matrix.data.tolist()})


def networkit_graph(network: SpreadNetwork) -> Any:
    """The network in networkit."""
    import networkit

    matrix = lengths(network).tocoo()
    row, col = matrix.coords
    return networkit.GraphFromCoo((matrix.data, (row, col)), n=matrix.shape[0], weighted=True, directed=True)


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
