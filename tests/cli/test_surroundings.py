"""What users, their shells and their disks do is never called a bug (exit 1), and leaves nothing behind."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from firebreak_gis.files.commit import ENDINGS, move_all
from firebreak_gis.landscape import legends

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data"
LAYERS = [str(SAMPLE / name) for name in ("dem.tif", "vegetation.tif", "density.tif")]
LONG = "n" * 300
posix = pytest.mark.skipif(sys.platform == "win32", reason="shells and signals of POSIX")


def call(*words):
    return CliRunner().invoke(firebreak, [str(word) for word in words])


def shell(line, **more):
    command = f'"{sys.executable}" -m firebreak_gis {line}'
    return subprocess.run(command, shell=True, cwd=ROOT, capture_output=True, text=True, **more)


@pytest.fixture(scope="module")
def network(tmp_path_factory):
    folder = tmp_path_factory.mktemp("network")
    assert call("align", *LAYERS, "-o", folder / "l", "--res", "100").exit_code == 0
    assert call("network", folder / "l", "-o", folder / "n.tif").exit_code == 0
    return folder / "n.tif"


@posix
@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("legends >/dev/full", 4),
        ("legends --json >/dev/full", 4),
        ("--help >/dev/full", 4),
        ("--version >/dev/full", 4),
        ("plan 2>/dev/full", 2),
        ("legends >&- 2>&- <&-", 0),
        ("legends 2>&-", 0),
    ],
)
def test_streams_that_are_full_or_closed(line, code):
    done = shell(line)
    assert done.returncode == code
    assert "bug" not in done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr
    if code == 4:
        assert "the disk is full" in done.stderr


@posix
def test_work_goes_on_where_nobody_reads_what_is_said(tmp_path):
    """With closed streams the first file opened would take their numbers, and words would go into it."""
    layers = " ".join(LAYERS)
    for name, streams in {"closed": ">&- 2>&- <&-", "full": "2>/dev/full", "plain": ""}.items():
        assert shell(f"align {layers} -o {tmp_path / name} --res 100 {streams}").returncode == 0
    for file in sorted((tmp_path / "plain").iterdir()):
        for other in ("closed", "full"):
            assert (tmp_path / other / file.name).read_bytes() == file.read_bytes(), file.name


@posix
@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP"])
def test_asked_to_end_it_cleans_up(network, tmp_path, name):
    number = getattr(signal, name)
    words = ["burn", network, "-o", tmp_path / "f.tif", "--runs", 2_000_000, "--json", "--progress", "json"]
    process = subprocess.Popen(
        [sys.executable, "-m", "firebreak_gis", *map(str, words)],
        cwd=ROOT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(number, signal.SIG_DFL),  # nohup has it ignored
    )
    for line in process.stdout:
        if json.loads(line).get("progress", 0) > 0.001:
            break
    assert any(path.name.endswith(".lock") for path in tmp_path.iterdir())
    asked = time.monotonic()
    process.send_signal(number)
    out, _ = process.communicate(timeout=60)
    assert time.monotonic() - asked < 10
    assert process.returncode == 128 + number
    told = json.loads(out.splitlines()[-1])["error"]
    assert told["kind"] == "cancelled"
    assert name in told["message"]
    assert not list(tmp_path.iterdir())


@posix
@pytest.mark.parametrize("number", ENDINGS)
def test_moving_files_is_not_broken_off(tmp_path, monkeypatch, number):
    """All files are moved, then the signal is answered as it would have been before."""
    heard = []
    before = signal.signal(number, lambda n, _: heard.append((n, sorted(p.name for p in tmp_path.iterdir()))))
    try:
        parts = {tmp_path / f"{i}.txt": tmp_path / f"{i}.part" for i in range(3)}
        for part in parts.values():
            part.write_text("new")
        replace = Path.replace

        def interrupted(self, target):
            signal.raise_signal(number)
            return replace(self, target)

        monkeypatch.setattr(Path, "replace", interrupted)
        move_all(parts, [])
    finally:
        signal.signal(number, before)
    assert [n for n, _ in heard] == [number] * 3
    assert heard[0][1] == ["0.txt", "1.txt", "2.txt"]


@pytest.mark.parametrize(
    "words",
    [
        ["plan", LONG, "-o", "out"],
        ["plan", *LAYERS, "-o", "out", "--ignitions", LONG],
        ["plan", *LAYERS, "-o", "out", "--barriers", LONG],
        ["plan", *LAYERS, "-o", "out", "--protected", LONG],
        ["plan", *LAYERS, "-o", "out", "--values", LONG],
        ["plan", *LAYERS, "-o", "out", "--like", LONG],
        ["plan", *LAYERS, "-o", "out", "--legend", LONG],
        ["plan", *LAYERS, "-o", "out", "--wind-speed", LONG],
        ["plan", *LAYERS, "-o", "out", "--cost", LONG],
        ["plan", *LAYERS, "-o", "out", "--config", LONG],
        ["align", *LAYERS, "-o", LONG],
        ["align", LONG, "-o", "out"],
        ["network", LONG, "-o", "n.tif"],
        ["rank", LONG, "-o", "n.tif"],
        ["breaks", LONG, "-o", "n.tif"],
        ["burn", LONG, "-o", "n.tif"],
        ["evaluate", LONG, "-o", "out"],
        ["compare", LONG, "-o", "out"],
        ["segments", LONG, LONG, "-o", "s.gpkg"],
    ],
    ids=lambda words: " ".join(w for w in words if w not in LAYERS and w != LONG),
)
def test_names_longer_than_a_file_may_have(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    done = call(*words)
    assert done.exit_code in (2, 3, 4), done.output
    assert done.exit_code == 4 or "-o" not in words or words[words.index("-o") + 1] != LONG
    assert not list(tmp_path.iterdir())


def test_an_output_with_a_long_name(tmp_path, network):
    done = call("burn", network, "-o", tmp_path / f"{LONG}.tif", "--runs", 2)
    assert done.exit_code == 4
    assert "too long" in done.output


@posix
def test_names_that_are_no_text(tmp_path):
    name = os.fsdecode(os.fsencode(str(tmp_path)) + b"/a\xffb.tif")
    Path(name).write_bytes(Path(LAYERS[0]).read_bytes())
    for words in (["align", name, *LAYERS[1:], "-o", tmp_path / "o"], ["align", *LAYERS, "-o", name]):
        for more in ([], ["--json"]):
            done = call(*words, *more)
            assert done.exit_code == 3
            assert "UTF-8" in done.output
    config = tmp_path / "c.json"
    config.write_text('{"legend": "\\udcff.csv"}')
    assert call("align", *LAYERS, "-o", tmp_path / "o", "--config", config).exit_code == 3


@posix
@pytest.mark.parametrize("letter", ["\n", "\t", "\r"])
def test_names_with_a_line_break(tmp_path, network, letter):
    """pyogrio takes such letters out of a name and would read and write another file."""
    odd = tmp_path / f"o{letter}dd"
    odd.mkdir()
    (tmp_path / "odd").mkdir()
    for name in ("villages.gpkg", "dem.tif"):
        (odd / name).write_bytes((SAMPLE / name).read_bytes())
    assert call("align", odd / "dem.tif", *LAYERS[1:], "-o", tmp_path / "l", "--res", 200).exit_code == 0
    done = call("plan", *LAYERS, "-o", tmp_path / "p", "--protected", odd / "villages.gpkg")
    assert done.exit_code == 3
    assert "line break" in done.output
    for words in (["align", *LAYERS, "-o", odd / "l"], ["burn", network, "-o", odd / "f.tif", "--runs", 2]):
        done = call(*words)
        assert done.exit_code == 4
        assert "line break" in done.output
    assert not list((tmp_path / "odd").iterdir())


@posix
@pytest.mark.parametrize("megabytes", [600, 900])
def test_a_limit_on_memory_is_no_bug(tmp_path, megabytes):
    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))

    layers = " ".join(LAYERS)
    done = shell(f"plan {layers} -o {tmp_path / 'o'} --res 100 --runs 3", preexec_fn=limited, timeout=120)
    assert "bug in firebreak_gis" not in done.stderr, done.stderr[-600:]
    assert done.returncode != 1, done.stderr[-600:]


def test_a_matplotlibrc_that_asks_for_tex_changes_no_picture(tmp_path, network):
    pictures = []
    for name, text in {"none": "", "tex": "text.usetex: True\nfont.size: 30\naxes.facecolor: red\n"}.items():
        folder = tmp_path / name
        folder.mkdir()
        (folder / "matplotlibrc").write_text(text)
        done = subprocess.run(
            f'"{sys.executable}" -m firebreak_gis evaluate {network} -o e --methods random,degree --runs 5',
            shell=True,
            cwd=folder,
            env={**os.environ, "MATPLOTLIBRC": str(folder / "matplotlibrc"), "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
        pictures.append([(folder / "e" / f"evaluation.{kind}").read_bytes() for kind in ("png", "svg")])
    assert pictures[0] == pictures[1]


def test_a_configuration_decides_no_output(tmp_path, network):
    victim, config = tmp_path / "victim.tif", tmp_path / "theirs.json"
    victim.write_text("precious")
    theirs = {"output": str(victim), "overwrite": True, "sizes": str(victim), "n_runs": 3}
    config.write_text(json.dumps({"parameters": theirs}))
    assert call("burn", network, "--config", config).exit_code == 2  # -o is missing
    done = call("burn", network, "--config", config, "-o", tmp_path / "mine.tif")
    assert done.exit_code == 0, done.output
    assert "output, overwrite, sizes" in done.output
    assert call("burn", network, "--config", config, "-o", victim).exit_code == 4
    assert victim.read_text() == "precious"
    config.write_text(json.dumps({"remote": True, "dem": "http://127.0.0.1:9/a.tif"}))
    done = call("plan", "--config", config, "-o", tmp_path / "o")
    assert done.exit_code == 3
    assert "--remote" in done.output
    config.write_text(json.dumps({"remote": False, "overwrite": False, "n_runs": 3}))
    done = call("burn", network, "--config", tmp_path / "theirs.json", "-o", tmp_path / "again.tif")
    assert "left out" not in done.output


def test_fields_of_a_legend_may_be_long(tmp_path):
    text = "x" * 300_000
    place = tmp_path / "legend.csv"
    place.write_text(f"code,vegetation,density,label\n1,pines,dense,{text}\n2,shrubs,normal,b\n")
    assert legends.read_legend(place).name == "legend"
    place.write_text(f"code,vegetation,density,label\n1,{text},dense,a\n")
    assert call("align", *LAYERS, "-o", tmp_path / "o", "--legend", place).exit_code == 3


@pytest.mark.parametrize(
    ("words", "ending"),
    [
        (["network", "l", "-o", "n.asc"], ".tif"),
        (["burn", "NETWORK", "-o", "f.img"], ".tif"),
        (["burn", "NETWORK", "-o", "f"], ".tif"),
        (["burn", "NETWORK", "-o", "f.tif", "--sizes", "s.xlsx"], ".csv"),
        (["segments", "NETWORK", "NETWORK", "-o", "s.svg"], ".gpkg"),
        (["segments", "NETWORK", "NETWORK", "-o", "s.kmz"], ".gpkg"),
    ],
    ids=lambda value: str(value[-1]) if isinstance(value, list) else "",
)
def test_a_file_has_the_format_that_its_name_says(network, tmp_path, monkeypatch, words, ending):
    monkeypatch.chdir(tmp_path)
    done = call(*(network if word == "NETWORK" else word for word in words))
    assert done.exit_code in (2, 4)
    assert ending in done.output
    assert not list(tmp_path.iterdir())
