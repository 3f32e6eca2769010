"""Kernels are compiled before a run of all tests, half by each of two programs; each worker would compile them all."""

from __future__ import annotations

import subprocess
import sys
import tempfile

import pytest

from tests.places import ROOT

LAYERS = [str(ROOT / "sample_data" / f"{name}.tif") for name in ("dem", "vegetation", "density")]


def pytest_sessionstart(session: pytest.Session) -> None:
    """Compile; what fails here fails in a test, in words. Some tests alone need too little of it."""
    config = session.config
    whole = config.args_source is pytest.Config.ArgsSource.TESTPATHS
    if not whole or hasattr(config, "workerinput") or config.option.collectonly:
        return
    with tempfile.TemporaryDirectory() as folder:
        each = (["warmup", "-q"], ["plan", *LAYERS, "--res", "120", "--runs", "4", "-q", "-o", f"{folder}/plan"])
        started = [
            subprocess.Popen([sys.executable, "-m", "firebreak_gis", *words], stderr=subprocess.DEVNULL)
            for words in each
        ]
        for program in started:
            program.wait()
