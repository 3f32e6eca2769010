#!/usr/bin/env python3
"""Plan fire breaks through the plugin in the real `qgis_process`, and try what may go wrong there.

Needs FIREBREAK_PYTHON, a Python with firebreak_gis. Only the standard library is used.
"""

from __future__ import annotations

import json
import os
import re
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
#: Libraries whose wheels crash QGIS.
HARMFUL = ("rasterio", "numba", "geopandas", "shapely", "pyproj", "pyogrio", "xarray", "firebreak_gis")


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
        for name in ("align", "network", "rank", "breaks", "segments", "plan", "burn", "evaluate", "compare"):
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
        own = self.folder / "own"
        layers = [word.partition("=")[2] for word in self.layers]
        self.firebreak("plan", "--res", 90, "--runs", 10, "--method", "degree", "-o", own, *layers)
        assert self.cells(target) == self.cells(own / "breaks.tif")

    def firebreak(self, *words: object) -> None:
        """Run the command line."""
        engine = [self.environment["FIREBREAK_PYTHON"], "-I", "-X", "utf8", "-m", "firebreak_gis"]
        subprocess.run([*engine, *map(str, words), "-q"], check=True)

    def cells(self, path: Path) -> bytes:
        """The values of a raster."""
        code = "import sys, rasterio; print(rasterio.open(sys.argv[1]).read(1).tobytes().hex())"
        engine = [self.environment["FIREBREAK_PYTHON"], "-I", "-X", "utf8", "-c", code, str(path)]
        return subprocess.run(engine, check=True, capture_output=True).stdout

    def check_model(self) -> None:
        """The sample model runs, and what comes out is what the command line makes step by step."""
        coarse, own, made = (self.folder / name for name in ("coarse", "steps", "model"))
        made.mkdir()
        own.mkdir()
        self.firebreak("align", "--res", 90, "-o", coarse, *(word.partition("=")[2] for word in self.layers))
        model = ROOT / "qgis_plugin" / "sample" / "breaks_and_burns.model3"
        given = {
            **{
                name: coarse / f"{file}.tif"
                for name, file in (("dem", "elevation"), ("vegetation", "vegetation"), ("density", "density"))
            },
            "budget": "5%",
            "runs": 10,
            "breaks:Fire breaks": made / "breaks.tif",
            "with:Burn frequency with the breaks": made / "with.tif",
            "without:Burn frequency without breaks": made / "without.tif",
        }
        done = self.call("run", str(model), "--", *(f"{key}={value}" for key, value in given.items()))
        assert done.returncode == 0, done.stdout + done.stderr
        self.firebreak("network", "-o", own / "network.tif", coarse)
        self.firebreak("rank", "-o", own / "priority.tif", own / "network.tif")
        self.firebreak("breaks", "--budget", 0.05, "-o", own / "breaks.tif", own / "priority.tif")
        burn = ("burn", "--runs", 10, own / "network.tif", "-o")
        self.firebreak(*burn, own / "without.tif")
        self.firebreak(*burn, own / "with.tif", "--breaks", own / "breaks.tif")
        for name in ("breaks.tif", "with.tif", "without.tif"):
            assert self.cells(made / name) == self.cells(own / name), name
        left_out = [f"{key}={value}" for key, value in given.items() if not key.startswith("breaks")]
        assert self.call("run", str(model), "--", *left_out).returncode != 0, "the second burn would have no breaks"

    def check_isolation(self) -> None:
        """A trap lies on the path of QGIS' Python for every library that would harm it; none springs."""
        traps, mark, target = self.folder / "traps", self.folder / "sprung", self.folder / "isolated.tif"
        traps.mkdir()
        for name in (*HARMFUL, "sitecustomize"):
            (traps / f"{name}.py").write_text(f"open({str(mark)!r}, 'a').write('{name} ')", encoding="utf-8")
        done = self.plan(f"OUTPUT_BREAKS={target}", PYTHONPATH=str(traps))
        assert done.returncode == 0, done.stderr
        assert target.is_file()
        assert set(mark.read_text(encoding="utf-8").split()) == {"sitecustomize"}, "which shows that the path counts"

    def check_readme(self) -> None:
        """The commands of the plugin's README give a planned break layer, in a copy of the checkout."""
        clone = self.folder / "clone"
        for name in ("qgis_plugin", "sample_data"):
            shutil.copytree(ROOT / name, clone / name)
        (clone / ".venv").symlink_to(Path(self.environment["FIREBREAK_PYTHON"]).parent.parent)
        text = (ROOT / "qgis_plugin" / "README.md").read_text(encoding="utf-8")
        commands = re.search(r"<!-- qgis_process -->\n```bash\n(.*?)```", text, re.DOTALL)
        environment = {k: v for k, v in self.environment.items() if k not in ("FIREBREAK_PYTHON", "QGIS_PLUGINPATH")}
        environment["QGIS_CUSTOM_CONFIG_PATH"] = str(clone / "config")
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", commands[1]],
            cwd=clone,
            env=environment,
            check=False,
            capture_output=True,
            text=True,
            timeout=240,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        assert len(self.cells(clone / "out" / "breaks.tif")) > 1000
        assert (clone / "out" / "segments.gpkg").is_file()

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
        for check in (
            smoke.check_provider,
            smoke.check_plan,
            smoke.check_json,
            smoke.check_missing_engine,
            smoke.check_wrong_crs,
            smoke.check_stop,
            smoke.check_isolation,
            smoke.check_model,
            smoke.check_readme,
        ):
            begun = time.monotonic()
            check()
            print(f"{check.__name__.replace('_', ' ')}: {time.monotonic() - begun:.1f} s", flush=True)


if __name__ == "__main__":
    main()
