"""Files are the same bytes whoever burns, by windows or not, after a stop too; see also `tests.benchmarks.equality`."""

import json
import signal
import subprocess
import sys
import time

import click
import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from tests.benchmarks.equality import BY_WINDOWS, WHOLE, Landscape, engine, hashes, run

RUNS = ("--runs", "20")
WINDOWS = ((), ("--window", "32"))


@pytest.fixture(scope="module")
def landscape(tmp_path_factory):
    return Landscape(tmp_path_factory.mktemp("landscape"), 60)


@pytest.fixture(scope="module")
def wanted(landscape):
    """By one thread, the map in memory."""
    with engine("threads", 1, landscape.folder):
        return hashes(landscape, (*BY_WINDOWS, *RUNS))


@pytest.mark.parametrize(("name", "count"), [("threads", 4), ("processes", 2), ("distributed", 2)])
def test_who_burns_and_by_which_windows_changes_no_byte(landscape, wanted, name, count):
    assert len(wanted) == 3  # the raster, its style, the table
    with engine(name, count, landscape.folder) as words:
        for window in WINDOWS:
            assert hashes(landscape, (*BY_WINDOWS, *RUNS, *window), words) == wanted, window
        if name == "distributed":
            with engine("threads", 1, landscape.folder):
                asked = ("burn without a clock", "burn in drawn weathers", "burn with products")
                alone = {each: hashes(landscape, (*WHOLE[each], *RUNS)) for each in asked}
            assert {each: hashes(landscape, (*WHOLE[each], *RUNS), words) for each in alone} == alone


def test_other_fires_are_other_bytes(landscape, wanted):
    assert hashes(landscape, (*BY_WINDOWS, *RUNS, "--seed", "1")) != wanted


@pytest.mark.parametrize("more", [("--workers", "2"), ()])
def test_a_stop_from_the_keyboard_and_the_same_command_again(landscape, tmp_path, more):
    given = (*BY_WINDOWS, "--runs", "4000", *more)
    words = [*landscape.words(given, tmp_path), "--resume"]
    parts = tmp_path / ".burn.tif.parts"
    process = subprocess.Popen(
        [sys.executable, "-m", "firebreak_gis", *words, "--progress", "json"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    for line in process.stdout:
        if json.loads(line).get("progress", 0) > 0.2:
            break
    process.send_signal(signal.SIGINT)
    began = time.monotonic()
    said = process.communicate()[0]
    took = time.monotonic() - began
    assert process.returncode == 130
    assert took < 4.0  # 2 s on a machine that does nothing else
    assert "go on" in said or "goes on" in said
    kept = len(list(parts.glob("*.part")))
    assert kept > 3
    assert [path.name for path in tmp_path.iterdir()] == [parts.name]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    assert f"{kept} parts of an earlier run were taken" in outcome.output
    assert not parts.exists()
    found = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    for path in tmp_path.iterdir():
        path.unlink()
    run([word for word in words if word not in ("--resume", *more)])
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == found


def test_a_plan_that_was_stopped_goes_on(landscape, tmp_path, monkeypatch):
    """Fires on which designs are tried are kept as well, and the account does not tell who burnt."""
    from firebreak_gis.planning import burning

    given = [*landscape.words((*WHOLE["plan"], "--runs", "20"), tmp_path / "out"), "-q"]
    real = burning.evaluate_fires
    monkeypatch.setattr(burning, "evaluate_fires", lambda *_, **__: (_ for _ in ()).throw(KeyboardInterrupt))
    assert CliRunner().invoke(firebreak, [*given, "--resume"]).exit_code == 130
    assert [path.name for path in (tmp_path / "out").iterdir()] == [".parts"]
    kept = len(list((tmp_path / "out" / ".parts").iterdir()))
    monkeypatch.setattr(burning, "evaluate_fires", real)
    outcome = CliRunner().invoke(firebreak, [*given[:-1], "--resume"])
    assert outcome.exit_code == 0, outcome.output
    assert f"{kept} parts of an earlier run were taken" in outcome.output
    found = {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    run([*given[:-1], "--overwrite"])
    assert {path.name: path.read_bytes() for path in (tmp_path / "out").iterdir()} == found


def test_every_command_with_runs_has_the_options():
    context = click.Context(firebreak)
    commands = [firebreak.get_command(context, name) for name in firebreak.list_commands(context)]
    options = {command.name: {p.name for p in command.params} for command in commands}
    burning = {name for name, given in options.items() if "n_runs" in given}
    assert len(burning) > 7
    assert all({"workers", "scheduler", "resume"} <= options[name] for name in burning)


def test_what_cannot_be_is_refused(landscape, tmp_path):
    words = landscape.words(BY_WINDOWS, tmp_path)
    for more, code, part in (
        (("--workers", "2", "--scheduler", "tcp://127.0.0.1:9"), 2, "one of workers"),
        (("--workers", "0"), 2, "workers"),
    ):
        outcome = CliRunner().invoke(firebreak, [*words, *more])
        assert outcome.exit_code == code, outcome.output
        assert part in outcome.output
    (tmp_path / "evil.toml").write_text('scheduler = "tcp://stranger:8786"\n')
    outcome = CliRunner().invoke(firebreak, [*words, "--config", str(tmp_path / "evil.toml")])
    assert outcome.exit_code == 0, outcome.output
    assert "sets scheduler, which counts on the command line only" in outcome.output
