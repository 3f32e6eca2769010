"""Progress: an honest time left, by a clock that a test moves, and compiling counted apart."""

from __future__ import annotations

import io
import json
import subprocess
import sys

import pytest

from firebreak_gis.cli import session as module
from firebreak_gis.cli.session import Session
from firebreak_gis.planning.timing import Estimate
from firebreak_gis.progress import COMPILING, CompileClock, in_proportion


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def clock(monkeypatch):
    class Clock:
        time = 1000.0

        def __call__(self):
            return self.time

    ours = Clock()
    monkeypatch.setattr(module.time, "monotonic", ours)
    monkeypatch.setattr(COMPILING, "_now", ours)
    monkeypatch.setattr(COMPILING, "_done", 0.0)
    monkeypatch.setattr(COMPILING, "_depth", 0)
    yield ours
    COMPILING.begun = None


def shown(monkeypatch):
    """A terminal in place of stderr; set in the test itself, since pytest puts its own back between the phases."""
    screen = Terminal()
    monkeypatch.setattr(module.sys, "stderr", screen)
    return screen


def test_the_time_left_is_that_of_the_pace(clock, monkeypatch):
    terminal = shown(monkeypatch)
    session = Session()
    clock.time += 10
    session.progress(0.2, "ranking")
    assert session.seconds_left(0.2, clock.time) == pytest.approx(40.0)
    assert "0:40 left  ranking" in terminal.getvalue()


def test_the_time_left_goes_down_while_the_share_does_not_rise(clock, capsys, monkeypatch):
    monkeypatch.setattr(module.sys, "stdin", io.StringIO(""))
    monkeypatch.setattr(module.threading.Thread, "start", lambda _: None)
    session = Session(progress_mode="json")
    for seconds in (10.0, 0.5, 1.0, 1.0, 2.0):
        clock.time += seconds
        session.progress(0.501, "burning")
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [each["progress"] for each in told] == [0.501] * 3
    assert len({each["seconds_left"] for each in told}) == 3


def test_nobody_knows_at_the_beginning(clock, monkeypatch):
    terminal = shown(monkeypatch)
    session = Session()
    assert session.seconds_left(0.0, clock.time) is None
    clock.time += 0.5
    assert session.seconds_left(0.5, clock.time) is None
    session.progress(0.01, "reading")
    assert "left" not in terminal.getvalue()


def test_compiling_is_no_pace(clock, monkeypatch):
    """Thirty seconds of compiling among ten of work: the rest takes forty, not two and a half minutes."""
    terminal = shown(monkeypatch)
    session = Session()
    clock.time += 4
    COMPILING.start()
    assert "compiling, once on this machine" in terminal.getvalue()
    clock.time += 15
    COMPILING.start()  # a kernel that the first one calls
    clock.time += 15
    COMPILING.stop()
    assert COMPILING.seconds == pytest.approx(30.0)
    COMPILING.stop()
    clock.time += 6
    assert session.seconds_left(0.2, clock.time) == pytest.approx(40.0)
    assert COMPILING.seconds == pytest.approx(30.0)


def test_what_was_foreseen_is_the_time_left_until_there_is_a_pace(clock, monkeypatch):
    terminal = shown(monkeypatch)
    session = Session()
    clock.time += 100  # reading, aligning
    session.progress(0.05, "align")
    session.foresee(Estimate({"ranking": 50.0, "fires": 150.0}))
    assert "This takes about 3.3 min (ranking 50 s, fires 2.5 min)" in terminal.getvalue()
    clock.time += 20
    assert session.seconds_left(0.05, clock.time) == pytest.approx(180.0)
    clock.time += 20
    assert session.seconds_left(0.24, clock.time) == pytest.approx(40 * 0.76 / 0.19)


def test_short_work_is_not_announced(clock, monkeypatch):
    terminal = shown(monkeypatch)
    session = Session()
    session.foresee(Estimate({"fires": 3.0}))
    assert terminal.getvalue() == ""
    assert session.seconds_left(0.0, clock.time) == 3.0


def test_programs_hear_what_the_quiet_do_not(monkeypatch):
    monkeypatch.setattr(module.threading.Thread, "start", lambda _: None)
    assert [Session(verbosity=each).heard for each in (-1, 0, 1)] == [False, True, True]
    assert Session(progress_mode="json", verbosity=-1).heard


def test_programs_are_told_in_lines(clock, capsys, monkeypatch):
    monkeypatch.setattr(module.sys, "stdin", io.StringIO(""))
    monkeypatch.setattr(module.threading.Thread, "start", lambda _: None)
    session = Session(progress_mode="json")
    session.foresee(Estimate({"fires": 90.0}))
    COMPILING.start()
    COMPILING.stop()
    COMPILING.start()  # said once until the work goes on
    COMPILING.stop()
    clock.time += 10
    session.progress(0.5, "burning")
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [line.get("said", line.get("message")).split(" (")[0] for line in lines] == [
        "This takes about 1.5 min",
        "compiling, once on this machine",
        "burning",
    ]
    assert "said" in lines[0], "what stays in the log, not the text of the bar"
    assert lines[-1]["seconds_left"] == 10


#: Waits half a minute in one way, listening for a stop meanwhile.
WAITING = """
import time
from firebreak_gis.cli.session import Session
session = Session(progress_mode="json")
for _ in range(3000):
    time.sleep(0.01)
    {report}
"""


@pytest.mark.parametrize(
    ("report", "raised"), [("", "KeyboardInterrupt"), ("session.progress(0.1, 'burning')", "Cancelled")]
)
def test_a_stop_is_met_whether_progress_is_told_or_not(report, raised):
    words = [sys.executable, "-c", WAITING.format(report=report)]
    done = subprocess.run(words, input="cancel\n", capture_output=True, text=True, timeout=20)
    assert raised in done.stderr.splitlines()[-1]


def test_a_command_that_has_ended_is_not_stopped(monkeypatch):
    interrupted = []
    monkeypatch.setattr(module._thread, "interrupt_main", lambda: interrupted.append(1))
    monkeypatch.setattr(module, "_PATIENCE", 0.01)
    monkeypatch.setattr(module.threading.Thread, "start", lambda _: None)
    for ended, times in ((True, 0), (False, 1)):
        monkeypatch.setattr(module.sys, "stdin", io.StringIO(""))
        session = Session(progress_mode="json")
        if ended:
            session.close()
        session._listen()
        assert len(interrupted) == times


def test_shares_of_steps():
    assert in_proportion([0.0, 0.0], 0.2, 0.6) == [(0.2, pytest.approx(0.4)), (pytest.approx(0.4), pytest.approx(0.6))]
    spans = in_proportion([3.0, 0.0, 1.0], 0.0, 1.0)
    assert spans == [(0.0, 0.75), (0.75, 0.75), (0.75, 1.0)]


def test_the_clock_runs_while_numba_compiles_and_not_while_it_loads(monkeypatch):
    """A function that no cache has, called twice."""
    import numba

    import firebreak_gis.kernels.policy  # noqa: F401 - listens to numba

    before = COMPILING.seconds
    double = numba.njit(lambda x: 2 * x)
    assert double(3) == 6
    first = COMPILING.seconds
    assert first > before
    assert double(4) == 8
    assert COMPILING.seconds == first


def test_clocks_of_two_processes_know_nothing_of_each_other():
    assert CompileClock().seconds == 0.0
