"""DomiRank: cells that dominate their neighbourhood when neighbours compete.

Gamma = sigma (I + sigma A)^-1 A 1: a cell is strong if its links are many and its neighbours weak. `competition` is
sigma as a share of the largest value for which the competition settles, 1 / |lambda_min|, lambda_min the eigenvalue
of A with the least real part; 0 is the degree. With strong competition dominant cells stand apart and spare their
neighbours, which centralities that gather in patches do not. `in` uses A transposed (how fire arrives).

Scores may be negative. They solve the equation to 1e-12 of its right side.

Cost: an eigenvalue (Arnoldi, some hundred products with the sparse matrix) and a linear solution, 10 s and more on
10^6 cells; memory about 700 B a cell. Ties fall to the cell first in (row, col).
Source: Engsig, Tejedor, Moreno, Foufoula-Georgiou, Kasmi 2024, doi 10.1038/s41467-023-44257-0.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import VerificationError
from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    import scipy.sparse

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (800, 0)

#: Cells up to which the matrix is dense for the eigenvalue, and factorised for the solution.
_DENSE, _FACTORISED = 300, 20_000
_TOLERANCE = 1e-12


@dataclass(frozen=True)
class Params:
    """Parameters of DomiRank."""

    competition: float = parameter(
        0.9,
        text="how strongly neighbours compete, as a share of the strongest competition that settles",
        minimum=0.0,
        maximum=0.999,
    )
    orientation: str = parameter(
        "in", text="whether fire arriving at the cell (in) or leaving it (out) counts", choices=("in", "out")
    )


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
) -> np.ndarray:
    """Return DomiRank, or the degree if the network has no competition to settle, (rows, cols) float64."""
    scores = np.zeros(network.shape)
    cells = np.flatnonzero(network.burnable)
    matrix = network.to_csr()[cells][:, cells]
    matrix = matrix.T.tocsr() if params.orientation == "in" else matrix.tocsr()
    degree = np.asarray(matrix.sum(axis=1)).ravel() if cells.size else np.zeros(0)
    progress(0.1, "DomiRank: least eigenvalue")
    lowest = least_eigenvalue(matrix) if degree.any() else 0.0
    values = degree
    if params.competition > 0.0 and lowest > 0.0:
        progress(0.6, "DomiRank: solution")
        values = _settled(matrix, degree, params.competition / lowest)
    scores.ravel()[cells] = values
    progress(1.0, "DomiRank done")
    return scores


def least_eigenvalue(matrix: scipy.sparse.csr_array) -> float:
    """Size of the least real part of an eigenvalue; 0 if no real part is negative."""
    from scipy.sparse.linalg import ArpackNoConvergence, eigs

    n_cells = matrix.shape[0]
    if n_cells <= _DENSE:
        return max(0.0, -float(np.linalg.eigvals(matrix.toarray()).real.min()))
    # A start of mixed signs, the same for every map: the eigenvector of the least eigenvalue alternates.
    start = np.cos(np.arange(n_cells) * 2.399963229728653)
    try:
        found = eigs(matrix, k=1, which="SR", v0=start, ncv=64, maxiter=5_000, return_eigenvectors=False)
    except ArpackNoConvergence as error:
        found = error.eigenvalues
        if found.size == 0:
            raise VerificationError(
                "the least eigenvalue of the network was not found; use another ranking, such as bonacich"
            ) from error
    return max(0.0, -float(found.real.min()))


def _settled(matrix: scipy.sparse.csr_array, degree: np.ndarray, sigma: float) -> np.ndarray:
    import scipy.sparse
    from scipy.sparse.linalg import bicgstab, splu

    system = (scipy.sparse.eye_array(matrix.shape[0]) + sigma * matrix).tocsr()
    right = sigma * degree
    if matrix.shape[0] <= _FACTORISED:
        values: np.ndarray = splu(system.tocsc()).solve(right)
    else:
        values, _ = bicgstab(system, right, x0=right, rtol=_TOLERANCE, atol=0.0, maxiter=5_000)
    left_over = float(np.linalg.norm(system @ values - right))
    if not left_over <= 100 * _TOLERANCE * float(np.linalg.norm(right)):
        raise VerificationError(
            f"DomiRank did not settle (relative error {left_over / float(np.linalg.norm(right)):.1e}); "
            "lower the competition"
        )
    return values
