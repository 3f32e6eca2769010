"""What is published: one version everywhere, the recipe's and the package's dependencies alike, files that parse."""

from __future__ import annotations

import contextlib
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
import yaml

import firebreak_gis
from firebreak_gis.cli import firebreak

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


def test_the_lowest_versions_are_those_that_the_package_allows():
    """pandas comes with geopandas; the extra for tests tells the lowest that is tested."""
    lines = (ROOT / "packaging/minimum.txt").read_text(encoding="utf-8").splitlines()
    pinned = dict(line.split("==") for line in lines if not line.startswith("#"))
    wanted = project()["dependencies"] + [
        e for e in project()["optional-dependencies"]["test"] if e.startswith("pandas")
    ]
    assert pinned == dict(entry.split(">=") for entry in wanted)
    for script in (".ci/run", ".github/workflows/ci.yml"):
        assert "packaging/minimum.txt" in (ROOT / script).read_text(encoding="utf-8"), script


def test_every_python_that_is_allowed_is_named_and_tested():
    low, high = re.fullmatch(r">=3\.(\d+),<3\.(\d+)", project()["requires-python"]).groups()
    versions = [f"3.{minor}" for minor in range(int(low), int(high))]
    named = [entry.rsplit(" ", 1)[1] for entry in project()["classifiers"] if "Python :: 3." in entry]
    assert named == versions
    matrix = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))
    tested = [
        entry
        for job in matrix["jobs"].values()
        for entry in job.get("strategy", {}).get("matrix", {}).get("python", [])
    ]
    assert set(versions) <= set(tested)


def test_the_image_is_built_of_what_is_here():
    """Docker cannot be tried everywhere; what the file copies, installs and runs must exist."""
    text = (ROOT / "packaging/docker/Dockerfile").read_text(encoding="utf-8")
    steps = [line.split(" ", 1) for line in text.replace("\\\n", " ").splitlines() if line and not line.startswith("#")]
    words = {word for word, _ in steps}
    assert {"FROM", "COPY", "RUN", "USER", "ENTRYPOINT", "CMD"} <= words <= {*words, "ENV", "WORKDIR"}
    (base,) = (rest for word, rest in steps if word == "FROM")
    version = re.fullmatch(r"python:(3\.\d+)-slim", base)[1]
    assert f"Programming Language :: Python :: {version}" in project()["classifiers"]
    extras = re.findall(r'"/source\[(\w+)\]"', text)
    assert extras
    assert set(extras) <= set(project()["optional-dependencies"])
    commands = set(firebreak.list_commands(None))
    assert set(re.findall(r"RUN firebreak (\w+)", text)) <= commands
    script = ROOT / "packaging/docker/build.sh"
    assert script.stat().st_mode & 0o111
    run = subprocess.run(["bash", "-n", script], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert set(re.findall(r"docker run --rm firebreak_gis (\w+)", script.read_text(encoding="utf-8"))) <= commands
    ignored = (ROOT / ".dockerignore").read_text(encoding="utf-8").split()
    assert not {"firebreak_gis", "sample_data", "pyproject.toml", "README.md", "LICENSE"} & set(ignored)


def test_without_docker_the_script_says_so(tmp_path):
    """With a PATH on which there is no docker."""
    (tmp_path / "dirname").symlink_to(shutil.which("dirname"))
    script = [shutil.which("bash"), ROOT / "packaging/docker/build.sh"]
    run = subprocess.run(script, env={"PATH": str(tmp_path)}, capture_output=True, text=True, check=False)
    assert run.returncode == 6
    assert "docker is not installed" in run.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built from a copy without anything that git does not keep."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("wheel")
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False)
    if listed.returncode:
        pytest.skip("not a clone")
    for name in filter(None, listed.stdout.decode().split("\0")):
        if (ROOT / name).is_file():
            (source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, source / name)
    from hatchling.build import build_wheel

    with contextlib.chdir(source):
        return target / build_wheel(str(target))


def test_the_wheel_holds_the_sample_and_no_pictures(wheel):
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    inside = {name for name in names if ".dist-info/" not in name}
    for layer in ("dem.tif", "vegetation.tif", "density.tif"):  # what firebreak demo plans on
        assert f"firebreak_gis/sample_data/{layer}" in names
    assert "firebreak_gis/py.typed" in names
    assert {name.split("/")[0] for name in inside} == {"firebreak_gis"}
    assert not [name for name in inside if name.endswith((".png", ".jpg", ".svg", ".pdf"))]
    assert {name for name in inside if name.endswith(".js")}  # the map of the report page
    assert wheel.stat().st_size < 2_000_000
