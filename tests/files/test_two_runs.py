"""Two runs at one output, and outputs that are inputs: refused through every command, and nothing is changed."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import rasterio.shutil
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from tests.places import patches, three, write

ROOT = Path(__file__).parents[2]
ROWS, COLS = 24, 31
LAYERS = ["dem.tif", "vegetation.tif", "density.tif"]


@pytest.fixture(scope="module")
def template(tmp_path_factory):
    """Layers, a landscape, a network, a priority, a mask, a legend and virtual rasters as files."""
    folder = tmp_path_factory.mktemp("inputs")
    three(folder, ROWS, COLS)
    write(folder / "net.tif", np.full((8, ROWS, COLS), 0.5, "float32"))
    write(folder / "priority.tif", np.arange(ROWS * COLS, dtype="float32").reshape(ROWS, COLS))
    write(folder / "mask.tif", (patches(ROWS, COLS, [0, 1]) == 1).astype("uint8"))
    assert call("align", *(folder / name for name in LAYERS), "-o", folder / "land").exit_code == 0
    (folder / "own.csv").write_text("code,vegetation\n0,none\n1,agricultural\n2,shrubs\n3,pines\n")
    for source, target in (("priority", "priority"), ("dem", "virtual")):
        rasterio.shutil.copy(folder / f"{source}.tif", folder / f"{target}.vrt", driver="VRT")
        text = (folder / f"{target}.vrt").read_text()
        assert 'relativeToVRT="1"' in text
    return folder


@pytest.fixture
def place(template, tmp_path, monkeypatch):
    folder = tmp_path / "place"
    shutil.copytree(template, folder)
    monkeypatch.chdir(folder)
    return folder


def call(*words):
    return CliRunner().invoke(firebreak, [str(w) for w in words])


def start(*words):
    return subprocess.Popen(
        [sys.executable, "-m", "firebreak_gis", *words],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def content(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def stopped_at_work(process, folder):
    """Let a process stand still while it holds its output; returns the files of that moment."""
    until = time.monotonic() + 60
    while True:
        assert process.poll() is None, process.stderr.read()
        assert time.monotonic() < until
        if list(folder.glob(".firebreak-*.lock")):
            process.send_signal(signal.SIGSTOP)
            os.waitid(os.P_PID, process.pid, os.WSTOPPED)
            # The file is there a moment before the lock is.
            if any(held(path) for path in folder.glob(".firebreak-*.lock")):
                return content(folder)
            process.send_signal(signal.SIGCONT)
        time.sleep(0.002)


def held(path):
    """Whether another process holds the lock; asked only while that process stands still."""
    import fcntl

    with path.open("rb") as stream:
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
    return False


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="a process cannot be made to stand still here")
@pytest.mark.parametrize("old", ["no", "old"])
@pytest.mark.parametrize(
    ("words", "target"),
    [
        (["plan", *LAYERS, "--method", "random", "--runs", "5"], "out/run.json"),
        (["align", *LAYERS], "out/elevation.tif"),
        (["rank", "net.tif", "--method", "random"], "out/p.tif"),
    ],
    ids=["plan", "align", "rank"],
)
def test_the_second_run_is_refused_and_the_first_is_whole(place, words, target, old):
    folder = Path("out")
    output = str(folder) if words[0] != "rank" else target
    folder.mkdir()
    alone = Path("alone")
    alone.mkdir()
    assert call(*words, "-o", str(alone) if words[0] != "rank" else "alone/p.tif").exit_code == 0
    if old == "old":
        assert call(*words, "-o", output).exit_code == 0
    first = start(*words, "-o", output, "-q", "--overwrite")
    try:
        before = stopped_at_work(first, folder)
        second = start(*words, "-o", output, "--seed", "9") if words[0] == "rank" else start(*words, "-o", output)
        _, told = second.communicate(timeout=60)
        assert second.returncode == 4, told
        assert "another run is writing the same output" in told
        assert "wait for it or choose another name" in told
        with_leave = call(*words, "-o", output, "--overwrite", "--json")
        assert with_leave.exit_code == 4
        assert content(folder) == before
    finally:
        first.send_signal(signal.SIGCONT)
        _, told = first.communicate(timeout=60)
    assert first.returncode == 0, told
    assert content(folder) == content(alone)


#: Command, option or place of the input in it, and the output that is this input.
SAME = {
    "rank": (["rank", "net.tif", "--method", "random", "-o", "OUT"], "net.tif"),
    "rank, protected": (["rank", "net.tif", "--protected", "mask.tif", "--method", "random", "-o", "OUT"], "mask.tif"),
    "breaks": (["breaks", "priority.tif", "-o", "OUT"], "priority.tif"),
    "breaks, cost": (["breaks", "priority.tif", "--cost", "dem.tif", "-o", "OUT"], "dem.tif"),
    "breaks, polygons": (["breaks", "priority.tif", "-o", "m.tif", "--polygons", "OUT"], "priority.tif"),
    "burn": (["burn", "net.tif", "--runs", "5", "-o", "OUT"], "net.tif"),
    "burn, breaks": (["burn", "net.tif", "--breaks", "mask.tif", "--runs", "5", "-o", "OUT"], "mask.tif"),
    "burn, ignitions": (["burn", "net.tif", "--ignitions", "dem.tif", "--runs", "5", "-o", "OUT"], "dem.tif"),
    "burn, sizes": (["burn", "net.tif", "--runs", "5", "-o", "f.tif", "--sizes", "OUT"], "net.tif"),
    "segments": (["segments", "net.tif", "mask.tif", "-o", "OUT"], "mask.tif"),
    "segments, dem": (["segments", "net.tif", "mask.tif", "--dem", "dem.tif", "-o", "OUT"], "dem.tif"),
    "segments, compartments": (["segments", "net.tif", "mask.tif", "-o", "s.gpkg", "--compartments", "OUT"], "net.tif"),
    "network": (["network", "land", "-o", "OUT"], "land/elevation.tif"),
    "network, wind": (["network", "land", "--wind-speed", "dem.tif", "-o", "OUT"], "dem.tif"),
    "breaks, page": (["breaks", "GTIFF_DIR:1:priority.tif", "-o", "OUT"], "priority.tif"),
    "breaks, virtual": (["breaks", "priority.vrt", "-o", "OUT"], "priority.tif"),
}
#: Extension of the output where it is another one than that of the input: the bare name is refused for it.
EXTENSIONS = {
    "breaks, polygons": ".gpkg",
    "burn, sizes": ".csv",
    "segments": ".gpkg",
    "segments, dem": ".gpkg",
    "segments, compartments": ".gpkg",
}
#: Commands that write into a folder: words, input, the file in the folder that is this input.
SAME_IN_FOLDER = {
    "align": (["align", *LAYERS], "dem.tif", "elevation.tif"),
    "align, virtual": (["align", "virtual.vrt", *LAYERS[1:]], "dem.tif", "elevation.tif"),
    "plan": (["plan", *LAYERS, "--runs", "5", "--method", "random"], "vegetation.tif", "breaks.tif"),
    "plan, protected": (
        ["plan", *LAYERS, "--protected", "mask.tif", "--runs", "5", "--method", "random"],
        "mask.tif",
        "priority.tif",
    ),
    "plan, legend": (
        ["plan", *LAYERS, "--legend", "own.csv", "--runs", "5", "--method", "random"],
        "own.csv",
        "evaluation.csv",
    ),
    "plan, virtual": (
        ["plan", "virtual.vrt", *LAYERS[1:], "--runs", "5", "--method", "random"],
        "dem.tif",
        "elevation.tif",
    ),
    "evaluate": (["evaluate", "net.tif", "--methods", "random", "--runs", "5"], "net.tif", "evaluation.png"),
    "compare": (["compare", "net.tif", "--methods", "random", "--runs", "5"], "net.tif", "comparison.csv"),
    "compare, values": (
        ["compare", "net.tif", "--values", "mask.tif", "--methods", "random", "--runs", "5"],
        "mask.tif",
        "run.json",
    ),
}


def refused(words, before, *told):
    """Run with and without leave to overwrite: exit 4, and every byte as it was."""
    for leave in ([], ["--overwrite"]):
        outcome = call(*words, *leave)
        assert outcome.exit_code == 4, outcome.output + repr(outcome.exception)
        for part in told or ("is the input", "inputs are never changed"):
            assert part in outcome.output
        assert content(Path()) == before


@pytest.mark.parametrize("how", ["name", "symbolic link", "hard link"])
@pytest.mark.parametrize("row", SAME)
def test_no_output_file_is_an_input(row, how, place):
    words, source = SAME[row]
    target = tie(how, Path(source), Path("tied").with_suffix(EXTENSIONS.get(row, Path(source).suffix)))
    told = ("expected the extension",) if how == "name" and row in EXTENSIONS else ()
    refused([str(target) if word == "OUT" else word for word in words], content(place), *told)


@pytest.mark.parametrize("how", ["symbolic link", "hard link"])
@pytest.mark.parametrize("row", SAME_IN_FOLDER)
def test_no_file_of_an_output_folder_is_an_input(row, how, place):
    words, source, name = SAME_IN_FOLDER[row]
    Path("out").mkdir()
    tie(how, Path(source), Path("out") / name)
    refused([*words, "-o", "out"], content(place))


@pytest.mark.parametrize("row", SAME_IN_FOLDER)
def test_an_input_in_the_output_folder_under_its_own_name(row, place):
    words, source, name = SAME_IN_FOLDER[row]
    Path("out").mkdir()
    words = [f"out/{name}" if word == source else word for word in words]
    Path(source).rename(f"out/{name}")
    virtual = Path("virtual.vrt")
    virtual.write_text(virtual.read_text().replace("dem.tif", f"out/{name}"))
    refused([*words, "-o", "out"], content(place))


def tie(how, source, target):
    """Return a name by which `source` is met."""
    if how == "name":
        return source
    if how == "symbolic link":
        target.symlink_to(source.absolute())
    else:
        target.hardlink_to(source)
    return target
