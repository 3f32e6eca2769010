"""Two hundred writers killed at random moments; see tests/test_faults.py for kills at every single call."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot be forked here")
@pytest.mark.parametrize(
    ("kind", "kills"), [("text", 40), ("raster", 50), ("gpkg", 40), ("landscape", 40), ("plan", 15)]
)
def test_a_kill_leaves_old_or_new_and_the_next_run_tidies_up(kind, kills, tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "tests.faults.killing", kind, tmp_path, str(kills), "7"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    found = json.loads(done.stdout)
    assert found["findings"] == []
    assert found["fell"] > 0
