"""Small things that stand in for the engine where a test is not about fire."""

from __future__ import annotations

import zipfile
from pathlib import Path

#: A stand-in for the engine: answers the handshake and does what the first argument says.
STAND_IN = """
import json, os, sys, threading, time
def say(**d): print(json.dumps(d), flush=True)
if "--version" in sys.argv:
    say(software="firebreak_gis", version=os.environ.get("STAND_IN_VERSION", "9.9.9")); sys.exit()
what = sys.argv[1]
if what == "work":
    print("a stray line", flush=True)
    for i in range(5): say(progress=i / 4, message=f"step {i}")
    say(progress=1.0, message="step 4")
    say(warning="thin ice")
    say(result={"args": sys.argv[1:], "environment": dict(os.environ)})
elif what == "refuse":
    say(error={"kind": "input", "message": "no CRS", "exit_code": 3}); sys.exit(3)
elif what == "die":
    os.kill(os.getpid(), 9)
elif what == "crash":
    print("Traceback: something odd", file=sys.stderr); sys.exit(1)
elif what in ("listen", "deaf"):
    stop = threading.Event()
    def listen():
        for line in sys.stdin:
            if line.strip() == "cancel": break
        stop.set()
    threading.Thread(target=listen, daemon=True).start()
    say(progress=0.1, message=str(os.getpid()))
    while what == "deaf" or not stop.is_set(): time.sleep(0.02)
    sys.exit(130)
"""


def make_wheel(folder: Path) -> Path:
    """Write a wheel with a package of the engine's name that knows its version and nothing else."""
    path = folder / "firebreak_gis-9.8.7-py3-none-any.whl"
    code = "import json; print(json.dumps({'software': 'firebreak_gis', 'version': '9.8.7'}))"
    info = "firebreak_gis-9.8.7.dist-info"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("firebreak_gis/__init__.py", "")
        archive.writestr("firebreak_gis/__main__.py", code)
        archive.writestr(f"{info}/METADATA", "Metadata-Version: 2.1\nName: firebreak_gis\nVersion: 9.8.7\n")
        archive.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        archive.writestr(f"{info}/RECORD", "")
    return path
