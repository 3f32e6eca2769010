"""Measure the kernels against their peers: `python -m tests.benchmarks.run`, about 10 minutes.

Every row is checked before it is timed: both sides must give the same result (fires of other draws: the same mean
size within its error). Both sides take turns, times are medians. Rows on one thread are in processor time, which
other programs on the machine hardly change; rows by the clock (several threads, start-up, files to files) need a
quiet machine.

`--huge` adds 9 million cells against scipy, and networkx on 10,000 cells: 12 minutes more and 8 GB of memory.
"""

from __future__ import annotations

import argparse
import gc
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from tests.benchmarks import centralities, fires, linear, memory, paths, report, scaling, start
from tests.benchmarks.measuring import Comparison, Figure, Line, line_of

Rows = Iterable[Comparison | Figure]
_HERE = Path(__file__).parent


def _parts(*, quick: bool, huge: bool) -> Iterator[tuple[str, Callable[[], Rows]]]:
    """Makers of rows, in the order of the table."""
    for side in (100,) if quick else (100, 300, 1000):
        yield "fires", lambda side=side: fires.rows(side)
    yield "paths", lambda: paths.rows(30 if quick else 50)
    yield "paths", lambda: paths.networkx_rows(30 if quick else 50)
    if not quick:
        yield "paths", lambda: paths.rows(100)
    if huge:
        yield "paths", lambda: paths.networkx_rows(100)
    yield "centralities", lambda: centralities.rows(30)
    yield "centralities", lambda: centralities.groups(10)
    yield "centralities", lambda: centralities.pagerank(100)
    yield "sampled", lambda: paths.sampled_rows(100 if quick else 1000)
    for side in (300,) if quick else (300, 1000, 3000) if huge else (300, 1000):
        yield "stencil", lambda side=side: linear.stencil_rows(side)
    for side in (300,) if quick else (1000, 3000):
        for transpose in (False, True):
            yield "stencil", lambda side=side, transpose=transpose: linear.bandwidth_row(side, transpose=transpose)
    for side in (300,) if quick else (1000, 3000) if huge else (1000,):
        yield "bonacich", lambda side=side: linear.bonacich_rows(side)
    yield "start", start.start_rows
    for side in (300,) if quick else (1000, 3000) if huge else (1000,):
        yield "whole", lambda side=side: start.whole_rows(side)
    if not quick and sys.platform == "linux":
        yield "memory", memory.figures


def _measured(maker: Callable[[], Rows], began: float) -> Iterator[Line]:
    """Lines of one maker; what fails becomes a line that says so."""
    try:
        for row in maker():
            line = line_of(row)
            print(f"{time.perf_counter() - began:6.0f} s", report.table([line]).splitlines()[-1], flush=True)
            yield line
    except Exception as error:  # the other rows are still wanted
        print(f"failed: {error!r}", file=sys.stderr, flush=True)
        yield Line("a row that failed", 0, 0, float("nan"), "", fault=repr(error).replace("|", "/"))


def main() -> None:
    """Write table.csv, table.md, costs.csv and cost.png; exit with 1 if a row failed or missed its mark."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=_HERE / "results", help="folder for the files")
    parser.add_argument("--quick", action="store_true", help="small sizes only, to see that all works")
    parser.add_argument("--huge", action="store_true", help="9 million cells, and networkx on 10,000")
    parser.add_argument(
        "--only",
        action="append",
        help="fires, paths, centralities, sampled, stencil, bonacich, start, whole, memory or scaling; may be given "
        "several times",
    )
    parser.add_argument("--readme", type=Path, help="put the rows with a demand into this file (docs/speed.md)")
    given = parser.parse_args()
    began = time.perf_counter()
    lines: list[Line] = []
    for subject, maker in _parts(quick=given.quick, huge=given.huge):
        if given.only and subject not in given.only:
            continue
        for line in _measured(maker, began):
            lines.append(line)
            report.write(lines, [], given.output)
        gc.collect()
    costs: list[scaling.Cost] = []
    if not given.only or "scaling" in given.only:
        sizes = ((100, 316), (32, 56)) if given.quick else (scaling.SIDES, scaling.SMALL_SIDES)
        for cost in scaling.costs(*sizes):
            print(f"{time.perf_counter() - began:6.0f} s {cost}", flush=True)
            costs.append(cost)
    report.write(lines, costs, given.output)
    if given.readme:
        command = "python -m tests.benchmarks.run" + (" --huge" if given.huge else "")
        report.put_into(given.readme, lines, given.output, command)
    missed = [line for line in lines if line.fault or line.holds is False]
    print(f"{len(lines)} rows, {len(missed)} missed, {time.perf_counter() - began:.0f} s, in {given.output}")
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
