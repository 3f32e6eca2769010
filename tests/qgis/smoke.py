#!/usr/bin/env python3
"""Plan fire breaks through the plugin in the real `qgis_process`, and try what may go wrong there.

Needs FIREBREAK_PYTHON, a Python with firebreak_gis. Only the standard library is used.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
#: Debian's wrapper without `.bin` fails on every call.
PROGRAM = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
QUICK = ("RESOLUTION=90", "N_RUNS=10", "METHOD=degree")


class Smoke:
    """One configuration of QGIS, and the checks in it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.data = shutil.copytree(ROOT / "sample_data", folder / "Ελιά data", ignore=shutil.ignore_patterns("*.py"))
        (folder / "run").mkdir(mode=0o700)
        self.environment = {
            **os.environ,
            "QT_QPA_PLATFORM": "offscreen",
            "XDG_RUNTIME_DIR": str(folder / "run"),
            "QGIS_CUSTOM_CONFIG_PATH": str(folder / "config"),
            "QGIS_PLUGINPATH": str(ROOT / "qgis_plugin"),
        }
        self.layers = [f"INPUT_{n.upper()}={self.data / n}.tif" for n in ("dem", "vegetation", "density")]

    def call(self, *words: str, **environment: str | None) -> subprocess.CompletedProcess[str]:
        """Run `qgis_process`; a variable given as None is taken away."""
        merged = {k: v for k, v in {**self.environment, **environment}.items() if v is not None}
        return subprocess.run([PROGRAM, *words], env=merged, capture_output=True, text=True, timeout=120, check=False)

    def plan(self, *words: str, json_output: bool = False, **environment: str | None):
        """Run the whole job."""
        flags = ["--json"] if json_output else []
        return self.call(*flags, "run", "firebreak:plan", "--", *self.layers, *QUICK, *words, **environment)

    def check_provider(self) -> None:
        """The plugin loads and lists its algorithms."""
        assert self.call("plugins", "enable", "firebreak").returncode == 0
        listed = self.call("list").stdout
        for name in ("align", "network", "rank", "breaks", "plan", "burn", "evaluate"):
            assert f"firebreak:{name}\t" in listed, listed
        shown = self.call("help", "firebreak:plan").stdout
        assert "INPUT_DEM" in shown
        assert "bonacich" in shown

    def check_plan(self) -> None:
        """A break layer is planned into a folder with other letters, and is the one of the command line."""
        target = self.folder / "Σχέδιο 1" / "breaks.tif"
        done = self.plan(f"OUTPUT_BREAKS={target}", f"OUTPUT_OVERVIEW={target.with_suffix('.png')}")
        assert done.returncode == 0, done.stderr
        assert target.is_file()
        assert target.with_suffix(".qml").is_file()
        assert target.with_suffix(".png").is_file()
        code = "import sys, rasterio; print(rasterio.open(sys.argv[1]).read(1).tobytes().hex())"
        engine = [self.environment["FIREBREAK_PYTHON"], "-I", "-X", "utf8"]
        own = self.folder / "own"
        layers = [word.partition("=")[2] for word in self.layers]
        words = ["plan", "--res", "90", "--runs", "10", "--method", "degree", "-q", "-o", str(own), *layers]
        subprocess.run([*engine, "-m", "firebreak_gis", *words], check=True)
        cells = [subprocess.run([*engine, "-c", code, str(path)], check=True, capture_output=True).stdout
                 for path in (target, own / "breaks.tif")]  # fmt: skip
        assert cells[0] == cells[1]

    def check_json(self) -> None:
        """With --json the results are data."""
        target = self.folder / "json" / "breaks.tif"
        done = self.plan(f"OUTPUT_BREAKS={target}", json_output=True)
        assert done.returncode == 0, done.stderr
        told = json.loads(done.stdout[done.stdout.index("{") :])
        assert told["results"]["OUTPUT_BREAKS"] == str(target)
        assert told["results"]["CELLS_CUT"] > 0
        assert 0 < told["results"]["BURNT_SHARE_WITH_BREAKS"] < 1

    def check_missing_engine(self) -> None:
        """Without an engine the words say what to do, and nothing is written."""
        target = self.folder / "none.tif"
        bare = {"FIREBREAK_PYTHON": None, "PATH": "/usr/bin:/bin"}
        done = self.plan(f"OUTPUT_BREAKS={target}", **bare)
        assert done.returncode != 0
        assert "Make engine" in done.stdout + done.stderr
        done = self.plan(f"OUTPUT_BREAKS={target}", FIREBREAK_PYTHON="/usr/bin/python3")
        assert done.returncode != 0
        assert "has no firebreak_gis" in done.stdout + done.stderr
        assert not target.exists()

    def check_wrong_crs(self) -> None:
        """A layer whose CRS cannot be true is refused in the engine's words."""
        wrong = self.folder / "wrong.tif"
        code = (
            "import sys, rasterio; from rasterio.shutil import copy; copy(sys.argv[1], sys.argv[2], driver='GTiff')\n"
            "with rasterio.open(sys.argv[2], 'r+') as f: f.crs = 'EPSG:4326'"
        )
        python = self.environment["FIREBREAK_PYTHON"]
        subprocess.run([python, "-I", "-c", code, str(self.data / "vegetation.tif"), str(wrong)], check=True)
        target = self.folder / "crs.tif"
        dem, _, density = self.layers
        words = (dem, f"INPUT_VEGETATION={wrong}", density, *QUICK, f"OUTPUT_BREAKS={target}")
        done = self.call("run", "firebreak:plan", "--", *words)
        assert done.returncode != 0
        assert "wrong.tif claims degrees" in done.stdout + done.stderr
        assert "Traceback" not in done.stdout + done.stderr
        assert not target.exists()

    def check_stop(self) -> None:
        """Whatever ends QGIS, the engine has ended within two seconds and no output was written."""
        for blow in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            self._stop_by(blow)

    def _stop_by(self, blow: signal.Signals) -> None:
        target = self.folder / f"stopped-{blow.name}.tif"
        words = [*self.layers, "METHOD=betweenness", "N_RUNS=5000", f"OUTPUT_BREAKS={target}"]
        command = [PROGRAM, "run", "firebreak:plan", "--", *words]
        with subprocess.Popen(
            command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ) as started:
            engine = wait_for(lambda: children(started.pid), 30)
            time.sleep(1.0)
            started.send_signal(blow)
        wait_for(lambda: not any(alive(pid) for pid in engine), 2)
        assert not target.exists()


def children(parent: int) -> list[int]:
    """Processes of the engine started by a process."""
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        try:
            status = (place / "stat").read_text().rsplit(")", 1)[1].split()
            if int(status[1]) == parent and b"firebreak_gis\0plan" in (place / "cmdline").read_bytes():
                found.append(int(place.name))
        except (OSError, IndexError):
            continue
    return found


def alive(pid: int) -> bool:
    """Tell whether a process runs."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def wait_for(found, seconds: float):
    """Return what `found` returns once that is true."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = found()
        if value:
            return value
        time.sleep(0.05)
    raise AssertionError(f"not within {seconds} seconds: {found}")


def main() -> None:
    """Run all checks."""
    if PROGRAM is None:
        sys.exit("qgis_process is not installed")
    with tempfile.TemporaryDirectory(prefix="firebreak smoke ") as name:
        smoke = Smoke(Path(name))
        for check in (smoke.check_provider, smoke.check_plan, smoke.check_json, smoke.check_missing_engine,
                      smoke.check_wrong_crs, smoke.check_stop):  # fmt: skip
            begun = time.monotonic()
            check()
            print(f"{check.__name__.replace('_', ' ')}: {time.monotonic() - begun:.1f} s", flush=True)


if __name__ == "__main__":
    main()
