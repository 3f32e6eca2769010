"""The part of the QGIS plugin that finds, makes and drives the engine, tested without QGIS."""

from __future__ import annotations

import base64
import json
import os
import signal
import socket
import subprocess
import sys
import textwrap
import threading
import time
import zipfile
from pathlib import Path

import pytest

PLUGINS = Path(__file__).resolve().parents[2] / "qgis_plugin"
sys.path[:0] = [str(PLUGINS), str(Path(__file__).resolve().parents[1] / "qgis")]

from firebreak import arguments, manifest, results  # noqa: E402
from firebreak.engine import environment, errors, lookup, making, process  # noqa: E402
from stand_ins import STAND_IN, make_wheel  # noqa: E402

posix = pytest.mark.skipif(os.name != "posix", reason="starts shell scripts")


@pytest.fixture(autouse=True)
def fresh_answers():
    lookup.forget()
    yield
    lookup.forget()


@pytest.fixture
def program(tmp_path):
    """A `firebreak` script in a folder with a space and other letters."""
    folder = tmp_path / "pröva it"
    folder.mkdir()
    code = folder / "engine.py"
    code.write_text(STAND_IN, encoding="utf-8")
    script = folder / "firebreak"
    script.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{code}" "$@"\n', encoding="utf-8")
    script.chmod(0o755)
    return script


@pytest.fixture
def engine(program):
    return lookup.find_engine(lookup.Places(setting=str(program), environment={}))


def alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


# --- environment --------------------------------------------------------------------------------------------


def test_environment_lacks_what_would_break_the_engine():
    given = {
        "PATH": "/bin",
        "PYTHONHOME": "x",
        "PYTHONPATH": "x",
        "PROJ_LIB": "x",
        "PROJ_DATA": "x",
        "GDAL_DATA": "x",
        "Gdal_Driver_Path": "x",
        "HOME": "h",
    }
    kept = environment.stripped(given)
    assert {"PATH", "HOME"} <= set(kept)
    assert not [name for name in kept if name.upper().startswith(("PROJ_", "GDAL_"))]
    assert {name for name in kept if name.startswith("PYTHON")} == {"PYTHONUTF8", "PYTHONUNBUFFERED"}
    assert kept["PYTHONUTF8"] == "1"


@posix
def test_environment_of_a_run_is_stripped(engine, tmp_path, monkeypatch):
    for name in ("PYTHONHOME", "PROJ_DATA", "GDAL_DATA"):
        monkeypatch.setenv(name, "/nowhere")
    told = process.run(engine, ["work"], folder=str(tmp_path))
    assert not {"PYTHONHOME", "PROJ_DATA", "GDAL_DATA"} & set(told["environment"])


# --- look-up ------------------------------------------------------------------------------------------------


@posix
def test_lookup_order(program, tmp_path):
    made = tmp_path / "made"
    (made / "bin").mkdir(parents=True)
    (made / "bin" / "python3").symlink_to(sys.executable)
    path = {"PATH": str(program.parent)}
    everything = lookup.Places("/set/python", made, {**path, lookup.VARIABLE: "/variable/python"})
    assert lookup.candidates(everything) == [("the variable FIREBREAK_PYTHON", lookup.command_of("/variable/python"))]
    assert lookup.candidates(lookup.Places("/set/python", made, path))[0][0] == "the settings"
    rest = lookup.candidates(lookup.Places("", made, path))
    assert [origin for origin, _ in rest] == ["the engine made by the plugin", "firebreak on the PATH"]
    assert rest[1][1] == (str(program),)


def test_command_of_a_python_is_isolated():
    command = lookup.command_of("/x/bin/python")
    assert command[1:] == ("-I", "-u", "-X", "utf8", "-m", "firebreak_gis")


@posix
def test_conda_python_comes_last(tmp_path, monkeypatch):
    (tmp_path / "conda-meta").mkdir()
    monkeypatch.setattr(lookup.sys, "prefix", str(tmp_path))
    monkeypatch.setattr(lookup, "own_interpreter", lambda: Path("/conda/bin/python"))
    found = lookup.candidates(lookup.Places(environment={"PATH": ""}))
    assert [origin for origin, _ in found] == ["the conda environment of QGIS"]


