"""What is published: one version everywhere, the recipe's and the package's dependencies alike, files that parse."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

import firebreak_gis

ROOT = Path(__file__).resolve().parents[2]


def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_one_version():
    version = firebreak_gis.__version__
    run = subprocess.run([sys.executable, ROOT / "packaging/version.py"], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == version
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    recipe = (ROOT / "packaging/conda/meta.yaml").read_text(encoding="utf-8")
    plugin = (ROOT / "qgis_plugin/firebreak/metadata.txt").read_text(encoding="utf-8")
    assert f"\nversion: {version}\n" in citation
    assert f'set version = "{version}"' in recipe
    assert f"\nversion={version}\n" in plugin
    assert project().get("version", version) == version
    assert f"## {version}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_the_recipe_needs_what_the_package_needs():
    recipe = (ROOT / "packaging/conda/meta.yaml").read_text(encoding="utf-8")
    run = recipe.split("  run:\n")[1].split("\ntest:")[0]
    listed = {tuple(line.strip(" -").split(" ", 1)) for line in run.splitlines() if line.strip().startswith("- ")}
    found = {name.removesuffix("-base"): version for name, version in listed}
    assert found.pop("python") == project()["requires-python"]
    wanted = dict(re.fullmatch(r"([\w-]+)(.*)", entry).groups() for entry in project()["dependencies"])
    assert found == wanted


@pytest.mark.parametrize("path", sorted((ROOT / ".github").rglob("*.yml")), ids=lambda p: p.name)
def test_forms_and_workflows_parse(path):
    content = yaml.safe_load(path.read_text(encoding="utf-8"))
    assert content["name"]
    jobs = content.get("jobs", {})
    for job in jobs.values():
        needed = job.get("needs", [])
        assert {needed} <= set(jobs) if isinstance(needed, str) else set(needed) <= set(jobs)
        assert job["runs-on"]


def test_metadata_that_an_index_shows():
    found = project()
    assert {"Homepage", "Documentation", "Source", "Issues", "Changelog"} <= set(found["urls"])
    assert found["license"] == "BSD-3-Clause"
    assert any(entry.startswith("Topic :: Scientific/Engineering") for entry in found["classifiers"])
