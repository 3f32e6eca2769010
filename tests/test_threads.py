"""Pieces of work on threads: all done once, stopped soon, counted as asked."""

from __future__ import annotations

import concurrent.futures
import functools
import os
import threading
import time

import pytest

import firebreak_gis.threads
from firebreak_gis.errors import Cancelled, ParameterError
from firebreak_gis.progress import silent
from firebreak_gis.threads import Once, meanwhile, run_growing, run_jobs, run_pieces, thread_count


@pytest.mark.parametrize("threads", [1, 2, 5])
@pytest.mark.parametrize("n_pieces", [0, 1, 7, 40])
def test_every_piece_is_done_once(threads, n_pieces):
    done, heard, lock = [], [], threading.Lock()

    def work(piece):
        with lock:
            done.append(piece)

    run_pieces(work, range(n_pieces), threads=threads, progress=lambda f, m: heard.append((f, m)), message="working")
    assert sorted(done) == list(range(n_pieces))
    shares = [f for f, _ in heard]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert all(0 <= f <= 1 for f in shares)
    assert {m for _, m in heard} == {"working"}


def test_few_pieces_wait_however_many_there_are(monkeypatch):
    """Every look at those that wait takes time for each of them."""
    waited = []

    def wait(waiting, **how):
        waited.append(len(waiting))
        return concurrent.futures.wait(waiting, **how)

    monkeypatch.setattr(firebreak_gis.threads, "wait", wait)
    run_pieces(lambda _: None, range(3000), threads=2, progress=silent, message="")
    assert 2 <= max(waited) <= 20


def test_pieces_run_side_by_side():
    meet = threading.Barrier(3, timeout=20)
    run_pieces(lambda _: meet.wait(), range(3), threads=3, progress=silent, message="")


def test_a_stop_drops_what_has_not_begun():
    begun, gate = [], threading.Event()

    def work(piece):
        begun.append(piece)
        gate.wait(20)

    def progress(fraction, message):
        if begun:
            raise Cancelled("enough")

    started = time.perf_counter()
    with pytest.raises(Cancelled, match="enough"):
        run_pieces(work, range(50), threads=2, progress=progress, message="")
    assert time.perf_counter() - started < 10
    gate.set()
    time.sleep(0.05)
    assert len(begun) <= 4


def test_progress_is_heard_while_one_piece_takes_long():
    heard = []
    run_pieces(
        lambda _: time.sleep(0.7), [0], threads=1, progress=lambda f, m: heard.append(time.perf_counter()), message=""
    )
    assert len(heard) >= 4