def test_nothing_found_says_what_to_do():
    with pytest.raises(errors.EngineMissingError, match=r"not installed.*Make engine"):
        lookup.find_engine(lookup.Places(environment={"PATH": ""}))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda folder: folder / "absent", "there is no such file"),
        (lambda folder: folder, "no Python in this folder"),
        (lambda folder: _script(folder, "exit 7"), "broken.*exit code 7"),
        (lambda folder: _script(folder, "echo hello"), "not firebreak_gis"),
        (
            lambda folder: _script(folder, 'echo \'{"software": "other", "version": "1"}\''),
            "not firebreak_gis",
        ),
        (
            lambda folder: _script(folder, 'echo \'{"software": "firebreak_gis", "version": "0.0.9"}\''),
            "too old",
        ),
        (lambda folder: _script(folder, "not a program", mode=0o644), "does not start"),
    ],
)
@posix
def test_a_bad_engine_is_told_in_clear_words(make, words, tmp_path, program):
    """And nothing else is tried in its stead, although there is a good engine on the PATH."""
    places = lookup.Places(str(make(tmp_path)), environment={"PATH": str(program.parent)})
    with pytest.raises(errors.EngineMissingError, match=words):
        lookup.find_engine(places)


def _script(folder: Path, line: str, mode: int = 0o755) -> Path:
    script = folder / "firebreak"
    script.write_text(f"#!/bin/sh\n{line}\n")
    script.chmod(mode)
    return script


def test_a_python_without_the_engine_is_told(tmp_path):
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(tmp_path / "empty")], check=True)
    with pytest.raises(errors.EngineMissingError, match="has no firebreak_gis"):
        lookup.find_engine(lookup.Places(str(tmp_path / "empty"), environment={}))


@posix
def test_handshake_is_kept_until_the_program_changes(program, monkeypatch):
    asked = []
    monkeypatch.setattr(lookup, "handshake", lambda command: asked.append(command) or "1.2.3")
    places = lookup.Places(str(program), environment={})
    assert lookup.find_engine(places).version == lookup.find_engine(places).version == "1.2.3"
    assert len(asked) == 1
    os.utime(program, (1, 1))
    lookup.find_engine(places)
    assert len(asked) == 2


@pytest.mark.parametrize(
    ("text", "numbers"), [("0.1.0", (0, 1, 0)), ("1.2", (1, 2, 0)), ("2.0.0rc1", (2, 0, 0)), ("x", (0, 0, 0))]
)
def test_versions(text, numbers):
    assert lookup._numbers(text) == numbers


# --- protocol -----------------------------------------------------------------------------------------------


@posix
def test_progress_warnings_and_result(engine, tmp_path):
    steps, warnings = [], []
    listener = process.Listener(lambda f, m: steps.append((f, m)), warnings.append)
    told = process.run(engine, ["work", "--x", "a b", "é"], listener, folder=str(tmp_path))
    assert told["args"] == ["work", "--json", "--progress", "json", "--x", "a b", "é"]
    assert steps == [(i / 4, f"step {i}") for i in range(5)]  # the last line said nothing new
    assert warnings == ["thin ice"]


@posix
@pytest.mark.parametrize(
    ("what", "words", "kind", "code"),
    [
        ("refuse", "no CRS", "input", 3),
        ("die", "signal 9.*memory", "died", -9),
        ("crash", "code 1.*something odd", "died", 1),
    ],
)
def test_failures(engine, tmp_path, what, words, kind, code):
    with pytest.raises(errors.EngineFailedError, match=f"(?s){words}") as caught:
        process.run(engine, [what], folder=str(tmp_path))
    assert (caught.value.kind, caught.value.exit_code) == (kind, code)


@posix
@pytest.mark.parametrize("what", ["listen", "deaf"])
def test_cancel_within_a_second(engine, tmp_path, what):
    """Also of an engine that does not listen; and no process is left."""
    pids, asked = [], []

    def cancelled() -> bool:
        if pids and not asked:
            asked.append(time.monotonic())
        return bool(pids)

    listener = process.Listener(progress=lambda _, m: pids.append(int(m)), cancelled=cancelled)
    with pytest.raises(errors.EngineCancelledError):
        process.run(engine, [what], listener, folder=str(tmp_path))
    assert time.monotonic() - asked[0] < 1.0
    assert not alive(pids[0])


