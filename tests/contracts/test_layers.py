"""The floors of the package: imports only go down, heavy libraries stay where they belong."""

from __future__ import annotations

import ast
import configparser
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "firebreak_gis"
MODULES = sorted(PACKAGE.rglob("*.py"))


def test_imports_only_go_down():
    command = [sys.executable, "-c", "from importlinter.cli import lint_imports_command; lint_imports_command()"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([*command, "--no-cache"], cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 broken" in done.stdout


def test_no_module_leads_back_to_itself():
    """Neither do imports inside functions; those for type checkers alone do not count."""
    import grimp
    import networkx as nx

    graph = grimp.build_graph("firebreak_gis", exclude_type_checking_imports=True, cache_dir=None)
    arrows = nx.DiGraph((m, n) for m in graph.modules for n in graph.find_modules_directly_imported_by(m))
    assert len(arrows) > 150
    rings = [ring for ring in nx.strongly_connected_components(arrows) if len(ring) > 1]
    assert rings == []


def contracts():
    parser = configparser.ConfigParser()
    parser.read(ROOT / ".importlinter")
    return parser


def test_contracts_are_complete():
    """All floors are listed, imports for type checkers alone do not count, nothing is excused."""
    parser = contracts()
    assert parser["importlinter"]["exclude_type_checking_imports"] == "True"
    floors = parser["importlinter:contract:floors"]
    assert floors["exhaustive"] == "True"
    assert "ignore_imports" not in floors
    listed = {name.strip(" ()") for line in floors["layers"].splitlines() for name in line.split("|")}
    files = {p.stem for p in PACKAGE.glob("*.py")} - {"__init__", "__main__"}
    assert files | {p.parent.name for p in PACKAGE.glob("*/__init__.py")} <= listed
    methods = parser["importlinter:contract:methods"]["modules"].split()
    assert methods == ["firebreak_gis.ranking.*", "firebreak_gis.spread.*"]
    assert parser["importlinter:contract:cli"]["modules"].split() == ["firebreak_gis.cli.commands.*"]


def test_the_top_of_the_tree_can_be_taken_in_at_a_glance():
    assert len(list(PACKAGE.glob("*.py"))) - len({"__init__", "__main__"}) <= 14
    assert len(list(PACKAGE.glob("*/__init__.py"))) <= 14
    for path in MODULES:
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 450, path


def imports(path, *, at_import_time):
    """Top-level names of packages that a module imports."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    todo, found = [tree], set()
    while todo:
        node = todo.pop()
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module.partition(".")[0])
        inner = isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
        typing_only = isinstance(node, ast.If) and getattr(node.test, "id", "") == "TYPE_CHECKING"
        if not typing_only and not (inner and at_import_time):
            todo += ast.iter_child_nodes(node)
    return found


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_kernels_know_arrays_only(path):
    """Only kernels use numba; they know neither files nor xarray. Others load heavy libraries on use."""
    used = imports(path, at_import_time=False)
    if path.parent.name == "kernels":
        assert not used & {"xarray", "rasterio", "rioxarray", "geopandas", "pyogrio", "click", "pandas"}
    else:
        assert "numba" not in used
    heavy = {"xarray", "rasterio", "rioxarray", "geopandas", "pyogrio", "pandas", "scipy", "matplotlib", "shapely"}
    if path.parent.name != "kernels":
        assert not imports(path, at_import_time=True) & heavy


def test_rasters_are_opened_and_written_in_one_place():
    for path in MODULES:
        text = path.read_text(encoding="utf-8")
        if "rasters" not in path.parts[-2:-1]:
            assert "rasterio.open(" not in text, path
            assert "to_raster(path" not in text, path
        if path.name != "vectors.py":
            assert ".to_file(" not in text, path
        if path.parts[-2] != "files":
            assert "os.replace(" not in text, path


def functions(path):
    return [node for node in ast.parse(path.read_text(encoding="utf-8")).body if isinstance(node, ast.FunctionDef)]


def test_no_command_takes_a_dictionary_of_options():
    """Every option is a typed argument, or a field of a typed request."""
    for path in (PACKAGE / "cli" / "commands").glob("*.py"):
        for function in functions(path):
            assert function.args.kwarg is None, f"{path}: {function.name}"


def test_no_module_is_named_like_its_only_function():
    """`from x import name` would leave open which is meant."""
    for path in MODULES:
        public = [function.name for function in functions(path) if not function.name.startswith("_")]
        assert public != [path.stem], path


def test_one_formatter_for_all():
    for path in [*MODULES, *(ROOT / "tests").rglob("*.py")]:
        assert f"fmt: {'skip'}" not in path.read_text(encoding="utf-8"), path


def test_no_module_is_a_drawer_for_odds_and_ends():
    for path in MODULES:
        assert not {"utils", "common", "helpers", "misc"} & {part.removesuffix(".py") for part in path.parts}
