"""Compiled kernels on disk: programs that compile at the same time do not take each other's code."""

import shutil
import subprocess
import sys

import numpy as np
import pytest

from firebreak_gis.kernels.policy import kernel
from tests.places import ROOT

PROGRAM = """
import sys
import numpy as np
from firebreak_gis.kernels.linear import _rows_dot
from firebreak_gis.kernels.policy import kernel
cache = _rows_dot._cache._cache_file
if sys.argv[1] == "blind":  # as if another program compiled it in the meantime
    cache.load = lambda key: None
x = np.arange(6, dtype=sys.argv[2]).reshape(2, 3)
out = np.zeros(2)
_rows_dot(x, x, out, 0, 2)
print(out.tolist(), type(cache).__name__, sum(_rows_dot.stats.cache_hits.values()))
"""


@pytest.fixture
def program(tmp_path):
    def run(how, kind):
        words = [sys.executable, "-c", PROGRAM, how, kind]
        environment = {"NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(ROOT), "PATH": ""}
        done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True, cwd=ROOT)
        return done.stdout.split()

    return run


def test_code_for_other_types_is_never_loaded(program, tmp_path):
    """Programs that do not see each other write code for integers and for floats; each later one finds its own."""
    for kind in ("int32", "float64", "int32"):
        program("blind", kind)
    assert len(list(tmp_path.rglob("linear._rows_dot-*.nbc"))) == 2
    for kind in ("int32", "float64", "int32", "float64"):
        *numbers, name, hit = program("seeing", kind)
        assert " ".join(numbers) == "[5.0, 50.0]"
        assert name == "_CacheFile"
        assert hit == "1"
    assert not list(tmp_path.rglob("*.nbi"))


def test_without_a_cache_file_nothing_changes(monkeypatch):
    twice = kernel(lambda x: 2 * x)
    assert twice(np.float64(1.5)) == 3.0


def test_a_kernel_is_compiled_anew_where_one_that_it_calls_has_changed(tmp_path):
    shutil.copytree(ROOT / "firebreak_gis", tmp_path / "firebreak_gis", ignore=shutil.ignore_patterns("__pycache__"))
    kernels = tmp_path / "firebreak_gis" / "kernels"
    head = "from firebreak_gis.kernels.policy import kernel\n"
    (kernels / "outer.py").write_text(
        f"{head}from firebreak_gis.kernels.inner import f\n\n@kernel\ndef g(x):\n    return f(x)\n"
    )
    words = [sys.executable, "-c", "from firebreak_gis.kernels.outer import g; print(g(2.0))"]
    environment = {"NUMBA_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(tmp_path), "PATH": ""}
    for factor in (3, 50):
        (kernels / "inner.py").write_text(f"{head}\n@kernel\ndef f(x):\n    return {factor} * x\n")
        done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True, cwd=tmp_path)
        assert float(done.stdout) == 2 * factor