@posix
@pytest.mark.parametrize("blow", [signal.SIGTERM, signal.SIGKILL, signal.SIGINT])
def test_no_orphan_when_the_caller_is_killed(program, tmp_path, blow):
    """The end of stdin stops the engine, whatever became of the process that started it."""
    caller = textwrap.dedent(f"""
        import sys
        sys.path.insert(0, {str(PLUGINS)!r})
        from firebreak.engine import lookup, process
        engine = lookup.find_engine(lookup.Places({str(program)!r}, environment={{}}))
        listener = process.Listener(progress=lambda f, m: print(m, flush=True))
        process.run(engine, ["listen"], listener, folder={str(tmp_path)!r})
    """)
    started = subprocess.Popen([sys.executable, "-c", caller], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    with started:
        pid = int(started.stdout.readline())
        assert alive(pid)
        started.send_signal(blow)
        started.wait(10)
    end = time.monotonic() + 2
    while alive(pid) and time.monotonic() < end:
        time.sleep(0.05)
    assert not alive(pid)


# --- making an engine ---------------------------------------------------------------------------------------


@pytest.fixture
def wheel(tmp_path):
    return make_wheel(tmp_path)


def test_make_engine(wheel, tmp_path):
    folder, said = tmp_path / "made here", []
    version = making.make_engine(
        folder,
        base=Path(sys.executable),
        package=str(wheel),
        cancelled=lambda: False,
        report=lambda share, text: said.append((share, text)),
    )
    assert version == "9.8.7"
    shares = [share for share, _ in said]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert len(said) >= 4
    found = lookup.find_engine(lookup.Places(made=folder, environment={"PATH": ""}))
    assert (found.version, found.origin) == ("9.8.7", "the engine made by the plugin")


def test_make_engine_fails_with_the_words_of_pip(tmp_path):
    folder = tmp_path / "made"
    with pytest.raises(errors.EngineError, match=r"(?s)installing.*absent\.whl"):
        making.make_engine(
            folder,
            base=Path(sys.executable),
            package=str(tmp_path / "absent.whl"),
            report=lambda *_: None,
            cancelled=lambda: False,
        )
    assert not folder.exists()


def made_before(folder):
    """An environment that stands there already."""
    folder.mkdir()
    (folder / "pyvenv.cfg").write_text("old")
    (folder / "mine").write_text("old")


def make(folder, package, **more):
    options = {"report": lambda *_: None, "cancelled": lambda: False, **more}
    return making.make_engine(folder, base=Path(sys.executable), package=str(package), **options)


def test_the_old_engine_stands_until_the_new_one_answers(wheel, tmp_path):
    folder, said = tmp_path / "made", []
    made_before(folder)
    assert make(folder, wheel, report=lambda _, text: said.append((folder / "mine").exists())) == "9.8.7"
    assert said[:-1] == [True] * (len(said) - 1)
    assert not said[-1]
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_dir()) == ["made"]
    for script in (folder / "bin").glob("pip*"):  # scripts know where they are
        assert ".new" not in script.read_text()
        assert subprocess.run([script, "--version"], capture_output=True).returncode == 0


@pytest.mark.parametrize("what", ["broken wheel", "no firebreak", "stopped"])
def test_the_old_engine_stays_where_a_new_one_fails(wheel, tmp_path, what):
    folder, begun = tmp_path / "made", time.monotonic()
    made_before(folder)
    if what == "broken wheel":
        wheel.write_bytes(b"no wheel")
    elif what == "no firebreak":
        other = tmp_path / "other"
        other.mkdir()
        with zipfile.ZipFile(wheel) as archive:
            parts = {name: archive.read(name) for name in archive.namelist() if "__main__" not in name}
        wheel.unlink()
        with zipfile.ZipFile(wheel, "w") as archive:
            for name, content in parts.items():
                archive.writestr(name, content)
    stop = (lambda: time.monotonic() > begun + 0.5) if what == "stopped" else (lambda: False)
    with pytest.raises((errors.EngineError, errors.EngineCancelledError)):
        make(folder, wheel, cancelled=stop)
    assert (folder / "mine").read_text() == "old"
    assert not (tmp_path / "made.new").exists()


def test_an_engine_of_a_run_killed_between_its_renames_is_found_again(tmp_path):
    folder = tmp_path / "made"
    made_before(tmp_path / "made.old")
    with pytest.raises(errors.EngineError):
        make(folder, tmp_path / "absent.whl")
    folder_or_old = [path for path in (folder, tmp_path / "made.old") if (path / "mine").exists()]
    assert folder_or_old
    (tmp_path / "bad.whl").write_bytes(b"")
    with pytest.raises(errors.EngineError):
        make(folder, tmp_path / "bad.whl")
    assert (folder / "mine").exists()


def test_it_is_told_where_the_package_comes_from(wheel, tmp_path):
    said = []
    make(tmp_path / "made", wheel, report=lambda _, text: said.append(text), proxy="http://me:secret@127.0.0.1:9")
    told = next(text for text in said if text.startswith("Installing firebreak_gis from"))
    assert f"the file {wheel}" in told
    assert "through the proxy http://127.0.0.1:9" in told
    assert not any("secret" in text for text in said)
    assert making.origin_of("firebreak_gis") == "the package index (firebreak_gis)"
    assert "package index" in making.origin_of("firebreak_gis[scale]>=0.1")
    assert making.origin_of(str(tmp_path)) == f"the folder {tmp_path}"
    for absent in (tmp_path / "absent", "absent.whl"):
        with pytest.raises(errors.EngineError, match="no file or folder"):
            making.origin_of(str(absent))


