"""What every command holds that writes: claimed, all or none, looked at before the work. Commands are found by file."""

from __future__ import annotations

import json
import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import click
import numpy as np
import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak, kinds
from firebreak_gis.cli.outputs import outputs_of
from firebreak_gis.files.outputs import labels, names
from tests.places import three, write

ROWS, COLS = 24, 31
#: What a command is given, by the name of the parameter; one that is required and not here fails the test.
GIVEN = {
    "dem": "dem.tif",
    "vegetation": "vegetation.tif",
    "density": "density.tif",
    "folder": "land",
    "network": "net.tif",
    "priority": "priority.tif",
    "mask": "mask.tif",
    "n_runs": "3",
    "n_forests": "1",
    "method": "degree",
    "method_list": "degree,random",
    "budgets": "0.1",
    "residuals": "0",
    "size_ha": "10ha",
    "scar": "scar.tif",
    "start": "start.tif",
    "duration": "1h",
    "fit": "rate",
    "run": "compared",
    "made": "segments.gpkg",
}
#: What the same name means elsewhere.
OWN = {
    "assess": {"duration": "inf"},
    "calibrate": {"folder": "cases.csv"},
    "burn": {"duration": "inf"},
    "compare": {"duration": "inf"},
    "evaluate": {"duration": "inf"},
    "mapbook": {"run": "segments.gpkg"},
}


def walk(group, before=()):
    for name, command in sorted((n, group.get_command(click.Context(group), n)) for n in group.list_commands(None)):
        if isinstance(command, click.Group):
            yield from walk(command, (*before, name))
        else:
            yield (*before, name), command


def hands_on(command):
    """Whether it hands all that it is given on to another command, which is looked at itself."""
    return any(p.type is click.UNPROCESSED for p in command.params)


ALL = {" ".join(words): command for words, command in walk(firebreak) if not hands_on(command)}
#: Those that take a place to write to, of whatever kind.
WRITING = {name: command for name, command in ALL.items() if any(p.name == "output" for p in command.params)}
FOLDERS = [name for name, command in WRITING.items() if outputs_of(command)]
FILES = [name for name in WRITING if name not in FOLDERS]
every = pytest.mark.parametrize("name", WRITING)


def new_files(name):
    """Options of a command that name a file to be written, -o first."""
    found = [p for p in WRITING[name].params if isinstance(p.type, kinds.NewFile)]
    return sorted(found, key=lambda p: p.name != "output")


def words(name, **targets):
    """A whole command line; `targets` are the files to write by parameter, all by default."""
    said = name.split()
    for param in WRITING[name].params:
        value = (GIVEN | OWN.get(name, {})).get(param.name)
        if isinstance(param, click.Argument):
            said += [value] if value is not None else []
        elif value is not None and not isinstance(param.type, kinds.NewFile):
            said += [param.opts[0], value]
    places = targets or {p.name: places_of(name)[i] for i, p in enumerate(new_files(name))} or {"output": "out"}
    for param in WRITING[name].params:
        if param.name in places:
            said += [param.opts[0], str(places[param.name])]
    return said


def places_of(name):
    """Files that a command writes: those in its folder, or those that its options name, in two folders."""
    if name in FOLDERS:
        return [Path("out") / file for file in names(outputs_of(WRITING[name]), ())]
    return [Path("side" if i else ".") / f"made_{p.name}{p.type.extensions[0]}" for i, p in enumerate(new_files(name))]


