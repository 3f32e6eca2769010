"""The option --no-skips fails a run for every way in which a test can be skipped, and for nothing else."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PASSES = "def test_runs():\n    pass\n"
CASES = {
    "nothing": (PASSES, 0),
    "in the test": ("import pytest\ndef test_a():\n    pytest.skip('not here')\n", 1),
    "in a fixture": (
        "import pytest\n@pytest.fixture\ndef data():\n    pytest.skip('not here')\ndef test_a(data):\n    pass\n",
        1,
    ),
    "by a mark": ("import pytest\n@pytest.mark.skipif(True, reason='not here')\ndef test_a():\n    pass\n", 1),
    "a whole file": ("import pytest\npytest.importorskip('no_such_thing_at_all', reason='not here')\n" + PASSES, 1),
    "one that may": (
        "import pytest\n@pytest.mark.may_skip('no machine has it')\ndef test_a():\n    pytest.skip('not here')\n",
        0,
    ),
    "expected to fail": ("import pytest\n@pytest.mark.xfail\ndef test_a():\n    assert False\n", 0),
}


#: Of which two workers tell the process that started them: a test, a file, and what is no skip.
REPORTED = ("in the test", "a whole file", "one that may")


@pytest.mark.parametrize(("case", "workers"), [*((case, "0") for case in CASES), *((case, "2") for case in REPORTED)])
def test_a_skipped_test_fails_the_run(case, workers, tmp_path):
    text, code = CASES[case]
    (tmp_path / "test_one.py").write_text(text, encoding="utf-8")
    (tmp_path / "test_two.py").write_text(PASSES, encoding="utf-8")
    (tmp_path / "pytest.ini").write_text("[pytest]\n", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-q", "-p", "tests.no_skips", "-p", "no:cacheprovider", "-n", workers]
    environment = {**{k: v for k, v in os.environ.items() if not k.startswith("PYTEST_")}, "PYTHONPATH": str(ROOT)}
    for option in ([], ["--no-skips"])[workers == "2" :]:
        done = subprocess.run([*command, *option], cwd=tmp_path, env=environment, capture_output=True, text=True)
        assert done.returncode == (code if option else 0), done.stdout + done.stderr
        assert ("--no-skips forbids" in done.stdout) == bool(code and option)
    assert not code or "not here" in done.stdout
