"""Measure the kernels against their peers, in one process, interleaved: `python -m tests.benchmarks.run`.

Every row is checked before it is timed: both sides must give the same result (fires: the same mean size within its
error). Times are medians; what counts is the ratio, since both sides meet the same machine at the same time.
"""

from __future__ import annotations

import argparse
import os
import platform
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from firebreak_gis import SpreadNetwork, rank
from firebreak_gis.kernels import draws, lanes, percolation
from firebreak_gis.kernels.centrality import betweenness, closeness, sampled_betweenness
from firebreak_gis.kernels.linear import Operator
from tests.benchmarks import peers
from tests.benchmarks.landscapes import fractal

RUNS = 64


@dataclass
class Row:
    """One comparison: what, how large, ours, the peer's, and whether they agree."""

    what: str
    cells: int
    peer: str
    ours: Callable[[], object]
    theirs: Callable[[], object]
    agree: Callable[[object, object], bool]
    repeats: int = 5
    at_least: float | None = None


def fires(network: SpreadNetwork, middle: bool) -> tuple[tuple[object, ...], np.ndarray]:
    """Arguments of the fire kernels, and the ignition of each run."""
    n_cells = network.burnable.size
    rows, cols = network.shape
    starts = np.full(RUNS, rows // 2 * cols + cols // 2)
    if not middle:
        starts = np.random.default_rng(0).integers(0, n_cells, RUNS)
    grid_steps = percolation.steps(network.shape, periodic=False)
    keys = draws.run_keys(0, "edges", RUNS)
    return (draws.thresholds(network.probability), keys, grid_steps, np.arange(RUNS + 1), starts), starts


def burn_rows(side: int) -> Iterator[Row]:
    """Fires: 64 at once against one by one and against numpy; curves against plain runs."""
    network = fractal(side)
    n_cells = network.burnable.size
    state = lanes.lanes(network.shape)
    repeats = 5 if side <= 300 else 3

    def same(a: object, b: object) -> bool:
        return all(bool((x == y).all()) for x, y in zip(a, b, strict=True))

    def alike(a: object, b: object) -> bool:
        ours, theirs = a[1], b[1]
        error = np.sqrt(ours.var() / ours.size + theirs.var() / theirs.size)
        return bool(abs(ours.mean() - theirs.mean()) <= 4 * error + 0.02 * n_cells)

    for middle in (True, False):
        given, starts = fires(network, middle)
        name = "one ignition" if middle else "random ignitions"

        def single(given: tuple = given) -> tuple[np.ndarray, np.ndarray]:
            counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(RUNS, np.int64)
            percolation.burn_runs(*given, 0, RUNS, counts, sizes, np.zeros(0), np.zeros(RUNS))
            return counts, sizes

        def block(given: tuple = given) -> tuple[np.ndarray, np.ndarray]:
            counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(RUNS, np.int64)
            lanes.burn_block(*given, 0, RUNS, state, counts, sizes)
            return counts, sizes

        few = starts[:8] if side > 300 else starts[:32]
        factor = RUNS / few.size
        floor = (3.0 if side <= 300 else 2.0) if middle else None
        yield Row(f"64 fires at once, {name}", n_cells, "one by one", block, single, same, repeats, floor)
        yield Row(
            f"fires, {name}",
            n_cells,
            "numpy frontier",
            block,
            scaled(lambda few=few: peers.numpy_frontier(network, few, 1), factor),
            alike,
            repeats,
            15.0,
        )
        yield Row(
            f"fires, {name}",
            n_cells,
            "numpy mask + csgraph",
            block,
            scaled(lambda few=few: peers.mask_and_csgraph(network, few, 1), factor),
            alike,
            repeats,
            8.0,
        )
    given, _ = fires(network, False)
    levels = np.minimum(np.random.default_rng(3).random(n_cells) * 100, 50).astype(np.int32)

    def curve() -> np.ndarray:
        burnt = np.zeros((RUNS, 51), np.int64)
        percolation.burn_curve(*given, 0, RUNS, levels, burnt)
        return burnt

    def every_level() -> np.ndarray:
        burnt = np.zeros((RUNS, 51), np.int64)
        counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(RUNS, np.int64)
        for level in range(51):
            cut = levels.reshape(network.shape) < level
            limits = draws.thresholds(network.treated(cut).probability)
            cells = np.where(cut.ravel()[given[4]], -1, given[4])
            percolation.burn_runs(limits, *given[1:4], cells, 0, RUNS, counts, sizes, np.zeros(0), np.zeros(RUNS))
            burnt[:, level] = sizes
        return burnt

    def plain() -> np.ndarray:
        counts, sizes = np.zeros(n_cells, np.uint32), np.zeros(RUNS, np.int64)
        percolation.burn_runs(*given, 0, RUNS, counts, sizes, np.zeros(0), np.zeros(RUNS))
        return sizes

    yield Row(
        "curve of 51 levels",
        n_cells,
        "one plain run",
        curve,
        plain,
        lambda a, b: bool((a[:, 0] == b).all()),
        repeats,
        0.5,
    )
    if side <= 300:
        yield Row(
            "curve of 51 levels",
            n_cells,
            "simulating each level",
            curve,
            every_level,
            lambda a, b: bool((a == b).all()),
            3,
            5.0,
        )


def scaled(work: Callable[[], object], factor: float) -> Callable[[], object]:
    """Mark work that does only a share of the runs; its time is multiplied."""
    work.factor = factor  # type: ignore[attr-defined]
    return work


def path_rows(side: int) -> Iterator[Row]:
    """Shortest paths against graph libraries."""
    network = fractal(side, scale=1.0)
    n_cells = network.burnable.size
    graph, other = peers.igraph_graph(network), peers.networkit_graph(network)

    def close(a: object, b: object) -> bool:
        return bool(np.allclose(np.asarray(a).ravel(), np.asarray(b).ravel(), rtol=1e-9, atol=1e-9))

    def ours() -> np.ndarray:
        return betweenness(network.probability, network.burnable)

    def by_networkit() -> np.ndarray:
        import networkit

        return np.array(networkit.centrality.Betweenness(other).run().scores())

    yield Row("betweenness, exact", n_cells, "igraph", ours, lambda: graph.betweenness(weights="length"), close, 1, 4.0)
    yield Row("betweenness, exact", n_cells, "networkit", ours, by_networkit, close, 1, 5.0)

    def our_closeness() -> np.ndarray:
        return closeness(network.probability, network.burnable, transpose=False)

    def by_igraph() -> np.ndarray:
        return np.array(graph.closeness(weights="length", mode="out", normalized=False))

    def proportional(a: object, b: object) -> bool:
        ratio = np.asarray(a).ravel() / np.asarray(b).ravel()
        return bool(np.allclose(ratio, ratio[0], rtol=1e-9))

    yield Row("closeness", n_cells, "igraph", our_closeness, by_igraph, proportional, 1, 3.0)


def linear_rows(side: int) -> Iterator[Row]:
    """Bonacich centrality and the stencil against scipy and the memory bandwidth."""
    network = fractal(side, scale=1.0)
    n_cells = network.burnable.size
    matrix = network.to_csr()
    x = np.random.default_rng(0).random(n_cells)

    def close(a: object, b: object) -> bool:
        return bool(np.allclose(np.asarray(a).ravel(), np.asarray(b).ravel(), rtol=1e-6))

    with Operator(network.probability) as operator:
        plane, out = x.reshape(network.shape), np.empty(network.shape)
        yield Row(
            "stencil product",
            n_cells,
            "scipy CSR",
            lambda: operator.apply(plane, out).copy(),
            lambda: matrix @ x,
            close,
            7,
            4.0,
        )
    yield Row(
        "Bonacich, beta 0.9",
        n_cells,
        "scipy ARPACK + BiCGSTAB",
        lambda: rank(network, "bonacich", beta=0.9).values,
        lambda: peers.scipy_bonacich(network, 0.9),
        close,
        1,
        20.0 if side >= 3000 else None,
    )


def measure(row: Row) -> dict[str, object]:
    """Check a row, then time both sides in turn."""
    factor = getattr(row.theirs, "factor", 1.0)
    if not row.agree(row.ours(), row.theirs()):
        raise AssertionError(f"{row.what} does not agree with {row.peer}")
    ours, theirs = [], []
    for _ in range(row.repeats):
        for work, times in ((row.ours, ours), (row.theirs, theirs)):
            started = time.perf_counter()
            work()
            times.append(time.perf_counter() - started)
    a, b = float(np.median(ours)), factor * float(np.median(theirs))
    return {
        "what": row.what,
        "cells": row.cells,
        "peer": row.peer,
        "ours_s": a,
        "peer_s": b,
        "ratio": b / a,
        "at_least": row.at_least,
    }


def sampled_row(side: int) -> dict[str, object]:
    """Time of one pivot of sampled betweenness."""
    network = fractal(side, scale=1.0)
    sampled_betweenness(network.probability, network.burnable, pivots=2)
    started = time.perf_counter()
    sampled_betweenness(network.probability, network.burnable, pivots=16)
    seconds = (time.perf_counter() - started) / 16
    return {"what": "sampled betweenness, a pivot", "cells": network.burnable.size, "peer": "", "ours_s": seconds}


def main() -> None:
    """Write table.csv, table.md and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("benchmarks"))
    parser.add_argument("--quick", action="store_true", help="small sizes only")
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    rows: list[dict[str, object]] = []
    makers = [(burn_rows, (100, 300, 1000)), (path_rows, (50, 100)), (linear_rows, (300, 1000))]
    for maker, sides in makers:
        for side in sides[:1] if given.quick else sides:
            for row in maker(side):
                rows.append(measure(row))
                print(rows[-1], flush=True)
    rows.append(sampled_row(100 if given.quick else 1000))
    frame = pd.DataFrame(rows)
    frame.to_csv(given.output / "table.csv", index=False)
    lines = ["| what | cells | against | ours [s] | peer [s] | ratio |", "|---|---|---|---|---|---|"]
    for r in frame.fillna("").to_dict("records"):
        peer, ratio = (f"{r['peer_s']:.4g}", f"{r['ratio']:.1f}") if r["peer"] else ("", "")
        lines.append(f"| {r['what']} | {r['cells']:,} | {r['peer']} | {r['ours_s']:.4g} | {peer} | {ratio} |")
    lines.append(f"\n{platform.machine()}, {os.cpu_count()} processors, Python {platform.python_version()}")
    (given.output / "table.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