@pytest.fixture(scope="module")
def template(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    three(folder, ROWS, COLS)
    write(folder / "net.tif", np.full((8, ROWS, COLS), 0.5, "float32"))
    assert call("rank", folder / "net.tif", "--method", "degree", "-o", folder / "priority.tif").exit_code == 0
    assert call("breaks", folder / "priority.tif", "-o", folder / "mask.tif").exit_code == 0
    assert call("segments", folder / "net.tif", folder / "mask.tif", "-o", folder / "segments.gpkg").exit_code == 0
    (folder / "side").mkdir()
    scar, start = np.zeros((ROWS, COLS), "uint8"), np.zeros((ROWS, COLS), "uint8")
    scar[8:18, 8:22] = start[11:15, 12:17] = 1
    write(folder / "scar.tif", scar)
    write(folder / "start.tif", start)
    (folder / "cases.csv").write_text("landscape,scar,start,duration\nland,scar.tif,start.tif,1h\n")
    layers = [str(folder / f"{name}.tif") for name in ("dem", "vegetation", "density")]
    assert call("align", *layers, "-o", folder / "land").exit_code == 0
    words = ["--methods", "degree,random", "--budgets", "0.1", "--residuals", "0", "--runs", "3"]
    assert call("compare", folder / "net.tif", *words, "-o", folder / "compared").exit_code == 0
    (folder / "numbers.csv").write_text("code,vegetation\n0,none\n1,agricultural\n2,0.1\n3,pines\n")
    return folder


@pytest.fixture
def place(template, tmp_path, monkeypatch):
    folder = tmp_path / "place"
    shutil.copytree(template, folder)
    monkeypatch.chdir(folder)
    return folder


def call(*said):
    return CliRunner().invoke(firebreak, [str(w) for w in said])


def refused(outcome, *parts):
    assert outcome.exit_code == 4, outcome.output + repr(outcome.exception)
    for part in parts:
        assert part in outcome.output
    assert "Traceback" not in outcome.output


def content(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def test_a_command_that_hands_all_on_is_refused_as_the_other(place):
    """`demo` is `plan` on the sample landscape."""
    (place / "out").mkdir()
    (place / "out/run.json").write_text("mine")
    refused(call("demo", "-o", "out", "--no-open", "--res", "200", "-q"), "run.json", "--overwrite")
    assert content(place / "out") == {"run.json": b"mine"}


def test_every_place_to_write_is_of_a_kind_that_is_looked_at():
    assert {"plan", "align", "segments", "reproduce landscape"} <= set(WRITING)
    for name, command in ALL.items():
        for param in command.params:
            written = isinstance(param.type, kinds.NewFile) or param.name == "output"
            assert not (written and name not in WRITING), name
        if name in WRITING:
            (output,) = [p for p in command.params if p.name == "output"]
            assert isinstance(output.type, kinds.NewFile) != (name in FOLDERS), name
            assert any(p.name == "overwrite" for p in command.params), name
            unknown = [p.name for p in command.params if p.required and p.name != "output" and p.name not in GIVEN]
            assert not unknown, f"{name}: say in GIVEN what these tests are to give as {unknown}"


@pytest.mark.parametrize("name", FOLDERS)
def test_tables_name_each_file_once_and_the_account_last(name):
    table = outputs_of(WRITING[name])
    assert len(set(names(table))) == len(table)
    assert table[-1].name == "run.json"
    assert set(labels(table)) == set(names(table))
    assert len(set(labels(table).values())) == len(table)
    document = json.loads(call("describe", "--json", "-q").stdout)["result"]["commands"]
    for word in name.split():
        described = document[word]
        document = described.get("commands", {})
    assert described["outputs"] == labels(table)
    told = [line.split(maxsplit=1) for line in call(*name.split(), "--help").stdout.splitlines()]
    assert [[output.name, output.label] in told for output in table] == [True] * len(table)


@every
def test_all_files_come_and_none_is_replaced_unasked(name, place):
    outcome = call(*words(name), "-q")
    assert outcome.exit_code == 0, outcome.output + repr(outcome.exception)
    made = {p.relative_to(place) for p in place.rglob("*") if p.is_file()} - {
        p.relative_to(place) for p in place.rglob("*.qml")
    }
    assert set(places_of(name)) <= made
    assert not [p for p in place.rglob(".*") if p.is_file()]
    before = content(place)
    refused(call(*words(name), "-q"), "exists", "--overwrite")
    assert content(place) == before


HOLD = """
import sys
from firebreak_gis.files import claiming
with claiming(sys.argv[1], folder=sys.argv[2] == "folder"):
    print("held", flush=True)
    sys.stdin.read()
"""


@every
def test_another_run_is_kept_out(name, place):
    """Of every file that the command would write; claims do not count within one process."""
    before = content(place)
    for claim in ["out"] if name in FOLDERS else places_of(name):
        kind = "folder" if name in FOLDERS else "file"
        command = [sys.executable, "-c", HOLD, str(claim), kind]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=place) as other:
            assert other.stdout.readline() == b"held\n"
            refused(call(*words(name), "--overwrite", "-q"), "another run")
            other.stdin.close()
        assert content(place) == before


@every
@pytest.mark.parametrize("last", [False, True])
def test_all_or_none(name, last, place, monkeypatch):
    """The disk fails as the first, or the last, of the files is moved into place."""
    files = places_of(name)
    for file in files:
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(b"old")
    replace, moved = Path.replace, []

    def failing(self, target):
        if Path(target).name in {file.name for file in files}:
            moved.append(target)
            if len(moved) == (len(files) if last else 1):
                raise OSError(5, "Input/output error")
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", failing)
    refused(call(*words(name), "--overwrite", "-q"), "Input/output error")
    assert [file.read_bytes() for file in files] == [b"old"] * len(files)


@pytest.mark.parametrize("name", FILES)
def test_extensions_are_looked_at_before_the_inputs(name, place):
    (place / "net.tif").unlink()
    (place / "priority.tif").unlink()
    for param in new_files(name):
        good = {p.name: file for p, file in zip(new_files(name), places_of(name), strict=True)}
        refused(call(*words(name, **(good | {param.name: "made.txt"}))), max(param.opts, key=len), ".txt")
    assert not list(place.glob("made*"))


@pytest.mark.parametrize("name", FILES)
def test_no_file_is_named_for_two_outputs(name, place):
    before = content(place)
    first, *others = new_files(name)
    for param in others:
        file = f"made{param.type.extensions[0]}"
        for again in (file, f"side/../{file}"):
            refused(call(*words(name, **{first.name: file, param.name: again})))
    assert content(place) == before


@every
def test_pipes_are_refused_and_stay(name, place):
    """A pipe stands for every special file; opened for writing it would wait for ever."""
    for file in places_of(name):
        file.parent.mkdir(exist_ok=True)
        os.mkfifo(file)
        (place / "link").unlink(missing_ok=True)
        refused(call(*words(name), "--overwrite", "-q"), "device or a pipe")
        assert stat.S_ISFIFO(file.stat().st_mode)
        target = file.rename(place / "pipe")
        file.symlink_to(target)
        refused(call(*words(name), "--overwrite", "-q"), "device or a pipe")
        assert stat.S_ISFIFO(target.stat().st_mode)
        file.unlink()
        target.unlink()


@every
def test_inputs_are_never_outputs(name, place):
    for file in places_of(name):
        for source in ("net.tif", "dem.tif", "land/elevation.tif", "mask.tif", "priority.tif"):
            if source not in words(name) and not (source.startswith("land") and "land" in words(name)):
                continue
            file.parent.mkdir(exist_ok=True)
            file.symlink_to(place / source)
            before = content(place)
            refused(call(*words(name), "--overwrite", "-q"), "is the input")
            assert content(place) == before
            file.unlink()


@pytest.mark.parametrize("name", [n for n, c in WRITING.items() if any(p.name == "dry_run" for p in c.params)])
@pytest.mark.parametrize("numbers", [False, True])
def test_a_dry_run_agrees_with_the_run(name, numbers, place):
    said = [*words(name), *(["--legend", "numbers.csv"] if numbers else [])]
    told = json.loads(call(*said, "--dry-run", "--json", "-q").stdout)["result"]["files"]
    assert not (place / "out").exists()
    assert call(*said, "-q").exit_code == 0
    made = {str(p.relative_to(place)) for p in (place / "out").iterdir() if p.suffix != ".qml"}
    assert made == set(told)
    assert ("out/vegetation_effect.tif" in made) == numbers
    # What is left of another landscape stops both, or goes.
    for file in sorted(made - {"out/vegetation_effect.tif"}):
        (place / file).unlink()
    (place / "out/vegetation_effect.tif").touch()
    for more in (["--dry-run"], []):
        refused(call(*said, *more, "-q"), "vegetation_effect.tif")
    assert call(*said, "--overwrite", "-q").exit_code == 0
    assert (place / "out/vegetation_effect.tif").exists() == numbers
