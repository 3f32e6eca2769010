"""Memory: estimates are near what is measured, limits are kept, sizes are read."""

import ctypes
import os
import subprocess
import sys
from pathlib import Path

import pytest

from firebreak_gis import memory, plugins
from firebreak_gis.cli import parsing
from firebreak_gis.errors import ParameterError, ResourceError
from tests.benchmarks.estimates import measure


@pytest.mark.skipif(not hasattr(os, "wait4"), reason="this system does not tell the peak of a process")
def test_estimates_are_near_the_measured_peak_on_a_million_cells():
    """Larger grids, whole plans and slow rankings: `python -m tests.benchmarks.estimates`."""
    for what, (estimated, measured) in measure(1000, ("flammability",), whole=False).items():
        assert 1 / 1.5 < estimated / measured < 1.5, (what, estimated, measured)


def test_every_ranking_tells_what_it_needs():
    for name in plugins.names("ranking"):
        assert hasattr(plugins.load("ranking", name), "MEMORY"), name
        cell, thread = plugins.memory_of("ranking", name)
        assert 0 <= thread <= cell <= 3000  # those that solve linear systems need most


@pytest.mark.parametrize("command", ["align", "network", "rank", "burn", "evaluate", "compare", "plan"])
def test_more_cells_and_threads_need_more(command):
    method = None if command in ("align", "network", "burn") else "dissection"
    needs = [memory.bytes_for(command, cells, method=method, threads=2) for cells in (0, 10**5, 10**6, 10**8)]
    assert sorted(needs) == needs
    assert needs[0] > 1e8
    assert needs[2] > needs[0] + 80 * 10**6
    few, many = (memory.bytes_for(command, 10**7, method=method, threads=n) for n in (1, 64))
    assert few <= many
    assert memory.bytes_for(command, 10**6, method=method, threads=2, clock=True) > needs[2] + 60 * 10**6


def test_what_does_not_fit_is_refused():
    memory.require_memory(10**9, "work", max_memory=10**9)
    with pytest.raises(ResourceError, match=r"work needs about 2 GB of memory, 1 GB are allowed.*--max-memory"):
        memory.require_memory(2 * 10**9, "work", max_memory=10**9)
    assert 10**8 < memory.allowed() < memory.memory_limit()


@pytest.mark.parametrize(
    ("text", "size"), [("4GB", 4 << 30), ("800 MiB", 800 << 20), ("1.5g", 3 << 29), ("1000", 1000), (None, None)]
)
def test_sizes(text, size):
    assert parsing.byte_size(text) == size


@pytest.mark.parametrize("text", ["", "much", "-4GB", "0", "nan", "inf GB"])
def test_words_that_are_no_sizes(text):
    with pytest.raises(ParameterError, match="such as 4GB"):
        parsing.byte_size(text)


def test_windows_and_blocks_do_not_grow_with_the_map():
    small, large = (memory.bytes_for("burn", n, clock=True, window=512, threads=2) for n in (10**6, 10**8))
    assert large < small + 30 * 10**8
    assert large < memory.bytes_for("burn", 10**8, clock=True, threads=2) / 10
    one, other = (memory.bytes_for("network", n, clock=True, blocks=True) for n in (10**7, 10**9))
    assert one == other < memory.bytes_for("network", 10**7, clock=True)


def test_dissection_by_regions_needs_what_was_measured():
    """`rank` of 3,162 x 3,162 cells of noise on two threads took 1.5 GB, pages of the network's file among them."""
    large = memory.bytes_for("rank", 3162**2, method="dissection", blocks=True, threads=2)
    assert 1 / 1.2 < large / 1.52e9 < 1.2
    per_cell = [memory.bytes_for("rank", n, method="dissection", threads=2) / n for n in (memory.BLOCK_CELLS, 10**8)]
    assert per_cell[1] < 0.7 * per_cell[0]


def test_plans_of_large_maps_need_what_was_measured():
    """`plan` of 3,162 x 3,162 cells of noise on two threads took 3.5 GB beside the pages of its files."""
    about = {"method": "dissection", "clock": True, "threads": 2}
    away, whole = (memory.bytes_for("plan", 3162**2, **about, blocks=blocks) for blocks in (True, False))
    assert 1 / 1.2 < away / 3.5e9 < 1.2
    assert away < whole
    assert memory.bytes_for("plan", 10**8, **about, blocks=True) < 20 << 30
    assert memory.bytes_for("plan", 10**8, **about) > 40 << 30
    few = memory.BLOCK_CELLS
    assert memory.bytes_for("plan", few, **about, blocks=True) == memory.bytes_for("plan", few, **about)


def test_each_worker_has_its_own_copy():
    """A network with times of 2.25 million cells took 570 MB in each of two workers, one of 0.25 million 250 MB."""
    alone, two, four = (memory.bytes_for("burn", 2_250_000, clock=True, threads=1, workers=n) for n in (None, 2, 4))
    assert four - two == two - alone
    assert 570e6 < (two - alone) / 2 < 2 * 570e6
    window = {"clock": True, "threads": 1, "window": 512}
    one, other = (
        memory.bytes_for("burn", n, **window, workers=2) - memory.bytes_for("burn", n, **window) for n in (10**6, 10**8)
    )
    assert one == other  # what a worker reads does not grow with the map
    one, other = (
        memory.bytes_for("rank", n, method="dissection", workers=2) - memory.bytes_for("rank", n, method="dissection")
        for n in (memory.BLOCK_CELLS, 10**8)
    )
    assert one == other < 3 << 30  # nor does a region


@pytest.mark.skipif(
    sys.platform != "linux" or not hasattr(ctypes.CDLL(None), "malloc_trim"),
    reason="this C library has nothing to give back",
)
def test_what_was_freed_in_small_pieces_is_given_back():
    def held() -> int:
        lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
        return 1024 * int(next(line for line in lines if line.startswith("RssAnon")).split()[1])

    pieces = [bytes(2000) for _ in range(100_000)]
    del pieces[:-1]  # the last one lies above the others
    before = held()
    memory.give_back()
    assert held() < before - 100e6


_WORKS = """
import sys
from pathlib import Path
from firebreak_gis import memory

if sys.argv[1] == "return":
    memory.return_large()
if sys.argv[1] in ("little", "much"):
    memory.return_large()
    memory.suit(25 if sys.argv[1] == "little" else 26, max_memory=100)
del bytearray(31 << 20)[:]  # from now on the C library takes nothing smaller for large
pieces = [bytearray(4 << 20) for _ in range(40)]
del pieces[:-1]
lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
print(next(line for line in lines if line.startswith("RssAnon")).split()[1])
"""


@pytest.mark.skipif(
    sys.platform != "linux" or not hasattr(ctypes.CDLL(None), "mallopt"),
    reason="this C library keeps nothing large",
)
def test_what_is_large_is_returned_when_it_is_freed_unless_memory_is_plenty():
    def held(how: str, **more: str) -> int:
        words = [sys.executable, "-c", _WORKS, how]
        environment = {k: v for k, v in os.environ.items() if not k.startswith("MALLOC_")} | more
        return 1024 * int(subprocess.run(words, env=environment, check=True, capture_output=True, text=True).stdout)

    kept, returned = held("keep"), held("return")
    assert returned < kept - 100e6
    # Where work needs up to a quarter of what is allowed, what is freed stays for what comes next.
    assert held("little") > returned + 100e6
    assert held("much") < kept - 100e6
    assert held("return", MALLOC_MMAP_THRESHOLD_="33554432") > returned + 100e6  # the user's own setting
