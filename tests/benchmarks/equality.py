"""Whether all outputs are the same bytes, whoever does the work: `python -m tests.benchmarks.equality`.

Commands are run with {threads, processes, a dask scheduler of its own} x {1, 2, 4} of them x {the map in memory, by
windows or parts}, and the SHA-256 of every file is held against that of one thread with the map in memory; the walls of
regions, which are other ones than those of the whole, against one thread with the regions. Writes equality.md.

Maps are laid by parts and dissected by regions from 4 million cells on; here from `--block` on. The process that is
started decides this alone, workers are told their part. `--size 2100 --block 4000000` leaves it as it is.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from firebreak_gis.landscape.strips import read_by_parts
from firebreak_gis.memory import BLOCK_CELLS
from firebreak_gis.placement import dissection
from tests.benchmarks.estimates import layers

ENGINES = ("threads", "processes", "distributed")
#: Fires by command; those of `burn` that can also be burnt by windows, and all others.
BY_WINDOWS = ("burn", "NET", "-o", "OUT/burn.tif", "--sizes", "OUT/sizes.csv", "--duration", "2h", "--hold", "0.47")
#: Networks in a few bits a number are burnt as those with all, see `network --bits`.
PACKED = ("8", "16")
#: What is laid by parts, and dissected by regions.
ALIGN = ("align", "DEM", "VEG", "DEN", "-o", "OUT")
REGIONS = ("rank", "NET", "-o", "OUT/rank.tif", "--method", "dissection")
WHOLE: dict[str, tuple[str, ...]] = {
    "burn with products": (*BY_WINDOWS, "--products", "OUT/products"),
    "burn without a clock": ("burn", "NET", "-o", "OUT/burn.tif", "--sizes", "OUT/sizes.csv"),
    "burn in drawn weathers": (
        *("burn", "LAND", "-o", "OUT/burn.tif", "--sizes", "OUT/sizes.csv"),
        *("--weather", "rose:NW=5x0.4,N=36km/hx0.2,S=3x0.4;duration=2h"),
    ),
    "evaluate": ("evaluate", "NET", "-o", "OUT", "--methods", "degree,random", "--budgets", "0,5%,10%"),
    "compare": ("compare", "NET", "-o", "OUT", "--methods", "degree,random", "--budgets", "5%", "--residuals", "0,0.1"),
    "plan": ("plan", "DEM", "VEG", "DEN", "-o", "OUT", "--wind-speed", "5"),
    "assess": ("assess", "NET", "LAND/breaks.tif", "-o", "OUT", "--placements", "1", "--most-gaps", "3"),
}


class Asked(NamedTuple):
    """A command, by the name of what it writes; outputs of one name must be the same."""

    name: str
    where: Landscape
    words: tuple[str, ...]
    block: int = BLOCK_CELLS

    def hashes(self, engine: Sequence[str] = ()) -> dict[str, str]:
        """Of what it writes."""
        with blocks_of(self.block):
            return hashes(self.where, self.words, engine)


class Landscape:
    """Layers, their landscape, network and breaks, in a folder."""

    def __init__(self, folder: Path, size: int) -> None:
        self.folder = folder
        dem, vegetation, density = layers(folder, size)
        land, net = str(folder / "land"), str(folder / "net.tif")
        self._names = {"NET": net, "LAND": land, "DEM": dem, "VEG": vegetation, "DEN": density}
        run(["align", dem, vegetation, density, "-o", land])
        run(["network", land, "-o", net, "--clock", "--wind-speed", "5", "--wind-from", "315"])
        for bits in PACKED:
            self._names[f"BITS{bits}"] = packed = str(folder / f"net{bits}.tif")
            more = ("--clock", "--wind-speed", "5", "--wind-from", "315", "--bits", bits)
            run(["network", land, "-o", packed, *more])
        run(["rank", net, "-o", str(folder / "rank.tif"), "--method", "stripes"])
        run(["breaks", str(folder / "rank.tif"), "-o", str(folder / "land" / "breaks.tif"), "--budget", "5%"])

    def words(self, words: Sequence[str], out: Path) -> list[str]:
        """A command with the names of the files in it."""
        for name, path in (*self._names.items(), ("OUT", str(out))):
            words = [word.replace(name, path) if word.isupper() or "/" in word else word for word in words]
        return list(words)


def run(words: Sequence[str]) -> None:
    """Run a command; fails with what it said."""
    outcome = CliRunner().invoke(firebreak, [*words, "-q"])
    if outcome.exit_code:
        raise AssertionError(f"{' '.join(words)}\n{outcome.output}\n{outcome.exception!r}")


@contextlib.contextmanager
def blocks_of(cells: int) -> Iterator[None]:
    """Let maps of more cells be laid by parts, and be dissected by regions, of about so many."""
    with (
        patch("firebreak_gis.landscape.surveying.BLOCK_CELLS", cells),
        patch("firebreak_gis.cli.commands.rank.BLOCK_CELLS", cells),
        patch.dict(read_by_parts.__kwdefaults__, cells=cells),
        patch.dict(dissection.dissect.__kwdefaults__, regions_from=cells),
        patch.object(dissection.by_regions, "__defaults__", (cells,)),
    ):
        yield


def hashes(landscape: Landscape, words: Sequence[str], engine: Sequence[str] = ()) -> dict[str, str]:
    """SHA-256 of every file that a command writes, by name."""
    with tempfile.TemporaryDirectory() as place:
        run([*landscape.words(words, Path(place)), *engine])
        return {
            str(path.relative_to(place)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(Path(place).rglob("*"))
            if path.is_file()
        }


@contextlib.contextmanager
def engine(name: str, count: int, folder: Path) -> Iterator[list[str]]:
    """Options that let so many threads, processes or workers of another scheduler do the work."""
    if name == "threads":
        before = os.environ.get("FIREBREAK_THREADS")
        os.environ["FIREBREAK_THREADS"] = str(count)
        try:
            yield []
        finally:
            os.environ.pop("FIREBREAK_THREADS")
            os.environ.update({} if before is None else {"FIREBREAK_THREADS": before})
    elif name == "processes":
        yield ["--workers", str(count)]
    else:
        file = str(folder / f"scheduler-{count}.json")
        with contextlib.ExitStack() as open_:
            open_.enter_context(started("scheduler", "--port", "0", "--host", "127.0.0.1", "--scheduler-file", file))
            for _ in range(count):
                more = ("--nthreads", "1", "--no-nanny", "--no-dashboard")
                open_.enter_context(started("worker", "--scheduler-file", file, *more))
            yield ["--scheduler", file]


@contextlib.contextmanager
def started(what: str, *words: str) -> Iterator[subprocess.Popen[bytes]]:
    """A scheduler or a worker of dask in a process of its own, ended with the block."""
    module = f"distributed.cli.dask_{what}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    process = subprocess.Popen([sys.executable, "-m", module, *words], **quiet)
    try:
        file = Path(words[words.index("--scheduler-file") + 1])
        until = time.monotonic() + 60.0
        while not file.exists() and time.monotonic() < until:
            time.sleep(0.05)
        yield process
    finally:
        process.kill()
        process.wait()


def commands(given: argparse.Namespace, large: Landscape, small: Landscape) -> list[Asked]:
    """What is run; the first of a name with the map in memory, if there is such."""
    runs = ("--runs", given.runs)
    windows = [(), *(("--window", str(side)) for side in given.windows)]
    asked = [Asked("burn", large, (*BY_WINDOWS, *runs, *window)) for window in windows]
    for bits in PACKED:
        words = tuple(f"BITS{bits}" if word == "NET" else word for word in BY_WINDOWS)
        asked += [Asked(f"burn of {bits} bits", large, (*words, *runs, *window)) for window in windows]
    asked += [Asked("align", large, ALIGN, block) for block in (10**9, given.block)]
    asked += [Asked("rank by regions", large, REGIONS, given.block)]
    return asked + [Asked(name, small, (*words, *runs)) for name, words in WHOLE.items()]


def main() -> None:
    """Write equality.md; exit with 1 if any file differs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=Path(__file__).parent / "results", help="folder for the file")
    parser.add_argument("--size", type=int, default=1100, help="rows and columns of the map that is burnt by windows")
    parser.add_argument("--small", type=int, default=60, help="rows and columns of the map of the other commands")
    parser.add_argument("--windows", type=int, nargs="*", default=[256, 1024])
    parser.add_argument("--counts", type=int, nargs="*", default=[1, 2, 4])
    parser.add_argument("--runs", default="16")
    parser.add_argument("--block", type=int, default=200_000, help="cells of a part, and of a region at most")
    parser.add_argument("--only", default="", help="commands whose names hold this text")
    given = parser.parse_args()
    lines = ["| engine | of them | files | the same | seconds |", "|---|---|---|---|---|"]
    equal = True
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        for name in ("large", "small"):
            (folder / name).mkdir()
        large, small = Landscape(folder / "large", given.size), Landscape(folder / "small", given.small)
        asked = [each for each in commands(given, large, small) if given.only in each.name]
        with engine("threads", 1, folder):
            first = {each.name: each for each in reversed(asked)}
            wanted = {name: each.hashes() for name, each in first.items()}
        for kind in ENGINES:
            for count in given.counts:
                with engine(kind, count, folder) as words:
                    began = time.perf_counter()
                    found = [(each.name, each.hashes(words)) for each in asked]
                    took = time.perf_counter() - began
                other = [name for name, each in found if each != wanted[name]]
                files = sum(len(each) for _, each in found)
                equal &= not other
                told = f"not those of {', '.join(other)}" if other else "all"
                lines.append(f"| {kind} | {count} | {files} | {told} | {took:.0f} |")
                print(lines[-1], flush=True)
                (given.output / "equality.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    sys.exit(not equal)


if __name__ == "__main__":
    main()
