"""Long work says how long it takes before it begins, and stops within two seconds."""

from __future__ import annotations

import json
import subprocess
import sys
import time

import numpy as np
import pytest
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis.cli import firebreak

#: Seconds after which work that was told to stop has stopped.
SOON = 2.0


@pytest.fixture(scope="module")
def place(tmp_path_factory, make_landscape):
    """A landscape with its network, a wall and a burnt area."""
    from firebreak_gis.landscape import write_landscape

    folder = tmp_path_factory.mktemp("stops")
    write_landscape(make_landscape((160, 200), seed=3), folder / "land")
    done = CliRunner().invoke(firebreak, ["network", str(folder / "land"), "-o", str(folder / "net.tif"), "--clock"])
    assert done.exit_code == 0, done.output
    grid = fb.read_network(folder / "net.tif").grid
    planes = {name: np.zeros(grid.shape, np.uint8) for name in ("wall", "start", "scar")}
    planes["wall"][::40, 10:190] = planes["start"][78:83, 98:103] = planes["scar"][70:90, 90:110] = 1
    for name, plane in planes.items():
        fb.write_raster(folder / f"{name}.tif", grid.dataarray(plane, "breaks"))
    (folder / "scars.csv").write_text("landscape,scar,start,duration,weather\nland,scar.tif,start.tif,12h,rose:NW=4\n")
    return folder


#: Minutes of work each.
COMMANDS = {
    "burn": "burn net.tif --duration 48h --runs 200000 -o f.tif",
    "burn --window": "burn net.tif --duration 48h --window 64 --runs 200000 -o w.tif",
    "assess": "assess net.tif wall.tif --runs 100000 -o a",
    "delineate": "delineate land --size 60 --runs 1000000 -o d",
    "validate": "validate land scar.tif --start start.tif --duration 12h --runs 600000 -o v",
    "calibrate": "calibrate scars.csv --runs 200000 -o fit.toml",
}


@pytest.mark.parametrize("name", COMMANDS)
def test_long_work_says_so_first_and_stops_soon(place, name):
    words = COMMANDS[name].split()
    with subprocess.Popen(
        [sys.executable, "-m", "firebreak_gis", *words, "--progress", "json"],
        cwd=place,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            said = _until_burning(process.stdout)
            asked = time.monotonic()
            process.stdin.write("cancel\n")
            rest, _ = process.communicate(timeout=60)
            took = time.monotonic() - asked
        finally:
            process.kill()
    assert any(text.startswith("This takes about") for text in said), said
    assert json.loads(rest.splitlines()[-1])["error"]["kind"] == "cancelled"
    assert took < SOON
    assert not (place / words[words.index("-o") + 1]).exists()


def _until_burning(lines):
    """What is said until the work that it foretells goes on."""
    said, begun = [], None
    for line in lines:
        told = json.loads(line)
        assert "error" not in told, told
        said.append(told.get("said", ""))
        if begun is None and any(text.startswith("This takes about") for text in said):
            begun = time.monotonic()
        elif (
            begun is not None
            and told.get("message", "compiling").find("compiling") < 0
            and time.monotonic() > begun + 1
        ):
            break
    return said