def test_pip_goes_through_the_proxy(tmp_path):
    """A name is asked for through the proxy, which counts who comes and knows the password."""
    heard = []
    with socket.create_server(("127.0.0.1", 0)) as proxy:

        def listen():
            while True:
                try:
                    visitor, _ = proxy.accept()
                except OSError:
                    return
                with visitor:
                    heard.append(visitor.recv(4096))
                    visitor.sendall(b"HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")

        threading.Thread(target=listen, daemon=True).start()
        address = environment.proxy_address(
            enabled="true",
            kind="HttpProxy",
            host="127.0.0.1",
            port=str(proxy.getsockname()[1]),
            user="me",
            password="a/b",
        )
        with pytest.raises(errors.EngineError, match="installing"):
            make(tmp_path / "made", "firebreak_gis", proxy=address)
    assert heard
    assert base64.b64encode(b"me:a/b") in heard[0]


def test_addresses_of_proxies():
    given = {"enabled": "true", "kind": "HttpProxy", "host": "proxy.example", "port": "8080"}
    assert environment.proxy_address(**given) == "http://proxy.example:8080"
    assert environment.proxy_address(**{**given, "kind": "Socks5Proxy"}) == "socks5://proxy.example:8080"
    for none in ({"enabled": "false"}, {"host": ""}, {"kind": "DefaultProxy"}):
        assert environment.proxy_address(**{**given, **none}) == ""


def test_make_engine_is_stopped_and_leaves_nothing(wheel, tmp_path):
    folder, begun = tmp_path / "made", time.monotonic()
    with pytest.raises(errors.EngineCancelledError):
        making.make_engine(
            folder,
            base=Path(sys.executable),
            package=str(wheel),
            report=lambda *_: None,
            cancelled=lambda: time.monotonic() > begun + 0.3,
        )
    assert not folder.exists()


def test_make_engine_keeps_off_strange_folders(wheel, tmp_path):
    (tmp_path / "letters").mkdir()
    (tmp_path / "letters" / "dear.txt").write_text("you")
    with pytest.raises(errors.EngineError, match="something else"):
        making.make_engine(
            tmp_path / "letters",
            base=Path(sys.executable),
            package=str(wheel),
            report=lambda *_: None,
            cancelled=lambda: False,
        )
    assert (tmp_path / "letters" / "dear.txt").read_text() == "you"


def test_base_interpreters_are_of_the_right_releases():
    for python in making.base_interpreters():
        assert making.RELEASES[0] <= making._release(python) < making.RELEASES[1]


# --- arguments ----------------------------------------------------------------------------------------------


def _plan(**values) -> list[str]:
    description = next(d for d in manifest.descriptions() if d.form.name == "plan")
    defaults = {f.name: f.default for f in description.fields}
    return arguments.command_arguments(
        "plan",
        manifest.parameter_names("plan"),
        description.fields,
        {**defaults, "INPUT_DEM": "d.tif", "INPUT_VEGETATION": "v.tif", **values},
        {"-o": "out"},
    )


def _option(words: list[str], flag: str) -> list[str]:
    return [words[i + 1] for i, word in enumerate(words) if word == flag]


def test_arguments_come_last_and_in_order():
    words = _plan(INPUT_DENSITY="-odd name.tif")
    assert words[0] == "plan"
    assert words[words.index("--") :] == ["--", "d.tif", "v.tif", "-odd name.tif"]
    assert _option(words, "-o") == ["out"]


def test_parameters_of_methods_come_in_one_field():
    words = _plan(METHOD="bonacich", METHOD_PARAMS="beta=0.25; until=0.5")
    assert _option(words, "--param") == ["beta=0.25", "until=0.5"]
    assert _option(words, "--method") == ["bonacich"]


def test_what_is_left_at_its_default_is_left_to_the_engine():
    words = _plan()
    assert [word for word in words if word.startswith("-")] == ["-o", "--"]


def test_a_calibration_counts_where_the_form_was_left_as_it_is():
    words = _plan(CONFIG="fitted.toml", N_RUNS=7)
    assert _option(words, "--config") == ["fitted.toml"]
    assert _option(words, "--runs") == ["7"]
    assert "--duration" not in words


def test_a_file_wins_over_the_default_choice():
    assert _option(_plan(LEGEND_FILE="mine.csv"), "--legend") == ["mine.csv"]
    assert _option(_plan(LEGEND="corine"), "--legend") == ["corine"]
    assert _option(_plan(INPUT_WIND_SPEED_RASTER="w.tif"), "--wind-speed") == ["w.tif"]


