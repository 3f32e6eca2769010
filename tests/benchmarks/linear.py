"""Rows about linear algebra: the stencil, the bandwidth of the memory, and Bonacich centrality."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
from numba import njit

from firebreak_gis import rank
from firebreak_gis.kernels.linear import Operator
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal
from tests.benchmarks.measuring import Comparison, Figure, close, threads

#: Bytes that a cell of the stencil, and an element of the triad, must move.
STENCIL_BYTES, TRIAD_BYTES = 48, 24


@njit(nogil=True)
def triad(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> None:
    """STREAM's triad (McCalpin 1995)."""
    for i in range(a.size):
        a[i] = b[i] + 3.0 * c[i]


def stencil_rows(side: int) -> Iterator[Comparison]:
    """y = A x against scipy's product, which has one thread; with one thread and with two."""
    network = fractal(side, scale=1.0)
    x = np.random.default_rng(0).random(network.shape)
    out = np.empty(network.shape)
    matrix = network.to_csr()
    # In a row, as a solver makes them: caches and clock rate take some milliseconds to settle after the other side.
    times = max(1, 40_000_000 // x.size)

    def theirs() -> np.ndarray:
        for _ in range(times):
            product = matrix @ x.ravel()
        return np.asarray(product)

    for n_threads in (1, 2) if side >= 1000 else (1,):
        with Operator(network.probability, threads=n_threads) as operator:

            def ours(operator: Operator = operator) -> np.ndarray:
                for _ in range(times):
                    operator.apply(x, out)
                return out

            yield Comparison(
                "product A x",
                x.size,
                "scipy CSR, one thread",
                ours,
                theirs,
                close,
                lambda _: times,
                "ms",
                1e3,
                rounds=15,
                at_least=4.0,
                threads=n_threads,
            )


def bandwidth_row(side: int, *, transpose: bool) -> Iterator[Figure]:
    """Bytes a second of the stencil as a share of the triad's, both on one thread, in turn."""
    network = fractal(side, scale=1.0)
    x, out = np.ones(network.shape), np.empty(network.shape)
    a, b, c = (np.ones(20_000_000) for _ in range(3))
    triad(a, b, c)
    shares = []
    with Operator(network.probability, transpose=transpose, threads=1) as operator:
        operator.apply(x, out)
        for _ in range(9):
            times = []
            for work in (lambda: operator.apply(x, out), lambda: triad(a, b, c)):
                started = time.process_time()
                for _ in range(3):
                    work()
                times.append(time.process_time() - started)
            shares.append(STENCIL_BYTES * x.size / times[0] / (TRIAD_BYTES * a.size / times[1]))
    name = "product A'x" if transpose else "product A x"
    share = 100.0 * float(np.median(shares))
    yield Figure(f"{name}, share of the STREAM triad", x.size, share, "%", at_least=75.0)


def bonacich_rows(side: int) -> Iterator[Comparison]:
    """Bonacich centrality with beta 0.9, the eigenvalue included."""
    network = fractal(side, scale=1.0)

    def ours() -> np.ndarray:
        with threads(1):
            return rank(network, "bonacich", beta=0.9).to_numpy()

    yield Comparison(
        "Bonacich, beta 0.9",
        network.burnable.size,
        "scipy ARPACK + BiCGSTAB",
        ours,
        lambda: peers.scipy_bonacich(network, 0.9),
        lambda a, b: close(a, b, 1e-6),
        rounds=1,
        at_least=20.0 if side >= 3000 else None,
    )
