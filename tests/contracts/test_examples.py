"""Examples in docstrings run and print what they say; every public function has one."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import shutil
from pathlib import Path

import pytest

import firebreak_gis as fb

ROOT = Path(__file__).resolve().parents[2]
MODULES = [m.name for m in pkgutil.walk_packages(fb.__path__, "firebreak_gis.") if not m.name.endswith("__main__")]
FUNCTIONS = [name for name in fb.__all__ if inspect.isfunction(getattr(fb, name))]


def examples():
    """Every docstring of the package that holds an example, found without importing what holds none."""
    for name in MODULES:
        path = ROOT / (name.replace(".", "/") + ".py")
        path = path if path.is_file() else ROOT / name.replace(".", "/") / "__init__.py"
        if ">>> " in path.read_text(encoding="utf-8"):
            module = importlib.import_module(name)
            for test in doctest.DocTestFinder(exclude_empty=True).find(module, name):
                if test.examples:
                    yield test


EXAMPLES = list(examples())


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda test: test.name)
def test_examples_run(example, tmp_path, monkeypatch):
    """In a folder of its own, with the sample landscape at hand as in a clone."""
    if "sample_data" in example.docstring:
        shutil.copytree(ROOT / "sample_data", tmp_path / "sample_data", ignore=shutil.ignore_patterns("pictures"))
    monkeypatch.chdir(tmp_path)
    told: list[str] = []
    done = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(example, out=told.append)
    assert done.attempted > 0
    assert done.failed == 0, "".join(told)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_public_function_has_an_example(name):
    function = getattr(fb, name)
    assert ">>> " in (inspect.getdoc(function) or ""), f"{name} in {inspect.getsourcefile(function)}"
    assert f"{function.__module__}.{function.__name__}" in {test.name for test in EXAMPLES}


CLASSES = [
    name
    for name in fb.__all__
    if inspect.isclass(getattr(fb, name)) and not issubclass(getattr(fb, name), BaseException)
]


@pytest.mark.parametrize("name", CLASSES)
def test_every_public_class_has_an_example(name):
    kind = getattr(fb, name)
    assert ">>> " in (inspect.getdoc(kind) or ""), f"{name} in {inspect.getsourcefile(kind)}"
    assert f"{kind.__module__}.{kind.__name__}" in {test.name for test in EXAMPLES}
