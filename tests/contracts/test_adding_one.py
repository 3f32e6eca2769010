"""To add something it is enough to do what CONTRIBUTING.md says: done in a copy, what was added works."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from firebreak_gis import plugins
from firebreak_gis.cli import options
from tests.places import three, write

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
#: What is asked of the design: files to touch, by kind.
GOAL = {
    "A ranking": 1,
    "A spread model": 1,
    "A command": 1,
    "An output of `plan`": 1,
    "An option shared by command line and QGIS": 2,
}
GENERATED = Path("qgis_plugin/firebreak/manifest.json")


def sections():
    """Title and number of files that the page tells, and the section's text."""
    parts = re.split(r"^### (.+): (\d+) files?$", PAGE, flags=re.MULTILINE)[1:]
    return {title: (int(count), text) for title, count, text in zip(*[iter(parts)] * 3, strict=True)}


def steps(text):
    """What a section does: ("file" or "change", path, block)."""
    return re.findall(r"^<!-- (file|change): (\S+) -->\n```\w+\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)


def changed(content, block):
    """The content of a file after the change that a block shows."""
    for hunk in re.split(r"^@@\n", block, flags=re.MULTILINE):
        lines = hunk.splitlines(keepends=True)
        assert {line[0] for line in lines} <= set(" +-")
        old = "".join(line[1:] for line in lines if line[0] != "+")
        assert content.count(old) == 1, f"stands {content.count(old)} times in the file:\n{old}"
        content = content.replace(old, "".join(line[1:] for line in lines if line[0] != "-"))
    return content


def hashes(folder):
    """Every file of the copy that is not compiled, by its content."""
    files = (p for p in folder.rglob("*") if p.is_file() and "__pycache__" not in p.parts)
    return {p.relative_to(folder): hashlib.sha256(p.read_bytes()).digest() for p in files}


@pytest.fixture(scope="module")
def added(tmp_path_factory):
    """A copy to which everything was added; the files touched by title."""
    copy = tmp_path_factory.mktemp("copy")
    for name in ("firebreak_gis", "qgis_plugin"):
        shutil.copytree(ROOT / name, copy / name)  # with what is compiled, which is good as long as times are kept
    for name in ("pyproject.toml", ".importlinter"):
        shutil.copy(ROOT / name, copy)
    touched, state = {}, hashes(copy)
    for title, (_, text) in sections().items():
        for what, path, block in steps(text):
            file = copy / path
            assert file.exists() == (what == "change"), path
            file.write_text(block if what == "file" else changed(file.read_text("utf-8"), block), "utf-8")
        before, state = state, hashes(copy)
        touched[title] = {path for path in state.keys() | before.keys() if state.get(path) != before.get(path)}
    return copy, touched


@pytest.fixture(scope="module")
def run(added, tmp_path_factory):
    """Call Python on the copy, in a folder with layers; returns what it prints."""
    copy, _ = added
    place = tmp_path_factory.mktemp("place")
    three(place)
    write(place / "cost.tif", np.full((24, 31), 100.0, "float32"))
    environment = {**os.environ, "PYTHONPATH": str(copy), "PYTHONIOENCODING": "utf-8"}

    def call(*words, code=0):
        command = [sys.executable, *(("-m", "firebreak_gis") if words[0] != "-c" else ()), *map(str, words)]
        done = subprocess.run(command, cwd=place, env=environment, capture_output=True, encoding="utf-8", check=False)
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout

    call.place = place
    found = Path(call("-c", "import firebreak_gis; print(firebreak_gis.__file__)").strip())
    assert found == copy / "firebreak_gis" / "__init__.py"
    call("align", "dem.tif", "vegetation.tif", "density.tif", "-o", "land", "-q")
    return call


@pytest.fixture(scope="module")
def described(run):
    return json.loads(run("describe"))


def flags(command):
    return {flag: one for one in command["parameters"] for flag in one.get("flags", ())}


def result(text):
    return json.loads(text)["result"]


def test_the_page_shows_one_of_each_kind_and_the_number_of_files():
    assert {title: count for title, (count, _) in sections().items()} == GOAL
    assert len(steps(PAGE)) == PAGE.count("\n<!-- ") == sum(GOAL.values())


def test_no_more_files_are_touched_than_the_page_says(added):
    _, touched = added
    assert {title: len(files) for title, files in touched.items()} == GOAL
    assert not [path for files in touched.values() for path in files if "firebreak_gis" not in path.parts]


def test_what_is_added_is_in_the_style_of_the_house(added):
    copy, touched = added
    files = [str(copy / path) for paths in touched.values() for path in paths]
    ruff = [sys.executable, "-m", "ruff"]
    for words in (["check", "-q"], ["format", "--check", "-q"]):
        done = subprocess.run([*ruff, *words, *files], cwd=copy, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr


def test_the_ranking_is_listed_and_ranks(run, described):
    methods = {method["name"]: method for method in described["methods"]["ranking"]}
    assert [one["name"] for one in methods["readiness"]["parameters"]] == ["exponent"]
    assert "readiness" in run("methods")
    assert "readiness" in flags(described["commands"]["rank"])["--method"]["choices"]
    run("network", "land", "-o", "slope.tif", "-q")
    run("rank", "slope.tif", "--method", "readiness", "-p", "exponent=2", "-o", "priority.tif", "-q")
    code = """
import numpy as np, firebreak_gis as fb
network, priority = fb.read_network("slope.tif"), fb.rank(fb.read_network("slope.tif"), "readiness", exponent=2.0)
expected = np.where(network.burnable, network.probability.astype(float).mean(axis=0) ** 2, -np.inf)
np.testing.assert_allclose(priority, expected, rtol=1e-6)
from firebreak_gis.rasters import read_variable
np.testing.assert_allclose(read_variable("priority.tif", "priority"), priority, rtol=1e-6)
print("same")
"""
    assert run("-c", code) == "same\n"


def test_the_spread_model_makes_a_network(run, described):
    assert "uniform" in flags(described["commands"]["network"])["--model"]["choices"]
    run("network", "land", "-o", "flat.tif", "--model", "uniform", "--model-param", "chance=0.25", "-q")
    code = """
import numpy as np, firebreak_gis as fb
print(sorted(np.unique(fb.read_network("flat.tif").probability).tolist()))
"""
    assert run("-c", code) == "[0.0, 0.25]\n"
    words = ("network", "land", "-o", "no.tif", "--model", "uniform", "--model-param", "chance=2", "--json")
    assert "chance" in json.loads(run(*words, code=2))["error"]["message"]


def test_the_command_runs(run, described):
    assert described["commands"]["fuel"]["summary"] == "Tell how much of NETWORK holds fuel."
    assert "\n  fuel " in run("--help")
    run("network", "land", "-o", "counted.tif", "-q")
    expected = "import firebreak_gis as fb; print(fb.read_network('counted.tif').n_burnable)"
    assert result(run("fuel", "counted.tif", "--json"))["cells"] == int(run("-c", expected))


@pytest.fixture(scope="module")
def plan(run):
    """Words of a short plan, and its key figures; a dry run before the run."""
    words = ["plan", "dem.tif", "vegetation.tif", "density.tif", "--runs", "4", "--method", "degree"]
    told = result(run(*words, "-o", "out", "--dry-run", "--json"))["files"]
    assert not (run.place / "out").exists()
    run(*words, "-o", "out", "-q")
    return words, told


def test_the_output_appears_in_the_dry_run_the_run_and_the_description(run, described, plan):
    label = "Compartments between the breaks, without their outlines"
    assert described["commands"]["plan"]["outputs"]["compartment_table.csv"] == label
    assert label in run("plan", "--help")
    _, told = plan
    assert "out/compartment_table.csv" in {Path(file).as_posix() for file in told}
    head, *rows = (run.place / "out/compartment_table.csv").read_text(encoding="utf-8").splitlines()
    assert "geometry" not in head
    assert len(rows) >= 1
    account = json.loads((run.place / "out/run.json").read_text(encoding="utf-8"))
    assert "compartment_table.csv" in {file["path"] for file in account["outputs"]}


def test_the_option_reaches_the_work_and_is_described(run, described, plan):
    words, _ = plan
    for name in ("plan", "rank", "segments", "compare"):
        option = flags(described["commands"][name])["--cost-factor"]
        assert (option["name"], option["default"]) == ("cost_factor", 1.0)
    costs = []
    for factor in ([], ["--cost-factor", "1.5"]):
        run(*words, "--cost", "cost.tif", *factor, "-o", "priced", "--overwrite", "-q")
        account = json.loads((run.place / "priced/run.json").read_text(encoding="utf-8"))
        costs.append(account["summary"]["cost"])
    assert costs[1] == pytest.approx(1.5 * costs[0])
    assert costs[0] > 0
    run("plan", "--config", "priced/run.json", "-o", "again", "-q")
    again = json.loads((run.place / "again/run.json").read_text(encoding="utf-8"))
    assert again["summary"]["cost"] == costs[1]


def test_the_forms_of_qgis_have_all_of_it(run, added, described):
    copy, _ = added
    assert json.loads((copy / GENERATED).read_text(encoding="utf-8")) != described
    (copy / GENERATED).write_text(run("describe"), encoding="utf-8")
    code = f"""
import sys
sys.path.insert(0, {str(copy / "qgis_plugin")!r})
from firebreak.manifest import descriptions
for one in descriptions():
    if one.form.name in ("plan", "compare"):
        words = [m["name"] + ":" + p["name"] for m in one.methods for p in m["parameters"]]
        print(one.form.name, *[f.name for f in one.fields], *[o.name for o in one.outputs], *words)
"""
    lines = {line.split()[0]: set(line.split()) for line in run("-c", code).splitlines()}
    assert {"COST_FACTOR", "METHOD_PARAMS", "OUTPUT_COMPARTMENT_TABLE"} <= lines["plan"]
    assert {"readiness:exponent", "uniform:chance"} <= lines["plan"], "the help of the form lists them"
    assert "COST_FACTOR" in lines["compare"]


def test_imports_still_only_go_down(added):
    copy, _ = added
    command = [sys.executable, "-c", "from importlinter.cli import lint_imports_command; lint_imports_command()"]
    done = subprocess.run(
        [*command, "--no-cache"],
        cwd=copy,
        env={**os.environ, "PYTHONPATH": str(copy)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_what_the_page_names_is_there():
    for path in re.findall(r"\]\(((?!http)[^)#]+)", PAGE):
        assert (ROOT / path).exists(), path
    told = PAGE.split("says what can be asked for:")[1].split(". ")[0]
    assert re.findall(r"`(\w+)`", told) == list(plugins.FACTS)
    for path in re.findall(r"`((?:cli|planning|simulation|landscape|files|kernels)/\w*(?:\.py)?)`", PAGE):
        assert (ROOT / "firebreak_gis" / path).exists(), path
    for path in re.findall(r"`((?:qgis_plugin|tests)/[\w/.]+)`", PAGE):
        assert (ROOT / path).exists(), path
    for name in re.findall(r"`options\.(\w+)`", PAGE):
        assert callable(getattr(options, name)), name