def test_two_answers_to_one_question_are_refused():
    with pytest.raises(arguments.ArgumentsError, match="not both"):
        _plan(INPUT_DENSITY="x.tif", DENSITY="dense")


def test_an_argument_cannot_be_left_out_before_another():
    with pytest.raises(arguments.ArgumentsError, match="INPUT_DENSITY needs INPUT_VEGETATION"):
        _plan(INPUT_VEGETATION=None, INPUT_DENSITY="x.tif")
    assert _plan(INPUT_VEGETATION=None)[-1] == "d.tif"


def test_several_values_and_switches():
    words = _plan(SRC_NODATA="dem=-1; vegetation=255", STRICT=True, BOUNDS=(1.0, 2.5, 3.0, 4.0))
    assert _option(words, "--src-nodata") == ["dem=-1", "vegetation=255"]
    assert "--strict" in words
    assert "--strict" not in _plan(STRICT=False)
    place = words.index("--bounds")
    assert words[place + 1 : place + 5] == ["1.0", "2.5", "3.0", "4.0"]


# --- results ------------------------------------------------------------------------------------------------


def test_files_are_delivered_with_their_style(tmp_path):
    source = tmp_path / "made"
    source.mkdir()
    (source / "breaks.tif").write_text("new")
    (source / "breaks.qml").write_text("style")
    target = tmp_path / "ütput" / "my breaks.tif"
    target.parent.mkdir()
    target.write_text("old")
    results.deliver(source / "breaks.tif", target)
    assert sorted(p.name for p in target.parent.iterdir()) == ["my breaks.qml", "my breaks.tif"]
    assert target.read_text() == "new"


def test_a_destination_that_cannot_be_written(tmp_path):
    (tmp_path / "a.csv").write_text("x")
    (tmp_path / "folder").mkdir()
    with pytest.raises(results.DestinationError, match="cannot be written"):
        results.deliver(tmp_path / "a.csv", tmp_path / "folder")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv", "folder"]


@posix
def test_inputs_are_never_destinations(tmp_path):
    (tmp_path / "dem.tif").write_text("x")
    (tmp_path / "link.tif").symlink_to(tmp_path / "dem.tif")
    with pytest.raises(results.DestinationError, match="overwrite an input"):
        results.refuse_inputs({"OUTPUT_BREAKS": str(tmp_path / "link.tif")}, [str(tmp_path / "dem.tif")])
    with pytest.raises(results.DestinationError, match="overwrite A"):
        results.refuse_inputs({"A": "/x/y.tif", "B": "/x/y.tif"}, [])
    with pytest.raises(results.DestinationError, match="folder of an input"):
        results.refuse_inputs({"OUTPUT_FOLDER": str(tmp_path)}, [str(tmp_path / "dem.tif")])


def test_the_real_engine_answers(tmp_path):
    """The command line in this environment keeps the protocol."""
    engine = lookup.Engine((sys.executable, "-u", "-m", "firebreak_gis"), "0", "tests")
    told = process.run(engine, ["legends"], folder=str(Path(__file__).resolve().parents[2]))
    assert "paper" in told["legends"]
    with pytest.raises(errors.EngineFailedError, match="absent") as caught:
        process.run(
            engine,
            ["plan", "-o", str(tmp_path / "o"), "absent.tif", "b.tif", "c.tif"],
            folder=str(Path(__file__).resolve().parents[2]),
        )
    assert caught.value.exit_code == 3
    assert json.dumps(told)


@pytest.mark.parametrize("name", ["b.asc", "b.img", "b", "b.gpkg"])
def test_a_destination_of_another_format_is_refused(name):
    files = {"OUTPUT_BREAKS": "breaks.tif", "OUTPUT_SEGMENTS": "segments.gpkg"}
    results.refuse_formats({"OUTPUT_BREAKS": "/x/b.TIF", "OUTPUT_SEGMENTS": "/x/s.gpkg"}, files)
    results.refuse_formats({"OUTPUT_SEGMENTS": "/x/s.GeoJSON"}, files)
    with pytest.raises(results.DestinationError, match=r"OUTPUT_BREAKS is written as \.tif"):
        results.refuse_formats({"OUTPUT_BREAKS": f"/x/{name}"}, files)
    for other in ("s.kml", "s.mif", "s"):
        with pytest.raises(results.DestinationError, match=r"\.gpkg"):
            results.refuse_formats({"OUTPUT_SEGMENTS": f"/x/{other}"}, files)
