"""Pieces of work on threads: all done once, stopped soon, counted as asked."""

from __future__ import annotations

import concurrent.futures
import os
import threading
import time

import pytest

import firebreak_gis.threads
from firebreak_gis.errors import Cancelled, ParameterError
from firebreak_gis.progress import silent
from firebreak_gis.threads import run_growing, run_pieces, thread_count


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
