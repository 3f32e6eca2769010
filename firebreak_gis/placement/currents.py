"""Electric currents through a spread network: resistances and flows by a sparse factorisation.

A current has no direction, so the two edges between neighbours become one resistor whose conductance is their mean
probability, (p(l -> k) + p(k -> l)) / 2. Every part of the network that hangs together is a circuit of its own; one
cell of each is earthed, and the Laplacian of the others is factorised once (SuperLU, by way of scipy). On 10^6 cells
that takes about 8 s and 2.5 GB, and a solution 0.15 s.
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.kernels.draws import stream_key, uniforms
from firebreak_gis.progress import silent

if TYPE_CHECKING:
    import scipy.sparse

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress

#: Numbers of right sides that are solved together, about: these need 8 bytes a cell each.
_TOGETHER = 64


class Circuit:
    """The burnable cells of a network as one or more circuits of resistors.

    Parameters
    ----------
    network
        The spread network.

    Attributes
    ----------
    first, second : numpy.ndarray
        Ends of every resistor as positions among the burnable cells, first < second.
    conductance : numpy.ndarray
        Mean probability of the two edges.
    part : numpy.ndarray
        Circuit that each burnable cell belongs to.
    size : numpy.ndarray
        Cells of each circuit.
    """

    def __init__(self, network: SpreadNetwork) -> None:
        import scipy.sparse
        from scipy.sparse.csgraph import connected_components

        cells = np.flatnonzero(network.burnable)
        directed = network.to_csr()[cells][:, cells]
        mutual = (0.5 * (directed + directed.T)).tocsr()
        mutual.sum_duplicates()
        mutual.sort_indices()
        upper = scipy.sparse.triu(mutual, k=1).tocoo()
        self.n_cells = cells.size
        self.first, self.second, self.conductance = upper.row, upper.col, upper.data
        self._mutual = mutual
        self.part: np.ndarray = np.empty(0, np.int32)
        n_parts = 0
        if cells.size:
            n_parts, self.part = connected_components(mutual)
        self.size = np.bincount(self.part, minlength=n_parts)

    @cached_property
    def _earthed(self) -> tuple[np.ndarray, scipy.sparse.linalg.SuperLU | None]:
        """Cells that are not earthed, and the factors of their Laplacian."""
        import scipy.sparse
        import scipy.sparse.linalg

        _, earth = np.unique(self.part, return_index=True)
        kept = np.setdiff1d(np.arange(self.n_cells), earth)
        if kept.size == 0:
            return kept, None
        laplacian = scipy.sparse.diags_array(np.asarray(self._mutual.sum(axis=1)).ravel()) - self._mutual
        inner = laplacian.tocsr()[kept][:, kept].tocsc()
        # The matrix is symmetric and dominated by its diagonal: no pivoting is needed, and little fill arises.
        factors = scipy.sparse.linalg.splu(
            inner, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
        )
        return kept, factors

    def potentials(self, currents: np.ndarray) -> np.ndarray:
        """Potentials for currents fed into the cells; earthed cells have 0.

        Parameters
        ----------
        currents
            (n_cells, k) float64; the sum over each circuit flows off at its earth.

        Returns
        -------
        numpy.ndarray
            (n_cells, k) float64.
        """
        kept, factors = self._earthed
        result = np.zeros(currents.shape)
        if factors is not None:
            result[kept] = factors.solve(np.ascontiguousarray(currents[kept]))
        return result

    def rows(self, cells: np.ndarray) -> np.ndarray:
        """Potentials of all cells for a unit current into each of `cells`, (cells, n_cells)."""
        currents = np.zeros((self.n_cells, cells.size))
        currents[cells, np.arange(cells.size)] = 1.0
        return self.potentials(currents).T

    def centred(self, potentials: np.ndarray) -> np.ndarray:
        """Potentials less their mean over each circuit, (n_cells, k)."""
        result = potentials.copy()
        for k in range(result.shape[1]):
            mean = np.bincount(self.part, result[:, k], minlength=self.size.size) / np.maximum(self.size, 1)
            result[:, k] -= mean[self.part]
        return result


def resistance_sums(circuit: Circuit, *, probes: int = 0, seed: int = 0, progress: Progress = silent) -> np.ndarray:
    """Sum over the cells of its circuit of the effective resistance between a cell and each of them.

    Parameters
    ----------
    circuit
        The circuits.
    probes
        0: exact, one solution a cell. Else the diagonal of the pseudo-inverse is estimated from so many random
        signs on the resistors (Spielman, Srivastava 2011, doi 10.1137/080734029); the standard error of each entry
        is sqrt(2 / probes) of it.
    seed
        Of the signs (purpose "ranking").
    progress
        Callback.

    Returns
    -------
    numpy.ndarray
        (n_cells,) float64: n L+_ii + trace(L+), L+ the pseudo-inverse of the circuit's Laplacian and n its cells.
    """
    n_cells = circuit.n_cells
    diagonal = np.zeros(n_cells)
    if probes == 0:
        # With the inverse G of the earthed Laplacian: r_ij = G_ii + G_jj - 2 G_ij.
        row_sums = circuit.potentials(np.ones((n_cells, 1)))[:, 0]
        for start in range(0, n_cells, _TOGETHER):
            some = np.arange(start, min(start + _TOGETHER, n_cells))
            diagonal[some] = circuit.rows(some)[np.arange(some.size), some]
            progress((start + some.size) / n_cells, f"{start + some.size} of {n_cells} cells")
        return _per_part(circuit, diagonal) - 2.0 * row_sums
    root = np.sqrt(circuit.conductance)
    key = stream_key(seed, "ranking")
    for probe in range(probes):
        signs = np.where(uniforms(key, root.size, start=probe * root.size) < 0.5, -root, root)
        currents = np.zeros((n_cells, 1))
        currents[:, 0] = np.bincount(circuit.first, signs, minlength=n_cells)
        currents[:, 0] -= np.bincount(circuit.second, signs, minlength=n_cells)
        diagonal += circuit.centred(circuit.potentials(currents))[:, 0] ** 2
        progress((probe + 1) / probes, f"probe {probe + 1} of {probes}")
    return _per_part(circuit, diagonal / probes)


def _per_part(circuit: Circuit, diagonal: np.ndarray) -> np.ndarray:
    """For each cell of a circuit of n: n times its own entry and the sum of all entries."""
    sums = np.bincount(circuit.part, diagonal, minlength=circuit.size.size)
    result: np.ndarray = circuit.size[circuit.part] * diagonal + sums[circuit.part]
    return result


def throughput(circuit: Circuit, *, progress: Progress = silent) -> np.ndarray:
    """Current that passes through each cell, summed over all unordered pairs of other cells of its circuit.

    For each pair one unit flows from one cell to the other; what passes a cell is half of what flows in its resistors
    (Newman 2005, doi 10.1016/j.socnet.2004.11.009; Brandes, Fleischer 2005, doi 10.1007/978-3-540-31856-9_44).

    Cost: a solution a cell and a sort of n numbers a resistor; memory 16 B a cell and cell of a band of the grid.
    """
    n_cells = circuit.n_cells
    total = np.zeros(n_cells)
    known: dict[int, np.ndarray] = {}
    weight = 2.0 * np.arange(n_cells) - (n_cells - 1)
    order = np.argsort(circuit.first, kind="stable")
    ends = np.searchsorted(circuit.first[order], np.arange(n_cells + 1))
    uses = np.zeros(n_cells, dtype=np.int64)
    np.maximum.at(uses, circuit.second, circuit.first)
    np.maximum.at(uses, circuit.first, circuit.first)
    for cell in range(n_cells):
        mine = order[ends[cell] : ends[cell + 1]]
        missing = [c for c in {cell, *circuit.second[mine].tolist()} if c not in known]
        if missing and mine.size:
            # Rows are used by cells close to each other in the order of the grid: solve some ahead.
            ahead = range(max(missing) + 1, min(max(missing) + 1 + _TOGETHER, n_cells))
            wanted = np.array(sorted({*missing, *(c for c in ahead if c not in known)}))
            known.update(zip(wanted.tolist(), circuit.rows(wanted), strict=True))
        same = circuit.part == circuit.part[cell]
        for edge in mine.tolist():
            other = int(circuit.second[edge])
            drops = np.sort(circuit.conductance[edge] * (known[cell] - known[other])[same])
            m = drops.size
            flow = float((weight[:m] + (n_cells - m)) @ drops)  # sum over pairs of |difference|
            total[cell] += 0.5 * flow
            total[other] += 0.5 * flow
        for old in [c for c in known if uses[c] <= cell and c <= cell]:
            del known[old]
        progress((cell + 1) / n_cells, f"{cell + 1} of {n_cells} cells")
    # A pair that ends in the cell itself has one unit in its resistors, half of which was counted.
    passing: np.ndarray = np.maximum(total - 0.5 * (circuit.size[circuit.part] - 1), 0.0)
    return passing


def sampled_throughput(circuit: Circuit, *, pairs: int, seed: int, progress: Progress = silent) -> np.ndarray:
    """Estimate `throughput` from random pairs of cells, as a share of all pairs of burnable cells.

    What one pair sends through a cell lies between 0 and 1, so with probability 1 - delta no cell is off by more than
    sqrt(log(2 n / delta) / (2 pairs)), see `sampling_error` (Hoeffding 1963, doi 10.1080/01621459.1963.10500830).
    """
    n_cells = circuit.n_cells
    total = np.zeros(n_cells)
    if n_cells < 3:
        return total
    chosen = (uniforms(stream_key(seed, "ranking"), 2 * pairs) * np.tile([n_cells, n_cells - 1], pairs)).astype(
        np.int64
    )
    sources, targets = chosen[0::2], chosen[1::2]
    targets = targets + (targets >= sources)
    step = max(1, min(8, 4_000_000 // n_cells))
    for start in range(0, pairs, step):
        s, t = sources[start : start + step], targets[start : start + step]
        together = circuit.part[s] == circuit.part[t]
        s, t = s[together], t[together]
        currents = np.zeros((n_cells, s.size))
        currents[s, np.arange(s.size)] = 1.0
        currents[t, np.arange(s.size)] -= 1.0
        potentials = circuit.potentials(currents)
        for k in range(s.size):
            x = potentials[:, k]
            flow = circuit.conductance * np.abs(x[circuit.first] - x[circuit.second])
            passing = np.bincount(circuit.first, flow, n_cells) + np.bincount(circuit.second, flow, n_cells)
            passing[[s[k], t[k]]] = 0.0
            total += 0.5 * passing
        progress(min(1.0, (start + step) / pairs), f"{min(start + step, pairs)} of {pairs} pairs")
    return total / pairs


def sampling_error(n_cells: int, pairs: int, delta: float = 0.1) -> float:
    """Error of `sampled_throughput` that no cell exceeds with probability 1 - delta, as a share of all pairs."""
    return math.sqrt(math.log(2.0 * max(n_cells, 1) / delta) / (2.0 * pairs))