def test_an_error_in_a_piece_comes_through():
    def work(piece):
        if piece == 3:
            raise ZeroDivisionError("piece 3")

    with pytest.raises(ZeroDivisionError, match="piece 3"):
        run_pieces(work, range(6), threads=2, progress=silent, message="")


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_what_is_left_of_pieces_is_done_too_the_largest_first(threads):
    done, heard = [], []

    def halves(piece):
        done.append(piece)
        return [piece // 2, piece - piece // 2 - 1] if piece > 1 else []

    run_growing(
        halves,
        [3, 20, 7],
        size=lambda piece: piece**1.5,
        threads=threads,
        progress=lambda f, m: heard.append((f, m)),
        message=lambda: f"{len(done)} done",
    )
    waiting, expected = [3, 20, 7], []
    while waiting:
        piece = waiting.pop(waiting.index(max(waiting)))
        expected.append(piece)
        waiting += [piece // 2, piece - piece // 2 - 1] if piece > 1 else []
    assert sorted(done) == sorted(expected)
    assert threads > 1 or done == expected
    shares = [f for f, _ in heard]
    assert shares == sorted(shares)
    assert shares[0] == 0.0
    assert heard[-1] == (1.0, f"{len(done)} done")


def test_growing_work_is_stopped_and_tells_its_errors():
    def work(piece):
        if piece == 3:
            raise ZeroDivisionError("piece 3")
        return [piece + 1]

    with pytest.raises(ZeroDivisionError, match="piece 3"):
        run_growing(work, [0], size=lambda _: 1.0, threads=2, progress=silent, message=str)

    def stop(fraction, message):
        raise Cancelled("enough")

    with pytest.raises(Cancelled, match="enough"):
        run_growing(lambda piece: [piece], [0], size=lambda _: 1.0, threads=1, progress=stop, message=str)


def test_number_of_threads(monkeypatch):
    monkeypatch.delenv("FIREBREAK_THREADS", raising=False)
    assert 1 <= thread_count(None) <= (os.cpu_count() or 1)
    monkeypatch.setenv("FIREBREAK_THREADS", "3")
    assert thread_count(None) == 3
    assert thread_count(5) == 5
    for wrong in ("0", "-1", "two", "1.5"):
        monkeypatch.setenv("FIREBREAK_THREADS", wrong)
        with pytest.raises(ParameterError, match="at least 1"):
            thread_count(None)
    with pytest.raises(ParameterError):
        thread_count(0)


def test_work_goes_on_meanwhile_and_is_waited_for():
    done, meet = [], threading.Barrier(2, timeout=20)

    def work():
        meet.wait()
        time.sleep(0.05)
        done.append(threading.current_thread())

    with meanwhile(work):
        meet.wait()
    assert done
    assert done[0] is not threading.current_thread()


def test_an_error_of_work_done_meanwhile_comes_out_at_the_end():
    done = []
    with pytest.raises(ParameterError, match="of the work"), meanwhile(_fail):
        done.append("body")
    assert done


def _fail():
    raise ParameterError("of the work")


def test_a_body_that_fails_does_not_wait_for_what_is_done_meanwhile():
    gate = threading.Event()
    try:
        with pytest.raises(Cancelled), meanwhile(lambda: gate.wait(20)):
            raise Cancelled("stopped")
        assert not gate.is_set()
    finally:
        gate.set()


@pytest.mark.parametrize("at_once", [1, 2, 5])
def test_all_jobs_are_run_and_their_shares_add_up(at_once):
    heard, done = [], []

    def job(k, progress):
        for share in (0.3, 0.8):
            progress(share, f"job {k}")
            time.sleep(0.01)
        done.append(k)

    jobs = [functools.partial(job, k) for k in range(7)]
    run_jobs(jobs, at_once=at_once, progress=lambda share, message: heard.append((share, threading.current_thread())))
    assert sorted(done) == list(range(7))
    shares = [share for share, _ in heard]
    assert shares == sorted(shares)
    assert shares[-1] == pytest.approx(1.0, abs=0.1 if at_once == 1 else 1e-9)
    assert {thread for _, thread in heard} == {threading.current_thread()}


def test_jobs_run_side_by_side():
    meet = threading.Barrier(3, timeout=20)
    run_jobs([lambda _: meet.wait()] * 3, at_once=3, progress=silent)


def test_a_stop_reaches_jobs_at_work_and_those_that_wait_never_begin():
    begun, ended, gate = [], [], threading.Event()

    def job(k, progress):
        begun.append(k)
        gate.set()
        try:
            while True:
                progress(0.5, "working")
                time.sleep(0.01)
        finally:
            ended.append(k)

    def stop(share, message):
        if gate.is_set():
            raise Cancelled("stopped")

    with pytest.raises(Cancelled, match=r"^stopped$"):
        run_jobs([functools.partial(job, k) for k in range(9)], at_once=2, progress=stop)
    until = time.monotonic() + 20
    while len(ended) < len(begun) and time.monotonic() < until:
        time.sleep(0.01)
    assert sorted(ended) == sorted(begun)
    assert len(begun) <= 2


def test_a_job_that_fails_stops_the_others():
    ended = threading.Event()

    def endless(progress):
        try:
            while True:
                progress(0.1, "")
                time.sleep(0.01)
        finally:
            ended.set()

    with pytest.raises(ParameterError, match="of the work"):
        run_jobs([endless, lambda _: _fail()], at_once=2, progress=silent)
    assert ended.wait(20)


def test_what_many_ask_for_at_a_time_is_made_once():
    made, once = [], Once()

    def make(key):
        time.sleep(0.02)
        made.append(key)
        return [key]

    found = []
    run_pieces(
        lambda k: found.append(once(k % 3, lambda: make(k % 3))), range(30), threads=6, progress=silent, message=""
    )
    assert sorted(made) == [0, 1, 2]
    assert len({id(value) for value in found}) == 3


def test_different_things_are_made_at_a_time():
    meet, once = threading.Barrier(2, timeout=20), Once()
    run_pieces(lambda k: once(k, meet.wait), range(2), threads=2, progress=silent, message="")


def test_what_could_not_be_made_is_tried_again():
    once = Once()
    with pytest.raises(ParameterError):
        once("key", _fail)
    assert once("key", lambda: 5) == 5


def test_only_the_last_are_remembered():
    once = Once(keep=2)
    assert [once(key, lambda key=key: key * 10) for key in (1, 2, 3)] == [10, 20, 30]
    assert [once(key, lambda: "new") for key in (2, 3, 1)] == [20, 30, "new"]
    assert once(2, lambda: "again") == "again"
