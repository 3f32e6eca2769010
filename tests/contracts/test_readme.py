"""What the README and the pages it leads to say is run as it stands there."""

import configparser
import json
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
DOCS = {path.name: path.read_text(encoding="utf-8") for path in sorted((ROOT / "docs").glob("*.md"))}


def block(mark: str) -> str:
    """The fenced block under a mark, which stands once, in the README or in a page."""
    pattern = re.compile(rf"<!-- {mark} -->\n```\w+\n(.*?)```", re.DOTALL)
    found = [match for text in (README, *DOCS.values()) for match in pattern.findall(text)]
    assert len(found) == 1, f"{len(found)} blocks {mark!r} in the README and docs/, expected one"
    return str(found[0])


def test_readme_is_short():
    assert README.count("\n") < 150


def test_readme_leads_to_the_pages():
    """Straight, or by way of the index."""
    index = DOCS["index.md"]
    for page in DOCS.keys() - {"index.md"}:
        assert f"docs/{page}" in README or f"\n{page.removesuffix('.md')}\n" in index, page
    assert README.count("](docs/") >= 10


@pytest.fixture
def checkout(tmp_path, monkeypatch):
    """A folder in which the README's relative paths hold, and nothing else."""
    (tmp_path / "sample_data").symlink_to(ROOT / "sample_data")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_commands_run_in_the_order_given(checkout):
    lines = [line for line in block("commands").splitlines() if line.strip()]
    assert len(lines) >= 9
    for line in lines:
        words = shlex.split(line)
        assert words[0] == "firebreak"
        outcome = CliRunner().invoke(firebreak, words[1:])
        assert outcome.exit_code == 0, f"{line}\n{outcome.output}\n{outcome.exception}"
    assert (checkout / "out/plan/overview.png").stat().st_size > 10_000
    assert (checkout / "out/evaluation/evaluation.svg").exists()


def test_fires_with_a_clock(checkout):
    for line in block("clock").splitlines():
        outcome = CliRunner().invoke(firebreak, shlex.split(line)[1:])
        assert outcome.exit_code == 0, f"{line}\n{outcome.output}\n{outcome.exception}"
    made = {path.name for path in (checkout / "out/timed/products").iterdir()}
    assert {"burnt_by_8h.tif", "arrival_time_50.tif", "flames_above_2.5_m.tif", "isochrones.gpkg"} <= made


def test_plan_with_everything_a_planner_adds(checkout):
    outcome = CliRunner().invoke(firebreak, shlex.split(block("stakes"))[1:])
    assert outcome.exit_code == 0, outcome.output
    summary = json.loads((checkout / "out/stakes/run.json").read_text())["summary"]
    assert 148_000 < summary["cost"] <= 150_000
    assert summary["value_lost_with_breaks"] < summary["value_lost_without_breaks"]


def test_python_example_runs(checkout):
    scope = {}
    exec(compile(block("python"), "README.md", "exec"), scope)
    villages = scope["villages"]
    assert len(villages) == 4
    assert villages["after"].sum() < 0.7 * villages["before"].sum()
    assert scope["polygons"]["cells"].sum() == round(0.14 * scope["network"].n_burnable)


def test_set_up_commands_are_one_line_each():
    for mark in ("main job", "test"):
        text = block(mark)
        assert text.count("\n") == 1
        assert text.startswith("python3 -m venv .venv && ")


def test_files_that_the_readme_names_exist():
    for path in re.findall(r"\]\(((?!http)[^)#]+)\)", README):
        assert (ROOT / path).exists(), path


def test_the_map_names_every_module_and_package_once_from_the_top_down():
    package = ROOT / "firebreak_gis"
    files = {p.stem for p in package.glob("*.py")} - {"__init__", "__main__"}
    folders = {f"{p.parent.name}/" for p in package.glob("*/__init__.py")}
    inside = DOCS["map.md"].split("\nfirebreak_gis/\n")[1].split("\nqgis_plugin/")[0]
    lines = [line.split(maxsplit=1) for line in inside.splitlines()]
    assert all(len(line) == 2 for line in lines)
    named = [name for name, _ in lines]
    assert sorted(named) == sorted(files | folders)
    floors = configparser.ConfigParser()
    floors.read(ROOT / ".importlinter")
    layers = floors["importlinter:contract:floors"]["layers"].split("\n")
    place = {name.strip(" ()"): i for i, line in enumerate(layers) for name in line.split("|")}
    assert sorted(named, key=lambda name: place[name.rstrip("/")]) == named, "lower floors stand lower"


def test_table_of_outputs_names_what_plan_writes():
    """The whole list is in `firebreak plan --help`."""
    from firebreak_gis.files.outputs import names
    from firebreak_gis.planning.outputs import OUTPUTS

    table = DOCS["commands-and-files.md"].split("writes into the folder (")[1].split("Every raster is")[0]
    named = set(re.findall(r"`([\w.]+\.(?:tif|gpkg|csv|png|json))`", table))
    assert len(named) > 10
    assert named <= set(names(OUTPUTS))
